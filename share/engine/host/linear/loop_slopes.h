/* host/linear/loop_slopes.h: how the motion of a closed chain and its efforts change with that
 * of some coordinates and with parameters. */
#ifndef GSMBP_HOST_LOOP_SLOPES_H
#define GSMBP_HOST_LOOP_SLOPES_H

#ifdef __cplusplus
extern "C" {
#endif

/* d (rows,4*nu+npar): what ILP gives, by coordinates, speeds, accelerations, efforts and
 * multipliers, parameters; q (nplanned,3,n): n changes of the planned coordinates, their speeds and
 * accelerations; p (npar,n): of the parameters. x (nu,3,n): the changes of all; e (nu,n): of the
 * efforts, then the multipliers. 0; 1: no memory; 2: the loops are singular there */
int gs_loop_slopes (int nu, int npar, int rows, const double *d, int nplanned, const int *planned,
                    int n, const double *q, const double *p, double *x, double *e);

#ifdef __cplusplus
}
#endif
#endif
