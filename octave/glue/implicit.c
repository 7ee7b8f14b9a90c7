/* The run of GSSIM (stops at breaks, inputs, loops, statistics; the same routines of share/fortran)
   by an implicit method, for stiff scenes.  Output times may lie between the steps: there the
   method's state is moved onto the constraints as well. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "implicit.h"
#include "gsmbp/inputs.h"

/* the Fortran routines: the addresses carry no types, these do */
typedef void fun_type (gsmbp_sub rhs, gsmbp_sub con, gsmbp_sub kin, gsmbp_sub cmd, gsmbp_sub clo,
                       gsmbp_sub vin, const double *t, const int *side, double *x, const int *nq,
                       const int *nu, const int *nx, const int *nv, const int *nlam, int *ip,
                       double *rp, double *cst, double *v, double *xd, double *w, double *p,
                       int *istat, double *rstat, int *info);
typedef void inp_type (gsmbp_sub cmd, gsmbp_sub clo, gsmbp_sub vin, const double *t,
                       const int *side, const double *x, const int *nu, const int *nx,
                       const int *nv, int *ip, double *rp, double *cst, double *v, double *w,
                       int *info);
typedef void chk_type (gsmbp_sub prj, gsmbp_sub con, gsmbp_sub kin, const double *t, double *x,
                       const int *nq, const int *nu, const int *nx, const int *nlam,
                       const int *iopt, const double *jump, double *cst, double *p, int *istat,
                       double *rstat, int *info);
typedef void jmp_type (const int *nq, const int *nu, const double *x, const double *xn,
                       const double *rtol, const double *atol, double *jump);
typedef void pst_type (const int *nq, const int *nu, const int *nlam, const int *iopt, double *p);
typedef void pnw_type (gsmbp_sub con, gsmbp_sub kin, const double *t, double *x, const int *nq,
                       const int *nu, const int *nlam, double *cst, double *p, int *info);
typedef void pbg_type (gsmbp_sub con, gsmbp_sub kin, const double *t, const double *x,
                       const double *hmax, const int *nq, const int *nu, const int *nlam,
                       double *cst, const double *f, double *xt, double *xw, double *hc,
                       double *siz, double *p, int *state);
typedef void due_type (gsmbp_sub out, gsmbp_sub ctl, gsmbp_sub cmd, gsmbp_sub clo, gsmbp_sub vin,
                       const double *t, const double *x, const int *nu, const int *nx,
                       const int *nv, int *ip, double *rp, double *cst, double *v, double *w,
                       int *istat, double *ts, int *acted, int *info);
typedef void jac_type (const double *t, const double *x, const double *v, double *cst, double *a,
                       const int *lda, double *b, const int *ldb, double *c, const int *ldc,
                       double *d, const int *ldd, int *info);

static const double no_jump[3] = { 0, 0, 0 };

static int
all_finite (int n, const double *x)
{
  for (int i = 0; i < n; i++)
    if (! (fabs (x[i]) <= 1e300))
      return 0;
  return 1;
}

static int
side_at (const gs_run *s, double t)
{
  return s->side < 0 && t >= s->stop ? -1 : 1;
}

/* the inputs at T into V; INFO of GSINP */
static int
inputs (gs_run *s, double t, int side, const double *x, double *v)
{
  const gsmbp_run *r = s->r;
  int info = 0;
  ((inp_type *)r->gsinp) (r->cmd, r->clo, r->vin, &t, &side, x, &r->nu, &r->nx, &r->nv, r->ip,
                          r->rp, r->cst, v, r->w, &info);
  if (info != 0)
    {
      r->istat[5] = info;
      r->istat[6] = INPUTS;
    }
  return info;
}

/* X at T moved onto the constraints, at most by JUMP; or looked after, by OPTIONS */
static int
check (gs_run *s, const int *options, double t, double *x, const double *jump)
{
  const gsmbp_run *r = s->r;
  int info = 0;
  ((chk_type *)r->gschk) (r->prj, r->con, r->kin, &t, x, &r->nq, &r->nu, &r->nx, &r->nlam, options,
                          jump, r->cst, s->p, r->istat, r->rstat, &info);
  return info;
}

