// Steps of Runge and Kutta of the runs in lanes.
#pragma once

#include "lanes_dp853.h"

#if ! defined (GSMBP_QUAD)

void
lane_group::begin_way (lane_run& l)
{
  l.k = 1;
  fortran {gsrkl_} (&l.ta, &l.stp[0], &l.hr, &m_ropt[2], &l.n, &l.h, &l.r.rstat[0]);
}

// one step of every run, as GSRKS does it
void
lane_group::step_4 (void)
{
  if (begun_4 ())
    {
      stages_4 ();
      judge_all_4 ();
    }
  for (int k = 0; ! m_together && k < lane_count; k++)
    if (m_l[k].alone)
      by_itself_4 (k);
}

bool
lane_group::begun_4 (void)
{
  for (int k = 0; k < lane_count; k++)
    if (m_runs(0, k) <= 0)   // a run that has joined and goes on has no error
      {
        m_l[k].ier = 0;
        join (k);
        m_c(c_t, k) = m_l[k].joined ? m_c(c_t, k) : m_s.t0;
        m_together = false;
      }
  fortran {gslnp_} (m_runs.begin (), m_c.begin (), m_step.begin (), m_tn.begin (), m_at.begin (),
                    m_slow.begin ());
  part_where (m_slow);
  const bool all = ! some_below (m_runs, 1);
  if (m_together && all)
    return true;
  m_together = all;   // then as they are now until one parts
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    {
      lane_run& l = m_l[k];
      l.alone = ! l.joined && l.busy && ready_4 (k) && l.partition ()[0] > 0;
      l.steps = l.busy && ! l.alone;
      some = some || l.steps;
      if (l.joined)
        continue;
      m_at(0, k) = l.at;
      if (l.busy && (l.alone || m_of_time))
        watch_alone (k);
    }
  return some;
}

void
lane_group::judge_all_4 (void)
{
  fortran {gslnr_} (&m_s.nx, m_runs.begin (), m_xn.begin (), m_r.begin ());
  part_failed ();
  if (m_prj)
    project ();
  fortran {gslnq_} (&m_s.nx, m_r.begin (), m_tn.begin (), m_c.begin (), m_x.begin (),
                    m_xn.begin ());
  const bool all = ! some_below (m_runs, 1);
  bool ended = false;
  for (int k = 0; k < lane_count; k++)
    ended |= m_c(c_number, k) > m_c(c_count, k);
  for (int k = 0; (! all || ended) && k < lane_count; k++)
    if (! all && ! m_l[k].joined && m_l[k].steps)
      {
        m_xn.get (k, m_l[k].next (), m_s.nx);
        m_l[k].r.istat[GS_N_RHS] += m_calls[k];
        after_4 (k);
      }
    else if (m_c(c_number, k) > m_c(c_count, k) && m_l[k].joined)
      {
        part (k);
        m_l[k].t = m_l[k].stp[0];
        keep_on (k);
      }
}

bool
lane_group::ready_4 (int lane)
{
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  fortran {gsrkt_} (&l.ta, &l.stp[0], &l.istp[0], &l.h, &l.k, &l.n, &l.t, &l.tn, &l.at);
  if (m_iopt[GS_MOST_STEPS] > 0 && r.istat[GS_N_STEPS] >= m_iopt[GS_MOST_STEPS])
    {
      end (lane, 1);
      return m_l[lane].busy && ready_4 (lane);
    }
  m_step(0, lane) = l.h;
  m_c(c_t, lane) = l.t;
  m_c(c_good, lane) = r.istat[GS_N_STEPS];
  m_c(c_look, lane) = next_look (l);
  m_tn(0, lane) = l.tn;
  return true;
}

// GSSTD ahead of a step, for the runs where a look is due; the rates at their states are known
void
lane_group::watch_4 (void)
{
  bool due[lane_count], some = false;
  for (int k = 0; k < lane_count; k++)
    {
      due[k] = m_c(c_good, k) >= m_c(c_look, k) && m_active[k];
      some |= due[k];
    }
  if (! some)
    return;
  double rho[lane_count];
  int state[lane_count];
  eigenvalues (due, rho, state);
  for (int k = 0; k < lane_count; k++)
    if (due[k])
      {
        run_room& r = m_l[k].r;
        const int good = int (m_c(c_good, k));
        r.istat[GS_N_DIVERGED] = good + std::min (1000, std::max (10, 9 * good));
        if (rho[k] * std::fabs (m_step(0, k)) > 2.78)
          {
            r.istat[GS_IS_STIFF] = 1;
            r.istat[GS_STIFF_STATE] = state[k];
            r.rstat[GS_T_STIFF] = m_c(c_t, k);
            r.rstat[GS_R_STIFF] = rho[k];
            r.rstat[GS_H_STIFF] = std::fabs (m_step(0, k));
          }
        m_c(c_look, k) = next_look (m_l[k]);
      }
}

void
lane_group::watch_alone (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  const double none = 0;
  fortran {gsste_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &m_iopt[0], &l.t, &l.h, l.state (),
                    &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (),
                    l.rp.data (), &r.cst[0], l.inputs (), &m_ropt[1], &m_ropt[3], &none, &none,
                    l.stages () + s.nx, &r.w[0], l.partition (), &r.istat[0], &r.rstat[0]);
}

// what an iteration of GSSTF knows of the lanes
struct lane_growth
{
  double old[lane_count] = { }, sum[lane_count] = { }, part[lane_count];
  int equal[lane_count] = { };

