/* start.c: the state of a start onto the constraints, or why it is refused. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/limits.h"
#include "gsmbp/refusals.h"
#include "host/start.h"
#include "host/text.h"

static int
refuse (gs_start *s, int verdict, const char *format, ...)
{
  va_list values;
  va_start (values, format);
  vsnprintf (s->text, sizeof s->text, format, values);
  va_end (values);
  return s->verdict = verdict;
}

static int
no_memory (gs_start *s)
{
  return refuse (s, GS_START_NO_MEMORY, "there was no memory for the start");
}

int
gs_check_angles (const gs_description *d, const gs_real *x, gs_start *s)
{
  for (int k = 0; k < d->scene->nq && d->angles; k++)
    if (d->angles[k] && gs_abs (x[k]) > (gs_real)gs_limits.largest_angle)
      {
        s->state = k;
        return refuse (s, GS_START_ANGLE, gs_refusals.largest_angle, (double)x[k]);
      }
  return GS_START_TAKEN;
}

int
gs_refuse_orientation (const gs_description *d, int k, const gs_real *x, gs_start *s)
{
  const int *set = d->sets + 4 * k;
  char called[300], found[120];
  snprintf (called, sizeof called, "%s, %s, %s, %s", d->states[set[0]], d->states[set[1]],
            d->states[set[2]], d->states[set[3]]);
  snprintf (found, sizeof found, "[%.6g %.6g %.6g %.6g]", (double)x[set[0]], (double)x[set[1]],
            (double)x[set[2]], (double)x[set[3]]);
  return refuse (s, GS_START_ORIENTATION, gs_refusals.orientation, called, found);
}

/* Euler parameters that are almost zero have no direction */
static int
check_orientations (const gs_description *d, const gs_real *x, gs_start *s)
{
  for (int k = 0; k < d->nsets; k++)
    {
      const int *set = d->sets + 4 * k;
      double sum = 0;
      for (int j = 0; j < 4; j++)
        sum += (double)(x[set[j]] * x[set[j]]);
      if (! (sqrt (sum) > gs_limits.short_orientation))
        return gs_refuse_orientation (d, k, x, s);
    }
  return GS_START_TAKEN;
}

/* the row that is farthest from the constraints; a row without a number is */
static double
largest (int n, const double *scaled, int *k)
{
  double most = 0;
  *k = -1;
  for (int i = 0; i < n && ! isnan (most); i++)
    if (! (fabs (scaled[i]) <= most))
      {
        most = fabs (scaled[i]);
        *k = i;
      }
  return most;
}

static int
off_constraints (const gs_start_given *g, int verdict, const char *found, gs_start *s)
{
  return refuse (s, verdict, gs_refusals.off_constraints, (double)g->t, found);
}

/* no state on the constraints was found: what INFO of PRJ means, where y is, if it is finite */
static int
none_near (const gs_description *d, const gs_start_given *g, int info, int finite,
           const double *scaled, const double *found, gs_start *s)
{
  gs_writer w = { s->text, sizeof s->text, 0 };
  const char *meaning = d->meaning ? d->meaning ("prj", info) : NULL;
  gs_put (&w, "no state on the constraints was found near this one at t = %.9g s (PRJ: INFO = %d",
          (double)g->t, info);
  gs_put (&w, meaning ? ": %s)" : ")", meaning);
  gs_put (&w, "; found ");
  if (finite)
    gs_worst_residuals (d, scaled, found, gs_limits.off_constraints, w.text + w.length,
                        w.size - w.length);
  else
    gs_put (&w, "a state that is not finite");
  return s->verdict = GS_START_NONE;
}

/* is y, from PRJ with info, on the constraints? */
static int
check_moved (const gs_description *d, const gs_start_given *g, int info, const gs_real *y,
             double *scaled, double *found, gs_start *s)
{
  int finite = 1, k;
  for (int i = 0; i < d->scene->nx; i++)
    finite &= gs_abs (y[i]) <= GS_HUGE;
  if (finite && gs_residuals (d, g->t, y, g->cst, scaled, found) != 0)
    return no_memory (s);
  const double off = finite ? largest (gs_residual_rows (d), scaled, &k) : HUGE_VAL;
  if ((info != 0 && info != 2) || ! (off <= gs_limits.off_constraints))
    return none_near (d, g, info, finite, scaled, found, s);
  return GS_START_TAKEN;
}

