// Optimal motions (gsmbp_collocate), by host/collocation/collocation.h.
#pragma once

#include "solvers.h"
#include "motion_problem.h"
#include "host/collocation/collocation.h"

static gs_description
described_with_constants (void)
{
  gs_description about = *S.about;
  about.pre = gsmbp_constants;
  about.ncst = S.ncst;
  about.npar = S.npar;
  for (const char *name : { "dae", "daj", "dah" })
    routine (name);
  return about;
}

// a mesh of rows [phase; begin; end]
struct given_mesh
{
  explicit given_mesh (arguments& a)
  {
    const int method = a.integer_within ("method", GS_RADAU_IIA, GS_LOBATTO);
    const Matrix breaks = a.value ("breaks").matrix_value ();
    for (octave_idx_type k = 0; k < breaks.columns (); k++)
      {
        phase.push_back (int (breaks(0, k)) - 1);
        begin.push_back (breaks(1, k));
        end.push_back (breaks(2, k));
      }
    mesh = { method, int (phase.size ()), phase.data (), begin.data (), end.data () };
  }
  given_mesh (const given_mesh&) = delete;

  std::vector<int> phase;
  std::vector<double> begin, end;
  gs_mesh mesh;
};

// the least seconds that all parts of a program take at a new point
static double
program_time (gs_program *c, Matrix z, const Matrix& lambda)
{
  const gs_program_sizes n = gs_program_size (c);
  std::vector<double> out (std::max ({ n.jacobian, n.hessian, n.n, n.m }) + 1);
  double least = 1e300;
  for (int i = 0; i < 200; i++)
    {
      z(0) += 1e-3;
      const double begin = gs_wall_clock ();
      for (int part = GS_GOAL; part <= GS_HESSIAN; part++)
        gs_program_evaluate (c, part, z.data (), 1, lambda.data (), out.data ());
      least = std::min (least, gs_wall_clock () - begin);
    }
  return least;
}

// For tests: (constants, parameters, problem, method, breaks, part, point, factor, multipliers):
// the numbers of the part; of the Jacobian and the Hessian their rows and columns, too.  Part -1:
// the unknowns, the equations; -2: program_time
static octave_value_list
do_program (arguments& a, int)
{
  const motion_problem problem (a);
  const given_mesh given (a);
  const gs_description about = described_with_constants ();
  const std::unique_ptr<gs_program, void (*) (gs_program *)> c (
      gs_program_new (&about, &problem.get (), &given.mesh), gs_program_free);
  if (! c)
    throw std::bad_alloc ();
  const gs_program_sizes n = gs_program_size (c.get ());
  const int part = a.integer_within ("part", -2, GS_FUNCTIONS);
  if (part == -1)
    return ovl (n.n, n.m);
  const Matrix z = a.matrix ("point", n.n, 1);
  const double factor = double (a.scalar ("factor"));
  const Matrix lambda = a.matrix ("multipliers", part == GS_HESSIAN ? n.m : -1, 1);
  if (part == -2)
    return ovl (program_time (c.get (), z, lambda));
  const int sizes[] = { 1, n.n, n.m, n.jacobian, n.hessian, n.functions };
  Matrix out (sizes[part], 1, no_number), places (sizes[part], 2);
  gs_program_evaluate (c.get (), part, z.data (), factor, lambda.data (), out.fortran_vec ());
  if (part != GS_JACOBIAN && part != GS_HESSIAN)
    return ovl (out);
  std::vector<int> rows (sizes[part] + 1), columns (sizes[part] + 1);
  gs_program_places (c.get (), part, rows.data (), columns.data ());
  for (int k = 0; k < sizes[part]; k++)
    {
      places(k, 0) = rows[k] + 1;
      places(k, 1) = columns[k] + 1;
    }
  return ovl (out, places);
}

// a struct array; FIELD gives the value of a field of element K
template <typename F>
static octave_map
rows_of (int n, std::initializer_list<const char *> names, F field)
{
  octave_map m (dim_vector (1, n));
  for (const char *name : names)
    {
      Cell c (1, n);
      for (int k = 0; k < n; k++)
        c(k) = field (k, std::string (name));
      m.assign (name, c);
    }
  return m;
}

static Matrix
rows_from (const double *x, int rows, int n)
{
  Matrix m (n, rows);
  for (int q = 0; q < n; q++)
    for (int j = 0; j < rows; j++)
      m(q, j) = x[rows * q + j];
  return m;
}

static octave_value
bound_field (const gs_active_bound& one, const std::string& name)
{
  static const char *const words[] = { "state", "input", "output", "time", "parameter" };
  if (name == "of")
    return words[one.of];
  if (name == "bound")
    return one.largest ? "largest" : "least";
  return name == "number" ? one.number + 1.0 : name == "value" ? one.value
         : name == "from" ? one.from : name == "until" ? one.until : one.multiplier;
}

