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
  GS_LINEAR_DERIVATIVE, /* one is not finite: text says which, */
  GS_LINEAR_MARGIN,     /* a device cannot be there, */
  GS_LINEAR_REFUSED     /* or what else is wrong */
};

typedef struct
{
  int verdict, info;
  const char *routine;   /* also where constraints were dependent (info 2) and all was found */
  char text[2400];
} gs_linear_told;

/* where, and names and units for messages */
typedef struct
{
  gs_real t;
  const gs_real *cst, *x, *v;     /* x: nx, v: nv */
  const char *const *inputs;      /* nv */
  const char *const *units;       /* nx, of the states, */
  const char *const *constraints; /* nlam, of the constraints, "" where it is not known */
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

/* T (nx,n) and the n independent states of the deviations that the constraints allow; wanted: those
 * that are wanted, null: they are chosen by the Jacobian. The verdict */
int gs_linear_tangent (const gs_description *d, const gs_linear_place *at, const int *wanted,
                       int nwanted, gs_real *tangent, int *independent, int *n,
                       gs_linear_told *told);

/* ------------------------------------------------------------------ equilibria, steady motions */

typedef struct
{
  int nhold, ninputs, nspeeds;
  const int *hold;      /* nhold states that stay as they are */
  const int *inputs;    /* ninputs that are free, */
  const int *speeds;    /* nspeeds states that are, of a steady motion */
  int steady, nrunning;
  const int *running;   /* (2,nrunning): coordinates that run on, where steady is 1, their speeds */
  int nmodes;
  const int *modes;     /* nmodes inputs that are none: they cannot help */
  int margins;          /* 1: no device may be where its laws do not hold */
  double tolerance;
  const double *par;    /* npar: shown in messages */
} gs_trim_asked;

enum { GS_TRIM_NEWTON, GS_TRIM_LEVENBERG, GS_TRIM_TRANSIENT };

/* the arrays are the caller's */
typedef struct
{
  gs_real *x, *v;       /* nx, nv */
  double residual;      /* the largest rate or constraint, in usual sizes */
  int way;              /* by which it was found */
  int *running;         /* nq: 1 where a coordinate runs */
  int *indifferent;     /* nx + nv: 1 where a state or a free input can be moved without effect */
  char warning[400];    /* what holds at the time alone; "": nothing */
} gs_trim_found;

/* an equilibrium, or a steady motion, near the guess at->x, at->v: the verdict */
int gs_trim (const gs_description *d, const gs_linear_place *at, const gs_trim_asked *asked,
             gs_trim_found *found, gs_linear_told *told);

/* ----------------------------------------------------------------------------------- vibrations */

typedef struct
{
  int steady;             /* 1: the state is first moved to where nothing but what is held moves at
                             other than constant speed */
  int nheld;
  const int *held;        /* (2,nheld): coordinates that keep their motion, their speeds */
} gs_vibrations_asked;

/* small vibrations about a state; the arrays are the caller's, of the largest size */
typedef struct
{
  int n, nfelt;
  int *independent;       /* nx: n states */
  int *felt;              /* nx: nfelt of these n, on which something depends */
  gs_real *x;             /* nx: the state */
  gs_real *a;             /* (n,n): the rates of the n states by them, in nominal magnitudes */
  gs_real *square;        /* (nfelt,nfelt): rows and columns of it, whose eigenvalues count */
  gs_real *tangent;       /* (nx,n): dx of the independent deviations */
  char doubt[300];        /* why the state is no equilibrium and no steady motion; "": it is one */
} gs_vibrations;

int gs_vibrate (const gs_description *d, const gs_linear_place *at,
                const gs_vibrations_asked *asked, gs_vibrations *r, gs_linear_told *told);

/* the modes; complex numbers are pairs, as in C and Fortran */
typedef struct
{
  int n, nreal, rigid;    /* modes that oscillate, eigenvalues that are real, that are zero */
  gs_real *eigenvalues;   /* (2,n): by rising frequency, imaginary parts above 0 */
  gs_real *frequency, *damping;
  gs_real *shapes;        /* (2,nq,n), of a scene without coordinates (2,nx,n) */
  gs_real *real;          /* nreal, ascending */
} gs_modes;

/* modes of the eigenvalues e (2,nfelt) and eigenvectors v (2,nfelt,nfelt) of r->square, which a
 * host has from its library; e is changed. The verdict */
int gs_modes_of (const gs_description *d, const gs_linear_place *at, const gs_vibrations *r,
                 gs_real *e, const gs_real *v, gs_modes *modes, gs_linear_told *told);

/* the modes at some speeds, one behind another */
typedef struct
{
  int rows, nspeeds, total; /* of a shape; speeds; modes in all */
  const int *many;          /* nspeeds: how many modes each speed has */
  const gs_real *frequency; /* total */
  const gs_real *shapes;    /* (2,rows,total) */
} gs_campbell;

/* row (total): which row of a diagram each mode is of, from 0: that of the most alike shape at the
 * speeds before; rows rise in frequency where they begin. How many rows there are; -1: no memory */
int gs_follow_modes (const gs_campbell *c, int *row);

/* -------------------------------------------------------------- equilibria and their parameters */

typedef struct
{
  int nhold, ninputs;
  const int *hold;          /* nhold states that keep their value */
  const int *inputs;        /* ninputs that follow */
  const char *const *names; /* nsp: of the parameters of RHP */
} gs_slopes_asked;

/* by the parameters of RHP; the arrays are the caller's */
typedef struct
{
  int outputs;              /* 1: dy is known */
  gs_real *dx, *dv, *dy;    /* (nx,nsp), (nv,nsp), (ny,nsp) */
} gs_rest_slopes;

/* how the equilibrium at->x, at->v changes with parameters, by one linear system: the verdict */
int gs_slopes_of_rest (const gs_description *d, const gs_linear_place *at,
                       const gs_slopes_asked *asked, gs_rest_slopes *found, gs_linear_told *told);

/* differences of order 6 by a parameter p along equilibria that change by dx (nx): at p + steps (6)
 * the factors (6) */
void gs_family_steps (int nx, const double *nominal, double p, const double *dx, double *steps,
                      double *factors);

/* the arrays are the caller's */
typedef struct
{
  double *poles;              /* (2,n); NaN of a multiple eigenvalue */
  double *frequency, *damping; /* n: of its absolute value and damping ratio */
} gs_pole_slopes;

/* how the eigenvalues e (2,n) of a matrix with the right and left eigenvectors v, w (2,n,n),
 * w' a = e w', change where the matrix changes by da (n,n) */
void gs_slopes_of_poles (int n, const double *e, const double *v, const double *w,
                         const double *da, gs_pole_slopes *found);

#ifdef __cplusplus
}
#endif
#endif
