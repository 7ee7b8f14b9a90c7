/* gsmbp/plan.h: the plan of a run, ip and rp of gs_inputs_of_run, laid out. Calling rules: scene.h.
 *
 * A program fills gs_plan, gets ip and rp of the lengths below, all zero, and calls gs_lay, then
 * gs_due_from: the arrays are those of gs_integration. What is a null pointer or 0 is not there. */
#ifndef GSMBP_PLAN_H
#define GSMBP_PLAN_H

#include "gsmbp/real.h"
#include "gsmbp/events.h"
#include "gsmbp/inputs.h"

#ifdef __cplusplus
extern "C" {
#endif

/* nc polynomials of np pieces of k coefficients, see gs_polynomials_at */
typedef struct
{
  int nc, np, k;
  const gs_real *numbers; /* np + 1 breaks, then the coefficients (nc,np,k) */
} gs_pieces;

typedef struct
{
  const gs_scene *s;
  int nx;                  /* states of the run, s->nx, or s->nx + 2 with an audit */
  int inputs;              /* as ip[GS_V0] */
  int derivatives;         /* as ip[GS_DERIVATIVES] */
  const gs_real *constants; /* nv: inputs that are constant, held outputs before the first sample;
                              without them those are what the table has at the start */
  gs_pieces table;         /* inputs over time */
  gs_pieces motion;        /* planned coordinates, */
  const int *planned;      /* motion.nc: their numbers */
  gs_pieces reference;     /* nx: of a state feedback, */
  gs_pieces gain;          /* (nv,nx) */
  const gs_real *limits;   /* (nv,2): lower and upper ones of the inputs that it gives */
  const gs_real *memory;   /* nxk: of the sampled devices, otherwise as the scene has it */
  int on_the_way;          /* places for outputs of sampled devices that are on their way */
  int instants;            /* samples that are recorded */
  const int *modes;        /* nev: of the ports at the start, otherwise they are found; where they
                              contradict the state a run fails, istat[GS_FAILED_INFO] is 13 */
  int events;              /* events that are recorded */
} gs_plan;

/* the lengths of ip and rp */
int gs_wholes (const gs_plan *p);
int gs_reals (const gs_plan *p);

/* ip and rp, which are zero */
void gs_lay (const gs_plan *p, int *ip, gs_real *rp);

/* periods, delays and first samples of the sampled devices of a run from t0 on, and what a table
 * tells of their outputs. info: k where the
 * period of device k (from 1) is not above 0 or its delay below 0; -k where it has 2e9 samples
 * behind it */
int gs_due_from (const gs_scene *s, gs_real t0, const gs_real *cst, int *ip, gs_real *rp);

/* the parts of a plan; only where the scene has such devices */
static inline gs_samples
gs_planned_samples (const gs_scene *s, int *ip, gs_real *rp)
{
  return gs_samples_of (s->nv, ip + ip[GS_SAMPLES] - 1, rp + ip[GS_SAMPLES + 1] - 1);
}

static inline gs_events
gs_planned_events (int nx, int *ip, gs_real *rp)
{
  return gs_events_of (nx, ip + ip[GS_EVENTS] - 1, rp + ip[GS_EVENTS + 1] - 1);
}

#ifdef __cplusplus
}
#endif
#endif
