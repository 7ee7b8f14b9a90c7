/* The table that the scene's part of a module hands to the generic part:
   sizes from the JSON and the addresses of the emitted subroutines, a null
   pointer where one was not emitted. */
#ifndef GSMBP_SCENE_H
#define GSMBP_SCENE_H
#ifdef __cplusplus
extern "C" {
#endif
typedef void (*gsmbp_sub) (void);

/* The sizes, as the JSON's "dimensions" name them, and the subroutines by the ends of their names:
   the one place where they are listed. gsmbp__compile.m writes an initializer by name for each. */
#define GSMBP_SIZES(X)                                                                             \
  X (nq) X (nu) X (nv) X (nx) X (ny) X (ne) X (nlam) X (ncst) X (npar) X (nqj) X (nact) X (na)     \
  X (nmar) X (nxk) X (nctl) X (nev) X (nmode) X (nsm)
#define GSMBP_SUBROUTINES(X)                                                                       \
  X (par) X (pre) X (kin) X (inv) X (mas) X (bia) X (fwd) X (con) X (inl) X (lin) X (rhs) X (prj)  \
  X (jac) X (out) X (cmd) X (clo) X (ene) X (acc) X (ske) X (acd) X (tan) X (cmx) X (ctl) X (evt)  \
  X (rst) X (rha) X (ctp) X (inv_v) X (mas_v) X (bia_v) X (fwd_v) X (rhs_v) X (reg) X (mar)

#define GSMBP_SIZE(name) int name;
#define GSMBP_SUBROUTINE(name) gsmbp_sub name;
typedef struct
{
  const char *name;
  const char *left_out; /* of the requests, and why: "\nrequest: reason\n..." */
  GSMBP_SIZES (GSMBP_SIZE)
  int np;            /* points of the skeleton */
  int nbase;         /* base parameters */
  GSMBP_SUBROUTINES (GSMBP_SUBROUTINE)
  gsmbp_sub vin;     /* the user's inputs, GSVIN */
  int nsets;         /* of Euler parameters */
  const int *sets;   /* ... four numbers of coordinates each */
} gsmbp_scene;
extern const gsmbp_scene gsmbp_the_scene;
#ifdef __cplusplus
}
#endif
#endif
