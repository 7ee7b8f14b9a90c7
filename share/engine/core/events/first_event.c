/* gs_first_event: looks for the first event within a step; if there is one, the step is done again
 * up to it.
 *
 * Most steps of gs_step_dp853 are quiet, which gs_events_quiet tells; in the others states are
 * those of its polynomial of order 7 (gs_dense_coefficients), and a step is repeated where this is
 * off by ten tolerances. Eight points of that polynomial (of the cubic one through both ends of a
 * step of gs_step_rk4, of that of gs_step_passage or gs_event_septic), not evenly spaced (what
 * repeats itself would hide between them), tell whether an event function falls to 0, and up to
 * 2048 where it has a lowest value that they do not resolve (ports that stick let steps grow,
 * whatever the inputs do), or its last events say so (gs_user_points: where these are too few the
 * step is too long); its zero by the method of Illinois. The part before it is looked at again in
 * the same way: there may be an earlier one. Where a function of the user has just had its event
 * more points are closer and closer to the beginning of the step.
 * From there on the step itself is made as long as it must be, by the secant method, so that the
 * state at the event is as accurate as any other. Where a run carries derivatives they follow in
 * the last such step alone. */
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/events.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"

static gs_events
plan (const gs_system *g)
{
  return gs_events_of (g->nx, g->ip + g->ip[GS_EVENTS] - 1, g->rp + g->ip[GS_EVENTS + 1] - 1);
}

/* are the states of the step those of a polynomial, and the step is not made again? */
static int
is_polynomial (const gs_step *e)
{
  return e->method == 12 || e->method == 0;
}

/* the inputs failed */
static int
failed (const gs_system *g, int info)
{
  g->istat[GS_FAILED_INFO] = info;
  g->istat[GS_FAILED] = GS_AT_INPUTS;
  return info;
}

/* rates at both ends of e, for the cubic polynomial */
static int
ends (const gs_system *g, const gs_step *e, gs_real *xdn)
{
  if (e->method == 4)
    {
      int info = gs_rates_at (g, e->t, 1, e->x, e->f);
      if (info != 0)
        return info;
    }
  return is_polynomial (e) ? 0 : gs_rates_at (g, e->tn, e->side, e->xn, xdn);
}

/* in e, or up to its event `first`: the number of a function that has not risen above 0 since its
 * last event and tells what happens just after that, else 0 */
static int
still_below (const gs_events *a, int first)
{
  int found = 0;
  for (int i = 0; i < a->ne; i++)
    if (i + 1 != first && a->marks[i] == 0 && ! gs_is_held (a, i) && ! gs_is_own (a, i)
        && a->last[i] < 0)
      found = i + 1;
  return found;
}

static int tried (const gs_system *g, const gs_step *e, gs_real th, gs_real *te, const gs_events *a,
                  gs_real *err);

/* the largest error of a step up to an event beside the tolerance: see gs_dp853_trial */
static gs_real
most_error (const gs_system *g)
{
  if (g->s->nlam > 0 && g->p[GS_PIVOT] < GS_R (0.25) * g->p[GS_LARGEST])
    return gs_max (1, gs_pow (gs_epsilon (), GS_R (2.0) / 3) / g->ropt[1]);
  return 1;
}

/* functions of the user that have been above 0 before an event count as such */
static void
above_before (const gs_events *a)
{
  for (int i = 0; i < a->ne; i++)
    if (gs_is_own (a, i))
      a->mark[i] |= a->marks[i];
}

/* from here on the sign of function i at the end of the step is all that counts */
static void
by_its_end (const gs_system *g, int i)
{
  int *flag = plan (g).fresh + i - 1;
  *flag = 3 - gs_least (1, *flag);
}

/* the step e, which was made again to another end, as it was first, and its polynomial */
static int
as_it_was (const gs_system *g, gs_step *e)
{
  gs_real off;
  return e->method == 8 ? gs_event_polynomial (g, e, 1, &off) : 0;
}

/* Has function i been above 0 on the way to its zero at th? Where it was not at the beginning, the
 * step itself tells, not its polynomial. */
