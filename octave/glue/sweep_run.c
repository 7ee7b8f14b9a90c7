/* One run of a sweep without Octave; sweep_run.h says what it is. */
#include "sweep_run.h"
#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include "host/failure.h"
#include "host/fortran_scene.h"
#include "host/start.h"
#include "gsmbp_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const gsmbp_scene *const S = &gsmbp_the_scene;

extern double gslft_ (const double *t, const int *side);
static void absent (void) { }

/* an emitted subroutine by the end of its name, a null pointer where there is none */
static gsmbp_sub
emitted (const char *name)
{
  for (const gsmbp_routine *r = S->routines; r->name; r++)
    if (strcmp (name, r->name) == 0)
      return r->sub;
  return NULL;
}

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
find_subs (gs_sweep *s, char *why)
{
  static const char *const names[GS_SUBS]
      = { "rhs", "prj", "con", "kin", "cmd", "clo", "vin", "out", "ctl", "evt", "rst" };
  gs_array called = numbers (s->job, "called");
  for (int k = 0; k < GS_SUBS; k++)
    {
      int is = k < called.n && called.x[k] != 0;
      s->sub[k] = is ? k == 6 ? S->vin : emitted (names[k]) : absent;
      if (! s->sub[k])
        return snprintf (why, GS_WHY, "%s has no subroutine %s", S->name, names[k]), 1;
    }
  return 0;
}

static int
find_method (gs_sweep *s, char *why)
{
  long long n;
  const char *method = gs_text (s->job, "library", &n);
  s->implicit_method = NULL;
  if (strcmp (method, "radau") == 0)
    s->implicit_method = gs_radau;
  if (strcmp (method, "gauss") == 0)
    s->implicit_method = gs_gauss;
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
  for (const char *p = text; s->broken && p && *p; p = strchr (p, '\n'), p = p ? p + 1 : p)
    {
      long long i = atoll (p);
      const char *tab = strchr (p, '\t');
      if (tab && i >= 1 && i <= s->runs)
        s->broken[i - 1] = tab + 1;
    }
  if (! s->broken)
    snprintf (why, GS_WHY, "no memory");
  return ! s->broken;
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
  return find_subs (s, why) || find_method (s, why) || find_broken (s, why);
}

void
gs_close_sweep (gs_sweep *s)
{
  int *lists[] = { s->ip, s->iopt, s->follows, s->which, s->way, s->number, s->time };
  for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
    free (lists[k]);
  free (s->broken);
}

static double *
room (long long n)
{
  return calloc ((size_t) (n < 1 ? 1 : n), sizeof (double));
}

gs_sweep_room *
gs_make_room (const gs_sweep *s)
{
  gs_sweep_room *r = calloc (1, sizeof *r);
  if (! r)
    return NULL;
  long long nt = s->tout.n;
  r->cst = room (S->ncst);
  r->x0 = room (S->nx);
  r->xout = room (s->ldx * nt);
  r->vout = room (s->ldv * nt);
  r->yout = room (S->ny * nt);
  r->rstat = room (GS_MEASURED);
  r->w = room (s->lw);
  r->rp = room (s->rp.n);
  r->par = room (S->npar);
  r->times = room (1 + nt + s->tbrk.n + S->nsw);
  r->options = room (s->ropt.n + s->atol.n);
  r->ip = calloc ((size_t) s->nip + 1, sizeof (int));
  r->iopt = calloc ((size_t) s->niopt + 1, sizeof (int));
  r->istat = calloc (GS_COUNTED, sizeof (int));
  return r;
}

void
gs_free_room (gs_sweep_room *r)
{
  void *all[] = { r->cst, r->x0, r->xout, r->vout, r->yout, r->rstat, r->w, r->rp, r->par, r->times,
                  r->options, r->ip, r->iopt, r->istat, r };
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
    free (all[k]);
}

static void
copy (double *to, const double *from, long long n)
{
  if (n > 0)
    memcpy (to, from, (size_t) n * sizeof (double));
}

static void
zero (double *x, long long n)
{
  memset (x, 0, (size_t) n * sizeof (double));
}

static int
before (const void *a, const void *b)
{
  const double x = *(const double *) a, y = *(const double *) b;
  return (x > y) - (x < y);
}

