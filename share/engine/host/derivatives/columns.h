/* columns.h: a run with its columns, as the files of this folder share it. */
#ifndef GSMBP_HOST_COLUMNS_H
#define GSMBP_HOST_COLUMNS_H

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/inputs.h"
#include "gsmbp/plan.h"
#include "host/derivatives/derivatives.h"

enum { GS_MOST_TURNS = 1000 };

/* the constants of the run: what the routines of its scene are called with leads to the run */
typedef struct
{
  gs_derivatives *run;
  gs_real numbers[];
} gs_column_constants;

/* outputs of a sampled device that are pending */
typedef struct
{
  int place, from, to; /* in the plan; their range among the held ones */
  double when;         /* when they arrive [s] */
  gs_real *inputs;     /* (nv,nc): derivatives of all inputs with them */
} gs_sent_outputs;

/* the inputs of an event and what its function does along the motion */
typedef struct
{
  gs_real *v;      /* nv, */
  gs_real *f;      /* nx: rates of the states, */
  gs_real *slopes; /* nv: of the inputs */
  gs_real *g;      /* nx+nv+nsp+1: the function by states, inputs, parameters, time */
  gs_real rate;    /* of the function */
  int info, grazes;
} gs_event_before;

/* what an event of the user sets: derivatives of states and inputs after it by states, inputs,
   parameters and time, (nx+nv,nx+nv+nsp+1); states after it where constraints do not move them */
typedef struct
{
  gs_real *r, *xa;
  int info;
} gs_user_change;

/* rows of the constraints at a state: on coordinates, dp*S + pp, and on speeds, hc*S + dv*S + pv */
typedef struct
{
  gs_real *dp, *dv, *hc, *phi, *phit, *gam, *pp, *pv, *qdot;
} gs_loop_rows;

struct gs_derivatives
{
  gs_scene inner, outer; /* the scene, and the one with columns */
  gs_column_constants *constants;
  int nc, nsets, na;     /* columns; sets of Euler parameters; states of devices */
  int *col, *sets;
  int top;               /* coordinates whose rates are the speeds */
  int *ip, *own_ip;      /* the plan of the run; the inputs as they were, null: those of the plan */
  gs_real *rp;
  int has_events, has_samples;
  gs_events events;      /* the parts of the plan */
  gs_samples samples;
  gs_real rtol, *atol;

  int *why, *event;      /* nc: see gs_derivatives_lost */
  double *lost_at;
  gs_real *tau;          /* nc: dtau/dp of the event that is at work */
  int within;            /* of the events of an instant one is done */
  int *changes;          /* nev */
  double *times;         /* (nc,ntimes): dtau/dp of all events */
  int ntimes;
  gs_real *reports;      /* (nc,nev): of events of this instant that only report, */
  int *reported;         /* nev: where there is one */

  double *t1, *t2, *g1, *g2, *most; /* nev: the last two values of each event function and their
                                       times, the greatest value */
  double *turns;         /* (2,nturns) */
  int nturns;

  gs_real *vp;           /* (nv,nc): derivatives of held inputs, */
  gs_real *vt;           /* ... of all inputs at an instant along the motion */
  gs_real *gain;         /* (nv,nx): of the feedback where it was last evaluated */
  gs_real *vx, *vm;      /* what cmp said there: (nv,na), (nv,nsp) */
  int *own;              /* nv: 1 where an input is neither held nor a mode */
  double *switched;      /* nv: when an event of the user first set it; HUGE_VAL: never */
  double *held;          /* (1+nv*nc,nheld) */
  int nheld, room;
  int no_memory;
  gs_real *kp, *yp;      /* (nxk,nc), (ny,nc): derivatives of memory and outputs */
  gs_sent_outputs *sent;
  int nsent;

  /* workspaces: of gs_rates_with_columns and gs_project_columns; of gs_inputs_of_run of the inner
     scene and of the outer one; of input columns; of each file by its name */
  gs_real *w, *w2, *wi, *w3, *change;
  int *iw;
  struct { gs_real *v, *gains, *moves, *wanted, *f, *xi; } slopes;
  gs_event_before before;
  gs_user_change set;
  struct { gs_real *y, *h, *g, *values, *tau, *states, *x, *v, *given, *rates; int *modes; } at;
  struct { gs_real *r, *u, *before, *after; } resets;
  gs_loop_rows rows;
  struct { gs_real *b, *system; int *set, *free, *where, *used; } loops;
  struct { gs_real *a, *b, *c, *d, *p, *ctd, *z, *now; } outputs;
  void *blocks[4];       /* what is freed */
};

