/* derivatives.c: a run with columns made and freed: its routines, its arrays. */
#include <stdlib.h>

#include "host/derivatives/columns.h"

/* does event i (from 0) change what follows? One of the user that may end the run does where the
   scene has urp: it says that nothing changes, if so */
static int
event_changes (const gs_derivatives *d, const gs_derivatives_given *given, int i)
{
  if (given->changes)
    return given->changes[i] != 0;
  return ! gs_is_own (&d->events, i) || (d->inner.urp && ! gs_reports (&d->events, i));
}

/* the routine that the columns need and the scene lacks; null: none */
static const char *
missing_routine (const gs_derivatives *d, const gs_derivatives_given *given)
{
  const gs_scene *s = &d->inner;
  const int sampled = d->has_samples;
  const struct { const char *name; int lacks; } needed[] = {
    { "rhp", ! s->rhp },
    { "con", s->nlam > 0 && ! s->con },
    { "tan", s->nlam > 0 && ! s->tan },
    { "cop", s->nlam > 0 && ! s->cop },
    { "cmp", d->ip[GS_V0] == 2 && ! s->cmp },
    { "evp", d->has_events && ! s->evp },
    { "jac", sampled && s->ny > 0 && ! s->jac },
    { "oup", sampled && s->ny > 0 && ! s->oup },
    { "ctd", sampled && ! s->ctd },
  };
  for (int i = 0; i < (int)(sizeof needed / sizeof *needed); i++)
    if (needed[i].lacks)
      return needed[i].name;
  for (int i = 0; d->has_events && i < d->events.ne; i++)
    {
      if (! gs_is_own (&d->events, i) && ! s->rsp)
        return "rsp";
      if (gs_is_own (&d->events, i) && event_changes (d, given, i) && ! s->urp)
        return "urp";
    }
  return 0;
}

/* ---------------------------------------------------------------------------------- its arrays */

/* an array of n numbers in a block */
typedef struct { gs_real **to; int n; } gs_numbers_part;
typedef struct { double **to; int n; } gs_doubles_part;
typedef struct { int **to; int n; } gs_wholes_part;

/* a block of zeros with room for all parts, which begin where they belong; null: no memory */
#define GS_LAY(name, part, type)                                                                   \
  static void *name (const part *all, int count)                                                   \
  {                                                                                                \
    size_t n = 1;                                                                                  \
    for (int i = 0; i < count; i++)                                                                \
      n += (size_t)all[i].n;                                                                       \
    type *block = (type *)calloc (n, sizeof *block), *at = block;                                  \
    for (int i = 0; block && i < count; i++)                                                       \
      {                                                                                            \
        *all[i].to = at;                                                                           \
        at += all[i].n;                                                                            \
      }                                                                                            \
    return block;                                                                                  \
  }
GS_LAY (lay_numbers, gs_numbers_part, gs_real)
GS_LAY (lay_doubles, gs_doubles_part, double)
GS_LAY (lay_wholes, gs_wholes_part, int)
#define GS_COUNT(all) ((int)(sizeof all / sizeof *all))

