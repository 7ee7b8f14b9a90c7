/* residuals.c: how far a state is from its constraints. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/limits.h"
#include "gsmbp/refusals.h"
#include "host/start.h"
#include "host/text.h"

/* rows of constraints: there are none where CON was not emitted */
static int
constraints (const gs_description *d)
{
  return d->scene->con ? d->scene->nlam : 0;
}

static int
is_on_speeds (const gs_description *d, int row)
{
  for (int k = 0; k < d->nspeedrows; k++)
    if (d->speedrows[k] == row + 1)
      return 1;
  return 0;
}

int
gs_residual_rows (const gs_description *d)
{
  const int m = constraints (d);
  return d->nsets + (m > 0 ? 2 * m - d->nspeedrows : 0);
}

/* x, with Euler parameters of length 1 in y; how far their lengths were off */
static void
unit_sets (const gs_description *d, const gs_real *x, gs_real *y, double *off)
{
  memcpy (y, x, (size_t)d->scene->nx * sizeof *y);
  for (int k = 0; k < d->nsets; k++)
    {
      const int *set = d->sets + 4 * k;
      gs_real sum = 0;
      for (int j = 0; j < 4; j++)
        sum += x[set[j]] * x[set[j]];
      const gs_real length = gs_sqrt (sum);
      for (int j = 0; j < 4; j++)
        y[set[j]] /= length;
      off[k] = (double)(length - 1);
    }
}

/* what the nominal speeds make of row i */
static double
row_size (const gs_description *d, int i, const gs_real *rows)
{
  double sum = 0;
  for (int j = 0; j < d->scene->nu; j++)
    {
      const double one = (double)rows[i + d->scene->nlam * j] * d->nominal[d->scene->nq + j];
      sum += one * one;
    }
  return sqrt (sum);
}

/* the rate of row i, and the largest of its parts */
static double
row_rate (const gs_scene *s, int i, const gs_real *u, const gs_real *phit, const gs_real *rows,
          double *fast)
{
  gs_real rate = 0, parts = 0;
  for (int j = 0; j < s->nu; j++)
    {
      const gs_real one = rows[i + s->nlam * j] * u[j];
      rate += one;
      parts += gs_abs (one);
    }
  *fast = fmax ((double)parts, fabs ((double)phit[i]));
  return (double)(rate + phit[i]);
}

/* the rows of the constraints at x; w: 3*nlam + nlam*nu numbers */
static void
constraint_rows (const gs_description *d, gs_real t, const gs_real *x, const gs_real *cst,
                 gs_real *w, double *scaled, double *found)
{
  const gs_scene *s = d->scene;
  const int m = s->nlam, positions = m - d->nspeedrows;
  gs_real *phi = w, *phit = phi + m, *gam = phit + m, *rows = gam + m;
  const int info = s->con (t, x, x + s->nq, cst, phi, phit, rows, m, gam);
  const int usable = info == 0 || info == 2;
  double largest = 0;
  for (int i = 0; i < m; i++)
    largest = fmax (largest, row_size (d, i, rows));
  for (int i = 0, k = 0; i < m; i++)
    {
      /* a row that vanishes here (at a singular position) counts by the others */
      double size = fmax (row_size (d, i, rows), 1e-3 * largest), fast;
      size = size > 0 ? size : 1;
      const double rate = row_rate (s, i, x + s->nq, phit, rows, &fast);
      found[positions + i] = usable ? rate : NAN;
      scaled[positions + i] = found[positions + i] / fmax (size, fast);
      if (is_on_speeds (d, i))
        continue;
      found[k] = usable ? (double)phi[i] : NAN;
      scaled[k] = found[k] / size;
      k++;
    }
}

