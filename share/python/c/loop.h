/* loop.h: what the loops over states share (render.py makes them of the table). */
#ifndef GS_LOOP_H
#define GS_LOOP_H

#include <stddef.h>

/* so many states at once are brought side by side where their numbers lie apart */
enum { GS_TILE = 16 };

/* n numbers of each of m states, e bytes apart, the states *s bytes: where they are, or state by
 * state in room; *s becomes the distance of the states there */
static inline const char *
gs_tile_double (const char *a, ptrdiff_t e, ptrdiff_t *s, int n, int m, double *room)
{
  if (e == (ptrdiff_t)sizeof (double) || n <= 1)
    return a;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++)
      room[n * j + i] = *(const double *)(a + e * i + *s * j);
  *s = n * (ptrdiff_t)sizeof (double);
  return (const char *)room;
}

static inline const char *
gs_tile_int (const char *a, ptrdiff_t e, ptrdiff_t *s, int n, int m, int *room)
{
  if (e == (ptrdiff_t)sizeof (int) || n <= 1)
    return a;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++)
      room[n * j + i] = *(const int *)(a + e * i + *s * j);
  *s = n * (ptrdiff_t)sizeof (int);
  return (const char *)room;
}

#endif
