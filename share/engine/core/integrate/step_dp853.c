/* gs_step_dp853: one trial step of the Runge-Kutta method of Dormand and Prince of order 8 with its
 * error estimate of orders 5 and 3.
 *
 * Twelve stages, the first given. With e5 and e3 the differences to the embedded formulae of order
 * 5 and 3, each scaled by the tolerance, err = h*e5**2/sqrt(e5**2 + 0.01*e3**2); states that are
 * completed from others do not count; 1e307 if a number of xn is not finite.
 * The coefficients are those of share/fortran: the published ones, carried on to 38 digits from
 * the order conditions.
 *
 * Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.5 (method) and
 * II.10 (error estimate). */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"

/* the stages 2 to 12: at t + c*h (the last one at tn); a: the factors of stage 1 and of those from
 * the stage `from` on, counted from 0 */
static const struct
{
  gs_real c;
  int from;
  gs_real a[9];
} stage[11] = {
  { GS_R (5.2600151958767731878558754448801609008e-2), 1,
    { GS_R (5.2600151958767731878558754448801609008e-2) } },
  { GS_R (7.8900227938151597817838131673202413512e-2), 1,
    { GS_R (1.9725056984537899454459532918300603378e-2),
      GS_R (5.9175170953613698363378598754901810134e-2) } },
  { GS_R (1.1835034190722739672675719750980362027e-1), 2,
    { GS_R (2.9587585476806849181689299377450905067e-2),
      GS_R (8.8762756430420547545067898132352715201e-2) } },
  { GS_R (2.8164965809277260327324280249019637973e-1), 2,
    { GS_R (2.4136513415926668550236979866451012631e-1),
      -GS_R (8.8454947932828608534486496271706060422e-1),
      GS_R (9.2483400326179200311573796654274685764e-1) } },
  { GS_R (3.3333333333333333333333333333333333333e-1), 3,
    { GS_R (3.7037037037037037037037037037037037037e-2),
      GS_R (1.7082860872947387127960448217320269807e-1),
      GS_R (1.2546768756682242501669181412309359822e-1) } },
  { GS_R (2.5e-1), 3,
    { GS_R (3.7109375e-2),
      GS_R (1.7025221101954403931497806027171435744e-1),
      GS_R (6.0216538980455960685021939728285642563e-2),
      -GS_R (1.7578125e-2) } },
  { GS_R (3.0769230769230769230769230769230769231e-1), 3,
    { GS_R (3.7092000118504792710877931983635565443e-2),
      GS_R (1.7038392571223999381021405470448671109e-1),
      GS_R (1.0726203044637328465180919916779205528e-1),
      -GS_R (1.5319437748624401752793615823621775794e-2),
      GS_R (8.273789163814022887584737660015136294e-3) } },
  { GS_R (6.5128205128205128205128205128205128205e-1), 3,
    { GS_R (6.2411095871607571711442957781204574618e-1),
      -GS_R (3.3608926294469412940685710982459877531),
      -GS_R (8.6821934684172600681818989145257415931e-1),
      GS_R (2.7592099699446708304941560079685495462e1),
      GS_R (2.0154067550477893408618678897886364167e1),
      -GS_R (4.3489884181069958847736625514403292181e1) } },
  { GS_R (6.0e-1), 3,
    { GS_R (4.7766253643826436589043390852739152287e-1),
      -GS_R (2.4881146199716676419264258646823966931),
      -GS_R (5.9029082683684299637144647574313522176e-1),
      GS_R (2.1230051448181194234728894989704873027e1),
      GS_R (1.5279233632882423583259692293748442209e1),
      -GS_R (3.3288210968984862919445326558695882291e1),
      -GS_R (2.0331201708508626135822292859292552846e-2) } },
  { GS_R (8.5714285714285714285714285714285714286e-1), 3,
    { -GS_R (9.3714243008598732571704021658041552814e-1),
      GS_R (5.1863724288440637083002385320895363761),
      GS_R (1.0914373489967295781850025465390492309),
      -GS_R (8.1497870107469261251399726735690918797),
      -GS_R (1.8520065659996959864156618070114775078e1),
      GS_R (2.2739487099350504281897005673359727308e1),
      GS_R (2.4936055526796523898708939676188817179),
      -GS_R (3.046764471898219500382366902200055004) } },
  { 1, 3,
    { GS_R (2.2733101475165382079235976844938774245),
      -GS_R (1.0534495466737250198406668987892857914e1),
      -GS_R (2.0008720582248624990967571844381719685),
      -GS_R (1.7958931863118798917276595053361827338e1),
      GS_R (2.7948884529419960050849980883715913462e1),
      -GS_R (2.858998277135023694740655086735730542),
      -GS_R (8.8728569335306295443354928925846447156),
      GS_R (1.2360567175794303064726620152757372915e1),
      GS_R (6.4339274601576353035597048404606867587e-1) } }
};

/* the factors of stage 1 and of the stages 6 to 12: the result, and the error of order 5 */
static const gs_real b[8] = { GS_R (5.4293734116568762238053576636253801608e-2),
                              GS_R (4.4503128927524088814411395056556346879),
                              GS_R (1.8915178993145003830428159904359329816),
                              -GS_R (5.8012039600105847814672114226971519456),
                              GS_R (3.1116436695781989440891606236975861761e-1),
                              -GS_R (1.5216094966251607855617880680537322141e-1),
                              GS_R (2.0136540080403034837477653750070189956e-1),
                              GS_R (4.4710615727772590517688556904243178753e-2) };
