// Ipopt for Octave by its interface in C (Debian: coinor-libipopt-dev), built when it is first
// asked for (octave/private/gsmbp__ipopt.m).
//
// [x, status, J, g, lambda, zl, zu, log, text] = gsmbp_ipopt_solve (x0, low, high, glow, ghigh,
//   jac, hess, f, options, most, seconds): jac, hess: rows and columns of the entries that are not
// zero always (hess: lower triangle; [] where there is none), f (what, x, factor, lambda) gives
// "f", "grad", "g", "jac", "hess" as columns, or is the address of a gsmbp_program, options: a cell
// array of names and values, most: calls of f at new points at most, seconds: on the clock. log: a
// row for each iteration: J, infeasibility, dual infeasibility, mu, step; text: the last error of f
#include <octave/oct.h>
#include <octave/parse.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <coin/IpStdCInterface.h>

#include "gsmbp_program.h"

namespace
{
struct problem
{
  octave_value f;
  const gsmbp_program *native = nullptr;   // instead of F
  Matrix jac, hess;
  int n, m;
  double most, seconds;
  long points = 0;
  bool stopped = false, broken = false;
  std::string text;
  std::vector<double> log;
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now ();

  double spent (void) const
  { return std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count (); }

  // the numbers of a part; false: it has none here, or was interrupted
  bool ask (gsmbp_part part, const double *x, int count, double *out, double factor = 1,
            const double *lambda = nullptr)
  {
    static const char *const words[] = { "f", "grad", "g", "jac", "hess" };
    if (native)
      return native->evaluate (native->data, part, x, factor, lambda, out)
             && std::all_of (out, out + count, [] (double a) { return std::fabs (a) <= 1e300; });
    return ask_octave (words[part], x, count, out, factor, lambda);
  }

  bool ask_octave (const char *what, const double *x, int count, double *out, double factor,
                   const double *lambda)
  {
    try
      {
        ColumnVector z (n), l (lambda ? m : 0);
        std::copy (x, x + n, z.fortran_vec ());
        if (lambda)
          std::copy (lambda, lambda + m, l.fortran_vec ());
        octave_value_list r = octave::feval (f, ovl (what, z, factor, l), 1);
        Matrix v = r(0).matrix_value ();
        if (v.numel () != count)
          error ("expected %d numbers of %s, found %d", count, what, int (v.numel ()));
        for (int i = 0; i < count; i++)
          {
            out[i] = v(i);
            if (! (std::fabs (out[i]) <= 1e300))
              return false;
          }
        return true;
      }
    catch (const octave::execution_exception& e)
      {
        text = e.message ();
        octave::interpreter::the_interpreter ()->recover_from_exception ();
      }
    catch (const octave::interrupt_exception&)
      {
        stopped = broken = true;
        octave::interpreter::the_interpreter ()->recover_from_exception ();
      }
    return false;
  }
};

void
places (const Matrix& at, Index *rows, Index *cols)
{
  for (octave_idx_type k = 0; k < at.rows (); k++)
    {
      rows[k] = Index (at(k, 0));
      cols[k] = Index (at(k, 1));
    }
}

Bool
value (Index, Number *x, Bool fresh, Number *out, UserDataPtr data)
{
  problem& p = *static_cast<problem *> (data);
  p.points += fresh ? 1 : 0;
  return p.ask (GSMBP_GOAL, x, 1, out);
}

Bool
gradient (Index n, Number *x, Bool, Number *out, UserDataPtr data)
{
  return static_cast<problem *> (data)->ask (GSMBP_GRADIENT, x, n, out);
}

Bool
constraints (Index, Number *x, Bool fresh, Index m, Number *out, UserDataPtr data)
{
  problem& p = *static_cast<problem *> (data);
  p.points += fresh ? 1 : 0;
  return p.ask (GSMBP_EQUATIONS, x, m, out);
}

Bool
jacobian (Index, Number *x, Bool, Index, Index count, Index *rows, Index *cols, Number *out,
          UserDataPtr data)
{
  problem& p = *static_cast<problem *> (data);
  if (out)
    return p.ask (GSMBP_JACOBIAN, x, count, out);
  places (p.jac, rows, cols);
  return TRUE;
}

Bool
hessian (Index, Number *x, Bool, Number factor, Index, Number *lambda, Bool, Index count,
         Index *rows, Index *cols, Number *out, UserDataPtr data)
{
  problem& p = *static_cast<problem *> (data);
  if (out)
    return p.ask (GSMBP_HESSIAN, x, count, out, factor, lambda);
  places (p.hess, rows, cols);
  return TRUE;
}

Bool
after_each (Index, Index, Number J, Number primal, Number dual, Number mu, Number step, Number,
            Number, Number, Index, UserDataPtr data)
{
  problem& p = *static_cast<problem *> (data);
  for (double one : { J, primal, dual, mu, step })
    p.log.push_back (one);
  if (p.points > p.most || p.spent () > p.seconds)
    p.stopped = true;
  return ! p.stopped;
}

void
set_options (IpoptProblem nlp, const Cell& options)
{
  for (octave_idx_type i = 0; i + 1 < options.numel (); i += 2)
    {
      std::string name = options(i).string_value ();
      const octave_value& v = options(i + 1);
      char *word = const_cast<char *> (name.c_str ());
      bool good;
      if (v.is_string ())
        good = AddIpoptStrOption (nlp, word, const_cast<char *> (v.string_value ().c_str ()));
      else if (v.is_int32_type ())
        good = AddIpoptIntOption (nlp, word, v.int_value ());
      else
        good = AddIpoptNumOption (nlp, word, v.double_value ());
      if (! good)
        {
          FreeIpoptProblem (nlp);
          error ("Ipopt: option %s cannot be so", name.c_str ());
        }
    }
}
}

