// What a run is, for the program of a sweep, which has no Octave: its plan laid out, the numbers
// that GSSIM takes, which of the emitted subroutines it calls.
#pragma once

#include "simulation.h"

static Matrix
wholes_of (const std::vector<int>& x)
{
  Matrix m (x.size (), 1);
  std::copy (x.begin (), x.end (), m.fortran_vec ());
  return m;
}

// (those of "sim"): IP, RP, IOPT, [nx; ldx; ldv; lw], and for each subroutine in the order of
// GSSIM's arguments whether it is called
static octave_value_list
do_job (arguments& a, int)
{
  simulation s (a);
  if (s.input.is_function_handle () || s.carries () || s.audit)
    error ("%s.job: no functions of Octave, derivatives, audits", S.name);
  const gsmbp_sub subs[] = { s.rhs, s.prj, s.con, s.kin, s.cmd, s.clo, s.vin, s.out, s.ctl, s.evt,
                             s.rst };
  const std::size_t n = sizeof subs / sizeof subs[0];
  Matrix called (n, 1), sizes (4, 1);
  for (std::size_t i = 0; i < n; i++)
    called(i) = subs[i] != gsmbp_absent;
  sizes(0) = s.nx;
  sizes(1) = s.ldx;
  sizes(2) = s.ldv;
  sizes(3) = s.lw;
  return ovl (wholes_of (s.plan->ip), result (s.plan->rp, int (s.plan->rp.size ())),
              wholes_of (s.iopt), sizes, called);
}
