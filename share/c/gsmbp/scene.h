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

#ifdef __cplusplus
extern "C" {
#endif

typedef int gs_rhs (double t, const double *x, const double *v, const double *cst, double *xd);
typedef int gs_prj (double t, double *x, const double *cst, double *res);
typedef int gs_con (double t, const double *q, const double *u, const double *cst, double *phi,
                    double *phit, double *hc, int ldh, double *gam);
typedef void gs_kin (double t, const double *q, const double *u, const double *cst, double *qdot);
typedef int gs_cmd (double t, const double *qj, const double *xi, const double *cst, double *v,
                    double *xid);
typedef int gs_clo (double t, double *qj, const double *cst, double *res);
typedef int gs_out (double t, const double *x, const double *v, const double *cst, double *y);
typedef void gs_ctl (int k, double t, const double *y, double *xk, const double *cst, double *v);
typedef void gs_mas (double t, const double *q, const double *cst, double *m, int ldm);
typedef void gs_gad (double t, const double *qj, const double *cst, double *g);
typedef int gs_stk (double t, const double *x, const double *v, const double *cst, double *ud,
                    double *lam, double *hold);
typedef void gs_hld (double t, const double *x, const double *v, const double *cst, double *row,
                     int ldr, double *s, double *sd, double *prm);
typedef void gs_ctp (const double *cst, double *period, double *delay);
typedef void gs_evt (double t, const double *x, const double *v, const int *mode,
                     const double *cst, double *gv);
typedef int gs_rst (double t, double *x, double *v, int *mode, int k, const double *cst);
typedef void gs_pnt (double t, const double *q, const double *cst, double *place, double *axes);
typedef void gs_jpt (double t, const double *q, const double *u, const double *cst, double *jac,
                     double *gam);
/* for derivatives by parameters: of the rates xd (nx) by parameters, states and inputs, p, a, b (nx
 * rows each); of the sum of the rates times l (nx) by states, inputs and parameters, xb, vb, pb;
 * of the constraints and of their rates by coordinates, dp, dv, and by parameters, pp, pv (nlam
 * rows each) */
typedef int gs_rhp (double t, const double *x, const double *v, const double *cst, double *p,
                    int ldp, double *a, int lda, double *b, int ldb, double *xd);
typedef int gs_adj (double t, const double *x, const double *v, const double *cst,
                    const double *l, double *xb, double *vb, double *pb);
typedef void gs_tan (double t, const double *x, const double *cst, double *dp, int ldp, double *dv,
                     int ldv);
typedef void gs_cop (double t, const double *x, const double *cst, double *pp, int ldpp,
                     double *pv, int ldpv);
/* the nsw times at which the scene switches */
typedef void gs_swi (const double *cst, double *ts);
/* inputs of the user: side < 0 is the limit from the left; data is the scene's */
typedef int gs_vin (double t, int side, const double *x, int nx, int nv, void *data, double *v);

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
  gs_gad *gad;
  gs_stk *stk;
  gs_hld *hld;
  gs_ctp *ctp; /* periods and delays of the sampled devices, for whoever plans a run */
  gs_vin *vin;
  void *data; /* for vin */
  gs_pnt *pnt; /* points and frames, and their Jacobians, for gsnik */
  gs_jpt *jpt;
  gs_rhp *rhp; /* for gssen */
  gs_adj *adj; /* for gsad8 */
  gs_tan *tan; /* for gsspj, as the next */
  gs_cop *cop;
  gs_swi *swi; /* for gssim, which ends its steps there */
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
  const double *memory;          /* nxk: where it starts */
} gs_scene;

#ifdef __cplusplus
}
#endif
#endif
