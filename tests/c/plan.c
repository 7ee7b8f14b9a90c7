/* share/engine/core/inputs/lay_plan.c: plans laid out by gs_lay, and by hand as the head of GSINP
 * says: the same inputs, the first by the C, the others by the Fortran; no plan is longer than it
 * says. */
#include "bridge.h"

#include "gsmbp/plan.h"

void gsinp_ ();

enum { NU = 2, NX = 5, NV = 6 };

static int
any_cmd (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v,
         gs_real *xid)
{
  (void)cst;
  for (int i = 0; i < NV; i++)
    v[i] = qj[i % 6] + t * i + xi[0];
  xid[0] = 0;
  return 0;
}

static void
some_ctp (const gs_real *cst, gs_real *period, gs_real *delay)
{
  for (int k = 0; k < 2; k++)
    {
      period[k] = cst[2 * k];
      delay[k] = cst[2 * k + 1];
    }
}

static const int event_inputs[2] = { 4, 6 }, event_kinds[2] = { 1, 2 };
static const int held_counts[2] = { 1, 1 }, again[2] = { 0, 1 }, held_inputs[2] = { 2, 5 };
static const gs_real starts[3] = { 0.5, -0.25, 2 };
static gs_scene scene = {
  .nq = NU, .nu = NU, .nx = NX, .nv = NV, .ny = 1, .cmd = any_cmd, .ctp = some_ctp,
  .event_inputs = event_inputs, .event_kinds = event_kinds, .held_counts = held_counts,
  .again = again, .held_inputs = held_inputs, .memory = starts
};

/* all numbers that a plan is made of */
typedef struct
{
  gs_real constants[NV], table[3 + NV * 2 * 3], motion[3 + NU * 2 * 3], reference[2 + NX],
    gain[2 + NV * NX], limits[2 * NV], memory[3];
  int planned[NU], modes[2];
} numbers;

static void
fill (int n, gs_real *x)
{
  for (int i = 0; i < n; i++)
    x[i] = chance ();
}

static gs_plan
some_plan (numbers *a)
{
  gs_plan p = { .s = &scene, .nx = NX, .inputs = pick (3), .derivatives = 2 };
  fill (sizeof *a / sizeof (gs_real) - 2, (gs_real *)a);
  memcpy (a->table, (gs_real[]){ 0, 1, 2 }, 3 * sizeof (gs_real));
  memcpy (a->motion, (gs_real[]){ 0, 1, 2 }, 3 * sizeof (gs_real));
  memcpy (a->reference, (gs_real[]){ 0, 1 }, 2 * sizeof (gs_real));
  memcpy (a->gain, (gs_real[]){ 0, 1 }, 2 * sizeof (gs_real));
  for (int i = 0; i < NV; i++)
    a->limits[i + NV] = a->limits[i] + 0.5;
  a->planned[0] = 2;
  a->planned[1] = 1;
  a->modes[0] = pick (3) - 1;
  a->modes[1] = pick (3) - 1;
  p.constants = p.inputs == 0 || pick (2) ? a->constants : NULL;
  if (p.inputs == 1)
    p.table = (gs_pieces){ NV, 2, 3, a->table };
  if (p.inputs == 2)
    {
      p.motion = (gs_pieces){ NU, 2, 3, a->motion };
      p.planned = a->planned;
    }
  if (pick (2))
    {
      p.reference = (gs_pieces){ NX, 1, 1, a->reference };
      p.gain = (gs_pieces){ NV * NX, 1, 1, a->gain };
      p.limits = pick (2) ? a->limits : NULL;
    }
  scene.nctl = scene.nheld = 2 * pick (2);
  scene.nxk = scene.nctl > 0 ? 3 : 0;
  scene.nev = 2 * pick (2);
  p.memory = pick (2) ? a->memory : NULL;
  p.modes = pick (2) ? a->modes : NULL;
  p.on_the_way = pick (4);
  p.instants = pick (4);
  p.events = pick (4);
  return p;
}

/* the same by hand */
static void
by_hand (test *f, const gs_plan *p, const numbers *a)
{
  make (f, &scene, NULL, 1, 1);
  f->ip[GS_V0] = p->inputs;
  f->ip[GS_DERIVATIVES] = 2;
  if (p->inputs == 0)
    memcpy (f->rp, a->constants, sizeof a->constants);
  if (p->inputs == 1)
    polynomial (f, GS_TABLE, NV, 2, 3, a->table, a->table + 3);
  if (p->inputs == 2)
    {
      polynomial (f, GS_MOTION, NU, 2, 3, a->motion, a->motion + 3);
      f->ip[GS_PLANNED] = NU;
      f->ip[GS_INTERNAL] = 2 * NU + 1;
      memcpy (f->ip + GS_NUMBERS, a->planned, sizeof a->planned);
    }
  if (p->gain.np > 0)
    {
      f->ip[GS_FEEDBACK] = 1;
      polynomial (f, GS_REFERENCE, NX, 1, 1, a->reference, a->reference + 2);
      polynomial (f, GS_GAIN, NV * NX, 1, 1, a->gain, a->gain + 2);
    }
  if (p->limits)
    {
      f->ip[GS_LIMITS] = f->nrp + 1;
      memcpy (f->rp + f->nrp, a->limits, sizeof a->limits);
      f->nrp += 2 * NV;
    }
  if (scene.nctl > 0)
    {
      gs_real *held = f->rp + f->nrp + 4;
      samples (f, 2, (gs_real[]){ 0.1, 0.25 }, (gs_real[]){ 0, 0.05 }, held_counts, again,
               held_inputs, 3, p->memory ? p->memory : starts, p->on_the_way, p->instants);
      held[0] = p->constants ? a->constants[1] : 0;
      held[1] = p->constants ? a->constants[4] : 0;
    }
  if (scene.nev > 0)
    {
      int *ie = f->ip + f->nip;
      events (f, 2, event_kinds, event_inputs, p->events);
      for (int k = 0; k < 2 && p->modes; k++)
        ie[10 + k] = a->modes[k];
      ie[4] = p->modes != 0;
    }
}

