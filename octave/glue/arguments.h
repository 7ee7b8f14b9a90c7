// What Octave hands over, one argument after the other: checked, with an error that names the
// argument, and copied where the Fortran reads it.
#pragma once

#include "columns.h"

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

  // coordinates, alone or before speeds and others
  reals coordinates (const char *name, int size)
  {
    reals x = vector (name, size);
    with_orientation (name, &x[0]);
    return x;
  }

  // Euler parameters that are all zero are no orientation
  void with_orientation (const char *name, const number *x) const
  {
    for (int k = 0; k < S.nsets; k++)
      if (no_orientation (x, k, 1))
        error ("%s: argument %s: expected Euler parameters of length 1 in %s(%d), %s(%d), %s(%d), "
               "%s(%d), found zeros, which are no orientation",
               who ().c_str (), name, name, S.sets[4 * k], name, S.sets[4 * k + 1], name,
               S.sets[4 * k + 2], name, S.sets[4 * k + 3]);
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

  // Inputs that are not given are zero; a mode cannot be: 0 is a stick or a lift-off.  Energies
  // (not the power that is lost), stops and margins are the same in all modes.
  void no_mode_left_out (const char *name) const
  {
    if (m_call == "ene" || m_call == "hld" || m_call == "mar")
      return;
    for (int i = 0; i < S.nmode && name == std::string ("v") && ! more (); i++)
      if (S.modes[i] > 0)
        error ("%s: argument v is missing: expected the inputs; v(%d) is the mode (-1, 0 or 1) of "
               "a device with events, without which its friction or contact would be left out",
               who ().c_str (), S.modes[i]);
  }

  // those among the inputs of K states, v (number of the input, state), both from 0; what is no
  // number is let through
  template <typename F> void modes_among (int k, F v) const
  {
    for (int i = 0; i < S.nmode; i++)
      for (int j = 0; j < k && S.modes[i] > 0; j++)
        {
          double mode = double (v (S.modes[i] - 1, j));
          if (! (mode == 0 || std::fabs (mode) == 1 || std::isnan (mode)))
            error ("%s: argument v(%d), a mode: expected -1, 0 or 1, found %g", who ().c_str (),
                   S.modes[i], mode);
        }
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
  void batch (const char *name, int rows, int k, columns& x, bool needed)
  {
    if (! needed && ! more ())
      {
        no_mode_left_out (name);
        m_next++;
        return;
      }
    int given = states (name, rows);
    if (given != k && given != 1)
      error ("%s: argument %s: expected %d columns (or one for all), found %d", who ().c_str (),
             name, k, given);
    Matrix m = m_args(m_next++).matrix_value ();
    const double *from = m.data ();
    std::size_t step = given == 1 ? 0 : rows;
    x.each ([&] (number& y, int i, int j) { y = from[i + step * j]; });
    if (name == std::string ("v"))
      modes_among (given, [&] (int i, int j) { return from[i + step * j]; });
    if (rows == S.nq || rows == S.nx)
      x.without_orientation (k, name[0] == 'q' || name[0] == 'x');
  }

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
