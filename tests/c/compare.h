/* What the drivers of tests/c share: numbers by chance, pairs of arrays that C and Fortran begin
 * with alike, and a line for each routine:  ok ROUTINE: CASES cases, largest difference */
#ifndef COMPARE_H
#define COMPARE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/real.h"

/* numbers that the Fortran is handed by address */
#define I(x) (&(int){ x })
#define D(x) (&(gs_real){ x })

enum { QUAD = GS_DIGITS > 53 };
/* the largest difference of C and Fortran relative to the largest entry */
static const double allowed = QUAD ? 1e-30 : 1e-14;
/* MAX and MIN of gfortran, of NaN and a number, depend on the precision: in quad they are not those
 * of C, and 0 is in the place of NaN and of what makes it */
#define NOT_A_NUMBER (QUAD ? 0 : NAN)

static uint64_t seed = 20240229;

/* between -1 and 1 */
static inline gs_real
chance (void)
{
  seed = seed * 6364136223846793005u + 1442695040888963407u;
  return (gs_real)(int64_t)(seed >> 11) / 4503599627370496.0 - 1.0;
}

/* between 0 and n - 1 */
static inline int
pick (int n)
{
  return (unsigned)(0.5 * (chance () + 1.0) * n) % n;
}

/* ------------------------------------------------------------ */

typedef struct
{
  int n;
  gs_real *c, *f; /* for the C, for the Fortran, with GUARD entries behind them to be left alone */
} pair;

enum { GUARD = 2 };

static inline pair
pair_of (int n)
{
  size_t size = sizeof (gs_real) * (n + GUARD);
  pair x = { n, malloc (size), malloc (size) };
  for (int i = 0; i < n + GUARD; i++)
    x.c[i] = x.f[i] = chance ();
  return x;
}

static inline void
both (pair x)
{
  memcpy (x.f, x.c, sizeof (gs_real) * x.n);
}

static inline void guarded (pair x);

static inline void
drop (pair x)
{
  guarded (x);
  free (x.c);
  free (x.f);
}

/* ------------------------------------------------------------ */

static struct
{
  const char *what;
  int cases, wrong;
  gs_real worst;
} record;

static inline void
begin (const char *what)
{
  memset (&record, 0, sizeof record);
  record.what = what;
}

static inline void
same_numbers (int n, const gs_real *c, const gs_real *f)
{
  gs_real most = 0, off = 0;
  record.cases++;
  for (int i = 0; i < n; i++)
    if (gs_abs (f[i]) > most && gs_abs (f[i]) <= 1e300)
      most = gs_abs (f[i]);
  for (int i = 0; i < n; i++)
    if (c[i] != f[i] && ! (isnan (c[i]) && isnan (f[i])))
      {
        gs_real d = gs_abs (c[i] - f[i]) / most;
        if (! (d <= allowed))
          record.wrong++;
        off = d > off || isnan (d) ? d : off;
      }
  if (! (off <= record.worst))
    record.worst = off;
}

static inline void
guarded (pair x)
{
  if (memcmp (x.c + x.n, x.f + x.n, GUARD * sizeof (gs_real)) != 0 && record.wrong++ == 0)
    printf ("  %s: writes beyond an array\n", record.what);
}

static inline void
same (pair x)
{
  same_numbers (x.n, x.c, x.f);
}

static inline void
same_int (int c, int f)
{
  record.cases++;
  if (c != f && record.wrong++ == 0)
    printf ("  %s: %d in C, %d in Fortran\n", record.what, c, f);
}

static inline void
finish (void)
{
  printf ("%sok %s: %d comparisons, largest difference %.1e of the largest entry\n",
          record.wrong || record.cases == 0 ? "not " : "", record.what, record.cases,
          (double)record.worst);
}

/* a condition by itself */
static inline void
holds (int true, const char *what)
{
  printf ("%sok %s\n", true ? "" : "not ", what);
}

#endif
