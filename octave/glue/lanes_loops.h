// The loops of the runs in lanes that have joined: projection, drift, rank, least pivots, the look
// ahead for singular positions.
#pragma once

#include "lanes_joined.h"

#if ! defined (GSMBP_QUAD)

// whether what GSPSS and GSCHK do for the run is done in vectors
bool
lane_group::closes (const lane_run& l) const
{
  if (S.nlam == 0)
    return S.nq == S.nu;
  const int way = m_iopt[GS_LOOPS];
  return m_prj && way == 2 && m_iopt[GS_WATCH] == (m_iopt[GS_DRIFT] == 1)
         && l.lm[5] <= 0 && l.lm[2] == 0 && (m_iopt[GS_METHOD] == 4 || m_ropt[1] >= l.m[5]);
}

void
lane_group::join_loops (int lane)
{
  lane_run& l = m_l[lane];
  const double *rstat = &l.r.rstat[0], *p = l.partition ();
  m_p.put (lane, p, 24 + 18 * S.nq + 7 * S.nlam + 2 * S.nlam * S.nq);
  m_c(c_pivot, lane) = p[12];
  m_c(c_largest, lane) = p[13];
  for (int k = 0; k < 5; k++)
    m_c(c_drift + k, lane) = rstat[k];
  m_c(c_smallest, lane) = rstat[GS_R_PIVOT];
  m_c(c_smallest_at, lane) = rstat[GS_T_PIVOT];
  m_c(c_projections, lane) = l.r.istat[GS_N_PROJECTIONS];
  m_c(c_past, lane) = l.m[7];
  m_c(c_turn, lane) = l.m[10];
  m_c(c_known, lane) = 0;
}

void
lane_group::part_loops (int lane)
{
  lane_run& l = m_l[lane];
  double *rstat = &l.r.rstat[0];
  m_p.get (lane, l.partition (), 24 + 18 * S.nq + 7 * S.nlam + 2 * S.nlam * S.nq);
  for (int k = 0; k < 5; k++)
    rstat[k] = m_c(c_drift + k, lane);
  rstat[GS_R_PIVOT] = m_c(c_smallest, lane);
  rstat[GS_T_PIVOT] = m_c(c_smallest_at, lane);
  l.r.istat[GS_N_PROJECTIONS] = int (m_c(c_projections, lane));
  l.m[10] = m_c(c_turn, lane);
}

void
lane_group::jacobians (const double *t, const double *q, lane_array& hc)
{
  const int k = lane_count;
  fortran {m_con} (t, q, m_cst.begin (), hc.begin (), m_info, &k, &k);
}

// those at the states of the runs that have just joined
void
lane_group::know_jacobians (void)
{
  bool all = true;
  for (int k = 0; k < lane_count; k++)
    all = all && (m_runs(0, k) <= 0 || m_c(c_known, k) > 0);
  if (all)
    return;
  jacobians (m_c.begin (), m_x.begin (), m_hn);
  for (int k = 0; k < lane_count; k++)
    if (m_runs(0, k) > 0 && m_c(c_known, k) <= 0)
      {
        for (int j = 0; j < S.nlam * S.nq; j++)
          m_hc(j, k) = m_hn(j, k);
        m_c(c_known, k) = 1;
      }
}

// GSCHK for the good steps of those that have joined; where it is not the usual case they part,
// with their states as the step left them
void
lane_group::project (void)
{
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    {
      m_live(0, k) = m_r(0, k) == 1;
      m_slow(0, k) = 0;
      some = some || m_r(0, k) == 1;
    }
  if (! some)
    return;
  if (m_iopt[GS_WATCH] == 1)
    know_jacobians ();
  std::copy_n (m_xn.begin (), m_numbers, m_new.begin ());
  onto_constraints ();
  if (m_iopt[GS_WATCH] == 1)
    watch_loops ();
  for (int k = 0; k < lane_count; k++)
    if (m_r(0, k) == 1 && m_slow(0, k) > 0)
      {
        for (int j = k; j < m_numbers; j += lane_count)
          m_xn.begin ()[j] = m_new.begin ()[j];
        part (k);
        m_r(0, k) = 0;
      }
    else if (m_r(0, k) == 1)
      {
        m_c(c_projections, k)++;
        m_c(c_projected, k) = std::max (m_c(c_projected, k), m_res(0, k));
      }
  if (m_iopt[GS_WATCH] != 1)
    return;
  fortran {gsllu_} (&S.nlam, &S.nq, m_r.begin (), m_tn.begin (), m_xn.begin (),
                    m_long.begin (), m_rank.begin (), m_least.begin (), m_gap.begin (),
                    m_left.begin (), m_p.begin (), m_c.begin ());
  for (int k = 0; k < lane_count; k++)
    for (int j = 0; m_r(0, k) == 1 && j < S.nlam * S.nq; j++)
      m_hc(j, k) = m_hn(j, k);
}

