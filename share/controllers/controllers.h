/* controllers.h: the controllers of this folder in C, which calculate with a scene's routines.
 * Calling rules: gsmbp/scene.h; the heads of the Fortran of the same names say more. A controller
 * alone (gsmbp_controller in Octave) has them beside it. */
#ifndef GSMBP_CONTROLLERS_H
#define GSMBP_CONTROLLERS_H

#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* the machine as a controller knows it; matrices (n,..) have n rows */
typedef struct
{
  int n, na, order;       /* coordinates, independent ones, derivatives of a motion (> 1) */
  const int *independent; /* na: which ones, from 1 */
  int (*closure) (double t, double *qj, const double *cst);
  int (*command) (double t, const double *qj, const double *cst, double *v);
  gs_mas *mass;
  gs_pnt *points;
  gs_jpt *jacobians;
  const double *cst;
} gs_machine;

typedef void gs_inv (double t, const double *q, const double *u, const double *ud, const double *v,
                     const double *cst, double *tau);

/* coordinates of a sample (na each): measured q, u; wanted qr, ur, ar */
typedef struct
{
  double t;
  const double *q, *u, *qr, *ur, *ar;
} gs_sample;

/* gains of each coordinate: kp, kd, ki with the integrals z, or stiffness kp, damping kd with the
 * damping ratio zeta where it is not 0 */
typedef struct
{
  const double *kp, *kd, *ki;
  double zeta;
} gs_gains;

/* the motion qj (n,order+1) of all coordinates from q, u, a (na) of the independent ones; qg (n):
 * where they were, then where they are */
int gsmot (const gs_machine *m, double t, const double *q, const double *u, const double *a,
           double *qg, double *qj);

/* mass matrices mt (n,n) and mr (na,na), speeds tr (n,na) by the independent ones; wj as qj */
int gsmor (const gs_machine *m, double t, const double *qj, double *wj, double *mt, double *tr,
           double *mr);

/* computed torque: accelerations a (na), motion qj, inputs v */
int gsctd (const gs_machine *m, const gs_sample *s, const gs_gains *k, const double *z, double *qg,
           double *a, double *qj, double *v);

/* feedforward along rj (na,order+1) and a PID controller of each coordinate on its drive id */
int gsffd (const gs_machine *m, const gs_sample *s, const double *rj, const gs_gains *k,
           const double *z, const int *id, double *qg, double *qj, double *v);

/* impedance of the coordinates; iw (na) */
int gsimd (const gs_machine *m, const gs_sample *s, const gs_gains *k, double *qg, double *a,
           double *qj, double *wj, double *mt, double *tr, double *mr, double *v, int *iw);

/* a tool: number ip (from 1) of np points, in_tool: k and d (6,6) by its axes; wanted pr, pdr (6);
 * damping dq (na) of the coordinates */
typedef struct
{
  int np, ip, in_tool;
  const double *pr, *pdr, *k, *d, *dq;
} gs_tool;

/* impedance of a tool; p (3,np), r (3,3*np), jp (6,n*np), dju (6,np) */
int gscim (const gs_machine *m, const gs_sample *s, const gs_tool *tool, double *qg, double *a,
           double *qj, double *wj, double *mt, double *tr, double *mr, double *p, double *r,
           double *jp, double *dju, double *v, int *iw);

/* efforts tau (n) of a tree: computed torque, feedforward, impedance; a (n), v: zeros, mt (n,n) */
void gsctq (gs_inv *inv, int n, const gs_sample *s, const gs_gains *k, const double *z,
            const double *v, const double *cst, double *a, double *tau);
void gsffw (gs_inv *inv, int n, const gs_sample *s, const gs_gains *k, const double *z,
            const double *v, const double *cst, double *tau);
void gsimt (gs_inv *inv, gs_mas *mas, int n, const gs_sample *s, const gs_gains *k,
            const double *v, const double *cst, double *mt, double *tau);

/* an input v within its limits, then to the steps of its converter (0: none); whether it was
 * within them */
int gslim (double low, double high, double step, double *v);

#ifdef __cplusplus
}
#endif
#endif
