// The parameters of a scene and the constants that PRE makes of them.
#pragma once

#include "info.h"

#if defined (GSMBP_MODULE_QUAD)
// the shortest decimal that reads back as x: 0.2 is one fifth
static number
decimal (double x)
{
  char text[40];
  for (int digits = 15; digits <= 17; digits++)
    {
      std::snprintf (text, sizeof text, "%.*g", digits, x);
      if (std::strtod (text, nullptr) == x)
        break;
    }
# if defined (__SIZEOF_FLOAT128__)
  return strtoflt128 (text, nullptr);
# else
  return std::strtold (text, nullptr);
# endif
}
#else
static number decimal (double x) { return x; }
#endif

static octave_value_list
do_par (arguments&, int)
{
  reals par = room (S.npar);
  routine ("par") (&par[0]);
  the_rank_said = the_rank_full = false;   // a new model: gsmbp_build asks for its parameters
  return ovl (result (par, S.npar));
}

static octave_value_list
do_pre (arguments& a, int nargout)
{
  Matrix given = a.matrix ("par", S.npar, 1);
  reals par = room (S.npar);
  reals cst = room (S.ncst);
  routine ("par") (&par[0]);
  for (int i = 0; i < S.npar; i++)
    if (double (par[i]) != given(i))
      par[i] = decimal (given(i));
  int info = 0;
  routine ("pre") (&par[0], &cst[0], &info);
  uint8NDArray bytes (dim_vector (cst.size () * sizeof (number), 1));
  std::memcpy (static_cast<void *> (bytes.fortran_vec ()), &cst[0], bytes.numel ());
  octave_value_list out = ovl (bytes);
  finish (out, info, nargout, "pre");
  return out;
}
