// What happens at an event to the derivatives that a run carries: RST, and with it the jump of S,
//   S+ = R_x S- + R_p + (R_x f- + R_t - f+) dtau/dp,  dtau/dp = -(g_x S- + g_p)/(g_x f- + g_t).
// From the first event of an instant to the last S is that along the motion, S + f dtau/dp, which
// every reset takes along.  Where there is no derivative the column is given up.
#pragma once

#include "columns_of_inputs.h"

// the numbers of an instant: RHS at a state under its inputs from one side
static void
rates_at (carried& c, number t, const number *x, int side, number *v, number *f, int *info)
{
  fortran {gsinp_} (gsmbp_absent, gsmbp_absent,
                    reinterpret_cast<gsmbp_sub> (gsmbp_inputs_with_columns), &t, &side, x, &S.nu,
                    &c.nx, &S.nv, c.plan->ip.data (), c.plan->rp.data (), &(*c.cst)[0], v,
                    &c.w3[0], info);
  if (*info == 0)
    routine ("rhs") (&t, x, v, &(*c.cst)[0], f, info);
  if (*info == 2 || *info == 3)
    *info = 0;
}

// derivatives of event function K, and its rate along the motion
static int
event_slope (carried& c, number t, const number *x, const number *v, const int *mode, int k,
             const number *f, const number *slopes, number *g, number *rate)
{
  int info = 0;
  routine ("evp") (&t, x, v, mode, &k, &(*c.cst)[0], g, &info);
  *rate = g[S.nx + S.nv + S.nsp];
  for (int i = 0; i < S.nx; i++)
    *rate += g[i] * f[i];
  for (int i = 0; i < S.nv; i++)
    if (slopes[i] != 0)
      *rate += g[S.nx + i] * slopes[i];
  return info;
}

// how far a tolerance of the states moves an event function
static number
event_tolerance (const carried& c, const number *g, const number *x)
{
  number size = 0;
  for (int i = 0; i < S.nx; i++)
    size += magnitude (g[i]) * (c.atol[i] + c.rtol * magnitude (x[i]));
  return size;
}

// the time in which a state changes by a millionth of its usual size
static number
moment (const carried& c, const number *x, const number *f)
{
  number fast = 0;
  for (int i = 0; i < S.nx; i++)
    fast = std::max (fast, magnitude (f[i]) * c.rtol / (c.atol[i] + c.rtol * magnitude (x[i])));
  return fast > 0 ? number (1e-6) / fast : number (0);
}

// does the motion only graze where the event function has the slope RATE? Then an error of the
// size of the tolerance makes another slope of it.
static bool
grazes (carried& c, number t, const number *x, const number *v, const int *mode, int k,
        const number *f, const number *slopes, const number *g, number rate)
{
  number before = 0;
  const number d = moment (c, x, f);
  reals y (x, x + S.nx), h = room (S.nx), g2 = room (S.nx + S.nv + S.nsp + 1);
  for (int i = 0; i < S.nx; i++)
    y[i] -= d * f[i];
  const number earlier = t - d;
  int info = 0;
  routine ("rhs") (&earlier, &y[0], v, &(*c.cst)[0], &h[0], &info);
  event_slope (c, earlier, &y[0], v, mode, k, &h[0], slopes, &g2[0], &before);
  const number bend = d > 0 ? magnitude (rate - before) / d : number (0);
  return ! (rate * rate > event_tolerance (c, g, x) * bend) || ! (magnitude (rate) > 0);
}

// dtau/dp of event function K by all columns
static void
event_times (const carried& c, const number *s, const number *v, const number *g, number rate,
             number *tau)
{
  reals dv = room (S.nv);
  for (int k = 0; k < c.count (); k++)
    {
      number sum = c.col[k] > 0 ? g[S.nx + S.nv + c.col[k] - 1] : number (0);
      for (int i = 0; i < S.nx; i++)
        sum += g[i] * s[i + S.nx * k];
      input_columns (c, v, s + S.nx * k, k, &dv[0]);
      for (int i = 0; i < S.nv; i++)
        sum += g[S.nx + i] * dv[i];
      tau[k] = sum != 0 ? -sum / rate : number (0);
    }
}

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

// is another event just coming at the same instant, whose time changes in another way?
static int
another (carried& c, number t, const number *x, const number *v, const int *mode, int k,
         const number *f, const number *slopes)
{
  const gs_events e = c.plan->events ();
  reals values = room (S.nev), g = room (S.nx + S.nv + S.nsp + 1), tau = room (c.count ());
  routine ("evt") (&t, x, v, mode, &(*c.cst)[0], &values[0]);
  for (int i = 1; i <= S.nev; i++)
    {
      number rate = 0;
      if (i == k || e.mark[i-1] != 1
          || event_slope (c, t, x, v, mode, i, f, slopes, &g[0], &rate) != 0
          || ! (magnitude (values[i-1]) <= 10 * event_tolerance (c, &g[0], x))
          || ! (rate < 0 && values[i-1] <= -10 * rate * moment (c, x, f)))
        continue;
      event_times (c, x + S.nx, v, &g[0], rate, &tau[0]);
      for (int j = 0; j < c.count (); j++)
        if (! (magnitude (tau[j] - c.tau[j]) <= number (1e-6) * magnitude (c.tau[j])))
          return i;
    }
  return 0;
}

