/* gsmbp/partition.h: the array p of the routines of loops.h, dimension
 * 24 + 8*nu + 10*nq + 7*nlam + 2*nlam*nu, laid out as P of gs_complete_state.
 *
 * Numbers of speeds are stored counted from 1, as whole numbers in double. */
#ifndef GSMBP_PARTITION_H
#define GSMBP_PARTITION_H

#include "gsmbp/real.h"

/* the first entries of p */
enum
{
  GS_WAY = 0,       /* 0 no partition, 1 for speeds alone (Kane with dependent speeds), 2 for
                       coordinates and speeds (coordinate partitioning), 3 as 2, but it is kept as
                       long as it may be */
  GS_DEPENDENT,     /* the number of dependent speeds, < 0 if no set has been chosen */
  GS_RANK,          /* the largest rank that the constraints had so far */
  GS_STEPS,         /* the memory of gs_follow_pivot: the number of steps, */
  GS_TIMES,         /* then three times, each followed by the least pivot */
  GS_DISPLACED = 10,/* the number of dependent displacements */
  GS_NONHOLONOMIC,  /* 1 if there are constraints on speeds alone, else 0 */
  GS_PIVOT,         /* the least pivot of the Jacobian now */
  GS_LARGEST,       /* ... and the largest so far */
  GS_PARTS          /* here the arrays begin */
};

/* the arrays behind them */
typedef struct
{
  gs_real *order;  /* nu: the numbers of the speeds, dependent ones first */
  gs_real *counts; /* nq + nu: 0 for each coordinate and speed that is completed, else 1 */
  gs_real *size;   /* nlam: the largest lengths that the rows of hc had so far */
  gs_real *displ;  /* nu: the numbers of the speeds, those with dependent displacements first */
  gs_real *rows;   /* nlam: 0 for each constraint on speeds alone, else 1: set by the caller */
  gs_real *phi;    /* nlam, from here on workspace: what con writes, */
  gs_real *phit;   /* nlam */
  gs_real *gam;    /* nlam + 10 */
  gs_real *hc;     /* (nlam,nu): the Jacobian */
  gs_real *y;      /* (nlam,nu): its factorization by gs_qr_pivoted or gs_qr_columns, with */
  gs_real *beta;   /* nu */
  gs_real *piv;    /* nu */
  gs_real *siz;    /* nu + nlam */
  gs_real *rhs;    /* nlam: a right side */
  gs_real *du;     /* nu: displacements, followed by */
  gs_real *dq;     /* nq: those of the coordinates */
  gs_real *before; /* nq + nu: the state before gs_check_constraints moved it */
  gs_real *between; /* nq: a position between steps */
  gs_real *path;   /* (nq,6): positions and rates of the last three steps, for gs_follow_pivot */
} gs_partition;

static inline gs_partition
gs_partition_of (int nq, int nu, int nlam, gs_real *p)
{
  gs_partition a;
  a.order = p + GS_PARTS;
  a.counts = a.order + nu;
  a.size = a.counts + nq + nu;
  a.displ = a.size + nlam;
  a.rows = a.displ + nu;
  a.phi = a.rows + nlam;
  a.phit = a.phi + nlam;
  a.gam = a.phit + nlam;
  a.hc = a.gam + nlam + 10;
  a.y = a.hc + nlam * nu;
  a.beta = a.y + nlam * nu;
  a.piv = a.beta + nu;
  a.siz = a.piv + nu;
  a.rhs = a.siz + nu + nlam;
  a.du = a.rhs + nlam;
  a.dq = a.du + nu;
  a.before = a.dq + nq;
  a.between = a.before + nq + nu;
  a.path = a.between + nq;
  return a;
}

#endif
