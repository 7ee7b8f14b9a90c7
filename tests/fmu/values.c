/* values.c: a run of an FMU by its binary, for Linux or Windows: linked with the library, STANDARD
 * is 2 or 3. Prints all variables as it goes, one line for each instant of co-simulation and of
 * model exchange (method of Heun, events at steps).
 *
 * Arguments: the token, the number of variables, of states, of event indicators, the end [s]. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void
logged (int status, const char *text)
{
  if (status >= 2)
    printf ("log: %s\n", text);
}

#if STANDARD == 2
#include "calls2.h"
#else
#include "calls3.h"
#endif

enum { MOST = 1000, STEPS = 10 };
static int all, ns, nz;

static int
print (void *c)
{
  unsigned r[MOST];
  double x[MOST];
  for (int k = 0; k < all; k++)
    r[k] = k;
  int bad = GET (c, r, all, x);
  for (int k = 0; k < all; k++)
    printf ("%.17g ", x[k]);
  printf ("\n");
  return bad;
}

static void *
begun (int kind, const char *token, double end)
{
  void *c = make (kind, token);
  if (! c || ENTER (c, 0, end) || EXIT (c))
    printf ("it does not begin\n");
  return c;
}

static int
cosimulation (const char *token, double end)
{
  void *c = begun (1, token, end);
  int bad = print (c);
  for (int k = 0; k < STEPS; k++)
    bad += (STEP (c, end * k / STEPS, end / STEPS) > 1) + print (c);
  bad += TERMINATE (c);
  FREE (c);
  return bad;
}

static int
exchange (const char *token, double end)
{
  void *c = begun (0, token, end);
  double x[MOST], y[MOST], f[MOST], g[MOST], next, h = end / (20 * STEPS);
  int bad = update (c, &next) + CONTINUE (c);
  for (int k = 0; k < 20 * STEPS; k++)
    {
      truth event, terminate;
      bad += STATES (c, x, ns) + RATES (c, f, ns);
      for (int i = 0; i < ns; i++)
        y[i] = x[i] + h * f[i];
      bad += TIME (c, h * (k + 1)) + PUT (c, y, ns) + RATES (c, g, ns);
      for (int i = 0; i < ns; i++)
        y[i] = x[i] + 0.5 * h * (f[i] + g[i]);
      bad += PUT (c, y, ns) + INDICATORS (c, g, nz) + COMPLETED (c, &event, &terminate);
      if (event || h * (k + 1) >= next)
        bad += EVENTS (c) + update (c, &next) + CONTINUE (c);
      bad += k % 20 == 19 ? print (c) : 0;
    }
  bad += TERMINATE (c);
  FREE (c);
  return bad;
}

int
main (int argc, char **argv)
{
  if (argc < 6)
    return 2;
  all = atoi (argv[2]);
  ns = atoi (argv[3]);
  nz = atoi (argv[4]);
  double end = strtod (argv[5], NULL);
  int bad = make (1, "another") != NULL;   /* refused, with a line in the log */
  bad += cosimulation (argv[1], end) + exchange (argv[1], end);
  printf ("%d\n", bad);
  return 0;
}
