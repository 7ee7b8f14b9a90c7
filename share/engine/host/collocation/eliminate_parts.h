/* host/collocation/eliminate_parts.h: a program without the unknowns that equations determine. */
#ifndef GSMBP_HOST_COLLOCATION_ELIMINATE_PARTS_H
#define GSMBP_HOST_COLLOCATION_ELIMINATE_PARTS_H

#include "host/collocation/eliminate.h"
#include "host/collocation/room.h"

/* how many unknowns a block may have */
enum { GS_MOST_DETERMINED = 64 };

/* The others of a block are unknowns that its equations have besides its own; after them those
 * that second derivatives have together with its own. A pair is a row that is left with a block of
 * whose unknowns it has some. */
typedef struct
{
  gs_room room;
  const gs_nlp *p;
  gs_determined d;
  int n, m, jacobian, hessian;    /* of the program that is left: */
  int *column, *row;              /* of p, -1: taken out */
  int *owner;                     /* n of p: the block of an unknown, -1: none, */
  int *ruler;                     /* m of p: of an equation */
  int *others, *begins, *seconds; /* the others; of a block: where they begin, where those of second
                                     derivatives do (count + 1, count) */
  int npairs, *pair_row, *pair_block;
  int *jac_place, *hess_place;    /* of the entries of p: in others, or the pair; hess (2,): in the
                                     block, or behind it in others; -1: the entry stays */
  int nseconds, *second_list, *second_block; /* entries of the Hessian with own unknowns, by
                                                blocks */
  /* where it was evaluated last */
  int known, good, has_gradient;
  double *x, *z;                  /* there: n, n of p */
  double *g, *jac, *hess, *gradient, *lambda, *pairs; /* pairs (size,npairs) */
  gs_real *inverse, *unit;        /* of all blocks, (size,size) each; of one */
  double *slopes, *square, *work; /* (size,others); of one block: (size + its others) squared */
} gs_rest_program;

static inline int
gs_unknown_of (const gs_rest_program *e, int block)
{
  return e->d.unknown + e->d.step_unknown * block;
}
static inline int
gs_equation_of (const gs_rest_program *e, int block)
{
  return e->d.equation + e->d.step_equation * block;
}
/* (size,size) of a block; (size,others) of the derivatives of its unknowns */
static inline gs_real *
gs_inverse_of (const gs_rest_program *e, int block)
{
  return e->inverse + e->d.size * e->d.size * block;
}
static inline double *
gs_slopes_of (const gs_rest_program *e, int block)
{
  return e->slopes + e->d.size * e->begins[block];
}

/* laid out; 0: it cannot be */
int gs_rest_lay (gs_rest_program *e);
/* the places of the entries that are left */
void gs_rest_places (const gs_rest_program *e, int part, int *rows, int *columns);

/* at the point x: whether there is something */
int gs_rest_move (gs_rest_program *e, const double *x);
/* lambda (m of p) of the equations that are taken out from those of the others, for factor times
 * the goal: 0: there are none */
int gs_rest_multipliers (gs_rest_program *e, double factor);
/* as evaluate of gs_nlp */
int gs_rest_evaluate (void *data, int part, const double *x, double factor, const double *lambda,
                      double *out);

#endif
