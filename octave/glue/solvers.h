// Solvers (host/ipopt, host/nlopt) for Octave: libraries that are built when they are first asked
// for.
#pragma once

#include <dlfcn.h>
#include <map>

#include "arguments.h"
#include "patience.h"
#include "host/collocation/nlp.h"

static gs_nlp_solver *
solver_of (const std::string& library, const char *name)
{
  static std::map<std::string, gs_nlp_solver *> loaded;
  if (loaded.count (library))
    return loaded[library];
  void *handle = dlopen (library.c_str (), RTLD_NOW | RTLD_LOCAL);
  void *address = handle ? dlsym (handle, name) : nullptr;
  if (! address)
    error ("%s: cannot load %s: %s", S.name, library.c_str (), dlerror ());
  return loaded[library] = reinterpret_cast<gs_nlp_solver *> (address);
}

// arrays of a result
struct nlp_arrays
{
  std::vector<double> x, zl, zu, g, lambda;
  gs_nlp_result r;

  nlp_arrays (int n, int m)
    : x (n + 1), zl (n + 1), zu (n + 1), g (m + 1), lambda (m + 1), r (gs_nlp_result ())
  {
    r.x = x.data ();
    r.zl = zl.data ();
    r.zu = zu.data ();
    r.g = g.data ();
    r.lambda = lambda.data ();
  }
};

// A program of C at Ipopt, in a thread of its own: MUMPS looks for no Ctrl-C, and puts a large one
// in order for seconds.  Who is interrupted does not wait for that; the thread ends at its next
// call.  It has all that it reads, but for the program, which it evaluates under a lock until it is
// to leave.
class nlp_task
{
public:

  nlp_task (gs_nlp_solver *solver, const gs_nlp& p, const gs_nlp_options& o)
    : m_solver (solver), m_given (p), m_p (p), m_o (o), m_x0 (p.x0, p.x0 + p.n),
      m_low (p.low, p.low + p.n), m_high (p.high, p.high + p.n), m_glow (p.glow, p.glow + p.m),
      m_ghigh (p.ghigh, p.ghigh + p.m), m_last (m_x0), m_arrays (p.n, p.m)
  {
    const int *const lists[] = { p.jac_rows, p.jac_columns, p.hess_rows, p.hess_columns };
    for (int k = 0; k < 4; k++)
      m_places[k].assign (lists[k], lists[k] + (k < 2 ? p.jacobian : std::max (0, p.hessian)));
    m_p.x0 = m_x0.data ();
    m_p.low = m_low.data ();
    m_p.high = m_high.data ();
    m_p.glow = m_glow.data ();
    m_p.ghigh = m_ghigh.data ();
    m_p.jac_rows = m_places[0].data ();
    m_p.jac_columns = m_places[1].data ();
    m_p.hess_rows = m_places[2].data ();
    m_p.hess_columns = m_places[3].data ();
    m_p.data = this;
    m_p.evaluate = evaluate;
    m_o.ask = ask;
    m_o.asked = this;
  }

  void run (void)
  {
    m_bad = m_solver (&m_p, &m_o, &m_arrays.r);
    std::lock_guard<std::mutex> guard (m_mutex);
    m_done = true;
    m_end.notify_all ();
  }

  bool wait (double seconds)
  {
    std::unique_lock<std::mutex> lock (m_mutex);
    return m_end.wait_for (lock, std::chrono::duration<double> (seconds),
                           [this] { return m_done; });
  }

  void leave (void)
  {
    std::lock_guard<std::mutex> guard (m_mutex);
    m_leave = true;
  }

  bool left (void) const { return m_leave; }

  bool late (void) const
  {
    return std::chrono::duration<double> (std::chrono::steady_clock::now () - m_begin).count ()
           > m_o.seconds + 0.05;
  }

