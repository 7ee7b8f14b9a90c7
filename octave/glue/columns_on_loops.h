// What an event of the user sets in a closed chain: the other coordinates and speeds follow from
// the constraints.  Where these leave a choice, which the projection of the state decides, there
// are no derivatives: columns are given up.
#pragma once

#include "columns_through_resets.h"

// constraints on coordinates and their rates at a state, as rows on S: A*S + b = 0
struct loop_rows
{
  reals dp, dv, hc, phit, gam, pp, pv, qdot;
  int info = 0;

  loop_rows (carried& c, number t, const number *x)
  {
    const int m = S.nlam, ld = m;
    const number *cst = &(*c.cst)[0];
    reals phi = room (m);
    phit = gam = phi;
    dp = dv = room (m * S.nq);
    hc = room (m * S.nu);
    pp = pv = room (m * S.nsp);
    qdot.assign (x + S.nq, x + S.nq + S.nu);
    routine ("con") (&t, x, x + S.nq, cst, &phi[0], &phit[0], &hc[0], &ld, &gam[0], &info);
    routine ("tan") (&t, x, cst, &dp[0], &ld, &dv[0], &ld);
    routine ("cop") (&t, x, cst, &pp[0], &ld, &pv[0], &ld);
    if (emitted ("kin"))
      routine ("kin") (&t, x, x + S.nq, cst, &qdot[0]);
  }
};

// Numbers of a small dense system A*y + r = 0, M x N, for several right sides.
struct small_system
{
  int m, n, sides;
  reals a;   // rows of N + SIDES numbers

  small_system (int rows, int unknowns, int right)
    : m (rows), n (unknowns), sides (right), a (room (rows * (unknowns + right))) { }

  number& at (int i, int j) { return a[i * (n + sides) + j]; }

  // y where A has N independent columns, in the rows WHERE (j) ends up in
  bool solve (std::vector<int>& where);

private:

  void eliminate (int row, int column);
};

void
small_system::eliminate (int row, int column)
{
  for (int i = 0; i < m; i++)
    {
      const number f = i == row ? number (0) : at (i, column) / at (row, column);
      for (int j = 0; j < n + sides && f != 0; j++)
        at (i, j) -= f * at (row, j);
    }
}

bool
small_system::solve (std::vector<int>& where)
{
  std::vector<char> used (m, 0);
  number first = 0;
  where.assign (n, -1);
  for (int k = 0; k < n; k++)
    {
      int row = -1, column = -1;
      number most = 0;
      for (int i = 0; i < m; i++)
        for (int j = 0; j < n && ! used[i]; j++)
          if (where[j] < 0 && magnitude (at (i, j)) > most)
            {
              most = magnitude (at (i, j));
              row = i;
              column = j;
            }
      first = std::max (first, most);
      if (! (most > number (1e-9) * first))
        return false;
      used[row] = 1;
      where[column] = row;
      eliminate (row, column);
    }
  return true;
}

// Do rows A (M x N) of all columns hold, A*s + B = 0, s from place FROM of a state on?
static bool
rows_hold (const carried& c, const number *x, int from, int n, const reals& a, const reals& b)
{
  const int m = S.nlam;
  for (int k = 0; k < c.count (); k++)
    for (int i = 0; i < m; i++)
      {
        number sum = b[i + m * k], size = magnitude (sum);
        for (int j = 0; j < n; j++)
          {
            const number part = a[i + m * j] * x[S.nx * (k + 1) + from + j];
            sum += part;
            size += magnitude (part);
          }
        if (magnitude (sum) > number (1e-9) * size)
          return false;
      }
  return true;
}