/* how far y is from x, in nominal magnitudes: the state that is most */
static void
measure (const gs_description *d, const gs_real *x, const gs_real *y, gs_start *s)
{
  s->state = 0;
  for (int i = 0; i < d->scene->nx; i++)
    {
      const double one = fabs ((double)(y[i] - x[i])) / d->nominal[i];
      if (one > s->moved)
        {
          s->moved = one;
          s->state = i;
        }
    }
}

/* x moved onto the constraints by PRJ; y: nx numbers */
static int
move (const gs_description *d, const gs_start_given *g, gs_real *x, double *scaled, double *found,
      gs_real *y, gs_start *s)
{
  const int nx = d->scene->nx;
  gs_real res;
  memcpy (y, x, (size_t)nx * sizeof *y);
  const int info = d->scene->prj (g->t, y, g->cst, &res);
  for (int i = 0; i < nx; i++)
    y[i] = (double)y[i];
  const int verdict = check_moved (d, g, info, y, scaled, found, s);
  if (verdict != GS_START_TAKEN)
    return verdict;
  measure (d, x, y, s);
  if (g->check && ! (s->moved <= gs_limits.moved_start))
    {
      char why[700];
      snprintf (why, sizeof why, "found one that %s puts off them by %.3g only, but that must be "
                "moved by %.3g in %s (close to a singular position)", s->row, s->residual, s->moved,
                d->states[s->state]);
      return off_constraints (g, GS_START_FAR, why, s);
    }
  memcpy (x, y, (size_t)nx * sizeof *x);
  return GS_START_TAKEN;
}

/* x checked and moved, with room for the rows of residuals and a state */
static int
close_state (const gs_description *d, const gs_start_given *g, gs_real *x, double *scaled,
             double *found, gs_real *y, gs_start *s)
{
  const gs_scene *scene = d->scene;
  const int seen = scene->nlam == 0 || scene->con;
  int k;
  if (gs_residuals (d, g->t, x, g->cst, scaled, found) != 0)
    return no_memory (s);
  s->residual = largest (gs_residual_rows (d), scaled, &k);
  if (k >= 0)
    gs_residual_name (d, k, s->row, sizeof s->row);
  if (g->check && ! (s->residual <= gs_limits.off_constraints))
    {
      char why[2000] = "found ";
      gs_worst_residuals (d, scaled, found, gs_limits.off_constraints, why + 6, sizeof why - 6);
      return off_constraints (g, GS_START_OFF, why, s);
    }
  /* what is closed to rounding stays as it is */
  if (s->residual <= 100 * DBL_EPSILON && (g->check || seen))
    return GS_START_TAKEN;
  if (! scene->prj && g->check)
    return GS_START_TAKEN;
  if (! scene->prj)
    return refuse (s, GS_START_NO_PROJECTION, gs_refusals.no_projection, scene->name);
  return move (d, g, x, scaled, found, y, s);
}

int
gs_close_start (const gs_description *d, const gs_start_given *g, gs_real *x, gs_start *s)
{
  const gs_scene *scene = d->scene;
  const size_t n = (size_t)gs_residual_rows (d);
  s->verdict = GS_START_TAKEN;
  s->residual = s->moved = 0;
  s->state = -1;
  s->row[0] = s->text[0] = 0;
  if (gs_check_angles (d, x, s) != GS_START_TAKEN)
    return s->verdict;
  if (scene->nlam == 0 && scene->nq == scene->nu)
    return GS_START_TAKEN;
  if (check_orientations (d, x, s) != GS_START_TAKEN)
    return s->verdict;
  double *rows = malloc ((2 * n + 1) * sizeof *rows);
  gs_real *y = malloc ((size_t)scene->nx * sizeof *y);
  const int verdict = rows && y ? close_state (d, g, x, rows, rows + n, y, s) : no_memory (s);
  free (rows);
  free (y);
  return verdict;
}

int
gs_check_margins (const gs_description *d, const gs_start_given *g, const gs_real *x, gs_start *s)
{
  char all[2000];
  gs_real *v = calloc ((size_t)d->scene->nv + 1, sizeof *v);
  const int many = v ? gs_passed_text (d, g->t, x, g->v ? g->v : v, g->cst, g->par, all,
                                       sizeof all) : -1;
  free (v);
  if (many < 0)
    return no_memory (s);
  s->verdict = GS_START_TAKEN;
  return many > 0 ? refuse (s, GS_START_DEVICE, gs_refusals.device, all) : GS_START_TAKEN;
}