// GSPRJ; some turns, then it is left to each alone
void
lane_group::onto_constraints (void)
{
  const int n = lane_count;
  int many = 1;
  for (int turn = 1; turn <= 8 && many == 1; turn++)
    {
      fortran {m_prj} (m_tn.begin (), m_xn.begin (), m_cst.begin (), m_phi.begin (),
                       m_rate.begin (), m_hn.begin (), m_dq.begin (), m_du.begin (), m_info, &n,
                       &n);
      fortran {gslln_} (&S.nlam, &S.nq, &turn, m_phi.begin (), m_rate.begin (),
                        m_hn.begin (), m_dq.begin (), m_du.begin (), m_info, m_xn.begin (),
                        m_res.begin (), m_gap.begin (), m_left.begin (), m_live.begin (),
                        m_slow.begin (), &many);
    }
  for (int k = 0; k < lane_count; k++)
    if (m_live(0, k) > 0)
      m_slow(0, k) = 1;
  if (m_iopt[GS_METHOD] != 4)
    fortran {gsllj_} (&S.nq, m_x.begin (), m_xn.begin (), m_new.begin (), &m_ropt[1],
                      &m_ropt[3], m_slow.begin ());
}

// the rank of the constraints, their least pivot
void
lane_group::watch_loops (void)
{
  fortran {gsllv_} (&S.nlam, &S.nq, m_hn.begin (), sizes (), m_long.begin (),
                    m_y.begin (), m_w.begin (), m_rank.begin (), m_least.begin ());
  fortran {gsllt_} (&S.nlam, &S.nq, m_hn.begin (), m_hc.begin (), m_long.begin (),
                    m_turn.begin ());
  for (int k = 0; k < lane_count; k++)
    m_margin(0, k) = m_iopt[GS_METHOD] == 4 ? 0.01 : m_tn(0, k) < m_c(c_stop, k) ? m_l[k].m[6] : 0;
  fortran {gsllc_} (&S.nq, m_xn.begin (), m_gap.begin (), m_rank.begin (),
                    m_least.begin (), m_turn.begin (), m_margin.begin (), m_p.begin (),
                    m_slow.begin ());
}

// GSPSS where no singular position is ahead; those that may have one part
void
lane_group::look_ahead (void)
{
  double h[lane_count];
  for (int k = 0; k < lane_count; k++)
    {
      m_fresh(0, k) = m_runs(0, k) > 0 && m_c(c_fresh, k) <= 0;
      h[k] = std::min (m_c(c_next, k), m_c(c_longest, k));
      m_limit(0, k) = 1e300;
    }
  fortran {gslla_} (m_fresh.begin (), m_c.begin (), m_p.begin (), m_live.begin ());
  if (far_ahead (h))
    look_along ();
  part_where (m_slow);
}

// is a singular position so near that it may lie behind as well?
bool
lane_group::close_by (int lane) const
{
  return m_c(c_pivot, lane) < 0.3 * m_c(c_largest, lane);
}

// how far those can see that look; false: none
bool
lane_group::far_ahead (const double *h)
{
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    {
      m_slow(0, k) = 0;
      some = some || m_live(0, k) > 0;
      m_tau(0, k) = m_live(0, k) > 0 ? 0.01 * h[k] : 0;
    }
  if (! some)
    return false;
  know_jacobians ();
  fortran {gsllx_} (&S.nq, m_c.begin (), m_x.begin (), m_f.begin (), m_tau.begin (),
                    m_stage_t.begin (), m_q.begin ());
  jacobians (m_stage_t.begin (), m_q.begin (), m_hn);
  fortran {gsllt_} (&S.nlam, &S.nq, m_hn.begin (), m_hc.begin (), sizes (),
                    m_turn.begin ());
  for (int k = 0; k < lane_count; k++)
    if (m_live(0, k) > 0)
      {
        if (m_info[k] != 0 || ! (m_turn(0, k) <= 0.3))
          m_slow(0, k) = 1;
        m_turn(0, k) = 1.2 * m_tau(0, k) / std::max (m_turn(0, k), 1e-10);
      }
  for (int k = 0; k < lane_count; k++)
    if (m_live(0, k) > 0 && m_slow(0, k) <= 0)
      {
        const double rest = 2 * (m_s.tout[m_s.nt - 1] - m_c(c_t, k));   // as GSAHD
        m_c(c_turn, k) = m_turn(0, k);
        m_limit(0, k) = std::min (h[k], m_turn(0, k));
        m_way(0, k) = close_by (k) ? m_turn(0, k) : std::min (m_turn(0, k), rest);
        if (m_way(0, k) < 0.1 * m_turn(0, k))
          m_live(0, k) = 0;
      }
    else
      m_live(0, k) = 0;
  return true;
}

