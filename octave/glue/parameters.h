// The parameters of a scene and the constants that PRE makes of them.
#pragma once

#include "info.h"

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
# if LDBL_MANT_DIG == 113
  return std::strtold (text, nullptr);
# else
  return strtoflt128 (text, nullptr);
# endif
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

// the values of the scene, and those of `given`, where they are others
static reals
parameter_values (const Matrix& given, int column)
{
  reals par = room (S.npar);
  routine ("par") (&par[0]);
  for (int i = 0; i < S.npar; i++)
    if (double (par[i]) != given(i,column))
      par[i] = decimal (given(i,column));
  return par;
}

// a gs_pre that is told parameters in double precision: those of the scene are the scene's, others
// the decimals that they are read from
extern "C" int
gsmbp_exact_constants (const number *par, number *cst)
{
#if defined (GSMBP_QUAD)
  Matrix given (S.npar, 1);
  std::transform (par, par + S.npar, given.fortran_vec (), [] (number x) { return double (x); });
  return gsmbp_constants (parameter_values (given, 0).data (), cst);
#else
  return gsmbp_constants (par, cst);
#endif
}

static octave_value_list
do_pre (arguments& a, int nargout)
{
  reals par = parameter_values (a.matrix ("par", S.npar, 1), 0);
  reals cst = room (S.ncst);
  int info = 0;
  routine ("pre") (&par[0], &cst[0], &info);
  uint8NDArray bytes (dim_vector (cst.size () * sizeof (number), 1));
  std::memcpy (static_cast<void *> (bytes.fortran_vec ()), &cst[0], bytes.numel ());
  octave_value_list out = ovl (bytes);
  finish (out, info, nargout, "pre");
  return out;
}

// par (npar x n), number of rules -> the values of the rules (rules x n), the number of the first
// rule that each column breaks, INFO of CHK (1 x n)
static octave_value_list
do_chk (arguments& a, int)
{
  const Matrix given = a.value ("par").matrix_value ();
  const int rules = a.integers ("rules", 1)[0], n = given.columns ();
  if (given.rows () != S.npar)
    error ("%s.chk: argument par: expected %d rows, found %d", S.name, S.npar, int (given.rows ()));
  Matrix values (rules, n), first (1, n), infos (1, n);
  for (int j = 0; j < n; j++)
    {
      reals par = parameter_values (given, j), r = room (rules);
      int k = 0, info = 0;
      routine ("chk") (&par[0], &r[0], &k, &info);
      for (int i = 0; i < rules; i++)
        values(i,j) = double (r[i]);
      first(j) = k;
      infos(j) = info;
    }
  return ovl (values, first, infos);
}

// par, numbers of links and of derivatives of masses -> the initial state, masses, derivatives
static octave_value_list
do_ini (arguments& a, int)
{
  reals par = parameter_values (a.matrix ("par", S.npar, 1), 0);
  std::vector<int> sizes = a.integers ("sizes", 2);
  reals x = room (S.nx), w = room (sizes[0]), d = room (sizes[1]);
  routine ("ini") (&par[0], &x[0], &w[0], &d[0]);
  return ovl (result (x, S.nx), result (w, sizes[0]), result (d, sizes[1]));
}
