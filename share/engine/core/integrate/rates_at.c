/* gs_rates_at: the right-hand side under its inputs: v by gs_inputs_of_run, xd by rhs.
 *
 * v is kept where it is constant. istat[GS_N_RHS] counts the calls, istat[GS_N_RANK_LOST]
 * those where the constraints lost rank (rhs returned 2: its result is usable, multipliers are not
 * unique), istat[GS_N_ANGLES] those close to a singularity of orientation angles (3). */

#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

int
gs_rates_at (const gs_system *g, gs_real t, int side, gs_real *x, gs_real *xd)
{
  return gs_rates_from (g, t, t, t, side, x, xd);
}

static int
failed (const gs_system *g, int info, int which)
{
  g->istat[GS_FAILED_INFO] = info;
  g->istat[GS_FAILED] = which;
  return info;
}

/* the calls istat[k] that are counted, with their first and last time */
static void
count (const gs_system *g, int k, gs_real t)
{
  gs_real *when = g->rstat + 2 * k - 5;
  if (g->istat[k] == 0)
    when[0] = t;
  when[1] = t;
  g->istat[k]++;
}

/* The stages of gs_step_passage that lie beyond a jump of the inputs, at tv, have those before it,
 * continued. With side < 0 rhs is called just before t. */
int
gs_rates_from (const gs_system *g, gs_real t, gs_real tv, gs_real tf, int side, gs_real *x,
               gs_real *xd)
{
  int info = 0;
  if (g->p[GS_WAY] > 0)
    info = gs_complete_state (g->s, t, x, g->cst, g->p);
  if (info != 0)
    return failed (g, info, GS_AT_PARTITION);
  if (g->ip[GS_V0] != 0 || g->ip[GS_FEEDBACK] != 0)
    {
      if (tf >= tv && tf <= tv)
        info = gs_inputs_of_run (g->s, tv, side, x, g->nx, g->ip, g->rp, g->cst, g->v, g->w);
      else
        info = gs_inputs_continued (g, tv, tf, x);
    }
  if (info != 0)
    return failed (g, info, GS_AT_INPUTS);
  info = g->s->rhs (gs_time_beside (t, side), x, g->v, g->cst, xd);
  g->istat[GS_N_RHS]++;
  if (info == 2 || info == 3)
    count (g, info + 5, t);
  else if (info != 0)
    return failed (g, info, GS_AT_RHS);
  return 0;
}

/* By the polynomial of degree 5 through six values as far from tv as tf at most, so that five
 * derivatives are continuous at tv. */
int
gs_inputs_continued (const gs_system *g, gs_real tv, gs_real tf, const gs_real *x)
{
  const int nv = g->s->nv;
  gs_real *vk = g->v + nv, z[6];
  for (int k = 0; k < 6; k++)
    {
      gs_real s = gs_sin (gs_atan (1) * (gs_real)(2 * k + 1) / 6);
      z[k] = -(s * s);
    }
  for (int i = 0; i < nv; i++)
    g->v[i] = 0;
  for (int k = 0; k < 6; k++)
    {
      int info = gs_inputs_of_run (g->s, tv + z[k] * (tf - tv), 1, x, g->nx, g->ip, g->rp, g->cst,
                                   vk, g->w);
      if (info != 0)
        return info;
      gs_real s = 1;
      for (int j = 0; j < 6; j++)
        if (j != k)
          s = s * (1 - z[j]) / (z[k] - z[j]);
      for (int i = 0; i < nv; i++)
        g->v[i] += s * vk[i];
    }
  return 0;
}
