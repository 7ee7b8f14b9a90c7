#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <string.h>

/* entry i of R x, R (3,3) */
static gs_real
turned (const gs_real *r, int i, const gs_real *x)
{
  return r[i] * x[0] + r[i + 3] * x[1] + r[i + 6] * x[2];
}

/* neighbour l of an arm: axes kb, points pb */
static void
neighbour (int l, const gs_real *ka, const gs_real *pc, gs_real *kb, gs_real *pb)
{
  for (int j = 1; j <= 6; j++, ka += 3, pc += 3, kb += 3, pb += 3)
    {
      for (int i = 1; i <= 3; i++)
        {
          kb[i - 1] = ka[i - 1] + GS_R (3e-6) * (gs_real)l * gs_sin ((gs_real)(7 * i + 3 * j * l));
          pb[i - 1] = pc[i - 1] + GS_R (3e-6) * (gs_real)l * gs_cos ((gs_real)(5 * i + 4 * j * l));
        }
      gs_real size = gs_sqrt (kb[0] * kb[0] + kb[1] * kb[1] + kb[2] * kb[2]);
      for (int i = 0; i < 3; i++)
        kb[i] = kb[i] / size;
    }
}

/* the points pc of the arm about their middle cen, by their size, which is returned */
static gs_real
middle (const gs_real *pa, gs_real *pc, gs_real *cen)
{
  gs_real size = 0;
  for (int i = 0; i < 3; i++)
    {
      cen[i] = 0;
      for (int j = 0; j < 6; j++)
        cen[i] = cen[i] + pa[i + 3 * j] / 6;
    }
  for (int j = 0; j < 18; j++)
    {
      pc[j] = pa[j] - cen[j % 3];
      size = gs_max (size, gs_abs (pc[j]));
    }
  return size;
}

/* all orders of the joints until two are regular, or one was; else four neighbours of this arm,
 * whose lengths beside their largest are pc */
static void
candidates (const gs_real *ka, const gs_real *pc, const gs_real *r, const gs_real *p2, gs_real *qc,
            int *ns, gs_real *w, int *iw)
{
  gs_real kb[18], pb[18];
  int regular = 0;
  memcpy (kb, ka, sizeof kb);
  memcpy (pb, pc, sizeof pb);
  for (int l = 0; l < 6; l++)
    {
      if (l > 0)
        gs_arm_last_to_front (r, p2, kb, pb);
      gs_arm_both_ways (kb, pb, r, p2, ka, pc, l, qc, ns, &regular, w, iw);
      if (regular >= 2)
        return;
    }
  if (regular > 0)
    return;
  for (int l = 1; l <= 4; l++)
    {
      neighbour (l, ka, pc, kb, pb);
      gs_arm_both_ways (kb, pb, r, p2, ka, pc, 0, qc, ns, &regular, w, iw);
    }
}

/* The line of axis 6, told by point p and direction l, gives fifteen numbers (p, l, p.p, p.l,
 * p x l, (p.p)l - 2(p.l)p, 1) that every displacement changes linearly; fourteen equations between
 * those moved by joints 3 to 5 and those moved back by joints 2 and 1. The angles 1 and 2 are
 * eliminated linearly, six equations are left, and as many times the half tangent of angle 4: the
 * half tangent of angle 3 is an eigenvalue of a matrix of order 24. That, and the same of the chain
 * backwards. Axes that are parallel can make this singular everywhere: then the same with the last
 * axes carried by the pose to the front of the chain, until two orders of the joints are regular;
 * where none is, the same of four arms very close to this one. Every candidate is refined by
 * Newton's method on the pose and taken if it misses less than 1e-11 of it; close to singular
 * positions others are looked for as gs_reach_refine does.
 *
 * M. Raghavan, B. Roth, J. Mech. Design 115 (1993), 502-508. D. Manocha, J. Canny, IEEE Trans.
 * Robotics Automation 10 (1994), 648-657. */
