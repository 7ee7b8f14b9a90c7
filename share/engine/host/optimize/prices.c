/* prices.c: the bounds and demands that hold an end back, and how much the goal would fall for each
 * unit that they are loosened: multipliers by least squares. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/optimize/optimize_parts.h"

static const double near = 1e-6;

/* one that is active: its normal (n), 1: an equation, 1: of a peak that is a goal */
typedef struct
{
  gs_design_active told;
  double *normal;
  int equation, peak;
} active;

typedef struct
{
  gs_best *b;
  active *all;
  int many, n;
} active_list;

/* ----------------------------------------------------------------------------- least squares */

/* Solves a (n,m) * x = b by least squares in the columns that are in, by Gram and Schmidt twice;
 * columns that depend on others get 0. room: n * m + m * m + 2 * m + n */
static void
least_squares (int n, int m, const double *a, const int *in, const double *b, double *x,
               double *room)
{
  double *q = room, *r = q + n * m, *c = r + m * m, *left = c + m;
  memcpy (left, b, (size_t)n * sizeof *b);
  memset (room, 0, (size_t)(n * m + m * m + m) * sizeof *room);
  for (int j = 0; j < m; j++)
    {
      x[j] = 0;
      if (! in[j])
        continue;
      double *v = q + n * j, length = 0;
      memcpy (v, a + n * j, (size_t)n * sizeof *v);
      for (int k = 0; k < 2 * j; k++)
        {
          const double *u = q + n * (k % j);
          double part = 0;
          for (int i = 0; i < n; i++)
            part += u[i] * v[i];
          for (int i = 0; i < n; i++)
            v[i] -= part * u[i];
          r[k % j + m * j] += part;
        }
      for (int i = 0; i < n; i++)
        length += v[i] * v[i];
      length = sqrt (length);
      r[j + m * j] = length;
      for (int i = 0; i < n; i++)
        v[i] = length > 1e-12 ? v[i] / length : 0;
      for (int i = 0; i < n; i++)
        c[j] += v[i] * left[i];
      for (int i = 0; i < n; i++)
        left[i] -= c[j] * v[i];
    }
  for (int j = m - 1; j >= 0; j--)
    if (in[j] && r[j + m * j] > 1e-12)
      {
        x[j] = c[j];
        for (int k = j + 1; k < m; k++)
          x[j] -= r[j + m * k] * x[k];
        x[j] /= r[j + m * j];
      }
}

/* The column, not in, along which x may grow most, -1: none. left: n */
static int
steepest (int n, int m, const double *a, const double *b, const double *x, const int *in,
          double *left)
{
  double size = 0, most = -INFINITY;
  int at = -1;
  for (int i = 0; i < n; i++)
    {
      size = fmax (size, fabs (b[i]));
      left[i] = b[i];
      for (int k = 0; k < m; k++)
        left[i] -= a[i + n * k] * x[k];
    }
  for (int j = 0; j < m; j++)
    {
      double w = 0;
      for (int i = 0; ! in[j] && i < n; i++)
        w += a[i + n * j] * left[i];
      if (! in[j] && w > most)
        {
          most = w;
          at = j;
        }
    }
  return most > 1e-10 * size ? at : -1;
}

/* from x towards s until a number is 0, which leaves; 0: all stay above it */
static int
step_back (int m, double *x, const double *s, int *in)
{
  double step = 1;
  int bad = 0;
  for (int j = 0; j < m; j++)
    if (in[j] && s[j] <= 0)
      {
        step = bad ? fmin (step, x[j] / (x[j] - s[j])) : x[j] / (x[j] - s[j]);
        bad = 1;
      }
  for (int j = 0; bad && j < m; j++)
    {
      x[j] += step * (s[j] - x[j]);
      in[j] = in[j] && x[j] > 1e-14;
    }
  return bad;
}

/* the least squares solution x >= 0 of a*x = b (Lawson and Hanson 1974). room: n * m + m * m +
 * 3 * m + n */
static void
nonnegative (int n, int m, const double *a, const double *b, double *x, int *in, double *room)
{
  double *s = room + n * m + m * m + 2 * m + n;
  for (int j = 0; j < m; j++)
    {
      x[j] = 0;
      in[j] = 0;
    }
  for (int k = 0; k < 3 * m; k++)
    {
      const int j = steepest (n, m, a, b, x, in, room);
      if (j < 0)
        break;
      in[j] = 1;
      do
        least_squares (n, m, a, in, b, s, room);
      while (step_back (m, x, s, in));
      memcpy (x, s, (size_t)m * sizeof *x);
    }
}

/* ----------------------------------------------------------------------------- what is active */

static active *
add (active_list *l)
{
  active *a = l->all + l->many++;
  a->normal = gs_room_numbers (&l->b->room, l->n);
  return a->normal ? a : NULL;
}

static void
add_bounds (active_list *l, const double *low, const double *high)
{
  const gs_narrowed *q = &l->b->q;
  const double *z = l->b->r.z;
  for (int j = 0; j < q->n; j++)
    for (int up = 0; up < 2; up++)
      {
        const double bound = up ? high[j] : low[j];
        if (! isfinite (bound) || ! (fabs (z[j] - bound) <= near * fmax (1, fabs (bound))))
          continue;
        active *a = add (l);
        if (! a)
          return;
        a->normal[j] = (up ? -1 : 1) * q->scale[j]; /* for each unit of the variable itself */
        a->told.value = z[j] * q->scale[j];
        a->told.bound = bound * q->scale[j];
        snprintf (a->told.text, sizeof a->told.text, "%s %c %g",
                  q->w->d->free[q->at[j]].name, up ? '<' : '>', a->told.bound);
      }
}

