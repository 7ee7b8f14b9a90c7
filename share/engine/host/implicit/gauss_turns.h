/* Whole turns of coordinates, which gauss_momenta.c keeps apart. */
#ifndef GS_HOST_GAUSS_TURNS_H
#define GS_HOST_GAUSS_TURNS_H
#include <float.h>
#include "gauss_rates.h"

static const longer turn_ = 6.283185307179586476925286766559005768L;

/* do A and B say the same, of a coordinate as far as FAR? */
static int
same_numbers (int n, const double *a, const double *b, double bound, double far)
{
  for (int i = 0; i < n; i++)
    bound = fmax (bound, fabs (a[i]));
  for (int i = 0; i < n; i++)
    if (! (fabs (a[i] - b[i]) <= bound * (1e-12 + 1e-14 * far)))
      return 0;
  return 1;
}

/* do efforts and constraints at the state X say the same where coordinates are TURNS farther? */
static int
same_turned (gs_stepper *s, gs_momenta *w, double t, const double *x, const double *turns)
{
  int n = w->n, m = w->m;
  double *other = w->trial, *bias = w->pi, *rows = w->turned, far = 0, bound = 0;
  gs_copy (2 * n, x, other);
  for (int l = 0; l < n; l++)
    {
      other[l] = (double) (other[l] + turn_ * turns[l]);
      far = fmax (far, fabs (other[l]));
    }
  s->scene->bia (t, x, x + n, s->v, s->r->cst, w->bias);
  s->scene->bia (t, other, x + n, s->v, s->r->cst, bias);
  if (! same_numbers (n, w->bias, bias, w->large, far))
    return 0;
  if (m == 0)
    return 1;
  if (constraints_at (s, w, t, x, w->phi, rows) != 0
      || constraints_at (s, w, t, other, w->phi + m, rows + n * m) != 0)
    return 0;
  for (int k = 0; k < n * m; k++)
    bound = fmax (bound, fabs (rows[k]));
  return same_numbers (n * m, rows, rows + n * m, bound, far)
         && same_numbers (m, w->phi, w->phi + m, bound, far);
}

/* which coordinates are angles, of which one turn, or some, change nothing at the start */
static void
find_turning (gs_stepper *s, gs_momenta *w)
{
  static const int tried[] = { 1, -1, 3, -10, 100 };
  double *turns = w->old;
  for (int l = 0; l < w->n; l++)
    {
      w->turning[l] = gs_inputs_of_time (s) && ! gs_acts (s);
      gs_zero (w->n, turns);
      for (size_t k = 0; w->turning[l] && k < sizeof tried / sizeof tried[0]; k++)
        {
          turns[l] = tried[k];
          w->turning[l] = same_turned (s, w, s->t, s->x, turns);
        }
    }
}

/* what turns on by more than half a turn in X loses a whole one */
static void
take_turns (gs_stepper *s, gs_momenta *w, double *x)
{
  for (int l = 0; l < w->n; l++)
    if (w->turning[l] && fabs (x[l]) > 0.51 * (double) turn_)
      {
        double turns = rint (x[l] / (double) turn_);
        s->turns[l] += turns;
        gs_round_off (x[l] + (w->lost_q[l] - turns * turn_), &x[l], &w->lost_q[l]);
      }
}

/* no turns are kept apart from here on, in the state X */
static void
give_turns (gs_stepper *s, gs_momenta *w, double *x)
{
  for (int l = 0; l < w->n; l++)
    {
      gs_round_off (x[l] + (w->lost_q[l] + s->turns[l] * turn_), &x[l], &w->lost_q[l]);
      s->turns[l] = 0;
      w->turning[l] = 0;
    }
}
#endif
