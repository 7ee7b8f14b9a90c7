// What happens at an event to the derivatives that a run carries: RST, and with it the jump of S,
//   S+ = R_x S- + R_p + (R_x f- + R_t - f+) dtau/dp,  dtau/dp = -(g_x S- + g_p)/(g_x f- + g_t).
// From the first event of an instant to the last S is that along the motion, S + f dtau/dp, which
// every reset takes along.  Where there is no derivative the column is given up.
#pragma once

#include "columns_on_loops.h"

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

// is event I just coming, along the motion with the rates F?  G: its derivatives
static bool
is_coming (carried& c, number t, const number *x, const number *v, const int *mode, int i,
           const number *f, const number *slopes, number value, number *g, number *rate)
{
  if (c.plan->events ().mark[i - 1] != 1
      || event_slope (c, t, x, v, mode, i, f, slopes, g, rate) != 0)
    return false;
  number size = 0;
  for (int j = 0; j < S.nx; j++)
    size += magnitude (g[j] * f[j]);
  return *rate < number (-1e-9) * size   // else it is one by rounding errors
         && magnitude (value) <= 10 * event_tolerance (c, g, x)
         && value <= -10 * *rate * moment (c, x, f);
}

// Another event may just be coming at the instant of event K: columns by which its time changes in
// another way are given up.  One that only reports matters to nobody, but has its own time.
static void
give_up_apart (carried& c, number t, number *x, const number *v, const int *mode, int k,
               const number *f, const number *slopes)
{
  reals values = room (S.nev), g = room (S.nx + S.nv + S.nsp + 1), tau = room (c.count ());
  routine ("evt") (&t, x, v, mode, &(*c.cst)[0], &values[0]);
  c.reports.assign (S.nev, reals ());
  for (int i = 1; i <= S.nev; i++)
    {
      number rate = 0;
      if (i == k || ! is_coming (c, t, x, v, mode, i, f, slopes, values[i-1], &g[0], &rate))
        continue;
      event_times (c, x + S.nx, v, &g[0], rate, &tau[0]);
      if (! c.changes[i-1])
        c.reports[i-1] = tau;
      for (int j = 0; j < c.count () && c.changes[i-1]; j++)
        if (! (magnitude (tau[j] - c.tau[j]) <= number (1e-6) * magnitude (c.tau[j])))
          give_up (c, x, j, t, k, c.several);
    }
}

// event K at the state X before it: inputs, rates, derivatives of its function; TAU: dtau/dp
struct event_before
{
  reals v, f, slopes, g;
  number rate = 0;
  int info = 0;
  bool grazing = false;

  event_before (carried& c, number t, const number *x, const int *mode, int k, number *tau)
    : v (room (S.nv)), f (room (S.nx)), g (room (S.nx + S.nv + S.nsp + 1))
  {
    rates_at (c, t, x, -1, &v[0], &f[0], &info);
    slopes = input_slopes (c, t, -1, x, &v[0], &f[0]);
    if (info == 0)
      info = event_slope (c, t, x, &v[0], mode, k, &f[0], &slopes[0], &g[0], &rate);
    event_times (c, x + S.nx, &v[0], &g[0], rate, tau);
    grazing = info == 0 && grazes (c, t, x, &v[0], mode, k, &f[0], &slopes[0], &g[0], rate);
  }
};

