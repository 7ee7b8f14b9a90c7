/* host/collocation/program.h: an optimal motion on a mesh as a sparse non-linear program.
 *
 * Unknowns: at each point states, accelerations, multipliers, inputs; then the durations of the
 * phases [s], then the parameters that are unknowns of the scene (gs_description). Equations: at
 * each point of a stage the residuals of the motion, then outputs with bounds; for each stage of
 * each interval X - X(left) - h*T*A*f = 0. All numbers count from 0. Shapes, units: gsmbp/scene.h.
 * Source: Betts, Practical Methods for Optimal Control and Estimation, 2010, ch. 4. */
#ifndef GSMBP_HOST_COLLOCATION_PROGRAM_H
#define GSMBP_HOST_COLLOCATION_PROGRAM_H

#include "host/start.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The collocation on an interval of length 1. Source: Hairer and Wanner, Solving Ordinary
 * Differential Equations II, tables IV.5.6, IV.5.7. */
enum
{
  GS_RADAU_IIA, /* three stages, order 5; */
  GS_LOBATTO    /* Hermite and Simpson: stages at 0, 1/2, 1, order 4 */
};
typedef struct
{
  int order, own; /* own: stages that do not belong to the interval before */
  double c[3];    /* where the stages are */
  double a[3][3]; /* own rows: the weights of the stages; the last one is that of the interval */
} gs_collocation_rule;
gs_collocation_rule gs_collocation_rule_of (int method);

/* each phase from 0 to 1, one row of intervals after the other */
typedef struct
{
  int method, n;
  const int *phase;          /* n */
  const double *begin, *end; /* n */
} gs_mesh;

/* a product of two unknowns of a point in the integrand, b not after a */
typedef struct
{
  int a, b;
  double weight;
} gs_cost_product;

/* a singular arc, from 0 to 1 of the duration: the input is made smooth there, by this weight */
typedef struct
{
  int input;
  double from, until, weight;
} gs_smooth_arc;

/* what is asked for. nz = nx + nu + nlam + nv: the unknowns of a point; the arrays are the caller's
 * and stay as they are while something is made of them */
typedef struct
{
  const gs_real *cst;
  const double *par;                     /* npar */
  const double *x0, *xf;                 /* nx: the ends, NaN where a state is free */
  const double *last_low, *last_high;    /* nx: bounds at the end; infinite: none */
  double t0, duration[2];                /* [s]: when it begins; the least and the largest */
  const double *low, *high;              /* nz */
  const double *unknown_low, *unknown_high; /* nunknown: bounds of the parameters */
  int nbounded;
  const int *bounded;                    /* outputs with bounds: */
  const double *output_low, *output_high;
  /* what is least: a sum of the duration, integrals of outputs, states and outputs at the end, and
     integrals of unknowns of a point and of products of them, with these weights */
  double time_weight;
  const double *output_weights;          /* ny */
  const double *final_states, *final_outputs; /* nx, ny */
  const double *linear;                  /* nz */
  int nproducts;
  const gs_cost_product *products;
  int narcs;
  const gs_smooth_arc *arcs;
  const char *const *inputs, *const *outputs; /* nv, ny: names, for messages */
  const double *held;                    /* (nv,phases): the inputs; null: they are free */
} gs_motion_problem;

typedef struct gs_program gs_program;

/* the program; null: no memory */
gs_program *gs_program_new (const gs_description *d, const gs_motion_problem *p,
                            const gs_mesh *mesh);
void gs_program_free (gs_program *c);

typedef struct
{
  int points, phases, n, m;          /* points of the mesh, unknowns, equations */
  int jacobian, hessian, functions;  /* entries of the derivatives; numbers of dae at all points */
} gs_program_sizes;
gs_program_sizes gs_program_size (const gs_program *c);

/* parts of a program */
enum { GS_GOAL, GS_GRADIENT, GS_EQUATIONS, GS_JACOBIAN, GS_HESSIAN, GS_FUNCTIONS };

/* the numbers of a part at the point z (n) into out: the goal; its gradient (n); the equations (m);
 * the entries of their Jacobian; those of the Hessian of factor times the goal plus lambda (m)
 * times the equations, lower triangle; dae at all points, by columns. 1; 0: it has none there. An
 * entry may stand more than once: its values add up. program: a gs_program */
int gs_program_evaluate (void *program, int part, const double *z, double factor,
                         const double *lambda, double *out);

/* where the entries are */
void gs_program_places (gs_program *c, int part, int *rows, int *columns);

#ifdef __cplusplus
}
#endif
#endif
