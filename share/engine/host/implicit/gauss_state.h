/* What the steps of method gauss in coordinates and momenta keep (gauss_momenta.c). */
#ifndef GS_HOST_GAUSS_STATE_H
#define GS_HOST_GAUSS_STATE_H
#include "gauss_momenta.h"
#include "rows.h"

enum { TURNS = 100, BEFORE = 3 };

struct gs_momenta
{
  const gauss_rule *rule;
  int n, m;                     /* speeds, constraints */
  const double *size;           /* usual sizes of the states */
  double *numbers;              /* all that follow */
  double *p, *lost_q, *lost_p;  /* the momenta, what rounding took from them and the coordinates */
  double *u, *f, *old;          /* of the stages: speeds, rates of momenta; one of both before */
  double *x, *pi, *trial;       /* a state, the momenta of a stage, another state */
  double *mass, *masses, *B, *C, *C0, *bias, *zero;   /* MASSES: factors, at the end of the step */
  double *force, *past;         /* multipliers, those of steps before */
  double *phi, *phit, *gamma, *rows, *turned;   /* constraints, their gradients */
  double *before;               /* coordinates, momenta, what they lost, before the step */
  int *turning;                 /* coordinates of which whole turns change nothing */
  gs_rows gram;                 /* rows M^-1 rows' at the start */
  double large;                 /* the largest momentum of usual speeds, at the start */
  int known, remembered;        /* is there a step before; how many sets of multipliers */
  int turns;
};
#endif