/* ------------------------------------------------------------
 * what a method calls */

static int
outcome (int info)
{
  return info < 0 ? -1 : info > 0;
}

/* the rate XD under the inputs that IP asks for, or, where it asks for none, V */
static int
rate (gs_run *s, double t, const double *x, int *ip, double *v, double *xd)
{
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), info = 0;
  if (side < 0)
    t = s->stop;
  memcpy (s->trial, x, sizeof (double) * r->nx);   /* GSFUN may complete it */
  ((fun_type *)r->gsfun) (r->rhs, r->con, r->kin, r->cmd, r->clo, r->vin, &t, &side, s->trial,
                          &r->nq, &r->nu, &r->nx, &r->nv, &r->nlam, ip, r->rp, r->cst, v, xd, r->w,
                          s->p, r->istat, r->rstat, &info);
  return info != 0 ? outcome (info) : ! all_finite (r->nx, xd);
}

int
gs_rate (gs_run *s, double t, const double *x, double *xd)
{
  return rate (s, t, x, s->r->ip, s->v, xd);
}

int
gs_inputs_at (gs_run *s, double t, const double *x, double *v)
{
  return outcome (inputs (s, t, side_at (s, t), x, v));
}

int
gs_inputs (gs_run *s, double t, double *v)
{
  return gs_inputs_at (s, t, s->x, v);
}

int
gs_rate_by (gs_run *s, double t, const double *x, double *v, double *xd)
{
  int none[2] = { 0, 0 };   /* GS_V0, GS_FEEDBACK: kept as they are */
  return rate (s, t, x, none, v, xd);
}

int
gs_inputs_of_time (const gs_run *s)
{
  const int *ip = s->r->ip;
  return ip[GS_FEEDBACK] == 0 && (ip[GS_V0] < 2 || (ip[GS_V0] == 2 && ! s->r->of_state));
}

int
gs_own_states (const gsmbp_run *r)
{
  return r->nx / (1 + r->columns);
}

/* A += B dV/dX: the inputs follow the state by a gain, by the user's routine or by the states of
 * devices; by differences, exact for a gain */
static int
add_feedback (gs_run *s, double t, double *x, double *A)
{
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), n = gs_own_states (r);
  for (int j = 0; j < n; j++)
    {
      double old = x[j], h = (s->r->ip[GS_V0] >= 2 ? 1e-7 : 1)
                             * fmax (fabs (old), r->ropt[1] > 0 ? r->atol[j] / r->ropt[1] : 1);
      if (! (h > 0))
        h = 1e-7;
      x[j] = old + h;
      h = x[j] - old;
      int info = inputs (s, t, side, x, s->dv);
      x[j] = old;
      if (info != 0)
        return outcome (info);
      for (int k = 0; k < r->nv; k++)
        {
          double slope = (s->dv[k] - s->v[k]) / h;
          for (int i = 0; slope != 0 && i < n; i++)
            A[i + (size_t) n * j] += s->b[i + (size_t) n * k] * slope;
        }
    }
  return 0;
}

/* without the emitted Jacobian: by differences */
static int
differences (gs_run *s, double t, const double *x, double *A)
{
  int n = gs_own_states (s->r), info;
  double *f = s->work, *g = s->work + s->r->nx, *beside = s->work + 2 * s->r->nx;
  if ((info = gs_rate (s, t, x, f)) != 0)
    return info;
  memcpy (beside, x, sizeof (double) * s->r->nx);
  for (int j = 0; j < n; j++)
    {
      beside[j] = x[j] + sqrt (DBL_EPSILON * fmax (1e-5, fabs (x[j])));
      if ((info = gs_rate (s, t, beside, g)) != 0)
        return info;
      for (int i = 0; i < n; i++)
        A[i + (size_t) n * j] = (g[i] - f[i]) / (beside[j] - x[j]);
      beside[j] = x[j];
    }
  return 0;
}

