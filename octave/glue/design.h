// Designs (gsmbp_optimize), by host/optimize/optimize.h.
#pragma once

#include "collocation.h"
#include "host/optimize/optimize.h"

// What gsmbp_optimize is asked for (its engine_problem) as the engine takes it; what a function of
// Octave gives as the values of a point.
class octave_design
{
public:

  octave_design (const octave_scalar_map& p, const octave_value& f);
  octave_design (const octave_design&) = delete;

  const gs_design& get (void) const { return m_d; }
  // an error of the function, or what ended it, as Octave has them
  void raise (const gs_design_result& r, const std::string& who) const;
  void settle (void) const
  {
    if (m_end_of_octave)
      std::rethrow_exception (m_end_of_octave);
  }

private:

  static int evaluate (void *data, const double *p, const int *rows, const int *free,
                       gs_design_values *v)
  { return static_cast<octave_design *> (data)->ask (p, rows, free, *v); }

  int ask (const double *p, const int *rows, const int *free, gs_design_values& v);
  void take (const octave_scalar_map& e, gs_design_values& v);
  const double *keep (const octave_value& v);
  void read_free (const octave_map& free);
  void read_rows (const octave_map& rows);

  octave_value m_f;
  gs_design m_d;
  std::string m_name, m_why, m_identifier;
  std::vector<std::string> m_texts;
  std::vector<gs_free> m_free;
  std::vector<gs_design_row> m_rows;
  std::vector<Matrix> m_lists, m_kept;
  std::vector<std::vector<int>> m_cases;
  Matrix m_bands;
  std::exception_ptr m_end_of_octave;
};

void
octave_design::read_free (const octave_map& free)
{
  const octave_idx_type n = free.numel ();
  auto of = [&] (const char *name, octave_idx_type k) { return free.contents (name)(k); };
  for (octave_idx_type k = 0; k < n; k++)
    {
      m_texts.push_back (of ("name", k).string_value ());
      m_lists.push_back (of ("list", k).matrix_value ());
    }
  for (octave_idx_type k = 0; k < n; k++)
    m_free.push_back ({ m_texts[k].c_str (), of ("start", k).double_value (),
                        of ("low", k).double_value (), of ("high", k).double_value (),
                        of ("kind", k).string_value () == "own", int (m_lists[k].numel ()),
                        m_lists[k].data () });
}

void
octave_design::read_rows (const octave_map& rows)
{
  const octave_idx_type n = rows.numel ();
  auto of = [&] (const char *name, octave_idx_type k) { return rows.contents (name)(k); };
  for (octave_idx_type k = 0; k < n; k++)
    {
      const Matrix cases = of ("cases", k).matrix_value ();
      m_cases.emplace_back ();
      for (octave_idx_type i = 0; i < cases.numel (); i++)
        m_cases.back ().push_back (int (cases(i)) - 1);
      m_texts.push_back (of ("text", k).string_value ());
    }
  for (octave_idx_type k = 0; k < n; k++)
    {
      const std::string relation = of ("relation", k).string_value ();
      m_rows.push_back ({ of ("number", k).int_value (), relation.empty () ? 0 : relation[0],
                          int (m_cases[k].size ()), of ("factor", k).double_value (),
                          of ("bound", k).double_value (), m_cases[k].data (),
                          m_texts[m_free.size () + k].c_str () });
    }
}

octave_design::octave_design (const octave_scalar_map& p, const octave_value& f)
  : m_f (f), m_name (p.contents ("name").string_value ()),
    m_why (p.contents ("why").string_value ()), m_bands (p.contents ("bands").matrix_value ())
{
  const octave_map free = p.contents ("free").map_value ();
  const octave_map rows = p.contents ("rows").map_value ();
  m_texts.reserve (free.numel () + rows.numel ());
  m_lists.reserve (free.numel ());
  m_cases.reserve (rows.numel ());
  read_free (free);
  read_rows (rows);
  const int goals = p.contents ("goals").int_value ();
  m_d = { m_name.c_str (), int (m_free.size ()), goals, int (m_rows.size ()) - goals,
          int (m_bands.numel ()), m_free.data (), m_rows.data (), m_bands.data (), m_why.c_str (),
          this, evaluate };
}

// a null pointer where there is nothing
const double *
octave_design::keep (const octave_value& v)
{
  if (v.isempty ())
    return nullptr;
  m_kept.push_back (v.array_value ().as_matrix ());
  return m_kept.back ().data ();
}

