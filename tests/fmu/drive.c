/* drive.c: an FMU called from C, as it should be and as it should not. It is linked with the
 * sources of an FMU; STANDARD is 2 or 3. Prints a line `ok` or `not ok` for each check.
 *
 * Arguments: the end of the run [s], the number of wrong sequences (0: starts alone; -1: a run in
 * which margins of devices are passed alone; -2: short communication steps alone), the value of all
 * inputs. */
#include "fmu/fmu.h"

#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int lines;        /* of the log */
static int warnings;
static char last[1000];

static void
logged (int status, const char *text)
{
  if (status >= 2 && text && *text)
    lines++;
  if (status == 1 && text && strstr (text, "has left the range of its laws"))
    warnings++;
  snprintf (last, sizeof last, "%s", text);
}

#if STANDARD == 2
#include "calls2.h"
#else
#include "calls3.h"
#endif

#define ERROR 3
enum { MOST = 1000 };
static const gsf_model *m = &gsf_the_model;
static double given = 0.1;   /* all inputs */

static void
told (int good, const char *text)
{
  printf ("%s %s %d.0: %s%s%s\n", good ? "ok" : "not ok", m->scene->name, STANDARD, text,
          good ? "" : "; the last log line: ", good ? "" : last);
}

static unsigned
first_of (int block)
{
  unsigned r = 0;
  for (int k = 0; k < block; k++)
    r += gsf_count (m, k);
  return r;
}

static int
all_variables (void)
{
  return (int)first_of (GSF_BLOCKS);
}

/* an instance behind its initialization, inputs as given */
static void *
begun (int kind, double end)
{
  void *c = make (kind, m->token);
  int bad = ENTER (c, 0, end);
  for (int k = 0; k < m->nin; k++)
    {
      unsigned r = first_of (GSF_INPUT) + k;
      double v = given;
      bad += SET (c, &r, 1, &v);
    }
  bad += EXIT (c);
  if (bad)
    told (0, "it begins");
  return c;
}

/* all variables of an instance */
static int
everything (void *c, double *values)
{
  unsigned r[MOST];
  for (int k = 0; k < all_variables (); k++)
    r[k] = k;
  return GET (c, r, all_variables (), values);
}

static int
same (void *c, void *d)
{
  double x[MOST], y[MOST];
  if (everything (c, x) || everything (d, y))
    return 0;
  return memcmp (x, y, all_variables () * sizeof (double)) == 0;
}

/* ------------------------------------------------------------------------------------- orderly */

/* step k of 20; a warning, that a device has left the range of its laws, is no failure */
static int
failing (void *c, double end, int k)
{
  return STEP (c, end * k / 20, end / 20) > 1;
}

/* a whole run of co-simulation */
static double until;
static void *
whole_run (void *nothing)
{
  void *c = begun (1, until);
  (void)nothing;
  for (int k = 0; k < 20; k++)
    if (failing (c, until, k))
      return c;
  return c;
}

/* how many margins are passed at the state of c and were not before */
static int
newly_passed (void *c, double t, int *was)
{
  double par[MOST], cst[MOST], x[MOST], v[MOST] = { 0 }, margin[MOST], size[MOST];
  unsigned r[MOST];
  int found = 0;
  for (int k = 0; k < m->scene->nx; k++)
    r[k] = first_of (GSF_STATE) + k;
  GET (c, r, m->scene->nx, x);
  for (int k = 0; k < m->nin; k++)
    r[k] = first_of (GSF_INPUT) + k;
  double u[MOST];
  GET (c, r, m->nin, u);
  for (int k = 0; k < m->nin; k++)
    v[m->inputs[k]] = u[k];
  m->par (par);
  m->pre (par, cst);
  m->mar (t, x, v, cst, margin, size);
  for (int k = 0; k < m->nmargins; k++)
    {
      int passed = margin[k] < -1e-4 * size[k];
      found += passed && ! was[k];
      was[k] = passed;
    }
  return found;
}