  // into the arrays of R; where it was left, the last iterate, without multipliers
  int take (bool whole, gs_nlp_result& r)
  {
    std::lock_guard<std::mutex> guard (m_mutex);
    gs_nlp_result own = r;
    if (whole)
      {
        own = m_arrays.r;
        own.x = r.x; own.zl = r.zl; own.zu = r.zu; own.g = r.g; own.lambda = r.lambda;
        std::copy_n (m_arrays.x.data (), m_p.n, r.x);
        std::copy_n (m_arrays.zl.data (), m_p.n, r.zl);
        std::copy_n (m_arrays.zu.data (), m_p.n, r.zu);
        std::copy_n (m_arrays.g.data (), m_p.m, r.g);
        std::copy_n (m_arrays.lambda.data (), m_p.m, r.lambda);
        r = own;
        return m_bad;
      }
    std::copy_n (m_last.data (), m_p.n, r.x);
    std::fill_n (r.zl, m_p.n, no_number);
    std::fill_n (r.zu, m_p.n, no_number);
    std::fill_n (r.g, m_p.m, no_number);
    std::fill_n (r.lambda, m_p.m, no_number);
    r.goal = no_number;
    m_given.evaluate (m_given.data, GS_GOAL, r.x, 1, nullptr, &r.goal);
    m_given.evaluate (m_given.data, GS_EQUATIONS, r.x, 1, nullptr, r.g);
    r.status = 5;
    r.solved = r.infeasible = 0;
    r.limit = r.interrupted = 1;
    gs_nlp_say_limit (&m_o, &r);
    return 0;
  }

private:

  static int ask (void *data) { return static_cast<nlp_task *> (data)->m_leave; }

  static int evaluate (void *data, int part, const double *z, double factor,
                       const double *lambda, double *out)
  {
    nlp_task& t = *static_cast<nlp_task *> (data);
    std::lock_guard<std::mutex> guard (t.m_mutex);
    if (t.m_leave)
      return 0;
    if (part == GS_JACOBIAN)
      t.m_last.assign (z, z + t.m_p.n);
    return t.m_given.evaluate (t.m_given.data, part, z, factor, lambda, out);
  }

  gs_nlp_solver *m_solver;
  const gs_nlp m_given;
  gs_nlp m_p;
  gs_nlp_options m_o;
  std::vector<double> m_x0, m_low, m_high, m_glow, m_ghigh, m_last;
  std::vector<int> m_places[4];
  nlp_arrays m_arrays;
  int m_bad = 0;
  bool m_done = false;
  std::atomic<bool> m_leave { false };
  std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now ();
  std::mutex m_mutex;
  std::condition_variable m_end;
};

// the thread that works, or one that was left alone
class nlp_worker
{
public:

  ~nlp_worker (void)
  {
    if (m_thread.joinable ())
      m_thread.join ();
  }

  // MUMPS is for one at a time: an interrupt ends this, too
  bool free (void)
  {
    while (m_thread.joinable ())
      if (m_of->wait (0.02))
        m_thread.join ();
      else if (! quiet ())
        return false;
    return true;
  }

  // false: interrupted, or LATE, and perhaps left alone
  bool solve (const std::shared_ptr<nlp_task>& t, bool& late)
  {
    m_of = t;
    m_thread = std::thread ([t] { t->run (); });
    while (! t->wait (0.01))
      {
        late = t->late ();
        if (late || patience::signalled () || ! quiet ())
          {
            t->leave ();
            if (! t->wait (0.02))
              return false;
          }
      }
    m_thread.join ();
    return ! t->left ();
  }

  // what ended Octave meanwhile, SIGTERM, is thrown
  void settle (void)
  {
    const std::exception_ptr end = m_end_of_octave;
    m_end_of_octave = nullptr;
    if (end)
      std::rethrow_exception (end);
  }

private:

  // no exception crosses C
  bool quiet (void)
  {
    if (m_end_of_octave)
      return false;
    try
      {
        octave_quit ();
        return true;
      }
    catch (const octave::interrupt_exception&)
      {
        octave::interpreter::the_interpreter ()->recover_from_exception ();
      }
    catch (...)
      {
        m_end_of_octave = std::current_exception ();
      }
    return false;
  }

  std::thread m_thread;
  std::shared_ptr<nlp_task> m_of;
  std::exception_ptr m_end_of_octave;
};

static nlp_worker the_worker;
static gs_nlp_solver *the_solver = nullptr;

// a gs_nlp_solver: the_solver in a thread of its own
extern "C" int
gsmbp_solve_apart (const gs_nlp *p, const gs_nlp_options *o, gs_nlp_result *r)
{
  bool late = false, whole = false;
  const auto t = std::make_shared<nlp_task> (the_solver, *p, *o);
  if (the_worker.free ())
    whole = the_worker.solve (t, late);
  else
    t->leave ();
  if (! whole && ! late)
    octave::interpreter::the_interpreter ()->recover_from_exception ();
  const int bad = t->take (whole, *r);
  if (! whole)
    r->interrupted = ! late;
  return bad;
}
