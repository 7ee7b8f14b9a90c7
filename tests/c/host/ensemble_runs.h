/* ensemble_runs.h: emitted scenes as ensembles, with routines over lanes that call those of one
 * run, and single runs beside them, for ensemble_runs.c. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include "gsmbp/solve.h"
#include "host/ensemble/ensemble.h"

/* runs, output times, most states of a scene */
enum { N = 37, NT = 6, NX = 8, NCST = 400 };

/* a scene whose runs differ in a parameter and their starts */
typedef struct
{
  const char *name;
  const gs_scene *s;
  gs_pre *pre;
  const gs_lane_routines *lanes;
  int npar, ncst, which;      /* which: the parameter that differs, from 1 */
  gs_real par[40], x0[NX];
  gs_real scatter;            /* of the starts */
  double tend;                /* [s] */
} subject;

/* what all runs of a subject have in common, with what it points to */
typedef struct
{
  const subject *j;
  gs_ensemble e;
  gs_rows rows;
  gs_description about;
  gs_implicit implicit;
  gs_real tout[NT], ropt[3], atol[NX], table[N], starts[N * NX], cst[NCST];
  double nominal[NX];
  int iopt[6], which[1];
} given;

static void
check (const char *what, const char *of, int true_)
{
  printf ("%sok %s: %s\n", true_ ? "" : "not ", of, what);
}

static void *
zeros (size_t n, size_t size)
{
  void *all = calloc (n + 1, size);
  if (! all)
    abort ();
  return all;
}

/* numbers between -1 and 1, the same in every run of the program */
static double
scattered (int k)
{
  return fmod (k * 0.6180339887498949, 1.0) * 2 - 1;
}

static void
plan_runs (given *g)
{
  gs_integration *r = &g->e.run;
  static const gs_real none[8] = { 0 };
  const gs_plan plan = { .s = g->j->s, .nx = r->nx, .constants = none, .events = 60 };
  g->e.wholes = (size_t)gs_wholes (&plan);
  g->e.reals = (size_t)gs_reals (&plan);
  r->ip = zeros (g->e.wholes, sizeof (int));
  r->rp = zeros (g->e.reals, sizeof (gs_real));
  gs_lay (&plan, r->ip, r->rp);
}

/* N runs by a method (iopt[GS_METHOD]); lanes: whether they are in lanes */
static void
give (given *g, const subject *j, int method, int lanes)
{
  const int nx = j->s->nx;
  memset (g, 0, sizeof *g);
  g->j = j;
  g->iopt[GS_METHOD] = method;
  g->iopt[GS_LOOPS] = j->s->nlam > 0 ? 2 : 1;
  g->iopt[GS_DRIFT] = g->iopt[GS_WATCH] = j->s->nlam > 0;
  g->ropt[0] = method == 4 ? GS_R (1e-3) : 0;
  g->ropt[1] = GS_R (1e-9);
  g->which[0] = j->which;
  for (int k = 0; k < nx; k++)
    {
      g->atol[k] = GS_R (1e-10);
      g->nominal[k] = 1;
    }
  for (int k = 0; k < NT; k++)
    g->tout[k] = (gs_real)j->tend * (gs_real)k / (NT - 1);
  for (int i = 0; i < N; i++)
    {
      g->table[i] = j->par[j->which - 1] * (gs_real)(1 + 0.05 * scattered (i + 1));
      for (int k = 0; k < nx; k++)
        g->starts[i * nx + k] = j->x0[k] + j->scatter * (gs_real)scattered (7 * i + k);
    }
  g->about = (gs_description){ .scene = j->s, .nominal = g->nominal };
  if (j->pre (j->par, g->cst) != 0)
    abort ();
  g->e = (gs_ensemble){
    .scene = j->s, .about = &g->about, .pre = j->pre, .lanes = lanes ? j->lanes : NULL,
    .npar = j->npar, .ncst = j->ncst, .implicit = &g->implicit,
    .run = { .nx = nx, .x0 = j->x0, .nt = NT, .tout = g->tout, .iopt = g->iopt, .ropt = g->ropt,
             .atol = g->atol, .cst = g->cst, .ldx = nx, .ldv = j->s->nv + 1 }
  };
  plan_runs (g);
  g->e.run.lw = gs_room (j->s, nx, 0);
  g->rows = (gs_rows){ .n = N, .par = j->par, .varied = 1, .which = g->which,
                       .table = { g->table, 1, N }, .starts = { g->starts, nx, 1 } };
}

