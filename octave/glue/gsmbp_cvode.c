/* Stiff scenes: the run of GSSIM (stops at breaks, inputs, loops, statistics; the same routines of
   share/fortran), integrated by BDF of variable order and step, CVODE of SUNDIALS, with the emitted
   Jacobian.

   Loops: the state is moved onto the constraints within every step (CVodeSetProjFn), before its
   error is tested. Output times lie between the steps: there the state comes from the polynomial
   that BDF keeps and is moved onto the constraints as well. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include "gsmbp_cvode.h"
#include "gsmbp/inputs.h"

#if SUNDIALS_VERSION_MAJOR != 6
# error "gsmbp_cvode.c is written for SUNDIALS 6 (Debian 12: libsundials-dev)"
#endif

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

enum { INPUTS = 1, RHS, PRJ, CON, PARTITION, BEGINNING = 8 };   /* ISTAT(7) */
enum { FINISHED, STEPS, SMALL, ROUTINE, INFINITE, CVODE_FAILED = 6, MEMORY };   /* INFO */

typedef struct
{
  const gsmbp_run *r;
  int side;              /* the limits of the inputs at STOP, a break, a sample or the end */
  double stop, sample;   /* ... and the next sample */
  int still;             /* steps in succession that hardly move the time */
  double t;              /* the last step's end, and the state there */
  double *x, *trial, *v, *p, *b, *c, *d, *dv;
  int *project,
      *watch; /* IOPT for GSCHK: to move a state onto the constraints; to look after what is left */
  SUNContext context;
  N_Vector y, atol, dense;
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void *memory;
} run;

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
side_at (const run *s, double t)
{
  return s->side < 0 && t >= s->stop ? -1 : 1;
}

/* the inputs at T into V; INFO of GSINP */
static int
inputs (run *s, double t, int side, const double *x, double *v)
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
check (run *s, const int *options, double t, double *x, const double *jump)
{
  const gsmbp_run *r = s->r;
  int info = 0;
  ((chk_type *)r->gschk) (r->prj, r->con, r->kin, &t, x, &r->nq, &r->nu, &r->nx, &r->nlam, options,
                          jump, r->cst, s->p, r->istat, r->rstat, &info);
  return info;
}

/* ------------------------------------------------------------
 * what CVODE calls */

/* A positive result: CVODE tries a smaller step. */
static int
outcome (int info)
{
  return info < 0 ? -1 : info > 0;
}

static int
rate (realtype t, N_Vector y, N_Vector yd, void *data)
{
  run *s = data;
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), info = 0;
  double *xd = N_VGetArrayPointer (yd);
  memcpy (s->trial, N_VGetArrayPointer (y), sizeof (double) * r->nx);   /* GSFUN may complete it */
  ((fun_type *)r->gsfun) (r->rhs, r->con, r->kin, r->cmd, r->clo, r->vin, &t, &side, s->trial,
                          &r->nq, &r->nu, &r->nx, &r->nv, &r->nlam, r->ip, r->rp, r->cst, s->v, xd,
                          r->w, s->p, r->istat, r->rstat, &info);
  return info != 0 ? outcome (info) : ! all_finite (r->nx, xd);
}

/* A += B dV/dX: the inputs follow the state by a gain or by the user's routine; by differences,
 * exact for a gain */
