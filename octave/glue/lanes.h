// Many runs of a scene in lanes: the right-hand sides of sixteen runs at once by RHS_W, each with
// parameters, inputs, time and a step of its own.  What a run does between them are the routines of
// GSSIM, for each lane by itself, so that a run is that of GSSIM; one that has ended makes room for
// the next.
#pragma once

#include "simulation.h"

#if ! defined (GSMBP_QUAD)

extern "C"
{
  double gslft_ (const double *t, const int *side);
  void gsarg_ (void);
  void gsini_ (void);
  void gsbgn_ (void);
  void gssto_ (void);
  void gsste_ (void);
  void gsstd_ (void);
  void gspss_ (void);
  void gsdta_ (void);
  void gsdtb_ (void);
  void gsrkl_ (void);
  void gsrkt_ (void);
  void gsrkq_ (void);
  void gsrk4_ (void);
  void gslnc_ (void);
  void gslns_ (void);
  void gslnt_ (void);
  void gslne_ (void);
  void gslnk_ (void);
  void gslna_ (void);
  void gslnj_ (void);
  void gslnu_ (void);
  void gslnp_ (void);
  void gslnr_ (void);
  void gslnq_ (void);
  void gslln_ (void);
  void gsllj_ (void);
  void gsllv_ (void);
  void gsllt_ (void);
  void gsllc_ (void);
  void gsllu_ (void);
  void gslla_ (void);
  void gsllx_ (void);
  void gsln4_ (void);
}

const int lane_count = 16;

// N numbers for each lane, a lane's K-th at [K * lane_count + lane], at a multiple of 64 bytes
class lane_array
{
public:

  explicit lane_array (int n) : m_room (std::size_t (std::max (1, n)) * lane_count + 8, 0.0)
  {
    std::size_t off = reinterpret_cast<std::uintptr_t> (m_room.data ()) % 64 / sizeof (double);
    m_begin = m_room.data () + (8 - off) % 8;
  }
  lane_array (const lane_array&) = delete;

  double *begin (void) { return m_begin; }
  double& operator () (int k, int lane) { return m_begin[k * lane_count + lane]; }
  double operator () (int k, int lane) const { return m_begin[k * lane_count + lane]; }

  void put (int lane, const double *from, int n)
  {
    for (int k = 0; k < n; k++)
      m_begin[k * lane_count + lane] = from[k];
  }

  void get (int lane, double *to, int n) const
  {
    for (int k = 0; k < n; k++)
      to[k] = m_begin[k * lane_count + lane];
  }

private:

  std::vector<double> m_room;
  double *m_begin;
};

// what GSSIM, GSDPS, GSDPT and GSRKS keep of one run
struct lane_run
{
  run_room r;
  std::vector<int> ip;
  reals rp;
  int i;                             // its number
  int siz[8];                        // SIZ and TIM of GSSIM, with breaks of its own
  std::vector<double> tim;
  bool busy, steps, alone, started;  // it has a run; which takes part in this step, or by itself;
                                     // it has had one
  bool joined;                       // what it remembers is in the columns of the group
  double t, hmax, stp[3], m[11], tn, h, ta, hr;
  int istp[3], lm[6], iw[7], at, k, n, ier;

  double *w (int place) { return &r.w[iw[place] - 1]; }
  double *state (void) { return w (0); }
  double *next (void) { return w (1); }
  double *inputs (void) { return w (2); }
  double *partition (void) { return w (3); }
  double *stages (void) { return w (4); }
};

// who has runs and takes their results
struct lane_source
{
  virtual ~lane_source (void) { }
  virtual bool next (lane_run& l) = 0;             // false: there is none any more
  virtual void done (lane_run& l) = 0;
};

class lane_group
{
public:

  // most: no more lanes than that have runs
  lane_group (const simulation& s, lane_source& source, int most);

  void run_all (void);

  // whether runs of this simulation can be in lanes
  static bool fits (const simulation& s)
  {
    return emitted ("rhs_w") && s.iopt[0] != 0 && ! s.audit && ! s.carries ()
           && (S.nlam == 0 || s.iopt[1] <= 2);   // else it would be the right side of one run
  }

private:

