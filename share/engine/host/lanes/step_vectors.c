/* Trial steps of Dormand and Prince, all lanes at once. */
#include "host/lanes/lanes.h"

#include <float.h>
#include <math.h>

#include "gsmbp/arith.h"

void
gs_lane_method (gs_lane_group *g)
{
  double a[12][12] = { { 0 } }, b[12] = { 0 }, c[12] = { 0 };   /* a[k][i]: of rate k in stage i */
  gs_dp853_table (a[0], b, c);
  for (int i = 0; i < 12; i++)
    {
      g->terms[i] = 0;
      g->at_time[i] = c[i];
      for (int k = 0; k < 12; k++)
        {
          const double factor = i == 0 ? b[k] : a[k][i];
          if (! (fabs (factor) > 0))
            continue;
          g->factor[i][g->terms[i]] = factor;
          g->which[i][g->terms[i]] = k;
          g->terms[i]++;
        }
    }
}

/* x + h times the sum of n rates, from the first on */
#define GS_STAGE(n, sum)                                                                           \
  case n:                                                                                          \
    for (int i = 0; i < nx; i++)                                                                   \
      {                                                                                            \
        const double *x = g->x[i];                                                                 \
        double *xs = g->xs[i];                                                                     \
        GS_EACH_LANE                                                                               \
        for (int l = 0; l < GS_LANES; l++)                                                         \
          xs[l] = x[l] + h[l] * (sum);                                                             \
      }                                                                                            \
    break;
#define GS_TERM(k) c[k] * f[k][i][l]
#define GS_SUM2 GS_TERM (0) + GS_TERM (1)
#define GS_SUM3 GS_SUM2 + GS_TERM (2)
#define GS_SUM4 GS_SUM3 + GS_TERM (3)
#define GS_SUM5 GS_SUM4 + GS_TERM (4)
#define GS_SUM6 GS_SUM5 + GS_TERM (5)
#define GS_SUM7 GS_SUM6 + GS_TERM (6)
#define GS_SUM8 GS_SUM7 + GS_TERM (7)
#define GS_SUM9 GS_SUM8 + GS_TERM (8)

/* the state xs of a stage (from 0) from the rates before it */
void
gs_stage_states (gs_lane_group *g, int stage)
{
  const int nx = g->nx;
  const double *c = g->factor[stage], *h = g->step;
  gs_lane *f[9];
  for (int k = 0; k < 9; k++)
    f[k] = g->f + g->which[stage][gs_least (k, g->terms[stage] - 1)] * nx;
  switch (g->terms[stage])
    {
      GS_STAGE (1, GS_TERM (0))
      GS_STAGE (2, GS_SUM2)
      GS_STAGE (3, GS_SUM3)
      GS_STAGE (4, GS_SUM4)
      GS_STAGE (5, GS_SUM5)
      GS_STAGE (6, GS_SUM6)
      GS_STAGE (7, GS_SUM7)
      GS_STAGE (8, GS_SUM8)
      GS_STAGE (9, GS_SUM9)
    }
}

