/* A run by an implicit method: what the generic part of a module hands to the library of
   gsmbp_cvode.c, gsmbp_radau.c or gsmbp_gauss.c, which is built when its method is first asked for,
   so that nothing else needs SUNDIALS. Everything but the members said below means what the
   argument of GSSIM with that name means. */
#ifndef GSMBP_GLUE_RUN_H
#define GSMBP_GLUE_RUN_H
#include "gsmbp/failures.h"
#include "gsmbp/options.h"
#include "gsmbp/statistics.h"
#include "gsmbp_scene.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct
{
  gsmbp_sub rhs, prj, con, kin, cmd, clo, vin, out, ctl, evt, rst,
      jac, /* a null pointer: difference quotients */
      lin, bia, mas, /* for the momenta of method gauss; null pointers: it takes the states */
      gradients,     /* CON, also where the run does not look after drift; a null pointer */
      tan,           /* for loops in index 2 */
      gsfun, gsinp, gschk, gsjmp, gspst, gspnw, gspbg, gsdue, gsend, gsevn, gsevo, gsevr,
      gsevv, gsusg; /* of the run time */
  int nq, nu, nx, nv, ny, nlam,
      columns;      /* of derivatives that are behind the states, among the NX */
  int resume,       /* 1: goes on where GSSIM ended with INFO = 5 */
      index2,       /* 1: loops in index 2, for Radau alone */
      order,        /* the largest order: of BDF 1 to 5, of Radau 5, 9 or 13; of Gauss 4, 6 or 8 */
      followed;     /* how many states of devices the inputs of a planned motion follow */
  const int *follows;   /* ... and which ones, from 1 on */
  double t0, *x0;
  int nt, nb;
  int switches;   /* the scene switches at this many of the breaks, at most */
  double *tout, *tbrk;
  int *iopt;
  double *ropt, *atol;
  int *ip;
  double *rp, *cst, *xout, *vout;
  int ldx, ldv;
  int *istat; /* (16) evaluations of the Jacobian, (17) Newton iterations, (18) those that did not
                 converge, (19) the flag of CVODE */
  double *rstat, *w;
  char *text;       /* what CVODE said when it failed */
  int length;       /* room in TEXT */
} gsmbp_run;

/* INFO as GSSIM, or 6 if the method failed, 7 if there was no memory */
typedef int gsmbp_run_function (const gsmbp_run *);
extern gsmbp_run_function gsmbp_cvode, gsmbp_radau, gsmbp_gauss;
#ifdef __cplusplus
}
#endif
#endif
