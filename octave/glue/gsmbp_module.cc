// The generic part of a module: takes Octave's arrays apart, checks size and
// finiteness of every argument, calls the emitted Fortran and the run time of
// share/fortran.  Compiled once for double and once, with GSMBP_QUAD defined,
// for quad precision (Fortran under -freal-8-number-16): doubles in, doubles out.

#include <octave/oct.h>
#include <octave/parse.h>

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include "gsmbp_scene.h"
#include "gsmbp_cvode.h"

class columns;

#if defined (GSMBP_QUAD)
# include <quadmath.h>
typedef __float128 number;
#else
typedef double number;
#endif

typedef std::vector<number> reals;

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
  void gssim_ (void);
  void gspln_ (void);
  void gskkt_ (void);
  void gsacc_ (void);
  void gsspd_ (void);
  void gsleq_ (void);
  void gsfun_ (void);
  void gsinp_ (void);
  void gschk_ (void);
  void gsjmp_ (void);
  void gspst_ (void);
  void gspnw_ (void);
  void gspbg_ (void);
  void gsdue_ (void);
}

static const gsmbp_scene& S = gsmbp_the_scene;

// an emitted subroutine by the end of its name, a null pointer where there is none
static const gsmbp_routine *
emitted (const std::string& name)
{
  for (const gsmbp_routine *r = S.routines; r->name; r++)
    if (name == r->name)
      return r;
  return nullptr;
}

static void absent_routine (const std::string& name);

static fortran
routine (const char *name)
{
  const gsmbp_routine *r = emitted (name);
  if (! r)
    absent_routine (name);
  return fortran {r->sub};
}

// ---------------------------------------------------------------- arguments

class arguments
{
public:

  // usage: the arguments of the handle as its user types them, "t, q[, u]"
  arguments (const octave_value_list& a, const std::string& call, const std::string& usage = "")
    : m_args (a), m_call (call), m_usage (usage), m_next (0) { }

  std::string who (void) const { return std::string (S.name) + "." + m_call; }

  const std::string& call (void) const { return m_call; }

  bool more (void) const
  { return m_next < m_args.length () && ! m_args(m_next).isempty (); }

  // how the handle is called
  std::string typed (void) const
  { return "m." + m_call + " (" + m_usage + ")"; }

  void missing (const char *name) const
  {
    if (m_usage.empty ())
      error ("%s: argument %s is missing", who ().c_str (), name);
    error ("%s: argument %s is missing; expected %s", who ().c_str (), name, typed ().c_str ());
  }

  // As many arguments as the usage says: the ones before the first bracket are needed.  The
  // constants, which come first, are not the user's.
  void count_given (void) const
  {
    int given = int (m_args.length ()) - 1;
    std::string needed = m_usage.substr (0, m_usage.find ('['));
    for (std::size_t begin = 0; ! needed.empty () && begin < std::string::npos; given--)
      {
        std::size_t end = needed.find (',', begin);
        if (given <= 0)
          missing (needed.substr (begin, end - begin).c_str ());
        begin = end == std::string::npos ? end : end + 2;
      }
    int most = m_usage.empty () ? 0 : 1 + int (std::count (m_usage.begin (), m_usage.end (), ','));
    if (m_args.length () > most + 1)
      error ("%s: expected %s, at most %d argument%s, found %d", who ().c_str (), typed ().c_str (),
             most, most == 1 ? "" : "s", int (m_args.length ()) - 1);
  }

  const octave_value& value (const char *name)
  {
    if (m_next >= m_args.length ())
      missing (name);
    return m_args(m_next++);
  }

  // rows < 0: any number; cols < 0: any number; a vector may lie either way
  Matrix matrix (const char *name, int rows, int cols)
  {
    const octave_value& v = value (name);
    if (! v.isnumeric () && ! v.islogical ())
      error ("%s: argument %s: expected real numbers, found %s",
             who ().c_str (), name, v.class_name ().c_str ());
    if (v.iscomplex ())
      error ("%s: argument %s: expected real numbers, found complex ones",
             who ().c_str (), name);
    if (v.ndims () > 2)
      error ("%s: argument %s: expected a matrix, found %s",
             who ().c_str (), name, v.dims ().str ().c_str ());
    Matrix m = v.matrix_value ();
    if (cols == 1 && m.rows () == 1 && m.columns () != 1)
      m = m.transpose ();
    if (rows <= 0 && cols == 1 && m.numel () == 0)
      return Matrix (0, 1);
    if ((rows >= 0 && m.rows () != rows) || (cols >= 0 && m.columns () != cols))
      {
        if (cols == 1 && rows >= 0)
          error ("%s: argument %s: expected %d number%s, found %s", who ().c_str (),
                 name, rows, rows == 1 ? "" : "s", v.dims ().str ().c_str ());
        error ("%s: argument %s: expected %s x %s, found %s", who ().c_str (), name,
               count (rows).c_str (), count (cols).c_str (),
               v.dims ().str ().c_str ());
      }
    for (octave_idx_type j = 0; j < m.columns (); j++)
      for (octave_idx_type i = 0; i < m.rows (); i++)
        if (! (std::fabs (m(i,j)) <= 1e300))
          {
            std::string place, found = std::isnan (m(i,j)) ? "NaN" : m(i,j) > 0 ? "Inf" : "-Inf";
            if (m.columns () > 1)
              place = "(" + std::to_string (i + 1) + "," + std::to_string (j + 1) + ")";
            else if (m.numel () > 1)
              place = "(" + std::to_string (i + 1) + ")";
            error ("%s: argument %s%s is not finite: %s", who ().c_str (), name,
                   place.c_str (), found.c_str ());
          }
    return m;
  }

  // an array of `size` numbers, at least one place so that &x[0] exists
  reals vector (const char *name, int size)
  {
    Matrix m = matrix (name, size, 1);
    reals x (std::max<octave_idx_type> (1, m.numel ()), number (0));
    for (octave_idx_type i = 0; i < m.numel (); i++)
      x[i] = m.elem (i);
    return x;
  }

  reals array (const char *name, int rows, int cols)
  {
    Matrix m = matrix (name, rows, cols);
    reals x (std::max<octave_idx_type> (1, m.numel ()), number (0));
    for (octave_idx_type i = 0; i < m.numel (); i++)
      x[i] = m.elem (i);
    return x;
  }

  reals vector_or_zero (const char *name, int size)
  {
    if (more () || size < 0)
      return vector (name, size);
    m_next++;
    return reals (std::max (1, size), number (0));
  }

  number scalar (const char *name) { return vector (name, 1)[0]; }

