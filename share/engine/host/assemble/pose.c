/* pose.c: constraints on positions at a state, and displacements of its coordinates. */
#include "gsmbp/functions.h"
#include "host/assemble/assemble_parts.h"

int
gs_pose_begin (gs_work *w, gs_pose *p)
{
  const gs_scene *s = w->s;
  const int m = s->nlam, nu = s->nu;
  *p = (gs_pose){ 0, gs_numbers (w, m), gs_numbers (w, m * nu), gs_numbers (w, s->nq * nu),
                  gs_numbers (w, m), gs_numbers (w, m * nu), gs_numbers (w, m),
                  gs_numbers (w, m), gs_numbers (w, nu) };
  return w->told->verdict;
}

static int
is_on_speeds (const gs_description *d, int row)
{
  return gs_is_among (row + 1, d->nspeedrows, d->speedrows);
}

void
gs_pose_at (const gs_work *w, const gs_real *x, gs_pose *p)
{
  const gs_scene *s = w->s;
  const int nu = s->nu, m = s->nlam;
  s->con (w->t, x, x + s->nq, w->cst, p->all, p->rate, p->rows, m, p->gam);
  p->n = 0;
  for (int i = 0; i < m; i++)
    p->n += ! is_on_speeds (w->d, i);
  for (int i = 0, row = 0; i < m; i++)
    if (! is_on_speeds (w->d, i))
      {
        p->phi[row] = p->all[i];
        gs_put_row (nu, p->rows, m, i, p->h, p->n, row++);
      }
  for (int j = 0; j < nu; j++)
    {
      gs_real *column = p->k + s->nq * j;
      gs_zero (nu, p->one);
      p->one[j] = 1;
      if (s->kin)
        s->kin (w->t, x, p->one, w->cst, column);
      else
        gs_copy (nu, p->one, column);   /* speeds are rates of the coordinates */
    }
}

void
gs_speeds_beside (const gs_work *w, const gs_pose *p, const int *coordinates, int *speeds)
{
  for (int j = 0; j < w->s->nu; j++)
    {
      speeds[j] = 1;
      for (int i = 0; i < w->s->nq; i++)
        speeds[j] &= ! (coordinates[i] && gs_abs (p->k[i + w->s->nq * j]) > GS_R (1e-12));
    }
}

void
gs_least_step (gs_work *w, int n, const gs_real *rows, const int *speeds, const gs_real *gap,
               gs_real *step)
{
  gs_block *begin = w->blocks;
  const int nu = w->s->nu;
  gs_real *part = gs_numbers (w, n * nu), *inverse = gs_numbers (w, n * nu);
  int many = 0;
  gs_zero (nu, step);
  if (part && inverse)
    {
      for (int j = 0; j < nu; j++)
        if (speeds[j])
          gs_copy (n, rows + n * j, part + n * many++);
      if (n > 0 && many > 0)
        gs_pseudo_inverse (w, n, many, part, (gs_real)gs_most (n, many) * gs_epsilon (), inverse);
      for (int j = 0, row = 0; j < nu; j++)
        if (speeds[j])
          {
            for (int i = 0; i < n; i++)
              step[j] += inverse[row + many * i] * gap[i];
            row++;
          }
    }
  gs_work_back (w, begin);
}

gs_real
gs_newton_move (gs_work *w, const gs_pose *p, const int *speeds, gs_real *move)
{
  gs_block *begin = w->blocks;
  const int nu = w->s->nu, nq = w->s->nq;
  gs_real *step = gs_numbers (w, nu), most = 0;
  gs_zero (nq, move);
  if (step)
    {
      gs_least_step (w, p->n, p->h, speeds, p->phi, step);
      most = gs_largest_modulus (nu, step);
      for (int j = 0; j < nu; j++)
        gs_take (nq, step[j], p->k + nq * j, move);
    }
  gs_work_back (w, begin);
  return most;
}

double
gs_extent (const gs_work *w, const gs_real *move)
{
  double most = 0;
  for (int i = 0; i < w->s->nq; i++)
    {
      const double part = fabs ((double)move[i]) / w->d->nominal[i];
      if (! (part <= most))
        most = part;
    }
  return most;
}

void
gs_unit_orientations (const gs_description *d, gs_real *x)
{
  for (int k = 0; k < d->nsets; k++)
    {
      const int *set = d->sets + 4 * k;
      gs_real sum = 0;
      for (int j = 0; j < 4; j++)
        sum += x[set[j]] * x[set[j]];
      for (int j = 0; j < 4 && sum > 0; j++)
        x[set[j]] /= gs_sqrt (sum);
    }
}

void
gs_displace (const gs_work *w, const gs_real *x, const gs_real *move, gs_real *y)
{
  if (y != x)
    gs_copy (w->s->nx, x, y);
  for (int i = 0; i < w->s->nq; i++)
    y[i] += move[i];
  gs_unit_orientations (w->d, y);
}

gs_real
gs_largest_modulus (int n, const gs_real *a)
{
  gs_real most = 0;
  for (int i = 0; i < n; i++)
    if (! (gs_abs (a[i]) <= most))
      most = gs_abs (a[i]);
  return most;
}

int
gs_rank_of (gs_work *w, int m, int n, const gs_real *a, int k, const gs_real *b)
{
  gs_block *begin = w->blocks;
  gs_real *both = gs_numbers (w, (m + k) * n);
  int rank = 0;
  if (both && m + k > 0)
    {
      for (int i = 0; i < m; i++)
        gs_put_row (n, a, m, i, both, m + k, i);
      for (int i = 0; i < k; i++)
        gs_put_row (n, b, k, i, both, m + k, m + i);
      rank = gs_rank (w, m + k, n, both, GS_R (1e-11) * gs_norm (w, m + k, n, both));
    }
  gs_work_back (w, begin);
  return rank;
}

int
gs_rows_of (int m, int n, const gs_real *a, const int *mask, gs_real *part)
{
  int many = 0, row = 0;
  for (int i = 0; i < m; i++)
    many += mask[i] != 0;
  for (int i = 0; i < m; i++)
    if (mask[i])
      gs_put_row (n, a, m, i, part, many, row++);
  return many;
}
