/* The run of gs_integrate (stops at breaks, inputs, loops, statistics; the same routines of the run
   time) by an implicit method, for stiff scenes.  Output times may lie between the steps: there the
   method's state is moved onto the constraints as well. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "gsmbp/loops.h"
#include "gsmbp/plan.h"
#include "implicit_parts.h"

/* ------------------------------------------------------------
 * the run */

/* how many numbers the partition has */
static ptrdiff_t
partition_room (const gs_scene *s)
{
  const ptrdiff_t nu = s->nu;
  return 24 + 8 * nu + 10 * s->nq + 7 * s->nlam + 2 * s->nlam * nu;
}

static int
by_time (const void *a, const void *b)
{
  const double left = *(const double *) a, right = *(const double *) b;
  return (left > right) - (left < right);
}

/* where steps end: the breaks of the run, and where the scene switches by itself */
static void
take_stops (gs_stepper *s)
{
  const gs_integration *r = s->r;
  s->nstops = r->nb + s->scene->nsw;
  if (r->nb > 0)
    gs_copy (r->nb, r->tbrk, s->stops);
  if (s->scene->nsw > 0)
    s->scene->swi (r->cst, s->stops + r->nb);
  qsort (s->stops, (size_t) s->nstops, sizeof (double), by_time);
}

static int
allocate (gs_stepper *s)
{
  gs_integration *r = s->r;
  const ptrdiff_t nx = r->nx, nv = s->scene->nv + 1, ny = s->scene->ny + 1, nq = s->scene->nq,
                  np = partition_room (s->scene), stops = r->nb + s->scene->nsw;
  int n = 6 + r->iopt[GS_ON_SPEEDS], ne = gs_event_functions (s);
  s->x = gs_allocate ((8 + GS_NODES) * nx + nq + 3 * nv + np + nx * nv + ny * nx + ny * nv + 2 * ne
                   + stops, sizeof (double));
  s->project = gs_allocate (2 * n + 3 * ne, sizeof (int));
  if (! s->x || ! s->project)
    return 0;
  s->trial = s->x + nx;
  s->between = s->trial + nx;
  s->v = s->between + nx;
  s->dv = s->v + 2 * nv;
  s->p = s->dv + nv;
  s->b = s->p + np;
  s->c = s->b + nx * nv;
  s->d = s->c + ny * nx;
  s->work = s->d + ny * nv;
  s->known = s->work + 3 * nx;
  s->event = s->known + nx;
  s->nodes = s->event + nx;
  s->turns = s->nodes + GS_NODES * nx;
  s->levels = s->turns + nq;
  s->stops = s->levels + 2 * ne;
  s->watch = s->project + n;
  s->marks = s->watch + n;
  s->rising = s->marks + 2 * ne;
  for (int k = 0; k < n; k++)
    s->project[k] = s->watch[k] = r->iopt[k];
  s->project[GS_LOOPS] = 2;
  s->project[GS_DRIFT] = 0;
  s->watch[GS_LOOPS] = s->watch[GS_DRIFT] = 1;
  s->watch[GS_METHOD] = 4;   /* steps are not steered by singular positions */
  s->g = (gs_system){ .s = s->scene, .nx = r->nx, .iopt = r->iopt, .ropt = r->ropt,
                      .atol = r->atol, .ip = r->ip, .rp = r->rp, .cst = r->cst, .v = s->v,
                      .w = r->w, .p = s->p, .istat = r->istat, .rstat = r->rstat };
  take_stops (s);
  return s->by->open (s);
}

static void
release (gs_stepper *s)
{
  s->by->close (s);
  free (s->x);
  free (s->project);
}

int
gs_acts (const gs_stepper *s)
{
  return s->r->ip[GS_SAMPLES] > 0 || gs_has_events (s);
}

int
gs_projects (const gs_stepper *s)
{
  const gs_scene *scene = s->scene;
  return s->r->iopt[GS_LOOPS] != 1 && (scene->nlam > 0 || scene->nq > scene->nu);
}

/* the sampled devices; ACTED: did any? INFO */
static int
samples (gs_stepper *s, int *acted)
{
  gs_integration *r = s->r;
  int info = gs_samples_due (s->scene, s->t, s->x, r->nx, r->ip, r->rp, r->cst, s->v, r->w,
                             r->istat, &s->sample, acted);
  return info != 0 ? GS_ROUTINE_FAILED : GS_DONE;
}

