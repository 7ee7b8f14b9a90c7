// What gsmbp_collocate is asked for (gs.collocation.read_problem) as host/collocation/program.h
// takes it.
#pragma once

#include <list>

#include "arguments.h"
#include "host/collocation/program.h"

class motion_problem
{
public:

  // (constants, parameters, problem)
  motion_problem (arguments& a);
  motion_problem (const motion_problem&) = delete;

  const gs_motion_problem& get (void) const { return m_p; }

private:

  typedef std::vector<double> doubles;

  static doubles list (const octave_value& v);
  static doubles of_rows (const octave_scalar_map& p, const char *name, const char *field);
  static int nz (void) { return S.nx + S.nu + S.nlam + S.nv; }
  const double *keep (doubles list, std::size_t n, double otherwise);
  const double *numbers (const octave_scalar_map& p, const char *name, int n, double otherwise);
  void read_bounds (const octave_scalar_map& p);
  void read_goal (const octave_scalar_map& p);
  const char *const *names (const octave_scalar_map& p, const char *name, int n,
                            std::vector<const char *>& list);
  void read_arcs (const octave_scalar_map& p);

  reals m_cst;
  std::list<doubles> m_kept;
  std::vector<std::string> m_names;
  std::vector<const char *> m_inputs, m_outputs;
  std::vector<int> m_bounded;
  std::vector<gs_cost_product> m_products;
  std::vector<gs_smooth_arc> m_arcs;
  gs_motion_problem m_p;
};

motion_problem::doubles
motion_problem::list (const octave_value& v)
{
  const Matrix m = v.matrix_value ();
  return doubles (m.data (), m.data () + m.numel ());
}

// a field of the elements of a struct array
motion_problem::doubles
motion_problem::of_rows (const octave_scalar_map& p, const char *name, const char *field)
{
  doubles l;
  if (! p.isfield (name) || ! p.contents (name).map_value ().isfield (field))
    return l;
  const Cell c = p.contents (name).map_value ().contents (field);
  for (octave_idx_type k = 0; k < c.numel (); k++)
    l.push_back (c(k).double_value ());
  return l;
}

// as it is, filled to N numbers
const double *
motion_problem::keep (doubles l, std::size_t n, double otherwise)
{
  l.resize (std::max (l.size (), n + 1), otherwise);
  m_kept.push_back (std::move (l));
  return m_kept.back ().data ();
}

const double *
motion_problem::numbers (const octave_scalar_map& p, const char *name, int n, double otherwise)
{
  return keep (p.isfield (name) ? list (p.contents (name)) : doubles (), n, otherwise);
}

void
motion_problem::read_bounds (const octave_scalar_map& p)
{
  const double inf = std::numeric_limits<double>::infinity ();
  m_p.x0 = numbers (p, "x0", S.nx, no_number);
  m_p.xf = numbers (p, "xf", S.nx, no_number);
  m_p.t0 = p.contents ("t0").double_value ();
  const double *T = numbers (p, "T", 2, 1);
  std::copy (T, T + 2, m_p.duration);
  m_p.low = numbers (p, "low", nz (), -inf);
  m_p.high = numbers (p, "high", nz (), inf);
  doubles low (S.nx, -inf), high (S.nx, inf);
  const doubles at = of_rows (p, "ends", "number"), a = of_rows (p, "ends", "low"),
                b = of_rows (p, "ends", "high");
  for (std::size_t k = 0; k < at.size (); k++)
    {
      low[at[k] - 1] = std::max (low[at[k] - 1], a[k]);
      high[at[k] - 1] = std::min (high[at[k] - 1], b[k]);
    }
  m_p.last_low = keep (low, S.nx, -inf);
  m_p.last_high = keep (high, S.nx, inf);
  m_p.unknown_low = keep (of_rows (p, "parameters", "low"), S.npar, 0);
  m_p.unknown_high = keep (of_rows (p, "parameters", "high"), S.npar, 0);
  for (double k : of_rows (p, "outputs", "number"))
    m_bounded.push_back (int (k) - 1);
  m_p.nbounded = int (m_bounded.size ());
  m_p.bounded = m_bounded.data ();
  m_p.output_low = keep (of_rows (p, "outputs", "low"), 0, 0);
  m_p.output_high = keep (of_rows (p, "outputs", "high"), 0, 0);
  m_p.held = p.isfield ("held") ? numbers (p, "held", 0, 0) : nullptr;
}

void
motion_problem::read_goal (const octave_scalar_map& p)
{
  m_p.time_weight = p.contents ("goal_time").double_value ();
  doubles weights (S.ny, 0);
  const doubles at = of_rows (p, "goal", "number"), w = of_rows (p, "goal", "weight");
  for (std::size_t k = 0; k < at.size (); k++)
    weights[at[k] - 1] += w[k];
  m_p.output_weights = keep (weights, S.ny, 0);
  const octave_scalar_map final_ = p.contents ("final").scalar_map_value ();
  m_p.final_states = numbers (final_, "x", S.nx, 0);
  m_p.final_outputs = numbers (final_, "y", S.ny, 0);
  const octave_scalar_map own = p.contents ("own").scalar_map_value ();
  m_p.linear = numbers (own, "linear", nz (), 0);
  const Matrix m = own.contents ("products").matrix_value ();
  for (octave_idx_type i = 0; i < m.rows (); i++)
    m_products.push_back ({ int (m(i, 0)) - 1, int (m(i, 1)) - 1, m(i, 2) });
  m_p.nproducts = int (m_products.size ());
  m_p.products = m_products.data ();
}

void
motion_problem::read_arcs (const octave_scalar_map& p)
{
  const doubles input = of_rows (p, "singular", "input"), from = of_rows (p, "singular", "from"),
                until = of_rows (p, "singular", "until"),
                weight = of_rows (p, "singular", "weight");
  for (std::size_t k = 0; k < input.size (); k++)
    m_arcs.push_back ({ int (input[k]) - 1, from[k], until[k], weight[k] });
  m_p.narcs = int (m_arcs.size ());
  m_p.arcs = m_arcs.data ();
}

const char *const *
motion_problem::names (const octave_scalar_map& p, const char *name, int n,
                       std::vector<const char *>& list)
{
  const Cell given = p.isfield (name) ? p.contents (name).cell_value () : Cell (1, n, "");
  for (int k = 0; k < n; k++)
    {
      m_names.push_back (given(k).string_value ());
      list.push_back (m_names.back ().c_str ());
    }
  return list.data ();
}

motion_problem::motion_problem (arguments& a)
  : m_cst (a.constants ()), m_p (gs_motion_problem ())
{
  m_p.cst = &m_cst[0];
  m_p.par = keep (list (a.value ("par")), S.npar, 0);
  const octave_scalar_map p = a.value ("problem").scalar_map_value ();
  read_bounds (p);
  read_goal (p);
  read_arcs (p);
  m_names.reserve (S.nv + S.ny + 2);
  m_p.inputs = names (p, "inputs", S.nv, m_inputs);
  m_p.outputs = names (p, "names", S.ny, m_outputs);
}