static int
rose (const gs_system *g, gs_step *e, int i, gs_real th, int *so)
{
  const gs_events a = plan (g);
  gs_real te, err, tm;
  *so = 1;
  if (is_polynomial (e) || ! gs_is_own (&a, i - 1) || a.mark[i - 1] == 1)
    return 0;
  int info = gs_event_highest (g, e, i, th, &tm);
  if (info != 0)
    return failed (g, info);
  *a.search = *a.tells == 1;
  info = tried (g, e, tm * th, &te, &a, &err);
  *a.search = 0;
  *so = a.now[i - 1] > 0;
  return info == 0 ? as_it_was (g, e) : info;
}

/* how the first event of a step is looked for */
typedef struct
{
  int is_long; /* may the step be made shorter where a function is fast? */
  int first;   /* its function, 0: none */
  gs_real thf; /* and where it is on the polynomial of the step */
  int ns;      /* in how many points */
  int many;    /* ... at least, all in all, see gs_user_points */
  int more;    /* 1 where these were more than those of other steps */
  int fast;    /* 1 where a function is too fast for any, and the step may be made shorter */
} search;

/* what the polynomial alone says: all again in more points, and then without it */
static void
otherwise (const gs_system *g, search *l, int i)
{
  if (l->more)
    by_its_end (g, i);
  l->ns = l->more ? l->many : l->many > 512 ? l->many : 512;
  l->more = 1;
}

/* the first function that falls to 0 within e, and where on its polynomial; the part before it
 * again */
static int
first_event (const gs_system *g, gs_step *e, search *l)
{
  int found;
  gs_real be = 1;
  l->first = 0;
  l->thf = 2;
  for (;;)
    {
      gs_real th;
      int fine, so = 1,
                info = gs_event_zero (g, e, be, l->ns, l->first == 0 ? e->side : 1, &found, &th,
                                      &fine, &l->fast);
      if (info != 0)
        return failed (g, info);
      if ((fine || l->fast) && l->ns < 2048)
        {
          l->ns *= 2;
          continue;
        }
      l->fast &= l->is_long;
      if (! (found > 0 && th < GS_R (0.999) * l->thf) || l->fast)
        return 0;
      if ((info = rose (g, e, found, th, &so)) != 0)
        return info;
      l->first = so ? found : 0;
      l->thf = so ? th : 2;
      be = so ? th * (1 - GS_R2 (1e-9, 1e-6)) : 1;
      l->ns = (int) gs_max (8, be * (gs_real)l->many);
      if (! so)
        otherwise (g, l, found);
    }
}

/* the step e up to its first event; again: the polynomial alone says so */
static int
up_to (const gs_system *g, gs_step *e, search *l, int *found, int *again)
{
  const int first = l->first;
  const gs_events a = plan (g);
  const gs_real instant = GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->tn));
  gs_real err;
  *found = first;
  *again = 0;
  if (a.fresh[first - 1] >= 2 && gs_abs (e->h) > instant)
    {
      *found = -1;
      return 0;
    }
  int info = gs_event_secant (g, e, first, l->thf, &err);
  *again = info == 0 && err < 0;
  if (*again && a.kind[first - 1] == 2 && gs_abs (e->h) > instant)
    {
      *again = 0;
      *found = -1;
      return 0;
    }
  if (*again)
    {
      otherwise (g, l, first);
      return as_it_was (g, e);
    }
  if (info == 0 && e->wanted && e->tn > *e->wanted)
    {
      *found = -2;
      return 0;
    }
  if (err > most_error (g) && gs_abs (e->h) > instant)
    *found = -1;
  if (e->tn - e->t > instant)
    *a.since = 0;
  if (info == 0 && *found > 0 && e->method != 0 && e->tn - e->t > instant)
    above_before (&a);
  return info == 0 && *found > 0 ? gs_user_accumulates (g, &a, e->t, e->tn - e->t, first, a.now)
                                 : info;
}

/* the polynomial of a step of gs_step_dp853; found: -1 where it is off by more than most and the
 * step is long enough to be repeated */
static int
polynomial (const gs_system *g, gs_step *e, int is_long, gs_real most, int *found)
{
  gs_real off;
  const int info = gs_event_polynomial (g, e, 0, &off);
  if (info != 0)
    return info;
  e->rows_off = off;
  if (! (off <= most) && is_long)
    {
      e->off = off;
      *found = -1;
    }
  return 0;
}

/* is the step e of gs_step_dp853 quiet? Else its polynomial, which must be within ten tolerances,
 * or within three where outputs are to be taken from it */