DEFUN_DLD (gsmbp_ipopt_solve, args, , "Called by gsmbp__ipopt; not for direct use.")
{
  if (args.length () != 11)
    error ("gsmbp_ipopt_solve: expected 11 arguments, found %d", int (args.length ()));
  problem p;
  ColumnVector x = args(0).column_vector_value (), low = args(1).column_vector_value (),
               high = args(2).column_vector_value (), glow = args(3).column_vector_value (),
               ghigh = args(4).column_vector_value ();
  p.jac = args(5).matrix_value ();
  p.hess = args(6).matrix_value ();
  p.f = args(7);
  if (p.f.is_uint64_type ())
    p.native = reinterpret_cast<const gsmbp_program *> (
        std::uintptr_t (p.f.uint64_scalar_value ().value ()));
  p.n = int (x.numel ());
  p.m = int (glow.numel ());
  p.most = args(9).double_value ();
  p.seconds = args(10).double_value ();
  IpoptProblem nlp
      = CreateIpoptProblem (p.n, low.fortran_vec (), high.fortran_vec (), p.m,
                            glow.fortran_vec (), ghigh.fortran_vec (), Index (p.jac.rows ()),
                            Index (p.hess.rows ()), 1, value, constraints, gradient, jacobian,
                            hessian);
  if (! nlp)
    error ("Ipopt: the problem could not be set up");
  set_options (nlp, args(8).cell_value ());
  SetIntermediateCallback (nlp, after_each);
  ColumnVector g (p.m), lambda (p.m, 0.0), zl (p.n, 0.0), zu (p.n, 0.0);
  double J = 0;
  int status = IpoptSolve (nlp, x.fortran_vec (), g.fortran_vec (), &J, lambda.fortran_vec (),
                           zl.fortran_vec (), zu.fortran_vec (), &p);
  FreeIpoptProblem (nlp);
  if (p.broken)
    throw octave::interrupt_exception ();
  Matrix log (5, p.log.size () / 5);
  std::copy (p.log.begin (), p.log.end (), log.fortran_vec ());
  return ovl (x, status, J, g, lambda, zl, zu, log.transpose (), p.text);
}