int
gs_arm_angles (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
               gs_real *qc, int *ns, gs_real *w, int *iw)
{
  gs_real pc[18], p2[3], cen[3], size = middle (pa, pc, cen);
  *ns = 0;
  if (! (size > 0))
    return 0;
  for (int i = 0; i < 3; i++)
    p2[i] = (p[i] + r[i] * cen[0] + r[i + 3] * cen[1] + r[i + 6] * cen[2] - cen[i]) / size;
  for (int j = 0; j < 18; j++)
    pc[j] = pc[j] / size;
  candidates (ka, pc, r, p2, qc, ns, w, iw);
  return gs_arm_complete (ka, pc, r, p2, qc, ns);
}

/* as gs_reach_refine, from the solutions where the least singular value of the Jacobian is below
 * 1e-4 of the largest */
int
gs_arm_complete (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                 gs_real *qc, int *ns)
{
  const int kind[] = { 1, 1, 1, 1, 1, 1 };
  gs_real q[96], z[6], qw[2400], s;
  int br[16] = { 0 }, m = 0, nw = 0;
  for (int k = 0; k < *ns; k++)
    {
      gs_reach_least_move (6, kind, ka, pa, r, p, qc + 6 * k, z, &s);
      m += s <= GS_R (1e-4);
      gs_copy (6, qc + 6 * k, q + 6 * k);
      br[k] = k + 1;
    }
  if (m == 0)
    return 0;
  gs_reach_refine_all (6, kind, ka, pa, r, p, 16, q, ns, br);
  m = *ns;
  for (int k = 0; k < m; k++)
    {
      gs_reach_least_move (6, kind, ka, pa, r, p, q + 6 * k, z, &s);
      if (! (s <= GS_R (1e-4)))
        continue;
      gs_copy (6, q + 6 * k, qc);
      gs_reach_beside_singular (6, kind, ka, pa, r, p, qc, z, 16, q, ns, br, 0);
      gs_reach_curve (kind, ka, pa, r, p, qc, 16, q, ns, br, 0, &nw, qw);
    }
  int info = gs_arm_doubles (ka, pa, r, p, q, ns);
  m = *ns;
  *ns = 0;
  for (int k = 0; k < m; k++)
    gs_arm_add (q + 6 * k, qc, ns);
  return info;
}

void
gs_arm_last_to_front (const gs_real *r, const gs_real *p, gs_real *ka, gs_real *pa)
{
  gs_real k[3], x[3];
  for (int i = 0; i < 3; i++)
    {
      k[i] = turned (r, i, ka + 15);
      x[i] = turned (r, i, pa + 15) + p[i];
    }
  gs_move (15, ka, ka + 3);
  gs_move (15, pa, pa + 3);
  memcpy (ka, k, sizeof k);
  memcpy (pa, x, sizeof x);
}

void
gs_arm_both_ways (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                  const gs_real *k0, const gs_real *p0, int l0, gs_real *qc, int *ns, int *regular,
                  gs_real *w, int *iw)
{
  gs_real kb[18], pb[18], rb[9], d[3];
  *regular += gs_arm_one_order (ka, pa, r, p, k0, p0, r, p, 1, l0, qc, ns, w, iw) == 0;
  for (int j = 0; j < 6; j++)
    {
      gs_copy (3, ka + 3 * (5 - j), kb + 3 * j);
      gs_copy (3, pa + 3 * (5 - j), pb + 3 * j);
    }
  for (int i = 0; i < 3; i++)
    for (int l = 0; l < 3; l++)
      rb[i + 3 * l] = r[l + 3 * i];
  for (int i = 0; i < 3; i++)
    d[i] = -turned (rb, i, p);
  *regular += gs_arm_one_order (kb, pb, rb, d, k0, p0, r, p, -1, l0, qc, ns, w, iw) == 0;
}

