/* eliminate_values.c: a program without the unknowns that equations determine, at a point. */
#include "host/collocation/eliminate_parts.h"

#include <math.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/solve.h"

/* ----------------------------------------------------------------------------- the whole point */

/* the derivatives of the equations of all blocks by their unknowns, inverted; 0: singular */
static int
invert (gs_rest_program *e)
{
  const gs_nlp *p = e->p;
  const int size = e->d.size;
  int order[GS_MOST_DETERMINED];
  for (int b = 0; b < e->d.count; b++)
    gs_zero (size * size, gs_inverse_of (e, b));
  for (int k = 0; k < p->jacobian; k++)
    {
      const int b = e->ruler[p->jac_rows[k]];
      if (b >= 0 && e->owner[p->jac_columns[k]] >= 0)
        gs_inverse_of (e, b)[p->jac_rows[k] - gs_equation_of (e, b)
                             + size * (p->jac_columns[k] - gs_unknown_of (e, b))] += e->jac[k];
    }
  for (int b = 0; b < e->d.count; b++)
    {
      gs_zero (size * size, e->unit);
      for (int i = 0; i < size; i++)
        e->unit[i + size * i] = 1;
      if (gs_solve_general (size, size, gs_inverse_of (e, b), size, e->unit, size, order) != 0)
        return 0;
      gs_copy (size * size, e->unit, gs_inverse_of (e, b));
    }
  return 1;
}

/* Newton's step of all blocks: the largest part of it beside the unknowns */
static double
step (gs_rest_program *e)
{
  double most = 0;
  for (int b = 0; b < e->d.count; b++)
    {
      const gs_real *inverse = gs_inverse_of (e, b);
      const double *g = e->g + gs_equation_of (e, b);
      double *z = e->z + gs_unknown_of (e, b), length = 1;
      for (int i = 0; i < e->d.size; i++)
        length += fabs (z[i]);
      for (int i = 0; i < e->d.size; i++)
        {
          double change = 0;
          for (int j = 0; j < e->d.size; j++)
            change += (double)inverse[i + e->d.size * j] * g[j];
          z[i] -= change;
          if (! (fabs (change) <= most * length))
            most = fabs (change) / length;
        }
    }
  return most;
}

/* by the others, from the derivatives of the equations of the blocks; those of second derivatives
 * alone are 0 */
static void
find_slopes (gs_rest_program *e)
{
  const gs_nlp *p = e->p;
  const int size = e->d.size;
  memset (e->slopes, 0, (size_t)(size * e->begins[e->d.count]) * sizeof *e->slopes);
  memset (e->pairs, 0, (size_t)(size * e->npairs) * sizeof *e->pairs);
  for (int k = 0; k < p->jacobian; k++)
    {
      const int b = e->ruler[p->jac_rows[k]], place = e->jac_place[k];
      if (place < 0)
        continue;
      if (b < 0)
        {
          const int own = e->owner[p->jac_columns[k]];
          e->pairs[size * place + p->jac_columns[k] - gs_unknown_of (e, own)] += e->jac[k];
          continue;
        }
      const gs_real *column = gs_inverse_of (e, b)
                             + size * (p->jac_rows[k] - gs_equation_of (e, b));
      for (int i = 0; i < size; i++)
        e->slopes[size * place + i] -= (double)column[i] * e->jac[k];
    }
}

static int
complete (gs_rest_program *e)
{
  const gs_nlp *p = e->p;
  for (int turn = 0; turn < 20; turn++)
    {
      if (! p->evaluate (p->data, GS_EQUATIONS, e->z, 1, NULL, e->g)
          || ! p->evaluate (p->data, GS_JACOBIAN, e->z, 1, NULL, e->jac) || ! invert (e))
        return 0;
      const double most = step (e);
      if (! (most > 1e-13))
        {
          find_slopes (e);
          return ! isnan (most);
        }
    }
  return 0;
}

int
gs_rest_move (gs_rest_program *e, const double *x)
{
  if (e->known && memcmp (e->x, x, (size_t)e->n * sizeof *x) == 0)
    return e->good;
  memcpy (e->x, x, (size_t)e->n * sizeof *x);
  for (int k = 0; k < e->p->n; k++)
    if (e->column[k] >= 0)
      e->z[k] = x[e->column[k]];
  e->known = 1;
  e->has_gradient = 0;
  e->good = complete (e);
  for (int k = 0; k < e->p->n && ! e->good; k++)
    if (e->owner[k] >= 0)
      e->z[k] = 0;   /* the next point begins anew */
  return e->good;
}

static int
find_gradient (gs_rest_program *e)
{
  if (! e->has_gradient)
    e->has_gradient = e->p->evaluate (e->p->data, GS_GRADIENT, e->z, 1, NULL, e->gradient);
  return e->has_gradient;
}