/* ports are the event functions before those of the user */
gs_real *
gs_ports_at (const gs_description *d, const gs_start_given *g, const gs_real *x, int *ports)
{
  const gs_scene *s = d->scene;
  int n = 0;
  while (s->hld && n < s->nev && s->event_kinds[n] <= 2)
    n++;
  *ports = n;
  if (n == 0)
    return NULL;
  gs_real *w = calloc ((size_t)((6 + s->nu) * n + s->nv + 1), sizeof *w);
  if (w)
    s->hld (g->t, x, g->v ? g->v : w + (6 + s->nu) * n, g->cst, w + 6 * n, n, w, w + n, w + 2 * n);
  return w;
}

int
gs_check_stops (const gs_description *d, const gs_start_given *g, const gs_real *x, gs_start *s)
{
  int n;
  const double near = gs_limits.past_stop;
  gs_real *w = gs_ports_at (d, g, x, &n);
  s->verdict = GS_START_TAKEN;
  if (n == 0)
    return GS_START_TAKEN;
  if (! w)
    return no_memory (s);
  for (int k = 0; k < n && s->verdict == GS_START_TAKEN; k++)
    {
      const double place = (double)w[k], low = (double)w[2 * n + 4 * k],
                   high = (double)w[2 * n + 4 * k + 1];
      if (d->scene->event_kinds[k] == 2 && ! (g->modes && g->modes[k] != 0)
          && (place < low - near || place > high + near))
        refuse (s, GS_START_STOP, gs_refusals.past_stop, d->events[k], low, high, place);
    }
  free (w);
  return s->verdict;
}

int
gs_take_start (const gs_description *d, const gs_start_given *g, gs_real *x, gs_start *s)
{
  int verdict = gs_close_start (d, g, x, s);
  if (verdict == GS_START_TAKEN && g->check)
    verdict = gs_check_margins (d, g, x, s);
  return verdict == GS_START_TAKEN ? gs_check_stops (d, g, x, s) : verdict;
}

/* ------------------------------------------------------------------------------ samples, modes */

int
gs_check_samples (const gs_description *d, gs_real t0, const gs_real *cst, int *ip, gs_real *rp,
                  gs_start *s)
{
  const int found = gs_due_from (d->scene, t0, cst, ip, rp);
  s->verdict = GS_START_TAKEN;
  if (found == 0)
    return GS_START_TAKEN;
  const int k = abs (found) - 1;
  const gs_samples plan = gs_planned_samples (d->scene, ip, rp);
  char device[200];
  snprintf (device, sizeof device, "sampled device %d", k + 1);
  const char *name = d->devices ? d->devices[k] : device;
  if (found > 0)
    return refuse (s, GS_START_SAMPLES, gs_refusals.period, name, (double)plan.period[k],
                   (double)plan.delay[k]);
  return refuse (s, GS_START_SAMPLES, gs_refusals.too_many_samples, name);
}

int
gs_pending (int n, const double *period, const double *delay)
{
  double places = 0;
  for (int k = 0; k < n; k++)
    if (period[k] > 0 && delay[k] > 0)
      places += floor (delay[k] / period[k] + 1e-9) + 2;
  return places < 2e9 ? (int)places : 2000000000;
}

double
gs_instants (int n, const double *period, const double *delay, double span)
{
  double instants = 0;
  for (int k = 0; k < n; k++)
    if (period[k] > 0)
      instants += (delay[k] > 0 ? 2 : 1) * (floor (span / period[k]) + 2);
  return instants;
}

/* that of a stop which errors at its nearer end are beside (gs_stop_travel) */
static double
travel (double place, double low, double high)
{
  return fmin (high - low, fmax (1, fabs (high - place < place - low ? high : low)));
}

void
gs_wrong_mode (const gs_description *d, const gs_start_given *g, const gs_real *x, int k,
               char *text, int size)
{
  const int mode = g->modes[k];
  int n;
  gs_real *w = gs_ports_at (d, g, x, &n);
  char why[200] = "which has no mode";
  int wanted = 0;
  if (w && k < n)
    {
      const double place = (double)w[k], speed = (double)w[n + k],
                   low = (double)w[2 * n + 4 * k], high = (double)w[2 * n + 4 * k + 1];
      snprintf (why, sizeof why, "which moves at %.6g (m/s or rad/s)", speed);
      if (d->scene->event_kinds[k] == 1)
        wanted = (speed > 0) - (speed < 0);
      else if (fabs (place - (mode > 0 ? high : low))
               > gs_limits.past_stop * travel (place, low, high))
        snprintf (why, sizeof why, "which is at %.6g between %.6g and %.6g (m or rad)", place, low,
                  high);
    }
  snprintf (text, (size_t)size, gs_refusals.wrong_mode, wanted, d->events[k], why, mode);
  free (w);
}
