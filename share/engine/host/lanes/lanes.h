/* host/lanes/lanes.h: GS_LANES runs of an ensemble at a time, in double precision: their right-hand
 * sides at once by the emitted rhs_w, each with parameters, inputs, time and a step of its own.
 * Between them each run does what gs_integrate does; one that has ended makes room for the next.
 *
 * A run that has joined does not even do that by itself: what it remembers from step to step is in
 * the columns of the group, in vectors with that of the others. It parts where a step is none of
 * the usual ones. */
#ifndef GS_HOST_LANES_H
#define GS_HOST_LANES_H

#include "host/ensemble/member.h"

/* who has runs and takes those that ended */
typedef struct
{
  void *data;
  int (*next) (void *data, gs_member *m);   /* 0: there is none any more */
  void (*done) (void *data, gs_member *m);
} gs_lane_source;

/* all runs of the source, at most so many at a time. 0; GS_OUT_OF_MEMORY: none was taken */
int gs_run_lanes (const gs_ensemble *e, const gs_lane_source *source, int most);

/* a number of each lane */
typedef double gs_lane[GS_LANES];

/* the next loop is over lanes, none of its turns needs another */
#if defined (GS_OPENMP_SIMD)
#define GS_EACH_LANE _Pragma ("omp simd")
#elif defined (__GNUC__) && ! defined (__clang__)
#define GS_EACH_LANE _Pragma ("GCC ivdep")
#else
#define GS_EACH_LANE
#endif

/* a run in a lane */
typedef struct
{
  gs_member m;
  gs_course c;
  gs_equal_steps way;   /* of rk4 */
  gs_step e;            /* its trial step */
  int busy;             /* it has a run */
  int started;          /* it has had one */
  int steps, alone;     /* it takes part in this step, or makes it by itself */
  int joined;           /* what it remembers is in the columns of the group */
  int failed;           /* info of what failed in its step, or 0 */
} gs_lane_run;

/* The runs and what they remember; numbers below have a row for each lane. */
typedef struct
{
  const gs_ensemble *e;
  const gs_lane_source *source;
  const gs_lane_routines *w;
  double *room;
  int nx, nq, nu, nv, nlam, method;
  int most;                    /* no more lanes than that have runs */
  int of_time;                 /* 1: inputs are no constants */
  int projects;                /* 1: the scene has the routines of its loops over lanes */
  int width;                   /* lanes of which right-hand sides are computed */
  int failed;                  /* 1: something has failed in a step */
  int together;                /* rk4: all lanes have joined and take part */
  int info[GS_LANES], active[GS_LANES], calls[GS_LANES];
  gs_lane_run run[GS_LANES];

  /* the method: of stage i (from 0) the number of rates, which ones, their factors, its time; of
   * stage 0 those of the result */
  int terms[12], which[12][12];
  double factor[12][12], at_time[12];

  gs_lane *x, *xs, *xn;        /* nx: states, those of a stage, after the step */
  gs_lane *f;                  /* (nx,12): stages */
  gs_lane *rates;              /* nx: rates at the states; states before the projection */
  gs_lane *v, *cst, *one_cst;  /* inputs, constants, those of one run */
  gs_lane stage_t, step, err, a, b, tn, at;
  gs_lane runs;                /* 1 where a run has joined */
  gs_lane slow;                /* 1 where a run has to look by itself: it parts */
  gs_lane fresh;               /* 1 where rates are wanted */
  gs_lane limit;               /* no step is longer */
  gs_lane r;                   /* trial steps: 1 good, 2 to be repeated, 3 to be judged by itself,
                                  0 there was none */

  /* what runs that have joined remember */
  gs_lane t, next, longest;    /* time, next step, largest step [s] */
  gs_lane stop, side, due;     /* the next stop and its side, the next output time [s] */
  gs_lane least, largest;      /* steps so far [s] */
  gs_lane good, others, allowed; /* steps that were good and others, how many there may be */
  gs_lane bound, unbound;      /* istat[GS_SEEN_STIFF], istat[GS_SEEN_FREE] */
  gs_lane called;              /* calls of rhs */
  gs_lane wants, after;        /* c.fresh, c.after */
  gs_lane last, near, far, then; /* c.last, c.near, c.far, rstat[GS_H_NEXT] */
  gs_lane moved;               /* 1 if a step was good since it joined */
  gs_lane stiff;               /* istat[GS_IS_STIFF] */
  gs_lane pivot, highest;      /* p[GS_PIVOT], p[GS_LARGEST] */
  gs_lane from, equal, number, count; /* rk4: way.ta, h, k, n */
  gs_lane look;                /* rk4: after how many steps gs_watch_stiffness is to look */

  /* of their event functions; 0: each run looks by itself */
  int events;
  gs_lane looks;               /* 1 where events are looked for here */
  gs_lane loud;                /* 1 where the step may have one */
  gs_lane *g, *g0, *old, *older; /* now, at the begin of the step, at the last points */
  gs_lane *mark, *noise, *bend, *quiet, *apart; /* see gs_look_at_events */
  gs_lane *needs, *until;      /* 1 where it must be above 0; from when on [s] */
  gs_lane *repeats;            /* until when its events may repeat themselves [s] */
  gs_lane *fn, *z;             /* nx: rates at the end of the step, a state within it */

  /* of their loops */
  gs_lane *p;                  /* the partition, */
  int sizes, path;             /* ... where gs_partition has its size and its path */
  gs_lane *q, *phi, *rate, *hc, *hn, *dq, *du, *lengths, *y, *work;
  gs_lane phi_0, rate_0, t_phi, t_rate, projected; /* rstat[GS_R_PHI] and so on */
  gs_lane smallest, smallest_at; /* rstat[GS_R_PIVOT], rstat[GS_T_PIVOT] */
  gs_lane projections;
  gs_lane past, turn;          /* c.a.not_before, c.a.turn */
  gs_lane known;               /* 1: hc is the Jacobian at the state */
  gs_lane res, gap, left, live, rank, lowest, turned, way, margin, tau;
} gs_lane_group;

