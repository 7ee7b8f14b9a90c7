// Linear models (host/linear/linear.h), for the functions of octave/.
#pragma once

#include "info.h"
#include "starts.h"
#include "host/close_along.h"
#include "host/linear/linear.h"
#include "host/linear/loop_slopes.h"

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

// texts as C takes them, as long as this lives
class texts
{
public:
  texts (arguments& a, const char *name, int n)
  {
    const Array<std::string> list = a.value (name).cellstr_value ();
    for (octave_idx_type k = 0; k < list.numel (); k++)
      m_list.push_back (list(k));
    m_list.resize (std::size_t (n) + 1);
    for (const std::string& text : m_list)
      m_pointers.push_back (text.c_str ());
  }
  texts (const texts&) = delete;
  const char *const *data (void) const { return m_pointers.data (); }

private:
  std::vector<std::string> m_list;
  std::vector<const char *> m_pointers;
};

// (those of asked_start, inputs, names of the inputs, units of states and constraints)
struct asked_place
{
  asked_start start;
  const reals v;
  const texts inputs, units, constraints;
  const gs_linear_place at;

  asked_place (arguments& a)
    : start (a), v (a.vector ("v", S.nv)), inputs (a, "inputs", S.nv), units (a, "units", S.nx),
      constraints (a, "constraints", S.nlam),
      at ({ start.t, &start.cst[0], &start.x[0], &v[0], inputs.data (), units.data (),
            constraints.data () })
  { }
};

// (those of asked_place, 0: names, 1: auto, 2: none, wanted states, whether what runs is
// dropped, coordinates that are dropped): the verdict, its text; A, B, C, D, T, the numbers of the
// states, those dropped, the outputs that are left, row and column of an output without a finite
// derivative
static octave_value_list
do_linear (arguments& a, int)
{
  const asked_place p (a);
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
  gs_linear (&p.start.about, &p.at, &asked, &r, &told);
  heed (told);
  octave_value_list list = ovl (told.verdict, told.text);
  return list.append (ovl (result (A, r.n, r.n), result (B, r.n, S.nv), result (C, r.m, r.n),
                           result (D, r.m, S.nv), result (T, nx, r.n),
                           from_one (r.independent, r.n), from_one (r.dropped, r.ndropped),
                           from_one (r.seen, r.m), r.row + 1, r.column + 1));
}

// flags as numbers from 1
static RowVector
marked (const std::vector<int>& flags, int n)
{
  std::vector<int> list;
  for (int k = 0; k < n; k++)
    if (flags[k])
      list.push_back (k);
  return from_one (list.data (), int (list.size ()));
}

// (those of asked_place, states that are held, free inputs, free speeds, whether it is a steady
// motion, coordinates that run and their speeds, whether margins count, tolerance): the verdict,
// its text; the state, the inputs, what is left, the way, the coordinates that run, what can be
// moved, a warning
static octave_value_list
do_trim (arguments& a, int)
{
  const asked_place p (a);
  const std::vector<int> hold = from_zero (a, "hold"), free = from_zero (a, "free");
  const std::vector<int> speeds = from_zero (a, "speeds");
  const bool steady = a.integer_within ("steady", 0, 1) == 1;
  const std::vector<int> running = from_zero (a, "running");
  const bool margins = a.integer_within ("margins", 0, 1) == 1;
  std::vector<int> modes;
  for (int k = 0; k < S.nmode; k++)
    modes.push_back (S.modes[k] - 1);
  const gs_trim_asked asked
      = { int (hold.size ()), int (free.size ()), int (speeds.size ()), hold.data (), free.data (),
          speeds.data (), steady, int (running.size () / 2), running.data (), int (modes.size ()),
          modes.data (), margins, a.value ("tolerance").double_value (), p.start.par.data () };
  reals x (S.nx + 1), v (S.nv + 1);
  std::vector<int> runs (S.nq + 1), moved (S.nx + S.nv + 1);
  gs_trim_found found = { &x[0], &v[0], 0, 0, runs.data (), moved.data (), "" };
  gs_linear_told told;
  gs_trim (&p.start.about, &p.at, &asked, &found, &told);
  heed (told);
  return ovl (told.verdict, told.text, result (x, S.nx), result (v, S.nv), found.residual,
              found.way + 1, marked (runs, S.nq), marked (moved, S.nx + S.nv), found.warning);
}

