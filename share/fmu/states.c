/* states.c: the state of an instance: its start, and in model exchange the states of the importer,
 * which the others follow from.
 *
 * Of a closed chain the importer's states are independent coordinates and speeds; the dependent
 * ones are completed by Newton's method (gs_complete_state) from where they were in the state
 * before. Where Euler parameters, quasi-speeds or constraints on speeds alone are in the scene all
 * coordinates are states, of which those that depend on others are guesses. Euler parameters are
 * divided by their length before they are used. */
#include "fmu.h"
#include "gsmbp/functions.h"
#include "gsmbp/limits.h"
#include "gsmbp/loops.h"
#include "gsmbp/refusals.h"
#include "gsmbp/solve.h"

#include <math.h>
#include <stdio.h>

/* a set is chosen anew where the volume of its columns is below this part of the best one's after a
 * step; within one, below GSF_RANGE */
#define GSF_CHANGE 0.8
#define GSF_RANGE 0.5
/* how far the length of Euler parameters may be from 1 */
#define GSF_LENGTH 1e-3

/* ----------------------------------------------------------------------- inputs, rates, outputs */

int
gsf_inputs (gsf_instance *a)
{
  int info = gs_inputs_of_run (a->m->scene, *a->t, 1, a->x, a->m->scene->nx, a->run.r.ip,
                               a->run.r.rp, a->cst, a->v, a->w);
  return info == 0 ? GSF_OK : gsf_failed (a, GSF_ERROR, GS_AT_INPUTS, info);
}

/* 2: constraints are dependent, 3: angles are close to their singularity: results are usable */
int
gsf_is_usable (int info)
{
  return info == 0 || info == 2 || info == 3;
}

int
gsf_rates (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  if (gsf_fresh (a) || gsf_inputs (a))
    return GSF_ERROR;
  if (a->known & GSF_HAS_RATES)
    return GSF_OK;
  int info = s->rhs (gsf_time (a), a->x, a->v, a->cst, a->xd);
  if (! gsf_is_usable (info))
    return gsf_failed (a, GSF_DISCARD, GS_AT_RHS, info);
  if (gs_not_finite (s->nx, a->xd) != 0)
    return gsf_fail (a, GSF_DISCARD, "the rate of state %d is not finite at t = %.15g s",
                     gs_not_finite (s->nx, a->xd), *a->t);
  a->known |= GSF_HAS_RATES;
  return GSF_OK;
}

int
gsf_outputs (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  if (gsf_fresh (a) || gsf_inputs (a))
    return GSF_ERROR;
  if (a->known & GSF_HAS_OUTPUTS)
    return GSF_OK;
  int info = s->out ? s->out (gsf_time (a), a->x, a->v, a->cst, a->y) : 0;
  if (! gsf_is_usable (info))
    return gsf_failed (a, GSF_DISCARD, GS_AT_OUTPUT, info);
  a->known |= GSF_HAS_OUTPUTS;
  return GSF_OK;
}

double
gsf_nominal (const gsf_instance *a, int state)
{
  return a->m->nominal[a->place[state]];
}

/* ----------------------------------------------------------------------------- Euler parameters */

static double
length (const gsf_instance *a, const double *x, int set)
{
  const int *k = a->m->sets + 4 * set;
  return sqrt (x[k[0]] * x[k[0]] + x[k[1]] * x[k[1]] + x[k[2]] * x[k[2]] + x[k[3]] * x[k[3]]);
}

static int
normalize (gsf_instance *a, double *x)
{
  for (int set = 0; set < a->m->nsets; set++)
    {
      double n = length (a, x, set);
      if (! (n > gs_limits.short_orientation && n < 1e3))
        {
          gs_start s;
          gs_refuse_orientation (&a->about, set, x, &s);
          return gsf_fail (a, GSF_DISCARD, "%s", s.text);
        }
      for (int k = 0; k < 4; k++)
        x[a->m->sets[4 * set + k]] /= n;
    }
  return GSF_OK;
}

/* ---------------------------------------------------------------------- independent coordinates */

