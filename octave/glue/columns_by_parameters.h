// A run that carries derivatives of the states by parameters: GSSEN stands for RHS, and behind PRJ
// comes GSSPJ.
#pragma once

#include "run_plan.h"

// What the two wrappers know beside their arguments: Fortran's externals carry nothing.
struct carried
{
  std::vector<int> col;   // of each column of S the column of RHP, 0 for a start value
  gsmbp_sub rhp, prj, con, tan, cop;
  int top;                // coordinates whose rates are the speeds
  reals w, w2;
  std::vector<int> iw;

  int count (void) const { return int (col.size ()); }
};

static carried *the_columns = nullptr;   // only while a run lasts

extern "C" void
gsmbp_rates_with_columns (const number *t, const number *x, const number *v, const number *cst,
                          number *xd, int *info)
{
  carried& c = *the_columns;
  const int nc = c.count ();
  fortran {gssen_} (c.rhp, t, &c.top, &S.nx, &S.nv, &S.nsp, &nc, &c.col[0], x, v, cst, &c.w[0], xd,
                    info);
}

extern "C" void
gsmbp_projection_with_columns (const number *t, number *x, const number *cst, number *res,
                               int *info)
{
  carried& c = *the_columns;
  const int nc = c.count ();
  fortran {c.prj} (t, x, cst, res, info);
  if (*info == 0 || *info == 2)
    fortran {gsspj_} (c.con, c.tan, c.cop, t, &S.nx, &S.nq, &S.nu, &S.nlam, &S.nsets, S.sets,
                      &S.nsp, &nc, &c.col[0], x, cst, &c.w2[0], &c.iw[0], info);
}

// are the speeds the rates of the coordinates? Two positions by chance tell, exactly.
static bool
plain_speeds (const reals& cst)
{
  if (S.nq != S.nu || ! emitted ("kin"))
    return false;
  reals q = room (S.nq), u = room (S.nu), rates = room (S.nq);
  bool plain = true;
  for (int k = 1; k <= 2; k++)
    {
      const number t = number (0.37) * k;
      for (int i = 0; i < S.nq; i++)
        {
          q[i] = std::sin (double (7 * k + 3 * i)) * 0.9;
          u[i] = std::cos (double (5 * k + 2 * i)) * 0.8;
        }
      routine ("kin") (&t, &q[0], &u[0], &cst[0], &rates[0]);
      plain = plain && rates == u;
    }
  return plain;
}

// the columns of a run by their numbers
static std::unique_ptr<carried>
columns_of (const Matrix& numbers, const reals& cst)
{
  std::unique_ptr<carried> c (new carried ());
  const int nc = int (numbers.numel ());
  if (nc == 0)
    return c;
  for (int k = 0; k < nc; k++)
    {
      c->col.push_back (int (numbers(k)));
      if (c->col[k] < 0 || c->col[k] > S.nsp)
        error ("%s: there is no column %d among %d", S.name, c->col[k], S.nsp);
    }
  const bool loops = S.nlam > 0;
  const int rows = S.nlam + S.nsets;
  c->top = plain_speeds (cst) ? S.nq : 0;
  c->rhp = routine ("rhp").f;
  c->con = loops ? routine ("con").f : gsmbp_absent;
  c->tan = loops ? routine ("tan").f : gsmbp_absent;
  c->cop = loops ? routine ("cop").f : gsmbp_absent;
  c->w = room (S.nx * (S.nx + S.nsp + S.nv + 1));
  c->w2 = room (rows * (S.nq + rows + nc) + S.nlam * (S.nq + S.nu + 2 * S.nsp + 3));
  c->iw.assign (rows + 1, 0);
  return c;
}
