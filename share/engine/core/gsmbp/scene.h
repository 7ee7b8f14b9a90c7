/* gsmbp/scene.h: what the run time knows of a scene: sizes and routines.
 *
 * A routine is called as the Fortran one of the same name, with these changes, which hold for the
 * emitted routines and for those of this folder alike: names are in lower case; numbers that are
 * read are given by value, numbers that are written by address; arrays that are only read are
 * const; matrices lie by columns, (i,j) counted from 0 at [i + ld*j]; the indicator INFO is the
 * value of the function, with the meanings of the Fortran. Where the Fortran takes routines of the
 * scene as EXTERNAL arguments, the C takes the scene. */
#ifndef GSMBP_SCENE_H
#define GSMBP_SCENE_H

#include "gsmbp/real.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int gs_rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd);
typedef int gs_prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res);
typedef int gs_con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
                    gs_real *phit, gs_real *hc, int ldh, gs_real *gam);
typedef void gs_kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,
                     gs_real *qdot);
typedef int gs_cmd (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v,
                    gs_real *xid);
typedef int gs_clo (gs_real t, gs_real *qj, const gs_real *cst, gs_real *res);
typedef int gs_out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y);
typedef void gs_ctl (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst,
                     gs_real *v);
typedef void gs_mas (gs_real t, const gs_real *q, const gs_real *cst, gs_real *m, int ldm);
/* of the tree: M and the derivatives of its generalized forces by speeds, b, and coordinates, c (ld
 * rows each); these forces without accelerations */
typedef void gs_lin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *ud,
                     const gs_real *v, const gs_real *cst, gs_real *m, gs_real *b, gs_real *c,
                     int ld);
typedef void gs_bia (gs_real t, const gs_real *q, const gs_real *u, const gs_real *v,
                     const gs_real *cst, gs_real *b);
/* rates and outputs by states and inputs */
typedef int gs_jac (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *a,
                    int lda, gs_real *b, int ldb, gs_real *c, int ldc, gs_real *d, int ldd);
typedef void gs_gad (gs_real t, const gs_real *qj, const gs_real *cst, gs_real *g);
typedef int gs_stk (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *ud,
                    gs_real *lam, gs_real *hold);
typedef void gs_hld (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst,
                     gs_real *row, int ldr, gs_real *s, gs_real *sd, gs_real *prm);
typedef void gs_ctp (const gs_real *cst, gs_real *period, gs_real *delay);
typedef void gs_evt (gs_real t, const gs_real *x, const gs_real *v, const int *mode,
                     const gs_real *cst, gs_real *gv);
typedef int gs_rst (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst);
typedef void gs_pnt (gs_real t, const gs_real *q, const gs_real *cst, gs_real *place,
                     gs_real *axes);
typedef void gs_jpt (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,
                     gs_real *jac, gs_real *gam);
/* for derivatives by parameters: of the rates xd (nx) by parameters, states and inputs, p, a, b (nx
 * rows each); of the sum of the rates times l (nx) by states, inputs and parameters, xb, vb, pb;
 * of the constraints and of their rates by coordinates, dp, dv, and by parameters, pp, pv (nlam
 * rows each) */
typedef int gs_rhp (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p,
                    int ldp, gs_real *a, int lda, gs_real *b, int ldb, gs_real *xd);
typedef int gs_adj (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst,
                    const gs_real *l, gs_real *xb, gs_real *vb, gs_real *pb);
typedef void gs_tangent (gs_real t, const gs_real *x, const gs_real *cst, gs_real *dp, int ldp,
                         gs_real *dv, int ldv);
typedef void gs_cop (gs_real t, const gs_real *x, const gs_real *cst, gs_real *pp, int ldpp,
                     gs_real *pv, int ldpv);
/* ... through samples, events and planned motions: of outputs by parameters, p (ny rows); of held
 * outputs v and memory after the sample of device k by v and memory before it, outputs and
 * parameters, d (nv+nxk rows); of event function k by states, inputs, parameters and time, g; of
 * the speeds behind event k of ports, where speeds are ua and modes ma, by coordinates, speeds,
 * parameters and time before it, r (nu rows); of states and inputs behind event k of the user by
 * states, inputs, parameters and time before it, r (nx+nv rows), and the states behind it where no
 * constraint moves them, xa; of the command by states of devices and by parameters, vx, vp (nv
 * rows each) */
