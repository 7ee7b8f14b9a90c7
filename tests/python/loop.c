/* Seconds of the inverse dynamics of 1e5 states of the six-link PUMA, a line each time that it is
 * asked by a line on stdin. */
#define _POSIX_C_SOURCE 199309L
#include "puma6.h"

#include <stdio.h>
#include <time.h>

enum { K = 100000, N = PUMA6_NU };

static double q[N * K], u[N * K], ud[N * K], tau[N * K], v[PUMA6_NV + 1], cst[PUMA6_NCST];

static double
seconds (void)
{
  struct timespec t;
  clock_gettime (CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

int
main (void)
{
  puma6_parameters par;
  unsigned seed = 1;
  puma6_par (&par);
  puma6_pre (&par, cst);
  for (int i = 0; i < N * K; i++)
    {
      seed = seed * 1664525u + 1013904223u;
      q[i] = u[i] = ud[i] = seed / 4294967296.0;
    }
  while (getchar () != EOF)
    {
      double begin = seconds ();
      for (int i = 0; i < K; i++)
        puma6_inv (0.0, q + N * i, u + N * i, ud + N * i, v, cst, tau + N * i);
      printf ("%.9f\n", seconds () - begin);
      fflush (stdout);
    }
  return 0;
}
