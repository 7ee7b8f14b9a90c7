/* gsmbp/inputs.h: what the inputs of a scene are during a run. Calling rules: scene.h.
 *
 * ip and rp are the plan of a run, laid out as IP and RP of gs_inputs_of_run. Numbers of places,
 * coordinates, inputs and devices in it are counted from 1. */
#ifndef GSMBP_INPUTS_H
#define GSMBP_INPUTS_H

#include "gsmbp/real.h"
#include "gsmbp/scene.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* the first entries of ip. A polynomial has four: pieces, order, and where in rp its breaks and its
 * coefficients begin, see gs_polynomials_at */
enum
{
  GS_V0 = 0,         /* 0 constant, 1 a table, 2 planned motion through cmd, 3 vin of the user */
  GS_FEEDBACK,       /* 1 for state feedback, else 0 */
  GS_CLOSED,         /* 1 if clo completes the planned motion */
  GS_DERIVATIVES,    /* r, the highest derivative of the motion that cmd takes */
  GS_PLANNED,        /* the number of planned coordinates */
  GS_TABLE,          /* polynomial v0 (a constant is at its coefficients) */
  GS_MOTION = 9,     /* polynomial of the planned motion */
  GS_REFERENCE = 13, /* polynomial of the reference state */
  GS_GAIN = 17,      /* polynomial of the gain, (nv,nx) */
  GS_INTERNAL = 21,  /* where in x the states of the devices begin, 0: none */
  GS_HELD,           /* how many inputs are held outputs of sampled devices; where their numbers */
  GS_HELD_AT = 24,   /* begin in ip, and here where their values begin in rp */
  GS_SAMPLES,        /* where the plan of the samples begins in ip, 0: none; then where in rp */
  GS_EVENTS = 27,    /* where the plan of the events begins in ip, 0: none; then where in rp */
  GS_LIMITS = 29,    /* where nv lower and nv upper limits begin in rp, 0: none */
  GS_NUMBERS         /* the numbers of the planned coordinates */
};

/* the plan of the samples, see gs_sample */
typedef struct
{
  int nc, nxk, ny, nh; /* devices, their memory, outputs of the scene, held outputs */
  int np, ns;          /* places for outputs on their way, for records */
  int *count;          /* instants so far */
  int *tabled;         /* 1: what is held before the first samples is what the table v0 has there */
  int *next;           /* nc: the number of the next sample */
  int *held;           /* nc: how many held outputs it has */
  int *anew;           /* nc: 1 if y is to be computed anew for it after others acted */
  int *input;          /* nh: the numbers of the inputs, device by device */
  int *sender;         /* np: the number of the device, 0 where the place is free */
  gs_real *period;     /* nc [s] */
  gs_real *delay;      /* nc [s] */
  gs_real *value;      /* nh: held outputs */
  gs_real *memory;     /* nxk */
  gs_real *y;          /* ny, workspace */
  gs_real *v;          /* nv, workspace */
  gs_real *when;       /* np: when outputs arrive [s] */
  gs_real *sent;       /* (nh,np): these outputs */
  gs_real *record;     /* (1+nxk+nv,ns): time, memory, inputs */
  int *kept;           /* 1+nc+np, workspace: count, next and sender */
  gs_real *keeps;      /* nh+nxk + np*(1+nh), workspace: value and memory, when and sent */
} gs_samples;

/* the plan of which is and rs are the arrays */
static inline gs_samples
gs_samples_of (int nv, int *is, gs_real *rs)
{
  gs_samples a;
  a.nc = is[0];
  a.nxk = is[1];
  a.ny = is[2];
  a.nh = is[3];
  a.np = is[4];
  a.ns = is[5];
  a.count = is + 6;
  a.tabled = is + 7;
  a.next = is + 10;
  a.held = a.next + a.nc;
  a.anew = a.held + a.nc;
  a.input = a.anew + a.nc;
  a.sender = a.input + a.nh;
  a.period = rs;
  a.delay = a.period + a.nc;
  a.value = a.delay + a.nc;
  a.memory = a.value + a.nh;
  a.y = a.memory + a.nxk;
  a.v = a.y + a.ny;
  a.when = a.v + nv;
  a.sent = a.when + a.np;
  a.record = a.sent + a.np * a.nh;
  a.kept = a.sender + a.np;
  a.keeps = a.record + (ptrdiff_t)a.ns * (1 + a.nxk + nv);
  return a;
}

/* the inputs v (nv) at t; side < 0: from the left at a jump. w: 2*nu*(r+1) + 5*nx + nv*nx + 20, its
 * first nu*(r+1) entries hold the planned motion. info: what cmd, clo or vin returned */
int gs_inputs_of_run (const gs_scene *s, gs_real t, int side, const gs_real *x, int nx,
                      const int *ip, const gs_real *rp, const gs_real *cst, gs_real *v, gs_real *w);

/* do coordinates with rates, qj (nu,2), follow from those in old (nu,2), dt before: each moves by
 * the mean of its rates at both ends, but for a tenth of the larger one and 1e-6? */
int gs_motion_follows (int nu, gs_real dt, const gs_real *old, const gs_real *qj);

/* planned motion qj (nu,0:r) of a closed chain at t, of which na coordinates, numbers ipl, are
 * planned: the others by clo, on one branch. w: time of qj, 1 or 0 (qj is a guess), na*(r+1) + 2*nu
 * more. info: -i from gs_polynomials_at, what clo returned, 2 if the chain cannot follow */
int gs_follow_motion (const gs_scene *s, gs_real t, int side, int r, int na, const int *ipl, int np,
                      int k, const gs_real *brk, const gs_real *coef, const gs_real *cst,
                      gs_real *qj, gs_real *w);

/* the planned coordinates and their derivatives into their rows of qj; f (na,0:r) is workspace.
 * info: -i from gs_polynomials_at */
int gs_planned_rows (gs_real t, int side, int nu, int r, int na, const int *ipl, int np, int k,
                     const gs_real *brk, const gs_real *coef, gs_real *f, gs_real *qj);

/* coordinates and speeds w (2*nu) back into qj */
void gs_motion_back (int nu, const gs_real *w, gs_real *qj);

/* nc polynomials of np pieces of k coefficients, coef (nc,np,k), the highest power first, and nd
 * derivatives at t: f (ldf,0:nd). info: 1 outside, the end value is held; -i argument i */
int gs_polynomials_at (int nc, int np, int k, const gs_real *brk, const gs_real *coef, gs_real t,
                       int side, int nd, gs_real *f, int ldf);

/* sampled devices at one instant: held outputs of v are set. info: that of out, or -1: no place for
 * an output on its way */
int gs_sample (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *v,
               int *is, gs_real *rs);

/* what an instant changes in the plan of the samples is kept (back = 0), or as it was kept */
void gs_sample_keep (int back, int nv, int *is, gs_real *rs);

/* sampled devices at a stop of a run; ts: when one acts or gives out next [s]; acted: 1 if
 * something was due. info: what failed, as istat[GS_FAILED_INFO] and istat[GS_FAILED] */
int gs_samples_due (const gs_scene *s, gs_real t, const gs_real *x, int nx, int *ip, gs_real *rp,
                    const gs_real *cst, gs_real *v, gs_real *w, int *istat, gs_real *ts,
                    int *acted);

/* the next time at which a sampled device acts or gives out [s] */
gs_real gs_next_sample (int nv, int *is, gs_real *rs);

#ifdef __cplusplus
}
#endif
#endif