static int
look (const gs_system *g, gs_step *e, int is_long, int *quiet, int *found)
{
  *quiet = 0;
  e->off = 0;
  if (e->method != 8)
    return 0;
  const gs_real most = most_error (g);
  int info = e->rows ? polynomial (g, e, is_long, most, found) : 0;
  if (info != 0 || *found < 0)
    return info;
  info = gs_events_quiet (g, e, quiet);
  if (info != 0)
    return failed (g, info);
  if (! *quiet && ! e->rows)
    info = polynomial (g, e, is_long, 3 * most, found);
  return info;
}

int
gs_first_event (const gs_system *g, gs_step *e, int *found)
{
  const gs_events a = plan (g);
  const int is_long
      = gs_abs (e->h) > GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->tn));
  const gs_real largest = g->rstat[GS_H_LARGEST];
  search l = { .is_long = is_long && e->h > GS_R (1e-2) * largest && largest > 0 };
  int quiet = 0, again, info = ends (g, e, a.xdn);
  *found = 0;
  for (int i = 0; i < a.ne && e->method != 0; i++)
    if (a.fresh[i] >= 2)
      a.fresh[i] = 3 - a.fresh[i];
  if (info == 0)
    info = look (g, e, is_long, &quiet, found);
  if (*found < 0)
    return info;
  again = ! quiet;
  l.many = gs_user_points (&a, e->t, e->h);
  if (info == 0 && again && l.many > 2048 && is_long)
    {
      *found = -1;
      return 0;
    }
  l.ns = l.many = l.many < 2048 ? l.many : 2048;
  while (info == 0 && again)
    {
      again = 0;
      if ((info = first_event (g, e, &l)) != 0)
        return info;
      *found = still_below (&a, l.first);
      if (l.fast || (*found > 0 && is_long))
        *found = -1;
      else if (l.first > 0)
        info = up_to (g, e, &l, found, &again);
    }
  if (info == 0 && *found == 0)
    {
      memcpy (a.mark, a.marks, (size_t)a.ne * sizeof (int));
      gs_copy (a.ne, a.last, a.g);
      *a.since = 0;
      info = gs_user_accumulates (g, &a, e->t, e->h, 0, a.last);
      gs_user_levels_left (&a);
    }
  return info;
}

/* do the last three points, c and a apart, show a lowest value that they do not resolve? Has the
 * parabola through them its lowest point between them, or close to them? */
static int
unresolved (gs_real older, gs_real before, gs_real now, gs_real c, gs_real a)
{
  if (! (older > 0 && before > 0 && now > 0))
    return 0;
  const gs_real old = (before - older) / c, slope = (now - before) / a,
               curve = (slope - old) / (a + c), s = a + c;
  return old < GS_R (1.25) * c * curve && slope > -GS_R (1.25) * a * curve
         && GS_R (0.5) * (s * s) * curve > gs_min (gs_min (older, now), before);
}

int
gs_event_zero (const gs_system *g, const gs_step *e, gs_real be, int ns, int side, int *found,
               gs_real *th, int *fine, int *fast)
{
  const gs_events p = plan (g);
  const gs_real near = GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->t + e->h));
  int j0 = 1, last = ns, own = 0;
  for (int i = 0; i < p.ne; i++)
    {
      if (p.fresh[i] == 1)
        j0 = -24;
      own |= gs_is_own (&p, i);
      p.marks[i] = p.mark[i];
      p.before[i] = p.g[i];
      p.older[i] = -1;
    }
  *found = 0;
  *fine = 0;
  *fast = 0;
  *th = 2;
  for (int j = j0; j <= ns; j++)
    {
      gs_real b = be * gs_event_point (j, ns);
      gs_real a = j > j0 ? b - be * gs_event_point (j - 1, ns) : b;
      gs_real c = j > j0 ? b - a : 0;
      if (j > j0 + 1)
        c -= be * gs_event_point (j - 2, ns);
      int info = gs_events_at_fraction (g, e, b, j == ns ? side : 1);
      if (info != 0)
        return info;
      for (int i = 0; i < p.ne; i++)
        {
          p.last[i] = p.now[i];
          if (j > j0 && j > 1 && a * e->h > near && gs_is_own (&p, i)
              && gs_event_too_fast (&p, i, j, p.older[i], p.before[i], p.last[i], c, a))
            *fast = 1;
          if (unresolved (p.older[i], p.before[i], p.last[i], c, a))
            *fine = 1;
          p.older[i] = p.before[i];
          p.before[i] = p.last[i];
        }
      const int soon = gs_abs (b * e->h) <= near, seen = *found;
      if (seen > 0 && j >= last)
        return 0;
      for (int i = 0; i < p.ne && seen == 0; i++)
        if (p.last[i] > 0)
          p.marks[i] |= ! (soon && gs_is_own (&p, i) && p.fresh[i] == 1)
                        && (p.fresh[i] < 2 || (j == ns && be >= 1))
                        && gs_risen (&p, i, p.last[i]);
        else if (p.marks[i] == 1 && (p.fresh[i] < 2 || (j == ns && be >= 1)))
          {
            gs_real zero = b;
            info = gs_event_illinois (g, e, b - a, &zero, i + 1);
            if (info != 0)
              return info;
            if (zero < *th)
              {
                *th = zero;
                *found = i + 1;
              }
          }
      /* behind a zero four points more are looked at, where the user has events: do they resolve
       * it? */
      if (*found > 0 && ! own)
        return 0;
      if (seen == 0 && *found > 0)
        last = gs_most (j, 0) + 4;
    }
  return 0;
}