/* margins of devices that are passed in a run: inputs as given for a third of it, then their
 * negatives */
static void
passing (double end)
{
  void *c = begun (1, end);
  int was[MOST] = { 0 }, wanted = 0, bad = 0, steps = 60;
  warnings = 0;
  for (int k = 0; k < steps && ! bad; k++)
    {
      for (int i = 0; k == steps / 3 && i < m->nin; i++)
        {
          unsigned r = first_of (GSF_INPUT) + i;
          double v = -given;
          bad += SET (c, &r, 1, &v);
        }
      bad += STEP (c, end * k / steps, end / steps) > 1;
      wanted += newly_passed (c, end * (k + 1) / steps, was);
    }
  FREE (c);
  char text[80];
  snprintf (text, sizeof text, "%d margins are passed in a run, each is told once (%d)", wanted,
            warnings);
  told (! bad && warnings == wanted, text);
}

/* four instances at the same time */
static void
threads (double end)
{
  pthread_t thread[4];
  void *c[4];
  int good = 1;
  until = end;
  for (int k = 0; k < 4; k++)
    pthread_create (thread + k, NULL, whole_run, NULL);
  for (int k = 0; k < 4; k++)
    pthread_join (thread[k], c + k);
  for (int k = 1; k < 4; k++)
    good &= same (c[0], c[k]);
  for (int k = 0; k < 4; k++)
    FREE (c[k]);
  told (good, "four instances in threads of their own give the same bits");
}

/* is each of n bytes of a state looked at, and does the log say what is wrong? */
static int
are_refused (void *c, char *bytes, size_t n)
{
  void *state = NULL;
  int good = 1;
  for (size_t k = 0; k < n; k += 7)
    {
      bytes[k] ^= 16;
      good &= READ (c, bytes, n, &state) == ERROR && state == NULL && strstr (last, "damaged") != 0;
      bytes[k] ^= 16;
    }
  good &= READ (c, bytes, n, &state) == 0;
  DROP (c, &state);
  return good;
}

/* two instances, one of which is read after each step, give the same bits; a saved state goes on as
 * the instance did */
static void
cosimulation (double end)
{
  void *a = begun (1, end), *b = begun (1, end), *state = NULL, *copy = NULL;
  double x[MOST];
  int bad = 0;
  for (int k = 0; k < 20; k++)
    bad += failing (a, end, k) + everything (a, x);
  for (int k = 0; k < 10; k++)
    bad += failing (b, end, k);
  size_t n = 0;
  bad += SAVE (b, &state) + SIZE (b, state, &n);
  char *bytes = calloc (n + 1, 1);
  bad += WRITE (b, state, bytes, n) + READ (b, bytes, n, &copy);
  for (int k = 10; k < 20; k++)
    bad += failing (b, end, k);
  told (! bad, "co-simulation");
  told (same (a, b), "two instances give the same bits");
  void *c = make (1, m->token);
  bad = LOAD (c, copy);
  for (int k = 10; k < 20; k++)
    bad += failing (c, end, k);
  told (! bad && same (a, c), "a state that was serialized goes on as the instance did");
  told (READ (c, bytes, n - 1, &state) == ERROR && READ (c, bytes + 1, n, &state) == ERROR,
        "bytes that are no state are refused");
  told (are_refused (c, bytes, n), "bytes of a state that are damaged are refused");
  DROP (b, &state);
  DROP (b, &copy);
  free (bytes);
  told (STEP (b, end, end / 20) == ERROR && strstr (last, "the experiment stops at"),
        "a step beyond the end of the experiment is refused");
  TERMINATE (a);
  RESET (a);
  told (ENTER (a, 0, end) + EXIT (a) == 0, "it begins again after a reset");
  FREE (a);
  FREE (b);
  FREE (c);
}

