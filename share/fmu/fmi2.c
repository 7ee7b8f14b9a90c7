/* fmi2.c: the functions of FMI 2.0, model exchange and co-simulation. */
#include "fmi2Functions.h"
#include "fmu.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct
{
  gsf_instance *a;
  fmi2CallbackFunctions back;
  char *name;
} instance;

/* a status of this folder as one of the standard; its sentence is logged */
static fmi2Status
tell (const instance *c, int status)
{
  static const fmi2Status all[] = { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error };
  if (status != GSF_OK && c->back.logger)
    c->back.logger (c->back.componentEnvironment, c->name, all[status], gsf_category[status], "%s",
                    c->a->text);
  return all[status];
}

enum { EXCHANGE = 1 << GSF_EXCHANGE, COSIMULATION = 1 << GSF_COSIMULATION, BOTH = 3 };

/* the instance c; the function ends with an error where it is null or not allowed here */
#define ENTER(kinds, phases)                                                                       \
  instance *c = component;                                                                         \
  if (! c)                                                                                         \
    return fmi2Error;                                                                              \
  if (gsf_allowed (c->a, __func__, kinds, phases))                                                 \
    return tell (c, GSF_ERROR)
#define NEED(n, first, second)                                                                     \
  if (gsf_given (c->a, __func__, n, first, second))                                                \
    return tell (c, GSF_ERROR)

/* ----------------------------------------------------------------------------------- both kinds */

const char *
fmi2GetTypesPlatform (void)
{
  return fmi2TypesPlatform;
}

const char *
fmi2GetVersion (void)
{
  return fmi2Version;
}

fmi2Status
fmi2SetDebugLogging (fmi2Component component, fmi2Boolean on, size_t n,
                     const fmi2String categories[])
{
  (void)on;
  ENTER (BOTH, GSF_ANY);
  NEED (n, categories, categories);
  return fmi2OK;
}

static fmi2Component
refuse (const fmi2CallbackFunctions *back, fmi2String name, const char *text)
{
  if (back && back->logger)
    back->logger (back->componentEnvironment, name ? name : "", fmi2Error, "logStatusError", "%s",
                  text);
  return NULL;
}

fmi2Component
fmi2Instantiate (fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                 const fmi2CallbackFunctions *back, fmi2Boolean visible, fmi2Boolean on)
{
  (void)resources;
  (void)visible;
  (void)on;
  if (! name || ! *name)
    return refuse (back, name, "fmi2Instantiate: expected a name of the instance");
  if (! guid || strcmp (guid, gsf_the_model.token) != 0)
    return refuse (back, name, "fmi2Instantiate: the guid is not that of this FMU");
  if (type != fmi2ModelExchange && type != fmi2CoSimulation)
    return refuse (back, name, "fmi2Instantiate: unknown kind of FMU");
  instance *c = calloc (1, sizeof *c);
  if (! c)
    return refuse (back, name, "fmi2Instantiate: out of memory");
  c->a = gsf_new (&gsf_the_model, type == fmi2ModelExchange ? GSF_EXCHANGE : GSF_COSIMULATION);
  c->name = malloc (strlen (name) + 1);
  if (! c->a || ! c->name)
    {
      fmi2FreeInstance (c);
      return refuse (back, name, "fmi2Instantiate: out of memory");
    }
  strcpy (c->name, name);
  if (back)
    c->back = *back;
  return c;
}

void
fmi2FreeInstance (fmi2Component component)
{
  instance *c = component;
  if (! c)
    return;
  gsf_free (c->a);
  free (c->name);
  free (c);
}

fmi2Status
fmi2SetupExperiment (fmi2Component component, fmi2Boolean tolerant, fmi2Real tolerance,
                     fmi2Real start, fmi2Boolean stops, fmi2Real stop)
{
  ENTER (BOTH, GSF_MADE);
  return tell (c, gsf_setup (c->a, tolerant, tolerance, start, stops, stop));
}

