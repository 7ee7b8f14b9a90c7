/* loop.h: what the loops over states share (render.py makes them of the table). */
#ifndef LOOP_H
#define LOOP_H

/* n numbers that lie e bytes apart: where they are, or side by side in room */
static inline const double *
gs_gather_double (const char *a, long e, int n, double *room)
{
  if (e == (long)sizeof (double) || n <= 1)
    return (const double *)a;
  for (int i = 0; i < n; i++)
    room[i] = *(const double *)(a + e * i);
  return room;
}

static inline const int *
gs_gather_int (const char *a, long e, int n, int *room)
{
  if (e == (long)sizeof (int) || n <= 1)
    return (const int *)a;
  for (int i = 0; i < n; i++)
    room[i] = *(const int *)(a + e * i);
  return room;
}

#endif
