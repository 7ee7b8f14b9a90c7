/* gsmbp/integrate.h: steps of an integration, its loop, the way through singular positions.
 * Calling rules: scene.h.
 *
 * A program fills gs_integration and calls gs_integrate. */
#ifndef GSMBP_INTEGRATE_H
#define GSMBP_INTEGRATE_H

#include "gsmbp/events.h"
#include "gsmbp/real.h"
#include "gsmbp/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* a step of gs_step_dp853 with its polynomial, see gs_dense_at */
typedef struct
{
  gs_real t, h;       /* where it begins, its length [s] */
  const gs_real *x;   /* nx: the state at t */
  const gs_real *xn;  /* nx: the state at t + h */
  const gs_real *f;   /* (nx,13): as gs_dense_dp853 has left it */
} gs_dense;

/* the arguments of gs_integrate beside the scene; what SIZ and TIM hold has names of its own */
typedef struct
{
  int nx;             /* states, s->nx, or s->nx + 2 with an audit */
  gs_real t0;         /* initial time [s] */
  const gs_real *x0;  /* nx: initial state */
  int nt;             /* output times */
  const gs_real *tout; /* nt: rising, tout[0] >= t0 [s] */
  int nb;             /* breaks */
  const gs_real *tbrk; /* nb: rising, times at which the inputs may jump [s]; gs_integrate stops
                         where the scene switches by itself */
  const int *iopt;    /* 6 + iopt[GS_ON_SPEEDS]: method (4, 8, 9), way of the loops (1 .. 6), 1 to
                         record the drift, most steps (0: any), 1 to watch for singular positions,
                         number of constraints on speeds alone, then their numbers from 1 */
  const gs_real *ropt; /* 3: step [s] (method 8: the first one, or 0), relative tolerance, largest
                         step [s] or 0 */
  const gs_real *atol; /* nx: absolute tolerances, in the units of the states (method 8) */
  int *ip;            /* the inputs and the plans of the samples and of the events, see inputs.h; */
  gs_real *rp;        /* next samples, held outputs, memories and modes go on in them */
  const gs_real *cst; /* from <name>_pre */
  gs_real *xout;      /* (ldx,nt): states at the output times */
  int ldx;            /* >= nx */
  gs_real *vout;      /* (ldv,nt): inputs there, from the left, but at t0; where the scene switches
                         at t the outputs of the same side are those of <name>_out at
                         gs_time_beside (t, -1), functions.h */
  int ldv;            /* >= max(1,nv) */
  int istat[GS_COUNTED];      /* statistics, written */
  gs_real rstat[GS_MEASURED];
  gs_real *w;         /* lw: workspace; first nu entries: the guess of the planned motion */
  int lw;             /* >= gs_room */
  gs_real beyond;     /* method 8: the last step may end so far behind the last output time [s];
                         0: it ends there, as always in the gs_integrate of Fortran */
  gs_dense last;      /* written where it did, else its h is 0; it lies in w */
  int (*ask) (void *asked, gs_real t); /* called before every step, by implicit methods at every
                         rate, too; what is not 0 ends the run with that info; a null pointer: none
                         */
  void *asked;
} gs_integration;

/* one step through a position where the constraints lose rank, and what is remembered from one such
 * step to the next */
typedef struct
{
  gs_real tc, d;     /* the step is from tc - d to tc + d; d = 0: there is none [s] */
  int ns;            /* stages, 8 or 12 */
  gs_real tv[3];     /* the last jump of the inputs and the next one; if tv[2] > 0 inputs are
                        continued beyond them by no more than that time [s] */
  gs_real err;       /* the estimated error beside the tolerance */
  gs_real eit;       /* what the last iteration moved: rounding errors, if not below 0.02 */
  gs_real tmin, smin; /* where the least pivot is least [s], and its value there */
  gs_real not_before; /* no passage is tried before this time [s] */
  gs_real counted;   /* ... none is counted [s] */
  gs_real share;     /* of the length that is tried */
  gs_real turn;      /* in this time the constraints turn by 1.2 rad [s] */
  int begin;         /* 1 in a singular position where the run starts, -1 behind an event, 0 */
} gs_passage;