/* breaks of the inputs and the times at which the scene switches, behind the output times */
static void
set_breaks (const gs_sweep *s, gs_sweep_room *r)
{
  double *all = r->times + 1 + s->tout.n, *at = all + s->tbrk.n;
  int n = (int) s->tbrk.n;
  copy (all, s->tbrk.x, n);
  r->nb = n;
  if (S->nsw == 0)
    return;
  S->run->swi (r->cst, at);
  for (int k = 0; k < S->nsw; k++)
    if (at[k] > s->t0 && at[k] < s->tout.x[s->tout.n - 1])
      all[n++] = at[k];
  qsort (all, (size_t) n, sizeof *all, before);
  r->nb = 0;
  for (int k = 0; k < n; k++)
    if (r->nb == 0 || all[k] > all[r->nb - 1])
      all[r->nb++] = all[k];
}

/* a start that is not taken: INFO as GSSIM, a verdict and its message */
static void
refused (const gs_sweep *s, gs_sweep_room *r, const gs_start *start)
{
  r->info = start->verdict == GS_START_NO_MEMORY ? GS_OUT_OF_MEMORY : GS_ROUTINE_FAILED;
  r->istat[GS_FAILED_INFO] = start->verdict;
  r->istat[GS_FAILED] = GS_BEFORE_START;
  r->rstat[GS_T_REACHED] = s->t0;
  snprintf (r->text, sizeof r->text, "%s", start->text);
}

/* what a start needs of the scene, with the nominal magnitudes of the job */
static gs_description
description (const gs_sweep *s)
{
  gs_description d = *S->about;
  d.nominal = s->nominal.x;
  return d;
}

/* the modes of ports that are given, or a null pointer */
static const int *
given_modes (const gs_sweep *s)
{
  if (s->ip[GS_EVENTS] == 0)
    return NULL;
  const gs_events e = gs_planned_events (S->nx, s->ip, (double *) s->rp.x);
  return e.given ? e.mode : NULL;
}

/* the start of a run on its constraints */
static void
take_start (const gs_sweep *s, gs_sweep_room *r)
{
  const gs_description d = description (s);
  const gs_start_given g = { .t = s->t0, .cst = r->cst, .par = r->par, .check = s->check_start,
                             .modes = given_modes (s) };
  gs_start start;
  r->rstat[GS_T_REACHED] = s->t0;
  if (gs_take_start (&d, &g, r->x0, &start) != GS_START_TAKEN)
    refused (s, r, &start);
}

/* the first samples of the sampled devices */
static void
take_samples (const gs_sweep *s, gs_sweep_room *r)
{
  const gs_description d = description (s);
  gs_start start;
  if (gs_check_samples (&d, s->t0, r->cst, r->ip, r->rp, &start) != GS_START_TAKEN && r->info == 0)
    refused (s, r, &start);
}

/* the plan of a run and what came of it; the record of the events, of which nothing is read before
   it is written, stays as it is: it takes most of the room */
void
gs_take_plan (const gs_sweep *s, const int *from_ip, const double *from, int *ip, double *rp)
{
  memcpy (ip, from_ip, (size_t) s->nip * sizeof (int));
  if (ip[GS_EVENTS] == 0)
    {
      copy (rp, from, s->rp.n);
      return;
    }
  gs_events e = gs_planned_events (S->nx, ip, rp);
  long long behind = e.level - rp;
  copy (rp, from, e.record - rp);
  copy (rp + behind, from + behind, s->rp.n - behind);
}

/* the room of run I; INFO of PRE: that of the constants CST if they are known */
static int
prepare (const gs_sweep *s, gs_sweep_room *r, long long i, const double *cst, int info)
{
  copy (r->par, s->par.x, S->npar);
  for (long long k = 0; k < s->varied; k++)
    r->par[s->which[k] - 1] = s->samples.x[s->varied * i + k];
  copy (r->cst, cst ? cst : s->cst.x, s->cst.n);
  if (! cst)
    ((void (*) (double *, double *, int *)) emitted ("pre")) (r->par, r->cst, &info);
  copy (r->x0, s->x0.x, S->nx);
  zero (r->w, s->lw);
  zero (r->xout, s->ldx * s->tout.n);
  zero (r->vout, s->ldv * s->tout.n);
  zero (r->rstat, GS_MEASURED);
  memset (r->istat, 0, GS_COUNTED * sizeof (int));
  r->text[0] = 0;
  r->info = 0;
  if (info == 0)
    take_start (s, r);
  copy (r->w, S->nq == S->nu ? r->x0 : s->guess.x, S->nu);
  gs_take_plan (s, s->ip, s->rp.x, r->ip, r->rp);
  if (S->nctl > 0 && info == 0)
    take_samples (s, r);
  r->times[0] = s->t0;
  copy (r->times + 1, s->tout.x, s->tout.n);
  set_breaks (s, r);
  copy (r->options, s->ropt.x, s->ropt.n);
  copy (r->options + s->ropt.n, s->atol.x, s->atol.n);
  memcpy (r->iopt, s->iopt, (size_t) s->niopt * sizeof (int));
  return info;
}

