/* host/fortran_scene.h: subroutines of a scene emitted in Fortran as routines of a gs_scene.
 *
 * GS_FORTRAN_rhs (name, pendulum_rhs_) defines the function name, static, a gs_rhs that calls the
 * subroutine pendulum_rhs_ with its arguments by address; so do the others for the members of
 * gs_scene with their names. The rates of an audit, rha, are a gs_rhs, too, margins of
 * devices, mar, a gs_mar of host/start.h. vin calls the user's GSVIN; its data is a
 * gs_fortran_inputs of that header. */
#ifndef GSMBP_HOST_FORTRAN_SCENE_H
#define GSMBP_HOST_FORTRAN_SCENE_H

#include "host/start.h"

#define GS_FORTRAN_rhs(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   int *);                                                                         \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)  \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, y, &info);                                                                 \
    return info;                                                                                   \
  }
#define GS_FORTRAN_rha(name, sub) GS_FORTRAN_rhs (name, sub)
#define GS_FORTRAN_out(name, sub) GS_FORTRAN_rhs (name, sub)

#define GS_FORTRAN_prj(name, sub)                                                                  \
  extern void sub (const gs_real *, gs_real *, const gs_real *, gs_real *, int *);                 \
  static int name (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)                        \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, cst, res, &info);                                                                  \
    return info;                                                                                   \
  }
#define GS_FORTRAN_clo(name, sub) GS_FORTRAN_prj (name, sub)

#define GS_FORTRAN_con(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   gs_real *, gs_real *, const int *, gs_real *, int *);                           \
  static int name (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,              \
                   gs_real *phi, gs_real *phit, gs_real *hc, int ldh, gs_real *gam)                \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, q, u, cst, phi, phit, hc, &ldh, gam, &info);                                          \
    return info;                                                                                   \
  }

#define GS_FORTRAN_kin(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *); \
  static void name (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,             \
                    gs_real *qdot)                                                                 \
  {                                                                                                \
    sub (&t, q, u, cst, qdot);                                                                     \
  }

#define GS_FORTRAN_cmd(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   gs_real *, int *);                                                              \
  static int name (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst,            \
                   gs_real *v, gs_real *xid)                                                       \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, qj, xi, cst, v, xid, &info);                                                          \
    return info;                                                                                   \
  }

#define GS_FORTRAN_ctl(name, sub)                                                                  \
  extern void sub (const int *, const gs_real *, const gs_real *, gs_real *, const gs_real *,      \
                   gs_real *);                                                                     \
  static void name (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst,           \
                    gs_real *v)                                                                    \
  {                                                                                                \
    sub (&k, &t, y, xk, cst, v);                                                                   \
  }

#define GS_FORTRAN_ctp(name, sub)                                                                  \
  extern void sub (const gs_real *, gs_real *, gs_real *);                                         \
  static void name (const gs_real *cst, gs_real *period, gs_real *delay)                           \
  {                                                                                                \
    sub (cst, period, delay);                                                                      \
  }

#define GS_FORTRAN_swi(name, sub)                                                                  \
  extern void sub (const gs_real *, gs_real *);                                                    \
  static void name (const gs_real *cst, gs_real *ts) { sub (cst, ts); }

#define GS_FORTRAN_evt(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const int *,                 \
                   const gs_real *, gs_real *);                                                    \
  static void name (gs_real t, const gs_real *x, const gs_real *v, const int *mode,                \
                    const gs_real *cst, gs_real *gv)                                               \
  {                                                                                                \
    sub (&t, x, v, mode, cst, gv);                                                                 \
  }

#define GS_FORTRAN_mar(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   gs_real *);                                                                     \
  static void name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *g, \
                    gs_real *size)                                                                 \
  {                                                                                                \
    sub (&t, x, v, cst, g, size);                                                                  \
  }

#define GS_FORTRAN_rst(name, sub)                                                                  \
  extern void sub (const gs_real *, gs_real *, gs_real *, int *, const int *, const gs_real *,     \
                   int *);                                                                         \
  static int name (gs_real t, gs_real *x, gs_real *v, int *mode, int k, const gs_real *cst)        \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, mode, &k, cst, &info);                                                          \
    return info;                                                                                   \
  }

