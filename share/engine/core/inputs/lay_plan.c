/* The plan of a run, laid out: gs_wholes, gs_reals, gs_lay, gs_due_from of plan.h. In Fortran
 * whoever calls gs_integrate lays it out. */
#include "gsmbp/arith.h"
#include "gsmbp/plan.h"

#include <string.h>

/* where the next numbers go, from 0 */
typedef struct
{
  int i, r;
} place;

static int
length_of (const gs_pieces *a)
{
  return a->np > 0 ? a->np + 1 + a->nc * a->np * a->k : 0;
}

static int
sample_wholes (const gs_plan *p)
{
  const gs_scene *s = p->s;
  return s->nctl > 0 ? 11 + 4 * s->nctl + s->nheld + 2 * p->on_the_way : 0;
}

static int
sample_reals (const gs_plan *p)
{
  const gs_scene *s = p->s;
  if (s->nctl == 0)
    return 0;
  return 2 * s->nctl + s->nheld + s->nxk + s->ny + s->nv + p->on_the_way * (1 + s->nheld)
         + p->instants * (1 + s->nxk + s->nv) + s->nheld + s->nxk + p->on_the_way * (1 + s->nheld);
}

int
gs_wholes (const gs_plan *p)
{
  return GS_NUMBERS + p->motion.nc + sample_wholes (p) 
         + (p->s->nev > 0 ? 11 + 7 * p->s->nev + 3 * p->s->nswitch : 0);
}

int
gs_reals (const gs_plan *p)
{
  const int n = p->s->nev;
  return gs_most (1, p->s->nv) + length_of (&p->table) + length_of (&p->motion)
         + length_of (&p->reference) + length_of (&p->gain) + (p->limits ? 2 * p->s->nv : 0)
         + sample_reals (p) 
         + (n > 0 ? (16 + p->nx) * n + 3 * p->nx + p->events * (3 + 2 * p->nx) + p->s->nswitch : 0)
         + 1;
}

/* numbers copied to the next places, from which on */
static int
put (const gs_real *numbers, int n, gs_real *rp, place *at)
{
  const int first = at->r + 1;
  if (n > 0)
    gs_copy (n, numbers, rp + at->r);
  at->r += n;
  return first;
}

static void
lay_pieces (const gs_pieces *a, int which, int *ip, gs_real *rp, place *at)
{
  if (a->np == 0)
    return;
  ip[which] = a->np;
  ip[which + 1] = a->k;
  ip[which + 2] = put (a->numbers, length_of (a), rp, at);
  ip[which + 3] = ip[which + 2] + a->np + 1;
}

static void
lay_inputs (const gs_plan *p, int *ip, gs_real *rp, place *at)
{
  const gs_scene *s = p->s;
  ip[GS_V0] = p->inputs;
  ip[GS_DERIVATIVES] = p->derivatives;
  if (p->constants)
    gs_copy (s->nv, p->constants, rp);
  at->r = gs_most (1, s->nv);
  if (p->inputs == 0)
    ip[GS_TABLE + 3] = 1;
  lay_pieces (&p->table, GS_TABLE, ip, rp, at);
  lay_pieces (&p->motion, GS_MOTION, ip, rp, at);
  if (p->motion.np > 0)
    {
      ip[GS_CLOSED] = s->nlam > 0 && p->motion.nc < s->nu;
      ip[GS_PLANNED] = p->motion.nc;
      ip[GS_INTERNAL] = s->nq + s->nu + 1;
      memcpy (ip + GS_NUMBERS, p->planned, (size_t)p->motion.nc * sizeof (int));
      at->i += p->motion.nc;
    }
  ip[GS_FEEDBACK] = p->gain.np > 0;
  lay_pieces (&p->reference, GS_REFERENCE, ip, rp, at);
  lay_pieces (&p->gain, GS_GAIN, ip, rp, at);
  if (p->limits)
    ip[GS_LIMITS] = put (p->limits, 2 * s->nv, rp, at);
}

