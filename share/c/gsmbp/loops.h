/* gsmbp/loops.h: states of closed chains between steps. Calling rules: scene.h.
 *
 * p is the partition of a state into independent and dependent speeds, partition.h. */
#ifndef GSMBP_LOOPS_H
#define GSMBP_LOOPS_H

#include "gsmbp/real.h"
#include "gsmbp/partition.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* after a step: x onto the constraints as iopt[GS_LOOPS] says; drift, rank and the choice of
 * independent speeds are looked after. jump: how far a coordinate [0] and a speed [1] may be
 * moved, 0 for any way, and how far the least pivot may fall beside its largest value [2].
 * info: what failed; 3 constraints not fulfilled, or only by a jump; 4 the least pivot fell */
int gschk (const gs_scene *s, gs_real t, gs_real *x, const int *iopt, const gs_real *jump,
           const gs_real *cst, gs_real *p, int *istat, gs_real *rstat);

/* the first part of gschk alone: x is moved onto the constraints, by no more than jump[0] and
 * jump[1] where jump[0] > 0. info as gschk: not 4 */
int gsmov (const gs_scene *s, gs_real t, gs_real *x, const int *iopt, const gs_real *jump,
           const gs_real *cst, gs_real *p, int *istat, gs_real *rstat);

/* completes x: phi(q,t) = 0 and HC*u + phit = 0 by the dependent coordinates and speeds, which are
 * guesses on entry. info: 3 no position found, or what con returned */
int gsprt (const gs_scene *s, gs_real t, gs_real *x, const gs_real *cst, gs_real *p);

/* the partition p before anything is known of the constraints */
void gspst (int nq, int nu, int nlam, const int *iopt, gs_real *p);

/* for gsprt: y (m,r) = diag(rows)*hc(:,order) by gsqrp */
void gspfa (int m, int r, const gs_real *hc, const gs_real *order, const gs_real *rows, gs_real *y,
            gs_real *piv, gs_real *beta, gs_real *siz, int *rank);

/* for gsprt: du(order(1..r)) solves y*du = b by least squares, the other entries of du (nu) are 0;
 * b is destroyed */
void gspls (int m, int r, int rank, const gs_real *y, const gs_real *piv, const gs_real *beta,
            gs_real *b, int nu, const gs_real *order, gs_real *du);

/* a first or new choice of the dependent speeds at x. info: what con returned */
int gspnw (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p);

/* the same within a run: istat[GS_FAILED_INFO], istat[GS_FAILED] tell if con fails */
int gspcn (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
           int *istat);

/* rank of the constraints, to 1e-7, and the choice of the dependent speeds, from the Jacobian that
 * p holds. least: the least pivot beside the largest; change: 1 if another set was chosen */
void gsprc (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
            int *rank, gs_real *least, int *change);

/* which coordinates and speeds count in the step control; order is that of the displacements, w
 * (nu + nq) is workspace */
void gspwt (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
            const gs_real *order, gs_real *w);

/* the volume that the r columns of y (m,r) span, divided by the product of siz; y is destroyed */
void gsvol (int m, int r, gs_real *y, const gs_real *siz, gs_real *ratio);

/* pivots of the Jacobian hc (nlam,nu), rows divided by the largest length size they had so far;
 * y, piv, beta, d and rank are what gsqrc leaves */
void gslpv (int nu, int nlam, const gs_real *hc, gs_real *size, gs_real *y, gs_real *piv,
            gs_real *beta, gs_real *d, int *rank, gs_real *least);

/* follows the least pivot from step to step: the minimum smin that it passed and when, tmin;
 * smin = -1: none */
void gspas (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *p,
            gs_real *tmin, gs_real *smin);

/* job 0: hc (nlam,nu) becomes the Jacobian that p holds; 1: turn becomes how far that differs from
 * hc, beside the length of its row, the largest of the rows */
void gspch (int nq, int nu, int nlam, const gs_real *p, gs_real *hc, int job, gs_real *turn);

/* x onto phi = 0 and HC*u + phit = 0 by the shortest way in the metric of the mass matrix; Euler
 * parameters, ns sets at iset (4,ns), numbers from 1, get the norm 1. quasi: 1 where the speeds are
 * not the rates of the coordinates, else 0. res: the largest |phi| and error of a norm before. w:
 * 2*nu*nu + 2*nu*nlam + nlam*nlam + 5*nu + 10*nlam + 2*nq. info: < 0 as con; 1 singular mass
 * matrix; 3 no position found */
int gsprj (const gs_scene *s, gs_real t, gs_real *x, int quasi, int ns, const int *iset,
           const gs_real *cst, gs_real *res, gs_real *w);

/* for gsprj: the position q onto phi = 0; h (nlam,nu) and pt (nlam) are those of con there. u: the
 * speeds; workspace: a (nu,nu), p, g, lam (nlam), f, dx (nu), w as gskkt, dq (nq) */
int gspjq (const gs_scene *s, gs_real t, gs_real *q, const gs_real *u, int quasi, int ns,
           const int *iset, const gs_real *cst, gs_real *res, gs_real *a, gs_real *h, gs_real *p,
           gs_real *pt, gs_real *g, gs_real *f, gs_real *dx, gs_real *lam, gs_real *w, gs_real *dq);

