/* host/collocation/room.h: memory that is freed at once. */
#ifndef GSMBP_HOST_COLLOCATION_ROOM_H
#define GSMBP_HOST_COLLOCATION_ROOM_H

#include <stddef.h>
#include <stdlib.h>

#include "gsmbp/real.h"

typedef struct gs_room_block
{
  struct gs_room_block *before;
  gs_real room[];
} gs_room_block;

/* full: 1 where there was no memory */
typedef struct
{
  gs_room_block *last;
  int full;
} gs_room;

/* room for n things of some bytes each, all 0; null: there is none */
static inline void *
gs_room_take (gs_room *r, ptrdiff_t n, size_t bytes)
{
  gs_room_block *new = r->full ? NULL
                               : (gs_room_block *)calloc (1, sizeof *new
                                                                 + (size_t)(n + 1) * bytes);
  if (! new)
    {
      r->full = 1;
      return NULL;
    }
  new->before = r->last;
  r->last = new;
  return new->room;
}

static inline double *
gs_room_numbers (gs_room *r, ptrdiff_t n)
{
  return (double *)gs_room_take (r, n, sizeof (double));
}
static inline int *
gs_room_places (gs_room *r, ptrdiff_t n)
{
  return (int *)gs_room_take (r, n, sizeof (int));
}
static inline gs_real *
gs_room_reals (gs_room *r, ptrdiff_t n)
{
  return (gs_real *)gs_room_take (r, n, sizeof (gs_real));
}

static inline void
gs_room_free (gs_room *r)
{
  while (r->last)
    {
      gs_room_block *before = r->last->before;
      free (r->last);
      r->last = before;
    }
}
#endif