typedef int gs_oup (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p,
                    int ldp);
typedef void gs_ctd (int k, gs_real t, const gs_real *y, const gs_real *xk, const gs_real *cst,
                     const gs_real *v, gs_real *d);
typedef int gs_evp (gs_real t, const gs_real *x, const gs_real *v, const int *mode, int k,
                    const gs_real *cst, gs_real *g);
typedef int gs_rsp (gs_real t, const gs_real *x, const gs_real *v, const int *mode, int k,
                    const gs_real *ua, const int *ma, const gs_real *cst, gs_real *r);
typedef int gs_urp (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, int k,
                    gs_real *r, gs_real *xa);
typedef int gs_cmp (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst,
                    gs_real *vx, int ldvx, gs_real *vp, int ldvp);
/* for optimal motions (share/engine/host/collocation): what accelerations ud and multipliers lam
 * leave of the equations of motion, rates, outputs, f; their derivatives that are not zero, g;
 * those of second order of the sum of w times f, h. gs_description has where the entries are */
typedef void gs_dae (gs_real t, const gs_real *x, const gs_real *ud, const gs_real *lam,
                     const gs_real *v, const gs_real *cst, gs_real *f);
typedef gs_dae gs_daj;
typedef void gs_dah (gs_real t, const gs_real *x, const gs_real *ud, const gs_real *lam,
                     const gs_real *v, const gs_real *cst, const gs_real *w, gs_real *h);
/* the nsw times at which the scene switches */
typedef void gs_swi (const gs_real *cst, gs_real *ts);
/* inputs of the user: side < 0 is the limit from the left; data is the scene's */
typedef int gs_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v);

typedef struct
{
  const char *name;
  int nq, nu, nx, nv, ny, nlam; /* coordinates, speeds, states, inputs, outputs, constraints */
  gs_rhs *rhs;
  gs_prj *prj; /* a null pointer where the scene has no such routine, as below */
  gs_con *con;
  gs_kin *kin;
  gs_cmd *cmd;
  gs_clo *clo;
  gs_out *out;
  gs_ctl *ctl;
  gs_evt *evt;
  gs_rst *rst;
  gs_mas *mas;
  gs_lin *lin; /* for implicit methods, as the next two */
  gs_bia *bia;
  gs_jac *jac;
  gs_gad *gad;
  gs_stk *stk;
  gs_hld *hld;
  gs_ctp *ctp; /* periods and delays of the sampled devices, for whoever plans a run */
  gs_vin *vin;
  void *data; /* for vin */
  gs_pnt *pnt; /* points and frames, and their Jacobians, for gs_reach_point */
  gs_jpt *jpt;
  gs_rhp *rhp; /* for gs_rates_with_columns */
  gs_adj *adj; /* for gs_step_back_dp853 */
  gs_tangent *tan; /* for gs_project_columns, as the next */
  gs_cop *cop;
  gs_oup *oup; /* for runs with derivatives (share/engine/host/derivatives), as the next five */
  gs_ctd *ctd;
  gs_evp *evp;
  gs_rsp *rsp;
  gs_urp *urp;
  gs_cmp *cmp;
  int nsp;     /* parameters of all of these */
  gs_swi *swi; /* for gs_integrate, which ends its steps there */
  int nsw;
  /* for the plan of a run (plan.h); numbers of inputs count from 1 */
  int nev, nctl, nxk, nheld;     /* ports with events; sampled devices, memory, held outputs */
  const int *event_inputs;       /* nev: the mode of each, 0: none, */
  const int *event_kinds;        /* 1 friction, 2 stops, the user's: 3, 4 ends runs, 5 reports */
  int nswitch;                   /* inputs that events of the user switch: */
  const int *switch_events;      /* nswitch: the numbers of these events, */
  const int *switch_inputs;      /* of the inputs */
  const int *held_counts;        /* nctl: how many outputs each device holds */
  const int *again;              /* nctl: 1 if outputs are computed anew for it */
  const int *held_inputs;        /* nheld: device by device */
  const gs_real *memory;         /* nxk: where it starts */
  gs_dae *dae; /* for optimal motions (share/engine/host/collocation), as the next two */
  gs_daj *daj;
  gs_dah *dah;
} gs_scene;

#ifdef __cplusplus
}
#endif
#endif
