/* solve_design.c: the best end of a problem, from one start or several. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "host/optimize/optimize_parts.h"

const char *
gs_stopped_text (int stopped)
{
  return stopped == GS_TIMED_OUT ? "ended by option timeout" : "interrupted by Ctrl-C";
}

int
gs_search_failed (gs_search_design *w, int values, const char *trouble, const char *when)
{
  if (w->failed)
    return 1;
  if (values == GS_VALUES_FAILED)
    {
      w->failed = GS_DESIGN_FAILED;
      snprintf (w->why, sizeof w->why, "%s", trouble);
      return 1;
    }
  const int late = values == GS_VALUES_LATE || gs_wall_clock () >= w->ends;
  w->failed = GS_DESIGN_STOPPED;
  snprintf (w->why, sizeof w->why, "%s %s",
            gs_stopped_text (late ? GS_TIMED_OUT : GS_INTERRUPTED),
            when ? when : "before the first values were there");
  return 1;
}

int
gs_is_end (const gs_best *b)
{
  return b->p != NULL;
}

int
gs_better (const gs_best *a, const gs_best *b)
{
  if (! gs_is_end (b))
    return 1;
  const int fa = a->r.violation <= GS_FEASIBLE, fb = b->r.violation <= GS_FEASIBLE;
  return (fa && ! fb)
         || (fa == fb
             && (fa ? a->r.e.J < b->r.e.J : a->r.violation < b->r.violation));
}

void
gs_best_free (gs_best *b)
{
  gs_point_free (&b->r.e);
  gs_room_free (&b->room);
  *b = (gs_best){ .p = NULL };
}

/* of choices, where all variables begin: as gs_narrow takes them */
typedef struct
{
  const double *low, *high, *start;
} range;

/* ------------------------------------------------------------------------- one start */

/* each unknown above a peak begins above all its values, which are its size */
static void
place_peaks (const gs_narrowed *q, const gs_point *e, double *z)
{
  for (int s = 0; s < q->npeaks; s++)
    {
      double top = 0;
      const double *a = e->a + e->m * (q->n + s);
      for (int i = 0, first = 1; i < e->m; i++)
        if (a[i] != 0 && e->row[i] < 0)
          {
            const double ahead = -e->g[i] / a[i];
            top = first ? ahead : a[i] < 0 ? fmax (top, ahead) : fmin (top, ahead);
            first = 0;
          }
      q->sizes[s] = fmax (fabs (top), 1e-12);
      z[q->n + s] = top / q->sizes[s];
    }
}

/* the variables on which nothing depends */
static void
find_idle (gs_narrowed *q, const gs_point *e)
{
  for (int j = 0; j < q->n; j++)
    q->idle[q->at[j]] = ! gs_point_moves (e, j);
}

/* on which something must depend */
static int
refuse_idle (const gs_narrowed *q)
{
  gs_search_design *w = q->w;
  for (int i = 0; i < w->d->nfree; i++)
    if (q->idle[i] && w->d->free[i].own)
      {
        w->failed = GS_DESIGN_REFUSED;
        snprintf (w->why, sizeof w->why,
                  "nothing depends on %s at the start (no parameter of %s has that name)",
                  w->d->free[i].name, w->d->name);
        return 1;
      }
  return 0;
}

/* settling needs times and a first value, beside which its band is */
static int
refuse_settling (const gs_narrowed *q)
{
  gs_search_design *w = q->w;
  const gs_design *d = w->d;
  const gs_series *s = w->v.series;
  for (int i = 0; i < d->ngoal + d->ndemands; i++)
    for (int k = 0; k < gs_series_of (d->rows + i); k++, s++)
      {
        if (d->rows[i].word != GS_WORD_settling
            || (s->n > 1 && fabs (s->y[0]) > 1e-12 * gs_largest (s->n, s->y)))
          continue;
        w->failed = GS_DESIGN_REFUSED;
        snprintf (w->why, sizeof w->why,
                  s->n > 1 ? "%s: its band is a share of the first value: expected one other than "
                             "0 (\"error.q\" beside a target), found 0"
                           : "%s: expected a case of several times, found one",
                  d->rows[i].text);
        return 1;
      }
  return 0;
}

static int
all_squares (const gs_design *d)
{
  for (int i = 0; i < d->ngoal; i++)
    if (d->rows[i].word != GS_WORD_square || d->rows[i].factor <= 0)
      return 0;
  return d->ngoal > 0 && d->ndemands == 0;
}

/* what misses of demands with a bound of 0 count beside: their values and derivatives where the
 * search began */
