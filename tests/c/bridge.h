/* A run by GSSIM in Fortran and in C, of the same scene: what the Fortran calls hands over to the
 * routines of the scene in C, or the scene in C to those of an emitted Fortran scene. */
#ifndef BRIDGE_H
#define BRIDGE_H

#define _POSIX_C_SOURCE 199309L
#include <time.h>

#include "compare.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

typedef void sub (void);

/* the EXTERNAL arguments of GSSIM */
typedef struct
{
  sub *rhs, *prj, *con, *kin, *cmd, *clo, *vin, *out, *ctl, *evt, *rst;
} externals;

enum { MOST_X = 40, MOST_T = 200, MOST_IP = 400, MOST_RP = 20000, MOST_W = 20000 };

/* a run; the C runs it as it stands, the Fortran a copy */
typedef struct
{
  const gs_scene *s;
  const externals *f;
  gs_integration run;
  int iopt[12], ip[MOST_IP];
  gs_real ropt[3], atol[MOST_X], x0[MOST_X], tout[MOST_T], tbrk[20], rp[MOST_RP], cst[1000];
  gs_real xout[MOST_X * MOST_T], vout[MOST_X * MOST_T], w[MOST_W];
  int nip, nrp; /* places of ip and rp that are used */
  int info;
} test;

/* the scene whose routines the Fortran calls */
static const gs_scene *bridged;
static int calls; /* for scenes that count, 0 before each run */

/* ------------------------------------------------------------ what the Fortran calls */

static void
f_rhs (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd,
       int *info)
{
  *info = bridged->rhs (*t, x, v, cst, xd);
}

static void
f_prj (const gs_real *t, gs_real *x, const gs_real *cst, gs_real *res, int *info)
{
  *info = bridged->prj (*t, x, cst, res);
}

static void
f_con (const gs_real *t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
       gs_real *phit, gs_real *hc, const int *ldh, gs_real *gam, int *info)
{
  *info = bridged->con (*t, q, u, cst, phi, phit, hc, *ldh, gam);
}

static void
f_kin (const gs_real *t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  bridged->kin (*t, q, u, cst, qdot);
}

static void
f_cmd (const gs_real *t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v,
       gs_real *xid, int *info)
{
  *info = bridged->cmd (*t, qj, xi, cst, v, xid);
}

static void
f_clo (const gs_real *t, gs_real *qj, const gs_real *cst, gs_real *res, int *info)
{
  *info = bridged->clo (*t, qj, cst, res);
}

static void
f_vin (const gs_real *t, const int *side, const gs_real *x, const int *nx, const int *nv,
       const int *ip, const gs_real *rp, const gs_real *cst, gs_real *v, int *info)
{
  (void)ip, (void)rp, (void)cst;
  *info = bridged->vin (*t, *side, x, *nx, *nv, bridged->data, v);
}

static void
f_out (const gs_real *t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y,
       int *info)
{
  *info = bridged->out (*t, x, v, cst, y);
}

static void
f_ctl (const int *k, const gs_real *t, const gs_real *y, gs_real *xk, const gs_real *cst,
       gs_real *v)
{
  bridged->ctl (*k, *t, y, xk, cst, v);
}

static void
f_evt (const gs_real *t, const gs_real *x, const gs_real *v, const int *mode, const gs_real *cst,
       gs_real *gv)
{
  bridged->evt (*t, x, v, mode, cst, gv);
}

static void
f_rst (const gs_real *t, gs_real *x, gs_real *v, int *mode, const int *k, const gs_real *cst,
       int *info)
{
  *info = bridged->rst (*t, x, v, mode, *k, cst);
}

static const externals through = { (sub *)f_rhs, (sub *)f_prj, (sub *)f_con, (sub *)f_kin,
                            (sub *)f_cmd, (sub *)f_clo, (sub *)f_vin, (sub *)f_out,
                            (sub *)f_ctl, (sub *)f_evt, (sub *)f_rst };

void gssim_ (sub *rhs, sub *prj, sub *con, sub *kin, sub *cmd, sub *clo, sub *vin, sub *out,
             sub *ctl, sub *evt, sub *rst, const int *siz, const gs_real *tim, const gs_real *x0,
             const int *iopt, const gs_real *ropt, int *ip, gs_real *rp, const gs_real *cst,
             gs_real *xout, gs_real *vout, int *istat, gs_real *rstat, gs_real *w, int *info);

