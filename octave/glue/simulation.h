// A run: what gsmbp_simulate hands over, the subroutines that it needs, gs_integrate, an implicit
// method where that is asked for or steps are bound by stability, what comes back.
#pragma once

#include "run_parts.h"
#include "run_columns.h"
#include "gsmbp/integrate.h"
#include "host/fortran_scene.h"

// inputs by a function of Octave in the place of those of the scene
GS_FORTRAN_vin (gs_octave_vin, gsmbp_call_input)

// The arguments of gs_integrate by their names, and who integrates.
struct simulation
{
  simulation (arguments& a);

  void integrate (void);
  bool carries (void) const { return columns.count () > 0; }
  gs_integration run (void);   // as the engine takes it; its statistics are those so far
  octave_value_list results (void);

  number t0;
  int nx, nt, nb, ldx, ldv, lw;
  reals cst, x0, tout, ropt, atol;
  reals tbrk;   // breaks of the inputs, nb of them within the run
  std::vector<int> iopt;
  reals xout, vout, rstat, w;
  std::vector<int> istat;
  int info;
  std::vector<char> text;   // what an implicit method said when it failed
  gs_scene scene;
  const number *carried = nullptr;    // constants of a run that carries derivatives
  run_columns columns;                // by parameters, behind the states
  bool audit;                         // the two states of an audit stand behind the others
  std::unique_ptr<run_plan> plan;
  octave_value input;    // the user's inputs as a function of Octave
  std::string library;   // an implicit method, or its library; "": gs_integrate alone
#if ! defined (GSMBP_QUAD)
  gs_implicit_method *implicit_method = nullptr;
#endif
  std::vector<int> implicit;   // the largest order; 1 if loops are in index 2; the states that the
                               // inputs of a motion follow, from 1 on
  double timeout;              // wall time [s]; 0: none
  gs_fortran_inputs given_inputs;   // data of the inputs of a run that carries columns
  double seconds;

private:

  void read_options (arguments& a);
  void make_room (const reals& guess);
  void check_routines (void);
  void fill_scene (void);
  void carry (const reals& guess);
  template <typename integrator> void run_by (gs_scene one, integrator integrate);
#if ! defined (GSMBP_QUAD)
  void by_implicit (bool resume);
#endif
};

simulation::simulation (arguments& a)
  : seconds (0)
{
  cst = a.constants ();
  t0 = a.scalar ("t0");
  x0 = a.vector ("x0", -1);
  nx = int (x0.size ());
  columns = run_columns (a.value ("columns").matrix_value ());
  audit = nx == S.nx + 2 && ! carries ();
  info = 0;
  text.assign (400, 0);
  if (nx != S.nx * (1 + columns.count ()) && ! audit)
    error ("%s: argument x0: expected %d numbers, found %d", a.who ().c_str (),
           S.nx * (1 + columns.count ()), nx);
  tout = a.vector ("times", -1);
  tbrk = a.vector ("breaks", -1);
  Matrix counts = a.matrix ("counts", 2, 1);
  nt = int (counts(0));
  nb = int (counts(1));
  read_options (a);
  ropt = a.vector ("ropt", 3);
  atol = a.vector ("atol", nx);
  plan.reset (new run_plan (a.value ("plan").scalar_map_value (), nx));
  reals guess = a.vector ("guess", S.nu);
  input = a.value ("input function");
  library = a.value ("library").string_value ();
#if ! defined (GSMBP_QUAD)
  if (! library.empty ())
    implicit_method = implicit_run (library);
#endif
  implicit = a.integers ("largest order, index 2, states that inputs follow", -1);
  timeout = double (a.scalar ("timeout"));
  gs_start start;
  if (! plan->due_from (t0, cst, start))
    error ("gsmbp_simulate: %s", start.text);
  make_room (guess);
  check_routines ();
  fill_scene ();
  if (carries ())
    carry (guess);
}