  // coordinates, alone or before speeds and others; Euler parameters that are all zero are no
  // orientation
  reals coordinates (const char *name, int size)
  {
    reals x = vector (name, size);
    for (int k = 0; k < S.nsets; k++)
      if (no_orientation (&x[0], k, 1))
        error ("%s: argument %s: expected Euler parameters of length 1 in %s(%d), %s(%d), %s(%d), "
               "%s(%d), found zeros, which are no orientation",
               who ().c_str (), name, name, S.sets[4 * k], name, S.sets[4 * k + 1], name,
               S.sets[4 * k + 2], name, S.sets[4 * k + 3]);
    return x;
  }

  static bool no_orientation (const number *x, int set, std::size_t step)
  {
    for (int i = 0; i < 4; i++)
      if (x[step * (S.sets[4*set+i] - 1)] != 0)
        return false;
    return true;
  }

  std::vector<int> integers (const char *name, int size)
  {
    Matrix m = matrix (name, size, 1);
    std::vector<int> x (std::max<octave_idx_type> (1, m.numel ()), 0);
    for (octave_idx_type i = 0; i < m.numel (); i++)
      {
        if (! (m.elem (i) == std::floor (m.elem (i)) && std::fabs (m.elem (i)) <= 2e9))
          error ("%s: argument %s: expected whole numbers, found %g", who ().c_str (), name,
                 m.elem (i));
        x[i] = int (m.elem (i));
      }
    return x;
  }

  int integer_within (const char *name, int low, int high)
  {
    int k = integers (name, 1)[0];
    if (k < low || k > high)
      error ("%s: argument %s: expected %d to %d, found %d", who ().c_str (), name, low, high, k);
    return k;
  }

  // the modes of devices with events
  std::vector<int> modes (void)
  {
    std::vector<int> mode = integers ("mode", S.nmode);
    for (int i = 0; i < S.nmode; i++)
      if (mode[i] < -1 || mode[i] > 1)
        error ("%s: argument mode(%d): expected -1, 0 or 1, found %d", who ().c_str (), i + 1,
               mode[i]);
    return mode;
  }

  // the number of columns of the next argument
  int states (const char *name, int rows)
  {
    if (m_next >= m_args.length ())
      missing (name);
    const octave_value& v = m_args(m_next);
    if (v.is_string () || ! (v.isnumeric () || v.islogical ()))
      error ("%s: argument %s: expected real numbers, found %s", who ().c_str (), name,
             v.class_name ().c_str ());
    if (v.iscomplex ())
      error ("%s: argument %s: expected real numbers, found complex ones", who ().c_str (), name);
    if (v.rows () != rows || v.ndims () > 2)
      error ("%s: argument %s: expected %d row%s, a column for each state, found %s",
             who ().c_str (), name, rows, rows == 1 ? "" : "s", v.dims ().str ().c_str ());
    return int (v.columns ());
  }

  // the number of states in the argument behind the next one
  int states_behind (const char *name, int rows)
  {
    m_next++;
    int k = states (name, rows);
    m_next--;
    return k;
  }

  // the next argument, rows x K, with the state first; one column is of all states, nothing given
  // is zero. What is not finite is let through: it is the matter of its state.
  void batch (const char *name, int rows, int k, columns& x, bool needed);

  reals constants (void)
  {
    const octave_value& v = value ("cst");
    uint8NDArray bytes = v.uint8_array_value ();
    reals c (std::max (1, S.ncst), number (0));
    if (bytes.numel () != octave_idx_type (c.size () * sizeof (number)))
      error ("%s: the constants were made by another module", who ().c_str ());
    std::memcpy (&c[0], bytes.data (), bytes.numel ());
    return c;
  }

private:

  static std::string count (int n) { return n < 0 ? "any" : std::to_string (n); }

  octave_value_list m_args;
  std::string m_call, m_usage;
  int m_next;
};

// ------------------------------------------------------------------ results

static Matrix
result (const reals& x, int rows, int cols = 1)
{
  Matrix m (rows, cols);
  for (octave_idx_type i = 0; i < m.numel (); i++)
    m.xelem (i) = double (x[i]);
  return m;
}

// An array over K states, the state first, where it lies best (see the header of INV_V): columns
// begin at multiples of 64 bytes that are none of 4096.
class columns
{
public:
  columns (int k, int n, number value = 0)
      : m_k (k), m_n (n), m_ld (leading (k)),
        m_room (std::size_t (m_ld) * std::max (1, n) + 8, value), m_first (0)
  {
    while (reinterpret_cast<std::uintptr_t> (&m_room[m_first]) % 64 != 0 && m_first < 7)
      m_first++;
  }

  static int leading (int k)
  {
    int ld = 8 * std::max (1, (k + 7) / 8);
    return ld % 512 == 0 ? ld + 8 : ld;
  }

  number *data (void) { return &m_room[m_first]; }

  // f (place of a number, its row, its state), eight states at a time: a line of memory here, a few
  // columns there
  template <typename F> void each (F f)
  {
    for (int k0 = 0; k0 < m_k; k0 += 8)
      for (int i = 0; i < m_n; i++)
        {
          number *x = data () + k0 + std::size_t (m_ld) * i;
          int end = std::min (m_k - k0, 8);
          for (int k = 0; k < end; k++)
            f (x[k], i, k0 + k);
        }
  }

  // states of which Euler parameters are all zero, no orientation, become no numbers
  void without_orientation (int k, bool coordinates)
  {
    for (int set = 0; coordinates && set < S.nsets; set++)
      for (int j = 0; j < k; j++)
        if (arguments::no_orientation (data () + j, set, m_ld))
          data ()[j + std::size_t (m_ld) * (S.sets[4 * set] - 1)]
              = std::numeric_limits<double>::quiet_NaN ();
  }

  // a column for each state
  NDArray matrix (const dim_vector& dims)
  {
    NDArray a (dims);
    double *to = a.fortran_vec ();
    each ([&] (number& x, int i, int k) { to[i + std::size_t (m_n) * k] = double (x); });
    return a;
  }

private:

  int m_k, m_n, m_ld;
  reals m_room;
  int m_first;
};

void
arguments::batch (const char *name, int rows, int k, columns& x, bool needed)
{
  if (! needed && ! more ())
    {
      m_next++;
      return;
    }
  int given = states (name, rows);
  if (given != k && given != 1)
    error ("%s: argument %s: expected %d columns (or one for all), found %d", who ().c_str (), name,
           k, given);
  Matrix m = m_args(m_next++).matrix_value ();
  const double *from = m.data ();
  std::size_t step = given == 1 ? 0 : rows;
  x.each ([&] (number& y, int i, int j) { y = from[i + step * j]; });
  if (rows == S.nq || rows == S.nx)
    x.without_orientation (k, name[0] == 'q' || name[0] == 'x');
}

static reals
room (int n)
{
  return reals (std::max (1, n), number (0));
}

// ---------------------------------------------------- what a subroutine takes

