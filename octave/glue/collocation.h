// The programs of optimal motions (gsmbp_collocate) that are kept, the last ones, by the numbers
// that they were given; gsmbp_ipopt_solve has one by its place.
#pragma once

#include "transcription_parts.h"

#include <list>

struct kept_program
{
  int number;
  transcription t;
  gsmbp_program program;
};

static std::list<kept_program> the_programs;

extern "C" int
gsmbp_evaluate_program (void *data, int part, const double *z, double factor,
                        const double *lambda, double *out)
{
  return static_cast<transcription *> (data)->evaluate (part, z, factor, lambda, out);
}

// (constants, transcription): the number of the program
static octave_value_list
do_program (arguments& a, int)
{
  const int most = 20;
  static int count = 0;
  const reals cst = a.constants ();
  the_programs.push_back ({ ++count,
                            transcription (a.value ("program").scalar_map_value (), cst),
                            gsmbp_program () });
  kept_program& k = the_programs.back ();
  k.program.data = &k.t;
  k.program.evaluate = gsmbp_evaluate_program;
  if (the_programs.size () > most)
    the_programs.pop_front ();
  return ovl (count);
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

// (number): where the program stands, for gsmbp_ipopt_solve
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
  transcription& t = program_of (a).t;
  const int part = a.integer_within ("part", GSMBP_GOAL, GSMBP_FUNCTIONS);
  Matrix z = a.matrix ("point", t.unknowns (), 1);
  const double factor = double (a.scalar ("factor"));
  Matrix lambda = a.matrix ("multipliers", part == GSMBP_HESSIAN ? t.equations () : -1, 1);
  Matrix out (t.size_of (part), 1, no_number);
  if (! t.evaluate (part, z.data (), factor, lambda.data (), out.fortran_vec ()))
    out.fill (no_number);
  return ovl (out);
}

// (number, repetitions, point, multipliers): the least seconds that all parts take at a new point
static octave_value_list
do_program_time (arguments& a, int)
{
  transcription& t = program_of (a).t;
  const int repetitions = a.integer_within ("repetitions", 1, 1000000);
  Matrix z = a.matrix ("point", t.unknowns (), 1), lambda = a.matrix ("multipliers",
                                                                     t.equations (), 1);
  std::vector<double> out (std::max (t.size_of (GSMBP_JACOBIAN),
                                     std::max (t.size_of (GSMBP_HESSIAN), t.unknowns ())));
  double least = 1e300;
  for (int k = 0; k < repetitions; k++)
    {
      z(0) += 1e-3;
      auto begin = std::chrono::steady_clock::now ();
      for (int part = GSMBP_GOAL; part <= GSMBP_HESSIAN; part++)
        t.evaluate (part, z.data (), 1, lambda.data (), out.data ());
      least = std::min (least, std::chrono::duration<double> (std::chrono::steady_clock::now ()
                                                             - begin).count ());
    }
  return ovl (least);
}
