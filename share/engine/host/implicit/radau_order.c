/* The order of elimination of radau_solve.h: pivots on the diagonal, each time the one whose row
   and column are shortest (Markowitz), as long as lists cost less than what is left as a dense
   matrix. */
#include <string.h>
#include "radau_solve.h"
#include "allocate.h"

int
gsmbp_new_order (radau_order *o, int n)
{
  memset (o, 0, sizeof *o);
  o->n = n;
  const ptrdiff_t places = (ptrdiff_t) n * n;
  o->order = gs_allocate (3 * n + 2 + 2 * places, sizeof (int));
  o->places = gs_allocate (places + 1, 1);
  if (! o->order || ! o->places)
    return 0;
  o->row_from = o->order + n;
  o->column_from = o->row_from + n + 1;
  o->rows = o->column_from + n + 1;
  o->columns = o->rows + places;
  for (int i = 0; i < n; i++)
    o->order[i] = i;
  return 1;
}

void
gsmbp_free_order (radau_order *o)
{
  free (o->order);
  free (o->places);
}

/* the entries of row and column P among the states that are left, from place K of the order on */
static void
count (const radau_order *o, const char *fill, int k, int p, int *row, int *column)
{
  int n = o->n;
  *row = *column = 0;
  for (int l = k; l < n; l++)
    if (o->order[l] != p)
      {
        *row += fill[p + n * o->order[l]];
        *column += fill[o->order[l] + n * p];
      }
}

/* the next pivot: its place in the order, or -1 where a dense matrix costs less */
static int
next (const radau_order *o, const char *fill, int k)
{
  int left = o->n - k - 1, best = -1;
  long least = (long) left * left / 3;
  for (int l = k; l < o->n; l++)
    {
      int row, column;
      count (o, fill, k, o->order[l], &row, &column);
      if ((long) row * column < least)
        least = (long) row * column, best = l;
    }
  return best;
}

/* the states of row and column of the pivot at place K, as states; what fills in */
static void
eliminate (radau_order *o, char *fill, int k)
{
  int n = o->n, p = o->order[k], r = o->row_from[k], c = o->column_from[k];
  for (int l = k + 1; l < n; l++)
    {
      int i = o->order[l];
      if (fill[i + n * p])
        o->rows[r++] = i;
      if (fill[p + n * i])
        o->columns[c++] = i;
    }
  for (int j = o->column_from[k]; j < c; j++)
    for (int i = o->row_from[k]; i < r; i++)
      fill[o->rows[i] + n * o->columns[j]] = 1;
  o->row_from[k + 1] = r;
  o->column_from[k + 1] = c;
}

/* the lists hold places in the order instead of states */
static void
as_places (radau_order *o)
{
  int *place = gs_allocate (o->n + 1, sizeof (int));
  if (! place)
    {
      o->sparse = 0;
      return;
    }
  for (int l = 0; l < o->n; l++)
    place[o->order[l]] = l;
  for (int l = 0; l < o->row_from[o->sparse]; l++)
    o->rows[l] = place[o->rows[l]];
  for (int l = 0; l < o->column_from[o->sparse]; l++)
    o->columns[l] = place[o->columns[l]];
  free (place);
}

static void
make (radau_order *o)
{
  int n = o->n, best;
  const ptrdiff_t places = (ptrdiff_t) n * n;
  char *fill = o->plain ? NULL : gs_allocate (places + 1, 1);
  for (int i = 0; i < n; i++)
    o->order[i] = i;
  o->sparse = 0;
  if (! fill)
    return;
  for (ptrdiff_t k = 0; k < places; k++)
    fill[k] = o->places[k];
  while (o->sparse < n && (best = next (o, fill, o->sparse)) >= 0)
    {
      int p = o->order[best];
      o->order[best] = o->order[o->sparse];
      o->order[o->sparse] = p;
      eliminate (o, fill, o->sparse++);
    }
  as_places (o);
  free (fill);
}

void
gsmbp_take_order (radau_order *o, const double *J, double *ordered)
{
  int n = o->n, other = o->plain == 1;
  for (ptrdiff_t k = 0; k < (ptrdiff_t) n * n; k++)
    if (J[k] != 0 && ! o->places[k])
      {
        o->places[k] = 1;
        other = 1;
      }
  if (other)
    make (o);
  if (o->plain)
    o->plain = 2;   /* it is in the order already */
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++)
      ordered[i + (ptrdiff_t) n * j] = J[o->order[i] + (ptrdiff_t) n * o->order[j]];
}