// An argument of an emitted subroutine.
struct slot
{
  enum kind { real, whole, modes, constants, leading, states, indicator } what;
  bool in, out, needed;
  std::string name;
  int rows, cols, room;   // numbers of the array, and places that the subroutine writes
  int low, high;          // of a whole number
};

// All of them in the order of the Fortran, the numbers of those that the handle gives back, and how
// the handle is typed, "t, q[, u]".
struct signature
{
  std::vector<slot> slots;
  std::vector<std::size_t> results;
  std::string usage;
  bool batch, tells;   // many states at once; INFO is among them
};

const std::size_t most_slots = 24;

// a size by its name in the JSON, or a number
static int
size_of (const std::string& word)
{
#define GSMBP_NAMED(size) { #size, S.size },
  static const struct { const char *name; int value; } sizes[]
      = { GSMBP_SIZES (GSMBP_NAMED)
          { "np", S.np },
          { "nbase", S.nbase },
          { "norders", S.nqj + 1 },            // a motion and its derivatives
          { "nresidual", 2 * S.nlam + 4 } };   // what PRJ and CLO need to tell one
  for (const auto& entry : sizes)
    if (word == entry.name)
      return entry.value;
  return std::atoi (word.c_str ());
}

// what the arguments of that name always are
static const struct { const char *name, *rows, *meaning; } quantities[]
    = { { "t", "1", "" },
        { "q", "nq", "the coordinates" },
        { "u", "nu", "the speeds" },
        { "ud", "nu", "the accelerations" },
        { "x", "nx", "the states" },
        { "v", "nv", "the inputs" },
        { "tau", "nu", "the efforts" },
        { "xi", "na", "the internal states" },
        { "qj", "nu,norders", "the motion" },
        { "par", "npar", "the parameters" } };

static std::vector<std::string>
words (const std::string& text)
{
  std::vector<std::string> list;
  std::istringstream from (text);
  for (std::string word; from >> word; )
    list.push_back (word);
  return list;
}

// the sizes of SHAPE, "nu", "nu,nq" or "1/nresidual" (one number of so many places)
static void
shape (slot& s, std::string text)
{
  if (text.empty ())
    for (const auto& q : quantities)
      if (s.name == q.name)
        text = q.rows;
  std::size_t comma = text.find (','), slash = text.find ('/');
  s.rows = text.empty () ? 1 : size_of (text.substr (0, std::min (comma, slash)));
  s.cols = comma == std::string::npos ? 1 : size_of (text.substr (comma + 1));
  s.room = slash == std::string::npos ? s.rows * s.cols : size_of (text.substr (slash + 1));
}

// A word of a row of the table `known` (see there).
static slot
slot_of (const std::string& word)
{
  slot s = { slot::real, true, false, true, "", 1, 1, 1, 0, 0 };
  static const struct { const char *name; slot::kind what; } plain[]
      = { { "cst", slot::constants }, { "ld", slot::leading }, { "k", slot::states },
          { "info", slot::indicator } };
  for (const auto& entry : plain)
    if (word == entry.name)
      {
        s.what = entry.what;
        s.in = false;
        return s;
      }
  std::size_t begin = word.find_first_not_of ("?<>"), end = word.find_first_of ("([");
  std::string marks = word.substr (0, begin), inside;
  if (end != std::string::npos)
    inside = word.substr (end + 1, word.size () - end - 2);
  s.name = word.substr (begin, end == std::string::npos ? end : end - begin);
  s.in = marks.find ('>') == std::string::npos;
  s.out = marks.find_first_of ("<>") != std::string::npos;
  s.needed = marks.find ('?') == std::string::npos;
  if (s.name == "mode")
    s.what = slot::modes;
  else if (word.find ('[') != std::string::npos)
    {
      s.what = slot::whole;
      s.low = size_of (inside.substr (0, inside.find (':')));
      s.high = size_of (inside.substr (inside.find (':') + 1));
    }
  else
    shape (s, inside);
  return s;
}

// what the user types: "t, q, u[, v[, tau]]"
static std::string
usage_of (const std::vector<slot>& slots)
{
  std::string text, close;
  std::size_t last = 0;
  for (std::size_t i = 0; i < slots.size (); i++)
    if (slots[i].in && slots[i].needed)
      last = i;
  for (std::size_t i = 0; i < slots.size (); i++)
    if (slots[i].in)
      {
        if (i > last)
          close += "]";
        text += (i > last ? "[" : "") + std::string (text.empty () ? "" : ", ") + slots[i].name;
      }
  return text + close;
}

// a row of the table as a signature; RESULTS: names in the order of the handle, "" for that of the
// Fortran
static signature
signature_of (const std::string& text, const std::string& results)
{
  signature g;
  g.batch = g.tells = false;
  for (const std::string& word : words (text))
    {
      slot s = slot_of (word);
      if (s.what == slot::leading && ! g.slots.empty ())
        s.rows = std::max (1, g.slots.back ().rows);
      g.batch = g.batch || s.what == slot::states;
      g.tells = g.tells || s.what == slot::indicator;
      g.slots.push_back (s);
    }
  for (std::size_t i = 0; results.empty () && i < g.slots.size (); i++)
    if (g.slots[i].out)
      g.results.push_back (i);
  for (const std::string& name : words (results))
    for (std::size_t i = 0; i < g.slots.size (); i++)
      if (g.slots[i].name == name)
        g.results.push_back (i);
  if (g.slots.size () > most_slots)
    error ("%s: a subroutine with %d arguments: expected at most %d", S.name,
           int (g.slots.size ()), int (most_slots));
  g.usage = usage_of (g.slots);
  return g;
}

static std::string meaning (const std::string& call, int info);

static octave_value_list
do_meaning (arguments& a, int)
{
  std::string call = a.value ("subroutine").string_value ();
  return ovl (meaning (call, a.integers ("info", 1)[0]));
}

// Lost rank is news where it is not so everywhere: of a scene that has redundant constraints it is
// said once a model.
static bool the_rank_said = false, the_rank_full = false;

static void
say_rank (const char *call)
{
  if (the_rank_said && ! the_rank_full)
    return;
  the_rank_said = true;
  warning_with_id (
      "gsmbp:rank", "%s.%s: INFO = 2: %s%s", S.name, call, meaning (call, 2).c_str (),
      the_rank_full ? "" : "; this is said once a model: gsmbp_mobility tells which ones are");
}

// INFO becomes the output after the others if the caller takes it; otherwise
// an error, but for lost rank (2), whose results are usable, a warning.
static void
finish (octave_value_list& out, int info, int nargout, const char *call)
{
  int place = out.length ();
  if (info == 0 && S.nlam > 0
      && std::strstr (" rhs acc acd ", (" " + std::string (call) + " ").c_str ()))
    the_rank_full = true;
  if (nargout <= place && info != 0)
    {
      if (info == 2
          && std::strstr (" rhs acc acd out jac evt rst prj con ",
                          (" " + std::string (call) + " ").c_str ()))
        say_rank (call);
      else
        error_with_id ("gsmbp:info", "%s.%s: INFO = %d: %s", S.name, call, info,
                       meaning (call, info).c_str ());
    }
  out.append (octave_value (info));
}

