/* gsmbp/events.h: ports that stick or hit stops. Calling rules: scene.h.
 *
 * Numbers of events, ports and inputs are counted from 1. */
#ifndef GSMBP_EVENTS_H
#define GSMBP_EVENTS_H

#include "gsmbp/real.h"
#include "gsmbp/inputs.h"
#include "gsmbp/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* the plan of the events, see gs_resolve_event */
typedef struct
{
  int ne, nr, nx; /* event functions (and modes), places for records, states */
  int *count;     /* events so far */
  int *since;     /* events since the time went on */
  int given;      /* 1 if the modes at the start are given */
  int *tells;     /* 1: behind the events of an instant rst is called once more, with k = -2; 2:
                     only events of the user are recorded, and counted */
  int *search;    /* where tells is 1: 1 while the time of an event is looked for, of which states
                     alone matter */
  int *cause;     /* while rst is called: what gs_resolve_event was called with */
  int *ended;     /* the number of the event function that ends the run, 0: none does */
  int ns;         /* inputs that are switched at events of the user */
  int *mode;      /* ne */
  int *input;     /* ne: the numbers of the inputs that are the modes */
  int *kind;      /* ne: 1 friction, 2 stops, 3 an event of the user, 4 one that ends the run,
                     5 one that only reports */
  int *mark;      /* ne: 1 where the function was above 0 since its last event */
  int *marks;     /* ne, workspace: the same at a place within a step */
  int *fresh;     /* ne: 1 where the function has just had its event or the run begins */
  int *by;        /* ns: numbers of event functions, */
  int *switched;  /* ns: of the inputs that they switch, */
  int *on;        /* ns: 1 where the input is held */
  int *times;     /* ne: how many events a function has had */
  int *newest;    /* which one has had the last one, 0: none has */
  gs_real *g;     /* ne: event functions */
  gs_real *now;   /* ne, workspace of gs_first_event from here on: event functions at a place of a
                     step, */
  gs_real *last;  /* ne: at the last point that was looked at, */
  gs_real *before; /* ne: at the one before, as marks go on, */
  gs_real *older; /* ne: at the one before that */
  gs_real *xdn;   /* nx: rates at the end of the step */
  gs_real *z;     /* nx: the state at a place of a step */
  gs_real *end;   /* nx: the state at the end of the step that was done again */
  gs_real *record; /* (3+2*nx,nr): time, number, mode after, states before and after */
  gs_real *level; /* ne: what a function of the user is at its last event but for rounding */
  gs_real *held;  /* ns: values of the inputs that are held */
  gs_real *first; /* ne: when a function had its first event, where it has had one, */
  gs_real *latest; /* ne: and its last one */
  gs_real *told;  /* (8+nx,ne): what is remembered of the user's: gs_told */
} gs_events;

/* What is remembered of an event function of the user: where this stands in its part of told. */
enum
{
  GS_TOLD_TIMES = 0,    /* of its last four events, the last one first */
  GS_TOLD_CHANGED = 4,  /* 1 where the last one has changed states */
  GS_TOLD_RISEN = 5,    /* what it must be above to have risen */
  GS_TOLD_BEND = 6,     /* workspace of gs_events_quiet and gs_event_zero */
  GS_TOLD_NOISE = 7,    /* rounding errors of it: 1000 units of what it was up to events */
  GS_TOLD_STATE = 8     /* nx: behind the last one */
};

