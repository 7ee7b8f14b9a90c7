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
int gs_check_constraints (const gs_scene *s, gs_real t, gs_real *x, const int *iopt,
                          const gs_real *jump, const gs_real *cst, gs_real *p, int *istat,
                          gs_real *rstat);

/* the first part of gs_check_constraints alone: x is moved onto the constraints, by no more than
 * jump[0] and jump[1] where jump[0] > 0. info as gs_check_constraints: not 4 */
int gs_move_onto (const gs_scene *s, gs_real t, gs_real *x, const int *iopt, const gs_real *jump,
                  const gs_real *cst, gs_real *p, int *istat, gs_real *rstat);

/* completes x: phi(q,t) = 0 and HC*u + phit = 0 by the dependent coordinates and speeds, which are
 * guesses on entry. info: 3 no position found, or what con returned */
int gs_complete_state (const gs_scene *s, gs_real t, gs_real *x, const gs_real *cst, gs_real *p);

/* the partition p before anything is known of the constraints */
void gs_partition_none (int nq, int nu, int nlam, const int *iopt, gs_real *p);

/* for gs_complete_state: y (m,r) = diag(rows)*hc(:,order) by gs_qr_pivoted */
void gs_partition_factors (int m, int r, const gs_real *hc, const gs_real *order,
                           const gs_real *rows, gs_real *y, gs_real *piv, gs_real *beta,
                           gs_real *siz, int *rank);

/* for gs_complete_state: du(order(1..r)) solves y*du = b by least squares, the other entries of du
 * (nu) are 0; b is destroyed */
void gs_partition_solve (int m, int r, int rank, const gs_real *y, const gs_real *piv,
                         const gs_real *beta, gs_real *b, int nu, const gs_real *order,
                         gs_real *du);

/* a first or new choice of the dependent speeds at x. info: what con returned */
int gs_partition_choose (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                         gs_real *p);

/* the same within a run: istat[GS_FAILED_INFO], istat[GS_FAILED] tell if con fails */
int gs_partition_choose_in_run (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                                gs_real *p, int *istat);

/* rank of the constraints, to 1e-7, and the choice of the dependent speeds, from the Jacobian that
 * p holds. least: the least pivot beside the largest; change: 1 if another set was chosen */
void gs_partition_rank (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                        gs_real *p, int *rank, gs_real *least, int *change);

/* which coordinates and speeds count in the step control; order is that of the displacements, w
 * (nu + nq) is workspace */
void gs_partition_weights (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                           gs_real *p, const gs_real *order, gs_real *w);

/* the volume that the r columns of y (m,r) span, divided by the product of siz; y is destroyed */
void gs_volume (int m, int r, gs_real *y, const gs_real *siz, gs_real *ratio);

/* pivots of the Jacobian hc (nlam,nu), rows divided by the largest length size they had so far;
 * y, piv, beta, d and rank are what gs_qr_columns leaves */
void gs_constraint_pivots (int nu, int nlam, const gs_real *hc, gs_real *size, gs_real *y,
                           gs_real *piv, gs_real *beta, gs_real *d, int *rank, gs_real *least);

/* follows the least pivot from step to step: the minimum smin that it passed and when, tmin;
 * smin = -1: none */
void gs_follow_pivot (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst,
                      gs_real *p, gs_real *tmin, gs_real *smin);

/* job 0: hc (nlam,nu) becomes the Jacobian that p holds; 1: turn becomes how far that differs from
 * hc, beside the length of its row, the largest of the rows */
void gs_jacobian_turn (int nq, int nu, int nlam, const gs_real *p, gs_real *hc, int job,
                       gs_real *turn);

/* x onto phi = 0 and HC*u + phit = 0 by the shortest way in the metric of the mass matrix; Euler
 * parameters, ns sets at iset (4,ns), numbers from 1, get the norm 1. quasi: 1 where the speeds are
 * not the rates of the coordinates, else 0. res: the largest |phi| and error of a norm before. w:
 * 2*nu*nu + 2*nu*nlam + nlam*nlam + 5*nu + 10*nlam + 2*nq. info: < 0 as con; 1 singular mass
 * matrix; 3 no position found */
int gs_project (const gs_scene *s, gs_real t, gs_real *x, int quasi, int ns, const int *iset,
                const gs_real *cst, gs_real *res, gs_real *w);

/* for gs_project: the position q onto phi = 0; h (nlam,nu) and pt (nlam) are those of con there. u:
 * the speeds; workspace: a (nu,nu), p, g, lam (nlam), f, dx (nu), w as gs_solve_kkt, dq (nq) */
int gs_project_position (const gs_scene *s, gs_real t, gs_real *q, const gs_real *u, int quasi,
                         int ns, const int *iset, const gs_real *cst, gs_real *res, gs_real *a,
                         gs_real *h, gs_real *p, gs_real *pt, gs_real *g, gs_real *f, gs_real *dx,
                         gs_real *lam, gs_real *w, gs_real *dq);

/* for gs_project: the step dx that moves the speeds u onto h*u + pt = 0; f (nu) is 0 */
int gs_project_speeds (const gs_scene *s, gs_real t, const gs_real *q, const gs_real *u,
                       const gs_real *cst, gs_real *a, const gs_real *h, gs_real *p,
                       const gs_real *pt, const gs_real *f, gs_real *dx, gs_real *lam, gs_real *w);

