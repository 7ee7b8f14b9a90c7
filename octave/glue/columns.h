// Arrays over many states, as the batches read and write them.
#pragma once

#include "numbers.h"

// whether a set of Euler parameters is all zero, which is no orientation; STEP: between two numbers
static bool
no_orientation (const number *x, int set, std::size_t step)
{
  for (int i = 0; i < 4; i++)
    if (x[step * (S.sets[4*set+i] - 1)] != 0)
      return false;
  return true;
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
        if (no_orientation (data () + j, set, m_ld))
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