static int
run_fortran (const externals *f, const gs_scene *s, gs_integration *r)
{
  const int siz[] = { s->nq, s->nu, r->nx, s->nv, s->nlam, r->nt, r->nb, r->lw };
  gs_real tim[1 + MOST_T + 20], ropt[3 + MOST_X];
  int info = 0;
  bridged = s;
  tim[0] = r->t0;
  for (int i = 0; i < r->nt; i++)
    tim[1 + i] = r->tout[i];
  for (int i = 0; i < r->nb; i++)
    tim[1 + r->nt + i] = r->tbrk[i];
  for (int i = 0; i < 3; i++)
    ropt[i] = r->ropt[i];
  for (int i = 0; i < r->nx; i++)
    ropt[3 + i] = r->atol[i];
  gssim_ (f->rhs, f->prj, f->con, f->kin, f->cmd, f->clo, f->vin, f->out, f->ctl, f->evt, f->rst,
          siz, tim, r->x0, r->iopt, ropt, r->ip, r->rp, r->cst, r->xout, r->vout, r->istat,
          r->rstat, r->w, &info);
  return info;
}

/* ------------------------------------------------------------ the run */

/* the pointers of a->run into a, as after a copy of it */
static void
aim (test *a)
{
  gs_integration *r = &a->run;
  r->x0 = a->x0;
  r->tout = a->tout;
  r->tbrk = a->tbrk;
  r->iopt = a->iopt;
  r->ropt = a->ropt;
  r->atol = a->atol;
  r->ip = a->ip;
  r->rp = a->rp;
  r->cst = a->cst;
  r->xout = a->xout;
  r->vout = a->vout;
  r->w = a->w;
}

/* a run of method 8 until tend with nt outputs, inputs 0, no plans; f: null for `through` */
static inline void
make (test *a, const gs_scene *s, const externals *f, gs_real tend, int nt)
{
  memset (a, 0, sizeof *a);
  aim (a);
  a->s = s;
  a->f = f ? f : &through;
  a->run.nx = a->run.ldx = s->nx;
  a->run.ldv = s->nv > 1 ? s->nv : 1;
  a->run.nt = nt;
  for (int i = 0; i < nt; i++)
    a->tout[i] = tend * (i + 1) / nt;
  a->iopt[GS_METHOD] = 8;
  a->iopt[GS_LOOPS] = 2;
  a->iopt[GS_DRIFT] = s->nlam > 0;
  a->iopt[GS_WATCH] = s->nlam > 0;
  a->ropt[1] = 1e-8;
  for (int i = 0; i < s->nx; i++)
    a->atol[i] = 1e-10;
  a->nip = 40;
  a->nrp = s->nv + 1;
  a->ip[GS_TABLE + 3] = 1; /* a constant v0 */
}

/* the polynomial that begins at ip[place]: np pieces of k coefficients, breaks and coefficients */
static inline void
polynomial (test *a, int place, int nc, int np, int k, const gs_real *brk, const gs_real *coef)
{
  int *ip = a->ip + place;
  ip[0] = np;
  ip[1] = k;
  ip[2] = a->nrp + 1;
  ip[3] = ip[2] + np + 1;
  memcpy (a->rp + a->nrp, brk, (np + 1) * sizeof (gs_real));
  memcpy (a->rp + a->nrp + np + 1, coef, nc * np * k * sizeof (gs_real));
  a->nrp += np + 1 + nc * np * k;
}

/* the plan of the events: kinds and inputs of ne ports, nr records */
static inline void
events (test *a, int ne, const int *kind, const int *input, int nr)
{
  int *ie = a->ip + a->nip;
  a->ip[GS_EVENTS] = a->nip + 1;
  a->ip[GS_EVENTS + 1] = a->nrp + 1;
  ie[0] = ne;
  ie[1] = nr;
  memcpy (ie + 10 + ne, input, ne * sizeof (int));
  memcpy (ie + 10 + 2 * ne, kind, ne * sizeof (int));
  a->nip += 11 + 7 * ne;
  a->nrp += (16 + a->run.nx) * ne + 3 * a->run.nx + nr * (3 + 2 * a->run.nx);
}

/* the plan of the samples: nc devices with periods and delays, held outputs of each and their
 * inputs, memory nxk, np places on the way, ns records */
