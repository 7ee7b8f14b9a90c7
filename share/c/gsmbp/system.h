/* gsmbp/system.h: a scene in a run: what the routines of events.h and integrate.h share. */
#ifndef GSMBP_SYSTEM_H
#define GSMBP_SYSTEM_H

#include "gsmbp/real.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* iopt: IOPT of GSSIM */
enum
{
  GS_METHOD = 0, /* 4 classical Runge-Kutta, fixed step; 8 Dormand-Prince 8(5,3), step controlled; 9
                    as 8, but it ends where steps are found to be bound by stability */
  GS_LOOPS,      /* the way of the loops, see gssim.c: 1 Baumgarte, 2 projection, 3 partitioning,
                    4 null space, 5 zero-eigenvalue theorem, 6 Kane with dependent speeds */
  GS_DRIFT,      /* 1: the drift of the constraints is recorded */
  GS_MOST_STEPS, /* the largest number of steps, 0 for no limit */
  GS_WATCH,      /* 1: positions where the constraints lose rank are watched for */
  GS_ON_SPEEDS   /* how many constraints are on speeds alone; their numbers, from 1, follow */
};

/* istat: ISTAT(1) .. ISTAT(20) of GSSIM */
enum
{
  GS_N_RHS = 0,         /* calls of rhs */
  GS_N_STEPS,           /* accepted steps */
  GS_N_REJECTED,        /* rejected steps */
  GS_N_PROJECTIONS,     /* calls of prj */
  GS_N_OUTPUTS,         /* output times reached */
  GS_FAILED_INFO,       /* info of the routine that failed */
  GS_FAILED,            /* which one: 1 inputs, 2 rhs, 3 prj, 4 con, 5 gsprt, 6 out or gssmp, 7 rst
                           or gsres, 8 the start in a singular position: info is 1 where method 4
                           does not begin there, 2 at rest, 3 where no motion with these speeds
                           leaves it, 4 so after an event */
  GS_N_RANK_LOST,       /* calls of rhs where the constraints lost rank */
  GS_N_ANGLES,          /* calls of rhs close to a singularity of orientation angles */
  GS_N_PARTITIONS,      /* choices of other independent speeds */
  GS_N_PASSED,          /* positions passed where the constraints lose rank */
  GS_N_REPEATED,        /* rejected steps that could not be moved onto the constraints, or only by a
                           jump, or were too close to a singular position */
  GS_N_STABILITY,       /* calls of rhs that looked for bounds of stability */
  GS_IS_STIFF,          /* 1 if steps are bound by stability, and */
  GS_STIFF_STATE,       /* the state (from 1) that the eigenvalue belongs to */
  GS_STIFF_MEMORY,      /* 3 entries: memory of gsstd */
  GS_ACCUMULATES = 18,  /* where GS_FAILED is 7: the event that failed, 0: none did; GS_FAILED_INFO
                           is 10 where it accumulates, 13 where its mode at the start contradicts
                           the state */
  GS_N_LOOSE            /* steps close to singular positions whose error is above the tolerance;
                           method 4: that end in one */
};

/* rstat: RSTAT(1) .. RSTAT(20) of GSSIM */
enum
{
  GS_R_PHI = 0,          /* largest |phi| and */
  GS_R_RATE,             /* largest |HC*u + phit| after any step; */
  GS_T_PHI,              /* when */
  GS_T_RATE,             /* ... [s] */
  GS_R_BEFORE,           /* largest |phi| before a projection */
  GS_H_LEAST,            /* smallest and */
  GS_H_LARGEST,          /* largest step [s] */
  GS_T_REACHED,          /* time reached [s] */
  GS_H_NEXT,             /* the next step that method 8 would take [s] */
  GS_T_RANK_LOST,        /* first and last time of GS_N_RANK_LOST [s] */
  GS_T_ANGLES = 11,      /* first and last time of GS_N_ANGLES [s] */
  GS_R_PIVOT = 13,       /* the least pivot of the constraints beside the largest */
  GS_T_PIVOT,            /* ... and when [s] */
  GS_T_PASSED,           /* first and last time of GS_N_PASSED [s] */
  GS_T_STIFF = 17,       /* when steps were found to be bound by stability [s], */
  GS_R_STIFF,            /* the largest eigenvalue [1/s] */
  GS_H_STIFF             /* and the step [s] */
};

typedef struct
{
  const gs_scene *s;
  int nx;             /* states; an audit adds two to those of s */
  const int *iopt;    /* options */
  const gs_real *ropt; /* step, relative tolerance, largest step */
  const gs_real *atol; /* nx: absolute tolerances */
  int *ip;            /* the inputs and the plans of the samples and of the events, see inputs.h */
  gs_real *rp;
  const gs_real *cst; /* from <name>_pre */
  gs_real *v;         /* 2*nv: inputs */
  gs_real *w;         /* workspace of gsinp */
  gs_real *p;         /* the partition, see partition.h */
  int *istat;         /* 20: statistics */
  gs_real *rstat;     /* 20 */
} gs_system;

#ifdef __cplusplus
}
#endif
#endif
