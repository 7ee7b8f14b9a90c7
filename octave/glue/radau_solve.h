/* The linear systems of gsmbp_radau.c: (ROOT/H*I - J) X = B, real and complex, dense, by LU with
   partial pivoting; columns one after the other. */
#ifndef GSMBP_RADAU_SOLVE_H
#define GSMBP_RADAU_SOLVE_H
#include <complex.h>

/* the factors in LU, the rows that changed places in PIVOT; 0, or 1: singular */
extern int gsmbp_real_factors (int n, double shift, const double *J, double *lu, int *pivot);
extern void gsmbp_real_solve (int n, const double *lu, const int *pivot, double *x);
extern int gsmbp_complex_factors (int n, double complex shift, const double *J, double complex *lu,
                                  int *pivot);
extern void gsmbp_complex_solve (int n, const double complex *lu, const int *pivot,
                                 double complex *x);
#endif
