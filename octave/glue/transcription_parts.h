// Goal, equations and their derivatives of a transcription, from DAE, DAJ, DAH at all points.
#pragma once

#include "transcription.h"

void
transcription::functions (void)
{
  if (m_has_f)
    return;
  const fortran f = routine ("dae");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &F[nf * q]);
  m_has_f = true;
}

void
transcription::derivatives (void)
{
  functions ();
  if (m_has_g)
    return;
  const fortran f = routine ("daj");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &G[nJ * q]);
  m_has_g = true;
}

// of state J at the point Q
double
transcription::rate (int j, int q) const
{
  return double (rates[j] >= 0 ? F[nf * q + rates[j]] : m_ud[S.nu * q + j - S.nq]);
}

// of each defect what stands by its duration, a column each
void
transcription::sums (doubles& s) const
{
  s.assign (S.nx * own.size (), 0.0);
  for (const share& one : shares)
    for (int j = 0; j < S.nx; j++)
      s[S.nx * one.column + j] += one.a * rate (j, one.point);
}

// of the integral at the point Q, with the durations
double
transcription::whole_weight (int q) const
{
  double whole = 0;
  for (int p = 0; p < nT; p++)
    whole += T[p] * integral[nT * q + p];
  return whole;
}

// what the goal integrates of the unknowns of the point Q; its derivative by the unknown L
double
transcription::own_integrand (int q) const
{
  const double *z = &m_z[std::size_t (nz) * q], *k = &own_linear[std::size_t (nz) * q];
  double sum = 0;
  for (int l : own_unknowns)
    sum += k[l] * z[l];
  for (const product& one : own_products)
    sum += one.weight * z[one.a] * z[one.b];
  return sum;
}

double
transcription::own_slope (int l, int q) const
{
  const double *z = &m_z[std::size_t (nz) * q];
  double sum = own_linear[std::size_t (nz) * q + l];
  for (const product& one : own_products)
    sum += one.weight * ((one.a == l ? z[one.b] : 0) + (one.b == l ? z[one.a] : 0));
  return sum;
}

double *
transcription::own_hessian (double factor, double *v) const
{
  for (const own_curve& one : own_curves)
    *v++ = factor * one.k * whole_weight (one.point);
  for (const own_cross& one : own_crosses)
    *v++ = factor * integral[nT * one.point + one.phase] * own_slope (one.unknown, one.point);
  for (const pair& one : rough)
    *v++ = factor * one.k;
  return v;
}

double
transcription::goal (void) const
{
  double sum = 0;
  for (double t : T)
    sum += goal_time * t;
  if (! own_unknowns.empty ())
    for (int q = 0; q < K; q++)
      sum += whole_weight (q) * own_integrand (q);
  for (int q = 0; q < K; q++)
    for (int i = 0; i < nf; i++)
      if (goals[i] != 0)
        for (int p = 0; p < nT; p++)
          sum += T[p] * integral[nT * q + p] * goals[i] * double (F[nf * q + i]);
  for (int i = 0; i < nf; i++)
    sum += final_f[i] * double (F[nf * (K - 1) + i]);
  for (int j = 0; j < S.nx; j++)
    sum += final_x[j] * double (state (K - 1)[j]);
  for (const pair& one : rough)
    sum += (one.row == one.column ? 0.5 : 1) * one.k * m_z[one.row] * m_z[one.column];
  return sum;
}

void
transcription::gradient (double *g)
{
  derivatives ();
  std::fill (g, g + m_n, 0.0);
  double *durations = g + std::size_t (K) * nz;
  for (int q = 0; q < K; q++)
    {
      const double whole = whole_weight (q);
      double here = own_unknowns.empty () ? 0 : own_integrand (q);
      for (int l : own_unknowns)
        g[std::size_t (nz) * q + l] += whole * own_slope (l, q);
      for (int e : gradient_of)
        {
          const double at_end = q == K - 1 ? final_f[f_of[e] - 1] : 0;
          g[columns_of[(1 + nz + np) * q + by[e] - 1]]
              += double (G[nJ * q + e]) * (by[e] == 1 ? tau[q] : 1)
                 * (goals[f_of[e] - 1] * whole + at_end);
        }
      for (int i = 0; i < nf; i++)
        here += goals[i] * double (F[nf * q + i]);
      for (int p = 0; p < nT; p++)
        durations[p] += integral[nT * q + p] * here;
    }
  for (int p = 0; p < nT; p++)
    durations[p] += goal_time;
  for (int j = 0; j < S.nx; j++)
    g[std::size_t (K - 1) * nz + j] += final_x[j];
  for (const pair& one : rough)
    {
      g[one.row] += one.k * m_z[one.column];
      if (one.row != one.column)
        g[one.column] += one.k * m_z[one.row];
    }
}