  void fill (int lane);
  bool begin (lane_run& l);
  bool to_next_stop (lane_run& l);
  bool stopped (lane_run& l);
  void finish (lane_run& l);
  void end (int lane, int info);
  void next_state (int lane);
  void inputs_of (int lane, double t, int side, const double *x);
  void activate (void);
  void told (int lane, int info, double t);
  void call_rates (const double *x, double *xd);
  void stage_rates (double *xd, const double *t, double *x, bool last);
  void join (int lane);
  void part (int lane);
  void join_8 (int lane);
  void part_8 (int lane);
  void join_4 (int lane);
  void part_4 (int lane);
  void part_where (const lane_array& is);
  bool keep_on (int lane);

  // the loops of those that have joined
  bool closes (const lane_run& l) const;
  void join_loops (int lane);
  void part_loops (int lane);
  void jacobians (const double *t, const double *q, lane_array& hc);
  void know_jacobians (void);
  void project (void);
  void onto_constraints (void);
  void watch_loops (void);
  void look_ahead (void);
  bool far_ahead (const double *h);
  void look_along (void);
  bool passage (int lane, double from, double to);
  double search (int lane, double from, double to, double& at);
  double *sizes (void) { return &m_p(14 + 3 * S.nq, 0); }
  void park (int lane);
  void take_numbers (int lane);
  bool any (void) const;
  bool left (void);

  void step_8 (void);
  void rates_8 (void);
  bool begun_8 (void);
  void rates_by_itself (int lane);
  bool found_8 (int lane);
  bool ready_8 (int lane);
  void in_lanes_8 (void);
  void judge_all_8 (void);
  void stages_8 (void);
  void by_itself_8 (int lane);
  void after_8 (int lane);
  void judge_8 (int lane, double err);

  void step_4 (void);
  void begin_way (lane_run& l);
  bool ready_4 (int lane);
  bool begun_4 (void);
  void judge_all_4 (void);
  void watch_4 (void);
  void watch_alone (int lane);
  void eigenvalues (const bool *due, double *rho, int *state);
  void stages_4 (void);
  void by_itself_4 (int lane);
  void after_4 (int lane);

  const simulation& m_s;
  lane_source& m_source;
  const int m_most;
  gsmbp_sub m_rhs;
  int m_siz[8], m_numbers;           // m_siz, m_tim: without the breaks of a run
  int m_info[lane_count], m_active[lane_count], m_calls[lane_count];
  std::vector<int> m_iopt;
  std::vector<double> m_tim, m_ropt;
  bool m_of_time;                    // inputs that are no constants
  lane_run m_l[lane_count];
  std::vector<int> m_n, m_j;         // of GSLNC
  std::vector<double> m_c8, m_ts;
  lane_array m_x, m_xs, m_xn, m_f, m_h, m_v, m_cst, m_cst_1;
  lane_array m_new, m_stage_t, m_step, m_err, m_a, m_b;
  // of the runs that have joined, see GSLNA and GSLNP
  lane_array m_c, m_runs, m_slow, m_fresh, m_limit, m_tn, m_at, m_r;
  // and of their loops
  gsmbp_sub m_con, m_prj;
  lane_array m_p, m_q, m_phi, m_rate, m_hc, m_hn, m_dq, m_du, m_long, m_y, m_w;
  lane_array m_res, m_gap, m_left, m_live, m_rank, m_least, m_turn, m_margin, m_tau;
};

lane_group::lane_group (const simulation& s, lane_source& source, int most)
  : m_s (s), m_source (source), m_most (std::min (most, lane_count)),
    m_rhs (emitted ("rhs_w")->sub), m_siz {S.nq, S.nu, s.nx, S.nv, S.nlam, s.nt, 0, s.lw},
    m_numbers (lane_count * s.nx),
    m_iopt (s.iopt), m_tim (1, s.t0), m_ropt (s.ropt), m_n (12), m_j (144), m_c8 (144), m_ts (12),
    m_x (s.nx), m_xs (s.nx), m_xn (s.nx), m_f (12 * s.nx), m_h (s.nx), m_v (S.nv), m_cst (S.ncst),
    m_cst_1 (S.nlam > 0 ? S.ncst : 0),
    m_new (s.nx), m_stage_t (1), m_step (1), m_err (1), m_a (1), m_b (1), m_c (40), m_runs (1),
    m_slow (1), m_fresh (1), m_limit (1), m_tn (1), m_at (1), m_r (1), m_con (nullptr),
    m_prj (nullptr), m_p (24 + 18 * S.nq + 7 * S.nlam + 2 * S.nlam * S.nq), m_q (S.nq),
    m_phi (S.nlam), m_rate (S.nlam), m_hc (S.nlam * S.nq), m_hn (S.nlam * S.nq), m_dq (S.nq),
    m_du (S.nq), m_long (S.nlam), m_y (S.nlam * S.nq), m_w (S.nlam + 8), m_res (1), m_gap (1),
    m_left (1), m_live (1), m_rank (1), m_least (1), m_turn (1), m_margin (1), m_tau (1)
{
  if (S.nlam > 0 && emitted ("prj_w") && emitted ("con_w"))
    {
      m_prj = emitted ("prj_w")->sub;
      m_con = emitted ("con_w")->sub;
    }
  std::fill_n (m_limit.begin (), lane_count, 1e300);
  m_tim.insert (m_tim.end (), s.tout.begin (), s.tout.begin () + s.nt);
  m_ropt.insert (m_ropt.end (), s.atol.begin (), s.atol.end ());
  m_of_time = s.plan->ip[GS_V0] != 0 || s.plan->ip[GS_FEEDBACK] != 0;
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
    if (m_iopt[0] == 4)
      step_4 ();
    else
      step_8 ();
}

