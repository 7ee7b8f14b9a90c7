/* eliminate.c: a program solved without the unknowns that equations determine. */
#include "host/collocation/eliminate_parts.h"

#include <math.h>
#include <string.h>

/* bounds and where to begin, of the unknowns and equations that are left */
static void
take_bounds (const gs_rest_program *e, double *x0, double *low, double *high, double *glow,
             double *ghigh)
{
  const gs_nlp *p = e->p;
  for (int k = 0; k < p->n; k++)
    if (e->column[k] >= 0)
      {
        x0[e->column[k]] = p->x0[k];
        low[e->column[k]] = p->low[k];
        high[e->column[k]] = p->high[k];
      }
  for (int k = 0; k < p->m; k++)
    if (e->row[k] >= 0)
      {
        glow[e->row[k]] = p->glow[k];
        ghigh[e->row[k]] = p->ghigh[k];
      }
}

/* the result of the whole program from that of what is left, found */
static void
take_result (gs_rest_program *e, const gs_nlp_result *found, gs_nlp_result *r)
{
  const gs_nlp *p = e->p;
  double *x = r->x, *zl = r->zl, *zu = r->zu, *g = r->g, *lambda = r->lambda;
  const int good = gs_rest_move (e, found->x);
  *r = *found;
  r->x = x, r->zl = zl, r->zu = zu, r->g = g, r->lambda = lambda;
  for (int k = 0; k < p->n; k++)
    {
      const int at = e->column[k];
      x[k] = e->z[k];
      zl[k] = at < 0 ? 0 : found->zl[at];
      zu[k] = at < 0 ? 0 : found->zu[at];
    }
  for (int k = 0; k < p->m; k++)
    if (e->row[k] >= 0)
      e->lambda[k] = found->lambda[e->row[k]];
  if (! good || ! gs_rest_multipliers (e, 1))
    for (int k = 0; k < p->m; k++)
      e->lambda[k] = NAN;
  memcpy (lambda, e->lambda, (size_t)p->m * sizeof *lambda);
  if (! p->evaluate (p->data, GS_EQUATIONS, x, 1, NULL, g))
    for (int k = 0; k < p->m; k++)
      g[k] = NAN;
}

static int
solve_rest (gs_nlp_solver *solver, gs_rest_program *e, const gs_nlp_options *o, gs_nlp_result *r)
{
  gs_room *room = &e->room;
  double *x0 = gs_room_numbers (room, e->n), *low = gs_room_numbers (room, e->n);
  double *high = gs_room_numbers (room, e->n), *glow = gs_room_numbers (room, e->m);
  double *ghigh = gs_room_numbers (room, e->m);
  const int second = e->hessian > 0 ? e->hessian : 0;
  int *places[4];
  for (int k = 0; k < 4; k++)
    places[k] = gs_room_places (room, k < 2 ? e->jacobian : second);
  gs_nlp_result found = *r;
  found.x = gs_room_numbers (room, e->n);
  found.zl = gs_room_numbers (room, e->n);
  found.zu = gs_room_numbers (room, e->n);
  found.g = gs_room_numbers (room, e->m);
  found.lambda = gs_room_numbers (room, e->m);
  if (room->full)
    return 1;
  take_bounds (e, x0, low, high, glow, ghigh);
  gs_rest_places (e, GS_JACOBIAN, places[0], places[1]);
  if (second)
    gs_rest_places (e, GS_HESSIAN, places[2], places[3]);
  const gs_nlp rest = { e->n, e->m, x0, low, high, glow, ghigh, e->jacobian, e->hessian,
                        places[0], places[1], places[2], places[3], e, gs_rest_evaluate };
  const int bad = solver (&rest, o, &found);
  if (! bad)
    take_result (e, &found, r);
  else
    memcpy (r->ended, found.ended, sizeof r->ended);
  return bad;
}

int
gs_solve_eliminated (gs_nlp_solver *solver, const gs_nlp *p, const gs_determined *d,
                     const gs_nlp_options *o, gs_nlp_result *r)
{
  gs_rest_program e = { .p = p, .d = *d };
  int bad, can = d->count > 0 && d->size > 0 && d->size <= GS_MOST_DETERMINED
                 && gs_rest_lay (&e);
  if (can)
    {
      memcpy (e.z, p->x0, (size_t)p->n * sizeof *e.z);
      double *x = gs_room_numbers (&e.room, e.n);
      for (int k = 0; x && k < p->n; k++)
        if (e.column[k] >= 0)
          x[e.column[k]] = p->x0[k];
      can = x && gs_rest_move (&e, x);
    }
  bad = e.room.full ? 1 : can ? solve_rest (solver, &e, o, r) : solver (p, o, r);
  gs_room_free (&e.room);
  return bad;
}
