// A run whose steps are kept, and the way back through them (gsmbp_adjoint): the steps are those of
// GSDP8, without projection, events, samples.
#pragma once

#include "patience.h"
#include "run_plan.h"

// what both ways need beside the scene
struct adjoint_run
{
  adjoint_run (arguments& a)
    : cst (a.constants ()), plan (a.value ("plan").scalar_map_value (), S.nx),
      v (room (2 * S.nv + 1)),
      wi (room (2 * S.nu * (plan.ip[GS_DERIVATIVES] + 1) + 5 * S.nx + S.nv * S.nx + 21)),
      p (room (24 + 8 * S.nu + 10 * S.nq + 7 * S.nlam + 2 * S.nlam * S.nu)),
      rstat (room (GS_MEASURED)), istat (GS_COUNTED, 0), info (0)
  {
    int side = 1;
    reals x = room (S.nx);
    number t = 0;
    fortran {gsinp_} (gsmbp_absent, gsmbp_absent, gsmbp_absent, &t, &side, &x[0], &S.nu, &S.nx,
                      &S.nv, plan.ip.data (), plan.rp.data (), &cst[0], &v[0], &wi[0], &info);
  }

  // the right-hand side at a state
  void rates (number t, const number *x, number *xd)
  {
    int side = 1;
    fortran {gsfun_} (routine ("rhs").f, gsmbp_absent, gsmbp_absent, gsmbp_absent, gsmbp_absent,
                      gsmbp_absent, &t, &side, x, &S.nq, &S.nu, &S.nx, &S.nv, &S.nlam,
                      plan.ip.data (), plan.rp.data (), &cst[0], &v[0], xd, &wi[0], &p[0],
                      &istat[0], &rstat[0], &info);
  }

  // the length of a first step
  number first (number t, number longest, const number *x, number rtol, const number *atol,
                number *w)
  {
    number h = longest;
    fortran {gshin_} (routine ("rhs").f, gsmbp_absent, gsmbp_absent, gsmbp_absent, gsmbp_absent,
                      gsmbp_absent, &t, &longest, x, &S.nq, &S.nu, &S.nx, &S.nv, &S.nlam,
                      plan.ip.data (), plan.rp.data (), &cst[0], &v[0], &rtol, atol, w, &wi[0],
                      &p[0], &istat[0], &rstat[0], &h, &info);
    return h;
  }

  // a trial step from x to xn; its error beside the tolerance
  number step (number t, number tn, int side, number h, const number *x, number rtol,
               const number *atol, number *xn, number *w)
  {
    number err = 0;
    fortran {gsdp8_} (routine ("rhs").f, gsmbp_absent, gsmbp_absent, gsmbp_absent, gsmbp_absent,
                      gsmbp_absent, &t, &tn, &side, &h, x, &S.nq, &S.nu, &S.nx, &S.nv, &S.nlam,
                      plan.ip.data (), plan.rp.data (), &cst[0], &v[0], &rtol, atol, xn, &err, w,
                      &wi[0], &p[0], &istat[0], &rstat[0], &info);
    return info == 0 && err == err ? err : number (1e10);
  }

  reals cst;
  run_plan plan;
  reals v, wi, p, rstat;
  std::vector<int> istat;
  int info;
};

// at a step that begins or ends at T: 0, or what ends it all (INFO of patience.h)
static int
ended_at (patience& p, number t)
{
  return patience::asked () && p.look (double (t)) ? p.why () : patience::none;
}

