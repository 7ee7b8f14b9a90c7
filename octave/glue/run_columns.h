// The columns of derivatives that a run carries, by share/engine/host/derivatives: numbers of
// columns in, matrices of what was found out.
#pragma once

#include "arguments.h"
#include "host/derivatives/derivatives.h"
#include "run_plan.h"

class run_columns
{
public:

  // of each column the number of the parameter, 0 for a start value
  explicit run_columns (const Matrix& numbers = Matrix ())
  {
    for (octave_idx_type k = 0; k < numbers.numel (); k++)
      {
        m_col.push_back (int (numbers(k)));
        if (m_col.back () < 0 || m_col.back () > S.nsp)
          error ("%s: there is no column %d among %d", S.name, m_col.back (), S.nsp);
      }
  }

  int count (void) const { return int (m_col.size ()); }

  // SCENE becomes that of the run with columns, on its plan; INPUTS: the data of its vin
  void open (gs_scene& scene, run_plan& plan, const reals& cst, const reals& guess, number rtol,
             const reals& atol, void *inputs);

  // of a run that carries them, else a null pointer
  const number *constants (void) const
  {
    return m_run ? gs_derivatives_constants (m_run.get ()) : nullptr;
  }

  // of each column why it was given up, at which event and when
  Matrix lost (void) const;
  // event functions that came close to 0 and turned: a column each, number and time
  Matrix turns (void) const;
  // derivatives of held inputs: a column each, from which time on and inputs by columns
  Matrix held (void) const;
  // derivatives of inputs that follow plan and feedback at the output times: a column each
  Matrix followed (int reached, const reals& tout, const reals& xout, int ldx, const reals& vout,
                   int ldv) const;
  // derivatives of the times of the events: a column each
  Matrix events (void) const;

private:

  struct closed { void operator() (gs_derivatives *d) const { gs_derivatives_close (d); } };
  std::unique_ptr<gs_derivatives, closed> m_run;
  std::vector<int> m_col;
};

void
run_columns::open (gs_scene& scene, run_plan& plan, const reals& cst, const reals& guess,
                   number rtol, const reals& atol, void *inputs)
{
  std::vector<int> changes = plan.changing_events ();
  gs_derivatives_given given = gs_derivatives_given ();
  const char *missing = nullptr;
  scene.data = inputs;
  given.scene = &scene;
  given.cst = cst.data ();
  given.ncst = int (cst.size ());
  given.nc = count ();
  given.col = m_col.data ();
  given.nsets = S.nsets;
  given.sets = S.sets;
  given.ip = plan.ip.data ();
  given.rp = plan.rp.data ();
  given.guess = guess.data ();
  given.rtol = rtol;
  given.atol = atol.data ();
  given.changes = changes.data ();
  m_run.reset (gs_derivatives_open (&given, &missing));
  if (missing)
    routine (missing);   // says how to have it
  if (! m_run)
    throw std::bad_alloc ();
  scene = *gs_derivatives_scene (m_run.get ());
}

Matrix
run_columns::lost (void) const
{
  Matrix m (count (), 3);
  for (int k = 0; k < count (); k++)
    {
      int event = 0;
      m(k, 0) = gs_derivatives_lost (m_run.get (), k, &event, &m(k, 2));
      m(k, 1) = event;
    }
  return m;
}

// N columns of ROWS numbers
static Matrix
matrix_of (const double *from, int rows, int n)
{
  Matrix m (rows, n);
  std::copy_n (from, m.numel (), m.fortran_vec ());
  return m;
}

Matrix
run_columns::turns (void) const
{
  const double *pairs = nullptr;
  const int n = m_run ? gs_derivatives_turns (m_run.get (), &pairs) : 0;
  return matrix_of (pairs, 2, n);
}

Matrix
run_columns::held (void) const
{
  const double *columns = nullptr;
  const int n = m_run ? gs_derivatives_held (m_run.get (), &columns) : 0;
  if (n < 0)
    throw std::bad_alloc ();
  return matrix_of (columns, 1 + S.nv * count (), n);
}

Matrix
run_columns::followed (int reached, const reals& tout, const reals& xout, int ldx,
                       const reals& vout, int ldv) const
{
  const bool are = m_run && gs_derivatives_followed (m_run.get ());
  Matrix m (S.nv * count (), are ? reached : 0);
  if (are)
    gs_derivatives_of_inputs (m_run.get (), reached, &tout[0], &xout[0], ldx, &vout[0], ldv,
                              m.fortran_vec ());
  return m;
}

Matrix
run_columns::events (void) const
{
  const double *columns = nullptr;
  const int n = m_run ? gs_derivatives_of_events (m_run.get (), &columns) : 0;
  return matrix_of (columns, count (), n);
}