fmi2Status
fmi2EnterInitializationMode (fmi2Component component)
{
  ENTER (BOTH, GSF_MADE);
  return tell (c, gsf_enter (c->a));
}

fmi2Status
fmi2ExitInitializationMode (fmi2Component component)
{
  ENTER (BOTH, GSF_INIT);
  return tell (c, gsf_exit (c->a));
}

fmi2Status
fmi2Terminate (fmi2Component component)
{
  ENTER (BOTH, GSF_EVENT | GSF_CONTINUOUS | GSF_STEP);
  gsf_terminate (c->a);
  return fmi2OK;
}

fmi2Status
fmi2Reset (fmi2Component component)
{
  ENTER (BOTH, GSF_ANY);
  gsf_reset (c->a);
  return fmi2OK;
}

fmi2Status
fmi2GetReal (fmi2Component component, const fmi2ValueReference references[], size_t n,
             fmi2Real values[])
{
  ENTER (BOTH, GSF_ANY);
  NEED (n, references, values);
  for (size_t k = 0; k < n; k++)
    {
      int status = gsf_get (c->a, references[k], values + k);
      if (status)
        return tell (c, status);
    }
  return fmi2OK;
}

fmi2Status
fmi2SetReal (fmi2Component component, const fmi2ValueReference references[], size_t n,
             const fmi2Real values[])
{
  ENTER (BOTH, GSF_ANY);
  NEED (n, references, values);
  for (size_t k = 0; k < n; k++)
    {
      int status = gsf_set (c->a, references[k], values[k]);
      if (status)
        return tell (c, status);
    }
  return fmi2OK;
}

/* all variables are of the type Real */
static int
only_real (instance *c, const char *function, size_t n)
{
  return n == 0 ? GSF_OK : gsf_fail (c->a, GSF_ERROR, "%s: all variables of this FMU are Real",
                                     function);
}

#define NO_SUCH(function, type)                                                                    \
  fmi2Status function (fmi2Component component, const fmi2ValueReference references[], size_t n,   \
                       type values[])                                                              \
  {                                                                                                \
    (void)references;                                                                              \
    (void)values;                                                                                  \
    ENTER (BOTH, GSF_ANY);                                                                         \
    return tell (c, only_real (c, __func__, n));                                                   \
  }
NO_SUCH (fmi2GetInteger, fmi2Integer)
NO_SUCH (fmi2GetBoolean, fmi2Boolean)
NO_SUCH (fmi2GetString, fmi2String)
NO_SUCH (fmi2SetInteger, const fmi2Integer)
NO_SUCH (fmi2SetBoolean, const fmi2Boolean)
NO_SUCH (fmi2SetString, const fmi2String)

/* --------------------------------------------------------------------------------- saved states */

fmi2Status
fmi2GetFMUstate (fmi2Component component, fmi2FMUstate *state)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, state, state);
  *state = gsf_save (c->a, *state);
  return *state ? fmi2OK : tell (c, gsf_fail (c->a, GSF_ERROR, "out of memory"));
}

fmi2Status
fmi2SetFMUstate (fmi2Component component, fmi2FMUstate state)
{
  ENTER (BOTH, GSF_ANY);
  return tell (c, gsf_restore (c->a, state));
}

fmi2Status
fmi2FreeFMUstate (fmi2Component component, fmi2FMUstate *state)
{
  ENTER (BOTH, GSF_ANY);
  if (state)
    {
      free (*state);
      *state = NULL;
    }
  return fmi2OK;
}

fmi2Status
fmi2SerializedFMUstateSize (fmi2Component component, fmi2FMUstate state, size_t *n)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, state, n);
  *n = gsf_bytes (c->a);
  return fmi2OK;
}

fmi2Status
fmi2SerializeFMUstate (fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t n)
{
  ENTER (BOTH, GSF_ANY);
  return tell (c, gsf_serialize (c->a, state, bytes, n));
}

