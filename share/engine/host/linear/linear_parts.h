/* host/linear/linear_parts.h: what the files of this folder share. */
#ifndef GSMBP_HOST_LINEAR_PARTS_H
#define GSMBP_HOST_LINEAR_PARTS_H

#include "gsmbp/arith.h"
#include "host/linear/linear.h"
#include "host/text.h"

typedef struct gs_block gs_block;

/* a calculation on its way: the scene, the time, memory that is freed at its end */
typedef struct
{
  const gs_description *d;
  const gs_scene *s;
  gs_real t;
  const gs_real *cst;
  const gs_linear_place *at;
  gs_linear_told *told;
  gs_block *blocks; /* the newest first */
} gs_work;

/* ----------------------------------------------------------------------------- memory, verdicts */

gs_work gs_work_begin (const gs_description *d, const gs_linear_place *at, gs_linear_told *told);
/* frees all; the verdict */
int gs_work_end (gs_work *w);

/* room for n numbers, zeros; null: there is none, which is the verdict then */
gs_real *gs_numbers (gs_work *w, int n);
int *gs_places (gs_work *w, int n);
/* frees what is newer than the block */
void gs_work_back (gs_work *w, gs_block *to);

/* the verdict; the text that says why, to be written */
int gs_work_failed (gs_work *w, int verdict, const char *routine, int info);
gs_writer gs_work_refused (gs_work *w, int verdict);
/* the derivative of the row by the column, a state or nx + an input, is not finite */
int gs_no_derivative (gs_work *w, const char *of, const char *row, int column);
int gs_no_derivative_by (gs_work *w, const char *of, const char *row, const char *by);

/* ------------------------------------------------------------------------------------- matrices */

/* c (m,n) := a (m,k) * b (k,n) */
void gs_product (int m, int k, int n, const gs_real *a, const gs_real *b, gs_real *c);

/* row i of a (m,n) as row j of b (mb,n) */
void gs_put_row (int n, const gs_real *a, int m, int i, gs_real *b, int mb, int j);

/* an orthonormal basis (n,columns) of what a (m,n) takes to zero, singular values at most tol: how
 * many columns */
int gs_null_space (gs_work *w, int m, int n, const gs_real *a, gs_real tol, gs_real *basis);

/* of a (m,n): how many singular values are above tol; the largest one; the least one beside that */
int gs_rank (gs_work *w, int m, int n, const gs_real *a, gs_real tol);
gs_real gs_norm (gs_work *w, int m, int n, const gs_real *a);
gs_real gs_condition (gs_work *w, int n, const gs_real *a);

/* inverse (n,m) of a (m,n) by singular values above tol times the largest */
void gs_pseudo_inverse (gs_work *w, int m, int n, const gs_real *a, gs_real tol, gs_real *inverse);

/* order (n) of the columns of a (m,n), the next one that of which most is left; how many are
 * independent to tol */
int gs_column_order (gs_work *w, int m, int n, const gs_real *a, gs_real tol, int *order);

/* whole numbers, ascending; is k among them */
void gs_sort_places (int n, int *list);
int gs_is_among (int k, int n, const int *list);

/* ------------------------------------------------------------------------ routines of the scene */

/* the routines; 0, or the verdict. b, c, d may be null */
int gs_rates_there (gs_work *w, gs_real t, const gs_real *x, const gs_real *v, gs_real *xd);
int gs_jacobian_there (gs_work *w, const gs_real *x, const gs_real *v, gs_real *a, gs_real *b,
                       gs_real *c, gs_real *d);

/* RHP: the rates by parameters, states and inputs, and the rates */
int gs_slopes_there (gs_work *w, const gs_real *x, const gs_real *v, gs_real *p, gs_real *a,
                     gs_real *b, gs_real *xd);

/* the first entry of a (m,n) that is not finite, an infinite one before others; 0: none */
int gs_first_not_finite (int m, int n, const gs_real *a, int *row, int *column);

/* the constraints at a state, those of Euler parameters first, differentiated: by coordinates
 * p (np,nq), by speeds h (nh,nu), of loops alone, and with their rates by states k (nk,nx); after
 * them rows for coordinates and their speeds that are held */
