// Runs in lanes from stop to stop, each by itself: how they begin and end, and the right-hand sides
// of all of them.
#pragma once

#include "lane_group.h"

#if ! defined (GSMBP_QUAD)

lane_group::lane_group (const run_setting& s, const std::vector<int>& ip, lane_source& source,
                        int most)
  : m_s (s), m_source (source), m_most (std::min (most, lane_count)),
    m_rhs (emitted ("rhs_w")->sub), m_siz {S.nq, S.nu, s.nx, S.nv, S.nlam, s.nt, 0, s.lw},
    m_numbers (lane_count * s.nx), m_width (lane_count), m_failed (false), m_together (false),
    m_iopt (s.iopt), m_tim (1, s.t0), m_ropt (s.ropt), m_n (12), m_j (144), m_c8 (144), m_ts (12),
    m_x (s.nx), m_xs (s.nx), m_xn (s.nx), m_f (12 * s.nx), m_h (s.nx), m_v (S.nv), m_cst (S.ncst),
    m_cst_1 (S.nlam > 0 ? S.ncst : 0),
    m_new (s.nx), m_stage_t (1), m_step (1), m_err (1), m_a (1), m_b (1), m_c (40), m_runs (1),
    m_slow (1), m_fresh (1), m_limit (1), m_tn (1), m_at (1), m_r (1), m_evt (nullptr),
    m_events (looks_at (s, ip)), m_looks (1), m_g (m_events), m_g0 (m_events),
    m_old (m_events), m_older (m_events), m_mark (m_events), m_noise (m_events),
    m_bend (m_events), m_allowed (m_events), m_apart (m_events), m_needs (m_events),
    m_until (m_events), m_repeats (m_events), m_fn (m_events > 0 ? s.nx : 0),
    m_z (m_events > 0 ? s.nx : 0), m_loud (1), m_con (nullptr),
    m_prj (nullptr), m_p (24 + 18 * S.nq + 7 * S.nlam + 2 * S.nlam * S.nq), m_q (S.nq),
    m_phi (S.nlam), m_rate (S.nlam), m_hc (S.nlam * S.nq), m_hn (S.nlam * S.nq), m_dq (S.nq),
    m_du (S.nq), m_long (S.nlam), m_y (S.nlam * S.nq), m_w (S.nlam + 8), m_res (1), m_gap (1),
    m_left (1), m_live (1), m_rank (1), m_least (1), m_turn (1), m_way (1), m_margin (1), m_tau (1)
{
  if (S.nlam > 0 && emitted ("prj_w") && emitted ("con_w"))
    {
      m_prj = emitted ("prj_w")->sub;
      m_con = emitted ("con_w")->sub;
    }
  if (m_events > 0)
    m_evt = emitted ("evt_w")->sub;
  std::fill_n (m_limit.begin (), lane_count, 1e300);
  m_tim.insert (m_tim.end (), s.tout.begin (), s.tout.begin () + s.nt);
  m_ropt.insert (m_ropt.end (), s.atol.begin (), s.atol.end ());
  m_of_time = ip[GS_V0] != 0 || ip[GS_FEEDBACK] != 0;
  fortran {gslnc_} (&m_n[0], &m_c8[0], &m_j[0], &m_ts[0]);
}

bool
lane_group::any (void) const
{
  return std::any_of (m_l, m_l + lane_count, [] (const lane_run& l) { return l.busy; });
}

void
lane_group::run_all (void)
{
  for (lane_run& l : m_l)
    {
      l.busy = l.steps = l.alone = l.joined = false;
      l.started = false;
    }
  for (int k = 0; k < m_most; k++)
    fill (k);
  for (int k = 1; k < lane_count && any (); k++)
    if (! m_l[k].started)   // it goes on with numbers that are good
      take_numbers (k);
  while (any () && ! left ())
    if (m_iopt[GS_METHOD] == 4)
      step_4 ();
    else
      step_8 ();
}

// were all runs ended from outside?  Then those of the lanes are where they stand.
bool
lane_group::left (void)
{
  const int info = m_source.over ();
  if (info == 0)
    return false;
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].busy)
      {
        part (k);
        end (k, info);
      }
  return true;
}

// the next run that does not end at once; without one the lane goes on with numbers that are good
void
lane_group::fill (int lane)
{
  lane_run& l = m_l[lane];
  for (l.busy = l.steps = l.alone = false; ! l.busy && m_source.next (l); )
    if (begin (l))
      l.busy = true;
    else
      finish (l);
  if (! l.busy || m_iopt[GS_METHOD] != 4)   // the next step of rk4 writes all that it reads
    park (lane);
  if (! l.busy)
    return;
  l.started = true;
  next_state (lane);
  m_cst.put (lane, &l.r.cst[0], S.ncst);
}

