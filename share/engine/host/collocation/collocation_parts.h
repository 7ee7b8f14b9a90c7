/* host/collocation/collocation_parts.h: an optimal motion on its way. */
#ifndef GSMBP_HOST_COLLOCATION_COLLOCATION_PARTS_H
#define GSMBP_HOST_COLLOCATION_COLLOCATION_PARTS_H

#include "host/assemble/assemble.h"
#include "host/collocation/collocation.h"
#include "host/collocation/program_parts.h"

/* where a mesh begins: columns of unknowns of a point at n times from 0 to 1, the durations of
 * phases, the parameters */
typedef struct
{
  int n;
  const double *t, *z;             /* n, (nz,n) */
  const double *duration, *unknown;
} gs_guess;

/* a mesh that was solved; all arrays are its own */
typedef struct gs_solution
{
  struct gs_solution *before;      /* of the same search */
  gs_room room;
  gs_motion_problem p;
  gs_mesh mesh;
  gs_program *c;
  gs_program_sizes size;
  double *low, *high, *glow, *ghigh;
  gs_nlp_result r;
  double *t, *at;                  /* of the points: [s]; from 0 to 1 */
  double *errors, error;           /* of the intervals; the largest one */
  int stopped;                     /* why the search ends here */
} gs_solution;

typedef struct
{
  const gs_description *d;
  const gs_motion_problem *p;
  const gs_motion_options *o;
  gs_room room;
  double began;                    /* on the clock [s] */
  const double *hint;              /* nx: the end, where it is free a guess */
  gs_solution *solutions;          /* the newest first */
  int bad;                         /* as gs_collocate */
  char refused[2400];
  char told[2400];                 /* what is known of the end, if no solution is found */
} gs_search;

/* what is found besides a solution; the room of a search has it */
typedef struct
{
  int nmeshes, nactive, nswitches, narcs;
  gs_mesh_report *meshes;
  gs_active_bound *active;
  double *switches;
  gs_singular_arc *arcs;
} gs_found;

static inline int
gs_is_closed (const gs_scene *s)
{
  return s->nlam > 0 && s->con;
}
static inline int
gs_search_bad (gs_search *w)
{
  if (w->room.full && ! w->bad)
    w->bad = 1;
  return w->bad;
}
/* [s] that are left; infinite: there is no end */
double gs_time_left (const gs_search *w);

/* the problem on a mesh from a guess; null: what w->bad says */
gs_solution *gs_solve_mesh (gs_search *w, const gs_motion_problem *p, const gs_mesh *mesh,
                            const gs_guess *guess);
gs_guess gs_guess_of (const gs_solution *s);
/* the ends of a closed chain, of the problem p and where the search begins; w->bad: refused */
void gs_take_ends (gs_search *w, gs_motion_problem *p, const gs_motion_guess *g);
/* x (nx) with the coordinates held (nq, of 1) as they are, onto the constraints at t, on the branch
 * of x; 0: there is none, or w->bad */
int gs_close_chain (gs_search *w, const gs_motion_guess *g, double t, const int *held, double *x,
                    gs_assembly *found);
gs_guess gs_first_guess (gs_search *w, const gs_motion_guess *given);

/* the unknowns of the point q */
static inline const double *
gs_point (const gs_solution *s, int q)
{
  return s->r.x + s->c->nz * q;
}
/* the duration of a phase, of all of them */
static inline double
gs_phase_duration (const gs_solution *s, int p)
{
  return s->r.x[gs_duration_column (s->c, p)];
}
double gs_whole_duration (const gs_solution *s);

/* its errors; the intervals of its mesh that have too large ones cut */
void gs_mesh_errors (gs_search *w, gs_solution *s);
gs_mesh gs_finer_mesh (gs_search *w, const gs_solution *s);

/* the polynomials (3) of a rule that are 1 at one stage and 0 at the others, at the place x, and
 * their integrals from 0 */
void gs_stage_basis (const gs_collocation_rule *r, double x, double *values, double *integrals);

/* derivatives of the goal by the states at all points: (nx,points) */
void gs_costates (const gs_solution *s, double *costates);

int gs_active_bounds (gs_search *w, const gs_solution *s, gs_active_bound **list);

/* arcs, with weights for the form that makes them smooth, which smooth (as many) has */
int gs_singular_arcs (gs_search *w, gs_solution *s, gs_singular_arc **arcs);
gs_smooth_arc *gs_smooth_arcs (gs_search *w, const gs_solution *s, int n, gs_singular_arc *arcs);
/* the width of input j: its range and a thousandth of its largest magnitude; 1 where it stays 0 */
double gs_input_width (const gs_solution *s, int j);

/* solved once more with the times at which inputs jump as unknowns: another solution with them in
 * switches (n); null: it stays as it is; stopped: why the search ends */
gs_solution *gs_polish (gs_search *w, const gs_solution *s, double **switches, int *n,
                        int *stopped);

/* all of it as the caller gets it */
void gs_take_motion (gs_search *w, gs_solution *s, const gs_motion_guess *given,
                     const gs_found *found, gs_motion *r);

/* why it ended, in words */
void gs_say_end (const gs_search *w, const gs_solution *s, gs_motion *r);

#endif
