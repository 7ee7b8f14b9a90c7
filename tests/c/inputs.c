/* share/engine/core/inputs against share/fortran/inputs: polynomials, planned motions, sampled
   devices */
#include "bridge.h"

void gspln_ (), gsppl_ (), gsbak_ (), gsfol_ (), gsinp_ (), gssmp_ (), gsdue_ (),
  gskep_ ();
gs_real gsnxt_ ();

/* times: before, at, between and behind the breaks */
static gs_real
some_time (int np, const gs_real *brk)
{
  const int k = pick (np + 1);
  switch (pick (5))
    {
    case 0: return brk[k];
    case 1: return brk[0] - 0.5;
    case 2: return brk[np] + (pick (2) ? 0.5 : 1e-14);
    case 3: return brk[0] - 1e-14;
    default: return brk[0] + 0.5 * (chance () + 1) * (brk[np] - brk[0]);
    }
}

static void
breaks (int np, gs_real *brk)
{
  brk[0] = chance ();
  for (int i = 1; i <= np; i++)
    brk[i] = brk[i - 1] + 1.1 + chance ();
}

static void
polynomials (void)
{
  begin ("gs_polynomials_at");
  for (int i = 0; i < 2000; i++)
    {
      int nc = pick (4), np = pick (8) ? 1 + pick (6) : 0, k = pick (9) ? 1 + pick (6) : 0;
      int nd = pick (9) - 1, side = pick (2) ? 1 : -1, ldf = pick (9) ? nc + 1 : 0, info = 0;
      gs_real brk[10], coef[200], t;
      pair f = pair_of (8 * 10);
      breaks (np, brk);
      for (int j = 0; j < nc * np * k; j++)
        coef[j] = chance ();
      t = pick (20) ? some_time (np, brk) : NAN;
      gspln_ (&nc, &np, &k, brk, coef, &t, &side, &nd, f.f, &ldf, &info);
      same_int (gs_polynomials_at (nc, np, k, brk, coef, t, side, nd, f.c, ldf), info);
      same (f);
      drop (f);
    }
  finish ();

  begin ("gs_planned_rows, gs_motion_back");
  for (int i = 0; i < 300; i++)
    {
      const int ipl[3] = { 2, 4, 1 };
      int na = pick (4), nu = 4, np = 2, k = 4, r = 1 + pick (3), side = pick (3) - 1, info = 0;
      gs_real brk[3], coef[24], t;
      pair qj = pair_of (16), f = pair_of (12);
      breaks (np, brk);
      for (int j = 0; j < 24; j++)
        coef[j] = chance ();
      t = i == 0 ? NAN : some_time (np, brk);
      gsppl_ (&t, &side, &nu, &r, &na, ipl, &np, &k, brk, coef, f.f, qj.f, &info);
      same_int (gs_planned_rows (t, side, nu, r, na, ipl, np, k, brk, coef, f.c, qj.c), info);
      same (qj);
      gs_motion_back (nu, coef, qj.c);
      gsbak_ (&nu, coef, qj.f);
      same (qj);
      drop (qj);
      drop (f);
    }
  finish ();
}

/* ------------------------------------------------------------ a chain: q1 is planned, q2 = f(q1)
 * on one of two branches */

static int
chain_clo (gs_real t, gs_real *qj, const gs_real *cst, gs_real *res)
{
  const gs_real w = cst[0] * gs_sin (3 * qj[0]), wd = 3 * cst[0] * gs_cos (3 * qj[0]) * qj[2];
  (void)t;
  *res = 0;
  if (! (gs_abs (w) < 1))
    return 3;
  const gs_real s = qj[1] >= 0 ? 1 : -1;
  qj[1] = s * gs_sqrt (1 - w * w);
  qj[3] = -s * w * wd / gs_sqrt (1 - w * w);
  return 0;
}

static const gs_scene chain = { .nq = 2, .nu = 2, .nx = 4, .nv = 3, .ny = 2, .clo = chain_clo };

static void
chains (void)
{
  begin ("gs_follow_motion");
  bridged = &chain;
  for (int i = 0; i < 300; i++)
    {
      const int ipl[1] = { 1 };
      int np = 2, k = 3, r = 2, na = 1, nu = 2, side, info = 0;
      gs_real brk[3] = { 0, 1, 2 }, coef[6], cst[1] = { pick (3) ? 0.9 : 0 };
      pair qj = pair_of (6), w = pair_of (9);
      for (int j = 0; j < 6; j++)
        coef[j] = chance ();
      if (pick (4)) /* without a jump */
        coef[5] = coef[0] + coef[2] + coef[4];
      w.c[1] = w.f[1] = 0;
      for (int n = 0; n < 5; n++)
        {
          gs_real t = n * 0.4 + 0.3 * chance ();
          side = pick (2) ? 1 : -1;
          t = n == 3 ? 1 : t;
          gsfol_ (through.clo, &t, &side, &nu, &r, &na, ipl, &np, &k, brk, coef, cst, qj.f, w.f,
                  &info);
          same_int (
              gs_follow_motion (&chain, t, side, r, na, ipl, np, k, brk, coef, cst, qj.c, w.c),
              info);
          same (qj);
          same (w);
        }
      drop (qj);
      drop (w);
    }
  finish ();
}

/* a plan into a dead point, by which the chain cannot go: both say so, when the halved step has
 * become 0 by rounding */
static int
dead_point_clo (gs_real t, gs_real *qj, const gs_real *cst, gs_real *res)
{
  static int calls;
  (void)t, (void)cst;
  *res = 0;
  if (calls++ > 100000)
    exit (1);
  if (! (gs_abs (qj[0]) <= 1))
    return 3;
  qj[1] = gs_sqrt (1 - qj[0] * qj[0]);
  qj[3] = qj[0] < 1 ? -qj[0] * qj[2] / qj[1] : 0;
  return 0;
}

