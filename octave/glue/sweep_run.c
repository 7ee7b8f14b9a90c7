/* The runs of a sweep without Octave; sweep_run.h says what it is. */
#include "sweep_run.h"
#include "gsmbp/plan.h"
#include "host/ensemble/ensemble.h"
#include "gsmbp_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const gsmbp_scene *const S = &gsmbp_the_scene;

static gs_array
numbers (const gs_job *job, const char *name)
{
  gs_array a;
  a.x = gs_numbers (job, name, &a.n);
  return a;
}

static int *
wholes (const gs_job *job, const char *name, long long *count)
{
  const double *x = gs_numbers (job, name, count);
  int *k = calloc ((size_t) *count + 1, sizeof (int));
  for (long long i = 0; k && i < *count; i++)
    k[i] = (int) x[i];
  return k;
}

static int
find_method (gs_sweep *s, char *why)
{
  long long n;
  const char *method = gs_text (s->job, "library", &n);
  s->implicit_method = gs_method_named (method);
#if defined (GS_CVODE)
  if (strcmp (method, "cvode") == 0)
    s->implicit_method = gs_cvode;
#endif
  if (n == 0 || s->implicit_method)
    return 0;
  snprintf (why, GS_WHY, "this program was built without the method %s", method);
  return 1;
}

/* lines RUN<tab>REASON of runs whose parameters break a rule of the scene */
static int
find_broken (gs_sweep *s, char *why)
{
  long long n;
  const char *text = gs_text (s->job, "broken", &n);
  s->broken = calloc ((size_t) s->runs + 1, sizeof (char *));
  s->reasons = calloc ((size_t) n + 1, 1);
  if (! s->broken || ! s->reasons)
    return snprintf (why, GS_WHY, "no memory"), 1;
  memcpy (s->reasons, text, (size_t) n);
  for (char *p = s->reasons, *end = strchr (p, '\n'); end; p = end + 1, end = strchr (p, '\n'))
    {
      const long long i = atoll (p);
      const char *tab = strchr (p, '\t');
      *end = 0;
      if (tab && tab < end && i >= 1 && i <= s->runs)
        s->broken[i - 1] = tab + 1;
    }
  return 0;
}

static int
read_kept (gs_sweep *s)
{
  long long n, m, l;
  s->way = wholes (s->job, "way", &n);
  s->number = wholes (s->job, "number", &m);
  s->time = wholes (s->job, "time", &l);
  for (long long k = 0; k < n; k++)
    {
      s->wholes += s->way[k] == GS_WHOLE;
      s->kept += s->way[k] != GS_WHOLE;
    }
  s->columns = 2 + s->kept + s->wholes * s->tout.n;
  return n != m || n != l;
}

static void
read_numbers (gs_sweep *s)
{
  const gs_job *job = s->job;
  long long n;
  s->cst = numbers (job, "cst");
  s->x0 = numbers (job, "x0");
  s->tout = numbers (job, "tout");
  s->tbrk = numbers (job, "tbrk");
  s->ropt = numbers (job, "ropt");
  s->atol = numbers (job, "atol");
  s->rp = numbers (job, "rp");
  s->guess = numbers (job, "guess");
  s->par = numbers (job, "par");
  s->samples = numbers (job, "samples");
  s->nominal = numbers (job, "nominal");
  s->groups = numbers (job, "groups");
  s->ip = wholes (job, "ip", &s->nip);
  s->iopt = wholes (job, "iopt", &s->niopt);
  s->follows = wholes (job, "follows", &s->followed);
  s->which = wholes (job, "which", &s->varied);
  s->runs = s->varied > 0 ? s->samples.n / s->varied : 0;
  int *sizes = wholes (job, "sizes", &n);
  if (n == 4)
    {
      s->nx = sizes[0];
      s->ldx = sizes[1];
      s->ldv = sizes[2];
      s->lw = sizes[3];
    }
  free (sizes);
  s->order = (int) gs_number (job, "order", 5);
  s->index2 = (int) gs_number (job, "index2", 0);
  s->check_start = (int) gs_number (job, "check_start", 1);
  s->lanes = (int) gs_number (job, "lanes", 0);
  s->t0 = gs_number (job, "t0", 0);
}

int
gs_open_sweep (gs_sweep *s, const gs_job *job, char *why)
{
  memset (s, 0, sizeof *s);
  s->job = job;
  long long n;
  const char *symbol = gs_text (job, "symbol", &n);
  if (strcmp (symbol, S->symbol) != 0)
    return snprintf (why, GS_WHY, "the job is of another scene than the program: %s, not %s",
                     symbol, S->symbol), 1;
  read_numbers (s);
  if (read_kept (s) || s->nx != S->nx || s->par.n != S->npar || s->runs < 1
      || s->nominal.n != S->nx || s->x0.n != S->nx || s->atol.n != S->nx || s->niopt < 6)
    return snprintf (why, GS_WHY, "the job is not whole"), 1;
  return find_method (s, why) || find_broken (s, why);
}

