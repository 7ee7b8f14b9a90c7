/* solve_small.c: a small program solved by Ipopt or NLopt, with its last point and its best one
 * kept. */
#include <math.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "gsmbp/refusals.h"
#include "host/optimize/optimize_parts.h"

/* z: of the last point e; at: of the best one, which misses by miss */
typedef struct
{
  gs_search_design *w;
  const gs_small_program *p;
  gs_point e, best;
  double *z, *at, *inside, *sizes, miss, *size_g, size_J;
  int m, count, stopped, has_best;
  char trouble[800];
} memory;

/* As many equations as unknowns or more may depend on each other: they get some room. */
static void
loosen (gs_point *e, double *sizes)
{
  int equations = 0;
  for (int i = 0; i < e->m; i++)
    equations += e->low[i] == e->high[i];
  if (equations < e->n || equations == 0)
    return;
  gs_point_sizes (e, sizes);
  for (int i = 0; i < e->m; i++)
    if (e->low[i] == e->high[i])
      {
        e->low[i] -= 1e-9 * sizes[i];
        e->high[i] += 1e-9 * sizes[i];
      }
}

static int
keep_best (memory *k)
{
  gs_point_sizes (&k->e, k->sizes);
  const double miss = fmax (1e-6, gs_point_violation (&k->e, k->sizes));
  if (k->has_best && ! (miss < k->miss || (miss <= k->miss && k->e.J < k->best.J)))
    return 0;
  k->miss = miss;
  k->has_best = 1;
  memcpy (k->at, k->z, (size_t)k->p->n * sizeof *k->z);
  return gs_point_copy (&k->best, &k->e);
}

/* its last point is that at z; 0: there is none */
static int
move (memory *k, const double *z, int first)
{
  const size_t bytes = (size_t)k->p->n * sizeof *z;
  if (! first && k->count && ! memcmp (k->z, z, bytes))
    return k->e.there;
  k->e.there = 0;
  if (! first && ! k->stopped && gs_wall_clock () > k->w->ends)
    k->stopped = GS_TIMED_OUT;
  if (k->stopped || k->w->room.full)
    return 0;
  memcpy (k->z, z, bytes);
  k->count++;
  const int found = k->p->f (k->p->of, z, &k->e, k->trouble);
  if (found == GS_VALUES_INTERRUPTED || found == GS_VALUES_LATE)
    k->stopped = found == GS_VALUES_LATE ? GS_TIMED_OUT : GS_INTERRUPTED;
  if (found != GS_VALUES_FOUND)
    return k->e.there = 0;
  if (! first && k->e.m != k->m)
    {
      snprintf (k->trouble, sizeof k->trouble,
                "expected %d numbers of goal and demands, as where it began; found %d", k->m,
                k->e.m);
      return k->e.there = 0;
    }
  if (first && ! k->sizes)
    {
      k->m = k->e.m;
      k->sizes = gs_room_numbers (&k->w->room, k->m);
    }
  if (! k->sizes)
    return k->e.there = 0;
  loosen (&k->e, k->sizes);
  k->w->room.full |= keep_best (k);
  return 1;
}

/* what the solvers ask for: evaluate of gs_nlp */
static int
evaluate (void *data, int part, const double *z, double factor, const double *lambda, double *out)
{
  memory *k = data;
  const gs_point *e = &k->e;
  (void)lambda;
  for (int j = 0; j < k->p->n; j++) /* solvers step over bounds by rounding */
    k->inside[j] = gs_within (z[j], k->p->low[j], k->p->high[j]);
  if (! move (k, k->inside, 0))
    return 0;
  switch (part)
    {
    case GS_GOAL:
      out[0] = e->J / k->size_J;
      break;
    case GS_GRADIENT:
      for (int j = 0; j < e->n; j++)
        out[j] = e->gJ[j] / k->size_J;
      break;
    case GS_EQUATIONS:
      for (int i = 0; i < e->m; i++)
        out[i] = e->g[i] / k->size_g[i];
      break;
    case GS_JACOBIAN:
      for (int i = 0; i < e->m * e->n; i++)
        out[i] = e->a[i] / k->size_g[i % e->m];
      break;
    default:
      for (int j = 0, at = 0; j < e->n; j++)
        for (int i = j; i < e->n; i++)
          out[at++] = factor * e->h[i + e->n * j] / k->size_J;
    }
  return 1;
}

