/* run.c: a whole run, from its options to its results. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/expressions.h"
#include "gsmbp/functions.h"
#include "gsmbp/refusals.h"
#include "host/failure.h"
#include "host/output_rows.h"
#include "host/run/run_parts.h"
#include "host/text.h"

/* ---------------------------------------------------------------------------------------- room */

static size_t
many (int a, int b)
{
  return (size_t)(a > 1 ? a : 1) * (size_t)(b > 1 ? b : 1);
}

static int
make_room (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  const gs_scene *s = w->d->scene;
  const size_t x = many (r->nx, r->nt), v = many (r->ldv, r->nt), y = many (s->ny, r->nt);
  const size_t nx = many (r->nx, 1), nt = many (r->nt, 1), cst = many (w->d->ncst, 1);
  const size_t numbers = x + v + y + 2 * nx + nt + cst;
  const size_t nc = (size_t)w->o->ncolumns, slopes = 2 * (((v + y) * nc + 1) / 2);
  const size_t wholes = many (GS_ON_SPEEDS + 1 + w->d->nspeedrows, 1);
  r->room = calloc (1, slopes * sizeof (double) + numbers * sizeof (gs_real)
                         + wholes * sizeof (int));
  if (! r->room)
    return gs_refuse (r, GS_REFUSED_START, "", "there was no memory for the run");
  double *first = r->room;   /* an even number of them: those of quad precision stand behind */
  r->dv = nc > 0 ? first : NULL;
  r->dy = nc > 0 ? first + v * nc : NULL;
  r->x = (gs_real *)(first + slopes);
  r->v = r->x + x;
  r->y = r->v + v;
  r->atol = w->atol = r->y + y;
  w->x0 = r->atol + nx;
  r->times = w->x0 + nx;
  r->cst = r->times + nt;
  w->iopt = (int *)(r->cst + cst);
  for (size_t k = 0; k < x; k++)   /* where the run does not come */
    r->x[k] = (gs_real)NAN;
  memcpy (r->times, w->s->times, nt * sizeof (gs_real));
  memcpy (w->x0, w->s->x0, (size_t)s->nx * sizeof (gs_real));
  if (w->o->dx0 && w->o->ncolumns > 0)
    memcpy (w->x0 + s->nx, w->o->dx0,
            (size_t)s->nx * (size_t)w->o->ncolumns * sizeof (gs_real));
  return 0;
}

void
gs_free_result (gs_run_result *r)
{
  if (r->derivatives)
    gs_derivatives_close (r->derivatives);
  r->derivatives = NULL;
  free (r->room);
  free (r->ip);
  free (r->rp);
  r->room = NULL;
  r->ip = NULL;
  r->rp = NULL;
}

/* --------------------------------------------------------------------------------------- start */

/* where the solution of a planned motion begins */
static void
guess_motion (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  if (s->nq == s->nu)
    memcpy (w->w, w->x0, (size_t)s->nu * sizeof (gs_real));
}

static int
take_start (gs_whole_run *w)
{
  const gs_start_given g = { .t = w->s->times[0], .cst = w->r->cst, .par = w->s->par,
                             .check = ! w->o->project, .modes = w->s->modes };
  if (gs_take_start (w->d, &g, w->x0, &w->r->start) != GS_START_TAKEN)
    return gs_refuse (w->r, GS_REFUSED_START, "", "%s", w->r->start.text);
  guess_motion (w);
  return 0;
}

static int
lay_plan (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  r->ip = calloc ((size_t)gs_wholes (&w->plan) + 1, sizeof *r->ip);
  r->rp = calloc ((size_t)gs_reals (&w->plan) + 1, sizeof *r->rp);
  w->lw = gs_room (w->d->scene, r->nx, w->plan.derivatives);
  w->w = calloc ((size_t)w->lw + 1, sizeof *w->w);
  if (! r->ip || ! r->rp || ! w->w)
    return gs_refuse (r, GS_REFUSED_START, "", "there was no memory for the plan");
  gs_lay (&w->plan, r->ip, r->rp);
  guess_motion (w);
  if (w->in->kind == 2 && r->ip[GS_CLOSED] == 1
      && gs_lacks (w, w->d->scene->clo != NULL, "the run", "clo"))
    return 1;
  gs_start first;
  if (gs_check_samples (w->d, w->s->times[0], r->cst, r->ip, r->rp, &first) == GS_START_TAKEN)
    return 0;
  return gs_refuse (r, GS_REFUSED_SAMPLES, "", "%s", first.text);
}

/* ----------------------------------------------------------------------------------------- run */

/* a function of inputs, asked for a side of a jump, is called just before it or behind it, whatever
 * it has in the jump itself; it may have double precision alone */
static int
beside_jumps (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  const gs_whole_run *w = data;
  for (int k = 0; k < w->njumps; k++)
    if (w->jumps[k] >= t && w->jumps[k] <= t)
      {
        const gs_real apart = gs_max (2 * gs_max (GS_EPSILON, (gs_real)DBL_EPSILON) * gs_abs (t),
                                      gs_max (GS_TINY, (gs_real)1e-300));
        return w->in->function (side < 0 ? t - apart : t + apart, side, x, nx, nv, w->in->data, v);
      }
  return w->in->function (t, side, x, nx, nv, w->in->data, v);
}

