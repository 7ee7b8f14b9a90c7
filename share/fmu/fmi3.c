/* fmi3.c: the functions of FMI 3.0, model exchange and co-simulation. */
#include "fmi3Functions.h"
#include "fmu.h"

#include <stdlib.h>
#include <string.h>

typedef struct
{
  gsf_instance *a;
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;
  int early;   /* 1: a step may end ahead of its end */
} instance;

/* a status of this folder as one of the standard; its sentence is logged */
static fmi3Status
tell (const instance *c, int status)
{
  static const fmi3Status all[] = { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error };
  if (status != GSF_OK && c->log)
    c->log (c->environment, all[status], gsf_category[status], c->a->text);
  return all[status];
}

enum { EXCHANGE = 1 << GSF_EXCHANGE, COSIMULATION = 1 << GSF_COSIMULATION, BOTH = 3 };

/* the instance c; the function ends with an error where it is null or not allowed here */
#define ENTER(kinds, phases)                                                                       \
  instance *c = component;                                                                         \
  if (! c)                                                                                         \
    return fmi3Error;                                                                              \
  if (gsf_allowed (c->a, __func__, kinds, phases))                                                 \
    return tell (c, GSF_ERROR)
#define NEED(n, first, second)                                                                     \
  if (gsf_given (c->a, __func__, n, first, second))                                                \
    return tell (c, GSF_ERROR)
#define AS_MANY(n, expected, array)                                                                \
  NEED (n, array, array);                                                                          \
  if (gsf_as_many (c->a, __func__, n, (size_t)(expected)))                                         \
    return tell (c, GSF_ERROR)

typedef const fmi3ValueReference references_t[];

/* ----------------------------------------------------------------------------------- both kinds */

const char *
fmi3GetVersion (void)
{
  return fmi3Version;
}

fmi3Status
fmi3SetDebugLogging (fmi3Instance component, fmi3Boolean on, size_t n,
                     const fmi3String categories[])
{
  (void)on;
  ENTER (BOTH, GSF_ANY);
  NEED (n, categories, categories);
  return fmi3OK;
}

static fmi3Instance
refuse (fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, const char *text)
{
  if (log)
    log (environment, fmi3Error, "logStatusError", text);
  return NULL;
}

static fmi3Instance
make (fmi3String name, fmi3String token, fmi3InstanceEnvironment environment,
      fmi3LogMessageCallback log, int kind)
{
  if (! name || ! *name)
    return refuse (environment, log, "fmi3Instantiate: expected a name of the instance");
  if (! token || strcmp (token, gsf_the_model.token) != 0)
    return refuse (environment, log,
                   "fmi3Instantiate: the instantiationToken is not that of this FMU");
  instance *c = calloc (1, sizeof *c);
  if (c)
    c->a = gsf_new (&gsf_the_model, kind);
  if (! c || ! c->a)
    {
      free (c);
      return refuse (environment, log, "fmi3Instantiate: out of memory");
    }
  c->environment = environment;
  c->log = log;
  return c;
}

fmi3Instance
fmi3InstantiateModelExchange (fmi3String name, fmi3String token, fmi3String resources,
                              fmi3Boolean visible, fmi3Boolean on,
                              fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
  (void)resources;
  (void)visible;
  (void)on;
  return make (name, token, environment, log, GSF_EXCHANGE);
}

fmi3Instance
fmi3InstantiateCoSimulation (fmi3String name, fmi3String token, fmi3String resources,
                             fmi3Boolean visible, fmi3Boolean on, fmi3Boolean events,
                             fmi3Boolean early, const fmi3ValueReference intermediate[], size_t n,
                             fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                             fmi3IntermediateUpdateCallback update)
{
  (void)resources;
  (void)visible;
  (void)on;
  (void)intermediate;
  (void)update;
  if (events)
    return refuse (environment, log,
                   "fmi3InstantiateCoSimulation: eventModeUsed: this FMU has no event mode in "
                   "co-simulation");
  if (n > 0)
    return refuse (environment, log,
                   "fmi3InstantiateCoSimulation: this FMU has no intermediate variables");
  instance *c = make (name, token, environment, log, GSF_COSIMULATION);
  if (c)
    c->early = early != 0;
  return c;
}