// were all runs ended from outside?  Then those of the lanes are where they stand.
bool
lane_group::left (void)
{
  if (! patience::asked () || ! the_patience->look (0))
    return false;
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].busy)
      {
        part (k);
        end (k, the_patience->why ());
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

// zero rates and steps: its state stays
void
lane_group::park (int lane)
{
  for (int k = 0; k < m_s.nx; k++)
    m_h(k, lane) = 0;
  for (int k = 0; k < 12 * m_s.nx; k++)
    m_f(k, lane) = 0;
  m_step(0, lane) = 0;
  m_active[lane] = 0;
}

// the beginning of GSSIM; false where the run has ended
bool
lane_group::begin (lane_run& l)
{
  const simulation& s = m_s;
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
  const simulation& s = m_s;
  run_room& r = l.r;
  int acted = 0;
  r.rstat[7] = l.t;
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
  if (m_iopt[0] == 4)
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
  const simulation& s = m_s;
  run_room& r = l.r;
  int ier = 0;
  fortran {gsinp_} (s.cmd, s.clo, s.vin, &l.t, &l.istp[0], l.state (), &m_siz[1], &m_siz[2],
                    &m_siz[3], l.ip.data (), l.rp.data (), &r.cst[0], l.inputs (), &r.w[0], &ier);
  if (ier == 0)
    return to_next_stop (l);
  r.info = 3;
  r.istat[5] = ier;
  r.istat[6] = 1;
  return false;
}

// the run is over: where it came to if that is not its end
void
lane_group::finish (lane_run& l)
{
  run_room& r = l.r;
  if (r.info >= 0 && r.istat[4] < m_s.nt)
    {
      std::copy_n (l.state (), m_s.nx, &r.xout[std::size_t (m_s.nx) * r.istat[4]]);
      std::copy_n (l.inputs (), S.nv, &r.vout[std::size_t (S.nv) * r.istat[4]]);
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
  const simulation& s = m_s;
  lane_run& l = m_l[lane];
  int info = 0;
  fortran {gsinp_} (s.cmd, s.clo, s.vin, &t, &side, x, &m_siz[1], &m_siz[2], &m_siz[3],
                    l.ip.data (), l.rp.data (), &l.r.cst[0], l.inputs (), &l.r.w[0], &info);
  if (info != 0)
    {
      l.ier = info;
      l.r.istat[5] = info;
      l.r.istat[6] = 1;
      park (lane);
      return;
    }
  m_v.put (lane, l.inputs (), S.nv);
}

void
lane_group::call_rates (const double *x, double *xd)
{
  const int k = lane_count;
  fortran {m_rhs} (m_stage_t.begin (), x, m_v.begin (), m_cst.begin (), xd, m_info, &k, &k);
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
      istat[5] = info;
      istat[6] = 2;
      park (lane);
    }
}

// the right-hand sides of all lanes at the states X of a stage; those that take part are told.
// last: at the end of the step
void
lane_group::stage_rates (double *xd, const double *t, double *x, bool last)
{
  const int nx = m_s.nx;
  for (int k = 0; k < lane_count; k++)
    m_stage_t(0, k) = last ? gslft_ (&t[k], &m_l[k].at) : t[k];
  for (int k = 0; m_of_time && k < lane_count; k++)
    if (m_active[k])
      {
        double one[nx];
        for (int j = 0; j < nx; j++)
          one[j] = x[j * lane_count + k];
        inputs_of (k, t[k], last ? m_l[k].at : 1, one);
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

// which lanes take part in what follows, and their calls of the right-hand side so far
void
lane_group::activate (void)
{
  for (int k = 0; k < lane_count; k++)
    {
      m_active[k] = m_l[k].steps;
      m_calls[k] = 0;
    }
}

// ----- Runs that have joined: what they remember from step to step is in columns, in vectors with
// that of the others.  They part where a step is none of the usual ones.

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
             && (m_iopt[0] != 4 || l.ip[GS_EVENTS] == 0);
  m_runs(0, lane) = l.joined;
  if (! l.joined)
    return;
  m_c(c_t, lane) = l.t;
  m_c(c_stop, lane) = l.stp[0];
  m_c(c_side, lane) = l.istp[0];
  m_c(c_limit, lane) = m_iopt[3] > 0 ? m_iopt[3] : 1e300;
  m_c(c_calls, lane) = l.r.istat[0];
  m_c(c_good, lane) = l.r.istat[1];
  m_c(c_moved, lane) = 0;
  m_c(c_pivot, lane) = m_c(c_largest, lane) = 0;
  if (S.nlam > 0)
    join_loops (lane);
  if (m_iopt[0] == 4)
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
  m_c(c_due, lane) = l.ip[GS_EVENTS] > 0 ? -1e300 : m_tim[l.istp[1]];
  m_c(c_least, lane) = l.r.rstat[5];
  m_c(c_most, lane) = l.r.rstat[6];
  m_c(c_others, lane) = n[2];
  m_c(c_bound, lane) = n[15];
  m_c(c_free, lane) = n[16];
  m_c(c_fresh, lane) = l.lm[0];
  m_c(c_behind, lane) = l.lm[1];
  m_c(c_last, lane) = l.m[1];
  m_c(c_near, lane) = l.m[2];
  m_c(c_far, lane) = l.m[3];
  m_c(c_then, lane) = l.r.rstat[8];
  m_c(c_stiff, lane) = n[13];
}

void
lane_group::join_4 (int lane)
{
  const lane_run& l = m_l[lane];
  m_c(c_from, lane) = l.ta;
  m_c(c_step, lane) = l.h;
  m_c(c_number, lane) = l.k;
  m_c(c_count, lane) = l.n;
  m_c(c_look, lane) = l.r.istat[13] == 0 ? l.r.istat[17] : 1e300;
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
  l.h = m_step(0, lane);
  l.tn = m_tn(0, lane);
  l.at = int (m_at(0, lane));
  n[0] = int (m_c(c_calls, lane));
  n[1] = int (m_c(c_good, lane));
  if (m_c(c_moved, lane) > 0)
    {
      l.r.rstat[7] = l.t;
      if (l.ier == 0)   // else they tell what has just failed
        n[5] = n[6] = 0;
    }
  if (S.nlam > 0)
    part_loops (lane);
  if (m_iopt[0] == 4)
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
  l.r.rstat[5] = m_c(c_least, lane);
  l.r.rstat[6] = m_c(c_most, lane);
  l.r.rstat[8] = m_c(c_then, lane);
  l.lm[0] = int (m_c(c_fresh, lane));
  l.lm[1] = int (m_c(c_behind, lane));
  l.lm[3] = 0;
  if (m_c(c_moved, lane) > 0)
    l.lm[2] = l.lm[5] = 0;
  n[2] = int (m_c(c_others, lane));
  n[15] = int (m_c(c_bound, lane));
  n[16] = int (m_c(c_free, lane));
}

void
lane_group::part_4 (int lane)
{
  lane_run& l = m_l[lane];
  l.k = int (m_c(c_number, lane));
  l.h = m_c(c_step, lane);
}

void
lane_group::part_where (const lane_array& is)
{
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].joined && (m_l[k].ier != 0 || is(0, k) > 0))
      part (k);
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

// ----- The loops of those that have joined

// whether what GSPSS and GSCHK do for the run is done in vectors
bool
lane_group::closes (const lane_run& l) const
{
  if (S.nlam == 0)
    return S.nq == S.nu;
  const int way = m_iopt[1];
  return m_prj && way == 2 && m_iopt[4] == (m_iopt[2] == 1)
         && l.lm[5] <= 0 && l.lm[2] == 0 && (m_iopt[0] == 4 || m_ropt[1] >= l.m[5]);
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
  m_c(c_smallest, lane) = rstat[13];
  m_c(c_smallest_at, lane) = rstat[14];
  m_c(c_projections, lane) = l.r.istat[3];
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
  rstat[13] = m_c(c_smallest, lane);
  rstat[14] = m_c(c_smallest_at, lane);
  l.r.istat[3] = int (m_c(c_projections, lane));
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
  if (m_iopt[4] == 1)
    know_jacobians ();
  std::copy_n (m_xn.begin (), m_numbers, m_new.begin ());
  onto_constraints ();
  if (m_iopt[4] == 1)
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
  if (m_iopt[4] != 1)
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
  if (m_iopt[0] != 4)
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
    m_margin(0, k) = m_iopt[0] == 4 ? 0.01 : m_tn(0, k) < m_c(c_stop, k) ? m_l[k].m[6] : 0;
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
        m_c(c_turn, k) = m_turn(0, k);
        m_limit(0, k) = std::min (h[k], m_turn(0, k));
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
      bool close = m_c(c_pivot, k) < 0.3 * m_c(c_largest, k);
      from[k] = close ? 0 : -1;
      pivot[0][k] = m_c(c_pivot, k);
      last = std::max (last, m_live(0, k) <= 0 ? 0 : close ? places : 9);
    }
  for (int i = 0; i < last; i++)
    {
      for (int k = 0; k < lane_count; k++)
        {
          double part = from[k] < 0 ? 0.125 * (i + 1) : -0.6 + 1.6 / 12 * i;
          m_tau(0, k) = m_live(0, k) > 0 ? part * m_turn(0, k) : 0;
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
  double middle = t + at * turn, d = 0.8 * turn, full = m_l[lane].m[9] * d;
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
          double tau = place[k] * m_turn(0, lane);
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

// ----- Dormand and Prince

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
  const int many = m_iopt[0] == 9 ? 100 : 500;
  fortran {gslnk_} (&m_s.nx, m_fresh.begin (), m_new.begin (), m_f.begin (),
                    m_x.begin (), m_xs.begin (), &m_ropt[1], &m_ropt[3], &many, m_c.begin (),
                    m_slow.begin ());
  part_where (m_slow);
  if (m_prj && m_iopt[4] == 1)
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
      if (l.joined)
        l.at = int (m_at(0, k));
      else if (l.busy && found_8 (k) && ready_8 (k))
        {
          l.steps = true;
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
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].joined && (m_l[k].ier != 0 || m_r(0, k) > 2))
      {
        part (k);
        m_r(0, k) = 0;
      }
  if (m_prj)
    project ();
  fortran {gslnu_} (&m_s.nx, m_r.begin (), m_step.begin (), m_tn.begin (),
                    m_err.begin (), m_c.begin (), m_x.begin (), m_xn.begin ());
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
  const simulation& s = m_s;
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
  const simulation& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  if (l.lm[0] == 0)
    return true;
  l.lm[0] = 0;
  double *f = l.stages (), *v = l.inputs ();
  int info = l.ier != 0 ? 3 : 0;
  m_f.get (lane, f, s.nx);
  r.istat[0] += m_calls[lane];
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
      if (r.istat[13] > 0 && m_iopt[0] == 9)
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
  const simulation& s = m_s;
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
          r.istat[5] = 3;
          r.istat[6] = 8;
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
  l.r.istat[0] += m_calls[lane];
  if (l.ip[GS_EVENTS] > 0 || m_tim[l.istp[1]] < l.tn)
    {
      for (int k = 0; k < 12; k++)
        for (int j = 0; j < m_s.nx; j++)
          l.stages ()[m_s.nx * k + j] = m_f(m_s.nx * k + j, lane);
      m_xs.get (lane, l.stages () + 12 * m_s.nx, m_s.nx);
    }
  judge_8 (lane, l.ier == 0 ? m_err(0, lane) : 0);
}

// a step whose stages are completed from independent coordinates (GSPRT)
void
lane_group::by_itself_8 (int lane)
{
  const simulation& s = m_s;
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
  const simulation& s = m_s;
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

// ----- Runge and Kutta

void
lane_group::begin_way (lane_run& l)
{
  l.k = 1;
  fortran {gsrkl_} (&l.ta, &l.stp[0], &l.hr, &l.n, &l.h, &l.r.rstat[0]);
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
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].alone)
      by_itself_4 (k);
}

