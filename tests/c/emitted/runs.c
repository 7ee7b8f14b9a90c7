/* Runs of emitted scenes by GSSIM in Fortran and in C: both call the same emitted Fortran. */
#include "emitted.h"

extern const emitted emitted_four_bar, emitted_slider_crank, emitted_event_crank,
    emitted_event_pendulum, emitted_event_ball, emitted_event_slide, emitted_event_blocks,
    emitted_sampled_crank, emitted_passage_events, emitted_parallelograms3, emitted_user_bounce,
    emitted_user_count, emitted_user_crank, emitted_user_dips, emitted_user_held,
    emitted_user_wheel, emitted_event_instant;

static test a;
static gs_real par[100];

/* a run as of bridge.h, without Baumgarte's terms but in way 1; x0 is moved onto the constraints */
static void
start (const emitted *e, int method, int way, const gs_real *x0, gs_real tend, int nt)
{
  gs_real res;
  int info;
  make (&a, &e->s, &e->f, tend, nt);
  a.iopt[GS_METHOD] = method;
  a.iopt[GS_LOOPS] = way;
  a.ropt[0] = method == 4 ? 2e-3 : 0;
  if (a.s->nlam > 0)
    {
      par[e->npar - 1] = way == 4 || way == 5 || way == 6 ? way - 2 : 1;
      if (way != 1)
        par[e->npar - 2] = par[e->npar - 3] = 0;
    }
  e->pre (par, a.cst, &info);
  memcpy (a.x0, x0, a.s->nx * sizeof (gs_real));
  if (a.s->nlam > 0)
    e->s.prj (0, a.x0, a.cst, &res);
}

/* the plan of the samples of a scene with held outputs of its devices */
static void
sample (const emitted *e, const int *held, const int *input, int ns)
{
  const int anew[10] = { 0 };
  const gs_real memory[20] = { 0 };
  gs_real period[10], delay[10];
  e->ctp (a.cst, period, delay);
  samples (&a, e->nctl, period, delay, held, anew, input, e->nxk, memory, e->nctl, ns);
}

static void
seen (int n, int least, const char *what)
{
  char text[80];
  snprintf (text, sizeof text, "... %s", what);
  holds (n >= least, text);
}

/* ------------------------------------------------------------ */

static const gs_real four_bar_x0[6] = { 1, -0.1, 1.4, 6, -1, 2 };

static void
four_bar (void)
{
  const emitted *e = &emitted_four_bar;
  char what[80];
  e->par (par);
  for (int method = 4; method <= 8; method += 4)
    for (int way = 1; way <= 6; way++)
      {
        e->par (par);
        start (e, method, way, four_bar_x0, 2, 50);
        a.rp[0] = 0.02;
        snprintf (what, sizeof what, "four_bar, method %d, way %d", method, way);
        compare (&a, what, 0);
      }
  for (int closed = 0; closed <= 1; closed++)
    {
      const gs_real motion[4] = { 2, 1, 1, 2 }, gain[6] = { 0.3, 0, 0, 0.05, 0, 0 },
                   x0[12] = { 0, 0, 0, 0, 0, 0, 1, -0.1, 1.4, 0, 0, 0 };
      start (e, 8, 2, four_bar_x0, 1, 50);
      a.iopt[GS_LOOPS] = 3;
      a.run.nb = 1;
      a.tbrk[0] = 0.5;
      if (closed)
        {
          a.ip[GS_V0] = 2;
          a.ip[GS_CLOSED] = 1;
          a.ip[GS_DERIVATIVES] = 2;
          a.ip[GS_PLANNED] = 1;
          a.ip[GS_NUMBERS] = 1;
          memcpy (a.w, four_bar_x0, 3 * sizeof (gs_real));
          polynomial (&a, GS_MOTION, 1, 2, 2, (gs_real[]){ 0, 0.5, 1 }, motion);
        }
      a.ip[GS_FEEDBACK] = 1;
      polynomial (&a, GS_REFERENCE, 6, 1, 2, (gs_real[]){ 0, 1 }, x0);
      polynomial (&a, GS_GAIN, 6, 1, 1, (gs_real[]){ 0, 1 }, gain);
      compare (&a, closed ? "four_bar, planned with feedback" : "four_bar, feedback", 0);
    }
}