int
gs_rest_multipliers (gs_rest_program *e, double factor)
{
  const gs_nlp *p = e->p;
  const int size = e->d.size;
  if (! find_gradient (e))
    return 0;
  for (int b = 0; b < e->d.count; b++)
    for (int i = 0; i < size; i++)
      e->lambda[gs_equation_of (e, b) + i] = 0;
  for (int b = 0; b < e->d.count; b++)
    for (int a = 0; a < size; a++)
      {
        const double slope = factor * e->gradient[gs_unknown_of (e, b) + a];
        for (int i = 0; i < size; i++)
          e->lambda[gs_equation_of (e, b) + i]
              -= (double)gs_inverse_of (e, b)[a + size * i] * slope;
      }
  for (int k = 0; k < p->jacobian; k++)
    {
      const int own = e->owner[p->jac_columns[k]], row = p->jac_rows[k];
      if (own < 0 || e->ruler[row] >= 0)
        continue;
      const double slope = e->jac[k] * e->lambda[row];
      const int a = p->jac_columns[k] - gs_unknown_of (e, own);
      for (int i = 0; i < size; i++)
        e->lambda[gs_equation_of (e, own) + i]
            -= (double)gs_inverse_of (e, own)[a + size * i] * slope;
    }
  return 1;
}

/* --------------------------------------------------------------------------- what is left of it */

static void
put_gradient (const gs_rest_program *e, double *out)
{
  for (int k = 0; k < e->p->n; k++)
    if (e->column[k] >= 0)
      out[e->column[k]] = e->gradient[k];
  for (int b = 0; b < e->d.count; b++)
    for (int j = e->begins[b]; j < e->seconds[b]; j++)
      for (int i = 0; i < e->d.size; i++)
        out[e->column[e->others[j]]] += e->gradient[gs_unknown_of (e, b) + i]
                                        * e->slopes[e->d.size * j + i];
}

static void
put_jacobian (const gs_rest_program *e, double *out)
{
  const gs_nlp *p = e->p;
  const int size = e->d.size;
  for (int k = 0; k < p->jacobian; k++)
    if (e->ruler[p->jac_rows[k]] < 0 && e->owner[p->jac_columns[k]] < 0)
      *out++ = e->jac[k];
  for (int k = 0; k < e->npairs; k++)
    for (int j = e->begins[e->pair_block[k]]; j < e->seconds[e->pair_block[k]]; j++)
      {
        double sum = 0;
        for (int i = 0; i < size; i++)
          sum += e->pairs[size * k + i] * e->slopes[size * j + i];
        *out++ = sum;
      }
}

/* the lower triangle of block b, n others: h (size + n squared) has the second derivatives of its
 * own unknowns and the others; w: size*n */
static double *
put_square (const gs_rest_program *e, int b, int n, const double *h, double *w, double *out)
{
  const int size = e->d.size, all = size + n;
  const double *slopes = gs_slopes_of (e, b);
  for (int j = 0; j < n; j++)   /* w: by the own unknowns and other j, the others moving the own */
    for (int i = 0; i < size; i++)
      {
        double sum = 2 * h[i + all * (size + j)];
        for (int l = 0; l < size; l++)
          sum += h[i + all * l] * slopes[l + size * j];
        w[i + size * j] = sum / 2;
      }
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++)
      {
        double sum = 0;
        for (int l = 0; l < size; l++)
          sum += slopes[l + size * i] * w[l + size * j] + slopes[l + size * j] * w[l + size * i];
        *out++ = sum;
      }
  return out;
}

static void
put_hessian (gs_rest_program *e, double *out)
{
  const gs_nlp *p = e->p;
  const int size = e->d.size;
  for (int k = 0; k < p->hessian; k++)
    if (e->hess_place[2 * k] < 0)
      *out++ = e->hess[k];
  for (int b = 0, k = 0; b < e->d.count; b++)
    {
      const int n = e->begins[b + 1] - e->begins[b], all = size + n;
      memset (e->square, 0, (size_t)(all * all) * sizeof *e->square);
      for (; k < e->nseconds && e->second_block[k] == b; k++)
        {
          const int *at = e->hess_place + 2 * e->second_list[k];
          const double h = e->hess[e->second_list[k]];
          e->square[at[0] + all * at[1]] += h;
          if (at[0] != at[1])
            e->square[at[1] + all * at[0]] += h;
        }
      out = put_square (e, b, n, e->square, e->work, out);
    }
}

int
gs_rest_evaluate (void *data, int part, const double *x, double factor, const double *lambda,
                  double *out)
{
  gs_rest_program *e = (gs_rest_program *)data;
  const gs_nlp *p = e->p;
  if (! gs_rest_move (e, x))
    return 0;
  if (part == GS_GOAL)
    return p->evaluate (p->data, GS_GOAL, e->z, 1, NULL, out);
  if (part == GS_GRADIENT)
    {
      if (! find_gradient (e))
        return 0;
      put_gradient (e, out);
    }
  else if (part == GS_EQUATIONS)
    {
      if (! p->evaluate (p->data, GS_EQUATIONS, e->z, 1, NULL, e->g))
        return 0;
      for (int k = 0; k < p->m; k++)
        if (e->row[k] >= 0)
          out[e->row[k]] = e->g[k];
    }
  else if (part == GS_JACOBIAN)
    put_jacobian (e, out);
  else
    {
      for (int k = 0; k < p->m; k++)
        if (e->row[k] >= 0)
          e->lambda[k] = lambda[e->row[k]];
      if (! gs_rest_multipliers (e, factor)
          || ! p->evaluate (p->data, GS_HESSIAN, e->z, factor, e->lambda, e->hess))
        return 0;
      put_hessian (e, out);
    }
  return 1;
}