static void
take_away (given *g)
{
  free (g->e.run.ip);
  free (g->e.run.rp);
}

/* results of all runs, and how often each was taken */
typedef struct
{
  gs_results all;
  double x[N * NX * NT], info[2 * N], counts[GS_COUNTED * N], values[GS_MEASURED * N];
  double counted[3 * 8 * N];
  char *reason[N];
  int taken[N];
} found;

static void
count_and_keep (void *to, const gs_ensemble *e, gs_member *m)
{
  found *f = to;
  f->taken[m->row]++;
  gs_keep_member (&f->all, e, m);
}

static void
run_all (const given *g, int threads, found *f)
{
  memset (f, 0, sizeof *f);
  for (int k = 0; k < N * NX * NT; k++)
    f->x[k] = NAN;
  f->all = (gs_results){ .x = f->x, .counts = f->counts, .values = f->values, .info = f->info,
                         .counted = f->counted, .reason = f->reason };
  if (gs_run_ensemble (&g->e, &g->rows, threads, count_and_keep, f, NULL) != 0)
    abort ();
}

static void
forget (found *f)
{
  for (int i = 0; i < N; i++)
    free (f->reason[i]);
}

/* 1: the same bytes in all that is kept */
static int
same (const found *a, const found *b)
{
  return memcmp (a->x, b->x, sizeof a->x) == 0 && memcmp (a->info, b->info, sizeof a->info) == 0
         && memcmp (a->counts, b->counts, sizeof a->counts) == 0
         && memcmp (a->values, b->values, sizeof a->values) == 0
         && memcmp (a->counted, b->counted, sizeof a->counted) == 0;
}

/* state k of run i at output time t */
static double
state_of (const found *f, const given *g, int i, int k, int t)
{
  return f->x[NT * (g->j->s->nx * i + k) + t];
}

/* run i by itself, without the host files of ensembles; its calls of rhs, x (nx,NT) */
static int
single (const given *g, int i, gs_real *x, int *info)
{
  const subject *j = g->j;
  const int nx = j->s->nx;
  const size_t reals = g->e.reals, wholes = g->e.wholes;
  gs_real par[40], cst[NCST], x0[NX], v[8 * NT] = { 0 };
  gs_scene scene = *j->s;
  gs_start_given at = { .cst = cst, .check = g->e.check };
  gs_start start;
  memcpy (par, j->par, sizeof par);
  par[j->which - 1] = g->table[i];
  if (j->pre (par, cst) != 0)
    abort ();
  for (int k = 0; k < nx; k++)
    x0[k] = g->starts[i * nx + k];
  if (gs_take_start (&g->about, &at, x0, &start) != GS_START_TAKEN)
    abort ();
  gs_integration r = g->e.run;
  r.x0 = x0;
  r.cst = cst;
  r.xout = x;
  r.vout = v;
  r.ip = zeros (wholes, sizeof (int));
  r.rp = zeros (reals, sizeof (gs_real));
  r.w = zeros ((size_t)r.lw, sizeof (gs_real));
  memcpy (r.ip, g->e.run.ip, wholes * sizeof (int));
  memcpy (r.rp, g->e.run.rp, reals * sizeof (gs_real));
  memcpy (r.w, x0, (size_t)j->s->nu * sizeof (gs_real));
  *info = g->iopt[GS_METHOD] == 0 ? g->e.method (&scene, &r, &g->implicit)
                                  : gs_integrate (&scene, &r);
  free (r.ip);
  free (r.rp);
  free (r.w);
  return r.istat[GS_N_RHS];
}