/* The states xn at the end of the step and its errors err, as gs_step_dp853 has them. */
void
gs_estimate_errors (gs_lane_group *g)
{
  static const double e1 = 1.3120044994194880732501029953801793085e-2,
                      e6 = -1.2251564463762044407205697528543837147,
                      e7 = -4.9575894965725019152140799504384812683e-1,
                      e8 = 1.6643771824549865369615304151480492819,
                      e9 = -3.503288487499736816886487289838649404e-1,
                      e10 = 3.3417911871301747902973188414208476014e-1,
                      e11 = 8.1923206485115712465707426085956994164e-2,
                      e12 = -2.2355307863886295258844278437796047352e-2,
                      g1 = 2.4409448818897637795275590551181102362e-1,
                      g9 = 7.3384668828161185734136174154701250579e-1,
                      g12 = 2.2058823529411764705882352941176470588e-2;
  const int nx = g->nx;
  const double *c = g->factor[0], *h = g->step, rtol = g->e->run.ropt[1];
  gs_lane s1 = { 0 }, s2 = { 0 }, bad = { 0 };
  for (int i = 0; i < nx; i++)
    {
      gs_lane *f = g->f + i;
      const double atol = g->e->run.atol[i], *x = g->x[i], *f1 = f[0], *f6 = f[5 * nx],
                   *f7 = f[6 * nx], *f8 = f[7 * nx], *f9 = f[8 * nx], *f10 = f[9 * nx],
                   *f11 = f[10 * nx], *f12 = f[11 * nx];
      double *xn = g->xn[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double sum = c[0] * f1[l] + c[1] * f6[l] + c[2] * f7[l] + c[3] * f8[l]
                             + c[4] * f9[l] + c[5] * f10[l] + c[6] * f11[l] + c[7] * f12[l];
          const double end = x[l] + h[l] * sum;
          const double d3 = sum - g1 * f1[l] - g9 * f9[l] - g12 * f12[l];
          const double d5 = e1 * f1[l] + e6 * f6[l] + e7 * f7[l] + e8 * f8[l] + e9 * f9[l]
                            + e10 * f10[l] + e11 * f11[l] + e12 * f12[l];
          const double s = atol + rtol * gs_max (fabs (x[l]), fabs (end));
          const double q3 = s > 0 ? d3 / s : 0, q5 = s > 0 ? d5 / s : 0;
          xn[l] = end;
          s2[l] += q3 * q3;
          s1[l] = ! (s > 0) && fabs (d5) > 0 ? 1e300 : s1[l] + q5 * q5;
          bad[l] = fabs (end) <= 1e300 ? bad[l] : 1e307;
        }
    }
  const double many = gs_most (1, nx);
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double sum = s1[l] + 0.01 * s2[l], s = sum > 0 ? sum : 1;
      const double err = fabs (h[l]) * s1[l] / sqrt (many * s);
      g->err[l] = bad[l] > 0 ? bad[l] : err;
    }
}

/* gs_dp853_before for all lanes after the right-hand sides g->rates: those of lanes that wanted
 * them are the first stage; whether they are finite and stability binds the last step, where so
 * many steps that look bound are too many: slow is 1 where gs_dp853_before has to look by
 * itself. */
void
gs_take_rates (gs_lane_group *g, int many)
{
  const int nx = g->nx;
  const double rtol = g->e->run.ropt[1];
  gs_lane a = { 0 }, b = { 0 }, bad = { 0 };
  for (int i = 0; i < nx; i++)
    {
      const double atol = g->e->run.atol[i], *fresh = g->fresh, *rates = g->rates[i],
                   *x = g->x[i], *xs = g->xs[i], *f12 = g->f[i + 11 * nx];
      double *f = g->f[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        {
          const double y = fresh[l] > 0 ? rates[l] : f[l], size = atol + rtol * fabs (x[l]);
          const double s = size > 0 ? size : 1e308, p = (y - f12[l]) / s, q = (x[l] - xs[l]) / s;
          f[l] = y;
          a[l] += p * p;
          b[l] += q * q;
          bad[l] = fabs (y) <= 1e300 ? bad[l] : 1;
        }
    }
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const int looks_bound = fabs (g->last[l]) * sqrt (a[l]) > 5 * sqrt (b[l]);
      const double s = g->bound[l], p = g->unbound[l], more = s + 1, longer = p + 1;
      const double wants = g->wants[l], after = g->after[l], stiff = g->stiff[l];
      const double called = g->called[l], all = called + g->fresh[l], free = p >= 5 ? 0 : s;
      const double bound = looks_bound ? more : free, unbound = looks_bound ? 0 : longer;
      double slow = g->next[l] <= 0 ? 1 : bad[l];
      slow = (after > 0) & (stiff <= 0) & (bound >= many) ? 1 : slow;
      slow = wants <= 0 ? 0 : slow;
      const int stays = (after <= 0) | (wants <= 0) | (stiff > 0) | (slow > 0);
      g->slow[l] = slow;
      g->bound[l] = stays ? s : bound;
      g->unbound[l] = stays ? p : unbound;
      g->called[l] = slow <= 0 ? all : called;
      g->wants[l] = slow <= 0 ? 0 : wants;
    }
}