/* its routines where this run has others */
static void
call_scene (gs_whole_run *w)
{
  w->scene = *w->d->scene;
  if (w->o->audit > 0)
    w->scene.rhs = w->d->audited;
  if (w->in->kind == 3 && w->in->function)
    {
      w->scene.vin = beside_jumps;
      w->scene.data = w;
    }
  else if (w->d->fortran_inputs)
    {
      w->fortran = (gs_fortran_inputs){ w->r->ip, w->r->rp, w->r->cst };
      w->scene.data = &w->fortran;
    }
}

/* with the states, routines and columns that the options ask for */
static void
integrate (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  gs_scene scene = w->scene;
  gs_integration run = gs_prepared_run (w);
  if (r->derivatives)
    {
      scene = *gs_derivatives_scene (r->derivatives);
      run.cst = gs_derivatives_constants (r->derivatives);
    }
  gs_integrate_by (w, &scene, &run);
}

/* -------------------------------------------------------------------------------- what it gives */

/* where an event of the user has ended the run its state is the last row */
static void
end_by_event (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  r->rows = r->istat[GS_N_OUTPUTS];
  if (r->info != GS_ENDED)
    return;
  const gs_real last = r->rstat[GS_T_REACHED];
  r->ended = *gs_planned_events (r->nx, r->ip, r->rp).ended;
  if (r->rows == 0 || r->times[r->rows - 1] < last)
    r->times[r->rows++] = last;
}

static void
outputs (const gs_whole_run *w)
{
  const gs_run_result *r = w->r;
  const gs_scene *s = w->d->scene;
  gs_real switches[s->nsw + 1];
  if (s->nsw > 0)
    s->swi (r->cst, switches);
  for (int k = 0; s->ny > 0 && k < r->rows; k++)
    {
      const gs_real t = gs_row_time (r->times, k, r->istat[GS_N_OUTPUTS], s->nsw, switches);
      gs_real *y = r->y + (ptrdiff_t)s->ny * k;
      if (! gs_outputs (s, t, r->x + (ptrdiff_t)r->nx * k, r->v + (ptrdiff_t)r->ldv * k, r->cst, y))
        for (int i = 0; i < s->ny; i++)
          y[i] = (gs_real)NAN;
    }
}

/* of the columns, which may end the run by another info */
static void
derivatives (gs_whole_run *w)
{
  int info = gs_look_at_turns (w);
  if (info == 0)
    info = gs_take_slopes (w);
  if (info != 0)
    w->r->info = info;
}

/* does a given mode contradict the state, the last one of the run? Then it is refused */
static int
refuse_mode (gs_whole_run *w)
{
  gs_run_result *r = w->r;
  if (r->info != GS_ROUTINE_FAILED || r->istat[GS_FAILED] != GS_AT_EVENT
      || r->istat[GS_FAILED_INFO] != GS_WRONG_MODE || ! w->s->modes)
    return 0;
  const gs_start_given g = { .t = w->s->times[0], .cst = r->cst, .modes = w->s->modes };
  char why[2000];
  gs_wrong_mode (w->d, &g, r->x + (size_t)r->nx * (size_t)r->istat[GS_N_OUTPUTS],
                 r->istat[GS_CAUSE] - 1, why, (int)sizeof why);
  return gs_refuse (r, GS_REFUSED_MODE, "modes", "%s", why);
}

/* ---------------------------------------------------------------------------------------- whole */

int
gs_prepare_run (gs_whole_run *w)
{
  const gs_description *d = w->d;
  gs_run_result *r = w->r;
  const int audit = w->o->audit > 0;
  memset (r, 0, sizeof *r);
  r->nx = d->scene->nx * (1 + w->o->ncolumns) + (audit ? 2 : 0);
  r->nt = w->s->nt;
  r->ldv = d->scene->nv > 1 ? d->scene->nv : 1;
  if (audit && gs_lacks (w, d->audited != NULL, "option audit", "rha"))
    return 1;
  return make_room (w) || gs_choose_method (w) || gs_choose_tolerances (w) || gs_choose_loops (w)
         || gs_set_loop_method (w) || gs_lay_inputs (w) || lay_plan (w);
}

void
gs_forget_run (gs_whole_run *w)
{
  free (w->jumps);
  free (w->w);
}

/* all before the first step */
static int
begin (gs_whole_run *w)
{
  if (gs_prepare_run (w) || take_start (w))
    return 1;
  call_scene (w);
  return gs_open_columns (w);
}

int
gs_run_prepare (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
                const gs_run_inputs *in, gs_run_result *r)
{
  gs_whole_run w = { .d = d, .o = o, .s = s, .in = in, .r = r };
  if (! begin (&w))
    memcpy (r->x, w.x0, (size_t)r->nx * sizeof (gs_real));
  gs_forget_run (&w);
  return r->refused;
}

int
gs_run (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
        const gs_run_inputs *in, gs_run_result *r)
{
  gs_whole_run w = { .d = d, .o = o, .s = s, .in = in, .r = r };
  if (! begin (&w))
    {
      integrate (&w);
      if (strcmp (r->method, "auto") == 0)
        r->method = r->istat[GS_IS_STIFF] ? "radau" : "dp853";
      end_by_event (&w);
      if (r->derivatives)
        derivatives (&w);
      if (r->info == GS_DONE || r->info == GS_ENDED)
        r->info = GS_DONE;
      else if (! refuse_mode (&w))
        gs_tell_failure (&w);
      if (! r->refused)
        outputs (&w);
    }
  gs_forget_run (&w);
  return r->refused || r->info != GS_DONE;
}
