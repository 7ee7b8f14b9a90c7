/* The start of a run on its constraints, as octave/private/gsmbp__start.m has it: for runs of
   ensembles, whose parameters or starts are their own (ensemble.h, sweep_run.c). */
#ifndef GSMBP_GLUE_START_H
#define GSMBP_GLUE_START_H
#include "gsmbp_scene.h"
#include "gsmbp/limits.h"
#include "gsmbp/plan.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

typedef void gs_con_type (const gs_value *t, const gs_value *q, const gs_value *u, gs_value *cst,
                          gs_value *phi, gs_value *phit, gs_value *rows, const int *ld,
                          gs_value *gamma, int *info);
typedef void gs_prj_type (const gs_value *t, gs_value *x, gs_value *cst, gs_value *off, int *info);
typedef void gs_evt_type (const gs_value *t, const gs_value *x, const gs_value *v, const int *mode,
                          gs_value *cst, gs_value *g);
typedef void gs_mar_type (const gs_value *t, const gs_value *x, const gs_value *v, gs_value *cst,
                          gs_value *margins, gs_value *sizes);

/* CON, PRJ, MAR, EVT: null pointers where they were not emitted; NOMINAL: usual sizes of the
   states; CHECK: is the start one that should be closed, and where devices can be?  KIND, MODE: of
   the NE event functions, as gs_events has them; MODE: null pointer where the modes are found. */
typedef struct
{
  const gsmbp_scene *scene;
  gsmbp_sub con, prj, mar;
  const double *nominal;
  int check;
  gsmbp_sub evt;
  int ne;
  const int *kind, *mode;
} gs_start;

/* what A has to know of the planned events E: nothing where no stop is among them */
static void
gs_start_events (gs_start *a, const gs_events *e)
{
  for (int k = 0; k < e->ne; k++)
    if (e->kind[k] == 2)
      a->ne = e->ne;
  a->kind = e->kind;
  a->mode = e->given ? e->mode : NULL;
}

/* how many numbers gs_take_start works with */
static int
gs_start_room (const gsmbp_scene *s)
{
  return 2 * s->nx + s->nlam * (4 + s->nu) + 1;
}

/* how many numbers gs_margins works with */
static int
gs_margins_room (const gsmbp_scene *s)
{
  return s->nx + 2 * s->nsm;
}

/* the larger one; not a number where one is none */
static double
gs_larger (double a, double b)
{
  return isnan (a) || b <= a ? a : b;
}

/* X, with Euler parameters of length one in Y; by how much the length of one is off */
static double
gs_unit_sets (const gsmbp_scene *s, const gs_value *x, gs_value *y)
{
  double most = 0;
  for (int i = 0; i < s->nx; i++)
    y[i] = x[i];
  for (int k = 0; k < s->nsets; k++)
    {
      const int *set = s->sets + 4 * k;
      double sum = 0;
      for (int j = 0; j < 4; j++)
        sum += (double) (x[set[j] - 1] * x[set[j] - 1]);
      for (int j = 0; j < 4; j++)
        y[set[j] - 1] /= sqrt (sum);
      most = gs_larger (most, fabs (sqrt (sum) - 1));
    }
  return most;
}

/* row I of the constraints at X, where the usual sizes make SIZE of it */
static double
gs_row_off (const gs_start *a, int i, const gs_value *x, const gs_value *phi, double size)
{
  const int m = a->scene->nlam;
  const gs_value *u = x + a->scene->nq, *phit = phi + m, *rows = phit + 2 * m;
  double rate = (double) phit[i], fast = 0;
  for (int j = 0; j < a->scene->nu; j++)
    {
      rate += (double) (rows[i + m * j] * u[j]);
      fast += fabs ((double) (rows[i + m * j] * u[j]));
    }
  fast = fmax (fmax (size, fast), fabs ((double) phit[i]));
  return gs_larger (fabs ((double) phi[i]) / size, fabs (rate) / fast);
}

/* what the usual speeds make of row I */
static double
gs_row_size (const gs_start *a, int i, const gs_value *rows)
{
  double sum = 0;
  for (int j = 0; j < a->scene->nu; j++)
    {
      double one = (double) rows[i + a->scene->nlam * j] * a->nominal[a->scene->nq + j];
      sum += one * one;
    }
  return sqrt (sum);
}

/* how far the state X is from its constraints, as octave/private/gsmbp__residuals.m */
static double
gs_start_off (const gs_start *a, gs_value t, const gs_value *x, gs_value *cst, gs_value *w)
{
  const gsmbp_scene *s = a->scene;
  const int m = s->nlam;
  gs_value *phi = w + s->nx, *rows = phi + 3 * m;
  double most = gs_unit_sets (s, x, w), largest = 0;
  int info = 0;
  if (m == 0 || ! a->con)
    return most;
  ((gs_con_type *) a->con) (&t, w, w + s->nq, cst, phi, phi + m, rows, &m, phi + 2 * m, &info);
  if (info != 0 && info != 2)
    return HUGE_VAL;
  for (int i = 0; i < m; i++)
    largest = fmax (largest, gs_row_size (a, i, rows));
  for (int i = 0; i < m; i++)
    {
      double size = fmax (gs_row_size (a, i, rows), 1e-3 * largest);
      most = gs_larger (most, gs_row_off (a, i, w, phi, size > 0 ? size : 1));
    }
  return most;
}

/* how far X is from where it was, in usual sizes */
static double
gs_start_moved (const gs_start *a, const gs_value *x, const gs_value *was)
{
  double most = 0;
  for (int i = 0; i < a->scene->nx; i++)
    most = gs_larger (most, fabs ((double) (x[i] - was[i])) / a->nominal[i]);
  return most;
}

