// What a run is, for the program of a sweep, which has no Octave: its plan laid out, the numbers
// that gs_integrate takes.
#pragma once

#include "simulation.h"

static Matrix
wholes_of (const std::vector<int>& x)
{
  Matrix m (x.size (), 1);
  std::copy (x.begin (), x.end (), m.fortran_vec ());
  return m;
}

// (those of "sim"): IP, RP, IOPT, [nx; ldx; ldv; lw]
static octave_value_list
do_job (arguments& a, int)
{
  simulation s (a);
  if (s.input.is_function_handle () || s.carries () || s.audit)
    error ("%s.job: no functions of Octave, derivatives, audits", S.name);
  Matrix sizes (4, 1);
  sizes(0) = s.nx;
  sizes(1) = s.ldx;
  sizes(2) = s.ldv;
  sizes(3) = s.lw;
  return ovl (wholes_of (s.plan->ip), result (s.plan->rp, int (s.plan->rp.size ())),
              wholes_of (s.iopt), sizes);
}
