/* columns_turns.c: event functions that come close to 0 and turn: with other parameters there would
 * be an event. */
#include "host/derivatives/columns.h"

/* The values g1, g2, g of event function i at t1, t2, t, above 0: does the parabola through them
   turn close to 0? */
static void
watch_turn (gs_derivatives *d, int i, double t, double g1, double g2, double g)
{
  const double a = d->t2[i] - d->t1[i], b = t - d->t2[i];
  if (! (a > 0 && b > 0 && g2 < g1 && g2 <= g))
    return;
  const double s = (g2 - g1) / a, bend = ((g - g2) / b - s) / (a + b), slope = s + a * bend,
               low = g2 - slope * slope / (4 * bend);
  if (low <= 0.02 * d->most[i] && fmax (g1, g) - low > 1e-9 * d->most[i]
      && d->nturns < GS_MOST_TURNS)
    {
      d->turns[2 * d->nturns] = i + 1;
      d->turns[2 * d->nturns + 1] = d->t2[i] - slope / (2 * bend);
      d->nturns++;
    }
}

/* a value of event function i; one of the user may stay below 0 */
static void
watch (gs_derivatives *d, int i, double t, double g)
{
  const int own = gs_is_own (&d->events, i);
  const double side = own && d->g2[i] < 0 ? -1 : 1;
  if (! (t > d->t2[i]))
    d->t1[i] = d->t2[i] = t;
  d->most[i] = fmax (d->most[i], side * g);
  if (! own || (side * d->g1[i] > 0 && side * d->g2[i] > 0 && side * g > 0))
    watch_turn (d, i, t, side * d->g1[i], side * d->g2[i], side * g);
  d->t1[i] = d->t2[i];
  d->g1[i] = d->g2[i];
  d->t2[i] = t;
  d->g2[i] = g;
}

void
gs_columns_evt (gs_real t, const gs_real *x, const gs_real *v, const int *mode, const gs_real *cst,
                gs_real *gv)
{
  gs_derivatives *d = gs_columns_of (cst);
  d->inner.evt (t, x, v, mode, cst, gv);
  for (int i = 0; i < d->inner.nev; i++)
    if (gs_states_alone (d)) /* the ends of steps that close in on an event are no motion */
      {
        d->t1[i] = d->t2[i] = (double)t;
        d->g1[i] = d->g2[i] = (double)gv[i];
      }
    else if (d->changes[i])
      watch (d, i, (double)t, (double)gv[i]);
}

int
gs_derivatives_turns (const gs_derivatives *d, const double **pairs)
{
  *pairs = d->turns;
  return d->nturns;
}
