/* close_guess.c: one guess onto the constraints, or why it does not go there. */
#include "gsmbp/refusals.h"
#include "host/assemble/assemble_parts.h"

static void
put_row (gs_writer *said, const gs_description *d, int row)
{
  if (d->constraints)
    gs_put (said, "phi of %s", d->constraints[row]);
  else
    gs_put (said, "phi(%d)", row + 1);
}

static gs_writer
into (char *text, size_t size)
{
  text[0] = 0;
  return (gs_writer){ text, (int)size, 0 };
}

/* ----------------------------------------------------------------- why coordinates are not held */

/* where the branch of the guess ends: the state near, before the held coordinates are as in x */
static void
tell_end (const gs_work *w, const int *held, const gs_real *near, const gs_real *x, gs_closing *c)
{
  int k = -1;
  for (int i = 0; i < w->s->nq; i++)
    if (held[i] && (k < 0 || gs_abs (x[i] - near[i]) > gs_abs (x[k] - near[k])))
      k = i;
  const char *name = w->d->states[k];
  const double end = (double)near[k], wanted = (double)x[k];
  gs_writer said = into (c->unclosed, sizeof c->unclosed);
  gs_put (&said, "option hold: expected %s %s %.6g, where the branch of the guess ends; found "
          "%.6g, with which the loops do not close", name, wanted > end ? "at most" : "at least",
          end, wanted);
  if (! c->listed)
    gs_put (&said, "; other branches: option \"branches\"");
  said = into (c->elsewhere, sizeof c->elsewhere);
  gs_put (&said, "option hold: expected %s = %.6g on the branch of the guess; found its end at "
          "%s = %.6g; another branch reaches it: list them with \"branches\", 20", name, wanted,
          name, end);
}

/* the row of the constraints that states the one coordinate k alone */
static void
put_reason (gs_work *w, const gs_pose *p, int k, gs_writer *said)
{
  const int nu = w->s->nu, nq = w->s->nq;
  for (int row = 0, i = 0; row < w->s->nlam; row++)
    {
      if (gs_is_among (row + 1, w->d->nspeedrows, w->d->speedrows))
        continue;
      int some = 0, others = 0;
      for (int j = 0; j < nu; j++)
        {
          const int entry = ! (gs_abs (p->h[i + p->n * j]) <= 0);
          some |= entry;
          others |= entry && ! (gs_abs (p->k[k + nq * j]) > 0);
        }
      i++;
      if (some && ! others)
        {
          gs_put (said, "driven (");
          put_row (said, w->d, row);
          gs_put (said, ")");
          return;
        }
    }
  gs_put (said, "fixed by the constraints");
}

/* coordinates that may not be held: driven or fixed by the constraints, or more of them than the
 * loops leave freedoms; near: the closed pose near the guess x */
static void
tell_dependent (gs_work *w, const int *held, const gs_real *near, const gs_real *x, gs_closing *c)
{
  const int nq = w->s->nq, nu = w->s->nu;
  gs_pose p;
  gs_real *k = gs_numbers (w, nq * nu);
  gs_writer said = into (c->unclosed, sizeof c->unclosed);
  if (! k || gs_pose_begin (w, &p) != 0)
    return;
  gs_pose_at (w, near, &p);
  if (! (gs_largest_modulus (p.n, p.phi) <= GS_R (1e-8)))
    return;
  const int rank = gs_rank_of (w, p.n, nu, p.h, 0, NULL);
  for (int i = 0; i < nq; i++)
    {
      gs_put_row (nu, p.k, nq, i, k, 1, 0);
      if (held[i] && gs_rank_of (w, p.n, nu, p.h, 1, k) == rank)
        {
          gs_put (&said, "option hold: %s is ", w->d->states[i]);
          put_reason (w, &p, i, &said);
          gs_put (&said, ", at the time %g to %.6g; found %.6g; leave it out of hold, or take "
                  "another time (option time)", (double)w->t, (double)near[i], (double)x[i]);
          return;
        }
    }
  const int many = gs_rows_of (nq, nu, p.k, held, k);
  const int left = gs_rank_of (w, p.n, nu, p.h, many, k) - rank;
  if (left >= many)
    return;
  gs_put (&said, "option hold: the loops leave %d degree(s) of freedom to ", left);
  for (int i = 0, n = 0; i < nq; i++)
    if (held[i])
      gs_put (&said, n++ ? ", %s" : "%s", w->d->states[i]);
  gs_put (&said, "; expected at most as many coordinates to hold, found %d", many);
}

/* ---------------------------------------------------------------------------- held coordinates */

/* the speeds of x that are free onto the rates of the constraints */
static void
fit_speeds (gs_work *w, const int *held, gs_pose *p, int *speeds, gs_real *x)
{
  gs_block *begin = w->blocks;
  const int m = w->s->nlam, nu = w->s->nu;
  gs_real *u = x + w->s->nq, *gap = gs_numbers (w, m), *step = gs_numbers (w, nu);
  if (gap && step)
    {
      gs_pose_at (w, x, p);
      gs_speeds_beside (w, p, held, speeds);
      for (int i = 0; i < m; i++)
        {
          gap[i] = p->rate[i];
          for (int j = 0; j < nu; j++)
            gap[i] += p->rows[i + m * j] * u[j];
        }
      gs_least_step (w, m, p->rows, speeds, gap, step);
      for (int j = 0; j < nu; j++)
        u[j] -= step[j];
    }
  gs_work_back (w, begin);
}