int
gs_residuals (const gs_description *d, gs_real t, const gs_real *x, const gs_real *cst,
              double *scaled, double *found)
{
  const gs_scene *s = d->scene;
  const int m = constraints (d);
  gs_real *w = malloc ((size_t)(s->nx + m * (3 + s->nu) + 1) * sizeof *w);
  for (int k = 0; k < gs_residual_rows (d) && ! w; k++)
    scaled[k] = found[k] = NAN;
  if (! w)
    return 1;
  unit_sets (d, x, w, found);   /* the other rows are as they are with that mended */
  memcpy (scaled, found, (size_t)d->nsets * sizeof *found);
  if (m > 0)
    constraint_rows (d, t, w, cst, w + s->nx, scaled + d->nsets, found + d->nsets);
  free (w);
  return 0;
}

static void
put_constraint (gs_writer *w, const gs_description *d, int row)
{
  if (d->constraints)
    gs_put (w, "%s", d->constraints[row]);
  else
    gs_put (w, "constraint %d", row + 1);
}

static void
put_row (gs_writer *w, const gs_description *d, int k)
{
  const int positions = constraints (d) - d->nspeedrows;
  if (k < d->nsets)
    {
      const int *set = d->sets + 4 * k;
      gs_put (w, "length of (%s, %s, %s, %s) - 1", d->states[set[0]], d->states[set[1]],
              d->states[set[2]], d->states[set[3]]);
    }
  else if (k - d->nsets >= positions)
    {
      gs_put (w, "rate of ");
      put_constraint (w, d, k - d->nsets - positions);
    }
  else
    {
      int row = -1;
      for (int left = k - d->nsets; left >= 0; left -= ! is_on_speeds (d, row))
        row++;
      put_constraint (w, d, row);
    }
}

void
gs_residual_name (const gs_description *d, int k, char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  put_row (&w, d, k);
}

/* the row that is worst of those that are at least as good as row last (-1: of all), NaN first;
 * among equal ones the first */
static int
worst_after (int n, const double *scaled, int last)
{
  int worst = -1;
  double most = -1;
  for (int k = 0; k < n; k++)
    {
      const double size = isnan (scaled[k]) ? HUGE_VAL : fabs (scaled[k]);
      const double before = last < 0 ? HUGE_VAL
                            : isnan (scaled[last]) ? HUGE_VAL : fabs (scaled[last]);
      if (last >= 0 && (size > before || (! (size < before) && k <= last)))
        continue;
      if (size > most)
        {
          most = size;
          worst = k;
        }
    }
  return worst;
}

void
gs_worst_residuals (const gs_description *d, const double *scaled, const double *found,
                    double limit, char *text, int size)
{
  const int rows = gs_residual_rows (d), most = 6;
  gs_writer w = { text, size, 0 };
  int n = 0, nowhere = 0;
  text[0] = 0;
  if (rows == 0)
    {
      gs_put (&w, "no row that could be looked at");
      return;
    }
  for (int k = 0; k < rows; k++)
    n += ! (fabs (scaled[k]) <= limit);
  n = n > 1 ? n : 1;
  for (int k = worst_after (rows, scaled, -1), i = 0; i < n && i < most;
       k = worst_after (rows, scaled, k), i++)
    {
      gs_put (&w, i == 0 ? "" : ", ");
      put_row (&w, d, k);
      gs_put (&w, isnan (found[k]) ? " = NaN" : " = %.6g", found[k]);
      nowhere |= isnan (found[k]);
    }
  if (n > most)
    gs_put (&w, " and %d more", n - most);
  if (nowhere)
    gs_put (&w, "%s", gs_refusals.no_number);
}

int
gs_beside_constraints (const gs_description *d, gs_real t, const gs_real *x, const gs_real *cst,
                       char *text, int size)
{
  const int n = gs_residual_rows (d);
  double *rows = malloc ((2 * (size_t)n + 1) * sizeof *rows);
  int beside = rows && gs_residuals (d, t, x, cst, rows, rows + n) == 0 ? 0 : -1;
  for (int k = 0; beside >= 0 && k < n; k++)
    beside |= ! (fabs (rows[k]) <= gs_limits.off_constraints);
  if (beside > 0)
    gs_worst_residuals (d, rows, rows + n, gs_limits.off_constraints, text, size);
  free (rows);
  return beside;
}
