/* gs_sample: sampled devices at one instant of a run: outputs whose delay is over are given out,
 * devices whose sample is due act.
 *
 * The sample k of a device is at k times its period. Instants that differ by rounding only are
 * one. There delayed outputs come first, then the devices act in their order, each with the
 * outputs that those ahead of it have left. */
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"

/* outputs first .. first + n - 1 of a device become those in from */
static void
hold (const gs_samples *a, int first, int n, const gs_real *from, gs_real *v)
{
  for (int j = first; j < first + n; j++)
    {
      a->value[j] = from[j];
      v[a->input[j] - 1] = from[j];
    }
}

/* outputs that arrive until late, the earliest first */
static void
arrive (const gs_samples *a, gs_real late, gs_real *v)
{
  for (;;)
    {
      int l = -1;
      for (int i = 0; i < a->np; i++)
        if (a->sender[i] > 0 && a->when[i] <= late && (l < 0 || a->when[i] < a->when[l]))
          l = i;
      if (l < 0)
        return;
      int device = a->sender[l] - 1, first = 0;
      for (int k = 0; k < device; k++)
        first += a->held[k];
      hold (a, first, a->held[device], a->sent + a->nh * l, v);
      a->sender[l] = 0;
    }
}

/* what device k wrote into a->v is on its way; 0 if there is no place for it */
static int
send (const gs_samples *a, int k, int first)
{
  int l = -1;
  for (int i = 0; i < a->np; i++)
    if (a->sender[i] == 0)
      l = i;
  if (l < 0)
    return 0;
  a->sender[l] = k + 1;
  a->when[l] = (gs_real)(a->next[k] - 1) * a->period[k] + a->delay[k];
  for (int j = first; j < first + a->held[k]; j++)
    a->sent[j + a->nh * l] = a->v[a->input[j] - 1];
  return 1;
}

static void
record (const gs_samples *a, int nv, gs_real t, const gs_real *v)
{
  *a->count += 1;
  if (*a->count > a->ns)
    return;
  gs_real *r = a->record + (*a->count - 1) * (1 + a->nxk + nv);
  r[0] = t;
  gs_copy (a->nxk, a->memory, r + 1);
  gs_copy (nv, v, r + 1 + a->nxk);
}

int
gs_sample (const gs_scene *s, gs_real t, const gs_real *x, const gs_real *cst, gs_real *v, int *is,
           gs_real *rs)
{
  const gs_samples a = gs_samples_of (s->nv, is, rs);
  const gs_real late = t + 8 * gs_epsilon () * gs_abs (t);
  arrive (&a, late, v);

  int old = 2; /* y: 0 of now, 1 of before others acted, 2 not yet computed */
  int first = 0;
  for (int k = 0; k < a.nc; first += a.held[k], k++)
    {
      if (! ((gs_real)a.next[k] * a.period[k] <= late))
        continue;
      if (a.ny > 0 && old + a.anew[k] > 1)
        {
          int info = s->out (t, x, v, cst, a.y);
          if (info != 0 && info != 2 && info != 3)
            return info;
          old = 0;
        }
      gs_copy (s->nv, v, a.v);
      s->ctl (k + 1, t, a.y, a.memory, cst, a.v);
      a.next[k]++;
      if (a.delay[k] > 0)
        {
          if (! send (&a, k, first))
            return -1;
        }
      else
        {
          for (int j = first; j < first + a.held[k]; j++)
            {
              a.value[j] = a.v[a.input[j] - 1];
              v[a.input[j] - 1] = a.value[j];
            }
          if (old == 0)
            old = 1;
        }
    }
  record (&a, s->nv, t, v);
  return 0;
}

static void
keep (int back, int n, gs_real *what, gs_real *kept)
{
  if (n > 0)
    gs_copy (n, back ? kept : what, back ? what : kept);
}

static void
keep_integers (int back, int n, int *what, int *kept)
{
  if (n > 0)
    memcpy (back ? what : kept, back ? kept : what, (size_t)n * sizeof *what);
}

void
gs_sample_keep (int back, int nv, int *is, gs_real *rs)
{
  const gs_samples a = gs_samples_of (nv, is, rs);
  const int nk = a.nh + a.nxk;
  keep_integers (back, 1, a.count, a.kept);
  keep_integers (back, a.nc, a.next, a.kept + 1);
  keep_integers (back, a.np, a.sender, a.kept + 1 + a.nc);
  keep (back, nk, a.value, a.keeps);
  keep (back, a.np * (1 + a.nh), a.when, a.keeps + nk);
}
