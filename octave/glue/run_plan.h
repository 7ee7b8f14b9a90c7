// The plan of a run: what gsmbp_simulate says of its inputs, samples and events, laid out in IP and
// RP by gs_lay of share/engine/core, which alone knows where they stand.
#pragma once

#include "arguments.h"
#include "gsmbp/plan.h"
#include "host/start.h"

#include <list>

class run_plan
{
public:

  // the fields of gs_plan, and those of gs_scene that are for the plan; [] is none
  run_plan (const octave_scalar_map& given, int nx);

  // periods, delays and first samples of a run from T0 on; false where they cannot be: START says
  // why
  bool due_from (number t0, const reals& cst, gs_start& start);

  // the parts of the plan, in IP and RP
  gs_samples samples (void) { return gs_planned_samples (&m_scene, &ip[0], &rp[0]); }
  gs_events events (void) { return gs_planned_events (m_nx, &ip[0], &rp[0]); }

  // of each event function whether its event changes what follows
  std::vector<int> changing_events (void);

  std::vector<int> ip;
  zero_reals rp;   // the records of long runs with samples are most of it

private:

  const number *numbers (const char *name, int size);
  const int *wholes (const char *name, int size);
  gs_pieces pieces (const char *name);
  int whole (const char *name) { return m_given.contents (name).int_value (); }
  void read_scene (void);

  octave_scalar_map m_given;
  std::list<reals> m_numbers;              // what m_scene and gs_plan point to
  std::list<std::vector<int>> m_wholes;
  gs_scene m_scene;
  int m_nx;
};

// SIZE numbers of a field, a null pointer where it is []
const number *
run_plan::numbers (const char *name, int size)
{
  Matrix m = m_given.contents (name).matrix_value ();
  if (m.isempty ())
    return nullptr;
  if (m.numel () != size)
    error ("%s.sim: %s: expected %d numbers, found %d", S.name, name, size, int (m.numel ()));
  m_numbers.emplace_back (m.data (), m.data () + m.numel ());
  return m_numbers.back ().data ();
}

const int *
run_plan::wholes (const char *name, int size)
{
  const number *x = numbers (name, size);
  m_wholes.emplace_back ();
  for (int k = 0; x && k < size; k++)
    m_wholes.back ().push_back (int (x[k]));
  return x ? m_wholes.back ().data () : nullptr;
}

// a piecewise polynomial: a struct with the fields of gs_pieces
gs_pieces
run_plan::pieces (const char *name)
{
  octave_value field = m_given.contents (name);
  gs_pieces p = { 0, 0, 0, nullptr };
  if (! field.isstruct ())
    return p;
  octave_scalar_map given = field.scalar_map_value ();
  p.nc = given.contents ("nc").int_value ();
  p.np = given.contents ("np").int_value ();
  p.k = given.contents ("k").int_value ();
  Matrix m = given.contents ("numbers").matrix_value ();
  if (m.numel () != p.np + 1 + p.nc * p.np * p.k)
    error ("%s.sim: %s: expected %d numbers, found %d", S.name, name,
           p.np + 1 + p.nc * p.np * p.k, int (m.numel ()));
  m_numbers.emplace_back (m.data (), m.data () + m.numel ());
  p.numbers = m_numbers.back ().data ();
  return p;
}

std::vector<int>
run_plan::changing_events (void)
{
  const int *given = m_given.contains ("event_changes") ? wholes ("event_changes", S.nev) : nullptr;
  return given ? std::vector<int> (given, given + S.nev) : std::vector<int> (S.nev, 1);
}

void
run_plan::read_scene (void)
{
  m_scene = *S.run;
  if (S.nev > 0)
    {
      m_scene.event_inputs = wholes ("event_inputs", S.nev);
      m_scene.event_kinds = wholes ("event_kinds", S.nev);
      m_scene.nswitch = int (m_given.contents ("switch_events").matrix_value ().numel ());
      m_scene.switch_events = wholes ("switch_events", m_scene.nswitch);
      m_scene.switch_inputs = wholes ("switch_inputs", m_scene.nswitch);
    }
  if (S.nctl > 0)
    {
      m_scene.held_counts = wholes ("held_counts", S.nctl);
      m_scene.again = wholes ("again", S.nctl);
      for (int k = 0; k < S.nctl; k++)
        m_scene.nheld += m_scene.held_counts[k];
      m_scene.held_inputs = wholes ("held_inputs", m_scene.nheld);
    }
}

run_plan::run_plan (const octave_scalar_map& given, int nx)
  : m_given (given), m_nx (nx)
{
  read_scene ();
  gs_plan p = gs_plan ();
  p.s = &m_scene;
  p.nx = nx;
  p.inputs = whole ("inputs");
  p.derivatives = whole ("derivatives");
  p.constants = numbers ("constants", S.nv);
  p.table = pieces ("table");
  p.motion = pieces ("motion");
  p.planned = wholes ("planned", p.motion.nc);
  p.reference = pieces ("reference");
  p.gain = pieces ("gain");
  p.limits = numbers ("limits", 2 * S.nv);
  p.memory = numbers ("memory", S.nxk);
  p.on_the_way = whole ("on_the_way");
  p.instants = whole ("instants");
  p.modes = wholes ("modes", S.nev);
  p.events = whole ("events");
  ip.assign (gs_wholes (&p), 0);
  rp = zero_reals (gs_reals (&p));
  gs_lay (&p, &ip[0], &rp[0]);
}

bool
run_plan::due_from (number t0, const reals& cst, gs_start& start)
{
  return gs_check_samples (S.about, t0, &cst[0], &ip[0], &rp[0], &start) == GS_START_TAKEN;
}
