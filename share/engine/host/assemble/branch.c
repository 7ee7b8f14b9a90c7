/* branch.c: the branch of a guess, followed to where the held coordinates have their values.
 *
 * Numerical continuation with a tangent predictor and Newton's corrector, whose steps are shorter
 * where the corrector is slow (Allgower and Georg, Introduction to Numerical Continuation Methods,
 * 1990, chapter 6). */
#include "host/assemble/assemble_parts.h"

typedef struct
{
  gs_work *w;
  const int *held;
  int nheld;
  gs_pose pose;
  gs_real *near, *move;   /* nx, nq */
  int *speeds;            /* nu */
} branch;

static gs_real
gap_of (const branch *b)
{
  gs_real sum = 0;
  for (int i = 0; i < b->pose.n; i++)
    sum += b->pose.phi[i] * b->pose.phi[i];
  return gs_sqrt (sum);
}

/* the constraints made small by the coordinates of the mask: Gauss and Newton, each step shortened
 * until the gap falls; what is left */
static gs_real
approach (branch *b, const int *moving, gs_real *x)
{
  gs_work *w = b->w;
  gs_pose_at (w, x, &b->pose);
  gs_real gap = gap_of (b);
  for (int turn = 0; turn < 60; turn++)
    {
      gs_speeds_beside (w, &b->pose, moving, b->speeds);
      for (int j = 0; j < w->s->nu; j++)
        b->speeds[j] = ! b->speeds[j];
      gs_newton_move (w, &b->pose, b->speeds, b->move);
      double part = 1 / fmax (1, 2 * gs_extent (w, b->move));
      do
        {
          for (int i = 0; i < w->s->nq; i++)
            b->move[i] *= part;
          gs_displace (w, x, b->move, b->near);
          gs_pose_at (w, b->near, &b->pose);
          part = 0.5;
        }
      while (! (gap_of (b) < gap) && gs_extent (w, b->move) >= 2e-12);
      if (! (gap_of (b) < gap))
        return gap;
      gs_copy (w->s->nx, b->near, x);
      gap = gap_of (b);
    }
  return gap;
}

/* do the constraints leave the held coordinates fewer freedoms than their number? */
static int
dependent (branch *b, const gs_real *x)
{
  gs_work *w = b->w;
  gs_block *begin = w->blocks;
  gs_real *k = gs_numbers (w, b->nheld * w->s->nu);
  int yes = 1;
  gs_pose_at (w, x, &b->pose);
  if (k)
    {
      const int n = b->pose.n, nu = w->s->nu;
      gs_rows_of (w->s->nq, nu, b->pose.k, b->held, k);
      yes = gs_rank_of (w, n, nu, b->pose.h, b->nheld, k)
            < gs_rank_of (w, n, nu, b->pose.h, 0, NULL) + gs_rank_of (w, 0, nu, NULL, b->nheld, k);
    }
  gs_work_back (w, begin);
  return yes;
}

/* the held coordinates of y at values (nheld), the others along the tangent at x; 0 where that is
 * too far */
static int
predict (branch *b, const gs_real *x, const gs_real *values, gs_real *y)
{
  gs_work *w = b->w;
  gs_block *begin = w->blocks;
  const int nq = w->s->nq, nu = w->s->nu;
  gs_pose_at (w, x, &b->pose);
  const int n = b->pose.n, m = n + b->nheld;
  gs_real *rows = gs_numbers (w, m * nu), *gap = gs_numbers (w, m), *step = gs_numbers (w, nu);
  int *all = gs_places (w, nu), near = 0;
  if (rows && gap && step && all)
    {
      for (int i = 0; i < n; i++)
        gs_put_row (nu, b->pose.h, n, i, rows, m, i);
      for (int i = 0, row = 0; i < nq; i++)
        if (b->held[i])
          {
            gs_put_row (nu, b->pose.k, nq, i, rows, m, n + row);
            gap[n + row] = values[row] - x[i];
            row++;
          }
      for (int j = 0; j < nu; j++)
        all[j] = 1;
      gs_least_step (w, m, rows, all, gap, step);
      gs_zero (nq, b->move);
      for (int j = 0; j < nu; j++)
        gs_take (nq, -step[j], b->pose.k + nq * j, b->move);
      near = gs_extent (w, b->move) <= 0.5;
      gs_displace (w, x, b->move, y);
      for (int i = 0, row = 0; i < nq; i++)
        if (b->held[i])
          y[i] = values[row++];
      gs_unit_orientations (w->d, y);
    }
  gs_work_back (w, begin);
  return near;
}

/* y: the pose with the held coordinates at values (nheld), by tangent and corrector. 1: the steps
 * of the corrector were small and fell quickly, thus it is on the branch of x */
static int
advance (branch *b, const gs_real *x, const gs_real *values, gs_real *y)
{
  double last = 0.2;
  if (! predict (b, x, values, y))
    return 0;
  for (int turn = 0; turn < 8; turn++)
    {
      gs_pose_at (b->w, y, &b->pose);
      gs_speeds_beside (b->w, &b->pose, b->held, b->speeds);
      gs_newton_move (b->w, &b->pose, b->speeds, b->move);
      gs_displace (b->w, y, b->move, y);
      const double size = gs_extent (b->w, b->move);
      if (size <= 1e-10)
        return 1;
      if (! (size <= last))
        return 0;
      last = size / 2;
    }
  return 0;
}

/* the held coordinates from where they are in x to target (nheld); values (2*nheld), y (nx):
 * workspace */
static double
go_along (branch *b, const gs_real *target, gs_real *values, gs_real *y, gs_real *x)
{
  gs_real *const first = values + b->nheld;
  double reached = 0, step = 1;
  for (int i = 0, row = 0; i < b->w->s->nq; i++)
    if (b->held[i])
      first[row++] = x[i];
  while (reached < 1 && step > 1e-6)
    {
      const double next = fmin (1, reached + step);
      for (int i = 0; i < b->nheld; i++)
        values[i] = next < 1 ? first[i] + (gs_real)next * (target[i] - first[i]) : target[i];
      if (advance (b, x, values, y))
        {
          gs_copy (b->w->s->nx, y, x);
          reached = next;
          step *= 2;
        }
      else
        step /= 4;
    }
  return reached;
}

double
gs_follow_branch (gs_work *w, const int *held, gs_real *x)
{
  gs_block *begin = w->blocks;
  const int nq = w->s->nq, nx = w->s->nx;
  branch b = { .w = w, .held = held, .near = gs_numbers (w, nx), .move = gs_numbers (w, nq),
               .speeds = gs_places (w, w->s->nu) };
  double reached = NAN;
  for (int i = 0; i < nq; i++)
    b.nheld += held[i] != 0;
  gs_real *target = gs_numbers (w, b.nheld), *values = gs_numbers (w, 2 * b.nheld);
  gs_real *y = gs_numbers (w, nx);
  int *all = gs_places (w, nq);
  if (b.near && b.move && b.speeds && target && values && y && all
      && gs_pose_begin (w, &b.pose) == 0)
    {
      for (int i = 0, row = 0; i < nq; i++)
        {
          all[i] = 1;
          if (held[i])
            target[row++] = x[i];
        }
      /* a closed pose near the guess: the held coordinates go where the others fit best, then all
         follow */
      approach (&b, held, x);
      if (approach (&b, all, x) <= GS_R (1e-9) && ! dependent (&b, x))
        reached = go_along (&b, target, values, y, x);
    }
  gs_work_back (w, begin);
  return reached;
}
