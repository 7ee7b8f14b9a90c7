/* fmu.h: what the parts of an FMU share: the table of a scene, one instance of it.
 *
 * Value references count the variables in the order of the blocks below, from 0 (time) on. In a
 * function of type int 0 is success, else a status with its sentence in the instance's text. */
#ifndef GSF_FMU_H
#define GSF_FMU_H

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"
#include "host/run/stepped.h"

#include <stddef.h>

typedef int gsf_jac (double t, const double *x, const double *v, const double *cst, double *a,
                     int lda, double *b, int ldb, double *c, int ldc, double *d, int ldd);
typedef void gsf_tan (double t, const double *x, const double *cst, double *dp, int ldp,
                      double *dv, int ldv);

/* what INFO of a routine means */
typedef struct
{
  const char *routine;
  int info;
  const char *text;
} gsf_info;

/* bounds of a variable */
typedef struct
{
  int reference;
  double low, high;
} gsf_bounds;

/* the scene as the emitted table has it; numbers of states, inputs, ... count from 0 */
typedef struct
{
  const gs_scene *scene;
  int npar, ncst;
  void (*par) (double *par);                        /* parameters as the scene has them */
  int (*pre) (const double *par, double *cst);
  const char *(*refuse) (const double *par);        /* null, or the rule that values break */
  void (*start) (const double *par, double *x);     /* states as the scene starts them */
  gsf_jac *jac;                                     /* null: none */
  gsf_tan *tan;
  gs_mar *mar;                                      /* null: no margins */
  const char *method;                               /* of co-simulation, a word of GS_METHODS; */
  gs_implicit_method *integrate;                    /* null: gs_integrate */
  int nmargins;
  const char *const *margins;                       /* what must be above 0 */
  const double *nominal;                            /* nx */
  int nsets;
  const int *sets;                                  /* (4,nsets): Euler parameters */
  int nspeedrows;
  const int *speedrows;                             /* constraints on speeds alone, from 1 */
  int nsettled;
  const int *settled;                               /* states that start where rates vanish */
  int nsq, nsu;                                     /* coordinates, speeds that are states in
                                                       model exchange */
  int nin;
  const int *inputs;                                /* places of the importer's inputs in V */
  int nports, nown;                                 /* event functions of ports, behind which
                                                       those of the user stand; its events: */
  const int *own;                                   /* which of them each of these functions is, */
  const int *ends;                                  /* nown: 1 where one ends the run, */
  const char *const *events;                        /* nown: their names, */
  int nswitched;                                    /* inputs that they switch: */
  const int *switched;                              /* places of these in V */
  int ninfos;
  const gsf_info *infos;
  int nbounds;
  const gsf_bounds *bounds;
  const char *const *names;                         /* of the variables, by reference */
  const char *token;                                /* guid, instantiationToken */
} gsf_model;

extern const gsf_model gsf_the_model;

/* ------------------------------------------------------------------------------------ variables */

/* the blocks of value references, in their order */
enum gsf_block
{
  GSF_TIME,
  GSF_PARAMETER,
  GSF_INPUT,
  GSF_STATE,      /* coordinates, speeds, states of devices */
  GSF_CHOSEN,     /* closed chains: the independent ones among them, the states of model exchange */
  GSF_RATE,       /* rates of the states of model exchange */
  GSF_OUTPUT,
  GSF_MODE,       /* of ports with events */
  GSF_HELD,       /* held outputs of sampled devices, */
  GSF_MEMORY,     /* their memory */
  GSF_PLACE,      /* which state each of GSF_CHOSEN is, from 1 */
  GSF_TALLY,      /* events of the user: how often each has happened, */
  GSF_WHEN,       /* when it did last */
  GSF_OVERRIDDEN, /* inputs that they switch: 1 where one is held, */
  GSF_USED,       /* its value for the scene */
  GSF_INDICATOR,  /* event indicators */
  GSF_BLOCKS
};

int gsf_count (const gsf_model *m, int block);
/* the reference of its first variable */
int gsf_first (const gsf_model *m, int block);
/* the block of a reference and the place in it, GSF_BLOCKS if there is none */
int gsf_locate (const gsf_model *m, unsigned reference, int *place);

/* the number of continuous states in model exchange, of event indicators */
int gsf_ns (const gsf_model *m);
int gsf_nz (const gsf_model *m);

/* ------------------------------------------------------------------------------------- instance */

