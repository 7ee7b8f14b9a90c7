// Derivatives of goals of a run backwards (gsmbp_adjoint), by share/engine/host/adjoint.h.
#pragma once

#include "run.h"
#include "host/adjoint.h"

// what both ways need: the run prepared
struct adjoint_run
{
  adjoint_run (arguments& a) : asked (a)
  {
    if (gs_run_prepare (&asked.about, &asked.options, &asked.start, &asked.inputs, &found))
      error ("%s: %s", a.who ().c_str (), found.text);
    run = { S.run, found.cst, found.ip, found.rp, gsmbp_patience, nullptr };
  }
  ~adjoint_run (void) { gs_adjoint_free (&kept); }
  adjoint_run (const adjoint_run&) = delete;

  asked_run asked;
  found_run found;
  gs_adjoint_run run;
  gs_kept_steps kept = gs_kept_steps ();
};

// what a run that was kept before is made of
static void
take_record (gs_kept_steps& kept, const Matrix& counts, const Matrix& record)
{
  const int ns = int (counts.numel ()), steps = int (record.columns ());
  kept.counts = static_cast<int *> (std::calloc (ns + 1, sizeof (int)));
  kept.numbers = static_cast<number *> (std::calloc (record.numel () + 1, sizeof (number)));
  if (! kept.counts || ! kept.numbers)
    throw std::bad_alloc ();
  kept.ns = ns;
  kept.steps = kept.room = steps;
  std::copy_n (counts.data (), ns, kept.counts);
  std::copy_n (record.data (), record.numel (), kept.numbers);
}

// (those of a run, t0 and the stops): a column for each step as gs_kept_steps has it; the number of
// steps up to each stop; the state at each; INFO; the time that was reached
static octave_value_list
do_forward (arguments& a, int)
{
  adjoint_run r (a);
  const reals stops = a.vector ("stops", -1);
  const int ns = int (stops.size ());
  reals states (std::size_t (S.nx) * ns, no_number);
  patience p (r.asked.timeout, double (stops[0]), double (stops[ns - 1]), "s");
  number t = 0;
  const int info = gs_adjoint_forward (&r.run, r.found.x, ns, &stops[0], number (r.found.rtol),
                                       r.found.atol, &r.kept, &states[0], &t);
  p.settle ();
  if (info == GS_OUT_OF_MEMORY)
    throw std::bad_alloc ();
  Matrix record (4 + 13 * S.nx, r.kept.steps), counts (ns, 1);
  std::copy_n (r.kept.numbers, record.numel (), record.fortran_vec ());
  std::copy_n (r.kept.counts, ns, counts.fortran_vec ());
  return ovl (record, counts, result (states, S.nx, ns), info, double (t));
}

// (those of a run, record of the forward way, numbers of steps up to each stop, weights of the
// states at each stop): derivatives by the first state and by the parameters; INFO; the
// time that was reached
static octave_value_list
do_backward (arguments& a, int)
{
  adjoint_run r (a);
  const Matrix record = a.value ("record").matrix_value (),
               counts = a.value ("counts").matrix_value (),
               weights = a.value ("weights").matrix_value ();
  take_record (r.kept, counts, record);
  reals lx = room (S.nx), pb = room (S.nsp), given (weights.data (),
                                                    weights.data () + weights.numel ());
  const int at = r.kept.steps;
  patience p (r.asked.timeout, at > 0 ? record(1, at - 1) : 0,
              at > 0 ? record(0, 0) : 1, "s, backward");
  number t = 0;
  const int info = gs_adjoint_backward (&r.run, &r.kept, given.data (), &lx[0], &pb[0], &t);
  p.settle ();
  if (info == GS_OUT_OF_MEMORY)
    throw std::bad_alloc ();
  return ovl (result (lx, S.nx), result (pb, S.nsp), info, double (t));
}