// --------------------------------------------------------------- parameters

#if defined (GSMBP_QUAD)
// the shortest decimal that reads back as x: 0.2 is one fifth
static number
decimal (double x)
{
  char text[40];
  for (int digits = 15; digits <= 17; digits++)
    {
      std::snprintf (text, sizeof text, "%.*g", digits, x);
      if (std::strtod (text, nullptr) == x)
        break;
    }
  return strtoflt128 (text, nullptr);
}
#else
static number decimal (double x) { return x; }
#endif

static octave_value_list
do_par (arguments&, int)
{
  reals par = room (S.npar);
  routine ("par") (&par[0]);
  the_rank_said = the_rank_full = false;   // a new model: gsmbp_build asks for its parameters
  return ovl (result (par, S.npar));
}

static octave_value_list
do_pre (arguments& a, int nargout)
{
  Matrix given = a.matrix ("par", S.npar, 1);
  reals par = room (S.npar);
  reals cst = room (S.ncst);
  routine ("par") (&par[0]);
  for (int i = 0; i < S.npar; i++)
    if (double (par[i]) != given(i))
      par[i] = decimal (given(i));
  int info = 0;
  routine ("pre") (&par[0], &cst[0], &info);
  uint8NDArray bytes (dim_vector (cst.size () * sizeof (number), 1));
  std::memcpy (static_cast<void *> (bytes.fortran_vec ()), &cst[0], bytes.numel ());
  octave_value_list out = ovl (bytes);
  finish (out, info, nargout, "pre");
  return out;
}

// ------------------------------------------------- the emitted subroutines

// f (p[0], p[1], ...)
template <std::size_t... I>
static void
spread (gsmbp_sub f, void **p, std::index_sequence<I...>)
{
  fortran {f} (p[I]...);
}

template <std::size_t N>
static void
call_with (gsmbp_sub f, void **p)
{
  spread (f, p, std::make_index_sequence<N> ());
}

template <std::size_t... N>
static void
call_any (gsmbp_sub f, void **p, std::size_t n, std::index_sequence<N...>)
{
  static void (*const by_number[]) (gsmbp_sub, void **) = { call_with<N>... };
  by_number[n] (f, p);
}

static void
call (gsmbp_sub f, void **p, std::size_t n)
{
  call_any (f, p, n, std::make_index_sequence<most_slots + 1> ());
}

static reals
read (arguments& a, const slot& s)
{
  const char *name = s.name.c_str ();
  if (s.cols > 1)
    return a.array (name, s.rows, s.cols);
  if (! s.needed)
    return a.vector_or_zero (name, s.rows);
  bool coordinates = s.name == "q" || s.name == "x";
  return coordinates ? a.coordinates (name, s.rows) : a.vector (name, s.rows);
}

static Matrix
modes_after (const std::vector<int>& mode)
{
  Matrix m (S.nmode, 1);
  for (int i = 0; i < S.nmode; i++)
    m(i) = mode[i];
  return m;
}

// a subroutine at one state
static octave_value_list
call_once (const signature& g, gsmbp_sub f, arguments& a, int nargout)
{
  std::size_t n = g.slots.size ();
  reals numbers[most_slots];
  int wholes[most_slots] = { };
  void *places[most_slots];
  std::vector<int> mode;
  reals cst = a.constants ();
  for (std::size_t i = 0; i < n; i++)
    {
      const slot& s = g.slots[i];
      if (s.what == slot::real)
        {
          numbers[i] = s.in ? read (a, s) : room (s.room);
          places[i] = numbers[i].data ();
        }
      else if (s.what == slot::modes)
        {
          mode = a.modes ();
          places[i] = mode.data ();
        }
      else if (s.what == slot::constants)
        places[i] = cst.data ();
      else
        {
          wholes[i] = s.what == slot::whole ? a.integer_within (s.name.c_str (), s.low, s.high)
                                            : s.what == slot::leading ? s.rows : 0;
          places[i] = &wholes[i];
        }
    }
  call (f, places, n);
  octave_value_list out (g.results.size ());
  for (std::size_t k = 0; k < g.results.size (); k++)
    {
      std::size_t i = g.results[k];
      const slot& s = g.slots[i];
      out(k) = s.what == slot::modes ? modes_after (mode) : result (numbers[i], s.rows, s.cols);
    }
  for (std::size_t i = 0; i < n; i++)
    if (g.slots[i].what == slot::indicator)
      finish (out, wholes[i], nargout, a.call ().c_str ());
  return out;
}

// ------------------------------------------------------ batches of K states

static const number no_number = std::numeric_limits<double>::quiet_NaN ();

// The indicators are the last output; without it a state that has one is an error.
static void
finish_batch (octave_value_list &out, const std::vector<int> &info, int k, int nargout,
              const char *call)
{
  RowVector r (k);
  int worst = -1;
  for (int i = k - 1; i >= 0; i--)
    {
      r(i) = info[i];
      if (info[i] != 0)
        worst = i;
    }
  if (nargout <= out.length () && worst >= 0)
    error_with_id ("gsmbp:info", "%s.%s: state %d: INFO = %d: %s", S.name, call, worst + 1,
                   info[worst], meaning (call, info[worst]).c_str ());
  out.append (octave_value (r));
}

// a subroutine at K states, of which the second argument tells how many
static octave_value_list
call_batch (const signature& g, gsmbp_sub f, arguments& a, int nargout)
{
  std::size_t n = g.slots.size ();
  reals cst = a.constants ();
  int k = a.states_behind (g.slots[1].name.c_str (), g.slots[1].rows), ld = columns::leading (k);
  std::vector<int> info (ld, 0);
  std::vector<columns> numbers;
  numbers.reserve (n);
  void *places[most_slots];
  for (std::size_t i = 0; i < n; i++)
    {
      const slot& s = g.slots[i];
      bool real = s.what == slot::real;
      numbers.emplace_back (real ? k : 0, real ? s.rows * s.cols : 0,
                            s.out && g.tells ? no_number : number (0));
      if (s.in)
        a.batch (s.name.c_str (), s.rows, k, numbers[i], s.needed);
      places[i] = s.what == slot::constants ? static_cast<void *> (cst.data ())
                  : s.what == slot::states ? &k
                  : s.what == slot::leading ? &ld
                  : s.what == slot::indicator ? static_cast<void *> (info.data ())
                                              : numbers[i].data ();
    }
  call (f, places, n);
  octave_value_list out;
  for (std::size_t i : g.results)
    out.append (numbers[i].matrix (g.slots[i].cols > 1
                                   ? dim_vector (g.slots[i].rows, g.slots[i].cols, k)
                                   : dim_vector (g.slots[i].rows, k)));
  if (g.tells)
    finish_batch (out, info, k, nargout, a.call ().c_str ());
  return out;
}

