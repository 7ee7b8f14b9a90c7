/* gsmbp/failures.h: how a run ends, and what failed in it. */
#ifndef GSMBP_FAILURES_H
#define GSMBP_FAILURES_H

/* what gs_integrate, an implicit method or a host returns; -i: argument i of gs_integrate is out of
 * range,
 * -100-k: SIZ(k), -109: ldx, -110: ldv */
enum
{
  GS_DONE = 0,           /* all output times reached */
  GS_TOO_MANY,           /* more than iopt[GS_MOST_STEPS] steps */
  GS_TOO_SMALL,          /* the step became too small */
  GS_ROUTINE_FAILED,     /* see istat[GS_FAILED] */
  GS_NOT_FINITE,         /* the state is no longer finite */
  GS_STIFF,              /* steps are bound by stability (method 9) */
  GS_METHOD_FAILED,      /* an implicit method stopped with the flag istat[GS_CAUSE] */
  GS_OUT_OF_MEMORY,
  GS_RATE_NOT_FINITE,    /* at the start, after a stop or after the end */
  GS_INTERRUPTED,        /* Ctrl-C */
  GS_TIMED_OUT,
  GS_ENDED               /* an event of the user has ended the run */
};

/* istat[GS_FAILED], what failed with istat[GS_FAILED_INFO]. GS_AT_START: in a singular position;
 * info is 1 where the method does not begin there, 2 at rest, 3 where no motion with these speeds
 * leaves it, 4 so after an event. GS_BEFORE_START: the start was refused; info is a verdict.
 * GS_AT_EVENT: info is 10 where events accumulate, GS_WRONG_MODE where the given mode contradicts
 * the state. */
enum
{
  GS_AT_NOTHING, GS_AT_INPUTS, GS_AT_RHS, GS_AT_PRJ, GS_AT_CON, GS_AT_PARTITION, GS_AT_OUTPUT,
  GS_AT_EVENT, GS_AT_START, GS_BEFORE_START, GS_AT_PRE, GS_AT_JAC
};
enum { GS_WRONG_MODE = 13 };

/* verdicts on a start, GS_START_<name>, which hosts know by these names */
#define GS_VERDICTS(ROW)                                                                           \
  ROW (TAKEN)                                                                                      \
  ROW (OFF)           /* its constraints are off by more than 1e-6 */                              \
  ROW (FAR)           /* they are not, but it must be moved by more than 1e-3 (of usual sizes) */  \
  ROW (NONE)          /* no state on them was found */                                             \
  ROW (DEVICE)        /* a device cannot be there */                                               \
  ROW (SAMPLES)       /* a period or a delay cannot be, or too many samples (gs_due_from) */       \
  ROW (ANGLE)         /* an angle is beyond 1e15 rad */                                            \
  ROW (ORIENTATION)   /* Euler parameters have no direction */                                     \
  ROW (NO_PROJECTION) /* it must be moved, but there is no PRJ */                                  \
  ROW (NO_MEMORY)                                                                                  \
  ROW (STOP)          /* a stop is passed */
#define GS_VERDICT_NUMBER(name) GS_START_##name,
enum { GS_VERDICTS (GS_VERDICT_NUMBER) GS_VERDICT_COUNT };
#undef GS_VERDICT_NUMBER
#endif
