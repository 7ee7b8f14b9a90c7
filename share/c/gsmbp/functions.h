/* gsmbp/functions.h: functions of one number or of a list. Calling rules: scene.h; sines.h has GSSC
 * for compilers to put in line. */
#ifndef GSMBP_FUNCTIONS_H
#define GSMBP_FUNCTIONS_H

#ifdef __cplusplus
extern "C" {
#endif

/* the distance from 1 to the next larger number */
double gseps (void);

/* the time that stands for t: with side < 0 one just before it, else t itself */
double gslft (double t, int side);

/* 0 if the n entries of x are finite, else the number of the first that is not, counted from 1 */
int gsfin (int n, const double *x);

/* the largest whole number that is not above x */
double gsflr (double x);

/* the ns points c of Gauss between -1 and 1, rising, and their weights wt; ns = 2, 8 or
 * 12 */
void gsgln (int ns, double *c, double *wt);

/* the polynomials p of Legendre of degrees 0 to n-1 at x, n >= 2 */
void gslgp (int n, double x, double *p);

/* weights b (ns): sum b[k]*f(c[k]) = integral from ca to cb of the polynomial through f at the
 * points of gsgln */
void gsglq (int ns, const double *c, const double *wt, double ca, double cb, double *b);

/* weights b (n): the same of the polynomial through f at the places z (n) next to cb, seven at
 * most; the other b are 0 */
void gslgi (int n, const double *z, double ca, double cb, double *b);

/* sine s and cosine c of the angle x [rad] */
void gssc (double x, double *s, double *c);

/* the same by the library, where gssc cannot */
void gsscl (double x, double *s, double *c);

/* sines s and cosines c of n blocks of eight angles x, (8,n) all */
void gsscv (int n, const double *x, double *s, double *c);

/* angles a of n blocks of eight points (x,y), (8,n) all, as atan2 (y, x) [rad] */
void gsatv (int n, const double *y, const double *x, double *a);

/* the same of one point by the library */
void gsatl (double y, double x, double *a);

#ifdef __cplusplus
}
#endif
#endif
