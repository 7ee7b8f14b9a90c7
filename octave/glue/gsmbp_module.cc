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
#include <string>
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

static fortran
routine (gsmbp_sub f, const char *name)
{
  if (! f)
    error_with_id ("gsmbp:absent",
                   "%s.%s: the scene was emitted without the subroutine %s_%s; add it to the "
                   "requests of gsmbp_fortran",
                   S.name, name, S.name, name);
  return fortran {f};
}

// ---------------------------------------------------------------- arguments

class arguments
{
public:

  // usage: the arguments of the handle as its user types them, "t, q[, u]"
  arguments (const octave_value_list& a, const std::string& call, const std::string& usage = "")
    : m_args (a), m_call (call), m_usage (usage), m_next (0) { }

  std::string who (void) const { return std::string (S.name) + "." + m_call; }

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

// the k-th argument of an emitted subroutine, as its handle calls it
static std::string
fortran_argument (const std::string& call, int k)
{
  static const struct { const char *calls, *names[5];
  } table[] = { { " rhs rha acc acd jac out evt rst rhs_v ",
                  { "t", "x (the states)", "v (the inputs)", "", "" } },
                { " inl ",
                  { "t", "q (the coordinates)", "u (the speeds)", "ud (the accelerations)",
                    "v (the inputs)" } },
                { " fwd fwd_v ",
                  { "t", "q (the coordinates)", "u (the speeds)", "v (the inputs)",
                    "tau (the efforts)" } },
                { " con ", { "t", "q (the coordinates)", "u (the speeds)", "", "" } },
                { " prj ", { "t", "x (the states)", "", "", "" } },
                { " cmd cmx clo ", { "t", "qj (the motion)", "", "", "" } },
                { " pre ", { "par (the parameters)", "", "", "", "" } } };
  for (const auto& entry : table)
    if (k <= 5 && *entry.names[k-1] && std::strstr (entry.calls, (" " + call + " ").c_str ()))
      return std::string ("argument ") + entry.names[k-1];
  return "argument " + std::to_string (k) + " of the Fortran subroutine";
}

// The error indicators of the emitted subroutines as sentences: the one place where they stand
// (also of gsmbp_simulate and others, by the call "meaning").  An entry without a subroutine holds
// for those that are not named.
static std::string
meaning (const std::string& call, int info)
{
  static const struct { int info; const char *calls, *text;
  } table[] = {
    { 1, " clo ",
      "a singular position: the dependent coordinates cannot be found from the independent ones" },
    { 1, "", "the mass matrix is singular or not positive definite" },
    { 2, " clo ", "the loops do not close at these independent coordinates" },
    { 2, "", "the constraints have lost rank: multipliers are not unique" },
    { 3, " rhs rha acc acd out jac evt rst rhs_v ",
      "orientation angles are within 0.05 rad of their singularity: choose another sequence of "
      "axes or Euler parameters" },
    { 3, " prj ", "no position that closes the loops was found near this one" },
    { 3, "", "the iteration did not converge" },
    { 4, "",
      "a length is 0 by which the equations were divided (passes gauge and unit: leave them out of "
      "gsmbp_passes)" }
  };
  if (info == 0)
    return "ok";
  if (info < 0)
    return fortran_argument (call, -info) + " is out of range or not finite";
  if (! call.compare ("inl") || ! call.compare (0, 2, "cm"))
    return "a singular position for these actuators: they cannot give the motion here";
  for (const auto& entry : table)
    if (entry.info == info
        && (!*entry.calls || std::strstr (entry.calls, (" " + call + " ").c_str ())))
      return entry.text;
  return "no sentence for this number: see ERROR INDICATOR in the head of the subroutine";
}

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
  routine (S.par, "par") (&par[0]);
  the_rank_said = the_rank_full = false;   // a new model: gsmbp_build asks for its parameters
  return ovl (result (par, S.npar));
}

