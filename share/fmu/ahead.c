/* ahead.c: a step of co-simulation that ends behind the communication point: its polynomial, from
 * which the states at the next points come without further steps while no input changes.
 *
 * The time of the instance is always the communication point; where an input changes there the
 * step behind it is as if it had never been. No step goes beyond a sample, a switch, an event or
 * the end of the experiment, so that nothing happens between the two. */
#include "fmu.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"
#include "gsmbp/partition.h"
#include "plan.h"

#include <math.h>

/* steps go this many communication steps beyond at most: what happens in short times is seen */
enum { GSF_FARTHEST = 20 };

void
gsf_forget (gsf_instance *a)
{
  a->d[GSF_AHEAD_H] = 0;
  a->i[GSF_QUIET] = 0;
}

double
gsf_beyond (const gsf_instance *a, double t, double h)
{
  const double far = GSF_FARTHEST * h, left = a->d[GSF_T1] - t;
  if ((a->m->nin > 0 && a->i[GSF_QUIET] < 2) || ! (left > 0))
    return 0;
  return far < left ? far : left;
}

void
gsf_keep (gsf_instance *a, const gs_dense *e)
{
  const int nx = a->m->scene->nx;
  a->d[GSF_AHEAD_H] = e->h;
  if (! (e->h > 0))
    return;
  a->d[GSF_AHEAD_T] = e->t;
  gs_copy (nx, e->x, a->ahead);
  gs_copy (nx, e->xn, a->ahead + nx);
  gs_copy (9 * nx, e->f, a->ahead + 2 * nx);
}

/* but for rounding, as samples are met */
int
gsf_reaches (const gsf_instance *a, double t)
{
  const double end = a->d[GSF_AHEAD_T] + a->d[GSF_AHEAD_H];
  return a->d[GSF_AHEAD_H] > 0 && t <= end + 8 * gs_epsilon () * fabs (end);
}

/* xout onto the constraints, as the ends of steps are */
static int
moved (gsf_instance *a, double t)
{
  const gs_scene *s = a->m->scene;
  const double *x = a->ahead, *xn = x + s->nx;
  double jump[3] = { 0 }, rstat[GS_MEASURED] = { 0 };
  int istat[GS_COUNTED] = { 0 };
  gs_partition_none (s->nq, s->nu, s->nlam, a->iopt, a->w);
  a->w[GS_WAY] = 0;
  gs_largest_move (s->nq, s->nu, x, xn, a->d[GSF_TOLERANCE], a->atol, jump);
  return gs_move_onto (s, t, a->xout, a->iopt, jump, a->cst, a->w, istat, rstat);
}

int
gsf_look (gsf_instance *a, double t)
{
  const int nx = a->m->scene->nx;
  const double h = a->d[GSF_AHEAD_H], *x = a->ahead, *xn = x + nx;
  gs_dense_at (nx, h, (t - a->d[GSF_AHEAD_T]) / h, x, xn, x + 2 * nx, a->xout);
  if (t < a->d[GSF_AHEAD_T] + h)
    return moved (a, t) == 0;
  gs_copy (nx, xn, a->xout);
  return 1;
}