/* time, state and statistics at the start */
static void
start (gs_stepper *s)
{
  gs_integration *r = s->r;
  if (s->o->resume)
    {
      s->t = r->rstat[GS_T_REACHED];
      gs_copy (r->nx, r->xout + (ptrdiff_t) r->ldx * r->istat[GS_N_OUTPUTS], s->x);
      r->istat[GS_N_JACOBIANS] = r->istat[GS_N_NEWTON] = r->istat[GS_N_DIVERGED] = 0;
      return;
    }
  s->t = r->t0;
  gs_copy (r->nx, r->x0, s->x);
  memset (r->istat, 0, GS_COUNTED * sizeof (int));
  gs_zero (GS_MEASURED, r->rstat);
  r->rstat[GS_R_PIVOT] = 1;
  r->rstat[GS_H_LEAST] = r->tout[r->nt - 1] - r->t0;
  r->rstat[GS_T_REACHED] = r->t0;
}

/* does the run start where the constraints lose rank? BDF does not begin there: INFO */
static int
singular_start (gs_stepper *s)
{
  gs_integration *r = s->r;
  double hmax = r->tout[r->nt - 1] - s->t;
  const ptrdiff_t nlam = s->scene->nlam,
                  room = r->nx + 2 * s->scene->nq + nlam * (s->scene->nu + 1);
  int state = 0, info = 0;
  if (s->scene->nlam == 0 || r->iopt[GS_WATCH] != 1 || r->iopt[GS_LOOPS] == 1 || s->o->resume)
    return GS_DONE;
  double *f = gs_allocate (room, sizeof (double));
  if (! f)
    return GS_OUT_OF_MEMORY;
  double *xt = f + r->nx, *xw = xt + s->scene->nq, *siz = xw + s->scene->nq,
         *hc = siz + s->scene->nlam;
  gs_starts_singular (s->scene, s->t, s->x, hmax, r->cst, f, xt, xw, hc, siz, s->p, &state);
  if (state < 0)   /* at rest: by the accelerations */
    {
      info = gs_rates_at (&s->g, s->t, 1, s->x, f);
      if (info == 0)
        gs_starts_singular (s->scene, s->t, s->x, hmax, r->cst, f, xt, xw, hc, siz, s->p, &state);
    }
  free (f);
  if (info == 0 && state > 0)
    {
      r->istat[GS_FAILED_INFO] = state;
      r->istat[GS_FAILED] = GS_AT_START;
    }
  return info != 0 || state > 0 ? GS_ROUTINE_FAILED : GS_DONE;
}

/* the start, as gs_integrate; INFO */
static int
begin (gs_stepper *s)
{
  gs_integration *r = s->r;
  int info, acted;
  start (s);
  gs_partition_none (s->scene->nq, s->scene->nu, s->scene->nlam, r->iopt, s->p);
  double job = s->p[0];
  s->p[0] = 0;   /* completed from others it would be moved close to a singular position */
  if (gs_check (s, r->iopt, s->t, s->x, gs_no_jump) != 0)
    return GS_ROUTINE_FAILED;
  s->p[0] = job;
  if (gs_take_inputs (s, s->t, 1, s->x, s->v) != 0)
    return GS_ROUTINE_FAILED;
  if ((info = gs_first_events (s)) != 0 || (info = singular_start (s)) != 0)
    return info;
  if (s->scene->nlam > 0 && r->iopt[GS_WATCH] == 1 && r->iopt[GS_LOOPS] != 1 && s->p[0] < 2
      && s->p[2] < s->scene->nlam)
    s->p[0] = 2;   /* dependent constraints: see METHOD of gs_integrate */
  if (s->p[0] > 0)
    {
      info = gs_partition_choose (s->scene, s->t, s->x, r->cst, s->p);
      if (info != 0)
        {
          r->istat[GS_FAILED_INFO] = info;
          r->istat[GS_FAILED] = GS_AT_CON;
          return GS_ROUTINE_FAILED;
        }
    }
  r->istat[GS_FAILED] = GS_AT_NOTHING;
  return samples (s, &acted);
}

void
gs_turn_on (const gs_stepper *s, double *x)
{
  for (int l = 0; l < s->scene->nq; l++)
    if (s->turns[l] != 0)
      x[l] = (double) (x[l] + 2 * 3.14159265358979323846264338327950288L * s->turns[l]);
}

/* the state X at the output time T: a column of the result */
static int
put_out (gs_stepper *s, double t, const double *x)
{
  gs_integration *r = s->r;
  int k = r->istat[GS_N_OUTPUTS];
  double *column = r->xout + (ptrdiff_t) r->ldx * k;
  gs_copy (r->nx, x, column);
  if (gs_projects (s) && ! (t < s->t && s->by->onto && s->by->onto (s, t, column) == 0)
      && gs_check (s, s->project, t, column, gs_no_jump) != 0)
    return GS_ROUTINE_FAILED;
  if (gs_take_inputs (s, t, gs_side_at (s, t), column, s->v) != 0)
    return GS_ROUTINE_FAILED;
  gs_copy (s->scene->nv, s->v, r->vout + (ptrdiff_t) r->ldv * k);
  gs_turn_on (s, column);
  r->istat[GS_N_OUTPUTS] = k + 1;
  return GS_DONE;
}