/* ns sets of four Euler parameters, at the places iset (4,ns) of q, from 1, are divided by their
 * norm; err becomes no less than the largest error of a norm */
void gs_normalize_sets (int ns, const int *iset, gs_real *q, gs_real *err);

/* gs_normalize_sets for one set of neighbours, q (4) */
void gs_normalize_set (gs_real *q, gs_real *err);

/* the derivatives by parameters that stand behind the states in x (nx,1+nc), as
 * gs_rates_with_columns has them, onto those of the constraints by the least squares, coordinates
 * first, then speeds; ns, iset: as gs_project, the norms stay. w: (nlam+ns)*(nq+nlam+ns+nc) +
 * nlam*(nq+nu+2*np+3); iw: nlam + ns. info: < 0 as con; 9 where the constraints have lost rank */
int gs_project_columns (const gs_scene *s, gs_real t, int ns, const int *iset, int np, int nc,
                        const int *col, gs_real *x, const gs_real *cst, gs_real *w, int *iw);

/* for gs_project_columns: y (n,nc) is moved by the least squares onto d*y + r = 0, d (m,n), rows of
 * zeros apart; r (m,nc) is destroyed; g (m,m), iw (m): workspace. info: 9 if rows are dependent */
int gs_columns_onto (int m, int n, int nc, const gs_real *d, int ldd, gs_real *y, int ldy,
                     gs_real *r, int ldr, gs_real *g, int *iw);

/* completes the motion qj (nu,0:r), r <= 3: the dependent coordinates id (nlam) and their
 * derivatives from the others, ia (nu-nlam), numbers from 1; the speeds are the rates. res: the
 * largest |phi| left. w: nlam*nlam + nlam*nu + 4*nlam; iw: nlam. info: < 0 as con; 1 a singular
 * position; 2 the loops do not close */
int gs_close_motion (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id, const int *ia,
                     const gs_real *cst, gs_real *res, gs_real *w, int *iw);

/* for gs_close_motion: the positions; h (nlam,nu) and pt (nlam) are those of con there; workspace:
 * m (nlam,nlam), p, g (nlam) */
int gs_close_positions (const gs_scene *s, gs_real t, gs_real *qj, const int *id,
                        const gs_real *cst, gs_real *res, gs_real *m, gs_real *h, gs_real *p,
                        gs_real *pt, gs_real *g, int *iw);

/* for gs_close_motion: the derivatives 1 to r; size (nlam): what gs_lu_scaled scales rows by */
int gs_close_derivatives (const gs_scene *s, gs_real t, gs_real *qj, int r, const int *id,
                          const int *ia, const gs_real *cst, gs_real *m, gs_real *h, gs_real *p,
                          gs_real *pt, gs_real *g, gs_real *size, int *iw);

/* for gs_close_motion: m becomes the columns of the dependent coordinates in h */
void gs_close_matrix (int nlam, const int *id, const gs_real *h, gs_real *m);

/* derivatives z (nu+nlam,nz) of accelerations and multipliers by states and inputs: k*z_out = z_in,
 * with what the efforts of the tree give: lm, lb (nu,nu), lc (nu,nq), from <name>_lin. k is on
 * entry its border and is overwritten; iw: nu + nlam; info: on entry 2 where the constraints have
 * lost rank: then nothing is solved. Returned: > 0 where z holds the right sides
 * (gs_loop_jacobian_deficient solves) */
int gs_loop_jacobian (int nu, int nlam, int nq, int nz, const gs_real *lm, const gs_real *lb,
                      const gs_real *lc, gs_real *k, gs_real *z, int *iw, int info);

/* z of gs_loop_jacobian from the right sides, column by column, rank revealing, where the
 * constraints h (nlam,nu) have lost rank; phi: what is left of them, grp as gs_qr_groups;
 * workspace: hc (nlam,nu), ud (nu), lam (nlam), w as gs_solve_accelerations. info: 1 singular mass
 * matrix */
int gs_loop_jacobian_deficient (int nu, int nlam, int nz, const gs_real *lm, const gs_real *h,
                                const gs_real *phi, const int *grp, gs_real *z, gs_real *hc,
                                gs_real *ud, gs_real *lam, gs_real *w);

/* rows of coordinates (quasi = 1: they are there already; 0: the speeds are their rates) and speeds
 * of the Jacobians of the states' rates, a (lda,nx) by states and b (ldb,nv) by inputs; z
 * (ldz,nx+nv): derivatives of the accelerations */
void gs_rate_rows (int nu, int nq, int nx, int nv, int quasi, const gs_real *z, int ldz, gs_real *a,
                   int lda, gs_real *b, int ldb);

/* a (nr,nz) := a + by*z, by (nr,nl): what rows of a Jacobian get through accelerations and
 * multipliers */
void gs_rate_rows_through (int nr, int nl, int nz, const gs_real *by, int ldb, const gs_real *z,
                           int ldz, gs_real *a, int lda);

#ifdef __cplusplus
}
#endif
#endif
