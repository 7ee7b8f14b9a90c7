/* A run by GSSIM in Fortran and in C, of the same scene: what the Fortran calls hands over to the
 * routines of the scene in C, or the scene in C to those of an emitted Fortran scene. */
#ifndef BRIDGE_H
#define BRIDGE_H

#include "compare.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

typedef void sub (void);

/* the EXTERNAL arguments of GSSIM */
typedef struct
{
  sub *rhs, *prj, *con, *kin, *cmd, *clo, *vin, *out, *ctl, *evt, *rst;
} externals;

extern const externals through;        /* to the routines of the scene bridged */
extern const gs_scene *bridged;

enum { MOST_X = 40, MOST_T = 200, MOST_IP = 400, MOST_RP = 20000, MOST_W = 20000 };

/* a run; the C runs it as it stands, the Fortran a copy */
typedef struct
{
  const gs_scene *s;
  const externals *f;
  gs_run run;
  int iopt[12], ip[MOST_IP];
  double ropt[3], atol[MOST_X], x0[MOST_X], tout[MOST_T], tbrk[20], rp[MOST_RP], cst[1000];
  double xout[MOST_X * MOST_T], vout[MOST_X * MOST_T], w[MOST_W];
  int nip, nrp; /* places of ip and rp that are used */
  int info;
} test;

/* a run of method 8 until tend with nt outputs, inputs 0, no plans; f: null for `through` */
void make (test *a, const gs_scene *s, const externals *f, double tend, int nt);

/* the polynomial that begins at ip[place]: np pieces of k coefficients, breaks and coefficients */
void polynomial (test *a, int place, int nc, int np, int k, const double *brk, const double *coef);

/* the plan of the events: kinds and inputs of ne ports, nr records */
void events (test *a, int ne, const int *kind, const int *input, int nr);

/* the plan of the samples: nc devices with periods and delays, held outputs of each and their
 * inputs, memory nxk, np places on the way, ns records */
void samples (test *a, int nc, const double *period, const double *delay, const int *held,
              const int *anew, const int *input, int nxk, const double *memory, int np, int ns);

/* both runs, compared; info of the C in a->info, its results in a. One line `ok what` */
void compare (test *a, const char *what, int info);

/* seconds of the run in Fortran, or in C */
double seconds (const test *a, int in_c);

#endif
