// Ipopt for Octave by its interface in C (Debian: coinor-libipopt-dev), built when it is first
// asked for (octave/+gs/+run/run_ipopt.m).
//
// [x, status, J, g, lambda, zl, zu, log, text, interrupted] = gsmbp_ipopt_solve (x0, low, high,
//   glow, ghigh, jac, hess, f, options, most, seconds): jac, hess: rows and columns of the entries
// that are not zero always (hess: lower triangle; [] where there is none), f (what, x, factor,
// lambda) gives "f", "grad", "g", "jac", "hess" as columns, or is the address of a gsmbp_program,
// options: a cell array of names and values, most: calls of f at new points at most, seconds: on
// the clock. log: a row for each iteration: J, infeasibility, dual infeasibility, mu, step;
// text: the last error of f; interrupted: by Ctrl-C, x is then the last iterate, the
// multipliers are NaN
#include <octave/oct.h>
#include <octave/parse.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "gsmbp_program.h"
#include "header_ipopt.h"

namespace
{
struct interruption { };   // thrown through Ipopt: an iteration of a large problem takes long

struct problem
{
  octave_value f;
  const gsmbp_program *native = nullptr;   // instead of F
  Matrix jac, hess;
  int n, m;
  double most, seconds;
  long points = 0;
  bool stopped = false;
  std::atomic<bool> interrupted;
  std::string text;
  std::vector<double> log, last;   // last: iterate
  std::mutex mutex;                // of last
  std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now ();

  problem (void) : interrupted (false) { }

  double spent (void) const
  { return std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count (); }

  // Ctrl-C, which Octave counts in a thread of its own
  static bool signalled (void)
  { return octave_interrupt_state > 0; }

  void leave_if_interrupted (void)
  {
    if (signalled ())
      interrupted = true;
    if (interrupted)
      throw interruption ();
  }

  // the numbers of a part; false: it has none here
  bool ask (gsmbp_part part, const double *x, int count, double *out, double factor = 1,
            const double *lambda = nullptr)
  {
    static const char *const words[] = { "f", "grad", "g", "jac", "hess" };
    leave_if_interrupted ();
    if (native)
      return ask_native (part, x, count, out, factor, lambda);
    return ask_octave (words[part], x, count, out, factor, lambda);
  }

  bool ask_native (gsmbp_part part, const double *x, int count, double *out, double factor = 1,
                   const double *lambda = nullptr)
  {
    return native->evaluate (native->data, part, x, factor, lambda, out)
           && std::all_of (out, out + count, [] (double a) { return std::fabs (a) <= 1e300; });
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
        interrupted = true;
        octave::interpreter::the_interpreter ()->recover_from_exception ();
      }
    leave_if_interrupted ();
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
    {
      {
        std::lock_guard<std::mutex> guard (p.mutex);
        p.last.assign (x, x + p.n);
      }
      return p.ask (GSMBP_JACOBIAN, x, count, out);
    }
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
  p.leave_if_interrupted ();
  if (p.points > p.most || p.spent () > p.seconds)
    p.stopped = true;
  return ! p.stopped;
}

// A problem at Ipopt, in a thread of its own where it is a program: MUMPS looks for no Ctrl-C, and
// puts a large one in order for seconds.  Who is interrupted does not wait for that; the thread
// ends at the next call.
struct task
{
  problem p;
  IpoptProblem nlp = nullptr;
  ColumnVector x, g, lambda, zl, zu;
  double J = 0;
  int status = 5;
  std::mutex mutex;
  std::condition_variable end;
  bool done = false;

  void solve (void)
  {
    try
      {
        status = IpoptSolve (nlp, x.fortran_vec (), g.fortran_vec (), &J, lambda.fortran_vec (),
                             zl.fortran_vec (), zu.fortran_vec (), &p);
      }
    catch (const interruption&)
      { }
    FreeIpoptProblem (nlp);
    std::lock_guard<std::mutex> guard (mutex);
    done = true;
    end.notify_all ();
  }

  bool wait (double seconds)
  {
    std::unique_lock<std::mutex> lock (mutex);
    return end.wait_for (lock, std::chrono::duration<double> (seconds), [this] { return done; });
  }

