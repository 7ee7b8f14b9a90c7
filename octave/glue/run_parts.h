// What a run calls of Octave: inputs of the user, patience, the library of CVODE; parts of a run at
// many states.
#pragma once

#include "arguments.h"
#include "patience.h"

// Inputs by a function of the user in Octave, v = f (t, x).  An exception may not cross the frames
// of C; it is kept and thrown again behind the run.
struct octave_inputs
{
  octave_value f;
  std::exception_ptr failure;
};

// a gs_vin whose data are such
extern "C" int
gsmbp_octave_inputs (number t, int, const number *x, int nx, int nv, void *data, number *v)
{
  octave_inputs& given = *static_cast<octave_inputs *> (data);
  if (given.failure)
    return -1000;
  try
    {
      Matrix state (nx, 1);
      std::transform (x, x + nx, state.fortran_vec (), [] (number a) { return double (a); });
      octave_value_list r = octave::feval (given.f, ovl (double (t), state), 1);
      octave_value_list only;
      if (r.length () > 0)
        only.append (r(0));
      arguments a (only, "simulate");
      const reals found = a.vector ("v", nv);
      std::copy_n (found.begin (), nv, v);
      return 0;
    }
  catch (const octave::interrupt_exception&)
    {
      octave::interpreter::the_interpreter ()->recover_from_exception ();
      if (the_patience)
        the_patience->stop (patience::interrupted);
    }
  catch (...)
    {
      given.failure = std::current_exception ();
      if (the_patience)
        the_patience->stop (patience::failed);
    }
  return -1000;
}

// before a step: INFO where the run is to end, else 0
extern "C" int
gsmbp_patience (void *, number t)
{
  return patience::asked () && the_patience->look (double (t)) ? the_patience->why () : 0;
}

// the outputs at K states, a column each; not a number where a state or an input is none or the
// subroutine cannot calculate them
static Matrix
outputs_at (const reals& cst, int k, const number *t, const number *x, int ldx, const number *v,
            int ldv)
{
  Matrix y (S.ny, k, no_number);
  reals one = room (S.ny);
  for (int i = 0; i < k && S.ny > 0; i++, t++, x += ldx, v += ldv)
    if (fine (t, 1) && fine (x, S.nx) && fine (v, S.nv))
      {
        int info = 0;
        routine ("out") (t, x, v, &cst[0], &one[0], &info);
        for (int j = 0; j < S.ny && (info == 0 || info == 2); j++)
          y(j, i) = double (one[j]);
      }
  return y;
}

// The next argument, K rows of N numbers, row after row; zero where nothing is given and that may
// be.  What is not finite is let through: it is the matter of its time.
static reals
rows_of (arguments& a, const char *name, int k, int n, bool needed = true)
{
  const octave_value& v = a.value (name);
  reals x (std::size_t (k) * n + 1, number (0));   // &x[0] exists
  if (v.isempty () && (! needed || k * n == 0))
    return x;
  if (! v.isnumeric () || v.iscomplex ())
    error ("%s: argument %s: expected real numbers, found %s", a.who ().c_str (), name,
           v.class_name ().c_str ());
  if (v.ndims () > 2 || v.rows () != k || v.columns () != n)
    error ("%s: argument %s: expected %d x %d, found %s", a.who ().c_str (), name, k, n,
           v.dims ().str ().c_str ());
  Matrix m = v.matrix_value ();
  for (int i = 0; i < k; i++)
    for (int j = 0; j < n; j++)
      x[std::size_t (n) * i + j] = m(i, j);
  return x;
}

// what the parts of a run are read from: constants, number of times, times, states (coordinates
// alone where no inputs follow) and inputs, a row for each time
struct given_run
{
  reals cst;
  int k;
  reals t, x, v;

  given_run (arguments& a, bool inputs)
    : cst (a.constants ()), k (a.integer_within ("number", 0, 2000000000)),
      t (rows_of (a, "times", k, 1)),
      x (inputs ? rows_of (a, "states", k, S.nx) : rows_of (a, "coordinates", k, S.nq)),
      v (inputs ? rows_of (a, "inputs", k, S.nv, false) : reals (1, number (0))) { }

  const number *states (int i) const { return &x[std::size_t (S.nx) * i]; }
  const number *coordinates (int i) const { return &x[std::size_t (S.nq) * i]; }
  const number *inputs (int i) const { return &v[std::size_t (S.nv) * i]; }
};

// (constants, number of times, times, states, inputs): outputs, a column each
static octave_value_list
do_outputs (arguments& a, int)
{
  given_run r (a, true);
  return ovl (outputs_at (r.cst, r.k, &r.t[0], r.states (0), S.nx, r.inputs (0), S.nv));
}

// (constants, number of times, times, coordinates, number of points): their places, a column each
static octave_value_list
do_places (arguments& a, int)
{
  given_run g (a, false);
  int n = a.integer_within ("points", 0, 100000);
  Matrix places (3 * n, g.k, no_number);
  reals p = room (3 * n), r = room (9 * n);
  for (int i = 0; i < g.k; i++)
    if (fine (&g.t[i], 1) && fine (g.coordinates (i), S.nq))
      {
        routine ("pnt") (&g.t[i], g.coordinates (i), &g.cst[0], &p[0], &r[0]);
        for (int j = 0; j < 3 * n; j++)
          places(j, i) = double (p[j]);
      }
  return ovl (places);
}

// (constants, number of times, times, states, inputs): margins of devices and their sizes, a column
// each
static octave_value_list
do_margins (arguments& a, int)
{
  given_run r (a, true);
  Matrix margins (S.nsm, r.k), sizes (S.nsm, r.k);
  reals g = room (S.nsm), size = room (S.nsm);
  for (int i = 0; i < r.k; i++)
    {
      routine ("mar") (&r.t[i], r.states (i), r.inputs (i), &r.cst[0], &g[0], &size[0]);
      for (int j = 0; j < S.nsm; j++)
        {
          margins(j, i) = double (g[j]);
          sizes(j, i) = double (size[j]);
        }
    }
  return ovl (margins, sizes);
}

// (constants, number of times, times, states, inputs): energies and powers, a column each
static octave_value_list
do_energies (arguments& a, int)
{
  given_run r (a, true);
  const int n = 5;
  Matrix energies (n, r.k, no_number);
  reals e = room (n);
  for (int i = 0; i < r.k; i++)
    if (fine (&r.t[i], 1) && fine (r.states (i), S.nx) && fine (r.inputs (i), S.nv))
      {
        routine ("ene") (&r.t[i], r.states (i), r.inputs (i), &r.cst[0], &e[0]);
        for (int j = 0; j < n; j++)
          energies(j, i) = double (e[j]);
      }
  return ovl (energies);
}

#if ! defined (GSMBP_QUAD)
// the method of a library, of libgsmbp_cvode.so gs_cvode
static gs_implicit_method *
method_of (const std::string& library)
{
  static gs_implicit_method *run = nullptr;
  static std::string loaded;
  if (loaded != library)
    {
      std::string name = "gs_" + library.substr (library.rfind ("libgsmbp_") + 9);
      name.resize (name.rfind (".so"));
      void *handle = dlopen (library.c_str (), RTLD_NOW | RTLD_LOCAL);
      void *address = handle ? dlsym (handle, name.c_str ()) : nullptr;
      if (! address)
        error ("gsmbp_simulate: cannot load %s: %s", library.c_str (), dlerror ());
      run = reinterpret_cast<gs_implicit_method *> (address);
      loaded = library;
    }
  return run;
}
#endif
