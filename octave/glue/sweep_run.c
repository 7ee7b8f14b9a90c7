/* The runs of a sweep without Octave; sweep_run.h says what it is. */
#include "sweep_run.h"
#include "gsmbp/plan.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const gsmbp_scene *const S = &gsmbp_the_scene;

/* a null pointer where there are none */
static gs_array
numbers (const gs_job *job, const char *name)
{
  gs_array a;
  a.x = gs_numbers (job, name, &a.n);
  if (a.n == 0)
    a.x = NULL;
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
  s->columns = 2 + s->kept + s->wholes * s->start.nt;
  return n != m || n != l;
}

static void
read_options (gs_sweep *s)
{
  const gs_job *job = s->job;
  gs_run_options *o = &s->options;
  long long n;
  *o = gs_default_options ();
  o->method = gs_text (job, "method", &n);
  o->loops = gs_text (job, "loops", &n);
  o->loops = n > 0 ? o->loops : NULL;
  o->step = gs_number (job, "step", NAN);
  o->rtol = gs_number (job, "rtol", NAN);
  o->atol = numbers (job, "atol").x;
  o->maxstep = gs_number (job, "maxstep", 0);
  o->maxsteps = gs_number (job, "maxsteps", 0);
  o->maxorder = gs_number (job, "maxorder", NAN);
  o->drift = (int) gs_number (job, "drift", -1);
  o->project = (int) gs_number (job, "project", 0);
#if defined (GS_CVODE)
  o->cvode = gs_cvode;
#endif
}

static gs_pieces
pieces (const gs_job *job, const char *name)
{
  const gs_array a = numbers (job, name);
  if (a.n < 3)
    return (gs_pieces){ 0 };
  return (gs_pieces){ (int) a.x[0], (int) a.x[1], (int) a.x[2], a.x + 3 };
}

/* whole numbers, a null pointer where there are none */
static int *
some_wholes (const gs_job *job, const char *name)
{
  long long n;
  gs_numbers (job, name, &n);
  return n > 0 ? wholes (job, name, &n) : NULL;
}

static void
read_inputs (gs_sweep *s)
{
  const gs_job *job = s->job;
  const gs_array breaks = numbers (job, "breaks");
  s->planned = some_wholes (job, "planned");
  s->inputs = (gs_run_inputs){
    .kind = (int) gs_number (job, "kind", 0), .constants = numbers (job, "constants").x,
    .table = pieces (job, "table"), .motion = pieces (job, "motion"), .planned = s->planned,
    .reference = pieces (job, "reference"), .gain = pieces (job, "gain"),
    .limits = numbers (job, "limits").x, .nbreaks = (int) breaks.n, .breaks = breaks.x
  };
}

/* 0, or the job has not all of it */
static int
read_start (gs_sweep *s)
{
  const gs_job *job = s->job;
  const gs_array times = numbers (job, "tout"), x0 = numbers (job, "x0"),
                 par = numbers (job, "par"), cst = numbers (job, "cst"),
                 nominal = numbers (job, "nominal");
  s->modes = some_wholes (job, "modes");
  s->start = (gs_run_start){ .nt = (int) times.n, .times = times.x, .x0 = x0.x, .par = par.x,
                             .cst = cst.x, .modes = s->modes,
                             .memory = numbers (job, "memory").x };
  s->about = *S->about;
  s->about.nominal = nominal.x;
  gsmbp_lanes (&s->lanes);
  s->about.lanes = gs_number (job, "lanes", 0) != 0 ? &s->lanes : NULL;
  return times.n < 2 || x0.n != S->nx || par.n != S->npar || cst.n != S->ncst
         || nominal.n != S->nx;
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
  read_options (s);
  read_inputs (s);
  s->samples = numbers (job, "samples");
  s->groups = numbers (job, "groups");
  s->which = wholes (job, "which", &s->varied);
  s->runs = s->varied > 0 ? s->samples.n / s->varied : 0;
  if (read_start (s) || read_kept (s) || s->runs < 1)
    return snprintf (why, GS_WHY, "the job is not whole"), 1;
  return find_broken (s, why);
}

void
gs_close_sweep (gs_sweep *s)
{
  int *lists[] = { s->modes, s->planned, s->which, s->way, s->number, s->time };
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
  for (long long k = 0; k < w->s->start.nt; k++)
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
    fails = gs_margins_at (d, w->s->start.times[k], r->xout + r->ldx * column (w, k),
                           r->vout + r->ldv * column (w, k), r->cst, passed, least) < 0;
  return fails ? NAN : least[number - 1];
}

/* sum of the trapezoidal rule as gs.sweep.kept_results has it, of the POWER 1 or 2 */
static double
mean (const gs_view *w, int number, int power)
{
  double sum = 0, before = 0;
  const double *t = w->s->start.times;
  for (long long k = 0; k < w->s->start.nt; k++)
    {
      double z = value_at (w, number, k);
      z = power == 2 ? z * z : z;
      if (k > 0)
        sum = sum + (t[k] - t[k - 1]) * (z + before);
      before = z;
    }
  return sum / (2 * (t[w->s->start.nt - 1] - t[0]));
}

/* the largest of SIGN times the value, or of its modulus where SIGN is 0; numbers alone count */
static double
largest (const gs_view *w, int number, int sign)
{
  double most = NAN;
  for (long long k = 0; k < w->s->start.nt; k++)
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
  const gs_events a = gs_planned_events (S->nx, w->m->run.ip, w->m->run.rp);
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
    for (long long i = 0; i < s->start.nt && s->way[k] == GS_WHOLE; i++)
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
    w.reached = s->start.nt;
  w.y = calloc ((size_t) (S->ny * s->start.nt) + 1, sizeof (double));
  if (! w.y)
    {
      f->no_memory = 1;
      return;
    }
  gs_member_failure (e, m, why, GS_WHY);
  find_outputs (&w);
  fill (&w, ok, ok && ! ended ? s->start.times[s->start.nt - 1] : m->run.rstat[GS_T_REACHED], row);
  free (w.y);
}

int
gs_sweep_rows (const gs_sweep *s, long long first, int n, int threads, double *rows,
               char (*why)[GS_WHY], char *refused)
{
  gs_filled filled = { .s = s, .rows = rows, .why = why };
  const gs_rows given = {
    .n = n, .varied = (int) s->varied, .which = s->which,
    .table = { s->samples.x + s->varied * first, (ptrdiff_t) s->varied, 1 },
    .broken = s->broken + first
  };
  gs_run_result found;
  int failed = gs_take_rows (&s->about, &s->options, &s->start, &s->inputs, &given, threads,
                             take_run, &filled, NULL, &found);
  snprintf (refused, GS_WHY, "%s", found.refused ? found.text : "no memory");
  gs_free_result (&found);
  return failed || filled.no_memory;
}