#define GS_FORTRAN_mas(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, gs_real *, const int *);     \
  static void name (gs_real t, const gs_real *q, const gs_real *cst, gs_real *m, int ldm)          \
  {                                                                                                \
    sub (&t, q, cst, m, &ldm);                                                                     \
  }

#define GS_FORTRAN_lin(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const gs_real *, const gs_real *, gs_real *, gs_real *, gs_real *,              \
                   const int *);                                                                   \
  static void name (gs_real t, const gs_real *q, const gs_real *u, const gs_real *ud,              \
                    const gs_real *v, const gs_real *cst, gs_real *m, gs_real *b, gs_real *c,      \
                    int ld)                                                                        \
  {                                                                                                \
    sub (&t, q, u, ud, v, cst, m, b, c, &ld);                                                      \
  }

#define GS_FORTRAN_bia(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const gs_real *, gs_real *);                                                    \
  static void name (gs_real t, const gs_real *q, const gs_real *u, const gs_real *v,               \
                    const gs_real *cst, gs_real *b)                                                \
  {                                                                                                \
    sub (&t, q, u, v, cst, b);                                                                     \
  }

#define GS_FORTRAN_jac(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   const int *, gs_real *, const int *, gs_real *, const int *, gs_real *,         \
                   const int *, int *);                                                            \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *a,  \
                   int lda, gs_real *b, int ldb, gs_real *c, int ldc, gs_real *d, int ldd)         \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, a, &lda, b, &ldb, c, &ldc, d, &ldd, &info);                                \
    return info;                                                                                   \
  }

#define GS_FORTRAN_gad(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, gs_real *);                  \
  static void name (gs_real t, const gs_real *qj, const gs_real *cst, gs_real *g)                  \
  {                                                                                                \
    sub (&t, qj, cst, g);                                                                          \
  }

#define GS_FORTRAN_stk(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   gs_real *, gs_real *, int *);                                                   \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *ud, \
                   gs_real *lam, gs_real *hold)                                                    \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, ud, lam, hold, &info);                                                     \
    return info;                                                                                   \
  }

#define GS_FORTRAN_hld(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   const int *, gs_real *, gs_real *, gs_real *);                                  \
  static void name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst,             \
                    gs_real *row, int ldr, gs_real *s, gs_real *sd, gs_real *prm)                  \
  {                                                                                                \
    sub (&t, x, v, cst, row, &ldr, s, sd, prm);                                                    \
  }

#define GS_FORTRAN_pnt(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, gs_real *, gs_real *);       \
  static void name (gs_real t, const gs_real *q, const gs_real *cst, gs_real *place,               \
                    gs_real *axes)                                                                 \
  {                                                                                                \
    sub (&t, q, cst, place, axes);                                                                 \
  }

#define GS_FORTRAN_jpt(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   gs_real *);                                                                     \
  static void name (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst,             \
                    gs_real *jac, gs_real *gam)                                                    \
  {                                                                                                \
    sub (&t, q, u, cst, jac, gam);                                                                 \
  }

#define GS_FORTRAN_rhp(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   const int *, gs_real *, const int *, gs_real *, const int *, gs_real *, int *); \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p,  \
                   int ldp, gs_real *a, int lda, gs_real *b, int ldb, gs_real *xd)                 \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, p, &ldp, a, &lda, b, &ldb, xd, &info);                                     \
    return info;                                                                                   \
  }

#define GS_FORTRAN_adj(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const gs_real *, gs_real *, gs_real *, gs_real *, int *);                       \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst,              \
                   const gs_real *l, gs_real *xb, gs_real *vb, gs_real *pb)                        \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, l, xb, vb, pb, &info);                                                     \
    return info;                                                                                   \
  }

#define GS_FORTRAN_tan(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, gs_real *, const int *,      \
                   gs_real *, const int *);                                                        \
  static void name (gs_real t, const gs_real *x, const gs_real *cst, gs_real *d, int ldd,          \
                    gs_real *v, int ldv)                                                           \
  {                                                                                                \
    sub (&t, x, cst, d, &ldd, v, &ldv);                                                            \
  }
