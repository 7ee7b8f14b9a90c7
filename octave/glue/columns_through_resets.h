// What the resets of an event do to the derivatives that a run carries: RSP of ports that are hit
// or held, URP of what an event of the user sets.
#pragma once

#include "columns_of_inputs.h"

// a column that has no derivative from now on: it is zero, and said to be lost
static void
give_up (carried& c, number *x, int k, number t, int event, int why)
{
  if (c.why[k] == 0)
    {
      c.why[k] = why;
      c.event[k] = event;
      c.lost_at[k] = double (t);
    }
  std::fill (x + S.nx * (k + 1), x + S.nx * (k + 2), number (0));
  c.tau[k] = 0;
}

// those whose time of the event depends on the parameter
static void
give_up_moved (carried& c, number *x, number t, int event, int why)
{
  for (int k = 0; k < c.count (); k++)
    if (c.tau[k] != 0 || ! (c.tau[k] == c.tau[k]))
      give_up (c, x, k, t, event, why);
}

// S through what ports do, whose derivatives by coordinates, speeds, parameters and time are R
static void
through_ports (carried& c, number *x, const reals& r)
{
  const int nm = S.nq + S.nu;
  reals u = room (S.nu);
  for (int k = 0; k < c.count (); k++)
    {
      number *s = x + S.nx * (k + 1);
      for (int i = 0; i < S.nu; i++)
        {
          u[i] = r[i + S.nu * (nm + S.nsp)] * c.tau[k];
          if (c.col[k] > 0)
            u[i] += r[i + S.nu * (nm + c.col[k] - 1)];
          for (int j = 0; j < nm; j++)
            u[i] += r[i + S.nu * j] * s[j];
        }
      std::copy (u.begin (), u.begin () + S.nu, s + S.nq);
      if (c.why[k] != 0)
        std::fill (s, s + S.nx, number (0));
    }
}

// what an event of the user sets, before it happens: derivatives of states and inputs after it, by
// states, inputs, parameters and time; states after it, where the constraints do not move them
struct user_change
{
  reals r, xa;
  int bad = 0;

  int rows (void) const { return S.nx + S.nv; }
  number at (int i, int j) const { return r[i + std::size_t (rows ()) * j]; }
  // is state I another one than before?
  bool sets (int i) const
  {
    for (int j = 0; j <= rows () + S.nsp; j++)
      if (at (i, j) != number (i == j ? 1 : 0))
        return true;
    return false;
  }
  bool sets_states (void) const
  {
    for (int i = 0; i < S.nx; i++)
      if (sets (i))
        return true;
    return false;
  }
};

static user_change
change_of (carried& c, number t, const number *x, const number *v, int k)
{
  user_change u;
  u.r = room ((S.nx + S.nv) * (S.nx + S.nv + S.nsp + 1));
  u.xa = room (S.nx);
  routine ("urp") (&t, x, v, &(*c.cst)[0], &k, &u.r[0], &u.xa[0], &u.bad);
  return u;
}

// S and the derivatives of the inputs through what an event of the user sets
static void
through_change (carried& c, number *x, const user_change& u)
{
  const int n = u.rows ();
  reals before = room (n), after = room (n);
  for (int k = 0; k < c.count (); k++)
    {
      number *s = x + S.nx * (k + 1), *dv = &c.vt[S.nv * k];
      std::copy (s, s + S.nx, before.begin ());
      std::copy (dv, dv + S.nv, before.begin () + S.nx);
      for (int i = 0; i < n; i++)
        {
          after[i] = u.at (i, n + S.nsp) * c.tau[k];
          if (c.col[k] > 0)
            after[i] += u.at (i, n + c.col[k] - 1);
          for (int j = 0; j < n; j++)
            after[i] += u.at (i, j) * before[j];
        }
      std::copy (after.begin (), after.begin () + S.nx, s);
      std::copy (after.begin () + S.nx, after.begin () + n, dv);
    }
}

// inputs that event K switches are held from here on
static void
hold_switched (carried& c, number t, int k)
{
  const gs_events e = c.plan->events ();
  bool any = false;
  for (int j = 0; j < e.ns; j++)
    if (e.by[j] == k)
      {
        const int i = e.switched[j] - 1;
        c.switched[i] = std::min (c.switched[i], double (t));
        for (int l = 0; l < c.count (); l++)
          c.vp[i + S.nv * l] = c.why[l] != 0 ? number (0) : c.vt[i + S.nv * l];
        any = true;
      }
  if (any)
    keep_inputs (c, double (t));
}

// Euler parameters XA that are made of length 1, X
static void
through_lengths (carried& c, number *x, const reals& xa)
{
  for (int set = 0; set < S.nsets; set++)
    {
      const int *place = S.sets + 4 * set;
      number size = 0;
      for (int i = 0; i < 4; i++)
        size += xa[place[i] - 1] * x[place[i] - 1];
      for (int k = 0; k < c.count (); k++)
        {
          number *s = x + S.nx * (k + 1), along = 0;
          for (int i = 0; i < 4; i++)
            along += x[place[i] - 1] * s[place[i] - 1];
          for (int i = 0; i < 4; i++)
            s[place[i] - 1] = (s[place[i] - 1] - x[place[i] - 1] * along) / size;
        }
    }
}