static octave_value
arc_field (const gs_singular_arc& one, const std::string& name)
{
  return name == "input" ? one.input + 1.0 : name == "from" ? one.from
         : name == "until" ? one.until : name == "ringing" ? one.ringing : one.weight;
}

static octave_value
mesh_field (const gs_mesh_report& one, const std::string& name)
{
  if (name == "ended")
    return one.ended;
  return name == "intervals" ? one.intervals : name == "iterations" ? one.iterations : one.error;
}

static octave_scalar_map
motion_map (const gs_motion& r, int nunknown)
{
  octave_scalar_map s;
  const int n = r.n;
  s.assign ("t", rows_from (r.t, 1, n));
  s.assign ("x", rows_from (r.x, S.nx, n));
  s.assign ("v", rows_from (r.v, S.nv, n));
  s.assign ("ud", rows_from (r.ud, S.nu, n));
  s.assign ("lambda", rows_from (r.lambda, S.nlam, n));
  s.assign ("y", rows_from (r.y, S.ny, n));
  s.assign ("costates", rows_from (r.costates, S.nx, n));
  s.assign ("goal", r.goal);
  s.assign ("T", r.duration);
  s.assign ("error", r.error);
  s.assign ("unknown", result (r.unknown, nunknown, 1));
  s.assign ("breaks", result (r.breaks, 1, r.pieces + 1));
  s.assign ("input", result (r.input, S.nv * r.pieces, 3));
  s.assign ("motion", result (r.motion, r.nplanned * (n - 1), 6));
  s.assign ("planned", r.nplanned);
  s.assign ("switches", result (r.switches, r.nswitches, 1));
  s.assign ("active", rows_of (r.nactive, { "of", "number", "bound", "value", "from", "until",
                                            "multiplier" },
                               [&] (int k, const std::string& f)
                               { return bound_field (r.active[k], f); }));
  s.assign ("singular", rows_of (r.narcs, { "input", "from", "until", "ringing", "weight" },
                                 [&] (int k, const std::string& f)
                                 { return arc_field (r.arcs[k], f); }));
  s.assign ("meshes", rows_of (r.nmeshes, { "intervals", "iterations", "error", "ended" },
                               [&] (int k, const std::string& f)
                               { return mesh_field (r.meshes[k], f); }));
  s.assign ("solved", bool (r.solved));
  s.assign ("ended", r.ended);
  s.assign ("stopped", r.stopped == GS_INTERRUPTED ? "interrupted"
                       : r.stopped == GS_TIMED_OUT ? "timeout" : "");
  return s;
}

// (constants, parameters, problem, library of Ipopt, options, guess: t, x, v, T, start,
// actuated): what is found, as host/collocation/collocation.h has it
static octave_value_list
do_collocate (arguments& a, int)
{
  const motion_problem problem (a);
  the_solver = solver_of (a.value ("library").string_value (), "gs_ipopt");
  const octave_scalar_map o = a.value ("options").scalar_map_value ();
  const octave_scalar_map g = a.value ("guess").scalar_map_value ();
  const gs_description about = described_with_constants ();
  auto of = [&] (const char *name) { return o.contents (name).double_value (); };
  auto array = [&] (const char *name) { return g.contents (name).matrix_value (); };
  const Matrix t = array ("t"), x = array ("x"), v = array ("v"),
               start = array ("start"), actuated = array ("actuated");
  std::vector<int> independent;
  for (octave_idx_type k = 0; k < actuated.numel (); k++)
    independent.push_back (int (actuated(k)) - 1);
  const gs_motion_guess guess
      = { int (t.numel ()), t.data (), x.data (), v.data (), g.contents ("T").double_value (),
          start.data (), int (independent.size ()), independent.data () };
  const gs_motion_options options
      = { o.contents ("method").string_value () == "lobatto" ? GS_LOBATTO : GS_RADAU_IIA,
          int (of ("intervals")), of ("accuracy"), int (of ("refinements")),
          o.contents ("polish").bool_value (), of ("regularize"), of ("tolerance"),
          of ("seconds"), int (of ("iterations")), of ("timeout"), gsmbp_solve_apart, nullptr,
          nullptr };
  gs_motion r;
  const int bad = gs_collocate (&about, &problem.get (), &guess, &options, &r);
  the_worker.settle ();
  if (bad == 1)
    throw std::bad_alloc ();
  if (bad)
    error ("gsmbp_collocate: %s: %s", S.name, r.ended);
  const octave_scalar_map s = motion_map (r, about.nunknown);
  gs_motion_free (&r);
  return ovl (s);
}