  lane_growth (void) { std::fill_n (part, lane_count, 1.0); }

  // whether an eigenvalue of 1/H can still be there
  bool possible (int k, double h)
  {
    part[k] = std::min (1e300, part[k] * old[k] * h);
    return part[k] >= 1e-4;
  }

  // after a turn that let CHANGE grow so: has it ended? Then the eigenvalue, else 0
  double settled (int k, double growth, int turn)
  {
    equal[k] = std::fabs (growth - old[k]) > 0.02 * growth ? 0 : equal[k] + 1;
    old[k] = growth;
    sum[k] += turn > 8 ? std::log (growth) : 0;
    return equal[k] == 3 ? growth : turn == 32 ? std::exp (sum[k] / 24) : 0;
  }
};

// where to GSSTF looks first, one by the usual sizes of the states
void
lane_group::begin_eigenvalues (double *change, double *size)
{
  const double rtol = m_ropt[1];
  for (int j = 0, i = 0; j < m_s.nx; j++)
    {
      const double least = rtol > 0 ? m_ropt[3 + j] / rtol : 1,
                   first = 0.5 + std::fmod (0.618 * (j + 1), 1.0);
      for (int k = 0; k < lane_count; k++, i++)
        {
          const double usual = std::fabs (m_x.begin ()[i]) + least, one = usual > 0 ? usual : 1;
          size[i] = 1 / one;
          change[i] = first * one;
        }
    }
}

// GSSTF for all lanes that are due: behind the first stage of a step, by the rates that it leaves
void
lane_group::eigenvalues (const bool *due, double *rho, int *state)
{
  const double d = std::sqrt (DBL_EPSILON);
  lane_growth g;
  lane_array& goes = m_live;
  double *base = m_f.begin (), *change = base + m_numbers, *size = change + m_numbers;
  auto fine = [this] (int k) { return m_info[k] == 0 || m_info[k] == 2 || m_info[k] == 3; };
  begin_eigenvalues (change, size);
  for (int k = 0; k < lane_count; k++)
    {
      if (due[k])   // others may have no run
        m_l[k].r.istat[GS_N_STABILITY]++;
      goes(0, k) = due[k] && fine (k);
      rho[k] = 0;
      state[k] = 1;
    }
  bool some = true;
  for (int turn = 1; turn <= 32 && some; turn++)
    {
      fortran {gslnh_} (&m_s.nx, &d, m_x.begin (), change, size, goes.begin (), m_xs.begin ());
      call_rates (m_xs.begin (), change);
      fortran {gslni_} (&m_s.nx, base, size, change, m_a.begin (), m_b.begin ());
      some = false;
      for (int k = 0; k < lane_count; k++)
        if (goes(0, k) > 0)
          {
            const double growth = m_a(0, k) / d;
            m_l[k].r.istat[GS_N_STABILITY]++;
            state[k] = int (m_b(0, k));
            rho[k] = growth > 0 && fine (k) ? g.settled (k, growth, turn) : 0;
            goes(0, k) = growth > 0 && fine (k) && rho[k] <= 0
                         && g.possible (k, std::fabs (m_step(0, k)) / 2.78);
            some = some || goes(0, k) > 0;
          }
    }
}

void
lane_group::stages_4 (void)
{
  double half[lane_count], *x = m_x.begin ();
  for (int k = 0; k < lane_count; k++)
    half[k] = m_c(c_t, k) + 0.5 * m_step(0, k);
  const double *t[] = { m_c.begin (), half, half, m_tn.begin () };
  activate ();
  for (int stage = 1; stage <= 4; stage++)
    {
      stage_rates (m_f.begin () + (stage - 1) * m_numbers, t[stage-1], x, stage == 4);
      if (stage == 1)
        watch_4 ();
      x = stage == 4 ? m_xn.begin () : m_xs.begin ();
      fortran {gsln4_} (&stage, &m_s.nx, m_step.begin (), m_x.begin (), m_f.begin (), x);
    }
}

void
lane_group::by_itself_4 (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  fortran {gsrk4_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &l.t, &l.tn, &l.at, &l.h, l.state (),
                    &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (),
                    l.rp.data (), &l.r.cst[0], l.inputs (), l.next (), l.stages (), &l.r.w[0],
                    l.partition (), &l.r.istat[0], &l.r.rstat[0], &l.ier);
  after_4 (lane);
}

void
lane_group::after_4 (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  int again = 0, info = 0;
  if (l.ier != 0)
    {
      end (lane, 3);
      return;
    }
  fortran {gsrkq_} (s.rhs, s.prj, s.con, s.kin, s.cmd, s.clo, s.vin, s.evt, s.rst, &l.t, &l.tn,
                    &l.stp[0], &l.at, &l.h, &l.ta, &l.hr, m_siz, &m_iopt[0], &m_ropt[0],
                    l.ip.data (), l.rp.data (), &r.cst[0], l.iw, &r.w[0], &r.istat[0], &r.rstat[0],
                    &again, &info);
  if (info == 0 && again == 1)
    begin_way (l);
  else if (info == 0 && ++l.k > l.n)
    {
      l.t = l.stp[0];
      if (! stopped (l))
        {
          end (lane, r.info);
          return;
        }
    }
  if (info != 0)
    end (lane, info);
  else
    next_state (lane);
}

#endif