typedef struct
{
  int np, nh, nk;
  gs_real *p, *h, *k;
} gs_constraint_rows;

/* held (2,nheld): a coordinate and its speed each */
int gs_constraints_there (gs_work *w, const gs_real *x, int nheld, const int *held,
                          gs_constraint_rows *rows);

/* --------------------------------------------------------------------------- independent states */

/* t (nx,n), own (n): the deviations that the constraints allow at the state x; each column changes
 * one of the independent states own. wanted: states that are wanted as independent ones, null: they
 * are chosen by the Jacobian */
int gs_loop_tangent (gs_work *w, const gs_real *x, const int *wanted, int nwanted, int nheld,
                     const int *held, gs_real *tangent, int *own, int *n);

/* the same for the n states own: 1, or 0 where they do not determine the motion as well as least
 * says; left: how many are free */
int gs_tangent_of (gs_work *w, const gs_constraint_rows *rows, int n, const int *own, gs_real least,
                   gs_real *tangent, int *left);

/* coordinates and speeds that move independently at x, so chosen that their accelerations depend on
 * as few coordinates as can be: what may run steadily (of a disc that turns on a plane its spin,
 * not the speed of its centre along a fixed axis); first: speeds that are wanted among them */
typedef struct
{
  int nq, nu, *q, *u;
} gs_free_velocities;

int gs_find_free_velocities (gs_work *w, const gs_real *x, int nfirst, const int *first,
                             gs_free_velocities *f);

/* ---------------------------------------------------------------------------------------- rests */

/* equations of rest: unknowns are states and inputs, zero shall be rates and constraints */
typedef struct
{
  gs_work *w;
  gs_real *x, *v;          /* state and inputs, with the unknowns */
  int nown, ninputs, nrows;
  const int *own, *inputs; /* the unknowns */
  const int *rows;         /* states whose rates vanish */
  const int *fixed;        /* nown + ninputs: 1: stays where it is; null: none does */
  const gs_real *size;     /* nown + ninputs: usual sizes of the unknowns */
  int moves;               /* speeds are not zero: rates of the constraints count */
} gs_rest;

int gs_rest_unknowns (const gs_rest *p);
int gs_rest_equations (const gs_rest *p);
void gs_rest_put (const gs_rest *p, const gs_real *z);

/* the equations f at z and the time t, their derivatives (equations, unknowns), which may be null;
 * NaN where a routine fails */
void gs_rest_at (const gs_rest *p, const gs_real *z, gs_real t, gs_real *f, gs_real *jacobian);

/* Newton's method, damped, from z */
void gs_rest_newton (const gs_rest *p, gs_real *z);

/* the largest part of a step, in usual sizes, that keeps the unknowns within their bounds */
gs_real gs_rest_bound (const gs_rest *p, const gs_real *step);

/* x at the time t with what follows, by the constraints, from its coordinates and speeds f; the
 * coordinates alone, with those held where they are: 0 where the loops do not close */
void gs_follow_rest (gs_work *w, gs_real t, const gs_free_velocities *f, gs_real *x);
int gs_close_rest (gs_work *w, const gs_free_velocities *held, gs_real *x);

/* ------------------------------------------------------------------------------ what is dropped */

/* keep (n): which of the n states own are left where coordinates are dropped, and those that only
 * follow them; a (n,n): the Jacobian of their rates */
int gs_without_states (gs_work *w, const gs_linear_place *at, const gs_linear_asked *asked, int n,
                       const int *own, const gs_real *a, int *keep);

/* ------------------------------------------------------------------------------- what is held */

/* the Jacobian a (nx,nx) of the rates xd (nx) by the states, where efforts of any size hold speeds
 * as they are (held, (2,nheld)): the accelerations that these give are taken out */
int gs_held_rates (gs_work *w, const gs_real *x, const gs_real *v, int nheld, const int *held,
                      gs_real *a, gs_real *xd);

/* the unit of the rate of a state */
void gs_put_rate_unit (const gs_work *w, int state, gs_writer *unit);

#endif
