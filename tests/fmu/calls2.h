/* calls2.h: the calls of drive.c in FMI 2.0. */
#include "fmi2Functions.h"

typedef fmi2Boolean truth;

static void
logger (void *environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String text,
        ...)
{
  va_list more;
  char line[500];
  va_start (more, text);
  vsnprintf (line, sizeof line, text, more);
  va_end (more);
  logged ((int)status, line);
  (void)environment;
  (void)name;
  (void)category;
}

static void *
make (int kind, const char *token)
{
  static const fmi2CallbackFunctions back = { logger, calloc, free, NULL, NULL };
  return fmi2Instantiate ("one", kind ? fmi2CoSimulation : fmi2ModelExchange, token, "", &back, 0,
                          0);
}

#define FREE fmi2FreeInstance
#define ENTER(c, t0, t1) (fmi2SetupExperiment (c, 1, 1e-8, t0, 1, t1) > fmi2Warning\
                            ? fmi2Error : fmi2EnterInitializationMode (c))
#define EXIT fmi2ExitInitializationMode
#define GET(c, r, n, v) fmi2GetReal (c, r, n, v)
#define SET(c, r, n, v) fmi2SetReal (c, r, n, v)
#define TERMINATE fmi2Terminate
#define RESET fmi2Reset
#define SAVE fmi2GetFMUstate
#define LOAD fmi2SetFMUstate
#define DROP fmi2FreeFMUstate
#define SIZE fmi2SerializedFMUstateSize
#define WRITE fmi2SerializeFMUstate
#define READ fmi2DeSerializeFMUstate
#define DERIVATIVE(c, u, nu, k, nk, s, d) fmi2GetDirectionalDerivative (c, u, nu, k, nk, s, d)
#define EVENTS fmi2EnterEventMode
#define CONTINUE fmi2EnterContinuousTimeMode
#define TIME fmi2SetTime
#define COMPLETED(c, e, t) fmi2CompletedIntegratorStep (c, 1, e, t)
#define PUT fmi2SetContinuousStates
#define STATES fmi2GetContinuousStates
#define NOMINALS fmi2GetNominalsOfContinuousStates
#define RATES fmi2GetDerivatives
#define INDICATORS fmi2GetEventIndicators
#define STEP(c, t, h) fmi2DoStep (c, t, h, 1)

/* the next event time in next; 1e300: none */
static int
update (void *c, double *next)
{
  fmi2EventInfo info;
  int status = fmi2NewDiscreteStates (c, &info);
  *next = status <= fmi2Warning && info.nextEventTimeDefined ? info.nextEventTime : 1e300;
  return status;
}

/* functions that the others do not need, called as an importer should not */
static int
other (void *c, int k, const unsigned *r, double *x)
{
  switch (k % 8)
    {
    case 0:
      return fmi2GetInteger (c, r, 1, (fmi2Integer *)x);
    case 1:
      return fmi2SetBoolean (c, NULL, 1, NULL);
    case 2:
      return fmi2SetRealInputDerivatives (c, r, 1, NULL, x);
    case 3:
      return fmi2CancelStep (c);
    case 4:
      return fmi2NewDiscreteStates (c, NULL);
    case 5:
      return fmi2GetReal (c, NULL, 3, x);
    case 6:
      return fmi2GetFMUstate (c, NULL);
    default:
      return fmi2CompletedIntegratorStep (c, 1, NULL, NULL);
    }
}
