// Many runs of a scene by one plan (host/ensemble): what Octave hands over, and what comes back.
#pragma once

#include "host/ensemble/run_rows.h"
#include "run.h"

#include <numeric>

// the parameters that differ from run to run, a row of the table for each
struct varied_parameters
{
  std::vector<int> which;   // those that a column stands for
  reals table;
  int n;                    // runs, 0: no table

  varied_parameters (arguments& a) : which (a.integers ("parameters", -1))
  {
    const Matrix m = a.value ("table").matrix_value ();
    n = int (m.rows ());
    if (! m.isempty () && m.columns () != octave_idx_type (which.size ()))
      error ("%s: argument table: expected %d columns, found %d", a.who ().c_str (),
             int (which.size ()), int (m.columns ()));
    table.assign (m.data (), m.data () + m.numel ());
  }

  gs_rows rows (void) const
  {
    gs_rows r = gs_rows ();
    r.n = n;
    r.varied = table.empty () ? 0 : int (which.size ());
    r.which = which.data ();
    r.table = { table.empty () ? nullptr : table.data (), 1, n };
    return r;
  }
};

// ... and starts and inputs; no rows: as in the run of the beginning; why runs are not begun
struct ensemble_rows
{
  int n;
  varied_parameters varied;
  reals starts, inputs;
  std::vector<std::string> texts;
  std::vector<const char *> broken;

  ensemble_rows (arguments& a)
    : n (a.integer_within ("runs", 1, 2000000000)), varied (a),
      starts (columns_of (a, S.nx, "starts")), inputs (columns_of (a, S.nv, "inputs"))
  {
    if (varied.n > 0 && varied.n != n)
      error ("%s: argument table: expected %d rows, found %d", a.who ().c_str (), n, varied.n);
    read_broken (a.value ("broken").cell_value ());
  }

  gs_rows rows (void) const
  {
    gs_rows r = varied.rows ();
    r.n = n;
    r.starts = { starts.empty () ? nullptr : starts.data (), 1, n };
    r.inputs = { inputs.empty () ? nullptr : inputs.data (), 1, n };
    r.broken = broken.empty () ? nullptr : broken.data ();
    return r;
  }

private:

  // a text for each run, "": none; {}: no run has one
  void read_broken (const Cell& given)
  {
    if (given.numel () != 0 && given.numel () != n)
      error ("%s.ensemble: argument broken: expected %d texts, found %d", S.name, n,
             int (given.numel ()));
    for (octave_idx_type i = 0; i < given.numel (); i++)
      texts.push_back (given(i).string_value ());
    for (const std::string& text : texts)
      broken.push_back (text.empty () ? nullptr : text.c_str ());
  }

  reals columns_of (arguments& a, int many, const char *name) const
  {
    const Matrix m = a.value (name).matrix_value ();
    if (! m.isempty () && (m.rows () != n || m.columns () != many))
      error ("%s: argument %s: expected %d x %d, found %s", a.who ().c_str (), name, n, many,
             m.dims ().str ().c_str ());
    return reals (m.data (), m.data () + m.numel ());
  }
};

// what comes back, a column or a page for each run
struct ensemble_results
{
  const int n;
  NDArray x, v, y;
  Matrix counts, values, info, counted, margins;
  std::vector<char *> reason;    // why runs failed
  std::vector<double *> events;  // of each run time, number, mode after it, one by one
  std::vector<int> many;
  gs_results all;

  ensemble_results (int runs, int nt)
    : n (runs), x (dim_vector (nt, S.nx, n), no_number), v (dim_vector (nt, S.nv, n), no_number),
      y (dim_vector (nt, S.ny, n), no_number), counts (GS_COUNTED, n, 0.0),
      values (GS_MEASURED, n, 0.0), info (2, n, 0.0), counted (3 * S.nev, n, 0.0),
      margins (2 * S.nsm, n, 0.0), reason (n), events (n), many (n)
  {
    for (int i = 0; i < n; i++)
      for (int k = 0; k < S.nsm; k++)
        margins(S.nsm + k, i) = HUGE_VAL;
    all = { x.fortran_vec (), v.fortran_vec (), y.fortran_vec (), counts.fortran_vec (),
            values.fortran_vec (), info.fortran_vec (), counted.fortran_vec (),
            margins.fortran_vec (), events.data (), many.data (), reason.data (), 0 };
  }
  ~ensemble_results (void)
  {
    std::for_each (reason.begin (), reason.end (), std::free);
    std::for_each (events.begin (), events.end (), std::free);
  }
  ensemble_results (const ensemble_results&) = delete;

  Cell reasons (void) const
  {
    Cell texts (n, 1, octave_value (""));
    for (int i = 0; i < n; i++)
      if (reason[i])
        texts(i) = reason[i];
    return texts;
  }

  // a column for each event: run, time, number, mode after it
  Matrix all_events (void) const
  {
    Matrix list (4, std::accumulate (many.begin (), many.end (), 0));
    double *to = list.fortran_vec ();
    for (int i = 0; i < n; i++)
      for (int k = 0; k < many[i]; k++, to += 4)
        {
          to[0] = i + 1;
          std::copy_n (events[i] + 3 * k, 3, to + 1);
        }
    return list;
  }
};

extern "C" void
gsmbp_runs_done (void *, int done)
{
  the_patience->reached (done);
}

// (those of a run, number of runs, numbers of the parameters, table, starts, inputs, why runs are
// not begun, threads, lanes): states, inputs, outputs (a row for each time, a page for each run),
// statistics, INFO of the run and of PRE, seconds, whether in lanes, events, how many of each
// function there were and when, why runs failed (a column, "" of those that did not), which margins
// of devices were passed, their least values
static octave_value_list
do_ensemble (arguments& a, int)
{
  asked_run asked (a);
  const ensemble_rows given (a);
  const int threads = a.integer_within ("threads", 1, 10000);
  gs_lane_routines lanes = gs_lane_routines ();
  if (a.integer_within ("lanes", 0, 1) == 1)
    gsmbp_lanes (&lanes);
  asked.about.lanes = &lanes;
  if (asked.calls_octave () || asked.options.ncolumns > 0 || asked.options.audit > 0)
    error ("%s.ensemble: no functions of Octave, derivatives, audits", S.name);
  const gs_rows rows = given.rows ();
  ensemble_results r (rows.n, asked.start.nt);
  found_run found;
  const auto begin = std::chrono::steady_clock::now ();
  patience p (asked.timeout, 0, rows.n, "runs");
  gs_run_rows (&asked.about, &asked.options, &asked.start, &asked.inputs, &rows, threads, &r.all,
               gsmbp_runs_done, &found);
  p.settle ();
  if (found.refused)
    error ("%s.ensemble: %s", S.name, found.text);
  if (found.info == GS_OUT_OF_MEMORY)
    throw std::bad_alloc ();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  return ovl (r.x, r.v, r.y, r.counts, r.values, r.info, took.count (), found.in_lanes == 1,
              r.all_events (), r.counted, r.reasons (), r.margins);
}

// (counts, values of runs as do_ensemble has them, a column each): a struct of rows
static octave_value_list
do_statistics (arguments& a, int)
{
  const Matrix counts = a.value ("counts").matrix_value ();
  return ovl (named_statistics (counts, a.value ("values").matrix_value ()));
}
