// A run that Octave asks for, as the engine takes it (host/run/run.h): the constants and a struct
// with the members of gs_run_options, gs_run_start and gs_run_inputs by their names; [] is a null
// pointer.
#pragma once

#include "parameters.h"
#include "run_parts.h"
#include "host/run/run.h"

#include <list>

// the fields of a struct of Octave as C reads them, as long as this is there
class fields
{
public:

  explicit fields (const octave_scalar_map& given) : m_given (given) { }

  octave_value value (const char *name) const { return m_given.contents (name); }
  double scalar (const char *name) const { return value (name).double_value (); }
  int whole (const char *name) const { return value (name).int_value (); }

  // a null pointer: ""
  const char *text (const char *name)
  {
    m_texts.push_back (value (name).string_value ());
    return m_texts.back ().empty () ? nullptr : m_texts.back ().c_str ();
  }

  // a cell of them, as long as this is there
  std::vector<const char *> texts (const char *name)
  {
    const Cell given = value (name).cell_value ();
    std::vector<const char *> all;
    for (octave_idx_type k = 0; k < given.numel (); k++)
      {
        m_texts.push_back (given(k).string_value ());
        all.push_back (m_texts.back ().c_str ());
      }
    return all;
  }

  // SIZE numbers
  const number *numbers (const char *name, int size)
  {
    return list (name, value (name), size, m_numbers);
  }
  const int *wholes (const char *name, int size)
  {
    return list (name, value (name), size, m_wholes);
  }
  const double *doubles (const char *name, int size)
  {
#if defined (GSMBP_QUAD)
    return list (name, value (name), size, m_doubles);
#else
    return numbers (name, size);
#endif
  }

  // a piecewise polynomial: a struct with the members of gs_pieces
  gs_pieces pieces (const char *name)
  {
    if (! value (name).isstruct ())
      return { 0, 0, 0, nullptr };
    const fields p (value (name).scalar_map_value ());
    const int nc = p.whole ("nc"), np = p.whole ("np"), k = p.whole ("k");
    return { nc, np, k, list (name, p.value ("numbers"), np + 1 + nc * np * k, m_numbers) };
  }

private:

  template <typename T>
  const T *list (const char *name, const octave_value& given, int size,
                 std::list<std::vector<T>>& kept)
  {
    const Matrix m = given.matrix_value ();
    if (m.isempty ())
      return nullptr;
    if (m.numel () != size)
      error ("%s.run: %s: expected %d numbers, found %d", S.name, name, size, int (m.numel ()));
    kept.emplace_back (m.numel ());
    std::transform (m.data (), m.data () + m.numel (), kept.back ().begin (),
                    [] (double x) { return T (x); });
    return kept.back ().data ();
  }

  octave_scalar_map m_given;
  std::list<std::string> m_texts;
  std::list<reals> m_numbers;
  std::list<std::vector<int>> m_wholes;
#if defined (GSMBP_QUAD)
  std::list<std::vector<double>> m_doubles;
#endif
};

// what follows (constants, the struct), for as long as it is there
class asked_run
{
public:

  explicit asked_run (arguments& a);
  asked_run (const asked_run&) = delete;

  double begin (void) const { return double (start.times[0]); }
  double end (void) const { return double (start.times[start.nt - 1]); }
  bool calls_octave (void) const { return inputs.function != nullptr; }
  // an exception of the inputs in Octave is thrown again
  void settle (void) const
  {
    if (m_inputs.failure)
      std::rethrow_exception (m_inputs.failure);
  }

  gs_description about;
  gs_run_options options;
  gs_run_start start;
  gs_run_inputs inputs;
  double timeout;   // wall time [s]; 0: none

private:

  void read_options (void);
  void read_columns (void);
  void read_start (void);
  void read_inputs (void);

  const reals m_cst;
  fields m_given;
  octave_inputs m_inputs;
  std::vector<const char *> m_names;   // of the columns
};

asked_run::asked_run (arguments& a)
  : about (*S.about), options (gs_default_options ()), start (gs_run_start ()),
    inputs (gs_run_inputs ()), m_cst (a.constants ()),
    m_given (a.value ("run").scalar_map_value ())
{
  about.nominal = m_given.doubles ("nominal", S.nx);
  about.pre = gsmbp_exact_constants;
  timeout = m_given.scalar ("timeout");
  read_options ();
  read_start ();
  read_inputs ();
}

void
asked_run::read_options (void)
{
  gs_run_options& o = options;
  o.method = m_given.text ("method");
  o.loops = m_given.text ("loops");
  o.step = m_given.scalar ("step");
  o.rtol = m_given.scalar ("rtol");
  o.atol = m_given.numbers ("atol", S.nx);
  o.maxstep = m_given.scalar ("maxstep");
  o.maxsteps = m_given.scalar ("maxsteps");
  o.maxorder = m_given.scalar ("maxorder");
  o.drift = m_given.whole ("drift");
  o.project = m_given.whole ("project");
  o.samples = m_given.whole ("samples");
  o.audit = m_given.scalar ("audit");
  o.ncolumns = int (m_given.value ("columns").numel ());
  if (o.ncolumns > 0)
    read_columns ();
  o.ask = gsmbp_patience;
#if ! defined (GSMBP_QUAD)
  if (const char *library = m_given.text ("library"))
    o.cvode = method_of (library);
#endif
}

void
asked_run::read_columns (void)
{
  gs_run_options& o = options;
  o.columns = m_given.wholes ("columns", o.ncolumns);
  for (int k = 0; k < o.ncolumns; k++)
    if (o.columns[k] < 0 || o.columns[k] > S.nsp)
      error ("%s: there is no column %d among %d", S.name, o.columns[k], S.nsp);
  m_names = m_given.texts ("names");
  o.names = m_names.data ();
  o.sizes = m_given.doubles ("sizes", o.ncolumns);
  o.dx0 = m_given.numbers ("dx0", S.nx * o.ncolumns);
  o.fixed = m_given.wholes ("fixed", S.nq);
  o.changes = m_given.wholes ("changes", S.nev);
}

void
asked_run::read_start (void)
{
  start.nt = int (m_given.value ("times").numel ());
  start.times = m_given.numbers ("times", start.nt);
  start.x0 = m_given.numbers ("x0", S.nx);
  start.par = m_given.doubles ("par", S.npar);
  start.cst = m_cst.data ();
  start.modes = m_given.wholes ("modes", S.nev);
  start.memory = m_given.numbers ("memory", S.nxk);
}

void
asked_run::read_inputs (void)
{
  gs_run_inputs& in = inputs;
  in.kind = m_given.whole ("kind");
  in.constants = m_given.numbers ("constants", S.nv);
  in.table = m_given.pieces ("table");
  in.motion = m_given.pieces ("motion");
  in.planned = m_given.wholes ("planned", in.motion.nc);
  in.reference = m_given.pieces ("reference");
  in.gain = m_given.pieces ("gain");
  in.limits = m_given.numbers ("limits", 2 * S.nv);
  in.nbreaks = int (m_given.value ("breaks").numel ());
  in.breaks = m_given.doubles ("breaks", in.nbreaks);
  m_inputs.f = m_given.value ("function");
  if (m_inputs.f.is_function_handle ())
    {
      in.function = gsmbp_octave_inputs;
      in.data = &m_inputs;
    }
}
