/* carried_runs.c: share/engine/host/derivatives on emitted scenes: closed forms of an oscillator
 * and of a ball that a stop or an event of the user throws back; differences of whole runs of a
 * sampled controller and a closed chain; two runs at once. A line for each check. */
#include <pthread.h>

#include "carried_runs.h"
#include "oscillator.h"
#include "sensitivity_ball.h"
#include "sensitivity_bounce.h"
#include "sensitivity_crank.h"
#include "sensitivity_sampled.h"

#ifdef GSMBP_QUAD
#define FINE 1e-19
#define STEP GS_R (1e-8)
#define ROUGH 1e-14
#define BACK 1e-28
#else
#define FINE 1e-10
#define STEP GS_R (1e-4)
#define ROUGH 2e-7
#define BACK 1e-12
#endif

/* constants of a scene with its parameters, of which number k is h more; the pointer is kept */
#define CONSTANTS(name, NAME)                                                                      \
  static gs_real name##_numbers[NAME##_NCST + 1];                                                  \
  static const gs_real *name##_constants (int k, gs_real h)                                        \
  {                                                                                                \
    name##_parameters p;                                                                           \
    name##_par (&p);                                                                               \
    ((gs_real *)&p)[k] += h;                                                                       \
    if (name##_pre (&p, name##_numbers) != 0)                                                      \
      abort ();                                                                                    \
    return name##_numbers;                                                                         \
  }
CONSTANTS (oscillator, OSCILLATOR)
CONSTANTS (sensitivity_ball, SENSITIVITY_BALL)
CONSTANTS (sensitivity_bounce, SENSITIVITY_BOUNCE)
CONSTANTS (sensitivity_crank, SENSITIVITY_CRANK)
CONSTANTS (sensitivity_sampled, SENSITIVITY_SAMPLED)

/* a run up to `end` with columns by the parameters named, from 1 */
static job
job_of (const gs_scene *s, const gs_real *cst, int ncst, gs_real end, int nc, const int *col)
{
  job j = { .s = s, .cst = cst, .ncst = ncst, .nc = nc, .nt = 2, .rtol = (gs_real)FINE / 100 };
  j.tout[1] = end;
  for (int k = 0; k < nc; k++)
    j.col[k] = col[k];
  return j;
}

static void backwards (const char *what, job *j);

/* ---------------------------------------------------------------------------------- oscillator */

/* x = a*cos (w*t), w = sqrt (c/m): by c, m and the start a */
static void
oscillator (void)
{
  const int col[] = { 1 + OSCILLATOR_PAR_C, 1 + OSCILLATOR_PAR_M, 0 };
  const gs_real t = 3, a = GS_R (0.4), m = 2, c = 5, w = gs_sqrt (c / m),
                by_w = -a * t * gs_sin (w * t);
  job j = job_of (&oscillator_scene, oscillator_constants (0, 0), OSCILLATOR_NCST, t, 3, col);
  j.x0[0] = a;
  j.x0[2 * 3] = 1; /* column 3 is by the start of the coordinate */
  run_job (&j);
  check ("the oscillator runs", j.info == 0);
  close_to ("its place", state_of (&j, 1, 0), a * gs_cos (w * t), FINE);
  close_to ("... by the stiffness", column_of (&j, 1, 0, 0), by_w * w / (2 * c), FINE);
  close_to ("... by the mass", column_of (&j, 1, 1, 0), -by_w * w / (2 * m), FINE);
  close_to ("... by the start", column_of (&j, 1, 2, 0), gs_cos (w * t), FINE);
  close_to ("its speed by the start", column_of (&j, 1, 2, 1), -w * gs_sin (w * t), FINE);
  backwards ("the oscillator runs forward", &j);
}

/* --------------------------------------------------------------------------------------- events */

/* A ball falls from rest at h above lo and comes back with the share e of its speed: its height y
   at t, and the derivatives of y and of the time of the impact by g, lo, e. */
typedef struct
{
  gs_real y, by[3], time_by[3];
} thrown;

static thrown
throw_back (gs_real g, gs_real lo, gs_real e, gs_real h, gs_real t)
{
  const gs_real t1 = gs_sqrt (2 * h / g), s = t - t1, by_t1 = e * g * s - e * g * t1 + g * s;
  const gs_real t1_by[] = { -t1 / (2 * g), -1 / (g * t1), 0 },
                alone[] = { e * t1 * s - s * s / 2, 1, g * t1 * s };
  thrown b = { lo + e * g * t1 * s - g * s * s / 2, { 0 }, { 0 } };
  for (int k = 0; k < 3; k++)
    {
      b.time_by[k] = t1_by[k];
      b.by[k] = alone[k] + by_t1 * t1_by[k];
    }
  return b;
}

static void
compare_thrown (const char *what, const job *j, const thrown *b)
{
  static const char *const by[] = { "gravity", "the floor", "the coefficient" };
  char text[100];
  check (what, j->info == 0 && j->events >= 1);
  close_to ("... its height", state_of (j, 1, 0), b->y, FINE);
  for (int k = 0; k < 3; k++)
    {
      snprintf (text, sizeof text, "... by %s", by[k]);
      close_to (text, column_of (j, 1, k, 0), b->by[k], FINE);
      snprintf (text, sizeof text, "... its impact by %s", by[k]);
      close_to (text, (gs_real)j->tau[k], b->time_by[k], 1e-9);
    }
}

static void
impacts (void)
{
  const gs_real g = GS_R (9.81), lo = GS_R (0.1), e = GS_R (0.8), h = 1;
  const int by_stop[] = { 1 + SENSITIVITY_BALL_PAR_G, 1 + SENSITIVITY_BALL_PAR_LO,
                          1 + SENSITIVITY_BALL_PAR_E },
            by_user[] = { 1 + SENSITIVITY_BOUNCE_PAR_G, 1 + SENSITIVITY_BOUNCE_PAR_LO,
                          1 + SENSITIVITY_BOUNCE_PAR_E };
  const thrown b = throw_back (g, lo, e, h, GS_R (0.9));
  job j = job_of (&sensitivity_ball_scene, sensitivity_ball_constants (0, 0),
                  SENSITIVITY_BALL_NCST, GS_R (0.9), 3, by_stop);
  j.x0[0] = lo + h;
  run_job (&j);
  compare_thrown ("a ball on a stop", &j, &b);
  job u = job_of (&sensitivity_bounce_scene, sensitivity_bounce_constants (0, 0),
                  SENSITIVITY_BOUNCE_NCST, GS_R (0.9), 3, by_user);
  u.x0[0] = lo + h;
  run_job (&u);
  compare_thrown ("a ball that an event of the user throws back", &u, &b);
}

/* --------------------------------------------------------------------------------- differences */

/* the last states of the run without columns where number k of its parameters is h more */
typedef const gs_real *constants_with (int k, gs_real h);
typedef void start_with (job *j);

static void
last_state (const job *with, constants_with *constants, start_with *start, int k, gs_real h,
            gs_real *x)
{
  job j = *with;
  j.nc = 0;
  j.cst = constants (k, h);
  start (&j);
  run_job (&j);
  check ("... the run beside it", j.info == 0);
  for (int i = 0; i < j.s->nx; i++)
    x[i] = state_of (&j, 1, i);
}

/* central differences of order 4 of the last states by number k of the parameters */
static void
differences (const job *j, constants_with *constants, start_with *start, int k, gs_real *dx)
{
  gs_real x[4][MOST];
  const gs_real h = STEP;
  last_state (j, constants, start, k, -2 * h, x[0]);
  last_state (j, constants, start, k, -h, x[1]);
  last_state (j, constants, start, k, h, x[2]);
  last_state (j, constants, start, k, 2 * h, x[3]);
  for (int i = 0; i < j->s->nx; i++)
    dx[i] = (x[0][i] - 8 * x[1][i] + 8 * x[2][i] - x[3][i]) / (12 * h);
}

static void
compare_differences (const char *what, const job *j, constants_with *constants, start_with *start)
{
  char text[100];
  for (int k = 0; k < j->nc; k++)
    {
      gs_real dx[MOST];
      differences (j, constants, start, j->col[k] - 1, dx);
      for (int i = 0; i < j->s->nx; i++)
        {
          snprintf (text, sizeof text, "... state %d of %s by parameter %d", i, what, j->col[k]);
          close_to (text, column_of (j, 1, k, i), dx[i], ROUGH);
        }
    }
  constants (0, 0);
}

static void
sampled_start (job *j)
{
  j->x0[1] = GS_R (0.3);
  j->on_the_way = 8;
}

static void
sampled (void)
{
  const int col[] = { 1 + SENSITIVITY_SAMPLED_PAR_J, 1 + SENSITIVITY_SAMPLED_PAR_KP,
                      1 + SENSITIVITY_SAMPLED_PAR_KI };
  job j = job_of (&sensitivity_sampled_scene, sensitivity_sampled_constants (0, 0),
                  SENSITIVITY_SAMPLED_NCST, GS_R (0.75), 3, col);
  sampled_start (&j);
  run_job (&j);
  check ("a digital controller runs", j.info == 0);
  check ("... and holds outputs, from the start on", j.held >= 8 && j.first_held[0] <= 0);
  compare_differences ("the wheel", &j, sensitivity_sampled_constants, sampled_start);
}

/* the crank at rest, its chain closed */
static void
crank_start (job *j)
{
  static const gs_real start[] = { GS_R (0.5), GS_R (-0.7), GS_R (0.66) };
  gs_real res[4];
  memset (j->x0, 0, sizeof j->x0);
  for (int i = 0; i < 3; i++)
    j->x0[i] = start[i];
  j->inputs[0] = 12;
  j->loops = 1;
  check ("... the chain closes", j->s->prj (0, j->x0, j->cst, res) == 0);
}

/* the columns at the start, by differences of the closure */
static void
crank_columns (job *j)
{
  const gs_real h = STEP;
  const int nx = j->s->nx;
  for (int k = 0; k < j->nc; k++)
    for (int side = -2; side <= 2; side++)
      {
        job other = *j;
        const gs_real weight[] = { 1, -8, 0, 8, -1 };
        other.cst = sensitivity_crank_constants (j->col[k] - 1, (gs_real)side * h);
        if (side != 0)
          crank_start (&other);
        for (int i = 0; i < nx; i++)
          j->x0[nx * (k + 1) + i] += weight[side + 2] * other.x0[i] / (12 * h);
      }
  sensitivity_crank_constants (0, 0);
}

static void
closed_chain (void)
{
  const int col[] = { 1, 2, 4 };
  job j = job_of (&sensitivity_crank_scene, sensitivity_crank_constants (0, 0),
                  SENSITIVITY_CRANK_NCST, GS_R (0.1), 3, col);
  crank_start (&j);
  crank_columns (&j);
  run_job (&j);
  check ("a slider-crank runs", j.info == 0);
  compare_differences ("the slider-crank", &j, sensitivity_crank_constants, crank_start);
  j.loops = 0;
  run_job (&j);
  check ("... with Baumgarte's method, too", j.info == 0);
  backwards ("the slider-crank runs forward", &j);
}

/* ------------------------------------------------------------------------------------ backwards */

/* the run of j forward and backwards: the derivatives of each state at its end by its parameters
   and its start, beside those of columns along the same steps, which differ by rounding alone */
static void
backwards (const char *what, job *j)
{
  const int nx = j->s->nx;
  const gs_plan plan = { .s = j->s, .nx = nx, .constants = j->inputs };
  int *ip = zeros ((size_t)gs_wholes (&plan), sizeof *ip);
  gs_real *rp = zeros ((size_t)gs_reals (&plan), sizeof *rp), atol[MOST], states[MOST], t,
          by_start[MOST], by_parameters[MOST], worst = 0, size = 0;
  gs_kept_steps kept;
  const gs_adjoint_run run = { .scene = j->s, .cst = j->cst, .ip = ip, .rp = rp };
  gs_lay (&plan, ip, rp);
  for (int i = 0; i < nx; i++)
    atol[i] = j->rtol;
  check (what, gs_adjoint_forward (&run, j->x0, 2, j->tout, j->rtol, atol, &kept, states, &t) == 0
                 && t == j->tout[1]);
  run_along (j, &kept);
  for (int i = 0; i < nx; i++)
    {
      gs_real weights[2 * MOST] = { 0 };
      weights[nx + i] = 1;
      check ("... and back", gs_adjoint_backward (&run, &kept, weights, by_start, by_parameters,
                                                  &t) == 0 && t == j->tout[0]);
      for (int k = 0; k < j->nc; k++)
        {
          gs_real sum = j->col[k] > 0 ? by_parameters[j->col[k] - 1] : 0;
          for (int l = 0; l < nx; l++)
            sum += by_start[l] * j->x0[nx * (k + 1) + l];
          worst = gs_fmax (worst, gs_abs (sum - column_of (j, 1, k, i)));
          size = gs_fmax (size, gs_abs (sum));
        }
    }
  close_to ("... gives what columns give, relative to the largest,", worst / size, 0, BACK);
  gs_adjoint_free (&kept);
  free (ip);
  free (rp);
}

/* ends the run from the third call on */
static int
ask_thrice (void *asked, gs_real t)
{
  int *calls = asked;
  (void)t;
  return ++*calls < 3 ? 0 : GS_INTERRUPTED;
}

static void
interrupted (void)
{
  const gs_plan plan = { .s = &oscillator_scene, .nx = 2 };
  int *ip = zeros ((size_t)gs_wholes (&plan), sizeof *ip), calls = 0;
  gs_real *rp = zeros ((size_t)gs_reals (&plan), sizeof *rp), states[4], t;
  const gs_real x0[] = { 1, 0 }, atol[] = { GS_R (1e-9), GS_R (1e-9) }, stops[] = { 0, 100 };
  gs_kept_steps kept;
  const gs_adjoint_run run = { .scene = &oscillator_scene, .cst = oscillator_constants (0, 0),
                               .ip = ip, .rp = rp, .ask = ask_thrice, .asked = &calls };
  gs_lay (&plan, ip, rp);
  const int info = gs_adjoint_forward (&run, x0, 2, stops, GS_R (1e-9), atol, &kept, states, &t);
  check ("a run forward is ended by ask", info == GS_INTERRUPTED && calls == 3 && kept.steps > 0
                                            && kept.steps <= 3 && t > 0 && t < 100);
  gs_adjoint_free (&kept);
  free (ip);
  free (rp);
}

/* ------------------------------------------------------------------------------ several threads */

static void
at_once (void)
{
  const int col[] = { 1 + SENSITIVITY_BOUNCE_PAR_G, 1 + SENSITIVITY_BOUNCE_PAR_E };
  static gs_real constants[2][SENSITIVITY_BOUNCE_NCST + 1];
  static job alone[2], together[2];
  pthread_t thread[2];
  int same = 1;
  for (int k = 0; k < 2; k++)
    {
      memcpy (constants[k], sensitivity_bounce_constants (0, GS_R (0.5) * (gs_real)k),
              sizeof sensitivity_bounce_numbers);
      alone[k] = job_of (&sensitivity_bounce_scene, constants[k], SENSITIVITY_BOUNCE_NCST,
                         GS_R (2.9), 2, col);
      alone[k].x0[0] = 1;
      together[k] = alone[k];
      run_job (&alone[k]);
    }
  for (int k = 0; k < 2; k++)
    if (pthread_create (&thread[k], NULL, run_job, &together[k]) != 0)
      abort ();
  for (int k = 0; k < 2; k++)
    {
      pthread_join (thread[k], NULL);
      same = same && memcmp (&alone[k], &together[k], sizeof alone[k]) == 0;
    }
  check ("two runs at once find what each finds alone, to the bit",
         same && alone[0].events > 3 && alone[0].events != alone[1].events);
}

int
main (void)
{
  oscillator ();
  impacts ();
  sampled ();
  closed_chain ();
  interrupted ();
  at_once ();
  return 0;
}
