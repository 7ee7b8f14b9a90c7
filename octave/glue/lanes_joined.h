// Runs in lanes that have joined: what they remember from step to step is in columns, in vectors
// with that of the others.  They part where a step is none of the usual ones.
#pragma once

#include "lanes_fill.h"

#if ! defined (GSMBP_QUAD)

// places in m_c, those of GSLNA less 1
enum
{
  c_t, c_next, c_longest, c_stop, c_due, c_least, c_most, c_good, c_others, c_limit, c_bound,
  c_free, c_calls, c_fresh, c_behind, c_side, c_last, c_near, c_far, c_then, c_moved, c_stiff,
  c_pivot, c_largest, c_drift, c_projected = 28, c_smallest, c_smallest_at, c_projections, c_past,
  c_turn, c_known
};
// and of GSLNP, where they are others
enum { c_from = 1, c_step, c_number = 4, c_count, c_look = 16 };

void
lane_group::join (int lane)
{
  lane_run& l = m_l[lane];
  l.joined = l.busy && l.partition ()[0] <= 0 && closes (l)
             && (m_iopt[GS_METHOD] != 4 || l.ip[GS_EVENTS] == 0);
  m_runs(0, lane) = l.joined;
  if (! l.joined)
    return;
  m_c(c_t, lane) = l.t;
  m_c(c_stop, lane) = l.stp[0];
  m_c(c_side, lane) = l.istp[0];
  m_c(c_limit, lane) = m_iopt[GS_MOST_STEPS] > 0 ? m_iopt[GS_MOST_STEPS] : 1e300;
  m_c(c_calls, lane) = l.r.istat[GS_N_RHS];
  m_c(c_good, lane) = l.r.istat[GS_N_STEPS];
  m_c(c_moved, lane) = 0;
  m_c(c_pivot, lane) = m_c(c_largest, lane) = 0;
  if (S.nlam > 0)
    join_loops (lane);
  if (m_iopt[GS_METHOD] == 4)
    join_4 (lane);
  else
    join_8 (lane);
}

void
lane_group::join_8 (int lane)
{
  const lane_run& l = m_l[lane];
  const std::vector<int>& n = l.r.istat;
  m_c(c_next, lane) = l.m[0];
  m_c(c_longest, lane) = l.hmax;
  m_c(c_due, lane) = m_tim[l.istp[1]];
  m_c(c_least, lane) = l.r.rstat[GS_H_LEAST];
  m_c(c_most, lane) = l.r.rstat[GS_H_LARGEST];
  m_c(c_others, lane) = n[2];
  m_c(c_bound, lane) = n[15];
  m_c(c_free, lane) = n[16];
  m_c(c_fresh, lane) = l.lm[0];
  m_c(c_behind, lane) = l.lm[1];
  m_c(c_last, lane) = l.m[1];
  m_c(c_near, lane) = l.m[2];
  m_c(c_far, lane) = l.m[3];
  m_c(c_then, lane) = l.r.rstat[GS_H_NEXT];
  m_c(c_stiff, lane) = n[13];
  if (l.ip[GS_EVENTS] > 0)
    join_events (lane);
}

// after how many steps GSSTD is to look at a run
static double
next_look (const lane_run& l)
{
  return l.r.istat[GS_IS_STIFF] == 0 ? l.r.istat[GS_N_DIVERGED] : 1e300;
}

void
lane_group::join_4 (int lane)
{
  const lane_run& l = m_l[lane];
  m_c(c_from, lane) = l.ta;
  m_c(c_step, lane) = l.h;
  m_c(c_number, lane) = l.k;
  m_c(c_count, lane) = l.n;
  m_c(c_look, lane) = next_look (l);
}

void
lane_group::part (int lane)
{
  lane_run& l = m_l[lane];
  if (! l.joined)
    return;
  l.joined = false;
  m_runs(0, lane) = 0;
  std::vector<int>& n = l.r.istat;
  m_x.get (lane, l.state (), m_s.nx);
  l.t = m_c(c_t, lane);
  if (l.ier == 0)   // else that of the step that has failed
    l.h = m_step(0, lane);
  l.tn = m_tn(0, lane);
  l.at = int (m_at(0, lane));
  n[0] = int (m_c(c_calls, lane));
  n[1] = int (m_c(c_good, lane));
  if (m_c(c_moved, lane) > 0)
    {
      l.r.rstat[GS_T_REACHED] = l.t;
      if (l.ier == 0)   // else they tell what has just failed
        n[5] = n[6] = 0;
    }
  if (S.nlam > 0)
    part_loops (lane);
  if (m_iopt[GS_METHOD] == 4)
    part_4 (lane);
  else
    part_8 (lane);
}

void
lane_group::part_8 (int lane)
{
  lane_run& l = m_l[lane];
  std::vector<int>& n = l.r.istat;
  l.m[0] = m_c(c_next, lane);
  l.m[1] = m_c(c_last, lane);
  l.m[2] = m_c(c_near, lane);
  l.m[3] = m_c(c_far, lane);
  l.r.rstat[GS_H_LEAST] = m_c(c_least, lane);
  l.r.rstat[GS_H_LARGEST] = m_c(c_most, lane);
  l.r.rstat[GS_H_NEXT] = m_c(c_then, lane);
  l.lm[0] = int (m_c(c_fresh, lane));
  l.lm[1] = int (m_c(c_behind, lane));
  l.lm[3] = 0;
  if (m_c(c_moved, lane) > 0)
    l.lm[2] = l.lm[5] = 0;
  n[2] = int (m_c(c_others, lane));
  n[15] = int (m_c(c_bound, lane));
  n[16] = int (m_c(c_free, lane));
  if (m_events > 0)
    part_events (lane);
}

void
lane_group::part_4 (int lane)
{
  lane_run& l = m_l[lane];
  l.k = int (m_c(c_number, lane));
  l.h = m_c(c_step, lane);
}

// is a number of one of the lanes beyond a limit?
static bool
some_above (const lane_array& a, double limit)
{
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    some |= a(0, k) > limit;
  return some;
}

static bool
some_below (const lane_array& a, double limit)
{
  bool some = false;
  for (int k = 0; k < lane_count; k++)
    some |= a(0, k) < limit;
  return some;
}

void
lane_group::part_where (const lane_array& is)
{
  if (! m_failed && ! some_above (is, 0))
    return;
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].joined && (m_l[k].ier != 0 || is(0, k) > 0))
      part (k);
}

// the runs whose step has failed: by themselves it is told why
void
lane_group::part_failed (void)
{
  if (! m_failed && ! some_above (m_r, 2))
    return;
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].joined && (m_l[k].ier != 0 || m_r(0, k) > 2))
      {
        part (k);
        m_r(0, k) = 0;
      }
}

// at a stop, the run parted: on from there, or its end
bool
lane_group::keep_on (int lane)
{
  lane_run& l = m_l[lane];
  if (stopped (l))
    next_state (lane);
  else
    end (lane, l.r.info);
  return l.busy;
}

#endif
