#include "gsmbp/arith.h"
#include "gsmbp/reach.h"
#include "gsmbp/solve.h"

#include <string.h>

enum
{
  NEAR = 1,
  OUT = 2,
  FREE = 4,
  CLOSE = 8
};

/* NEAR: a radicand of a branch is close to 0, OUT: one is below, FREE: a coordinate is free, CLOSE:
 * a number that it depends on is very close to its limit */
static int
marks (int nm, const gs_real *rad, const gs_real *lim)
{
  int mark = 0;
  for (int i = 0; i < nm; i++)
    {
      if (lim[i] > GS_R (1e-20) && gs_abs (rad[i]) <= GS_R (1e7) * lim[i])
        mark |= NEAR;
      if (rad[i] <= GS_R (1e3) * lim[i])
        mark |= CLOSE;
      if (lim[i] <= GS_R (1e-20) && rad[i] <= lim[i])
        mark |= FREE;
      if (! (rad[i] >= -GS_R (1e7) * lim[i]))
        mark |= OUT;
    }
  return mark;
}

/* the n coordinates q, then 0 */
static void
six (int n, const gs_real *q, gs_real *x)
{
  gs_zero (6, x);
  gs_copy (n, q, x);
}

/* places as those of a point on the last axis: px (3,6), d (3) */
static void
about_last (int n, const gs_real *pa, const gs_real *r, const gs_real *p, gs_real *px, gs_real *d)
{
  const gs_real *o = pa + 3 * (n - 1);
  for (int i = 0; i < 3; i++)
    {
      d[i] = r[i] * o[0] + r[i + 3] * o[1] + r[i + 6] * o[2] - o[i] + p[i];
      for (int j = 0; j < 6; j++)
        px[i + 3 * j] = pa[i + 3 * j] - o[i];
    }
}

/* how far the solution of branch k (from 1) is from q; 1 if there is none */
static gs_real
away (int n, const int *kind, const gs_real *q, int k, const gs_real *qs, int ns, const int *br)
{
  gs_real h = 1;
  for (int j = 0; j < ns; j++)
    if (br[j] == k)
      h = gs_reach_difference (n, kind, q, qs + n * j);
  return h;
}

/* was no solution close to branch k (from 1) found, where it may have lost its digits? */
static int
is_unsure (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
           const gs_real *p, const gs_real *q, int k, const gs_real *qs, int ns, const int *br)
{
  gs_real h = away (n, kind, q, k, qs, ns, br), z[6], s;
  if (! (h > GS_R (1e-9) && n == 6))
    return 0;
  gs_reach_least_move (n, kind, ka, pa, r, p, q, z, &s);
  return s <= GS_R (1e-4) && h > gs_min (GS_R (1e-6), GS_R (1e-9) + GS_R (1e-14) / s);
}

/* Newton's method on the pose from every solution (gs_reach_refine_all), then from both sides of
 * every branch whose radicands are above -1e7 times lim and one of them close to 0
 * (gs_reach_beside_singular), but where none is within 1e3 times lim of it and the branch was
 * refined to a solution within 1e-9: nothing is left to find there. Where the Jacobian has almost
 * lost rank a branch may have lost its digits: where it was not refined to a solution close to it,
 * the curve on which the tool hardly moves is followed (gs_reach_curve); also near a branch that
 * has a radicand close to 0 and another one below. New solutions take the numbers of branches that
 * have none. */
