/* run.c: runs and gs_follow_motion for the module, their arguments one by one. */
#include <string.h>
#include <time.h>

#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/limits.h"
#include "gsmbp/plan.h"
#include "gsmbp/refusals.h"
#include "host/implicit/implicit.h"

/* asked some twenty times a second of processor time: 0, or the info by which the run is to end */
typedef int gs_question (void);

typedef struct
{
  gs_question *question;
  clock_t next;
  int calls;
} gs_asking;

/* ask of gs_integration */
static int
ask (void *data, double t)
{
  gs_asking *a = data;
  (void)t;
  if (++a->calls % 8 != 0 || clock () < a->next)
    return 0;
  a->next = clock () + CLOCKS_PER_SEC / 20;
  return a->question ();
}

/* by gs_integrate, or by an implicit method: from the beginning, or where gs_integrate finds steps
 * bound by stability */
static int
integrate (const gs_scene *s, gs_integration *r, gs_implicit_method *by, gs_implicit *options)
{
  int info = GS_STIFF;
  options->resume = r->iopt[GS_METHOD] != 0;
  if (options->resume)
    info = gs_integrate (s, r);
  return info == GS_STIFF && by ? by (s, r, options) : info;
}

/* a run; rhs, vin: in the place of the scene's, or null pointers; question may be one, too, and by,
 * an implicit method; choice: its largest order, 1 for loops in index 2, how many states the inputs
 * follow, which ones; said (size): what it says where it fails. info as gs_integrate */
int
gs_loop_run (const gs_scene *s, gs_rhs *rhs, gs_vin *vin, gs_question *question, int nx, double t0,
             const double *x0, int nt, const double *tout, int nb, const double *tbrk,
             const int *iopt, const double *ropt, const double *atol, int *ip, double *rp,
             const double *cst, double *xout, double *vout, int *istat, double *rstat, double *w,
             int lw, gs_implicit_method *by, const int *choice, char *said, int size)
{
  gs_implicit o = { .order = choice[0], .index2 = choice[1], .followed = choice[2],
                    .follows = choice + 3, .text = said, .length = size };
  gs_scene own = *s;
  gs_integration r = { .nx = nx, .t0 = t0, .x0 = x0, .nt = nt, .tout = tout, .nb = nb, .tbrk = tbrk,
               .iopt = iopt, .ropt = ropt, .atol = atol, .ip = ip, .rp = rp, .cst = cst,
               .xout = xout, .ldx = nx, .vout = vout, .ldv = s->nv > 1 ? s->nv : 1, .w = w,
               .lw = lw };
  if (rhs)
    own.rhs = rhs;
  own.vin = vin;
  gs_asking asking = { .question = question, .next = clock () };
  if (question)
    {
      r.ask = ask;
      r.asked = &asking;
    }
  const int info = integrate (&own, &r, by, &o);
  memcpy (istat, r.istat, sizeof r.istat);
  memcpy (rstat, r.rstat, sizeof r.rstat);
  return info;
}

#define NAME(name) #name "\n"
#define ONE(constant, name) #name "\n"
#define TWO(name, value) #name "\t" #value "\n"
#define TEXT(name, text) #name "\t" text "\n"
#define THREE(name, kind, value) #name "\t" #kind "\t" #value "\n"

/* the tables that hosts share, a line for each row, tabs between its parts */
const char *
gs_loop_table (int which)
{
  static const char *const tables[] = {
    GS_COUNTS (ONE), GS_VALUES (ONE), GS_OPTIONS (THREE), GS_KINDS (TEXT), GS_METHODS (TWO),
    GS_LOOP_METHODS (TWO), GS_LIMITS (TWO), GS_REFUSALS (TEXT), GS_VERDICTS (NAME)
  };
  return tables[which];
}

/* of the structure that Python fills as well */
int
gs_loop_plan_size (void)
{
  return (int)sizeof (gs_plan);
}

/* where in rp the records of the sampled devices begin; sizes: how many there are room for, how
 * many instants there were, where in rp the memory begins */
int
gs_loop_samples (const gs_scene *s, int *ip, double *rp, int *sizes)
{
  gs_samples a = gs_planned_samples (s, ip, rp);
  sizes[0] = a.ns;
  sizes[1] = *a.count;
  sizes[2] = (int)(a.memory - rp);
  return (int)(a.record - rp);
}

/* the same of the events, then the numbers of the one that ended the run and of the last one */
int
gs_loop_events (int nx, int *ip, double *rp, int *sizes)
{
  gs_events a = gs_planned_events (nx, ip, rp);
  sizes[0] = a.nr;
  sizes[1] = *a.count;
  sizes[2] = *a.ended;
  sizes[3] = *a.newest;
  return (int)(a.record - rp);
}

int
gs_loop_room (const gs_scene *s, int nx, int r)
{
  return gs_room (s, nx, r);
}

/* the planned motion qj (nu,0:r) of a closed chain at t, see gs_follow_motion */
int
gs_loop_follow (const gs_scene *s, double t, int side, int r, int na, const int *ipl, int np,
                int k, const double *brk, const double *coef, const double *cst, double *qj,
                double *w)
{
  return gs_follow_motion (s, t, side, r, na, ipl, np, k, brk, coef, cst, qj, w);
}