// --------------------------------------------------------------- simulation

// A subroutine of the user in Octave: v = f (t, x).  An exception may not
// cross Fortran frames; it is kept and thrown again behind the run.
// Only while a run lasts do these point to something: a static octave_value
// would be destroyed after the interpreter.
static const octave_value *the_input = nullptr;
static std::exception_ptr *the_failure = nullptr;

extern "C" void
gsmbp_call_input (const number *t, const int *, const number *x, const int *nx,
                  const int *nv, const int *, const number *, const number *,
                  number *v, int *info)
{
  *info = 0;
  try
    {
      Matrix state (*nx, 1);
      for (int i = 0; i < *nx; i++)
        state.xelem (i) = double (x[i]);
      octave_value_list r = octave::feval (*the_input, ovl (double (*t), state), 1);
      octave_value_list only;
      if (r.length () > 0)
        only.append (r(0));
      arguments a (only, "simulate");
      reals given = a.vector ("v", *nv);
      for (int i = 0; i < *nv; i++)
        v[i] = given[i];
    }
  catch (...)
    {
      *the_failure = std::current_exception ();
      *info = -1000;
    }
}

extern "C" void gsmbp_absent (void) { }

static gsmbp_sub
user_input (void)
{
  if (! S.vin)
    error_with_id ("gsmbp:absent",
                   "%s.input: the model was built without option \"input\" of gsmbp_build", S.name);
  return S.vin;
}

// The plan of the samples (see GSSMP) in IP and RP: its periods and delays, room for what lies
// behind the memory
static void
set_samples (reals& cst, std::vector<int>& ip, reals& rp)
{
  if (ip.size () < 30)
    error ("%s.sim: ip is too short", S.name);
  if (ip[25] <= 0)
    return;
  const int *is = &ip[ip[25] - 1];
  int nc = is[0], nh = is[3], np = is[4], ns = is[5], first = ip[26] - 1;
  if (nc != S.nctl || is[1] != S.nxk || is[2] != S.ny)
    error ("%s.sim: the plan of the samples is not of this scene", S.name);
  rp.resize (first + 2 * nc + nh + S.nxk + S.ny + S.nv + np * (1 + nh)
                 + std::size_t (ns) * (1 + S.nxk + S.nv),
             number (0));
  routine ("ctp") (&cst[0], &rp[first], &rp[first + nc]);
}

// after a run: a struct of the outputs at the output times, the record of the samples, the memory
// at the end
static octave_value
samples (reals &cst, const std::vector<int> &ip, const reals &rp, const reals &tout,
         const reals &xout, const reals &vout, int ldx, int ldv, int reached)
{
  if (ip[25] <= 0)
    return Matrix ();
  const int *is = &ip[ip[25] - 1];
  int nc = is[0], nh = is[3], np = is[4], ns = std::min (is[5], is[6]), width = 1 + S.nxk + S.nv;
  const number *s = &rp[ip[26] - 1];
  octave_scalar_map r;
  Matrix y (S.ny, reached), memory (S.nxk, 1), record (width, ns);
  reals one = room (S.ny);
  for (int k = 0; k < reached && S.ny > 0; k++)
    {
      int info = 0;
      routine ("out") (&tout[k], &xout[std::size_t (ldx) * k], &vout[std::size_t (ldv) * k],
                              &cst[0], &one[0], &info);
      for (int i = 0; i < S.ny; i++)
        y(i, k) = double (one[i]);
    }
  s += 2 * nc + nh;
  for (int i = 0; i < S.nxk; i++)
    memory(i) = double (s[i]);
  s += S.nxk + S.ny + S.nv + np * (1 + nh);
  for (octave_idx_type i = 0; i < record.numel (); i++)
    record.xelem (i) = double (s[i]);
  r.assign ("y", y);
  r.assign ("memory", memory);
  r.assign ("record", record);
  r.assign ("instants", is[6]);
  return octave_value (r);
}

// The plan of the events (see GSRES): room in RP
static void
set_events (std::vector<int>& ip, reals& rp, int nx)
{
  if (ip[27] <= 0)
    return;
  const int *ie = &ip[ip[27] - 1];
  if (ie[0] != S.nev)
    error ("%s.sim: the plan of the events is not of this scene", S.name);
  ip[28] = int (rp.size ()) + 1;
  rp.resize (rp.size () + 5 * ie[0] + 3 * nx + std::size_t (ie[1]) * (3 + 2 * nx), number (0));
}

// after a run: the record of the events, a column for each: time, number, mode after, states
// before, states after; how many there were
static octave_value_list
events (const std::vector<int>& ip, const reals& rp, int nx)
{
  if (ip[27] <= 0)
    return ovl (Matrix (), 0);
  const int *ie = &ip[ip[27] - 1];
  Matrix record (3 + 2 * nx, std::min (ie[1], ie[2]));
  for (octave_idx_type i = 0; i < record.numel (); i++)
    record.xelem (i) = double (rp[ip[28] - 1 + 5 * ie[0] + 3 * nx + i]);
  return ovl (record, ie[2]);
}

#if ! defined (GSMBP_QUAD)
// the run by CVODE, in a library of its own
static int
run_cvode (const std::string& library, const gsmbp_run& r)
{
  static gsmbp_run_function *run = nullptr;
  static std::string loaded;
  if (loaded != library)
    {
      void *handle = dlopen (library.c_str (), RTLD_NOW | RTLD_LOCAL);
      void *address = handle ? dlsym (handle, "gsmbp_cvode") : nullptr;
      if (! address)
        error ("gsmbp_simulate: cannot load %s: %s", library.c_str (), dlerror ());
      run = reinterpret_cast<gsmbp_run_function *> (address);
      loaded = library;
    }
  return run (&r);
}
#endif