/* does somebody end it? */
static int
ended (void *data)
{
  memory *k = data;
  return k->stopped != 0 || k->w->room.full;
}

/* all entries of the Jacobian, by columns; of the Hessian its lower triangle */
static void
put_places (gs_room *room, gs_nlp *p)
{
  const int n = p->n, m = p->m, entries = n * m + n * (n + 1);
  int *rows = gs_room_places (room, entries), *columns = gs_room_places (room, entries);
  if (! rows || ! columns)
    return;
  int at = 0;
  for (; at < n * m; at++)
    {
      rows[at] = at % m;
      columns[at] = at / m;
    }
  p->jac_rows = rows;
  p->jac_columns = columns;
  p->hess_rows = rows + at;
  p->hess_columns = columns + at;
  for (int j = 0; j < n; j++)
    for (int i = j; i < n; i++, at++)
      {
        rows[at] = i;
        columns[at] = j;
      }
}

static double
clipped (double x)
{
  return gs_within (x, -2e19, 2e19);
}

/* the program as the solvers take it, beside the sizes at its start */
static void
put_program (memory *k, gs_room *room, gs_nlp *p)
{
  const int n = k->p->n, m = k->m;
  double *low = gs_room_numbers (room, 2 * n), *glow = gs_room_numbers (room, 2 * m);
  *p = (gs_nlp){ .n = n, .m = m, .x0 = k->p->z0, .low = low, .high = low + n, .glow = glow,
                 .ghigh = glow + m, .jacobian = n * m,
                 .hessian = k->p->newton ? n * (n + 1) / 2 : -1, .data = k, .evaluate = evaluate };
  for (int j = 0; low && j < n; j++)
    {
      low[j] = clipped (k->p->low[j]);
      low[n + j] = clipped (k->p->high[j]);
    }
  for (int i = 0; glow && i < m; i++)
    {
      glow[i] = clipped (k->e.low[i] / k->size_g[i]);
      glow[m + i] = clipped (k->e.high[i] / k->size_g[i]);
    }
  put_places (room, p);
}

static int
has_equations (const gs_nlp *p)
{
  for (int i = 0; i < p->m; i++)
    if (p->glow[i] == p->ghigh[i])
      return 1;
  return 0;
}

/* what the solvers are asked for; 1: they are not there, or cannot */
static int
run_solver (memory *k, int solver, const gs_design_options *o, gs_room *room, gs_nlp_result *r)
{
  /* the barrier of the bounds stays below what flat sums of squares tell */
  static const gs_nlp_word flat[] = { { "mu_init", NULL, 1e-8, 0 }, { "bound_push", NULL, 1e-8, 0 },
                                      { "bound_frac", NULL, 1e-8, 0 } };
  static const char *const algorithms[] = { "", "slsqp", "mma", "cobyla", "" };
  const gs_nlp_word algorithm = { "algorithm", algorithms[solver], 0, 0 };
  const int by_ipopt = solver == GS_SOLVER_ipopt;
  gs_search_design *w = k->w;
  gs_nlp p;
  const gs_nlp_options options
      = { o->tolerance, o->evaluations, fmax (1e-3, fmin (o->seconds, w->ends - gs_wall_clock ())),
          o->iterations, by_ipopt ? (k->p->newton ? 3 : 0) : 1, by_ipopt ? flat : &algorithm, ended,
          k };
  put_program (k, room, &p);
  if (room->full)
    return w->room.full = 1;
  if (solver == GS_SOLVER_mma && has_equations (&p))
    {
      w->failed = GS_DESIGN_REFUSED;
      snprintf (w->why, sizeof w->why, "option solver: mma takes no equations (relation \"=\"); "
                                       "expected slsqp, cobyla or ipopt");
      return 1;
    }
  const int bad = (by_ipopt ? o->ipopt : o->nlopt) (&p, &options, r);
  if (bad == 1)
    return w->room.full = 1;
  if (bad)
    {
      w->failed = GS_DESIGN_REFUSED;
      snprintf (w->why, sizeof w->why, "%s", r->ended);
    }
  return bad;
}

