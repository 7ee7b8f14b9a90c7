/* lanes_by_one.h: routines over lanes of an emitted scene, each made of those of one state, for
 * ensemble_runs.c. LANES_BY_ONE (name, NAME, pre, loops): name_lanes of the scene name_scene with
 * the sizes NAME_NX; loops: 1 where it has constraints. */
#define GATHER(to, from, n)                                                                        \
  for (int k_ = 0; k_ < (n); k_++)                                                                 \
    (to)[k_] = (from)[*ldk * k_ + l]
#define SCATTER(from, to, n)                                                                       \
  for (int k_ = 0; k_ < (n); k_++)                                                                 \
    (to)[*ldk * k_ + l] = (from)[k_]

/* the step of least norm d with h d = -b, h (m,n) */
static void
least_step (int m, int n, const double *h, const double *b, double *d)
{
  double a[16], y[4];
  int iw[4];
  for (int i = 0; i < m; i++)
    {
      y[i] = -b[i];
      for (int j = 0; j < m; j++)
        {
          a[i + m * j] = 0;
          for (int k = 0; k < n; k++)
            a[i + m * j] += h[i + m * k] * h[j + m * k];
        }
    }
  if (gs_solve_general (m, 1, a, m, y, m, iw) != 0)
    abort ();
  for (int k = 0; k < n; k++)
    {
      d[k] = 0;
      for (int i = 0; i < m; i++)
        d[k] += h[i + m * k] * y[i];
    }
}

static void
rates_by_one (const gs_scene *s, int ncst, const double *t, const double *x, const double *v,
              const double *cst, double *xd, int *info, const int *k, const int *ldk)
{
  for (int l = 0; l < *k; l++)
    {
      double x1[NX], v1[8] = { 0 }, c1[NCST], xd1[NX];
      GATHER (x1, x, s->nx);
      GATHER (v1, v, s->nv);
      GATHER (c1, cst, ncst);
      info[l] = s->rhs (t[l], x1, v1, c1, xd1);
      SCATTER (xd1, xd, s->nx);
    }
  for (int l = *k; l < *ldk; l++)
    info[l] = 0;
}

static void
events_by_one (const gs_scene *s, int ncst, const double *t, const double *x, const double *v,
               const double *cst, double *gv, int *info, const int *k, const int *ldk)
{
  for (int l = 0; l < *k; l++)
    {
      double x1[NX], v1[8] = { 0 }, c1[NCST], g1[8];
      const int mode[8] = { 0 };
      GATHER (x1, x, s->nx);
      GATHER (v1, v, s->nv);
      GATHER (c1, cst, ncst);
      s->evt (t[l], x1, v1, mode, c1, g1);
      SCATTER (g1, gv, s->nev);
      info[l] = 0;
    }
}

static void
constraints_by_one (const gs_scene *s, int ncst, const double *t, const double *q,
                    const double *cst, double *hc, int *info, const int *k, const int *ldk)
{
  for (int l = 0; l < *k; l++)
    {
      double q1[NX], u1[NX] = { 0 }, c1[NCST], phi[4], phit[4], gam[4], h[4 * NX];
      GATHER (q1, q, s->nq);
      GATHER (c1, cst, ncst);
      info[l] = s->con (t[l], q1, u1, c1, phi, phit, h, s->nlam, gam);
      SCATTER (h, hc, s->nlam * s->nq);
    }
}

static void
projection_by_one (const gs_scene *s, int ncst, const double *t, const double *x,
                   const double *cst, double *phi, double *rate, double *hc, double *dq,
                   double *du, int *info, const int *k, const int *ldk)
{
  const int m = s->nlam, n = s->nq;
  for (int l = 0; l < *k; l++)
    {
      double x1[NX], c1[NCST], phi1[4], phit[4], gam[4], h[4 * NX], rate1[4], dq1[NX], du1[NX];
      GATHER (x1, x, s->nx);
      GATHER (c1, cst, ncst);
      info[l] = s->con (t[l], x1, x1 + n, c1, phi1, phit, h, m, gam);
      for (int i = 0; i < m; i++)
        {
          rate1[i] = phit[i];
          for (int j = 0; j < n; j++)
            rate1[i] += h[i + m * j] * x1[n + j];
        }
      least_step (m, n, h, phi1, dq1);
      least_step (m, n, h, rate1, du1);
      SCATTER (phi1, phi, m);
      SCATTER (rate1, rate, m);
      SCATTER (h, hc, m * n);
      SCATTER (dq1, dq, n);
      SCATTER (du1, du, n);
    }
}

static void
parameters_by_one (gs_pre *pre, int npar, int ncst, const double *par, double *cst, int *info,
                   const int *k, const int *ldk)
{
  for (int l = 0; l < *k; l++)
    {
      double p1[40], c1[NCST];
      GATHER (p1, par, npar);
      info[l] = pre (p1, c1) == 0 ? 0 : 9;
      if (info[l] == 0)
        SCATTER (c1, cst, ncst);
    }
}

#define LANES_BY_ONE(name, NPAR_, NCST_, loops, own)                                               \
  static void name##_rhs_w (const double *t, const double *x, const double *v, const double *cst,  \
                            double *xd, int *info, const int *k, const int *ldk)                   \
  {                                                                                                \
    rates_by_one (&name##_scene, NCST_, t, x, v, cst, xd, info, k, ldk);                           \
  }                                                                                                \
  static void name##_evt_w (const double *t, const double *x, const double *v, const double *cst,  \
                            double *gv, int *info, const int *k, const int *ldk)                   \
  {                                                                                                \
    events_by_one (&name##_scene, NCST_, t, x, v, cst, gv, info, k, ldk);                          \
  }                                                                                                \
  static void name##_con_w (const double *t, const double *q, const double *cst, double *hc,       \
                            int *info, const int *k, const int *ldk)                               \
  {                                                                                                \
    constraints_by_one (&name##_scene, NCST_, t, q, cst, hc, info, k, ldk);                        \
  }                                                                                                \
  static void name##_prj_w (const double *t, const double *x, const double *cst, double *phi,      \
                            double *rate, double *hc, double *dq, double *du, int *info,           \
                            const int *k, const int *ldk)                                          \
  {                                                                                                \
    projection_by_one (&name##_scene, NCST_, t, x, cst, phi, rate, hc, dq, du, info, k, ldk);      \
  }                                                                                                \
  static void name##_pre_w (const double *par, double *cst, int *info, const int *k,               \
                            const int *ldk)                                                        \
  {                                                                                                \
    parameters_by_one (name##_constants, NPAR_, NCST_, par, cst, info, k, ldk);                    \
  }                                                                                                \
  static const gs_lane_routines name##_lanes                                                       \
    = { name##_rhs_w, own ? name##_evt_w : NULL, loops ? name##_con_w : NULL,                      \
        loops ? name##_prj_w : NULL, name##_pre_w };
