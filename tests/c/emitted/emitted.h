/* An emitted scene in Fortran as a scene for the run time in C. tests/sh/c_run_time.sh writes a
 * file for each scene: its name as SCENE, its sizes as SIZE_nq, ..., HAS_prj, ... for the
 * subroutines that it has; then it includes emitted_scene.h. */
#ifndef EMITTED_H
#define EMITTED_H

#include "../bridge.h"

typedef struct
{
  gs_scene s, audit; /* audit: with the two states of an audit */
  externals f, faudit;
  int npar, nctl, nxk;
  void (*par) (gs_real *par);
  void (*pre) (const gs_real *par, gs_real *cst, int *info);
  void (*ctp) (const gs_real *cst, gs_real *period, gs_real *delay);
} emitted;

#endif
