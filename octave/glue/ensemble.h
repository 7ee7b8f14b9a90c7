// Many runs of a scene by one plan, on all cores: parameters, starts and constant inputs differ
// from run to run.  A run is a function of its own row alone, whoever runs it and when.
#pragma once

#include "lanes.h"
#include "ensemble_rows.h"

class ensemble
{
public:

  // lanes: whether runs are in lanes where they can be
  ensemble (const simulation& s, const ensemble_rows& rows, bool lanes)
    : m_s (s), m_rows (rows), m_lanes (lanes && in_lanes (s)), m_results (rows.n, s.nt), m_next (0),
      m_done (0), m_common (rows.common ()), m_about (*S.about), m_modes (nullptr),
      m_out (S.ny > 0 ? routine ("out") : fortran { nullptr })
  {
    m_x = m_results.x.fortran_vec ();
    m_v = m_results.v.fortran_vec ();
    m_y = m_results.y.fortran_vec ();
    m_counts = m_results.counts.fortran_vec ();
    m_values = m_results.values.fortran_vec ();
    m_info = m_results.info.fortran_vec ();
    m_counted = m_results.counted.fortran_vec ();
    m_margins = m_results.margins.fortran_vec ();
    m_said = m_results.said.data ();
    m_about.nominal = rows.nominal.data ();
    if (s.plan->ip[GS_EVENTS] > 0)
      {
        const gs_events e = s.plan->events ();
        m_modes = e.given ? e.mode : nullptr;
      }
  }

  void run_all (int threads);
  const ensemble_results& results (void) const { return m_results; }
  bool in_lanes (void) const { return m_lanes; }

private:

  void work (int thread, int most);
  static bool is_over (void) { return the_patience->why () != patience::none; }
  bool over (int i);
  int constants (const known_row& row, reals& cst) const;
  bool prepare (const known_row& row, run_room& r, std::vector<int>& ip, unset_reals& rp);
  bool begins (int i, run_room& r) const;
  bool refused (int i, const gs_start& start) const;   // false
  double *counts_of (int i) const { return m_counts + std::size_t (GS_COUNTED) * i; }
  double *values_of (int i) const { return m_values + std::size_t (GS_MEASURED) * i; }
  void margins (int i, std::size_t rows, std::size_t reached, const run_room& r) const;
  void keep (int i, const run_room& r, const std::vector<int>& ip, const unset_reals& rp,
             reals& one);

#if defined (GSMBP_QUAD)
  static bool in_lanes (const simulation&) { return false; }
#else
  static bool in_lanes (const simulation& s)
  {
    return lane_group::fits (s.iopt) && ! s.audit && ! s.carries ();
  }

  // a thread's
  struct lane_rows : lane_source
  {
    ensemble& all;
    const int thread;

    lane_rows (ensemble& e, int k) : all (e), thread (k) { }
    bool next (lane_run& l) { return all.next (l, thread); }
    void done (lane_run& l) { all.done (l); }
    int over (void)
    {
      return patience::asked () && the_patience->look (0) ? the_patience->why () : patience::none;
    }
  };

  bool next (lane_run& l, int thread);
  void done (lane_run& l);

  std::unique_ptr<row_groups> m_groups;   // none: PRE is called for each run
#endif

  const simulation& m_s;
  const ensemble_rows& m_rows;
  const bool m_lanes;
  ensemble_results m_results;
  double *m_x, *m_v, *m_y, *m_counts, *m_values, *m_info, *m_counted, *m_margins;
  std::string *m_said;
  std::atomic<int> m_next, m_done;
  std::mutex m_plan;
  const reals m_common;              // the parameters of all runs
  gs_description m_about;            // the scene with the nominal magnitudes of these runs
  const int *m_modes;                // given ones of ports
  const fortran m_out;
};

// whether all is to end before run I
bool
ensemble::over (int i)
{
  if (! is_over ())
    return false;
  m_info[2 * i] = the_patience->why ();   // no calls
  values_of (i)[GS_T_REACHED] = double (m_s.t0);
  return true;
}

// the constants of a run; INFO of PRE
int
ensemble::constants (const known_row& row, reals& cst) const
{
#if ! defined (GSMBP_QUAD)
  if (row.group)
    return row.group->constants (row.place, cst);
#endif
  int info = 0;
  reals par = m_common;
  m_rows.put (row.i, par);
  routine ("pre") (&par[0], &cst[0], &info);
  return info;
}

// the margins of the devices in the first ROWS, of which those behind REACHED are as that one
void
ensemble::margins (int i, std::size_t rows, std::size_t reached, const run_room& r) const
{
  if (S.nsm == 0)
    return;
  double *passed = m_margins + std::size_t (2) * S.nsm * i;
  std::vector<int> so_far (S.nsm, 0);
  for (std::size_t k = 0; k < rows; k++)
    {
      const std::size_t at = std::min (k, reached);
      if (gs_margins_at (&m_about, m_s.tout[k], &r.xout[m_s.ldx * at], &r.vout[m_s.ldv * at],
                         &r.cst[0], so_far.data (), passed + S.nsm) < 0)
        throw std::bad_alloc ();
    }
  std::copy (so_far.begin (), so_far.end (), passed);
}

