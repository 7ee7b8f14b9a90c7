/* host/ensemble/ensemble.h: many runs of a scene on threads: parameters, starts and constant inputs
 * differ from run to run. A run is a function of its own row alone: the same bits whoever runs it,
 * when, and next to which others.
 *
 * A host fills gs_ensemble and gs_rows, calls gs_run_ensemble and takes each run as it ends:
 * gs_keep_member puts it into arrays. Where the scene has routines over lanes and
 * gs_ensemble_in_lanes says so, each thread makes GS_LANES runs at a time (host/lanes). */
#ifndef GS_HOST_ENSEMBLE_H
#define GS_HOST_ENSEMBLE_H

#include <stddef.h>

#include "gsmbp/integrate.h"
#include "host/implicit/implicit.h"
#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

/* runs that a thread makes at a time */
enum { GS_LANES = 16 };

/* The emitted routines over lanes: of all arrays of n numbers (ldk,n), a row for each lane; the
 * first k lanes are computed; info (ldk): of each lane, 9 where the routine of one is to be called.
 * Arguments by address, as the Fortran has them. */
typedef void gs_rhs_w (const double *t, const double *x, const double *v, const double *cst,
                       double *xd, int *info, const int *k, const int *ldk);
typedef void gs_evt_w (const double *t, const double *x, const double *v, const double *cst,
                       double *gv, int *info, const int *k, const int *ldk);
typedef void gs_con_w (const double *t, const double *q, const double *cst, double *hc, int *info,
                       const int *k, const int *ldk);
typedef void gs_prj_w (const double *t, const double *x, const double *cst, double *phi,
                       double *rate, double *hc, double *dq, double *du, int *info, const int *k,
                       const int *ldk);
typedef void gs_pre_w (const double *par, double *cst, int *info, const int *k, const int *ldk);

/* a null pointer where the scene has none */
typedef struct gs_lane_routines
{
  gs_rhs_w *rhs;
  gs_evt_w *evt;
  gs_con_w *con;
  gs_prj_w *prj;
  gs_pre_w *pre;
} gs_lane_routines;

/* constants from parameters; info */
typedef int gs_pre (const gs_real *par, gs_real *cst);

/* what all runs have in common */
typedef struct
{
  const gs_scene *scene;
  const gs_description *about;   /* with the nominal magnitudes of these runs */
  gs_pre *pre;
  const gs_lane_routines *lanes; /* a null pointer: every run by itself */
  int npar, ncst;                /* parameters, constants */
  int fortran_inputs;            /* 1: the data of scene->vin are a gs_fortran_inputs of each run */
  gs_integration run;                    /* nx, t0, x0, nt, tout, nb, tbrk, iopt, ropt, atol, ip,
                                    rp, cst, ldx, ldv, lw, ask, asked; the others are each run's
                                    own. ip, rp are the plan from which each run begins; ask is
                                    called by all threads; what is not 0 ends all runs with that
                                    info */
  size_t wholes, reals;          /* the lengths of ip and rp */
  const gs_real *guess;          /* nu: of a planned motion; a null pointer: 0 */
  int check;                     /* 1: starts must be on the constraints; 0: they are moved there */
  gs_implicit_method *method;    /* where iopt[GS_METHOD] is 0, and on from a run that is found to
                                    be stiff; a null pointer: none */
  const gs_implicit *implicit;   /* its options; text, length and resume are each run's own */
} gs_ensemble;

/* numbers of the runs, run i number k at x[i*row + k*column]; x a null pointer: none differ */
typedef struct
{
  const gs_real *x;
  ptrdiff_t row, column;
} gs_table;

/* what differs from run to run */
typedef struct
{
  int n;                      /* runs */
  const gs_real *par;         /* npar: the parameters of all runs */
  int varied;                 /* parameters that differ, */
  const int *which;           /* their numbers, from 1, */
  gs_table table;             /* their values; none: the constants are run.cst of gs_ensemble */
  gs_table starts, inputs;    /* (n,nx), (n,nv) */
  const char *const *broken;  /* n: why a run is not begun, or a null pointer; may be null itself */
} gs_rows;

/* a run with arrays of its own */
typedef struct
{
  int row;                  /* its row, from 0 */
  int begun;                /* 1; 0: it ended before its first step: broken, pre or info says why */
  const char *broken;       /* that of its row */
  int pre;                  /* info of pre */
  int info;                 /* how it ended, as gs_integrate */
  gs_integration run;               /* statistics in it */
  char text[2400];          /* why its start was refused; what a method said that failed */
  gs_scene scene;           /* as it calls it */
  gs_fortran_inputs inputs;
  double *par;              /* npar: its parameters, for messages, */
  gs_real *values;          /* ... for pre */
  gs_real *cst, *x0;        /* the arrays that run reads */
} gs_member;

/* takes a run that ended; called by the thread that made it, for every row once, in any order */
typedef void gs_take_member (void *to, const gs_ensemble *e, gs_member *m);

/* 1: its runs are in lanes */
int gs_ensemble_in_lanes (const gs_ensemble *e);

/* all rows, by so many threads, each run to take (to, ...); progress, where it is no null pointer,
 * is told how many are done. 0; GS_OUT_OF_MEMORY: not all were taken */
int gs_run_ensemble (const gs_ensemble *e, const gs_rows *rows, int threads, gs_take_member *take,
                     void *to, void (*progress) (void *asked, int done));

/* 1: it came to its end, or an event of the user has ended it */
int gs_member_is_done (const gs_member *m);

/* why a run failed, or "", into text of the given size */
void gs_member_failure (const gs_ensemble *e, const gs_member *m, char *text, int size);

/* the outputs y (ny) of the scene at output time k of a run, in the state of column at: those of
 * the side that the row has where the scene switches. 1; 0: there are none, y is as it was */
int gs_outputs_at (const gs_ensemble *e, const gs_member *m, int k, int at, gs_real *y);

/* Runs in arrays of a host, a column or a page for each; a null pointer: not wanted. */
typedef struct
{
  double *x, *v, *y;        /* (nt,nx,n), (nt,nv,n), (nt,ny,n): NaN before; rows that were reached,
                               then the last state of a run that ended before its time */
  double *counts, *values;  /* (GS_COUNTED,n), (GS_MEASURED,n) */
  double *info;             /* (2,n): of the run, of pre */
  double *counted;          /* (3*nev,n): how many events each function had, the times of the first
                               and of the last one, NaN where there was none; 0 before */
  double *margins;          /* (2*nmargins,n): 1 where a margin was passed, then the least values;
                               0 and HUGE_VAL before */
  double **events;          /* n: (3,nevents) time, number, mode after; null before, then of
                               malloc */
  int *nevents;             /* n: how many */
  char **reason;            /* n: why a run failed; null before, and of one that is done; else of
                               malloc */
  int no_memory;            /* 0 before; 1: something is missing */
} gs_results;

/* a gs_take_member whose argument is a gs_results */
void gs_keep_member (void *results, const gs_ensemble *e, gs_member *m);

#ifdef __cplusplus
}
#endif
#endif
