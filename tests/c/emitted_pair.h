/* What the programs of tests/tools/c_driver.py share: random numbers, comparisons. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/real.h"

/* the largest difference of C and Fortran relative to the largest entry */
static const double allowed = GS_DIGITS > 53 ? 1e-30 : 1e-14;

static long calls, entries, same;
static gs_real largest;
static int failed;

static gs_real
chance (void)
{
  static unsigned long long s = 88172645463325252ULL;
  s ^= s << 13;
  s ^= s >> 7;
  s ^= s << 17;
  return (gs_real)(s >> 11) / 9007199254740992.0;
}

static gs_real
number (gs_real size)
{
  return size * (2 * chance () - 1);
}

/* a number about a start value */
static gs_real
near (gs_real start)
{
  return start + number (0.1 * gs_abs (start) + 0.2);
}

static void
fill_number (gs_real *x, int n)
{
  for (int i = 0; i < n; i++)
    x[i] = number (1);
}

static void
same_info (int f, int c)
{
  if (f == c)
    return;
  printf ("INFO %d in Fortran, %d in C\n", f, c);
  failed = 1;
}

/* arrays are equal to `allowed` of the largest entry; what is not finite is so in both */
static void
same_reals (const gs_real *f, const gs_real *c, int n, const char *what)
{
  gs_real most = 0, worst = 0;
  for (int i = 0; i < n; i++)
    if (isfinite (f[i]) && gs_abs (f[i]) > most)
      most = gs_abs (f[i]);
  for (int i = 0; i < n; i++)
    {
      entries++;
      if (memcmp (f + i, c + i, sizeof *f) == 0 || (isnan (f[i]) && isnan (c[i])))
        same++;
      else if (! (gs_abs (f[i] - c[i]) <= worst * most))
        worst = isfinite (f[i] - c[i]) && most > 0 ? gs_abs (f[i] - c[i]) / most : 1;
    }
  if (worst > largest)
    largest = worst;
  if (worst <= allowed)
    return;
  printf ("%s differs by %.1e\n", what, (double)worst);
  failed = 1;
}

static inline void
same_int (const int *f, const int *c, int n, const char *what)
{
  entries += n;
  if (memcmp (f, c, n * sizeof *f) == 0)
    {
      same += n;
      return;
    }
  printf ("%s differs\n", what);
  failed = 1;
}

static int
told (const char *name)
{
  printf ("%s %ld %ld %ld %.1e\n", name, calls, entries, same, (double)largest);
  return failed;
}
