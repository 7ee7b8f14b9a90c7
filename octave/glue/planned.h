// The whole motion of which some coordinates are planned (host/planned.h), for gsmbp_inverse.
#pragma once

#include "arguments.h"
#include "host/planned.h"

static octave_value
pages (const reals& x, int rows, int columns, int pages)
{
  NDArray list (dim_vector (rows, columns, pages));
  std::copy_n (x.begin (), list.numel (), list.fortran_vec ());
  return list;
}

// (constants, nominal magnitudes, times, side, order, planned coordinates, breaks, coefficients of
// the plan, guess of the coordinates, states of the devices at the first time, whether internal
// ones are carried): motion (nu,1+order,times), states of the devices; how many times were found,
// why no more, the verdict
static octave_value_list
do_planned (arguments& a, int)
{
  const reals cst = a.constants ();
  const Matrix nominal = a.matrix ("nominal", S.nx, 1);
  const reals t = a.vector ("times", -1);
  const int n = int (t.size ()), rest = S.nx - S.nq - S.nu;
  gs_planned_asked asked = gs_planned_asked ();
  asked.side = a.integer_within ("side", -1, 1);
  asked.order = a.integer_within ("order", 1, 100);
  const std::vector<int> planned = a.integers ("planned", -1);
  const reals breaks = a.vector ("breaks", -1);
  const Matrix plan = a.matrix ("coefficients", -1, -1);
  const reals guess = a.vector ("guess", S.nu), devices = a.vector ("devices", rest);
  asked.carry = a.integer_within ("carry", 0, 1);
  if (S.nlam > 0 && int (planned.size ()) < S.nu)
    routine ("clo");
  const reals coefficients (plan.data (), plan.data () + plan.numel ());
  asked.cst = &cst[0];
  asked.nplanned = int (planned.size ());
  asked.planned = planned.data ();
  asked.pieces = int (breaks.size ()) - 1;
  asked.powers = int (plan.columns ());
  asked.breaks = &breaks[0];
  asked.coefficients = coefficients.data ();
  asked.guess = &guess[0];
  asked.devices = &devices[0];
  asked.n = n;
  asked.t = &t[0];
  gs_description about = *S.about;
  about.nominal = nominal.data ();
  reals qj (std::size_t (S.nu) * (1 + asked.order) * n + 1, number (0));
  reals xi (std::size_t (rest) * n + 1, number (0));
  gs_planned_found found = { &qj[0], &xi[0], 0, "" };
  const int verdict = gs_whole_motion (&about, &asked, &found);
  if (verdict == 1)
    throw std::bad_alloc ();
  return ovl (pages (qj, S.nu, 1 + asked.order, n), result (xi, rest, n), found.done, found.text,
              verdict);
}
