// A run that carries derivatives of the states by parameters: GSSEN stands for RHS, and behind PRJ
// comes GSSPJ.
#pragma once

#include "run_plan.h"

// outputs of a sampled device on their way: their place in the plan, their range among the held
// ones, when they arrive, the derivatives of all inputs with them
struct sent_outputs
{
  int place, from, to;
  double when;
  reals vp;
};

// What the wrappers know beside their arguments: Fortran's externals carry nothing.
struct carried
{
  std::vector<int> col;   // of each column of S the column of RHP, 0 for a start value
  gsmbp_sub rhp, prj, con, tan, cop;
  int top;                // coordinates whose rates are the speeds
  reals w, w2;
  std::vector<int> iw;

  // of each column: dtau/dp of the event that is at work; why it was given up (0: it was not), at
  // which event and when
  enum { grazing = 1, several, no_numbers, left_open };
  reals tau;
  std::vector<int> why, event;
  std::vector<double> lost_at;
  bool within;            // of the events of an instant one is done
  reals vt;               // derivatives of its inputs along the motion, NV x columns
  std::vector<double> times;   // dtau/dp of all events, event by event; not a number: there is none
  std::vector<reals> reports;  // ... of those that come at this instant and only report
  std::vector<char> changes;   // of each event function: its event changes what follows
  int nx;                 // of the states with all columns

  // of each event function the last two values and their times, the greatest one; where it came
  // close to 0 and turned: number, time
  std::vector<double> t1, t2, g1, g2, most;
  std::vector<double> turns;

  std::vector<int> ip;    // IP of the run's own inputs where they depend on states, else empty
  std::vector<char> own;  // which inputs are not held outputs or modes
  std::vector<double> switched;   // when an event of the user has first set an input; else infinity
  reals gain;             // of the feedback, NV x NX, as it was last evaluated
  gsmbp_sub cmd, clo;     // of a planned motion; what CMP said of it where it was last evaluated:
  reals vx, vm;           // derivatives of its inputs by states of devices, NV x NA, by parameters

  reals kp, yp;           // derivatives of memory and outputs, NXK and NY x columns
  std::vector<sent_outputs> sent;
  std::vector<double> kept;   // VP over time, see kept_inputs
  run_plan *plan;
  const reals *cst;
  reals wi, w3, atol;     // workspaces of GSINP; tolerances
  reals vp;               // derivatives of the inputs, NV x columns
  number rtol;

  int count (void) const { return int (col.size ()); }
};

static carried *the_columns = nullptr;   // only while a run lasts

// while the time of an event is looked for the columns do not matter
static bool
states_alone (const carried& c)
{
  return S.nev > 0 && *c.plan->events ().search == 1;
}

// columns that were given up stay zero
static void
drop_lost (const carried& c, number *x)
{
  for (int k = 0; k < c.count (); k++)
    if (c.why[k] != 0)
      std::fill (x + S.nx * (k + 1), x + S.nx * (k + 2), number (0));
}

static void arrivals (carried& c);
static void input_columns (const carried& c, const number *v, const number *s, int k, number *dv);

// what the rates get through inputs that depend on parameters and states; B is behind A and P in
// the workspace
static void
add_inputs (carried& c, const number *x, const number *v, number *xd)
{
  if (S.nctl > 0)
    arrivals (c);
  const number *b = &c.w[S.nx * (S.nx + S.nsp)];
  reals dv = room (S.nv);
  for (int k = 0; k < c.count (); k++)
    {
      input_columns (c, v, x + S.nx * (k + 1), k, &dv[0]);
      for (int j = 0; j < S.nv; j++)
        for (int i = 0; i < S.nx && dv[j] != 0; i++)
          xd[i + S.nx * (k + 1)] += b[i + S.nx * j] * dv[j];
    }
}

extern "C" void
gsmbp_rates_with_columns (const number *t, const number *x, const number *v, const number *cst,
                          number *xd, int *info)
{
  carried& c = *the_columns;
  const int nc = c.count ();
  if (states_alone (c))
    {
      routine ("rhs") (t, x, v, cst, xd, info);
      std::fill (xd + S.nx, xd + S.nx * (nc + 1), number (0));
      return;
    }
  fortran {gssen_} (c.rhp, t, &c.top, &S.nx, &S.nv, &S.nsp, &nc, &c.col[0], x, v, cst, &c.w[0], xd,
                    info);
  if (S.nctl > 0 || ! c.ip.empty () || (S.nev > 0 && c.plan->events ().ns > 0))
    add_inputs (c, x, v, xd);
  drop_lost (c, xd);
}