// times: a row for each case, t, w, dt, dw; series: a row for each, y, slopes
void
octave_design::take (const octave_scalar_map& e, gs_design_values& v)
{
  const Cell times = e.contents ("times").cell_value (), series
      = e.contents ("series").cell_value ();
  m_kept.clear ();
  m_kept.reserve (times.numel () + series.numel ());
  for (octave_idx_type k = 0; k < times.rows (); k++)
    v.times[k] = { int (times(k, 0).numel ()), keep (times(k, 0)), keep (times(k, 1)),
                   keep (times(k, 2)), keep (times(k, 3)) };
  for (octave_idx_type k = 0; k < series.rows (); k++)
    v.series[k] = { int (series(k, 0).numel ()), keep (series(k, 0)), keep (series(k, 1)) };
  const Matrix rough = e.contents ("rough").matrix_value ();
  for (octave_idx_type k = 0; k < rough.numel (); k++)
    v.rough[k] = rough(k) != 0;
  v.functions = e.contents ("functions").bool_value ();
}

// f (p, rows, free): 0, or by what it was ended, as "guarded" says it; what it found
int
octave_design::ask (const double *p, const int *rows, const int *free, gs_design_values& v)
{
  if (m_end_of_octave)
    return GS_VALUES_INTERRUPTED;
  try
    {
      const std::size_t n = m_free.size (), m = m_rows.size ();
      ColumnVector at (n);
      std::copy_n (p, n, at.fortran_vec ());
      boolNDArray wanted (dim_vector (1, m)), by (dim_vector (1, n));
      std::transform (rows, rows + m, wanted.fortran_vec (), [] (int k) { return k != 0; });
      std::transform (free, free + n, by.fortran_vec (), [] (int k) { return k != 0; });
      const octave_value_list r = octave::feval (m_f, ovl (at, wanted, by), 2);
      const int cut = r(0).int_value ();
      if (cut)
        return cut == 2 ? GS_VALUES_LATE : GS_VALUES_INTERRUPTED;
      take (r(1).scalar_map_value (), v);
      return GS_VALUES_FOUND;
    }
  catch (const octave::execution_exception& e)
    {
      std::snprintf (v.trouble, sizeof v.trouble, "%s", e.message ().c_str ());
      m_identifier = e.identifier ();
      octave::interpreter::the_interpreter ()->recover_from_exception ();
      return GS_VALUES_FAILED;
    }
  catch (...)   // no exception crosses C
    {
      m_end_of_octave = std::current_exception ();
    }
  octave::interpreter::the_interpreter ()->recover_from_exception ();
  return GS_VALUES_INTERRUPTED;
}

void
octave_design::raise (const gs_design_result& r, const std::string& who) const
{
  const std::string text = r.ended;
  if (r.verdict == GS_DESIGN_FAILED)
    error_with_id (m_identifier.c_str (), "%s", text.c_str ());
  if (r.verdict == GS_DESIGN_STOPPED)
    error_with_id ("gsmbp:stopped", "%s: %s", who.c_str (), text.c_str ());
  if (r.verdict)
    error ("%s: %s", who.c_str (), text.c_str ());
}

static octave_value
active_field (const gs_design_active& a, const std::string& f)
{
  return f == "text"    ? octave_value (a.text)
         : f == "kind"  ? octave_value (a.demand ? "demand" : "bound")
         : f == "value" ? octave_value (a.value)
         : f == "bound" ? octave_value (a.bound)
                        : octave_value (a.multiplier);
}

static octave_value
end_field (const gs_design_end& e, const std::string& f, int n)
{
  return f == "values"      ? octave_value (rows_from (e.values, n, 1))
         : f == "J"         ? octave_value (e.J)
         : f == "solved"    ? octave_value (bool (e.solved))
         : f == "violation" ? octave_value (e.violation)
                            : octave_value (e.ended);
}

static const char *
stopped_word (int stopped)
{
  return stopped == GS_INTERRUPTED ? "interrupted" : stopped == GS_TIMED_OUT ? "timeout" : "";
}

