/* host/linear/trim_parts.h: what the files of equilibria and steady motions share. */
#ifndef GSMBP_HOST_TRIM_PARTS_H
#define GSMBP_HOST_TRIM_PARTS_H

#include "host/linear/linear_parts.h"

/* equations of rest, with unknowns that hosts have named */
typedef struct
{
  gs_work *w;
  const gs_trim_asked *asked;
  gs_rest rest;
  gs_real *z, *size, *usual;      /* unknowns: the guess, their sizes; equations: theirs */
  int *own, *rows, *fixed;        /* of rest */
  int nrunning, *running;         /* coordinates that run, */
  gs_free_velocities free;        /* what moves independently, of a steady motion */
} gs_trim_problem;

/* 0, or the verdict */
int gs_trim_begin (gs_work *w, const gs_trim_asked *asked, gs_real *x, gs_real *v,
                   gs_trim_problem *p);

/* for it: unknowns, rows and coordinates that run, of a steady motion */
int gs_steady_begin (gs_trim_problem *p);

/* row (equations): what the usual sizes make of them at z: J, its derivatives */
void gs_trim_rows (const gs_trim_problem *p, const gs_real *jacobian, gs_real *row);

/* how far z is from a solution at the time t: at most 1, it is one; beside (equations): of each
 * equation f; these may be null */
gs_real gs_trim_worst (const gs_trim_problem *p, const gs_real *z, gs_real t, gs_real tolerance,
                       gs_real *beside, gs_real *f);

/* z by one method after the other, which becomes way */
void gs_trim_solve (gs_trim_problem *p, gs_real *z, int *way);

/* the solution z where it does not stand alone: the one with as many unknowns as can be left as in
 * the guess; basis (unknowns, columns): what can be moved; how many columns */
int gs_trim_free (const gs_trim_problem *p, const gs_real *z, gs_real *basis);
void gs_trim_nearest (gs_trim_problem *p, int columns, const gs_real *basis, gs_real *z);

/* what equation i is and its unit; which state, or nx + input, unknown k is */
void gs_trim_equation (const gs_trim_problem *p, int i, gs_writer *name);
void gs_trim_unit (const gs_trim_problem *p, int i, gs_writer *unit);
int gs_trim_unknown (const gs_trim_problem *p, int k);

/* refusals: with all speeds zero a constraint moves; a derivative is not finite; none was found: z
 * is the best of it; a device cannot be there; it is steady at one instant alone */
int gs_trim_check_rest (const gs_trim_problem *p);
int gs_trim_check_derivatives (const gs_trim_problem *p, const gs_real *z);
int gs_trim_refuse (const gs_trim_problem *p, const gs_real *z);
int gs_trim_check_margins (const gs_trim_problem *p);
int gs_trim_check_later (gs_trim_problem *p, const gs_real *z, char *warning, int size);

#endif
