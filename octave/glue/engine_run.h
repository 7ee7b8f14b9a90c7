// A run by the run time in C (share/engine/core).
#pragma once

#include "run_parts.h"
#include "run_room.h"
#include "gsmbp/integrate.h"
#include "host/fortran_scene.h"

// inputs by a function of Octave in the place of those of the scene
GS_FORTRAN_vin (gs_octave_vin, gsmbp_call_input)

// before a step: INFO where the run is to end, else 0
extern "C" int
gsmbp_patience (void *, number t)
{
  return patience::asked () && the_patience->look (double (t)) ? the_patience->why () : 0;
}

// as the run time takes it; its statistics are those of R
static gs_integration
engine_run (const run_setting& s, run_room& r, int *ip, number *rp)
{
  gs_integration run = gs_integration ();
  run.nx = s.nx;
  run.t0 = s.t0;
  run.x0 = &r.x0[0];
  run.nt = s.nt;
  run.tout = &s.tout[0];
  run.nb = int (r.breaks.size ());
  run.tbrk = r.breaks.data ();
  run.iopt = &s.iopt[0];
  run.ropt = &s.ropt[0];
  run.atol = &s.atol[0];
  run.ip = ip;
  run.rp = rp;
  run.cst = s.carried ? s.carried : &r.cst[0];
  run.xout = &r.xout[0];
  run.ldx = s.ldx;
  run.vout = &r.vout[0];
  run.ldv = s.ldv;
  run.w = &r.w[0];
  run.lw = s.lw;
  run.ask = gsmbp_patience;
  std::copy_n (r.istat.begin (), int (GS_COUNTED), run.istat);
  std::copy_n (r.rstat.begin (), int (GS_MEASURED), run.rstat);
  return run;
}

// INTEGRATE (scene, run): its INFO
template <typename integrator>
static int
run_engine (const run_setting& s, run_room& r, int *ip, number *rp, integrator integrate)
{
  gs_fortran_inputs of_vin = { ip, rp, &r.cst[0] };
  gs_scene scene = s.scene;
  if (! s.carried)
    scene.data = &of_vin;
  gs_integration run = engine_run (s, r, ip, rp);
  const int info = integrate (&scene, &run);
  std::copy_n (run.istat, int (GS_COUNTED), r.istat.begin ());
  std::copy_n (run.rstat, int (GS_MEASURED), r.rstat.begin ());
  return info;
}

#if ! defined (GSMBP_QUAD)
// by an implicit method; INFO
static int
run_implicit (const run_setting& s, run_room& r, int *ip, number *rp, gs_implicit_method *by,
              const gs_implicit& options)
{
  return run_engine (s, r, ip, rp, [&] (gs_scene *scene, gs_integration *run) {
    scene->nsw = S.nsw;   // at these breaks its rates may jump
    return by (scene, run, &options);
  });
}
#endif
