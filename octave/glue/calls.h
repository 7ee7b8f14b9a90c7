// The emitted subroutines, called at one state or at many.
#pragma once

#include "info.h"
#include "signature.h"

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
  if (s.name == "q" || s.name == "x")
    return a.coordinates (name, s.rows);
  if (! s.needed)
    a.no_mode_left_out (name);
  reals x = s.needed ? a.vector (name, s.rows) : a.vector_or_zero (name, s.rows);
  if (s.name == "v")
    a.modes_among (1, [&] (int i, int) { return x[i]; });
  return x;
}

// whole numbers that come back
static Matrix
counted (const std::vector<int>& counts)
{
  Matrix m (counts.size (), 1);
  for (std::size_t i = 0; i < counts.size (); i++)
    m(i) = counts[i];
  return m;
}

// a subroutine at one state
static octave_value_list
call_once (const signature& g, gsmbp_sub f, arguments& a, int nargout)
{
  std::size_t n = g.slots.size ();
  reals numbers[most_slots];
  std::vector<int> counts[most_slots];
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
      else if (s.what == slot::counts)
        {
          counts[i].assign (std::max (1, s.room), 0);
          places[i] = counts[i].data ();
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
      out(k) = s.what == slot::modes    ? counted (mode)
               : s.what == slot::counts ? counted (counts[i])
                                        : result (numbers[i], s.rows, s.cols);
    }
  for (std::size_t i = 0; i < n; i++)
    if (g.slots[i].what == slot::indicator)
      finish (out, wholes[i], nargout, a.call ().c_str ());
  return out;
}

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

// the next argument for the states of a handle of one, a column for each; one column is of all
static Matrix
read_many (arguments& a, const slot& s, int& k)
{
  int n = s.rows * s.cols;
  if (! s.needed && ! a.more ())
    {
      read (a, s);
      return Matrix (n, 1, 0.0);
    }
  Matrix x = a.matrix (s.name.c_str (), n, -1);
  int given = int (x.columns ());
  if (s.name == "v")
    a.modes_among (given, [&] (int i, int j) { return x(i, j); });
  if (k == 1)
    k = given;
  if (given != k && given != 1)
    error ("%s: argument %s: expected %d columns (or one for all), found %d", a.who ().c_str (),
           s.name.c_str (), k, given);
  return x;
}

// A subroutine of one state, called at K: what is given for all of them, what is found, and the
// numbers of one.
class many
{
public:

  many (const signature& g, arguments& a)
    : m_slots (g.slots), m_call (a), m_cst (a.constants ()), m_k (1)
  {
    for (std::size_t i = 0; i < m_slots.size (); i++)
      {
        const slot& s = m_slots[i];
        bool real = s.what == slot::real;
        if (! real && s.what != slot::constants && s.what != slot::leading
            && s.what != slot::indicator)
          error ("%s: it is called at one state", a.who ().c_str ());
        m_one[i] = room (real ? s.room : 1);
        if (s.in)
          m_given[i] = read_many (a, s, m_k);
        m_whole[i] = s.rows;
        m_places[i] = real ? static_cast<void *> (m_one[i].data ())
                      : s.what == slot::constants ? static_cast<void *> (m_cst.data ())
                                                  : &m_whole[i];
      }
    for (std::size_t i = 0; i < m_slots.size (); i++)
      m_found[i] = NDArray (m_slots[i].cols > 1
                            ? dim_vector (m_slots[i].rows, m_slots[i].cols, m_k)
                            : dim_vector (m_slots[i].rows, m_k), 0.0);
  }

  int states (void) const { return m_k; }

  void call_at (gsmbp_sub f, int state)
  {
    std::size_t n = m_slots.size ();
    for (std::size_t i = 0; i < n; i++)
      if (m_slots[i].in)
        {
          const Matrix& x = m_given[i];
          std::copy_n (x.data () + (x.columns () > 1 ? state * x.rows () : 0), x.rows (),
                       m_one[i].begin ());
          if (m_slots[i].name == "q" || m_slots[i].name == "x")
            m_call.with_orientation (m_slots[i].name.c_str (), &m_one[i][0]);
        }
    call (f, m_places, n);
    for (std::size_t i = 0; i < n; i++)
      if (m_slots[i].what == slot::indicator)
        m_found[i](state) = m_whole[i];
      else if (m_slots[i].out)
        {
          octave_idx_type size = m_slots[i].rows * m_slots[i].cols;
          double *to = m_found[i].fortran_vec () + state * size;
          for (octave_idx_type j = 0; j < size; j++)
            to[j] = double (m_one[i][j]);
        }
  }

  // with a column (a page where one is a matrix) for each state
  const NDArray& found (std::size_t slot) const { return m_found[slot]; }

private:

  const std::vector<slot>& m_slots;
  arguments& m_call;
  reals m_cst, m_one[most_slots];
  Matrix m_given[most_slots];
  NDArray m_found[most_slots];
  void *m_places[most_slots];
  int m_k, m_whole[most_slots];
};

// the results, then the indicators
static octave_value_list
call_many (const signature& g, gsmbp_sub f, arguments& a)
{
  many all (g, a);
  for (int j = 0; j < all.states (); j++)
    all.call_at (f, j);
  octave_value_list out;
  for (std::size_t i : g.results)
    out.append (all.found (i));
  for (std::size_t i = 0; i < g.slots.size (); i++)
    if (g.slots[i].what == slot::indicator)
      out.append (all.found (i));
  return out;
}
