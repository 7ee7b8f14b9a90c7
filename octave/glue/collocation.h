// The programs of optimal motions (gsmbp_collocate) that are kept, the last ones, by the numbers
// that they were given.
#pragma once

#include "ipopt.h"
#include "motion_problem.h"

struct kept_program
{
  explicit kept_program (arguments& a)
    : problem (a), about (*S.about), c (nullptr), sizes (), program ()
  {
    about.pre = gsmbp_constants;
    about.ncst = S.ncst;
    about.npar = S.npar;
    const int method = a.integer_within ("method", GS_RADAU_IIA, GS_LOBATTO);
    const Matrix breaks = a.value ("breaks").matrix_value ();
    std::vector<int> phase;
    std::vector<double> begin, end;
    for (octave_idx_type k = 0; k < breaks.columns (); k++)
      {
        phase.push_back (int (breaks(0, k)) - 1);
        begin.push_back (breaks(1, k));
        end.push_back (breaks(2, k));
      }
    for (const char *name : { "dae", "daj", "dah" })
      routine (name);
    const gs_mesh mesh = { method, int (phase.size ()), phase.data (), begin.data (),
                           end.data () };
    c = gs_program_new (&about, &problem.get (), &mesh);
    if (! c)
      throw std::bad_alloc ();
    sizes = gs_program_size (c);
    program.data = c;
    program.evaluate = gs_program_evaluate;
  }
  ~kept_program (void) { gs_program_free (c); }
  kept_program (const kept_program&) = delete;

  int size_of (int part) const
  {
    const int all[] = { 1, sizes.n, sizes.m, sizes.jacobian, sizes.hessian, sizes.functions };
    return all[part];
  }

  // rows and columns of the entries, from 1
  Matrix places (int part) const
  {
    const int n = size_of (part);
    std::vector<int> rows (n + 1), columns (n + 1);
    gs_program_places (c, part, rows.data (), columns.data ());
    Matrix m (n, 2);
    for (int k = 0; k < n; k++)
      {
        m(k, 0) = rows[k] + 1;
        m(k, 1) = columns[k] + 1;
      }
    return m;
  }

  int number;
  motion_problem problem;
  gs_description about;
  gs_program *c;
  gs_program_sizes sizes;
  gs_nlp program;
};

static std::list<kept_program> the_programs;

// (constants, parameters, problem, method, breaks): the number of the program, the places of its
// Jacobian and Hessian
static octave_value_list
do_program (arguments& a, int)
{
  const int most = 20;
  static int count = 0;
  the_programs.emplace_back (a);
  kept_program& k = the_programs.back ();
  k.number = ++count;
  if (the_programs.size () > most)
    the_programs.pop_front ();
  return ovl (count, k.places (GS_JACOBIAN), k.places (GS_HESSIAN));
}

static kept_program&
program_of (arguments& a)
{
  const int number = a.integer_within ("program", 1, 2000000000);
  for (kept_program& k : the_programs)
    if (k.number == number)
      return k;
  error ("%s: there is no program %d any more", a.who ().c_str (), number);
}

// (number): the address of its gs_nlp
static octave_value_list
do_program_at (arguments& a, int)
{
  uint64NDArray at (dim_vector (1, 1));
  at(0) = octave_uint64 (reinterpret_cast<std::uintptr_t> (&program_of (a).program));
  return ovl (at);
}

// (number, part, point, factor, multipliers): its numbers
static octave_value_list
do_program_part (arguments& a, int)
{
  kept_program& k = program_of (a);
  const int part = a.integer_within ("part", GS_GOAL, GS_FUNCTIONS);
  const Matrix z = a.matrix ("point", k.sizes.n, 1);
  const double factor = double (a.scalar ("factor"));
  const Matrix lambda = a.matrix ("multipliers", part == GS_HESSIAN ? k.sizes.m : -1, 1);
  Matrix out (k.size_of (part), 1, no_number);
  if (! gs_program_evaluate (k.c, part, z.data (), factor, lambda.data (), out.fortran_vec ()))
    out.fill (no_number);
  return ovl (out);
}

// (number, repetitions, point, multipliers): the least seconds that all parts take at a new point
static octave_value_list
do_program_time (arguments& a, int)
{
  kept_program& k = program_of (a);
  const int repetitions = a.integer_within ("repetitions", 1, 1000000);
  Matrix z = a.matrix ("point", k.sizes.n, 1);
  const Matrix lambda = a.matrix ("multipliers", k.sizes.m, 1);
  std::vector<double> out (std::max ({ k.sizes.jacobian, k.sizes.hessian, k.sizes.n, k.sizes.m }));
  double least = 1e300;
  for (int i = 0; i < repetitions; i++)
    {
      z(0) += 1e-3;
      auto begin = std::chrono::steady_clock::now ();
      for (int part = GS_GOAL; part <= GS_HESSIAN; part++)
        gs_program_evaluate (k.c, part, z.data (), 1, lambda.data (), out.data ());
      least = std::min (least, std::chrono::duration<double> (std::chrono::steady_clock::now ()
                                                             - begin).count ());
    }
  return ovl (least);
}
