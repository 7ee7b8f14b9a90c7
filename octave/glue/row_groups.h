// The constants of runs in lanes, of sixteen at once by PRE_W.  A thread takes the next rows of the
// table as a group; where there are none it takes rows of the groups of others, so that no row
// waits for a thread while another one is idle.
#pragma once

#include "lane_group.h"

#include <atomic>
#include <thread>

class row_group;

// the parameters that differ from run to run: of each column the number, and the values, a row of
// TABLE for each run
struct varied_rows
{
  int n;
  std::vector<int> which;
  const double *table;
  std::ptrdiff_t next_row, next_column;

  double operator () (int i, std::size_t column) const
  {
    return table[i * next_row + std::ptrdiff_t (column) * next_column];
  }
};

// a run, and its place in the group that has its constants; no group: PRE is to be called
struct known_row
{
  int i;
  const row_group *group;
  int place;
};

#if ! defined (GSMBP_QUAD)

class row_group
{
public:

  explicit row_group (const reals& common)
    : m_left (0), m_size (0), m_first (0), m_info {}, m_par (S.npar), m_cst (S.ncst)
  {
    for (int j = 0; j < lane_count; j++)
      m_par.put (j, common.data (), S.npar);
  }

  bool take (known_row& row);
  bool fill (const varied_rows& rows, std::atomic<int>& next, int most, bool over);

  int constants (int place, reals& cst) const
  {
    m_cst.get (place, &cst[0], S.ncst);
    return m_info[place];
  }

private:

  void know (const varied_rows& rows);

  std::atomic<int> m_left;   // rows that nobody has taken; -1: their constants are not known yet
  int m_size, m_first, m_info[lane_count];
  lane_array m_par, m_cst;
};

// the next of its rows, by any thread; false: it has none
bool
row_group::take (known_row& row)
{
  int left = m_left;
  do
    {
      for (; left < 0; left = m_left)   // a matter of microseconds
        std::this_thread::yield ();
      if (left == 0)
        return false;
    }
  while (! m_left.compare_exchange_weak (left, left - 1));
  row.group = this;
  row.place = m_size - left;
  row.i = m_first + row.place;
  return true;
}

// By its own thread, when it has none: the next rows of the table, at most MOST.  It is marked
// before they are taken, so that who finds the table empty finds the last ones here.
bool
row_group::fill (const varied_rows& rows, std::atomic<int>& next, int most, bool over)
{
  m_left = -1;
  const int first = next < rows.n ? int (next.fetch_add (most)) : rows.n;
  const int size = std::max (0, std::min (most, rows.n - first));
  if (size > 0)
    {
      m_first = first;
      m_size = size;
      if (! over)
        know (rows);
    }
  m_left = size;
  return size > 0;
}

// Always sixteen sets of parameters, so that the bits of a run are those of any group: the first
// row stands in the places behind the last one.  What PRE_W leaves is done by PRE.
void
row_group::know (const varied_rows& rows)
{
  const int k = lane_count;
  for (std::size_t c = 0; c < rows.which.size (); c++)
    for (int j = 0; j < lane_count; j++)
      m_par(rows.which[c] - 1, j) = rows(m_first + (j < m_size ? j : 0), c);
  fortran {emitted ("pre_w")->sub} (m_par.begin (), m_cst.begin (), m_info, &k, &k);
  for (int j = 0; j < m_size; j++)
    if (m_info[j] != 0)
      {
        reals par = room (S.npar), cst = room (S.ncst);
        m_par.get (j, &par[0], S.npar);
        fortran {emitted ("pre")->sub} (&par[0], &cst[0], &m_info[j]);
        m_cst.put (j, &cst[0], S.ncst);
      }
}

// those of all threads
class row_groups
{
public:

  // over: whether all is to end
  row_groups (const varied_rows& rows, const reals& common, int threads, int most,
              bool (*over) (void))
    : m_rows (rows), m_most (std::min (most, lane_count)), m_over (over), m_next (0)
  {
    for (int k = 0; k < threads; k++)
      m_groups.emplace_back (new row_group (common));
  }

  // the next row of a thread; false: all are taken
  bool next (int thread, known_row& row)
  {
    row_group& own = *m_groups[thread];
    if (own.take (row) || (own.fill (m_rows, m_next, m_most, m_over ()) && own.take (row)))
      return true;
    return std::any_of (m_groups.begin (), m_groups.end (),
                        [&] (const std::unique_ptr<row_group>& g) { return g->take (row); });
  }

private:

  const varied_rows m_rows;
  const int m_most;                  // rows of a group
  bool (*const m_over) (void);
  std::atomic<int> m_next;
  std::vector<std::unique_ptr<row_group>> m_groups;
};

// the next row of a thread, of GROUPS or, where there are none, of those that NEXT counts; false:
// all N are taken
static bool
next_row (row_groups *groups, int thread, std::atomic<int>& next, int n, known_row& row)
{
  if (groups)
    return groups->next (thread, row);
  row = { next++, nullptr, 0 };
  return row.i < n;
}

#endif
