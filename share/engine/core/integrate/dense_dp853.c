/* gs_dense_dp853: behind a step of gs_step_dp853 its polynomial of order 7: the rates at its end
 * and three stages more.
 *
 * The coefficients are those of share/fortran: the published ones, carried on to 38 digits from
 * the quadrature conditions of the stages and the conditions up to order 7.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.6 (dense output
 * for the method of order 8). */

#include "gsmbp/arith.h"
#include "gsmbp/integrate.h"
#include "gsmbp/loops.h"

/* the stages 14 to 16: at t + c*h; the columns of f whose stages they take, and the factors of
 * these.  Stage 13, the rates at the end, and they stand in the columns 1 to 4, which are free. */
static const struct
{
  gs_real c;
  int column[8];
  gs_real a[8];
} stage[3] = {
  { GS_R (0.1),
    { 0, 6, 7, 8, 9, 10, 11, 1 },
    { GS_R (5.616750228304795233929092196808835088e-2),
      GS_R (2.5350021021662481108879476533244434029e-1),
      -GS_R (2.4623903747080248991744147544091267073e-1),
      -GS_R (1.2419142326381636046901014062612922994e-1),
      GS_R (1.5329179827876569731206322685011242997e-1),
      GS_R (8.2010522956346898849166660205544010511e-3),
      GS_R (7.5678976605456997613860358958423784806e-3),
      -GS_R (8.298e-3) } },
  { GS_R (0.2),
    { 0, 5, 6, 7, 10, 11, 1, 2 },
    { GS_R (3.1834648163502140506076847326062954552e-2),
      GS_R (2.8300909672366775528832296140254226938e-2),
      GS_R (5.3541988307438567622379738437171210315e-2),
      -GS_R (5.492374857139098846465693403059960239e-2),
      -GS_R (1.0834732869724932285850931699437051482e-4),
      GS_R (3.825710908356584129549201923226346803e-4),
      -GS_R (3.404650086874045608029771144923653197e-4),
      GS_R (1.4131244367463250027807461836627531174e-1) } },
  { GS_R (7.7777777777777777777777777777777777778e-1),
    { 0, 5, 6, 7, 8, 1, 2, 3 },
    { -GS_R (4.2889630158379192340857353869179790275e-1),
      -GS_R (4.697621415361163843144494472061115892),
      GS_R (7.6834211960625990418424095387807972522),
      GS_R (4.0689898183971100797021355433098297066),
      GS_R (3.5672718745528110927066954302055167332e-1),
      -GS_R (1.3990241651590146212941800973427111366e-3),
      GS_R (2.9475147891527723389556272148966788837),
      -GS_R (9.1509584721798700108187018713798232322) } }
};

/* the columns of f, and the factors of their stages in the four highest coefficients */
static const int column[12] = { 0, 5, 6, 7, 8, 9, 10, 11, 1, 2, 3, 4 };
static const gs_real d[4][12] = {
  { -GS_R (8.4289382761090128651353491156926746058),
    GS_R (5.6671495351937776962531783681399719771e-1),
    -GS_R (3.0689499459498916912797304725279267159),
    GS_R (2.3846676565120698287728149684829354651),
    GS_R (2.1170345824450282767155149947547719394),
    -GS_R (8.7139158377797299206789907515508291831e-1),
    GS_R (2.2404374302607882758541771638108757242),
    GS_R (6.3157877876946881815570249306256900235e-1),
    -GS_R (8.8990336451333310820698116813268590269e-2),
    GS_R (1.8148505520854727256656404964585408434e1),
    -GS_R (9.1946323924783554000451984443154903043),
    -GS_R (4.4360363875948939664310571970061146284) },
  { GS_R (1.0427508642579134603413151007820153768e1),
    GS_R (2.4228349177525818288430175319346907856e2),
    GS_R (1.6520045171727028198505394886943906276e2),
    -GS_R (3.7454675472269020279518312151748195265e2),
    -GS_R (2.2113666853125306036270938577389199842e1),
    GS_R (7.733432668472263838960389880893706722),
    -GS_R (3.0674084731089398182061213627694050874e1),
    -GS_R (9.3321305264302278729567221703984904423),
    GS_R (1.5697238121770843886131091074860972666e1),
    -GS_R (3.1139403219565177677282850409550408241e1),
    -GS_R (9.3529243588444783865713862677002920114),
    GS_R (3.5816841486394083752465898543731419581e1) },
  { GS_R (1.9985053242002433820987653617543856929e1),
    -GS_R (3.8703730874935176555105901742118678709e2),
    -GS_R (1.8917813819516756882830838328016853598e2),
    GS_R (5.2780815920542364900561016685902094876e2),
    -GS_R (1.1573902539959630126141871134308364925e1),
    GS_R (6.8812326946963000169666922661290824953),
    -GS_R (1.0006050966910838403183860970810240069),
    GS_R (7.7771377980534432092869265732936785435e-1),
    -GS_R (2.7782057523535084065932004337486694044),
    -GS_R (6.0196695231264120758267380846103303412e1),
    GS_R (8.4320405506677161018159903784204679883e1),
    GS_R (1.1992291136182789328035130028368748898e1) },
  { -GS_R (2.5693933462703749003312586129344078647e1),
    -GS_R (1.5418974869023643374053993627104569092e2),
    -GS_R (2.315293791760454956753603910894595838e2),
    GS_R (3.5763911791061412378285349909925792968e2),
    GS_R (9.3405324183624310003907691703634672325e1),
    -GS_R (3.7458323136451633156875139351368782361e1),
    GS_R (1.0409964950896230045147246184439732151e2),
    GS_R (2.9840293426660503123344363578679209881e1),
    -GS_R (4.3533456590011143754432175058249915266e1),
    GS_R (9.6324553959188282948394950600425855209e1),
    -GS_R (3.9177261675615439165231486171539053858e1),
    -GS_R (1.4972683625798562581422125275538788376e2) }
};