static void
slider_crank (void)
{
  const emitted *e = &emitted_slider_crank;
  const gs_real x0[7] = { 0.1, -0.04, 0.7, 0, 0, 0, 0 };
  const gs_real volts[3] = { 6, 12, -3 };
  const gs_real motion[8] = { 0, 0, 2. / 3, 0, 0, 4. / 3, 0.1, 0.1 + 2. / 3 };
  for (int way = 1; way <= 6; way++)
    {
      e->par (par);
      start (e, 8, way, x0, 3, 60);
      a.ip[GS_V0] = 1;
      a.run.nb = 2;
      a.tbrk[0] = 0.8;
      a.tbrk[1] = 2;
      polynomial (&a, GS_TABLE, 1, 3, 1, (gs_real[]){ 0, 0.8, 2, 3 }, volts);
      compare (&a, "slider_crank, a table of volts", 0);
    }
  e->par (par);
  start (e, 8, 2, x0, 2, 60);
  a.ip[GS_V0] = 2;
  a.ip[GS_CLOSED] = 1;
  a.ip[GS_DERIVATIVES] = 3;
  a.ip[GS_PLANNED] = 1;
  a.ip[GS_NUMBERS] = 1;
  a.ip[GS_INTERNAL] = 7;
  memcpy (a.w, x0, 3 * sizeof (gs_real));
  polynomial (&a, GS_MOTION, 1, 2, 4, (gs_real[]){ 0, 1, 2 }, motion);
  a.run.nb = 1;
  a.tbrk[0] = 1;
  compare (&a, "slider_crank, a planned motion through the motor", 0);
  start (e, 9, 2, x0, 3, 60);
  a.rp[0] = 12;
  compare (&a, "slider_crank, method 9", 0);
}

static void
event_crank (void)
{
  const emitted *e = &emitted_event_crank;
  const gs_real x0[6] = { 0.5, -0.1, 0.84, 0, 0, 0 };
  char what[80];
  for (int way = 2; way <= 6; way += way == 3 ? 3 : 1)
    for (int method = 4; method <= 8; method += 4)
      {
        e->par (par);
        start (e, method, way, x0, 4, 80);
        a.iopt[GS_WATCH] = method == 8;
        a.rp[0] = 8;
        events (&a, 2, (int[]){ 2, 1 }, (int[]){ 2, 3 }, 200);
        snprintf (what, sizeof what, "event_crank, method %d, way %d", method, way);
        compare (&a, what, 0);
        seen (a.ip[a.ip[GS_EVENTS] + 1], 5, "five events or more");
      }
  start (e, 8, 2, x0, 4, 80);
  a.s = &e->audit;
  a.f = &e->faudit;
  a.run.nx = a.run.ldx = a.s->nx + 2;
  a.atol[a.s->nx] = a.atol[a.s->nx + 1] = 1e-8;
  a.rp[0] = 8;
  events (&a, 2, (int[]){ 2, 1 }, (int[]){ 2, 3 }, 200);
  compare (&a, "event_crank with an audit", 0);
}

static void
event_pendulum (void)
{
  const emitted *e = &emitted_event_pendulum;
  for (int method = 4; method <= 8; method += 4)
    {
      e->par (par);
      par[1] = 0.01;
      start (e, method, 1, (gs_real[]){ 2, 0.03, 0, 0 }, 3, 60);
      a.rp[2] = 0.1;
      sample (e, (int[]){ 1 }, (int[]){ 4 }, 200);
      events (&a, 2, (int[]){ 2, 1 }, (int[]){ 1, 2 }, 100);
      compare (&a, method == 4 ? "event_pendulum, method 4" : "event_pendulum, method 8", 0);
      seen (a.ip[a.ip[GS_EVENTS] + 1], 5, "five events or more");
    }
}

