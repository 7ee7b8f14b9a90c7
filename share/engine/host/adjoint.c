/* adjoint.c: a run whose steps are kept, and the way back through them. */
#include <stdlib.h>

#include "gsmbp/arith.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"
#include "host/adjoint.h"

/* a run on its way; the arrays lie in one block */
typedef struct
{
  gs_system g;
  const gs_adjoint_run *run;
  int istat[GS_COUNTED];
  gs_real ropt[3], rstat[GS_MEASURED];
  gs_real *block, *x, *xn, *w; /* the state, the next one; (nx,13) stages, or what
                                  gs_step_back_dp853 takes */
  gs_real t, h;                /* the time, the next step, 0 before the first one [s] */
} course;

/* for the way forward, and for the way back */
static int
work_size (const gs_scene *s)
{
  return gs_most (13 * s->nx, 15 * s->nx + s->nv + s->nsp);
}

/* At the state x at t, with the inputs there, which stay so where they are constant; no partition.
   info: 0 or GS_OUT_OF_MEMORY */
static int
begin (course *c, const gs_adjoint_run *run, gs_real t, gs_real rtol, const gs_real *atol,
       const gs_real *x)
{
  const gs_scene *s = run->scene;
  const int nx = s->nx, inputs = 2 * s->nv + 1,
            motion = 2 * s->nu * (run->ip[GS_DERIVATIVES] + 1) + 5 * nx + s->nv * nx + 21,
            all = 2 * nx + work_size (s) + inputs + GS_PARTS + motion;
  *c = (course){ .run = run, .t = t, .ropt = { 0, rtol, 0 } };
  c->block = (gs_real *)calloc ((size_t)all, sizeof *c->block);
  if (! c->block)
    return GS_OUT_OF_MEMORY;
  c->x = c->block;
  c->xn = c->x + nx;
  c->w = c->xn + nx;
  c->g = (gs_system){ .s = s, .nx = nx, .ropt = c->ropt, .atol = atol, .ip = run->ip,
                      .rp = run->rp, .cst = run->cst, .istat = c->istat, .rstat = c->rstat };
  c->g.v = c->w + work_size (s);
  c->g.p = c->g.v + inputs;
  c->g.w = c->g.p + GS_PARTS;
  gs_copy (nx, x, c->x);
  gs_inputs_of_run (s, t, 1, x, nx, run->ip, run->rp, run->cst, c->g.v, c->g.w); /* fails again at a
                                                                                    step */
  return 0;
}

static int
ask (const course *c, gs_real t)
{
  return c->run->ask ? c->run->ask (c->run->asked, t) : 0;
}

/* ------------------------------------------------------------------------------------ forward */

/* the step from t to tn; 0: there is no memory */
static int
keep_step (const course *c, gs_kept_steps *kept, gs_real tn, gs_real length, int side)
{
  const int nx = c->g.nx, n = 4 + 13 * nx;
  if (kept->steps == kept->room)
    {
      const int room = gs_most (64, 2 * kept->room);
      gs_real *all = (gs_real *)realloc (kept->numbers,
                                         (size_t)room * (size_t)n * sizeof *all);
      if (! all)
        return 0;
      kept->numbers = all;
      kept->room = room;
    }
  gs_real *one = kept->numbers + (ptrdiff_t)n * kept->steps++;
  one[0] = c->t;
  one[1] = tn;
  one[2] = length;
  one[3] = (gs_real)side;
  gs_copy (nx, c->x, one + 4);
  gs_copy (12 * nx, c->w, one + 4 + nx);
  return 1;
}