/* the plan of which ie and re are the arrays */
static inline gs_events
gs_events_of (int nx, int *ie, gs_real *re)
{
  gs_events a;
  a.ne = ie[0];
  a.nr = ie[1];
  a.nx = nx;
  a.count = ie + 2;
  a.since = ie + 3;
  a.given = ie[4];
  a.tells = ie + 5;
  a.cause = ie + 6;
  a.search = ie + 7;
  a.ended = ie + 8;
  a.ns = ie[9];
  a.mode = ie + 10;
  a.input = a.mode + a.ne;
  a.kind = a.input + a.ne;
  a.mark = a.kind + a.ne;
  a.marks = a.mark + a.ne;
  a.fresh = a.marks + a.ne;
  a.by = a.fresh + a.ne;
  a.switched = a.by + a.ns;
  a.on = a.switched + a.ns;
  a.times = a.on + a.ns;
  a.newest = a.times + a.ne;
  a.g = re;
  a.now = a.g + a.ne;
  a.last = a.now + a.ne;
  a.before = a.last + a.ne;
  a.older = a.before + a.ne;
  a.xdn = a.older + a.ne;
  a.z = a.xdn + nx;
  a.end = a.z + nx;
  a.record = a.end + nx;
  a.level = a.record + a.nr * (3 + 2 * nx);
  a.held = a.level + a.ne;
  a.first = a.held + a.ns;
  a.latest = a.first + a.ne;
  a.told = a.latest + a.ne;
  return a;
}

/* is port i (from 0) held: friction that sticks, a stop in contact? */
static inline int
gs_is_held (const gs_events *a, int i)
{
  return (a->kind[i] == 1) == (a->mode[i] == 0);
}

/* has an event of the user ended the run whose plan ip is? */
static inline int
gs_ended (const int *ip)
{
  return ip[GS_EVENTS] > 0 && ip[ip[GS_EVENTS] + 7] > 0;
}

/* is function i (from 0) that of an event of the user? */
static inline int
gs_is_own (const gs_events *a, int i)
{
  return a->kind[i] > 2;
}

/* ... of one that only reports? */
static inline int
gs_reports (const gs_events *a, int i)
{
  return a->kind[i] == 5;
}

/* what is remembered of function i (from 0) */
static inline gs_real *
gs_told (const gs_events *a, int i)
{
  return a->told + i * (GS_TOLD_STATE + a->nx);
}

/* has function i (from 0), which is g, risen above 0? One of the user must be above what rounding
 * errors make of 0. */
static inline int
gs_risen (const gs_events *a, int i, gs_real g)
{
  return g > 0 && (! gs_is_own (a, i) || g > gs_told (a, i)[GS_TOLD_RISEN]);
}

/* From when on events of function i (from 0), of the user, accumulate if it does not rise above 0
 * again. Where its last four events lie within 1e-9 of the time since then. Where the last event
 * has changed states and three intervals between them fell one after the other, after twice the
 * last one; where all three are within 1e-8 of the time, whatever their order, after ten times as
 * long (bounces that drown in rounding errors). Those that only report do not. */
static inline gs_real
gs_accumulates_from (const gs_events *a, int i)
{
  const gs_real *told = gs_told (a, i), *t = told + GS_TOLD_TIMES;
  if (a->times[i] < 4 || gs_reports (a, i))
    return GS_HUGE;
  const gs_real all = t[0] - t[3];
  gs_real from = t[0] + GS_R (1e9) * all;
  if (! (told[GS_TOLD_CHANGED] > 0))
    return from;
  if (t[0] - t[1] < t[1] - t[2] && t[1] - t[2] < t[2] - t[3])
    from = gs_fmin (from, t[0] + 2 * (t[0] - t[1]));
  return all < GS_R2 (1e-8, 1e-5) * gs_abs (t[0]) ? gs_fmin (from, t[0] + 10 * all) : from;
}

/* The mean interval of the last four events of function i (from 0), of the user; 0: there are not
 * so many. A step that goes past four of them behind the last event may hold more than it seems. */
static inline gs_real
gs_interval (const gs_events *a, int i)
{
  const gs_real *t = gs_told (a, i) + GS_TOLD_TIMES;
  return gs_is_own (a, i) && a->times[i] >= 4 ? (t[0] - t[3]) / 3 : 0;
}

static inline gs_real
gs_repeats_until (const gs_events *a, int i)
{
  return gs_told (a, i)[GS_TOLD_TIMES] + 4 * gs_interval (a, i);
}