/* a run on its way; comments name the places of gs_integrate's M and LM */
typedef struct
{
  gs_system g;
  gs_integration *run;
  gs_real t;          /* the time [s], */
  gs_real *x;         /* nx: the state, */
  gs_real *xn;        /* nx: and the next one; the two change places */
  gs_real *f;         /* (nx,13): stages */
  gs_real *fn;        /* 3*nx: rates */
  gs_real *hc;        /* (nlam,nu): a Jacobian of the constraints */
  gs_real hmax;       /* the largest step [s] */
  int it, ib;         /* the next output time and the next break, from 0 */
  gs_real tb;         /* the next stop [s] */
  gs_real until;      /* tb, or the time behind it up to which a step may go [s] */
  int strict;         /* 1: the next one must, for behind it is an event, or something fails */
  gs_real tend;       /* the next break, sample or end of the run [s] */
  gs_real ts;         /* the next sample [s] */
  gs_real *switches;  /* nsw: times at which the scene switches [s] */
  int side;           /* -1 if the next stop is a break or a sample, else 1 */
  gs_real next;       /* M(1) the next step, 0 before the first one [s] */
  gs_real last;       /* M(2) the last one [s] */
  gs_real near;       /* M(3) the share of the least pivot below which gs_complete_state helps */
  gs_real far;        /* M(4) the next step far from singular positions [s] */
  gs_real job;        /* M(5) p[0] as the way of the loops wants it */
  gs_real loose;      /* M(6) the relative tolerance close to singular positions */
  gs_real close;      /* M(7) how small the pivot may be where a step ends */
  int fresh;          /* LM(1) 1 if the rates at x are to be computed, 2 if gs_dense_dp853 left
                         them */
  int after;          /* LM(2) 1 if the last step was one of gs_step_dp853 */
  int repeated;       /* LM(3) steps that were repeated for the pivot, */
  int slow;           /* LM(4) that were very short, one after the other */
  gs_passage a;       /* M(8) .. M(11), LM(5), LM(6) */
} gs_course;

/* the whole run */
int gs_integrate (const gs_scene *s, gs_integration *run);

/* the least lw of a run with nx states; r = ip[3], the highest derivative of a planned motion */
int gs_room (const gs_scene *s, int nx, int r);

/* are the arguments within their ranges? info: as gs_integrate */
int gs_check_arguments (const gs_scene *s, const gs_integration *run);

/* the next time at which inputs may jump or the scene switches, above 1e300: none; the last one */
gs_real gs_next_break (const gs_course *c);
gs_real gs_last_break (const gs_course *c);

/* before a step: what run->ask returns, or 0 */
int gs_ask (const gs_course *c);

/* workspace, state, partition and memory of a run; statistics are 0 */
void gs_integration_init (const gs_scene *s, gs_integration *run, gs_course *c);

/* the start: onto the constraints, what is due, a singular position. info as gs_integrate: 0 or
   3 */
int gs_integration_start (gs_course *c);

/* at a stop: output, samples and events that are due, the next stop; it = nt: the end. acted: 1 if
 * the integration starts again here. info as gs_integrate: 0 or 3 */
int gs_integration_stop (gs_course *c, int *acted);

/* from one stop to the next by the classical method of Runge and Kutta. info as gs_integrate: 0, 1,
 * 3, 4 */
int gs_run_rk4 (gs_course *c);

/* gs_run_rk4 in parts: n equal steps of the length h, at most hr, from ta to the next stop, of
 * which the k-th (from 1) is next */
typedef struct
{
  gs_real ta, hr, h; /* [s] */
  int k, n;
} gs_equal_steps;

/* from w->ta by w->hr; before the next step e: c->t is where it begins; after gs_step_rk4 made it:
 * up to an event in it, onto the constraints, and on to the next one; k > n: the stop is reached,
 * c->t is to be set. info as gs_integrate */
void gs_cut_way (gs_course *c, gs_equal_steps *w);
gs_step gs_begin_equal (gs_course *c, const gs_equal_steps *w);
int gs_end_equal (gs_course *c, gs_step *e, gs_equal_steps *w);

/* from one stop to the next by the method of Dormand and Prince, or through a singular position,
 * which may end before or behind it. info as gs_integrate: 0, 1, 2, 3, 5, 8 */
int gs_run_dp853 (gs_course *c);

/* before a step of gs_step_dp853: the rates at x, stability, a first step. info as gs_integrate: 0,
   3, 5, 8 */
int gs_dp853_before (gs_course *c);

/* one trial step of gs_step_dp853 of the length htry or less, onto the constraints and up to an
 * event in it, the outputs within it, and the length of the next one; taken: 1 if it was good. info
 * as gs_integrate: 0, 1, 2, 3 */
int gs_dp853_trial (gs_course *c, gs_real htry, int *taken);

/* gs_dp853_trial in two parts, between which whoever calls them makes the step e of gs_step_dp853:
 * before it, its length and its end; after it, with its err and what failed in it, or 0. info as
 * gs_integrate */
