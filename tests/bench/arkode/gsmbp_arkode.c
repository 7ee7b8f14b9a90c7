/* Diagonally implicit Runge-Kutta methods, ARKStep of SUNDIALS's ARKODE, with the emitted Jacobian,
   as a method of implicit.c: a rival in `make bench-devices`.  Its order is the run's (2 to 5).

   Loops: the state is moved onto the constraints behind every step.  Output times lie between the
   steps, where ARKODE interpolates. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <arkode/arkode_arkstep.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include "host/cvode/sundials_calls.h"

typedef struct
{
  SUNContext context;
  N_Vector y, atol, dense;
  SUNMatrix matrix;
  SUNLinearSolver solver;
  void *memory;
} dirk;

static int
moved (sunrealtype t, N_Vector y, void *data)
{
  gs_stepper *s = data;
  int info = gs_moved (s, t, N_VGetArrayPointer (y), s->trial);
  memcpy (N_VGetArrayPointer (y), s->trial, sizeof (double) * s->r->nx);
  return info;
}

static int
open_ (gs_stepper *s)
{
  int nx = s->r->nx;
  dirk *b = s->memory = calloc (1, sizeof (dirk));
  if (! b || SUNContext_Create (SUN_COMM_NULL, &b->context) != 0)
    return 0;
  b->y = N_VNew_Serial (nx, b->context);
  b->dense = N_VNew_Serial (nx, b->context);
  b->atol = N_VNew_Serial (nx, b->context);
  b->matrix = SUNDenseMatrix (nx, nx, b->context);
  b->solver = SUNLinSol_Dense (b->y, b->matrix, b->context);
  return 1;
}

static void
close_ (gs_stepper *s)
{
  dirk *b = s->memory;
  if (b->memory)
    ARKStepFree (&b->memory);
  SUNLinSolFree (b->solver);
  SUNMatDestroy (b->matrix);
  N_VDestroy (b->y);
  N_VDestroy (b->dense);
  N_VDestroy (b->atol);
  SUNContext_Free (&b->context);
  free (b);
}

static int
hears (gs_stepper *s)
{
  dirk *b = s->memory;
#if SUNDIALS_VERSION_MAJOR == 6
  return ARKStepSetErrHandlerFn (b->memory, said, s);
#else
  return hear (b->context, s);
#endif
}

static int
begin (gs_stepper *s)
{
  const gs_integration *r = s->r;
  dirk *b = s->memory;
  int flag;
  memcpy (N_VGetArrayPointer (b->y), s->x, sizeof (double) * r->nx);
  memcpy (N_VGetArrayPointer (b->atol), r->atol, sizeof (double) * r->nx);
  void *m = b->memory = ARKStepCreate (NULL, rate, s->t, b->y, b->context);
  if ((flag = hears (s)) < 0 || (flag = ARKStepSetUserData (m, s)) < 0
      || (flag = ARKStepSVtolerances (m, r->ropt[1], b->atol)) < 0
      || (flag = ARKStepSetLinearSolver (m, b->solver, b->matrix)) < 0
      || (flag = ARKStepSetJacFn (m, jacobian)) < 0
      || (flag = ARKStepSetMaxNumSteps (m, -1)) < 0 || (flag = ARKStepSetMaxHnilWarns (m, -1)) < 0
      || (flag = ARKStepSetOrder (m, s->o->order)) < 0
      || (flag = ARKStepSetInitStep (m, r->ropt[0])) < 0
      || (flag = ARKStepSetMaxStep (m, r->ropt[2])) < 0)
    return flag;
  return gs_projects (s) ? ARKStepSetPostprocessStepFn (m, moved) : 0;
}

static int
restart (gs_stepper *s)
{
  dirk *b = s->memory;
  memcpy (N_VGetArrayPointer (b->y), s->x, sizeof (double) * s->r->nx);
  return ARKStepReset (b->memory, s->t, b->y);
}

static int
step (gs_stepper *s)
{
  dirk *b = s->memory;
  int flag = ARKStepSetStopTime (b->memory, s->stop);
  if (flag < 0 || (flag = ARKStepEvolve (b->memory, s->stop, b->y, &s->t, ARK_ONE_STEP)) < 0)
    return flag;
  s->y = N_VGetArrayPointer (b->y);
  ARKStepGetLastStep (b->memory, &s->h);
  ARKStepGetCurrentStep (b->memory, &s->next);
  return flag;
}

static int
between (gs_stepper *s, double t, double *x)
{
  dirk *b = s->memory;
  int flag = ARKStepGetDky (b->memory, t, 0, b->dense);
  memcpy (x, N_VGetArrayPointer (b->dense), sizeof (double) * s->r->nx);
  return flag;
}

static int
rejected (gs_stepper *s)
{
  long tests = 0;
  ARKStepGetNumErrTestFails (((dirk *) s->memory)->memory, &tests);
  return (int) tests;
}

static void
count (gs_stepper *s)
{
  (void) s;
}

int
gs_arkode (const gs_scene *scene, gs_integration *run, const gs_implicit *options)
{
  static const gs_method arkstep
    = { open_, close_, begin, restart, step, NULL /* no events */, between, rejected, count, 1, 0 };
  return gs_implicit_run (scene, run, options, &arkstep);
}
