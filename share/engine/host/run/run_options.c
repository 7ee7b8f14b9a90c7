/* run_options.c: the options of a run: method, steps, tolerances. */
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/expressions.h"
#include "gsmbp/limits.h"
#include "gsmbp/methods.h"
#include "gsmbp/options.h"
#include "gsmbp/refusals.h"
#include "host/run/run_parts.h"
#include "host/text.h"

#define ROW_DEFAULT(name, kind, value) { #name, #value },
#define ROW_METHOD(word, number, steps, by, orders, order)                                         \
  { #word, #steps, #by, #orders, number, order },
static const struct { const char *name, *value; } defaults[] = { GS_OPTIONS (ROW_DEFAULT) };
static const struct { const char *word, *steps, *by, *orders; int number, order; } methods[]
    = { GS_METHODS (ROW_METHOD) };

enum { METHODS = sizeof methods / sizeof *methods, OPTIONS = sizeof defaults / sizeof *defaults };

int
gs_refuse (gs_run_result *r, int refused, const char *option, const char *format, ...)
{
  va_list values;
  va_start (values, format);
  vsnprintf (r->text, sizeof r->text, format, values);
  va_end (values);
  r->refused = refused;
  r->option = option;
  return 1;
}

static const char *
default_of (const char *name)
{
  for (int k = 0; k < OPTIONS; k++)
    if (strcmp (defaults[k].name, name) == 0)
      return defaults[k].value;
  return "";
}

static double
number_of (const char *name)
{
  char *end;
  const char *text = default_of (name);
  const double x = strtod (text, &end);
  return end == text ? (double)NAN : x;
}

gs_run_options
gs_default_options (void)
{
  gs_run_options o = { 0 };
  o.method = default_of ("method");
  o.step = number_of ("step");
  o.rtol = number_of ("rtol");
  o.maxstep = number_of ("maxstep");
  o.maxsteps = number_of ("maxsteps");
  o.maxorder = number_of ("maxorder");
  o.drift = -1;
  o.project = strcmp (default_of ("start"), "project") == 0;
  o.samples = strcmp (default_of ("samples"), "true") == 0;
  return o;
}

static int
is (const gs_whole_run *w, const char *method)
{
  return strcmp (w->o->method, method) == 0;
}

/* is the order among those of method k? all: these with commas */
static int
has_order (int k, double order, char *all, size_t size)
{
  gs_writer list = { all, (int)size, 0 };
  int found = 0;
  char *end;
  const char *p = methods[k].orders;
  for (long one = strtol (p, &end, 10); end > p; p = end, one = strtol (p, &end, 10))
    {
      gs_put (&list, list.length > 0 ? ", %ld" : "%ld", one);
      found = found || ((double)one <= order && order <= (double)one);
    }
  return found;
}

static int
choose_order (gs_whole_run *w, int k)
{
  char all[80] = "", found[40];
  w->order = methods[k].order;
  if (isnan (w->o->maxorder))
    return 0;
  snprintf (found, sizeof found, "%g", w->o->maxorder);
  if (has_order (k, w->o->maxorder, all, sizeof all))
    {
      w->order = (int)w->o->maxorder;
      return 0;
    }
  return *all ? gs_refuse (w->r, GS_REFUSED_OPTION, "maxorder", gs_refusals.order, all, found)
              : gs_refuse (w->r, GS_REFUSED_OPTION, "maxorder", gs_refusals.one_order,
                           w->o->method, found);
}

/* who integrates where gs_integrate does not; in double precision alone */
static int
choose_implicit (gs_whole_run *w, int k)
{
  const char *by = methods[k].by;
  if (strcmp (by, "core") == 0)
    return 0;
#if defined (GSMBP_QUAD) || defined (GSMBP_FLOAT)
  return gs_refuse (w->r, GS_REFUSED_OPTION, "method", "%s works in double precision alone",
                    w->o->method);
#else
  w->by = strcmp (by, "library") == 0 ? w->o->cvode
          : gs_method_named (strcmp (by, "both") == 0 ? "radau" : w->o->method);
  if (w->by == NULL)
    return gs_refuse (w->r, GS_REFUSED_OPTION, "method", "%s", gs_refusals.no_sundials);
  return 0;
#endif
}

/* the number of steps: what the run time counts to, or what time resolves */
static int
count_steps (gs_whole_run *w)
{
  const gs_run_start *s = w->s;
  const double span = (double)(s->times[s->nt - 1] - s->times[0]);
  const double most = w->fixed ? gs_limits.fixed_steps : gs_limits.controlled_steps;
  const double step = w->fixed ? (double)w->ropt[0] : 0, maxstep = w->o->maxstep;
  const int by_step = step > 0 && (step <= maxstep || ! (maxstep > 0));
  const double longest = by_step ? step : maxstep;
  if (! (longest > 0) || ! (span / longest > most))
    return 0;
  return gs_refuse (w->r, GS_REFUSED_OPTION, by_step ? "step" : "maxstep",
                    gs_refusals.too_many_steps, span, longest, span / longest, w->o->method, most);
}

/* its row in the table, or METHODS */
static int
method_named (gs_whole_run *w)
{
  char all[200] = "";
  gs_writer list = { all, (int)sizeof all, 0 };
  int k = 0;
  for (; k < METHODS && ! is (w, methods[k].word); k++)
    gs_put (&list, k > 0 ? ", %s" : "%s", methods[k].word);
  if (k == METHODS)
    gs_refuse (w->r, GS_REFUSED_OPTION, "method", "expected one of %s, found %s", all,
               w->o->method);
  return k;
}

int
gs_choose_method (gs_whole_run *w)
{
  const gs_run_options *o = w->o;
  const int k = method_named (w);
  if (k == METHODS)
    return 1;
  w->r->method = methods[k].word;
  w->iopt[GS_METHOD] = methods[k].number;
  w->fixed = strcmp (methods[k].steps, "fixed") == 0;
  const double step = isnan (o->step) ? w->fixed ? 1e-3 : 0 : o->step;
  if (! (step >= 0 && step <= DBL_MAX) || (w->fixed && ! (step > 0)))
    return gs_refuse (w->r, GS_REFUSED_OPTION, "step", "expected a length [s]; found %g", step);
  if (! (o->maxstep >= 0) || ! (o->maxsteps >= 0 && o->maxsteps <= gs_limits.fixed_steps))
    return gs_refuse (w->r, GS_REFUSED_OPTION, o->maxstep >= 0 ? "maxsteps" : "maxstep",
                      "expected 0 or more; found %g", o->maxstep >= 0 ? o->maxsteps : o->maxstep);
  w->iopt[GS_MOST_STEPS] = (int)o->maxsteps;
  w->ropt[0] = (gs_real)step;
  w->ropt[2] = (gs_real)o->maxstep;
  return count_steps (w) || choose_order (w, k) || choose_implicit (w, k);
}

#if defined (GSMBP_QUAD)
static const char precision[] = "quad";
#elif defined (GSMBP_FLOAT)
static const char precision[] = "single";
#else
static const char precision[] = "double";
#endif

/* The least tolerance that the precision can keep: ten units of rounding (the error estimate of a
 * step of dp853 rounds to about one), a hundred with cvode (its Newton iteration and the projection
 * within it leave more). Below that steps are rejected for rounding errors, at any length. */
static gs_real
least_tolerance (const gs_whole_run *w)
{
  return (is (w, "cvode") || is (w, "auto") ? 100 : 10) * GS_EPSILON;
}

int
gs_choose_tolerances (gs_whole_run *w)
{
  const int nx = w->d->scene->nx;
  const double rtol = isnan (w->o->rtol) ? number_of ("rtol") : w->o->rtol;
  const gs_real least = least_tolerance (w);
  char small[200] = "";
  gs_writer told = { small, (int)sizeof small, 0 };
  if (! (rtol > 0 && rtol < 1))
    return gs_refuse (w->r, GS_REFUSED_OPTION, "rtol",
                      "expected a number above 0 and below 1; found %g", rtol);
  if ((gs_real)rtol < least)
    gs_put (&told, "rtol = %g", rtol);
  w->ropt[1] = gs_max ((gs_real)rtol, least);
  int low = 0;
  for (int k = 0; k < nx; k++)
    {
      const gs_real nominal = (gs_real)w->d->nominal[k];
      const gs_real given = w->o->atol ? w->o->atol[k] : w->ropt[1] * nominal;
      if (! (given >= 0 && given <= GS_HUGE))
        return gs_refuse (w->r, GS_REFUSED_OPTION, "atol",
                          "expected finite numbers >= 0; found %g of %s", (double)given,
                          w->d->states[k]);
      if (given < least * nominal * (1 - GS_R (1e-9)) && low++ == 0)
        gs_put (&told, "%satol = %g of %s", *small ? ", " : "", (double)given, w->d->states[k]);
      w->atol[k] = gs_max (given, least * nominal);
    }
  if (*small && ! is (w, "rk4"))
    snprintf (w->r->warning, sizeof w->r->warning, gs_refusals.low_tolerance, small, precision,
              (double)least);
  w->r->rtol = (double)w->ropt[1];
  for (int k = nx; k < w->r->nx; k++)   /* of an audit, of derivatives */
    w->atol[k] = w->o->audit > 0 ? w->ropt[1] * (gs_real)w->o->audit
                                 : w->atol[k % nx] / (gs_real)w->o->sizes[k / nx - 1];
  return 0;
}