enum { GSF_OK, GSF_WARNING, GSF_DISCARD, GSF_ERROR };
/* under which category each of them is logged */
extern const char *const gsf_category[];

enum gsf_phase
{
  GSF_MADE = 1,
  GSF_INIT = 2,
  GSF_EVENT = 4,
  GSF_CONTINUOUS = 8,
  GSF_STEP = 16,
  GSF_DONE = 32,
  GSF_READY = GSF_INIT | GSF_EVENT | GSF_CONTINUOUS | GSF_STEP | GSF_DONE,
  GSF_ANY = GSF_MADE | GSF_READY
};

enum { GSF_EXCHANGE, GSF_COSIMULATION };
enum { GSF_HAS_RATES = 1, GSF_HAS_OUTPUTS = 2 };

/* whole numbers of an instance ahead of those of its arrays */
enum
{
  GSF_PHASE = 0,
  GSF_KIND,
  GSF_STALE,      /* 1: parameters or starts were set, 2: a state or the time */
  GSF_WHOLES
};
/* in a communication step */
enum { GSF_MOST_STEPS = 10000000 };
/* numbers */
enum
{
  GSF_T1 = 0,     /* where it stops, or 1e300 */
  GSF_TOLERANCE,
  GSF_T_EVENT,    /* the last event */
  GSF_T_NEXT,     /* the next one that is known, or 2e300 */
  GSF_T_SWITCH,   /* the next time at which the scene switches, or 2e300 */
  GSF_NUMBERS
};

typedef struct
{
  const gsf_model *m;
  gs_stepped_run run; /* its two arrays are what is saved with a state; of it: */
  double *t;       /* the time now */
  double *cst;
  double *x;       /* nx: the state now */
  double *v, *w;   /* inputs, workspace */
  double *d;       /* what is the FMU's among the numbers, */
  int *i;          /* the whole numbers of the run */
  /* parts of d */
  double *par;
  double *memory;  /* nxk: of sampled devices at the start */
  double *xs;      /* nx: starts, as they were set */
  double *xr;      /* nx: that of the last event or completed step */
  double *z;       /* ns: states of model exchange */
  double *p;       /* the partition of a closed chain */
  double *level;   /* nev: an event is where its function falls below */
  double *size;    /* nev: functions of the user: the largest value so far */
  /* parts of i */
  int *set;        /* nx: 1 where the start was set */
  int *place;      /* ns: numbers of the states that z holds */
  int *passed;     /* nmargins: 1 where a margin was passed at the end of the last step */
  int *phase;      /* nev: functions of the user in model exchange: GSF_ARMED, ... */
  int *low;        /* nev: events since it has last risen */
  void *kept;      /* the instance as it was before the samples that it shows */
  int shown;       /* 1: it shows those at the communication point */
  /* workspace */
  double *xd, *y, *g;
  double *xout;    /* nx + nev + 2 */
  gs_description about;   /* for starts and margins: */
  const char **events;    /* nev: names of event functions, */
  char *event_text;       /* those of ports */
  int known;       /* which of v and xd, v and y belong to the state: GSF_HAS_... */
  char text[1000]; /* what went wrong */
} gsf_instance;

int gsf_partition_size (const gs_scene *s);
gsf_instance *gsf_new (const gsf_model *m, int kind);
void gsf_free (gsf_instance *a);
void gsf_reset (gsf_instance *a);
void gsf_terminate (gsf_instance *a);

/* a status with its sentence */
int gsf_fail (gsf_instance *a, int status, const char *format, ...);
/* ... of a routine (GS_AT_RHS, ...) that returned info */
int gsf_failed (gsf_instance *a, int status, int routine, int info);
/* what INFO of a routine means, or null */
const char *gsf_meaning (const char *routine, int info);
/* an error: what the run says */
int gsf_run_says (gsf_instance *a);

/* may a function be called here: kinds of FMU as bits, phases? are there values where n are
 * expected, and as many as expected? */
int gsf_allowed (gsf_instance *a, const char *function, int kinds, int phases);
int gsf_given (gsf_instance *a, const char *function, size_t n, const void *first,
               const void *second);
int gsf_as_many (gsf_instance *a, const char *function, size_t n, size_t expected);