/* the emitted one, at the inputs of the state */
static int
emitted (gs_run *s, double t, const double *x, double *A)
{
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), ldy = r->ny > 0 ? r->ny : 1, info = 0, n = gs_own_states (r);
  memcpy (s->trial, x, sizeof (double) * r->nx);
  if ((r->ip[GS_V0] != 0 || r->ip[GS_FEEDBACK] != 0)
      && (info = inputs (s, t, side, s->trial, s->v)) != 0)
    return outcome (info);
  if (side < 0)   /* as GSLFT: what switches at the stop has not yet */
    t = s->stop - fmax (2 * DBL_EPSILON * fabs (s->stop), 1e-300);
  ((jac_type *)r->jac) (&t, s->trial, s->v, r->cst, A, &n, s->b, &n, s->c, &ldy, s->d, &ldy, &info);
  if (info != 0 && info != 2
      && info != 3) /* lost rank, a singularity of angles: usable, as with RHS */
    return outcome (info);
  if (r->nv > 0 && ! gs_inputs_of_time (s)
      && (info = add_feedback (s, t, s->trial, A)) != 0)
    return info;
  return ! all_finite (n * n, A);
}

/* is the emitted Jacobian that of the states? not if GSFUN completes them */
static int
has_jacobian (const gs_run *s)
{
  return s->r->jac && s->p[0] == 0;
}

int
gs_jacobian (gs_run *s, double t, const double *x, double *A)
{
  return has_jacobian (s) ? emitted (s, t, x, A) : differences (s, t, x, A);
}

int
gs_completes (const gs_run *s)
{
  return s->p[0] > 0;
}

int
gs_completed (gs_run *s, double t, const double *x, double *completed)
{
  int info = gs_rate (s, t, x, s->work);
  memcpy (completed, s->trial, sizeof (double) * s->r->nx);
  return info;
}

/* ... and no jump to another branch, as GSSIM */
int
gs_moved (gs_run *s, double t, const double *x, double *moved)
{
  const gsmbp_run *r = s->r;
  double jump[3];
  ((jmp_type *) r->gsjmp) (&r->nq, &r->nu, s->x, x, &r->ropt[1], r->atol, jump);
  jump[2] = 0;
  memcpy (moved, x, sizeof (double) * r->nx);
  return outcome (check (s, s->project, t, moved, jump));
}

/* ------------------------------------------------------------
 * the run */

static int
allocate (gs_run *s)
{
  const gsmbp_run *r = s->r;
  size_t nx = r->nx, nv = r->nv + 1, ny = r->ny + 1,
         np = 24 + 8 * r->nu + 10 * r->nq + 7 * r->nlam + 2 * r->nlam * r->nu;
  int n = 6 + r->iopt[5];
  s->x = calloc (6 * nx + r->nq + 2 * nv + np + nx * nv + ny * nx + ny * nv, sizeof (double));
  s->project = calloc (2 * n, sizeof (int));
  if (! s->x || ! s->project)
    return 0;
  s->trial = s->x + nx;
  s->between = s->trial + nx;
  s->v = s->between + nx;
  s->dv = s->v + nv;
  s->p = s->dv + nv;
  s->b = s->p + np;
  s->c = s->b + nx * nv;
  s->d = s->c + ny * nx;
  s->work = s->d + ny * nv;
  s->turns = s->work + 3 * nx;
  s->watch = s->project + n;
  memcpy (s->project, r->iopt, n * sizeof (int));
  memcpy (s->watch, r->iopt, n * sizeof (int));
  s->project[1] = 2;
  s->project[2] = 0;
  s->watch[1] = s->watch[2] = 1;
  s->watch[0] = 4;   /* as method 4: steps are not steered by singular positions */
  return s->by->open (s);
}

static void
release (gs_run *s)
{
  s->by->close (s);
  free (s->x);
  free (s->project);
}

