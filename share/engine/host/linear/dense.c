/* dense.c: memory of a calculation, small matrices. */
#include <stdlib.h>

#include "gsmbp/functions.h"
#include "gsmbp/refusals.h"
#include "gsmbp/solve.h"
#include "host/linear/linear_parts.h"

struct gs_block
{
  gs_block *before;
  gs_real numbers[];
};

gs_work
gs_work_begin (const gs_description *d, const gs_linear_place *at, gs_linear_told *told)
{
  *told = (gs_linear_told){ .verdict = GS_LINEAR_FOUND };
  return (gs_work){ .d = d, .s = d->scene, .t = at->t, .cst = at->cst, .at = at, .told = told };
}

void
gs_work_back (gs_work *w, gs_block *to)
{
  while (w->blocks != to)
    {
      gs_block *before = w->blocks->before;
      free (w->blocks);
      w->blocks = before;
    }
}

int
gs_work_end (gs_work *w)
{
  gs_work_back (w, NULL);
  return w->told->verdict;
}

static void *
taken (gs_work *w, size_t bytes)
{
  gs_block *new = calloc (1, sizeof *new + bytes + sizeof (gs_real));
  if (! new)
    {
      w->told->verdict = GS_LINEAR_NO_MEMORY;
      return NULL;
    }
  new->before = w->blocks;
  w->blocks = new;
  return new->numbers;
}

gs_real *
gs_numbers (gs_work *w, int n)
{
  return taken (w, (size_t)n * sizeof (gs_real));
}

int *
gs_places (gs_work *w, int n)
{
  return taken (w, (size_t)n * sizeof (int));
}

int
gs_work_failed (gs_work *w, int verdict, const char *routine, int info)
{
  w->told->routine = routine;
  w->told->info = info;
  return w->told->verdict = verdict;
}

gs_writer
gs_work_refused (gs_work *w, int verdict)
{
  w->told->verdict = verdict;
  return (gs_writer){ w->told->text, sizeof w->told->text, 0 };
}

int
gs_no_derivative (gs_work *w, const char *of, const char *row, int column)
{
  const int nx = w->s->nx;
  return gs_no_derivative_by (w, of, row, column < nx ? w->d->states[column]
                                                      : w->at->inputs[column - nx]);
}

int
gs_no_derivative_by (gs_work *w, const char *of, const char *row, const char *by)
{
  char name[300];
  gs_writer said = gs_work_refused (w, GS_LINEAR_DERIVATIVE);
  snprintf (name, sizeof name, "%s%s", of, row);
  gs_put (&said, gs_refusals.no_derivative, name, by);
  return w->told->verdict;
}

/* ------------------------------------------------------------------------------------- matrices */

void
gs_product (int m, int k, int n, const gs_real *a, const gs_real *b, gs_real *c)
{
  gs_zero (m * n, c);
  for (int j = 0; j < n; j++)
    for (int l = 0; l < k; l++)
      for (int i = 0; i < m; i++)
        c[i + m * j] += a[i + m * l] * b[l + k * j];
}

void
gs_put_row (int n, const gs_real *a, int m, int i, gs_real *b, int mb, int j)
{
  for (int k = 0; k < n; k++)
    b[j + mb * k] = a[i + m * k];
}

/* a*v = us: us (m,n) has columns of the lengths s (n), which fall; how many there may be that are
 * not zero, -1: no memory */
static int
decompose (gs_work *w, int m, int n, const gs_real *a, gs_real **us, gs_real **v, gs_real **s)
{
  int rank;
  *us = gs_numbers (w, m * n);
  *v = gs_numbers (w, n * n);
  *s = gs_numbers (w, n);
  if (! *us || ! *v || ! *s)
    return -1;
  gs_copy (m * n, a, *us);
  gs_singular_values (m, n, *us, m, *v, n, *s, 0, &rank);
  return gs_least (m, n);
}

int
gs_null_space (gs_work *w, int m, int n, const gs_real *a, gs_real tol, gs_real *basis)
{
  gs_block *begin = w->blocks;
  gs_real *us, *v, *s;
  int columns = 0;
  const int most = decompose (w, m, n, a, &us, &v, &s);
  for (int j = 0; j < n && most >= 0; j++)
    if (j >= most || ! (s[j] > tol))
      {
        for (int i = 0; i < n; i++)
          basis[i + n * columns] = gs_abs (v[i + n * j]) < gs_epsilon () ? 0 : v[i + n * j];
        columns++;
      }
  gs_work_back (w, begin);
  return columns;
}

int
gs_rank (gs_work *w, int m, int n, const gs_real *a, gs_real tol)
{
  gs_block *begin = w->blocks;
  gs_real *us, *v, *s;
  int rank = 0;
  const int most = decompose (w, m, n, a, &us, &v, &s);
  for (int j = 0; j < most; j++)
    rank += s[j] > tol;
  gs_work_back (w, begin);
  return rank;
}

gs_real
gs_condition (gs_work *w, int n, const gs_real *a)
{
  gs_block *begin = w->blocks;
  gs_real *us, *v, *s;
  const int most = decompose (w, n, n, a, &us, &v, &s);
  const gs_real found = most > 0 && s[0] > 0 ? s[n - 1] / s[0] : most == 0;
  gs_work_back (w, begin);
  return found;
}

gs_real
gs_norm (gs_work *w, int m, int n, const gs_real *a)
{
  gs_block *begin = w->blocks;
  gs_real *us, *v, *s;
  const gs_real found = decompose (w, m, n, a, &us, &v, &s) > 0 ? s[0] : 0;
  gs_work_back (w, begin);
  return found;
}

void
gs_pseudo_inverse (gs_work *w, int m, int n, const gs_real *a, gs_real tol, gs_real *inverse)
{
  gs_block *begin = w->blocks;
  gs_real *us, *v, *s;
  const int most = decompose (w, m, n, a, &us, &v, &s);
  gs_zero (n * m, inverse);
  for (int l = 0; l < most; l++)
    if (s[l] > tol * s[0])
      for (int j = 0; j < m; j++)
        for (int i = 0; i < n; i++)
          inverse[i + n * j] += v[i + n * l] / s[l] * (us[j + m * l] / s[l]);
  gs_work_back (w, begin);
}

int
gs_column_order (gs_work *w, int m, int n, const gs_real *a, gs_real tol, int *order)
{
  gs_block *begin = w->blocks;
  gs_real *y = gs_numbers (w, m * n), *piv = gs_numbers (w, n);
  gs_real *beta = gs_numbers (w, gs_least (m, n)), *left = gs_numbers (w, gs_least (m, n));
  int rank = 0;
  if (y && piv && beta && left)
    {
      gs_copy (m * n, a, y);
      gs_qr_columns (m, n, y, m, tol, piv, beta, left, &rank);
      for (int j = 0; j < n; j++)
        order[j] = (int)piv[j] - 1;
    }
  gs_work_back (w, begin);
  return rank;
}

/* ---------------------------------------------------------------------------------------- lists */

static int
rising (const void *a, const void *b)
{
  const int i = *(const int *)a, j = *(const int *)b;
  return (i > j) - (i < j);
}

void
gs_sort_places (int n, int *list)
{
  qsort (list, (size_t)n, sizeof *list, rising);
}

int
gs_is_among (int k, int n, const int *list)
{
  for (int i = 0; i < n; i++)
    if (list[i] == k)
      return 1;
  return 0;
}