fmi2Status
fmi2DeSerializeFMUstate (fmi2Component component, const fmi2Byte bytes[], size_t n,
                         fmi2FMUstate *state)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, bytes, state);
  void *read = gsf_deserialize (c->a, bytes, n, *state);
  if (! read)
    return tell (c, GSF_ERROR);
  *state = read;
  return fmi2OK;
}

fmi2Status
fmi2GetDirectionalDerivative (fmi2Component component, const fmi2ValueReference unknowns[],
                              size_t nu, const fmi2ValueReference knowns[], size_t nk,
                              const fmi2Real seed[], fmi2Real result[])
{
  ENTER (BOTH, GSF_READY);
  NEED (nu, unknowns, result);
  NEED (nk, knowns, seed);
  return tell (c, gsf_directional (c->a, nu, unknowns, nk, knowns, seed, result));
}

/* ------------------------------------------------------------------------------- model exchange */

fmi2Status
fmi2EnterEventMode (fmi2Component component)
{
  ENTER (EXCHANGE, GSF_CONTINUOUS | GSF_EVENT);
  c->a->i[GSF_PHASE] = GSF_EVENT;
  return fmi2OK;
}

fmi2Status
fmi2NewDiscreteStates (fmi2Component component, fmi2EventInfo *info)
{
  ENTER (EXCHANGE, GSF_EVENT);
  NEED (1, info, info);
  int changed, nominals, status = gsf_event (c->a, &changed, &nominals);
  memset (info, 0, sizeof *info);
  info->valuesOfContinuousStatesChanged = changed;
  info->nominalsOfContinuousStatesChanged = nominals;
  info->terminateSimulation = *c->a->run.ended > 0;
  info->nextEventTimeDefined = c->a->d[GSF_T_NEXT] < 1e300;
  info->nextEventTime = info->nextEventTimeDefined ? c->a->d[GSF_T_NEXT] : 0;
  return tell (c, status);
}

fmi2Status
fmi2EnterContinuousTimeMode (fmi2Component component)
{
  ENTER (EXCHANGE, GSF_EVENT);
  c->a->i[GSF_PHASE] = GSF_CONTINUOUS;
  return fmi2OK;
}

fmi2Status
fmi2CompletedIntegratorStep (fmi2Component component, fmi2Boolean nothing_before,
                             fmi2Boolean *event, fmi2Boolean *terminate)
{
  (void)nothing_before;
  ENTER (EXCHANGE, GSF_CONTINUOUS);
  NEED (1, event, terminate);
  int status = gsf_completed (c->a, event);
  *terminate = fmi2False;
  return tell (c, status);
}

fmi2Status
fmi2SetTime (fmi2Component component, fmi2Real t)
{
  ENTER (EXCHANGE, GSF_EVENT | GSF_CONTINUOUS);
  return tell (c, gsf_set_time (c->a, t));
}

#define AS_MANY(expected, array)                                                                   \
  NEED (n, array, array);                                                                          \
  if (gsf_as_many (c->a, __func__, n, (size_t)(expected)))                                         \
    return tell (c, GSF_ERROR)

fmi2Status
fmi2SetContinuousStates (fmi2Component component, const fmi2Real x[], size_t n)
{
  ENTER (EXCHANGE, GSF_CONTINUOUS | GSF_EVENT);
  AS_MANY (gsf_ns (c->a->m), x);
  return tell (c, gsf_set_states (c->a, x));
}

