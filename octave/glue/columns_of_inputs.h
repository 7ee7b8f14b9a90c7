// Inputs that depend on parameters or states in a run that carries derivatives: held outputs of
// sampled devices (VP), feedback, functions of time.  A feedback is evaluated here, at the states
// alone, and its gain kept: the outer GSINP sees a subroutine of the user.
#pragma once

#include "columns_by_parameters.h"

// |a|, of quad precision, too
static number
magnitude (number a)
{
  return a < 0 ? -a : a;
}

// what CMP says of the planned motion that GSINP has left in its workspace
static void
planned_columns (carried& c, const number *t, const number *x, const number *cst, int *info)
{
  const int ld = std::max (1, S.nv), at = c.ip[GS_INTERNAL];
  reals xi = room (S.na);
  for (int i = 0; i < S.na; i++)
    xi[i] = at > 0 ? x[at - 1 + i] : number (0);
  routine ("cmp") (t, &c.wi[0], &xi[0], cst, &c.vx[0], &ld, &c.vm[0], &ld, info);
}

extern "C" void
gsmbp_inputs_with_columns (const number *t, const int *side, const number *x, const int *,
                           const int *nv, const int *, const number *rp, const number *cst,
                           number *v, int *info)
{
  carried& c = *the_columns;
  const int ld = std::max (1, S.nv * S.nx), none = 0, *gain = &c.ip[GS_GAIN];
  const int nk = S.nv * S.nx;
  if (c.ip[GS_V0] == 3)
    {
      gsmbp_call_input (t, side, x, &S.nx, nv, nullptr, nullptr, nullptr, v, info);
      return;
    }
  fortran {gsinp_} (c.cmd, c.clo, gsmbp_absent, t, side, x, &S.nu, &S.nx, &S.nv, c.ip.data (), rp,
                    cst, v, &c.wi[0], info);
  if (*info == 0 && c.ip[GS_V0] == 2 && ! states_alone (c))
    planned_columns (c, t, x, cst, info);
  if (*info != 0)
    return;
  if (c.ip[GS_FEEDBACK] == 1)
    fortran {gspln_} (&nk, gain, gain + 1, rp + gain[2] - 1, rp + gain[3] - 1, t, side, &none,
                      &c.gain[0], &ld, info);
  *info = std::min (*info, 0);
}

// the run calls these inputs instead of its own
static bool
takes_inputs (carried& c, run_plan& plan)
{
  if (plan.ip[GS_V0] < 2 && plan.ip[GS_FEEDBACK] != 1)
    return false;
  c.ip = plan.ip;
  c.ip[GS_HELD] = c.ip[GS_EVENTS] = 0;
  plan.ip[GS_V0] = 3;
  plan.ip[GS_FEEDBACK] = 0;
  c.own.assign (S.nv, 1);
  for (int i = 0; i < plan.ip[GS_HELD]; i++)
    c.own[plan.samples ().input[i] - 1] = 0;
  for (int i = 0; i < S.nev; i++)   // events of the user have no input
    if (plan.events ().input[i] > 0)
      c.own[plan.events ().input[i] - 1] = 0;
  return true;
}

// does input I follow plan and feedback, and not its limit?
static bool
free_input (const carried& c, const number *v, int i)
{
  if (c.ip.empty () || ! c.own[i])
    return false;
  const bool limited = c.ip[GS_FEEDBACK] == 1 && c.ip[GS_LIMITS] > 0;
  const number *limits = limited ? &c.plan->rp[c.ip[GS_LIMITS] - 1] : nullptr;
  return ! limits || (v[i] > limits[i] && v[i] < limits[S.nv + i]);
}

// derivative of input I by column K, S its states, through the planned motion
static number
planned_change (const carried& c, const number *s, int k, int i)
{
  const int at = c.ip[GS_INTERNAL];
  number sum = c.col[k] > 0 ? c.vm[i + S.nv * (c.col[k] - 1)] : number (0);
  for (int j = 0; j < S.na && at > 0; j++)
    sum += c.vx[i + S.nv * j] * s[at - 1 + j];
  return sum;
}

// and of all that a run's plan gives, feedback too
static number
given_change (const carried& c, const number *v, const number *s, int k, int i)
{
  if (! free_input (c, v, i))
    return 0;
  number sum = c.ip[GS_V0] == 2 ? planned_change (c, s, k, i) : number (0);
  for (int j = 0; j < S.nx && c.ip[GS_FEEDBACK] == 1; j++)
    sum -= c.gain[i + S.nv * j] * s[j];
  return sum;
}

// has an event of the user set input I before T?
static bool
is_set (const carried& c, int i, double t)
{
  return t > c.switched[i] + 1e-12 * std::fabs (t);
}

// derivatives of the inputs V by column K, S its states
static void
input_columns (const carried& c, const number *v, const number *s, int k, number *dv)
{
  for (int i = 0; i < S.nv; i++)
    dv[i] = c.vp[i + S.nv * k]
            + (std::isfinite (c.switched[i]) ? number (0) : given_change (c, v, s, k, i));
}

