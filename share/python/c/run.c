/* run.c: gssim and gsfol for the module, their arguments one by one. */
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"

/* a run; rhs and vin: in the place of the scene's, or null pointers. info as gssim */
int
gs_loop_run (const gs_scene *s, gs_rhs *rhs, gs_vin *vin, int nx, double t0, const double *x0,
             int nt, const double *tout, int nb, const double *tbrk, const int *iopt,
             const double *ropt, const double *atol, int *ip, double *rp, const double *cst,
             double *xout, double *vout, int *istat, double *rstat, double *w, int lw)
{
  gs_scene own = *s;
  gs_run r = { .nx = nx, .t0 = t0, .x0 = x0, .nt = nt, .tout = tout, .nb = nb, .tbrk = tbrk,
               .iopt = iopt, .ropt = ropt, .atol = atol, .ip = ip, .rp = rp, .cst = cst,
               .xout = xout, .ldx = nx, .vout = vout, .ldv = s->nv > 1 ? s->nv : 1, .w = w,
               .lw = lw };
  if (rhs)
    own.rhs = rhs;
  own.vin = vin;
  int info = gssim (&own, &r);
  for (int i = 0; i < 20; i++)
    {
      istat[i] = r.istat[i];
      rstat[i] = r.rstat[i];
    }
  return info;
}

/* of the structure that Python fills as well */
int
gs_loop_plan_size (void)
{
  return (int)sizeof (gs_plan);
}

/* where in rp the records of the sampled devices begin; sizes: how many there are room for, how
 * many instants there were, where in rp the memory begins */
int
gs_loop_samples (const gs_scene *s, int *ip, double *rp, int *sizes)
{
  gs_samples a = gs_planned_samples (s, ip, rp);
  sizes[0] = a.ns;
  sizes[1] = *a.count;
  sizes[2] = (int)(a.memory - rp);
  return (int)(a.record - rp);
}

/* the same of the events, then the numbers of the one that ended the run and of the last one */
int
gs_loop_events (int nx, int *ip, double *rp, int *sizes)
{
  gs_events a = gs_planned_events (nx, ip, rp);
  sizes[0] = a.nr;
  sizes[1] = *a.count;
  sizes[2] = *a.ended;
  sizes[3] = *a.newest;
  return (int)(a.record - rp);
}

int
gs_loop_room (const gs_scene *s, int nx, int r)
{
  return gs_room (s, nx, r);
}

/* the planned motion qj (nu,0:r) of a closed chain at t, see gsfol */
int
gs_loop_follow (const gs_scene *s, double t, int side, int r, int na, const int *ipl, int np,
                int k, const double *brk, const double *coef, const double *cst, double *qj,
                double *w)
{
  return gsfol (s, t, side, r, na, ipl, np, k, brk, coef, cst, qj, w);
}
