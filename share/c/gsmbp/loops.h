/* gsmbp/loops.h: states of closed chains between steps. Calling rules: scene.h.
 *
 * p is the partition of a state into independent and dependent speeds, partition.h. */
#ifndef GSMBP_LOOPS_H
#define GSMBP_LOOPS_H

#include "gsmbp/partition.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* after a step: x onto the constraints in the way iopt[1] says; drift, rank and the choice of
 * independent speeds are looked after. jump: how far a coordinate [0] and a speed [1] may be
 * moved, 0 for any way, and how far the least pivot may fall beside its largest value [2].
 * info: what failed; 3 constraints not fulfilled, or only by a jump; 4 the least pivot fell */
int gschk (const gs_scene *s, double t, double *x, const int *iopt, const double *jump,
           const double *cst, double *p, int *istat, double *rstat);

/* completes x: phi(q,t) = 0 and HC*u + phit = 0 by the dependent coordinates and speeds, which are
 * guesses on entry. info: 3 no position found, or what con returned */
int gsprt (const gs_scene *s, double t, double *x, const double *cst, double *p);

/* the partition p before anything is known of the constraints */
void gspst (int nq, int nu, int nlam, const int *iopt, double *p);

/* for gsprt: y (m,r) = diag(rows)*hc(:,order) by gsqrp */
void gspfa (int m, int r, const double *hc, const double *order, const double *rows, double *y,
            double *piv, double *beta, double *siz, int *rank);

/* for gsprt: du(order(1..r)) solves y*du = b by least squares, the other entries of du (nu) are 0;
 * b is destroyed */
void gspls (int m, int r, int rank, const double *y, const double *piv, const double *beta,
            double *b, int nu, const double *order, double *du);

/* a first or new choice of the dependent speeds at x. info: what con returned */
int gspnw (const gs_scene *s, double t, const double *x, const double *cst, double *p);

/* the same within a run: istat[5], istat[6] tell if con fails */
int gspcn (const gs_scene *s, double t, const double *x, const double *cst, double *p,
           int *istat);

/* rank of the constraints, to 1e-7, and the choice of the dependent speeds, from the Jacobian that
 * p holds. least: the least pivot beside the largest; change: 1 if another set was chosen */
void gsprc (const gs_scene *s, double t, const double *x, const double *cst, double *p, int *rank,
            double *least, int *change);

/* which coordinates and speeds count in the step control; order is that of the displacements, w
 * (nu + nq) is workspace */
void gspwt (const gs_scene *s, double t, const double *x, const double *cst, double *p,
            const double *order, double *w);

/* the volume that the r columns of y (m,r) span, divided by the product of siz; y is destroyed */
void gsvol (int m, int r, double *y, const double *siz, double *ratio);

/* pivots of the Jacobian hc (nlam,nu), rows divided by the largest length size they had so far;
 * y, piv, beta, d and rank are what gsqrc leaves */
void gslpv (int nu, int nlam, const double *hc, double *size, double *y, double *piv, double *beta,
            double *d, int *rank, double *least);

/* follows the least pivot from step to step: the minimum smin that it passed and when, tmin;
 * smin = -1: none */
void gspas (const gs_scene *s, double t, const double *x, const double *cst, double *p,
            double *tmin, double *smin);

/* job 0: hc (nlam,nu) becomes the Jacobian that p holds; 1: turn becomes how far that differs from
 * hc, beside the length of its row, the largest of the rows */
void gspch (int nq, int nu, int nlam, const double *p, double *hc, int job, double *turn);

#ifdef __cplusplus
}
#endif
#endif