fmi3Instance
fmi3InstantiateScheduledExecution (fmi3String name, fmi3String token, fmi3String resources,
                                   fmi3Boolean visible, fmi3Boolean on,
                                   fmi3InstanceEnvironment environment,
                                   fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                   fmi3LockPreemptionCallback lock,
                                   fmi3UnlockPreemptionCallback unlock)
{
  (void)name;
  (void)token;
  (void)resources;
  (void)visible;
  (void)on;
  (void)update;
  (void)lock;
  (void)unlock;
  return refuse (environment, log, "this FMU has no scheduled execution");
}

void
fmi3FreeInstance (fmi3Instance component)
{
  instance *c = component;
  if (! c)
    return;
  gsf_free (c->a);
  free (c);
}

fmi3Status
fmi3EnterInitializationMode (fmi3Instance component, fmi3Boolean tolerant, fmi3Float64 tolerance,
                             fmi3Float64 start, fmi3Boolean stops, fmi3Float64 stop)
{
  ENTER (BOTH, GSF_MADE);
  int status = gsf_setup (c->a, tolerant, tolerance, start, stops, stop);
  return tell (c, status ? status : gsf_enter (c->a));
}

fmi3Status
fmi3ExitInitializationMode (fmi3Instance component)
{
  ENTER (BOTH, GSF_INIT);
  return tell (c, gsf_exit (c->a));
}

fmi3Status
fmi3Terminate (fmi3Instance component)
{
  ENTER (BOTH, GSF_EVENT | GSF_CONTINUOUS | GSF_STEP);
  gsf_terminate (c->a);
  return fmi3OK;
}

fmi3Status
fmi3Reset (fmi3Instance component)
{
  ENTER (BOTH, GSF_ANY);
  gsf_reset (c->a);
  return fmi3OK;
}

fmi3Status
fmi3GetFloat64 (fmi3Instance component, references_t references, size_t n, fmi3Float64 values[],
                size_t nvalues)
{
  ENTER (BOTH, GSF_ANY);
  NEED (n, references, values);
  AS_MANY (nvalues, n, values);
  for (size_t k = 0; k < n; k++)
    {
      int status = gsf_get (c->a, references[k], values + k);
      if (status)
        return tell (c, status);
    }
  return fmi3OK;
}

fmi3Status
fmi3SetFloat64 (fmi3Instance component, references_t references, size_t n,
                const fmi3Float64 values[], size_t nvalues)
{
  ENTER (BOTH, GSF_ANY);
  NEED (n, references, values);
  AS_MANY (nvalues, n, values);
  for (size_t k = 0; k < n; k++)
    {
      int status = gsf_set (c->a, references[k], values[k]);
      if (status)
        return tell (c, status);
    }
  return fmi3OK;
}

/* what this FMU does not have */
static fmi3Status
nothing (fmi3Instance component, const char *function, const char *why)
{
  instance *c = component;
  if (! c)
    return fmi3Error;
  return tell (c, gsf_fail (c->a, GSF_ERROR, "%s: %s", function, why));
}

/* all variables are of the type Float64 */
#define NO_SUCH(type)                                                                              \
  fmi3Status fmi3Get##type (fmi3Instance component, references_t references, size_t n,             \
                            fmi3##type values[], size_t nvalues)                                   \
  {                                                                                                \
    (void)references;                                                                              \
    (void)values;                                                                                  \
    return n + nvalues == 0 && component ? fmi3OK : nothing (component, __func__, all_float64);    \
  }                                                                                                \
  fmi3Status fmi3Set##type (fmi3Instance component, references_t references, size_t n,             \
                            const fmi3##type values[], size_t nvalues)                             \
  {                                                                                                \
    (void)references;                                                                              \
    (void)values;                                                                                  \
    return n + nvalues == 0 && component ? fmi3OK : nothing (component, __func__, all_float64);    \
  }
