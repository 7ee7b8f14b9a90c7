/* host/optimize/optimize_parts.h: a search on its way: what the files of this folder share. */
#ifndef GSMBP_HOST_OPTIMIZE_PARTS_H
#define GSMBP_HOST_OPTIMIZE_PARTS_H

#include <math.h>

#include "host/collocation/room.h"
#include "host/optimize/optimize.h"
#include "host/text.h"

#define GS_FEASIBLE 1e-6 /* violations below it are none */

static inline void
gs_swap (double *a, double *b)
{
  const double kept = *a;
  *a = *b;
  *b = kept;
}

static inline double
gs_within (double x, double low, double high)
{
  return fmax (fmin (x, high), low);
}

/* the largest modulus of n numbers */
static inline double
gs_largest (int n, const double *x)
{
  double most = 0;
  for (int i = 0; i < n; i++)
    most = fmax (most, fabs (x[i]));
  return most;
}

/* is it of a quantity over the times of load cases? how many series a row has */
static inline int
gs_has_cases (int word)
{
  return word < GS_WORD_value;
}

static inline int
gs_series_of (const gs_design_row *row)
{
  return gs_has_cases (row->word) ? row->ncases : 1;
}

/* what differences and solvers take as the size of a variable */
double gs_scale_of (const gs_free *v);

/* Goal and demands at a point of n unknowns: J and its gradient; m numbers g with their derivatives
 * a (m,n), between low and high; row: the demand of each, -1: of a peak that is a goal; h (n,n):
 * the Gauss-Newton matrix of goals that are squares; size: beside which misses of a number count,
 * where that is known, else 0. Arrays of its own. */
typedef struct
{
  int n, m, there;
  double J, *gJ, *g, *a, *low, *high, *h, *size;
  int *row;
  size_t all;
  double *room;
} gs_point;

/* room for n unknowns and m numbers, zeros; 1: no memory */
int gs_point_size (gs_point *e, int n, int m);
int gs_point_copy (gs_point *to, const gs_point *from);
void gs_point_free (gs_point *e);
/* the largest derivative of number i */
double gs_point_steepest (const gs_point *e, int i);
/* the sizes of its numbers, m; by how much the worst one misses its bounds, beside them */
void gs_point_sizes (const gs_point *e, double *sizes);
double gs_point_violation (const gs_point *e, const double *sizes);
/* does anything at it depend on unknown j? */
int gs_point_moves (const gs_point *e, int j);

/* A measure of a series, of its times as times has them: f, its derivatives F by n variables; band:
 * of the settling time. Word each has none. */
void gs_measure (int word, const gs_series *y, const gs_case_times *times, double band, int n,
                 double *f, double *F);

/* how a solver ended, n unknowns z: the point e with sizes */
typedef struct
{
  int n, iterations, evaluations, limit, stopped, solver;
  double *z, *size_g, size_J, violation;
  gs_point e;
  char ended[200], trouble[800];
} gs_nlp_end;

/* a program of few unknowns with all entries of its Jacobian: f fills the point e and returns
 * GS_VALUES_FOUND, ... */
typedef struct
{
  int n, newton;       /* newton: h is its Hessian */
  const double *z0, *low, *high;
  void *of;
  int (*f) (void *of, const double *z, gs_point *e, char *trouble);
} gs_small_program;

/* a search on its way */
typedef struct
{
  const gs_design *d;
  const gs_design_options *o;
  double ends;         /* on the clock; INFINITY: no timeout */
  gs_room room;        /* lives as long as the result */
  gs_design_values v;
  double *naturals;    /* beside which misses of demands whose bound is 0 count; 0: not known */
  int began;           /* they are known */
  double *last_p;      /* nfree: where v is from, for which rows and variables */
  int *last_rows, *last_free, there;
  int failed;          /* why there is no end: GS_DESIGN_REFUSED, ...; */
  char why[2400];
} gs_search_design;

/* a problem: choices made or free between two numbers, some of the demands */
typedef struct
{
  gs_search_design *w;
  int n, npeaks, goals, ndemands; /* goals: 0: none of them */
  int *at;             /* n: the number of each unknown among the variables */
  int *demands;        /* ndemands: their numbers */
  int *rows, *free;    /* 1: of the rows, of the variables */
  double *p, *low, *high, *start, *scale; /* p: nfree; of the unknowns, low, high beside scale */
  double *sizes;       /* npeaks: of the numbers above peaks */
  int *idle;           /* nfree: nothing depends on it where it begins; */
  int *rough, functions; /* derivatives by it, of functions were differences somewhere */
} gs_narrowed;

/* an end: of which problem; values, multipliers */
typedef struct
{
  gs_narrowed q;
  gs_nlp_end r;
  gs_room room;        /* of its own */
  double *p, optimality;
  int solved, nactive;
  gs_design_active *active;
} gs_best;

/* the numbers of goal and demands at z, as f of a gs_small_program; goals with an unknown above all
 * their values */
int gs_assess (void *narrowed, const double *z, gs_point *e, char *trouble);
int gs_count_peaks (const gs_design *d);

/* GS_VALUES_FOUND and the end of a solver; else w->failed and w->why report why there is none */
int gs_solve_small (gs_search_design *w, const gs_small_program *p, int solver,
                    const gs_design_options *o, gs_room *room, gs_nlp_end *r);

/* no memory */
static inline int
gs_search_full (gs_search_design *w)
{
  w->room.full = 1;
  return GS_VALUES_FAILED;
}

/* what ended a search from outside, in words */
const char *gs_stopped_text (int stopped);
/* what is to be said of GS_VALUES_INTERRUPTED, ..., into why and failed; when: null: before the
 * first values were there; 1 */
int gs_search_failed (gs_search_design *w, int values, const char *trouble, const char *when);

/* the problem where choice k is between low and high; start: of all variables (null: their own) */
int gs_narrow (gs_search_design *w, const double *low, const double *high, const double *start,
               gs_room *room, gs_narrowed *q);

/* the best end of a problem from its starts; all of them go to the list of ends */
int gs_solve_design (gs_search_design *w, const double *low, const double *high,
                     const double *start, int solver, gs_best *best, gs_design_result *r, int told);
void gs_best_free (gs_best *b);
/* one more of the list of ends: b, or a null pointer: what has failed from the values p on */
void gs_add_end (gs_search_design *w, gs_design_result *r, const double *p, const gs_best *b);
/* is a to be preferred? b may have no end */
int gs_better (const gs_best *a, const gs_best *b);
int gs_is_end (const gs_best *b);

/* the bounds and demands that hold an end back, their multipliers; what is left of the gradient */
int gs_price (gs_best *b, const double *low, const double *high);

/* all combinations of choices */
int gs_try_choices (gs_search_design *w, gs_best *best, gs_design_result *r);

/* from z to values that meet all demands, met: where they were found; q serves for nothing else
 * then; 1: w->failed reports why */
int gs_meet_demands (gs_narrowed *q, double *z, int *met);

/* a least set of demands that contradict each other, their numbers; values that miss them by least;
 * bounds: of the variables there, in words */
int gs_find_conflict (gs_search_design *w, gs_best *b, int *least, double *near, gs_writer *bounds);

/* the result of an end */
int gs_tell_design (gs_search_design *w, gs_best *b, gs_design_result *r);

#endif