// The least pivots along the ways ahead, at 9 places, or 13 about the state where the pivot is
// small already. Between three of which the middle one is the least the pivot is no less than a
// line twice as steep as they are has it.
void
lane_group::look_along (void)
{
  const int places = 13;
  double pivot[places + 2][lane_count];
  int from[lane_count], last = 0;
  for (int k = 0; k < lane_count; k++)
    {
      bool close = close_by (k);
      from[k] = close ? 0 : -1;
      pivot[0][k] = m_c(c_pivot, k);
      last = std::max (last, m_live(0, k) <= 0 ? 0 : close ? places : 9);
    }
  for (int i = 0; i < last; i++)
    {
      for (int k = 0; k < lane_count; k++)
        {
          double part = from[k] < 0 ? 0.125 * (i + 1) : -0.6 + 1.6 / 12 * i;
          m_tau(0, k) = m_live(0, k) > 0 ? part * m_way(0, k) : 0;
        }
      fortran {gsllx_} (&S.nq, m_c.begin (), m_x.begin (), m_f.begin (),
                        m_tau.begin (), m_stage_t.begin (), m_q.begin ());
      jacobians (m_stage_t.begin (), m_q.begin (), m_hn);
      fortran {gsllv_} (&S.nlam, &S.nq, m_hn.begin (), sizes (), m_long.begin (),
                        m_y.begin (), m_w.begin (), m_rank.begin (), m_least.begin ());
      for (int k = 0; k < lane_count; k++)
        pivot[i + 1][k] = m_info[k] != 0 || m_rank(0, k) < m_p(2, k) ? 0 : m_least(0, k);
    }
  for (int k = 0; k < lane_count; k++)
    for (int i = from[k] + 1, n = from[k] < 0 ? 9 : places; m_live(0, k) > 0 && i <= n; i++)
      {
        bool ahead = from[k] < 0, first = i == from[k] + 1;
        if (ahead && (first || i == n))
          continue;
        double at = pivot[i][k];
        double before = first ? pivot[i+1][k] : pivot[i-1][k];
        double behind = i == n ? pivot[i-1][k] : pivot[i+1][k];
        if (at > before || at > behind)
          continue;
        double share = ahead ? 0.25 : 0.2;
        if (! (3 * at - 2 * std::max (before, behind) > share * m_c(c_largest, k)))
          {
            m_slow(0, k) = passage (k, from[k] < 0 ? 0.125 * (i - 1) : -0.6,
                                    from[k] < 0 ? 0.125 * (i + 1) : 1);
            break;
          }
        if (ahead)
          break;
      }
}

// is there a passage to be tried? If not yet, no step leads into it.
bool
lane_group::passage (int lane, double from, double to)
{
  double at, least = search (lane, from, to, at), turn = m_turn(0, lane), t = m_c(c_t, lane);
  if (least > 0.2 * m_c(c_largest, lane))
    return false;
  double middle = t + at * m_way(0, lane), d = 0.8 * turn, full = m_l[lane].m[9] * d;
  if (t > middle + 0.5 * d)
    return false;
  if (t >= middle - 1.05 * full)
    return true;
  m_limit(0, lane) = std::min (m_limit(0, lane), middle - full - t);
  return false;
}

// the least pivot along the way of one run, as GSPMN finds it, by the lanes of all
double
lane_group::search (int lane, double from, double to, double& at)
{
  const int n = S.nq, m = S.nlam;
  double least = 1e300, width = (to - from) / 12;
  at = 0.5 * (from + to);
  lane_array& cst = m_cst_1;
  for (int j = 0; j < S.ncst; j++)
    std::fill_n (&cst(j, 0), lane_count, m_cst(j, lane));
  for (int j = 0; j < m; j++)
    std::fill_n (&m_rate(j, 0), lane_count, sizes ()[j * lane_count + lane]);
  for (int level = 0; level < 4; level++, width *= 0.2)
    {
      double middle = at, place[lane_count];
      for (int k = 0; k < lane_count; k++)
        {
          place[k] = middle + std::min (k - 6, 6) * width;
          double tau = place[k] * m_way(0, lane);
          m_stage_t(0, k) = m_c(c_t, lane) + tau;
          for (int j = 0; j < n; j++)
            m_q(j, k) = m_x(j, lane) + tau * (m_f(j, lane) + 0.5 * tau * m_f(n + j, lane));
        }
      const int many = lane_count;
      fortran {m_con} (m_stage_t.begin (), m_q.begin (), cst.begin (), m_hn.begin (), m_info, &many,
                       &many);
      fortran {gsllv_} (&m, &n, m_hn.begin (), m_rate.begin (), m_long.begin (),
                        m_y.begin (), m_w.begin (), m_rank.begin (), m_least.begin ());
      for (int k = 0; k < 13; k++)
        {
          double pivot = m_rank(0, k) < m_p(2, lane) ? 0 : m_least(0, k);
          if (m_info[k] == 0 && pivot < least && place[k] >= from - 0.1 * width
              && place[k] <= to + 0.1 * width)
            {
              least = pivot;
              at = place[k];
            }
        }
    }
  return least;
}

#endif