int
gs_reach_refine (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                 const gs_real *p, int nb, int nm, const gs_real *qc, const gs_real *rad,
                 const gs_real *lim, gs_real *qs, int *ns, int *br, int info)
{
  gs_real z[6], q[6], e[6], qw[2400], s, px[18], d[3];
  int nw = 0;
  about_last (n, pa, r, p, px, d);
  gs_reach_refine_all (n, kind, ka, px, r, d, nb, qs, ns, br);
  for (int k = 0; k < nb; k++)
    {
      int mark = marks (nm, rad + nm * k, lim), walk = 0;
      six (n, qc + n * k, q);
      if ((mark & (NEAR | OUT | FREE)) == (NEAR | OUT) && n == 6)
        {
          gs_reach_closest_near (kind, ka, px, r, d, q, e, &s);
          walk = s <= GS_R (1e-8);
        }
      else if (! (mark & (OUT | FREE)))
        {
          if (mark & NEAR
              && (mark & CLOSE || ! (away (n, kind, q, k + 1, qs, *ns, br) <= GS_R (1e-9))))
            {
              gs_reach_least_move (n, kind, ka, px, r, d, q, z, &s);
              info = gs_reach_beside_singular (n, kind, ka, px, r, d, q, z, nb, qs, ns, br, info);
            }
          walk = is_unsure (n, kind, ka, px, r, d, q, k + 1, qs, *ns, br);
        }
      if (walk)
        info = gs_reach_curve (kind, ka, px, r, d, q, nb, qs, ns, br, info, &nw, qw);
    }
  return *ns == 0 ? 1 : gs_arm_singular (n, kind, ka, px, r, d, qs, *ns, info);
}

/* six joints, of which three are none, see gs_arm_missed; about the point */
int
gs_reach_refine_place (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                       const gs_real *p, const gs_real *x0, int nb, int nm, const gs_real *qc,
                       const gs_real *rad, const gs_real *lim, gs_real *qs, int *ns, int *br,
                       int info)
{
  const int k6[] = { kind[0], kind[1], kind[2], 2, 2, 2 };
  gs_real c6[96] = { 0 }, s6[96] = { 0 }, a6[18] = { 0 }, p6[18] = { 0 }, d[3];
  for (int i = 0; i < 3; i++)
    {
      d[i] = r[i] * x0[0] + r[i + 3] * x0[1] + r[i + 6] * x0[2] - x0[i] + p[i];
      for (int j = 0; j < 3; j++)
        p6[i + 3 * j] = pa[i + 3 * j] - x0[i];
    }
  gs_copy (9, ka, a6);
  for (int k = 0; k < nb; k++)
    {
      six (3, qc + 3 * k, c6 + 6 * k);
      six (3, qs + 3 * k, s6 + 6 * k);
    }
  info = gs_reach_refine (6, k6, a6, p6, r, d, nb, nm, c6, rad, lim, s6, ns, br, info);
  for (int k = 0; k < nb; k++)
    gs_copy (3, s6 + 6 * k, qs + 3 * k);
  return info;
}

/* a solution refined into q: is it one? */
static int
refined (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
         const gs_real *p, const gs_real *solution, gs_real size, gs_real *q)
{
  gs_real w[42], e[6], miss;
  int iw[6], good;
  six (n, solution, q);
  gs_arm_missed (kind, ka, pa, r, p, q, w, e, &miss);
  gs_arm_refine (n, kind, ka, pa, r, p, q, w, iw, &good);
  if (! good
      || (miss <= GS_R (1e-14) * size && gs_reach_difference (n, kind, q, solution) > GS_R (1e-2)))
    gs_copy (n, solution, q);
  return good || miss <= GS_R (1e-11);
}

/* Newton's method on the pose. One that misses more than 1e-14 of the size of the arm may become
 * one far from it, others stay close. One that is not refined is kept if it misses less than 1e-11.
 * One that becomes another is left out. */
void
gs_reach_refine_all (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                     const gs_real *p, int nb, gs_real *qs, int *ns, int *br)
{
  const gs_real size = gs_reach_size (n, pa, p);
  const int m = *ns;
  (void)nb;
  *ns = 0;
  for (int k = 0; k < m; k++)
    {
      gs_real q[6];
      int closer, keep = refined (n, kind, ka, pa, r, p, qs + n * k, size, q);
      for (int l = 0; l < *ns && keep; l++)
        keep = ! gs_reach_same (n, kind, ka, pa, r, p, q, qs + n * l, &closer);
      if (! keep)
        continue;
      br[*ns] = br[k];
      gs_copy (n, q, qs + n * *ns);
      (*ns)++;
    }
  for (int k = *ns; k < m; k++)
    {
      br[k] = 0;
      gs_zero (n, qs + n * k);
    }
}

