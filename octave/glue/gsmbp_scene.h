/* The table that the scene's part of a module hands to the generic part:
   sizes from the JSON and the addresses of the emitted subroutines, a null
   pointer where one was not emitted. */
#ifndef GSMBP_SCENE_H
#define GSMBP_SCENE_H
#ifdef __cplusplus
extern "C" {
#endif
typedef void (*gsmbp_sub) (void);
typedef struct
{
  const char *name;
  int nq, nu, nv, nx, ny, ne, nlam, ncst, npar, nqj, nact, na, nmar, nxk,
      nctl, nev, nmode, nsm, np, nbase;
  gsmbp_sub par, pre, kin, inv, mas, bia, fwd, con, inl, lin, rhs, prj, jac,
            out, cmd, clo, ene, acc, ske, acd, tan, cmx, ctl, evt,
            rst, rha, ctp, inv_v, mas_v, bia_v, fwd_v, rhs_v, reg, mar, vin;
  int nsets;         /* of Euler parameters */
  const int *sets;   /* ... four numbers of coordinates each */
} gsmbp_scene;
extern const gsmbp_scene gsmbp_the_scene;
#ifdef __cplusplus
}
#endif
#endif