#define GS_FORTRAN_cop(name, sub) GS_FORTRAN_tan (name, sub)

#define GS_FORTRAN_oup(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   const int *, int *);                                                            \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *p,  \
                   int ldp)                                                                        \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, p, &ldp, &info);                                                           \
    return info;                                                                                   \
  }

#define GS_FORTRAN_ctd(name, sub)                                                                  \
  extern void sub (const int *, const gs_real *, const gs_real *, const gs_real *,                 \
                   const gs_real *, const gs_real *, gs_real *);                                   \
  static void name (int k, gs_real t, const gs_real *y, const gs_real *xk, const gs_real *cst,     \
                    const gs_real *v, gs_real *d)                                                  \
  {                                                                                                \
    sub (&k, &t, y, xk, cst, v, d);                                                                \
  }

#define GS_FORTRAN_evp(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const int *, const int *,    \
                   const gs_real *, gs_real *, int *);                                             \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const int *mode, int k,          \
                   const gs_real *cst, gs_real *g)                                                 \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, mode, &k, cst, g, &info);                                                       \
    return info;                                                                                   \
  }

#define GS_FORTRAN_rsp(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const int *, const int *,    \
                   const gs_real *, const int *, const gs_real *, gs_real *, int *);               \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const int *mode, int k,          \
                   const gs_real *ua, const int *ma, const gs_real *cst, gs_real *r)               \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, mode, &k, ua, ma, cst, r, &info);                                               \
    return info;                                                                                   \
  }

#define GS_FORTRAN_urp(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const int *, gs_real *, gs_real *, int *);                                      \
  static int name (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, int k,       \
                   gs_real *r, gs_real *xa)                                                        \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, x, v, cst, &k, r, xa, &info);                                                         \
    return info;                                                                                   \
  }

#define GS_FORTRAN_cmp(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *, gs_real *,  \
                   const int *, gs_real *, const int *, int *);                                    \
  static int name (gs_real t, const gs_real *qj, const gs_real *xi, const gs_real *cst,            \
                   gs_real *vx, int ldvx, gs_real *vp, int ldvp)                                   \
  {                                                                                                \
    int info = 0;                                                                                  \
    sub (&t, qj, xi, cst, vx, &ldvx, vp, &ldvp, &info);                                            \
    return info;                                                                                   \
  }

#define GS_FORTRAN_dae(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const gs_real *, const gs_real *, gs_real *);                                   \
  static void name (gs_real t, const gs_real *x, const gs_real *ud, const gs_real *lam,            \
                    const gs_real *v, const gs_real *cst, gs_real *f)                              \
  {                                                                                                \
    sub (&t, x, ud, lam, v, cst, f);                                                               \
  }
#define GS_FORTRAN_daj(name, sub) GS_FORTRAN_dae (name, sub)

#define GS_FORTRAN_dah(name, sub)                                                                  \
  extern void sub (const gs_real *, const gs_real *, const gs_real *, const gs_real *,             \
                   const gs_real *, const gs_real *, const gs_real *, gs_real *);                  \
  static void name (gs_real t, const gs_real *x, const gs_real *ud, const gs_real *lam,            \
                    const gs_real *v, const gs_real *cst, const gs_real *w, gs_real *h)            \
  {                                                                                                \
    sub (&t, x, ud, lam, v, cst, w, h);                                                            \
  }

#define GS_FORTRAN_vin(name, sub)                                                                  \
  extern void sub (const gs_real *, const int *, const gs_real *, const int *, const int *,        \
                   const int *, const gs_real *, const gs_real *, gs_real *, int *);               \
  static int name (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)  \
  {                                                                                                \
    const gs_fortran_inputs *d = (const gs_fortran_inputs *) data;                                 \
    int info = 0;                                                                                  \
    sub (&t, &side, x, &nx, &nv, d->ip, d->rp, d->cst, v, &info);                                  \
    return info;                                                                                   \
  }
#endif
