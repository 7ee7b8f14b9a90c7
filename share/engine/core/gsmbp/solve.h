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

/* A*ud - H'*lam = f, H*ud = g, in one of four ways (1 gs_solve_kkt_groups, 2 gs_solve_null_space, 3
 * gs_solve_zero_eigenvectors, 4 gs_solve_dependent_speeds); A (n,n), H (m,n); rows that are
 * dependent to about 1e-11. w: 2*n*n + n*m + m*m + 4*n + 8*m. info: 1 A is not positive definite on
 * the motions that H allows, ud and lam are 0; 2 constraints are dependent, lam is one of many */
int gs_solve_accelerations (int way, int n, int m, const gs_real *a, int lda, const gs_real *h,
                            int ldh, const gs_real *f, const gs_real *g, gs_real *ud, gs_real *lam,
                            gs_real *w);

/* the same with groups grp (m) of rows and the tolerance tol, as gs_solve_kkt_groups */
int gs_solve_accelerations_groups (int way, int n, int m, const gs_real *a, int lda,
                                   const gs_real *h, int ldh, const gs_real *f, const gs_real *g,
                                   gs_real tol, const int *grp, gs_real *ud, gs_real *lam,
                                   gs_real *w);

/* the way 2 of gs_solve_accelerations_groups: null space by Householder reflections */
int gs_solve_null_space (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                         const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                         gs_real *ud, gs_real *lam, gs_real *w);

/* the way 3: eigenvectors to the eigenvalue zero */
int gs_solve_zero_eigenvectors (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                                const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                                gs_real *ud, gs_real *lam, gs_real *w);

/* the way 4: Kane's dependent speeds */
int gs_solve_dependent_speeds (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                               const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                               gs_real *ud, gs_real *lam, gs_real *w);

/* y = A*x, A symmetric of order n */
void gs_symmetric_times (int n, const gs_real *a, int lda, const gs_real *x, gs_real *y);

/* the reduced equations of the ways 2 to 4: rows and columns of b (n,n) and rows of z from r on;
 * z becomes the solution, b is destroyed. info: 1 a pivot is not above the rounding errors of A */
int gs_solve_reduced (int n, int r, const gs_real *a, int lda, gs_real *b, gs_real *z);

/* Y (m,n) = diag(d)*H, rows divided by their sizes */
void gs_scaled_rows (int n, int m, const gs_real *h, int ldh, const int *grp, gs_real *y,
                     gs_real *d);

/* lam of least norm of H'*lam = A*ud - f, where the constraints are dependent */
void gs_least_multipliers (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                           const gs_real *f, gs_real tol, const int *grp, const gs_real *ud,
                           gs_real *lam, gs_real *w);

/* A*ud - H'*lam = f, H*ud = g, by multipliers; rows dependent to about 1e-11.
 * w: n*n + n*m + m*m + 2*n + 6*m; info as gs_solve_accelerations */
int gs_solve_kkt (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                  const gs_real *f, const gs_real *g, gs_real *ud, gs_real *lam, gs_real *w);

/* the same: a row of which no more than tol times its size is left beside those before it is
 * dependent; its size is the largest length in its group: grp[i] is the first row (from 1) of the
 * group of row i; grp[0] = 0: every row by itself */
int gs_solve_kkt_groups (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                         const gs_real *f, const gs_real *g, gs_real tol, const int *grp,
                         gs_real *ud, gs_real *lam, gs_real *w);

/* for gs_solve_kkt_groups: l*l' = A + H'*D*D*H, z (2*n) := z + H'*D*D*g; y (m,n), d (m) and the
 * second half of z are workspace. l is on entry the factor of A alone if info, that of
 * gs_cholesky_factor, is 0, and is kept if its worst pivot is the better one. Returned: 0, or > 0
 * if neither is positive definite */
int gs_kkt_augmented (int n, int m, const gs_real *a, int lda, const gs_real *h, int ldh,
                      const gs_real *g, const int *grp, gs_real *l, int ldl, gs_real *z, gs_real *y,
                      gs_real *d, int info);

/* lam (m) of least norm of R1*P'*lam = c (r), R1 the r by m trapezoid y that gs_qr_pivoted left of
 * H'; t (m*m), q, beta, s (m) are workspace */
void gs_least_norm (int m, int r, const gs_real *y, int ldy, const gs_real *piv, const gs_real *c,
                    gs_real *lam, gs_real *t, gs_real *q, gs_real *beta, gs_real *s);

/* A*X = B, b (n,nrhs) becomes X, a is destroyed, iw (n) is workspace. info = k: the k-th pivot of
 * the matrix with rows of size 1 is below 1000*eps */
int gs_solve_general (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw);

/* for gs_solve_general: rows of a and b times powers of two, so that the largest entry of a row of
 * a is in [1,2), then a = P*L*U; a column of ones in b becomes these powers. info: as
 * gs_solve_general */