/* modes at the start that are given: info and its port where they contradict the state */
static void
given_modes (void)
{
  static const struct { gs_real at, speed; int mode, wrong; } starts[]
    = { { 0, 1, 1, 0 }, { 0, 0, 1, 0 }, { 0, 1, 0, 1 }, { 0, -1, 1, 1 } };
  char what[80];
  for (int k = 0; k < 4; k++)
    {
      emitted_event_slide.par (par);
      start (&emitted_event_slide, 8, 1, (gs_real[]){ starts[k].at, starts[k].speed }, 2, 10);
      events (&a, 1, (int[]){ 1 }, (int[]){ 2 }, 100);
      int *ie = a.ip + a.ip[GS_EVENTS] - 1;
      ie[4] = 1;
      ie[10] = starts[k].mode;
      snprintf (what, sizeof what, "event_slide, given mode %d at %g m/s", starts[k].mode,
                starts[k].speed);
      compare (&a, what, starts[k].wrong ? 3 : 0);
      if (starts[k].wrong)
        holds (a.run.istat[GS_FAILED_INFO] == 13 && a.run.istat[GS_CAUSE] == 1,
               "... contradicts the state");
    }
}

/* long steps, functions that fall again at once, waves within a step */
static void
rough_steps (void)
{
  char what[80];
  for (int method = 4; method <= 8; method += 4)
    for (int k = 0; k < 3; k++)
      {
        const emitted *e = &emitted_event_ball;
        e->par (par);
        start (e, method, 1, (gs_real[]){ k == 2 ? 1e-6 : 1, 0, k == 2 ? 1e-3 : 0, 5 }, 5, 20);
        a.ropt[0] = method == 4 ? 0.02 * (1 + 5 * k) : 0.1;
        events (&a, 2, (int[]){ 2, 2 }, (int[]){ 1, 2 }, 150);
        snprintf (what, sizeof what, "event_ball, method %d", method);
        compare (&a, what, 0);
        e = &emitted_event_slide;
        e->par (par);
        par[1] = 1.001 + 0.01 * k;
        start (e, method, 1, (gs_real[]){ 0, k == 1 }, 20, k == 2 ? 2 : 20);
        a.ropt[0] = method == 4 ? 0.25 : 0;
        events (&a, 1, (int[]){ 1 }, (int[]){ 2 }, 100);
        snprintf (what, sizeof what, "event_slide, method %d", method);
        compare (&a, what, 0);
        e = &emitted_event_blocks;
        e->par (par);
        par[0] = 0.05;
        start (e, method, 1, (gs_real[12]){ [11] = 0.1 * k }, 8, 10);
        a.ropt[0] = method == 4 ? 0.05 : 0;
        events (&a, 6, (int[]){ 1, 1, 1, 1, 1, 1 }, (int[]){ 1, 2, 3, 4, 5, 6 }, 200);
        snprintf (what, sizeof what, "event_blocks, method %d", method);
        compare (&a, what, 0);
      }
  /* numbers that overflow */
  start (&emitted_event_blocks, 8, 1, (gs_real[12]){ [10] = 1e214, [11] = 1e252 }, 8, 10);
  events (&a, 6, (int[]){ 1, 1, 1, 1, 1, 1 }, (int[]){ 1, 2, 3, 4, 5, 6 }, 200);
  compare (&a, "event_blocks, speeds of 1e252 m/s", 2);
}

/* events of the user: bounces, counted passages, in a loop, on speeds that friction holds, faster
 * than the steps */
