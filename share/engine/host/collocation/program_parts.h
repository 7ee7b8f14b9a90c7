/* host/collocation/program_parts.h: a program laid out, and where its parts are. */
#ifndef GSMBP_HOST_COLLOCATION_PROGRAM_PARTS_H
#define GSMBP_HOST_COLLOCATION_PROGRAM_PARTS_H

#include <stddef.h>

#include "host/collocation/program.h"
#include "host/collocation/room.h"

/* k * z(row) * z(column) in the goal, half of it on the diagonal; column not after row */
typedef struct
{
  int row, column;
  double k;
} gs_form_entry;

struct gs_program
{
  gs_room room;
  const gs_description *d;
  const gs_scene *s;
  const gs_motion_problem *p;
  gs_collocation_rule rule;
  int intervals, points, first;   /* first: the first point with a stage */
  int nz, nphase, np, nr, nf, n, m;
  int *phase, *phase_of;          /* of a point, of an interval */
  double *h, *begin, *tau;        /* of an interval: length, begin; of a point: its place */
  double *weights;                /* (nphase,points): of the integral, without the durations */
  double *goals, *finals;         /* nf: weights of integrals, of values at the end */
  int *state_of;                  /* nf: the state whose rate a function is; -1: of none */
  int *in_integrand;              /* nz: 1 where the goal integrates it */
  int nform;
  gs_form_entry *form;            /* what else the goal has: the roughness of inputs */
  double form_weight;             /* 1, or 0: it is left out */
  /* where it was evaluated last */
  double *z, *duration, *sums;    /* sums (nx,own*intervals): what a defect has by its duration */
  int known, good, has_f, has_g;
  gs_real *cst, *par, *t, *x, *ud, *lam, *v, *f, *g, *w, *hess;
  double *bare, *speeds;          /* weights of functions and accelerations in a phase, without its
                                     duration */
};

static inline int
gs_left (const gs_program *c, int k)
{
  return c->rule.own * k;
}
static inline int
gs_stage (const gs_program *c, int k, int j)
{
  return c->rule.own * (k + 1) - 2 + j;
}
/* the point of the state that defect s of interval k defines */
static inline int
gs_own_point (const gs_program *c, int k, int s)
{
  return c->rule.own * k + 1 + s;
}
/* equations: residual i and bounded output i of the point q; the first of a defect */
static inline int
gs_residual_row (const gs_program *c, int q, int i)
{
  return c->nr * (q - c->first) + i;
}
static inline int
gs_path_row (const gs_program *c, int q, int i)
{
  return c->nr * (c->points - c->first) + c->p->nbounded * (q - c->first) + i;
}
static inline int
gs_defect_row (const gs_program *c, int k, int s)
{
  return (c->nr + c->p->nbounded) * (c->points - c->first) + c->s->nx * (c->rule.own * k + s);
}
/* unknown l of the functions at the point q: time, unknowns of the point, parameters */
static inline int
gs_column (const gs_program *c, int q, int l)
{
  const int behind = c->points * c->nz;
  if (l == 0)
    return behind + c->phase[q];
  return l <= c->nz ? q * c->nz + l - 1 : behind + c->nphase + l - 1 - c->nz;
}
/* of the phase p, and of the first acceleration and input of a point */
static inline int
gs_duration_column (const gs_program *c, int p)
{
  return c->points * c->nz + p;
}

/* entries one after the other: their values where values is not null, their places where rows is
 * not */
typedef struct
{
  int n, *rows, *columns;
  double *values;
} gs_entries;

static inline void
gs_entry (gs_entries *e, int row, int column, double value)
{
  if (e->values)
    e->values[e->n] = value;
  if (e->rows)
    {
      e->rows[e->n] = row;
      e->columns[e->n] = column;
    }
  e->n++;
}

/* the form that makes the inputs on the arcs smooth: how many entries; form null: counted */
int gs_roughness (const gs_program *c, gs_form_entry *form);

/* an orthonormal basis (n,4) of the cubics at the n places t, at least 4 */
void gs_cubic_basis (int n, const double *t, double *basis);

/* the point z, once; whether there is something */
int gs_program_move (gs_program *c, const double *z);
/* rate of state j at the point q; the weight of the integral there with the durations; the
 * integrand in the unknowns of the point; its derivative by unknown l */
double gs_rate_at (const gs_program *c, int j, int q);
double gs_integral_weight (const gs_program *c, int q);
double gs_own_integrand (const gs_program *c, int q);
double gs_own_slope (const gs_program *c, int l, int q);

void gs_program_functions (gs_program *c);
void gs_program_slopes (gs_program *c);
/* of the functions, from those of the goal and of the equations */
void gs_program_weights (gs_program *c, double factor, const double *lambda);
double gs_program_goal (const gs_program *c);
void gs_program_gradient (const gs_program *c, double *g);
void gs_program_equations (gs_program *c, double *g);
void gs_program_jacobian (gs_program *c, gs_entries *e);
void gs_program_hessian (gs_program *c, double factor, gs_entries *e);

#endif
