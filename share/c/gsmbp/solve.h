/* gsmbp/solve.h: linear systems and factorizations. Calling rules: scene.h.
 *
 * Rows and columns that are stored as data (piv, iw, grp) are counted from 1, as in the Fortran;
 * piv holds them as whole numbers in double. A symmetric matrix is its lower triangle.
 * info = -i: argument i is out of range. */
#ifndef GSMBP_SOLVE_H
#define GSMBP_SOLVE_H

#ifdef __cplusplus
extern "C" {
#endif

/* A*ud - H'*lam = f, H*ud = g, in one of four ways (1 gskkr, 2 gsnul, 3 gszev, 4 gskds); A (n,n), H
 * (m,n); rows that are dependent to about 1e-11. w: 2*n*n + n*m + m*m + 4*n + 8*m. info: 1 A is
 * not positive definite on the motions that H allows, ud and lam are 0; 2 constraints are
 * dependent, lam is one of many */
int gsacc (int way, int n, int m, const double *a, int lda, const double *h, int ldh,
           const double *f, const double *g, double *ud, double *lam, double *w);

/* the same with groups grp (m) of rows and the tolerance tol, as gskkr */
int gsacr (int way, int n, int m, const double *a, int lda, const double *h, int ldh,
           const double *f, const double *g, double tol, const int *grp, double *ud, double *lam,
           double *w);

/* the way 2 of gsacr: null space by Householder reflections */
int gsnul (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
           const double *g, double tol, const int *grp, double *ud, double *lam, double *w);

/* the way 3: eigenvectors to the eigenvalue zero */
int gszev (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
           const double *g, double tol, const int *grp, double *ud, double *lam, double *w);

/* the way 4: Kane's dependent speeds */
int gskds (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
           const double *g, double tol, const int *grp, double *ud, double *lam, double *w);

/* y = A*x, A symmetric of order n */
void gsmul (int n, const double *a, int lda, const double *x, double *y);

/* the reduced equations of the ways 2 to 4: rows and columns of b (n,n) and rows of z from r on;
 * z becomes the solution, b is destroyed. info: 1 a pivot is not above the rounding errors of A */
int gsred (int n, int r, const double *a, int lda, double *b, double *z);

/* Y (m,n) = diag(d)*H, rows divided by their sizes */
void gsrow (int n, int m, const double *h, int ldh, const int *grp, double *y, double *d);

/* lam of least norm of H'*lam = A*ud - f, where the constraints are dependent */
void gslam (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
            double tol, const int *grp, const double *ud, double *lam, double *w);

/* A*ud - H'*lam = f, H*ud = g, by multipliers; rows dependent to about 1e-11.
 * w: n*n + n*m + m*m + 2*n + 6*m; info as gsacc */
int gskkt (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
           const double *g, double *ud, double *lam, double *w);

/* the same: a row of which no more than tol times its size is left beside those before it is
 * dependent; its size is the largest length in its group: grp[i] is the first row (from 1) of the
 * group of row i; grp[0] = 0: every row by itself */
int gskkr (int n, int m, const double *a, int lda, const double *h, int ldh, const double *f,
           const double *g, double tol, const int *grp, double *ud, double *lam, double *w);

/* for gskkr: l*l' = A + H'*D*D*H, z (2*n) := z + H'*D*D*g; y (m,n), d (m) and the second half of z
 * are workspace. l is on entry the factor of A alone if info, that of gschf, is 0, and is kept if
 * its worst pivot is the better one. Returned: 0, or > 0 if neither is positive definite */
int gsaug (int n, int m, const double *a, int lda, const double *h, int ldh, const double *g,
           const int *grp, double *l, int ldl, double *z, double *y, double *d, int info);

/* lam (m) of least norm of R1*P'*lam = c (r), R1 the r by m trapezoid y that gsqrp left of H';
 * t (m*m), q, beta, s (m) are workspace */
void gslnm (int m, int r, const double *y, int ldy, const double *piv, const double *c,
            double *lam, double *t, double *q, double *beta, double *s);

/* A*X = B, b (n,nrhs) becomes X, a is destroyed, iw (n) is workspace. info = k: the k-th pivot of
 * the matrix with rows of size 1 is below 1000*eps */
int gsleq (int n, int nrhs, double *a, int lda, double *b, int ldb, int *iw);

/* for gsleq: rows of a and b times powers of two, so that the largest entry of a row of a is in
 * [1,2), then a = P*L*U; a column of ones in b becomes these powers. info: as gsleq */
int gslqf (int n, int nrhs, double *a, int lda, double *b, int ldb, int *iw);

/* for gsleq: the solution from the factors of gslqf; for three rows, one column, four columns */
void gslqs (int n, int nrhs, const double *a, int lda, double *b, int ldb, const int *iw);
void gslq3 (int nrhs, const double *a, int lda, double *b, int ldb, const int *iw);
void gslqc (int n, const double *a, int lda, double *b, const int *iw);
void gslq4 (int n, const double *a, int lda, double *b, int ldb, const int *iw);

/* the same for A symmetric positive definite. info = k: the k-th pivot is not positive to working
 * precision, b is unchanged */
int gsspd (int n, int nrhs, double *a, int lda, double *b, int ldb);

/* b (n,m) := inv(L)*b, or inv(L')*b where trans = 1 */
void gstrs (int n, int m, const double *l, int ldl, double *b, int ldb, int trans);

/* Cholesky factor, A = L*L', in the lower triangle. info = k: the k-th pivot is not above n*eps
 * times the k-th diagonal entry */
int gschp (int n, double *a, int lda);
int gschf (int n, double *a, int lda);

/* A = P*L*U with partial pivoting: row k and row iw[k] (from 1) were interchanged. info: 0 or the
 * first k with a zero pivot */
int gslup (int n, double *a, int lda, int *iw);
int gsluf (int n, double *a, int lda, int *iw);

/* Y*P = Q*R, Y (n,m), by reflections with column interchanges, as gsqrg; every column by itself */
void gsqrp (int n, int m, double *y, int ldy, double tol, double *piv, double *beta, double *siz,
            int *rank);

/* the same with columns in groups: R in the upper triangle of the first rank rows, below it the
 * vectors v of the reflections I - beta[k]*v*v', v[k] = 1. A column is dependent if what is left
 * of it is not above tol times its size. siz (m) is workspace */
void gsqrg (int n, int m, double *y, int ldy, double tol, const int *grp, double *piv,
            double *beta, double *siz, int *rank);

/* the same; the next column is the one of which most is left, dependent if that is not above tol
 * times the largest column; siz (rank): what was left */
void gsqrc (int n, int m, double *y, int ldy, double tol, double *piv, double *beta, double *siz,
            int *rank);

/* siz (m) becomes the largest of its group grp, no less than part times the largest of all */
void gsgrp (int m, const int *grp, double part, double *siz);

/* the reflection of column k, counted from 0; d is the squared length of its rows from k on */
void gshrf (int n, int m, int k, double *y, int ldy, double d, double *beta);

/* b (n) := Q*b, or Q'*b where trans = 1; Q from gsqrp with the rank k */
void gsqmv (int n, int k, const double *y, int ldy, const double *beta, double *b, int trans);

/* B*V = U*diag(s): b (m,n) becomes B*V, v (n,n), singular values s (n) falling; rank: how many are
 * above tol*s[0] */
void gssvd (int m, int n, double *b, int ldb, double *v, int ldv, double *s, double tol,
            int *rank);

/* a plane rotation: (x,y) := (c*x + s*y, c*y - s*x) */
void gsrot (int n, double *x, double *y, double c, double s);

/* tol, within which constraints are dependent at a position beside them: their values phi (m),
 * their Jacobian h (m,n); w (m) is workspace */
void gsrtl (int n, int m, const double *h, int ldh, const double *phi, const int *grp, double *tol,
            double *w);

/* eigenvalues wr + i*wi (n) of a general matrix, which is destroyed; w: 4*n. info > 0: not all were
 * found */
int gseig (int n, double *a, int lda, double *wr, double *wi, double *w);

/* for gseig: a similar matrix of Hessenberg form; v (n) is workspace */
void gshes (int n, double *a, int lda, double *v);

/* for gseig: the eigenvalues of that. info as gseig */
int gshqr (int n, double *a, int lda, double *wr, double *wi);

/* for gshqr: a double QR step on rows and columns l to en (from 1), en >= l + 2; the shifts have
 * the sum x + y and the product x*y - z */
void gshqs (int n, double *a, int lda, int l, int en, double x, double y, double z);

#ifdef __cplusplus
}
#endif
#endif
