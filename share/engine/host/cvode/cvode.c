/* BDF of variable order and step, CVODE of SUNDIALS, with the emitted Jacobian, as a method of
   implicit.c.

   Loops: the state is moved onto the constraints within every step (CVodeSetProjFn), before its
   error is tested.  Output times lie between the steps: there the state comes from the polynomial
   that BDF keeps. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_dense.h>
#include <sundials/sundials_linearsolver.h>
#include <sunmatrix/sunmatrix_dense.h>
#include "host/implicit/settle.h"
#include "sundials_calls.h"

typedef struct
{
  SUNContext context;
  N_Vector y, atol, dense;
  SUNMatrix matrix;
  SUNLinearSolver solver;
  sunindextype *pivots;
  void *memory;
  gs_stepper *run;
  gs_loops *loops;              /* null: there are none */
  double gamma, *scale;         /* the factors are those of I - GAMMA*J; of errors */
  int settles;                  /* are the constraints known where J is of? */
} bdf;

/* ------------------------------------------------------------
 * what CVODE calls; a positive result: it tries a smaller step */

static void
solve_own (const void *of, double *x)
{
  const bdf *b = of;
  const sunindextype own = SUNDenseMatrix_Rows (b->matrix);
  SUNDlsMat_denseGETRS (SUNDenseMatrix_Cols (b->matrix), own, b->pivots, x);
  for (sunindextype i = 0; i < own; i++)
    x[i] *= b->gamma;
}

/* X along what the scene does under forces of its constraints; as gs_settle */
static int
settle (gs_stepper *s, double t, double *x)
{
  bdf *b = s->memory;
  gs_factors by = { .shift = 1 / b->gamma, .solve = solve_own, .of = b };
  if (! b->settles || gs_completes (s))
    return -1;
  for (int i = 0; i < s->r->nx; i++)
    b->scale[i] = 1 / (s->r->atol[i] + s->r->ropt[1] * fabs (x[i]));
  return gs_settle (s, b->loops, &by, b->scale, t, x);
}

static int
projection (sunrealtype t, N_Vector y, N_Vector correction, sunrealtype eps, N_Vector err,
            void *data)
{
  gs_stepper *s = data;
  const double *x = N_VGetArrayPointer (y);
  double *c = N_VGetArrayPointer (correction);
  (void) eps, (void) err;
  gs_copy (s->r->nx, x, c);
  int left = gs_projects (s) ? settle (s, t, c) : 0, info = 0;
  if (left != 0)
    info = gs_moved (s, t, left > 0 ? c : x, s->trial);
  if (left != 0)
    gs_copy (s->r->nx, s->trial, c);
  if (info == 0)
    gs_onto_held (s, t, c);
  for (int i = 0; info == 0 && i < s->r->nx; i++)
    c[i] -= x[i];
  return info;
}

/* The linear solver: one dense matrix for the states and for every column of derivatives. */
static SUNLinearSolver_Type
direct (SUNLinearSolver solver)
{
  (void) solver;
  return SUNLINEARSOLVER_DIRECT;
}

static int
factorize (SUNLinearSolver solver, SUNMatrix A)
{
  bdf *b = solver->content;
  b->settles = b->loops && CVodeGetCurrentGamma (b->memory, &b->gamma) == 0
               && gs_take_loops (b->run, b->loops) == 0;
  return SUNDlsMat_denseGETRF (SUNDenseMatrix_Cols (A), SUNDenseMatrix_Rows (A),
                               SUNDenseMatrix_Columns (A), b->pivots) > 0;
}

static int
solve (SUNLinearSolver solver, SUNMatrix A, N_Vector x, N_Vector given, sunrealtype tolerance)
{
  bdf *b = solver->content;
  const sunindextype own = SUNDenseMatrix_Rows (A), n = N_VGetLength (x);
  (void) tolerance;
  N_VScale (1, given, x);
  for (sunindextype i = 0; i < n; i += own)
    SUNDlsMat_denseGETRS (SUNDenseMatrix_Cols (A), own, b->pivots, N_VGetArrayPointer (x) + i);
  return 0;
}

/* ------------------------------------------------------------
 * the method */

static int
open_ (gs_stepper *s)
{
  int nx = s->r->nx, own = gs_own_states (s);
  bdf *b = s->memory = gs_allocate (1, sizeof (bdf));
  if (! b || SUNContext_Create (SUN_COMM_NULL, &b->context) != 0)
    return 0;
  b->y = N_VNew_Serial (nx, b->context);
  b->dense = N_VNew_Serial (nx, b->context);
  b->atol = N_VNew_Serial (nx, b->context);
  b->matrix = SUNDenseMatrix (own, own, b->context);
  b->memory = CVodeCreate (CV_BDF, b->context);
  if (! b->y || ! b->dense || ! b->atol || ! b->matrix || ! b->memory)
    return 0;
  b->pivots = gs_allocate (own, sizeof (sunindextype));
  b->scale = gs_allocate (nx, sizeof (double));
  b->solver = SUNLinSolNewEmpty (b->context);
  if (! b->solver || ! b->pivots || ! b->scale)
    return 0;
  int failed;
  b->run = s;
  b->loops = gs_new_loops (s, &failed);
  if (failed)
    return 0;
  b->solver->content = b;
  b->solver->ops->gettype = direct;
  b->solver->ops->setup = factorize;
  b->solver->ops->solve = solve;
  return 1;
}