bool
lane_group::begun_4 (void)
{
  for (int k = 0; k < lane_count; k++)
    {
      lane_run& l = m_l[k];
      l.ier = 0;
      if (! l.joined)
        join (k);
      m_c(c_t, k) = l.joined ? m_c(c_t, k) : m_s.t0;
      m_slow(0, k) = l.joined && m_c(c_good, k) >= m_c(c_look, k);
    }
  part_where (m_slow);
  fortran {gslnp_} (&m_s.nx, m_runs.begin (), m_c.begin (), m_step.begin (),
                    m_h.begin (), m_tn.begin (), m_at.begin (), m_slow.begin ());
  part_where (m_slow);
  bool some = false, apart = false;
  for (int k = 0; k < lane_count; k++)
    {
      lane_run& l = m_l[k];
      l.alone = ! l.joined && l.busy && ready_4 (k) && l.partition ()[0] > 0;
      l.steps = l.busy && ! l.alone;
      some = some || l.steps;
      apart = apart || ! l.joined;
      if (l.joined)
        l.at = int (m_at(0, k));
    }
  if (apart)
    watch_4 ();
  return some;
}

void
lane_group::judge_all_4 (void)
{
  fortran {gslnr_} (&m_s.nx, m_runs.begin (), m_xn.begin (), m_r.begin ());
  for (int k = 0; k < lane_count; k++)
    if (m_l[k].joined && (m_l[k].ier != 0 || m_r(0, k) > 2))
      {
        part (k);
        m_r(0, k) = 0;
      }
  if (m_prj)
    project ();
  fortran {gslnq_} (&m_s.nx, m_r.begin (), m_tn.begin (), m_c.begin (), m_x.begin (),
                    m_xn.begin ());
  for (int k = 0; k < lane_count; k++)
    if (! m_l[k].joined && m_l[k].steps)
      {
        m_xn.get (k, m_l[k].next (), m_s.nx);
        m_l[k].r.istat[0] += m_calls[k];
        after_4 (k);
      }
    else if (m_l[k].joined && m_c(c_number, k) > m_c(c_count, k))
      {
        part (k);
        m_l[k].t = m_l[k].stp[0];
        keep_on (k);
      }
}