int
gs_arm_one_order (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                  const gs_real *k0, const gs_real *p0, const gs_real *r0, const gs_real *d0,
                  int way, int l0, gs_real *qc, int *ns, gs_real *w, int *iw)
{
  static const int kind[] = { 1, 1, 1, 1, 1, 1 };
  gs_real q[6], q0[6], f[14 * 27], g[14 * 9], h[6 * 9 * 3], shift, er[24], ei[24];
  int good, info;
  gs_arm_left_lines (ka, pa, f);
  gs_arm_right_lines (ka, pa, r, p, g);
  gs_arm_equations (f, g, h, w);
  info = gs_arm_matrix (h, &shift, w, w + 576, w + 720, iw);
  if (info == 1 || gs_eigenvalues (24, w, 24, er, ei, w + 576))
    return 1;
  for (int i = 0; i < 24; i++)
    {
      if (! (gs_abs (ei[i]) <= GS_R (1e-3) * (1 + gs_abs (er[i]))))
        continue;
      q[2] = shift + 2 * gs_atan (er[i]);
      gs_arm_candidate (ka, pa, r, f, g, h, q, w);
      for (int j = 0; j < 3 && way < 0; j++)
        {
          gs_real t = q[j];
          q[j] = -q[5 - j];
          q[5 - j] = -t;
        }
      for (int j = 0; j < 6; j++)
        q0[(j + 6 - l0) % 6] = q[j];
      gs_arm_refine (6, kind, k0, p0, r0, d0, q0, w, iw, &good);
      if (good)
        gs_arm_add (q0, qc, ns);
    }
  return info;
}

/* x turned about the axis k through the origin */
static void
rodrigues (const gs_real *k, gs_real s, gs_real c, gs_real *x)
{
  gs_real d = k[0] * x[0] + k[1] * x[1] + k[2] * x[2], u[3];
  u[0] = k[1] * x[2] - k[2] * x[1];
  u[1] = k[2] * x[0] - k[0] * x[2];
  u[2] = k[0] * x[1] - k[1] * x[0];
  for (int i = 0; i < 3; i++)
    x[i] = c * x[i] + s * u[i] + (1 - c) * d * k[i];
}

void
gs_turn_line (const gs_real *k, const gs_real *p, gs_real s, gs_real c, gs_real *x, gs_real *e)
{
  gs_real y[3], u[3];
  rodrigues (k, s, c, e);
  for (int i = 0; i < 3; i++)
    y[i] = x[i] - p[i];
  gs_real d = k[0] * y[0] + k[1] * y[1] + k[2] * y[2];
  u[0] = k[1] * y[2] - k[2] * y[1];
  u[1] = k[2] * y[0] - k[0] * y[2];
  u[2] = k[0] * y[1] - k[1] * y[0];
  for (int i = 0; i < 3; i++)
    x[i] = p[i] + c * y[i] + s * u[i] + (1 - c) * d * k[i];
}

void
gs_line_numbers (const gs_real *x, const gs_real *e, gs_real *v)
{
  v[6] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  v[7] = x[0] * e[0] + x[1] * e[1] + x[2] * e[2];
  v[8] = x[1] * e[2] - x[2] * e[1];
  v[9] = x[2] * e[0] - x[0] * e[2];
  v[10] = x[0] * e[1] - x[1] * e[0];
  for (int i = 0; i < 3; i++)
    {
      v[i] = x[i];
      v[3 + i] = e[i];
      v[11 + i] = v[6] * e[i] - 2 * v[7] * x[i];
    }
}

void
gs_fourier_coefficients (int m, int n, int l, gs_real *f)
{
  const int k = m * n;
  for (int j = 0; j < l; j++, f += 3 * k)
    for (int i = 0; i < k; i++)
      {
        gs_real a = f[i], b = f[i + 2 * k];
        f[i + 2 * k] = GS_R (0.5) * (a + b);
        f[i] = GS_R (0.5) * (a - b);
        f[i + k] = f[i + k] - f[i + 2 * k];
      }
}

/* sine and cosine of 0, 90 and 180 degrees */
static const gs_real sine[] = { 0, 1, 0 }, cosine[] = { 1, 0, -1 };