static void
close_ (gs_stepper *s)
{
  bdf *b = s->memory;
  if (! b)
    return;
  if (b->memory)
    CVodeFree (&b->memory);
  if (b->solver)
    SUNLinSolFreeEmpty (b->solver);
  free (b->pivots);
  free (b->scale);
  gs_free_loops (b->loops);
  if (b->matrix)
    SUNMatDestroy (b->matrix);
  N_VDestroy (b->y);
  N_VDestroy (b->dense);
  N_VDestroy (b->atol);
  if (b->context)
    SUNContext_Free (&b->context);
  free (b);
}

static int
hears (gs_stepper *s)
{
  bdf *b = s->memory;
#if SUNDIALS_VERSION_MAJOR == 6
  return CVodeSetErrHandlerFn (b->memory, said, s);
#else
  return hear (b->context, s);
#endif
}

/* What CVODE is told of the tolerances.  Its error test is one of a step: over a run, and in the
   steps of low order after every start, errors of BDF add up to some 100 times what is asked for,
   those of gs_step_dp853 do not. */
static const double tight = 0.1, finest = 1e-14;

static int
begin (gs_stepper *s)
{
  gs_integration *r = s->r;
  bdf *b = s->memory;
  void *m = b->memory;
  double rtol = fmax (tight * r->ropt[1], fmin (finest, r->ropt[1]));
  int flag;
  gs_copy (r->nx, s->x, N_VGetArrayPointer (b->y));
  for (int i = 0; i < r->nx; i++)
    N_VGetArrayPointer (b->atol)[i] = rtol / r->ropt[1] * r->atol[i];
  if ((flag = hears (s)) < 0 || (flag = CVodeInit (m, rate, s->t, b->y)) < 0
      || (flag = CVodeSetUserData (m, s)) < 0 || (flag = CVodeSVtolerances (m, rtol, b->atol)) < 0
      || (flag = CVodeSetLinearSolver (m, b->solver, b->matrix)) < 0
      || (flag = CVodeSetMaxNumSteps (m, -1)) < 0 || (flag = CVodeSetMaxHnilWarns (m, -1)) < 0
      || (flag = CVodeSetInitStep (m, s->o->resume ? 0 : r->ropt[0])) < 0
      || (flag = CVodeSetMaxStep (m, r->ropt[2])) < 0
      || (flag = CVodeSetMaxOrd (m, s->o->order)) < 0)
    return flag;
  if ((flag = CVodeSetJacFn (m, jacobian)) < 0)
    return flag;
  if ((gs_projects (s) || gs_has_ports (s))
      && ((flag = CVodeSetProjFn (m, projection)) < 0
          || (flag = CVodeSetProjErrEst (m, SUNFALSE)) < 0))
    return flag;
  return 0;
}

static int
restart (gs_stepper *s)
{
  bdf *b = s->memory;
  int flag;
  gs_copy (s->r->nx, s->x, N_VGetArrayPointer (b->y));
  return (flag = CVodeReInit (b->memory, s->t, b->y)) < 0 ? flag
                                                           : CVodeSetInitStep (b->memory, 0);
}

static int
step (gs_stepper *s)
{
  bdf *b = s->memory;
  int flag = CVodeSetStopTime (b->memory, s->stop);
  if (flag < 0 || (flag = CVode (b->memory, s->stop, b->y, &s->t, CV_ONE_STEP)) < 0)
    return flag == CV_MEM_FAIL ? GS_NO_MEMORY : flag;
  s->y = N_VGetArrayPointer (b->y);
  CVodeGetLastStep (b->memory, &s->h);
  CVodeGetCurrentStep (b->memory, &s->next);
  return flag;
}

/* from the state of the run */
static int
again (gs_stepper *s)
{
  int flag = restart (s);
  return flag < 0 ? flag : step (s);
}

static int
between (gs_stepper *s, double t, double *x)
{
  bdf *b = s->memory;
  int flag = CVodeGetDky (b->memory, t, 0, b->dense);
  gs_copy (s->r->nx, N_VGetArrayPointer (b->dense), x);
  return flag;
}

/* one of its counts */
static int
counted (int (*count_of) (void *, long *), void *memory)
{
  long n = 0;
  count_of (memory, &n);
  return (int) n;
}

static int
rejected (gs_stepper *s)
{
  return counted (CVodeGetNumErrTestFails, ((bdf *) s->memory)->memory);
}

/* CVODE forgets its counts when it starts again */
static void
count (gs_stepper *s)
{
  int *istat = s->r->istat;
  void *m = ((bdf *) s->memory)->memory;
  const int projections = gs_projects (s) ? counted (CVodeGetNumProjFails, m) : 0,
            diverged = counted (CVodeGetNumNonlinSolvConvFails, m);
  istat[GS_N_REJECTED] += rejected (s) + diverged + projections;
  istat[GS_N_REPEATED] += projections;
  istat[GS_N_JACOBIANS] += counted (CVodeGetNumJacEvals, m);
  istat[GS_N_NEWTON] += counted (CVodeGetNumNonlinSolvIters, m);
  istat[GS_N_DIVERGED] += diverged;
}

int
gs_cvode (const gs_scene *scene, gs_integration *run, const gs_implicit *options)
{
  static const gs_method bdf_
    = { open_, close_, begin, restart, step, again, between, 0, rejected, count, 1, 0, 0 };
  return gs_implicit_run (scene, run, options, &bdf_);
}
