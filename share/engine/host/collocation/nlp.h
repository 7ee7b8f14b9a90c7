/* host/collocation/nlp.h: a sparse non-linear program, and how it is solved. Numbers count from 0;
 * the arrays are the caller's. */
#ifndef GSMBP_HOST_COLLOCATION_NLP_H
#define GSMBP_HOST_COLLOCATION_NLP_H

#include <math.h>
#include <stdio.h>

#include "host/collocation/program.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  int n, m;                               /* unknowns, equations */
  const double *x0, *low, *high;          /* n: where to begin, bounds */
  const double *glow, *ghigh;             /* m: bounds of the equations */
  int jacobian, hessian;                  /* entries; hessian -1: it is estimated */
  const int *jac_rows, *jac_columns, *hess_rows, *hess_columns; /* hess: lower triangle */
  void *data;
  /* a part (program.h) at the point z; 0: it has none there */
  int (*evaluate) (void *data, int part, const double *z, double factor, const double *lambda,
                   double *out);
} gs_nlp;

/* an option of the solver: text, or a number, whole or not */
typedef struct
{
  const char *name, *text;
  double number;
  int whole;
} gs_nlp_word;

typedef struct
{
  double tolerance, evaluations, seconds; /* at most so many points, so long on the clock */
  int iterations, nwords;
  const gs_nlp_word *words;
  int (*ask) (void *asked); /* before each evaluation; not 0: it ends; null: never */
  void *asked;
} gs_nlp_options;

typedef struct
{
  double *x, *zl, *zu;      /* n: the point, multipliers of its bounds */
  double *g, *lambda;       /* m: equations, their multipliers */
  double goal;
  int status, iterations;   /* of the solver */
  int solved, limit, infeasible; /* why it ended: limit: of points, iterations, time */
  int interrupted;          /* by ask: x is the last iterate, multipliers are NaN */
  char ended[200];          /* in words */
} gs_nlp_result;

/* The result; 0; 1: no memory; 2: an option or the problem is refused, which ended says. */
typedef int gs_nlp_solver (const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r);

/* ended, where Ipopt reached a limit of its options */
static inline void
gs_nlp_say_limit (const gs_nlp_options *o, gs_nlp_result *r)
{
  if (o->seconds < INFINITY)
    snprintf (r->ended, sizeof r->ended, "stopped at the limit of %g evaluations or %g s",
              o->evaluations, o->seconds);
  else
    snprintf (r->ended, sizeof r->ended, "stopped at the limit of %g evaluations",
              o->evaluations);
}

/* by Ipopt (host/ipopt), NLopt (host/nlopt), in libraries of their own */
gs_nlp_solver gs_ipopt, gs_nlopt;

/* the time on a clock [s] */
double gs_wall_clock (void);

#ifdef __cplusplus
}
#endif
#endif
