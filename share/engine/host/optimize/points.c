/* points.c: goal and demands at a point, the memory of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "host/optimize/optimize_parts.h"

int
gs_point_size (gs_point *e, int n, int m)
{
  const size_t N = (size_t)n, M = (size_t)m, size = N + N * N + M * (N + 4) + 1;
  if (size > e->size)
    {
      free (e->room);
      *e = (gs_point){ .room = malloc (size * sizeof (double)), .size = size };
    }
  if (! e->room)
    {
      *e = (gs_point){ .size = 0 };
      return 1;
    }
  memset (e->room, 0, e->size * sizeof (double));
  e->n = n;
  e->m = m;
  e->J = 0;
  e->gJ = e->room;
  e->h = e->gJ + n;
  e->g = e->h + N * N;
  e->low = e->g + m;
  e->high = e->low + m;
  e->a = e->high + m;
  e->row = (int *)(void *)(e->a + N * M);
  return 0;
}

int
gs_point_copy (gs_point *to, const gs_point *from)
{
  const size_t N = (size_t)from->n, M = (size_t)from->m;
  if (gs_point_size (to, from->n, from->m))
    return 1;
  memcpy (to->room, from->room, (N + N * N + M * (N + 4)) * sizeof (double));
  to->J = from->J;
  to->there = from->there;
  return 0;
}

void
gs_point_free (gs_point *e)
{
  free (e->room);
  *e = (gs_point){ .size = 0 };
}

static double
finite (double x)
{
  return fabs (x) < INFINITY ? fabs (x) : 0;
}

void
gs_point_sizes (const gs_point *e, double *sizes)
{
  for (int i = 0; i < e->m; i++)
    {
      double most = fmax (finite (e->low[i]), finite (e->high[i]));
      for (int j = 0; j < e->n; j++)
        most = fmax (most, fabs (e->a[i + e->m * j]));
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
