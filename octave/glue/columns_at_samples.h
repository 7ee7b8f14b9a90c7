// What the samples of digital controllers do to the derivatives that a run carries: those of held
// outputs (VP) and memory jump as CTD says; outputs on their way keep theirs until they arrive.
#pragma once

#include "columns_at_events.h"

// outputs that have arrived, the earliest first
static void
arrivals (carried& c)
{
  const gs_samples s = c.plan->samples ();
  for (;;)
    {
      auto first = c.sent.end ();
      for (auto one = c.sent.begin (); one != c.sent.end (); ++one)
        if (s.sender[one->place] == 0 && (first == c.sent.end () || one->when < first->when))
          first = one;
      if (first == c.sent.end ())
        return;
      for (int k = 0; k < c.count (); k++)
        for (int i = first->from; i < first->to; i++)
          c.vp[s.input[i] - 1 + S.nv * k] = first->vp[s.input[i] - 1 + S.nv * k];
      keep_inputs (c, first->when);
      c.sent.erase (first);
    }
}

// OUT, and the derivatives of the outputs
extern "C" void
gsmbp_outputs_with_columns (const number *t, const number *x, const number *v, const number *cst,
                            number *y, int *info)
{
  carried& c = *the_columns;
  if (states_alone (c))   // on trial
    {
      routine ("out") (t, x, v, cst, y, info);
      return;
    }
  arrivals (c);
  routine ("out") (t, x, v, cst, y, info);
  if (*info != 0 && *info != 2 && *info != 3)
    return;
  const int nx = S.nx, ny = S.ny, nv = S.nv, ld = std::max (1, nx), ldy = std::max (1, ny);
  reals a = room (nx * nx), b = room (nx * nv), cm = room (ny * nx), d = room (ny * nv),
        p = room (ny * S.nsp), dv = room (nv);
  int bad = 0;
  routine ("jac") (t, x, v, cst, &a[0], &ld, &b[0], &ld, &cm[0], &ldy, &d[0], &ldy, &bad);
  if (bad == 0)
    routine ("oup") (t, x, v, cst, &p[0], &ldy, &bad);
  for (int k = 0; k < c.count (); k++)
    {
      input_columns (c, v, x + nx * (k + 1), k, &dv[0]);
      for (int i = 0; i < ny; i++)
        {
          number sum = c.col[k] > 0 ? p[i + ny * (c.col[k] - 1)] : number (0);
          for (int j = 0; j < nx; j++)
            sum += cm[i + ny * j] * x[j + nx * (k + 1)];
          for (int j = 0; j < nv; j++)
            sum += d[i + ny * j] * dv[j];
          c.yp[i + ny * k] = sum;
        }
      if (bad != 0)
        give_up (c, const_cast<number *> (x), k, *t, 1, c.no_numbers);
    }
}

// CTL, and the derivatives of held outputs and memory
extern "C" void
gsmbp_control_with_columns (const int *device, const number *t, const number *y, number *xk,
                            const number *cst, number *v)
{
  carried& c = *the_columns;
  const gs_samples s = c.plan->samples ();
  const int nv = S.nv, nk = S.nxk, ny = S.ny, rows = nv + nk;
  if (states_alone (c))
    {
      routine ("ctl") (device, t, y, xk, cst, v);
      return;
    }
  arrivals (c);
  reals d = room (rows * (rows + ny + S.nsp)), z = room (rows), now = c.vp;
  routine ("ctd") (device, t, y, xk, cst, v, &d[0]);
  routine ("ctl") (device, t, y, xk, cst, v);
  for (int k = 0; k < c.count (); k++)
    {
      for (int i = 0; i < rows; i++)
        {
          number sum = c.col[k] > 0 ? d[i + rows * (rows + ny + c.col[k] - 1)] : number (0);
          for (int j = 0; j < nv; j++)
            sum += d[i + rows * j] * c.vp[j + nv * k];
          for (int j = 0; j < nk; j++)
            sum += d[i + rows * (nv + j)] * c.kp[j + nk * k];
          for (int j = 0; j < ny; j++)
            sum += d[i + rows * (rows + j)] * c.yp[j + ny * k];
          z[i] = c.why[k] != 0 ? number (0) : sum;
        }
      std::copy (z.begin (), z.begin () + nv, now.begin () + nv * k);
      std::copy (z.begin () + nv, z.begin () + rows, c.kp.begin () + nk * k);
    }
  int from = 0;
  for (int i = 0; i < *device - 1; i++)
    from += s.held[i];
  if (s.delay[*device - 1] > 0)
    {
      int place = s.np - 1;   // where GSSMP puts it: the last free one
      while (place > 0 && s.sender[place] != 0)
        place--;
      const double when = s.next[*device - 1] * double (s.period[*device - 1])
                          + double (s.delay[*device - 1]);
      c.sent.push_back ({ place, from, from + s.held[*device - 1], when, now });
      return;
    }
  c.vp = now;
  keep_inputs (c, double (*t));
}

// VP over time: a column each, time and VP
static Matrix
kept_inputs (const carried& c)
{
  const int n = 1 + S.nv * c.count ();
  Matrix m (n, octave_idx_type (c.kept.size () / n));
  std::copy (c.kept.begin (), c.kept.end (), m.fortran_vec ());
  return m;
}