// the start of run I on its constraints; false where it cannot be taken: INFO 3, as GSSIM, a
// verdict and its message
bool
ensemble::begins (int i, run_room& r) const
{
  gs_start_given g = gs_start_given ();
  gs_start start;
  g.t = m_s.t0;
  g.cst = &r.cst[0];
  g.check = m_rows.check;
  g.modes = m_modes;
  const std::vector<double> par = m_rows.parameters (i);
  g.par = par.data ();
  return gs_take_start (&m_about, &g, &r.x0[0], &start) == GS_START_TAKEN || refused (i, start);
}

bool
ensemble::refused (int i, const gs_start& start) const
{
  m_info[2 * i] = GS_ROUTINE_FAILED;
  counts_of (i)[GS_FAILED_INFO] = start.verdict;
  counts_of (i)[GS_FAILED] = GS_BEFORE_START;
  values_of (i)[GS_T_REACHED] = double (m_s.t0);
  m_said[i] = start.text;
  return false;
}

// the room of a run; false where its parameters or its start cannot be, or all is to end
bool
ensemble::prepare (const known_row& row, run_room& r, std::vector<int>& ip, unset_reals& rp)
{
  const ensemble_rows& m = m_rows;
  const int i = row.i;
  if (over (i))
    return false;
  r = m_s;
  if (! m.table.isempty ())
    {
      m_info[2 * i + 1] = constants (row, r.cst);
      if (m_info[2 * i + 1] != 0)
        return false;
      r.breaks = m_s.breaks_of (r.cst);
    }
  for (int k = 0; k < S.nx && ! m.starts.isempty (); k++)
    r.x0[k] = m.starts(i, k);
  if (! begins (i, r))
    return false;
  if (S.nctl > 0)   // their periods are the run's own
    {
      std::lock_guard<std::mutex> guard (m_plan);
      gs_start start;
      if (! m_s.plan->due_from (m_s.t0, r.cst, start))
        return refused (i, start);
      m_s.plan->begin (ip, rp);
    }
  else
    m_s.plan->begin (ip, rp);
  for (int k = 0; k < S.nv && ! m.inputs.isempty (); k++)
    rp[ip[GS_TABLE + 3] - 1 + k] = m.inputs(i, k);
  for (int k = 0; k < S.nu && S.nq == S.nu; k++)
    r.w[k] = r.x0[k];
  return true;
}

// the rows that were reached, and the last state of a run that ended before its time; one that an
// event of the user has ended (INFO 11) stays there
void
ensemble::keep (int i, const run_room& r, const std::vector<int>& ip, const unset_reals& rp,
                reals& one)
{
  const std::size_t nt = m_s.nt, reached = r.istat[GS_N_OUTPUTS];
  const bool ended = r.info == GS_ENDED;
  const std::size_t rows = ended ? nt : std::min (nt, reached + (r.info != 0));
  double *x = m_x + S.nx * nt * i, *v = m_v + S.nv * nt * i, *y = m_y + S.ny * nt * i;
  const reals switches = S.ny > 0 ? switch_times (r.cst) : reals ();
  for (std::size_t k = 0; k < rows; k++)
    {
      const std::size_t at = std::min (k, ended ? reached : k);
      const number *state = &r.xout[m_s.ldx * at], *input = &r.vout[m_s.ldv * at];
      for (int j = 0; j < S.nx; j++)
        x[nt * j + k] = double (state[j]);
      for (int j = 0; j < S.nv; j++)
        v[nt * j + k] = double (input[j]);
      int info = 0;
      if (S.ny == 0 || (k >= reached && ! ended) || ! fine (state, S.nx) || ! fine (input, S.nv))
        continue;
      const number t = k < reached ? row_time (switches, &m_s.tout[0], int (k)) : m_s.tout[k];
      m_out (&t, state, input, &r.cst[0], &one[0], &info);
      for (int j = 0; j < S.ny && (info == 0 || info == 2); j++)
        y[nt * j + k] = double (one[j]);
    }
  margins (i, ended ? nt : std::min (nt, reached), reached, r);
  if (S.nev > 0)
    {
      m_results.events[i] = m_s.plan->events_of (ip, rp);
      m_s.plan->counted (ip, rp, m_counted + std::size_t (3) * S.nev * i);
    }
  m_info[2 * i] = r.info;
  if (r.info == GS_METHOD_FAILED)
    m_results.said[i] = &r.text[0];
  for (int j = 0; j < GS_COUNTED; j++)
    counts_of (i)[j] = r.istat[j];
  for (int j = 0; j < GS_MEASURED; j++)
    values_of (i)[j] = double (r.rstat[j]);
}

#if ! defined (GSMBP_QUAD)

