/* see emitted.h */
#include "emitted.h"

#define JOIN3(a, b, c) a##b##c
#define JOIN(a, b, c) JOIN3 (a, b, c)
#define F(routine) JOIN (SCENE, _, routine##_)

extern void F (par) (gs_real *);
extern void F (pre) (const gs_real *, gs_real *, int *);
extern void F (rhs) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,
                     int *);
extern void F (rha) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,
                     int *);
extern void F (kin) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *);

static int
rhs (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  int info = 0;
  F (rhs) (&t, x, v, cst, xd, &info);
  return info;
}

#ifdef HAS_rha
static int
rha (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *xd)
{
  int info = 0;
  F (rha) (&t, x, v, cst, xd, &info);
  return info;
}
#endif

static void
kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  F (kin) (&t, q, u, cst, qdot);
}

#ifdef HAS_prj
extern void F (prj) (const gs_real *, gs_real *, const gs_real *, gs_real *, int *);
static int
prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  int info = 0;
  F (prj) (&t, x, cst, res, &info);
  return info;
}
#endif

#ifdef HAS_con
extern void F (con) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,
                     gs_real *, gs_real *, const int *, gs_real *, int *);
static int
con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi, gs_real *phit,
     gs_real *hc, int ldh, gs_real *gam)
{
  int info = 0;
  F (con) (&t, q, u, cst, phi, phit, hc, &ldh, gam, &info);
  return info;
}
#endif

#ifdef HAS_cmd
extern void F (cmd) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,
                     gs_real *, int *);
static int
cmd (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst, gs_real *v, gs_real *xid)
{
  int info = 0;
  F (cmd) (&t, qj, xi, cst, v, xid, &info);
  return info;
}
#endif

#ifdef HAS_clo
extern void F (clo) (const gs_real *, gs_real *, const gs_real *, gs_real *, int *);
static int
clo (gs_real t, gs_real *qj, const gs_real *cst, gs_real *res)
{
  int info = 0;
  F (clo) (&t, qj, cst, res, &info);
  return info;
}
#endif

#ifdef HAS_out
extern void F (out) (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,
                     int *);
static int
out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  int info = 0;
  F (out) (&t, x, v, cst, y, &info);
  return info;
}
#endif

#ifdef HAS_ctl
extern void F (ctl) (const int *, const gs_real *, const gs_real *, gs_real *, const gs_real *,
                     gs_real *);
extern void F (ctp) (const gs_real *, gs_real *, gs_real *);
static void
ctl (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  F (ctl) (&k, &t, y, xk, cst, v);
}
#endif

#ifdef HAS_evt
extern void F (evt) (const gs_real *, const gs_real *, const gs_real *, const int *,
                     const gs_real *, gs_real *);
extern void F (rst) (const gs_real *, gs_real *, gs_real *, int *, const int *, const gs_real *,
                     int *);
static void
evt (gs_real t, const gs_real *x, const gs_real *v, const int *mode, const gs_real *cst,
     gs_real *gv)
{
  F (evt) (&t, x, v, mode, cst, gv);
}

static int
rst (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst)
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
