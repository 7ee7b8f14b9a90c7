/* Events of a run by an implicit method: looked for on the polynomial of a step by GSEVN; then the
   step is made again, as long as it must be (a method of one step; the polynomial of BDF is as
   accurate as its steps).  Behind one that changes nothing, which is only told, the step stands
   as it was. */
#include <float.h>
#include <math.h>
#include <string.h>
#include "gsmbp/plan.h"
#include "implicit_parts.h"

/* the Fortran routines: the addresses carry no types, these do */
typedef void evn_type (gsmbp_sub rhs, gsmbp_sub prj, gsmbp_sub con, gsmbp_sub kin, gsmbp_sub cmd,
                       gsmbp_sub clo, gsmbp_sub vin, gsmbp_sub evt, const int *method,
                       const int *way, const double *t, double *tn, const int *side,
                       const double *h, double *x, const int *siz, int *ip, double *rp,
                       double *cst, double *v, double *ropt, double *xn, double *w, double *wi,
                       double *p, int *istat, double *rstat, int *ie, double *re, double *gauss,
                       int *found, int *info);
typedef void evv_type (gsmbp_sub cmd, gsmbp_sub clo, gsmbp_sub vin, gsmbp_sub evt, const double *t,
                       const int *side, const double *x, const int *nu, const int *nx,
                       const int *nv, int *ip, double *rp, double *cst, double *v, double *w,
                       const int *mode, double *gv, int *info);
typedef void usg_type (const int *nx, int *ie, double *re);
typedef void evr_type (gsmbp_sub cmd, gsmbp_sub clo, gsmbp_sub vin, gsmbp_sub evt, gsmbp_sub rst,
                       const double *t, double *x, const int *nu, const int *nx, const int *nv,
                       int *ip, double *rp, double *cst, double *v, double *w, int *istat,
                       const int *k, int *info);

enum { OWN = 3, TURNS = 12 };   /* kind of an event of the user that does not end the run */

static gs_events
plan (const gs_run *s)
{
  return gs_planned_events (s->r->nx, s->r->ip, s->r->rp);
}

static int *
wholes (const gs_run *s)
{
  return s->r->ip + s->r->ip[GS_EVENTS] - 1;
}

static double *
reals (const gs_run *s)
{
  return s->r->rp + s->r->ip[GS_EVENTS + 1] - 1;
}

int
gs_has_events (const gs_run *s)
{
  return s->r->ip[GS_EVENTS] > 0;
}

int
gs_event_functions (const gsmbp_run *r)
{
  return r->ip[GS_EVENTS] > 0 ? gs_planned_events (r->nx, r->ip, r->rp).ne : 0;
}

int
gs_has_ports (const gsmbp_run *r)
{
  if (r->ip[GS_EVENTS] <= 0)
    return 0;
  gs_events e = gs_planned_events (r->nx, r->ip, r->rp);
  for (int i = 0; i < e.ne; i++)
    if (e.kind[i] < OWN)
      return 1;
  return 0;
}

/* event K at T, 0 the start, -1 inputs may have jumped: X behind it; INFO */
static int
happen (gs_run *s, double t, double *x, int k)
{
  const gsmbp_run *r = s->r;
  int info = 0;
  ((evr_type *) r->gsevr) (r->cmd, r->clo, r->vin, r->evt, r->rst, &t, x, &r->nu, &r->nx, &r->nv,
                           r->ip, r->rp, r->cst, s->v, r->w, r->istat, &k, &info);
  return info != 0 ? ROUTINE : FINISHED;
}

int
gs_first_events (gs_run *s)
{
  return gs_has_events (s) && ! s->r->resume ? happen (s, s->t, s->x, 0) : FINISHED;
}

int
gs_ended_by_event (const gs_run *s)
{
  return gs_ended (s->r->ip);
}

int
gs_events_at_stop (gs_run *s, int *acted)
{
  *acted = 0;
  if (! gs_has_events (s))
    return FINISHED;
  int so_far = *plan (s).count, info = happen (s, s->t, s->x, -1);
  *acted = *plan (s).count > so_far;
  return info != 0 ? info : gs_ended_by_event (s) ? ENDED : FINISHED;
}

/* ------------------------------------------------------------
 * where an event is */

/* the state at T within the step, or at its end */
static int
state_at (gs_run *s, double t, double *x)
{
  if (t < s->t)
    return s->by->between (s, t, x);
  memcpy (x, s->y, sizeof (double) * s->r->nx);
  return 0;
}

