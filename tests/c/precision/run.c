/* A run of an emitted scene (C for any precision) from its start, inputs zero: prints the info of
 * gs_integrate, the steps and the states at the end. Made by tests/sh/precision.sh: SCENE, the
 * prefix of the names; METHOD, 4 or 8; WAY, how loops are kept; RTOL; start.h: initial and
 * nominal. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/integrate.h"
#include "gsmbp/plan.h"
#include "start.h"

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2 (a, b)
#define OF(name) JOIN (SCENE, name)

extern const gs_scene OF (_scene);
extern void OF (_par) (gs_real *);
extern int OF (_pre) (const gs_real *, gs_real *);

enum { MOST = 1000 };

int
main (void)
{
  const gs_scene *s = &OF (_scene);
  const int nx = s->nx;
  static gs_real par[MOST], cst[MOST], x0[MOST], atol[MOST], x[MOST], v[MOST];
  gs_real end = 1, ropt[3] = { METHOD == 4 ? GS_R (1e-3) : 0, (gs_real)RTOL, 0 };
  int iopt[6] = { METHOD, s->nlam > 0 ? WAY : 1, s->nlam > 0, 0, 0, 0 };
  const gs_plan plan = { .s = s, .nx = nx, .on_the_way = 8 * s->nctl, .events = 1000 };
  int *ip = calloc ((size_t)gs_wholes (&plan), sizeof *ip);
  gs_real *rp = calloc ((size_t)gs_reals (&plan), sizeof *rp), res;
  OF (_par) (par);
  int info = OF (_pre) (par, cst);
  gs_lay (&plan, ip, rp);
  if (info == 0)
    info = gs_due_from (s, 0, cst, ip, rp);
  for (int k = 0; k < nx; k++)
    {
      x0[k] = (gs_real)initial[k];
      atol[k] = (gs_real)RTOL * (gs_real)nominal[k];
    }
  if (info == 0 && s->prj)
    info = s->prj (0, x0, cst, &res);
  gs_integration run = { .nx = nx, .x0 = x0, .nt = 1, .tout = &end, .iopt = iopt, .ropt = ropt,
                 .atol = atol, .ip = ip, .rp = rp, .cst = cst, .xout = x, .ldx = nx, .vout = v,
                 .ldv = s->nv > 1 ? s->nv : 1 };
  run.lw = gs_room (s, nx, 0);
  run.w = calloc ((size_t)run.lw, sizeof *run.w);
  if (info == 0)
    info = gs_integrate (s, &run);
  printf ("%d %d", info, run.istat[GS_N_STEPS]);
  for (int k = 0; k < nx; k++)
    printf (" %.9e", (double)x[k]);
  printf ("\n");
  free (run.w);
  free (ip);
  free (rp);
  return 0;
}
