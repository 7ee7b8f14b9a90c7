/* host/assemble/assemble_parts.h: what the files of this folder share. */
#ifndef GSMBP_HOST_ASSEMBLE_PARTS_H
#define GSMBP_HOST_ASSEMBLE_PARTS_H

#include "host/assemble/assemble.h"
#include "host/linear/linear_parts.h"

/* ---------------------------------------------------------------------------------------- poses */

/* the constraints on positions at a state: values, their Jacobian by the speeds; q' = k*u. The rows
 * on speeds are left out */
typedef struct
{
  int n;
  gs_real *phi, *h, *k;     /* n; (n,nu); (nq,nu) */
  gs_real *rate, *rows;     /* nlam: of all rows, the rate that speeds do not make; (nlam,nu) */
  gs_real *all, *gam, *one; /* nlam, nlam, nu: workspace */
} gs_pose;

/* 0, or the verdict */
int gs_pose_begin (gs_work *w, gs_pose *p);
void gs_pose_at (const gs_work *w, const gs_real *x, gs_pose *p);

/* which speeds move none of the coordinates of the mask */
void gs_speeds_beside (const gs_work *w, const gs_pose *p, const int *coordinates, int *speeds);

/* the change of the speeds of the mask, of least length, that makes rows (n,nu) times it gap (n):
 * step (nu), 0 for the others */
void gs_least_step (gs_work *w, int n, const gs_real *rows, const int *speeds, const gs_real *gap,
                    gs_real *step);

/* move (nq): Newton's step onto the constraints by the speeds of the mask; the largest of these */
gs_real gs_newton_move (gs_work *w, const gs_pose *p, const int *speeds, gs_real *move);

/* the largest part of a displacement, by nominal magnitudes */
double gs_extent (const gs_work *w, const gs_real *move);

/* y: x (nx) with its coordinates displaced, Euler parameters of length 1 */
void gs_displace (const gs_work *w, const gs_real *x, const gs_real *move, gs_real *y);
void gs_unit_orientations (const gs_description *d, gs_real *x);

gs_real gs_largest_modulus (int n, const gs_real *a);

/* how many rows of a (m,n), and of b (k,n) below it, are independent */
int gs_rank_of (gs_work *w, int m, int n, const gs_real *a, int k, const gs_real *b);

/* the rows of a (m,n) of the mask; how many */
int gs_rows_of (int m, int n, const gs_real *a, const int *mask, gs_real *part);

/* ------------------------------------------------------------------------------------- branches */

/* x: the loops closed near the guess with no coordinate held, then the held ones moved from there
 * to their values in x in small steps. The part of this way that the branch covers, 1: all of it;
 * NaN where no closed pose is near the guess or where the held coordinates depend on each other */
double gs_follow_branch (gs_work *w, const int *held, gs_real *x);

/* one guess closed; why not, in words: closed says whether x is on the constraints */
typedef struct
{
  int anywhere;   /* 1: on any branch */
  int listed;     /* 1: messages do not point to other branches */
  char unclosed[1200], elsewhere[600];
} gs_closing;

void gs_close_guess (gs_work *w, const gs_assembly_asked *a, gs_real *x, gs_closing *c);

#endif