void
gs_arm_left_lines (const gs_real *ka, const gs_real *pa, gs_real *f)
{
  gs_real x[3], e[3];
  for (int n = 0; n < 27; n++)
    {
      const int i = n / 9, j = n / 3 % 3, k = n % 3;
      memcpy (x, pa + 15, sizeof x);
      memcpy (e, ka + 15, sizeof e);
      gs_turn_line (ka + 12, pa + 12, sine[k], cosine[k], x, e);
      gs_turn_line (ka + 9, pa + 9, sine[j], cosine[j], x, e);
      gs_turn_line (ka + 6, pa + 6, sine[i], cosine[i], x, e);
      gs_line_numbers (x, e, f + 14 * n);
    }
  gs_fourier_coefficients (14, 1, 9, f);
  gs_fourier_coefficients (14, 3, 3, f);
  gs_fourier_coefficients (14, 9, 1, f);
}

void
gs_arm_right_lines (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                    gs_real *g)
{
  static const gs_real back[] = { 0, -1, 0 };
  gs_real x[3], e[3];
  for (int n = 0; n < 9; n++)
    {
      const int i = n / 3, j = n % 3;
      for (int l = 0; l < 3; l++)
        {
          e[l] = turned (r, l, ka + 15);
          x[l] = turned (r, l, pa + 15) + p[l];
        }
      gs_turn_line (ka, pa, back[i], cosine[i], x, e);
      gs_turn_line (ka + 3, pa + 3, back[j], cosine[j], x, e);
      gs_line_numbers (x, e, g + 14 * n);
    }
  gs_fourier_coefficients (14, 1, 3, g);
  gs_fourier_coefficients (14, 3, 1, g);
}

/* combinations of the equations in which angles 1 and 2 have no part, by the singular vectors of
 * their coefficients */
void
gs_arm_equations (const gs_real *f, const gs_real *g, gs_real *h, gs_real *w)
{
  gs_real s[14], v[14 * 14], b[6 * 9];
  int rank;
  gs_transpose (8, 14, g, 14, w);
  gs_singular_values (8, 14, w, 8, v, 14, s, GS_R (1e-14), &rank);
  for (int k = 0; k < 3; k++)
    {
      for (int i = 0; i < 6; i++)
        for (int j = 0; j < 9; j++)
          {
            gs_real a = 0;
            for (int l = 0; l < 14; l++)
              {
                gs_real z = f[l + 14 * (j + 9 * k)];
                if (k == 2 && j == 8)
                  z = z - g[l + 14 * 8];
                a = a + v[l + 14 * (8 + i)] * z;
              }
            b[i + 6 * j] = a;
          }
      for (int i = 1; i <= 6; i++)
        gs_arm_half_tangents (b, i, h + 54 * k);
    }
}

void
gs_arm_half_tangents (const gs_real *b, int i, gs_real *h)
{
  gs_real t[9];
  b += i - 1;
  h += i - 1;
  for (int k = 0; k < 3; k++)
    {
      t[3 * k] = b[6 * (2 + 3 * k)] + b[6 * (3 * k)];
      t[1 + 3 * k] = 2 * b[6 * (1 + 3 * k)];
      t[2 + 3 * k] = b[6 * (2 + 3 * k)] - b[6 * (3 * k)];
    }
  for (int j = 0; j < 3; j++)
    {
      h[6 * j] = t[j + 6] + t[j];
      h[6 * (3 + j)] = 2 * t[j + 3];
      h[6 * (6 + j)] = t[j + 6] - t[j];
    }
}

/* a (24,24): the companion matrix of x (12,24) */
static void
companion (const gs_real *x, gs_real *a)
{
  for (int j = 0; j < 24; j++)
    for (int i = 0; i < 12; i++)
      {
        a[i + 24 * j] = j == 12 + i ? 1 : 0;
        a[12 + i + 24 * j] = -x[i + 12 * j];
      }
}