static void
keep_naturals (gs_search_design *w, const gs_point *e)
{
  if (w->began)
    return;
  w->began = 1;
  for (int i = 0; i < e->m; i++)
    if (e->row[i] >= 0 && e->size[i] == 0)
      w->naturals[e->row[i]] = fmax (w->naturals[e->row[i]],
                                     fmax (fabs (e->g[i]), gs_point_steepest (e, i)));
  for (int k = 0; k < w->d->ndemands; k++)
    if (w->naturals[k] < 1e-12)
      w->naturals[k] = 0;
}

/* z: n + npeaks unknowns, the peaks placed; 0 or what there is instead of values */
static int
set_up (gs_narrowed *q, double *z, char *trouble)
{
  gs_point e = { .all = 0 };
  for (int s = 0; s < q->npeaks; s++)
    {
      q->sizes[s] = 1;
      z[q->n + s] = 0;
    }
  const int found = gs_assess (q, z, &e, trouble);
  if (found == GS_VALUES_FOUND)
    {
      find_idle (q, &e);
      keep_naturals (q->w, &e);
      place_peaks (q, &e, z);
    }
  gs_point_free (&e);
  return found;
}

/* the values there, as an end: nothing is free, or no solver gets further */
static int
only_values (gs_best *b, const double *z, gs_room *room)
{
  const int n = b->q.n + b->q.npeaks;
  gs_narrowed *q = &b->q;
  gs_nlp_end *r = &b->r;
  int chosen = 0;
  for (int i = 0; i < q->w->d->nfree; i++)
    chosen += q->w->d->free[i].nlist > 0;
  *r = (gs_nlp_end){ .iterations = 0, .evaluations = 1, .size_J = 1,
                     .z = gs_room_numbers (room, n + 1) };
  if (! r->z)
    return gs_search_full (q->w);
  memcpy (r->z, z, (size_t)n * sizeof *z);
  const int found = gs_assess (q, z, &r->e, r->trouble);
  if (found != GS_VALUES_FOUND)
    return found;
  r->size_g = gs_room_numbers (room, r->e.m);
  if (! r->size_g)
    return gs_search_full (q->w);
  gs_point_sizes (&r->e, r->size_g);
  r->violation = gs_point_violation (&r->e, r->size_g);
  snprintf (r->ended, sizeof r->ended, "%s",
            n        ? "the demands are met there"
            : chosen ? "all is chosen from lists"
                     : "nothing is free");
  return found;
}

static int
solver_of (const gs_search_design *w, int solver, int newton)
{
  if (solver != GS_SOLVER_auto)
    return solver;
  return newton || ! w->o->nlopt ? GS_SOLVER_ipopt : GS_SOLVER_slsqp;
}

/* from the unknowns z to an end, or stay: there; 1: there is none, w->failed says why */
static int
one (gs_best *b, double *z, int solver, int stay)
{
  gs_narrowed *q = &b->q;
  gs_search_design *w = q->w;
  const int n = q->n + q->npeaks, newton = all_squares (w->d);
  char trouble[800] = "";
  int found = set_up (q, z, trouble);
  if (found != GS_VALUES_FOUND)
    return gs_search_failed (w, found, trouble, NULL);
  if (refuse_idle (q) || refuse_settling (q))
    return 1;
  const gs_small_program p = { n, newton, z, q->low, q->high, q, gs_assess };
  solver = solver_of (w, solver, newton);
  found = n && ! stay ? gs_solve_small (w, &p, solver, w->o, &b->room, &b->r)
                      : only_values (b, z, &b->room);
  b->r.solver = solver;
  b->p = gs_room_numbers (&b->room, w->d->nfree);
  if (found != GS_VALUES_FOUND || ! b->p)
    return gs_search_failed (w, found, b->r.trouble, NULL);
  memcpy (b->p, q->p, (size_t)w->d->nfree * sizeof *b->p);
  for (int j = 0; j < q->n; j++)
    b->p[q->at[j]] = b->r.z[j] * q->scale[j];
  w->room.full |= gs_price (b, q->low, q->high);
  b->solved = b->r.violation <= GS_FEASIBLE && ! b->r.limit
              && (b->optimality <= 1e-4 || w->d->ngoal == 0);
  return 0;
}

/* the unknowns of start k: the problem's own, then others, within its bounds */
static void
start_values (const gs_narrowed *q, int k, double *z)
{
  const int n = q->w->d->nfree;
  for (int j = 0; j < q->n; j++)
    z[j] = k == 0 ? q->start[j]
                  : gs_within (q->w->o->starts[n * (k - 1) + q->at[j]] / q->scale[j], q->low[j],
                               q->high[j]);
}