// method, way of the loops, drift, steps; from 7 on constraints on speeds
void
simulation::read_options (arguments& a)
{
  iopt = a.integers ("iopt", -1);
  if (iopt.size () < 6)
    error ("%s: iopt is too short", a.who ().c_str ());
  for (std::size_t i = 6; i < iopt.size (); i++)
    if (iopt[i] < 1 || iopt[i] > S.nlam)
      error ("%s: there is no constraint %d", a.who ().c_str (), iopt[i]);
  iopt[GS_WATCH] = S.nlam > 0 && iopt[GS_DRIFT] == 1 && emitted ("kin");
  iopt[GS_ON_SPEEDS] = int (iopt.size ()) - 6;
}

void
simulation::make_room (const reals& guess)
{
  ldx = std::max (1, nx);
  ldv = std::max (1, S.nv);
  lw = gs_room (S.run, nx, plan->ip[GS_DERIVATIVES]);
  w = room (lw);
  xout.assign (std::size_t (ldx) * nt, no_number);   // where a run is left
  vout = room (ldv * nt);
  rstat = room (GS_MEASURED);
  istat.assign (GS_COUNTED, 0);
  for (int i = 0; i < S.nu; i++)
    w[i] = guess[i];
}

// a routine that the run needs and the scene has not is an error
void
simulation::check_routines (void)
{
  auto need = [] (bool is, const char *name) { if (is) routine (name); };
  const bool loops = S.nlam > 0, euler = S.nq > S.nu;
  const bool partition = loops && (iopt[GS_LOOPS] == 3 || iopt[GS_LOOPS] == 6);
  // coordinate partitioning keeps the loops closed by itself, but CVODE projects in every way
  const bool project = iopt[GS_LOOPS] != 1
                       && (euler || (loops && (iopt[GS_LOOPS] != 3 || ! library.empty ())));
  const bool drift = loops && iopt[GS_DRIFT] == 1, sampled = S.nctl > 0, events = S.nev > 0;
  const std::vector<int>& ip = plan->ip;
  const bool planned = ip[GS_V0] == 2;
  need (true, audit ? "rha" : "rhs");
  need (project, "prj");
  need (partition || drift, "con");
  need (partition || iopt[GS_WATCH], "kin");
  need (planned, "cmd");
  need (planned && ip[GS_CLOSED] == 1, "clo");
  need (sampled && S.ny > 0, "out");
  need (sampled, "ctl");
  need (events, "evt");
  need (events, "rst");
  if (ip[GS_V0] == 3 && ! input.is_function_handle () && ! S.vin)
    error_with_id ("gsmbp:absent",
                   "%s.input: the model was built without option \"input\" of gsmbp_build", S.name);
}

// those routines in which this run differs from others of its scene
void
simulation::fill_scene (void)
{
  scene = *S.run;
  if (audit)
    scene.rhs = S.audited;
  if (plan->ip[GS_V0] == 3 && input.is_function_handle ())
    scene.vin = gs_octave_vin;
}

// the run carries its columns
void
simulation::carry (const reals& guess)
{
  given_inputs = { plan->ip.data (), plan->rp.data (), cst.data () };
  columns.open (scene, *plan, cst, guess, ropt[1], atol, &given_inputs);
  carried = columns.constants ();
}

gs_integration
simulation::run (void)
{
  gs_integration r = gs_integration ();
  r.nx = nx;
  r.t0 = t0;
  r.x0 = &x0[0];
  r.nt = nt;
  r.tout = &tout[0];
  r.nb = nb;
  r.tbrk = tbrk.data ();
  r.iopt = &iopt[0];
  r.ropt = &ropt[0];
  r.atol = &atol[0];
  r.ip = plan->ip.data ();
  r.rp = plan->rp.data ();
  r.cst = carried ? carried : &cst[0];
  r.xout = &xout[0];
  r.ldx = ldx;
  r.vout = &vout[0];
  r.ldv = ldv;
  r.w = &w[0];
  r.lw = lw;
  r.ask = gsmbp_patience;
  std::copy_n (istat.begin (), int (GS_COUNTED), r.istat);
  std::copy_n (rstat.begin (), int (GS_MEASURED), r.rstat);
  return r;
}