int
gs_projects (const gsmbp_run *r)
{
  return r->iopt[1] != 1 && (r->nlam > 0 || r->nq > r->nu);
}

/* the sampled devices; ACTED: did any? INFO */
static int
samples (gs_run *s, int *acted)
{
  const gsmbp_run *r = s->r;
  int info = 0;
  ((due_type *)r->gsdue) (r->out, r->ctl, r->cmd, r->clo, r->vin, &s->t, s->x, &r->nu, &r->nx,
                          &r->nv, r->ip, r->rp, r->cst, s->v, r->w, r->istat, &s->sample, acted,
                          &info);
  return info != 0 ? ROUTINE : FINISHED;
}

/* time, state and statistics at the start */
static void
start (gs_run *s)
{
  const gsmbp_run *r = s->r;
  if (r->resume)
    {
      s->t = r->rstat[7];
      memcpy (s->x, r->xout + (size_t) r->ldx * r->istat[4], sizeof (double) * r->nx);
      r->istat[15] = r->istat[16] = r->istat[17] = 0;
      return;
    }
  s->t = r->t0;
  memcpy (s->x, r->x0, sizeof (double) * r->nx);
  memset (r->istat, 0, 20 * sizeof (int));
  memset (r->rstat, 0, 20 * sizeof (double));
  r->rstat[13] = 1;
  r->rstat[5] = r->tout[r->nt - 1] - r->t0;
  r->rstat[7] = r->t0;
}

/* does the run start where the constraints lose rank? BDF does not begin there: INFO */
static int
singular_start (gs_run *s)
{
  const gsmbp_run *r = s->r;
  double hmax = r->tout[r->nt - 1] - s->t;
  size_t room = r->nx + 2 * (size_t) r->nq + (size_t) r->nlam * (r->nu + 1);
  int state = 0, side = 1, info = 0;
  if (r->nlam == 0 || r->iopt[4] != 1 || r->iopt[1] == 1 || r->resume)
    return FINISHED;
  double *f = calloc (room, sizeof (double));
  if (! f)
    return MEMORY;
  double *xt = f + r->nx, *xw = xt + r->nq, *siz = xw + r->nq, *hc = siz + r->nlam;
  pbg_type *look = (pbg_type *) r->gspbg;
  look (r->con, r->kin, &s->t, s->x, &hmax, &r->nq, &r->nu, &r->nlam, r->cst, f, xt, xw, hc, siz,
        s->p, &state);
  if (state < 0)   /* at rest: by the accelerations */
    {
      ((fun_type *) r->gsfun) (r->rhs, r->con, r->kin, r->cmd, r->clo, r->vin, &s->t, &side, s->x,
                               &r->nq, &r->nu, &r->nx, &r->nv, &r->nlam, r->ip, r->rp, r->cst, s->v,
                               f, r->w, s->p, r->istat, r->rstat, &info);
      if (info == 0)
        look (r->con, r->kin, &s->t, s->x, &hmax, &r->nq, &r->nu, &r->nlam, r->cst, f, xt, xw, hc,
              siz, s->p, &state);
    }
  free (f);
  if (info == 0 && state > 0)
    {
      r->istat[5] = state;
      r->istat[6] = BEGINNING;
    }
  return info != 0 || state > 0 ? ROUTINE : FINISHED;
}