// (constants, plan, x0, t0 and the stops, rtol, atol, timeout): a column for each step: begin, end,
// length, side, state at the begin, its twelve right-hand sides; the number of steps up to each
// stop; the state at each; INFO: 0, 2 where the steps became too small, or that of patience.h; the
// time that was reached
static octave_value_list
do_forward (arguments& a, int)
{
  adjoint_run run (a);
  reals x = a.vector ("x0", S.nx), stops = a.vector ("stops", -1);
  number rtol = a.scalar ("rtol");
  reals atol = a.vector ("atol", S.nx), w = room (13 * S.nx), xn = room (S.nx);
  std::vector<double> kept;
  const int ns = int (stops.size ());
  patience p (double (a.scalar ("timeout")), double (stops[0]), double (stops[ns - 1]),
              "s");
  Matrix counts (ns, 1, 0.0), states (S.nx, ns, no_number);
  auto keep_state = [&] (int i) { for (int j = 0; j < S.nx; j++) states(j, i) = double (x[j]); };
  keep_state (0);
  number t = stops[0], h = 0;
  int steps = 0, info = 0;
  for (int i = 1; i < ns && info == 0; i++)
    {
      const number end = stops[i];
      while (t < end && info == 0)
        {
          run.rates (t, &x[0], &w[0]);
          if (h == 0)
            h = run.first (t, end - t, &x[0], rtol, &atol[0], &w[0]);
          number length = h, tn = t + h;
          int side = 1;
          if (t + number (1.01) * h >= end)
            {
              length = end - t;
              tn = end;
              side = -1;
            }
          number err = run.step (t, tn, side, length, &x[0], rtol, &atol[0], &xn[0], &w[0]);
          number factor = err > 0 ? number (0.9 * std::pow (double (err), -0.125)) : number (6);
          if (err <= 1)
            {
              kept.insert (kept.end (), {double (t), double (tn), double (length), double (side)});
              kept.insert (kept.end (), x.begin (), x.end ());
              kept.insert (kept.end (), w.begin (), w.begin () + 12 * S.nx);
              steps++;
              x = xn;
              t = tn;
              number next = length * std::min (number (6), std::max (number (1.0 / 3), factor));
              h = side < 0 ? std::max (h, next) : next;
            }
          else
            h = length * std::min (number (0.9), std::max (number (0.2), factor));
          if (h < 1e-14 * std::max (number (1e-30), end))
            info = 2;
          if (info == 0)
            info = ended_at (p, t);
        }
      counts(i) = steps;
      keep_state (i);
    }
  p.settle ();
  Matrix record (4 + 13 * S.nx, steps);
  std::copy (kept.begin (), kept.end (), record.fortran_vec ());
  return ovl (record, counts, states, info, double (t));
}

// (constants, plan, record of the forward way, numbers of steps up to each stop, weights of the
// states at each stop, timeout): derivatives by the first state and by the parameters; INFO: of
// ADJ, or that of patience.h; the time that was reached
static octave_value_list
do_backward (arguments& a, int)
{
  adjoint_run run (a);
  Matrix record = a.value ("record").matrix_value (), counts = a.value ("counts").matrix_value (),
         weights = a.value ("weights").matrix_value ();
  reals lx = room (S.nx), pb = room (S.nsp), w = room (15 * S.nx + S.nv + S.nsp),
        k = room (12 * S.nx), x = room (S.nx);
  std::fill (lx.begin (), lx.end (), number (0));
  std::fill (pb.begin (), pb.end (), number (0));
  int at = int (record.columns ());
  const double from = at > 0 ? record(1, at - 1) : 0, to = at > 0 ? record(0, 0) : 1;
  patience patient (double (a.scalar ("timeout")), from, to, "s, backward");
  for (int i = int (counts.numel ()) - 1; i >= 0; i--)
    {
      for (; i < int (counts.numel ()) - 1 && at > int (counts(i)); )
        {
          const double *one = record.data () + (4 + 13 * S.nx) * std::ptrdiff_t (--at);
          number t = one[0], tn = one[1], h = one[2];
          int side = int (one[3]);
          std::copy (one + 4, one + 4 + S.nx, x.begin ());
          std::copy (one + 4 + S.nx, one + 4 + 13 * S.nx, k.begin ());
          fortran {gsad8_} (routine ("adj").f, &t, &tn, &side, &h, &x[0], &k[0], &S.nu, &S.nx,
                            &S.nv, &S.nsp, run.plan.ip.data (), run.plan.rp.data (), &run.cst[0],
                            &run.v[0], &lx[0], &pb[0], &w[0], &run.wi[0], &run.info);
          if (run.info == 0)
            run.info = ended_at (patient, t);
          if (run.info != 0)
            {
              patient.settle ();
              return ovl (result (lx, S.nx), result (pb, S.nsp), run.info, double (t));
            }
        }
      for (int j = 0; j < S.nx; j++)
        lx[j] += weights(j, i);
    }
  return ovl (result (lx, S.nx), result (pb, S.nsp), 0, 0.0);
}