bool
lane_group::ready_4 (int lane)
{
  const simulation& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  fortran {gsrkt_} (&l.ta, &l.stp[0], &l.istp[0], &l.h, &l.k, &l.n, &l.t, &l.tn, &l.at);
  if (m_iopt[3] > 0 && r.istat[1] >= m_iopt[3])
    {
      end (lane, 1);
      return m_l[lane].busy && ready_4 (lane);
    }
  m_step(0, lane) = l.h;
  m_c(c_t, lane) = l.t;
  m_tn(0, lane) = l.tn;
  for (int k = 0; k < s.nx; k++)
    m_h(k, lane) = l.h;
  return true;
}

// GSSTD ahead of a step, for the runs where a look is due
void
lane_group::watch_4 (void)
{
  bool due[lane_count], some = false;
  for (int k = 0; k < lane_count; k++)
    {
      const std::vector<int>& istat = m_l[k].r.istat;
      due[k] = m_l[k].busy && ! m_l[k].joined && istat[13] == 0 && istat[1] >= istat[17];
      if (due[k] && (m_l[k].alone || m_of_time))
        {
          watch_alone (k);
          due[k] = false;
        }
      some = some || due[k];
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
        r.istat[17] = r.istat[1] + std::min (1000, std::max (10, 9 * r.istat[1]));
        if (rho[k] * std::fabs (m_l[k].h) <= 2.78)
          continue;
        r.istat[13] = 1;
        r.istat[14] = state[k];
        r.rstat[17] = m_l[k].t;
        r.rstat[18] = rho[k];
        r.rstat[19] = std::fabs (m_l[k].h);
      }
}