/* the end of a solver, as it is, or the best point where it was ended */
static int
take_end (memory *k, gs_nlp_result *s, gs_nlp_end *r)
{
  for (int j = 0; j < k->p->n; j++)
    r->z[j] = gs_within (s->x[j], k->p->low[j], k->p->high[j]);
  const int late = s->limit && gs_wall_clock () >= k->w->ends;
  r->limit = s->limit;
  r->iterations = s->iterations;
  snprintf (r->ended, sizeof r->ended, "%s", s->ended);
  const int there = move (k, r->z, 0);
  if (s->interrupted && ! k->stopped)
    k->stopped = GS_INTERRUPTED;
  if (late && ! k->stopped)
    k->stopped = GS_TIMED_OUT;
  r->stopped = k->stopped;
  if (r->stopped)
    {
      snprintf (r->ended, sizeof r->ended, "%s", gs_stopped_text (r->stopped));
      r->limit = 1;
    }
  if (! there || r->stopped)
    {
      memcpy (r->z, k->at, (size_t)k->p->n * sizeof *r->z);
      return gs_point_copy (&r->e, &k->best);
    }
  return gs_point_copy (&r->e, &k->e);
}

static int
solve (memory *k, int solver, const gs_design_options *o, gs_room *room, gs_nlp_end *r)
{
  const int n = k->p->n;
  k->size_J = fmax (fabs (k->e.J), 1e-12);
  k->size_J = fmax (k->size_J, gs_largest (n, k->e.gJ));
  r->size_J = k->size_J;
  r->size_g = k->size_g = gs_room_numbers (room, k->m);
  double *numbers = gs_room_numbers (room, 3 * n + 2 * k->m);
  if (! numbers || ! k->size_g)
    return gs_search_full (k->w);
  gs_point_sizes (&k->e, k->size_g);
  gs_nlp_result s = { .x = numbers, .zl = numbers + n, .zu = numbers + 2 * n,
                      .g = numbers + 3 * n, .lambda = numbers + 3 * n + k->m };
  if (run_solver (k, solver, o, room, &s))
    return GS_VALUES_FAILED;
  k->w->room.full |= take_end (k, &s, r);
  r->evaluations = k->count;
  r->violation = gs_point_violation (&r->e, r->size_g);
  snprintf (r->trouble, sizeof r->trouble, "%s", k->trouble);
  return GS_VALUES_FOUND;
}

int
gs_solve_small (gs_search_design *w, const gs_small_program *p, int solver,
                const gs_design_options *o, gs_room *room, gs_nlp_end *r)
{
  double *numbers = gs_room_numbers (room, 4 * p->n);
  memory k = { .w = w, .p = p, .z = numbers, .at = numbers + p->n,
               .inside = numbers + 3 * p->n };
  *r = (gs_nlp_end){ .n = p->n, .solver = solver, .z = numbers + 2 * p->n };
  int found = GS_VALUES_FAILED;
  if (! numbers)
    return gs_search_full (w);
  if (solver == GS_SOLVER_ipopt ? ! o->ipopt : ! o->nlopt)
    {
      w->failed = GS_DESIGN_REFUSED;
      snprintf (w->why, sizeof w->why, "%s",
                solver == GS_SOLVER_ipopt ? gs_refusals.no_ipopt : gs_refusals.no_nlopt);
      return found;
    }
  if (move (&k, p->z0, 1))
    found = solve (&k, solver, o, room, r);
  else
    gs_search_failed (w, k.stopped ? GS_VALUES_INTERRUPTED : GS_VALUES_FAILED, k.trouble,
                      NULL);
  gs_point_free (&k.e);
  gs_point_free (&k.best);
  return found;
}