/* the run as the run time in C takes it, with its statistics so far */
static gs_run
run_of (const gs_sweep *s, gs_sweep_room *r)
{
  gs_run g = {
    .nx = s->nx, .t0 = s->t0, .x0 = r->x0, .nt = (int) s->tout.n, .tout = r->times + 1,
    .nb = r->nb, .tbrk = r->times + 1 + s->tout.n, .iopt = r->iopt, .ropt = r->options,
    .atol = r->options + s->ropt.n, .ip = r->ip, .rp = r->rp, .cst = r->cst, .xout = r->xout,
    .ldx = s->ldx, .vout = r->vout, .ldv = s->ldv, .w = r->w, .lw = s->lw
  };
  memcpy (g.istat, r->istat, sizeof g.istat);
  memcpy (g.rstat, r->rstat, sizeof g.rstat);
  return g;
}

static void
keep_statistics (gs_sweep_room *r, const gs_run *g)
{
  memcpy (r->istat, g->istat, sizeof g->istat);
  memcpy (r->rstat, g->rstat, sizeof g->rstat);
}

static void
by_explicit (const gs_sweep *s, gs_sweep_room *r)
{
  gs_fortran_inputs data = { .ip = r->ip, .rp = r->rp, .cst = r->cst };
  gs_scene scene = *S->run;
  scene.data = &data;
  scene.nsw = 0;   /* the breaks have these times */
  gs_run g = run_of (s, r);
  r->info = gssim (&scene, &g);
  keep_statistics (r, &g);
}

/* from the start, or on from where gssim found its steps bound by stability */
static void
by_implicit (const gs_sweep *s, gs_sweep_room *r, int resume)
{
  gs_fortran_inputs data = { .ip = r->ip, .rp = r->rp, .cst = r->cst };
  gs_scene scene = *S->run;
  scene.data = &data;
  gs_run g = run_of (s, r);
  const gs_implicit o = {
    .order = s->order, .index2 = s->index2, .resume = resume, .followed = (int) s->followed,
    .follows = s->follows, .text = r->text, .length = (int) sizeof r->text
  };
  r->info = s->implicit_method (&scene, &g, &o);
  keep_statistics (r, &g);
}

static int
fine (const double *x, int n)
{
  for (int i = 0; i < n; i++)
    if (! (fabs (x[i]) <= 1e300))
      return 0;
  return 1;
}

/* the time that stands for row K: where the scene switches it has what was before, as the inputs in
   it, but for the first one and those behind its end */
static double
row_time (const gs_sweep *s, const gs_sweep_room *r, const double *switches, long long k)
{
  const double t = s->tout.x[k];
  const int left = -1;
  for (int i = 0; i < S->nsw && k > 0 && k < r->istat[GS_N_OUTPUTS]; i++)
    if (switches[i] >= t && switches[i] <= t)
      return gslft_ (&t, &left);
  return t;
}

/* outputs at the times that were reached, not a number where there are none */
static void
outputs (const gs_sweep *s, gs_sweep_room *r, long long reached)
{
  gsmbp_sub out = S->ny > 0 ? emitted ("out") : NULL;
  double switches[S->nsw + 1];
  if (S->nsw > 0)
    S->run->swi (r->cst, switches);
  for (long long k = 0; k < s->tout.n; k++)
    {
      double *y = r->yout + S->ny * k, *x = r->xout + s->ldx * k, *v = r->vout + s->ldv * k;
      double one[S->ny + 1], t = row_time (s, r, switches, k);
      int info = 0;
      for (int j = 0; j < S->ny; j++)
        y[j] = NAN;
      if (! out || k >= reached || ! fine (x, S->nx) || ! fine (v, S->nv))
        continue;
      ((void (*) (double *, double *, double *, double *, double *, int *)) out) (&t, x, v, r->cst,
                                                                                 one, &info);
      if (info == 0 || info == 2)
        copy (y, one, S->ny);
    }
}

