/* What a method of implicit.c calls: rates of the states, inputs, the Jacobian, the way onto the
   constraints; the run time does it. */
#include <float.h>
#include <math.h>
#include "gsmbp/inputs.h"
#include "gsmbp/loops.h"
#include "implicit_parts.h"

int
gs_all_finite (int n, const double *x)
{
  for (int i = 0; i < n; i++)
    if (! (fabs (x[i]) <= 1e300))
      return 0;
  return 1;
}

int
gs_side_at (const gs_stepper *s, double t)
{
  return s->side < 0 && t >= s->stop ? -1 : 1;
}

/* the inputs at T into V; INFO of gs_inputs_of_run */
int
gs_take_inputs (gs_stepper *s, double t, int side, const double *x, double *v)
{
  gs_integration *r = s->r;
  int info = gs_inputs_of_run (s->scene, t, side, x, r->nx, r->ip, r->rp, r->cst, v, r->w);
  if (info != 0)
    {
      r->istat[GS_FAILED_INFO] = info;
      r->istat[GS_FAILED] = GS_AT_INPUTS;
    }
  return info;
}

/* X at T moved onto the constraints, at most by JUMP; or looked after, by OPTIONS */
int
gs_check (gs_stepper *s, const int *options, double t, double *x, const double *jump)
{
  gs_integration *r = s->r;
  return gs_check_constraints (s->scene, t, x, options, jump, r->cst, s->p, r->istat, r->rstat);
}

/* ------------------------------------------------------------
 * what a method calls */

int
gs_asked (gs_stepper *s, double t)
{
  gs_integration *r = s->r;
  if (r->ask && s->asked == 0)
    s->asked = r->ask (r->asked, t);
  return s->asked;
}

static int
outcome (int info)
{
  return info < 0 ? -1 : info > 0;
}

/* the rate XD under the inputs that IP asks for, or, where it asks for none, V */
static int
rate (gs_stepper *s, double t, const double *x, int *ip, double *v, double *xd)
{
  gs_integration *r = s->r;
  int side = gs_side_at (s, t);
  gs_system g = s->g;
  if (gs_asked (s, t) != 0)
    return -1;
  g.ip = ip;
  g.v = v;
  if (side < 0)
    t = s->stop;
  gs_copy (r->nx, x, s->trial);   /* gs_rates_at may complete it */
  int info = gs_rates_at (&g, t, side, s->trial, xd);
  return info != 0 ? outcome (info) : ! gs_all_finite (r->nx, xd);
}

int
gs_rate (gs_stepper *s, double t, const double *x, double *xd)
{
  return rate (s, t, x, s->r->ip, s->v, xd);
}

int
gs_inputs_at (gs_stepper *s, double t, const double *x, double *v)
{
  return outcome (gs_take_inputs (s, t, gs_side_at (s, t), x, v));
}

int
gs_inputs (gs_stepper *s, double t, double *v)
{
  return gs_inputs_at (s, t, s->x, v);
}

int
gs_rate_by (gs_stepper *s, double t, const double *x, double *v, double *xd)
{
  int none[2] = { 0, 0 };   /* GS_V0, GS_FEEDBACK: kept as they are */
  return rate (s, t, x, none, v, xd);
}

int
gs_inputs_of_time (const gs_stepper *s)
{
  const int *ip = s->r->ip;
  return ip[GS_FEEDBACK] == 0 && (ip[GS_V0] < 2 || (ip[GS_V0] == 2 && s->o->followed == 0));
}

int
gs_own_states (const gs_stepper *s)
{
  return s->r->nx / (1 + s->o->columns);
}

/* A += B dV/dX(J) at the inputs S->v; by differences, exact for a gain */
static int
add_slope (gs_stepper *s, double t, double *x, int j, double *A)
{
  gs_integration *r = s->r;
  int side = gs_side_at (s, t), n = gs_own_states (s);
  double old = x[j], h = (r->ip[GS_V0] >= 2 ? 1e-7 : 1)
                         * fmax (fabs (old), r->ropt[1] > 0 ? r->atol[j] / r->ropt[1] : 1);
  if (! (h > 0))
    h = 1e-7;
  x[j] = old + h;
  h = x[j] - old;
  int info = gs_take_inputs (s, t, side, x, s->dv);
  x[j] = old;
  for (int k = 0; info == 0 && k < s->scene->nv; k++)
    {
      double slope = (s->dv[k] - s->v[k]) / h;
      for (int i = 0; slope != 0 && i < n; i++)
        A[i + (ptrdiff_t) n * j] += s->b[i + (ptrdiff_t) n * k] * slope;
    }
  return outcome (info);
}