/* Newton's method on what is not held, by displacements of the speeds; then the speeds */
static void
solve_held (gs_work *w, const int *held, gs_real *x)
{
  gs_block *begin = w->blocks;
  const int nq = w->s->nq, nx = w->s->nx;
  gs_pose p;
  gs_real *best = gs_numbers (w, nx), *move = gs_numbers (w, nq), least = GS_INFINITY;
  int *speeds = gs_places (w, w->s->nu);
  if (best && move && speeds && gs_pose_begin (w, &p) == 0)
    {
      gs_unit_orientations (w->d, x);
      for (int turn = 0; turn <= 60; turn++)
        {
          gs_pose_at (w, x, &p);
          const gs_real gap = gs_largest_modulus (p.n, p.phi);
          if (gap < least)
            {
              least = gap;
              gs_copy (nx, x, best);
            }
          gs_speeds_beside (w, &p, held, speeds);
          const gs_real most = gs_newton_move (w, &p, speeds, move);
          for (int i = 0; i < nq && most > 1; i++)
            move[i] /= most;
          const gs_real size = gs_largest_modulus (nq, x);
          if (! (gap > 0) || ! (gs_largest_modulus (nq, move)
                                > GS_R (1e-15) * (size > 1 ? size : 1)))
            break;
          gs_displace (w, x, move, x);
        }
      if (least < GS_INFINITY)
        gs_copy (nx, best, x);
      fit_speeds (w, held, &p, speeds, x);
    }
  gs_work_back (w, begin);
}

/* x with the held coordinates at their values, on the branch of the guess; where that cannot be,
 * what c says */
static void
close_held (gs_work *w, const gs_assembly_asked *a, gs_real *x, gs_closing *c)
{
  if (! c->anywhere)
    {
      gs_real *near = gs_numbers (w, w->s->nx);
      if (! near)
        return;
      gs_copy (w->s->nx, x, near);
      const double reached = gs_follow_branch (w, a->held, near);
      if (reached < 1)
        tell_end (w, a->held, near, x, c);
      else if (isnan (reached))
        tell_dependent (w, a->held, near, x, c);
      else
        gs_copy (w->s->nx, near, x);
    }
  solve_held (w, a->held, x);
}

/* ------------------------------------------------------------------------------ what is reached */

/* is x on the constraints, coordinates and speeds? If not, and c has no words for it yet, which row
 * is worst */
static int
closed (gs_work *w, double tolerance, const gs_real *x, gs_closing *c)
{
  const gs_scene *s = w->s;
  const int m = s->nlam, nu = s->nu;
  gs_pose p;
  if (gs_pose_begin (w, &p) != 0)
    return 0;
  int finite = 1, first = 0, second = 0, nowhere = 0;
  for (int i = 0; i < s->nx; i++)
    finite &= gs_abs (x[i]) <= GS_HUGE;
  if (finite)
    gs_pose_at (w, x, &p);
  double gap = -1, slip = -1, length = 0;
  for (int i = 0; i < m; i++)
    {
      gs_real rate = p.rate[i];
      for (int j = 0; j < nu; j++)
        rate += p.rows[i + m * j] * x[s->nq + j];
      p.rate[i] = finite ? rate : GS_INFINITY;
      p.all[i] = finite ? p.all[i] : GS_INFINITY;
      nowhere |= p.rate[i] != p.rate[i] || p.all[i] != p.all[i];
      if (! (fabs ((double)p.all[i]) <= gap))
        gap = fabs ((double)p.all[first = i]);
      if (! (fabs ((double)p.rate[i]) <= slip))
        slip = fabs ((double)p.rate[second = i]);
    }
  for (int j = 0; j < nu; j++)
    length += (double)(x[s->nq + j] * x[s->nq + j]);
  const double most = tolerance * fmax (1, sqrt (length));
  if (gap <= tolerance && slip <= most)
    return 1;
  if (c->unclosed[0])
    return 0;
  gs_writer said = into (c->unclosed, sizeof c->unclosed);
  gs_put (&said, gap <= tolerance ? "the speeds do not fit the constraints: the rate of "
                                  : "the loop does not close: ");
  put_row (&said, w->d, gap <= tolerance ? second : first);
  if (gap <= tolerance)
    gs_put (&said, " is %.6g", (double)p.rate[second]);
  else
    gs_put (&said, " = %.6g is left of the constraints (tolerance %g); try another guess, the "
            "option \"branches\", or check the lengths", (double)p.all[first], tolerance);
  if (nowhere)
    gs_put (&said, "%s", gs_refusals.no_number);
  return 0;
}

void
gs_close_guess (gs_work *w, const gs_assembly_asked *a, gs_real *x, gs_closing *c)
{
  gs_block *begin = w->blocks;
  int some = 0;
  gs_real left;
  c->unclosed[0] = c->elsewhere[0] = 0;
  for (int i = 0; i < w->s->nq; i++)
    some |= a->held[i];
  if (some)
    close_held (w, a, x, c);
  else
    w->s->prj (w->t, x, w->cst, &left);
  if (closed (w, a->tolerance, x, c))
    c->unclosed[0] = 0;
  gs_work_back (w, begin);
}