static void
user_events (void)
{
  static const struct
  {
    const emitted *e;
    const char *name;
    int ne, kind[8], input[8], least;
    gs_real x0[6], tend;
  } runs[] = {
    { &emitted_user_bounce, "user_bounce", 3, { 3, 5, 4 }, { 0 }, 4, { 1, 0 }, 2.5 },
    { &emitted_user_count, "user_count", 3, { 3, 3, 3 }, { 0 }, 10, { 1, 2, 0, 5 }, 60 },
    { &emitted_user_crank, "user_crank", 1, { 3 }, { 0 }, 1, { 0.5, -0.1, 0.4, 5, 0, 0 }, 1 },
    { &emitted_user_held, "user_held", 8, { 1, 1, 5, 5, 5, 5, 5, 5 }, { 1, 2 }, 20, { 0, 0.1 },
      5 },
    { &emitted_user_wheel, "user_wheel", 1, { 5 }, { 0 }, 90, { 0, 20 }, 10 } };
  char what[80];
  for (int k = 0; k < 20; k++)
    {
      const emitted *e = runs[k % 5].e;
      const int method = (int[]){ 8, 8, 9, 4 }[k / 5];
      e->par (par);
      start (e, method, e->s.nlam > 0 ? 2 : 1, runs[k % 5].x0, runs[k % 5].tend, 40);
      if (k < 5)
        a.ropt[1] = 1e-5;
      events (&a, runs[k % 5].ne, runs[k % 5].kind, runs[k % 5].input, 150);
      snprintf (what, sizeof what, "%s, method %d", runs[k % 5].name, method);
      compare (&a, what, 0);
      seen (a.ip[a.ip[GS_EVENTS] + 1], runs[k % 5].least, "its events");
    }
}

/* a place that is hardly reached: the polynomial of a step says so, or the step itself */
static void
user_dips (void)
{
  const emitted *e = &emitted_user_dips;
  int told = 0;
  begin ("user_dips");
  for (int k = 0; k < 300; k++)
    {
      e->par (par);
      par[2] = 2 + gs_pow (10, -2 - k % 7) * chance ();
      start (e, 8, 1, (gs_real[]){ 0, 0 }, 20, 4);
      a.ropt[1] = gs_pow (10, -3 - k % 5);
      events (&a, 2, (int[]){ 5, 5 }, (int[]){ 0, 0 }, 50);
      compare_silently (&a);
      told += a.ip[a.ip[GS_EVENTS] + 1] > 0;
    }
  finish ();
  seen (told, 50, "its events");
}

static void
sampled_crank (void)
{
  const emitted *e = &emitted_sampled_crank;
  for (int delayed = 0; delayed <= 1; delayed++)
    {
      e->par (par);
      if (delayed)
        par[1] = par[4] = 4e-4;
      start (e, 8, 2, (gs_real[]){ 0.3, -0.1, 0.84, 0, 0, 0 }, 0.3, 60);
      a.ip[GS_V0] = 1;
      polynomial (&a, GS_TABLE, 8, 1, 2, (gs_real[]){ 0, 1 },
                  (gs_real[]){ 0, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0.3, 6, 0, 0 });
      sample (e, (int[]){ 2, 2, 2 }, (int[]){ 1, 2, 3, 4, 7, 8 }, 100);
      compare (&a, delayed ? "sampled_crank, with delays" : "sampled_crank", 0);
    }
}

/* a switch and a sample at the end of a run, a sample at its start */
static void
event_instant (void)
{
  const emitted *e = &emitted_event_instant;
  for (int method = 4; method <= 8; method += 4)
    {
      e->par (par);
      start (e, method, 1, (gs_real[]){ 0.1, 0 }, 0.5, 10);
      sample (e, (int[]){ 1 }, (int[]){ 1 }, 20);
      events (&a, 5, (int[]){ 4, 5, 3, 3, 5 }, (int[5]){ 0 }, 20);
      compare (&a, method == 4 ? "event_instant, method 4" : "event_instant, method 8", 0);
      seen (a.ip[a.ip[GS_EVENTS] + 1], 2, "its events");
    }
}

