// Many runs of a scene in lanes: the right-hand sides of sixteen runs at once by RHS_W, each with
// parameters, inputs, time and a step of its own.  What a run does between them are the routines of
// GSSIM, for each lane by itself, so that a run is that of GSSIM; one that has ended makes room for
// the next.
#pragma once

#include "run_room.h"

#include "gsmbp/plan.h"

#if ! defined (GSMBP_QUAD)

extern "C"
{
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
  void gslnh_ (void);
  void gslni_ (void);
  void gslep_ (void);
  void gsleg_ (void);
  void gsled_ (void);
  void gslen_ (void);
  void gsleu_ (void);
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
  unset_reals rp;
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
  virtual int over (void) = 0;                     // INFO of runs that end from outside; 0: go on
};

class lane_group
{
public:

  // ip: the plan of a run; most: no more lanes than that have runs
  lane_group (const run_setting& s, const std::vector<int>& ip, lane_source& source, int most);

  void run_all (void);

  // whether runs with these options can be in lanes
  static bool fits (const std::vector<int>& iopt)
  {
    return emitted ("rhs_w") && iopt[GS_METHOD] != 0
           && (S.nlam == 0 || iopt[GS_LOOPS] <= 2);   // else it would be the right side of one run
  }

  // how many event functions are looked at in lanes; 0: each run looks by itself
  static int looks_at (const run_setting& s, const std::vector<int>& ip)
  {
    if (s.iopt[GS_METHOD] == 4 || ip[GS_EVENTS] == 0 || ip[GS_V0] != 0 || ip[GS_FEEDBACK] != 0)
      return 0;
    return emitted ("evt_w") ? ip[ip[GS_EVENTS] - 1] : 0;
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
  void part_failed (void);
  bool keep_on (int lane);

  // the events of those that have joined
  gs_events events_of (lane_run& l);
  void join_events (int lane);
  void part_events (int lane);
  void events_at (int j, int n);
  bool past_repeats (int lane);
  void look_for_events (void);
  void remember_quiet (void);

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
  bool close_by (int lane) const;
  bool passage (int lane, double from, double to);
  double search (int lane, double from, double to, double& at);
  double *sizes (void) { return &m_p(14 + 3 * S.nq, 0); }
  void park (int lane, int known = 0);
  void rest (int lane);
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
  void begin_eigenvalues (double *change, double *size);
  void eigenvalues (const bool *due, double *rho, int *state);
  void stages_4 (void);
  void by_itself_4 (int lane);
  void after_4 (int lane);

  const run_setting& m_s;
  lane_source& m_source;
  const int m_most;
  gsmbp_sub m_rhs;
  int m_siz[8], m_numbers;           // m_siz, m_tim: without the breaks of a run
  int m_width;                       // lanes of which right-hand sides are computed
  bool m_failed;                     // an IER may not be 0
  bool m_together;                   // rk4: all lanes have joined and take part
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
  // and of their events, see GSLEG
  gsmbp_sub m_evt;
  int m_events;
  lane_array m_looks, m_g, m_g0, m_old, m_older, m_mark, m_noise, m_bend, m_allowed, m_apart;
  lane_array m_needs, m_until, m_repeats;
  lane_array m_fn, m_z, m_loud;
  // and of their loops
  gsmbp_sub m_con, m_prj;
  lane_array m_p, m_q, m_phi, m_rate, m_hc, m_hn, m_dq, m_du, m_long, m_y, m_w;
  lane_array m_res, m_gap, m_left, m_live, m_rank, m_least, m_turn, m_way, m_margin, m_tau;
};

#endif
