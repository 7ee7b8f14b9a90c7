/* costates.c: what the multipliers of a solution say: the derivatives of the goal by the states,
 * the bounds that hold it back. */
#include <math.h>

#include "host/collocation/collocation_parts.h"

/* The weights of the rates by the multipliers of the defects beside those of the integral; where no
 * stage stands at the beginning of an interval what its defects have by the state there, which is
 * more accurate. */
void
gs_costates (const gs_solution *s, double *costates)
{
  const gs_program *c = s->c;
  const int nx = c->s->nx, own = c->rule.own;
  for (int q = 0; q < nx * c->points; q++)
    costates[q] = 0;
  for (int k = 0; k < c->intervals; k++)
    for (int i = 0; i < own; i++)
      for (int l = 0; l < 3; l++)
        for (int j = 0; j < nx; j++)
          costates[nx * gs_stage (c, k, l) + j]
              -= c->h[k] * c->rule.a[i][l] * s->r.lambda[gs_defect_row (c, k, i) + j];
  for (int q = 0; q < c->points; q++)
    {
      double weight = 0;
      for (int p = 0; p < c->nphase; p++)
        weight += c->weights[c->nphase * q + p];
      for (int j = 0; j < nx; j++)
        costates[nx * q + j] /= weight;
    }
  for (int k = 0; c->first > 0 && k < c->intervals; k++)
    for (int j = 0; j < nx; j++)
      {
        double *l = costates + nx * gs_left (c, k) + j;
        *l = 0;
        for (int i = 0; i < own; i++)
          *l -= s->r.lambda[gs_defect_row (c, k, i) + j];
      }
}

/* ------------------------------------------------------------------------------------- bounds */

/* one quantity at its bounds; multiplier: of the point q, from q 0 on, above 0 at the largest */
static int
both_bounds (const gs_solution *s, gs_active_bound as, const double *multiplier, double low,
             double high, gs_active_bound *list)
{
  const gs_program *c = s->c;
  int n = 0;
  for (int side = 0; side < 2; side++)
    {
      double most = 0;
      gs_active_bound one = as;
      int first = -1;
      one.largest = side;
      one.value = side ? high : low;
      for (int q = 0; q < c->points; q++)
        most = fmax (most, (2 * side - 1) * multiplier[q]);
      for (int q = 0; q < c->points; q++)
        {
          const double l = fmax (0, (2 * side - 1) * multiplier[q]);
          one.multiplier += l;
          if (! (l > 1e-6 * (1 + fabs (s->r.goal)) && l > 1e-4 * most))
            continue;
          first = first < 0 ? q : first;
          one.until = s->t[q];
        }
      if (first >= 0)
        {
          one.from = s->t[first];
          list[n++] = one;
        }
    }
  return n;
}

/* a duration or a parameter, unknown g of the program */
static int
one_bound (const gs_solution *s, int of, int number, int g, gs_active_bound *list)
{
  const double l = s->r.zu[g] - s->r.zl[g];
  if (! (s->low[g] < s->high[g] && fabs (l) > 1e-6 * (1 + fabs (s->r.goal))))
    return 0;
  *list = (gs_active_bound){ of, number, l > 0, l > 0 ? s->high[g] : s->low[g], NAN, NAN,
                             fabs (l) };
  return 1;
}

int
gs_active_bounds (gs_search *w, const gs_solution *s, gs_active_bound **list)
{
  const gs_program *c = s->c;
  const gs_motion_problem *p = &s->p;
  const int nx = c->s->nx, nv = c->s->nv, nz = c->nz;
  double *l = gs_room_numbers (&w->room, c->points);
  int n = 0;
  *list = (gs_active_bound *)gs_room_take (
      &w->room, 2 * (nx + nv + p->nbounded) + c->nphase + c->np, sizeof **list);
  if (gs_search_bad (w))
    return 0;
  for (int j = 0; j < nx + nv; j++)
    {
      const int at = j < nx ? j : nz - nv + j - nx;
      for (int q = 0; q < c->points; q++)
        {
          const int k = nz * q + at;
          const int fixed = s->low[k] == s->high[k] && ! (p->held && j >= nx);
          l[q] = fixed ? 0 : s->r.zu[k] - s->r.zl[k];
        }
      const gs_active_bound as = { .of = j < nx ? GS_BOUND_STATE : GS_BOUND_INPUT,
                                   .number = j < nx ? j : j - nx };
      n += both_bounds (s, as, l, p->low[at], p->high[at], *list + n);
    }
  for (int i = 0; i < p->nbounded; i++)
    {
      for (int q = 0; q < c->points; q++)
        l[q] = q < c->first ? 0 : s->r.lambda[gs_path_row (c, q, i)];
      const gs_active_bound as = { .of = GS_BOUND_OUTPUT, .number = p->bounded[i] };
      n += both_bounds (s, as, l, p->output_low[i], p->output_high[i], *list + n);
    }
  for (int k = 0; k < c->nphase; k++)
    n += one_bound (s, GS_BOUND_TIME, k, gs_duration_column (c, k), *list + n);
  for (int k = 0; k < c->np; k++)
    n += one_bound (s, GS_BOUND_PARAMETER, k, c->n - c->np + k, *list + n);
  return n;
}