/* the run whose constants these are */
static inline gs_derivatives *
gs_columns_of (const gs_real *cst)
{
  const char *at = (const char *)cst - offsetof (gs_column_constants, numbers);
  return ((const gs_column_constants *)(const void *)at)->run;
}

static inline const gs_real *
gs_columns_constants (const gs_derivatives *d)
{
  return d->constants->numbers;
}

/* column k of the states x */
static inline const gs_real *
gs_column (const gs_derivatives *d, const gs_real *x, int k)
{
  return x + d->inner.nx * (k + 1);
}

static inline gs_real *
gs_column_in (const gs_derivatives *d, gs_real *x, int k)
{
  return x + d->inner.nx * (k + 1);
}

/* while the time of an event is looked for the columns do not matter */
static inline int
gs_states_alone (const gs_derivatives *d)
{
  return d->has_events && *d->events.search == 1;
}

/* ------------------------------------------------------------------- columns_rates.c: rhs, prj */
gs_rhs gs_columns_rhs;
gs_prj gs_columns_prj;
/* columns that were given up stay zero */
void gs_columns_drop_lost (const gs_derivatives *d, gs_real *x);
/* are the speeds the rates of the coordinates? */
int gs_columns_plain_speeds (const gs_derivatives *d);
/* the columns of x onto the constraints of a loop */
void gs_columns_onto_loops (gs_derivatives *d, gs_real t, gs_real *x);

/* ------------------------------------------------------------------------ columns_inputs.c: vin */
gs_vin gs_columns_vin;
/* the run asks the columns for its inputs, where these depend on parameters or states */
void gs_columns_take_inputs (gs_derivatives *d);
/* does input i follow plan and feedback, and not its limit? */
int gs_columns_is_free (const gs_derivatives *d, const gs_real *v, int i);
/* derivatives dv (nv) of the inputs v by column k, s (nx) */
void gs_columns_input_changes (const gs_derivatives *d, const gs_real *v, const gs_real *s, int k,
                               gs_real *dv);
/* vp from time t on, for gs_derivatives_held */
void gs_columns_keep_inputs (gs_derivatives *d, double t);

/* ----------------------------------------------------------------------------- columns_slopes.c */
/* rates (nv) of the inputs v along the motion with the rates f (nx) of the states x */
void gs_columns_slopes (gs_derivatives *d, gs_real t, int side, const gs_real *x, const gs_real *v,
                        const gs_real *f, gs_real *rate);

/* ----------------------------------------------------------------------------- columns_resets.c */
/* column k has no derivative from now on; of give_up_moved those whose time of the event moves */
void gs_columns_give_up (gs_derivatives *d, gs_real *x, int k, gs_real t, int event, int why);
void gs_columns_give_up_moved (gs_derivatives *d, gs_real *x, gs_real t, int event, int why);
/* what event k of the user sets, at the state before it */
void gs_columns_change_of (gs_derivatives *d, gs_real t, const gs_real *x, const gs_real *v, int k);
/* ... does it set state i, any state? */
int gs_columns_sets (const gs_derivatives *d, int i);
int gs_columns_sets_states (const gs_derivatives *d);
/* the columns through it: x is the state behind it */
void gs_columns_through_user (gs_derivatives *d, gs_real t, gs_real *x, int k);
/* ... through what ports do at event k, with d->at.x, v, modes before it */
void gs_columns_through_ports (gs_derivatives *d, gs_real t, int k, gs_real *x, const int *mode);

/* ------------------------------------------------------------------------------ columns_loops.c */
/* the columns behind event k of the user that sets states of a closed chain */
void gs_columns_through_loops (gs_derivatives *d, gs_real t, gs_real *x, int k);

/* ----------------------------------------------------------------------------- columns_events.c */
/* inputs v and rates f at a state from one side. info: of the inputs or of rhs */
int gs_columns_rates_at (gs_derivatives *d, gs_real t, const gs_real *x, int side, gs_real *v,
                         gs_real *f);
/* event k at the state x before it: d->before; tau (nc): dtau/dp */
void gs_columns_before (gs_derivatives *d, gs_real t, const gs_real *x, const int *mode, int k,
                        gs_real *tau);
/* another event may just be coming: columns by which its time changes in another way are given
   up */
void gs_columns_give_up_apart (gs_derivatives *d, gs_real t, gs_real *x, const int *mode, int k);

/* ---------------------------------------------------------- columns_instants.c, columns_turns.c */
gs_rst gs_columns_rst;
gs_evt gs_columns_evt;

/* ----------------------------------------------------------------- columns_samples.c: out, ctl */
gs_out gs_columns_out;
gs_ctl gs_columns_ctl;
/* pending outputs that have arrived, the earliest first */
void gs_columns_arrivals (gs_derivatives *d);

#endif