/* C: the points of GSEVQ; D: what their values give the slope at the first one */
static void
points (double *c, double *d)
{
  for (int j = 0; j < GS_NODES; j++)
    c[j] = 0.5 * (1 - cos (j * acos (-1) / (GS_NODES - 1)));
  d[0] = 0;
  for (int j = 1; j < GS_NODES; j++)
    {
      d[j] = 1 / c[j];
      for (int k = 1; k < GS_NODES; k++)
        d[j] *= k == j ? 1 : -c[k] / (c[j] - c[k]);
      d[0] -= d[j];
    }
}

/* S->nodes: the states between FROM and TO at the points of GSEVQ, bent so that value and slope at
 * the first are those of S->known: where an event has just been, its sign is decided there.  A
 * flag */
static int
take_nodes (gs_run *s, double from, double to)
{
  int n = s->r->nx, flag = 0;
  double c[GS_NODES], d[GS_NODES], h = to - from, *rate = s->work;
  points (c, d);
  for (int j = 0; j < GS_NODES && flag >= 0; j++)
    flag = state_at (s, j == GS_NODES - 1 ? to : from + c[j] * h, s->nodes + n * j);
  if (flag < 0 || gs_rate (s, from, s->known, rate) != 0)
    return flag < 0 ? flag : GS_NO_RATES;
  for (int i = 0; i < n; i++)
    {
      double value = s->known[i] - s->nodes[i], slope = h * rate[i];
      for (int j = 0; j < GS_NODES; j++)
        slope -= d[j] * (s->nodes[i + n * j] - s->nodes[i]);
      for (int j = 1; j < GS_NODES; j++)
        s->nodes[i + n * j]
          += (1 - c[j]) * (1 - c[j]) * ((1 + 2 * c[j]) * value + c[j] * slope);
      s->nodes[i] = s->known[i];
    }
  return 0;
}

/* event function I at T in the state X; INFO */
static int
function (gs_run *s, int i, double t, const double *x, double *g)
{
  const gsmbp_run *r = s->r;
  gs_events e = plan (s);
  int side = gs_side_at (s, t), info = 0;
  ((evv_type *) r->gsevv) (r->cmd, r->clo, r->vin, r->evt, &t, &side, x, &r->nu, &r->nx, &r->nv,
                           r->ip, r->rp, r->cst, s->v, r->w, e.mode, e.now, &info);
  ((usg_type *) r->gsusg) (&r->nx, wholes (s), reals (s));
  *g = e.now[i - 1];
  if (info != 0)
    {
      r->istat[5] = info;
      r->istat[6] = INPUTS;
    }
  return info != 0 ? ROUTINE : FINISHED;
}

/* What is known of the event functions before a step is looked at, to be looked at again. */
static void
remember (gs_run *s)
{
  gs_events e = plan (s);
  memcpy (s->marks, e.mark, e.ne * sizeof (int));
  memcpy (s->marks + e.ne, e.fresh, e.ne * sizeof (int));
  memcpy (s->levels, e.g, e.ne * sizeof (double));
  memcpy (s->levels + e.ne, e.level, e.ne * sizeof (double));
}

static void
recall (gs_run *s)
{
  gs_events e = plan (s);
  memcpy (e.mark, s->marks, e.ne * sizeof (int));
  memcpy (e.fresh, s->marks + e.ne, e.ne * sizeof (int));
  memcpy (e.g, s->levels, e.ne * sizeof (double));
  memcpy (e.level, s->levels + e.ne, e.ne * sizeof (double));
}

/* S->rising: which functions of the user have just had their event at T, in S->known, and rise from
 * there, within D; INFO */
static int
take_rising (gs_run *s, double t, double d)
{
  gs_events e = plan (s);
  int any = 0, info = FINISHED;
  double before, *rate = s->work;   /* of take_nodes */
  for (int i = 0; i < e.ne; i++)
    any |= s->rising[i] = e.kind[i] >= OWN && e.fresh[i] == 1 && e.mark[i] == 0;
  if (! any)
    return info;
  for (int l = 0; l < s->r->nx; l++)
    s->event[l] = s->known[l] + d * rate[l];
  for (int i = 0; i < e.ne && info == 0; i++)
    if (s->rising[i] && (info = function (s, i + 1, t, s->known, &before)) == 0
        && (info = function (s, i + 1, t + d, s->event, &e.now[i])) == 0)
      s->rising[i] = e.now[i] > before;
  return info;
}