void
lane_group::next_state (int lane)
{
  m_x.put (lane, m_l[lane].state (), m_s.nx);
  m_v.put (lane, m_l[lane].inputs (), S.nv);
}

// the state, inputs and constants of the first lane that has a run
void
lane_group::take_numbers (int lane)
{
  int from = 0;
  while (! m_l[from].busy)
    from++;
  lane_run& l = m_l[from];
  m_x.put (lane, l.state (), m_s.nx);
  m_v.put (lane, l.inputs (), S.nv);
  m_cst.put (lane, &l.r.cst[0], S.ncst);
}

// zero rates and steps: its state stays.  The rates of the first KNOWN stages do, too.
void
lane_group::park (int lane, int known)
{
  for (int k = 0; k < m_s.nx; k++)
    m_h(k, lane) = 0;
  for (int k = known * m_s.nx; k < (m_iopt[GS_METHOD] == 4 ? 4 : 12) * m_s.nx; k++)
    m_f(k, lane) = 0;
  m_step(0, lane) = 0;
  m_active[lane] = 0;
}

// for the rest of a step in which a stage has failed: the next trial begins with the same rates
// and is shorter than this one
void
lane_group::rest (int lane)
{
  bool known = true;
  for (int k = 0; k < m_s.nx; k++)
    known = known && std::fabs (m_f(k, lane)) <= 1e300;
  if (m_l[lane].joined)
    m_l[lane].h = m_step(0, lane);
  park (lane, known);
}

// the beginning of GSSIM; false where the run has ended
bool
lane_group::begin (lane_run& l)
{
  const run_setting& s = m_s;
  run_room& r = l.r;
  l.tim = m_tim;
  l.tim.insert (l.tim.end (), r.breaks.begin (), r.breaks.end ());
  std::copy_n (m_siz, 8, l.siz);
  l.siz[6] = int (r.breaks.size ());
  fortran {gsarg_} (l.siz, &l.tim[0], &r.x0[0], &m_iopt[0], &m_ropt[0], &l.ip[GS_DERIVATIVES],
                    &r.info);
  if (r.info != 0)
    return false;
  fortran {gsini_} (&m_tim[0], &r.x0[0], &m_tim[s.nt], &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3],
                    &m_siz[4], &m_iopt[0], &m_ropt[0], &l.ip[GS_DERIVATIVES], l.iw, &r.w[0], l.m,
                    l.lm, &l.hmax, &r.istat[0], &r.rstat[0]);
  l.t = s.t0;
  l.istp[1] = l.istp[2] = 1;
  fortran {gsbgn_} (s.rhs, s.prj, s.con, s.kin, s.cmd, s.clo, s.vin, s.out, s.ctl, s.evt, s.rst,
                    &l.t, l.state (), &l.hmax, &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3],
                    &m_siz[4], &m_iopt[0], l.ip.data (), l.rp.data (), &r.cst[0], l.inputs (),
                    l.stages (), l.next (), l.w (5), l.w (6), &r.w[0], l.partition (), &l.m[4],
                    &l.lm[5], &r.istat[0], &r.rstat[0], &r.info);
  return r.info == 0 && to_next_stop (l);
}

// at a stop: outputs, samples, the next stop; false at the end of the run
bool
lane_group::to_next_stop (lane_run& l)
{
  const run_setting& s = m_s;
  run_room& r = l.r;
  int acted = 0;
  r.rstat[GS_T_REACHED] = l.t;
  fortran {gssto_} (s.out, s.ctl, s.cmd, s.clo, s.vin, s.evt, s.rst, &m_iopt[0], &l.t,
                    l.state (), l.siz, &l.tim[0], l.ip.data (), l.rp.data (), &r.cst[0],
                    l.inputs (), &r.w[0], &r.xout[0], &r.vout[0], l.stp, l.istp, &acted,
                    &r.istat[0], &r.info);
  if (r.info != 0 || l.istp[1] > s.nt)
    return false;
  if (acted == 1)
    {
      l.lm[0] = 1;
      l.lm[1] = 0;
    }
  if (m_iopt[GS_METHOD] == 4)
    {
      l.ta = l.t;
      l.hr = m_ropt[0];
      begin_way (l);
    }
  return true;
}