/* a step in which gs_first_event looks for events */
typedef struct
{
  int method;   /* as iopt[GS_METHOD]; 12: gs_step_passage, whose polynomial has the states within;
                 * 0: of an implicit method, its states at the points of gs_event_septic are in f
                 * (nx,8) */
  gs_real t, h; /* where the step begins, its length [s] */
  gs_real tn;   /* its end, on exit of gs_first_event the time of the event [s] */
  int side;     /* of tn: < 0 if a jump of the inputs may lie there */
  gs_real *x;   /* nx: the state at t */
  gs_real *xn;  /* nx: the state at tn */
  gs_real *f;   /* (nx,13): its stages, the first column are the rates at x; of gs_step_dp853
                 * columns 0 and 5 to 12 stay where there is no event */
  gs_real tc, d; /* of gs_step_passage: from tc - d to tc + d [s] */
  int ns;       /* ... with so many stages */
  gs_real off;  /* on exit of gs_first_event the error of the polynomial beside the tolerance where
                 * it is too large, else 0 */
  int rows;     /* 1: outputs lie within the step, its polynomial must be within three tolerances */
  gs_real rows_off; /* ... gs_dense_error of it; where there is no event it is in columns 1 to 4 of
                       f */
  const gs_real *wanted; /* a time behind which events are not, or a null pointer */
} gs_step;

/* Is event function i (from 0) too fast for the points of a step, of which j has been looked at, so
 * that it may pass 0 between them? It was older, before and now at the last three, c and a apart;
 * from j = 3 on the point before was told. */
int gs_event_too_fast (const gs_events *p, int i, int j, gs_real older, gs_real before, gs_real now,
                       gs_real c, gs_real a);

/* the first event within the step e; if there is one the step is done again up to it. found: its
 * number, 0 none, -1 the step is too long to see what happens, -2 it is
 * not wanted: nothing is done. info: what failed, as istat[GS_FAILED_INFO] and istat[GS_FAILED] */
int gs_first_event (const gs_system *g, gs_step *e, int *found);

/* for gs_first_event: quiet: 1 if no event function comes close to 0 in the step e of
 * gs_step_dp853, beside what a polynomial through its stages may hide; then the plan is as
 * gs_event_zero leaves it */
int gs_events_quiet (const gs_system *g, gs_step *e, int *quiet);

/* for gs_events_quiet: the error of a cubic polynomial through both ends of a step, at the fraction
 * b of it, beside that in its middle */
gs_real gs_event_cubic_error (gs_real b);

/* for gs_first_event: the polynomial of order 7 of the step e of gs_step_dp853 into the columns 1
 * to 4 of its stages; again: it was made again to another end, and is made as it was first; off: as
 * gs_dense_error */
int gs_event_polynomial (const gs_system *g, const gs_step *e, int again, gs_real *off);

/* for gs_first_event: the first zero, at the fraction th, of an event function on the polynomial of
 * e up to the fraction be, in ns points; side at be; fine: 1 if these do not resolve a lowest
 * value; fast: 1 if one is too fast for them */
int gs_event_zero (const gs_system *g, const gs_step *e, gs_real be, int ns, int side, int *found,
                   gs_real *th, int *fine, int *fast);

/* for gs_event_zero: the zero of function i between the fractions begin and *c, by the method of
 * Illinois; on exit it has fallen to 0 at *c */
int gs_event_illinois (const gs_system *g, const gs_step *e, gs_real begin, gs_real *c, int i);

/* for gs_first_event: the step e once more, by the secant method as long as function i needs to be
 * 0 at its end; it starts at the fraction start. err: that of gs_step_dp853, else 0; -1: it
 * does not fall to 0 on the step, though on its polynomial; its end is not changed */
int gs_event_secant (const gs_system *g, gs_step *e, int i, gs_real start, gs_real *err);

/* where function i is highest on the polynomial of the step e, on the way to its zero at the
   fraction th: of seven points the fraction tm of that way */