int
gs_event_illinois (const gs_system *g, const gs_step *e, gs_real begin, gs_real *c, int i)
{
  const gs_events p = plan (g);
  gs_real a = begin, gb = p.last[i - 1];
  int info = gs_events_at_fraction (g, e, a, 1);
  if (info != 0)
    return info;
  gs_real ga = gs_max (p.now[i - 1], 0);
  int kept = 0; /* the end that stayed: 1 c, -1 a */
  for (int k = 0; k < 60; k++)
    {
      if (*c - a <= GS_R2 (1e-12, 1e-6) || ga - gb <= 0)
        return 0;
      gs_real d = (ga * *c - gb * a) / (ga - gb);
      if (! (d > a && d < *c))
        d = GS_R (0.5) * (a + *c);
      info = gs_events_at_fraction (g, e, d, 1);
      if (info != 0)
        return info;
      gs_real gc = p.now[i - 1];
      if (gc > 0)
        {
          a = d;
          ga = gc;
          if (kept == 1)
            gb *= GS_R (0.5);
          kept = 1;
        }
      else
        {
          *c = d;
          gb = gc;
          if (kept == -1)
            ga *= GS_R (0.5);
          kept = -1;
          if (! (gc < 0))
            a = *c;
        }
    }
  return 0;
}

/* e again with the length th*h to te, into end, onto the constraints; err as gs_event_secant. info
 * as gs_first_event */
static int
again (const gs_system *g, const gs_step *e, gs_real th, gs_real te, int side, const gs_events *a,
       gs_real *err)
{
  const gs_scene *s = g->s;
  const int way = g->iopt[GS_LOOPS];
  gs_real res;
  int info = 0;
  if (is_polynomial (e))
    {
      gs_event_state (g->nx, e, th, a->xdn, a->end);
      return 0;
    }
  if (e->method == 4)
    info = gs_step_rk4 (g, e->t, te, side, th * e->h, e->x, a->end, e->f + g->nx);   /* rates at x
                                                                                        stay */
  else
    info = gs_step_dp853 (g, e->t, te, side, th * e->h, e->x, a->end, err, e->f);
  if (info != 0)
    return info;
  if (way != 1 && (s->nq > s->nu || (s->nlam > 0 && way != 3)))
    {
      info = s->prj (te, a->end, g->cst, &res);
      g->istat[GS_N_PROJECTIONS]++;
      if (info == 2)
        info = 0;
      if (info != 0)
        {
          g->istat[GS_FAILED_INFO] = info;
          g->istat[GS_FAILED] = GS_AT_PRJ;
        }
    }
  return info;
}

/* the slope of function i before its zero at the fraction th of the polynomial of e */
static int
first_slope (const gs_system *g, const gs_step *e, int i, gs_real th, gs_real *slope)
{
  gs_real d = gs_min (GS_R (1e-3), GS_R (0.5) * th);
  int info = gs_events_at_fraction (g, e, th - d, 1);
  *slope = d > 0 ? -plan (g).now[i - 1] / d : 0;
  return info;
}

