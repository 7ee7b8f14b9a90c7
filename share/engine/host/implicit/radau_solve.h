/* The linear systems of radau.c: (ROOT/H*I - J) X = B, real and complex; columns one after
   the other.

   States whose rows and columns of J are short are eliminated first, along lists that are made once
   for the places of J that are not zero (the rates of coordinates, currents, pressures); what is
   left is dense: LU with partial pivoting. */
#ifndef GSMBP_RADAU_SOLVE_H
#define GSMBP_RADAU_SOLVE_H
#include <complex.h>
#include <stddef.h>

typedef struct
{
  int n, sparse;           /* states, those that are eliminated along lists */
  int *order;              /* N: the states in the order of elimination */
  int *rows, *row_from;    /* of each of those the places below it, */
  int *columns, *column_from;   /* ... and to the right */
  char *places;            /* N x N: which places of J were not zero so far */
  int plain;               /* 1: everything is dense, the lists led to a small pivot */
} radau_order;

/* 0: there is no memory */
extern int gsmbp_new_order (radau_order *o, int n);
extern void gsmbp_free_order (radau_order *o);
/* ORDERED: J in the order of elimination, which is made anew where J has other places */
extern void gsmbp_take_order (radau_order *o, const double *J, double *ordered);

/* The factors in LU, the rows that changed places in PIVOT; J as gsmbp_take_order gave it.  0; 1:
   singular; 2: a pivot of the lists is small, the order is to be taken again. */
enum { SINGULAR = 1, SMALL_PIVOT };
extern int gsmbp_real_factors (radau_order *o, double shift, const double *J, double *lu,
                               int *pivot);
extern int gsmbp_complex_factors (radau_order *o, double complex shift, const double *J,
                                  double complex *lu, int *pivot);
/* WORK: N numbers */
extern void gsmbp_real_solve (const radau_order *o, const double *lu, const int *pivot, double *x,
                              double *work);
extern void gsmbp_complex_solve (const radau_order *o, const double complex *lu, const int *pivot,
                                 double complex *x, double complex *work);
/* A dense matrix of order N, overwritten by its factors; 0, SINGULAR */
extern int gsmbp_dense_factors (int n, double *a, int *pivot);
extern void gsmbp_dense_solve (int n, const double *lu, const int *pivot, double *x);
#endif
