/* planned_parts.h: a planned motion on its way. */
#ifndef GSMBP_HOST_PLANNED_PARTS_H
#define GSMBP_HOST_PLANNED_PARTS_H

#include "host/planned.h"

/* where the motion was followed to: qj (nu,1+order), and what gs_follow_motion keeps */
typedef struct
{
  gs_real *qj, *kept;
} gs_planned_place;

typedef struct
{
  const gs_description *d;
  const gs_planned_asked *a;
  int closed;
  gs_planned_place place, inner; /* at the times asked for; between them, for internal states */
  gs_real *close, *v, *xid;      /* room */
  char *text;
  int size;
} gs_plan_way;

/* place goes on to t; 0: it cannot, text says why */
int gs_planned_to (gs_plan_way *w, gs_planned_place *place, gs_real t, int side);

/* states of the devices from one time to the other; 0, 1: no memory, 3: text says why not */
int gs_carry_states (gs_plan_way *w, gs_real from, gs_real to, gs_real *devices);

#endif
