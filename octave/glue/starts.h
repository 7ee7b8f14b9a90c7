// How a run starts (host/start.h), for the functions of octave/.
#pragma once

#include "arguments.h"
#include "numbers.h"
#include "host/start.h"

// (constants, parameters, time, states, nominal magnitudes): a start that is asked for
struct asked_start
{
  const reals cst;
  const Matrix par;
  const number t;
  reals x;
  const Matrix nominal;
  gs_description about;
  gs_start_given given;

  asked_start (arguments& a)
    : cst (a.constants ()), par (a.matrix ("par", S.npar, 1)), t (a.value ("t").double_value ()),
      x (states_of (a)), nominal (a.matrix ("nominal", S.nx, 1)), about (*S.about),
      given (gs_start_given ())
  {
    about.nominal = nominal.data ();
    given.t = t;
    given.cst = &cst[0];
    given.par = par.data ();
  }

private:

  // what is not finite is found by residuals
  static reals states_of (arguments& a)
  {
    const Matrix m = a.value ("x").matrix_value ();
    if (m.numel () != S.nx)
      error ("%s: argument %s: expected %d number%s, found %s", a.who ().c_str (), "x", S.nx,
             S.nx == 1 ? "" : "s", m.dims ().str ().c_str ());
    return reals (m.data (), m.data () + S.nx);
  }
};

// (those of asked_start, whether the state must be on the constraints): the state on them; a struct
// of the verdict (gsmbp/failures.h) and the number of the state that it is of; its message
static octave_value_list
do_start (arguments& a, int)
{
  asked_start s (a);
  s.given.check = a.integer_within ("check", 0, 1);
  gs_start found;
  if (gs_close_start (&s.about, &s.given, &s.x[0], &found) == GS_START_TAKEN && s.given.check)
    gs_check_margins (&s.about, &s.given, &s.x[0], &found);
  octave_scalar_map start;
  start.assign ("verdict", found.verdict);
  start.assign ("state", found.state + 1);
  return ovl (result (s.x, S.nx), start, found.text);
}

// (those of asked_start): the state with its settled states where their rates vanish
static octave_value_list
do_settle (arguments& a, int)
{
  asked_start s (a);
  gs_settle_states (&s.about, s.t, &s.cst[0], nullptr, &s.x[0]);
  return ovl (result (s.x, S.nx));
}

// (those of asked_start): the residuals relative to nominal magnitudes and in units of their rows,
// the names of the rows
static octave_value_list
do_residuals (arguments& a, int)
{
  asked_start s (a);
  const int n = gs_residual_rows (&s.about);
  ColumnVector scaled (n), found (n);
  gs_residuals (&s.about, s.t, &s.x[0], &s.cst[0], scaled.fortran_vec (), found.fortran_vec ());
  Cell names (n, 1);
  for (int k = 0; k < n; k++)
    {
      char name[300];
      gs_residual_name (&s.about, k, name, sizeof name);
      names(k) = name;
    }
  return ovl (scaled, found, names);
}

// (scaled, found, limit): the rows above the limit, the worst first, as text
static octave_value_list
do_worst (arguments& a, int)
{
  const Matrix scaled = a.value ("scaled").matrix_value ();
  const Matrix found = a.value ("found").matrix_value ();
  const double limit = a.value ("limit").double_value ();
  char text[2000];
  if (scaled.numel () != gs_residual_rows (S.about) || found.numel () != scaled.numel ())
    error ("%s: expected %d residuals", a.who ().c_str (), gs_residual_rows (S.about));
  gs_worst_residuals (S.about, scaled.data (), found.data (), limit, text, sizeof text);
  return ovl (text);
}

// (constants, number of times, times, states, inputs, parameters, nominal magnitudes): the margins
// of devices that are passed: their numbers, the numbers of the first times, the least values, the
// messages
static octave_value_list
do_passed_margins (arguments& a, int)
{
  const given_run r (a, true);
  const Matrix par = a.matrix ("par", S.npar, 1), nominal = a.matrix ("nominal", S.nx, 1);
  gs_description about = *S.about;
  about.nominal = nominal.data ();
  std::vector<gs_passed_margin> list (about.nmargins + 1);
  const int n = gs_margins_of_run (&about, r.k, &r.t[0], r.states (0), S.nx, r.inputs (0), S.nv,
                                   &r.cst[0], list.data ());
  if (n < 0)
    throw std::bad_alloc ();
  RowVector numbers (n), first (n), least (n);
  Cell texts (1, n);
  for (int i = 0; i < n; i++)
    {
      char text[600];
      gs_margin_text (&about, list[i].k, list[i].least, r.states (list[i].at), par.data (), text,
                      sizeof text);
      numbers(i) = list[i].k + 1;
      first(i) = list[i].first + 1;
      least(i) = list[i].least;
      texts(i) = text;
    }
  return ovl (numbers, first, least, texts);
}
