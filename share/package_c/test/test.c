/* test.c: calls every routine of @name@ at one state, prints what it gives, and compares it with
 * reference.h where that has values: to 1e-12 of the largest entry. Elsewhere INFO tells.
 * The last line is "N passed, N failed". */
#include "@name@.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct
{
  const char *name;
  int (*call) (const double *in, double *out, const double *cst);
  int n;             /* how many numbers it writes */
  const double *in;  /* what it reads */
  const double *out; /* what it is to write, or a null pointer */
} test;

#include "reference.h"

static int passed, failed;

static void
tell (int good, const char *name, const char *what)
{
  printf ("%s %s: %s\n", good ? "ok" : "not ok", name, what);
  good ? passed++ : failed++;
}

/* the largest difference beside the largest entry */
static double
difference (int n, const double *a, const double *b)
{
  double most = 0, off = 0;
  for (int i = 0; i < n; i++)
    {
      most = fabs (b[i]) > most ? fabs (b[i]) : most;
      off = fabs (a[i] - b[i]) > off || a[i] != a[i] ? fabs (a[i] - b[i]) : off;
    }
  return off == 0 ? 0 : off / most;
}

static void
compare (const test *t, const double *cst)
{
  double *out = calloc ((size_t)t->n + 1, sizeof *out);
  char text[80];
  int info = t->call (t->in, out, cst);
  printf ("%s: INFO = %d:", t->name, info);
  for (int i = 0; i < t->n; i++)
    printf (" %.17g", out[i]);
  printf ("\n");
  if (t->out)
    {
      double off = difference (t->n, out, t->out);
      snprintf (text, sizeof text, "off by %.1e of the largest entry", off);
      tell (info == 0 && off <= 1e-12, t->name, text);
    }
  free (out);
}

int
main (void)
{
  @prefix@_parameters par;
  double *cst = calloc (@NAME@_NCST, sizeof *cst);
  @prefix@_par (&par);
  tell (@prefix@_pre (&par, cst) == 0, "pre", "parameters");
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    compare (list + i, cst);
  printf ("%d passed, %d failed\n", passed, failed);
  free (cst);
  return failed > 0 || passed < 2;
}
