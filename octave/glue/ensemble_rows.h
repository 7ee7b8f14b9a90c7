// What differs from run to run of an ensemble, and what comes back.
#pragma once

#include "parameters.h"
#include "row_groups.h"
#include "simulation.h"

// what differs, a row for each run; no rows: as in the run of the beginning
struct ensemble_rows
{
  int n;
  std::vector<int> which;            // the parameters that a column stands for
  Matrix par, table, starts, inputs, nominal;
  int check;                         // should starts be closed, or are they moved from anywhere?

  ensemble_rows (arguments& a)
    : n (a.integer_within ("runs", 1, 2000000000)), which (a.integers ("parameters", -1)),
      par (a.matrix ("par", S.npar, 1)), table (a.value ("table").matrix_value ()),
      starts (a.value ("starts").matrix_value ()), inputs (a.value ("inputs").matrix_value ()),
      nominal (a.matrix ("nominal", S.nx, 1)), check (a.integer_within ("check", 0, 1))
  {
    fits (table, int (which.size ()), "table");
    fits (starts, S.nx, "starts");
    fits (inputs, S.nv, "inputs");
  }

  varied_rows varied (void) const { return { n, which, table.data (), 1, n }; }

  // the parameters of all runs, and of one
  reals common (void) const
  {
    reals p = room (S.npar);
    routine ("par") (&p[0]);
    for (int k = 0; k < S.npar; k++)
      if (double (p[k]) != par(k))
        p[k] = decimal (par(k));
    return p;
  }
  // the parameters of run I, for messages
  std::vector<double> parameters (int i) const
  {
    std::vector<double> p (par.data (), par.data () + S.npar);
    for (std::size_t k = 0; k < which.size () && ! table.isempty (); k++)
      p[which[k] - 1] = table(i, k);
    return p;
  }
  void put (int i, reals& p) const
  {
    for (std::size_t k = 0; k < which.size (); k++)
      p[which[k] - 1] = decimal (table(i, k));
  }

private:

  void fits (const Matrix& m, int columns, const char *name) const
  {
    if (! m.isempty () && (m.rows () != n || m.columns () != columns))
      error ("%s.ensemble: %s: expected %d x %d", S.name, name, n, columns);
  }
};

// what comes back, a column or a page for each run
struct ensemble_results
{
  NDArray x, v, y;
  Matrix counts, values, info, counted;   // COUNTED: as run_plan has it
  Matrix margins;   // of devices, as gs_margins_at has it: which were passed, then the least values
  std::vector<std::string> said;             // of refused starts, by implicit methods that failed
  std::vector<std::vector<double>> events;   // of each run time, number, mode after it, one by one

  ensemble_results (int n, int nt)
    : x (dim_vector (nt, S.nx, n), no_number), v (dim_vector (nt, S.nv, n), no_number),
      y (dim_vector (nt, S.ny, n), no_number), counts (GS_COUNTED, n, 0.0),
      values (GS_MEASURED, n, 0.0), info (2, n, 0.0), counted (3 * S.nev, n, 0.0),
      margins (2 * S.nsm, n, 0.0), said (n), events (S.nev > 0 ? n : 0)
  {
    for (int i = 0; i < n; i++)
      for (int k = 0; k < S.nsm; k++)
        margins(S.nsm + k, i) = HUGE_VAL;
  }

  Cell all_said (void) const
  {
    if (std::all_of (said.begin (), said.end (), [] (const std::string& s) { return s.empty (); }))
      return Cell ();
    Cell all (said.size (), 1);
    for (std::size_t i = 0; i < said.size (); i++)
      all(i) = said[i];
    return all;
  }

  // a column for each event: run, time, number, mode after it
  Matrix all_events (void) const
  {
    std::size_t many = 0;
    for (const std::vector<double>& one : events)
      many += one.size () / 3;
    Matrix list (4, many);
    double *to = list.fortran_vec ();
    for (std::size_t i = 0; i < events.size (); i++)
      for (std::size_t k = 0; k < events[i].size (); k++)
        {
          if (k % 3 == 0)
            *to++ = double (i + 1);
          *to++ = events[i][k];
        }
    return list;
  }
};