/* places of the samples and the events in both, and that nothing is behind the last one */
static void
same_parts (const gs_plan *p, int *ip, gs_real *rp, test *f)
{
  if (scene.nctl > 0)
    {
      gs_samples c = gs_planned_samples (&scene, ip, rp), d = gs_planned_samples (&scene, f->ip,
                                                                                  f->rp);
      same_int (gs_due_from (&scene, 0, (gs_real[]){ 0.1, 0, 0.25, 0.05 }, ip, rp), 0);
      if (p->inputs == 1 && ! p->constants)   /* told by the table */
        gs_polynomials_at (NV, 2, 3, p->table.numbers, p->table.numbers + 3, 0, 1, 0, d.v, NV);
      for (int k = 0; k < 2 && p->inputs == 1 && ! p->constants; k++)
        d.value[k] = d.v[d.input[k] - 1];
      same_numbers (2 * 2 + 2 + 3, c.period, d.period);
      for (int k = 0; k < 2; k++)
        same_int (c.held[k] + 10 * c.anew[k] + 100 * c.input[k],
                  d.held[k] + 10 * d.anew[k] + 100 * d.input[k]);
      same_int (c.np + 10 * c.ns, d.np + 10 * d.ns);
      same_int (c.record + p->instants * (1 + scene.nxk + NV) < rp + gs_reals (p), 1);
    }
  if (scene.nev > 0)
    {
      gs_events c = gs_planned_events (NX, ip, rp), d = gs_planned_events (NX, f->ip, f->rp);
      same_int (c.nr + 10 * c.given, d.nr + 10 * d.given);
      for (int k = 0; k < 2; k++)
        same_int (c.mode[k] + 10 * c.input[k] + 100 * c.kind[k],
                  d.mode[k] + 10 * d.input[k] + 100 * d.kind[k]);
      same_int (c.latest + 2 <= rp + gs_reals (p), 1);
      same_int (c.newest + 1 <= ip + gs_wholes (p), 1);
    }
}

static void
plans (void)
{
  static test f;
  begin ("gs_lay, gs_wholes, gs_reals");
  bridged = &scene;
  for (int i = 0; i < 400; i++)
    {
      numbers a;
      const gs_plan p = some_plan (&a);
      int *ip = calloc (gs_wholes (&p), sizeof *ip);   /* lengths: with the address sanitizer */
      gs_real *rp = calloc (gs_reals (&p), sizeof *rp);
      gs_lay (&p, ip, rp);
      by_hand (&f, &p, &a);
      for (int n = 0; n < 5; n++)
        {
          gs_real t = chance () + 1, x[NX], w[100] = { 0 }, g[100] = { 0 };
          pair v = pair_of (NV);
          int info = 0, nu = NU, nx = NX, nv = NV, side = 1;
          fill (NX, x);
          gsinp_ (through.cmd, through.clo, through.vin, &t, &side, x, &nu, &nx, &nv, f.ip, f.rp,
                  f.cst, v.f, g, &info);
          same_int (gs_inputs_of_run (&scene, t, side, x, NX, ip, rp, f.cst, v.c, w), info);
          same (v);
          drop (v);
        }
      same_parts (&p, ip, rp, &f);
      free (ip);
      free (rp);
    }
  finish ();
}

/* the first sample at t0 or later, whatever rounding makes of t0; devices that cannot be */
static void
first_samples (void)
{
  begin ("gs_due_from");
  scene.nctl = scene.nheld = 2;
  scene.nxk = 3;
  scene.nev = 0;
  const gs_plan p = { .s = &scene, .nx = NX };
  int ip[100] = { 0 };
  gs_real rp[200] = { 0 };
  gs_lay (&p, ip, rp);
  const int *next = gs_planned_samples (&scene, ip, rp).next;
  for (int k = -300; k <= 300; k++)
    {
      const gs_real period = GS_R (0.1), t = k * period;
      const gs_real cst[4] = { period, 0, GS_R (0.7), 0 };
      same_int (gs_due_from (&scene, t, cst, ip, rp), 0);
      same_int (next[0], k);
      same_int (next[1], (int)(k >= 0 ? (k + 6) / 7 : -(-k / 7)));
      gs_due_from (&scene, t + 0.01, cst, ip, rp);
      same_int (next[0], k + 1);
    }
  same_int (gs_due_from (&scene, 0, (gs_real[]){ 0.1, 0, 0, 0 }, ip, rp), 2);
  same_int (gs_due_from (&scene, 0, (gs_real[]){ 0.1, -1, 1, 0 }, ip, rp), 1);
  same_int (gs_due_from (&scene, 0, (gs_real[]){ NAN, 0, 1, 0 }, ip, rp), 1);
  same_int (gs_due_from (&scene, 3e9, (gs_real[]){ 1, 0, 2, 0 }, ip, rp), -1);
  scene.nctl = 0;
  same_int (gs_due_from (&scene, 0, rp, ip, rp), 0);
  finish ();
}

int
main (void)
{
  plans ();
  first_samples ();
  return 0;
}
