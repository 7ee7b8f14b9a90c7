// The events of the runs in lanes that have joined: what GSEVN does where a step has none, by the
// event functions of all lanes at once (EVT_W).  Where they do not say so, the run parts, and GSEVN
// looks.
#pragma once

#include "lanes_loops.h"

#if ! defined (GSMBP_QUAD)

gs_events
lane_group::events_of (lane_run& l)
{
  return gs_planned_events (m_s.nx, l.ip.data (), l.rp.data ());
}

// From when on GSUSZ may say that events of function i accumulate; a little before.
static double
accumulate_from (const gs_events& e, int i)
{
  if (! gs_is_own (&e, i))
    return 1e300;
  const double from = gs_accumulates_from (&e, i);
  return from - 1e-9 * std::fabs (from);
}

// Whether ports are held that have loops or other speeds beside them: behind each step the state is
// moved to where they are held (GSEVO).
static bool
moves_held (const gs_events& e, lane_run& l)
{
  int nh = 0;
  std::vector<int> held;
  for (int i = 0; i < e.ne && ! gs_is_own (&e, i); i++, nh++)
    if ((e.kind[i] == 1) == (e.mode[i] == 0))
      held.push_back (i);
  if (held.empty () || S.nlam > 0)
    return ! held.empty ();
  reals row = room (nh * S.nu), s = room (nh), sd = room (nh), prm = room (4 * nh);
  fortran {emitted ("hld")->sub} (&l.t, l.state (), l.inputs (), &l.r.cst[0], &row[0], &nh, &s[0],
                                  &sd[0], &prm[0]);
  return std::any_of (held.begin (), held.end (), [&] (int i) {
    int many = 0;
    for (int j = 0; j < S.nu; j++)
      many += std::fabs (row[i + nh * j]) > 0;
    return many > 1;
  });
}

// Where a function has just had its event, counts from a level of its own or waits for its sign at
// the end of a step the run looks by itself, and where it is moved behind the step.
void
lane_group::join_events (int lane)
{
  gs_events e = events_of (m_l[lane]);
  bool looks = m_events > 0 && ! moves_held (e, m_l[lane]);
  for (int i = 0; i < m_events; i++)
    {
      looks = looks && e.fresh[i] == 0 && ! (std::fabs (e.level[i]) > 0) && *e.tells != 1;
      m_g0(i, lane) = e.g[i];
      m_mark(i, lane) = e.mark[i];
      const double *told = gs_told (&e, i);
      m_noise(i, lane) = gs_is_own (&e, i)
                           ? std::max (told[GS_TOLD_RISEN], told[GS_TOLD_NOISE]) : 1e300;
      m_needs(i, lane) = ! gs_is_own (&e, i);
      m_until(i, lane) = accumulate_from (e, i);
      m_repeats(i, lane) = gs_interval (&e, i) > 0 ? gs_repeats_until (&e, i) : -1e300;
    }
  m_looks(0, lane) = looks;
  if (! looks)
    m_c(c_due, lane) = -1e300;   // every step is told to GSDTB
}

void
lane_group::part_events (int lane)
{
  if (m_c(c_moved, lane) <= 0)
    return;
  gs_events e = events_of (m_l[lane]);
  *e.since = 0;
  for (int i = 0; i < m_events; i++)
    e.g[i] = m_g0(i, lane);
}

// the event functions at the J-th point of the steps, on the polynomial of degree N
void
lane_group::events_at (int j, int n)
{
  const int many = lane_count;
  fortran {gslep_} (&m_s.nx, &j, &n, m_step.begin (), m_c.begin (), m_at.begin (), m_x.begin (),
                    m_f.begin (), m_xn.begin (), m_fn.begin (), m_z.begin (), m_stage_t.begin ());
  fortran {m_evt} (m_stage_t.begin (), m_z.begin (), m_v.begin (), m_cst.begin (), m_g.begin (),
                   m_info, &m_width, &many);
}

// Does the step of a lane go past a time until which events of a function may repeat themselves?
bool
lane_group::past_repeats (int lane)
{
  const double end = m_tn(0, lane), begin = end - m_step(0, lane), fuzz = 1e-12 * std::fabs (end);
  for (int i = 0; i < m_events; i++)
    if (begin < m_repeats(i, lane) + fuzz && end > m_repeats(i, lane) - fuzz)
      return true;
  return false;
}

// which good steps have none; the other runs part
void
lane_group::look_for_events (void)
{
  const int left = -1;
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    some = some || m_r(0, k) == 1;
  if (! some)
    return;
  for (int k = 0; k < lane_count; k++)
    m_stage_t(0, k) = m_at(0, k) < 0 ? gslft_ (&m_tn(0, k), &left) : m_tn(0, k);
  call_rates (m_xn.begin (), m_fn.begin ());
  for (int k = 0; k < lane_count; k++)
    m_loud(0, k) = m_info[k] != 0 || past_repeats (k);
  for (int j = 1; j <= 8; j++)
    {
      events_at (j, 5);
      fortran {gsleg_} (&m_events, &j, m_g.begin (), m_info, m_g0.begin (), m_mark.begin (),
                        m_noise.begin (), m_old.begin (), m_older.begin (), m_bend.begin (),
                        m_allowed.begin (), m_loud.begin ());
      if (j != 4 && j != 6)
        continue;
      events_at (j, 3);
      fortran {gsled_} (&m_events, &j, m_g.begin (), m_old.begin (), m_apart.begin ());
    }
  fortran {gslen_} (&m_events, m_apart.begin (), m_allowed.begin (), m_mark.begin (),
                    m_needs.begin (), m_until.begin (), m_tn.begin (), m_loud.begin ());
  for (int k = 0; k < lane_count; k++)
    if (m_r(0, k) == 1 && m_loud(0, k) > 0)
      m_r(0, k) = 3;
  part_failed ();
}

void
lane_group::remember_quiet (void)
{
  const int known = S.nlam == 0 && S.nq == S.nu;
  fortran {gsleu_} (&m_s.nx, &m_events, m_r.begin (), m_looks.begin (), &known, m_at.begin (),
                    m_g.begin (), m_fn.begin (), m_g0.begin (), m_f.begin (), m_c.begin ());
}

#endif