/* one trial step to the stop `end` or less; info as gs_adjoint_forward */
static int
try_step (course *c, gs_kept_steps *kept, gs_real end)
{
  if (gs_rates_at (&c->g, c->t, 1, c->x, c->w) != 0)
    return GS_TOO_SMALL; /* no step is short enough where the rates fail */
  if (c->h <= 0 && gs_first_step (&c->g, c->t, end - c->t, c->x, c->w, &c->h) != 0)
    c->h = end - c->t;
  const int last = c->t + (gs_real)1.01 * c->h >= end, side = last ? -1 : 1;
  const gs_real length = last ? end - c->t : c->h, tn = last ? end : c->t + c->h;
  gs_real err = 0;
  const int info = gs_step_dp853 (&c->g, c->t, tn, side, length, c->x, c->xn, &err, c->w);
  if (info != 0 || ! (err >= 0))
    err = (gs_real)1e10;
  const gs_real factor = err > 0 ? (gs_real)(0.9 * pow ((double)err, -0.125)) : 6;
  if (err <= 1)
    {
      const gs_real next = length * gs_min (6, gs_max ((gs_real)(1.0 / 3), factor));
      if (! keep_step (c, kept, tn, length, side))
        return GS_OUT_OF_MEMORY;
      gs_copy (c->g.nx, c->xn, c->x);
      c->t = tn;
      c->h = last ? gs_max (c->h, next) : next;
    }
  else
    c->h = length * gs_min ((gs_real)0.9, gs_max ((gs_real)0.2, factor));
  return c->h < (gs_real)1e-14 * gs_max ((gs_real)1e-30, end) ? GS_TOO_SMALL : ask (c, c->t);
}

int
gs_adjoint_forward (const gs_adjoint_run *run, const gs_real *x0, int ns, const gs_real *stops,
                    gs_real rtol, const gs_real *atol, gs_kept_steps *kept, gs_real *states,
                    gs_real *reached)
{
  const int nx = run->scene->nx;
  course c;
  int info = begin (&c, run, stops[0], rtol, atol, x0);
  *kept = (gs_kept_steps){ .ns = ns };
  kept->counts = (int *)calloc ((size_t)gs_most (1, ns), sizeof *kept->counts);
  if (! kept->counts)
    info = GS_OUT_OF_MEMORY;
  gs_copy (nx, x0, states);
  for (int i = 1; i < ns && info == 0; i++)
    {
      while (c.t < stops[i] && info == 0)
        info = try_step (&c, kept, stops[i]);
      kept->counts[i] = kept->steps;
      gs_copy (nx, c.x, states + nx * i);
    }
  *reached = c.t;
  free (c.block);
  return info;
}

/* ----------------------------------------------------------------------------------- backward */

/* the step back that is number `step` (from 0) of those kept */
static int
step_back (course *c, const gs_kept_steps *kept, int step, gs_real *by_start,
           gs_real *by_parameters)
{
  const gs_scene *s = c->g.s;
  const gs_real *one = kept->numbers + (ptrdiff_t)(4 + 13 * s->nx) * step;
  const int info = gs_step_back_dp853 (s, one[0], one[1], one[3] < 0 ? -1 : 1, one[2], one + 4,
                                       one + 4 + s->nx, s->nsp, c->g.ip, c->g.rp, c->g.cst, c->g.v,
                                       by_start, by_parameters, c->w, c->g.w);
  c->t = one[0];
  return info != 0 ? info : ask (c, c->t);
}

int
gs_adjoint_backward (const gs_adjoint_run *run, const gs_kept_steps *kept, const gs_real *weights,
                     gs_real *by_start, gs_real *by_parameters, gs_real *reached)
{
  const int nx = run->scene->nx;
  const gs_real t = kept->steps > 0 ? kept->numbers[0] : 0;
  course c;
  gs_zero (nx, by_start);
  gs_zero (run->scene->nsp, by_parameters);
  int step = kept->steps, info = begin (&c, run, t, 0, 0, kept->steps > 0 ? kept->numbers + 4
                                                                          : by_start);
  for (int i = kept->ns - 1; i >= 0 && info == 0; i--)
    {
      while (i < kept->ns - 1 && step > kept->counts[i] && info == 0)
        info = step_back (&c, kept, --step, by_start, by_parameters);
      for (int j = 0; j < nx && info == 0; j++)
        by_start[j] += weights[j + nx * i];
    }
  *reached = c.t;
  free (c.block);
  return info;
}

void
gs_adjoint_free (gs_kept_steps *kept)
{
  free (kept->counts);
  free (kept->numbers);
  *kept = (gs_kept_steps){ 0 };
}
