/* derivatives.c: the adjoint for the module, its arguments one by one. */
#include <stdlib.h>

#include "host/adjoint.h"

/* before a step: what the question says */
typedef int gs_question (void);

static int
ask (void *asked, double t)
{
  gs_question *const *question = asked;
  (void)t;
  return (*question) ();
}

/* the steps of a run forward, empty; for gs_loop_forward, then gs_loop_forget_steps */
gs_kept_steps *
gs_loop_keep_steps (void)
{
  return (gs_kept_steps *)calloc (1, sizeof (gs_kept_steps));
}

void
gs_loop_forget_steps (gs_kept_steps *kept)
{
  if (kept)
    gs_adjoint_free (kept);
  free (kept);
}

int
gs_loop_forward (const gs_scene *s, const double *cst, int *ip, double *rp, gs_question *question,
                 const double *x0, int ns, const double *stops, double rtol, const double *atol,
                 gs_kept_steps *kept, double *states, double *reached, int *steps)
{
  const gs_adjoint_run run = { .scene = s, .cst = cst, .ip = ip, .rp = rp,
                               .ask = question ? ask : NULL, .asked = &question };
  const int info = gs_adjoint_forward (&run, x0, ns, stops, rtol, atol, kept, states, reached);
  *steps = kept->steps;
  return info;
}

int
gs_loop_backward (const gs_scene *s, const double *cst, int *ip, double *rp,
                  gs_question *question, const gs_kept_steps *kept, const double *weights,
                  double *by_start, double *by_parameters, double *reached)
{
  const gs_adjoint_run run = { .scene = s, .cst = cst, .ip = ip, .rp = rp,
                               .ask = question ? ask : NULL, .asked = &question };
  return gs_adjoint_backward (&run, kept, weights, by_start, by_parameters, reached);
}