static octave_value_list
do_pre (arguments& a, int nargout)
{
  Matrix given = a.matrix ("par", S.npar, 1);
  reals par = room (S.npar);
  reals cst = room (S.ncst);
  routine (S.par, "par") (&par[0]);
  for (int i = 0; i < S.npar; i++)
    if (double (par[i]) != given(i))
      par[i] = decimal (given(i));
  int info = 0;
  routine (S.pre, "pre") (&par[0], &cst[0], &info);
  uint8NDArray bytes (dim_vector (cst.size () * sizeof (number), 1));
  std::memcpy (static_cast<void *> (bytes.fortran_vec ()), &cst[0], bytes.numel ());
  octave_value_list out = ovl (bytes);
  finish (out, info, nargout, "pre");
  return out;
}

// ------------------------------------------------- the emitted subroutines

static octave_value_list
do_kin (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu), qdot = room (S.nq);
  routine (S.kin, "kin") (&t, &q[0], &u[0], &cst[0], &qdot[0]);
  return ovl (result (qdot, S.nq));
}

static octave_value_list
do_inv (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu), ud = a.vector ("ud", S.nu);
  reals v = a.vector_or_zero ("v", S.nv), tau = room (S.nu);
  routine (S.inv, "inv") (&t, &q[0], &u[0], &ud[0], &v[0], &cst[0], &tau[0]);
  return ovl (result (tau, S.nu));
}

static octave_value_list
do_reg (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu), ud = a.vector ("ud", S.nu);
  reals v = a.vector_or_zero ("v", S.nv), y = room (S.nu * S.nbase), p = room (S.nbase),
        r = room (S.nu);
  int ld = std::max (1, S.nu);
  routine (S.reg, "reg") (&t, &q[0], &u[0], &ud[0], &v[0], &cst[0], &y[0], &ld, &p[0], &r[0]);
  return ovl (result (y, S.nu, S.nbase), result (p, S.nbase), result (r, S.nu));
}

static octave_value_list
do_mas (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), m = room (S.nu * S.nu);
  int ld = std::max (1, S.nu);
  routine (S.mas, "mas") (&t, &q[0], &cst[0], &m[0], &ld);
  return ovl (result (m, S.nu, S.nu));
}

static octave_value_list
do_bia (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu);
  reals v = a.vector_or_zero ("v", S.nv), b = room (S.nu);
  routine (S.bia, "bia") (&t, &q[0], &u[0], &v[0], &cst[0], &b[0]);
  return ovl (result (b, S.nu));
}

static octave_value_list
do_fwd (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu);
  reals v = a.vector_or_zero ("v", S.nv), tau = a.vector_or_zero ("tau", S.nu);
  reals ud = room (S.nu);
  int info = 0;
  routine (S.fwd, "fwd") (&t, &q[0], &u[0], &v[0], &tau[0], &cst[0], &ud[0], &info);
  octave_value_list out = ovl (result (ud, S.nu));
  finish (out, info, nargout, "fwd");
  return out;
}

static octave_value_list
do_con (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector_or_zero ("u", S.nu);
  reals phi = room (S.nlam), phit = room (S.nlam), hc = room (S.nlam * S.nu), gam = room (S.nlam);
  int ld = std::max (1, S.nlam), info = 0;
  routine (S.con, "con") (&t, &q[0], &u[0], &cst[0], &phi[0], &phit[0], &hc[0], &ld, &gam[0],
                          &info);
  octave_value_list out = ovl (result (phi, S.nlam), result (phit, S.nlam),
                               result (hc, S.nlam, S.nu), result (gam, S.nlam));
  finish (out, info, nargout, "con");
  return out;
}

static octave_value_list
do_inl (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu), ud = a.vector ("ud", S.nu);
  reals v = a.vector_or_zero ("v", S.nv);
  reals tau = room (std::max (S.nact, S.nu)), lam = room (S.nlam);
  int info = 0;
  routine (S.inl, "inl") (&t, &q[0], &u[0], &ud[0], &v[0], &cst[0], &tau[0], &lam[0], &info);
  octave_value_list out = ovl (result (tau, S.nact), result (lam, S.nlam));
  finish (out, info, nargout, "inl");
  return out;
}

static octave_value_list
do_lin (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), u = a.vector ("u", S.nu), ud = a.vector ("ud", S.nu);
  reals v = a.vector_or_zero ("v", S.nv);
  int ld = std::max (1, S.nu);
  reals m = room (ld * S.nu), b = room (ld * S.nu), c = room (ld * S.nq);
  routine (S.lin, "lin") (&t, &q[0], &u[0], &ud[0], &v[0], &cst[0], &m[0], &b[0], &c[0], &ld);
  return ovl (result (m, S.nu, S.nu), result (b, S.nu, S.nu), result (c, S.nu, S.nq));
}

