// The generic part of a module: takes Octave's arrays apart, checks size and
// finiteness of every argument, calls the emitted Fortran and the run times of share/engine/core
// and share/fortran.  Compiled once for double and once, with GSMBP_QUAD defined,
// for quad precision (Fortran under -freal-8-number-16): doubles in, doubles out.

#include "calls.h"
#include "handles.h"
#include "parameters.h"
#include "runtime.h"
#include "run.h"
#include "starts.h"
#include "ensemble.h"
#include "job.h"
#include "adjoint.h"
#include "linear.h"
#include "planned.h"
#include "assemble.h"
#include "reach.h"
#include "collocation.h"
#include "design.h"

static bool the_interrupt_is_old = false;   // a run ended by it

// what Ctrl-C is to Octave
static octave_value_list
do_interrupt (arguments&, int)
{
  the_interrupt_is_old = true;
  octave::interpreter::the_interpreter ()->recover_from_exception ();
  throw octave::interrupt_exception ();
}

// (function, seconds): 0, or by what it was ended, 1: Ctrl-C, 2: it took longer (Inf: never);
// what it gives.  A second Ctrl-C within half a second ends who called, too.
static octave_value_list
do_guarded (arguments& a, int nargout)
{
  const octave_value f = a.value ("function");
  alarm_clock late (a.value ("seconds").double_value ());
  try
    {
      octave_value_list r = octave::feval (f, ovl (), std::max (0, nargout - 1));
      late.off ();
      return r.prepend (0.0);
    }
  catch (const octave::interrupt_exception&)
    {
      octave::interpreter::the_interpreter ()->recover_from_exception ();
      late.off ();
      const bool counted = the_interrupt_is_old;
      the_interrupt_is_old = false;
      if (! late.rang () && ! counted && patience::again ())
        throw;
    }
  octave_value_list none (std::max (1, nargout), Matrix ());
  none(0) = late.rang () ? 2.0 : 1.0;
  return none;
}

// for the functions of octave/ and for tests
static const struct { const char *name; octave_value_list (*call) (arguments&, int); } services[]
    = { { "run", do_run }, { "prepare", do_prepare }, { "ensemble", do_ensemble },
        { "job", do_job }, { "start", do_start }, { "settle", do_settle },
        { "residuals", do_residuals }, { "worst", do_worst },
        { "passed margins", do_passed_margins },
        { "statistics", do_statistics },
        { "forward", do_forward },
        { "backward", do_backward },
        { "linear", do_linear }, { "trim", do_trim },
        { "tangent", do_tangent }, { "modes", do_modes },
        { "followed modes", do_follow_modes }, { "rest slopes", do_rest_slopes },
        { "family steps", do_family_steps }, { "pole slopes", do_pole_slopes },
         { "loop slopes", do_loop_slopes }, { "planned", do_planned },
         { "assemble", do_assemble }, { "lost rank", do_lost_rank },
         { "axes", do_axes }, { "choose", do_choose }, { "free", do_free },
         { "outputs", do_outputs }, { "places", do_places }, { "margins", do_margins },
         { "energies", do_energies },
         { "program", do_program }, { "collocate", do_collocate },
         { "design", do_design }, { "weights", do_weights },
         { "differences", do_differences }, { "par", do_par }, { "pre", do_pre },
         { "chk", do_chk }, { "ini", do_ini },
        { "meaning", do_meaning }, { "spline", do_spline }, { "kkt", do_kkt },
        { "solve", do_solve }, { "interrupt", do_interrupt }, { "guarded", do_guarded },
        { "calls", do_calls } };

// what the handle CALL is; a null pointer: none
static const handle *
handle_by (const std::string& call)
{
  for (const handle& h : handles ())
    if (call == h.name && h.asked_for ())
      {
        if (! h.code)
          absent (call, h.row->request);
        return &h;
      }
  return nullptr;
}

static octave_value_list
dispatch (const std::string& call, const octave_value_list& args, int nargout)
{
  if (const handle *h = handle_by (call))
    {
      arguments a (args, call, h->g.usage);
      a.count_given ();
      return (h->g.batch ? call_batch : call_once) (h->g, h->code->sub, a, nargout);
    }
  for (const auto& service : services)
    if (call == service.name)
      {
        arguments a (args, call, "");
        return service.call (a, nargout);
      }
  error ("%s: no subroutine %s", S.name, call.c_str ());
}

// ("many", call, its arguments with a column for each state ...)
static octave_value_list
do_many (const octave_value_list& args)
{
  const handle *h = args.length () > 2 && args(1).is_string () ? handle_by (args(1).string_value ())
                                                               : nullptr;
  if (! h)
    error ("%s.many: expected the name of a subroutine and its arguments", S.name);
  arguments a (args.slice (2, args.length () - 2), h->name, h->g.usage);
  a.count_given ();
  return call_many (h->g, h->code->sub, a);
}

// ("time", repetitions, call, its arguments ...): seconds for one call of the
// emitted subroutine, Octave's part not in it
static octave_value_list
do_time (const octave_value_list& args)
{
  if (args.length () < 3 || ! args(2).is_string ())
    error ("%s.time: expected repetitions, the name of a subroutine, its arguments", S.name);
  std::string call = args(2).string_value ();
  long repeats = args(1).long_value ();
  if (repeats < 1 || call == "run")
    error ("%s.time: cannot time %ld calls of %s", S.name, repeats, call.c_str ());
  struct guard { ~guard () { the_repeats = 0; } } back_to_normal;
  the_repeats = repeats;
  dispatch (call, args.slice (3, args.length () - 3), 9);
  return ovl (the_seconds / repeats);
}

// By the name under which Octave has it: a function that it does not find under its own name it
// loads anew at every call, once a folder was added to the path behind the first one.
DEFUNX_DLD (S.symbol, Fgsmbp_module, Ggsmbp_module, args, nargout,
            "Called through the handles of gsmbp_build; not for direct use.")
{
  if (args.length () < 1 || ! args(0).is_string ())
    error ("%s: expected the name of a subroutine", S.name);
  std::string call = args(0).string_value ();
  if (call == "time")
    return do_time (args);
  if (call == "many")
    return do_many (args);
  octave_value_list results = dispatch (call, args.slice (1, args.length () - 1), nargout);
  int most = int (results.length ());
  if (nargout > most)
    error ("%s.%s: expected at most %d result%s, found %d", S.name, call.c_str (), most,
           most == 1 ? "" : "s", nargout);
  return results;
}