/* the reference of state i of model exchange */
static unsigned
state_reference (int i)
{
  const gs_scene *s = m->scene;
  if (s->nlam == 0 || (i < m->nsq && m->nsq == s->nq))
    return first_of (GSF_STATE) + i;
  if (i < m->nsq + m->nsu)
    return first_of (GSF_CHOSEN) + i - (m->nsq == s->nq ? s->nq : 0);
  return first_of (GSF_STATE) + s->nq + s->nu + i - m->nsq - m->nsu;
}

/* the references of all that has a derivative; how many */
static int
unknowns_of (unsigned *r)
{
  int n = gsf_count (m, GSF_RATE), k;
  for (k = 0; k < n + m->scene->ny; k++)
    r[k] = k < n ? first_of (GSF_RATE) + k : first_of (GSF_OUTPUT) + k - n;
  return k;
}

/* the unknowns where state i, or input i - ns, is moved by h */
static int
moved (void *c, const double *x, int i, double h, int n, const unsigned *unknowns, double *values)
{
  const int ns = gsf_ns (m);
  double y[MOST], v = given + h;
  unsigned input = first_of (GSF_INPUT) + i - ns;
  memcpy (y, x, ns * sizeof (double));
  if (i < ns)
    y[i] += h;
  int bad = (i >= ns && SET (c, &input, 1, &v)) || PUT (c, y, ns) || GET (c, unknowns, n, values);
  v = given;
  return bad || (i >= ns && SET (c, &input, 1, &v)) || PUT (c, x, ns);
}

/* central differences by state i, or input i - ns, less the derivatives, beside the largest */
static double
difference (void *c, const double *x, int i, double h)
{
  const int ns = gsf_ns (m);
  unsigned unknowns[MOST], known = i < ns ? state_reference (i) : first_of (GSF_INPUT) + i - ns;
  double exact[MOST], low[MOST], high[MOST], one = 1, size = 1, worst = 0;
  int n = unknowns_of (unknowns);
  if (DERIVATIVE (c, unknowns, n, &known, 1, &one, exact)
      || moved (c, x, i, -h, n, unknowns, low) || moved (c, x, i, h, n, unknowns, high))
    return 1e300;
  for (int k = 0; k < n; k++)
    {
      size = fmax (size, fabs (exact[k]));
      worst = fmax (worst, fabs ((high[k] - low[k]) / (2 * h) - exact[k]));
    }
  return worst / size;
}

/* the least of some steps: short ones have rounding errors, in long ones friction bends */
static double
worst_derivative (void *c, const double *x, int i)
{
  double least = 1e300, size = i < gsf_ns (m) ? fmax (1, fabs (x[i])) : fabs (given);
  for (double h = 1e-4; h > 1e-8; h /= 10)
    least = fmin (least, difference (c, x, i, h * size));
  return least;
}

/* model exchange by the method of Heun, events at steps; derivatives on the way */
static void
exchange (double end)
{
  void *c = begun (0, end);
  int ns = gsf_ns (m), bad = 0, n = 200;
  double x[MOST], f[MOST], g[MOST], y[MOST], next, worst = 0;
  bad += update (c, &next) + CONTINUE (c);
  for (int k = 0; k < n; k++)
    {
      double t = end * k / n, h = end / n;
      truth event, terminate;
      bad += STATES (c, x, ns) + RATES (c, f, ns);
      for (int i = 0; m->jac && k % 40 == 20 && i < ns + m->nin; i++)
        worst = fmax (worst, worst_derivative (c, x, i));
      for (int i = 0; i < ns; i++)
        y[i] = x[i] + h * f[i];
      bad += TIME (c, t + h) + PUT (c, y, ns) + RATES (c, g, ns);
      for (int i = 0; i < ns; i++)
        y[i] = x[i] + 0.5 * h * (f[i] + g[i]);
      bad += PUT (c, y, ns) + INDICATORS (c, g, gsf_nz (m)) + COMPLETED (c, &event, &terminate);
      if (event || t + h >= next)
        bad += EVENTS (c) + update (c, &next) + CONTINUE (c);
    }
  told (! bad, "model exchange");
  char text[80];
  snprintf (text, sizeof text, "directional derivatives within %.1e of differences", worst);
  if (m->jac)
    told (worst < 2e-7, text);
  bad = TERMINATE (c);
  told (! bad && TIME (c, 0) == ERROR, "after its end it is not continued");
  FREE (c);
}

