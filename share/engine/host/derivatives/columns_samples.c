/* columns_samples.c: what the samples of digital controllers do to the columns: the derivatives of
 * held outputs (vp) and memory (kp) jump as ctd says; pending outputs keep theirs until they
 * arrive. */
#include "host/derivatives/columns.h"

/* the earliest pending output that has arrived; -1: none */
static int
next_arrival (const gs_derivatives *d)
{
  int first = -1;
  for (int l = 0; l < d->nsent; l++)
    if (d->samples.sender[d->sent[l].place] == 0
        && (first < 0 || d->sent[l].when < d->sent[first].when))
      first = l;
  return first;
}

void
gs_columns_arrivals (gs_derivatives *d)
{
  const int nv = d->inner.nv;
  for (int first = next_arrival (d); first >= 0; first = next_arrival (d))
    {
      const gs_sent_outputs one = d->sent[first];
      for (int k = 0; k < d->nc; k++)
        for (int i = one.from; i < one.to; i++)
          {
            const int at = d->samples.input[i] - 1 + nv * k;
            d->vp[at] = one.inputs[at];
          }
      gs_columns_keep_inputs (d, one.when);
      for (int l = first; l < d->nsent - 1; l++)
        d->sent[l] = d->sent[l + 1];
      d->sent[--d->nsent] = one; /* its room */
    }
}

/* derivatives of the outputs by column k, s its states, under the inputs v */
static void
output_columns (gs_derivatives *d, const gs_real *v, const gs_real *s, int k)
{
  const int nx = d->inner.nx, ny = d->inner.ny, nv = d->inner.nv;
  gs_real *y = d->yp + ny * k;
  gs_columns_input_changes (d, v, s, k, d->change);
  for (int i = 0; i < ny; i++)
    {
      gs_real sum = d->col[k] > 0 ? d->outputs.p[i + ny * (d->col[k] - 1)] : 0;
      for (int j = 0; j < nx; j++)
        sum += d->outputs.c[i + ny * j] * s[j];
      for (int j = 0; j < nv; j++)
        sum += d->outputs.d[i + ny * j] * d->change[j];
      y[i] = sum;
    }
}

int
gs_columns_out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  gs_derivatives *d = gs_columns_of (cst);
  const gs_scene *s = &d->inner;
  if (gs_states_alone (d)) /* on trial */
    return s->out (t, x, v, cst, y);
  gs_columns_arrivals (d);
  const int info = s->out (t, x, v, cst, y), nx = s->nx, ny = s->ny;
  if (info != 0 && info != 2 && info != 3)
    return info;
  int bad = s->jac (t, x, v, cst, d->outputs.a, nx, d->outputs.b, nx, d->outputs.c, ny,
                    d->outputs.d, ny);
  if (bad == 0)
    bad = s->oup (t, x, v, cst, d->outputs.p, ny);
  for (int k = 0; k < d->nc; k++)
    {
      output_columns (d, v, gs_column (d, x, k), k);
      if (bad != 0) /* x is the state of the run, which is no constant */
        gs_columns_give_up (d, (gs_real *)x, k, t, 1, GS_UNDEFINED);
    }
  return info;
}

/* derivatives of inputs and memory behind a sample, into d->outputs.now and d->kp */
static void
through_sample (gs_derivatives *d)
{
  const int nv = d->inner.nv, nk = d->inner.nxk, ny = d->inner.ny, n = nv + nk;
  const gs_real *by = d->outputs.ctd;
  gs_real *z = d->outputs.z;
  for (int k = 0; k < d->nc; k++)
    {
      for (int i = 0; i < n; i++)
        {
          gs_real sum = d->col[k] > 0 ? by[i + n * (n + ny + d->col[k] - 1)] : 0;
          for (int j = 0; j < nv; j++)
            sum += by[i + n * j] * d->vp[j + nv * k];
          for (int j = 0; j < nk; j++)
            sum += by[i + n * (nv + j)] * d->kp[j + nk * k];
          for (int j = 0; j < ny; j++)
            sum += by[i + n * (n + j)] * d->yp[j + ny * k];
          z[i] = d->why[k] != 0 ? 0 : sum;
        }
      gs_copy (nv, z, d->outputs.now + nv * k);
      gs_copy (nk, z + nv, d->kp + nk * k);
    }
}

/* what device k (from 1) makes is pending */
static void
send (gs_derivatives *d, int k)
{
  const gs_samples *a = &d->samples;
  int from = 0, place = a->np - 1; /* where gs_sample puts it: the last free one */
  for (int i = 0; i < k - 1; i++)
    from += a->held[i];
  while (place > 0 && a->sender[place] != 0)
    place--;
  if (d->nsent >= a->np) /* gs_sample says that there is no place */
    return;
  gs_sent_outputs *one = d->sent + d->nsent++;
  one->place = place;
  one->from = from;
  one->to = from + a->held[k - 1];
  one->when = a->next[k - 1] * (double)a->period[k - 1] + (double)a->delay[k - 1];
  gs_copy (d->inner.nv * d->nc, d->outputs.now, one->inputs);
}

void
gs_columns_ctl (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  gs_derivatives *d = gs_columns_of (cst);
  if (gs_states_alone (d))
    {
      d->inner.ctl (k, t, y, xk, cst, v);
      return;
    }
  gs_columns_arrivals (d);
  d->inner.ctd (k, t, y, xk, cst, v, d->outputs.ctd);
  d->inner.ctl (k, t, y, xk, cst, v);
  gs_copy (d->inner.nv * d->nc, d->vp, d->outputs.now);
  through_sample (d);
  if (d->samples.delay[k - 1] > 0)
    {
      send (d, k);
      return;
    }
  gs_copy (d->inner.nv * d->nc, d->outputs.now, d->vp);
  gs_columns_keep_inputs (d, (double)t);
}