/* the first of these that has fallen all the same in the part that was looked at, 0: none. The
 * step is too long to see what happens just behind the event. */
static int
sunk (const gs_run *s)
{
  gs_events e = plan (s);
  for (int i = 0; i < e.ne; i++)
    if (s->rising[i] && e.marks[i] == 0 && e.last[i] < 0)
      return i + 1;
  return 0;
}

/* the shortest step that may be made still shorter */
static double
shortest (double from, double to)
{
  return 1e3 * DBL_EPSILON * fmax (fabs (from), fabs (to));
}

/* GSEVN between FROM and TO */
static int
search (gs_run *s, double from, double *to, int *found)
{
  const gsmbp_run *r = s->r;
  double h = *to - from, end = *to, no_gauss[3] = { 0, 0, 0 };
  int none = 0, side = gs_side_at (s, *to), info = 0,
      sizes[8] = { r->nq, r->nu, r->nx, r->nv, r->nlam, r->nt, r->nb, 0 };
  memcpy (s->event, s->nodes + (size_t) r->nx * (GS_NODES - 1), sizeof (double) * r->nx);
  ((evn_type *) r->gsevn) (r->rhs, r->prj, r->con, r->kin, r->cmd, r->clo, r->vin, r->evt, &none,
                           &r->iopt[1], &from, &end, &side, &h, s->known, sizes, r->ip, r->rp,
                           r->cst, s->v, r->ropt, s->event, s->nodes, r->w, s->p, r->istat,
                           r->rstat, wholes (s), reals (s), no_gauss, found, &info);
  if (info == 0 && *found > 0)
    *to = end;
  return info != 0 ? ROUTINE : FINISHED;
}

/* The first event between FROM, where the state is S->known, and TO: its function FOUND, TO and the
 * state there, S->event, on the polynomial; FOUND as GSEVN.  A flag of the method in *FLAG, INFO */
static int
look (gs_run *s, double from, double *to, int *found, int *flag)
{
  const double end = *to;
  *found = 0;
  if ((*flag = take_nodes (s, from, *to)) < 0)
    return FINISHED;
  int info = take_rising (s, from, 1e-3 * (end - from)), which;
  remember (s);
  if (info != 0 || (info = search (s, from, to, found)) != 0 || (which = sunk (s)) == 0)
    return info;
  if (end - from <= shortest (from, end))
    {
      s->r->istat[5] = 10;   /* as GSEVN: they accumulate */
      s->r->istat[6] = 7;
      s->r->istat[18] = which;
      return ROUTINE;
    }
  recall (s);
  *found = -1;
  return FINISHED;
}

/* the step from FROM once more, to TO at most; a flag */
static int
once_more (gs_run *s, double from, double to)
{
  double stop = s->stop;
  int side = s->side;
  if (to < stop)
    s->side = 1;
  s->stop = to;
  s->t = from;
  int flag = s->by->again (s);
  s->stop = stop;
  s->side = side;
  return flag;
}

/* The slope of function I behind the step to T, where it is G */
static int
slope_of (gs_run *s, int i, double from, double t, double g, double *slope)
{
  double d = 1e-3 * (t - from), before;
  int info = s->by->between (s, t - d, s->event) < 0 ? METHOD_FAILED
                                                      : function (s, i, t - d, s->event, &before);
  *slope = (g - before) / d;
  return info;
}

/* What locates an event: the step from FROM ends at T, where function I is G. */
typedef struct { double from, begin, end, t, g; int i; } place;

/* the step to P->t once more; a flag of the method in *FLAG, INFO */
static int
tried (gs_run *s, place *p, int *flag)
{
  *flag = once_more (s, p->from, p->t);
  return *flag < 0 || s->t < p->t ? FINISHED : function (s, p->i, p->t, s->y, &p->g);
}

/* an event of the user has happened: a little later than P its function is not above 0 */
static int
past (gs_run *s, place *p, int *flag)
{
  int info = FINISHED, own = plan (s).kind[p->i - 1] >= OWN;
  double least = DBL_EPSILON * fmax (fabs (p->from), fabs (p->end));
  for (int k = 0; k < 8 && own && info == 0 && *flag >= 0 && p->g > 0 && p->t < p->end; k++)
    {
      p->t = fmin (p->end, p->t + ldexp (least, k));
      info = tried (s, p, flag);
    }
  return info;
}