static octave_value_list
do_sim (arguments& a, int)
{
  reals cst = a.constants ();
  number t0 = a.scalar ("t0");
  reals x0 = a.vector ("x0", -1);
  const int nx = int (x0.size ());   // with the two states of an audit or without
  const bool audit = nx == S.nx + 2;
  if (nx != S.nx && ! audit)
    error ("%s: argument x0: expected %d numbers, found %d", a.who ().c_str (), S.nx, nx);
  reals tout = a.vector ("times", -1), tbrk = a.vector ("breaks", -1);
  Matrix counts = a.matrix ("counts", 2, 1);
  std::vector<int> iopt = a.integers (
      "iopt", -1); // method, way of the loops, drift, steps; from 7 on constraints on speeds
  if (iopt.size () < 6)
    error ("%s: iopt is too short", a.who ().c_str ());
  for (std::size_t i = 6; i < iopt.size (); i++)
    if (iopt[i] < 1 || iopt[i] > S.nlam)
      error ("%s: there is no constraint %d", a.who ().c_str (), iopt[i]);
  iopt[5] = int (iopt.size ()) - 6;
  reals ropt = a.vector ("ropt", 3), atol = a.vector ("atol", nx);
  std::vector<int> ip = a.integers ("ip", -1);
  reals rp = a.vector ("rp", -1), guess = a.vector ("guess", S.nu);
  octave_value input = a.value ("input function");
  std::string library = a.value ("library").string_value ();   // of CVODE; "": GSSIM alone
  int order = a.integers ("largest order", 1)[0];
  set_samples (cst, ip, rp);
  set_events (ip, rp, nx);
  std::exception_ptr failure;
  the_input = &input;
  the_failure = &failure;

  int nt = int (counts(0)), nb = int (counts(1)), info = 0;
  int ldx = std::max (1, nx), ldv = std::max (1, S.nv);
  int lw = 2 * S.nu * (ip[3] + 1) + 24 * nx + S.nv * nx + 2 * S.nv + 8 * S.nu + 10 * S.nq
           + 7 * S.nlam + 3 * S.nlam * S.nu + 60;
  reals w = room (lw), xout = room (ldx * nt), vout = room (ldv * nt);
  const int statistics = 20;
  reals rstat = room (statistics);
  std::vector<int> istat (statistics, 0);
  for (int i = 0; i < S.nu; i++)
    w[i] = guess[i];

  gsmbp_sub none = gsmbp_absent;
  gsmbp_sub rhs = audit ? routine ("rha").f : routine ("rhs").f;
  bool loops = S.nlam > 0, partition = loops && (iopt[1] == 3 || iopt[1] == 6);
  bool project = iopt[1] != 1 && (iopt[1] == 3 ? S.nq > S.nu : loops || S.nq > S.nu);
  if (! library.empty ())
    project = iopt[1] != 1 && (loops || S.nq > S.nu);   // by PRJ in every way
  gsmbp_sub prj = project ? routine ("prj").f : none;
  gsmbp_sub con = partition || (loops && iopt[2] == 1) ? routine ("con").f : none;
  iopt[4] = loops && iopt[2] == 1 && emitted ("kin");
  gsmbp_sub kin = partition || iopt[4] ? routine ("kin").f : none;
  gsmbp_sub cmd = ip[0] == 2 ? routine ("cmd").f : none;
  gsmbp_sub clo = ip[0] == 2 && ip[2] == 1 ? routine ("clo").f : none;
  gsmbp_sub out = ip[25] > 0 && S.ny > 0 ? routine ("out").f : none;
  gsmbp_sub ctl = ip[25] > 0 ? routine ("ctl").f : none;
  gsmbp_sub evt = ip[27] > 0 ? routine ("evt").f : none;
  gsmbp_sub rst = ip[27] > 0 ? routine ("rst").f : none;
  gsmbp_sub vin = none;
  if (ip[0] == 3)
    vin = input.is_function_handle ()
          ? reinterpret_cast<gsmbp_sub> (gsmbp_call_input) : user_input ();

  auto begin = std::chrono::steady_clock::now ();
  std::vector<char> text (400, 0);
  bool stiff = iopt[0] == 0;
  if (! stiff)
    fortran {gssim_} (rhs, prj, con, kin, cmd, clo, vin, &S.nq, &S.nu, &nx, &S.nv, &S.nlam,
            &t0, &x0[0], &nt, &tout[0], &nb, &tbrk[0], &iopt[0], &ropt[0],
            &atol[0], &ip[0], &rp[0], &cst[0], &xout[0], &ldx, &vout[0], &ldv,
            &istat[0], &rstat[0], &w[0], &lw, out, ctl, evt, rst, &info);
#if ! defined (GSMBP_QUAD)
  if (stiff || info == 5)   // found to be bound by stability
    {
      int resume = ! stiff;
      const gsmbp_routine *jac = emitted ("jac");
      gsmbp_run r = { rhs,
                      prj,
                      con,
                      kin,
                      cmd,
                      clo,
                      vin,
                      out,
                      ctl,
                      jac ? jac->sub : nullptr,
                      gsfun_,
                      gsinp_,
                      gschk_,
                      gsjmp_,
                      gspst_,
                      gspnw_,
                      gspbg_,
                      gsdue_,
                      S.nq,
                      S.nu,
                      nx,
                      S.nv,
                      S.ny,
                      S.nlam,
                      resume,
                      order,
                      t0,
                      &x0[0],
                      nt,
                      nb,
                      &tout[0],
                      &tbrk[0],
                      &iopt[0],
                      &ropt[0],
                      &atol[0],
                      &ip[0],
                      &rp[0],
                      &cst[0],
                      &xout[0],
                      &vout[0],
                      ldx,
                      ldv,
                      &istat[0],
                      &rstat[0],
                      &w[0],
                      &text[0],
                      int (text.size ()) };
      info = run_cvode (library, r);
    }
#endif
  std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  if (failure)
    std::rethrow_exception (failure);

  Matrix counters (statistics, 1);
  for (int i = 0; i < statistics; i++)
    counters(i) = istat[i];
  Matrix xs = result (xout, nx, nt), vs = result (vout, S.nv, nt);
  if (ldv > S.nv)
    vs = Matrix (0, nt);
  octave_value_list results = ovl (xs, vs, counters, result (rstat, statistics), info,
                                   took.count (), std::string (&text[0]));
  results.append (samples (cst, ip, rp, tout, xout, vout, ldx, ldv, istat[4]));
  results.append (events (ip, rp, nx));
  return results;
}

// -------------------------------------------------- the run time, for tests

static octave_value_list
do_spline (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 5, 1);   // NC NP K ND SIDE
  int nc = int (sizes(0)), np = int (sizes(1)), k = int (sizes(2)), nd = int (sizes(3));
  int side = int (sizes(4)), ld = std::max (1, nc), info = 0;
  reals brk = a.vector ("breaks", np + 1), coef = a.array ("coefficients", nc * np, k);
  Matrix times = a.matrix ("t", -1, 1);
  NDArray f (dim_vector (nc, nd + 1, times.numel ()));
  reals one = room (ld * (nd + 1));
  int worst = 0;
  for (octave_idx_type j = 0; j < times.numel (); j++)
    {
      number t = times(j);
      fortran {gspln_} (&nc, &np, &k, &brk[0], &coef[0], &t, &side, &nd, &one[0], &ld, &info);
      if (info < 0)
        error ("gspln: INFO = %d", info);
      worst = std::max (worst, info);
      for (int d = 0; d <= nd; d++)
        for (int i = 0; i < nc; i++)
          f(i, d, j) = double (one[i + ld * d]);
    }
  return ovl (f, worst);
}