static const char all_float64[] = "all variables of this FMU are Float64";
NO_SUCH (Float32)
NO_SUCH (Int8)
NO_SUCH (UInt8)
NO_SUCH (Int16)
NO_SUCH (UInt16)
NO_SUCH (Int32)
NO_SUCH (UInt32)
NO_SUCH (Int64)
NO_SUCH (UInt64)
NO_SUCH (Boolean)
NO_SUCH (String)

/* --------------------------------------------------------------------------------- saved states */

fmi3Status
fmi3GetFMUState (fmi3Instance component, fmi3FMUState *state)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, state, state);
  *state = gsf_save (c->a, *state);
  return *state ? fmi3OK : tell (c, gsf_fail (c->a, GSF_ERROR, "out of memory"));
}

fmi3Status
fmi3SetFMUState (fmi3Instance component, fmi3FMUState state)
{
  ENTER (BOTH, GSF_ANY);
  return tell (c, gsf_restore (c->a, state));
}

fmi3Status
fmi3FreeFMUState (fmi3Instance component, fmi3FMUState *state)
{
  ENTER (BOTH, GSF_ANY);
  if (state)
    {
      free (*state);
      *state = NULL;
    }
  return fmi3OK;
}

fmi3Status
fmi3SerializedFMUStateSize (fmi3Instance component, fmi3FMUState state, size_t *n)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, state, n);
  *n = gsf_bytes (c->a);
  return fmi3OK;
}

fmi3Status
fmi3SerializeFMUState (fmi3Instance component, fmi3FMUState state, fmi3Byte bytes[], size_t n)
{
  ENTER (BOTH, GSF_ANY);
  return tell (c, gsf_serialize (c->a, state, bytes, n));
}

fmi3Status
fmi3DeserializeFMUState (fmi3Instance component, const fmi3Byte bytes[], size_t n,
                         fmi3FMUState *state)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, bytes, state);
  void *read = gsf_deserialize (c->a, bytes, n, *state);
  if (! read)
    return tell (c, GSF_ERROR);
  *state = read;
  return fmi3OK;
}

fmi3Status
fmi3GetDirectionalDerivative (fmi3Instance component, references_t unknowns, size_t nu,
                              references_t knowns, size_t nk, const fmi3Float64 seed[], size_t ns,
                              fmi3Float64 result[], size_t nr)
{
  ENTER (BOTH, GSF_READY);
  NEED (nu, unknowns, result);
  NEED (nk, knowns, seed);
  AS_MANY (nr, nu, result);
  AS_MANY (ns, nk, seed);
  return tell (c, gsf_directional (c->a, nu, unknowns, nk, knowns, seed, result));
}

/* ------------------------------------------------------------------------------- model exchange */

fmi3Status
fmi3EnterEventMode (fmi3Instance component)
{
  ENTER (EXCHANGE, GSF_CONTINUOUS | GSF_EVENT);
  c->a->i[GSF_PHASE] = GSF_EVENT;
  return fmi3OK;
}

fmi3Status
fmi3UpdateDiscreteStates (fmi3Instance component, fmi3Boolean *again, fmi3Boolean *terminate,
                          fmi3Boolean *nominals, fmi3Boolean *values, fmi3Boolean *defined,
                          fmi3Float64 *next)
{
  ENTER (EXCHANGE, GSF_EVENT);
  NEED (1, again, terminate);
  NEED (1, nominals, values);
  NEED (1, defined, next);
  int changed, others, status = gsf_event (c->a, &changed, &others);
  *again = fmi3False;
  *terminate = *c->a->run.ended > 0;
  *nominals = others != 0;
  *values = changed != 0;
  *defined = c->a->d[GSF_T_NEXT] < 1e300;
  *next = *defined ? c->a->d[GSF_T_NEXT] : 0;
  return tell (c, status);
}

