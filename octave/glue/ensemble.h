// Many runs of a scene by one plan (host/ensemble): what Octave hands over, and what comes back.
#pragma once

#include "host/ensemble/ensemble.h"
#include "parameters.h"
#include "simulation.h"

#include <numeric>

// what differs from run to run, a row for each; no rows: as in the run of the beginning
struct ensemble_rows
{
  int n;
  std::vector<int> which;            // the parameters that a column stands for
  Matrix nominal;
  int check;                         // should starts be closed, or are they moved from anywhere?
  reals common, table, starts, inputs;   // the parameters of all runs; columns of the others

  ensemble_rows (arguments& a)
    : n (a.integer_within ("runs", 1, 2000000000)), which (a.integers ("parameters", -1))
  {
    common = parameter_values (a.matrix ("par", S.npar, 1), 0);
    table = columns_of (a, int (which.size ()), "table", decimal);
    starts = columns_of (a, S.nx, "starts", plain);
    inputs = columns_of (a, S.nv, "inputs", plain);
    nominal = a.matrix ("nominal", S.nx, 1);
    check = a.integer_within ("check", 0, 1);
  }

  gs_rows rows (void) const
  {
    return { n, &common[0], int (which.size ()), which.data (), columns (table), columns (starts),
             columns (inputs), nullptr };
  }

private:

  static number plain (double x) { return x; }

  gs_table columns (const reals& all) const
  {
    return { all.empty () ? nullptr : all.data (), 1, n };
  }

  reals columns_of (arguments& a, int many, const char *name, number (*as) (double)) const
  {
    const Matrix m = a.value (name).matrix_value ();
    if (! m.isempty () && (m.rows () != n || m.columns () != many))
      error ("%s: argument %s: expected %d x %d, found %s", a.who ().c_str (), name, n, many,
             m.dims ().str ().c_str ());
    reals x (m.numel ());
    std::transform (m.data (), m.data () + m.numel (), x.begin (), as);
    return x;
  }
};

// what comes back, a column or a page for each run
struct ensemble_results
{
  const int n;
  NDArray x, v, y;
  Matrix counts, values, info, counted, margins;
  std::vector<char *> said;      // of refused starts, by implicit methods that failed
  std::vector<double *> events;  // of each run time, number, mode after it, one by one
  std::vector<int> many;
  gs_results all;

  ensemble_results (int runs, int nt)
    : n (runs), x (dim_vector (nt, S.nx, n), no_number), v (dim_vector (nt, S.nv, n), no_number),
      y (dim_vector (nt, S.ny, n), no_number), counts (GS_COUNTED, n, 0.0),
      values (GS_MEASURED, n, 0.0), info (2, n, 0.0), counted (3 * S.nev, n, 0.0),
      margins (2 * S.nsm, n, 0.0), said (n), events (n), many (n)
  {
    for (int i = 0; i < n; i++)
      for (int k = 0; k < S.nsm; k++)
        margins(S.nsm + k, i) = HUGE_VAL;
    all = { x.fortran_vec (), v.fortran_vec (), y.fortran_vec (), counts.fortran_vec (),
            values.fortran_vec (), info.fortran_vec (), counted.fortran_vec (),
            margins.fortran_vec (), events.data (), many.data (), said.data (), 0 };
  }
  ~ensemble_results (void)
  {
    std::for_each (said.begin (), said.end (), std::free);
    std::for_each (events.begin (), events.end (), std::free);
  }
  ensemble_results (const ensemble_results&) = delete;

  // a column of texts, {} if there is none
  Cell all_said (void) const
  {
    if (std::none_of (said.begin (), said.end (), [] (const char *s) { return s; }))
      return Cell ();
    Cell texts (n, 1);
    for (int i = 0; i < n; i++)
      texts(i) = said[i] ? said[i] : "";
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

// the run S as all runs of an ensemble have it; its arrays are those of S
static gs_ensemble
ensemble_of (simulation& s, const gs_description& about, const gs_lane_routines& lanes,
             const ensemble_rows& rows)
{
  gs_ensemble e = gs_ensemble ();
  e.scene = S.run;
  e.about = &about;
  e.pre = gsmbp_constants;
  e.lanes = &lanes;
  e.npar = S.npar;
  e.ncst = S.ncst;
  e.fortran_inputs = 1;
  e.run = s.run ();
  e.run.nb = s.nb;   // the breaks of the inputs alone
  e.run.tbrk = &s.tbrk[0];
  e.wholes = s.plan->ip.size ();
  e.reals = s.plan->rp.size ();
  e.guess = &s.w[0];
  e.check = rows.check;
  return e;
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
  ensemble_rows given (a);
  const int threads = a.integer_within ("threads", 1, 10000);
  const bool wanted = a.integer_within ("lanes", 0, 1) == 1;
  if (s.input.is_function_handle () || s.carries () || s.audit)
    error ("%s.ensemble: no functions of Octave, derivatives, audits", S.name);
  gs_lane_routines lanes = gs_lane_routines ();
  if (wanted)
    gsmbp_lanes (&lanes);
  gs_description about = *S.about;
  about.nominal = given.nominal.data ();
  gs_ensemble e = ensemble_of (s, about, lanes, given);
#if ! defined (GSMBP_QUAD)
  const gs_implicit options = { s.implicit[0], s.implicit[1], 0, 0, int (s.implicit.size ()) - 2,
                                s.implicit.data () + 2, nullptr, 0 };
  e.method = s.implicit_method;
  e.implicit = &options;
#endif
  const gs_rows rows = given.rows ();
  ensemble_results r (rows.n, s.nt);
  const auto begin = std::chrono::steady_clock::now ();
  patience p (s.timeout, 0, rows.n, "runs");
  const int failed = gs_run_ensemble (&e, &rows, threads, gs_keep_member, &r.all, gsmbp_runs_done);
  p.settle ();
  if (failed || r.all.no_memory)
    throw std::bad_alloc ();
  const double took = std::chrono::duration<double> (std::chrono::steady_clock::now () - begin)
                        .count ();
  return ovl (r.x, r.v, r.y, r.counts, r.values, r.info, took, gs_ensemble_in_lanes (&e) == 1,
              r.all_events (), r.counted, r.all_said (), r.margins);
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
