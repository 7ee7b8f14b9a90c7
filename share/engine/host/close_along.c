/* close_along.c: Newton's method of clo goes to some closure, near or far. A step of the way counts
 * if gs_motion_follows: else another branch may have been met, and half the step is tried. */
#include "host/close_along.h"
#include "gsmbp/arith.h"
#include "gsmbp/expressions.h"
#include "gsmbp/inputs.h"

typedef struct
{
  const gs_scene *s;
  gs_real t;
  int r, na;
  const int *ipl;
  const gs_real *cst, *start, *way; /* (na): the planned coordinates of the guess, the rest to go */
  gs_real *rows;                    /* (nu,0:r) */
} chain;

/* the planned entries of column j: start + part*way, or part*way where start is a null pointer */
static void
plan (const chain *c, int j, const gs_real *start, gs_real part)
{
  for (int i = 0; i < c->na; i++)
    c->rows[c->ipl[i] - 1 + j * c->s->nu] = (start != NULL ? start[i] : 0) + part * c->way[i];
}

/* the coordinates q (nu,2) closed near a guess (nu) at a part of the way, and their slopes along
 * it: their rates less those that they have while the planned ones rest */
static int
close_at (const chain *c, gs_real part, const gs_real *guess, gs_real *q)
{
  const int nu = c->s->nu;
  gs_real res, *const slope = q + nu;
  gs_zero (nu * (c->r + 1), c->rows);
  gs_copy (nu, guess, c->rows);
  plan (c, 0, c->start, part);
  int info = c->s->clo (c->t, c->rows, c->cst, &res);
  gs_copy (nu, c->rows, q);
  for (int moving = 1; info == 0 && moving >= 0; moving--)
    {
      gs_zero (nu * c->r, c->rows + nu);
      gs_copy (nu, q, c->rows);
      plan (c, 1, NULL, (gs_real)moving);
      info = c->s->clo (c->t, c->rows, c->cst, &res);
      for (int i = 0; i < nu; i++)
        slope[i] = moving ? c->rows[nu + i] : slope[i] - c->rows[nu + i];
    }
  return info;
}

/* along the rest of the way from *done, where here (nu,2) has the coordinates and their slopes;
 * next: (nu,2) */
static int
go_on (const chain *c, gs_real *here, gs_real *next, gs_real *done)
{
  const int nu = c->s->nu;
  gs_real step = 1, reached = *done;
  while (reached < 1)
    {
      step = gs_min (step, 1 - reached);
      *done = reached + step;
      for (int i = 0; i < nu; i++)
        next[i] = here[i] + step * here[nu + i];
      const int info = close_at (c, *done, next, next);
      if (info == 0 && gs_motion_follows (nu, step, here, next))
        {
          gs_copy (2 * nu, next, here);
          reached = *done;
          step *= 2;
        }
      else if (step > GS_R (1e-9))
        step *= GS_R (0.5);
      else
        return info != 0 ? info : 2;
    }
  return 0;
}

int
gs_close_along (const gs_scene *s, gs_real t, int r, int na, const int *ipl,
                const gs_real *target, const gs_real *cst, gs_real *q, gs_real *done, gs_real *w)
{
  static const double begins[] = { 0, 1e-3, 1e-2, 0.1, 1 }; /* the guess itself may be singular */
  const int nu = s->nu;
  gs_real *const start = w, *const way = start + na, *const here = way + na;
  gs_real *const next = here + 2 * nu;
  const chain c = { s, t, r, na, ipl, cst, start, way, next + 2 * nu };
  int moves = 0, info = 1;
  for (int i = 0; i < na; i++)
    {
      start[i] = q[ipl[i] - 1];
      way[i] = target[i] - start[i];
      moves |= gs_abs (way[i]) > 0;
    }
  *done = 1;
  if (! moves)
    return 0;
  for (int k = 0; k < 5 && info != 0; k++)
    {
      *done = (gs_real)begins[k];
      info = close_at (&c, *done, q, here);
    }
  if (info == 0)
    info = go_on (&c, here, next, done);
  gs_copy (nu, here, q);
  return info;
}