/* a run that an event of the user has ended stays there: how many rows there are now */
static long long
stay (const gs_sweep *s, gs_sweep_room *r, long long reached)
{
  for (long long k = reached + 1; k < s->tout.n; k++)
    {
      copy (r->xout + s->ldx * k, r->xout + s->ldx * reached, S->nx);
      copy (r->vout + s->ldv * k, r->vout + s->ldv * reached, S->nv);
    }
  r->info = 0;
  return s->tout.n;
}

/* state, input or output NUMBER (from 1) at time K; not a number from REACHED on */
static double
value_at (const gs_sweep *s, const gs_sweep_room *r, int number, long long k, long long reached)
{
  int j = number - 1;
  if (k >= reached)
    return NAN;
  if (j < S->nx)
    return r->xout[s->ldx * k + j];
  j -= S->nx;
  return j < S->nv ? r->vout[s->ldv * k + j] : r->yout[S->ny * k + j - S->nv];
}

/* the least value of margin NUMBER of the devices */
static double
of_margins (const gs_sweep *s, gs_sweep_room *r, int number, long long reached)
{
  const gs_description d = description (s);
  int passed[S->nsm + 1], fails = ! d.mar;
  double least[S->nsm + 1];
  for (int k = 0; k < S->nsm; k++)
    {
      passed[k] = 1;   /* those need not be found */
      least[k] = HUGE_VAL;
    }
  for (long long k = 0; k < reached && ! fails; k++)
    fails = gs_margins_at (&d, s->tout.x[k], r->xout + s->ldx * k, r->vout + s->ldv * k, r->cst,
                           passed, least) < 0;
  return fails ? NAN : least[number - 1];
}

/* sum of the trapezoidal rule as gs.sweep.kept_results has it, of the POWER 1 or 2 */
static double
mean (const gs_sweep *s, const gs_sweep_room *r, int number, long long reached, int power)
{
  double sum = 0, before = 0;
  const double *t = s->tout.x;
  for (long long k = 0; k < s->tout.n; k++)
    {
      double z = value_at (s, r, number, k, reached);
      z = power == 2 ? z * z : z;
      if (k > 0)
        sum = sum + (t[k] - t[k - 1]) * (z + before);
      before = z;
    }
  return sum / (2 * (t[s->tout.n - 1] - t[0]));
}

/* the largest of SIGN times the value, or of its modulus where SIGN is 0; numbers alone count */
static double
largest (const gs_sweep *s, const gs_sweep_room *r, int number, long long reached, int sign)
{
  double most = NAN;
  for (long long k = 0; k < s->tout.n; k++)
    {
      double z = value_at (s, r, number, k, reached);
      z = sign == 0 ? fabs (z) : sign * z;
      if (! (z <= most) && ! isnan (z))
        most = z;
    }
  return sign < 0 ? -most : most;
}

/* of the events in the group NUMBER: when the first or the last one was, or how many there were */
static double
of_events (const gs_sweep *s, const gs_sweep_room *r, int way, int number)
{
  const gs_events a = gs_planned_events (s->nx, r->ip, r->rp);
  int count = 0;
  double first = NAN, last = NAN;
  for (int k = 0; k < a.ne; k++)
    {
      if ((int) s->groups.x[k] != number || a.times[k] == 0)
        continue;
      first = count == 0 ? a.first[k] : fmin (first, a.first[k]);
      last = count == 0 ? a.latest[k] : fmax (last, a.latest[k]);
      count += a.times[k];
    }
  return way == GS_COUNT ? count : way == GS_FIRST ? first : last;
}

static double
kept (const gs_sweep *s, gs_sweep_room *r, long long k, long long reached)
{
  int number = s->number[k];
  switch (s->way[k])
    {
    case GS_PEAK:
      return largest (s, r, number, reached, 0);
    case GS_MAX:
      return largest (s, r, number, reached, 1);
    case GS_MIN:
      return largest (s, r, number, reached, -1);
    case GS_MEAN:
      return mean (s, r, number, reached, 1);
    case GS_FIRST:
    case GS_LAST:
    case GS_COUNT:
      return of_events (s, r, s->way[k], number);
    case GS_MARGIN:
      return of_margins (s, r, number, reached);
    case GS_RMS:
      return sqrt (mean (s, r, number, reached, 2));
    default:
      return value_at (s, r, number, s->time[k] - 1, reached);
    }
}