/* the step e, of the fraction th, its end in te and a.end, the event functions there in a.now */
static int
tried (const gs_system *g, const gs_step *e, gs_real th, gs_real *te, const gs_events *a,
       gs_real *err)
{
  const int side = th >= 1 ? e->side : 1;
  *te = th >= 1 ? e->tn : e->t + th * e->h;
  int info = again (g, e, th, *te, side, a, err);
  if (info != 0)
    return info;
  info = gs_event_values (g, *te, side, a->end, a->mode, a->now);
  if (info != 0)
    return failed (g, info);
  gs_user_values_now (a);
  return 0;
}

/* an event of the user has happened: a little later than th its function i is not above 0 */
static int
past (const gs_system *g, const gs_step *e, int i, gs_real th, gs_real *te, const gs_events *a,
      gs_real *err)
{
  const gs_real least = gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->tn));
  for (int k = 0; k < 8 && gs_is_own (a, i - 1) && a->now[i - 1] > 0 && th < 1; k++)
    {
      th = gs_min (1, th + gs_ldexp (1, k) * least / e->h);
      int info = tried (g, e, th, te, a, err);
      if (info != 0)
        return info;
    }
  return 0;
}

/* port i (from 0) that slides or is away from its stop, te being hardly later than the beginning */
static int
has_just_gone (const gs_step *e, gs_real te, const gs_events *a, int i)
{
  return ! gs_is_own (a, i) && ! gs_is_held (a, i)
         && te - e->t <= GS_R (1e3) * gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->tn));
}

/* where gs_event_secant looks next, from th, where its function is gc: between lo, where it is
 * above 0, and hi, where it is not (2: unknown). 0: nowhere, it is there or does not fall to 0 */
static int
further (int k, gs_real d, gs_real lo, gs_real hi, gs_real *th, int *there)
{
  const gs_real old = *th;
  if (hi <= 1)
    {
      *th -= d;
      if (! (*th > lo && *th < hi) || k % 8 == 0)
        *th = GS_R (0.5) * (lo + hi);
      if (k < 80 && gs_abs (*th - old) > 0)
        return 1;
      *there = 1;
      return 0;
    }
  if (! (k < 12 && gs_abs (d) <= GS_R (0.1)))
    return 0;
  *th = gs_min (1, gs_max (0, *th - d));
  return gs_abs (*th - old) > 0;
}

/* e made again up to the zero of function i, from the fraction th on, on exit where e was made
 * last; there: it has one */
static int
secant (const gs_system *g, const gs_step *e, const gs_events *a, int i, gs_real *th, gs_real *te,
        gs_real *err, int *there)
{
  const gs_real least = 2 * gs_epsilon () * gs_max (gs_abs (e->t), gs_abs (e->tn));
  gs_real slope, old = 0, gold = 0, lo = 0, hi = 2;
  int info = first_slope (g, e, i, *th, &slope);
  if (info != 0)
    return failed (g, info);
  *there = 0;
  for (int k = 1;; k++)
    {
      if ((info = tried (g, e, *th, te, a, err)) != 0)
        return info;
      const gs_real gc = a->now[i - 1];
      if (gc > 0)
        lo = gs_max (lo, *th);
      else
        hi = gs_min (hi, *th);
      if (k > 1 && gs_abs (*th - old) > 0 && gs_abs (gc - gold) > 0)
        slope = (gc - gold) / (*th - old);
      old = *th;
      gold = gc;
      const gs_real d = gs_abs (slope) > 0 ? gc / slope : 1;
      *there = gs_abs (d * e->h) <= least || (hi - lo) * e->h <= least;
      if (*there || ! further (k, d, lo, hi, th, there))
        break;
    }
  *th = old;
  return 0;
}

int
gs_event_secant (const gs_system *g, gs_step *e, int i, gs_real start, gs_real *err)
{
  *err = 0;
  const gs_events a = plan (g);
  gs_real th = start, te = e->tn;
  *a.search = *a.tells == 1;
  int there, info = secant (g, e, &a, i, &th, &te, err, &there);
  *a.search = 0;
  if (info == 0 && *a.tells == 1)
    info = tried (g, e, th, &te, &a, err);
  if (info == 0)
    info = past (g, e, i, th, &te, &a, err);
  if (info != 0)
    return info;
  if (a.now[i - 1] > 0 && ! is_polynomial (e) && a.fresh[i - 1] < 2
      && (gs_is_own (&a, i - 1) || has_just_gone (e, te, &a, i - 1) || ! there))
    {
      *err = -1;
      return 0;
    }
  e->tn = te;
  gs_copy (g->nx, a.end, e->xn);
  return 0;
}

