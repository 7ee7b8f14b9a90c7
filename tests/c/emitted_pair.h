/* What the programs of tests/tools/c_driver.py share: random numbers, comparisons. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static long calls, entries, same;
static double largest;
static int failed;

static double
chance (void)
{
  static unsigned long long s = 88172645463325252ULL;
  s ^= s << 13;
  s ^= s >> 7;
  s ^= s << 17;
  return (double)(s >> 11) / 9007199254740992.0;
}

static double
number (double size)
{
  return size * (2 * chance () - 1);
}

/* a number about a start value */
static double
near (double start)
{
  return start + number (0.1 * fabs (start) + 0.2);
}

static void
fill_number (double *x, int n)
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

/* arrays are equal to 1e-14 of the largest entry; what is not finite is so in both */
static void
same_double (const double *f, const double *c, int n, const char *what)
{
  double most = 0, worst = 0;
  for (int i = 0; i < n; i++)
    if (isfinite (f[i]) && fabs (f[i]) > most)
      most = fabs (f[i]);
  for (int i = 0; i < n; i++)
    {
      entries++;
      if (memcmp (f + i, c + i, sizeof *f) == 0 || (isnan (f[i]) && isnan (c[i])))
        same++;
      else if (! (fabs (f[i] - c[i]) <= worst * most))
        worst = isfinite (f[i] - c[i]) && most > 0 ? fabs (f[i] - c[i]) / most : 1;
    }
  if (worst > largest)
    largest = worst;
  if (worst <= 1e-14)
    return;
  printf ("%s differs by %.1e\n", what, worst);
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
  printf ("%s %ld %ld %ld %.1e\n", name, calls, entries, same, largest);
  return failed;
}