// (those of asked_place, wanted states, or none): the verdict, its text; T, the numbers of the
// independent states
static octave_value_list
do_tangent (arguments& a, int)
{
  const asked_place p (a);
  const std::vector<int> wanted = from_zero (a, "wanted");
  std::vector<int> independent (S.nx + 1);
  reals T (S.nx * S.nx + 1);
  int n = 0;
  gs_linear_told told;
  gs_linear_tangent (&p.start.about, &p.at, wanted.empty () ? nullptr : wanted.data (),
                     int (wanted.size ()), &T[0], independent.data (), &n, &told);
  heed (told);
  return ovl (told.verdict, told.text, result (T, S.nx, n), from_one (independent.data (), n));
}

// pairs of numbers as complex ones
static ComplexMatrix
complex_result (const reals& z, int rows, int cols)
{
  ComplexMatrix m (rows, cols);
  for (octave_idx_type i = 0; i < m.numel (); i++)
    m.xelem (i) = Complex (double (z[2 * i]), double (z[2 * i + 1]));
  return m;
}

static reals
as_pairs (const ComplexNDArray& m)
{
  reals z (2 * m.numel () + 1, number (0));
  for (octave_idx_type i = 0; i < m.numel (); i++)
    {
      z[2 * i] = m(i).real ();
      z[2 * i + 1] = m(i).imag ();
    }
  return z;
}

// the eigenvalues and eigenvectors of r.square, by Octave, and what they say: a list of
// eigenvalues, frequencies, damping ratios, shapes, real eigenvalues, how many are zero
static octave_value_list
modes_of (const asked_place& p, const gs_vibrations& r, const reals& square)
{
  const int k = r.nfelt, rows = S.nq > 0 ? S.nq : S.nx;
  reals values (1), vectors (1);
  if (k > 0)
    {
      const octave_value_list e = octave::feval ("eig", ovl (result (square, k, k), "vector"), 2);
      vectors = as_pairs (e(0).complex_array_value ());
      values = as_pairs (e(1).complex_array_value ());
    }
  reals e (2 * k + 1), frequency (k + 1), damping (k + 1), shapes (2 * rows * k + 1), real (k + 1);
  gs_modes m = { 0, 0, 0, &e[0], &frequency[0], &damping[0], &shapes[0], &real[0] };
  gs_linear_told told;
  gs_modes_of (&p.start.about, &p.at, &r, &values[0], &vectors[0], &m, &told);
  heed (told);
  return ovl (complex_result (e, m.n, 1), result (frequency, m.n), result (damping, m.n),
              complex_result (shapes, rows, m.n), result (real, m.nreal), m.rigid);
}

// (those of asked_place, coordinates that are held and their speeds, whether the state is moved to
// a steady one): the verdict, its text, the state, why it is no equilibrium; those of modes_of
static octave_value_list
do_modes (arguments& a, int)
{
  const asked_place p (a);
  const std::vector<int> held = from_zero (a, "held");
  const int steady = a.integer_within ("steady", 0, 1), nx = S.nx;
  std::vector<int> independent (nx + 1), felt (nx + 1);
  reals x (nx + 1), A (nx * nx + 1), square (nx * nx + 1), T (nx * nx + 1);
  const gs_vibrations_asked asked = { steady, int (held.size () / 2), held.data () };
  gs_vibrations r = { 0, 0, independent.data (), felt.data (), &x[0], &A[0], &square[0], &T[0],
                      "" };
  gs_linear_told told;
  gs_vibrate (&p.start.about, &p.at, &asked, &r, &told);
  heed (told);
  octave_value_list list = ovl (told.verdict, told.text, result (x, nx), r.doubt);
  return list.append (told.verdict == 0 ? modes_of (p, r, square)
                                        : octave_value_list (6, Matrix ()));
}