int gs_begin_trial (gs_course *c, gs_real htry, gs_step *e);
int gs_end_trial (gs_course *c, gs_step *e, gs_real err, int failed, int *taken);

/* before a trial step of the length h: the partition that its stages need. info as gs_integrate: 0,
   3 */
int gs_dp853_partition (gs_course *c, gs_real h);

/* after a good step to tn: xn onto the constraints, but by no jump. info as gs_check_constraints */
int gs_dp853_after (gs_course *c, gs_real tn);

/* how far a coordinate, jump[0], and a speed, jump[1], may be moved after the step from x to xn */
void gs_largest_move (int nq, int nu, const gs_real *x, const gs_real *xn, gs_real rtol,
                      const gs_real *atol, gs_real *jump);

/* one step of the classical Runge-Kutta method from x at t to xn at tn, which is t + h as the
 * caller rounds it; side < 0: a jump of the inputs may lie there. w: 3*nx. info as gs_rates_at, as
 * below */
int gs_step_rk4 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h, gs_real *x,
                 gs_real *xn, gs_real *w);

/* one trial step of Dormand and Prince of order 8, as gs_step_rk4; err: the error beside the
 * tolerance, good if <= 1. w (nx,13): column 0 the rates at x, on entry; on exit the twelve stages,
 * and the state of the last one */
int gs_step_dp853 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h, const gs_real *x,
                   gs_real *xn, gs_real *err, gs_real *w);

/* z := the sum of n products a[k]*f[k], n 1 to 9 or 12, of nx numbers each; z overlaps none */
void gs_sum (int nx, int n, const gs_real *a, const gs_real *const *f, gs_real *z);

/* behind a step of gs_step_dp853, arguments as there, its polynomial of order 7: f (nx,13): on
 * entry its stages; on exit column 1 holds the rates at tn, 5 to 8 the coefficients that
 * gs_dense_at takes; columns 0, 11 and 12 stay. xn: as it was moved onto the constraints; z (nx):
 * workspace. info as gs_rates_at */
int gs_dense_dp853 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h,
                    const gs_real *x, gs_real *xn, gs_real *f, gs_real *z);

/* the coefficients of that polynomial, three stages more: on entry column 1 of f holds the rates at
 * the end; on exit columns to ... to + 3 (1 or 5) the coefficients c that gs_dense_from_rates
 * takes; 2 to 4 are changed, the others stay */
int gs_dense_coefficients (const gs_system *g, gs_real t, gs_real h, const gs_real *x, gs_real *f,
                           int to, gs_real *z);

/* the state z at the fraction b of the step from x to xn, on that polynomial */
void gs_dense_at (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xn,
                  const gs_real *f, gs_real *z);

/* ... from the rates xd, xdn at the ends and the coefficients c of gs_dense_coefficients; xn itself
   at the end */
void gs_dense_from_rates (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xd,
                          const gs_real *xn, const gs_real *xdn, const gs_real *c, gs_real *z);

/* the error of that polynomial beside three tolerances, at most 1 where it is as accurate as the
 * step: its state at the place of the last stage of gs_dense_dp853 less z (nx), as gs_dense_dp853
 * left it. w (nx): workspace */
gs_real gs_dense_error (const gs_system *g, gs_real h, const gs_real *x, const gs_real *xn,
                        const gs_real *f, const gs_real *z, gs_real *w);

/* ... from the state w of the polynomial there */
gs_real gs_dense_error_there (const gs_system *g, const gs_real *x, const gs_real *xn,
                              const gs_real *z, const gs_real *w);

/* the outputs within a step of gs_step_dp853 of the length h to tn, from that polynomial, moved
 * onto the constraints; off: gs_dense_error, on entry 0 and more where gs_first_event has told it
 * (rows_off) and left the polynomial. info as gs_check_constraints, or 90 if off is above 1 and the
 * scene has no events; if not 0, none is written */
int gs_dense_outputs (gs_course *c, gs_real tn, int side, gs_real h, gs_real *off);

/* the coefficients of gs_step_dp853 that are not zero, but c[11], which is 1: a (12,12), b (12), c
   (12) */
void gs_dp853_table (gs_real *a, gs_real *b, gs_real *c);

/* one step of gs_step_dp853 backwards, t, tn, side, h, x as there: from the derivatives lx (nx) of
 * a goal by the state at tn to those by x, and, added up, those by parameters, pb (np). k (nx,12):
 * the right-hand sides of its stages; ip, rp, wi: as gs_inputs_of_run, of whose inputs those are
 * taken that depend on time alone; v (nv): kept where it is constant. w: 15*nx + nv + np. info:
 * that of gs_inputs_of_run or of adj */