static octave_value_list
do_kkt (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 4, 1);   // N M repetitions way (0: GSKKT)
  int n = int (sizes (0)), m = int (sizes (1)), times = int (sizes (2)), way = int (sizes (3)),
      info = 0;
  int lda = std::max (1, n), ldh = std::max (1, m);
  reals A = a.array ("A", n, n), H = a.array ("H", m, n);
  reals f = a.vector ("f", n), g = a.vector ("g", m);
  reals ud = room (n), lam = room (m);
  reals w = room (way == 0 ? n * n + n * m + m * m + 2 * n + 6 * m
                           : 2 * n * n + n * m + m * m + 4 * n + 8 * m);
  auto begin = std::chrono::steady_clock::now ();
  for (int i = 0; i < times; i++)
    if (way == 0)
      fortran{ gskkt_ }(&n, &m, &A[0], &lda, &H[0], &ldh, &f[0], &g[0], &ud[0], &lam[0], &w[0],
                        &info);
    else
      fortran{ gsacc_ }(&way, &n, &m, &A[0], &lda, &H[0], &ldh, &f[0], &g[0], &ud[0], &lam[0],
                        &w[0], &info);
  std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  return ovl (result (ud, n), result (lam, m), info, took.count () / std::max (1, times));
}

static octave_value_list
do_solve (arguments& a, int)
{
  Matrix sizes = a.matrix ("sizes", 4, 1);   // N NRHS (1 = SPD, 2 = general) repetitions
  int n = int (sizes(0)), nrhs = int (sizes(1)), kind = int (sizes(2));
  int times = int (sizes(3)), ld = std::max (1, n), info = 0;
  reals A = a.array ("A", n, n), B = a.array ("B", n, nrhs);
  std::vector<int> iw (ld);
  reals P = A, X = B;
  auto begin = std::chrono::steady_clock::now ();
  for (int i = 0; i < times; i++)
    {
      P = A;
      X = B;
      if (kind == 1)
        fortran {gsspd_} (&n, &nrhs, &P[0], &ld, &X[0], &ld, &info);
      else
        fortran {gsleq_} (&n, &nrhs, &P[0], &ld, &X[0], &ld, &iw[0], &info);
    }
  std::chrono::duration<double> took = std::chrono::steady_clock::now () - begin;
  return ovl (result (X, n, nrhs), info, took.count () / std::max (1, times));
}

// ----------------------------------------------------------------- dispatch

static std::string
upper (std::string text)
{
  for (char& c : text)
    c = char (std::toupper (static_cast<unsigned char> (c)));
  return text;
}

// why the scene has not what is asked for by a request; or how to have it
static std::string
left_out (const char *request)
{
  std::string all = S.left_out, head = std::string ("\n") + request + ": ";
  std::size_t at = all.find (head), from = at + head.size ();
  if (at != std::string::npos)
    {
      std::string reason = all.substr (from, all.find ('\n', from) - from);
      if (reason.find ("made on request") == std::string::npos)
        return reason;
    }
  return std::string ("derive it with the request ") + request + " of gsmbp_fortran";
}

static void
absent (const std::string& call, const char *request)
{
  std::string reason;
  auto is = [&] (const char *calls)
    { return std::strstr (calls, (" " + call + " ").c_str ()) != nullptr; };
  if (S.nlam == 0 && is (" con inl clo acc acd tan "))
    reason = "it has no loops";
  else if (S.nlam == 0 && S.nq == S.nu && is (" prj "))
    reason = "it has neither loops nor Euler parameters";
  else if (S.nctl == 0 && is (" ctl ctp "))
    reason = "it has no sampled devices";
  else if (S.nev == 0 && is (" evt rst "))
    reason = "it has no events";
  else if (S.nsm == 0 && is (" mar "))
    reason = "no device of it has a margin that its state decides";
  else if (S.ny == 0 && is (" out "))
    reason = "it has no outputs";
  else
    reason = left_out (request);
  error_with_id ("gsmbp:absent", "%s.%s: the scene was emitted without the subroutine %s: %s",
                 S.name, call.c_str (), upper (call).c_str (), reason.c_str ());
}

// The emitted subroutines that gsmbp_fortran knows: end of the name, what it is asked for by, the
// arguments in the order of the Fortran:
//   q         read, of the shape of `quantities`; q(nq), m(nu,nu): of this one
//   ?v        may be left out, then zero
//   >tau(nu)  a result; <x: read and a result; >res(1/n): one number, n places to work in
//   way[1:4]  a whole number from 1 to 4; mode: the modes
//   cst, ld, k, info: the constants, the leading dimension of the array before it (of all arrays,
//             behind k, the number of states), the number of states, the indicator
// and the results in the order of the handle where that is another.  A subroutine that is not here
// has its arguments from the JSON (gsmbp__signature.m); the table says what that does not.  What
// nobody asks for (PRE) is no handle.
struct known_routine { const char *name, *request, *slots, *results; };
static const known_routine known[]
    = {
        { "rhs", "rhs", "t x ?v cst >xd(nx) info", "" },
        { "inv", "inverse", "t q u ud ?v cst >tau", "" },
        { "fwd", "forward", "t q u ?v ?tau cst >ud info", "" },
        { "mas", "mass", "t q cst >m(nu,nu) ld", "" },
        { "reg", "regressor", "t q u ud ?v cst >y(nu,nbase) ld >p(nbase) >r(nu)", "" },
        { "bia", "bias", "t q u ?v cst >b(nu)", "" },
        { "kin", "kinematics", "t q u cst >qdot(nq)", "" },
        { "con", "constraints",
          "t q ?u cst >phi(nlam) >phit(nlam) >hc(nlam,nu) ld >gam(nlam) info", "" },
        { "inl", "inverse_loops", "t q u ud ?v cst >tau(nact) >lam(nlam) info", "" },
        { "lin", "linear", "t q u ud ?v cst >m(nu,nu) >b(nu,nu) >c(nu,nq) ld", "" },
        { "prj", "projection", "t <x cst >res(1/nresidual) info", "" },
        { "jac", "jacobian",
          "t x ?v cst >a(nx,nx) ld >b(nx,nv) ld >c(ny,nx) ld >d(ny,nv) ld info", "" },
        { "out", "output", "t x ?v cst >y(ny) info", "" },
        { "cmd", "command", "t qj ?xi cst >v >xid(na) info", "" },
        { "cmx", "command_states", "t qj ?xi cst >v >xid(na) >xa(na) >g(nmar) info", "" },
        { "ctl", "control", "k[0:nctl] t y(ny) <xk(nxk) cst ?<v", "v xk" },
        { "ctp", "control", "cst >period(nctl) >delay(nctl)", "" },
        { "evt", "events", "t x v mode cst >g(nev)", "" },
        { "rst", "events", "t <x <v <mode k[-1:nev] cst info", "x mode v" },
        { "clo", "closure", "t <qj cst >res(1/nresidual) info", "" },
        { "ene", "energy", "t x ?v cst >e(ne)", "" },
        { "acc", "accelerations", "t x ?v cst >ud >lam(nlam) info", "" },
        { "acd", "dense", "t x ?v cst way[1:4] >ud >lam(nlam) info", "" },
        { "tan", "tangent", "t x cst >dp(nlam,nq) ld >dv(nlam,nq) ld", "" },
        { "mar", "margins", "t x ?v cst >g(nsm) >sizes(nsm)", "" },
        { "ske", "skeleton", "t q cst >p(3,np)", "" },
        { "inv_v", "batch", "t q u ud ?v cst >tau k ld", "" },
        { "mas_v", "batch", "t q cst >m(nu,nu) k ld", "" },
        { "bia_v", "batch", "t q u ?v cst >b(nu) k ld", "" },
        { "fwd_v", "batch", "t q u ?v ?tau cst >ud info k ld", "" },
        { "rhs_v", "batch", "t x ?v cst >xd(nx) info k ld", "" },
        { "pre", "", "par cst info", "" }
      };