// (numbers of modes by speed, frequencies, shapes, one behind another): the row of each mode in a
// diagram, how many rows there are
static octave_value_list
do_follow_modes (arguments& a, int)
{
  std::vector<int> many = a.integers ("many", -1);
  const ComplexMatrix given = a.value ("shapes").complex_matrix_value ();
  const int total = int (given.columns ());
  const reals frequency = a.vector ("frequency", total), shapes = as_pairs (given);
  std::vector<int> row (total + 1);
  const gs_campbell c = { int (given.rows ()), int (many.size ()), total, many.data (),
                          &frequency[0], &shapes[0] };
  const int rows = gs_follow_modes (&c, row.data ());
  if (rows < 0)
    throw std::bad_alloc ();
  return ovl (from_one (row.data (), total), rows);
}

// (those of asked_place, states that are held, free inputs, names of the parameters): the verdict,
// its text; derivatives of states, inputs and outputs of an equilibrium
static octave_value_list
do_rest_slopes (arguments& a, int)
{
  const asked_place p (a);
  const std::vector<int> hold = from_zero (a, "hold"), free = from_zero (a, "free");
  const int np = S.run->nsp;
  const texts names (a, "names", np);
  const gs_slopes_asked asked
      = { int (hold.size ()), int (free.size ()), hold.data (), free.data (), names.data () };
  reals dx (S.nx * np + 1), dv (S.nv * np + 1), dy (S.ny * np + 1);
  gs_rest_slopes r = { 0, &dx[0], &dv[0], &dy[0] };
  gs_linear_told told;
  gs_slopes_of_rest (&p.start.about, &p.at, &asked, &r, &told);
  heed (told);
  return ovl (told.verdict, told.text, result (dx, S.nx, np), result (dv, S.nv, np),
              r.outputs ? result (dy, S.ny, np) : Matrix (S.ny, np, octave_NaN));
}

// (nominal magnitudes, a parameter, derivatives of the states by it): steps and factors of
// differences
static octave_value_list
do_family_steps (arguments& a, int)
{
  const Matrix nominal = a.matrix ("nominal", S.nx, 1);
  const double p = a.value ("parameter").double_value ();
  const Matrix dx = a.matrix ("dx", S.nx, 1);
  RowVector steps (6), factors (6);
  gs_family_steps (S.nx, nominal.data (), p, dx.data (), steps.fortran_vec (),
                   factors.fortran_vec ());
  return ovl (steps, factors);
}

// (eigenvalues, right and left eigenvectors, the change of their matrix): changes of the
// eigenvalues, of their absolute values and damping ratios
static octave_value_list
do_pole_slopes (arguments& a, int)
{
  const ComplexColumnVector e = a.value ("poles").complex_column_vector_value ();
  const int n = int (e.numel ());
  const ComplexMatrix v = a.value ("right").complex_matrix_value ();
  const ComplexMatrix w = a.value ("left").complex_matrix_value ();
  const Matrix da = a.matrix ("change", n, n);
  ComplexColumnVector poles (n);
  ColumnVector frequency (n), damping (n);
  const auto pairs = [] (const Complex *z) { return reinterpret_cast<const double *> (z); };
  gs_pole_slopes r = { reinterpret_cast<double *> (poles.fortran_vec ()),
                       frequency.fortran_vec (), damping.fortran_vec () };
  gs_slopes_of_poles (n, pairs (e.data ()), pairs (v.data ()), pairs (w.data ()), da.data (), &r);
  return ovl (poles, frequency, damping);
}

// (planned coordinates; changes of parameters, of the planned coordinates, their speeds and
// accelerations; derivatives of ILP): changes of all, of efforts and multipliers; whether the loops
// are singular
static octave_value_list
do_loop_slopes (arguments& a, int)
{
  const std::vector<int> planned = from_zero (a, "planned");
  const Matrix p = a.matrix ("parameters", -1, -1);
  const int n = int (p.columns ()), np = int (planned.size ());
  const Matrix q = a.matrix ("changes", np, 3 * n);
  const Matrix d = a.matrix ("derivatives", -1, int (4 * S.nu + p.rows ()));
  NDArray x (dim_vector (S.nu, 3, n), 0.0);
  Matrix e (S.nu, n, 0.0);
  const int bad = gs_loop_slopes (S.nu, int (p.rows ()), int (d.rows ()), d.data (), np,
                                  planned.data (), n, q.data (), p.data (), x.fortran_vec (),
                                  e.fortran_vec ());
  if (bad == 1)
    throw std::bad_alloc ();
  return ovl (x, e, bad == 2);
}