// the inputs at a stop for the record, and on from there; false at the end of the run
bool
lane_group::stopped (lane_run& l)
{
  const run_setting& s = m_s;
  run_room& r = l.r;
  int ier = 0;
  fortran {gsinp_} (s.cmd, s.clo, s.vin, &l.t, &l.istp[0], l.state (), &m_siz[1], &m_siz[2],
                    &m_siz[3], l.ip.data (), l.rp.data (), &r.cst[0], l.inputs (), &r.w[0], &ier);
  if (ier == 0)
    return to_next_stop (l);
  r.info = 3;
  r.istat[GS_FAILED_INFO] = ier;
  r.istat[GS_FAILED] = GS_AT_INPUTS;
  return false;
}

// the run is over: where it came to if that is not its end
void
lane_group::finish (lane_run& l)
{
  run_room& r = l.r;
  if (r.info >= 0 && r.istat[GS_N_OUTPUTS] < m_s.nt)
    {
      std::copy_n (l.state (), m_s.nx, &r.xout[std::size_t (m_s.nx) * r.istat[GS_N_OUTPUTS]]);
      std::copy_n (l.inputs (), S.nv, &r.vout[std::size_t (S.nv) * r.istat[GS_N_OUTPUTS]]);
    }
  m_source.done (l);
}

void
lane_group::end (int lane, int info)
{
  m_l[lane].r.info = info;
  finish (m_l[lane]);
  fill (lane);
}

// the inputs of a lane at a time and state
void
lane_group::inputs_of (int lane, double t, int side, const double *x)
{
  const run_setting& s = m_s;
  lane_run& l = m_l[lane];
  int info = 0;
  fortran {gsinp_} (s.cmd, s.clo, s.vin, &t, &side, x, &m_siz[1], &m_siz[2], &m_siz[3],
                    l.ip.data (), l.rp.data (), &l.r.cst[0], l.inputs (), &l.r.w[0], &info);
  if (info != 0)
    {
      l.ier = info;
      m_failed = true;
      l.r.istat[GS_FAILED_INFO] = info;
      l.r.istat[GS_FAILED] = GS_AT_INPUTS;
      rest (lane);
      return;
    }
  m_v.put (lane, l.inputs (), S.nv);
}

void
lane_group::call_rates (const double *x, double *xd)
{
  const int k = lane_count;
  fortran {m_rhs} (m_stage_t.begin (), x, m_v.begin (), m_cst.begin (), xd, m_info, &m_width, &k);
}

// as GSFUT tells of an INFO that is not 0
void
lane_group::told (int lane, int info, double t)
{
  lane_run& l = m_l[lane];
  std::vector<int>& istat = l.r.istat;
  if (info == 2 || info == 3)
    {
      const int k = info + 6;
      if (istat[k-1] == 0)
        l.r.rstat[2 * k - 7] = t;
      l.r.rstat[2 * k - 6] = t;
      istat[k-1]++;
    }
  else
    {
      l.ier = info;
      m_failed = true;
      istat[GS_FAILED_INFO] = info;
      istat[GS_FAILED] = GS_AT_RHS;
      rest (lane);
    }
}

// the right-hand sides of all lanes at the states X of a stage; those that take part are told.
// last: at the end of the step
void
lane_group::stage_rates (double *xd, const double *t, double *x, bool last)
{
  const int nx = m_s.nx, left = -1;
  std::copy_n (t, lane_count, m_stage_t.begin ());
  for (int k = 0; last && k < lane_count; k++)
    if (m_at(0, k) < 0)
      m_stage_t(0, k) = gslft_ (&t[k], &left);
  for (int k = 0; m_of_time && k < lane_count; k++)
    if (m_active[k])
      {
        double one[nx];
        for (int j = 0; j < nx; j++)
          one[j] = x[j * lane_count + k];
        inputs_of (k, t[k], last ? int (m_at(0, k)) : 1, one);
      }
  call_rates (x, xd);
  int some = 0;
  for (int k = 0; k < lane_count; k++)
    {
      m_calls[k] += m_active[k];
      some |= m_info[k];
    }
  for (int k = 0; some != 0 && k < lane_count; k++)
    if (m_active[k] && m_info[k] != 0)
      told (k, m_info[k], t[k]);
}

// which lanes take part in what follows, and their calls of the right-hand side so far; at the end
// of many runs, or with few, half of the lanes do
void
lane_group::activate (void)
{
  m_width = lane_count / 2;
  m_failed = false;
  for (int k = 0; k < lane_count; k++)
    {
      m_active[k] = m_together || m_l[k].steps;
      m_calls[k] = 0;
      if (m_active[k] && k >= m_width)
        m_width = lane_count;
    }
}

#endif
