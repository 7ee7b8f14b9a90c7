/* conflict.c: of demands that cannot be met a least set that contradict each other: without any one
 * of them the others can be met. */
#include <math.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "host/optimize/optimize_parts.h"

static const double missed = 1e-7; /* beside sizes: a sum above it is no rounding */

/* some demands, each loosened by an unknown beside its size */
typedef struct
{
  gs_narrowed *q;
  gs_point e;
  int m; /* its numbers */
  double *sizes;
} elastic;

/* the cases that the demands read, as rows */
static void
choose (gs_narrowed *q, const int *demands, int many)
{
  const gs_design *d = q->w->d;
  q->goals = q->npeaks = 0;
  q->ndemands = many;
  for (int k = 0; k < d->ngoal + d->ndemands; k++)
    q->rows[k] = 0;
  for (int k = 0; k < many; k++)
    {
      q->demands[k] = demands[k];
      q->rows[d->ngoal + demands[k]] = 1;
    }
}

/* the sum of what the demands are loosened by, as f of a gs_small_program; each number that has a
 * bound above comes first, then those that have one below */
static int
loosened (void *of, const double *z, gs_point *e, char *trouble)
{
  elastic *x = of;
  gs_point *a = &x->e;
  const int n = x->q->n, ns = x->q->ndemands;
  const int found = gs_assess (x->q, z, a, trouble);
  int m = 0;
  if (found != GS_VALUES_FOUND)
    return found;
  for (int i = 0; i < a->m; i++)
    m += (a->high[i] < INFINITY) + (a->low[i] > -INFINITY);
  if (gs_point_size (e, n + ns, m))
    {
      gs_search_full (x->q->w);
      return GS_VALUES_FAILED;
    }
  for (int s = 0; s < ns; s++)
    {
      e->J += z[n + s];
      e->gJ[n + s] = 1;
    }
  for (int up = 1, at = 0; up >= 0; up--)
    for (int i = 0; i < a->m; i++)
      {
        if (! (up ? a->high[i] < INFINITY : a->low[i] > -INFINITY))
          continue;
        const double by = (up ? -1 : 1) * x->sizes[i];
        e->size[at] = x->sizes[i];
        e->g[at] = a->g[i] + by * z[n + a->row[i]];
        for (int j = 0; j < n; j++)
          e->a[at + m * j] = a->a[i + a->m * j];
        e->a[at + m * (n + a->row[i])] = by;
        e->low[at] = up ? -INFINITY : a->low[i];
        e->high[at++] = up ? a->high[i] : INFINITY;
      }
  e->there = 1;
  return found;
}

static double
sum_of (int n, const double *x)
{
  double sum = 0;
  for (int i = 0; i < n; i++)
    sum += x[i];
  return sum;
}

/* by how much each demand is missed; the sum */
static double
miss (const elastic *x, double *s)
{
  const gs_point *a = &x->e;
  for (int k = 0; k < x->q->ndemands; k++)
    s[k] = 0;
  for (int i = 0; i < a->m; i++)
    s[a->row[i]] = fmax (s[a->row[i]],
                         fmax (a->low[i] - a->g[i], a->g[i] - a->high[i]) / x->sizes[i]);
  return sum_of (x->q->ndemands, s);
}