static void *
numbers_of (gs_derivatives *d)
{
  const gs_scene *s = &d->inner;
  const int nc = d->nc, nx = s->nx, nq = s->nq, nu = s->nu, nv = s->nv, ny = s->ny, np = s->nsp,
            m = s->nlam, nk = s->nxk, n = nx + nv, rows = m + d->nsets, all = nx * (1 + nc),
            motion = 2 * nu * (d->ip[GS_DERIVATIVES] + 1) + 5 * all + nv * all + 21,
            ne = d->has_events ? d->events.ne : 0, feedback = d->ip[GS_FEEDBACK] == 1,
            most = gs_most (nx, gs_most (nv, feedback * nv * nx)), sampled = d->has_samples;
  const gs_numbers_part parts[] = {
    { &d->atol, nx }, { &d->tau, nc }, { &d->reports, nc * ne },
    { &d->vp, nv * nc }, { &d->vt, nv * nc }, { &d->gain, nv * nx }, { &d->vx, nv * d->na },
    { &d->vm, nv * np }, { &d->kp, nk * nc }, { &d->yp, ny * nc },
    { &d->w, nx * (nx + np + nv + 1) },
    { &d->w2, rows * (nq + rows + nc) + m * (nq + nu + 2 * np + 3) },
    { &d->wi, motion }, { &d->w3, motion }, { &d->change, nv },
    { &d->slopes.v, nv }, { &d->slopes.gains, feedback * nv * nx },
    { &d->slopes.moves, nx }, { &d->slopes.wanted, nx }, { &d->slopes.f, 2 * gs_most (1, most) },
    { &d->slopes.xi, d->na },
    { &d->before.v, nv }, { &d->before.f, nx }, { &d->before.slopes, nv },
    { &d->before.g, n + np + 1 },
    { &d->set.r, s->urp ? n * (n + np + 1) : 0 }, { &d->set.xa, nx },
    { &d->at.y, nx }, { &d->at.h, nx }, { &d->at.g, n + np + 1 }, { &d->at.values, ne },
    { &d->at.tau, nc }, { &d->at.states, all }, { &d->at.x, nx }, { &d->at.v, nv },
    { &d->at.given, nv }, { &d->at.rates, nx },
    { &d->resets.r, s->rsp ? nu * (nq + nu + np + 1) : 0 }, { &d->resets.u, nu },
    { &d->resets.before, n }, { &d->resets.after, n },
    { &d->rows.dp, m * nq }, { &d->rows.dv, m * nq }, { &d->rows.hc, m * nu }, { &d->rows.phi, m },
    { &d->rows.phit, m }, { &d->rows.gam, m }, { &d->rows.pp, m * np }, { &d->rows.pv, m * np },
    { &d->rows.qdot, gs_most (nq, nu) },
    { &d->loops.b, m * nc }, { &d->loops.system, m * (gs_most (nq, nu) + nc) },
    { &d->outputs.a, sampled * nx * nx }, { &d->outputs.b, sampled * nx * nv },
    { &d->outputs.c, sampled * ny * nx }, { &d->outputs.d, sampled * ny * nv },
    { &d->outputs.p, sampled * ny * np },
    { &d->outputs.ctd, sampled * (nv + nk) * (nv + nk + ny + np) },
    { &d->outputs.z, nv + nk }, { &d->outputs.now, nv * nc },
  };
  return lay_numbers (parts, GS_COUNT (parts));
}

static void *
doubles_of (gs_derivatives *d)
{
  const int ne = d->has_events ? d->events.ne : 0, nr = d->has_events ? d->events.nr : 0;
  const gs_doubles_part parts[] = {
    { &d->lost_at, d->nc }, { &d->times, d->nc * nr }, { &d->t1, ne }, { &d->t2, ne },
    { &d->g1, ne }, { &d->g2, ne }, { &d->most, ne }, { &d->turns, ne > 0 ? 2 * GS_MOST_TURNS : 0 },
    { &d->switched, d->inner.nv },
  };
  return lay_doubles (parts, GS_COUNT (parts));
}

static void *
wholes_of (gs_derivatives *d)
{
  const gs_scene *s = &d->inner;
  const int nc = d->nc, ne = d->has_events ? d->events.ne : 0, widest = gs_most (s->nq, s->nu);
  const gs_wholes_part parts[] = {
    { &d->col, nc }, { &d->sets, 4 * d->nsets }, { &d->why, nc }, { &d->event, nc },
    { &d->changes, ne }, { &d->reported, ne }, { &d->own, s->nv },
    { &d->own_ip, GS_NUMBERS + d->ip[GS_PLANNED] }, { &d->iw, s->nlam + d->nsets + 1 },
    { &d->at.modes, s->nev }, { &d->loops.set, s->nx }, { &d->loops.free, widest },
    { &d->loops.where, widest }, { &d->loops.used, s->nlam },
  };
  return lay_wholes (parts, GS_COUNT (parts));
}

/* pending outputs with their room */
static int
lay_sent (gs_derivatives *d)
{
  const int np = d->has_samples ? d->samples.np : 0, n = d->inner.nv * d->nc;
  d->sent = (gs_sent_outputs *)calloc ((size_t)np + 1, sizeof *d->sent);
  gs_real *inputs = (gs_real *)calloc ((size_t)np * (size_t)n + 1, sizeof *inputs);
  d->blocks[3] = inputs;
  for (int i = 0; d->sent && inputs && i < np; i++)
    d->sent[i].inputs = inputs + n * i;
  return d->sent && inputs;
}