int gs_event_highest (const gs_system *g, const gs_step *e, int i, gs_real th, gs_real *tm);

/* event functions at the fraction b of the step e, on its polynomial, into the plan's now */
int gs_events_at_fraction (const gs_system *g, const gs_step *e, gs_real b, int side);

/* the point j of ns of a step, as a fraction of it; from 0 to -24 each is a quarter of the next */
gs_real gs_event_point (int j, int ns);

/* the state z at the fraction b of the step e; xdn: the rates at its end; method 3, 5: of a step of
 * gs_step_dp853 by gs_event_cubic, and by gs_event_quintic */
void gs_event_state (int nx, const gs_step *e, gs_real b, const gs_real *xdn, gs_real *z);

/* the cubic polynomial through the ends of a step of the length h, at the fraction b of it */
void gs_event_cubic (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xd,
                     const gs_real *xn, const gs_real *xdn, gs_real *z);

/* from the state z of gs_event_cubic at the fraction b of a step of gs_step_dp853, with the stages
 * f (nx,13), that of a polynomial of order 5: it has the rates of the stages 7 and 10 as well, at
 * 1/4 and 3/5 */
void gs_event_quintic (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *f,
                       const gs_real *xn, const gs_real *xdn, gs_real *z);

/* the polynomial of order 7 at the fraction b of a step, from the states w (nx,8) at the fractions
 * (1 - cos(i*pi/7))/2, i = 0 ... 7; as what it is away from the first one, without rounding errors
 * there */
void gs_event_septic (int nx, gs_real b, const gs_real *w, gs_real *z);

/* event functions gv under the inputs of a run. info: that of the inputs */
int gs_event_values (const gs_system *g, gs_real t, int side, const gs_real *x, const int *mode,
                     gs_real *gv);

/* before gs_resolve_event acts at event k: which functions of the user have had their event just
 * now; all of them at the start */
void gs_user_events_begin (const gs_events *a, int k);

/* after event l of the user, which gs_resolve_event met at event k: its level, the inputs in v that
 * it switches, whether it ends the run; g: its function before the event */
void gs_user_event (const gs_events *a, int l, int k, gs_real g, const gs_real *v);

/* functions g of the user from their levels on; a level that later events of the same instant have
 * left is none */
void gs_user_from_levels (const gs_events *a, gs_real *g);

/* the plan's now from the levels of the functions of the user on */
void gs_user_values_now (const gs_events *a);

/* after a step without an event: levels that functions of the user have left are none; no function
 * has just had its event */
void gs_user_levels_left (const gs_events *a);

/* before event i of the user at the time t, and behind it: the state x is remembered */
void gs_user_before_event (const gs_events *a, int i, gs_real t, const gs_real *x);
void gs_user_after_event (const gs_events *a, int i, const gs_real *x);

/* Behind its last event: does function i (from 0) rise, as one does that was thrown back, or does
 * it go on falling (0)? fell: how fast it has since, in the mean; d: a small time. */
int gs_user_rises (const gs_system *s, const gs_events *a, int i, gs_real fell, gs_real d);

/* After a step of the length h from t, without an event or up to that of function but: do events of
 * the user accumulate? g (ne): their functions at the end. 10, and istat says so, or 0. */
/* in how many points event functions must be looked at in a step from t to t + h: 8, where it goes
   past gs_repeats_until 8 for each interval that it may hold; intervals of 1e-9 of the time are
   those of events that accumulate */
int gs_user_points (const gs_events *a, gs_real t, gs_real h);
int gs_user_accumulates (const gs_system *s, const gs_events *a, gs_real t, gs_real h, int but,
                         const gs_real *g);

/* gs_resolve_event under the inputs of a run, from the right; nothing where the scene has no
 * events. info: what failed, as istat[GS_FAILED_INFO] and istat[GS_FAILED] */
int gs_resolve_under_inputs (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                             const gs_real *cst, gs_real *v, gs_real *w, int *istat, int k);