/* one solver from z; the point that is better takes its place */
static int
relax_by (elastic *x, int solver, double *z, double *best, gs_room *room)
{
  gs_narrowed *q = x->q;
  const int n = q->n, ns = q->ndemands, all = n + ns;
  gs_design_options o = *q->w->o;
  double *begin = gs_room_numbers (room, 3 * all), *low = begin + all, *high = low + all;
  double *here = gs_room_numbers (room, ns);
  char trouble[800] = "";
  gs_nlp_end r;
  if (! begin || ! here)
    return gs_search_full (q->w);
  o.evaluations = fmin (o.evaluations, 300);
  o.tolerance = 1e-8;
  for (int j = 0; j < all; j++)
    {
      begin[j] = j < n ? z[j] : 1.01 * best[j - n] + 1e-3;
      low[j] = j < n ? q->low[j] : 0;
      high[j] = j < n ? q->high[j] : INFINITY;
    }
  const gs_small_program p = { all, 0, begin, low, high, x, loosened };
  int found = gs_solve_small (q->w, &p, solver, &o, room, &r);
  if (found == GS_VALUES_FOUND && r.stopped)
    {
      gs_search_failed (q->w, r.stopped == GS_TIMED_OUT ? GS_VALUES_LATE : GS_VALUES_INTERRUPTED,
                        "",
                        "while it was looked for the least set of demands that contradict each "
                        "other");
      found = GS_VALUES_FAILED;
    }
  if (found == GS_VALUES_FOUND)
    {
      found = gs_assess (q, r.z, &x->e, trouble);
      if (found != GS_VALUES_FOUND)
        gs_search_failed (q->w, found, trouble, NULL);
    }
  if (found == GS_VALUES_FOUND && miss (x, here) < sum_of (ns, best))
    {
      memcpy (best, here, (size_t)ns * sizeof *best);
      memcpy (z, r.z, (size_t)n * sizeof *z);
    }
  gs_point_free (&r.e);
  return found;
}

/* one solver after the other, from z on */
static int
relax_from (elastic *x, double *z, double *best, gs_room *room)
{
  static const int solvers[] = { GS_SOLVER_ipopt, GS_SOLVER_slsqp };
  const gs_design_options *o = x->q->w->o;
  int found = GS_VALUES_FOUND;
  for (int k = 0; k < 2 && found == GS_VALUES_FOUND && sum_of (x->q->ndemands, best) > missed; k++)
    if (k == 0 ? o->ipopt != NULL : o->nlopt != NULL)
      found = relax_by (x, solvers[k], z, best, room);
  return found;
}

/* number k of a sequence that fills 0 to 1 evenly, one for each prime (van der Corput, Halton) */
static double
spread (int k, int prime)
{
  double part = 1, sum = 0;
  for (; k > 0; k /= prime)
    sum += (part /= prime) * (k % prime);
  return sum;
}

/* z: of places all over the bounds that which misses the demands by least, without derivatives;
 * best: by how much. 0: there is none, where bounds are not finite */
static int
look_around (elastic *x, double *z, double *best, gs_room *room)
{
  static const int primes[] = { 2, 3, 5, 7, 11, 13 };
  gs_narrowed *q = x->q;
  const int n = q->n, ns = q->ndemands, all = q->w->d->nfree;
  double *here = gs_room_numbers (room, n + ns), least = INFINITY;
  int *free = gs_room_places (room, all), *kept = q->free;
  if (n == 0 || n > 6 || ! here || ! free)
    return 0;
  for (int j = 0; j < n; j++)
    if (! isfinite (q->high[j] - q->low[j]))
      return 0;
  q->free = free;
  for (int k = 1; k <= 16 * n && gs_wall_clock () < q->w->ends; k++)
    {
      char trouble[800] = "";
      for (int j = 0; j < n; j++)
        here[j] = q->low[j] + (q->high[j] - q->low[j]) * spread (k, primes[j]);
      const int found = gs_assess (q, here, &x->e, trouble);
      if (found == GS_VALUES_INTERRUPTED || found == GS_VALUES_LATE)
        break;
      const int there = found == GS_VALUES_FOUND && x->e.m == x->m;
      const double sum = there ? miss (x, here + n) : INFINITY;
      if (sum < least)
        {
          least = sum;
          memcpy (z, here, (size_t)n * sizeof *z);
          memcpy (best, here + n, (size_t)ns * sizeof *best);
        }
    }
  q->free = kept;
  return least < INFINITY;
}

/* the values z that miss the demands by least: from z on, then from elsewhere; best: by how much
 * each of them */