/* the row: ok, the time that was reached, what is kept, whole runs */
static void
fill (const gs_sweep *s, gs_sweep_room *r, int ok, double reached_time, long long reached,
      double *row)
{
  long long at = 0;
  *row++ = ok;
  *row++ = reached_time;
  for (long long k = 0; k < s->kept + s->wholes; k++)
    if (s->way[k] != GS_WHOLE)
      row[at++] = ok ? kept (s, r, k, reached) : NAN;
  for (long long k = 0; k < s->kept + s->wholes; k++)
    for (long long i = 0; i < s->tout.n && s->way[k] == GS_WHOLE; i++)
      row[at++] = value_at (s, r, s->number[k], i, reached);
}

/* which mode contradicts the state, the last one of the run */
static void
wrong_mode (const gs_sweep *s, const gs_sweep_room *r, char *why)
{
  const gs_description d = description (s);
  const gs_start_given g = { .t = s->t0, .cst = r->cst, .modes = given_modes (s) };
  const int said = snprintf (why, GS_WHY, "modes: ");
  gs_wrong_mode (&d, &g, r->xout + s->ldx * r->istat[GS_N_OUTPUTS], r->istat[GS_CAUSE] - 1,
                 why + said, GS_WHY - said);
}

/* why a run ended */
static void
failure (const gs_sweep *s, const gs_sweep_room *r, char *why)
{
  const int *istat = r->istat;
  const gs_failed_run run = { S->about, r->info, istat, r->rstat[GS_T_REACHED], r->text };
  if (r->info == GS_ROUTINE_FAILED && istat[GS_FAILED] == GS_AT_EVENT
      && istat[GS_FAILED_INFO] == GS_WRONG_MODE)
    wrong_mode (s, r, why);
  else
    gs_failure (&run, why, GS_WHY);
}

/* one that was not begun */
static void
never (const gs_sweep *s, gs_sweep_room *r, double *row)
{
  fill (s, r, 0, s->t0, 0, row);
}

int
gs_begin_row (const gs_sweep *s, gs_sweep_room *r, long long i, const double *cst, int info,
              double *row, char *why)
{
  why[0] = 0;
  if (s->broken[i])
    {
      snprintf (why, GS_WHY, "%.*s", (int) strcspn (s->broken[i], "\n"), s->broken[i]);
      never (s, r, row);
      return 0;
    }
  info = prepare (s, r, i, cst, info);
  if (info == 0)
    return 1;
  int istat[GS_COUNTED] = { 0 };
  istat[GS_FAILED] = GS_AT_PRE;
  istat[GS_FAILED_INFO] = info;
  const int said = snprintf (why, GS_WHY, "its parameters cannot be: ");
  const gs_failed_run failed = { .d = S->about, .istat = istat };
  gs_cause (&failed, why + said, GS_WHY - said);
  never (s, r, row);
  return 0;
}

void
gs_end_row (const gs_sweep *s, gs_sweep_room *r, double *row, char *why)
{
  if (s->implicit_method && r->iopt[GS_METHOD] != 0 && r->info == GS_STIFF)
    by_implicit (s, r, 1);
  long long reached = r->istat[GS_N_OUTPUTS];
  int ended = r->info == GS_ENDED;
  if (ended)
    reached = stay (s, r, reached);
  outputs (s, r, reached);
  int ok = r->info == GS_DONE;
  if (! ok)
    failure (s, r, why);
  fill (s, r, ok, ok && ! ended ? s->tout.x[s->tout.n - 1] : r->rstat[GS_T_REACHED], reached, row);
}

void
gs_sweep_row (const gs_sweep *s, gs_sweep_room *r, long long i, double *row, char *why)
{
  if (! gs_begin_row (s, r, i, NULL, 0, row, why))
    return;
  if (r->info == 0 && r->iopt[GS_METHOD] != 0)
    by_explicit (s, r);
  else if (r->info == 0 && s->implicit_method)
    by_implicit (s, r, 0);
  gs_end_row (s, r, row, why);
}
