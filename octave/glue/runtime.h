// Subroutines of the run time alone, for tests.
#pragma once

#include "arguments.h"
#include "gsmbp/inputs.h"

static octave_value_list
do_spline (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 5, 1);   // NC NP K ND SIDE
  int nc = int (sizes(0)), np = int (sizes(1)), k = int (sizes(2)), nd = int (sizes(3));
  int side = int (sizes(4)), ld = std::max (1, nc), info = 0;
  reals brk = a.vector ("breaks", np + 1), coef = a.array ("coefficients", nc * np, k);
  Matrix times = a.matrix ("t", -1, 1);
  NDArray f (dim_vector (nc, nd + 1, times.numel ()));
  reals one = room (ld * (nd + 1));
  int worst = 0;
  for (octave_idx_type j = 0; j < times.numel (); j++)
    {
      number t = times(j);
      info = gs_polynomials_at (nc, np, k, &brk[0], &coef[0], t, side, nd, &one[0], ld);
      if (info < 0)
        error ("gs_polynomials_at: INFO = %d", info);
      worst = std::max (worst, info);
      for (int d = 0; d <= nd; d++)
        for (int i = 0; i < nc; i++)
          f(i, d, j) = double (one[i + ld * d]);
    }
  return ovl (f, worst);
}

static octave_value_list
do_kkt (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 4, 1);   // N M repetitions way (0: gs_solve_kkt)
  int n = int (sizes (0)), m = int (sizes (1)), times = int (sizes (2)), way = int (sizes (3)),
      info = 0;
  int lda = std::max (1, n), ldh = std::max (1, m);
  reals A = a.array ("A", n, n), H = a.array ("H", m, n);
  reals f = a.vector ("f", n), g = a.vector ("g", m);
  reals ud = room (n), lam = room (m);
  reals w = room (way == 0 ? n * n + n * m + m * m + 2 * n + 6 * m
                           : 2 * n * n + n * m + m * m + 4 * n + 8 * m);
  auto begin = std::chrono::steady_clock::now ();
  for (int i = 0; i < times; i++)
    if (way == 0)
      fortran{ gskkt_ }(&n, &m, &A[0], &lda, &H[0], &ldh, &f[0], &g[0], &ud[0], &lam[0], &w[0],
                        &info);
    else
      fortran{ gsacc_ }(&way, &n, &m, &A[0], &lda, &H[0], &ldh, &f[0], &g[0], &ud[0], &lam[0],
                        &w[0], &info);
  std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  return ovl (result (ud, n), result (lam, m), info, took.count () / std::max (1, times));
}

static octave_value_list
do_solve (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 4, 1);   // N NRHS (1 = SPD, 2 = general) repetitions
  int n = int (sizes(0)), nrhs = int (sizes(1)), kind = int (sizes(2));
  int times = int (sizes(3)), ld = std::max (1, n), info = 0;
  reals A = a.array ("A", n, n), B = a.array ("B", n, nrhs);
  std::vector<int> iw (ld);
  reals P = A, X = B;
  auto begin = std::chrono::steady_clock::now ();
  for (int i = 0; i < times; i++)
    {
      P = A;
      X = B;
      if (kind == 1)
        fortran {gsspd_} (&n, &nrhs, &P[0], &ld, &X[0], &ld, &info);
      else
        fortran {gsleq_} (&n, &nrhs, &P[0], &ld, &X[0], &ld, &iw[0], &info);
    }
  std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  return ovl (result (X, n, nrhs), info, took.count () / std::max (1, times));
}