void
lane_group::watch_alone (int lane)
{
  const simulation& s = m_s;
  lane_run& l = m_l[lane];
  run_room& r = l.r;
  const double none = 0;
  fortran {gsste_} (s.rhs, s.con, s.kin, s.cmd, s.clo, s.vin, &m_iopt[0], &l.t, &l.h, l.state (),
                    &m_siz[0], &m_siz[1], &m_siz[2], &m_siz[3], &m_siz[4], l.ip.data (),
                    l.rp.data (), &r.cst[0], l.inputs (), &m_ropt[1], &m_ropt[3], &none, &none,
                    l.stages () + s.nx, &r.w[0], l.partition (), &r.istat[0], &r.rstat[0]);
}

// GSSTF for all lanes that are due
void
lane_group::eigenvalues (const bool *due, double *rho, int *state)
{
  const int nx = m_s.nx;
  const double d = std::sqrt (DBL_EPSILON), rtol = m_ropt[1];
  double old[lane_count] = { }, sum[lane_count] = { };
  int equal[lane_count] = { };
  bool goes[lane_count];
  double *base = m_f.begin (), *change = base + m_numbers, *size = change + m_numbers;
  for (int k = 0; k < lane_count; k++)
    {
      goes[k] = due[k];
      rho[k] = 0;
      state[k] = 1;
      m_stage_t(0, k) = m_c(c_t, k);
      for (int j = 0, i = k; j < nx; j++, i += lane_count)
        {
          const double x = std::fabs (m_x.begin ()[i]);
          size[i] = rtol > 0 ? x + m_ropt[3 + j] / rtol : x + 1;
          size[i] = size[i] > 0 ? size[i] : 1;
          change[i] = size[i] * (0.5 + std::fmod (0.618 * (j + 1), 1.0));
        }
    }
  call_rates (m_x.begin (), base);
  for (int k = 0; k < lane_count; k++)
    {
      if (due[k])
        m_l[k].r.istat[12]++;
      goes[k] = goes[k] && (m_info[k] == 0 || m_info[k] == 2 || m_info[k] == 3);
    }
  for (int turn = 1; turn <= 32 && std::any_of (goes, goes + lane_count, [] (bool g) { return g; });
       turn++)
    {
      for (int k = 0; k < lane_count; k++)
        {
          double s = 0;
          for (int j = k; j < m_numbers; j += lane_count)
            s = std::max (s, std::fabs (change[j]) / size[j]);
          goes[k] = goes[k] && s > 0 && s <= 1e300;
          s = goes[k] ? d / s : 0;
          for (int j = k; j < m_numbers; j += lane_count)
            m_xs.begin ()[j] = goes[k] ? m_x.begin ()[j] + s * change[j] : m_x.begin ()[j];
        }
      call_rates (m_xs.begin (), change);
      for (int k = 0; k < lane_count; k++)
        {
          if (! goes[k])
            continue;
          m_l[k].r.istat[12]++;
          double growth = 0;
          for (int j = 0, i = k; j < nx; j++, i += lane_count)
            {
              change[i] -= base[i];
              if (std::fabs (change[i]) / size[i] > growth)
                {
                  growth = std::fabs (change[i]) / size[i];
                  state[k] = j + 1;
                }
            }
          growth /= d;
          goes[k] = growth > 0 && (m_info[k] == 0 || m_info[k] == 2 || m_info[k] == 3);
          if (! goes[k])
            continue;
          equal[k] = std::fabs (growth - old[k]) > 0.02 * growth ? 0 : equal[k] + 1;
          old[k] = growth;
          sum[k] += turn > 8 ? std::log (growth) : 0;
          if (equal[k] == 3 || turn == 32)
            {
              rho[k] = equal[k] == 3 ? growth : std::exp (sum[k] / 24);
              goes[k] = false;
            }
        }
    }
}

void
lane_group::stages_4 (void)
{
  double t[lane_count], *x = m_x.begin ();
  std::copy_n (m_c.begin (), lane_count, t);
  activate ();
  for (int stage = 1; stage <= 4; stage++)
    {
      for (int k = 0; k < lane_count && stage > 1; k++)
        t[k] = stage == 4 ? m_tn(0, k) : m_c(c_t, k) + 0.5 * m_step(0, k);
      stage_rates (m_f.begin () + (stage > 1 ? m_numbers : 0), t, x, stage == 4);
      x = stage == 4 ? m_xn.begin () : m_xs.begin ();
      fortran {gsln4_} (&stage, &m_numbers, m_h.begin (), m_x.begin (), m_f.begin (), x);
    }
}

void
lane_group::by_itself_4 (int lane)
{
  const simulation& s = m_s;
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
  const simulation& s = m_s;
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
