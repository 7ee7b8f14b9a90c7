/* host/optimize/optimize.h: designs for all hosts: values of free variables that make a goal small
 * and meet demands. The host says what goal and demands read of its load cases at given values; the
 * measures of it, solvers, choices from lists, prices and conflicts are here.
 *
 * Numbers count from 0; matrices lie by columns. */
#ifndef GSMBP_HOST_OPTIMIZE_OPTIMIZE_H
#define GSMBP_HOST_OPTIMIZE_OPTIMIZE_H

#include "gsmbp/options.h"
#include "host/collocation/nlp.h"

#ifdef __cplusplus
extern "C" {
#endif

/* GS_WORD_start, ...; a row that is a function has GS_WORD_FUNCTION */
#define GS_DESIGN_WORD(name) GS_WORD_##name,
enum { GS_DESIGN_WORDS (GS_DESIGN_WORD) GS_WORD_FUNCTION };
#undef GS_DESIGN_WORD
#define GS_DESIGN_SOLVER(name) GS_SOLVER_##name,
enum { GS_DESIGN_SOLVERS (GS_DESIGN_SOLVER) GS_SOLVERS };
#undef GS_DESIGN_SOLVER
#define GS_DESIGN_CHOICE(name) GS_CHOICES_##name,
enum { GS_DESIGN_CHOICES (GS_DESIGN_CHOICE) GS_CHOICES };
#undef GS_DESIGN_CHOICE

/* a variable: where it begins, bounds; a list to choose from, rising, nlist 0: none; own: 1: it is
 * none of the scene's, something must depend on it */
typedef struct
{
  const char *name;
  double start, low, high;
  int own, nlist;
  const double *list;
} gs_free;

/* a goal or a demand: its word, of a goal the factor, of a demand relation ('<', '>', '=') and
 * bound; its load cases (of functions, values, masses none); how it is written */
typedef struct
{
  int word, relation, ncases;
  double factor, bound;
  const int *cases;
  const char *text;
} gs_design_row;

/* the times of a load case, nt, weights of an integral over them; derivatives of both by the
 * variables, (nt,nfree) (null: none) */
typedef struct
{
  int nt;
  const double *t, *w, *dt, *dw;
} gs_case_times;

/* what a row reads of a load case, a number for each time, or the numbers that it is; derivatives
 * by the variables, (n,nfree) */
typedef struct
{
  int n;
  const double *y, *slopes;
} gs_series;

/* what the host finds at some values: times of each load case; a series for each load case of each
 * row, those of the goal first (one for a row without any). Its arrays live until the next ones. */
typedef struct
{
  gs_case_times *times;
  gs_series *series;
  int *rough;       /* nfree: 1: derivatives by it are differences */
  int functions;    /* 1: those of functions are */
  char trouble[800]; /* why there is nothing */
} gs_design_values;

enum { GS_VALUES_FOUND, GS_VALUES_FAILED, GS_VALUES_INTERRUPTED, GS_VALUES_LATE };

typedef struct
{
  const char *name; /* of the scene */
  int nfree, ngoal, ndemands, ncases;
  const gs_free *free;
  const gs_design_row *rows; /* goal, demands */
  const double *bands;       /* ncases: of settling times */
  const char *why;           /* why derivatives are differences, "": nothing is known */
  void *data;
  /* at the values p (nfree), for the rows that are not 0 in rows, with derivatives by the
   * variables that are not 0 in free: GS_VALUES_FOUND, ... */
  int (*evaluate) (void *data, const double *p, const int *rows, const int *free,
                   gs_design_values *v);
} gs_design;

typedef struct
{
  int solver, choices, nodes, iterations;
  int nstarts;
  const double *starts; /* (nfree,nstarts): further values to start from */
  double tolerance, evaluations, seconds; /* of each start */
  double timeout;                         /* of all together [s]; 0: none */
  gs_nlp_solver *ipopt, *nlopt;           /* null: not installed */
} gs_design_options;

/* what holds the goal back: bound (0) or demand (1) */
typedef struct
{
  int demand;
  double value, bound, multiplier;
  char text[400];
} gs_design_active;

/* one end of a search */
typedef struct
{
  double *values, J, violation;
  int solved;
  char ended[400];
} gs_design_end;

enum
{
  GS_DESIGN_FOUND,
  GS_DESIGN_REFUSED, /* ended says why */
  GS_DESIGN_FAILED,  /* evaluate failed where it begins; ended: its trouble */
  GS_DESIGN_STOPPED  /* before anything was found */
};

/* what is found: arrays of its own, freed by gs_design_free */
typedef struct
{
  int verdict;
  int info;               /* 0 solved, 1 a limit, 2 a contradiction, 3 ended elsewhere */
  int stopped;            /* GS_INTERRUPTED, GS_TIMED_OUT of failures.h, or 0 */
  int solved, limit, solver, evaluations, functions;
  int iterations;         /* -1: not known */
  double J, violation, optimality;
  double *values;         /* nfree */
  int *rough, *idle;      /* nfree: derivatives are differences; nothing depends on it */
  int nactive, nends, nconflict;
  gs_design_active *active;
  gs_design_end *ends;
  int *conflict;          /* numbers of demands */
  int branched, choices_limit, choices_stopped;
  int problems;           /* that were solved */
  double combinations, open;
  char ended[4800], derivatives[1600];
  char *report;
  void *room;
} gs_design_result;

/* 0; 1: no memory */
int gs_optimize (const gs_design *d, const gs_design_options *o, gs_design_result *r);
void gs_design_free (gs_design_result *r);

/* weights (n) of an integral over rising times: of the cubic spline that has no knot in the second
 * time and the last but one, if none is negative, else of straight lines; slope (n, null: not
 * wanted): their derivatives by the last time. 0; 1: no memory */
int gs_integral_weights (int n, const double *t, double *w, double *slope);

/* the values at which f is to be known for its derivative at a value of a variable, five at most:
 * by differences of order 4 within its bounds; factors: of f there, less f at the first one */
int gs_difference_points (const gs_free *variable, double at, double *points, double *factors);

#ifdef __cplusplus
}
#endif
#endif
