// States from a guess (host/assemble/assemble.h), for gsmbp_assemble.
#pragma once

#include "starts.h"
#include "host/assemble/assemble.h"

// (those of asked_start, which coordinates are held, how many more guesses, by how much they change
// lengths, tolerance, whether filters settle, how many constraints are independent in general,
// limits of the coordinates, where the scene starts): states by columns, none: they are refused;
// why, held coordinates beyond their limits, where constraints have lost rank
static octave_value_list
do_assemble (arguments& a, int)
{
  const asked_start s (a);
  gs_assembly_asked asked = gs_assembly_asked ();
  asked.t = s.t;
  asked.cst = &s.cst[0];
  const std::vector<int> held = a.integers ("held", S.nq);
  asked.held = held.data ();
  asked.branches = a.integer_within ("branches", 0, 1000000);
  asked.longest = a.value ("longest").double_value ();
  asked.tolerance = a.value ("tolerance").double_value ();
  asked.settle = a.integer_within ("settle", 0, 1);
  asked.rank = a.integer_within ("rank", 0, S.nlam);
  const Matrix limits = a.value ("limits").matrix_value ();
  asked.limits = limits.data ();
  const reals start = a.vector ("start", S.nx);
  reals x = s.x;
  x.resize (std::size_t (S.nx) * (1 + asked.branches) + 1);
  const std::unique_ptr<gs_assembly> found (new gs_assembly);
  if (gs_assemble (&s.about, &asked, &start[0], &x[0], found.get ()))
    throw std::bad_alloc ();
  return ovl (result (x, S.nx, found->n), found->text, found->beyond, found->lost);
}

// (those of asked_start, how many constraints are independent in general, where the scene starts):
// how they depend on each other in the state, "" where they do not; 1 for those whose multipliers
// no motion determines there
static octave_value_list
do_lost_rank (arguments& a, int)
{
  const asked_start s (a);
  const int rank = a.integer_within ("rank", 0, S.nlam);
  const reals start = a.vector ("start", S.nx);
  char text[1000];
  std::vector<int> loose (S.nlam + 1);
  if (gs_lost_rank (&s.about, s.t, &s.cst[0], rank, &start[0], &s.x[0], loose.data (), text,
                    sizeof text) < 0)
    throw std::bad_alloc ();
  Matrix list (1, S.nlam);
  std::copy_n (loose.data (), S.nlam, list.fortran_vec ());
  return ovl (text, list);
}