int gs_lu_scaled (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb, int *iw);

/* for gs_solve_general: the solution from the factors of gs_lu_scaled; for three rows, one column,
   four columns */
void gs_lu_solution (int n, int nrhs, const gs_real *a, int lda, gs_real *b, int ldb,
                     const int *iw);
void gs_lu_three_rows (int nrhs, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw);
void gs_lu_one_column (int n, const gs_real *a, int lda, gs_real *b, const int *iw);
void gs_lu_four_columns (int n, const gs_real *a, int lda, gs_real *b, int ldb, const int *iw);

/* the same for A symmetric positive definite. info = k: the k-th pivot is not positive to working
 * precision, b is unchanged */
int gs_solve_spd (int n, int nrhs, gs_real *a, int lda, gs_real *b, int ldb);

/* b (n,m) := inv(L)*b, or inv(L')*b where trans = 1 */
void gs_solve_triangular (int n, int m, const gs_real *l, int ldl, gs_real *b, int ldb, int trans);

/* Cholesky factor, A = L*L', in the lower triangle. info = k: the k-th pivot is not above n*eps
 * times the k-th diagonal entry */
int gs_cholesky (int n, gs_real *a, int lda);
int gs_cholesky_factor (int n, gs_real *a, int lda);

/* A = P*L*U with partial pivoting: row k and row iw[k] (from 1) were interchanged. info: 0 or the
 * first k with a zero pivot */
int gs_lu_pivoted (int n, gs_real *a, int lda, int *iw);
int gs_lu_factor (int n, gs_real *a, int lda, int *iw);

/* Y*P = Q*R, Y (n,m), by reflections with column interchanges, as gs_qr_groups; every column by
   itself */
void gs_qr_pivoted (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
                    gs_real *siz, int *rank);

/* the same with columns in groups: R in the upper triangle of the first rank rows, below it the
 * vectors v of the reflections I - beta[k]*v*v', v[k] = 1. A column is dependent if what is left
 * of it is not above tol times its size. siz (m) is workspace */
void gs_qr_groups (int n, int m, gs_real *y, int ldy, gs_real tol, const int *grp, gs_real *piv,
                   gs_real *beta, gs_real *siz, int *rank);

/* the same; the next column is the one of which most is left, dependent if that is not above tol
 * times the largest column; siz (rank): what was left */
void gs_qr_columns (int n, int m, gs_real *y, int ldy, gs_real tol, gs_real *piv, gs_real *beta,
                    gs_real *siz, int *rank);

/* siz (m) becomes the largest of its group grp, no less than part times the largest of all */
void gs_group_sizes (int m, const int *grp, gs_real part, gs_real *siz);

/* the reflection of column k, counted from 0; d is the squared length of its rows from k on */
void gs_reflection (int n, int m, int k, gs_real *y, int ldy, gs_real d, gs_real *beta);

/* b (n) := Q*b, or Q'*b where trans = 1; Q from gs_qr_pivoted with the rank k */
void gs_qr_times (int n, int k, const gs_real *y, int ldy, const gs_real *beta, gs_real *b,
                  int trans);

/* B*V = U*diag(s): b (m,n) becomes B*V, v (n,n), singular values s (n) falling; rank: how many are
 * above tol*s[0] */
void gs_singular_values (int m, int n, gs_real *b, int ldb, gs_real *v, int ldv, gs_real *s,
                         gs_real tol, int *rank);

/* a plane rotation: (x,y) := (c*x + s*y, c*y - s*x) */
void gs_rotate_plane (int n, gs_real *x, gs_real *y, gs_real c, gs_real s);

/* tol, within which constraints are dependent at a position beside them: their values phi (m),
 * their Jacobian h (m,n); w (m) is workspace */
void gs_rank_tolerance (int n, int m, const gs_real *h, int ldh, const gs_real *phi, const int *grp,
                        gs_real *tol, gs_real *w);

/* eigenvalues wr + i*wi (n) of a general matrix, which is destroyed; w: 4*n. info > 0: not all were
 * found */
int gs_eigenvalues (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi, gs_real *w);

/* for gs_eigenvalues: a similar matrix of Hessenberg form; v (n) is workspace */
void gs_hessenberg (int n, gs_real *a, int lda, gs_real *v);

/* for gs_eigenvalues: the eigenvalues of that. info as gs_eigenvalues */
int gs_hessenberg_eigenvalues (int n, gs_real *a, int lda, gs_real *wr, gs_real *wi);

/* for gs_hessenberg_eigenvalues: a double QR step on rows and columns l to en (from 1), en >= l +
 * 2; the shifts have the sum x + y and the product x*y - z */
void gs_hessenberg_step (int n, gs_real *a, int lda, int l, int en, gs_real x, gs_real y,
                         gs_real z);

#ifdef __cplusplus
}
#endif
#endif