/* ---------------------------------------------------------------------------------------- wrong */

static unsigned seed;
static int
chance (int n)
{
  seed = seed * 1664525u + 1013904223u;
  return (int)(seed >> 8) % n;
}

static double
odd (void)
{
  const double values[] = { 0, 1, -1, 1e-3, 1e308, NAN, INFINITY, -INFINITY, 1e-320, 0.5 };
  return values[chance (10)];
}

/* one call by chance; its status */
static int
call (void *c, void **state, int *kind)
{
  unsigned r[3] = { (unsigned)chance (all_variables () + 2), (unsigned)chance (all_variables ()),
                    chance (3) ? 0 : 4294967295u };
  double x[MOST], next;
  truth event, terminate;
  size_t n = 0;
  int ns = gsf_ns (m) + (chance (5) == 0);
  for (int k = 0; k < MOST; k++)
    x[k] = chance (20) ? 0.1 : odd ();
  (void)kind;
  switch (chance (24))
    {
    case 0:
      return ENTER (c, odd (), odd ());
    case 1:
    case 2:
      return ENTER (c, 0, 10);
    case 3:
    case 4:
      return EXIT (c);
    case 5:
      return GET (c, r, 1 + chance (3), x);
    case 6:
      return SET (c, r, 1 + chance (3), x);
    case 7:
      return TERMINATE (c);
    case 8:
      return chance (4) ? 0 : RESET (c);
    case 9:
      return SAVE (c, state);
    case 10:
      return LOAD (c, *state);
    case 11:
      return DROP (c, state);
    case 12:
      return SIZE (c, *state, &n);
    case 13:
      return WRITE (c, *state, (char *)x, sizeof x);
    case 14:
      return READ (c, (const char *)x, sizeof x, state);
    case 15:
      return DERIVATIVE (c, r, 1, r + 1, 1, x, x + 1);
    case 16:
      return EVENTS (c);
    case 17:
      return update (c, &next);
    case 18:
      return CONTINUE (c);
    case 19:
      return chance (2) ? TIME (c, odd ()) : COMPLETED (c, &event, &terminate);
    case 20:
      return PUT (c, x, ns);
    case 21:
      return chance (2) ? STATES (c, x, ns) : NOMINALS (c, x, ns);
    case 22:
      return chance (2) ? RATES (c, x, ns) : INDICATORS (c, x, gsf_nz (m) + (ns > gsf_ns (m)));
    default:
      if (chance (3) == 0)
        return other (c, chance (8), r, x);
      return STEP (c, chance (2) ? 0 : odd (), chance (2) ? 1e-3 : odd ());
    }
}

/* is every error said in the log? */
static int
wrong_sequence (int number)
{
  seed = number;
  int kind = number % 2, silent = 0;
  void *c = make (kind, m->token), *state = NULL;
  for (int k = 0; k < 60; k++)
    {
      int before = lines, status = call (c, &state, &kind);
      if (status < 0 || status > ERROR)
        silent = 1;
      if (status == ERROR && lines == before)
        {
          snprintf (last, sizeof last, "call %d of sequence %d is silent", k, number);
          silent = 1;
        }
    }
  DROP (c, &state);
  FREE (c);
  return silent;
}