fmi3Status
fmi3EnterContinuousTimeMode (fmi3Instance component)
{
  ENTER (EXCHANGE, GSF_EVENT);
  c->a->i[GSF_PHASE] = GSF_CONTINUOUS;
  return fmi3OK;
}

fmi3Status
fmi3CompletedIntegratorStep (fmi3Instance component, fmi3Boolean nothing_before,
                             fmi3Boolean *event, fmi3Boolean *terminate)
{
  (void)nothing_before;
  ENTER (EXCHANGE, GSF_CONTINUOUS);
  NEED (1, event, terminate);
  int needed, status = gsf_completed (c->a, &needed);
  *event = needed != 0;
  *terminate = fmi3False;
  return tell (c, status);
}

fmi3Status
fmi3SetTime (fmi3Instance component, fmi3Float64 t)
{
  ENTER (EXCHANGE, GSF_EVENT | GSF_CONTINUOUS);
  return tell (c, gsf_set_time (c->a, t));
}

fmi3Status
fmi3SetContinuousStates (fmi3Instance component, const fmi3Float64 x[], size_t n)
{
  ENTER (EXCHANGE, GSF_CONTINUOUS | GSF_EVENT);
  AS_MANY (n, gsf_ns (c->a->m), x);
  return tell (c, gsf_set_states (c->a, x));
}

fmi3Status
fmi3GetContinuousStates (fmi3Instance component, fmi3Float64 x[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (n, gsf_ns (c->a->m), x);
  int status = c->a->i[GSF_STALE] == 1 ? gsf_fresh (c->a) : GSF_OK;
  if (status == GSF_OK && n > 0)
    memcpy (x, c->a->z, n * sizeof (double));
  return tell (c, status);
}

fmi3Status
fmi3GetNominalsOfContinuousStates (fmi3Instance component, fmi3Float64 x[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (n, gsf_ns (c->a->m), x);
  for (size_t k = 0; k < n; k++)
    x[k] = gsf_nominal (c->a, (int)k);
  return fmi3OK;
}

fmi3Status
fmi3GetContinuousStateDerivatives (fmi3Instance component, fmi3Float64 xd[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (n, gsf_ns (c->a->m), xd);
  int status = gsf_rates (c->a);
  for (size_t k = 0; k < n && status == GSF_OK; k++)
    xd[k] = c->a->xd[c->a->place[k]];
  return tell (c, status);
}

fmi3Status
fmi3GetEventIndicators (fmi3Instance component, fmi3Float64 z[], size_t n)
{
  ENTER (EXCHANGE, GSF_READY);
  AS_MANY (n, gsf_nz (c->a->m), z);
  return n == 0 ? fmi3OK : tell (c, gsf_indicators (c->a, z));
}

fmi3Status
fmi3GetNumberOfEventIndicators (fmi3Instance component, size_t *n)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, n, n);
  *n = (size_t)gsf_nz (c->a->m);
  return fmi3OK;
}

fmi3Status
fmi3GetNumberOfContinuousStates (fmi3Instance component, size_t *n)
{
  ENTER (BOTH, GSF_ANY);
  NEED (1, n, n);
  *n = (size_t)gsf_ns (c->a->m);
  return fmi3OK;
}

fmi3Status
fmi3EvaluateDiscreteStates (fmi3Instance component)
{
  ENTER (BOTH, GSF_INIT | GSF_EVENT);
  return fmi3OK;
}

/* -------------------------------------------------------------------------------- co-simulation */

fmi3Status
fmi3DoStep (fmi3Instance component, fmi3Float64 t, fmi3Float64 h, fmi3Boolean nothing_before,
            fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *last)
{
  (void)nothing_before;
  ENTER (COSIMULATION, GSF_STEP);
  NEED (1, event, terminate);
  NEED (1, early, last);
  *event = *terminate = *early = fmi3False;
  int status = gsf_can_step (c->a, t, h);
  if (status == GSF_OK)
    status = gsf_step (c->a, t + h);
  *last = *c->a->t;
  *terminate = status <= GSF_WARNING && *c->a->run.ended > 0;
  *early = *terminate && c->early && *last < t + h;
  return tell (c, status);
}

/* -------------------------------------------------------------------------- what there is not */

/* the parameters of a function that does nothing with them, then their names */
#define NONE(function, why, parameters, ...)                                                       \
  fmi3Status function parameters                                                                   \
  {                                                                                                \
    const void *unused[] = { __VA_ARGS__ };                                                        \
    (void)unused;                                                                                  \
    return nothing (component, #function, why);                                                    \
  }

NONE (fmi3GetBinary, all_float64,
      (fmi3Instance component, references_t r, size_t n, size_t sizes[], fmi3Binary values[],
       size_t nvalues), r, &n, sizes, values, &nvalues)
NONE (fmi3SetBinary, all_float64,
      (fmi3Instance component, references_t r, size_t n, const size_t sizes[],
       const fmi3Binary values[], size_t nvalues), r, &n, sizes, values, &nvalues)
NONE (fmi3GetClock, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, fmi3Clock values[]), r, &n, values)
NONE (fmi3SetClock, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, const fmi3Clock values[]), r, &n, values)
NONE (fmi3GetNumberOfVariableDependencies, "not provided",
      (fmi3Instance component, fmi3ValueReference r, size_t *n), &r, n)