static const known_routine *
known_by (const std::string& name)
{
  for (const known_routine& row : known)
    if (name == row.name)
      return &row;
  return nullptr;
}

// what a run needs and was not emitted: as its handle says it
static void
absent_routine (const std::string& name)
{
  const known_routine *row = known_by (name);
  if (row && row->request[0])
    absent (name, row->request);
  error_with_id ("gsmbp:absent",
                 "%s.%s: the scene was emitted without the subroutine %s_%s; add it to the "
                 "requests of gsmbp_fortran",
                 S.name, name.c_str (), S.name, name.c_str ());
}

// A handle of gsmbp_build.
struct handle
{
  std::string name;
  const known_routine *row;   // a null pointer where the JSON alone knows it
  const gsmbp_routine *code;  // a null pointer where it was not emitted
  signature g;

  bool asked_for (void) const { return ! row || row->request[0]; }
};

static handle
handle_of (const std::string& name, const known_routine *row, const gsmbp_routine *code)
{
  return handle { name, row, code, signature_of (row ? row->slots : code->arguments,
                                                 row ? row->results : "") };
}

// those of the table, and what else was emitted whose arguments the JSON tells
static const std::vector<handle>&
handles (void)
{
  static std::vector<handle> list;
  if (list.empty ())
    {
      for (const known_routine& row : known)
        list.push_back (handle_of (row.name, &row, emitted (row.name)));
      for (const gsmbp_routine *r = S.routines; r->name; r++)
        if (r->arguments[0] && ! known_by (r->name))
          list.push_back (handle_of (r->name, nullptr, r));
    }
  return list;
}

// the names of the handles that a user may call
static octave_value_list
do_calls (arguments&, int)
{
  string_vector names;
  for (const handle& h : handles ())
    if (h.asked_for () && ! h.g.usage.empty ())
      names.append (h.name);
  return octave_value (Cell (names));
}

// for the functions of octave/ and for tests
static const struct { const char *name; octave_value_list (*call) (arguments&, int); } services[]
    = { { "sim", do_sim }, { "par", do_par }, { "pre", do_pre }, { "meaning", do_meaning },
        { "spline", do_spline }, { "kkt", do_kkt }, { "solve", do_solve }, { "calls", do_calls } };

// the k-th argument of an emitted subroutine, as its handle calls it
static std::string
fortran_argument (const std::string& call, int k)
{
  for (const handle& h : handles ())
    if (call == h.name && k <= int (h.g.slots.size ()) && h.g.slots[k-1].in)
      {
        std::string name = h.g.slots[k-1].name;
        for (const auto& q : quantities)
          if (name == q.name && *q.meaning)
            return "argument " + name + " (" + q.meaning + ")";
        return "argument " + name;
      }
  return "argument " + std::to_string (k) + " of the Fortran subroutine";
}

// The error indicators of the emitted subroutines as sentences, those of the JSON (also for
// gsmbp_simulate and others, by the call "meaning"): of the greatest number that is not above.
static std::string
meaning (const std::string& call, int info)
{
  if (info == 0)
    return "ok";
  if (info < 0)
    return fortran_argument (call, -info) + " is out of range or not finite";
  const gsmbp_meaning *found = nullptr;
  for (const gsmbp_meaning *m = S.meanings; m->name; m++)
    if (call == m->name && (m->info == info || (m->and_above && m->info < info)))
      found = m;
  return found ? found->text
               : "no sentence for this number: see ERROR INDICATOR in the head of the subroutine";
}

static octave_value_list
dispatch (const std::string& call, const octave_value_list& args, int nargout)
{
  for (const handle& h : handles ())
    if (call == h.name && h.asked_for ())
      {
        if (! h.code)
          absent (call, h.row->request);
        arguments a (args, call, h.g.usage);
        a.count_given ();
        return (h.g.batch ? call_batch : call_once) (h.g, h.code->sub, a, nargout);
      }
  for (const auto& service : services)
    if (call == service.name)
      {
        arguments a (args, call, "");
        return service.call (a, nargout);
      }
  error ("%s: no subroutine %s", S.name, call.c_str ());
}

// ("time", repetitions, call, its arguments ...): seconds for one call of the
// emitted subroutine, Octave's part not in it
static octave_value_list
do_time (const octave_value_list& args)
{
  if (args.length () < 3 || ! args(2).is_string ())
    error ("%s.time: expected repetitions, the name of a subroutine, its arguments", S.name);
  std::string call = args(2).string_value ();
  long repeats = args(1).long_value ();
  if (repeats < 1 || call == "sim")
    error ("%s.time: cannot time %ld calls of %s", S.name, repeats, call.c_str ());
  struct guard { ~guard () { the_repeats = 0; } } back_to_normal;
  the_repeats = repeats;
  dispatch (call, args.slice (3, args.length () - 3), 9);
  return ovl (the_seconds / repeats);
}

// By the name under which Octave has it: a function that it does not find under its own name it
// loads anew at every call, once a folder was added to the path behind the first one.
DEFUNX_DLD (S.symbol, Fgsmbp_module, Ggsmbp_module, args, nargout,
            "Called through the handles of gsmbp_build; not for direct use.")
{
  if (args.length () < 1 || ! args(0).is_string ())
    error ("%s: expected the name of a subroutine", S.name);
  std::string call = args(0).string_value ();
  if (call == "time")
    return do_time (args);
  octave_value_list results = dispatch (call, args.slice (1, args.length () - 1), nargout);
  int most = int (results.length ());
  if (nargout > most)
    error ("%s.%s: expected at most %d result%s, found %d", S.name, call.c_str (), most,
           most == 1 ? "" : "s", nargout);
  return results;
}