/* of eight places to begin the one with the smallest matrix */
int
gs_arm_matrix (const gs_real *h, gs_real *shift, gs_real *a, gs_real *s2, gs_real *x, int *iw)
{
  gs_real least = -1;
  int info = 1;
  for (int k = 1; k <= 8; k++)
    {
      gs_real th = GS_R (0.37) + GS_R (0.785398) * (gs_real)k, big = 0;
      gs_real c = gs_cos (th), s = gs_sin (th);
      gs_arm_twelve (h, -c, -s, 1, s2);
      gs_arm_twelve (h, c, s, 1, x);
      gs_arm_twelve (h, -2 * s, 2 * c, 0, x + 144);
      if (gs_solve_general (12, 24, s2, 12, x, 12, iw) != 0)
        continue;
      for (int i = 0; i < 288; i++)
        big = gs_max (big, gs_abs (x[i]));
      if (! (big <= GS_R2 (1e200, 1e30) && (least < 0 || big < least)))
        continue;
      least = big;
      *shift = th;
      info = 0;
      companion (x, a);
    }
  return least > GS_R (1e4) ? 2 : info;
}

void
gs_arm_twelve (const gs_real *h, gs_real a, gs_real b, gs_real c, gs_real *s)
{
  for (int i = 0; i < 6; i++)
    {
      for (int j = 0; j < 12; j++)
        s[i + 12 * j] = s[6 + i + 12 * j] = 0;
      for (int j = 0; j < 9; j++)
        s[i + 12 * j] = s[6 + i + 12 * (3 + j)]
            = a * h[i + 6 * j] + b * h[i + 6 * j + 54] + c * h[i + 6 * j + 108];
    }
}

/* the factor of term k (0 cosine, 1 sine, 2 one) */
static gs_real
times (gs_real m, int k, gs_real q)
{
  return k == 0 ? m * gs_cos (q) : k == 1 ? m * gs_sin (q) : m;
}

/* the right side b (14) of the equations for angles 1 and 2 */
static void
right_side (const gs_real *f, const gs_real *g, const gs_real *q, gs_real *b)
{
  for (int l = 0; l < 14; l++)
    {
      b[l] = -g[l + 14 * 8];
      for (int n = 0; n < 27; n++)
        {
          gs_real m = times (f[l + 14 * n], n % 3, q[4]);
          m = times (m, n / 3 % 3, q[3]);
          b[l] = b[l] + times (m, n / 9, q[2]);
        }
    }
}

/* angle 6: a direction u across its axis becomes e */
static gs_real
last_angle (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *q)
{
  gs_real u[3], e[3], x[3] = { 0 };
  const gs_real *k6 = ka + 15;
  int k = gs_abs (k6[1]) < gs_abs (k6[0]) ? 1 : 0;
  if (gs_abs (k6[2]) < gs_abs (k6[k]))
    k = 2;
  for (int i = 0; i < 3; i++)
    {
      u[i] = -k6[k] * k6[i];
      if (i == k)
        u[i] = u[i] + 1;
    }
  for (int i = 0; i < 3; i++)
    e[i] = turned (r, i, u);
  for (int i = 0; i < 5; i++)
    gs_turn_line (ka + 3 * i, pa + 3 * i, -gs_sin (q[i]), gs_cos (q[i]), x, e);
  return gs_atan2 (k6[0] * (u[1] * e[2] - u[2] * e[1]) + k6[1] * (u[2] * e[0] - u[0] * e[2])
                    + k6[2] * (u[0] * e[1] - u[1] * e[0]),
                u[0] * e[0] + u[1] * e[1] + u[2] * e[2]);
}

/* angles 4 and 5 from the vector that the twelve equations take to nothing, 1 and 2 by least
 * squares, 6 from the rotation */
void
gs_arm_candidate (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *f,
                  const gs_real *g, const gs_real *h, gs_real *q, gs_real *w)
{
  gs_real s[14], b[14], y[8] = { 0 };
  int rank;
  gs_arm_twelve (h, gs_cos (q[2]), gs_sin (q[2]), 1, w);
  gs_singular_values (12, 12, w, 12, w + 144, 12, s, GS_R (1e-14), &rank);
  gs_arm_two_angles (w + 144 + 132, q + 3, q + 4);
  right_side (f, g, q, b);
  gs_copy (14 * 8, g, w);
  gs_singular_values (14, 8, w, 14, w + 112, 8, s, GS_R (1e-12), &rank);
  for (int k = 0; k < rank; k++)
    {
      gs_real m = gs_dot (14, 0, w + 14 * k, b) / gs_square (s[k]);
      for (int j = 0; j < 8; j++)
        y[j] = y[j] + m * w[112 + 8 * k + j];
    }
  q[0] = gs_atan2 (y[5], y[2]);
  q[1] = gs_atan2 (y[7], y[6]);
  q[5] = last_angle (ka, pa, r, q);
}

