/* share/engine/core/functions against share/fortran/functions */
#include "compare.h"
#include "gsmbp/functions.h"
#include "gsmbp/sines.h"


gs_real gseps_ (void), gsflr_ (const gs_real *);
int gsfin_ (const int *, const gs_real *);
void gsgln_ (), gslgp_ (), gsglq_ (), gslgi_ (), gssc_ (), gsscl_ (), gsscv_ ();
void gsatv_ (), gsatl_ ();

static const gs_real odd[] = { 0.0,     -0.0,   0.5,  -0.5,  1.0,      -1.0,       1e5,      -1e5,
                              1.00001e5, -2e5, 1e22, -1e300, 1e-300, INFINITY, -INFINITY, NAN,
                              1e300,   DBL_MAX, 1.5707963267948966, 3.14159265358979312 };
enum { ODD = sizeof odd / sizeof *odd };

static void
numbers (void)
{
  begin ("gs_epsilon");
  same_numbers (1, D (gs_epsilon ()), D (gseps_ ()));
  finish ();
  holds (gs_epsilon () == GS_EPSILON, "gs_epsilon is GS_EPSILON");

  begin ("gs_whole_below");
  for (int i = 0; i < 1000; i++)
    {
      gs_real x = i < ODD ? odd[i] : i < 500 ? 1e3 * chance () : gs_floor (50 * chance ());
      same_numbers (1, D (gs_whole_below (x)), D (gsflr_ (&x)));
    }
  finish ();

  begin ("gs_not_finite");
  for (int n = 0; n < 5; n++)
    for (int i = 0; i < ODD; i++)
      for (int k = 0; k < n; k++)
        {
          pair x = pair_of (n);
          x.c[k] = odd[i];
          x.c[n - 1] = pick (3) ? 0.0 : NAN;
          x.c[n] = x.f[n] = NAN; /* behind the end */
          same_int (gs_not_finite (n, x.c), gsfin_ (&n, x.c));
          drop (x);
        }
  same_int (gs_not_finite (0, odd), 0);
  finish ();
}

static void
gauss (void)
{
  gs_real c[12], wt[12];
  begin ("gs_gauss_points");
  for (int ns = 8; ns <= 12; ns += 4)
    {
      pair x = pair_of (12), w = pair_of (12);
      gs_gauss_points (ns, x.c, w.c);
      gsgln_ (&ns, x.f, w.f);
      same (x);
      same (w);
      drop (x);
      drop (w);
    }
  finish ();

  begin ("gs_legendre");
  for (int n = 2; n <= 13; n++)
    for (int k = 0; k < 20; k++)
      {
        gs_real x = k < 2 ? 1.0 - 2 * k : 1.5 * chance ();
        pair p = pair_of (n);
        gs_legendre (n, x, p.c);
        gslgp_ (&n, &x, p.f);
        same (p);
        drop (p);
      }
  finish ();

  begin ("gs_gauss_weights");
  for (int ns = 8; ns <= 12; ns += 4)
    for (int k = 0; k < 50; k++)
      {
        gs_real ca = k ? chance () : -1.0, cb = k ? 1.2 * chance () : 1.0;
        pair b = pair_of (ns);
        gs_gauss_points (ns, c, wt);
        gs_gauss_weights (ns, c, wt, ca, cb, b.c);
        gsglq_ (&ns, c, wt, &ca, &cb, b.f);
        same (b);
        drop (b);
      }
  finish ();

  begin ("gs_interpolation_weights");
  for (int n = 0; n <= 14; n++)
    for (int k = 0; k < 50; k++)
      {
        gs_real ca = chance (), cb = chance ();
        pair z = pair_of (n), b = pair_of (n);
        if (k % 2) /* places as far from cb on both sides */
          {
            cb = n / 2;
            for (int i = 0; i < n; i++)
              z.c[i] = i;
          }
        gs_interpolation_weights (n, z.c, ca, cb, b.c);
        gslgi_ (&n, z.c, &ca, &cb, b.f);
        same (b);
        drop (z);
        drop (b);
      }
  finish ();
}

/* an angle by chance: of all sizes, next to multiples of pi/2, an odd number */
static gs_real
angle (int i)
{
  static const gs_real size[] = { 0.7, 4.0, 1e2, 1e4, 1e5, 1.1e5, 1e9, 1e22 };
  gs_real x = size[i % 8] * chance ();
  if (i < ODD)
    return odd[i];
  return i % 3 ? x : gs_round (x / 1.5707963267948966) * 1.5707963267948966;
}

typedef void pair_function (gs_real x, gs_real *s, gs_real *c);

static void
one_angle (const char *what, pair_function *c, void (*fortran) ())
{
  begin (what);
  for (int i = 0; i < 20000; i++)
    {
      gs_real x = angle (i);
      pair y = pair_of (2);
      c (x, y.c, y.c + 1);
      fortran (&x, y.f, y.f + 1);
      same (y);
      drop (y);
    }
  finish ();
}

static void
blocks (void)
{
  begin ("gs_sine_cosine_blocks");
  for (int k = 0; k < 200; k++)
    {
      int n = pick (7);
      pair x = pair_of (8 * n), s = pair_of (8 * n), c = pair_of (8 * n);
      for (int i = 0; i < 8 * n; i++)
        x.c[i] = k % 4 ? 6e4 / (1 + k) * chance () : angle (ODD + pick (5000));
      if (n > 0 && k % 10 == 0)
        x.c[pick (8 * n)] = odd[pick (ODD)];
      gs_sine_cosine_blocks (n, x.c, s.c, c.c);
      gsscv_ (&n, x.c, s.f, c.f);
      same (s);
      same (c);
      drop (x);
      drop (s);
      drop (c);
    }
  finish ();
}

/* points in all directions, near and on the axes too, of sizes from 1e-290 to 1e290; in every tenth
 * turn an odd one among them */
static void
points (void)
{
  begin ("gs_atan2_blocks");
  for (int k = 0; k < 400; k++)
    {
      int n = pick (7), wide = k % 3 == 0;
      pair y = pair_of (8 * n), x = pair_of (8 * n), a = pair_of (8 * n);
      for (int i = 0; i < 8 * n; i++)
        {
          gs_real size = gs_pow (10.0, (wide ? 290.0 : 1.0) * chance ());
          x.c[i] = pick (5) ? size * chance () : pick (2) ? -0.0 : 0.0;
          y.c[i] = x.c[i] == 0.0 || pick (5) ? size * chance () : pick (2) ? -0.0 : 0.0;
        }
      if (n > 0 && k % 10 == 0)
        (pick (2) ? x.c : y.c)[pick (8 * n)] = odd[pick (ODD)];
      gs_atan2_blocks (n, y.c, x.c, a.c);
      gsatv_ (&n, y.c, x.c, a.f);
      same (a);
      drop (y);
      drop (x);
      drop (a);
    }
  finish ();
}

static void
one_point (void)
{
  begin ("gs_atan2_point");
  for (int i = 0; i < ODD; i++)
    for (int k = 0; k < ODD; k++)
      {
        pair a = pair_of (1);
        gs_atan2_point (odd[i], odd[k], a.c);
        gsatl_ (odd + i, odd + k, a.f);
        same (a);
        drop (a);
      }
  finish ();
}

int
main (void)
{
  numbers ();
  gauss ();
  one_angle ("gs_sine_cosine", gs_sine_cosine, gssc_);
  one_angle ("gs_sines, in line", gs_sines, gssc_);
  one_angle ("gs_sine_cosine_far", gs_sine_cosine_far, gsscl_);
  blocks ();
  points ();
  one_point ();
  return 0;
}