/* margin K of the devices, as gsmbp__margins.m: is there a state beside X, by 1e-6 of a usual size,
   where it holds? */
static int
gs_margin_beside (const gs_start *a, gs_value t, const gs_value *x, const gs_value *v,
                  gs_value *cst, int k, gs_value *w)
{
  const gsmbp_scene *s = a->scene;
  gs_value *y = w, *g = w + s->nx, *size = g + s->nsm;
  for (int j = 0; j < 2 * s->nx; j++)
    {
      int i = j / 2;
      for (int l = 0; l < s->nx; l++)
        y[l] = x[l];
      y[i] = (double) x[i] + (j % 2 == 0 ? 1 : -1) * gs_limits.margin_near * a->nominal[i];
      ((gs_mar_type *) a->mar) (&t, y, v, cst, g, size);
      if (g[k] >= 0)
        return 1;
    }
  return 0;
}

/* the margins of the devices in the state X at T under the inputs V: PASSED, 1 where one is, LEAST,
   the least values so far (W: gs_margins_room numbers).  How many are passed */
static int
gs_margins (const gs_start *a, gs_value t, const gs_value *x, const gs_value *v, gs_value *cst,
            double *passed, double *least, gs_value *w)
{
  const gsmbp_scene *s = a->scene;
  gs_value *g = w + s->nx, *size = g + s->nsm;
  int many = 0;
  ((gs_mar_type *) a->mar) (&t, x, v, cst, g, size);
  for (int k = 0; k < s->nsm; k++)
    {
      double now = (double) g[k], rounding = -gs_limits.margin_rounding * (double) size[k];
      if (! isnan (least[k]) && ! (now >= least[k]))
        least[k] = now;
      if (now >= rounding || passed[k] > 0)
        continue;
      passed[k] = ! gs_margin_beside (a, t, x, v, cst, k, w);
      many += passed[k] > 0;
      ((gs_mar_type *) a->mar) (&t, x, v, cst, g, size);
    }
  return many;
}

/* is a device where it cannot be at the start X? */
static int
gs_start_outside (const gs_start *a, gs_value t, const gs_value *x, gs_value *cst)
{
  const gsmbp_scene *s = a->scene;
  const int n = s->nsm;
  gs_value *w = a->check && a->mar && n > 0
                 ? (gs_value *) calloc (gs_margins_room (s) + s->nv + 1, sizeof (gs_value)) : NULL;
  double *some = w ? (double *) calloc (2 * n, sizeof (double)) : NULL;
  int many = some ? gs_margins (a, t, x, w + gs_margins_room (s), cst, some, some + n, w) : 0;
  free (w);
  free (some);
  return many;
}

/* X at T moved onto the constraints, by PRJ, unless it is there but for rounding; a verdict (W:
   gs_start_room numbers) */
static int
gs_close_start (const gs_start *a, gs_value t, gs_value *x, gs_value *cst, gs_value *w)
{
  const gsmbp_scene *s = a->scene;
  gs_value *was = w + s->nx + s->nlam * (4 + s->nu);
  int info = 0;
  if (s->nlam == 0 && s->nq == s->nu)
    return GS_START_TAKEN;
  double off = gs_start_off (a, t, x, cst, w);
  if (a->check && ! (off <= gs_limits.off_constraints))
    return GS_START_OFF;
  if (off <= 100 * DBL_EPSILON && (a->check || s->nlam == 0 || a->con))
    return GS_START_TAKEN;
  if (! a->prj)
    return a->check ? GS_START_TAKEN : GS_START_NONE;
  for (int i = 0; i < s->nx; i++)
    was[i] = x[i];
  ((gs_prj_type *) a->prj) (&t, x, cst, w, &info);
  for (int i = 0; i < s->nx; i++)
    x[i] = (double) x[i];
  if ((info != 0 && info != 2) || ! (gs_start_off (a, t, x, cst, w) <= gs_limits.off_constraints))
    return GS_START_NONE;
  const int far = a->check && ! (gs_start_moved (a, x, was) <= gs_limits.moved_start);
  return far ? GS_START_FAR : GS_START_TAKEN;
}

/* the first stop that is beyond its end at the start X and that the modes leave free, from 1 on, as
   octave/private/gsmbp__check_stops.m; 0: none is */
static int
gs_start_beyond (const gs_start *a, gs_value t, const gs_value *x, gs_value *cst)
{
  const gsmbp_scene *s = a->scene;
  gs_value *g = a->evt && a->ne > 0
                 ? (gs_value *) calloc (a->ne + s->nv + 1, sizeof (gs_value)) : NULL;
  int *mode = g ? (int *) calloc (s->nmode + 1, sizeof (int)) : NULL, found = 0;
  if (mode)
    ((gs_evt_type *) a->evt) (&t, x, g + a->ne, mode, cst, g);
  for (int k = a->ne; mode && k > 0; k--)
    if (a->kind[k-1] == 2 && ! (a->mode && a->mode[k-1] != 0) && g[k-1] < -gs_limits.past_stop)
      found = k;
  free (g);
  free (mode);
  return found;
}

/* the same, and where devices and stops can be */
static int
gs_take_start (const gs_start *a, gs_value t, gs_value *x, gs_value *cst, gs_value *w)
{
  int verdict = gs_close_start (a, t, x, cst, w);
  if (verdict != GS_START_TAKEN)
    return verdict;
  if (gs_start_outside (a, t, x, cst))
    return GS_START_DEVICE;
  int beyond = gs_start_beyond (a, t, x, cst);
  return beyond > 0 ? GS_START_STOP + beyond - 1 : GS_START_TAKEN;
}
#endif
