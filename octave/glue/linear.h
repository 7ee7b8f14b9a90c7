// Linear models (host/linear/linear.h), for the functions of octave/.
#pragma once

#include "info.h"
#include "starts.h"
#include "host/linear/linear.h"

// numbers of Octave, which begin with 1, and those of C
static std::vector<int>
from_zero (arguments& a, const char *name)
{
  const Matrix m = a.value (name).matrix_value ();
  std::vector<int> list;
  for (octave_idx_type k = 0; k < m.numel (); k++)
    list.push_back (int (m(k)) - 1);
  return list;
}

static RowVector
from_one (const int *list, int n)
{
  RowVector r (n);
  for (int k = 0; k < n; k++)
    r(k) = list[k] + 1;
  return r;
}

// what the routines of the scene say; what else is wrong is told by who has called
static void
heed (const gs_linear_told& told)
{
  if (told.verdict == GS_LINEAR_NO_MEMORY)
    throw std::bad_alloc ();
  if (told.verdict == GS_LINEAR_ABSENT)
    absent_routine (told.routine);
  if (told.verdict == GS_LINEAR_FAILED)
    error_with_id ("gsmbp:info", "%s.%s: INFO = %d: %s", S.name, told.routine, told.info,
                   meaning (told.routine, told.info).c_str ());
  if (told.routine)
    say_rank (told.routine);
}

// (those of asked_start, inputs, 0: names, 1: auto, 2: none, wanted states, whether what runs is
// dropped, coordinates that are dropped): the verdict, its text, row and column; A, B, C, D, T, the
// numbers of the states, those dropped, the outputs that are left, row and column of an output
// without a finite derivative
static octave_value_list
do_linear (arguments& a, int)
{
  asked_start s (a);
  const reals v = a.vector ("v", S.nv);
  gs_linear_asked asked = gs_linear_asked ();
  asked.reduced = a.integer_within ("reduced", 0, 2);
  const std::vector<int> wanted = from_zero (a, "wanted");
  asked.nwanted = int (wanted.size ());
  asked.wanted = wanted.data ();
  asked.running = a.integer_within ("running", 0, 1);
  const std::vector<int> drop = from_zero (a, "drop");
  asked.ndrop = int (drop.size ());
  asked.drop = drop.data ();
  const int nx = S.nx, ny = S.ny > 0 ? S.ny : nx;
  std::vector<int> independent (nx + 1), dropped (nx + 1), seen (ny + 1);
  reals A (nx * nx + 1), B (nx * S.nv + 1), C (ny * nx + 1), D (ny * S.nv + 1), T (nx * nx + 1);
  gs_linear_model r = { 0, 0, 0, independent.data (), dropped.data (), seen.data (), &A[0], &B[0],
                        &C[0], &D[0], &T[0], -1, -1 };
  gs_linear_told told;
  const gs_linear_place at = { s.t, &s.cst[0], &s.x[0], &v[0] };
  gs_linear (&s.about, &at, &asked, &r, &told);
  heed (told);
  octave_value_list list = ovl (told.verdict, told.text, told.row + 1, told.column + 1);
  return list.append (ovl (result (A, r.n, r.n), result (B, r.n, S.nv), result (C, r.m, r.n),
                           result (D, r.m, S.nv), result (T, nx, r.n),
                           from_one (r.independent, r.n), from_one (r.dropped, r.ndropped),
                           from_one (r.seen, r.m), r.row + 1, r.column + 1));
}