/* ------------------------------------------------------------------------ lanes.c, lane_stops.c */

int gs_make_lanes (gs_lane_group *g);
void gs_free_lanes (gs_lane_group *g);
/* n numbers of one lane, to and from */
void gs_put_lane (gs_lane *to, int lane, const double *from, int n);
void gs_get_lane (gs_lane *from, int lane, double *to, int n);
/* is a number of one of the lanes beyond a limit? */
int gs_some_above (const double *a, double limit);
int gs_some_below (const double *a, double limit);

/* the next run that does not end at once; without one the lane goes on with numbers that are good;
 * is there a run in any? were all runs ended from outside? */
void gs_fill_lane (gs_lane_group *g, int lane);
void gs_start_lanes (gs_lane_group *g);
int gs_any_lane (const gs_lane_group *g);
int gs_left_lanes (gs_lane_group *g);

/* the inputs at a stop for the record, and on from there; 0 at the end of the run */
int gs_lane_stopped (gs_lane_group *g, gs_lane_run *l);
/* at a stop, the run parted: on from there, or its end; 0: the lane has no run */
int gs_lane_keeps_on (gs_lane_group *g, int lane);
void gs_end_lane (gs_lane_group *g, int lane, int info);
/* state and inputs of its run into the columns */
void gs_lane_state (gs_lane_group *g, int lane);
/* zero rates and steps: its state stays, and the rates of the first known stages */
void gs_park_lane (gs_lane_group *g, int lane, int known);

/* --------------------------------------------------------------------------------- lane_rates.c */

/* which lanes take part in what follows; their calls of rhs so far are 0 */
void gs_activate_lanes (gs_lane_group *g);
/* right-hand sides of all lanes */
void gs_lane_rates (gs_lane_group *g, gs_lane *x, gs_lane *xd);
/* ... at the states x of a stage, those that take part count; last: at the end of the step */
void gs_stage_rates (gs_lane_group *g, gs_lane *xd, const double *t, gs_lane *x, int last);