static void
lay_samples (const gs_plan *p, int *ip, gs_real *rp, place *at)
{
  const gs_scene *s = p->s;
  const gs_real *memory = p->memory ? p->memory : s->memory;
  const int head[6] = { s->nctl, s->nxk, s->ny, s->nheld, p->on_the_way, p->instants };
  if (s->nctl == 0)
    return;
  ip[GS_SAMPLES] = at->i + 1;
  ip[GS_SAMPLES + 1] = at->r + 1;
  memcpy (ip + at->i, head, sizeof head);
  gs_samples a = gs_planned_samples (s, ip, rp);
  *a.tabled = p->inputs == 1 && ! p->constants;
  ip[GS_HELD] = s->nheld;
  ip[GS_HELD + 1] = (int)(a.input - ip) + 1;
  ip[GS_HELD_AT] = (int)(a.value - rp) + 1;
  for (int k = 0; k < s->nctl; k++)
    {
      a.held[k] = s->held_counts[k];
      a.anew[k] = s->again[k];
      a.period[k] = 1;
    }
  for (int k = 0; k < s->nheld; k++)
    {
      a.input[k] = s->held_inputs[k];
      a.value[k] = p->constants ? p->constants[a.input[k] - 1] : 0;
    }
  for (int k = 0; k < s->nxk; k++)
    a.memory[k] = memory[k];
  at->i += sample_wholes (p);
  at->r += sample_reals (p);
}

static void
lay_events (const gs_plan *p, int *ip, gs_real *rp, const place *at)
{
  const gs_scene *s = p->s;
  if (s->nev == 0)
    return;
  ip[GS_EVENTS] = at->i + 1;
  ip[GS_EVENTS + 1] = at->r + 1;
  ip[at->i] = s->nev;
  ip[at->i + 1] = p->events;
  ip[at->i + 4] = p->modes != 0;
  ip[at->i + 9] = s->nswitch;
  gs_events a = gs_planned_events (p->nx, ip, rp);
  for (int k = 0; k < s->nev; k++)
    {
      a.mode[k] = p->modes ? p->modes[k] : 0;
      a.input[k] = s->event_inputs[k];
      a.kind[k] = s->event_kinds[k];
    }
  for (int k = 0; k < s->nswitch; k++)
    {
      a.by[k] = s->switch_events[k];
      a.switched[k] = s->switch_inputs[k];
    }
}

void
gs_lay (const gs_plan *p, int *ip, gs_real *rp)
{
  place at = { GS_NUMBERS, 0 };
  lay_inputs (p, ip, rp, &at);
  lay_samples (p, ip, rp, &at);
  lay_events (p, ip, rp, &at);
}

/* the number of the first sample at t0 or later: sample k is at k*period; a start that differs from
 * one by rounding only is one; in quad precision by rounding to double, which hosts have t0 in */
static gs_real
first_sample (gs_real t0, gs_real period)
{
  gs_real k = gs_floor (t0 / period + GS_R (0.5));
  const gs_real rounding = 8 * gs_max (GS_EPSILON, DBL_EPSILON) * gs_abs (t0);
  return gs_abs (k * period - t0) <= rounding ? k : gs_ceil (t0 / period);
}

/* what is held before the first samples: the values of the table at t0, from the right, as
 * gs_polynomials_at has them */
static void
hold_table (int nv, gs_real t0, const int *ip, const gs_real *rp, const gs_samples *a)
{
  if (*a->tabled == 0)
    return;
  const int np = ip[GS_TABLE], order = ip[GS_TABLE + 1];
  const gs_real *at = rp + ip[GS_TABLE + 2] - 1, *c = rp + ip[GS_TABLE + 3] - 1;
  int i = 0;
  while (i < np - 1 && t0 >= at[i + 1])
    i++;
  const gs_real t = t0 < at[0] ? at[0] : t0 > at[np] ? at[np] : t0;
  for (int k = 0; k < a->nh; k++)
    {
      a->value[k] = 0;
      for (int j = 0; j < order; j++)
        a->value[k] = a->value[k] * (t - at[i]) + c[a->input[k] - 1 + nv * (i + np * j)];
    }
}

int
gs_due_from (const gs_scene *s, gs_real t0, const gs_real *cst, int *ip, gs_real *rp)
{
  if (s->nctl == 0)
    return 0;
  gs_samples a = gs_planned_samples (s, ip, rp);
  s->ctp (cst, a.period, a.delay);
  for (int k = 0; k < s->nctl; k++)
    {
      if (! (a.period[k] > 0) || ! (a.delay[k] >= 0))
        return k + 1;
      gs_real next = first_sample (t0, a.period[k]);
      if (! (gs_abs (next) < GS_R (2e9)))
        return -(k + 1);
      a.next[k] = (int)next;
    }
  hold_table (s->nv, t0, ip, rp, &a);
  return 0;
}
