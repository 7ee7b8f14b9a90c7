/* values.c: values of variables by reference. */
#include "fmu.h"
#include "gsmbp/functions.h"
#include "gsmbp/refusals.h"

#include <math.h>

static int
no_variable (gsf_instance *a, unsigned reference)
{
  return gsf_fail (a, GSF_ERROR, "there is no variable of the value reference %u", reference);
}

/* the state that variable k of GSF_CHOSEN is, among those of the importer */
static int
chosen (const gsf_model *m, int k)
{
  return m->nsq == m->scene->nq ? m->nsq + k : k;
}

/* what follows from the state */
static int
get_computed (gsf_instance *a, int block, int k, double *value)
{
  int status = block == GSF_OUTPUT ? gsf_outputs (a)
             : block == GSF_RATE ? gsf_rates (a) : gsf_fresh (a);
  if (status == GSF_OK && block == GSF_USED)
    status = gsf_inputs (a);
  if (status)
    return status;
  switch (block)
    {
    case GSF_STATE:
      *value = a->x[k];
      break;
    case GSF_CHOSEN:
      *value = a->z[chosen (a->m, k)];
      break;
    case GSF_PLACE:
      *value = a->place[chosen (a->m, k)] + 1;
      break;
    case GSF_RATE:
      *value = a->xd[a->place[k]];
      break;
    case GSF_OUTPUT:
      *value = a->y[k];
      break;
    case GSF_MODE:
      *value = gsf_events (a).mode[k];
      break;
    case GSF_TALLY:
      *value = gsf_tally (a, k);
      break;
    case GSF_WHEN:
      *value = gsf_when (a, k);
      break;
    case GSF_OVERRIDDEN:
      *value = gsf_is_overridden (a, a->m->switched[k]);
      break;
    case GSF_USED:
      *value = a->v[a->m->switched[k]];
      break;
    case GSF_HELD:
      *value = gsf_samples (a).value[k];
      break;
    default:
      *value = gsf_samples (a).memory[k];
    }
  return GSF_OK;
}

int
gsf_get (gsf_instance *a, unsigned reference, double *value)
{
  int k, block = gsf_locate (a->m, reference, &k);
  if (gsf_show_samples (a))
    return GSF_ERROR;
  switch (block)
    {
    case GSF_BLOCKS:
      return no_variable (a, reference);
    case GSF_TIME:
      *value = *a->t;
      return GSF_OK;
    case GSF_PARAMETER:
      *value = a->par[k];
      return GSF_OK;
    case GSF_INPUT:
      *value = a->run.inputs[a->m->inputs[k]];
      return GSF_OK;
    case GSF_INDICATOR:
      return gsf_indicator (a, k, value);
    default:
      return get_computed (a, block, k, value);
    }
}

/* a value that can be: finite, within the bounds of the variable, no lost angle */
static int
can_be (gsf_instance *a, unsigned reference, double value)
{
  const gsf_model *m = a->m;
  if (! (fabs (value) <= 1e300))
    return gsf_fail (a, GSF_ERROR, gs_refusals.not_finite, m->names[reference], value);
  for (int k = 0; k < m->nbounds; k++)
    if (m->bounds[k].reference == (int)reference
        && ! (value >= m->bounds[k].low && value <= m->bounds[k].high))
      return gsf_fail (a, GSF_ERROR, "%s: expected a number from %g to %g, found %g",
                       m->names[reference], m->bounds[k].low, m->bounds[k].high, value);
  return GSF_OK;
}

/* a coordinate, speed or state of a device that the importer integrates, set after the
 * initialization, as gsf_set_states does; 0: it is none */
static int
set_state (gsf_instance *a, int k, double value)
{
  if (a->i[GSF_KIND] != GSF_EXCHANGE || ! (a->i[GSF_PHASE] & (GSF_EVENT | GSF_CONTINUOUS)))
    return 0;
  for (int j = 0; j < gsf_ns (a->m); j++)
    if (a->place[j] == k)
      {
        a->z[j] = value;
        if (a->i[GSF_STALE] == 0)
          a->i[GSF_STALE] = 2;
        return 1;
      }
  return 0;
}

/* set before the initialization ends */
static int
set_start (gsf_instance *a, int block, unsigned reference, int k, double value)
{
  if (! (a->i[GSF_PHASE] & (GSF_MADE | GSF_INIT)))
    return gsf_fail (a, GSF_ERROR, "%s: %s can only be set before the initialization ends",
                     a->m->names[reference],
                     block == GSF_PARAMETER ? "a fixed parameter" : "a start");
  if (block == GSF_PARAMETER)
    a->par[k] = value;
  else if (block == GSF_MEMORY)
    a->memory[k] = value;
  else
    {
      a->xs[k] = value;
      a->set[k] = 1;
    }
  a->i[GSF_STALE] = 1;
  return GSF_OK;
}

int
gsf_set (gsf_instance *a, unsigned reference, double value)
{
  int k, block = gsf_locate (a->m, reference, &k);
  if (block == GSF_BLOCKS)
    return no_variable (a, reference);
  gsf_hide_samples (a);
  int status = can_be (a, reference, value);
  if (status)
    return status;
  a->known = 0;
  if (block == GSF_STATE && set_state (a, k, value))
    return GSF_OK;
  if (block == GSF_PARAMETER || block == GSF_STATE || block == GSF_MEMORY)
    return set_start (a, block, reference, k, value);
  if (block != GSF_INPUT)
    return gsf_fail (a, GSF_ERROR, "%s: only parameters, inputs and starts can be set",
                     a->m->names[reference]);
  if (a->i[GSF_PHASE] == GSF_DONE)
    return gsf_fail (a, GSF_ERROR, "%s: the instance is terminated", a->m->names[reference]);
  gs_step_set (&a->run, a->m->inputs[k], value);
  return GSF_OK;
}

int
gsf_set_time (gsf_instance *a, double t)
{
  if (! (fabs (t) <= 1e300))
    return gsf_fail (a, GSF_ERROR, "time: expected a finite number, found %g", t);
  if (! (t == *a->t))
    {
      *a->t = t;
      a->known = 0;
      if (a->i[GSF_STALE] == 0)
        a->i[GSF_STALE] = 2;
    }
  return GSF_OK;
}
