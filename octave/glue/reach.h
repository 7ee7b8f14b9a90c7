// Solutions of inverse kinematics (host/reach/reach.h), for gsmbp_reach.
#pragma once

#include "arguments.h"
#include "numbers.h"
#include "host/reach/reach.h"

// (solutions, the coordinates before, which may turn, their limits, branches of the solutions, the
// wanted one): the solution that is taken, its number, 0: none
static octave_value_list
do_choose (arguments& a, int)
{
  Matrix q = a.matrix ("solutions", S.nq, -1);
  const Matrix before = a.matrix ("before", S.nq, 1);
  const std::vector<int> turns = a.integers ("turns", S.nq);
  const Matrix limits = a.matrix ("limits", S.nq, 2);
  const std::vector<int> branches = a.integers ("branches", int (q.columns ()));
  const int branch = a.integers ("branch", 1)[0];
  const gs_reach_choice c = { S.nq, turns.data (), limits.data (), before.data () };
  const int k = gs_reach_choose (&c, int (q.columns ()), q.fortran_vec (), branches.data (),
                                 branch);
  return ovl (k < 0 ? Matrix (S.nq, 0) : q.extract_n (0, k, S.nq, 1), k + 1);
}

// (Jacobian of a tool, whether the solution is singular): whether it is, a speed that does not move
// the tool
static octave_value_list
do_free (arguments& a, int)
{
  const Matrix jacobian = a.matrix ("jacobian", -1, S.nu);
  const int singular = a.integer_within ("singular", 0, 1);
  ColumnVector speed (S.nu);
  const int found = gs_reach_free (int (jacobian.rows ()), S.nu, jacobian.data (), singular,
                                   speed.fortran_vec ());
  if (found < 0)
    throw std::bad_alloc ();
  return ovl (found == 1, speed);
}