/* Newton's method from five places on each side: along z the pose is missed by a parabola, and it
 * stays on its side of the vertex */
int
gs_reach_beside_singular (int n, const int *kind, const gs_real *ka, const gs_real *pa,
                          const gs_real *r, const gs_real *p, const gs_real *q0, const gs_real *z,
                          int nb, gs_real *qs, int *ns, int *br, int info)
{
  gs_real q[6], w[42], h = GS_R (1e-2);
  int iw[6], good;
  for (int l = 0; l < 5; l++, h = GS_R (0.1) * h)
    for (int way = -1; way <= 1; way += 2)
      {
        for (int i = 0; i < 6; i++)
          q[i] = i < n ? q0[i] + (gs_real)way * h * z[i] : (gs_real)way * h * z[i];
        gs_arm_refine (n, kind, ka, pa, r, p, q, w, iw, &good);
        if (good)
          info = gs_reach_put (n, kind, ka, pa, r, p, q, nb, qs, ns, br, info);
      }
  return info;
}

gs_real
gs_reach_difference (int n, const int *kind, const gs_real *q, const gs_real *z)
{
  gs_real d = 0;
  for (int i = 0; i < n; i++)
    {
      gs_real t = gs_abs (q[i] - z[i]);
      if (kind[i] == 1)
        t = gs_abs (2 * gs_sin (GS_R (0.5) * t));
      d = gs_max (d, t);
    }
  return d;
}

void
gs_reach_least_move (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                     const gs_real *p, const gs_real *q, gs_real *z, gs_real *s)
{
  gs_real qa[6], j[36], e[6], v[36], sv[6], miss;
  int rank;
  six (n, q, qa);
  gs_arm_missed (kind, ka, pa, r, p, qa, j, e, &miss);
  gs_singular_values (6, n, j, 6, v, 6, sv, GS_R (1e-14), &rank);
  six (n, v + 6 * (n - 1), z);
  *s = sv[n - 1] / gs_max (sv[0], GS_TINY);
}

/* the place of the solution that misses the pose most, if that is more than most; else -1 */
static int
worst (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
       const gs_real *p, gs_real most, const gs_real *qs, int ns)
{
  gs_real x[6], j[36], e[6], miss;
  int l = -1;
  for (int k = 0; k < ns; k++)
    {
      six (n, qs + n * k, x);
      gs_arm_missed (kind, ka, pa, r, p, x, j, e, &miss);
      if (! (miss > most))
        continue;
      most = miss;
      l = k;
    }
  return l;
}

/* the least number of a branch, from 1, that none of the ns solutions has; nb + 1 */
static int
free_number (int nb, int ns, const int *br)
{
  int l = 1;
  for (int k = 0; l <= nb && k < ns; k++)
    if (br[k] == l)
      {
        l++;
        k = -1;
      }
  return l;
}

/* compared with each by gs_reach_same; one that misses more than 1e-14 of the size of the arm is
 * none. Where there is no room it takes that of the one that misses most, if that is more than
 * this. */
int
gs_reach_put (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
              const gs_real *p, const gs_real *q, int nb, gs_real *qs, int *ns, int *br, int info)
{
  const gs_real most = GS_R (1e-14) * gs_reach_size (n, pa, p);
  gs_real j[36], e[6], miss;
  int closer;
  gs_arm_missed (kind, ka, pa, r, p, q, j, e, &miss);
  if (miss > most)
    return info;
  for (int k = 0; k < *ns; k++)
    if (gs_reach_same (n, kind, ka, pa, r, p, q, qs + n * k, &closer))
      {
        if (closer)
          gs_copy (n, q, qs + n * k);
        return info;
      }
  int full = *ns >= nb, at = full ? worst (n, kind, ka, pa, r, p, most, qs, *ns) : *ns;
  if (at >= 0)
    gs_copy (n, q, qs + n * at);
  if (full)
    return info;
  int l = free_number (nb, *ns, br);
  (*ns)++;
  if (l > nb)
    return info;
  br[*ns - 1] = l;
  return info == 1 ? 0 : info;
}