static octave_value_list
do_rhs (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv), xd = room (S.nx);
  int info = 0;
  routine (S.rhs, "rhs") (&t, &x[0], &v[0], &cst[0], &xd[0], &info);
  octave_value_list out = ovl (result (xd, S.nx));
  finish (out, info, nargout, "rhs");
  return out;
}

static octave_value_list
do_acc (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv);
  reals ud = room (S.nu), lam = room (S.nlam);
  int info = 0;
  routine (S.acc, "acc") (&t, &x[0], &v[0], &cst[0], &ud[0], &lam[0], &info);
  octave_value_list out = ovl (result (ud, S.nu), result (lam, S.nlam));
  finish (out, info, nargout, "acc");
  return out;
}

static octave_value_list
do_acd (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv);
  int way = a.integer_within ("way", 1, 4), info = 0;
  reals ud = room (S.nu), lam = room (S.nlam);
  routine (S.acd, "acd") (&t, &x[0], &v[0], &cst[0], &way, &ud[0], &lam[0], &info);
  octave_value_list out = ovl (result (ud, S.nu), result (lam, S.nlam));
  finish (out, info, nargout, "acd");
  return out;
}

static octave_value_list
do_tan (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), dp = room (S.nlam * S.nq), dv = room (S.nlam * S.nq);
  int ld = std::max (1, S.nlam);
  routine (S.tan, "tan") (&t, &x[0], &cst[0], &dp[0], &ld, &dv[0], &ld);
  return ovl (result (dp, S.nlam, S.nq), result (dv, S.nlam, S.nq));
}

static octave_value_list
do_prj (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), res = room (2 * S.nlam + 4);
  int info = 0;
  routine (S.prj, "prj") (&t, &x[0], &cst[0], &res[0], &info);
  octave_value_list out = ovl (result (x, S.nx), result (res, 1));
  finish (out, info, nargout, "prj");
  return out;
}

static octave_value_list
do_jac (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv);
  int ldx = std::max (1, S.nx), ldy = std::max (1, S.ny), info = 0;
  reals A = room (S.nx * S.nx), B = room (S.nx * S.nv), C = room (S.ny * S.nx),
        D = room (S.ny * S.nv);
  routine (S.jac, "jac") (&t, &x[0], &v[0], &cst[0], &A[0], &ldx, &B[0], &ldx,
                          &C[0], &ldy, &D[0], &ldy, &info);
  octave_value_list out = ovl (result (A, S.nx, S.nx), result (B, S.nx, S.nv),
                               result (C, S.ny, S.nx), result (D, S.ny, S.nv));
  finish (out, info, nargout, "jac");
  return out;
}

static octave_value_list
do_out (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv), y = room (S.ny);
  int info = 0;
  routine (S.out, "out") (&t, &x[0], &v[0], &cst[0], &y[0], &info);
  octave_value_list out = ovl (result (y, S.ny));
  finish (out, info, nargout, "out");
  return out;
}

static octave_value_list
do_cmd (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals qj = a.array ("qj", S.nu, S.nqj + 1), xi = a.vector_or_zero ("xi", S.na);
  reals v = room (S.nv), xid = room (S.na);
  int info = 0;
  routine (S.cmd, "cmd") (&t, &qj[0], &xi[0], &cst[0], &v[0], &xid[0], &info);
  octave_value_list out = ovl (result (v, S.nv), result (xid, S.na));
  finish (out, info, nargout, "cmd");
  return out;
}

static octave_value_list
do_cmx (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals qj = a.array ("qj", S.nu, S.nqj + 1), xi = a.vector_or_zero ("xi", S.na);
  reals v = room (S.nv), xid = room (S.na), xa = room (S.na), g = room (S.nmar);
  int info = 0;
  routine (S.cmx, "cmx") (&t, &qj[0], &xi[0], &cst[0], &v[0], &xid[0], &xa[0], &g[0], &info);
  octave_value_list out
      = ovl (result (v, S.nv), result (xid, S.na), result (xa, S.na), result (g, S.nmar));
  finish (out, info, nargout, "cmx");
  return out;
}

