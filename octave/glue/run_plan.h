// The plan of a run: what gsmbp_simulate says of its inputs, samples and events, laid out in IP and
// RP by gs_lay of share/c, which alone knows where they stand.
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

  // IP and RP of a run of its own.  The record of its events, of which nothing is read before it is
  // written, stays as it is: it takes most of their room, and the time of a short run.
  void begin (std::vector<int>& own_ip, unset_reals& own_rp) const;

  // the parts of the plan, in IP and RP
  gs_samples samples (void) { return gs_planned_samples (&m_scene, &ip[0], &rp[0]); }
  gs_events events (void) { return gs_planned_events (m_nx, &ip[0], &rp[0]); }

  // time, number and mode after it of each event of a run with those
  std::vector<double> events_of (const std::vector<int>& own_ip, const unset_reals& own_rp) const;
  // of each event function how many events it had, when the first and the last one was, into three
  // columns of TO, one behind the other; not a number where there was none
  void counted (const std::vector<int>& own_ip, const unset_reals& own_rp, double *to) const;

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
  std::size_t m_record[2] = { 0, 0 };      // where in it the record of the events begins and ends
  std::size_t m_first, m_latest, m_times;  // ... where those of gs_events are, in RP and in IP
};

void
run_plan::begin (std::vector<int>& own_ip, unset_reals& own_rp) const
{
  own_ip = ip;
  own_rp.resize (rp.size ());
  std::copy_n (rp.begin (), m_record[0], own_rp.begin ());
  std::copy (rp.begin () + m_record[1], rp.end (), own_rp.begin () + m_record[1]);
}

std::vector<double>
run_plan::events_of (const std::vector<int>& own_ip, const unset_reals& own_rp) const
{
  const int *e = &own_ip[own_ip[GS_EVENTS] - 1];
  const std::size_t many = std::min (e[1], e[2]), width = 3 + 2 * std::size_t (m_nx);
  std::vector<double> list (3 * many);
  for (std::size_t k = 0; k < list.size (); k++)
    list[k] = double (own_rp[m_record[0] + k / 3 * width + k % 3]);
  return list;
}

void
run_plan::counted (const std::vector<int>& own_ip, const unset_reals& own_rp, double *to) const
{
  for (int k = 0; k < S.nev; k++)
    {
      const int times = own_ip[m_times + k];
      to[k] = times;
      to[S.nev + k] = times > 0 ? double (own_rp[m_first + k]) : no_number;
      to[2 * S.nev + k] = times > 0 ? double (own_rp[m_latest + k]) : no_number;
    }
}

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
  if (ip[GS_EVENTS] > 0)
    {
      const gs_events e = events ();
      m_record[0] = e.record - &rp[0];
      m_record[1] = e.level - &rp[0];
      m_first = e.first - &rp[0];
      m_latest = e.latest - &rp[0];
      m_times = e.times - &ip[0];
    }
}

bool
run_plan::due_from (number t0, const reals& cst, gs_start& start)
{
  return gs_check_samples (S.about, t0, &cst[0], &ip[0], &rp[0], &start) == GS_START_TAKEN;
}