fmi2Status
fmi2GetContinuousStates (fmi2Component component, fmi2Real x[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (gsf_ns (c->a->m), x);
  int status = c->a->i[GSF_STALE] == 1 ? gsf_fresh (c->a) : GSF_OK;
  if (status == GSF_OK && n > 0)
    memcpy (x, c->a->z, n * sizeof (double));
  return tell (c, status);
}

fmi2Status
fmi2GetNominalsOfContinuousStates (fmi2Component component, fmi2Real x[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (gsf_ns (c->a->m), x);
  for (size_t k = 0; k < n; k++)
    x[k] = gsf_nominal (c->a, (int)k);
  return fmi2OK;
}

fmi2Status
fmi2GetDerivatives (fmi2Component component, fmi2Real xd[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (gsf_ns (c->a->m), xd);
  int status = gsf_rates (c->a);
  for (size_t k = 0; k < n && status == GSF_OK; k++)
    xd[k] = c->a->xd[c->a->place[k]];
  return tell (c, status);
}

fmi2Status
fmi2GetEventIndicators (fmi2Component component, fmi2Real z[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (gsf_nz (c->a->m), z);
  return n == 0 ? fmi2OK : tell (c, gsf_indicators (c->a, z));
}

/* ------------------------------------------------------------------------------- co-simulation */

fmi2Status
fmi2SetRealInputDerivatives (fmi2Component component, const fmi2ValueReference references[],
                             size_t n, const fmi2Integer orders[], const fmi2Real values[])
{
  (void)references;
  (void)orders;
  (void)values;
  ENTER (COSIMULATION, GSF_ANY);
  return n == 0 ? fmi2OK : tell (c, gsf_fail (c->a, GSF_ERROR, "%s: inputs are constant in a step",
                                              __func__));
}

fmi2Status
fmi2GetRealOutputDerivatives (fmi2Component component, const fmi2ValueReference references[],
                              size_t n, const fmi2Integer orders[], fmi2Real values[])
{
  (void)references;
  (void)orders;
  (void)values;
  ENTER (COSIMULATION, GSF_ANY);
  return n == 0 ? fmi2OK : tell (c, gsf_fail (c->a, GSF_ERROR, "%s: not provided", __func__));
}

fmi2Status
fmi2DoStep (fmi2Component component, fmi2Real t, fmi2Real h, fmi2Boolean nothing_before)
{
  (void)nothing_before;
  ENTER (COSIMULATION, GSF_STEP);
  int status = gsf_can_step (c->a, t, h);
  if (status == GSF_OK)
    status = gsf_step (c->a, t + h);
  if (status <= GSF_WARNING && *c->a->run.ended > 0)
    status = gsf_ended (c->a, GSF_DISCARD);
  return tell (c, status);
}

fmi2Status
fmi2CancelStep (fmi2Component component)
{
  ENTER (COSIMULATION, GSF_ANY);
  return tell (c, gsf_fail (c->a, GSF_ERROR, "fmi2CancelStep: steps are not asynchronous"));
}

fmi2Status
fmi2GetRealStatus (fmi2Component component, const fmi2StatusKind kind, fmi2Real *value)
{
  ENTER (COSIMULATION, GSF_STEP | GSF_DONE);
  NEED (1, value, value);
  if (kind != fmi2LastSuccessfulTime)
    return fmi2Discard;
  *value = *c->a->t;
  return fmi2OK;
}

fmi2Status
fmi2GetBooleanStatus (fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value)
{
  ENTER (COSIMULATION, GSF_ANY);
  NEED (1, value, value);
  if (kind != fmi2Terminated)
    return fmi2Discard;
  gsf_hide_samples (c->a);
  *value = *c->a->run.ended > 0;
  return fmi2OK;
}

#define NO_STATUS(function, type)                                                                  \
  fmi2Status function (fmi2Component component, const fmi2StatusKind kind, type *value)            \
  {                                                                                                \
    (void)kind;                                                                                    \
    ENTER (COSIMULATION, GSF_ANY);                                                                 \
    NEED (1, value, value);                                                                        \
    return fmi2Discard;                                                                            \
  }
NO_STATUS (fmi2GetStatus, fmi2Status)
NO_STATUS (fmi2GetIntegerStatus, fmi2Integer)
NO_STATUS (fmi2GetStringStatus, fmi2String)