static octave_value_list
do_ctl (arguments& a, int)
{
  reals cst = a.constants ();
  int k = a.integer_within ("k", 0, S.nctl);
  number t = a.scalar ("t");
  reals y = a.vector ("y", S.ny), xk = a.vector ("xk", S.nxk), v = a.vector_or_zero ("v", S.nv);
  routine (S.ctl, "ctl") (&k, &t, &y[0], &xk[0], &cst[0], &v[0]);
  return ovl (result (v, S.nv), result (xk, S.nxk));
}

static octave_value_list
do_evt (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector ("v", S.nv), g = room (S.nev);
  std::vector<int> mode = a.modes ();
  routine (S.evt, "evt") (&t, &x[0], &v[0], &mode[0], &cst[0], &g[0]);
  return ovl (result (g, S.nev));
}

static octave_value_list
do_rst (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector ("v", S.nv);
  std::vector<int> mode = a.modes ();
  int k = a.integer_within ("k", 0, S.nev), info = 0;
  routine (S.rst, "rst") (&t, &x[0], &v[0], &mode[0], &k, &cst[0], &info);
  Matrix modes (S.nmode, 1);
  for (int i = 0; i < S.nmode; i++)
    modes(i) = mode[i];
  octave_value_list out = ovl (result (x, S.nx), modes, result (v, S.nv));
  finish (out, info, nargout, "rst");
  return out;
}

static octave_value_list
do_ctp (arguments& a, int)
{
  reals cst = a.constants (), period = room (S.nctl), delay = room (S.nctl);
  routine (S.ctp, "ctp") (&cst[0], &period[0], &delay[0]);
  return ovl (result (period, S.nctl), result (delay, S.nctl));
}

static octave_value_list
do_clo (arguments& a, int nargout)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals qj = a.array ("qj", S.nu, S.nqj + 1), res = room (2 * S.nlam + 4);
  int info = 0;
  routine (S.clo, "clo") (&t, &qj[0], &cst[0], &res[0], &info);
  octave_value_list out = ovl (result (qj, S.nu, S.nqj + 1), result (res, 1));
  finish (out, info, nargout, "clo");
  return out;
}

static octave_value_list
do_ene (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv), e = room (S.ne);
  routine (S.ene, "ene") (&t, &x[0], &v[0], &cst[0], &e[0]);
  return ovl (result (e, S.ne));
}

static octave_value_list
do_mar (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals x = a.coordinates ("x", S.nx), v = a.vector_or_zero ("v", S.nv);
  reals g = room (S.nsm), sizes = room (S.nsm);
  routine (S.mar, "mar") (&t, &x[0], &v[0], &cst[0], &g[0], &sizes[0]);
  return ovl (result (g, S.nsm), result (sizes, S.nsm));
}