// derivatives of the inputs that follow plan and feedback at the output times, from the left: a
// column each, inputs by columns
static Matrix
given_inputs (carried& c, const reals& tout, const reals& xout, const reals& vout, int ldx, int ldv,
              int reached)
{
  Matrix m (S.nv * c.count (), c.ip.empty () ? 0 : reached, 0.0);
  reals v = room (S.nv);
  const int side = -1;
  for (int r = 0; r < m.columns (); r++)
    {
      int info = 0;
      const number *x = &xout[std::size_t (ldx) * r], *given = &vout[std::size_t (ldv) * r];
      gsmbp_inputs_with_columns (&tout[r], &side, x, &S.nx, &S.nv, nullptr,
                                 c.plan->rp.data (), &(*c.cst)[0], &v[0], &info);
      for (int k = 0; k < c.count (); k++)
        for (int i = 0; i < S.nv; i++)
          if (! is_set (c, i, double (tout[r])))
            m(i + S.nv * k, r) = info != 0 ? no_number
                                 : double (given_change (c, given, x + S.nx * (k + 1), k, i));
    }
  return m;
}

// rates of a polynomial of the plan
static reals
polynomial_rates (carried& c, const int *where, int n, number t, int side)
{
  const int nd = 1, ld = std::max (1, n);
  reals f = room (2 * ld);
  int info = 0;
  number *rp = c.plan->rp.data ();
  fortran {gspln_} (&n, where, where + 1, rp + where[2] - 1, rp + where[3] - 1, &t, &side, &nd,
                    &f[0], &ld, &info);
  return reals (f.begin () + ld, f.end ());
}

// rates of a function of time, GIVEN (t, its values), from one side: differences of order 4
template <typename F> static reals
function_rates (number t, int side, F given)
{
  static const double weights[] = { 25, -48, 36, -16, 3 };
  const number h = number (1e-4) * std::max (number (1), magnitude (t)) * (side < 0 ? 1 : -1);
  reals rate = room (S.nv), v = room (S.nv);
  std::fill (rate.begin (), rate.end (), number (0));
  for (int k = 0; k < 5; k++)
    {
      given (t - k * h, &v[0]);
      for (int i = 0; i < S.nv; i++)
        rate[i] += weights[k] / (12 * h) * v[i];
    }
  return rate;
}

// of what a planned motion needs, through the states of devices too, whose rates are F
static reals
motion_rates (carried& c, number t, const number *x, const number *f, int side)
{
  std::vector<int> ip = c.ip;
  ip[GS_FEEDBACK] = 0;
  int info = 0;
  reals rate = function_rates (t, side, [&] (number at, number *v)
                               {
                                 fortran {gsinp_} (c.cmd, c.clo, gsmbp_absent, &at, &side, x, &S.nu,
                                                   &S.nx, &S.nv, ip.data (), c.plan->rp.data (),
                                                   &(*c.cst)[0], v, &c.wi[0], &info);
                               });
  const int from = ip[GS_INTERNAL];
  for (int i = 0; i < S.nv; i++)
    for (int j = 0; j < S.na && from > 0; j++)
      rate[i] += c.vx[i + S.nv * j] * f[from - 1 + j];
  return rate;
}

// VP from time T on, for the outputs of the scene
static void
keep_inputs (carried& c, double t)
{
  c.kept.push_back (t);
  c.kept.insert (c.kept.end (), c.vp.begin (), c.vp.begin () + S.nv * c.count ());
}

// rates of the inputs V that plan and feedback give, along the motion with the rates F of the
// states
static reals
planned_slopes (carried& c, number t, int side, const number *x, const number *v, const number *f)
{
  const std::vector<int>& ip = c.ip.empty () ? c.plan->ip : c.ip;
  reals rate = room (S.nv);
  std::fill (rate.begin (), rate.end (), number (0));
  if (ip[GS_V0] == 1)
    rate = polynomial_rates (c, &ip[GS_TABLE], S.nv, t, side);
  else if (ip[GS_V0] == 2)
    rate = motion_rates (c, t, x, f, side);
  else if (ip[GS_V0] == 3)
    rate = function_rates (t, side, [&] (number at, number *given)
                           {
                             int info = 0;
                             gsmbp_call_input (&at, &side, x, &S.nx, &S.nv, nullptr, nullptr,
                                               nullptr, given, &info);
                           });
  if (ip[GS_FEEDBACK] != 1)
    return rate;
  const reals gains = polynomial_rates (c, &ip[GS_GAIN], S.nv * S.nx, t, side),
              moves = polynomial_rates (c, &ip[GS_REFERENCE], S.nx, t, side);
  const int ld = std::max (1, S.nx), none = 0, *where = &ip[GS_REFERENCE];
  reals wanted = room (ld);
  number *rp = c.plan->rp.data ();
  int info = 0;
  fortran {gspln_} (&S.nx, where, where + 1, rp + where[2] - 1, rp + where[3] - 1, &t, &side, &none,
                    &wanted[0], &ld, &info);
  for (int i = 0; i < S.nv; i++)
    {
      if (! free_input (c, v, i))
        rate[i] = c.own[i] ? number (0) : rate[i];
      for (int j = 0; j < S.nx && free_input (c, v, i); j++)
        rate[i] -= gains[i + S.nv * j] * (x[j] - wanted[j])
                   + c.gain[i + S.nv * j] * (f[j] - moves[j]);
    }
  return rate;
}

// and of all: those that an event of the user has switched stay as they are
static reals
input_slopes (carried& c, number t, int side, const number *x, const number *v, const number *f)
{
  reals rate = planned_slopes (c, t, side, x, v, f);
  const gs_events e = c.plan->events ();
  for (int j = 0; j < e.ns; j++)
    if (e.on[j] == 1)
      rate[e.switched[j] - 1] = 0;
  return rate;
}
