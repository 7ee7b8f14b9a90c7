/* gs_integrate: a simulation whose whole loop is compiled: integrates
 *       x' = rhs(t, x, v(t,x)),  x(t0) = x0
 * and leaves the states and inputs at the times tout.
 *
 * The ways of the loops, iopt[GS_LOOPS]: 1 x is left to the terms of Baumgarte in rhs; 2 x is moved
 * onto the constraints (prj) at t0 and after every step; 3 coordinate partitioning: before every
 * call of rhs the dependent coordinates and speeds are computed from the independent ones
 * (gs_complete_state), whose errors alone steer the step; 4 null space, 5 zero-eigenvalue theorem:
 * as 2 (that rhs solves in this way is a parameter in cst); 6 Kane with dependent speeds: as 2, and
 * before every call of rhs the dependent speeds are computed from the independent ones. Euler
 * parameters (nq > nu) are normalized by prj, that is, not in the way 1. With iopt[GS_WATCH] = 1
 * positions where the constraints lose rank are watched for, and close to them (method 8) or where
 * constraints are redundant the ways 2, 4, 5 and 6 borrow from the way 3 (needs con, kin and
 * iopt[GS_DRIFT] = 1).
 *
 * Every stop (break, sample, the last output time; method 4: every output time) is met exactly,
 * and so is every event; there the integration starts again. Time is t0 + k*h within each way from
 * stop to stop, never a running sum. With method 8 the output times between are no stops: the
 * states there come from the polynomial of order 7 of the step around them (gs_dense_outputs), for
 * three calls of rhs more in such a step, and are moved onto the constraints as the end of the step
 * is; a step where that cannot be is repeated, shorter.
 * Method 4 cuts the way to each stop into equal steps of at most ropt[0]. A step of method 8
 * after which x cannot be moved onto the constraints, or only by a jump (more than a tenth of the
 * step's own move and 100 times the tolerance: another branch), is repeated with a quarter of its
 * length. Where the constraints lose rank ahead, before they have turned by 1.2 rad
 * (gs_passage_ahead), the position is passed by one step of collocation whose stages keep away from
 * it (gs_step_passage), from an output, a break or a sample in it as well; all output times within
 * it are taken from its polynomial, breaks, samples and the end stop it: the inputs before a break
 * are continued beyond it (gs_inputs_continued). Its relative tolerance is no less than 5e3*eps.
 * Where the position that it finds does not settle, the iteration does not converge or the
 * estimated error is too large, it is tried again with more stages and shorter, from where that
 * length begins. A run of method 8 may start in such a position, by such a step, if its speeds lead
 * out of it (gs_starts_singular, gs_passage_speed_gap). Where that step cannot be had (an error
 * that stays above the tolerance) and close to such a position, and where some constraints are
 * redundant, the stages of a step, which do not lie on the constraints, have accelerations of no
 * use. Where the constraints at t0 are dependent, and where the least pivot has fallen to a
 * twentieth of its largest value, or to a quarter and a step was rejected, the stages are completed
 * by gs_complete_state (there until it has risen to a quarter again). Rounding errors of
 * coordinates, speeds and accelerations that are completed grow with the inverse of the least
 * pivot, its square and its cube: below a quarter of its largest value the relative tolerance is no
 * less than eps**(2/3), 3.7e-11, and a step that ends where rounding errors pass it is repeated
 * with 0.7 of its length, five times at most, so that such a place is stepped over. It ends with
 * GS_TOO_SMALL also where 20000 steps one after the other are a ten thousandth of what they were
 * far from a singular position.
 *
 * In the cases GS_TOO_MANY to GS_STIFF and GS_RATE_NOT_FINITE, and where ask ends the run, the
 * first istat[GS_N_OUTPUTS] columns of xout are valid; where there is another it holds the state at
 * rstat[GS_T_REACHED], and that of vout the inputs. */
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

int
gs_room (const gs_scene *s, int nx, int r)
{
  return 2 * s->nu * (r + 1) + 24 * nx + s->nv * nx + 2 * s->nv + 8 * s->nu + 10 * s->nq
         + 7 * s->nlam + 3 * s->nlam * s->nu + 60 + s->nsw;
}

int
gs_ask (const gs_course *c)
{
  return c->run->ask ? c->run->ask (c->run->asked, c->t) : 0;
}

