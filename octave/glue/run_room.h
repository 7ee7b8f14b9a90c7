// A run by gs_integrate: what all runs of a plan have in common, and the room of one.
#pragma once

#include "fortran.h"

// What one run writes, and what may differ from run to run
struct run_room
{
  reals cst, x0, breaks;    // breaks: of the inputs, and times at which the scene switches
  reals xout, vout, rstat, w;
  std::vector<int> istat;
  int info;
  std::vector<char> text;   // what an implicit method said when it failed
};

// The arguments of gs_integrate by their names, as far as they are those of all runs
struct run_setting
{
  number t0;
  int nx;
  reals tout;
  int nt;
  std::vector<int> iopt;
  reals ropt, atol;
  gsmbp_sub rhs, prj, con, kin, cmd, clo, vin, out, ctl, evt, rst;
  int ldx, ldv, lw;
  gs_scene scene;   // the routines for the run time in C
  const number *carried = nullptr;   // constants of a run that carries derivatives
};
