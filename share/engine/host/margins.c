/* margins.c: where the laws of devices hold. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/limits.h"
#include "gsmbp/refusals.h"
#include "host/start.h"
#include "host/text.h"

/* does margin k hold where one state is moved a little? What steps of an integrator or a projection
 * leave is no fault. w: nx + 2*nmargins numbers */
static int
holds_near (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
            const gs_real *cst, int k, gs_real *w)
{
  const int nx = d->scene->nx;
  gs_real *y = w, *g = w + nx, *size = g + d->nmargins;
  memcpy (y, x, (size_t)nx * sizeof *y);
  for (int j = 0; j < 2 * nx; j++)
    {
      const int i = j / 2;
      const double step = (j % 2 ? -1 : 1) * gs_limits.margin_near * d->nominal[i];
      y[i] = x[i] + (gs_real)step;
      d->mar (t, y, v, cst, g, size);
      y[i] = x[i];
      if (g[k] >= 0)
        return 1;
    }
  return 0;
}

/* which margins are passed at x, of those that have not been; w: their values, then room for
 * nx + 3*nmargins numbers */
static int
passed_here (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
             const gs_real *cst, int *passed, gs_real *w)
{
  gs_real *g = w, *size = w + d->nmargins;
  int many = 0;
  d->mar (t, x, v, cst, g, size);
  for (int k = 0; k < d->nmargins; k++)
    {
      if (passed[k] || g[k] >= -(gs_real)gs_limits.margin_rounding * size[k])
        continue;
      passed[k] = ! holds_near (d, t, x, v, cst, k, w + 2 * d->nmargins);
      many += passed[k];
    }
  return many;
}

static gs_real *
room (const gs_description *d)
{
  return malloc ((size_t)(d->scene->nx + 4 * d->nmargins + 1) * sizeof (gs_real));
}

int
gs_margins_at (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
               const gs_real *cst, int *passed, double *least)
{
  if (! d->mar || d->nmargins == 0)
    return 0;
  gs_real *w = room (d);
  if (! w)
    return -1;
  const int many = passed_here (d, t, x, v, cst, passed, w);
  for (int k = 0; k < d->nmargins; k++)
    if (! isnan (least[k]) && ! ((double)w[k] >= least[k]))
      least[k] = (double)w[k];
  free (w);
  return many;
}

/* the states and parameters of margin k, if they are known */
static void
put_values (gs_writer *w, const gs_description *d, int k, const gs_real *x, const double *par)
{
  const int *list = d->margin_values;
  int shown = 0;
  if (! list || ! x)
    return;
  for (; k > 0; k--)
    {
      list += 1 + list[0];
      list += 1 + list[0];
    }
  for (int i = 1; i <= list[0]; i++)
    gs_put (w, "%s%s = %.6g", shown++ ? ", " : " (", d->states[list[i]], (double)x[list[i]]);
  list += 1 + list[0];
  for (int i = 1; i <= list[0] && par; i++)
    gs_put (w, "%s%s = %.6g", shown++ ? ", " : " (", d->parameters[list[i]], par[list[i]]);
  gs_put (w, shown ? ")" : "");
}

void
gs_margin_text (const gs_description *d, int k, double value, const gs_real *x, const double *par,
                char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  gs_put (&w, "%s: expected above 0, found %.6g", d->margins[k], value);
  put_values (&w, d, k, x, par);
}

/* the margins that are passed at x, each as the format has it, with a text between them */
static int
put_passed (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
            const gs_real *cst, const double *par, const char *format, const char *between,
            gs_writer *w)
{
  const size_t n = (size_t)d->nmargins;
  int *passed = calloc (n + 1, sizeof *passed);
  double *least = malloc ((n + 1) * sizeof *least);
  for (size_t k = 0; k < n && least; k++)
    least[k] = HUGE_VAL;
  const int many = passed && least ? gs_margins_at (d, t, x, v, cst, passed, least) : -1;
  for (int k = 0; k < d->nmargins && many > 0; k++)
    if (passed[k])
      {
        char one[600];
        gs_margin_text (d, k, least[k], x, par, one, sizeof one);
        gs_put (w, "%s", w->length > 0 ? between : "");
        gs_put (w, format, one);
      }
  free (passed);
  free (least);
  return many;
}

int
gs_passed_text (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
                const gs_real *cst, const double *par, char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  return put_passed (d, t, x, v, cst, par, "%s", "; ", &w);
}

void
gs_outside_text (const gs_description *d, gs_real t, const gs_real *x, const gs_real *v,
                 const gs_real *cst, const double *par, char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  put_passed (d, t, x, v, cst, par, gs_refusals.outside, "", &w);
}

/* a margin counts where its smallest value in the run is one that is passed */
static void
take_smallest (const gs_real *g, int j, int n, gs_passed_margin *list)
{
  for (int k = 0; k < n; k++)
    {
      const double value = (double)g[k];
      if (isnan (list[k].least) || value >= list[k].least)
        continue;
      list[k].least = value;
      list[k].at = j;
    }
}

/* those of n that are passed, one after the other */
static int
gather (const int *passed, int n, gs_passed_margin *list)
{
  int many = 0;
  for (int k = 0; k < n; k++)
    if (passed[k])
      list[many++] = list[k];
  return many;
}

int
gs_margins_of_run (const gs_description *d, int n, const gs_real *t, const gs_real *x, int ldx,
                   const gs_real *v, int ldv, const gs_real *cst, gs_passed_margin *list)
{
  if (! d->mar || d->nmargins == 0)
    return 0;
  gs_real *w = room (d);
  int *passed = calloc ((size_t)d->nmargins, sizeof *passed);
  for (int k = 0; k < d->nmargins; k++)
    list[k] = (gs_passed_margin){ k, -1, 0, HUGE_VAL };
  for (int j = 0; j < n && w && passed; j++)
    {
      passed_here (d, t[j], x + (size_t)ldx * (size_t)j, v + (size_t)ldv * (size_t)j, cst, passed,
                   w);
      take_smallest (w, j, d->nmargins, list);
      for (int k = 0; k < d->nmargins; k++)
        if (passed[k] && list[k].first < 0)
          list[k].first = j;
    }
  const int many = w && passed ? gather (passed, d->nmargins, list) : -1;
  free (w);
  free (passed);
  return many;
}
