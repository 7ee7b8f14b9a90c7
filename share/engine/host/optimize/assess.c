/* assess.c: goal and demands of a design at a point, from what the host finds there. */
#include <math.h>
#include <string.h>

#include "host/optimize/optimize_parts.h"

/* a point that is being filled: the next number, the next unknown above a peak */
typedef struct
{
  const gs_narrowed *q;
  gs_point *e;
  int next, above;
  double *F; /* nfree */
} filling;

/* what numbers of a row (-1: of a peak) lie between; beside which misses count, 0: not known */
typedef struct
{
  double low, high, size;
  int row;
} bounds;

/* is a goal made small by an unknown above (or below) all its values? */
static int
is_above (const gs_design_row *row)
{
  return ((row->word == GS_WORD_peak || row->word == GS_WORD_max) && row->factor > 0)
         || (row->word == GS_WORD_min && row->factor < 0);
}

/* the place of a row among the series */
static int
first_series (const gs_design *d, int row)
{
  int k = 0;
  for (int i = 0; i < row; i++)
    k += gs_series_of (d->rows + i);
  return k;
}

/* what a demand says of a series: does it hold at every time? */
static int
is_each (const gs_design_row *row)
{
  return ! gs_has_cases (row->word) || row->word == GS_WORD_each
         || ((row->word == GS_WORD_peak || row->word == GS_WORD_max) && row->relation == '<')
         || (row->word == GS_WORD_min && row->relation == '>');
}

static bounds
bounds_of (const gs_search_design *w, int demand, int as)
{
  const gs_design_row *row = w->d->rows + w->d->ngoal + demand;
  const double least = row->word == GS_WORD_peak ? -row->bound : -INFINITY;
  return (bounds){ .low = row->relation == '<' ? least : row->bound,
                   .high = row->relation == '>' ? INFINITY : row->bound,
                   .size = row->bound != 0 ? fabs (row->bound) : w->naturals[demand],
                   .row = as };
}

/* ------------------------------------------------------------------------- the host's values */

static int
known (const gs_narrowed *q, const double *p)
{
  const gs_search_design *w = q->w;
  const size_t n = (size_t)w->d->nfree, m = (size_t)(w->d->ngoal + w->d->ndemands);
  return w->there && ! memcmp (p, w->last_p, n * sizeof *p)
         && ! memcmp (q->rows, w->last_rows, m * sizeof (int))
         && ! memcmp (q->free, w->last_free, n * sizeof (int));
}

/* why there is nothing, and at which values */
static void
tell_trouble (const gs_search_design *w, const double *p, char *trouble)
{
  gs_writer t = { trouble, sizeof w->v.trouble, 0 };
  gs_put (&t, "%s", w->v.trouble);
  for (int i = 0; i < w->d->nfree && i < 8; i++)
    gs_put (&t, "%s%s = %.6g", i ? ", " : "; at ", w->d->free[i].name, p[i]);
}

static int
ask (gs_narrowed *q, const double *p, char *trouble)
{
  gs_search_design *w = q->w;
  const gs_design *d = w->d;
  if (known (q, p))
    return GS_VALUES_FOUND;
  w->there = 0;
  memcpy (w->last_p, p, (size_t)d->nfree * sizeof *p);
  memcpy (w->last_rows, q->rows, (size_t)(d->ngoal + d->ndemands) * sizeof (int));
  memcpy (w->last_free, q->free, (size_t)d->nfree * sizeof (int));
  w->v.functions = 0;
  w->v.trouble[0] = '\0';
  for (int k = 0; k < d->nfree; k++)
    w->v.rough[k] = 0;
  const int found = d->evaluate (d->data, p, q->rows, q->free, &w->v);
  w->there = found == GS_VALUES_FOUND;
  q->functions |= w->v.functions;
  for (int k = 0; k < d->nfree; k++)
    q->rough[k] |= w->v.rough[k];
  if (! w->there)
    tell_trouble (w, p, trouble);
  return found;
}

/* ------------------------------------------------------------------------- rows of a point */

static int
sides (int word)
{
  return word == GS_WORD_peak ? 2 : 1;
}

/* how many numbers there are */
static int
count (const gs_narrowed *q)
{
  const gs_design *d = q->w->d;
  const gs_series *s = q->w->v.series;
  int m = 0;
  for (int i = 0; q->goals && i < d->ngoal; i++)
    for (int k = 0; is_above (d->rows + i) && k < d->rows[i].ncases; k++)
      m += sides (d->rows[i].word) * s[first_series (d, i) + k].n;
  for (int i = 0; i < q->ndemands; i++)
    {
      const int at = d->ngoal + q->demands[i], first = first_series (d, at);
      const gs_design_row *row = d->rows + at;
      for (int k = 0; k < gs_series_of (row); k++)
        m += is_each (row) ? s[first + k].n : 1;
    }
  return m;
}

/* side times all numbers of a series */
static void
put_series (filling *f, const gs_series *s, double side, const bounds *b)
{
  gs_point *e = f->e;
  for (int i = 0; i < s->n; i++)
    {
      const int at = f->next + i;
      e->g[at] = side * s->y[i];
      e->low[at] = b->low;
      e->high[at] = b->high;
      e->row[at] = b->row;
      e->size[at] = b->size;
      for (int j = 0; j < f->q->n; j++)
        e->a[at + e->m * j] = side * s->slopes[i + s->n * f->q->at[j]] * f->q->scale[j];
    }
  f->next += s->n;
}