int
gs_put_out (gs_stepper *s, double limit)
{
  gs_integration *r = s->r;
  while (r->istat[GS_N_OUTPUTS] < r->nt && r->tout[r->istat[GS_N_OUTPUTS]] <= limit)
    {
      double t = r->tout[r->istat[GS_N_OUTPUTS]];
      if (t < s->t && s->by->between (s, t, s->between) < 0)
        return GS_METHOD_FAILED;
      if (put_out (s, t, t < s->t ? s->between : s->x) != 0)
        return GS_ROUTINE_FAILED;
    }
  return GS_DONE;
}

/* the output times up to here; at the end of the run an event of the user that lies there; INFO */
static int
arrive (gs_stepper *s)
{
  gs_integration *r = s->r;
  int info = GS_DONE;
  if (s->t >= r->tout[r->nt - 1]
      && (info = gs_put_out (s, nextafter (s->t, -HUGE_VAL))) == GS_DONE)
    info = gs_events_at_end (s);
  return info != GS_DONE ? info : gs_put_out (s, s->t);
}

/* after a step, up to an EVENT or none: statistics, drift, the output times that it passed; INFO */
static int
accept (gs_stepper *s, int event)
{
  gs_integration *r = s->r;
  r->istat[GS_N_STEPS]++;
  r->istat[GS_FAILED_INFO] = r->istat[GS_FAILED] = GS_AT_NOTHING;
  r->rstat[GS_H_LEAST] = fmin (r->rstat[GS_H_LEAST], s->h);
  r->rstat[GS_H_LARGEST] = fmax (r->rstat[GS_H_LARGEST], s->h);
  r->rstat[GS_T_REACHED] = s->t;
  r->rstat[GS_H_NEXT] = s->next;
  if (! gs_all_finite (r->nx, s->y))
    return GS_NOT_FINITE;
  s->still = s->h <= 16 * DBL_EPSILON * fabs (s->t) ? s->still + 1 : 0;
  if (s->still >= 20)   /* a method might go on for ever */
    return GS_TOO_SMALL;
  gs_copy (r->nx, s->y, s->x);
  if (! event && s->by->moves)
    gs_onto_held (s, s->t, s->x);
  gs_copy (r->nx, s->x, s->trial);
  if (s->scene->nlam > 0 && (r->iopt[GS_DRIFT] == 1 || s->p[0] > 0)
      && gs_check (s, s->watch, s->t, s->trial, gs_no_jump) != 0)
    return GS_ROUTINE_FAILED;
  return event && gs_ended_by_event (s) ? GS_ENDED : arrive (s);
}

/* does the scene switch where the run stands? Then its rates differ on both sides. */
static int
switched (gs_stepper *s)
{
  const int n = s->r->nx;
  double *left = s->work, *right = s->work + n;
  if (s->scene->nsw == 0)
    return 0;
  int info = gs_rate (s, s->stop, s->x, left);
  s->side = 1;
  info = info != 0 ? info : gs_rate (s, s->stop, s->x, right);
  s->side = -1;
  for (int k = 0; k < n && info == 0; k++)
    if (fabs (right[k] - left[k]) > 1e-11 * (fabs (right[k]) + fabs (left[k])))
      return 1;
  return info != 0;
}

/* do the inputs jump at the break where the run stands? A user's routine may do what it likes. */
static int
jumps (gs_stepper *s)
{
  gs_integration *r = s->r;
  if (r->ip[GS_V0] == 3)
    return 1;
  if (gs_take_inputs (s, s->t, -1, s->x, s->dv) != 0
      || gs_take_inputs (s, s->t, 1, s->x, s->v) != 0)
    return 1;   /* the next step will say what is wrong */
  for (int k = 0; k < s->scene->nv; k++)
    if (! (fabs (s->v[k] - s->dv[k]) <= 1e-11 * (fabs (s->v[k]) + fabs (s->dv[k]))))
      return 1;
  return switched (s);
}

/* the flag of a method; INFO */
static int
failure (gs_stepper *s, int flag)
{
  s->r->istat[GS_CAUSE] = flag;
  return s->r->istat[GS_FAILED] != GS_AT_NOTHING     ? GS_ROUTINE_FAILED
         : flag == GS_NO_STEP  ? GS_TOO_SMALL
         : flag == GS_NO_RATES   ? GS_RATE_NOT_FINITE
         : flag == GS_NO_MEMORY  ? GS_OUT_OF_MEMORY
                                 : GS_METHOD_FAILED;
}

/* one step, up to an EVENT in it; INFO */
static int
next_step (gs_stepper *s, int *event)
{
  double from = s->t;
  int flag = s->by->step (s), info = GS_DONE;
  *event = 0;
  if (flag >= 0 && gs_has_events (s))
    info = gs_events_in_step (s, from, event, &flag);
  return flag < 0 ? failure (s, flag) : info;
}

