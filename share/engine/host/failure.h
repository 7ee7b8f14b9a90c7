/* host/failure.h: the message that says why a run ended, for all hosts. */
#ifndef GSMBP_HOST_FAILURE_H
#define GSMBP_HOST_FAILURE_H

#include "gsmbp/failures.h"
#include "gsmbp/real.h"
#include "gsmbp/statistics.h"

#ifdef __cplusplus
extern "C" {
#endif

struct gs_description;

typedef struct
{
  const struct gs_description *d; /* the scene: events, what INFO means (host/start.h) */
  int info;            /* of the run */
  const int *istat;    /* GS_COUNTED; [GS_CAUSE]: the event that failed, from 1; 0: not known */
  double t;            /* the time reached [s] */
  const char *said;    /* by an implicit method that stopped; why a start was refused */
  const gs_real *x, *v; /* its last state and inputs; null: not known */
  const gs_real *cst;
  const double *par;   /* as in gs_start_given */
} gs_failed_run;

/* the routine of the scene that failed, in lower case without its name ("rhs"); "": none of it */
const char *gs_failed_routine (const int *istat);

/* why its routine failed, alone; only d and istat are read */
void gs_cause (const gs_failed_run *f, char *text, int size);

/* why a run ended, with the devices that are outside their margins in its last state, into text of
 * the given size, cut to it */
void gs_failure (const gs_failed_run *f, char *text, int size);

#ifdef __cplusplus
}
#endif
#endif
