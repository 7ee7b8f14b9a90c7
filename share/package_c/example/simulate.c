/* simulate.c: two seconds of @name@ from its start, inputs zero; prints the states at 21 times.
 * simulate METHOD [ORDER]: dp853 (if nothing is said), rk4, radau, gauss, auto. */
#include "@name@.h"
#include "host/run/run.h"

#include "start.h"

#include <stdio.h>
#include <stdlib.h>

enum { NX = @NAME@_NX, TIMES = 21 };
extern const gs_description @prefix@_about;

static void
show (const gs_run_result *r)
{
  for (int k = 0; k < r->rows; k++)
    {
      printf ("%4.1f", r->times[k]);
      for (int j = 0; j < NX; j++)
        printf (" %13.6g", r->x[NX * k + j]);
      printf ("\n");
    }
  if (r->ended)
    printf ("an event has ended the run; ");
  printf ("info %d, %d steps, t = %g s\n", r->info, r->istat[GS_N_STEPS],
          r->rstat[GS_T_REACHED]);
}

int
main (int count, char **words)
{
  @prefix@_parameters par;
  double *cst = calloc (@NAME@_NCST + 1, sizeof *cst);
  double times[TIMES], x0[NX], atol[NX], ropt[3] = { 0, 1e-9, 0 };
  double *x = calloc (NX * TIMES, sizeof *x), *v = calloc ((NV + 1) * TIMES, sizeof *v), res;
  const int loops = s->nlam > 0 && s->con && s->prj;
  int iopt[6] = { radau ? 0 : 8, loops || s->nq > s->nu ? WAY : 1, loops, 0, loops && s->kin, 0 };
  /* all inputs are zero; samples are not recorded */
  const gs_plan plan = { .s = s, .nx = NX, .on_the_way = 8 * s->nctl, .events = 1000 };
  int *ip = calloc ((size_t)gs_wholes (&plan), sizeof *ip);
  double *rp = calloc ((size_t)gs_reals (&plan), sizeof *rp);
  @prefix@_par (&par);
  int info = @prefix@_pre (&par, cst);
  gs_lay (&plan, ip, rp);
  if (info == 0)
    info = gs_due_from (s, 0, cst, ip, rp);
  memcpy (x0, start, sizeof x0);
  if (info == 0 && s->prj)
    s->prj (0, x0, cst, &res);
  for (int k = 0; k < TIMES; k++)
    times[k] = 0.1 * k;
  for (int k = 0; k < NX; k++)
    atol[k] = 1e-9 * nominal[k];
  gs_integration run = { .nx = NX, .x0 = x0, .nt = TIMES, .tout = times, .iopt = iopt, .ropt = ropt,
                 .atol = atol, .ip = ip, .rp = rp, .cst = cst, .xout = x, .ldx = NX, .vout = v,
                 .ldv = NV > 1 ? NV : 1 };
  run.lw = gs_room (s, NX, 0);
  run.w = calloc ((size_t)run.lw, sizeof *run.w);
  if (info == 0)
    info = radau ? gs_radau (s, &run, &implicit) : gs_integrate (s, &run);
  for (int k = 0; k < run.istat[GS_N_OUTPUTS]; k++)
    {
      printf ("%4.1f", times[k]);
      for (int j = 0; j < NX; j++)
        printf (" %13.6g", x[NX * k + j]);
      printf ("\n");
    }
  if (info == GS_ENDED)
    printf ("an event has ended the run; ");
  printf ("info %d, %d steps, t = %g s\n", info, run.istat[GS_N_STEPS], run.rstat[GS_T_REACHED]);
  free (cst);
  free (ip);
  free (rp);
  free (x);
  free (v);
  free (run.w);
  return info != 0 && info != GS_ENDED;
}