static void
wrong (int n)
{
  int silent = 0;
  for (int k = 0; k < n; k++)
    silent += wrong_sequence (k);
  char text[80];
  snprintf (text, sizeof text, "%d wrong sequences, each error with a log line (%d)", n, lines);
  told (silent == 0 && lines > n, text);
  told (! make (0, "another") && ! make (1, NULL), "another token is refused");
  told (STEP (NULL, 0, 1) == ERROR && RATES (NULL, NULL, 0) == ERROR, "no instance is an error");
  void *c = begun (0, 1);
  double nan = NAN;
  unsigned r = first_of (GSF_PARAMETER), far = all_variables ();
  told (SET (c, &r, 1, &nan) == ERROR && GET (c, &far, 1, &nan) == ERROR,
        "a parameter that is no number, a reference out of range");
  FREE (c);
}

/* a start where a port is beyond its stop, or a margin of a device not kept; x: states */
static int
is_impossible (const double *x)
{
  const gs_scene *s = m->scene;
  double par[MOST], cst[MOST], v[MOST] = { 0 }, row[MOST], pos[MOST], speed[MOST], ends[MOST];
  int bad = 0;
  m->par (par);
  m->pre (par, cst);
  if (m->nports > 0)
    s->hld (0, x, v, cst, row, m->nports, pos, speed, ends);
  for (int k = 0; k < m->nports; k++)
    bad |= s->event_kinds[k] == 2
           && (pos[k] < ends[4 * k] - 1e-5 || pos[k] > ends[4 * k + 1] + 1e-5);
  if (m->nmargins > 0)
    m->mar (0, x, v, cst, pos, speed);
  for (int k = 0; k < m->nmargins; k++)
    bad |= pos[k] < -1e-5 * speed[k];
  return bad;
}

/* state i starts at some value: 1 refused as it must be, 0 accepted as it must be, else -1 */
static int
start_at (int i, double value)
{
  void *c = make (1, m->token);
  unsigned r[MOST];
  double x[MOST];
  for (int k = 0; k < m->scene->nx; k++)
    r[k] = first_of (GSF_STATE) + k;
  int bad = ENTER (c, 0, 1) + SET (c, r + i, 1, &value) + GET (c, r, m->scene->nx, x);
  int refused = bad == 0 && EXIT (c) == ERROR;
  int found = bad ? 0 : is_impossible (x) ? (refused ? 1 : -1) : refused ? -1 : 0;
  if (refused && ! strstr (last, "start"))
    found = -1;
  FREE (c);
  return found;
}

static void
impossible_starts (void)
{
  int refused = 0, wrong = 0;
  for (int i = 0; i < m->scene->nx; i++)
    for (int k = m->nmargins > 0 ? -10 : -11; k <= 10; k++) /* -11: a little below 0 */
      {
        int found = start_at (i, k < -10 ? -1e-4 : 0.3 * k * m->nominal[i]);
        refused += found == 1;
        wrong += found < 0;
      }
  int expected = m->nmargins > 0;
  for (int k = 0; k < m->nports; k++)
    expected |= m->scene->event_kinds[k] == 2;
  told (wrong == 0 && (refused > 0) == expected, "starts beyond stops and margins, and no others, "
        "are refused");
}

#include "short_steps.h"

int
main (int argc, char **argv)
{
  double end = argc > 1 ? strtod (argv[1], NULL) : 1;
  if (argc > 3)
    given = strtod (argv[3], NULL);
  setlocale (LC_ALL, "");
  if (getenv ("LOCPATH"))
    {
      char text[20];
      snprintf (text, sizeof text, "%.1f", 1.5);
      told (strcmp (text, "1,5") == 0, "decimals have a comma");
    }
  if (argc > 2 && atoi (argv[2]) == -2)
    {
      short_steps (end);
      return 0;
    }
  if (argc > 2 && atoi (argv[2]) < 0)
    {
      passing (end);
      return 0;
    }
  impossible_starts ();
  if (argc > 2 && atoi (argv[2]) == 0)
    return 0;
  cosimulation (end);
  short_steps (end);
  threads (end);
  exchange (end);
  wrong (argc > 2 ? atoi (argv[2]) : 100);
  return 0;
}
