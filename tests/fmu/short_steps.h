/* short_steps.h: of drive.c: what short communication steps cost, in calls of the right-hand side,
 * and that a step which goes beyond one is dropped where an input changes. Implicit methods make no
 * such step. */

#include "fmu/fmu.h"

static long calls;
static gs_scene counted_scene;
static gsf_model counted;

static int
counting (double t, const double *x, const double *v, const double *cst, double *xd)
{
  calls++;
  return m->scene->rhs (t, x, v, cst, xd);
}

static int
put_inputs (gsf_instance *a, double v)
{
  int bad = 0;
  for (int k = 0; k < m->nin; k++)
    bad |= gsf_set (a, gsf_first (m, GSF_INPUT) + k, v);
  return bad;
}

/* an instance of co-simulation that counts, null where it does not begin */
static gsf_instance *
counting_one (void)
{
  counted_scene = *m->scene;
  counted_scene.rhs = counting;
  counted = *m;
  counted.scene = &counted_scene;
  calls = 0;
  gsf_instance *a = gsf_new (&counted, GSF_COSIMULATION);
  if (gsf_setup (a, 1, 1e-8, 0, 0, 0) || gsf_enter (a) || put_inputs (a, given) || gsf_exit (a))
    {
      snprintf (last, sizeof last, "%s", a->text);
      gsf_free (a);
      return NULL;
    }
  return a;
}

/* communication steps first to last of n up to end; the inputs change `changes` times in n, evenly.
 * Is something wrong? */
static int
some_steps (gsf_instance *a, double end, int n, int first, int last_one, int changes)
{
  int bad = 0;
  for (int k = first; k < last_one && ! bad && *a->run.ended == 0; k++)
    {
      if (changes > 0 && k % (n / changes) == 0)
        bad = put_inputs (a, given * (1 + 0.1 * (k / (n / changes) % 2)));
      bad |= gsf_step (a, end * (k + 1) / n) > GSF_WARNING;
    }
  return bad;
}

/* a run of n communication steps; x: the state at its end. Calls, or -1 */
static long
stepped (double end, int n, int changes, double *x)
{
  gsf_instance *a = counting_one ();
  if (! a)
    return -1;
  const int bad = some_steps (a, end, n, 0, n, changes);
  memcpy (x, a->x, m->scene->nx * sizeof *x);
  snprintf (last, sizeof last, "%s", a->text);
  gsf_free (a);
  return bad ? -1 : calls;
}

static double
apart (const double *x, const double *y)
{
  double off = 0;
  for (int i = 0; i < m->scene->nx; i++)
    off = fmax (off, fabs (x[i] - y[i]) / (m->nominal[i] + fabs (y[i])));
  return off;
}

/* inputs that change at a time to which the run is taken back leave nothing behind */
static void
taken_back (double end)
{
  double x[MOST];
  gsf_instance *a = counting_one ();
  void *state;
  if (! a)
    return;
  int bad = some_steps (a, end, 1000, 0, 503, 0);
  state = gsf_save (a, NULL);
  bad |= some_steps (a, end, 1000, 503, 600, 0);
  memcpy (x, a->x, m->scene->nx * sizeof *x);
  bad |= gsf_restore (a, state) || put_inputs (a, 2 * given);
  bad |= some_steps (a, end, 1000, 503, 510, 0) || gsf_restore (a, state);
  bad |= some_steps (a, end, 1000, 503, 600, 0);
  told (! bad && memcmp (x, a->x, m->scene->nx * sizeof *x) == 0,
        "taken back to within a step it goes on with the same bits, whatever was set between");
  free (state);
  gsf_free (a);
}

/* held outputs at 300 communication points, ten in a sampling period, those at samples among them:
 * the same where each step ends at one as where it goes beyond, and at a sample those after it */
static void
at_samples (void)
{
  gsf_instance *a = counting_one (), *b = counting_one ();
  const unsigned held = first_of (GSF_HELD);
  double off = 0, changed = 0;
  int bad = ! a || ! b;
  for (int k = 1; k <= 300 && ! bad; k++)
    {
      const double t = k * gsf_samples (a).period[0] / 10;
      gs_step_forget (&b->run);
      bad = gsf_step (a, t) > GSF_WARNING || gsf_step (b, t) > GSF_WARNING;
      for (int i = 0; i < m->scene->nheld && ! bad; i++)
        {
          const double before = gsf_samples (a).value[i];
          double x, y;
          bad = gsf_get (a, held + i, &x) || gsf_get (b, held + i, &y);
          off = fmax (off, fabs (x - y) / (1 + fabs (y)));
          changed += k % 10 == 0 ? fabs (x - before) : 0;
        }
    }
  told (! bad && off < 1e-6 && changed > 0, "held outputs at samples are those after them");
  gsf_free (a);
  gsf_free (b);
}

static void
short_steps (double end)
{
  double x[MOST], y[MOST];
  char text[200];
  const long few = stepped (end, 1, 0, x), all = stepped (end, 1000, 0, y);
  snprintf (text, sizeof text, "1000 communication steps, %ld calls; one, %ld; off by %.1e", all,
            few, apart (x, y));
  told (few > 0 && all > 0 && (m->integrate || all <= 1000 + 4 * few) && apart (x, y) < 1e-6, text);
  taken_back (end);
  if (m->nin == 0)
    return;
  if (m->scene->nctl > 0)
    at_samples ();
  const long each = stepped (end, 1000, 1000, x);
  const long long_ones = stepped (end, 10, 10, x), ten = stepped (end, 1000, 10, y);
  snprintf (text, sizeof text, "... inputs that change at each, %ld calls; ten times, %ld, off by "
            "%.1e", each, ten, apart (x, y));
  told (each > 0 && ten > 0 && (m->integrate || ten <= 1500 + 4 * long_ones) && apart (x, y) < 1e-6,
        text);
}