void
gs_close_sweep (gs_sweep *s)
{
  int *lists[] = { s->ip, s->iopt, s->follows, s->which, s->way, s->number, s->time };
  for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
    free (lists[k]);
  free (s->broken);
  free (s->reasons);
}

/* ---- what a row keeps of a run, whose arrays are of a member of the ensemble */

typedef struct
{
  const gs_sweep *s;
  const gs_ensemble *e;
  const gs_member *m;
  double *y;            /* (ny,nt): its outputs */
  long long reached;    /* rows that it has */
} gs_view;

/* the column of the state in row K: a run that an event of the user has ended stays there */
static long long
column (const gs_view *w, long long k)
{
  const long long last = w->m->run.istat[GS_N_OUTPUTS];
  return w->m->info == GS_ENDED && k > last ? last : k;
}

/* outputs at the times that were reached, not a number where there are none */
static void
find_outputs (gs_view *w)
{
  for (long long k = 0; k < w->s->tout.n; k++)
    {
      double *y = w->y + S->ny * k;
      for (int j = 0; j < S->ny; j++)
        y[j] = NAN;
      if (k < w->reached)
        gs_outputs_at (w->e, w->m, (int) k, (int) column (w, k), y);
    }
}

/* state, input or output NUMBER (from 1) at time K; not a number from those that were reached on */
static double
value_at (const gs_view *w, int number, long long k)
{
  const gs_integration *r = &w->m->run;
  int j = number - 1;
  if (k >= w->reached)
    return NAN;
  if (j < S->nx)
    return r->xout[r->ldx * column (w, k) + j];
  j -= S->nx;
  return j < S->nv ? r->vout[r->ldv * column (w, k) + j] : w->y[S->ny * k + j - S->nv];
}

/* the least value of margin NUMBER of the devices */
static double
of_margins (const gs_view *w, int number)
{
  const gs_description *d = w->e->about;
  const gs_integration *r = &w->m->run;
  int passed[S->nsm + 1], fails = ! d->mar;
  double least[S->nsm + 1];
  for (int k = 0; k < S->nsm; k++)
    {
      passed[k] = 1;   /* those need not be found */
      least[k] = HUGE_VAL;
    }
  for (long long k = 0; k < w->reached && ! fails; k++)
    fails = gs_margins_at (d, w->s->tout.x[k], r->xout + r->ldx * column (w, k),
                           r->vout + r->ldv * column (w, k), r->cst, passed, least) < 0;
  return fails ? NAN : least[number - 1];
}

/* sum of the trapezoidal rule as gs.sweep.kept_results has it, of the POWER 1 or 2 */
static double
mean (const gs_view *w, int number, int power)
{
  double sum = 0, before = 0;
  const double *t = w->s->tout.x;
  for (long long k = 0; k < w->s->tout.n; k++)
    {
      double z = value_at (w, number, k);
      z = power == 2 ? z * z : z;
      if (k > 0)
        sum = sum + (t[k] - t[k - 1]) * (z + before);
      before = z;
    }
  return sum / (2 * (t[w->s->tout.n - 1] - t[0]));
}

/* the largest of SIGN times the value, or of its modulus where SIGN is 0; numbers alone count */
static double
largest (const gs_view *w, int number, int sign)
{
  double most = NAN;
  for (long long k = 0; k < w->s->tout.n; k++)
    {
      double z = value_at (w, number, k);
      z = sign == 0 ? fabs (z) : sign * z;
      if (! (z <= most) && ! isnan (z))
        most = z;
    }
  return sign < 0 ? -most : most;
}

/* of the events in the group NUMBER: when the first or the last one was, or how many there were */
static double
of_events (const gs_view *w, int way, int number)
{
  const gs_events a = gs_planned_events (w->s->nx, w->m->run.ip, w->m->run.rp);
  int count = 0;
  double first = NAN, last = NAN;
  for (int k = 0; k < a.ne && w->m->begun; k++)
    {
      if ((int) w->s->groups.x[k] != number || a.times[k] == 0)
        continue;
      first = count == 0 ? a.first[k] : fmin (first, a.first[k]);
      last = count == 0 ? a.latest[k] : fmax (last, a.latest[k]);
      count += a.times[k];
    }
  return way == GS_COUNT ? count : way == GS_FIRST ? first : last;
}

