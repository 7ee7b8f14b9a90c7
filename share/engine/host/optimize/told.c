/* told.c: the result of a design, in numbers and in words. */
#include <string.h>

#include "host/optimize/optimize_parts.h"

#define GS_SOLVER_NAME(name) #name,
static const char *const solvers[] = { GS_DESIGN_SOLVERS (GS_SOLVER_NAME) };
#undef GS_SOLVER_NAME

/* name = value of the variables that are chosen, or of all */
static void
put_values (gs_writer *t, const gs_design *d, const double *p, const int *free, int all)
{
  const char *between = "";
  for (int i = 0; i < d->nfree; i++)
    if (all || ! free[i])
      {
        gs_put (t, "%s%s = %.6g", between, d->free[i].name, p[i]);
        between = ", ";
      }
}

static int
any_chosen (const gs_narrowed *q)
{
  for (int i = 0; i < q->w->d->nfree; i++)
    if (! q->free[i])
      return 1;
  return 0;
}

/* demands that contradict each other: which, and the values that miss them by least */
static int
contradict (gs_search_design *w, gs_best *b, gs_design_result *r)
{
  const gs_design *d = w->d;
  char text[2400] = "";
  gs_writer bounds = { text, sizeof text, 0 }, t = { r->ended, sizeof r->ended, 0 };
  double *z = gs_room_numbers (&w->room, d->nfree);
  r->conflict = gs_room_places (&w->room, d->ndemands);
  if (! z || ! r->conflict)
    return 1;
  r->nconflict = gs_find_conflict (w, b, r->conflict, z, &bounds);
  if (r->nconflict < 0)
    return 1;
  for (int j = 0; j < b->q.n; j++)
    r->values[b->q.at[j]] = z[j] * b->q.scale[j];
  r->info = 2;
  r->nactive = 0;
  gs_put (&t, "%s: ", r->nconflict == 1 ? "this demand cannot be met"
                                        : "these demands contradict each other");
  for (int k = 0; k < r->nconflict; k++)
    gs_put (&t, "%s%s", k ? "; " : "", d->rows[d->ngoal + r->conflict[k]].text);
  if (bounds.length)
    gs_put (&t, " (within %s)", text);
  gs_put (&t, "; %s missed by least at ", r->nconflict == 1 ? "it is" : "they are");
  put_values (&t, d, r->values, NULL, 1);
  if (any_chosen (&b->q))
    {
      gs_put (&t, ", of all choices with ");
      put_values (&t, d, r->values, b->q.free, 0);
    }
  return 0;
}

/* how the derivatives were found */
static void
say_derivatives (const gs_search_design *w, const gs_narrowed *q, gs_design_result *r)
{
  gs_writer t = { r->derivatives, sizeof r->derivatives, 0 };
  int many = 0;
  for (int i = 0; i < w->d->nfree; i++)
    if (q->free[i] && r->rough[i])
      gs_put (&t, "%s%s", many++ ? ", " : "differences of order 4 by ", w->d->free[i].name);
  if (many && many < q->n)
    gs_put (&t, ", exact by the others");
  if (many && w->d->why[0])
    gs_put (&t, ": %s", w->d->why);
  if (! many)
    gs_put (&t, "exact");
  if (r->functions)
    gs_put (&t, "; of functions: differences of order 4");
}

/* on what nothing depends, where it begins and at the end */
static void
find_idle (const gs_best *b, gs_design_result *r)
{
  const gs_point *e = &b->r.e;
  for (int j = 0; j < b->q.n; j++)
    r->idle[b->q.at[j]] = b->q.idle[b->q.at[j]] && ! gs_point_moves (e, j);
}

/* ------------------------------------------------------------------------- the report */

static void
put_variables (gs_writer *t, const gs_design *d, const double *values)
{
  for (int i = 0; i < d->nfree; i++)
    {
      const gs_free *v = d->free + i;
      gs_put (t, "  %-20s %16.9g   (", v->name, values[i]);
      if (! v->nlist)
        gs_put (t, "%g to %g", v->low, v->high);
      for (int k = 0; k < v->nlist; k++)
        gs_put (t, "%s%g", k ? ", " : "one of ", v->list[k]);
      gs_put (t, ")\n");
    }
}

static int
report (gs_search_design *w, gs_design_result *r)
{
  const gs_design *d = w->d;
  size_t size = sizeof r->ended + sizeof r->derivatives + 1000
                + (size_t)r->nactive * (sizeof *r->active + 60);
  for (int i = 0; i < d->nfree; i++)
    size += 120 + strlen (d->free[i].name) + 20 * (size_t)d->free[i].nlist;
  gs_writer t = { gs_room_take (&w->room, (ptrdiff_t)size, 1), (int)size, 0 };
  if (! t.text)
    return 1;
  r->report = t.text;
  gs_put (&t, "%s: goal %.9g, %s\n", d->name, r->J, r->ended);
  put_variables (&t, d, r->values);
  for (int k = 0; k < r->nactive; k++)
    gs_put (&t, "  active: %s, multiplier %.6g\n", r->active[k].text, r->active[k].multiplier);
  gs_put (&t, "  %d evaluations, %s; derivatives: %s\n", r->evaluations, solvers[r->solver],
          r->derivatives);
  if (r->branched)
    gs_put (&t, "  choices: branch and bound, %d problems solved for %.0f combinations\n",
            r->problems, r->combinations);
  else if (r->nends > 1)
    gs_put (&t, "  best of %d ends (%g starts, %.0f combinations)\n", r->nends,
            r->nends / r->combinations, r->combinations);
  return 0;
}

/* ------------------------------------------------------------------------- all of it */

static int
take_arrays (gs_search_design *w, const gs_best *b, gs_design_result *r)
{
  const int n = w->d->nfree;
  r->values = gs_room_numbers (&w->room, n);
  r->rough = gs_room_places (&w->room, n);
  r->idle = gs_room_places (&w->room, n);
  r->active = gs_room_take (&w->room, b->nactive, sizeof *r->active);
  if (w->room.full)
    return 1;
  memcpy (r->values, b->p, (size_t)n * sizeof *b->p);
  memcpy (r->rough, b->q.rough, (size_t)n * sizeof *r->rough);
  memcpy (r->active, b->active, (size_t)b->nactive * sizeof *b->active);
  r->nactive = b->nactive;
  return 0;
}

int
gs_tell_design (gs_search_design *w, gs_best *b, gs_design_result *r)
{
  const gs_nlp_end *s = &b->r;
  if (take_arrays (w, b, r))
    return 1;
  r->J = s->e.J;
  r->solved = b->solved;
  r->limit = s->limit;
  r->stopped = s->stopped;
  r->solver = s->solver;
  r->violation = s->violation;
  r->optimality = b->optimality;
  r->iterations = s->iterations;
  r->evaluations = s->evaluations;
  r->functions = b->q.functions;
  r->info = r->solved ? 0 : r->limit ? 1 : 3;
  find_idle (b, r);
  gs_writer t = { r->ended, sizeof r->ended, 0 };
  gs_put (&t, "%s", s->ended);
  if (r->violation > GS_FEASIBLE && ! r->limit && w->d->ndemands > 0)
    {
      if (contradict (w, b, r))
        return 1;
    }
  else if (r->info == 3)
    {
      gs_put (&t, ", what is left of the conditions of an optimum: %.2g (%s)", r->optimality,
              solvers[r->solver]);
      if (s->trouble[0])
        gs_put (&t, "; at some values: %s", s->trouble);
    }
  say_derivatives (w, &b->q, r);
  return report (w, r);
}
