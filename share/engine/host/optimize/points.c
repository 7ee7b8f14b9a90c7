/* points.c: goal and demands at a point, the memory of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/optimize/optimize_parts.h"

int
gs_point_size (gs_point *e, int n, int m)
{
  const size_t N = (size_t)n, M = (size_t)m, all = N + N * N + M * (N + 5) + 1;
  if (all > e->all)
    {
      free (e->room);
      *e = (gs_point){ .room = malloc (all * sizeof (double)), .all = all };
    }
  if (! e->room)
    {
      *e = (gs_point){ .all = 0 };
      return 1;
    }
  memset (e->room, 0, e->all * sizeof (double));
  e->n = n;
  e->m = m;
  e->J = 0;
  e->gJ = e->room;
  e->h = e->gJ + n;
  e->g = e->h + N * N;
  e->low = e->g + m;
  e->high = e->low + m;
  e->a = e->high + m;
  e->size = e->a + N * M;
  e->row = (int *)(void *)(e->size + m);
  return 0;
}

int
gs_point_copy (gs_point *to, const gs_point *from)
{
  const size_t N = (size_t)from->n, M = (size_t)from->m;
  if (gs_point_size (to, from->n, from->m))
    return 1;
  memcpy (to->room, from->room, (N + N * N + M * (N + 5)) * sizeof (double));
  to->J = from->J;
  to->there = from->there;
  return 0;
}

void
gs_point_free (gs_point *e)
{
  free (e->room);
  *e = (gs_point){ .all = 0 };
}

double
gs_point_steepest (const gs_point *e, int i)
{
  double most = 0;
  for (int j = 0; j < e->n; j++)
    most = fmax (most, fabs (e->a[i + e->m * j]));
  return most;
}

/* By its bound; by derivatives alone no number is judged that has a bound to be judged by: they are
 * infinite at dead centres. They only keep sizes above rounding. */
void
gs_point_sizes (const gs_point *e, double *sizes)
{
  for (int i = 0; i < e->m; i++)
    {
      const double slope = gs_point_steepest (e, i), size = e->size[i];
      const double most = size > 0 ? fmax (size, 1e-12 * slope) : slope;
      sizes[i] = most < 1e-12 ? 1 : most;
    }
}

double
gs_point_violation (const gs_point *e, const double *sizes)
{
  double most = 0;
  for (int i = 0; i < e->m; i++)
    most = fmax (most, fmax (e->low[i] - e->g[i], e->g[i] - e->high[i]) / sizes[i]);
  return most;
}

int
gs_point_moves (const gs_point *e, int j)
{
  int moves = e->gJ[j] != 0;
  for (int i = 0; i < e->m; i++)
    moves = moves || e->a[i + e->m * j] != 0;
  return moves;
}