/* which states the importer has: those that the partition counts */
static int
number_states (gsf_instance *a)
{
  const gsf_model *m = a->m;
  const gs_scene *s = m->scene;
  const double *counts = s->nlam > 0
                         ? gs_partition_of (s->nq, s->nu, s->nlam, a->p).counts : NULL;
  const int ns = gsf_ns (m);
  int n = 0;
  for (int i = 0; i < s->nx; i++)
    {
      int whole = ! counts || i >= s->nq + s->nu || (i < s->nq && m->nsq == s->nq);
      if (! (whole || counts[i] > 0))
        continue;
      if (n < ns)
        a->place[n] = i;
      n++;
    }
  if (n == ns)
    return GSF_OK;
  return gsf_fail (a, GSF_ERROR, "the constraints have another rank at t = %.15g s than where the "
                   "scene was derived (%d states are independent, expected %d): a singular "
                   "position, or other lengths; co-simulation may go on", *a->t, n, ns);
}

int
gsf_choose (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  if (s->nlam > 0)
    {
      int info = gs_partition_choose (s, *a->t, a->x, a->cst, a->p);
      if (info != 0)
        return gsf_failed (a, GSF_ERROR, GS_AT_CON, info);
    }
  return number_states (a);
}

static void
begin_partition (gsf_instance *a)
{
  const gsf_model *m = a->m;
  int iopt[6] = { 8, 3, 1, 0, 0, 0 };
  gs_partition_none (m->scene->nq, m->scene->nu, m->scene->nlam, iopt, a->p);
  double *rows = gs_partition_of (m->scene->nq, m->scene->nu, m->scene->nlam, a->p).rows;
  for (int k = 0; k < m->nspeedrows; k++)
    {
      rows[m->speedrows[k] - 1] = 0;
      a->p[GS_NONHOLONOMIC] = 1;
    }
}

void
gsf_take (gsf_instance *a)
{
  gs_copy (a->m->scene->nx, a->x, a->xr);
  for (int k = 0; k < gsf_ns (a->m); k++)
    a->z[k] = a->x[a->place[k]];
}

/* the state that follows from z, from the guess x */
static int
complete_from (gsf_instance *a, const double *x)
{
  const gs_scene *s = a->m->scene;
  gs_move (s->nx, x, a->x);
  for (int k = 0; k < gsf_ns (a->m); k++)
    a->x[a->place[k]] = a->z[k];
  int status = normalize (a, a->x);
  if (status)
    return status;
  /* twice: the speeds then belong to the last position */
  for (int k = 0; k < 2 && s->nlam > 0; k++)
    {
      int info = gs_complete_state (s, *a->t, a->x, a->cst, a->p);
      if (info == 3)
        return gsf_fail (a, GSF_DISCARD, "no state on the constraints was found at t = %.15g s: "
                         "the step is too long, or a singular position is near", *a->t);
      if (info != 0)
        return gsf_failed (a, GSF_DISCARD, GS_AT_CON, info);
    }
  return GSF_OK;
}

/* the guess is the last state that was asked for, then that of the last event or completed step */
int
gsf_complete (gsf_instance *a)
{
  int status = complete_from (a, a->x);
  if (status && a->m->scene->nlam > 0)
    status = complete_from (a, a->xr);
  if (status)
    gs_copy (a->m->scene->nx, a->xr, a->x);
  else
    a->i[GSF_STALE] = 0;
  return status;
}

/* the volume of the columns of the dependent speeds beside that of the best choice; the partition
 * itself stays as it is */
static double
volume (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  double *p = a->w, least, ratio;
  int rank;
  gs_copy (gsf_partition_size (s), a->p, p);
  gs_partition b = gs_partition_of (s->nq, s->nu, s->nlam, p);
  int info = s->con (*a->t, a->x, a->x + s->nq, a->cst, b.phi, b.phit, b.hc, s->nlam, b.gam);
  if (info != 0 && info != 2)
    return -1;
  gs_constraint_pivots (s->nu, s->nlam, b.hc, b.size, b.y, b.piv, b.beta, b.siz, &rank, &least);
  if ((int)p[GS_DEPENDENT] != rank)
    return -1;
  for (int j = 0; j < rank; j++)
    for (int i = 0; i < s->nlam; i++)
      b.y[i + s->nlam * j] = b.hc[i + s->nlam * ((int)b.order[j] - 1)] / b.size[i];
  gs_volume (s->nlam, rank, b.y, b.siz, &ratio);
  return ratio;
}

