/* simulate.c: two seconds of @name@ from its start, inputs zero, by the method of Dormand and
 * Prince; prints the states at 21 times. The plan of a run (ip, rp) is laid out as gsmbp/inputs.h,
 * gsmbp/events.h and the heads of the run time say. */
#include "@name@.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

#include "start.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
  NX = @NAME@_NX, NV = @NAME@_NV, NY = @NAME@_NY, NXK = @NAME@_NXK,
  TIMES = 21,
  PLACES = 8 * DEVICES, /* outputs on their way */
  INTEGERS = GS_NUMBERS + 10 + 6 * EVENTS + 10 + 3 * DEVICES + HELD + PLACES,
  NUMBERS = NV + 1 + 5 * EVENTS + 3 * NX + 2 * DEVICES + HELD + NXK + NY + NV
            + PLACES * (1 + HELD) + 1
};

static int ip[INTEGERS];
static double rp[NUMBERS];

/* the inputs are zero: a constant at rp[0] */
static int
constants (void)
{
  ip[GS_TABLE + 3] = 1;
  ip[GS_DERIVATIVES] = DERIVATIVES;
  return NV + 1;
}

/* the ports that stick or hit stops, from ip[i] and rp[r] on: no records are kept */
static void
events (int *i, int *r)
{
  if (EVENTS == 0)
    return;
  int *ie = ip + *i;
  ip[GS_EVENTS] = *i + 1;
  ip[GS_EVENTS + 1] = *r + 1;
  ie[0] = EVENTS;
  for (int k = 0; k < EVENTS; k++)
    {
      ie[10 + EVENTS + k] = event_input[k];
      ie[10 + 2 * EVENTS + k] = event_kind[k];
    }
  *i += 10 + 6 * EVENTS;
  *r += 5 * EVENTS + 3 * NX;
}

/* the sampled devices, the first sample at t = 0 */
static void
samples (int i, int r, const double *cst)
{
  int *is = ip + i, *held = is + 10 + 3 * DEVICES;
  if (DEVICES == 0)
    return;
  ip[GS_SAMPLES] = i + 1;
  ip[GS_SAMPLES + 1] = r + 1;
  ip[GS_HELD] = HELD;
  ip[GS_HELD + 1] = i + 11 + 3 * DEVICES;
  ip[GS_HELD_AT] = r + 1 + 2 * DEVICES;
  memcpy (is, (int[]){ DEVICES, NXK, NY, HELD, PLACES, 0 }, 6 * sizeof (int));
  for (int k = 0; k < DEVICES; k++)
    {
      is[10 + DEVICES + k] = device_outputs[k];
      is[10 + 2 * DEVICES + k] = device_again[k];
    }
  for (int k = 0; k < HELD; k++)
    held[k] = held_input[k];
  @prefix@_scene.ctp (cst, rp + r, rp + r + DEVICES);
  for (int k = 0; k < NXK; k++)
    rp[r + 2 * DEVICES + HELD + k] = memory[k];
}

int
main (void)
{
  const gs_scene *s = &@prefix@_scene;
  @prefix@_parameters par;
  double *cst = calloc (@NAME@_NCST + 1, sizeof *cst);
  double times[TIMES], x0[NX], atol[NX], ropt[3] = { 0, 1e-9, 0 };
  double *x = calloc (NX * TIMES, sizeof *x), *v = calloc ((NV + 1) * TIMES, sizeof *v), res;
  const int loops = s->nlam > 0 && s->con && s->prj;
  int iopt[6] = { 8, loops || s->nq > s->nu ? WAY : 1, loops, 0, loops && s->kin, 0 };
  int i = GS_NUMBERS, r = constants (), info;
  @prefix@_par (&par);
  info = @prefix@_pre (&par, cst);
  memcpy (x0, start, sizeof x0);
  if (info == 0 && s->prj)
    s->prj (0, x0, cst, &res);
  for (int k = 0; k < TIMES; k++)
    times[k] = 0.1 * k;
  for (int k = 0; k < NX; k++)
    atol[k] = 1e-9 * nominal[k];
  events (&i, &r);
  samples (i, r, cst);
  gs_run run = { .nx = NX, .x0 = x0, .nt = TIMES, .tout = times, .iopt = iopt, .ropt = ropt,
                 .atol = atol, .ip = ip, .rp = rp, .cst = cst, .xout = x, .ldx = NX, .vout = v,
                 .ldv = NV > 1 ? NV : 1 };
  run.lw = gs_room (s, NX, DERIVATIVES);
  run.w = calloc (run.lw, sizeof *run.w);
  if (info == 0)
    info = gssim (s, &run);
  for (int k = 0; k < run.istat[GS_N_OUTPUTS]; k++)
    {
      printf ("%4.1f", times[k]);
      for (int j = 0; j < NX; j++)
        printf (" %13.6g", x[NX * k + j]);
      printf ("\n");
    }
  printf ("info %d, %d steps, t = %g s\n", info, run.istat[GS_N_STEPS], run.rstat[GS_T_REACHED]);
  free (cst);
  free (x);
  free (v);
  free (run.w);
  return info != 0;
}