static inline void
samples (test *a, int nc, const gs_real *period, const gs_real *delay, const int *held,
         const int *anew, const int *input, int nxk, const gs_real *memory, int np, int ns)
{
  const gs_scene *s = a->s;
  int *is = a->ip + a->nip, nh = 0;
  gs_real *rs = a->rp + a->nrp;
  for (int k = 0; k < nc; k++)
    nh += held[k];
  a->ip[GS_SAMPLES] = a->nip + 1;
  a->ip[GS_SAMPLES + 1] = a->nrp + 1;
  a->ip[GS_HELD] = nh;
  a->ip[GS_HELD + 1] = a->nip + 11 + 3 * nc;
  a->ip[GS_HELD_AT] = a->nrp + 1 + 2 * nc;
  memcpy (is, (int[]){ nc, nxk, s->ny, nh, np, ns }, 6 * sizeof (int));
  memcpy (is + 10 + nc, held, nc * sizeof (int));
  memcpy (is + 10 + 2 * nc, anew, nc * sizeof (int));
  memcpy (is + 10 + 3 * nc, input, nh * sizeof (int));
  memcpy (rs, period, nc * sizeof (gs_real));
  memcpy (rs + nc, delay, nc * sizeof (gs_real));
  memcpy (rs + 2 * nc + nh, memory, nxk * sizeof (gs_real));
  a->nip += 11 + 4 * nc + nh + 2 * np;
  a->nrp += 2 * nc + 2 * (nh + nxk) + s->ny + s->nv + 2 * np * (1 + nh) + ns * (1 + nxk + s->nv);
}

/* did anybody write behind the workspace? */
static int
intact (const test *a, int lw)
{
  for (int i = lw < 0 ? 0 : lw; i < MOST_W; i++)
    if (a->w[i] != 1.5)
      return 0;
  return 1;
}

/* columns of xout and vout that are to be alike: those reached, and the one behind them */
static int
columns (const test *a)
{
  int n = a->run.istat[GS_N_OUTPUTS];
  return a->info > 0 && n < a->run.nt ? n + 1 : n;
}

static void
compare_results (const test *c, const test *f)
{
  const int n = columns (c);
  same_int (c->info, f->info);
  for (int i = 0; i < 20; i++)
    same_int (c->run.istat[i], f->run.istat[i]);
  for (int i = 0; i < 20; i++)
    same_numbers (1, c->run.rstat + i, f->run.rstat + i);
  for (int k = 0; k < n; k++)
    {
      same_numbers (c->run.nx, c->xout + c->run.ldx * k, f->xout + c->run.ldx * k);
      same_numbers (c->s->nv, c->vout + c->run.ldv * k, f->vout + c->run.ldv * k);
    }
  for (int i = 0; i < c->nip; i++)
    same_int (c->ip[i], f->ip[i]);
  same_numbers (c->nrp, c->rp, f->rp);
}

/* both runs, compared within begin and finish; info of the C in a->info */
static inline void
compare_silently (test *a)
{
  static test f;
  if (a->nip > MOST_IP || a->nrp > MOST_RP || a->run.nt > MOST_T)
    abort ();
  if (a->run.lw == 0)
    a->run.lw = gs_room (a->s, a->run.nx, a->ip[GS_DERIVATIVES]);
  for (int i = a->run.lw < 0 ? 0 : a->run.lw; i < MOST_W; i++)
    a->w[i] = 1.5;
  f = *a;
  aim (&f);
  calls = 0;
  f.info = run_fortran (f.f, f.s, &f.run);
  calls = 0;
  a->info = gs_integrate (a->s, &a->run);
  if (a->info < 0)
    same_int (a->info, f.info);
  else
    compare_results (a, &f);
  same_int (intact (a, a->run.lw), 1);
}

/* both runs, compared; info of the C in a->info, its results in a. One line `ok what` */
static inline void
compare (test *a, const char *what, int info)
{
  begin (what);
  compare_silently (a);
  if (! QUAD) /* where rounding ends a run in double precision it does not in quad */
    same_int (a->info, info);
  finish ();
  if (getenv ("COUNTS"))
    {
      for (int i = 0; i < 20; i++)
        printf (" %d", a->run.istat[i]);
      printf (" t %g\n", (double)a->run.rstat[GS_T_REACHED]);
    }
}

/* seconds of the run in Fortran, or in C */
static inline gs_real
seconds (const test *a, int in_c)
{
  static test copy;
  struct timespec from, to;
  copy = *a;
  aim (&copy);
  clock_gettime (CLOCK_MONOTONIC, &from);
  if (in_c)
    gs_integrate (copy.s, &copy.run);
  else
    run_fortran (copy.f, copy.s, &copy.run);
  clock_gettime (CLOCK_MONOTONIC, &to);
  return (to.tv_sec - from.tv_sec) + 1e-9 * (to.tv_nsec - from.tv_nsec);
}

#endif