int
gsf_margins (gsf_instance *a, double *chosen, double *normal)
{
  *chosen = a->m->scene->nlam > 0 ? volume (a) : 1;
  *normal = GSF_LENGTH;
  for (int set = 0; set < a->m->nsets; set++)
    {
      double z[4];
      for (int k = 0; k < 4; k++)
        z[k] = 0;
      for (int k = 0; k < gsf_ns (a->m); k++)
        for (int l = 0; l < 4; l++)
          if (a->place[k] == a->m->sets[4 * set + l])
            z[l] = a->z[k];
      double n = sqrt (z[0] * z[0] + z[1] * z[1] + z[2] * z[2] + z[3] * z[3]);
      if (GSF_LENGTH - fabs (n - 1) < *normal)
        *normal = GSF_LENGTH - fabs (n - 1);
    }
  return *chosen < GSF_CHANGE || *normal < 0.5 * GSF_LENGTH;
}

int
gsf_set_states (gsf_instance *a, const double *z)
{
  const int n = gsf_ns (a->m), wrong = gs_not_finite (n, z);
  if (wrong != 0)
    return gsf_fail (a, GSF_ERROR, "continuous state %d: expected a finite number, found %g",
                     wrong, z[wrong - 1]);
  gs_copy (n, z, a->z);
  a->known = 0;
  if (a->i[GSF_STALE] == 0)
    a->i[GSF_STALE] = 2;
  return GSF_OK;
}

/* ---------------------------------------------------------------------------------------- start */

/* cst, the state, modes and the choice of coordinates from parameters and starts */
static int
prepare (gsf_instance *a)
{
  const gsf_model *m = a->m;
  const gs_scene *s = m->scene;
  const char *rule = m->refuse (a->par);
  if (rule)
    return gsf_fail (a, GSF_ERROR, "parameters: %s", rule);
  int info = m->pre (a->par, a->cst);
  if (info != 0)
    return gsf_failed (a, GSF_ERROR, GS_AT_PRE, info);
  m->start (a->par, a->x);
  for (int i = 0; i < s->nx; i++)
    if (a->set[i])
      a->x[i] = a->xs[i];
  const double times[] = { *a->t, a->d[GSF_T1] };
  const gs_run_start start = { .nt = times[1] < 1e300 ? 2 : 1, .times = times, .x0 = a->x,
                               .par = a->par, .cst = a->cst, .memory = a->memory };
  a->run.o.rtol = a->d[GSF_TOLERANCE];
  if (gs_step_begin (&a->run, &start) || (m->nsettled > 0 && gs_step_settle (&a->run, a->set)))
    return gsf_run_says (a);
  gsf_next_switch (a);
  if (gsf_begin_events (a))
    return GSF_ERROR;
  if (s->nlam > 0)
    begin_partition (a);
  if (gsf_choose (a) && a->i[GSF_KIND] == GSF_EXCHANGE)
    return GSF_ERROR;
  gsf_take (a);
  a->i[GSF_STALE] = 0;
  return GSF_OK;
}

int
gsf_fresh (gsf_instance *a)
{
  if (a->i[GSF_STALE] == 1)
    return prepare (a);
  return a->i[GSF_STALE] == 2 ? gsf_complete (a) : GSF_OK;
}

int
gsf_setup (gsf_instance *a, int given, double tolerance, double t0, int stops, double t1)
{
  if (! (fabs (t0) <= 1e300) || (stops && ! (t1 > t0 && t1 <= 1e300)))
    return gsf_fail (a, GSF_ERROR, "expected a start time and a later stop time; found %g and %g",
                     t0, t1);
  if (given && ! (tolerance > 0 && tolerance < 1))
    return gsf_fail (a, GSF_ERROR, "tolerance: expected a number above 0 and below 1, found %g",
                     tolerance);
  *a->t = t0;
  a->d[GSF_T1] = stops ? t1 : 1e300;
  if (given)
    a->d[GSF_TOLERANCE] = tolerance;
  a->i[GSF_STALE] = 1;
  a->known = 0;
  return GSF_OK;
}

int
gsf_enter (gsf_instance *a)
{
  a->i[GSF_PHASE] = GSF_INIT;
  return GSF_OK;
}

int
gsf_exit (gsf_instance *a)
{
  a->i[GSF_STALE] = 1;
  a->known = 0;
  if (gsf_fresh (a))
    return GSF_ERROR;
  if (gs_step_check (&a->run))
    return gsf_run_says (a);
  a->i[GSF_PHASE] = a->i[GSF_KIND] == GSF_EXCHANGE ? GSF_EVENT : GSF_STEP;
  return GSF_OK;
}