/* initialization */
int gsf_setup (gsf_instance *a, int given, double tolerance, double t0, int stops, double t1);
int gsf_enter (gsf_instance *a);
int gsf_exit (gsf_instance *a);
/* what a run needs of the scene; 0: no memory */
int gsf_describe (gsf_instance *a);
/* a warning where a device has left the range of its laws since the last call */
int gsf_watch (gsf_instance *a);

/* values by reference */
int gsf_get (gsf_instance *a, unsigned reference, double *value);
int gsf_set (gsf_instance *a, unsigned reference, double value);
int gsf_set_time (gsf_instance *a, double t);

/* parameters, starts and the state as they are: cst, x, v of the instance */
int gsf_fresh (gsf_instance *a);
int gsf_is_usable (int info);
int gsf_inputs (gsf_instance *a);
/* outputs into a->y, rates of all states into a->xd */
int gsf_outputs (gsf_instance *a);
int gsf_rates (gsf_instance *a);

/* states of model exchange */
int gsf_choose (gsf_instance *a);
void gsf_take (gsf_instance *a);
int gsf_complete (gsf_instance *a);
int gsf_set_states (gsf_instance *a, const double *z);
double gsf_nominal (const gsf_instance *a, int state);
/* how far the independent coordinates are from where others must be chosen, the Euler parameters
 * from where they are normalized; below 0 they must */
int gsf_margins (gsf_instance *a, double *chosen, double *normal);

/* events; gsf_next_switch finds the next time at which the scene switches; gsf_time is the time,
 * but just before a switch that is due until its event has been */
void gsf_next_switch (gsf_instance *a);
double gsf_time (const gsf_instance *a);
int gsf_indicators (gsf_instance *a, double *z);
int gsf_indicator (gsf_instance *a, int k, double *z);
int gsf_begin_events (gsf_instance *a);
int gsf_event (gsf_instance *a, int *changed, int *nominals);
int gsf_completed (gsf_instance *a, int *event);

/* event k of the user (from 0): how often it has happened, when it last did */
int gsf_tally (const gsf_instance *a, int k);
double gsf_when (const gsf_instance *a, int k);
/* events of the user: where they are at the start */
void gsf_begin_own (gsf_instance *a);
/* in model exchange: before and after functions in a->g happen; where those that have risen count
 * anew; as gsf_fail where events accumulate */
void gsf_before_own (gsf_instance *a);
int gsf_after_own (gsf_instance *a);
void gsf_risen_own (gsf_instance *a, int completed);
/* may function k (from 0) happen where it is at its level? */
int gsf_is_ready (const gsf_instance *a, int k);
/* the sentence of the event that has ended the run, with a status */
int gsf_ended (gsf_instance *a, int status);
/* event k (0 the start, -1 inputs may have jumped) and those that follow */
int gsf_happens (gsf_instance *a, int k);
/* the event functions at the state into a->g */
int gsf_functions (gsf_instance *a);
/* is the input at place k of V held by an event? */
int gsf_is_overridden (const gsf_instance *a, int k);

/* may a step of the length h begin at t? one step of co-simulation to the time t, or to an event
 * that ends the run */
int gsf_can_step (gsf_instance *a, double t, double h);
int gsf_step (gsf_instance *a, double t);

/* what sampled devices do at this instant, and when the next one is */
int gsf_take_samples (gsf_instance *a, int *acted);
/* co-simulation: the values after the samples at the communication point, those before them */
int gsf_show_samples (gsf_instance *a);
void gsf_hide_samples (gsf_instance *a);

/* the parts of its plan; only where the scene has such devices */
static inline gs_samples
gsf_samples (const gsf_instance *a)
{
  return gs_planned_samples (a->m->scene, a->run.r.ip, a->run.r.rp);
}

static inline gs_events
gsf_events (const gsf_instance *a)
{
  return gs_planned_events (a->m->scene->nx, a->run.r.ip, a->run.r.rp);
}

/* sum over the knowns of the derivative of unknown times seed */
int gsf_directional (gsf_instance *a, size_t nu, const unsigned *unknowns, size_t nk,
                     const unsigned *knowns, const double *seed, double *result);

/* saved states */
void *gsf_save (gsf_instance *a, void *old);
int gsf_restore (gsf_instance *a, const void *state);
size_t gsf_bytes (const gsf_instance *a);
int gsf_serialize (gsf_instance *a, const void *state, void *bytes, size_t n);
void *gsf_deserialize (gsf_instance *a, const void *bytes, size_t n, void *old);

#endif