/* the method, behind a jump; INFO */
static int
start_again (gs_stepper *s)
{
  s->by->count (s);
  int flag = s->by->restart (s);
  return flag < 0 ? failure (s, flag) : GS_DONE;
}

/* from here to the next stop; INFO */
static int
advance (gs_stepper *s)
{
  gs_integration *r = s->r;
  int event, info;
  if (s->stop - s->t <= 16 * DBL_EPSILON * fmax (fabs (s->t), fabs (s->stop)))
    {
      s->t = s->stop;
      return arrive (s);
    }
  while (s->t < s->stop)
    {
      const int most = r->iopt[GS_MOST_STEPS];
      if (most > 0
          && r->istat[GS_N_STEPS] + r->istat[GS_N_REJECTED] + s->by->rejected (s) >= most)
        return GS_TOO_MANY;
      if ((info = gs_asked (s, s->t)) != 0 || (info = next_step (s, &event)) != 0
          || (info = accept (s, event)) != 0 || (event && (info = start_again (s)) != 0))
        return info;
    }
  return GS_DONE;
}

/* stop at T, a break or a sample, unless the stop is nearer; times that differ by rounding are one
 */
static void
next_stop (gs_stepper *s, double t)
{
  double fuzz = 8 * DBL_EPSILON * fabs (s->stop);
  if (t > s->stop + fuzz)
    return;
  if (t < s->stop - fuzz)
    s->stop = t;
}

static int
go (gs_stepper *s)
{
  gs_integration *r = s->r;
  int ib = 0, acted, jumped, happened, info, flag;
  double end = r->tout[r->nt - 1];
  if ((info = begin (s)) != 0)
    return info;
  s->side = 1;
  s->stop = end;
  if ((info = gs_put_out (s, s->t)) != 0)
    return info;
  if ((flag = s->by->begin (s)) < 0)
    return failure (s, flag);
  while (r->istat[GS_N_OUTPUTS] < r->nt)
    {
      while (ib < s->nstops && s->stops[ib] <= s->t)
        ib++;
      s->stop = end;
      s->side = -1;
      next_stop (s, ib < s->nstops ? s->stops[ib] : HUGE_VAL);
      next_stop (s, s->sample);
      info = advance (s);
      if (info != 0 || r->istat[GS_N_OUTPUTS] >= r->nt)
        break;
      jumped = jumps (s);
      if ((info = samples (s, &acted)) != 0 || (info = gs_events_at_stop (s, &happened)) != 0
          || ((jumped || acted || happened) && (info = start_again (s)) != 0))
        break;
    }
  s->by->count (s);
  return info;
}

/* an event that failed has been later than the last step */
static void
tell_time (gs_stepper *s)
{
  gs_integration *r = s->r;
  if (r->istat[GS_FAILED] != GS_AT_EVENT)
    return;
  const gs_events e = gs_planned_events (r->nx, r->ip, r->rp);
  if (*e.newest > 0)
    r->rstat[GS_T_REACHED] = fmax (r->rstat[GS_T_REACHED], e.latest[*e.newest - 1]);
}

/* are the arguments within their ranges? INFO as gs_integrate */
static int
check_arguments (const gs_scene *scene, const gs_integration *r, const gs_method *by)
{
  gs_integration checked = *r;
  int iopt[GS_ON_SPEEDS + 1];
  memcpy (iopt, r->iopt, sizeof iopt);
  iopt[GS_METHOD] = by->fixed ? 4 : 8;
  checked.iopt = iopt;
  return gs_check_arguments (scene, &checked);
}

int
gs_implicit_run (const gs_scene *scene, gs_integration *r, const gs_implicit *o,
                 const gs_method *by)
{
  gs_stepper s = { .scene = scene, .r = r, .o = o, .by = by };
  int info = check_arguments (scene, r, by);
  if (info != 0)
    return info;
  info = GS_OUT_OF_MEMORY;
  if (o->length > 0)
    o->text[0] = 0;
  if (allocate (&s))
    {
      info = go (&s);
      info = s.asked != 0 ? s.asked : info;
      if (info == GS_ROUTINE_FAILED)
        tell_time (&s);
      if (info != GS_DONE
          && r->istat[GS_N_OUTPUTS] < r->nt) /* the last state, as by gs_integrate */
        {
          const ptrdiff_t k = r->istat[GS_N_OUTPUTS];
          gs_turn_on (&s, s.x);
          gs_copy (r->nx, s.x, r->xout + r->ldx * k);
          gs_copy (scene->nv, s.v, r->vout + r->ldv * k);
        }
    }
  release (&s);
  return info;
}