static int
relax (gs_narrowed *q, const int *demands, int many, double *z, double *best)
{
  gs_room room = { NULL, 0 };
  elastic x = { .q = q };
  char trouble[800] = "";
  choose (q, demands, many);
  int found = gs_assess (q, z, &x.e, trouble);
  double *other = gs_room_numbers (&room, q->n + many);
  if (found != GS_VALUES_FOUND)
    gs_search_failed (q->w, found, trouble, NULL);
  else
    x.sizes = gs_room_numbers (&room, x.e.m);
  if (x.sizes && other)
    {
      double *far = other + q->n;
      x.m = x.e.m;
      gs_point_sizes (&x.e, x.sizes);
      miss (&x, best);
      found = relax_from (&x, z, best, &room);
      if (found == GS_VALUES_FOUND && sum_of (many, best) > missed
          && look_around (&x, other, far, &room))
        {
          found = relax_from (&x, other, far, &room);
          if (sum_of (many, far) < sum_of (many, best))
            {
              memcpy (z, other, (size_t)q->n * sizeof *z);
              memcpy (best, far, (size_t)many * sizeof *best);
            }
        }
    }
  gs_point_free (&x.e);
  gs_room_free (&room);
  return found != GS_VALUES_FOUND || ! x.sizes || ! other;
}

/* is least without demand k a contradiction? then it is left out */
static int
leave_out (gs_narrowed *q, int k, int *least, int *many, double *z, double *best)
{
  gs_room room = { NULL, 0 };
  int *rest = gs_room_places (&room, *many), n = 0;
  double *there = gs_room_numbers (&room, q->n);
  int bad = ! rest || ! there;
  for (int i = 0; ! bad && i < *many; i++)
    if (least[i] != k)
      rest[n++] = least[i];
  if (! bad)
    {
      memcpy (there, z, (size_t)q->n * sizeof *z);
      bad = relax (q, rest, n, there, best);
    }
  if (! bad && gs_largest (n, best) > missed)
    {
      memcpy (least, rest, (size_t)n * sizeof *rest);
      memcpy (z, there, (size_t)q->n * sizeof *z);
      *many = n;
    }
  gs_room_free (&room);
  return bad;
}

int
gs_meet_demands (gs_narrowed *q, double *z, int *met)
{
  const int all = q->w->d->ndemands;
  gs_room room = { NULL, 0 };
  double *best = gs_room_numbers (&room, all), before = INFINITY;
  int *demands = gs_room_places (&room, all), bad = ! best || ! demands;
  *met = 0;
  for (int k = 0; ! bad && k < all; k++)
    demands[k] = k;
  while (! bad && ! *met)
    {
      bad = relax (q, demands, all, z, best);
      const double most = gs_largest (all, best);
      *met = ! bad && most <= missed;
      if (! (most < before / 2))
        break;
      before = most;
    }
  gs_room_free (&room);
  return bad;
}

static void
put_bounds (const gs_narrowed *q, const double *z, gs_writer *t)
{
  for (int j = 0; j < q->n; j++)
    for (int up = 0; up < 2; up++)
      {
        const double bound = up ? q->high[j] : q->low[j];
        if (! isfinite (bound) || ! (fabs (z[j] - bound) <= 1e-6 * fmax (1, fabs (bound))))
          continue;
        gs_put (t, "%s%s %s %g", t->length ? ", " : "", q->w->d->free[q->at[j]].name,
                up ? "<=" : ">=", bound * q->scale[j]);
        break;
      }
}

int
gs_find_conflict (gs_search_design *w, gs_best *b, int *least, double *z, gs_writer *bounds)
{
  gs_narrowed *q = &b->q;
  const int all = w->d->ndemands;
  gs_room room = { NULL, 0 };
  double *best = gs_room_numbers (&room, 2 * all + 1), *first = best + all;
  int many = all, bad = ! best;
  for (int k = 0; k < all; k++)
    least[k] = k;
  for (int j = 0; j < q->n; j++)
    z[j] = q->start[j];
  bad = bad || relax (q, least, all, z, first);
  /* those that can be met by themselves are not among them; then one after the other is left out */
  for (int pass = 0; pass < 2; pass++)
    for (int k = all - 1; k >= 0 && ! bad && many > 1; k--)
      if ((first[k] > missed) == (pass == 1))
        bad = leave_out (q, k, least, &many, z, best);
  if (! bad)
    put_bounds (q, z, bounds);
  gs_room_free (&room);
  return bad ? -1 : many;
}
