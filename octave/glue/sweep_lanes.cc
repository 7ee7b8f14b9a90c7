// The runs of a sweep's program in lanes; sweep_lanes.h says what it is.
#include "sweep_lanes.h"

#include "lanes.h"
#include "row_groups.h"

struct gs_lanes
{
  gs_lanes (const gs_sweep *sweep, long long from, int n, int threads, double *rows,
            char (*reasons)[GS_WHY]);

  const gs_sweep *s;
  long long first;
  double *values;
  char (*why)[GS_WHY];
  const varied_rows table;
  const int most;
  run_setting setting;
  std::vector<int> ip;
  std::atomic<int> next;
  std::unique_ptr<row_groups> groups;   // none: PRE is called for each run
};

static reals
list (const gs_array& a)
{
  return reals (a.x, a.x + a.n);
}

static run_setting
setting_of (const gs_sweep *s)
{
  const gsmbp_sub *f = s->sub;
  return { s->t0, s->nx, list (s->tout), int (s->tout.n),
           std::vector<int> (s->iopt, s->iopt + s->niopt), list (s->ropt), list (s->atol), f[0],
           f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10], s->ldx, s->ldv, s->lw };
}

gs_lanes::gs_lanes (const gs_sweep *sweep, long long from, int n, int threads, double *rows,
                    char (*reasons)[GS_WHY])
  : s (sweep), first (from), values (rows), why (reasons),
    table ({ n, std::vector<int> (s->which, s->which + s->varied), s->samples.x + s->varied * first,
             std::ptrdiff_t (s->varied), 1 }),
    most ((n - 1) / threads + 1), setting (setting_of (s)), ip (s->ip, s->ip + s->nip), next (0)
{
  if (emitted ("pre_w"))
    groups.reset (new row_groups (table, list (s->par), threads, most, [] { return false; }));
}

// a thread's
class sweep_rows : public lane_source
{
public:

  sweep_rows (gs_lanes& all, int thread, gs_sweep_room *r)
    : m_all (all), m_thread (thread), m_r (r)
  { }
  bool next (lane_run& l);
  void done (lane_run& l);
  int over (void) { return 0; }

private:

  bool begins (const known_row& row);
  double *row (int i) const { return m_all.values + m_all.s->columns * i; }

  gs_lanes& m_all;
  const int m_thread;
  gs_sweep_room *m_r;
};

bool
sweep_rows::begins (const known_row& known)
{
  reals cst = room (S.ncst);
  const int info = known.group ? known.group->constants (known.place, cst) : 0, i = known.i;
  if (! gs_begin_row (m_all.s, m_r, m_all.first + i, known.group ? &cst[0] : nullptr, info, row (i),
                      m_all.why[i]))
    return false;
  if (m_r->info != 0)
    gs_end_row (m_all.s, m_r, row (i), m_all.why[i]);
  return m_r->info == 0;
}

// into the room of a lane
bool
sweep_rows::next (lane_run& l)
{
  const gs_sweep *s = m_all.s;
  known_row known;
  do
    if (! next_row (m_all.groups.get (), m_thread, m_all.next, m_all.table.n, known))
      return false;
  while (! begins (known));
  const double *breaks = m_r->times + 1 + s->tout.n;
  l.i = known.i;
  l.ip.resize (std::size_t (s->nip));
  l.rp.resize (std::size_t (s->rp.n));
  gs_take_plan (s, m_r->ip, m_r->rp, l.ip.data (), l.rp.data ());
  l.r.cst.assign (m_r->cst, m_r->cst + S.ncst);
  l.r.x0.assign (m_r->x0, m_r->x0 + s->nx);
  l.r.breaks.assign (breaks, breaks + m_r->nb);
  l.r.xout.resize (std::size_t (s->ldx) * s->tout.n);
  l.r.vout.resize (std::size_t (s->ldv) * s->tout.n);
  l.r.rstat.assign (m_r->rstat, m_r->rstat + GS_MEASURED);
  l.r.istat.assign (m_r->istat, m_r->istat + GS_COUNTED);
  l.r.w.assign (m_r->w, m_r->w + s->lw);
  l.r.info = 0;
  return true;
}

// and back
void
sweep_rows::done (lane_run& l)
{
  const gs_sweep *s = m_all.s;
  gs_take_plan (s, l.ip.data (), l.rp.data (), m_r->ip, m_r->rp);
  std::copy (l.r.cst.begin (), l.r.cst.end (), m_r->cst);
  std::copy (l.r.x0.begin (), l.r.x0.end (), m_r->x0);
  std::copy (l.r.breaks.begin (), l.r.breaks.end (), m_r->times + 1 + s->tout.n);
  m_r->nb = int (l.r.breaks.size ());
  std::copy (l.r.xout.begin (), l.r.xout.end (), m_r->xout);
  std::copy (l.r.vout.begin (), l.r.vout.end (), m_r->vout);
  std::copy (l.r.rstat.begin (), l.r.rstat.end (), m_r->rstat);
  std::copy (l.r.istat.begin (), l.r.istat.end (), m_r->istat);
  std::copy (l.r.w.begin (), l.r.w.end (), m_r->w);
  m_r->text[0] = 0;
  m_r->info = l.r.info;
  gs_end_row (s, m_r, row (l.i), m_all.why[l.i]);
}

int
gs_fit_lanes (const gs_sweep *s)
{
  return lane_group::fits (std::vector<int> (s->iopt, s->iopt + s->niopt));
}

gs_lanes *
gs_open_lanes (const gs_sweep *s, long long first, long long n, int threads, double *values,
               char (*why)[GS_WHY])
{
  return new gs_lanes (s, first, int (n), threads, values, why);
}

int
gs_run_lanes (gs_lanes *l, int thread)
{
  gs_sweep_room *r = gs_make_room (l->s);
  if (! r)
    return 1;
  sweep_rows mine (*l, thread, r);
  std::unique_ptr<lane_group> group (new lane_group (l->setting, l->ip, mine, l->most));
  group->run_all ();
  gs_free_room (r);
  return 0;
}

void
gs_close_lanes (gs_lanes *l)
{
  delete l;
}