/* for gsprj: the step dx that moves the speeds u onto h*u + pt = 0; f (nu) is 0 */
int gspju (const gs_scene *s, gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,
           gs_real *a, const gs_real *h, gs_real *p, const gs_real *pt, const gs_real *f,
           gs_real *dx, gs_real *lam, gs_real *w);

/* ns sets of four Euler parameters, at the places iset (4,ns) of q, from 1, are divided by their
 * norm; err becomes no less than the largest error of a norm */
void gsnrm (int ns, const int *iset, gs_real *q, gs_real *err);

/* gsnrm for one set of neighbours, q (4) */
void gsnrq (gs_real *q, gs_real *err);

/* the derivatives by parameters that stand behind the states in x (nx,1+nc), as gssen has them,
 * onto those of the constraints by the least squares, coordinates first, then speeds; ns, iset: as
 * gsprj, the norms stay. w: (nlam+ns)*(nq+nlam+ns+nc) + nlam*(nq+nu+2*np+3); iw: nlam + ns. info:
 * < 0 as con; 9 where the constraints have lost rank */
int gsspj (const gs_scene *s, gs_real t, int ns, const int *iset, int np, int nc, const int *col,
           gs_real *x, const gs_real *cst, gs_real *w, int *iw);

/* for gsspj: y (n,nc) is moved by the least squares onto d*y + r = 0, d (m,n), rows of zeros apart;
 * r (m,nc) is destroyed; g (m,m), iw (m): workspace. info: 9 if rows are dependent */
int gsspl (int m, int n, int nc, const gs_real *d, int ldd, gs_real *y, int ldy, gs_real *r,
           int ldr, gs_real *g, int *iw);

/* completes the motion qj (nu,0:r), r <= 3: the dependent coordinates id (nlam) and their
 * derivatives from the others, ia (nu-nlam), numbers from 1; the speeds are the rates. res: the
 * largest |phi| left. w: nlam*nlam + nlam*nu + 4*nlam; iw: nlam. info: < 0 as con; 1 a singular
 * position; 2 the loops do not close */
int gsclo (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id, const int *ia,
           const gs_real *cst, gs_real *res, gs_real *w, int *iw);

/* for gsclo: the positions; h (nlam,nu) and pt (nlam) are those of con there; workspace: m
 * (nlam,nlam), p, g (nlam) */
int gsclq (const gs_scene *s, gs_real t, gs_real *qj, const int *id, const gs_real *cst,
           gs_real *res, gs_real *m, gs_real *h, gs_real *p, gs_real *pt, gs_real *g, int *iw);

/* for gsclo: the derivatives 1 to r; size (nlam): what gslqf scales rows by */
int gscld (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id, const int *ia,
           const gs_real *cst, gs_real *m, gs_real *h, gs_real *p, gs_real *pt, gs_real *g,
           gs_real *size, int *iw);

/* for gsclo: m becomes the columns of the dependent coordinates in h */
void gsclm (int nlam, const int *id, const gs_real *h, gs_real *m);

/* derivatives z (nu+nlam,nz) of accelerations and multipliers by states and inputs: k*z_out = z_in,
 * with what the efforts of the tree give: lm, lb (nu,nu), lc (nu,nq), from <name>_lin. k is on
 * entry its border and is overwritten; iw: nu + nlam; info: on entry 2 where the constraints have
 * lost rank: then nothing is solved. Returned: > 0 where z holds the right sides (gsjdf solves) */
int gsjac (int nu, int nlam, int nq, int nz, const gs_real *lm, const gs_real *lb,
           const gs_real *lc, gs_real *k, gs_real *z, int *iw, int info);

/* z of gsjac from the right sides, column by column, rank revealing, where the constraints h
 * (nlam,nu) have lost rank; phi: what is left of them, grp as gsqrg; workspace: hc (nlam,nu), ud
 * (nu), lam (nlam), w as gsacc. info: 1 singular mass matrix */
int gsjdf (int nu, int nlam, int nz, const gs_real *lm, const gs_real *h, const gs_real *phi,
           const int *grp, gs_real *z, gs_real *hc, gs_real *ud, gs_real *lam, gs_real *w);

/* rows of coordinates (quasi = 1: they are there already; 0: the speeds are their rates) and speeds
 * of the Jacobians of the states' rates, a (lda,nx) by states and b (ldb,nv) by inputs; z
 * (ldz,nx+nv): derivatives of the accelerations */
void gsjrw (int nu, int nq, int nx, int nv, int quasi, const gs_real *z, int ldz, gs_real *a,
            int lda, gs_real *b, int ldb);

/* a (nr,nz) := a + by*z, by (nr,nl): what rows of a Jacobian get through accelerations and
 * multipliers */
void gsjth (int nr, int nl, int nz, const gs_real *by, int ldb, const gs_real *z, int ldz,
            gs_real *a, int lda);

#ifdef __cplusplus
}
#endif
#endif