/* the sum of a[j] times the columns of f */
static void
sum (int nx, int n, const int *columns, const gs_real *a, const gs_real *f, gs_real *z)
{
  const gs_real *from[8];
  for (int j = 0; j < n; j++)
    from[j] = f + nx * columns[j];
  gs_sum (nx, n, a, from, z);
}

/* the four highest coefficients, to the columns of f from `to` on, which are among those that they
 * are made of: eight states at a time */
static void
coefficients (int nx, gs_real *f, int to)
{
  gs_real r[4][8];
  for (int first = 0; first < nx; first += 8)
    {
      const int many = gs_least (8, nx - first);
      const gs_real *from[12];
      for (int j = 0; j < 12; j++)
        from[j] = f + first + nx * column[j];
      for (int k = 0; k < 4; k++)
        gs_sum (many, 12, d[k], from, r[k]);
      for (int k = 0; k < 4; k++)
        gs_copy (many, r[k], f + first + nx * (to + k));
    }
}

int
gs_dense_dp853 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h, const gs_real *x,
                gs_real *xn, gs_real *f, gs_real *z)
{
  int info = gs_rates_at (g, tn, side, xn, f + g->nx);
  return info == 0 ? gs_dense_coefficients (g, t, h, x, f, 5, z) : info;
}

int
gs_dense_coefficients (const gs_system *g, gs_real t, gs_real h, const gs_real *x, gs_real *f,
                       int to, gs_real *z)
{
  const int nx = g->nx;
  int info = 0;
  for (int k = 0; k < 3 && info == 0; k++)
    {
      sum (nx, 8, stage[k].column, stage[k].a, f, z);
      for (int i = 0; i < nx; i++)
        z[i] = x[i] + h * z[i];
      info = gs_rates_at (g, t + stage[k].c * h, 1, z, f + nx * (2 + k));
    }
  if (info == 0)
    coefficients (nx, f, to);
  return info;
}

void
gs_dense_at (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xn, const gs_real *f,
             gs_real *z)
{
  gs_dense_from_rates (nx, h, b, x, f, xn, f + nx, f + 5 * nx, z);
}

void
gs_dense_from_rates (int nx, gs_real h, gs_real b, const gs_real *x, const gs_real *xd,
                     const gs_real *xn, const gs_real *xdn, const gs_real *c, gs_real *z)
{
  for (int i = 0; i < nx; i++, c++)
    {
      const gs_real move = xn[i] - x[i], r3 = h * xd[i] - move, r4 = move - h * xdn[i] - r3;
      gs_real r = h * (c[0] + b * (c[nx] + (1 - b) * (c[2 * nx] + b * c[3 * nx])));
      r = r3 + b * (r4 + (1 - b) * r);
      z[i] = b < 1 ? x[i] + b * (move + (1 - b) * r) : xn[i];
    }
}

gs_real
gs_dense_error (const gs_system *g, gs_real h, const gs_real *x, const gs_real *xn,
                const gs_real *f, const gs_real *z, gs_real *w)
{
  gs_dense_at (g->nx, h, GS_R (7.0) / 9, x, xn, f, w);
  return gs_dense_error_there (g, x, xn, z, w);
}

gs_real
gs_dense_error_there (const gs_system *g, const gs_real *x, const gs_real *xn, const gs_real *z,
                      const gs_real *w)
{
  const int nu = g->s->nu, top = g->s->nq + nu;
  const gs_real *counts
      = g->p[GS_WAY] > 0 && g->p[GS_DEPENDENT] < (gs_real)nu ? g->p + GS_PARTS + nu : 0;
  gs_real e = 0;
  int n = 0;
  for (int i = 0; i < g->nx; i++)
    {
      const gs_real size = g->atol[i] + g->ropt[1] * gs_max (gs_abs (x[i]), gs_abs (xn[i])),
                   off = (w[i] - z[i]) / size;
      if ((counts && i < top && counts[i] <= 0) || ! (size > 0))
        continue;
      e += off * off;
      n++;
    }
  return GS_R (0.3) * gs_sqrt (e / (gs_real)gs_most (1, n));
}
