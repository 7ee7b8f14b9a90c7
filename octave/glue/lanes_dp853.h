// Steps of Dormand and Prince of the runs in lanes.
#pragma once

#include "lanes_events.h"

#if ! defined (GSMBP_QUAD)

// one trial step of every run, as GSDPS does it
void
lane_group::step_8 (void)
{
  rates_8 ();
  if (begun_8 ())
    in_lanes_8 ();
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].alone)
      by_itself_8 (k);
}

// the rates at the states where they are not yet known
void
lane_group::rates_8 (void)
{
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    {
      lane_run& l = m_l[k];
      if (! l.joined)
        {
          join (k);
          m_c(c_t, k) = l.busy ? l.t : m_s.t0;
        }
      int wanted = l.joined ? int (m_c(c_fresh, k)) : l.busy ? l.lm[0] : 0;
      l.alone = wanted == 1 && l.partition ()[0] > 0;
      l.steps = wanted == 1 && ! l.alone;
      l.ier = 0;
      l.at = 1;
      m_fresh(0, k) = l.steps;
      some = some || l.steps;
    }
  activate ();
  if (some)
    stage_rates (m_new.begin (), m_c.begin (), m_x.begin (), false);
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].alone)
      rates_by_itself (k);
}

// which runs are ready for a step in lanes; false: none
bool
lane_group::begun_8 (void)
{
  const int many = m_iopt[GS_METHOD] == 9 ? 100 : 500;
  fortran {gslnk_} (&m_s.nx, m_fresh.begin (), m_new.begin (), m_f.begin (),
                    m_x.begin (), m_xs.begin (), &m_ropt[1], &m_ropt[3], &many, m_c.begin (),
                    m_slow.begin ());
  part_where (m_slow);
  if (m_prj && m_iopt[GS_WATCH] == 1)
    look_ahead ();
  fortran {gslna_} (&m_s.nx, m_runs.begin (), m_c.begin (), m_limit.begin (),
                    m_step.begin (), m_h.begin (), m_tn.begin (), m_at.begin (), m_slow.begin ());
  part_where (m_slow);
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    {
      lane_run& l = m_l[k];
      l.steps = l.joined;
      l.alone = false;
      if (! l.joined && l.busy && found_8 (k) && ready_8 (k))
        {
          l.steps = true;
          m_at(0, k) = l.at;
          m_c(c_t, k) = l.t;
          m_tn(0, k) = l.tn;
        }
      some = some || l.steps;
    }
  return some;
}

void
lane_group::in_lanes_8 (void)
{
  stages_8 ();
  fortran {gslne_} (&m_s.nx, m_step.begin (), m_x.begin (), m_f.begin (), &m_ropt[1],
                    &m_ropt[3], &m_c8[0], m_xn.begin (), m_err.begin (), m_a.begin (),
                    m_b.begin ());
  judge_all_8 ();
}

void
lane_group::judge_all_8 (void)
{
  fortran {gslnj_} (m_runs.begin (), m_c.begin (), m_tn.begin (), m_err.begin (),
                    m_r.begin ());
  part_failed ();
  if (m_events > 0)
    look_for_events ();
  if (m_prj)
    project ();
  fortran {gslnu_} (&m_s.nx, m_r.begin (), m_step.begin (), m_tn.begin (),
                    m_err.begin (), m_c.begin (), m_x.begin (), m_xn.begin ());
  if (m_events > 0)
    remember_quiet ();
  for (int k = 0; k < lane_count; k++)
    if (! m_l[k].joined)
      {
        if (m_l[k].steps)
          after_8 (k);
      }
    else if (m_r(0, k) == 1 && m_c(c_t, k) >= m_c(c_stop, k))
      {
        part (k);
        keep_on (k);
      }
}

void
lane_group::rates_by_itself (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  const int side = 1;
  fortran {gsfun_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &l.t, &side, l.state (), &m_siz[0],
                    &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (), l.rp.data (),
                    &l.r.cst[0], l.inputs (), l.stages (), &l.r.w[0], l.partition (), &l.r.istat[0],
                    &l.r.rstat[0], &l.ier);
  next_state (lane);
  m_f.put (lane, l.stages (), s.nx);
}

// GSDPF behind its call of the right-hand side; false where the run ended
bool
lane_group::found_8 (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  if (l.lm[0] == 0)
    return true;
  l.lm[0] = 0;
  double *f = l.stages (), *v = l.inputs ();
  int info = l.ier != 0 ? 3 : 0;
  m_f.get (lane, f, s.nx);
  r.istat[GS_N_RHS] += m_calls[lane];
  if (info == 0 && ! fine (f, s.nx))
    info = 8;
  if (info == 0 && l.lm[1] == 1)
    {
      for (int j = 0; j < s.nx; j++)
        f[11 * s.nx + j] = m_f(11 * s.nx + j, lane);
      m_xs.get (lane, f + 12 * s.nx, s.nx);
      fortran {gsstd_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &m_iopt[0], &l.t, &l.m[1],
                        l.state (), &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4],
                        l.ip.data (), l.rp.data (), &r.cst[0], v, &m_ropt[1], &m_ropt[3], f,
                        &r.w[0], l.partition (), &r.istat[0], &r.rstat[0]);
      if (r.istat[GS_IS_STIFF] > 0 && m_iopt[GS_METHOD] == 9)
        info = 5;
    }
  if (info == 0 && l.m[0] <= 0)
    {
      double left = std::min (l.hmax, l.stp[0] - l.t);
      int ier = 0;
      fortran {gshin_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &l.t, &left, l.state (),
                        &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (),
                        l.rp.data (), &r.cst[0], v, &m_ropt[1], &m_ropt[3], f, &r.w[0],
                        l.partition (), &r.istat[0], &r.rstat[0], &l.m[0], &ier);
      if (ier != 0)
        info = 3;
    }
  if (info != 0)
    end (lane, info);
  return info == 0;
}

