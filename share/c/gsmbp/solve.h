/* gsmbp/solve.h: linear systems and factorizations. Calling rules: scene.h.
 *
 * Rows and columns that are stored as data (piv, iw, grp) are counted from 1, as in the Fortran;
 * piv holds them as whole numbers in double. A symmetric matrix is its lower triangle.
 * info = -i: argument i is out of range. */
#ifndef GSMBP_SOLVE_H
#define GSMBP_SOLVE_H

#include "gsmbp/real.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A*ud - H'*lam = f, H*ud = g, in one of four ways (1 gskkr, 2 gsnul, 3 gszev, 4 gskds); A (n,n), H
 * (m,n); rows that are dependent to about 1e-11. w: 2*n*n + n*m + m*m + 4*n + 8*m. info: 1 A is
 * not positive definite on the motions that H allows, ud and lam are 0; 2 constraints are
 * dependent, lam is one of many */
int gsacc (int way, int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
           const gs_real *f, const gs_real *g, gs_real *ud, gs_real *lam, gs_real *w);

/* the same with groups grp (m) of rows and the tolerance tol, as gskkr */
int gsacr (int way, int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
           const gs_real *f, const gs_real *g, gs_real tol, const int *grp, gs_real *ud,
           gs_real *lam, gs_real *w);

/* the way 2 of gsacr: null space by Householder reflections */
int gsnul (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
           const gs_real *g, gs_real tol, const int *grp, gs_real *ud, gs_real *lam, gs_real *w);

/* the way 3: eigenvectors to the eigenvalue zero */
int gszev (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
           const gs_real *g, gs_real tol, const int *grp, gs_real *ud, gs_real *lam, gs_real *w);

/* the way 4: Kane's dependent speeds */
int gskds (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
           const gs_real *g, gs_real tol, const int *grp, gs_real *ud, gs_real *lam, gs_real *w);

/* y = A*x, A symmetric of order n */
void gsmul (int n, const gs_real *a, int lda, const gs_real *x, gs_real *y);

/* the reduced equations of the ways 2 to 4: rows and columns of b (n,n) and rows of z from r on;
 * z becomes the solution, b is destroyed. info: 1 a pivot is not above the rounding errors of A */
int gsred (int n, int r, const gs_real *a, int lda, gs_real *b, gs_real *z);

/* Y (m,n) = diag(d)*H, rows divided by their sizes */
void gsrow (int n, int m, const gs_real *h, int ldh, const int *grp, gs_real *y, gs_real *d);

/* lam of least norm of H'*lam = A*ud - f, where the constraints are dependent */
void gslam (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
            gs_real tol, const int *grp, const gs_real *ud, gs_real *lam, gs_real *w);

/* A*ud - H'*lam = f, H*ud = g, by multipliers; rows dependent to about 1e-11.
 * w: n*n + n*m + m*m + 2*n + 6*m; info as gsacc */
int gskkt (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
           const gs_real *g, gs_real *ud, gs_real *lam, gs_real *w);

/* the same: a row of which no more than tol times its size is left beside those before it is
 * dependent; its size is the largest length in its group: grp[i] is the first row (from 1) of the
 * group of row i; grp[0] = 0: every row by itself */
int gskkr (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *f,
           const gs_real *g, gs_real tol, const int *grp, gs_real *ud, gs_real *lam, gs_real *w);

/* for gskkr: l*l' = A + H'*D*D*H, z (2*n) := z + H'*D*D*g; y (m,n), d (m) and the second half of z
 * are workspace. l is on entry the factor of A alone if info, that of gschf, is 0, and is kept if
 * its worst pivot is the better one. Returned: 0, or > 0 if neither is positive definite */
int gsaug (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh, const gs_real *g,
           const int *grp, gs_real *l, int ldl, gs_real *z, gs_real *y, gs_real *d, int info);

/* lam (m) of least norm of R1*P'*lam = c (r), R1 the r by m trapezoid y that gsqrp left of H';
 * t (m*m), q, beta, s (m) are workspace */
void gslnm (int m, int r, const gs_real *y, int ldy, const gs_real *piv, const gs_real *c,
            gs_real *lam, gs_real *t, gs_real *q, gs_real *beta, gs_real *s);