/* gs_resolve_event within a run; info: what failed, as istat[GS_FAILED_INFO] and istat[GS_FAILED];
 * istat[GS_CAUSE]: the event that did */
int gs_resolve_in_run (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                       const gs_real *cst, gs_real *v, int *istat, int k);

/* the end of a run: an event of the user that lies at t itself, or that inputs which jump there
 * bring about; v, written: the inputs there from the left, behind an event from the right.
 * info: as gs_resolve_under_inputs */
int gs_event_at_end (const gs_scene *s, gs_real t, gs_real *x, int nx, int *ip, gs_real *rp,
                     const gs_real *cst, gs_real *v, gs_real *w, int *istat);

/* before what event functions of the user are at t counts, where a sampled device acts at t, too:
 * one that is not above 0, but is so behind that, has no event. v: workspace */
void gs_event_before_sample (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip,
                             gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w, int *istat);

/* the other side of gs_event_before_sample, where a run begins: a function that a switch or a jump
 * at t alone brings above 0, before a sampled device acts at t, has not been above 0. v: the inputs
 * from the right */
void gs_event_at_begin (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip,
                        gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w);

/* for gs_event_at_end: the first event function of the user that has been above 0 since its last
 * event and is not at t; 0: none; -1: none has been above 0 */
int gs_event_first_above (const gs_scene *s, const gs_events *a, gs_real t, const gs_real *x,
                          const gs_real *v, const gs_real *cst);

/* event k (0 the start, -1 inputs may have jumped) and those that follow from it at the same
 * instant. info: that of rst; 13: as gs_check_given_modes; 9: more than 100 events at one instant
 * (does friction fall within a speed vs below the tolerance of the speeds? remedy: a larger vs, or
 * method "dp853") */
int gs_resolve_event (const gs_scene *s, gs_real t, gs_real *x, int nx, gs_real *v,
                      const gs_real *cst, int k, int *ie, gs_real *re);

/* do the modes that are given at the start agree with the state? info: that of rst; 13: the one in
 * a->ended does not */
int gs_check_given_modes (const gs_scene *s, const gs_events *a, gs_real t, gs_real *x, gs_real *v,
                          const gs_real *cst);

/* which of the n entries of a row, from 1, is not 0; 0: none, or several */
int gs_only_entry (int n, const gs_real *row, int ldr);

/* event functions gv of k ports, above 0 where nothing happens; prm (4,k) as gs_port_functions */
void gs_port_functions (int k, const int *kind, const int *mode, const gs_real *s,
                        const gs_real *sd, const gs_real *prm, const gs_real *hold, gs_real *gv);

/* what happens at event l (0 the start, -1 what sticks comes to rest): modes change, speeds u jump;
 * a (lda,n), h (ldh,n) with m constraints and k ports. w: 2*n*n + 2*n*(m+k) + (m+k)**2 + 4*n +
 * 9*(m+k). info: 1 singular mass matrix */
int gs_port_reset (int n, int m, int k, int l, const int *kind, int *mode, const gs_real *s,
                   const gs_real *sd, const gs_real *prm, const gs_real *hold, const gs_real *a,
                   int lda, const gs_real *h, int ldh, const gs_real *phit, gs_real *u, gs_real *w);

/* the travel of a stop, prm as gs_port_functions has it, that errors at the end nearer to s are
   beside */
gs_real gs_stop_travel (gs_real s, const gs_real *prm);

/* how near to an end of a stop, prm as gs_port_functions has it, a port at rest is at it */
gs_real gs_stop_nearness (gs_real s, const gs_real *prm);

/* the impulse of gs_port_reset after which the speed of port l is v (l = 0: of none, and ports that
 * stick are at rest as well). info: as gs_solve_kkt */
int gs_port_impulse (int n, int m, int k, int l, gs_real v, const int *kind, int *mode,
                     const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *phit,
                     gs_real *u, gs_real *w);

