/* host/linear/linear.h: exact linear models of a scene about a state, for all hosts.
 *
 * Numbers of states, coordinates, speeds and outputs count from 0; matrices lie by columns without
 * gaps. Shapes, units: gsmbp/scene.h. The state must be on the constraints (host/start.h). */
#ifndef GSMBP_HOST_LINEAR_H
#define GSMBP_HOST_LINEAR_H

#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

/* what became of a calculation */
enum
{
  GS_LINEAR_FOUND,
  GS_LINEAR_NO_MEMORY,
  GS_LINEAR_ABSENT,     /* the scene has no subroutine of the name routine */
  GS_LINEAR_FAILED,     /* it ended with info */
  GS_LINEAR_DERIVATIVE, /* the rate of state row has no finite derivative by column: a state, or
                           nx + an input */
  GS_LINEAR_REFUSED     /* text says why */
};

typedef struct
{
  int verdict, info, row, column;
  const char *routine;   /* also where constraints were dependent (info 2) and all was found */
  char text[2400];
} gs_linear_told;

/* where, and about what */
typedef struct
{
  gs_real t;
  const gs_real *cst, *x, *v; /* x: nx, v: nv */
} gs_linear_place;

/* which states of a linear model are independent */
enum { GS_REDUCED_NAMED, GS_REDUCED_AUTO, GS_REDUCED_NONE };

typedef struct
{
  int reduced, nwanted;
  const int *wanted;      /* nwanted states, where reduced is GS_REDUCED_NAMED */
  int running, ndrop;     /* drop what runs; or these */
  const int *drop;        /* coordinates */
} gs_linear_asked;

/* dx' = A dx + B dv, dy = C dx + D dv, of n states and m outputs; where the scene has no outputs
 * they are its states. The arrays are the caller's, of the largest size: */
typedef struct
{
  int n, m, ndropped;
  int *independent;       /* nx: which states they are, */
  int *dropped;           /* nx: which are dropped, */
  int *seen;              /* m: which outputs are left */
  gs_real *a, *b, *c, *d; /* (nx,nx), (nx,nv), (ny or nx,nx), (ny or nx,nv) */
  gs_real *tangent;       /* (nx,nx): dx of the independent deviations */
  int row, column;        /* an output without a finite derivative, by what; -1: none */
} gs_linear_model;

/* the verdict */
int gs_linear (const gs_description *d, const gs_linear_place *at, const gs_linear_asked *asked,
               gs_linear_model *model, gs_linear_told *told);

#ifdef __cplusplus
}
#endif
#endif
