// What a motion has to fulfil and its derivatives, DAE, DAJ, DAH, at many points (gsmbp_collocate).
#pragma once

#include "handles.h"

// the numbers that an emitted subroutine writes, as the JSON has them
static int
numbers_of (const char *name)
{
  for (const handle& h : handles ())
    if (h.name == name && h.code && ! h.g.results.empty ())
      return h.g.slots[h.g.results[0]].room;
  absent_routine (name);
  return 0;
}

// (constants, number of points, times, states, accelerations, multipliers, inputs[, weights]): F, G
// and, where there are weights of F, H at each of them, a column each
static octave_value_list
do_collocation (arguments& a, int nargout)
{
  const reals cst = a.constants ();
  const int k = a.integer_within ("points", 1, 10000000), nf = numbers_of ("dae");
  const reals t = a.vector ("t", k), x = a.array ("x", S.nx, k), ud = a.array ("ud", S.nu, k),
              lam = a.array ("lam", S.nlam, k), v = a.array ("v", S.nv, k);
  const bool second = a.more ();
  const reals w = second ? a.array ("w", nf, k) : room (1);
  auto each = [&] (const char *name, bool weighted)
    {
      const int n = numbers_of (name);
      reals out = room (n * k);
      const fortran f = routine (name);
      for (int i = 0; i < k; i++)
        if (weighted)
          f (&t[i], &x[S.nx * i], &ud[S.nu * i], &lam[S.nlam * i], &v[S.nv * i], &cst[0],
             &w[nf * i], &out[n * i]);
        else
          f (&t[i], &x[S.nx * i], &ud[S.nu * i], &lam[S.nlam * i], &v[S.nv * i], &cst[0],
             &out[n * i]);
      return result (out, n, k);
    };
  if (second)
    return ovl (each ("dah", true));
  if (nargout < 2)
    return ovl (each ("dae", false));
  return ovl (each ("dae", false), each ("daj", false));
}