/* the angle of the largest of pairs of entries, d apart, of v (3,4): ni rows, nj columns */
static gs_real
ratio (const gs_real *v, int ni, int nj, int d)
{
  gs_real big = -1, q = 0;
  for (int j = 0; j < nj; j++)
    for (int i = 0; i < ni; i++)
      {
        gs_real a = v[i + 3 * j], b = v[i + 3 * j + d], s = a * a + b * b;
        if (s > big)
          {
            big = s;
            q = 2 * gs_atan2 (b, a);
          }
      }
  return q;
}

void
gs_arm_two_angles (const gs_real *v, gs_real *q4, gs_real *q5)
{
  *q4 = ratio (v, 3, 3, 3);
  *q5 = ratio (v, 2, 4, 1);
}

/* linear equations; of fewer than six joints the normal equations of least squares */
int
gs_arm_refine_step (int n, gs_real *w, int *iw)
{
  gs_real a[36], s[6] = { 0 };
  if (n == 6)
    return gs_solve_general (6, 1, w, 6, w + 36, 6, iw);
  for (int i = 0; i < n; i++)
    {
      for (int k = 0; k < n; k++)
        a[k + 6 * i] = gs_dot (6, 0, w + 6 * k, w + 6 * i);
      s[i] = gs_dot (6, 0, w + 6 * i, w + 36);
    }
  int info = gs_solve_spd (n, 1, a, 6, s, 6);
  memcpy (w + 36, s, sizeof s);
  return info;
}

/* one step of Newton, none longer than 0.3, its length without that big; w as gs_arm_refine_step,
 * whose info it returns */
static int
newton (int n, gs_real *q, gs_real *w, int *iw, gs_real *big)
{
  gs_real *s = w + 36;
  int info = gs_arm_refine_step (n, w, iw);
  if (info != 0)
    return info;
  *big = 0;
  for (int i = 0; i < 6; i++)
    *big = gs_max (*big, gs_abs (s[i]));
  gs_real part = gs_min (1, GS_R (0.3) / gs_max (*big, GS_TINY));
  for (int i = 0; i < 6; i++)
    q[i] = q[i] + part * s[i];
  return 0;
}

/* two steps from best in all directions but the one in which the tool hardly moves; last: the
 * least that was missed */
static void
without_one (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
             const gs_real *p, gs_real *w, gs_real *best, gs_real *last)
{
  gs_real q[6], z[6] = { 0 }, u[6] = { 0 }, g, s, miss;
  memcpy (q, best, sizeof q);
  gs_reach_onto_curve (2, kind, ka, pa, r, p, q, z, u, &g, &s);
  gs_arm_missed (kind, ka, pa, r, p, q, w, w + 36, &miss);
  if (miss < *last)
    memcpy (best, q, sizeof q);
  *last = gs_min (*last, miss);
}

/* at most 40 steps on the exact Jacobian, or 44 where the last ones are close; the best position
 * counts. The end is where a step makes it no better, but not a long one between two solutions. */