/* the start, as GSSIM; INFO */
static int
begin (gs_run *s)
{
  const gsmbp_run *r = s->r;
  int info, acted;
  start (s);
  ((pst_type *) r->gspst) (&r->nq, &r->nu, &r->nlam, r->iopt, s->p);
  double job = s->p[0];
  s->p[0] = 0;   /* completed from others it would be moved close to a singular position */
  if (check (s, r->iopt, s->t, s->x, no_jump) != 0)
    return ROUTINE;
  s->p[0] = job;
  if (inputs (s, s->t, 1, s->x, s->v) != 0)
    return ROUTINE;
  if ((info = singular_start (s)) != 0)
    return info;
  if (r->nlam > 0 && r->iopt[4] == 1 && r->iopt[1] != 1 && s->p[0] < 2 && s->p[2] < r->nlam)
    s->p[0] = 2;   /* dependent constraints: see METHOD of GSSIM */
  if (s->p[0] > 0)
    {
      ((pnw_type *)r->gspnw) (r->con, r->kin, &s->t, s->x, &r->nq, &r->nu, &r->nlam, r->cst, s->p,
                              &info);
      if (info != 0)
        {
          r->istat[5] = info;
          r->istat[6] = CON;
          return ROUTINE;
        }
    }
  r->istat[6] = 0;
  return samples (s, &acted);
}

/* a state, with the turns that were kept apart */
static void
turn_on (const gs_run *s, double *x)
{
  for (int l = 0; l < s->r->nq; l++)
    if (s->turns[l] != 0)
      x[l] += 2 * 3.14159265358979323846264338327950288L * s->turns[l];
}

/* the state X at the output time T: a column of the result */
static int
put_out (gs_run *s, double t, const double *x)
{
  const gsmbp_run *r = s->r;
  int k = r->istat[4];
  double *column = r->xout + (size_t) r->ldx * k;
  memcpy (column, x, sizeof (double) * r->nx);
  if (gs_projects (r) && check (s, s->project, t, column, no_jump) != 0)
    return ROUTINE;
  if (inputs (s, t, side_at (s, t), column, s->v) != 0)
    return ROUTINE;
  memcpy (r->vout + (size_t) r->ldv * k, s->v, sizeof (double) * r->nv);
  turn_on (s, column);
  r->istat[4] = k + 1;
  return FINISHED;
}

/* the output times that the run has passed; INFO */
static int
put_out_all (gs_run *s)
{
  const gsmbp_run *r = s->r;
  while (r->istat[4] < r->nt && r->tout[r->istat[4]] <= s->t)
    {
      double t = r->tout[r->istat[4]];
      if (t < s->t && s->by->between (s, t, s->between) < 0)
        return METHOD_FAILED;
      if (put_out (s, t, t < s->t ? s->between : s->x) != 0)
        return ROUTINE;
    }
  return FINISHED;
}

/* after a step: statistics, drift, the output times that it passed; INFO */
static int
accept (gs_run *s)
{
  const gsmbp_run *r = s->r;
  r->istat[1]++;
  r->istat[5] = r->istat[6] = 0;
  r->rstat[5] = fmin (r->rstat[5], s->h);
  r->rstat[6] = fmax (r->rstat[6], s->h);
  r->rstat[7] = s->t;
  r->rstat[8] = s->next;
  if (! all_finite (r->nx, s->y))
    return INFINITE;
  s->still = s->h <= 16 * DBL_EPSILON * fabs (s->t) ? s->still + 1 : 0;
  if (s->still >= 20)   /* a method might go on for ever */
    return SMALL;
  memcpy (s->x, s->y, sizeof (double) * r->nx);
  memcpy (s->trial, s->y, sizeof (double) * r->nx);
  if (r->nlam > 0 && (r->iopt[2] == 1 || s->p[0] > 0)
      && check (s, s->watch, s->t, s->trial, no_jump) != 0)
    return ROUTINE;
  return put_out_all (s);
}

/* does the scene switch where the run stands? Then its rates differ on both sides. */
static int
switched (gs_run *s)
{
  const int n = s->r->nx;
  double *left = s->work, *right = s->work + n;
  if (s->r->switches == 0)
    return 0;
  int info = gs_rate (s, s->stop, s->x, left);
  s->side = 1;
  info = info != 0 ? info : gs_rate (s, s->stop, s->x, right);
  s->side = -1;
  for (int k = 0; k < n && info == 0; k++)
    if (fabs (right[k] - left[k]) > 1e-11 * (fabs (right[k]) + fabs (left[k])))
      return 1;
  return info != 0;
}