static double
kept (const gs_view *w, long long k)
{
  const int number = w->s->number[k], way = w->s->way[k];
  switch (way)
    {
    case GS_PEAK:
      return largest (w, number, 0);
    case GS_MAX:
      return largest (w, number, 1);
    case GS_MIN:
      return largest (w, number, -1);
    case GS_MEAN:
      return mean (w, number, 1);
    case GS_FIRST:
    case GS_LAST:
    case GS_COUNT:
      return of_events (w, way, number);
    case GS_MARGIN:
      return of_margins (w, number);
    case GS_RMS:
      return sqrt (mean (w, number, 2));
    default:
      return value_at (w, number, w->s->time[k] - 1);
    }
}

/* the row: ok, the time that was reached, what is kept, whole runs */
static void
fill (const gs_view *w, int ok, double reached_time, double *row)
{
  const gs_sweep *s = w->s;
  long long at = 0;
  *row++ = ok;
  *row++ = reached_time;
  for (long long k = 0; k < s->kept + s->wholes; k++)
    if (s->way[k] != GS_WHOLE)
      row[at++] = ok ? kept (w, k) : NAN;
  for (long long k = 0; k < s->kept + s->wholes; k++)
    for (long long i = 0; i < s->tout.n && s->way[k] == GS_WHOLE; i++)
      row[at++] = value_at (w, s->number[k], i);
}

/* ---- rows of a table, which threads fill */

typedef struct
{
  const gs_sweep *s;
  double *rows;          /* (columns,n) */
  char (*why)[GS_WHY];   /* n */
  int no_memory;
} gs_filled;

static void
take_run (void *to, const gs_ensemble *e, gs_member *m)
{
  gs_filled *f = to;
  const gs_sweep *s = f->s;
  char *why = f->why[m->row];
  double *row = f->rows + s->columns * m->row;
  gs_view w = { .s = s, .e = e, .m = m, .reached = m->begun ? m->run.istat[GS_N_OUTPUTS] : 0 };
  const int ended = m->info == GS_ENDED, ok = gs_member_is_done (m);
  if (ended)
    w.reached = s->tout.n;
  w.y = calloc ((size_t) (S->ny * s->tout.n) + 1, sizeof (double));
  if (! w.y)
    {
      f->no_memory = 1;
      return;
    }
  gs_member_failure (e, m, why, GS_WHY);
  find_outputs (&w);
  fill (&w, ok, ok && ! ended ? s->tout.x[s->tout.n - 1] : m->run.rstat[GS_T_REACHED], row);
  free (w.y);
}

/* what all runs have in common, as the job says it */
static gs_ensemble
ensemble_of (const gs_sweep *s)
{
  gs_ensemble e = {
    .scene = S->run, .pre = gsmbp_constants, .npar = S->npar, .ncst = S->ncst, .fortran_inputs = 1,
    .run = { .nx = s->nx, .t0 = s->t0, .x0 = s->x0.x, .nt = (int) s->tout.n, .tout = s->tout.x,
             .nb = (int) s->tbrk.n, .tbrk = s->tbrk.x, .iopt = s->iopt, .ropt = s->ropt.x,
             .atol = s->atol.x, .ip = s->ip, .rp = (double *) s->rp.x, .cst = s->cst.x,
             .ldx = s->ldx, .ldv = s->ldv, .lw = s->lw },
    .wholes = (size_t) s->nip, .reals = (size_t) s->rp.n, .guess = s->guess.x,
    .check = s->check_start, .method = s->implicit_method
  };
  return e;
}

int
gs_sweep_rows (const gs_sweep *s, long long first, int n, int threads, double *rows,
               char (*why)[GS_WHY])
{
  gs_filled filled = { .s = s, .rows = rows, .why = why };
  gs_description about = *S->about;
  gs_lane_routines lanes;
  const gs_implicit options = { .order = s->order, .index2 = s->index2,
                                .followed = (int) s->followed, .follows = s->follows };
  gs_ensemble e = ensemble_of (s);
  about.nominal = s->nominal.x;
  gsmbp_lanes (&lanes);
  e.about = &about;
  e.lanes = s->lanes ? &lanes : NULL;
  e.implicit = &options;
  const gs_rows given = {
    .n = n, .par = s->par.x, .varied = (int) s->varied, .which = s->which,
    .table = { s->samples.x + s->varied * first, (ptrdiff_t) s->varied, 1 },
    .broken = s->broken + first
  };
  return gs_run_ensemble (&e, &given, threads, take_run, &filled, NULL) || filled.no_memory;
}