/* gs_begin_trial for all lanes, far from singular positions: the lengths and ends of the next trial
 * steps; slow is 1 where that has to look by itself. */
void
gs_begin_trials (gs_lane_group *g)
{
  const double eps = 16 * DBL_EPSILON;
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double t = g->t[l], stop = g->stop[l];
      const double s = gs_min (gs_min (g->next[l], g->longest[l]), g->limit[l]);
      const int whole = t + 1.01 * s >= stop, half = t + 2 * s > stop;
      const double h = whole ? stop - t : half ? 0.5 * (stop - t) : s;
      const double tn = whole ? stop : t + h;
      double slow = g->good[l] + g->others[l] >= g->allowed[l] ? 1 : 0;
      slow = h <= eps * gs_max (fabs (t), fabs (stop)) && tn < stop ? 1 : slow;
      slow = g->pivot[l] < g->near[l] * g->highest[l] ? 1 : slow;
      slow = g->pivot[l] < 0.25 * g->highest[l] && h <= 1e-4 * g->far[l] ? 1 : slow;
      const int runs = g->runs[l] > 0;
      g->at[l] = whole ? g->side[l] : 1;
      g->last[l] = runs ? h : g->last[l];
      g->slow[l] = runs ? slow : 0;
      g->tn[l] = runs ? tn : t;
      g->step[l] = runs ? h : 0;
    }
}

/* r is 1 where trial steps are good, 2 where they are to be repeated, 3 where gs_end_trial has to
 * look by itself, 0 where there were none. */
void
gs_judge_trials (gs_lane_group *g)
{
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double err = g->err[l];
      double s = err <= 1 ? 1 : 2;
      s = err <= 1 && g->due[l] < g->tn[l] ? 3 : s;
      s = err <= 1e300 ? s : 3;
      g->r[l] = g->runs[l] <= 0 ? 0 : s;
    }
}

/* The end of a trial step: where r is 1 x becomes xn; the lengths of the next steps, where r is 1
 * or 2. The eighth root of the error is that of three square roots. */
void
gs_end_trials (gs_lane_group *g)
{
  GS_EACH_LANE
  for (int l = 0; l < GS_LANES; l++)
    {
      const double h = g->step[l], z = g->next[l];
      const double error = gs_min (1e300, gs_max (1e-16, g->err[l]));
      const double fac = 0.9 / sqrt (sqrt (sqrt (error)));
      const double longer = h * gs_max (gs_min (6, fac), 1.0 / 3);
      const double shorter = h * gs_min (0.9, gs_max (0.2, fac)), r = g->r[l], tn = g->tn[l];
      const int good = (r > 0.5) & (r < 1.5), again = (r > 1.5) & (r < 2.5);
      const int is_far = g->pivot[l] >= 0.25 * g->highest[l];
      const double after = (h >= 0.99 * z) | (longer > z) ? longer : z;
      const double kept = good ? after : z, next = again ? shorter : kept;
      const double least = gs_min (g->least[l], h), largest = gs_max (g->largest[l], h);
      const double near = again ? 0.25 : g->near[l];
      g->next[l] = next;
      g->t[l] = good ? tn : g->t[l];
      g->least[l] = good ? least : g->least[l];
      g->largest[l] = good ? largest : g->largest[l];
      g->good[l] += good ? 1 : 0;
      g->wants[l] = good ? 1 : g->wants[l];
      g->after[l] = good ? 1 : g->after[l];
      g->then[l] = good ? next : g->then[l];
      g->moved[l] = good ? 1 : g->moved[l];
      g->far[l] = good & is_far ? next : g->far[l];
      g->others[l] += again ? 1 : 0;
      g->near[l] = good ? 0.05 : near;
      g->called[l] += good | again ? 11 : 0;
    }
  gs_take_states (g);
}

/* where r is 1 x becomes xn */
void
gs_take_states (gs_lane_group *g)
{
  for (int i = 0; i < g->nx; i++)
    {
      const double *r = g->r, *xn = g->xn[i];
      double *x = g->x[i];
      GS_EACH_LANE
      for (int l = 0; l < GS_LANES; l++)
        x[l] = (r[l] > 0.5) & (r[l] < 1.5) ? xn[l] : x[l];
    }
}