static octave_value_list
do_ske (arguments& a, int)
{
  reals cst = a.constants ();
  number t = a.scalar ("t");
  reals q = a.coordinates ("q", S.nq), p = room (3 * S.np);
  routine (S.ske, "ske") (&t, &q[0], &cst[0], &p[0]);
  return ovl (result (p, 3, S.np));
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

// what all of them begin with: time, coordinates, speeds
struct batch
{
  reals cst;
  int k, ld;
  columns t, q, u;
  batch (arguments &a, bool speeds)
      : cst (a.constants ()), k (a.states_behind ("q", S.nq)), ld (columns::leading (k)), t (k, 1),
        q (k, S.nq), u (k, speeds ? S.nu : 0)
  {
    a.batch ("t", 1, k, t, true);
    a.batch ("q", S.nq, k, q, true);
    if (speeds)
      a.batch ("u", S.nu, k, u, true);
  }
};

static octave_value_list
do_inv_v (arguments& a, int)
{
  batch b (a, true);
  columns ud (b.k, S.nu), v (b.k, S.nv), tau (b.k, S.nu);
  a.batch ("ud", S.nu, b.k, ud, true);
  a.batch ("v", S.nv, b.k, v, false);
  routine (S.inv_v, "inv_v") (b.t.data (), b.q.data (), b.u.data (), ud.data (), v.data (),
                              &b.cst[0], tau.data (), &b.k, &b.ld);
  return ovl (tau.matrix (dim_vector (S.nu, b.k)));
}

static octave_value_list
do_mas_v (arguments& a, int)
{
  batch b (a, false);
  columns m (b.k, S.nu * S.nu);
  routine (S.mas_v, "mas_v") (b.t.data (), b.q.data (), &b.cst[0], m.data (), &b.k, &b.ld);
  return ovl (m.matrix (dim_vector (S.nu, S.nu, b.k)));
}

static octave_value_list
do_bia_v (arguments& a, int)
{
  batch b (a, true);
  columns v (b.k, S.nv), bias (b.k, S.nu);
  a.batch ("v", S.nv, b.k, v, false);
  routine (S.bia_v, "bia_v") (b.t.data (), b.q.data (), b.u.data (), v.data (), &b.cst[0],
                              bias.data (), &b.k, &b.ld);
  return ovl (bias.matrix (dim_vector (S.nu, b.k)));
}

static octave_value_list
do_fwd_v (arguments& a, int nargout)
{
  batch b (a, true);
  columns v (b.k, S.nv), tau (b.k, S.nu), ud (b.k, S.nu, no_number);
  a.batch ("v", S.nv, b.k, v, false);
  a.batch ("tau", S.nu, b.k, tau, false);
  std::vector<int> info (b.ld, 0);
  routine (S.fwd_v, "fwd_v") (b.t.data (), b.q.data (), b.u.data (), v.data (), tau.data (),
                              &b.cst[0], ud.data (), &info[0], &b.k, &b.ld);
  octave_value_list out = ovl (ud.matrix (dim_vector (S.nu, b.k)));
  finish_batch (out, info, b.k, nargout, "fwd_v");
  return out;
}

static octave_value_list
do_rhs_v (arguments& a, int nargout)
{
  reals cst = a.constants ();
  int k = a.states_behind ("x", S.nx), ld = columns::leading (k);
  columns t (k, 1), x (k, S.nx), v (k, S.nv), xd (k, S.nx, no_number);
  a.batch ("t", 1, k, t, true);
  a.batch ("x", S.nx, k, x, true);
  a.batch ("v", S.nv, k, v, false);
  std::vector<int> info (ld, 0);
  routine (S.rhs_v, "rhs_v") (t.data (), x.data (), v.data (), &cst[0], xd.data (), &info[0], &k,
                              &ld);
  octave_value_list out = ovl (xd.matrix (dim_vector (S.nx, k)));
  finish_batch (out, info, k, nargout, "rhs_v");
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
  routine (S.ctp, "ctp") (&cst[0], &rp[first], &rp[first + nc]);
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
      routine (S.out, "out") (&tout[k], &xout[std::size_t (ldx) * k], &vout[std::size_t (ldv) * k],
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
  gsmbp_sub rhs = audit ? routine (S.rha, "rha").f : routine (S.rhs, "rhs").f;
  bool loops = S.nlam > 0, partition = loops && (iopt[1] == 3 || iopt[1] == 6);
  bool project = iopt[1] != 1 && (iopt[1] == 3 ? S.nq > S.nu : loops || S.nq > S.nu);
  if (! library.empty ())
    project = iopt[1] != 1 && (loops || S.nq > S.nu);   // by PRJ in every way
  gsmbp_sub prj = project ? routine (S.prj, "prj").f : none;
  gsmbp_sub con = partition || (loops && iopt[2] == 1) ? routine (S.con, "con").f : none;
  iopt[4] = loops && iopt[2] == 1 && S.kin;
  gsmbp_sub kin = partition || iopt[4] ? routine (S.kin, "kin").f : none;
  gsmbp_sub cmd = ip[0] == 2 ? routine (S.cmd, "cmd").f : none;
  gsmbp_sub clo = ip[0] == 2 && ip[2] == 1 ? routine (S.clo, "clo").f : none;
  gsmbp_sub out = ip[25] > 0 && S.ny > 0 ? routine (S.out, "out").f : none;
  gsmbp_sub ctl = ip[25] > 0 ? routine (S.ctl, "ctl").f : none;
  gsmbp_sub evt = ip[27] > 0 ? routine (S.evt, "evt").f : none;
  gsmbp_sub rst = ip[27] > 0 ? routine (S.rst, "rst").f : none;
  gsmbp_sub vin = none;
  if (ip[0] == 3)
    vin = input.is_function_handle ()
          ? reinterpret_cast<gsmbp_sub> (gsmbp_call_input) : routine (S.vin, "input").f;

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
      gsmbp_run r = { rhs,
                      prj,
                      con,
                      kin,
                      cmd,
                      clo,
                      vin,
                      out,
                      ctl,
                      S.jac,
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

// A handle of gsmbp_build: subroutine, what it is asked for by in gsmbp_fortran, arguments behind
// the constants as they are typed; those without a request are for the functions of octave/ and
// for tests.
struct handle
{
  const char *name;
  octave_value_list (*call) (arguments&, int);
  gsmbp_sub gsmbp_scene::*sub;
  const char *request, *usage;
};
#define HANDLE(name, request, usage) { #name, do_##name, &gsmbp_scene::name, request, usage }
#define CALL(name) { #name, do_##name, nullptr, "", "" }
static octave_value_list do_calls (arguments&, int);

static const handle handles[]
    = {
        HANDLE (rhs, "rhs", "t, x[, v]"),
        HANDLE (inv, "inverse", "t, q, u, ud[, v]"),
        HANDLE (fwd, "forward", "t, q, u[, v[, tau]]"),
        HANDLE (mas, "mass", "t, q"),
        HANDLE (reg, "regressor", "t, q, u, ud[, v]"),
        HANDLE (bia, "bias", "t, q, u[, v]"),
        HANDLE (kin, "kinematics", "t, q, u"),
        HANDLE (con, "constraints", "t, q[, u]"),
        HANDLE (inl, "inverse_loops", "t, q, u, ud[, v]"),
        HANDLE (lin, "linear", "t, q, u, ud[, v]"),
        HANDLE (prj, "projection", "t, x"),
        HANDLE (jac, "jacobian", "t, x[, v]"),
        HANDLE (out, "output", "t, x[, v]"),
        HANDLE (cmd, "command", "t, qj[, xi]"),
        HANDLE (cmx, "command_states", "t, qj[, xi]"),
        HANDLE (ctl, "control", "k, t, y, xk[, v]"),
        HANDLE (ctp, "control", ""),
        HANDLE (evt, "events", "t, x, v, mode"),
        HANDLE (rst, "events", "t, x, v, mode, k"),
        HANDLE (clo, "closure", "t, qj"),
        HANDLE (ene, "energy", "t, x[, v]"),
        HANDLE (acc, "accelerations", "t, x[, v]"),
        HANDLE (acd, "dense", "t, x, v, way"),
        HANDLE (tan, "tangent", "t, x"),
        HANDLE (mar, "margins", "t, x[, v]"),
        HANDLE (ske, "skeleton", "t, q"),
        HANDLE (inv_v, "batch", "t, q, u, ud[, v]"),
        HANDLE (mas_v, "batch", "t, q"),
        HANDLE (bia_v, "batch", "t, q, u[, v]"),
        HANDLE (fwd_v, "batch", "t, q, u[, v[, tau]]"),
        HANDLE (rhs_v, "batch", "t, x[, v]"),
        CALL (sim),
        CALL (par),
        CALL (pre),
        CALL (meaning),
        CALL (spline),
        CALL (kkt),
        CALL (solve),
        CALL (calls)
      };

// the names of the handles that a user may call
static octave_value_list
do_calls (arguments&, int)
{
  string_vector names;
  for (const auto& entry : handles)
    if (entry.usage[0])
      names.append (std::string (entry.name));
  return octave_value (Cell (names));
}

static octave_value_list
dispatch (const std::string& call, const octave_value_list& args, int nargout)
{
  for (const auto& entry : handles)
    if (call == entry.name)
      {
        arguments a (args, call, entry.usage);
        if (entry.sub && ! (S.*(entry.sub)))
          absent (call, entry.request);
        if (entry.sub)
          a.count_given ();
        return entry.call (a, nargout);
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

DEFUN_DLD (gsmbp_module, args, nargout,
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