/* two of six joints: by the signed least singular values a at s (6), b at q (6); here, there:
 * what q and s miss */
static int
are_one (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
         const gs_real *q, const gs_real *s, gs_real size, gs_real here, gs_real there, int *closer)
{
  gs_real x[6], z[6] = { 0 }, u[6] = { 0 }, g, a, b, d = gs_reach_distance (kind, q, s);
  memcpy (x, s, sizeof x);
  gs_reach_onto_curve (0, kind, ka, pa, r, p, x, z, u, &g, &a);
  memcpy (x, q, sizeof x);
  gs_reach_onto_curve (0, kind, ka, pa, r, p, x, z, u, &g, &b);
  int one = d * gs_abs (a - b) <= 2 * size;
  if (a * b > 0)
    one = (d - GS_R (3e-8)) * gs_max (gs_abs (a), gs_abs (b))
          <= 10 * size + 2 * (here + there);
  if (gs_abs (a) <= GS_R (0.25) * gs_abs (b) && d * gs_abs (b) <= 4 * gs_max (there, size))
    {
      one = 1;
      *closer = there > (kind[3] == 2 ? GS_R (0.5) : 2) * size && here <= GS_R (0.5) * there;
    }
  return one;
}

/* A pose is known to about 1e-15 of its size e, a solution to e over the least singular value of
 * the Jacobian. Where the determinants have the same sign two solutions within ten times that, what
 * they miss and 3e-8 are the same. Where they have not a singular position is between them, where
 * the pose is missed by an eighth of the distance times the sum of these values: they are the same
 * where that is below e/4. So is s if it is that position, taken for a double solution: if its
 * value is below a quarter of that of q and what it misses, or e, is between; q takes its place
 * where it misses more than 2 e (e/2 where the place alone counts). Of fewer joints than the pose
 * has freedoms two are the same if half way between them the pose is missed by no more than 2 e
 * above what they miss. */
int
gs_reach_same (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
               const gs_real *p, const gs_real *q, const gs_real *s, int *closer)
{
  gs_real x[6], j[36], e[6], here, there, d;
  *closer = 0;
  if (! (gs_reach_difference (n, kind, q, s) <= GS_R (0.1)))
    return 0;
  const gs_real size = GS_R (1e-15) * gs_reach_size (n, pa, p);
  six (n, s, x);
  gs_arm_missed (kind, ka, pa, r, p, q, j, e, &here);
  gs_arm_missed (kind, ka, pa, r, p, x, j, e, &there);
  *closer = here + GS_R (1e-15) < GS_R (0.5) * there;
  if (n == 6)
    return are_one (kind, ka, pa, r, p, q, s, size, here, there, closer);
  for (int i = 0; i < n; i++)
    {
      d = q[i] - s[i];
      if (kind[i] == 1)
        d = gs_atan2 (gs_sin (d), gs_cos (d));
      x[i] = s[i] + GS_R (0.5) * d;
    }
  gs_arm_missed (kind, ka, pa, r, p, x, j, e, &d);
  return d <= gs_max (here, there) + 2 * size;
}

gs_real
gs_reach_size (int n, const gs_real *pa, const gs_real *p)
{
  gs_real size = 1;
  for (int i = 0; i < 3; i++)
    {
      size = gs_max (size, gs_abs (p[i]));
      for (int j = 0; j < n; j++)
        size = gs_max (size, gs_abs (pa[i + 3 * j]));
    }
  return size;
}