/* A*X = B, b (n,nrhs) becomes X, a is destroyed, iw (n) is workspace. info = k: the k-th pivot of
 * the matrix with rows of size 1 is below 1000*eps */
int gsleq (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw);

/* for gsleq: rows of a and b times powers of two, so that the largest entry of a row of a is in
 * [1,2), then a = P*L*U; a column of ones in b becomes these powers. info: as gsleq */
int gslqf (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw);

/* for gsleq: the solution from the factors of gslqf; for three rows, one column, four columns */
void gslqs (int n, int nrhs, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw);
void gslq3 (int nrhs, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw);
void gslqc (int n, const gs_real *a, int lda, gs_real *b, const int *iw);
void gslq4 (int n, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw);

/* the same for A symmetric positive definite. info = k: the k-th pivot is not positive to working
 * precision, b is unchanged */
int gsspd (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb);

/* b (n,m) := inv(L)*b, or inv(L')*b where trans = 1 */
void gstrs (int n, int m, const gs_real *l, int ldl, gs_real *b, int ldb, int trans);

/* Cholesky factor, A = L*L', in the lower triangle. info = k: the k-th pivot is not above n*eps
 * times the k-th diagonal entry */
int gschp (int n, gs_real *a, int lda);
int gschf (int n, gs_real *a, int lda);

/* A = P*L*U with partial pivoting: row k and row iw[k] (from 1) were interchanged. info: 0 or the
 * first k with a zero pivot */
int gslup (int n, gs_real *a, int lda, int *iw);
int gsluf (int n, gs_real *a, int lda, int *iw);

/* Y*P = Q*R, Y (n,m), by reflections with column interchanges, as gsqrg; every column by itself */
void gsqrp (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
            gs_real *siz, int *rank);

/* the same with columns in groups: R in the upper triangle of the first rank rows, below it the
 * vectors v of the reflections I - beta[k]*v*v', v[k] = 1. A column is dependent if what is left
 * of it is not above tol times its size. siz (m) is workspace */
void gsqrg (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv,
            gs_real *beta, gs_real *siz, int *rank);

/* the same; the next column is the one of which most is left, dependent if that is not above tol
 * times the largest column; siz (rank): what was left */
void gsqrc (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
            gs_real *siz, int *rank);

/* siz (m) becomes the largest of its group grp, no less than part times the largest of all */
void gsgrp (int m, const int *grp, gs_real part, gs_real *siz);

/* the reflection of column k, counted from 0; d is the squared length of its rows from k on */
void gshrf (int n, int m, int k, gs_real *y, int ldy, gs_real d, gs_real *beta);

/* b (n) := Q*b, or Q'*b where trans = 1; Q from gsqrp with the rank k */
void gsqmv (int n, int k, const gs_real *y, int ldy, const gs_real *beta, gs_real *b, int trans);

/* B*V = U*diag(s): b (m,n) becomes B*V, v (n,n), singular values s (n) falling; rank: how many are
 * above tol*s[0] */
void gssvd (int m, int n, gs_real *b, int ldb, gs_real *v, int ldv, gs_real *s, gs_real tol,
            int *rank);

/* a plane rotation: (x,y) := (c*x + s*y, c*y - s*x) */
void gsrot (int n, gs_real *x, gs_real *y, gs_real c, gs_real s);

/* tol, within which constraints are dependent at a position beside them: their values phi (m),
 * their Jacobian h (m,n); w (m) is workspace */
void gsrtl (int n, int m, const gs_real *h, int ldh, const gs_real *phi, const int *grp,
            gs_real *tol, gs_real *w);

/* eigenvalues wr + i*wi (n) of a general matrix, which is destroyed; w: 4*n. info > 0: not all were
 * found */
int gseig (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi, gs_real *w);

/* for gseig: a similar matrix of Hessenberg form; v (n) is workspace */
void gshes (int n, gs_real *a, int lda, gs_real *v);

/* for gseig: the eigenvalues of that. info as gseig */
int gshqr (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi);

/* for gshqr: a double QR step on rows and columns l to en (from 1), en >= l + 2; the shifts have
 * the sum x + y and the product x*y - z */
void gshqs (int n, gs_real *a, int lda, int l, int en, gs_real x, gs_real y, gs_real z);

#ifdef __cplusplus
}
#endif
#endif