/* from stop to stop. info as gs_integrate */
static int
stop_to_stop (gs_course *c)
{
  gs_integration *r = c->run;
  for (;;)
    {
      int acted;
      r->rstat[GS_T_REACHED] = c->t;
      int info = gs_integration_stop (c, &acted);
      if (info != 0 || c->it >= r->nt)
        return info;
      if (acted == 1)
        {
          c->fresh = 1;
          c->after = 0;
        }
      info = r->iopt[GS_METHOD] == 4 ? gs_run_rk4 (c) : gs_run_dp853 (c);
      if (info != 0 || c->it >= r->nt)
        return info;

      /* the inputs at the stop, from the left, for the record */
      info = gs_inputs_of_run (c->g.s, c->t, c->side, c->x, r->nx, r->ip, r->rp, r->cst, c->g.v,
                               r->w);
      if (info != 0)
        {
          r->istat[GS_FAILED_INFO] = info;
          r->istat[GS_FAILED] = GS_AT_INPUTS;
          return GS_ROUTINE_FAILED;
        }
    }
}

int
gs_integrate (const gs_scene *s, gs_integration *run)
{
  int info = gs_check_arguments (s, run);
  if (info != 0)
    return info;
  gs_course c;
  gs_integration_init (s, run, &c);
  info = gs_integration_start (&c);
  if (info == 0)
    info = stop_to_stop (&c);

  /* it failed: where it came to */
  const int k = run->istat[GS_N_OUTPUTS];
  if (info != 0 && k < run->nt)
    {
      gs_copy (run->nx, c.x, run->xout + (ptrdiff_t)run->ldx * k);
      gs_copy (s->nv, c.g.v, run->vout + (ptrdiff_t)run->ldv * k);
    }
  return info;
}

static void
divide_workspace (const gs_scene *s, gs_integration *run, gs_course *c)
{
  const int nx = run->nx, nu = s->nu, nv = s->nv, nlam = s->nlam;
  c->x = run->w + 2 * nu * (run->ip[GS_DERIVATIVES] + 1) + 5 * nx + nv * nx + 20;
  c->xn = c->x + nx;
  c->g.v = c->xn + nx;
  c->g.p = c->g.v + gs_most (1, 2 * nv);
  c->f = c->g.p + 24 + 8 * nu + 10 * s->nq + 7 * nlam + 2 * nlam * nu;
  c->fn = c->f + 13 * nx;
  c->hc = c->fn + 3 * nx;
  c->switches = run->w + gs_room (s, nx, run->ip[GS_DERIVATIVES]) - s->nsw;
  if (s->nsw > 0)
    s->swi (run->cst, c->switches);
}

static void
start_memory (gs_course *c)
{
  const gs_integration *run = c->run;
  const gs_real eps = gs_epsilon ();
  c->next = run->ropt[0];
  c->last = 0;
  c->near = GS_R (0.05);
  c->far = 0;
  c->job = c->g.p[GS_WAY];
  c->loose = gs_pow (eps, GS_R (2.0) / 3);
  c->close = GS_R (0.25) * gs_pow (eps / gs_max (run->ropt[1], c->loose), GS_R (1.0) / 3);
  c->a.not_before = -GS_HUGE;
  c->a.counted = -GS_HUGE;
  c->a.share = 1;
  c->a.turn = 0;
  c->a.ns = 8;
  c->a.begin = 0;
  c->fresh = 1;
  c->after = 0;
  c->repeated = 0;
  c->slow = 0;
}

void
gs_integration_init (const gs_scene *s, gs_integration *run, gs_course *c)
{
  memset (c, 0, sizeof *c);
  c->run = run;
  c->g.s = s;
  c->g.nx = run->nx;
  c->g.iopt = run->iopt;
  c->g.ropt = run->ropt;
  c->g.atol = run->atol;
  c->g.ip = run->ip;
  c->g.rp = run->rp;
  c->g.cst = run->cst;
  c->g.w = run->w;
  c->g.istat = run->istat;
  c->g.rstat = run->rstat;
  divide_workspace (s, run, c);
  for (int i = 0; i < 20; i++)
    {
      run->istat[i] = 0;
      run->rstat[i] = 0;
    }
  run->rstat[GS_R_PIVOT] = 1;
  run->last.h = 0;
  run->w[s->nu * (run->ip[GS_DERIVATIVES] + 1) + 1] = 0; /* for gs_follow_motion: a guess */
  gs_copy (run->nx, run->x0, c->x);
  gs_partition_none (s->nq, s->nu, s->nlam, run->iopt, c->g.p);
  c->t = run->t0;
  c->hmax = run->tout[run->nt - 1] - run->t0;
  c->hmax += run->beyond;
  if (run->ropt[2] > 0)
    c->hmax = gs_min (c->hmax, run->ropt[2]);
  run->rstat[GS_H_LEAST] = c->hmax;
  start_memory (c);
}