/* the demand of number i of a point, null: it is one of a peak that is a goal */
static const gs_design_row *
demand_of (const gs_narrowed *q, const gs_point *e, int i)
{
  const gs_design *d = q->w->d;
  return e->row[i] < 0 ? NULL : d->rows + d->ngoal + q->demands[e->row[i]];
}

static void
add_numbers (active_list *l)
{
  const gs_narrowed *q = &l->b->q;
  const gs_point *e = &l->b->r.e;
  for (int i = 0; i < e->m; i++)
    for (int up = 0; up < 2; up++)
      {
        const gs_design_row *row = demand_of (q, e, i);
        const double bound = up ? e->high[i] : e->low[i];
        /* one that has some room where equations decide all is an equation, too */
        const int equation = e->low[i] == e->high[i] || (row && row->relation == '=');
        if (! (fabs (e->g[i] - bound) <= near * l->b->r.size_g[i]) || (up && equation))
          continue;
        active *a = add (l);
        if (! a)
          return;
        for (int j = 0; j < l->n; j++)
          a->normal[j] = (up ? -1 : 1) * e->a[i + e->m * j];
        a->told.demand = 1;
        a->told.value = e->g[i];
        a->told.bound = row && equation ? row->bound : bound;
        a->equation = equation;
        a->peak = ! row;
        if (row)
          snprintf (a->told.text, sizeof a->told.text, "%s", row->text);
      }
}

/* ----------------------------------------------------------------------------- multipliers */

/* how far unknown j may go: far from where its size was taken, its own size */
static double
reach (const gs_nlp_end *r, int j)
{
  return fmax (1, fabs (r->z[j]));
}

/* by how much the goal changes along its gradient */
static double
steepness (const gs_nlp_end *r, int n)
{
  double most = 0;
  for (int j = 0; j < n; j++)
    most = fmax (most, fabs (r->e.gJ[j]) * reach (r, j));
  return most;
}

static double
size_of_goal (const gs_nlp_end *r, int n)
{
  return fmax (r->size_J, steepness (r, n));
}

/* the gradient as a sum of normals, factors >= 0, of equations any; what is left of it */
static int
price (active_list *l)
{
  const gs_nlp_end *r = &l->b->r;
  const int n = l->n, m = 2 * l->many;
  const size_t N = (size_t)n, M = (size_t)m;
  double *room = calloc (2 * N * M + M * M + 6 * M + 2 * N + 1, sizeof *room);
  int *in = calloc ((size_t)m + 1, sizeof *in);
  if (room && in)
    {
      double *a = room, *x = a + n * m, *work = x + m;
      for (int k = 0; k < l->many; k++)
        {
          const double length = gs_largest (n, l->all[k].normal);
          for (int j = 0; j < n && length > 0; j++)
            {
              a[j + n * k] = l->all[k].normal[j] / length;
              a[j + n * (l->many + k)] = l->all[k].equation ? -a[j + n * k] : 0;
            }
        }
      nonnegative (n, m, a, r->e.gJ, x, in, work);
      double left = 0;
      for (int j = 0; j < n; j++)
        {
          double rest = r->e.gJ[j];
          for (int k = 0; k < m; k++)
            rest -= a[j + n * k] * x[k];
          left = fmax (left, fabs (rest) * reach (r, j));
        }
      l->b->optimality = left / size_of_goal (r, n);
      for (int k = 0; k < l->many; k++)
        {
          const double length = gs_largest (n, l->all[k].normal);
          l->all[k].told.multiplier = (x[k] - x[l->many + k]) / (length > 0 ? length : 1);
        }
    }
  const int bad = ! room || ! in;
  free (room);
  free (in);
  return bad;
}

/* each text once, with the sum of its multipliers; peaks are not told */
static void
tell (active_list *l)
{
  gs_best *b = l->b;
  for (int i = 0; i < l->many; i++)
    {
      const active *a = l->all + i;
      int k = 0;
      while (k < b->nactive && strcmp (b->active[k].text, a->told.text))
        k++;
      if (a->peak)
        continue;
      if (k == b->nactive)
        b->active[b->nactive++] = a->told;
      else
        b->active[k].multiplier += a->told.multiplier;
    }
}

int
gs_price (gs_best *b, const double *low, const double *high)
{
  const int most = 2 * (b->q.n + b->r.e.m), n = b->q.n + b->q.npeaks;
  active_list l = { b, gs_room_take (&b->room, most, sizeof (active)), 0, n };
  b->active = gs_room_take (&b->room, most, sizeof *b->active);
  b->nactive = 0;
  if (! l.all || ! b->active)
    return 1;
  add_bounds (&l, low, high);
  add_numbers (&l);
  int bad = b->room.full;
  if (! l.many || n == 0)
    b->optimality = n ? steepness (&b->r, n) / size_of_goal (&b->r, n) : 0;
  for (int k = 0; k < l.many && n == 0; k++)
    l.all[k].told.multiplier = NAN; /* all is chosen from lists: nothing can give way */
  if (! bad && l.many && n > 0)
    bad = price (&l);
  tell (&l);
  return bad;
}