extern "C" void
gsmbp_projection_with_columns (const number *t, number *x, const number *cst, number *res,
                               int *info)
{
  carried& c = *the_columns;
  const int nc = c.count ();
  fortran {c.prj} (t, x, cst, res, info);
  if ((*info == 0 || *info == 2) && ! states_alone (c))
    fortran {gsspj_} (c.con, c.tan, c.cop, t, &S.nx, &S.nq, &S.nu, &S.nlam, &S.nsets, S.sets,
                      &S.nsp, &nc, &c.col[0], x, cst, &c.w2[0], &c.iw[0], info);
  drop_lost (c, x);
}

// are the speeds the rates of the coordinates? Two positions by chance tell, exactly.
static bool
plain_speeds (const reals& cst)
{
  if (S.nq != S.nu || ! emitted ("kin"))
    return false;
  reals q = room (S.nq), u = room (S.nu), rates = room (S.nq);
  bool plain = true;
  for (int k = 1; k <= 2; k++)
    {
      const number t = number (0.37) * k;
      for (int i = 0; i < S.nq; i++)
        {
          q[i] = std::sin (double (7 * k + 3 * i)) * 0.9;
          u[i] = std::cos (double (5 * k + 2 * i)) * 0.8;
        }
      routine ("kin") (&t, &q[0], &u[0], &cst[0], &rates[0]);
      plain = plain && rates == u;
    }
  return plain;
}

// the columns of a run by their numbers
static std::unique_ptr<carried>
columns_of (const Matrix& numbers, const reals& cst)
{
  std::unique_ptr<carried> c (new carried ());
  const int nc = int (numbers.numel ());
  if (nc == 0)
    return c;
  for (int k = 0; k < nc; k++)
    {
      c->col.push_back (int (numbers(k)));
      if (c->col[k] < 0 || c->col[k] > S.nsp)
        error ("%s: there is no column %d among %d", S.name, c->col[k], S.nsp);
    }
  const bool loops = S.nlam > 0;
  const int rows = S.nlam + S.nsets;
  c->top = plain_speeds (cst) ? S.nq : 0;
  c->rhp = routine ("rhp").f;
  c->con = loops ? routine ("con").f : gsmbp_absent;
  c->tan = loops ? routine ("tan").f : gsmbp_absent;
  c->cop = loops ? routine ("cop").f : gsmbp_absent;
  c->w = room (S.nx * (S.nx + S.nsp + S.nv + 1));
  c->w2 = room (rows * (S.nq + rows + nc) + S.nlam * (S.nq + S.nu + 2 * S.nsp + 3));
  c->iw.assign (rows + 1, 0);
  c->tau = room (nc);
  c->why.assign (nc, 0);
  c->event.assign (nc, 0);
  c->lost_at.assign (nc, 0.0);
  c->within = false;
  c->vp = room (S.nv * nc);
  c->gain = room (S.nv * S.nx);
  c->vx = room (S.nv * S.na);
  c->vm = room (S.nv * S.nsp);
  c->cmd = c->clo = gsmbp_absent;
  c->vt = c->vp;
  c->switched.assign (S.nv, std::numeric_limits<double>::infinity ());
  c->kp = room (S.nxk * nc);
  c->yp = room (S.ny * nc);
  return c;
}

// what a run of the states with these columns adds: its plan, tolerances, workspace of GSINP
static void
with_run (carried& c, run_plan& plan, const reals& cst, number rtol, const reals& atol)
{
  c.nx = S.nx * (1 + c.count ());
  c.plan = &plan;
  c.cst = &cst;
  c.rtol = rtol;
  c.atol = atol;
  c.wi = room (2 * S.nu * (plan.ip[GS_DERIVATIVES] + 1) + 5 * c.nx + S.nv * c.nx + 21);
  c.w3 = c.wi;
  if (S.nev > 0)
    {
      *plan.events ().tells = 1;
      c.changes = plan.changing_events ();
    }
  for (auto *list : { &c.t1, &c.t2, &c.g1, &c.g2, &c.most })
    list->assign (S.nev, 0.0);
}

// of each column why it was given up, at which event and when
static Matrix
lost_columns (const carried& c)
{
  Matrix m (c.count (), 3);
  for (int k = 0; k < c.count (); k++)
    {
      m(k, 0) = c.why[k];
      m(k, 1) = c.event[k];
      m(k, 2) = c.lost_at[k];
    }
  return m;
}