int
gs_event_highest (const gs_system *g, const gs_step *e, int i, gs_real th, gs_real *tm)
{
  const gs_events a = plan (g);
  gs_real most = 0;
  *tm = GS_R (0.5);
  for (int k = 1; k <= 7; k++)
    {
      const gs_real c = GS_R (0.125) * (gs_real)k;
      int info = gs_events_at_fraction (g, e, c * th, 1);
      if (info != 0)
        return info;
      if (a.now[i - 1] > most)
        {
          most = a.now[i - 1];
          *tm = c;
        }
    }
  return 0;
}

int
gs_events_at_fraction (const gs_system *g, const gs_step *e, gs_real b, int side)
{
  const gs_events a = plan (g);
  gs_event_state (g->nx, e, b, a.xdn, a.z);
  int info = gs_event_values (g, e->t + b * e->h, side, a.z, a.mode, a.now);
  gs_user_values_now (&a);
  return info;
}

/* the distances grow evenly, threefold from the first to the last */
gs_real
gs_event_point (int j, int ns)
{
  gs_real b = (gs_real)gs_most (1, j) / (gs_real)ns;
  b = GS_R (0.5) * b * (1 + b);
  if (j < 1)
    b *= gs_pow (GS_R (0.25), (gs_real)(1 - j));
  return j < -24 ? 0 : b;
}

void
gs_event_state (int nx, const gs_step *e, gs_real b, const gs_real *xdn, gs_real *z)
{
  if (e->method == 0)
    {
      gs_event_septic (nx, b, e->f, z);
      return;
    }
  if (e->method == 8)
    {
      gs_dense_from_rates (nx, e->h, b, e->x, e->f, e->xn, xdn, e->f + nx, z);
      return;
    }
  if (e->method != 12)
    {
      gs_event_cubic (nx, e->h, b, e->x, e->f, e->xn, xdn, z);
      if (e->method == 5)
        gs_event_quintic (nx, e->h, b, e->x, e->f, e->xn, xdn, z);
      return;
    }
  gs_real c[12], wt[12], q[12];
  gs_gauss_points (e->ns, c, wt);
  gs_gauss_weights (e->ns, c, wt, (e->t - e->tc) / e->d, (e->t + b * e->h - e->tc) / e->d, q);
  gs_passage_path (nx, e->ns, nx, e->x, e->d, q, e->f, z);
}

void
gs_event_cubic (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xd,
                const gs_real *xn, const gs_real *xdn, gs_real *z)
{
  const gs_real p = b * b * (3 - 2 * b);
  const gs_real q = h * b * (1 - b) * (1 - b);
  const gs_real r = h * b * b * (b - 1);
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + p * (xn[i] - x[i]) + q * xd[i] + r * xdn[i];
  if (b < 1)
    return;
  for (int i = 0; i < nx; i++)
    z[i] = xn[i];
}

void
gs_event_septic (int nx, gs_real b, const gs_real *w, gs_real *z)
{
  gs_real c[8];
  for (int j = 0; j < 8; j++)
    c[j] = GS_R (0.5) * (1 - gs_cos ((gs_real)j * gs_acos (-1) / 7));
  for (int i = 0; i < nx; i++)
    z[i] = 0;
  for (int j = 1; j < 8; j++)
    {
      gs_real f = 1;
      for (int k = 0; k < 8; k++)
        if (k != j)
          f = f * (b - c[k]) / (c[j] - c[k]);
      for (int i = 0; i < nx; i++)
        z[i] += f * (w[i + nx * j] - w[i]);
    }
  for (int i = 0; i < nx; i++)
    z[i] += w[i];
}

int
gs_event_values (const gs_system *g, gs_real t, int side, const gs_real *x, const int *mode,
                 gs_real *gv)
{
  if (g->ip[GS_V0] != 0 || g->ip[GS_FEEDBACK] != 0)
    {
      int info = gs_inputs_of_run (g->s, t, side, x, g->nx, g->ip, g->rp, g->cst, g->v, g->w);
      if (info != 0)
        return info;
    }
  g->s->evt (gs_time_beside (t, side), x, g->v, mode, g->cst, gv);
  return 0;
}
