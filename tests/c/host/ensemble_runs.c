/* ensemble_runs.c: share/engine/host/ensemble and lanes on emitted scenes: an oscillator, a ball
 * with events of the user, a closed chain with a motor. Runs against single runs, bit for bit; in
 * lanes against them within the tolerance; closed forms; the same bytes by any number of threads;
 * rows that fail; an interrupt in the middle. A line for each check. */
#include "ensemble_runs.h"

#include "oscillator.h"
#include "sensitivity_bounce.h"
#include "sensitivity_crank.h"

#define CONSTANTS(name)                                                                            \
  static int name##_constants (const gs_real *par, gs_real *cst)                                   \
  {                                                                                                \
    return name##_pre ((const name##_parameters *)par, cst);                                       \
  }
CONSTANTS (oscillator)
CONSTANTS (sensitivity_bounce)
CONSTANTS (sensitivity_crank)

#ifndef GSMBP_QUAD
#include "lanes_by_one.h"
LANES_BY_ONE (oscillator, OSCILLATOR_NPAR, OSCILLATOR_NCST, 0, 0)
LANES_BY_ONE (sensitivity_bounce, SENSITIVITY_BOUNCE_NPAR, SENSITIVITY_BOUNCE_NCST, 0, 1)
LANES_BY_ONE (sensitivity_crank, SENSITIVITY_CRANK_NPAR, SENSITIVITY_CRANK_NCST, 1, 0)
#define LANES(name) &name##_lanes
#else
#define LANES(name) NULL
#endif

#define SUBJECT(name, NAME, which_, scatter_, tend_, ...)                                          \
  static subject name##_subject (void)                                                             \
  {                                                                                                \
    subject j = { #name, &name##_scene, name##_constants, LANES (name), NAME##_NPAR, NAME##_NCST,  \
                  which_, { 0 }, { __VA_ARGS__ }, scatter_, tend_ };                               \
    name##_par ((name##_parameters *)j.par);                                                       \
    return j;                                                                                      \
  }
SUBJECT (oscillator, OSCILLATOR, 2, GS_R (0.3), 3, 1, 0)
SUBJECT (sensitivity_bounce, SENSITIVITY_BOUNCE, 2, GS_R (0.05), 2, 1, 0)
/* the crank lies along the x axis */
SUBJECT (sensitivity_crank, SENSITIVITY_CRANK, 5, 0, 0.4, 0, 0, GS_R (0.7))

/* each run is that of gs_integrate, or of the implicit method, by itself */
static void
against_single (const given *g, const found *f, const char *of)
{
  const int nx = g->j->s->nx;
  int equal = 1;
  for (int i = 0; i < N; i += 5)
    {
      gs_real x[NX * NT];
      int info;
      const int calls = single (g, i, x, &info);
      equal &= info == (int)f->info[2 * i] && calls == (int)f->counts[GS_COUNTED * i + GS_N_RHS];
      for (int t = 0; t < NT && info == 0; t++)
        for (int k = 0; k < nx; k++)
          equal &= (double)x[nx * t + k] == state_of (f, g, i, k, t);
    }
  check ("as single runs, bit for bit", of, equal);
}

/* the largest difference relative to 1 and more; 1e300 where one run ended in another way */
static double
apart (const found *a, const found *b)
{
  double most = 0;
  for (int k = 0; k < N * NX * NT; k++)
    if (isnan (a->x[k]) != isnan (b->x[k]))
      most = 1e300;
    else if (! isnan (a->x[k]))
      most = fmax (most, fabs (a->x[k] - b->x[k]) / (1 + fabs (b->x[k])));
  return memcmp (a->info, b->info, sizeof a->info) == 0 ? most : 1e300;
}

/* x of a mass on a spring from its start */
static void
against_closed_form (const given *g, const found *f, const char *of)
{
  double off = 0;
  for (int i = 0; i < N; i++)
    {
      const double w = sqrt ((double)(g->table[i] / g->j->par[0])), t = (double)g->tout[NT - 1];
      const double x0 = (double)g->starts[2 * i], v0 = (double)g->starts[2 * i + 1];
      const double x = x0 * cos (w * t) + v0 / w * sin (w * t);
      off = fmax (off, fabs (state_of (f, g, i, 0, NT - 1) - x));
    }
  check ("the closed form within 1e-7", of, off < 1e-7);
}

/* one subject by one method, each by 1, 2 and 5 threads, without lanes and in lanes */
static void
compare (const subject *j, int method, gs_implicit_method *implicit)
{
  static found one, many, lanes;
  given g;
  char of[80];
  snprintf (of, sizeof of, "%s, method %d", j->name, method);
  give (&g, j, method, 0);
  g.e.method = implicit;
  g.implicit = (gs_implicit){ .order = 5 };
  run_all (&g, 1, &one);
  run_all (&g, 2, &many);
  int equal = same (&one, &many), once = 1;
  forget (&many);
  run_all (&g, 5, &many);
  equal &= same (&one, &many);
  for (int i = 0; i < N; i++)
    once &= many.taken[i] == 1;
  check ("every row is taken once", of, once);
  check ("the same bytes by 1, 2 and 5 threads", of, equal);
  against_single (&g, &one, of);
  if (j->s == &oscillator_scene)
    against_closed_form (&g, &one, of);
  forget (&many);
  if (j->lanes && method != 0)
    {
      g.e.lanes = j->lanes;
      run_all (&g, 1, &lanes);
      run_all (&g, 3, &many);
      check ("runs are in lanes", of, gs_ensemble_in_lanes (&g.e));
      check ("in lanes the same bytes by 1 and 3 threads", of, same (&lanes, &many));
      check ("in lanes as without within 1e-7", of, apart (&lanes, &one) < 1e-7);
      forget (&many);
      forget (&lanes);
    }
  forget (&one);
  take_away (&g);
}

