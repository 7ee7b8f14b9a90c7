// A run as gs_integrate takes it, its plan laid out: what tests/gate measures without Octave.
#pragma once

#include "run.h"
#include "host/run/run_parts.h"

// (those of a run): a struct
static octave_value_list
do_job (arguments& a, int)
{
  asked_run asked (a);
  found_run r;
  gs_whole_run w = gs_whole_run ();
  w.d = &asked.about;
  w.o = &asked.options;
  w.s = &asked.start;
  w.in = &asked.inputs;
  w.r = &r;
  const std::unique_ptr<gs_whole_run, void (*) (gs_whole_run *)> forgotten (&w, gs_forget_run);
  if (gs_prepare_run (&w))
    error ("%s.job: %s", S.name, r.text);
  octave_scalar_map m;
  Matrix sizes (4, 1);
  sizes(0) = r.nx;
  sizes(1) = r.nx;
  sizes(2) = r.ldv;
  sizes(3) = w.lw;
  m.assign ("cst", result (r.cst, S.ncst));
  m.assign ("t0", asked.begin ());
  m.assign ("x0", result (w.x0, r.nx));
  m.assign ("tbrk", result (w.breaks, w.nb));
  m.assign ("ropt", result (w.ropt, 3));
  m.assign ("atol", result (r.atol, r.nx));
  m.assign ("guess", result (w.w, S.nu));
  m.assign ("ip", result (r.ip, gs_wholes (&w.plan)));
  m.assign ("rp", result (r.rp, gs_reals (&w.plan)));
  m.assign ("iopt", result (w.iopt, GS_ON_SPEEDS + 1 + w.iopt[GS_ON_SPEEDS]));
  m.assign ("sizes", sizes);
  return ovl (m);
}
