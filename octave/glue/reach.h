// Solutions of inverse kinematics (host/reach/reach.h), for gsmbp_reach.
#pragma once

#include "arguments.h"
#include "numbers.h"
#include "host/reach/reach.h"

// (Euler parameters or matrices, a column for each pose): rotation matrices, a column for each
static octave_value_list
do_axes (arguments& a, int)
{
  const Matrix given = a.matrix ("axes", -1, -1);
  const int n = int (given.rows ());
  Matrix axes (9, given.columns ());
  char why[200];
  if (n != 4 && n != 9)
    error ("%s: argument axes: expected 4 or 9 rows, found %d", a.who ().c_str (), n);
  for (octave_idx_type k = 0; k < given.columns (); k++)
    if (! gs_reach_axes (n, given.data () + n * k, int (k + 1), axes.fortran_vec () + 9 * k, why,
                         sizeof why))
      error ("gsmbp_reach: %s", why);
  return ovl (axes);
}

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