// those of N places from FROM on that the event has not set follow from A*s + B = 0; false: these
// leave a choice
static bool
follow (const carried& c, number *x, int from, int n, const std::vector<char>& set, const reals& a,
        const reals& b)
{
  const int m = S.nlam;
  std::vector<int> free, where;
  for (int j = 0; j < n; j++)
    if (! set[from + j])
      free.push_back (j);
  small_system y (m, int (free.size ()), c.count ());
  for (int i = 0; i < m; i++)
    {
      for (int j = 0; j < y.n; j++)
        y.at (i, j) = a[i + m * free[j]];
      for (int k = 0; k < c.count (); k++)
        {
          y.at (i, y.n + k) = b[i + m * k];
          for (int j = 0; j < n; j++)
            if (set[from + j])
              y.at (i, y.n + k) += a[i + m * j] * x[S.nx * (k + 1) + from + j];
        }
    }
  if (! y.solve (where))
    return false;
  for (int k = 0; k < c.count (); k++)
    for (int j = 0; j < y.n; j++)
      x[S.nx * (k + 1) + from + free[j]] = -y.at (where[j], y.n + k) / y.at (where[j], j);
  return true;
}

// what stands beside S in the rows on coordinates, or on speeds, along the motion
static reals
beside_columns (const carried& c, const loop_rows& r, const number *x, bool speeds)
{
  const int m = S.nlam;
  reals b = room (m * c.count ());
  for (int k = 0; k < c.count (); k++)
    for (int i = 0; i < m; i++)
      {
        number& sum = b[i + m * k];
        number by_time = speeds ? -r.gam[i] : r.phit[i];
        const reals& by = speeds ? r.pv : r.pp;
        sum = c.col[k] > 0 ? by[i + m * (c.col[k] - 1)] : number (0);
        for (int j = 0; j < S.nq && speeds; j++)
          {
            by_time -= r.dv[i + m * j] * r.qdot[j];
            sum += r.dv[i + m * j] * x[S.nx * (k + 1) + j];
          }
        sum += by_time * c.tau[k];
      }
  return b;
}

// has the projection moved the N states from FROM on?
static bool
is_moved (const number *x, const reals& xa, int from, int n)
{
  for (int i = from; i < from + n; i++)
    if (! (magnitude (x[i] - xa[i]) <= number (1e-9) * (1 + magnitude (xa[i]))))
      return true;
  return false;
}

// S onto the constraints before an event, where a step up to it has left them
static void
onto_loops (carried& c, number t, number *x)
{
  const int nc = c.count ();
  int info = 0;
  if (S.nlam > 0)
    fortran {gsspj_} (c.con, c.tan, c.cop, &t, &S.nx, &S.nq, &S.nu, &S.nlam, &S.nsets, S.sets,
                      &S.nsp, &nc, &c.col[0], x, &(*c.cst)[0], &c.w2[0], &c.iw[0], &info);
}

// do coordinates (FROM = 0) or speeds follow from what an event has set, SET, and rows A*s + B = 0?
static bool
fit (const carried& c, number *x, const user_change& u, int from, const std::vector<char>& set,
     const reals& a, const reals& b)
{
  const int n = from == 0 ? S.nq : S.nu;
  const bool moved = is_moved (x, u.xa, from, n);
  if (! moved && ! std::count (set.begin (), set.begin () + from + n, 1))
    return true;
  return (! moved && rows_hold (c, x, from, n, a, b)) || follow (c, x, from, n, set, a, b);
}

// S behind an event of the user, K, that sets states of a closed chain
static void
through_loops (carried& c, number t, number *x, const user_change& u, int k)
{
  if (S.nlam == 0 || ! u.sets_states ())
    return;
  loop_rows r (c, t, x);
  std::vector<char> set (S.nx, 0);
  for (int i = 0; i < S.nx; i++)
    set[i] = u.sets (i);
  const bool good = r.info == 0
                    && fit (c, x, u, 0, set, r.dp, beside_columns (c, r, x, false))
                    && fit (c, x, u, S.nq, set, r.hc, beside_columns (c, r, x, true));
  for (int j = 0; j < c.count () && ! good; j++)
    give_up (c, x, j, t, k, r.info != 0 ? c.no_numbers : c.left_open);
}