// the first event of an instant, K: dtau/dp, and S along the motion
static void
begin_instant (carried& c, number t, number *x, const int *mode, int k)
{
  const event_before e (c, t, x, mode, k, &c.tau[0]);
  if (e.info != 0)
    give_up_moved (c, x, t, k, c.no_numbers);
  else if (e.grazing)
    give_up_moved (c, x, t, k, c.grazing);
  else
    give_up_apart (c, t, x, &e.v[0], mode, k, &e.f[0], &e.slopes[0]);
  for (int j = 0; j < c.count (); j++)
    for (int i = 0; i < S.nx; i++)
      x[i + S.nx * (j + 1)] += e.f[i] * c.tau[j];
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

// The values G1, G2, G of event function I at T1, T2, T, above 0: does the parabola through them
// turn close to 0?
static void
watch_turn (carried& c, int i, double t, double g1, double g2, double g)
{
  const double a = c.t2[i] - c.t1[i], b = t - c.t2[i];
  if (! (a > 0 && b > 0 && g2 < g1 && g2 <= g))
    return;
  const double s = (g2 - g1) / a, bend = ((g - g2) / b - s) / (a + b), slope = s + a * bend,
               low = g2 - slope * slope / (4 * bend);
  if (low <= 0.02 * c.most[i] && std::max (g1, g) - low > 1e-9 * c.most[i]
      && c.turns.size () < 2000)
    c.turns.insert (c.turns.end (), { i + 1.0, c.t2[i] - slope / (2 * bend) });
}

// a value of event function I; one of the user may stay below 0
static void
watch (carried& c, int i, double t, double g)
{
  const bool own = c.plan->events ().kind[i] > 2;
  const double side = own && c.g2[i] < 0 ? -1 : 1;
  if (! (t > c.t2[i]))
    c.t1[i] = c.t2[i] = t;
  c.most[i] = std::max (c.most[i], side * g);
  if (! own || std::min ({ side * c.g1[i], side * c.g2[i], side * g }) > 0)
    watch_turn (c, i, t, side * c.g1[i], side * c.g2[i], side * g);
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
    else if (c.changes[i])
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

// dtau/dp of event K is told with the events
static void
tell_times (carried& c, const reals& tau)
{
  const gs_events e = c.plan->events ();
  if (*e.count > e.nr)
    return;
  for (int k = 0; k < c.count (); k++)
    c.times.push_back (c.why[k] != 0 ? no_number : double (tau[k]));
}

// of an event that changes nothing: it goes past the derivatives, even where it only grazes
static void
tell_reported (carried& c, number t, number *x, const int *mode, int k)
{
  reals tau = room (c.count ());
  const event_before e (c, t, x, mode, k, &tau[0]);
  for (number& one : tau)
    if ((e.info != 0 || e.grazing) && one != 0)
      one = no_number;
  tell_times (c, tau);
}

// derivatives of the inputs V at an instant, along the motion
static void
inputs_of_instant (carried& c, number t, const number *x, const number *v, int side)
{
  reals given = room (S.nv), f = room (S.nx);
  int info = 0;
  rates_at (c, t, x, side, &given[0], &f[0], &info);
  const reals slopes = input_slopes (c, t, side, x, &given[0], &f[0]);
  for (int k = 0; k < c.count (); k++)
    {
      input_columns (c, v, x + S.nx * (k + 1), k, &c.vt[S.nv * k]);
      for (int i = 0; i < S.nv; i++)
        c.vt[i + S.nv * k] += slopes[i] * c.tau[k];
    }
}

// the ports at event K: they jump, or (-1) come to rest; X is the state behind it
static void
through_impact (carried& c, number t, const reals& before, const reals& inputs,
                const std::vector<int>& modes, int k, number *x, const int *mode)
{
  reals r = room (S.nu * (S.nq + S.nu + S.nsp + 1));
  int bad = 0;
  routine ("rsp") (&t, &before[0], &inputs[0], &modes[0], &k, x + S.nq, mode, &(*c.cst)[0], &r[0],
                   &bad);
  if (bad == 0)
    through_ports (c, x, r);
  for (int j = 0; j < c.count () && bad != 0; j++)
    give_up (c, x, j, t, std::max (1, k), c.no_numbers);
}

// an event of the user that sets something
static void
through_user (carried& c, number t, number *x, const user_change& u, int k)
{
  for (int j = 0; j < c.count () && u.bad != 0; j++)
    give_up (c, x, j, t, k, c.no_numbers);
  if (u.bad != 0)
    return;
  through_change (c, x, u);
  through_lengths (c, x, u.xa);
  through_loops (c, t, x, u, k);
  drop_lost (c, x);
  hold_switched (c, t, k);
}

// before the first event of an instant
static void
open_instant (carried& c, number t, number *x, const number *v, const int *mode, int k)
{
  const int cause = *c.plan->events ().cause;
  std::fill (c.tau.begin (), c.tau.end (), number (0));
  c.reports.assign (S.nev, reals ());
  if (emitted ("urp"))
    onto_loops (c, t, x);
  const reals states (x, x + c.nx);
  if (cause > 0)
    begin_instant (c, t, x, mode, k);
  if (emitted ("urp"))
    inputs_of_instant (c, t, &states[0], v, cause > 0 ? -1 : 1);
  c.within = true;
}

extern "C" void
gsmbp_reset_with_columns (const number *t, number *x, number *v, int *mode, const int *k,
                          const number *cst, int *info)
{
  carried& c = *the_columns;
  *info = 0;
  if (*k <= -3)   // questions, and what moves by the errors of steps
    return routine ("rst") (t, x, v, mode, k, cst, info);
  const gs_events e = c.plan->events ();
  const bool own = *k > 0 && e.kind[*k - 1] > 2, changes = *k <= 0 || c.changes[*k - 1];
  if (*k == -2)
    {
      if (c.within)
        end_instant (c, *t, x);
      c.within = false;
      return;
    }
  if (! changes && ! c.within && *e.cause > 0)
    tell_reported (c, *t, x, mode, *k);
  else if (! changes)
    tell_times (c, ! c.within ? room (c.count ()) : c.reports[*k - 1].empty () ? c.tau
                                                  : c.reports[*k - 1]);
  if (! changes)
    return routine ("rst") (t, x, v, mode, k, cst, info);
  if (! c.within)
    open_instant (c, *t, x, v, mode, *k);
  if (*k > 0)
    tell_times (c, c.tau);
  const reals before (x, x + S.nx), inputs (v, v + S.nv);
  const std::vector<int> modes (mode, mode + S.nev);
  user_change u;
  if (own)
    u = change_of (c, *t, x, v, *k);
  routine ("rst") (t, x, v, mode, k, cst, info);
  if (*info != 0)
    return;
  if (own)
    through_user (c, *t, x, u, *k);
  if (emitted ("rsp") && ! (own && u.sets_states ()))
    through_impact (c, *t, before, inputs, modes, own ? -1 : *k, x, mode);
}

// dtau/dp of all events: a column each
static Matrix
event_columns (const carried& c)
{
  const int n = std::max (1, c.count ());
  Matrix m (c.count (), octave_idx_type (c.times.size () / n));
  std::copy (c.times.begin (), c.times.end (), m.fortran_vec ());
  return m;
}
