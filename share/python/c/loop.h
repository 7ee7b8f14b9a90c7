/* loop.h: what the loops over states share (render.py makes them of the table). */
#ifndef LOOP_H
#define LOOP_H

#include <stddef.h>

/* n is a constant where this is put in line */
#if defined (__clang__)
#define GS_UNROLL _Pragma ("clang loop unroll_count(16)")
#elif defined (__GNUC__)
#define GS_UNROLL _Pragma ("GCC unroll 16")
#else
#define GS_UNROLL
#endif

/* n numbers that lie e bytes apart: where they are, or side by side in room */
static inline const double *
gs_gather_double (const char *a, ptrdiff_t e, int n, double *room)
{
  if (e == (ptrdiff_t)sizeof (double) || n <= 1)
    return (const double *)a;
  GS_UNROLL
  for (int i = 0; i < n; i++)
    room[i] = *(const double *)(a + e * i);
  return room;
}

static inline const int *
gs_gather_int (const char *a, ptrdiff_t e, int n, int *room)
{
  if (e == (ptrdiff_t)sizeof (int) || n <= 1)
    return (const int *)a;
  GS_UNROLL
  for (int i = 0; i < n; i++)
    room[i] = *(const int *)(a + e * i);
  return room;
}

#endif