static const gs_real e[8] = { GS_R (1.3120044994194880732501029953801793085e-2),
                              -GS_R (1.2251564463762044407205697528543837147),
                              -GS_R (4.9575894965725019152140799505384812683e-1),
                              GS_R (1.6643771824549865369615304151480492819),
                              -GS_R (3.503288487499736816886487289838649404e-1),
                              GS_R (3.3417911871301747902973188414208476014e-1),
                              GS_R (8.1923206485115712465707426085956994164e-2),
                              -GS_R (2.2355307863886295258844278437796047352e-2) };

/* the factors of the stages 1, 9 and 12 in the embedded formula of order 3 */
static const gs_real g1 = GS_R (2.4409448818897637795275590551181102362e-1);
static const gs_real g9 = GS_R (7.3384668828161185734136174154701250579e-1);
static const gs_real g12 = GS_R (2.2058823529411764705882352941176470588e-2);

void
gs_dp853_table (gs_real *aa, gs_real *bb, gs_real *cc)
{
  for (int k = 1; k < 12; k++)
    {
      const int from = stage[k - 1].from;
      aa[k] = stage[k - 1].a[0];
      for (int j = from; j < k; j++)
        aa[k + 12 * j] = stage[k - 1].a[1 + j - from];
      if (k < 11)
        cc[k] = stage[k - 1].c;
    }
  bb[0] = b[0];
  for (int k = 5; k < 12; k++)
    bb[k] = b[k - 4];
}

/* each number of terms has a loop of its own: a third of the instructions of a loop over terms */
#define SUM_1 a[0] * f[0][i]
#define SUM_2 SUM_1 + a[1] * f[1][i]
#define SUM_3 SUM_2 + a[2] * f[2][i]
#define SUM_4 SUM_3 + a[3] * f[3][i]
#define SUM_5 SUM_4 + a[4] * f[4][i]
#define SUM_6 SUM_5 + a[5] * f[5][i]
#define SUM_7 SUM_6 + a[6] * f[6][i]
#define SUM_8 SUM_7 + a[7] * f[7][i]
#define SUM_9 SUM_8 + a[8] * f[8][i]
#define SUM_12 SUM_9 + a[9] * f[9][i] + a[10] * f[10][i] + a[11] * f[11][i]
#define ROW(n)                                                                                     \
  case n:                                                                                          \
    for (int i = 0; i < nx; i++)                                                                   \
      z[i] = SUM_##n;                                                                              \
    break;

void
gs_sum (int nx, int n, const gs_real *a, const gs_real *const *f, gs_real *restrict z)
{
  switch (n)
    {
      ROW (1)
      ROW (2)
      ROW (3)
      ROW (4)
      ROW (5)
      ROW (6)
      ROW (7)
      ROW (8)
      ROW (9)
      ROW (12)
    }
}

/* n numbers of the sum of a[0]*stage 1 and a[1], ... times the stages from .. to - 1 */
static void
sum (int n, int nx, const gs_real *a, const gs_real *w, int from, int to, gs_real *z)
{
  const gs_real *f[9] = { w };
  for (int j = from; j < to; j++)
    f[1 + j - from] = w + nx * j;
  gs_sum (n, 1 + to - from, a, f, z);
}

/* stage k, from 1: its state z */
static void
begin_stage (int nx, int k, gs_real h, const gs_real *x, const gs_real *w, gs_real *restrict z)
{
  sum (nx, nx, stage[k - 1].a, w, stage[k - 1].from, k, z);
  for (int i = 0; i < nx; i++)
    z[i] = x[i] + h * z[i];
}

enum { PIECE = 32 }; /* numbers of the error that are summed at a time */

int
gs_step_dp853 (const gs_system *g, gs_real t, gs_real tn, int side, gs_real h, const gs_real *x,
               gs_real *xn, gs_real *err, gs_real *w)
{
  const int nx = g->nx, nq = g->s->nq, nu = g->s->nu;
  gs_real *z = w + 12 * nx;
  *err = 0;
  for (int k = 1; k < 12; k++)
    {
      begin_stage (nx, k, h, x, w, z);
      int info = k < 11 ? gs_rates_at (g, t + stage[k - 1].c * h, 1, z, w + nx * k)
                        : gs_rates_at (g, tn, side, z, w + nx * k);
      if (info != 0)
        return info;
    }

  const gs_real *counts
      = g->p[GS_WAY] > 0 && g->p[GS_DEPENDENT] < (gs_real)nu ? g->p + GS_PARTS + nu : 0;
  gs_real e5 = 0, e3 = 0, to5[PIECE]; /* all stages stay, for gs_step_back_dp853 */
  int n = nx;
  sum (nx, nx, b, w, 5, 12, xn);
  for (int i = 0; i < nx; i++)
    {
      if (i % PIECE == 0)
        sum (gs_least (PIECE, nx - i), nx, e, w + i, 5, 12, to5);
      gs_real d5 = to5[i % PIECE]; /* the differences to the formulae of order 5 and 3 */
      gs_real d3 = xn[i] - g1 * w[i] - g9 * w[i + 8 * nx] - g12 * w[i + 11 * nx];
      xn[i] = x[i] + h * xn[i];
      if (counts && i < nq + nu && counts[i] <= 0)
        {
          n--;
          d3 = 0;
          d5 = 0;
        }
      gs_real s = g->atol[i] + g->ropt[1] * gs_max (gs_abs (x[i]), gs_abs (xn[i]));
      if (s > 0)
        {
          e3 += (d3 / s) * (d3 / s);
          e5 += (d5 / s) * (d5 / s);
        }
      else if (gs_abs (d5) > 0)
        e5 = GS_HUGE;
    }
  gs_real s = e5 + GS_R (0.01) * e3;
  if (! (s > 0))
    s = 1;
  *err = gs_not_finite (nx, xn) != 0 ? GS_R2 (1e307, 3e38)
                                     : gs_abs (h) * e5 / gs_sqrt ((gs_real)gs_most (1, n) * s);
  return 0;
}