/* a parameter that is too large, a start that is no number or off the constraints, a row that is
 * broken: they fail alone */
static void
failing (const subject *j, int lanes)
{
  static found good, bad;
  given g;
  const char *broken[N] = { NULL };
  char of[80];
  snprintf (of, sizeof of, "%s with rows that fail%s", j->name, lanes ? ", in lanes" : "");
  const int closed = j->s->nlam > 0;
  give (&g, j, 8, lanes);
  g.e.check = closed;
  run_all (&g, 2, &good);
  g.table[4] = GS_R (-1.1) * GS_HUGE;
  g.starts[9 * j->s->nx + (closed ? 2 : 0)] = closed ? GS_R (0.8) : GS_INFINITY;
  broken[20] = "a rule";
  g.rows.broken = broken;
  run_all (&g, 2, &bad);
  int equal = 1;
  for (int i = 0; i < N; i++)
    if (i != 4 && i != 9 && i != 20)
      equal &= memcmp (good.x + NT * j->s->nx * i, bad.x + NT * j->s->nx * i,
                       sizeof (double) * (size_t)(NT * j->s->nx)) == 0
               && good.info[2 * i] == bad.info[2 * i];
  check ("the others are the same, bit for bit", of, equal);
  check ("pre refuses a parameter", of, bad.info[2 * 4 + 1] != 0 && bad.taken[4] == 1
         && bad.reason[4] && strstr (bad.reason[4], "its parameters cannot be: ") == bad.reason[4]);
  if (closed)
    check ("a start is refused with a message", of,
           bad.info[2 * 9] == GS_ROUTINE_FAILED && bad.reason[9] && bad.reason[9][0]);
  else
    check ("a start that is no number is out of range", of, bad.info[2 * 9] < 0);
  check ("one that is broken is not begun", of,
         bad.taken[20] == 1 && isnan (bad.x[NT * j->s->nx * 20])
           && bad.counts[GS_COUNTED * 20 + GS_N_RHS] == 0);
  check ("... and says why; what did not fail says nothing", of,
         bad.reason[20] && strcmp (bad.reason[20], "a rule") == 0 && ! bad.reason[19]);
  forget (&good);
  forget (&bad);
  take_away (&g);
}

/* ends all runs after so many questions */
typedef struct
{
  pthread_mutex_t lock;
  int asked, until, done;
} patience;

static int
ask (void *data, gs_real t)
{
  patience *p = data;
  (void)t;
  pthread_mutex_lock (&p->lock);
  const int over = ++p->asked > p->until;
  pthread_mutex_unlock (&p->lock);
  return over ? GS_INTERRUPTED : 0;
}

static void
progress (void *data, int done)
{
  ((patience *)data)->done = done;
}

static void
interrupted (const subject *j, int method, int lanes)
{
  static found f;
  given g;
  patience p = { .until = 1 << 30 };
  char of[80];
  snprintf (of, sizeof of, "%s, method %d, interrupted%s", j->name, method,
            lanes ? ", in lanes" : "");
  pthread_mutex_init (&p.lock, NULL);
  give (&g, j, method, lanes);
  g.e.run.ask = ask;
  g.e.run.asked = &p;
  for (int turn = 0; turn < 2; turn++)
    {
      memset (&f, 0, sizeof f);
      f.all = (gs_results){ .info = f.info, .values = f.values, .reason = f.reason };
      p.asked = p.done = 0;
      if (gs_run_ensemble (&g.e, &g.rows, 2, count_and_keep, &f, progress) != 0)
        abort ();
      p.until = p.asked / 2;   /* the middle, in the second turn */
      if (turn == 0)
        check ("progress says how many are done", of, p.done == N);
    }
  int whole = 0, cut = 0, others = 0, early = 1;
  for (int i = 0; i < N; i++)
    {
      const int info = (int)f.info[2 * i];
      whole += info == GS_DONE || info == GS_ENDED;
      cut += info == GS_INTERRUPTED;
      others += f.taken[i] != 1;
      if (info == GS_INTERRUPTED)
        early &= f.values[GS_MEASURED * i + GS_T_REACHED] < j->tend;
    }
  check ("some runs are whole, the others end before their time", of,
         cut > 0 && whole + cut == N && others == 0 && early && (lanes || whole > 0));
  forget (&f);
  take_away (&g);
  pthread_mutex_destroy (&p.lock);
}

int
main (void)
{
  subject all[] = { oscillator_subject (), sensitivity_bounce_subject (),
                    sensitivity_crank_subject () };
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
    {
      compare (&all[k], 8, NULL);
      compare (&all[k], 4, NULL);
    }
  interrupted (&all[0], 8, 0);
  interrupted (&all[2], 4, 0);
  failing (&all[0], 0);
  failing (&all[2], 0);
#ifndef GSMBP_QUAD
  compare (&all[0], 0, gs_radau);
  interrupted (&all[0], 8, 1);
  interrupted (&all[1], 8, 1);
  interrupted (&all[2], 4, 1);
  failing (&all[0], 1);
  failing (&all[2], 1);
#endif
  return 0;
}
