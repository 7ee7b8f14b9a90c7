/* host/failure.h: the message that says why a run ended, for all hosts. */
#ifndef GSMBP_HOST_FAILURE_H
#define GSMBP_HOST_FAILURE_H

#include "gsmbp/failures.h"
#include "gsmbp/statistics.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  int info;            /* of the run */
  const int *istat;    /* GS_COUNTED */
  double t;            /* the time reached [s] */
  const char *meaning; /* of istat[GS_FAILED_INFO] in gs_failed_routine; null: none known */
  const char *event;   /* the name of the event that failed; null: not known */
  int sticks;          /* do ports have friction with events? */
  const char *said;    /* by an implicit method that stopped; why a start was refused */
} gs_failed_run;

/* the routine of the scene that failed, in lower case without its name ("rhs"); "": none of it */
const char *gs_failed_routine (const int *istat);

/* why its routine failed, alone; only istat and meaning are read */
void gs_cause (const gs_failed_run *f, char *text, int size);

/* why a run ended, into text of the given size, cut to it */
void gs_failure (const gs_failed_run *f, char *text, int size);

#ifdef __cplusplus
}
#endif
#endif
