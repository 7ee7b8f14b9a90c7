// A run by gs_run of the engine (host/run), or its beginning: a struct of Octave in (asked_run.h),
// one out.
#pragma once

#include "asked_run.h"
#include "handles.h"

// a result of the engine, empty at first
struct found_run : gs_run_result
{
  found_run (void) : gs_run_result () { }
  ~found_run (void) { gs_free_result (this); }
  found_run (const found_run&) = delete;

  // N of the columns of an array
  static Matrix columns_of (const number *from, int ld, int rows, int n)
  {
    Matrix m (rows, n);
    for (int k = 0; k < n; k++)
      std::transform (from + std::size_t (ld) * k, from + std::size_t (ld) * k + rows,
                      m.fortran_vec () + std::size_t (rows) * k,
                      [] (number x) { return double (x); });
    return m;
  }

  Matrix states (int n) const { return columns_of (x, nx, nx, n); }
  Matrix inputs (int n) const { return columns_of (v, ldv, S.nv, n); }
};

// why a run was refused, or warned of, and its start
static octave_scalar_map
told (const found_run& r)
{
  static const char *const words[]
      = { "", "option", "routine", "start", "mode", "samples", "columns" };
  octave_scalar_map m, start;
  // what the run itself needs is told as by its handle
  const bool lacks = r.refused == GS_REFUSED_ROUTINE && std::strncmp (r.text, "the run", 7) == 0;
  const std::string option = r.refused ? r.option : "";
  start.assign ("residual", r.start.residual);
  start.assign ("row", r.start.row);
  start.assign ("moved", r.start.moved);
  start.assign ("verdict", r.start.verdict);
  start.assign ("state", r.start.state + 1);
  m.assign ("refused", r.refused == GS_REFUSED_ROUTINE && ! lacks ? "need" : words[r.refused]);
  m.assign ("option", option == "vin" ? "input" : option);
  m.assign ("text", lacks ? why_absent (r.option) : std::string (r.text));
  m.assign ("warning", r.warning);
  m.assign ("start", start);
  return m;
}

// of runs, a column each, by the names of their rows
static octave_scalar_map
named_statistics (const Matrix& counts, const Matrix& values)
{
  octave_scalar_map all;
#define GS_NAMED_COUNT(k, name) all.assign (#name, octave_value (counts.row (k)));
#define GS_NAMED_VALUE(k, name) all.assign (#name, octave_value (values.row (k)));
  GS_COUNTS (GS_NAMED_COUNT)
  GS_VALUES (GS_NAMED_VALUE)
  return all;
}

// the record of the samples, the memory at the end; the record of the events, a column for each:
// time, number, mode after, states before, states after; how many there were of both
static void
put_records (octave_scalar_map& m, const found_run& r)
{
  if (S.nctl > 0)
    {
      const gs_samples a = gs_planned_samples (S.run, r.ip, r.rp);
      const int rows = 1 + S.nxk + S.nv;
      m.assign ("memory", found_run::columns_of (a.memory, S.nxk, S.nxk, 1));
      m.assign ("samples", found_run::columns_of (a.record, rows, rows,
                                                  std::min (a.ns, *a.count)));
      m.assign ("instants", *a.count);
    }
  if (S.nev > 0)
    {
      const gs_events a = gs_planned_events (r.nx, r.ip, r.rp);
      const int rows = 3 + 2 * r.nx;
      m.assign ("events", found_run::columns_of (a.record, rows, rows,
                                                 std::min (a.nr, *a.count)));
      m.assign ("happened", *a.count);
    }
}

// N columns of ROWS numbers
static Matrix
matrix_of (const double *from, int rows, int n)
{
  Matrix m (rows, n);
  std::copy_n (from, m.numel (), m.fortran_vec ());
  return m;
}

// of each column of derivatives why it was given up, in words, too, at which event and when;
// derivatives of inputs and outputs, a column for each row; of the times of the events
static void
put_derivatives (octave_scalar_map& m, const found_run& r, int columns)
{
  const gs_derivatives *d = r.derivatives;
  Matrix lost (columns, 3);
  Cell why (columns, 1);
  const double *moved = nullptr;
  for (int k = 0; k < columns; k++)
    {
      int event = 0;
      lost(k, 0) = gs_derivatives_lost (d, k, &event, &lost(k, 2));
      lost(k, 1) = event;
      why(k) = gs_derivatives_why (int (lost(k, 0)));
    }
  const int n = gs_derivatives_of_events (d, &moved);
  m.assign ("lost", lost);
  m.assign ("why", why);
  m.assign ("moved", matrix_of (moved, columns, n));
  m.assign ("dv", matrix_of (r.dv, S.nv * columns, r.rows));
  m.assign ("dy", matrix_of (r.dy, S.ny * columns, r.rows));
}

static void
put_results (octave_scalar_map& m, const found_run& r)
{
  Matrix counts (GS_COUNTED, 1);
  std::copy_n (r.istat, int (GS_COUNTED), counts.fortran_vec ());
  m.assign ("info", r.info);
  m.assign ("method", r.method);
  m.assign ("ended", r.ended);
  m.assign ("loop_method", r.loop_method);
  m.assign ("rtol", r.rtol);
  m.assign ("atol", result (r.atol, r.nx));
  m.assign ("t", result (r.times, r.rows));
  // after the rows of a run that failed its last state
  const int n = std::min (r.nt, r.rows + (r.info != 0));
  m.assign ("x", r.states (n));
  m.assign ("v", r.inputs (n));
  m.assign ("y", found_run::columns_of (r.y, S.ny, S.ny, r.rows));
  m.assign ("rows", r.rows);
  m.assign ("stats", named_statistics (counts, result (r.rstat, GS_MEASURED)));
  put_records (m, r);
}

// (constants, a struct): a struct of what a run has found (gs_run_result), or why it was refused
static octave_value_list
do_run (arguments& a, int)
{
  asked_run asked (a);
  found_run r;
  const auto begin = std::chrono::steady_clock::now ();
  {
    patience p (asked.timeout, asked.begin (), asked.end (), "s");
    gs_run (&asked.about, &asked.options, &asked.start, &asked.inputs, &r);
    if (r.info != 0 && p.why () != patience::none)
      r.info = p.why ();
    p.settle ();
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  asked.settle ();
  octave_scalar_map m = told (r);
  if (! r.refused)
    put_results (m, r);
  if (! r.refused && r.derivatives)
    put_derivatives (m, r, asked.options.ncolumns);
  m.assign ("seconds", took.count ());
  return ovl (m);
}

// (those of a run): the same up to the first step: x with the columns of derivatives, tolerances
static octave_value_list
do_prepare (arguments& a, int)
{
  asked_run asked (a);
  found_run r;
  gs_run_prepare (&asked.about, &asked.options, &asked.start, &asked.inputs, &r);
  asked.settle ();
  octave_scalar_map m = told (r);
  if (! r.refused)
    {
      m.assign ("x", r.states (1));
      m.assign ("rtol", r.rtol);
      m.assign ("atol", result (r.atol, r.nx));
    }
  return ovl (m);
}
