/* The largest eigenvalues of right-hand sides, as gs_largest_eigenvalue finds them, all lanes at
   once. */
#include "host/lanes/lanes.h"

#include <float.h>
#include <math.h>

#include "gsmbp/arith.h"

/* what an iteration knows of a lane */
typedef struct
{
  double old, sum, part;
  int equal;
} growth;

/* whether an eigenvalue of 1/h can still be there */
static int
is_possible (growth *k, double h)
{
  k->part = gs_min (1e300, k->part * k->old * h);
  return k->part >= 1e-4;
}

/* after a turn that let the change grow so: has it ended? Then the eigenvalue, else 0 */
static double
settled (growth *k, double now, int turn)
{
  k->equal = fabs (now - k->old) > 0.02 * now ? 0 : k->equal + 1;
  k->old = now;
  k->sum += turn > 8 ? log (now) : 0;
  return k->equal == 3 ? now : turn == 32 ? exp (k->sum / 24) : 0;
}

/* where to the iteration looks first, one by the nominal sizes of the states */
static void
begin (const gs_lane_group *g, gs_lane *change, gs_lane *size)
{
  const double rtol = g->e->run.ropt[1];
  for (int i = 0; i < g->nx; i++)
    {
      const double least = rtol > 0 ? g->e->run.atol[i] / rtol : 1;
      const double first = 0.5 + fmod (0.618 * (i + 1), 1.0);
      for (int l = 0; l < GS_LANES; l++)
        {
          const double usual = fabs (g->x[i][l]) + least, one = usual > 0 ? usual : 1;
          size[i][l] = 1 / one;
          change[i][l] = first * one;
        }
    }
}

/* the states xs next to those of the run; lanes that the change does not lead away take part no
 * more */
static void
states_apart (gs_lane_group *g, double d, gs_lane *change, gs_lane *size, double *goes)
{
  gs_lane s = { 0 };
  for (int i = 0; i < g->nx; i++)
    for (int l = 0; l < GS_LANES; l++)
      s[l] = gs_max (s[l], fabs (change[i][l]) * size[i][l]);
  for (int l = 0; l < GS_LANES; l++)
    {
      goes[l] = s[l] > 0 && s[l] <= 1e300 ? goes[l] : 0;
      s[l] = goes[l] > 0.5 ? d / s[l] : 0;
    }
  for (int i = 0; i < g->nx; i++)
    for (int l = 0; l < GS_LANES; l++)
      g->xs[i][l] = goes[l] > 0.5 ? g->x[i][l] + s[l] * change[i][l] : g->x[i][l];
}

/* the change of the rates, from base; its largest entry relative to the sizes, and which it is */
static void
measure (const gs_lane_group *g, gs_lane *base, gs_lane *size, gs_lane *change,
         double *most, double *at)
{
  for (int l = 0; l < GS_LANES; l++)
    {
      most[l] = 0;
      at[l] = 1;
    }
  for (int i = 0; i < g->nx; i++)
    for (int l = 0; l < GS_LANES; l++)
      {
        change[i][l] -= base[i][l];
        const double s = fabs (change[i][l]) * size[i][l];
        at[l] = s > most[l] ? i + 1 : at[l];
        most[l] = gs_max (most[l], s);
      }
}

static int
is_fine (int info)
{
  return info == 0 || info == 2 || info == 3;
}

/* After the first stage of a step, by the rates that it leaves; the stages after it are
 * workspace. */
void
gs_lane_eigenvalues (gs_lane_group *g, const int *due, double *rho, int *state)
{
  const double d = sqrt (DBL_EPSILON);
  gs_lane *base = g->f;
  gs_lane *change = g->f + g->nx, *size = g->f + 2 * g->nx, most, at;
  growth known[GS_LANES];
  double *goes = g->live;
  begin (g, change, size);
  for (int k = 0; k < GS_LANES; k++)
    {
      known[k] = (growth){ .part = 1 };
      goes[k] = due[k] && is_fine (g->info[k]);
      rho[k] = 0;
      state[k] = 1;
      if (due[k])   /* others may have no run */
        g->run[k].m.run.istat[GS_N_STABILITY]++;
    }
  int some = 1;
  for (int turn = 1; turn <= 32 && some; turn++)
    {
      states_apart (g, d, change, size, goes);
      gs_lane_rates (g, g->xs, change);
      measure (g, base, size, change, most, at);
      some = 0;
      for (int k = 0; k < GS_LANES; k++)
        if (goes[k] > 0)
          {
            const double now = most[k] / d;
            const int fine = now > 0 && is_fine (g->info[k]);
            g->run[k].m.run.istat[GS_N_STABILITY]++;
            state[k] = (int)at[k];
            rho[k] = fine ? settled (&known[k], now, turn) : 0;
            goes[k] = fine && rho[k] <= 0 && is_possible (&known[k], fabs (g->step[k]) / 2.78);
            some |= goes[k] > 0;
          }
    }
}