static octave_scalar_map
design_map (const gs_design_result& r, int n)
{
  octave_scalar_map s, choices;
  auto numbers = [] (const int *x, int many, int more)
  {
    Matrix m (1, many);
    for (int k = 0; k < many; k++)
      m(k) = x[k] + more;
    return m;
  };
  s.assign ("values", rows_from (r.values, n, 1));
  s.assign ("J", r.J);
  s.assign ("active", rows_of (r.nactive, { "text", "kind", "value", "bound", "multiplier" },
                               [&] (int k, const std::string& f)
                               { return active_field (r.active[k], f); }));
  s.assign ("solved", bool (r.solved));
  s.assign ("ended", r.ended);
  s.assign ("limit", bool (r.limit));
  s.assign ("violation", r.violation);
  s.assign ("optimality", r.optimality);
  s.assign ("iterations", r.iterations < 0 ? no_number : double (r.iterations));
  s.assign ("evaluations", r.evaluations);
  s.assign ("solver", double (r.solver + 1));
  s.assign ("starts", rows_of (r.nends, { "values", "J", "solved", "violation", "ended" },
                               [&] (int k, const std::string& f)
                               { return end_field (r.ends[k], f, n); }));
  s.assign ("stopped", stopped_word (r.stopped));
  s.assign ("derivatives", r.derivatives);
  s.assign ("conflict", numbers (r.conflict, r.info == 2 ? r.nconflict : 0, 1));
  s.assign ("idle", numbers (r.idle, n, 0));
  s.assign ("info", r.info);
  choices.assign ("how", r.branched ? "branch" : "all");
  choices.assign ("combinations", r.combinations);
  choices.assign ("solved", r.problems);
  choices.assign ("limit", bool (r.choices_limit));
  choices.assign ("open", r.open);
  choices.assign ("stopped", stopped_word (r.choices_stopped));
  s.assign ("choices", choices);
  s.assign ("report", r.report);
  return s;
}

// (who, problem, f, options: solver, choices (numbers), nodes, iterations, starts (a column each),
// tolerance, evaluations, seconds, timeout, libraries of Ipopt and NLopt, "" for none): what is
// found
static octave_value_list
do_design (arguments& a, int)
{
  const std::string who = a.value ("who").string_value ();
  const octave_scalar_map p = a.value ("problem").scalar_map_value ();
  octave_design design (p, a.value ("function"));
  const octave_scalar_map o = a.value ("options").scalar_map_value ();
  auto of = [&] (const char *name) { return o.contents (name).double_value (); };
  auto whole = [&] (const char *name) { return int (std::min (of (name), 2e9)); };
  auto solver = [&] (const char *name, const char *symbol)
  {
    const std::string library = o.contents (name).string_value ();
    return library.empty () ? nullptr : solver_of (library, symbol);
  };
  const Matrix starts = o.contents ("starts").matrix_value ();
  const gs_design_options options
      = { whole ("solver"), whole ("choices"), whole ("nodes"), whole ("iterations"),
          int (starts.columns ()), starts.data (), of ("tolerance"), of ("evaluations"),
          of ("seconds"), of ("timeout"), solver ("ipopt", "gs_ipopt"),
          solver ("nlopt", "gs_nlopt") };
  while (! the_worker.free ())
    octave_quit ();
  struct guard
  {
    gs_design_result r = gs_design_result ();
    ~guard (void) { gs_design_free (&r); }
  } found;
  const int bad = gs_optimize (&design.get (), &options, &found.r);
  design.settle ();
  if (bad)
    throw std::bad_alloc ();
  design.raise (found.r, who);
  return ovl (design_map (found.r, design.get ().nfree));
}

// (times): the weights of an integral over them, how they change with the last one
static octave_value_list
do_weights (arguments& a, int)
{
  const Matrix t = a.matrix ("times", -1, 1);
  Matrix w (t.numel (), 1), slope (t.numel (), 1);
  if (gs_integral_weights (int (t.numel ()), t.data (), w.fortran_vec (), slope.fortran_vec ()))
    throw std::bad_alloc ();
  return ovl (w, slope);
}

// (start, low, high, value of a variable): where differences of order 4 look, their factors
static octave_value_list
do_differences (arguments& a, int)
{
  auto next = [&] (const char *name) { return a.value (name).double_value (); };
  const double start = next ("start"), low = next ("low"), high = next ("high");
  const gs_free variable = { "", start, low, high, 0, 0, nullptr };
  Matrix points (1, 5), factors (1, 5);
  const int n = gs_difference_points (&variable, next ("at"), points.fortran_vec (),
                                      factors.fortran_vec ());
  points.resize (1, n);
  factors.resize (1, n);
  return ovl (points, factors);
}