/* accelerations ud, multipliers lam (m) where the ports with act = 1 are held, by the efforts hold
 * (k), +-1e30 where none can; rows of h (m+k,n) that are not active are overwritten. w: n*n +
 * n*(m+k) + (m+k)**2 + 4*n + 8*(m+k). info: as gs_solve_kkt, dependent ports are no failure */
int gs_port_holding (int n, int m, int k, const gs_real *a, int lda, gs_real *h, int ldh,
                     const gs_real *f, gs_real *g, const int *act, gs_real *ud, gs_real *lam,
                     gs_real *hold, gs_real *w);

/* free: 1 if an effort along row p (from 1) of h can change a speed that the first m rows leave
 * free, else 0 */
void gs_port_is_free (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, int p,
                      gs_real *w, int *free);

/* the nh ports of a scene that may be held, as mode (nh) has them; kind (nh): 1 friction, 2 a stop;
 * ipl (nh): the places of the modes in v, from 1. vm (nv): v with these modes; hold (nh): what
 * holds the ports, 0 where nothing does; row (nh,nu), pos, sd (nh), prm (4,nh) as hld gives them;
 * workspace: ud (nu), lam (nlam, at least 1) */
void gs_ports_held (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *v,
                    const int *mode, const gs_real *cst, int nh, const int *kind, const int *ipl,
                    gs_real *vm, gs_real *ud, gs_real *lam, gs_real *hold, gs_real *row,
                    gs_real *pos, gs_real *sd, gs_real *prm);

/* where friction at rest slides against its push, or a stop is pushed against at rest, the first
 * such mode is changed. Arguments as gs_ports_held */
void gs_release_port (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *v, int *mode,
                      const gs_real *cst, int nh, const int *kind, const int *ipl, gs_real *vm,
                      gs_real *ud, gs_real *lam, gs_real *hold, gs_real *row, gs_real *pos,
                      gs_real *sd, gs_real *prm);

/* 1 if another port is held that moves as port i (from 0) does, else 0 */
int gs_port_held_twice (int nu, int nh, int i, const int *kind, const int *mode,
                        const gs_real *row);

/* modes that contradict the state are changed to what it says. Arguments as gs_ports_held, u (nu):
 * the speeds */
void gs_correct_modes (int nu, int nlam, int nh, const int *kind, int *mode, const gs_real *row,
                       const gs_real *s, const gs_real *sd, const gs_real *prm, const gs_real *u);

/* the state x is moved to where the ports that are held are held; row, pos, sd, prm: workspace as
 * gs_ports_held has them; a, h, phit, u, w: that of gs_impact. info as con and gs_solve_kkt, x
 * moved in part */
int gs_hold_position (const gs_scene *s, gs_real t, gs_real *x, const gs_real *v,
                      const gs_real *cst, int nh, const int *kind, const int *mode, gs_real *row,
                      gs_real *pos, gs_real *sd, gs_real *prm, gs_real *a, gs_real *h,
                      gs_real *phit, gs_real *u, gs_real *w);

/* ... behind a step (method 4: of gs_step_rk4) of a run with the tolerances rtol and atol (nx), v
 * its inputs at t, by no more than the errors of steps; 1 if x was moved, else 0 */
int gs_hold_after_step (const gs_scene *s, int method, gs_real t, gs_real *x, int nx, int *ip,
                        gs_real *rp, const gs_real *cst, gs_real *v, gs_real rtol,
                        const gs_real *atol);

/* what happens at event k of a scene, as l of gs_port_reset; -3: gs_release_port; -4:
 * gs_correct_modes; -5: gs_hold_position. The modes in mode and in v change, the speeds in x jump.
 * w: 3*nu*nu + 3*nu*(nlam+nh) + nh*nu + (nlam+nh)**2 + nv + nq + 6*nu + 14*(nlam+nh) + 10*nh + 4.
 * info: as con and gs_port_reset */