NONE (fmi3GetVariableDependencies, "not provided",
      (fmi3Instance component, fmi3ValueReference r, size_t dependents[],
       fmi3ValueReference independents[], size_t elements[], fmi3DependencyKind kinds[], size_t n),
      &r, dependents, independents, elements, kinds, &n)
NONE (fmi3GetAdjointDerivative, "not provided",
      (fmi3Instance component, references_t unknowns, size_t nu, references_t knowns, size_t nk,
       const fmi3Float64 seed[], size_t ns, fmi3Float64 result[], size_t nr),
      unknowns, &nu, knowns, &nk, seed, &ns, result, &nr)
NONE (fmi3EnterConfigurationMode, "there are no structural parameters",
      (fmi3Instance component), component)
NONE (fmi3ExitConfigurationMode, "there are no structural parameters",
      (fmi3Instance component), component)
NONE (fmi3GetIntervalDecimal, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, fmi3Float64 intervals[],
       fmi3IntervalQualifier qualifiers[]), r, &n, intervals, qualifiers)
NONE (fmi3GetIntervalFraction, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, fmi3UInt64 counters[],
       fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[]),
      r, &n, counters, resolutions, qualifiers)
NONE (fmi3GetShiftDecimal, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, fmi3Float64 shifts[]), r, &n, shifts)
NONE (fmi3GetShiftFraction, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, fmi3UInt64 counters[],
       fmi3UInt64 resolutions[]), r, &n, counters, resolutions)
NONE (fmi3SetIntervalDecimal, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, const fmi3Float64 intervals[]),
      r, &n, intervals)
NONE (fmi3SetIntervalFraction, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, const fmi3UInt64 counters[],
       const fmi3UInt64 resolutions[]), r, &n, counters, resolutions)
NONE (fmi3SetShiftDecimal, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, const fmi3Float64 shifts[]),
      r, &n, shifts)
NONE (fmi3SetShiftFraction, "this FMU has no clocks",
      (fmi3Instance component, references_t r, size_t n, const fmi3UInt64 counters[],
       const fmi3UInt64 resolutions[]), r, &n, counters, resolutions)
NONE (fmi3GetOutputDerivatives, "not provided",
      (fmi3Instance component, references_t r, size_t n, const fmi3Int32 orders[],
       fmi3Float64 values[], size_t nvalues), r, &n, orders, values, &nvalues)
NONE (fmi3ActivateModelPartition, "this FMU has no clocks",
      (fmi3Instance component, fmi3ValueReference clock, fmi3Float64 t), &clock, &t)
NONE (fmi3EnterStepMode, "this FMU has no event mode in co-simulation",
      (fmi3Instance component), component)
