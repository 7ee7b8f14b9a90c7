/* host/adjoint.h: derivatives of goals of a run by its start and its parameters, backwards: a run
 * whose steps are kept, and the way back through them, at a cost that does not depend on the number
 * of parameters. Steps are those of gs_step_dp853, without projection, events and samples; inputs
 * depend on time alone. Shapes, units: gsmbp/scene.h. */
#ifndef GSMBP_HOST_ADJOINT_H
#define GSMBP_HOST_ADJOINT_H

#include "gsmbp/failures.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* what both ways need */
typedef struct
{
  const gs_scene *scene; /* with adj; nsp parameters */
  const gs_real *cst;    /* from <name>_pre */
  int *ip;               /* the inputs of a run of nx states, laid out by gs_lay */
  gs_real *rp;
  int (*ask) (void *asked, gs_real t); /* after every step: what is not 0 ends it with that info; */
  void *asked;           /* a null pointer: none */
} gs_adjoint_run;

/* the steps of a run; zero before gs_adjoint_forward, whose memory gs_adjoint_free gives back */
typedef struct
{
  int ns;           /* stops, */
  int *counts;      /* ns: steps up to each */
  int steps, room;
  gs_real *numbers; /* (4+13*nx,steps): begin, end, length [s], side, state at the begin, its twelve
                       right-hand sides */
} gs_kept_steps;

/* The run forward from x0 (nx) at stops[0] to the other stops [s] (ns of them, rising), where the
 * steps end; states (nx,ns): those at the stops, as far as they were reached; reached: the time
 * [s]. info: 0, GS_TOO_SMALL, GS_OUT_OF_MEMORY or what ask has returned. */
int gs_adjoint_forward (const gs_adjoint_run *run, const gs_real *x0, int ns, const gs_real *stops,
                        gs_real rtol, const gs_real *atol, gs_kept_steps *kept, gs_real *states,
                        gs_real *reached);

/* The way back: of a goal whose derivatives by the states at the stops are weights (nx,ns) the
 * derivatives by the start, by_start (nx), and by the parameters, by_parameters (nsp); reached: the
 * time [s]. info: 0, that of adj or of the inputs, GS_OUT_OF_MEMORY, what ask has returned. */
int gs_adjoint_backward (const gs_adjoint_run *run, const gs_kept_steps *kept,
                         const gs_real *weights, gs_real *by_start, gs_real *by_parameters,
                         gs_real *reached);

void gs_adjoint_free (gs_kept_steps *kept);

#ifdef __cplusplus
}
#endif
#endif
