// What a run is, for the program of a sweep, which has no Octave: its plan laid out, the numbers
// that gs_integrate takes.
#pragma once

#include "ensemble.h"
#include "host/run/run_parts.h"

// (those of a run, numbers of the parameters that differ, table): a struct of the records of a job
static octave_value_list
do_job (arguments& a, int)
{
  asked_run asked (a);
  const varied_parameters varied (a);
  const gs_rows rows = varied.rows ();
  found_run r;
  gs_whole_run w = gs_whole_run ();
  w.d = &asked.about;
  w.o = &asked.options;
  w.s = &asked.start;
  w.in = &asked.inputs;
  w.r = &r;
  w.pending = gs_most_pending (w.d, w.s->par, &rows);
  const std::unique_ptr<gs_whole_run, void (*) (gs_whole_run *)> forgotten (&w, gs_forget_run);
  if (asked.calls_octave () || asked.options.ncolumns > 0 || asked.options.audit > 0)
    error ("%s.job: no functions of Octave, derivatives, audits", S.name);
  if (gs_prepare_run (&w))
    error ("%s.job: %s", S.name, r.text);
  const gs_implicit implicit = gs_prepared_implicit (&w);
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
  m.assign ("order", implicit.order);
  m.assign ("index2", implicit.index2);
  m.assign ("follows", result (implicit.follows, implicit.followed));
  m.assign ("ip", result (r.ip, gs_wholes (&w.plan)));
  m.assign ("rp", result (r.rp, gs_reals (&w.plan)));
  m.assign ("iopt", result (w.iopt, GS_ON_SPEEDS + 1 + w.iopt[GS_ON_SPEEDS]));
  m.assign ("sizes", sizes);
  return ovl (m);
}
