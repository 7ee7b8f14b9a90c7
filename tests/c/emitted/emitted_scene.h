/* see emitted.h */
#include "emitted.h"

#define JOIN3(a, b, c) a##b##c
#define JOIN(a, b, c) JOIN3 (a, b, c)
#define F(routine) JOIN (SCENE, _, routine##_)

extern void F (par) (double *);
extern void F (pre) (const double *, double *, int *);
extern void F (rhs) (const double *, const double *, const double *, const double *, double *,
                     int *);
extern void F (rha) (const double *, const double *, const double *, const double *, double *,
                     int *);
extern void F (kin) (const double *, const double *, const double *, const double *, double *);

static int
rhs (double t, const double *x, const double *v, const double *cst, double *xd)
{
  int info = 0;
  F (rhs) (&t, x, v, cst, xd, &info);
  return info;
}

#ifdef HAS_rha
static int
rha (double t, const double *x, const double *v, const double *cst, double *xd)
{
  int info = 0;
  F (rha) (&t, x, v, cst, xd, &info);
  return info;
}
#endif

static void
kin (double t, const double *q, const double *u, const double *cst, double *qdot)
{
  F (kin) (&t, q, u, cst, qdot);
}

#ifdef HAS_prj
extern void F (prj) (const double *, double *, const double *, double *, int *);
static int
prj (double t, double *x, const double *cst, double *res)
{
  int info = 0;
  F (prj) (&t, x, cst, res, &info);
  return info;
}
#endif

#ifdef HAS_con
extern void F (con) (const double *, const double *, const double *, const double *, double *,
                     double *, double *, const int *, double *, int *);
static int
con (double t, const double *q, const double *u, const double *cst, double *phi, double *phit,
     double *hc, int ldh, double *gam)
{
  int info = 0;
  F (con) (&t, q, u, cst, phi, phit, hc, &ldh, gam, &info);
  return info;
}
#endif

#ifdef HAS_cmd
extern void F (cmd) (const double *, const double *, const double *, const double *, double *,
                     double *, int *);
static int
cmd (double t, const double *qj, const double *xi, const double *cst, double *v, double *xid)
{
  int info = 0;
  F (cmd) (&t, qj, xi, cst, v, xid, &info);
  return info;
}
#endif

#ifdef HAS_clo
extern void F (clo) (const double *, double *, const double *, double *, int *);
static int
clo (double t, double *qj, const double *cst, double *res)
{
  int info = 0;
  F (clo) (&t, qj, cst, res, &info);
  return info;
}
#endif

#ifdef HAS_out
extern void F (out) (const double *, const double *, const double *, const double *, double *,
                     int *);
static int
out (double t, const double *x, const double *v, const double *cst, double *y)
{
  int info = 0;
  F (out) (&t, x, v, cst, y, &info);
  return info;
}
#endif

#ifdef HAS_ctl
extern void F (ctl) (const int *, const double *, const double *, double *, const double *,
                     double *);
extern void F (ctp) (const double *, double *, double *);
static void
ctl (int k, double t, const double *y, double *xk, const double *cst, double *v)
{
  F (ctl) (&k, &t, y, xk, cst, v);
}
#endif

#ifdef HAS_evt
extern void F (evt) (const double *, const double *, const double *, const int *, const double *,
                     double *);
extern void F (rst) (const double *, double *, double *, int *, const int *, const double *,
                     int *);
static void
evt (double t, const double *x, const double *v, const int *mode, const double *cst, double *gv)
{
  F (evt) (&t, x, v, mode, cst, gv);
}

static int
rst (double t, double *x, double *v, int *mode, int k, const double *cst)
{
  int info = 0;
  F (rst) (&t, x, v, mode, &k, cst, &info);
  return info;
}
#endif

#ifdef HAS_rha
#define RHA_C rha
#define RHA_F (sub *)F (rha)
#else
#define RHA_C 0
#define RHA_F 0
#endif
#ifdef HAS_prj
#define PRJ_C .prj = prj,
#define PRJ_F .prj = (sub *)F (prj),
#else
#define PRJ_C
#define PRJ_F
#endif
#ifdef HAS_con
#define CON_C .con = con,
#define CON_F .con = (sub *)F (con),
#else
#define CON_C
#define CON_F
#endif
#ifdef HAS_cmd
#define CMD_C .cmd = cmd,
#define CMD_F .cmd = (sub *)F (cmd),
#else
#define CMD_C
#define CMD_F
#endif
#ifdef HAS_clo
#define CLO_C .clo = clo,
#define CLO_F .clo = (sub *)F (clo),
#else
#define CLO_C
#define CLO_F
#endif
#ifdef HAS_out
#define OUT_C .out = out,
#define OUT_F .out = (sub *)F (out),
#else
#define OUT_C
#define OUT_F
#endif
#ifdef HAS_ctl
#define CTL_C .ctl = ctl,
#define CTL_F .ctl = (sub *)F (ctl),
#define CTP .ctp = F (ctp),
#else
#define CTL_C
#define CTL_F
#define CTP
#endif
#ifdef HAS_evt
#define EVT_C .evt = evt, .rst = rst,
#define EVT_F .evt = (sub *)F (evt), .rst = (sub *)F (rst),
#else
#define EVT_C
#define EVT_F
#endif

#define SIZES .nq = SIZE_nq, .nu = SIZE_nu, .nx = SIZE_nx, .nv = SIZE_nv, .ny = SIZE_ny,\
              .nlam = SIZE_nlam
#define IN_C .kin = kin, PRJ_C CON_C CMD_C CLO_C OUT_C CTL_C EVT_C
#define IN_F .kin = (sub *)F (kin), PRJ_F CON_F CMD_F CLO_F OUT_F CTL_F EVT_F

extern const emitted JOIN (emitted, _, SCENE);
const emitted JOIN (emitted, _, SCENE) = {
  .s = { SIZES, .rhs = rhs, IN_C },
  .audit = { SIZES, .rhs = RHA_C, IN_C },
  .f = { .rhs = (sub *)F (rhs), IN_F },
  .faudit = { .rhs = RHA_F, IN_F },
  .npar = SIZE_npar, .nctl = SIZE_nctl, .nxk = SIZE_nxk,
  .par = F (par), .pre = F (pre), CTP
};