static void
dead_points (void)
{
  const gs_scene s = { .nq = 2, .nu = 2, .clo = dead_point_clo };
  gs_real brk[2] = { 0, 10 }, coef[2] = { 1, 0 }, far = 1.5;
  const int one = 1, two = 2;
  int stops = 1;
  bridged = &s;
  for (gs_real t = 0.5; t < 1; t += 0.01)
    {
      gs_real qj[6] = { 0, 1 }, w[9] = { 0 }, qf[6] = { 0, 1 }, wf[9] = { 0 };
      int found = 0;
      gs_follow_motion (&s, t, 1, 1, 1, I (1), 1, 2, brk, coef, NULL, qj, w);
      int info = gs_follow_motion (&s, 1.5, 1, 1, 1, I (1), 1, 2, brk, coef, NULL, qj, w);
      gsfol_ (through.clo, &t, &one, &two, &one, &one, I (1), &one, &two, brk, coef, brk, qf, wf,
              &found);
      gsfol_ (through.clo, &far, &one, &two, &one, &one, I (1), &one, &two, brk, coef, brk, qf, wf,
              &found);
      stops = stops && info > 0 && found == info && qf[0] == qj[0] && qf[1] == qj[1];
    }
  holds (stops, "gs_follow_motion: a chain stops at a dead point");
}

/* ------------------------------------------------------------ */

static int
any_out (gs_real t, const gs_real *x, const gs_real *v, const gs_real *cst, gs_real *y)
{
  y[0] = x[0] + v[0];
  y[1] = t * x[1] - v[1];
  return (int)cst[0];
}

static void
any_ctl (int k, gs_real t, const gs_real *y, gs_real *xk, const gs_real *cst, gs_real *v)
{
  (void)cst;
  xk[0] += 0.1 * y[0] + k;
  v[0] = xk[0] - t;
  v[1] += y[1];
  v[2] = k;
}

static int
any_vin (gs_real t, int side, const gs_real *x, int nx, int nv, void *data, gs_real *v)
{
  (void)data;
  for (int i = 0; i < nv; i++)
    v[i] = t + side + i * x[nx - 1];
  return 0;
}

static const gs_scene sampled = { .nq = 2, .nu = 2, .nx = 4, .nv = 3, .ny = 2, .out = any_out,
                                  .ctl = any_ctl, .vin = any_vin };

static void
samples_of_a_run (void)
{
  static test c, f;
  begin ("gs_samples_due, gs_sample, gs_sample_keep, gs_next_sample");
  bridged = &sampled;
  for (int i = 0; i < 60; i++)
    {
      const int held[3] = { 1, pick (2), 1 }, anew[3] = { pick (2), pick (2), pick (2) };
      const int input[3] = { 2, held[1] ? 1 : 3, 3 };
      const gs_real period[3] = { 0.1, 0.02 * (1 + pick (4)), 0.3 };
      const gs_real delay[3] = { pick (2) * 0.15, 0, pick (2) * 0.02 }, memory[2] = { 0.1, 0.2 };
      gs_real ts, tf, t = 0;
      make (&c, &sampled, NULL, 1, 1);
      samples (&c, 3, period, delay, held, anew, input, 2, memory, pick (4), pick (20));
      c.ip[GS_V0] = 3 * pick (2);
      c.cst[0] = pick (5);
      f = c;
      for (int n = 0; n < 20; n++, t = ts)
        {
          gs_real x[4] = { chance (), chance (), t, 1 };
          int acted, actf, info = 0;
          int *is = c.ip + c.ip[GS_SAMPLES] - 1;
          gs_real *rs = c.rp + c.ip[GS_SAMPLES + 1] - 1;
          if (n % 3 == 1)   // on trial, and back
            {
              gs_sample_keep (0, 3, is, rs);
              gs_samples_due (&sampled, t, x, 4, c.ip, c.rp, c.cst, c.vout, c.w, c.run.istat, &ts,
                              &acted);
              gs_sample_keep (1, 3, is, rs);
              int *isf = f.ip + f.ip[GS_SAMPLES] - 1;
              gs_real *rsf = f.rp + f.ip[GS_SAMPLES + 1] - 1;
              gskep_ (I (0), I (3), isf, rsf);
              gsdue_ (through.out, through.ctl, through.cmd, through.clo, through.vin, &t, x, I (2),
                      I (4), I (3), f.ip, f.rp, f.cst, f.vout, f.w, f.run.istat, &tf, &actf, &info);
              gskep_ (I (1), I (3), isf, rsf);
            }
          gsdue_ (through.out, through.ctl, through.cmd, through.clo, through.vin, &t, x, I (2),
                  I (4), I (3), f.ip, f.rp, f.cst, f.vout, f.w, f.run.istat, &tf, &actf, &info);
          same_int (gs_samples_due (&sampled, t, x, 4, c.ip, c.rp, c.cst, c.vout, c.w, c.run.istat,
                                    &ts, &acted),
                    info);
          same_int (acted, actf);
          same_numbers (1, &ts, &tf);
          same_numbers (c.nrp, c.rp, f.rp);
          same_numbers (3, c.vout, f.vout);
          for (int k = 0; k < c.nip; k++)
            same_int (c.ip[k], f.ip[k]);
          for (int k = 0; k < 20; k++)
            same_int (c.run.istat[k], f.run.istat[k]);
          same_numbers (1, D (gs_next_sample (3, is, rs)), D (gsnxt_ (I (3), is, rs)));
        }
    }
  finish ();
}

int
main (void)
{
  polynomials ();
  chains ();
  dead_points ();
  samples_of_a_run ();
  return 0;
}
