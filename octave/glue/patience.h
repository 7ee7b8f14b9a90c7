// Runs that are ended from outside, by Ctrl-C or after a wall time, with the rows so far, and that
// tell a terminal how far they are.  Octave takes SIGINT in a thread of its own and counts it in
// octave_interrupt_state; of other signals, SIGTERM, octave_signal_caught tells.  These and one
// word are all that a run looks at, before each step.
#pragma once

#include "numbers.h"

#include <atomic>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>
#include <unistd.h>

class patience
{
public:

  // INFO
  enum reason { none = 0, interrupted = GS_INTERRUPTED, timed_out = GS_TIMED_OUT, failed };

  // what runs from FIRST to LAST (time or number of runs); WHAT: its unit
  patience (double timeout, double first, double last, const char *what);
  ~patience (void);
  patience (const patience&) = delete;

  reason why (void) const { return reason (m_why.load ()); }
  void stop (reason why);
  void reached (double at) { m_at = at; }
  // before a step: is it over?
  bool look (double t);
  // behind the runs: what Octave ends by is thrown; a Ctrl-C that ended them is dealt with; one
  // within half a second of such a one is left to Octave, so that whatever called them ends, too
  void settle (void);

  static bool asked (void)
  {
    return word.load (std::memory_order_relaxed) != 0 || signalled () || octave_signal_caught;
  }
  // whether a Ctrl-C came within half a second of the last one
  static bool again (void)
  {
    static clock::time_point last = clock::now () - std::chrono::hours (1);
    const clock::time_point before = last;
    last = clock::now ();
    return last - before <= std::chrono::milliseconds (500);
  }
  static bool signalled (void)
  {
    return octave_interrupt_state > 0;   // sig_atomic_t, std::atomic<int> since Octave 9
  }

  const bool in_time;   // the time of the run is how far it is

private:

  typedef std::chrono::steady_clock clock;
  enum { tell = 1, leave };

  double seconds (void) const
  {
    return std::chrono::duration<double> (clock::now () - m_begin).count ();
  }
  void watch (void);
  void show (void);
  void other_signals (void);

  static std::atomic<int> word;   // not 0: look

  patience *m_outer;
  const std::thread::id m_owner;   // Octave's
  std::exception_ptr m_end_of_octave;
  std::atomic<int> m_why;
  std::atomic<double> m_at;
  clock::time_point m_begin;
  double m_timeout, m_first, m_last;
  const char *m_what;
  bool m_terminal, m_shown, m_over;
  std::mutex m_mutex;
  std::condition_variable m_end;
  std::thread m_watcher;
};

// A Ctrl-C of its own after so many seconds (Inf: never), until it is switched off
class alarm_clock
{
public:

  explicit alarm_clock (double seconds) : m_off (false), m_rang (false)
  {
    if (seconds < 1e9)
      m_thread = std::thread (&alarm_clock::wait, this, std::max (0.0, seconds));
  }
  ~alarm_clock (void) { off (); }
  alarm_clock (const alarm_clock&) = delete;

  bool rang (void) const { return m_rang; }

  void off (void)
  {
    if (! m_thread.joinable ())
      return;
    {
      std::lock_guard<std::mutex> guard (m_mutex);
      m_off = true;
    }
    m_end.notify_one ();
    m_thread.join ();
    if (m_rang)
      octave_interrupt_state = 0;
  }

private:

  void wait (double seconds)
  {
    std::unique_lock<std::mutex> lock (m_mutex);
    m_rang = ! m_end.wait_for (lock, std::chrono::duration<double> (seconds),
                               [this] { return m_off; });
    if (m_rang)
      octave_signal_caught = octave_interrupt_state = 1;
  }

  bool m_off, m_rang;
  std::mutex m_mutex;
  std::condition_variable m_end;
  std::thread m_thread;
};

std::atomic<int> patience::word (0);
static patience *the_patience = nullptr;

patience::patience (double timeout, double first, double last, const char *what)
  : in_time (*what == 's'), m_outer (the_patience),
    m_owner (std::this_thread::get_id ()), m_why (none), m_at (first), m_begin (clock::now ()),
    m_timeout (timeout), m_first (first), m_last (last), m_what (what), m_terminal (isatty (2)),
    m_shown (false), m_over (false)
{
  word = 0;
  the_patience = this;
  if (m_timeout > 0 || m_terminal)
    m_watcher = std::thread (&patience::watch, this);
}

patience::~patience (void)
{
  if (m_watcher.joinable ())
    {
      {
        std::lock_guard<std::mutex> guard (m_mutex);
        m_over = true;
      }
      m_end.notify_one ();
      m_watcher.join ();
    }
  if (m_shown)
    std::fputs ("\r\033[K", stderr);
  the_patience = m_outer;
  word = m_outer && m_outer->why () != none ? leave : 0;
}

void
patience::stop (reason why)
{
  int before = none;
  m_why.compare_exchange_strong (before, why);
  word = leave;
}

bool
patience::look (double t)
{
  if (signalled ())
    stop (interrupted);
  else if (octave_signal_caught && std::this_thread::get_id () == m_owner)
    other_signals ();
  if (in_time)
    m_at = t;
  int told = tell;
  word.compare_exchange_strong (told, 0);
  return why () != none;
}

// what Octave has to do: for SIGTERM it throws, which ends it
void
patience::other_signals (void)
{
  try
    {
      OCTAVE_QUIT;
    }
  catch (const octave::interrupt_exception&)
    {
      octave::interpreter::the_interpreter ()->recover_from_exception ();
      stop (interrupted);
    }
  catch (...)
    {
      m_end_of_octave = std::current_exception ();
      stop (failed);
    }
}

void
patience::settle (void)
{
  if (m_end_of_octave)
    std::rethrow_exception (m_end_of_octave);
  if (why () != interrupted)
    return;
  if (again ())
    octave_signal_caught = octave_interrupt_state = 1;
  else
    octave_interrupt_state = 0;
  OCTAVE_QUIT;
}

// in a thread of its own, where there is a wall time or a terminal
void
patience::watch (void)
{
  double show_at = 2;
  std::unique_lock<std::mutex> lock (m_mutex);
  while (! m_over)
    {
      double next = std::min (m_terminal ? show_at : HUGE_VAL,
                              m_timeout > 0 && why () == none ? m_timeout : HUGE_VAL);
      double wait = std::max (0.001, std::min (3600.0, next - seconds ()));
      m_end.wait_for (lock, std::chrono::duration<double> (wait));
      if (m_over)
        return;
      if (m_timeout > 0 && seconds () >= m_timeout)
        stop (timed_out);
      if (m_terminal && seconds () >= show_at)
        {
          show ();
          show_at = seconds () + 0.5;
        }
    }
}

void
patience::show (void)
{
  double at = m_at, done = (at - m_first) / (m_last - m_first);
  std::fprintf (stderr, "\r%s: %.4g of %.6g %s", S.name, at, m_last, m_what);
  if (done > 0)
    std::fprintf (stderr, ", %.0f s left", std::ceil (seconds () * (1 - done) / done));
  std::fputs ("\033[K", stderr);
  std::fflush (stderr);
  m_shown = true;
  int quiet = 0;
  word.compare_exchange_strong (quiet, tell);
}