int gs_step_back_dp853 (const gs_scene *s, gs_real t, gs_real tn, int side, gs_real h,
                        const gs_real *x, const gs_real *k, int np, const int *ip,
                        const gs_real *rp, const gs_real *cst, gs_real *v, gs_real *lx, gs_real *pb,
                        gs_real *w, gs_real *wi);

/* the rates xd of the states and, behind them, of their derivatives by parameters, nc columns, as x
 * (nx,1+nc) has them. col (nc): which column of the np parameters of rhp, from 1; 0: a derivative
 * by a start value. ntop: the number of coordinates if the speeds are their rates, else 0. w:
 * nx*(nx+np+nv+1). info: that of rhp, but 9 where the constraints have lost rank */
int gs_rates_with_columns (const gs_scene *s, gs_real t, int ntop, int np, int nc, const int *col,
                           const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *w,
                           gs_real *xd);

/* for gs_rates_with_columns: r = p + a*y, of four columns and of one; a (n,n), y and r (n,4) or
 * (n); the first ntop rows of a*y are those that lie ntop behind in y */
void gs_columns_times_four (int ntop, int n, const gs_real *a, const gs_real *p1, const gs_real *p2,
                            const gs_real *p3, const gs_real *p4, const gs_real *y, gs_real *r);
void gs_columns_times_one (int ntop, int n, const gs_real *a, const gs_real *p, const gs_real *y,
                           gs_real *r);

/* a first step h <= hmax for gs_step_dp853 [s]; w as there */
int gs_first_step (const gs_system *g, gs_real t, gs_real hmax, const gs_real *x, gs_real *w,
                   gs_real *h);

/* the right-hand side xd under its inputs; states of x that the partition completes are completed
 * first. info: what failed, as istat[GS_FAILED_INFO] and istat[GS_FAILED] */
int gs_rates_at (const gs_system *g, gs_real t, int side, gs_real *x, gs_real *xd);

/* gs_rates_at with the inputs as they go on from the time tv to tf */
int gs_rates_from (const gs_system *g, gs_real t, gs_real tv, gs_real tf, int side, gs_real *x,
                   gs_real *xd);

/* the inputs at tf as those on the other side of tv go on there, by a polynomial */
int gs_inputs_continued (const gs_system *g, gs_real tv, gs_real tf, const gs_real *x);

/* watches for steps h that are bound by the stability of an explicit method: istat[13 .. 17],
 * rstat[17 .. 19]. w (nx,13): as gs_step_dp853 left it, but column 0 the rates at x; columns 1 to 4
 * are workspace */
void gs_watch_stiffness (const gs_system *g, gs_real t, gs_real h, const gs_real *x, gs_real *w);

/* the largest eigenvalue rho of the right-hand side by modulus [1/s], 0 where that failed, or where
 * none is above 1/h; k: the state (from 1) that moves most. w: 4*nx */
void gs_largest_eigenvalue (const gs_system *g, gs_real t, const gs_real *x, gs_real h, gs_real *w,
                            gs_real *rho, int *k);

/* the passage of a position where the constraints lose rank, if one is ahead; h: the next step of
 * gs_step_dp853; hlim: its longest one where there is no passage yet [s]; taken: 1 if it was
 * passed. info as gs_integrate: 0, 3 */
int gs_take_passage (gs_course *c, gs_real h, gs_real *hlim, int *taken);

/* looks ahead for such a position (gs_passage_ahead), where one may be near */
void gs_passage_watch (gs_course *c, gs_real h, gs_real *hlim);

/* one trial step of gs_step_passage, with the partition that holds at its far end. info as
   gs_step_passage */
int gs_passage_trial (gs_course *c);

/* the partition that holds at the end of a step of gs_step_passage that lies farther from x */
void gs_passage_far_end (gs_course *c);

/* a good step of gs_step_passage is taken, to its end, the next stop or an event; the outputs
 * within it. again: 1 if a shorter one is to be tried. info as gs_integrate: 0, 3 */
int gs_passage_end (gs_course *c, int *taken, int *again);

/* xn at tn on the path of gs_step_passage, or at the first event before it: then tn is its time and
 * stops, which says that tn is a stop, 0. info: what failed */
int gs_passage_event (gs_course *c, gs_real *tn, int *stops, int *event);

/* gs_check_constraints for xn at the end of a passage; close to the singular position nothing is
   moved */
int gs_passage_onto (gs_course *c, gs_real tn);