/* The step again, as long as it must be for the function to be 0 at its end, by the secant method
 * from its zero on the polynomial on.  S->t < P->t: the method made a shorter one of it. */
static int
locate (gs_run *s, place *p, int *flag)
{
  double slope = 0, t = 0, g = 0, least = 2 * DBL_EPSILON * fmax (fabs (p->from), fabs (p->end));
  for (int turn = 0; turn < TURNS; turn++)
    {
      int info = tried (s, p, flag);
      if (info != 0 || *flag < 0 || s->t < p->t)
        return info;
      if (turn == 0 && (info = slope_of (s, p->i, p->from, p->t, p->g, &slope)) != 0)
        return info;
      if (turn > 0 && p->g != g)
        slope = (p->g - g) / (p->t - t);
      double d = p->g / slope;
      if (! (fabs (d) <= 0.1 * (p->end - p->from)) || fabs (d) <= least)
        break;
      t = p->t;
      g = p->g;
      p->t = fmin (p->end, fmax (p->t - d, p->begin + least));
      if (p->t == t)
        break;
    }
  return past (s, p, flag);
}

/* ------------------------------------------------------------
 * a step with events */

/* do the events behind the first COUNT of the record change anything but what is told of them? */
static int
changed (const gs_run *s, int count)
{
  gs_events e = plan (s);
  size_t n = s->r->nx;
  if (*e.count > e.nr || gs_ended_by_event (s))
    return 1;
  for (; count < *e.count; count++)
    {
      const double *row = e.record + (3 + 2 * n) * count;
      int k = (int) row[1];
      if (e.kind[k - 1] != OWN || memcmp (row + 3, row + 3 + n, n * sizeof (double)) != 0)
        return 1;
      for (int i = 0; i < e.ns; i++)
        if (e.by[i] == k)
          return 1;
    }
  return 0;
}

/* the end of the step at the event: S->event, onto the constraints where it is the polynomial's;
 * then the rows before it, and what happens at event I, where other functions may have risen above
 * 0 before it; INFO */
static int
act (gs_run *s, const place *p)
{
  gs_events e = plan (s);
  for (int i = 0; i < e.ne && p->t - p->begin > shortest (p->begin, p->t); i++)
    if (e.kind[i] >= OWN)
      e.mark[i] |= e.marks[i];
  if (! s->by->dense)
    memcpy (s->event, s->y, sizeof (double) * s->r->nx);
  else if (gs_projects (s->r) && gs_check (s, s->project, p->t, s->event, gs_no_jump) != 0)
    return ROUTINE;
  int info = gs_put_out (s, nextafter (p->t, -HUGE_VAL));
  return info != 0 ? info : happen (s, p->t, s->event, p->i);
}

/* from the event at P, which changed nothing, on: the step as it was; FLAG */
static int
go_on (gs_run *s, place *p)
{
  int flag = 0;
  memcpy (s->known, s->event, sizeof (double) * s->r->nx);
  p->begin = p->t;
  if (! s->by->dense)
    {
      flag = once_more (s, p->from, p->end);
      p->end = s->t;
    }
  return flag;
}

/* Does function I rise along the motion where the polynomial of the method, by its error, lets it
 * fall? INFO */
static int
rises (gs_run *s, const place *p, int *is)
{
  int info = FINISHED;
  double d = 1e-3 * (p->end - p->begin), g, later, *x = s->nodes, *rate = s->work;
  *is = 0;
  if (plan (s).kind[p->i - 1] < OWN || gs_rate (s, p->t, s->event, rate) != 0)
    return info;
  for (int l = 0; l < s->r->nx; l++)
    x[l] = s->event[l] + d * rate[l];
  if ((info = function (s, p->i, p->t, s->event, &g)) == 0
      && (info = function (s, p->i, p->t + d, x, &later)) == 0)
    *is = later > g;
  return info;
}

/* The polynomial alone says that there is an event at P: the sign of its function at the end of the
 * step is all that counts (as GSEVN: its flag is 2 or 3), which is made as it was.  A flag */
static int
by_its_end (gs_run *s, place *p)
{
  gs_events e = plan (s);
  int flag = 0;
  recall (s);
  e.fresh[p->i - 1] = 3 - (e.fresh[p->i - 1] == 1);
  if (! s->by->dense)
    {
      flag = once_more (s, p->from, p->end);
      p->end = s->t;
    }
  return flag;
}