static int
lay_arrays (gs_derivatives *d, const gs_derivatives_given *given)
{
  d->blocks[0] = numbers_of (d);
  d->blocks[1] = doubles_of (d);
  d->blocks[2] = wholes_of (d);
  d->constants = (gs_column_constants *)malloc (
      sizeof *d->constants + (size_t)gs_most (1, given->ncst) * sizeof (gs_real));
  return lay_sent (d) && d->blocks[0] && d->blocks[1] && d->blocks[2] && d->constants;
}

/* ------------------------------------------------------------------------------------ the run */

static void
fill_arrays (gs_derivatives *d, const gs_derivatives_given *given)
{
  d->constants->run = d;
  gs_copy (given->ncst, given->cst, d->constants->numbers);
  gs_copy (d->inner.nx, given->atol, d->atol);
  if (given->guess)
    gs_copy (d->inner.nu, given->guess, d->wi);
  for (int k = 0; k < d->nc; k++)
    d->col[k] = given->col[k];
  for (int i = 0; i < 4 * d->nsets; i++)
    d->sets[i] = given->sets[i];
  for (int i = 0; i < d->inner.nv; i++)
    d->switched[i] = HUGE_VAL;
  for (int i = 0; d->has_events && i < d->events.ne; i++)
    d->changes[i] = event_changes (d, given, i);
}

/* the routines of the scene, each where the scene has it */
static void
wrap_scene (gs_derivatives *d)
{
  const gs_scene *s = &d->inner;
  d->outer = *s;
  d->outer.data = d;
  d->outer.rhs = gs_columns_rhs;
  d->outer.prj = s->prj ? gs_columns_prj : 0;
  d->outer.out = s->out ? gs_columns_out : 0;
  d->outer.ctl = s->ctl ? gs_columns_ctl : 0;
  d->outer.evt = s->evt ? gs_columns_evt : 0;
  d->outer.rst = s->rst ? gs_columns_rst : 0;
  d->outer.vin = gs_columns_vin;
}

static void
read_plan (gs_derivatives *d, const gs_derivatives_given *given)
{
  const int all = given->scene->nx * (1 + given->nc);
  d->inner = *given->scene;
  d->nc = given->nc;
  d->nsets = given->nsets;
  d->na = d->inner.nx - d->inner.nq - d->inner.nu;
  d->ip = given->ip;
  d->rp = given->rp;
  d->rtol = given->rtol;
  d->has_events = d->ip[GS_EVENTS] > 0;
  d->has_samples = d->ip[GS_SAMPLES] > 0;
  if (d->has_events)
    d->events = gs_planned_events (all, d->ip, d->rp);
  if (d->has_samples)
    d->samples = gs_planned_samples (&d->inner, d->ip, d->rp);
}

gs_derivatives *
gs_derivatives_open (const gs_derivatives_given *given, const char **missing)
{
  gs_derivatives *d = (gs_derivatives *)calloc (1, sizeof *d);
  *missing = 0;
  if (! d)
    return 0;
  read_plan (d, given);
  *missing = missing_routine (d, given);
  if (*missing || ! lay_arrays (d, given))
    {
      gs_derivatives_close (d);
      return 0;
    }
  fill_arrays (d, given);
  wrap_scene (d);
  gs_columns_take_inputs (d);
  d->top = gs_columns_plain_speeds (d) ? d->inner.nq : 0;
  if (d->has_events)
    *d->events.tells = 1;
  return d;
}

void
gs_derivatives_close (gs_derivatives *d)
{
  if (! d)
    return;
  for (int i = 0; i < (int)(sizeof d->blocks / sizeof *d->blocks); i++)
    free (d->blocks[i]);
  free (d->sent);
  free (d->constants);
  free (d->held);
  free (d);
}

const gs_scene *
gs_derivatives_scene (const gs_derivatives *d)
{
  return &d->outer;
}

const gs_real *
gs_derivatives_constants (const gs_derivatives *d)
{
  return gs_columns_constants (d);
}