/* the outputs before tn, from the polynomial of gs_step_passage. info: that of the inputs */
int gs_passage_outputs (gs_course *c, gs_real tn);

/* one implicit step through a position where the constraints lose rank: a->err, eit, tmin, smin.
 * f (nx,13): column 0 the rates at x on entry, the others are the stages on exit; xn, fn (nx):
 * workspace. info: 1 the position lies too far from a->tc, 2 no convergence, 3 a stage failed */
int gs_step_passage (const gs_system *g, gs_real t, const gs_real *x, gs_passage *a, gs_real *f,
                     gs_real *xn, gs_real *fn);

/* the stages of gs_step_passage, at c, for the first time, from c0 outwards: order (ns), from 1 */
int gs_passage_stages (const gs_system *g, const gs_real *x, const gs_passage *a, gs_real c0,
                       const gs_real *c, gs_real *f, gs_real *xn, int *order);

/* the right-hand side of a stage of gs_step_passage; tv as in gs_passage */
int gs_passage_rates (const gs_system *g, gs_real t, const gs_real *tv, gs_real *x, gs_real *xd);

/* the size err of d beside the tolerance, tol >= rtol for the relative one */
void gs_passage_error (const gs_system *g, const gs_real *x, const gs_real *d, gs_real tol,
                       gs_real *err);

/* xt = x + d*f(:,1:ns)*b, the first n states at the place of b (gs_gauss_weights) in a step of
 * gs_step_passage; f (ldf,13) */
void gs_passage_path (int n, int ns, int ldf, const gs_real *x, gs_real d, const gs_real *b,
                      const gs_real *f, gs_real *xt);

/* the least pivot smin of the constraints and its place cs between ca and cb, on the path of
 * gs_step_passage from x at t; xt (nx): workspace */
void gs_passage_least_pivot (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d,
                             gs_real ca, gs_real cb, int ns, const gs_real *f, gs_real *xt,
                             gs_real *cs, gs_real *smin);

/* the least pivot sp at tc + ct*d on that path, 1e300 where con fails */
void gs_passage_pivot (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d,
                       gs_real ct, int ns, const gs_real *f, gs_real *xt, gs_real *sp);

/* looks for a position where the constraints lose rank: a->tc, d, turn; h: on exit no more than
 * what turns them by about 1 rad. f as gs_step_passage; xt (nx), hc (nlam,nu): workspace */
void gs_passage_ahead (const gs_system *g, gs_real t, const gs_real *x, gs_real *h, gs_real rest,
                       gs_passage *a, gs_real *f, gs_real *xt, gs_real *hc);

/* the rates f of gs_step_passage for a path with linear rates of the coordinates; xt (nq):
   workspace */
void gs_passage_linear (const gs_system *g, gs_real t, const gs_real *x, gs_real tc, gs_real d,
                        int ns, gs_real *f, gs_real *xt);

/* does a run start in or very close to a singular position, no further ahead than hmax? state: 0
 * no, 1 in one that the speeds lead out of, 2 at rest in one, -1 the constraints hardly turn. f:
 * the right-hand side; xt, xw (nq), hc (nlam,nu), siz (nlam): workspace */
void gs_starts_singular (const gs_scene *s, gs_real t, const gs_real *x, gs_real hmax,
                         const gs_real *cst, const gs_real *f, gs_real *xt, gs_real *xw,
                         gs_real *hc, gs_real *siz, gs_real *p, int *state);

/* for gs_starts_singular: the time h until the constraints have turned by 0.3 rad, 0 if they hardly
 * turn; rest: 1 if the speeds hardly move the scene until then */
void gs_singular_turn_time (const gs_scene *s, gs_real t, const gs_real *x, gs_real hmax,
                            const gs_real *cst, const gs_real *f, gs_real *xt, gs_real *xw,
                            gs_real *hc, gs_real *siz, gs_real *p, gs_real *h, int *rest);

/* for gs_starts_singular: the pivots of the constraints h behind t, in p; their rank, -1 where con
   fails */
void gs_singular_pivots (const gs_scene *s, gs_real t, const gs_real *x, gs_real h,
                         const gs_real *cst, const gs_real *f, gs_real *xt, gs_real *xw,
                         gs_real *siz, gs_real *p, int *rank);

/* how far the speeds of x differ from those of the step of gs_step_passage, beside the largest:
 * gap; xw (nq): workspace */
void gs_passage_speed_gap (const gs_system *g, gs_real t, const gs_real *x, const gs_passage *a,
                           const gs_real *f, gs_real *xw, gs_real *gap);

#ifdef __cplusplus
}
#endif
#endif