/* A += B dV/dX: the inputs follow the state by a gain or by the user's routine; those of a planned
 * motion follow some states of devices */
static int
add_feedback (gs_stepper *s, double t, double *x, double *A)
{
  gs_integration *r = s->r;
  int planned = r->ip[GS_V0] == 2 && r->ip[GS_FEEDBACK] == 0, info = 0;
  int n = planned ? s->o->followed : gs_own_states (s);
  for (int k = 0; info == 0 && k < n; k++)
    info = add_slope (s, t, x, planned ? s->o->follows[k] - 1 : k, A);
  return info;
}

/* without the emitted Jacobian: by differences */
static int
differences (gs_stepper *s, double t, const double *x, double *A)
{
  int n = gs_own_states (s), info;
  double *f = s->work, *g = s->work + s->r->nx, *beside = s->work + 2 * s->r->nx;
  if ((info = gs_rate (s, t, x, f)) != 0)
    return info;
  gs_copy (s->r->nx, x, beside);
  for (int j = 0; j < n; j++)
    {
      beside[j] = x[j] + sqrt (DBL_EPSILON * fmax (1e-5, fabs (x[j])));
      if ((info = gs_rate (s, t, beside, g)) != 0)
        return info;
      for (int i = 0; i < n; i++)
        A[i + (ptrdiff_t) n * j] = (g[i] - f[i]) / (beside[j] - x[j]);
      beside[j] = x[j];
    }
  return 0;
}

/* the emitted one, at the inputs of the state */
static int
emitted (gs_stepper *s, double t, const double *x, double *A)
{
  gs_integration *r = s->r;
  int side = gs_side_at (s, t), ldy = s->scene->ny > 0 ? s->scene->ny : 1, info = 0;
  int n = gs_own_states (s);
  gs_copy (r->nx, x, s->trial);
  if ((r->ip[GS_V0] != 0 || r->ip[GS_FEEDBACK] != 0)
      && (info = gs_take_inputs (s, t, side, s->trial, s->v)) != 0)
    return outcome (info);
  double at = t;
  if (side < 0) /* as gs_time_beside: what switches at the stop has not yet */
    at = s->stop - fmax (2 * DBL_EPSILON * fabs (s->stop), 1e-300);
  info = s->scene->jac (at, s->trial, s->v, r->cst, A, n, s->b, n, s->c, ldy, s->d, ldy);
  if (info != 0 && info != 2
      && info != 3) /* lost rank, a singularity of angles: usable, as with RHS */
    return outcome (info);
  if (s->scene->nv > 0 && ! gs_inputs_of_time (s)
      && (info = add_feedback (s, t, s->trial, A)) != 0)
    return info;
  return ! gs_all_finite (n * n, A);
}

/* is the emitted Jacobian that of the states? not if gs_rates_at completes them */
static int
has_jacobian (const gs_stepper *s)
{
  return s->scene->jac && s->p[0] == 0;
}

int
gs_jacobian (gs_stepper *s, double t, const double *x, double *A)
{
  return has_jacobian (s) ? emitted (s, t, x, A) : differences (s, t, x, A);
}

int
gs_completes (const gs_stepper *s)
{
  return s->p[0] > 0;
}

int
gs_completed (gs_stepper *s, double t, const double *x, double *completed)
{
  int info = gs_rate (s, t, x, s->work);
  gs_copy (s->r->nx, s->trial, completed);
  return info;
}

/* ... and no jump to another branch, as gs_integrate */
int
gs_moved (gs_stepper *s, double t, const double *x, double *moved)
{
  gs_integration *r = s->r;
  double jump[3];
  gs_largest_move (s->scene->nq, s->scene->nu, s->x, x, r->ropt[1], r->atol, jump);
  jump[2] = 0;
  gs_copy (r->nx, x, moved);
  return outcome (gs_check (s, s->project, t, moved, jump));
}