bool
ensemble::next (lane_run& l, int thread)
{
  known_row row;
  do
    if (! next_row (m_groups.get (), thread, m_next, m_rows.n, row))
      return false;
  while (! prepare (row, l.r, l.ip, l.rp));
  l.i = row.i;
  return true;
}

void
ensemble::done (lane_run& l)
{
  reals one = room (S.ny);
  m_s.go_on (l.r, l.ip, l.rp.data ());
  keep (l.i, l.r, l.ip, l.rp, one);
  the_patience->reached (++m_done);
}

#endif

// one run after the other, until none is left, or in lanes, MOST of them
void
ensemble::work (int thread, int most)
{
#if ! defined (GSMBP_QUAD)
  if (m_lanes)
    {
      lane_rows mine (*this, thread);
      std::unique_ptr<lane_group> group (new lane_group (m_s, m_s.plan->ip, mine, most));
      group->run_all ();
      return;
    }
#endif
  run_room r;
  std::vector<int> ip;
  unset_reals rp;
  reals one = room (S.ny);
  for (int i = m_next++; i < m_rows.n; i = m_next++)
    if (prepare ({ i, nullptr, 0 }, r, ip, rp))
      {
        m_s.run (r, ip, rp.data ());
        keep (i, r, ip, rp, one);
        the_patience->reached (++m_done);
      }
}

void
ensemble::run_all (int threads)
{
  const int most = (m_rows.n - 1) / threads + 1;
#if ! defined (GSMBP_QUAD)
  if (m_lanes && ! m_rows.table.isempty () && emitted ("pre_w"))
    m_groups.reset (new row_groups (m_rows.varied (), m_common, threads, most, is_over));
#endif
  std::exception_ptr failed;   // no memory: Octave is told, behind all threads
  auto guarded = [&] (int k) {
    try
      {
        work (k, most);
      }
    catch (...)
      {
        std::lock_guard<std::mutex> guard (m_plan);
        failed = std::current_exception ();
        m_next = m_rows.n;
      }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < threads; k++)
    others.emplace_back (guarded, k);
  guarded (0);
  for (std::thread& t : others)
    t.join ();
  if (failed)
    std::rethrow_exception (failed);
}

// (those of "sim", number of runs, numbers of the parameters, values of all parameters, table,
// starts, inputs, usual sizes, whether starts should be closed, threads, lanes): states, inputs,
// outputs (a row for each time, a page for each run), statistics, INFO of the run and of PRE,
// seconds, whether in lanes, events, how many of each function there were and when, what methods
// said that failed (a column of runs, {} if none), which margins of devices were passed, their
// least values
static octave_value_list
do_ensemble (arguments& a, int)
{
  simulation s (a);
  ensemble_rows rows (a);
  int threads = a.integer_within ("threads", 1, 10000);
  bool lanes = a.integer_within ("lanes", 0, 1) == 1;
  if (s.input.is_function_handle () || s.carries () || s.audit)
    error ("%s.ensemble: no functions of Octave, derivatives, audits", S.name);
  auto begin = std::chrono::steady_clock::now ();
  ensemble all (s, rows, lanes);
  patience p (s.timeout, 0, rows.n, "runs");
  all.run_all (threads);
  p.settle ();
  double took = std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count ();
  const ensemble_results& r = all.results ();
  return ovl (r.x, r.v, r.y, r.counts, r.values, r.info, took, all.in_lanes (), r.all_events (),
              r.counted, r.all_said (), r.margins);
}

// (counts, values of runs as do_ensemble has them, a column each): a struct of rows
static octave_value_list
do_statistics (arguments& a, int)
{
  const Matrix counts = a.value ("counts").matrix_value ();
  return ovl (named_statistics (counts, a.value ("values").matrix_value ()));
}

// (values of all parameters, numbers of those that a table is of, the table): periods and delays of
// the sampled devices, a column for each of its rows, zeros where PRE fails
static octave_value_list
do_periods (arguments& a, int)
{
  const Matrix par = a.matrix ("par", S.npar, 1);
  const std::vector<int> which = a.integers ("parameters", -1);
  const Matrix table = a.value ("table").matrix_value ();
  Matrix periods (S.nctl, table.rows (), 0.0), delays (S.nctl, table.rows (), 0.0);
  reals p = room (S.npar), cst = room (S.ncst), period = room (S.nctl), delay = room (S.nctl);
  for (int k = 0; k < S.npar; k++)
    p[k] = decimal (par(k));
  for (octave_idx_type i = 0; i < table.rows (); i++)
    {
      int info = 0;
      for (std::size_t k = 0; k < which.size (); k++)
        p[which[k] - 1] = decimal (table(i, k));
      routine ("pre") (&p[0], &cst[0], &info);
      routine ("ctp") (&cst[0], &period[0], &delay[0]);
      for (int k = 0; k < S.nctl && info == 0; k++)
        {
          periods(k, i) = double (period[k]);
          delays(k, i) = double (delay[k]);
        }
    }
  return ovl (periods, delays);
}