/* An end that misses demands which can be met is one from where they are, or there. 1: stopped */
static int
meet (gs_best *b, const range *of, int k, int solver)
{
  gs_search_design *w = b->q.w;
  if (b->r.violation <= GS_FEASIBLE || b->r.limit || w->d->ndemands == 0 || b->q.n == 0)
    return 0;
  int bad = 0, met = 1;
  for (int stay = 0; stay < 2 && met && ! bad && b->r.violation > GS_FEASIBLE; stay++)
    {
      gs_best there = { .p = NULL };
      bad = gs_narrow (w, of->low, of->high, of->start, &there.room, &there.q);
      double *z = bad ? NULL : gs_room_numbers (&there.room, there.q.n + there.q.npeaks);
      gs_narrowed search;
      bad = ! z || gs_narrow (w, of->low, of->high, of->start, &there.room, &search);
      if (! bad)
        {
          start_values (&there.q, k, z);
          bad = gs_meet_demands (&search, z, &met);
        }
      if (! bad && met && ! one (&there, z, solver, stay) && gs_better (&there, b))
        {
          const gs_best old = *b;
          there.r.evaluations += old.r.evaluations;
          *b = there;
          there = old;
        }
      gs_best_free (&there);
    }
  bad = w->failed == GS_DESIGN_STOPPED || w->room.full;
  w->failed = bad ? w->failed : 0;
  return bad;
}

/* ------------------------------------------------------------------------- several starts */

void
gs_add_end (gs_search_design *w, gs_design_result *r, const double *p, const gs_best *b)
{
  gs_design_end *all = realloc (r->ends, ((size_t)r->nends + 1) * sizeof *all);
  const int n = w->d->nfree;
  double *values = gs_room_numbers (&w->room, n);
  if (all)
    r->ends = all;
  if (! all || ! values)
    {
      gs_search_full (w);
      return;
    }
  gs_design_end *e = all + r->nends++;
  *e = (gs_design_end){ .values = values, .J = NAN, .violation = NAN };
  memcpy (values, p, (size_t)n * sizeof *p);
  if (! b)
    {
      snprintf (e->ended, sizeof e->ended, "no start: %.380s", w->why);
      return;
    }
  e->J = b->r.e.J;
  e->violation = b->r.violation;
  e->solved = b->solved;
  snprintf (e->ended, sizeof e->ended, "%s", b->r.ended);
}

static void
cut_short (gs_best *b, int stopped)
{
  b->r.stopped = stopped;
  snprintf (b->r.ended, sizeof b->r.ended, "%s", gs_stopped_text (stopped));
  b->r.limit = 1;
  b->solved = 0;
}

/* what becomes of start k; 1: it is the last one */
static int
take_start (gs_search_design *w, gs_best *here, int bad, int k, gs_best *best, gs_design_result *r)
{
  if (bad && w->failed == GS_DESIGN_STOPPED && gs_is_end (best))
    {
      cut_short (best, gs_wall_clock () >= w->ends ? GS_TIMED_OUT : GS_INTERRUPTED);
      w->failed = 0;
      return 1;
    }
  if (bad && (k == 0 || w->failed == GS_DESIGN_STOPPED))
    return 1;
  if (bad)
    {
      gs_add_end (w, r, here->q.p, NULL);
      w->failed = 0;
      return 0;
    }
  gs_add_end (w, r, here->p, here);
  const int stopped = here->r.stopped;
  if (gs_better (here, best))
    {
      const gs_best old = *best;
      *best = *here;
      *here = old;
    }
  if (stopped)
    cut_short (best, stopped);
  return stopped != 0;
}

int
gs_solve_design (gs_search_design *w, const double *low, const double *high, const double *start,
                 int solver, gs_best *best, gs_design_result *r, int told)
{
  const int before = r->nends;
  const range of = { low, high, start };
  *best = (gs_best){ .p = NULL };
  w->failed = 0;
  for (int k = 0; k <= w->o->nstarts && ! w->room.full; k++)
    {
      gs_best here = { .p = NULL };
      if (k > 0 && gs_wall_clock () >= w->ends)
        {
          cut_short (best, GS_TIMED_OUT);
          break;
        }
      int bad = gs_narrow (w, low, high, start, &here.room, &here.q);
      double *z = bad ? NULL : gs_room_numbers (&here.room, here.q.n + here.q.npeaks);
      if (! z)
        break;
      start_values (&here.q, k, z);
      bad = one (&here, z, solver, 0) || meet (&here, &of, k, solver);
      const int last = take_start (w, &here, bad, k, best, r);
      gs_best_free (&here);
      if (last)
        break;
    }
  if (! told)
    r->nends = before;
  return w->room.full || ! gs_is_end (best);
}