/* one number and its derivatives by all variables */
static void
put_number (filling *f, double value, const bounds *b)
{
  gs_point *e = f->e;
  const int at = f->next++;
  e->g[at] = value;
  e->low[at] = b->low;
  e->high[at] = b->high;
  e->row[at] = b->row;
  e->size[at] = b->size;
  for (int j = 0; j < f->q->n; j++)
    e->a[at + e->m * j] = f->F[f->q->at[j]] * f->q->scale[j];
}

/* the unknown is above all values of a peak (below, where the goal is to make it large) */
static void
put_above (filling *f, const gs_design_row *row, const gs_series *s, const double *z)
{
  gs_point *e = f->e;
  const int unknown = f->q->n + f->above;
  const double size = f->q->sizes[f->above++], of = row->word == GS_WORD_min ? -1 : 1;
  const bounds below = { -INFINITY, 0, size, -1 };
  e->J += row->factor * z[unknown] * size;
  e->gJ[unknown] += row->factor * size;
  for (int k = 0; k < row->ncases; k++)
    for (int side = 0; side < sides (row->word); side++)
      {
        const int from = f->next;
        put_series (f, s + k, side ? -1 : of, &below);
        for (int i = from; i < f->next; i++)
          {
            e->g[i] -= of * z[unknown] * size;
            e->a[i + e->m * unknown] = -of * size;
          }
      }
}

/* the Gauss-Newton matrix of a mean of squares */
static void
add_squares (filling *f, double factor, const gs_series *s, const gs_case_times *c)
{
  const gs_narrowed *q = f->q;
  double T = 0;
  for (int i = 0; i < c->nt; i++)
    T += c->w[i];
  for (int j = 0; j < q->n; j++)
    for (int k = 0; k < q->n; k++)
      {
        double sum = 0;
        for (int i = 0; i < s->n; i++)
          sum += c->w[i] * s->slopes[i + s->n * q->at[j]] * s->slopes[i + s->n * q->at[k]];
        f->e->h[j + f->e->n * k] += factor * 2 * sum / T * q->scale[j] * q->scale[k];
      }
}

static void
measure (filling *f, const gs_design_row *row, int k, const gs_series *s, double *value)
{
  const gs_search_design *w = f->q->w;
  const int at = row->cases[k];
  gs_measure (row->word, s + k, w->v.times + at, w->d->bands[at], w->d->nfree, value, f->F);
}

static void
put_goal (filling *f, const gs_design_row *row, const gs_series *s)
{
  const gs_narrowed *q = f->q;
  for (int k = 0; k < gs_series_of (row); k++)
    {
      double value = s->y[0];
      if (gs_has_cases (row->word))
        measure (f, row, k, s, &value);
      else
        memcpy (f->F, s->slopes, (size_t)q->w->d->nfree * sizeof (double));
      f->e->J += row->factor * value;
      for (int j = 0; j < q->n; j++)
        f->e->gJ[j] += row->factor * f->F[q->at[j]] * q->scale[j];
      if (row->word == GS_WORD_square)
        add_squares (f, row->factor, s + k, q->w->v.times + row->cases[k]);
    }
}

static void
put_demand (filling *f, int number, int as)
{
  const gs_design *d = f->q->w->d;
  const gs_design_row *row = d->rows + d->ngoal + number;
  const gs_series *s = f->q->w->v.series + first_series (d, d->ngoal + number);
  const bounds b = bounds_of (f->q->w, number, as);
  double value = 0;
  for (int k = 0; k < gs_series_of (row); k++)
    if (is_each (row))
      put_series (f, s + k, 1, &b);
    else
      {
        measure (f, row, k, s, &value);
        put_number (f, value, &b);
      }
}

int
gs_assess (void *narrowed, const double *z, gs_point *e, char *trouble)
{
  gs_narrowed *q = narrowed;
  gs_search_design *w = q->w;
  const gs_design *d = w->d;
  filling f = { q, e, 0, 0, q->p + d->nfree };
  for (int j = 0; j < q->n; j++)
    q->p[q->at[j]] = z[j] * q->scale[j];
  const int found = ask (q, q->p, trouble);
  if (found != GS_VALUES_FOUND)
    return found;
  if (gs_point_size (e, q->n + q->npeaks, count (q)))
    {
      w->room.full = 1;
      return GS_VALUES_INTERRUPTED;
    }
  for (int i = 0; q->goals && i < d->ngoal; i++)
    {
      const gs_series *s = w->v.series + first_series (d, i);
      if (is_above (d->rows + i))
        put_above (&f, d->rows + i, s, z);
      else
        put_goal (&f, d->rows + i, s);
    }
  for (int i = 0; i < q->ndemands; i++)
    put_demand (&f, q->demands[i], i);
  e->there = 1;
  return GS_VALUES_FOUND;
}

int
gs_count_peaks (const gs_design *d)
{
  int n = 0;
  for (int i = 0; i < d->ngoal; i++)
    n += is_above (d->rows + i);
  return n;
}
