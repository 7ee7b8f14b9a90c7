/* calls3.h: the calls of drive.c in FMI 3.0. */
#include "fmi3Functions.h"

typedef fmi3Boolean truth;

static void
logger (fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category,
        fmi3String text)
{
  logged ((int)status, text);
  (void)environment;
  (void)category;
}

static void *
make (int kind, const char *token)
{
  if (kind)
    return fmi3InstantiateCoSimulation ("one", token, "", 0, 0, 0, 0, NULL, 0, NULL, logger, NULL);
  return fmi3InstantiateModelExchange ("one", token, "", 0, 0, NULL, logger);
}

#define FREE fmi3FreeInstance
#define ENTER(c, t0, t1) fmi3EnterInitializationMode (c, 1, 1e-8, t0, 1, t1)
#define EXIT fmi3ExitInitializationMode
#define GET(c, r, n, v) fmi3GetFloat64 (c, r, n, v, n)
#define SET(c, r, n, v) fmi3SetFloat64 (c, r, n, v, n)
#define TERMINATE fmi3Terminate
#define RESET fmi3Reset
#define SAVE fmi3GetFMUState
#define LOAD fmi3SetFMUState
#define DROP fmi3FreeFMUState
#define SIZE fmi3SerializedFMUStateSize
#define WRITE(c, s, b, n) fmi3SerializeFMUState (c, s, (fmi3Byte *)(b), n)
#define READ(c, b, n, s) fmi3DeserializeFMUState (c, (const fmi3Byte *)(b), n, s)
#define DERIVATIVE(c, u, nu, k, nk, s, d) \
  fmi3GetDirectionalDerivative (c, u, nu, k, nk, s, nk, d, nu)
#define EVENTS fmi3EnterEventMode
#define CONTINUE fmi3EnterContinuousTimeMode
#define TIME fmi3SetTime
#define COMPLETED(c, e, t) fmi3CompletedIntegratorStep (c, 1, e, t)
#define PUT fmi3SetContinuousStates
#define STATES fmi3GetContinuousStates
#define NOMINALS fmi3GetNominalsOfContinuousStates
#define RATES fmi3GetContinuousStateDerivatives
#define INDICATORS fmi3GetEventIndicators

static int
STEP (void *c, double t, double h)
{
  fmi3Boolean event, terminate, early;
  double last;
  return fmi3DoStep (c, t, h, 1, &event, &terminate, &early, &last);
}

/* the next event time in next; 1e300: none */
static int
update (void *c, double *next)
{
  fmi3Boolean again, terminate, nominals, values, defined;
  int status = fmi3UpdateDiscreteStates (c, &again, &terminate, &nominals, &values, &defined, next);
  if (status > fmi3Warning || ! defined)
    *next = 1e300;
  return status;
}

/* functions that the others do not need, called as an importer should not */
static int
other (void *c, int k, const unsigned *r, double *x)
{
  switch (k % 8)
    {
    case 0:
      return fmi3GetInt32 (c, r, 1, (fmi3Int32 *)x, 1);
    case 1:
      return fmi3SetBoolean (c, NULL, 1, NULL, 0);
    case 2:
      return fmi3GetFloat64 (c, r, 1, x, 2);
    case 3:
      return fmi3GetClock (c, r, 1, NULL);
    case 4:
      return fmi3UpdateDiscreteStates (c, NULL, NULL, NULL, NULL, NULL, NULL);
    case 5:
      return fmi3GetFloat64 (c, NULL, 3, x, 3);
    case 6:
      return fmi3GetFMUState (c, NULL);
    default:
      return fmi3EnterStepMode (c);
    }
}