static int
add_feedback (run *s, double t, double *x, double *A)
{
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), n = r->nx;
  for (int j = 0; j < n; j++)
    {
      double old = x[j], h = (s->r->ip[GS_V0] == 3 ? 1e-7 : 1)
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

static int
jacobian (realtype t, N_Vector y, N_Vector yd, SUNMatrix J, void *data, N_Vector t1, N_Vector t2,
          N_Vector t3)
{
  run *s = data;
  const gsmbp_run *r = s->r;
  int side = side_at (s, t), ldy = r->ny > 0 ? r->ny : 1, info = 0;
  double *A = SUNDenseMatrix_Data (J);
  (void) yd, (void) t1, (void) t2, (void) t3;
  memcpy (s->trial, N_VGetArrayPointer (y), sizeof (double) * r->nx);
  if ((r->ip[GS_V0] != 0 || r->ip[GS_FEEDBACK] != 0)
      && (info = inputs (s, t, side, s->trial, s->v)) != 0)
    return outcome (info);
  ((jac_type *)r->jac) (&t, s->trial, s->v, r->cst, A, &r->nx, s->b, &r->nx, s->c, &ldy, s->d, &ldy,
                        &info);
  if (info != 0 && info != 2
      && info != 3) /* lost rank, a singularity of angles: usable, as with RHS */
    return outcome (info);
  if (r->nv > 0 && (r->ip[GS_V0] == 3 || r->ip[GS_FEEDBACK] == 1)
      && (info = add_feedback (s, t, s->trial, A)) != 0)
    return info;
  return ! all_finite (r->nx * r->nx, A);
}

/* ... and no jump to another branch, as GSSIM */
static int
projection (realtype t, N_Vector y, N_Vector correction, realtype eps, N_Vector err, void *data)
{
  run *s = data;
  const gsmbp_run *r = s->r;
  const double *x = N_VGetArrayPointer (y);
  double *c = N_VGetArrayPointer (correction), jump[3];
  (void) eps, (void) err;
  ((jmp_type *) r->gsjmp) (&r->nq, &r->nu, s->x, x, &r->ropt[1], r->atol, jump);
  jump[2] = 0;
  memcpy (s->trial, x, sizeof (double) * r->nx);
  int info = check (s, s->project, t, s->trial, jump);
  if (info != 0)
    return outcome (info);
  for (int i = 0; i < r->nx; i++)
    c[i] = s->trial[i] - x[i];
  return 0;
}

/* CVODE's own words instead of a print on the terminal */
static void
said (int code, const char *module, const char *function, char *message, void *data)
{
  const gsmbp_run *r = ((run *) data)->r;
  (void) module, (void) function;
  if (code < 0 && r->length > 0)
    snprintf (r->text, r->length, "%s", message);
}

/* ------------------------------------------------------------
 * the run */

static int
allocate (run *s)
{
  const gsmbp_run *r = s->r;
  size_t nx = r->nx, nv = r->nv + 1, ny = r->ny + 1,
         np = 24 + 8 * r->nu + 10 * r->nq + 7 * r->nlam + 2 * r->nlam * r->nu;
  int n = 6 + r->iopt[5];
  s->x = calloc (2 * nx + 2 * nv + np + nx * nv + ny * nx + ny * nv, sizeof (double));
  s->project = calloc (2 * n, sizeof (int));
  if (! s->x || ! s->project || SUNContext_Create (NULL, &s->context) != 0)
    return 0;
  s->trial = s->x + nx;
  s->v = s->trial + nx;
  s->dv = s->v + nv;
  s->p = s->dv + nv;
  s->b = s->p + np;
  s->c = s->b + nx * nv;
  s->d = s->c + ny * nx;
  s->watch = s->project + n;
  memcpy (s->project, r->iopt, n * sizeof (int));
  memcpy (s->watch, r->iopt, n * sizeof (int));
  s->project[1] = 2;
  s->project[2] = 0;
  s->watch[1] = s->watch[2] = 1;
  s->watch[0] = 4;   /* as method 4: steps are not steered by singular positions */
  s->y = N_VNew_Serial (nx, s->context);
  s->dense = N_VNew_Serial (nx, s->context);
  s->atol = N_VNew_Serial (nx, s->context);
  s->matrix = SUNDenseMatrix (nx, nx, s->context);
  s->memory = CVodeCreate (CV_BDF, s->context);
  if (! s->y || ! s->dense || ! s->atol || ! s->matrix || ! s->memory)
    return 0;
  s->solver = SUNLinSol_Dense (s->y, s->matrix, s->context);
  return s->solver != NULL;
}

static void
release (run *s)
{
  if (s->memory)
    CVodeFree (&s->memory);
  if (s->solver)
    SUNLinSolFree (s->solver);
  if (s->matrix)
    SUNMatDestroy (s->matrix);
  N_VDestroy (s->y);
  N_VDestroy (s->dense);
  N_VDestroy (s->atol);
  if (s->context)
    SUNContext_Free (&s->context);
  free (s->x);
  free (s->project);
}

/* is the state moved onto constraints (or Euler parameters onto their sphere)? */
static int
projects (const gsmbp_run *r)
{
  return r->iopt[1] != 1 && (r->nlam > 0 || r->nq > r->nu);
}

/* What CVODE is told of the tolerances.  Its error test is one of a step: over a run, and in the
   steps of low order after every start, errors of BDF add up to some 100 times what is asked for,
   those of GSDP8 do not. */
static const double tight = 0.1, finest = 1e-14;

/* CVODE at the time and state of the run; its flag */
static int
set_up (run *s)
{
  const gsmbp_run *r = s->r;
  void *m = s->memory;
  double rtol = fmax (tight * r->ropt[1], fmin (finest, r->ropt[1]));
  int flag;
  memcpy (N_VGetArrayPointer (s->y), s->x, sizeof (double) * r->nx);
  for (int i = 0; i < r->nx; i++)
    N_VGetArrayPointer (s->atol)[i] = rtol / r->ropt[1] * r->atol[i];
  if ((flag = CVodeSetErrHandlerFn (m, said, s)) < 0 || (flag = CVodeInit (m, rate, s->t, s->y)) < 0
      || (flag = CVodeSetUserData (m, s)) < 0 || (flag = CVodeSVtolerances (m, rtol, s->atol)) < 0
      || (flag = CVodeSetLinearSolver (m, s->solver, s->matrix)) < 0
      || (flag = CVodeSetMaxNumSteps (m, -1)) < 0 || (flag = CVodeSetMaxHnilWarns (m, -1)) < 0
      || (flag = CVodeSetInitStep (m, r->resume ? 0 : r->ropt[0])) < 0
      || (flag = CVodeSetMaxStep (m, r->ropt[2])) < 0 || (flag = CVodeSetMaxOrd (m, r->order)) < 0)
    return flag;
  /* the Jacobian of states that GSFUN completes is not the emitted one */
  if (r->jac && s->p[0] == 0 && (flag = CVodeSetJacFn (m, jacobian)) < 0)
    return flag;
  if (projects (r)
      && ((flag = CVodeSetProjFn (m, projection)) < 0
          || (flag = CVodeSetProjErrEst (m, SUNFALSE)) < 0))
    return flag;
  return 0;
}

/* the sampled devices; ACTED: did any? INFO */
static int
samples (run *s, int *acted)
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
start (run *s)
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
singular_start (run *s)
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
begin (run *s)
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

/* the state X at the output time T: a column of the result */
static int
put_out (run *s, double t, const double *x)
{
  const gsmbp_run *r = s->r;
  int k = r->istat[4];
  double *column = r->xout + (size_t) r->ldx * k;
  memcpy (column, x, sizeof (double) * r->nx);
  if (projects (r) && check (s, s->project, t, column, no_jump) != 0)
    return ROUTINE;
  if (inputs (s, t, side_at (s, t), column, s->v) != 0)
    return ROUTINE;
  memcpy (r->vout + (size_t) r->ldv * k, s->v, sizeof (double) * r->nv);
  r->istat[4] = k + 1;
  return FINISHED;
}

/* the output times that the run has passed; INFO */
static int
put_out_all (run *s)
{
  const gsmbp_run *r = s->r;
  while (r->istat[4] < r->nt && r->tout[r->istat[4]] <= s->t)
    {
      double t = r->tout[r->istat[4]];
      if (t < s->t && CVodeGetDky (s->memory, t, 0, s->dense) < 0)
        return CVODE_FAILED;
      if (put_out (s, t, t < s->t ? N_VGetArrayPointer (s->dense) : s->x) != 0)
        return ROUTINE;
    }
  return FINISHED;
}

/* CVODE forgets its counts when it starts again */
static void
count (run *s)
{
  long n = 0, failed = 0, jacobians = 0, newton = 0, diverged = 0, projections = 0;
  CVodeGetNumErrTestFails (s->memory, &failed);
  CVodeGetNumJacEvals (s->memory, &jacobians);
  CVodeGetNumNonlinSolvIters (s->memory, &newton);
  CVodeGetNumNonlinSolvConvFails (s->memory, &diverged);
  if (projects (s->r))
    CVodeGetNumProjFails (s->memory, &projections);
  n = failed + diverged + projections;
  s->r->istat[2] += n;
  s->r->istat[11] += projections;
  s->r->istat[15] += jacobians;
  s->r->istat[16] += newton;
  s->r->istat[17] += diverged;
}

/* after a step: statistics, drift, the output times that it passed; INFO */
static int
accept (run *s)
{
  const gsmbp_run *r = s->r;
  const double *y = N_VGetArrayPointer (s->y);
  double h = 0, next = 0;
  CVodeGetLastStep (s->memory, &h);
  CVodeGetCurrentStep (s->memory, &next);
  r->istat[1]++;
  r->istat[5] = r->istat[6] = 0;
  r->rstat[5] = fmin (r->rstat[5], h);
  r->rstat[6] = fmax (r->rstat[6], h);
  r->rstat[7] = s->t;
  r->rstat[8] = next;
  if (! all_finite (r->nx, y))
    return INFINITE;
  s->still = h <= 16 * DBL_EPSILON * fabs (s->t) ? s->still + 1 : 0;
  if (s->still >= 20)   /* CVODE itself would go on for ever */
    return SMALL;
  memcpy (s->x, y, sizeof (double) * r->nx);
  memcpy (s->trial, y, sizeof (double) * r->nx);
  if (r->nlam > 0 && (r->iopt[2] == 1 || s->p[0] > 0)
      && check (s, s->watch, s->t, s->trial, no_jump) != 0)
    return ROUTINE;
  return put_out_all (s);
}

/* do the inputs jump at the break where the run stands? A user's routine may do what it likes. */
static int
jumps (run *s)
{
  const gsmbp_run *r = s->r;
  if (r->ip[GS_V0] == 3)
    return 1;
  if (inputs (s, s->t, -1, s->x, s->dv) != 0 || inputs (s, s->t, 1, s->x, s->v) != 0)
    return 1;   /* the next step will say what is wrong */
  for (int k = 0; k < r->nv; k++)
    if (! (fabs (s->v[k] - s->dv[k]) <= 1e-11 * (fabs (s->v[k]) + fabs (s->dv[k]))))
      return 1;
  return 0;
}

/* from here to the next stop; INFO */
static int
advance (run *s)
{
  const gsmbp_run *r = s->r;
  int flag, info;
  if (s->stop - s->t <= 16 * DBL_EPSILON * fmax (fabs (s->t), fabs (s->stop)))
    {
      s->t = s->stop;
      return put_out_all (s);
    }
  if ((flag = CVodeSetStopTime (s->memory, s->stop)) < 0)
    goto failed;
  while (s->t < s->stop)
    {
      long error_tests = 0;
      CVodeGetNumErrTestFails (s->memory, &error_tests);
      if (r->iopt[3] > 0 && r->istat[1] + r->istat[2] + error_tests >= r->iopt[3])
        return STEPS;
      flag = CVode (s->memory, s->stop, s->y, &s->t, CV_ONE_STEP);
      if (flag < 0)
        goto failed;
      if ((info = accept (s)) != 0)
        return info;
    }
  return FINISHED;

failed:
  r->istat[18] = flag;
  return flag == CV_MEM_FAIL ? MEMORY : r->istat[6] != 0 ? ROUTINE : CVODE_FAILED;
}

/* stop at T, a break or a sample, unless the stop is nearer; times that differ by rounding are one
 */
static void
next_stop (run *s, double t)
{
  double fuzz = 8 * DBL_EPSILON * fabs (s->stop);
  if (t > s->stop + fuzz)
    return;
  if (t < s->stop - fuzz)
    s->stop = t;
}

static int
go (run *s)
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
  if ((flag = set_up (s)) < 0)
    {
      r->istat[18] = flag;
      return CVODE_FAILED;
    }
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
          count (s);
          memcpy (N_VGetArrayPointer (s->y), s->x, sizeof (double) * r->nx);
          if ((flag = CVodeReInit (s->memory, s->t, s->y)) < 0
              || (flag = CVodeSetInitStep (s->memory, 0)) < 0)
            {
              r->istat[18] = flag;
              return CVODE_FAILED;
            }
        }
    }
  count (s);
  return info;
}

int
gsmbp_cvode (const gsmbp_run *r)
{
  run s = { 0 };
  int info = MEMORY;
  s.r = r;
  if (r->length > 0)
    r->text[0] = 0;
  if (allocate (&s))
    {
      info = go (&s);
      if (info != FINISHED && r->istat[4] < r->nt)   /* the last state, as GSSIM leaves it */
        {
          memcpy (r->xout + (size_t) r->ldx * r->istat[4], s.x, sizeof (double) * r->nx);
          memcpy (r->vout + (size_t) r->ldv * r->istat[4], s.v, sizeof (double) * r->nv);
        }
    }
  release (&s);
  return info;
}