/* do the inputs jump at the break where the run stands? A user's routine may do what it likes. */
static int
jumps (gs_run *s)
{
  const gsmbp_run *r = s->r;
  if (r->ip[GS_V0] == 3)
    return 1;
  if (inputs (s, s->t, -1, s->x, s->dv) != 0 || inputs (s, s->t, 1, s->x, s->v) != 0)
    return 1;   /* the next step will say what is wrong */
  for (int k = 0; k < r->nv; k++)
    if (! (fabs (s->v[k] - s->dv[k]) <= 1e-11 * (fabs (s->v[k]) + fabs (s->dv[k]))))
      return 1;
  return switched (s);
}

/* the flag of a method; INFO */
static int
failure (gs_run *s, int flag)
{
  s->r->istat[18] = flag;
  return s->r->istat[6] != 0     ? ROUTINE
         : flag == GS_TOO_SMALL  ? SMALL
         : flag == GS_NO_RATES   ? NO_RATES
         : flag == GS_NO_MEMORY  ? MEMORY
                                 : METHOD_FAILED;
}

/* from here to the next stop; INFO */
static int
advance (gs_run *s)
{
  const gsmbp_run *r = s->r;
  int flag, info;
  if (s->stop - s->t <= 16 * DBL_EPSILON * fmax (fabs (s->t), fabs (s->stop)))
    {
      s->t = s->stop;
      return put_out_all (s);
    }
  while (s->t < s->stop)
    {
      if (r->iopt[3] > 0 && r->istat[1] + r->istat[2] + s->by->rejected (s) >= r->iopt[3])
        return STEPS;
      if ((flag = s->by->step (s)) < 0)
        return failure (s, flag);
      if ((info = accept (s)) != 0)
        return info;
    }
  return FINISHED;
}

/* stop at T, a break or a sample, unless the stop is nearer; times that differ by rounding are one
 */
static void
next_stop (gs_run *s, double t)
{
  double fuzz = 8 * DBL_EPSILON * fabs (s->stop);
  if (t > s->stop + fuzz)
    return;
  if (t < s->stop - fuzz)
    s->stop = t;
}

static int
go (gs_run *s)
{
  const gsmbp_run *r = s->r;
  int ib = 0, acted, jumped, info, flag;
  double end = r->tout[r->nt - 1];
  if ((info = begin (s)) != 0)
    return info;
  s->side = 1;
  s->stop = end;
  if ((info = put_out_all (s)) != 0)
    return info;
  if ((flag = s->by->begin (s)) < 0)
    return failure (s, flag);
  while (r->istat[4] < r->nt)
    {
      while (ib < r->nb && r->tbrk[ib] <= s->t)
        ib++;
      s->stop = end;
      s->side = -1;
      next_stop (s, ib < r->nb ? r->tbrk[ib] : HUGE_VAL);
      next_stop (s, s->sample);
      info = advance (s);
      if (info != 0 || r->istat[4] >= r->nt)
        break;
      jumped = jumps (s);
      if ((info = samples (s, &acted)) != 0)
        break;
      if (jumped || acted)
        {
          s->by->count (s);
          if ((flag = s->by->restart (s)) < 0)
            return failure (s, flag);
        }
    }
  s->by->count (s);
  return info;
}

int
gs_implicit_run (const gsmbp_run *r, const gs_method *by)
{
  gs_run s = { 0 };
  int info = MEMORY;
  s.r = r;
  s.by = by;
  if (r->length > 0)
    r->text[0] = 0;
  if (allocate (&s))
    {
      info = go (&s);
      if (info != FINISHED && r->istat[4] < r->nt)   /* the last state, as GSSIM leaves it */
        {
          turn_on (&s, s.x);
          memcpy (r->xout + (size_t) r->ldx * r->istat[4], s.x, sizeof (double) * r->nx);
          memcpy (r->vout + (size_t) r->ldv * r->istat[4], s.v, sizeof (double) * r->nv);
        }
    }
  release (&s);
  return info;
}
