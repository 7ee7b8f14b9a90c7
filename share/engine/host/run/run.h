/* host/run/run.h: a whole run, for all hosts: options checked, the start taken, inputs and plan
 * laid out, integrated by any method; states, inputs, outputs, what was counted, why it failed.
 * Shapes, units: gsmbp/scene.h.
 *
 * gs_run fills a result; gs_free_result gives its arrays back, after a refusal, too. */
#ifndef GSMBP_HOST_RUN_H
#define GSMBP_HOST_RUN_H

#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include "host/derivatives/derivatives.h"
#include "host/implicit/implicit.h"
#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

/* rows of gsmbp/options.h with their names there; gs_default_options fills them */
typedef struct
{
  const char *method;   /* a word of GS_METHODS */
  const char *loops;    /* a word of GS_LOOP_METHODS; a null pointer: what the scene needs */
  double step;          /* of rk4, gauss [s]; of others the first one; NaN: 1e-3, or chosen */
  double rtol;          /* relative tolerance; NaN: the default */
  const gs_real *atol;  /* nx: absolute tolerances; a null pointer: rtol times nominal */
  double maxstep;       /* [s]; 0: no limit */
  double maxsteps;      /* 0: no limit */
  double maxorder;      /* of implicit methods; NaN: the default */
  int drift;            /* 1: constraints are watched; -1: where the scene has some */
  int project;          /* start: 1: x0 is moved onto the constraints, 0: it must be on them */
  int samples;          /* 1: instants of sampled devices are recorded */
  double audit;         /* an energy usual in the scene [J]: the run has two more states, what came
                           in and what passed [J]; 0: none */
  int ncolumns;         /* derivatives that are carried: the run has nx more states for each, */
  const int *columns;   /* ncolumns: by which parameter of rhp (from 1), 0: by a start value, */
  const char *const *names; /* ncolumns: of these, for messages; may be a null pointer, */
  const double *sizes;  /* ncolumns: nominal magnitudes of these, */
  const gs_real *dx0;   /* (nx,ncolumns): those of the start; a null pointer: 0, */
  const int *fixed;     /* nq: 1 where a coordinate of a closed chain keeps them, the others follow
                           from the constraints */
  const int *changes;   /* nev: 0 where an event changes neither states nor inputs; a null pointer:
                           where its kind is 5 */
  gs_implicit_method *cvode; /* where SUNDIALS is there, else a null pointer */
  int (*ask) (void *asked, gs_real t); /* as in gs_integration */
  void *asked;
} gs_run_options;

/* where it starts, and the times of its results */
typedef struct
{
  int nt;
  const gs_real *times; /* nt, two or more: rising; the first is that of x0 [s] */
  const gs_real *x0;    /* nx */
  const double *par;    /* npar: parameters */
  const gs_real *cst;   /* from <name>_pre of them */
  const int *modes;     /* nev: of the ports; a null pointer: they are found */
  const gs_real *memory; /* nxk: of sampled devices; a null pointer: as the scene has it */
} gs_run_start;

/* its inputs: those of gs_plan, or a function */
typedef struct
{
  int kind;             /* as ip[GS_V0]: 0 constants, 1 table, 2 motion, 3 function */
  const gs_real *constants; /* nv; with a table, a motion or a function, or without: what sampled
                           devices hold before their first samples */
  gs_pieces table, motion;
  const int *planned;   /* motion.nc: numbers of the planned coordinates */
  gs_pieces reference, gain; /* of a state feedback, */
  const gs_real *limits; /* (nv,2): lower and upper ones of what it gives */
  gs_vin *function;     /* at a jump it is called beside it, on the side that is asked for; a null
                           pointer: vin of the scene, which is told the side */
  void *data;
  int nbreaks;
  const double *breaks; /* times at which inputs jump besides [s], in any order */
} gs_run_inputs;

/* why a run was not begun */
enum { GS_NOT_REFUSED, GS_REFUSED_OPTION, GS_REFUSED_ROUTINE, GS_REFUSED_START, GS_REFUSED_MODE,
       GS_REFUSED_SAMPLES, GS_REFUSED_COLUMNS, GS_REFUSED_TIME };

typedef struct
{
  int refused;          /* as above; else */
  int info;             /* of failures.h: how it ended */
  const char *option;   /* refused: the option, or the routine ("prj") that the scene lacks */
  char text[2400];      /* why it was refused or failed, after the names of function and scene */
  char warning[400];    /* a tolerance that was raised, or "" */
  gs_start start;       /* what was found at the start */
  const char *method;   /* of the last step */
  int ended;            /* number of the event of the user that has ended it (from 1), or 0 */
  int nx, nt, ldv;      /* states (with those of an audit, of derivatives), times */
  int rows;             /* times reached: columns of the results that are there; where the run has
                           failed the next one has its last state */
  double rtol;
  gs_real *atol;        /* nx: as they were used */
  gs_real *times;       /* nt: those of the start; where an event ended the run the last one is its
                           time */
  gs_real *x;           /* (nx,nt); columns of derivatives are NaN where there are none */
  gs_real *v;           /* (ldv,nt): inputs, from the left */
  gs_real *y;           /* (ny,nt): outputs, NaN where there are none */
  gs_real *cst;         /* ncst: with the parameters of the run, */
  int loop_method;      /* of which the way of the loops needs this one to be so */
  int in_lanes;         /* of many runs: 1: they were in lanes */
  double *dv, *dy;      /* (nv,ncolumns,nt), (ny,ncolumns,nt): derivatives of inputs and outputs,
                           NaN where there are none; a null pointer without columns */
  int istat[GS_COUNTED];
  gs_real rstat[GS_MEASURED];
  int *ip;              /* the plan, with records of samples and events: gs_planned_samples, */
  gs_real *rp;          /* gs_planned_events */
  gs_derivatives *derivatives; /* what a run that carried some has found besides, or null */
  void *room;           /* where all of these lie */
} gs_run_result;

/* those of the table */
gs_run_options gs_default_options (void);

/* A run; 0 where it came to its end, by an event of the user, too; else r->refused or r->info says
 * what happened, r->text in words. Nothing of d, o, s, in is kept. */
int gs_run (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
            const gs_run_inputs *in, gs_run_result *r);
void gs_free_result (gs_run_result *r);

/* the same up to the first step: r->x has the start in its first column, r->ip and r->rp the
 * plan */
int gs_run_prepare (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
                    const gs_run_inputs *in, gs_run_result *r);

#ifdef __cplusplus
}
#endif
#endif