// the first event of an instant, K: dtau/dp, and S along the motion
static void
begin_instant (carried& c, number t, number *x, const int *mode, int k)
{
  reals v = room (S.nv), f = room (S.nx), g = room (S.nx + S.nv + S.nsp + 1);
  number rate = 0;
  int info = 0;
  rates_at (c, t, x, -1, &v[0], &f[0], &info);
  const reals slopes = input_slopes (c, t, -1, x, &v[0], &f[0]);
  if (info == 0)
    info = event_slope (c, t, x, &v[0], mode, k, &f[0], &slopes[0], &g[0], &rate);
  event_times (c, x + S.nx, &v[0], &g[0], rate, &c.tau[0]);
  if (info != 0)
    give_up_moved (c, x, t, k, c.no_numbers);
  else if (grazes (c, t, x, &v[0], mode, k, &f[0], &slopes[0], &g[0], rate))
    give_up_moved (c, x, t, k, c.grazing);
  else if (another (c, t, x, &v[0], mode, k, &f[0], &slopes[0]))
    give_up_moved (c, x, t, k, c.several);
  for (int j = 0; j < c.count (); j++)
    for (int i = 0; i < S.nx; i++)
      x[i + S.nx * (j + 1)] += f[i] * c.tau[j];
}

// behind the last one: S at a fixed time
static void
end_instant (carried& c, number t, number *x)
{
  reals v = room (S.nv), f = room (S.nx);
  int info = 0;
  rates_at (c, t, x, 1, &v[0], &f[0], &info);
  for (int j = 0; j < c.count (); j++)
    for (int i = 0; i < S.nx && c.tau[j] != 0; i++)
      x[i + S.nx * (j + 1)] -= f[i] * c.tau[j];
}

// S through a reset, whose derivatives by coordinates, speeds, parameters and time are R
static void
through_reset (carried& c, number *x, const reals& r)
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

// A value of event function I: does the parabola through it and the last two turn close to 0?
static void
watch (carried& c, int i, double t, double g)
{
  if (! (t > c.t2[i]))
    c.t1[i] = c.t2[i] = t;
  const double a = c.t2[i] - c.t1[i], b = t - c.t2[i];
  c.most[i] = std::max (c.most[i], g);
  if (a > 0 && b > 0 && c.g2[i] < c.g1[i] && c.g2[i] <= g)
    {
      const double s = (c.g2[i] - c.g1[i]) / a, bend = ((g - c.g2[i]) / b - s) / (a + b),
                   slope = s + a * bend, low = c.g2[i] - slope * slope / (4 * bend);
      if (low <= 0.02 * c.most[i] && std::max (c.g1[i], g) - low > 1e-9 * c.most[i]
          && c.turns.size () < 2000)
        c.turns.insert (c.turns.end (), { i + 1.0, c.t2[i] - slope / (2 * bend) });
    }
  c.t1[i] = c.t2[i];
  c.g1[i] = c.g2[i];
  c.t2[i] = t;
  c.g2[i] = g;
}

extern "C" void
gsmbp_events_watched (const number *t, const number *x, const number *v, const int *mode,
                      const number *cst, number *g)
{
  carried& c = *the_columns;
  routine ("evt") (t, x, v, mode, cst, g);
  for (int i = 0; i < S.nev; i++)
    if (states_alone (c))   // the ends of steps that close in on an event are no motion
      {
        c.t1[i] = c.t2[i] = double (*t);
        c.g1[i] = c.g2[i] = double (g[i]);
      }
    else
      watch (c, i, double (*t), double (g[i]));
}

// the turns: a column each, number and time
static Matrix
watched_turns (const carried& c)
{
  Matrix m (2, octave_idx_type (c.turns.size () / 2));
  std::copy (c.turns.begin (), c.turns.end (), m.fortran_vec ());
  return m;
}

extern "C" void
gsmbp_reset_with_columns (const number *t, number *x, number *v, int *mode, const int *k,
                          const number *cst, int *info)
{
  carried& c = *the_columns;
  *info = 0;
  const int cause = *c.plan->events ().cause;
  if (*k == -2)
    {
      if (c.within)
        end_instant (c, *t, x);
      c.within = false;
      return;
    }
  if (! c.within)
    {
      std::fill (c.tau.begin (), c.tau.end (), number (0));
      if (cause > 0)
        begin_instant (c, *t, x, mode, *k);
    }
  c.within = true;
  const reals before (x, x + S.nx), inputs (v, v + S.nv);
  const std::vector<int> modes (mode, mode + S.nev);
  routine ("rst") (t, x, v, mode, k, cst, info);
  if (*info != 0)
    return;
  reals r = room (S.nu * (S.nq + S.nu + S.nsp + 1));
  int bad = 0;
  routine ("rsp") (t, &before[0], &inputs[0], &modes[0], k, x + S.nq, mode, cst, &r[0], &bad);
  if (bad == 0)
    through_reset (c, x, r);
  for (int j = 0; j < c.count () && bad != 0; j++)
    give_up (c, x, j, *t, std::max (1, *k), c.no_numbers);
}
