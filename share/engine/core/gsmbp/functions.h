/* gsmbp/functions.h: functions of one number or of a list. Calling rules: scene.h; sines.h has
 * gs_sine_cosine for compilers to put in line. */
#ifndef GSMBP_FUNCTIONS_H
#define GSMBP_FUNCTIONS_H

#include "gsmbp/real.h"

#ifdef __cplusplus
extern "C" {
#endif

/* the distance from 1 to the next larger number */
gs_real gs_epsilon (void);

/* the time that stands for t: with side < 0 one just before it, else t itself */
gs_real gs_time_beside (gs_real t, int side);

/* 0 if the n entries of x are finite, else the number of the first that is not, counted from 1 */
int gs_not_finite (int n, const gs_real *x);

/* the largest whole number that is not above x */
gs_real gs_whole_below (gs_real x);

/* the ns points c of Gauss between -1 and 1, rising, and their weights wt; ns = 2, 8 or
 * 12 */
void gs_gauss_points (int ns, gs_real *c, gs_real *wt);

/* the polynomials p of Legendre of degrees 0 to n-1 at x, n >= 2 */
void gs_legendre (int n, gs_real x, gs_real *p);

/* weights b (ns): sum b[k]*f(c[k]) = integral from ca to cb of the polynomial through f at the
 * points of gs_gauss_points */
void gs_gauss_weights (int ns, const gs_real *c, const gs_real *wt, gs_real ca, gs_real cb,
                       gs_real *b);

/* weights b (n): the same of the polynomial through f at the places z (n) next to cb, seven at
 * most; the other b are 0 */
void gs_interpolation_weights (int n, const gs_real *z, gs_real ca, gs_real cb, gs_real *b);

/* sine s and cosine c of the angle x [rad] */
void gs_sine_cosine (gs_real x, gs_real *s, gs_real *c);

/* the same by the library, where gs_sine_cosine cannot */
void gs_sine_cosine_far (gs_real x, gs_real *s, gs_real *c);

/* sines s and cosines c of n blocks of eight angles x, (8,n) all */
void gs_sine_cosine_blocks (int n, const gs_real *x, gs_real *s, gs_real *c);

/* angles a of n blocks of eight points (x,y), (8,n) all, as atan2 (y, x) [rad] */
void gs_atan2_blocks (int n, const gs_real *y, const gs_real *x, gs_real *a);

/* the same of one point by the library */
void gs_atan2_point (gs_real y, gs_real x, gs_real *a);

#ifdef __cplusplus
}
#endif
#endif