/* Has the function of the event at P been above 0 half way there, if it was not at P->begin, or
 * does it rise from there?  Else by_its_end.  A flag of the method in *FLAG, INFO */
static int
rose (gs_run *s, place *p, int *so, int *flag)
{
  gs_events e = plan (s);
  int i = p->i - 1, info = FINISHED;
  double g = -1;
  *so = e.kind[i] < OWN || s->marks[i] == 1 || s->rising[i] || e.fresh[i] >= 2;
  if (*so)
    return info;
  if (! s->by->dense && p->t - p->begin > 1e-9 * (p->end - p->begin))
    {
      double middle = p->begin + 0.5 * (p->t - p->begin);
      *flag = once_more (s, p->from, middle);
      if (*flag < 0 || (info = function (s, p->i, s->t, s->y, &g)) != 0)
        return info;
    }
  *so = g > 0;
  if (! *so)
    *flag = by_its_end (s, p);
  return info;
}

/* is there an event at P, as far as the polynomial and the rates there tell? TAKEN: 0 if not, -1 if
 * the step is too long to say so; INFO */
static int
believed (gs_run *s, place *p, int *taken, int *flag)
{
  int so, risen = 0, info = rose (s, p, &so, flag);
  *taken = so;
  if (info != 0 || *flag < 0 || ! so || p->end - p->begin <= shortest (p->begin, p->end))
    return info;
  if (s->by->dense && (info = rises (s, p, &risen)) == 0 && risen)
    recall (s);
  if (risen || plan (s).fresh[p->i - 1] >= 2)   /* it falls, but not where the polynomial says */
    *taken = -1;
  return info;
}

/* the step up to the event at P; TAKEN: 0 if its function does not fall; INFO */
static int
up_to (gs_run *s, place *p, int *taken, int *flag)
{
  int info = s->by->dense ? FINISHED : locate (s, p, flag);
  gs_events e = plan (s);
  *taken = ! (info == 0 && *flag >= 0 && ! s->by->dense && s->t >= p->t && p->g > 0
              && e.kind[p->i - 1] >= OWN && e.fresh[p->i - 1] < 2);
  if (! *taken)
    *flag = by_its_end (s, p);
  return info;
}

/* the first event behind P->begin; *FOUND 0: there is none, -1: look again */
static int
next_event (gs_run *s, place *p, int *found, int *flag)
{
  p->t = p->end;
  int taken = -1, info = look (s, p->begin, &p->t, found, flag);
  if (info != 0 || *found == 0)
    return info;
  p->i = *found;
  if (*found > 0)
    info = believed (s, p, &taken, flag);
  if (info == 0 && *flag >= 0 && taken < 0)   /* too long to see what is just behind the last one */
    *flag = once_more (s, p->from, p->begin + 0.25 * (p->end - p->begin));
  else if (info == 0 && *flag >= 0 && taken > 0)
    info = up_to (s, p, &taken, flag);
  if (info == 0 && *flag >= 0 && (taken < 0 || (taken > 0 && ! s->by->dense && s->t < p->t)))
    {
      p->end = s->t;
      taken = -1;
    }
  *found = taken > 0 ? p->i : -1;
  return info;
}

int
gs_events_in_step (gs_run *s, double from, int *event, int *flag)
{
  place p = { .from = from, .begin = from, .end = s->t };
  int info, found;
  const double *end = s->y;
  gs_events e = plan (s);
  for (int i = 0; i < e.ne; i++)
    e.fresh[i] = e.fresh[i] >= 2 ? 3 - e.fresh[i] : e.fresh[i];
  *event = *flag = 0;
  memcpy (s->known, s->x, sizeof (double) * s->r->nx);
  while ((info = next_event (s, &p, &found, flag)) == 0 && *flag >= 0 && found != 0)
    {
      if (found < 0)
        continue;
      int so_far = *plan (s).count;
      if ((info = act (s, &p)) != 0)
        return info;
      *event = changed (s, so_far);
      if (! *event && (*flag = go_on (s, &p)) < 0)
        break;
      if (*event || p.end <= p.t)
        {
          *event = 1;
          s->t = p.t;
          s->y = s->event;
          return FINISHED;
        }
      s->y = s->by->dense ? end : s->y;
    }
  return info;
}