/* -------------------------------------------------------------------------------- lane_joined.c */

void gs_join_lane (gs_lane_group *g, int lane);
void gs_part_lane (gs_lane_group *g, int lane);
/* runs whose step has failed, or is above 0 in slow; or 3 in g->r */
void gs_part_slow (gs_lane_group *g);
void gs_part_failed (gs_lane_group *g);
/* after how many steps gs_watch_stiffness is to look at a run */
double gs_next_look (const gs_lane_run *l);

/* ---------------------------------------------------- lane_events.c, vectors in event_vectors.c */

/* how many event functions are looked at in lanes */
int gs_lane_events (const gs_ensemble *e);
void gs_join_events (gs_lane_group *g, int lane);
void gs_part_events (gs_lane_group *g, int lane);
/* which good steps have none, the other runs part; what is remembered of good steps */
void gs_look_for_events (gs_lane_group *g);
void gs_remember_quiet (gs_lane_group *g);

void gs_event_states (gs_lane_group *g, int j, int degree);
void gs_look_at_events (gs_lane_group *g, int j);
void gs_events_apart (gs_lane_group *g, int j);
void gs_judge_events (gs_lane_group *g);

/* ---------------------------------------- lane_loops.c, lane_ahead.c, vectors in loop_vectors.c */

int gs_lane_closes (const gs_lane_group *g, const gs_lane_run *l);
void gs_join_loops (gs_lane_group *g, int lane);
void gs_part_loops (gs_lane_group *g, int lane);
/* good steps onto the constraints; where it is not the usual case runs part, with their states as
 * the step left them */
void gs_project_lanes (gs_lane_group *g);
/* the Jacobians hc (nlam,nq) at times and positions; those at the states of runs that joined */
void gs_lane_jacobians (gs_lane_group *g, const double *t, gs_lane *q, gs_lane *cst,
                        gs_lane *hc);
void gs_know_jacobians (gs_lane_group *g);
/* no singular position ahead; those that may have one part */
void gs_look_ahead (gs_lane_group *g);
/* the largest lengths that the rows of the Jacobian had so far (nlam) */
gs_lane *gs_lane_sizes (const gs_lane_group *g);

int gs_project_turn (gs_lane_group *g, int turn);
void gs_find_jumps (gs_lane_group *g);
void gs_lane_pivots (gs_lane_group *g, gs_lane *hc, gs_lane *size);
void gs_lane_turns (gs_lane_group *g, gs_lane *ha, gs_lane *hb, gs_lane *size);
void gs_find_unusual (gs_lane_group *g);
void gs_remember_loops (gs_lane_group *g);
void gs_want_look (gs_lane_group *g);
void gs_positions_ahead (gs_lane_group *g);

/* ------------------------------------------------------ lane_dp853.c, vectors in step_vectors.c */

/* one trial step of every run */
void gs_lanes_step_dp853 (gs_lane_group *g);

void gs_lane_method (gs_lane_group *g);
void gs_stage_states (gs_lane_group *g, int stage);
void gs_estimate_errors (gs_lane_group *g);
void gs_take_rates (gs_lane_group *g, int many);
void gs_begin_trials (gs_lane_group *g);
void gs_judge_trials (gs_lane_group *g);
void gs_end_trials (gs_lane_group *g);
void gs_take_states (gs_lane_group *g);

/* ---------------------------------------- lane_rk4.c, lane_growth.c, vectors in equal_vectors.c */

/* one step of every run */
void gs_lanes_step_rk4 (gs_lane_group *g);
/* of runs whose look is due the largest eigenvalue and the state (from 1) that moves most */
void gs_lane_eigenvalues (gs_lane_group *g, const int *due, double *rho, int *state);

void gs_begin_equals (gs_lane_group *g);
void gs_judge_equals (gs_lane_group *g);
void gs_end_equals (gs_lane_group *g);
void gs_stage_rk4 (gs_lane_group *g, int stage, gs_lane *xs);

#endif
