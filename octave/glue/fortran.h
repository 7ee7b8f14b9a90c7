// Numbers in double or quad precision and calls of Fortran subroutines; nothing of Octave.
#pragma once

#include <algorithm>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "gsmbp/failures.h"
#include "gsmbp/options.h"
#include "gsmbp/statistics.h"
#include "gsmbp_scene.h"

typedef gs_value number;

typedef std::vector<number> reals;

// numbers that are zero at first: memory that nobody writes to is not touched
template <typename T>
class zeros
{
public:

  explicit zeros (std::size_t n = 0)
    : m_n (n), m_all (static_cast<T *> (std::calloc (n + 1, sizeof (T))), std::free)
  {
    if (! m_all)
      throw std::bad_alloc ();
  }

  std::size_t size (void) const { return m_n; }
  T *data (void) const { return m_all.get (); }
  T *begin (void) const { return data (); }
  T *end (void) const { return data () + m_n; }
  T& operator[] (std::size_t k) const { return m_all.get ()[k]; }

private:

  std::size_t m_n;
  std::unique_ptr<T, void (*) (void *)> m_all;
};
typedef zeros<number> zero_reals;

// how often the next call is repeated to be timed (0: once, untimed), and the time of all
static long the_repeats = 0;
static double the_seconds = 0;

// A Fortran subroutine: the address carries no types, the call states them.
struct fortran
{
  gsmbp_sub f;
  template <typename... T> void operator () (T... a) const
  {
    // volatile: the compiler may not look behind the pointer, whose declared type has no arguments
    gsmbp_sub volatile hidden = f;
    auto call = reinterpret_cast<void (*) (T...)> (hidden);
    if (the_repeats == 0)
      return call (a...);
    auto begin = std::chrono::steady_clock::now ();
    for (long i = 0; i < the_repeats; i++)
      call (a...);
    the_seconds
        = std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count ();
  }
};

extern "C"
{
  void gskkt_ (void);
  void gsacc_ (void);
  void gsspd_ (void);
  void gsleq_ (void);
}

static const gsmbp_scene& S = gsmbp_the_scene;

// an emitted subroutine by the end of its name, a null pointer where there is none
static inline const gsmbp_routine *
emitted (const char *name)
{
  for (const gsmbp_routine *r = S.routines; r->name; r++)
    if (std::strcmp (name, r->name) == 0)
      return r;
  return nullptr;
}

static inline reals
room (int n)
{
  return reals (std::max (1, n), number (0));
}

// whether N numbers are finite, none above what the emitted subroutines take
static inline bool
fine (const number *x, int n)
{
  return std::all_of (x, x + n, [] (number a) { return std::fabs (double (a)) <= 1e300; });
}