  // where it was interrupted: the last iterate, without multipliers
  octave_value_list last (const ColumnVector& x0)
  {
    ColumnVector z = x0, values (p.m, octave::numeric_limits<double>::NaN ()),
                 none (p.n, octave::numeric_limits<double>::NaN ());
    double goal = none(0);
    {
      std::lock_guard<std::mutex> guard (p.mutex);
      if (! p.last.empty ())
        std::copy (p.last.begin (), p.last.end (), z.fortran_vec ());
    }
    ColumnVector prices = values;
    if (p.native)
      {
        p.ask_native (GSMBP_GOAL, z.data (), 1, &goal);
        p.ask_native (GSMBP_EQUATIONS, z.data (), p.m, values.fortran_vec ());
      }
    return ovl (z, 5, goal, values, prices, none, none);
  }
};

// the thread that works, or one that was left alone
struct worker
{
  std::thread thread;
  std::shared_ptr<task> of;

  ~worker (void)
  {
    if (thread.joinable ())
      thread.join ();
  }

  // MUMPS is for one at a time
  void free (void)
  {
    while (thread.joinable ())
      if (of->wait (0.02))
        thread.join ();
      else
        octave_quit ();
  }

  // false: interrupted, or LATE, and perhaps left alone
  bool solve (const std::shared_ptr<task>& t, bool& late)
  {
    of = t;
    thread = std::thread ([t] { t->solve (); });
    while (! t->wait (0.01))
      {
        late = t->p.spent () > t->p.seconds + 0.05;
        if (! late && ! problem::signalled ())
          other_signals (t->p);
        else
          {
            t->p.interrupted = true;
            if (! t->wait (0.02))
              return false;
          }
      }
    thread.join ();
    return ! t->p.interrupted;
  }

  // SIGTERM: Octave throws what ends it
  static void other_signals (problem& p)
  {
    try
      {
        octave_quit ();
      }
    catch (...)
      {
        p.interrupted = true;
        throw;
      }
  }
};

worker the_worker;

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

DEFUN_DLD (gsmbp_ipopt_solve, args, , "Called by gs.run.run_ipopt; not for direct use.")
{
  if (args.length () != 11)
    error ("gsmbp_ipopt_solve: expected 11 arguments, found %d", int (args.length ()));
  the_worker.free ();
  const std::shared_ptr<task> t = std::make_shared<task> ();
  problem& p = t->p;
  const ColumnVector x0 = args(0).column_vector_value ();
  ColumnVector low = args(1).column_vector_value (), high = args(2).column_vector_value (),
               glow = args(3).column_vector_value (), ghigh = args(4).column_vector_value ();
  p.jac = args(5).matrix_value ();
  p.hess = args(6).matrix_value ();
  p.f = args(7);
  if (p.f.is_uint64_type ())
    p.native = reinterpret_cast<const gsmbp_program *> (
        std::uintptr_t (p.f.uint64_scalar_value ().value ()));
  p.n = int (x0.numel ());
  p.m = int (glow.numel ());
  p.most = args(9).double_value ();
  p.seconds = args(10).double_value ();
  t->nlp = CreateIpoptProblem (p.n, low.fortran_vec (), high.fortran_vec (), p.m,
                               glow.fortran_vec (), ghigh.fortran_vec (), Index (p.jac.rows ()),
                               Index (p.hess.rows ()), 1, value, constraints, gradient, jacobian,
                               hessian);
  if (! t->nlp)
    error ("Ipopt: the problem could not be set up");
  set_options (t->nlp, args(8).cell_value ());
  SetIntermediateCallback (t->nlp, after_each);
  t->x = x0;
  t->g = ColumnVector (p.m);
  t->lambda = ColumnVector (p.m, 0.0);
  t->zl = t->zu = ColumnVector (p.n, 0.0);
  bool whole = true, late = false;
  if (p.native)
    whole = the_worker.solve (t, late);
  else
    t->solve ();
  octave_value_list r;
  if (whole && ! p.interrupted)
    r = ovl (t->x, t->status, t->J, t->g, t->lambda, t->zl, t->zu);
  else
    {
      if (! late)
        octave::interpreter::the_interpreter ()->recover_from_exception ();
      r = t->last (x0);
    }
  octave_quit ();   // SIGTERM
  Matrix log (5, 0);
  if (whole)
    {
      log = Matrix (5, p.log.size () / 5);
      std::copy (p.log.begin (), p.log.end (), log.fortran_vec ());
    }
  r.append (log.transpose ());
  r.append (p.text);
  r.append (p.interrupted && ! late);
  return r;
}