// whether a trial step in the lane is next, of the length that it then has
bool
lane_group::ready_8 (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  double most = 1e300, step = std::min (l.m[0], l.hmax);
  int taken = 0, info = 0;
  if (S.nlam > 0)
    {
      fortran {gspss_} (s.rhs, s.prj, s.con, s.kin, s.cmd, s.clo, s.vin, s.evt, s.rst, &l.t, l.stp,
                        l.istp, &step, l.siz, &l.tim[0], &m_iopt[0], &m_ropt[0], l.ip.data (),
                        l.rp.data (), &r.cst[0], &r.xout[0], &r.vout[0], l.partition (), l.m, l.lm,
                        l.iw, &r.w[0], &most, &taken, &r.istat[0], &r.rstat[0], &info);
      if (taken == 1)
        {
          l.lm[0] = 1;
          l.lm[1] = 0;
          std::swap (l.iw[0], l.iw[1]);
          next_state (lane);
          if (info == 0 && l.t >= l.stp[0] && ! stopped (l))
            info = -1;
        }
      else if (info == 0 && l.lm[5] > 0)
        {
          info = 3;
          r.istat[GS_FAILED_INFO] = 3;
          r.istat[GS_FAILED] = GS_AT_START;
        }
    }
  if (info == 0 && taken == 0)
    {
      step = std::min (step, most);
      fortran {gsdta_} (s.con, s.kin, &l.t, &l.stp[0], &l.istp[0], &step, m_siz, &m_iopt[0],
                        &r.cst[0], l.state (), l.partition (), l.m, l.lm, &l.tn, &l.at, &l.h,
                        &r.istat[0], &info);
    }
  if (info != 0)
    end (lane, info == -1 ? r.info : info);
  else if (taken == 0 && l.partition ()[0] > 0)
    l.alone = true;
  else if (taken == 0)
    {
      m_step(0, lane) = l.h;
      for (int k = 0; k < s.nx; k++)
        m_h(k, lane) = l.h;
      return true;
    }
  park (lane);
  return false;
}

void
lane_group::stages_8 (void)
{
  double t[lane_count];
  activate ();
  for (int stage = 2; stage <= 12; stage++)
    {
      fortran {gslns_} (&m_numbers, &m_n[stage-1], &m_c8[12*(stage-1)], &m_j[12*(stage-1)],
                        m_h.begin (), m_x.begin (), m_f.begin (), m_xs.begin ());
      fortran {gslnt_} (m_c.begin (), &m_ts[stage-1], m_step.begin (), t);
      if (stage == 12)
        std::copy_n (m_tn.begin (), lane_count, t);
      stage_rates (m_f.begin () + std::size_t (stage - 1) * m_numbers, t, m_xs.begin (),
                   stage == 12);
    }
}

void
lane_group::after_8 (int lane)
{
  lane_run& l = m_l[lane];
  m_xn.get (lane, l.next (), m_s.nx);
  l.r.istat[GS_N_RHS] += m_calls[lane];
  // rows within the step and events in it need all stages
  const bool all = m_tim[l.istp[1]] < l.tn || l.ip[GS_EVENTS] > 0;
  if (all)
    {
      m_f.get (lane, l.stages (), 12 * m_s.nx);
      m_xs.get (lane, l.stages () + 12 * m_s.nx, m_s.nx);
    }
  judge_8 (lane, l.ier == 0 ? m_err(0, lane) : 0);
}

// a step whose stages are completed from independent coordinates (GSPRT)
void
lane_group::by_itself_8 (int lane)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  double err = 0, *f = l.stages ();
  fortran {gsdp8_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &l.t, &l.tn, &l.at, &l.h, l.state (),
                    &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (),
                    l.rp.data (), &l.r.cst[0], l.inputs (), &m_ropt[1], &m_ropt[3], l.next (), &err,
                    f, &l.r.w[0], l.partition (), &l.r.istat[0], &l.r.rstat[0], &l.ier);
  for (int j = 0; j < s.nx; j++)
    m_f(11 * s.nx + j, lane) = f[11 * s.nx + j];
  m_xs.put (lane, f + 12 * s.nx, s.nx);
  judge_8 (lane, err);
}

void
lane_group::judge_8 (int lane, double err)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  int taken = 0, info = 0;
  fortran {gsdtb_} (s.rhs, s.prj, s.con, s.kin, s.cmd, s.clo, s.vin, s.evt, s.rst, &l.t, &l.stp[0],
                    &l.tn, &l.at, &l.h, &err, &l.ier, l.siz, &l.tim[0], &m_iopt[0], &m_ropt[0],
                    l.ip.data (), l.rp.data (), &r.cst[0], &r.xout[0], &r.vout[0], &l.istp[1],
                    l.state (), l.next (), l.inputs (), l.stages (), &r.w[0], l.partition (), l.m,
                    l.lm, &taken, &r.istat[0], &r.rstat[0], &info);
  if (l.lm[0] == 2)   // the rates at the end of the step are known
    m_f.put (lane, l.stages () + s.nx, s.nx);
  if (taken == 1)
    std::swap (l.iw[0], l.iw[1]);
  if (info != 0)
    end (lane, info);
  else if (taken == 1 && l.t >= l.stp[0])
    keep_on (lane);
  else if (taken == 1)
    next_state (lane);
}

#endif