int gs_impact (const gs_scene *s, gs_real t, gs_real *x, gs_real *v, int *mode, int k,
               const gs_real *cst, int nh, const int *kind, const int *ipl, gs_real *w);

/* for gs_impact: the mass matrix a (nu,nu), the Jacobian h (nlam+nh,nu) of the loops with the rows
 * row (nh,nu) of the ports below, phit (nlam), the speeds u; w: nq + 2*nlam */
int gs_impact_matrices (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, int nh,
                        const gs_real *row, gs_real *a, gs_real *h, gs_real *phit, gs_real *u,
                        gs_real *w);

/* derivatives g (nc) of event function k of gs_port_functions: d (6*nh,nc) those of pos, sd, prm of
 * each port, z (n+nh,nc) behind n rows those of hold, read where port k is held */
void gs_port_gradient (int n, int nh, int nc, int k, const int *kind, const int *mode,
                       const gs_real *s, const gs_real *prm, const gs_real *hold, const gs_real *d,
                       const gs_real *z, gs_real *g);

/* gs_loop_jacobian with the rows of nh ports behind those of the constraints; act (nh): 1 held, 0
 * on exit where others hold it already. info: 2 the constraints are dependent, 3 ports are: their
 * efforts are not unique */
int gs_held_jacobian (int nu, int nlam, int nh, int nq, int nz, int *act, const gs_real *lm,
                      const gs_real *lb, const gs_real *lc, gs_real *k, gs_real *z, int *iw);

/* for gs_held_jacobian: the first l rows of m columns of a (n,*) to the leading dimension l (way
 * 1), or back (-1) */
void gs_held_repack (int n, int l, int m, gs_real *a, int way);

/* for gs_held_jacobian: how many ports others hold already; their act becomes 0 */
int gs_held_duplicates (int nu, int nlam, int nh, int *act, gs_real *k);

/* derivatives r (nu,nc) of the speeds after event k, by coordinates, speeds before, parameters,
 * time, where they do not jump (hit -1); else hit, the port that is hit or 0, the jump ud (nu) of
 * the speeds and the impulses p (nu+nlam+nh places) for gs_impact_columns. ua, ma: speeds and modes
 * after; workspace c (n,n), iw (n), n = nu+nlam+nh. info: 2 the rows are dependent */
int gs_impact_gradient (int nq, int nu, int nlam, int nh, int nc, int k, const int *kind,
                        const int *mode, const int *ma, const gs_real *s, const gs_real *sd,
                        const gs_real *prm, const gs_real *x, const gs_real *ua, const gs_real *row,
                        const gs_real *a, const gs_real *h, const gs_real *phit, gs_real *c,
                        gs_real *p, gs_real *ud, int *iw, gs_real *r, int *hit);

/* 1 if port i (from 1) takes part in the impact k of gs_impact_gradient, else 0 */
int gs_impact_takes_part (int i, int k, const int *kind, const int *ma);

/* the matrix c (n,n) of the impact of gs_impact_gradient; a port that does not take part has no
   impulse */
void gs_impact_matrix (int nu, int nlam, int nh, int k, const int *kind, const int *ma,
                       const gs_real *row, const gs_real *a, const gs_real *h, gs_real *c);

/* behind gs_impact_gradient those of an impact, from d (6*nh,nxv+np+1), as of gs_port_gradient, and
 * e (n,nq+np+1), the derivatives of its equations by coordinates, parameters, time; workspace c
 * (n,n), b (n,nq+nu+np+1). info: as gs_impact_gradient */
int gs_impact_columns (int nq, int nu, int nlam, int nxv, int nh, int np, int hit, int k,
                       const int *kind, const int *ma, const gs_real *sd, const gs_real *prm,
                       const gs_real *row, const gs_real *a, const gs_real *h, const gs_real *d,
                       const gs_real *e, gs_real *c, gs_real *b, int *iw, gs_real *r);

#ifdef __cplusplus
}
#endif
#endif
