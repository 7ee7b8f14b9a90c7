/* What integrators of SUNDIALS call: the emitted rates and Jacobian; a positive result: they try a
   smaller step.  Their own words instead of a print on the terminal. */
#ifndef GS_HOST_SUNDIALS_CALLS_H
#define GS_HOST_SUNDIALS_CALLS_H
#include <stdio.h>
#include "header_cvode.h"
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>
#include "host/implicit/implicit_run.h"

static int
rate (sunrealtype t, N_Vector y, N_Vector yd, void *data)
{
  return gs_rate (data, t, N_VGetArrayPointer (y), N_VGetArrayPointer (yd));
}

static int
jacobian (sunrealtype t, N_Vector y, N_Vector yd, SUNMatrix J, void *data, N_Vector t1, N_Vector t2,
          N_Vector t3)
{
  (void) yd, (void) t1, (void) t2, (void) t3;
  return gs_jacobian (data, t, N_VGetArrayPointer (y), SUNDenseMatrix_Data (J));
}

static void
keep (int code, const char *message, void *data)
{
  const gs_implicit *o = ((gs_stepper *) data)->o;
  if (code < 0 && o->length > 0)
    snprintf (o->text, o->length, "%s", message);
}

#if SUNDIALS_VERSION_MAJOR == 6
static void
said (int code, const char *module, const char *function, char *message, void *data)
{
  (void) module, (void) function;
  keep (code, message, data);
}
#else
static void
said (int line, const char *function, const char *file, const char *message, SUNErrCode code,
      void *data, SUNContext context)
{
  (void) line, (void) function, (void) file, (void) context;
  keep (code, message, data);
}

/* in the place of every handler that the method has */
static int
hear (SUNContext context, gs_stepper *s)
{
  SUNContext_ClearErrHandlers (context);
  return SUNContext_PushErrHandler (context, said, s);
}
#endif
#endif