static void
passage_events (void)
{
  const emitted *e = &emitted_passage_events;
  static const gs_real hi[7] = { 100, 3.1, 3.14, 3.15, 3.2, 9.5, 3.14159265358979312 };
  for (int i = 0; i < 7; i++)
    {
      e->par (par);
      par[2] = 0.2;
      par[3] = hi[i];
      start (e, 8, 2, (gs_real[]){ 1, 1, -1, 6, 6, -6 }, 5, 60);
      sample (e, (int[]){ 2 }, (int[]){ 3, 4 }, 50);
      events (&a, 2, (int[]){ 1, 2 }, (int[]){ 1, 2 }, 20);
      compare (&a, "passage_events", i < 6 ? 0 : 3);
      if (i == 0)
        seen (a.run.istat[GS_N_PASSED], 3, "three positions or more");
      if (i < 6)
        seen (a.ip[a.ip[GS_EVENTS] + 1], 1, "an event or more");
    }
}

static void
parallelograms (void)
{
  const emitted *e = &emitted_parallelograms3;
  const gs_real x0[14] = { 1, 1, 1, 1, -1, -1, -1, 5, 5, 5, 5, -5, -5, -5 };
  char what[80];
  for (int way = 2; way <= 6; way++)
    {
      e->par (par);
      par[0] = 3;
      start (e, 8, way, x0, 1.5, 60);
      snprintf (what, sizeof what, "parallelograms3, way %d", way);
      compare (&a, what, 0);
      seen (a.run.istat[GS_N_PASSED], 2, "two positions or more");
    }
}

/* ------------------------------------------------------------ */

/* how long the C takes beside the Fortran, least of n runs of each, one after the other */
static void
speed (const char *what, int n)
{
  gs_real c = 1e9, f = 1e9;
  for (int k = 0; k < n; k++)
    {
      c = gs_fmin (c, seconds (&a, 1));
      f = gs_fmin (f, seconds (&a, 0));
    }
  printf ("   %s: C %.3f ms, Fortran %.3f ms, ratio %.3f\n", what, 1e3 * c, 1e3 * f, c / f);
}

static void
speeds (int n)
{
  emitted_four_bar.par (par);
  start (&emitted_four_bar, 8, 2, four_bar_x0, 20, 100);
  a.run.lw = gs_room (a.s, a.run.nx, 0);
  speed ("four_bar, projection", n);
  start (&emitted_four_bar, 8, 3, four_bar_x0, 20, 100);
  a.run.lw = gs_room (a.s, a.run.nx, 0);
  speed ("four_bar, partitioning", n);
  emitted_event_pendulum.par (par);
  par[1] = 0.01;
  start (&emitted_event_pendulum, 8, 1, (gs_real[]){ 2, 0.03, 0, 0 }, 3, 60);
  sample (&emitted_event_pendulum, (int[]){ 1 }, (int[]){ 4 }, 200);
  events (&a, 2, (int[]){ 2, 1 }, (int[]){ 1, 2 }, 100);
  a.run.lw = gs_room (a.s, a.run.nx, 0);
  speed ("event_pendulum", n);
  emitted_parallelograms3.par (par);
  start (&emitted_parallelograms3, 8, 3,
         (gs_real[]){ 1, 1, 1, 1, -1, -1, -1, 5, 5, 5, 5, -5, -5, -5 }, 6, 100);
  a.run.lw = gs_room (a.s, a.run.nx, 0);
  speed ("parallelograms3, partitioning", n);
}

int
main (int argc, char **argv)
{
  if (argc > 1)
    {
      speeds (atoi (argv[1]));
      return 0;
    }
  four_bar ();
  slider_crank ();
  event_crank ();
  event_pendulum ();
  given_modes ();
  rough_steps ();
  user_events ();
  user_dips ();
  sampled_crank ();
  event_instant ();
  passage_events ();
  parallelograms ();
  return 0;
}