void
transcription::equations_at (double *g)
{
  for (int q : stages)
    for (int i = 0; i < nr; i++)
      *g++ = double (F[nf * q + i]);
  for (int q : stages)
    for (int i : bounded)
      *g++ = double (F[nf * q + i]);
  doubles s;
  sums (s);
  for (std::size_t k = 0; k < own.size (); k++)
    for (int j = 0; j < S.nx; j++)
      *g++ = double (state (own[k])[j] - state (left[k])[j]) + T[of_defect[k]] * s[S.nx * k + j];
}

void
transcription::jacobian (double *v)
{
  derivatives ();
  v = std::copy (fixed.begin (), fixed.end (), v);
  for (const triplet& one : plain)
    *v++ = one.k * double (G[one.from]);
  for (const timed& one : by_time)
    *v++ = T[one.phase] * one.k * (one.from >= 0 ? double (G[one.from]) : 1);
  doubles s;
  sums (s);
  std::copy (s.begin (), s.end (), v);
}

// of the functions: of the rates by the multipliers of the defects, of the goal; BARE and SPEEDS
// without the durations, an array for each phase
void
transcription::weights (double factor, const double *lambda)
{
  const double *defect = lambda + m_m - S.nx * own.size ();
  std::fill (bare.begin (), bare.end (), 0.0);
  std::fill (speeds.begin (), speeds.end (), 0.0);
  for (int p = 0; p < nT; p++)
    for (int q = 0; q < K; q++)
      for (int i = 0; i < nf; i++)
        bare[(std::size_t (p) * K + q) * nf + i] = factor * goals[i] * integral[nT * q + p];
  for (const share& one : shares)
    {
      std::size_t at = std::size_t (of_defect[one.column]) * K + one.point;
      for (int j = 0; j < S.nx; j++)
        {
          double w = one.a * defect[S.nx * one.column + j];
          if (rates[j] >= 0)
            bare[at * nf + rates[j]] += w;
          else
            speeds[at * S.nu + j - S.nq] += w;
        }
    }
  for (std::size_t i = 0; i < m_w.size (); i++)
    m_w[i] = 0;
  for (int p = 0; p < nT; p++)
    for (std::size_t i = 0; i < std::size_t (nf) * K; i++)
      m_w[i] += T[p] * bare[std::size_t (p) * nf * K + i];
  for (int i = 0; i < nf; i++)
    m_w[nf * (K - 1) + i] += factor * final_f[i];
  for (int q : stages)
    for (int i = 0; i < nr; i++)
      m_w[nf * q + i] += *lambda++;
  for (int q : stages)
    for (int i : bounded)
      m_w[nf * q + i] += *lambda++;
}

void
transcription::hessian (double factor, const double *lambda, double *v)
{
  derivatives ();
  weights (factor, lambda);
  const fortran f = routine ("dah");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &m_w[nf * q], &H[nH * q]);
  for (const triplet& one : curved)
    *v++ = one.k * double (H[one.from]);
  for (const crossed& one : mixed)
    *v++ = one.k * double (G[one.from]) * bare[one.weight];
  for (int at : crossed_speeds)
    *v++ = speeds[at - 1];
  own_hessian (factor, v);
}

bool
transcription::evaluate (int part, const double *z, double factor, const double *lambda,
                         double *out)
{
  if (! move_to (z))
    return false;
  functions ();
  switch (part)
    {
    case GSMBP_GOAL: *out = goal (); break;
    case GSMBP_GRADIENT: gradient (out); break;
    case GSMBP_EQUATIONS: equations_at (out); break;
    case GSMBP_JACOBIAN: jacobian (out); break;
    case GSMBP_HESSIAN: hessian (factor, lambda, out); break;
    default: std::copy (F.begin (), F.begin () + std::size_t (nf) * K, out);
    }
  return true;
}