void
gs_arm_refine (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
               const gs_real *p, gs_real *q, gs_real *w, int *iw, int *good)
{
  gs_real miss, last = -1, big = 0, best[6];
  for (int it = 0; it < 44; it++)
    {
      gs_arm_missed (kind, ka, pa, r, p, q, w, w + 36, &miss);
      if (! (miss <= GS_R (1e10)))
        break;
      if (last < 0 || miss < last)
        {
          last = miss;
          memcpy (best, q, sizeof best);
          if (miss <= GS_R (2e-16))
            break;
        }
      else if (last <= GS_R (2e-15) || (last <= GS_R (1e-12) && big <= GS_R (1e-9)))
        break;
      if (it >= 39 && last > GS_R (1e-6))
        break;
      if (newton (n, q, w, iw, &big) != 0)
        break;
    }
  if (n == 6 && last > GS_R (2e-15) && last <= GS_R (1e-9))
    without_one (kind, ka, pa, r, p, w, best, &last);
  *good = last >= 0 && last <= GS_R (1e-11);
  for (int i = 0; i < 6 && *good; i++)
    q[i] = kind[i] == 1 ? gs_atan2 (gs_sin (best[i]), gs_cos (best[i])) : best[i];
}

/* axes and points moved from the first joint on: a, x are the rotation of the joints so far and
 * where the origin comes; j (6,6): points, then axes */
static void
moved (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *q, gs_real *a,
       gs_real *x, gs_real *j)
{
  for (int n = 0; n < 6; n++, j += 6)
    {
      gs_real *o = j, *k = j + 3, e[3] = { 0 };
      for (int i = 0; i < 3; i++)
        {
          k[i] = turned (a, i, ka + 3 * n);
          o[i] = turned (a, i, pa + 3 * n) + x[i];
        }
      if (kind[n] != 1)
        {
          for (int i = 0; i < 3; i++)
            x[i] = x[i] + q[n] * k[i];
          continue;
        }
      gs_real s = gs_sin (q[n]), c = gs_cos (q[n]);
      gs_turn_line (k, o, s, c, x, a);
      gs_turn_line (k, o, s, c, e, a + 3);
      gs_turn_line (k, o, s, c, e, a + 6);
    }
}

/* the place alone is asked for: joints 4 to 6 are none, with unit rows in the place of those of the
 * rotation */
static void
place_alone (const gs_real *q, gs_real *rj, gs_real *e)
{
  for (int j = 0; j < 3; j++)
    {
      for (int i = 3; i < 6; i++)
        rj[i + 6 * j] = 0;
      rj[(3 + j) * 7] = 1;
      e[3 + j] = -q[3 + j];
    }
}

void
gs_arm_missed (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
               const gs_real *p, const gs_real *q, gs_real *rj, gs_real *e, gs_real *miss)
{
  gs_real a[9] = { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, x[3] = { 0 }, o[3], k[3];
  moved (kind, ka, pa, q, a, x, rj);
  for (int n = 0; n < 6; n++)
    {
      gs_real *j = rj + 6 * n;
      for (int i = 0; i < 3; i++)
        {
          o[i] = x[i] - j[i];
          k[i] = j[3 + i];
          j[i] = k[i];
          j[3 + i] = kind[n] != 1 ? 0 : k[i];
        }
      if (kind[n] != 1)
        continue;
      j[0] = k[1] * o[2] - k[2] * o[1];
      j[1] = k[2] * o[0] - k[0] * o[2];
      j[2] = k[0] * o[1] - k[1] * o[0];
    }
  if (kind[3] == 2)
    place_alone (q, rj, e);
  else
    gs_rotation_vector (r, a, e + 3);
  *miss = 0;
  for (int i = 0; i < 3; i++)
    {
      e[i] = p[i] - x[i];
      *miss = gs_max (gs_max (*miss, gs_abs (e[i])), gs_abs (e[3 + i]));
    }
}

void
gs_arm_add (const gs_real *q, gs_real *qc, int *ns)
{
  for (int j = 0; j < *ns; j++)
    {
      gs_real d = 0;
      for (int i = 0; i < 6; i++)
        d = gs_max (d, gs_abs (gs_sin (GS_R (0.5) * (q[i] - qc[i + 6 * j]))));
      if (d <= GS_R (5e-9))
        return;
    }
  if (*ns >= 16)
    return;
  int k = *ns;
  for (; k >= 1 && qc[6 * (k - 1)] > q[0]; k--)
    gs_copy (6, qc + 6 * (k - 1), qc + 6 * k);
  gs_copy (6, q, qc + 6 * k);
  (*ns)++;
}