// INTEGRATE (scene, run)
template <typename integrator>
void
simulation::run_by (gs_scene one, integrator integrate)
{
  gs_fortran_inputs of_vin = { plan->ip.data (), plan->rp.data (), &cst[0] };
  if (! carried)
    one.data = &of_vin;
  gs_integration r = run ();
  info = integrate (&one, &r);
  std::copy_n (r.istat, int (GS_COUNTED), istat.begin ());
  std::copy_n (r.rstat, int (GS_MEASURED), rstat.begin ());
}

#if ! defined (GSMBP_QUAD)
// from the start, or on from where gs_integrate found its steps bound by stability
void
simulation::by_implicit (bool resume)
{
  const gs_implicit o = { implicit[0], implicit[1], resume, columns.count (),
                          int (implicit.size ()) - 2, implicit.data () + 2, &text[0],
                          text.size () };
  run_by (scene, [&] (gs_scene *s, gs_integration *r) { return implicit_method (s, r, &o); });
}
#endif

void
simulation::integrate (void)
{
  auto begin = std::chrono::steady_clock::now ();
  const bool steps = iopt[GS_METHOD] != 0;
  if (steps)
    run_by (scene, gs_integrate);
#if ! defined (GSMBP_QUAD)
  if (! steps || info == GS_STIFF)
    by_implicit (steps);
#endif
  seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count ();
}

// of runs, a column each, by the names of their rows
static octave_scalar_map
named_statistics (const Matrix& counts, const Matrix& values)
{
  octave_scalar_map all;
#define GS_NAMED_COUNT(k, name) all.assign (#name, octave_value (counts.row (k)));
#define GS_NAMED_VALUE(k, name) all.assign (#name, octave_value (values.row (k)));
  GS_COUNTS (GS_NAMED_COUNT)
  GS_VALUES (GS_NAMED_VALUE)
  return all;
}

octave_value_list
simulation::results (void)
{
  Matrix counts (GS_COUNTED, 1);
  for (int i = 0; i < GS_COUNTED; i++)
    counts(i) = istat[i];
  // after the rows so far the last state, if any
  const int n = std::min (nt, istat[GS_N_OUTPUTS] + 1);
  Matrix inputs = S.nv > 0 ? result (vout, S.nv, n) : Matrix (0, n);
  octave_value_list list = ovl (result (xout, nx, n), inputs,
                                named_statistics (counts, result (rstat, GS_MEASURED)), info,
                                seconds, std::string (&text[0]));
  list.append (samples (cst, *plan, tout, xout, vout, ldx, ldv, istat[GS_N_OUTPUTS]));
  list.append (events (*plan, nx));
  list.append (columns.lost ());
  list.append (columns.turns ());
  list.append (columns.held ());
  list.append (columns.followed (istat[GS_N_OUTPUTS], tout, xout, ldx, vout, ldv));
  list.append (columns.events ());
  return list;
}

// What the routines of a run in Octave read; it may be one within the function of inputs of
// another, whose it is again afterwards.
class current_run
{
public:

  current_run (simulation& run, const reals& jumps, std::exception_ptr& failure)
    : m_input (the_input), m_breaks (the_breaks), m_failure (the_failure)
  {
    the_input = &run.input;
    the_breaks = &jumps;
    the_failure = &failure;
  }
  ~current_run (void)
  {
    the_input = m_input;
    the_breaks = m_breaks;
    the_failure = m_failure;
  }
  current_run (const current_run&) = delete;

private:

  const octave_value *const m_input;
  const reals *const m_breaks;
  std::exception_ptr *const m_failure;
};

static octave_value_list
do_sim (arguments& a, int)
{
  simulation run (a);
  std::exception_ptr failure;
  reals jumps = switch_times (run.cst);
  jumps.insert (jumps.end (), run.tbrk.begin (), run.tbrk.end ());
  current_run current (run, jumps, failure);
  {
    patience p (run.timeout, double (run.t0), double (run.tout[run.nt - 1]), "s");
    run.integrate ();
    if (run.info != 0 && p.why () != patience::none)
      run.info = p.why ();
    p.settle ();
  }
  if (failure)
    std::rethrow_exception (failure);
  return run.results ();
}
