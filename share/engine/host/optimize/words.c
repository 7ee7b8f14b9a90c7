/* words.c: what a word says of a quantity over the times of a load case, and its derivatives. */
#include <float.h>
#include <math.h>

#include "host/optimize/optimize_parts.h"

typedef struct
{
  const gs_series *s;
  const gs_case_times *c;
  int nt, n;
  double *f, *F;
} measure;

static double
sign (double x)
{
  return (x > 0) - (x < 0);
}

static double
slope (const measure *m, int i, int k)
{
  return m->s->slopes[i + m->nt * k];
}

/* derivatives of times, of weights */
static double
moved (const measure *m, const double *by, int i, int k)
{
  return by ? by[i + m->nt * k] : 0;
}

/* factor times the value at a time */
static void
take (measure *m, int i, double factor)
{
  *m->f = factor * m->s->y[i];
  for (int k = 0; k < m->n; k++)
    m->F[k] = factor * slope (m, i, k);
}

static int
largest (const measure *m, double factor, int modulus)
{
  int most = 0;
  for (int i = 1; i < m->nt; i++)
    {
      const double a = factor * m->s->y[i], b = factor * m->s->y[most];
      if (modulus ? fabs (a) > fabs (b) : a > b)
        most = i;
    }
  return most;
}

/* the sum of weights times u (y), u_y its derivative */
static void
integrate (measure *m, int word)
{
  const double *y = m->s->y, *w = m->c->w;
  *m->f = 0;
  for (int k = 0; k < m->n; k++)
    m->F[k] = 0;
  for (int i = 0; i < m->nt; i++)
    {
      const int square = word == GS_WORD_square || word == GS_WORD_rms;
      const int out = word == GS_WORD_drawn && ! (y[i] > 0);
      const double u = square ? y[i] * y[i] : out ? 0 : y[i];
      const double u_y = square ? 2 * y[i] : out ? 0 : 1;
      *m->f += w[i] * u;
      for (int k = 0; k < m->n; k++)
        m->F[k] += w[i] * u_y * slope (m, i, k) + u * moved (m, m->c->dw, i, k);
    }
}

/* an integral as a mean */
static void
divide (measure *m)
{
  double T = 0;
  for (int i = 0; i < m->nt; i++)
    T += m->c->w[i];
  *m->f /= T;
  for (int k = 0; k < m->n; k++)
    {
      double longer = 0;
      for (int i = 0; i < m->nt; i++)
        longer += moved (m, m->c->dw, i, k);
      m->F[k] = (m->F[k] - *m->f * longer) / T;
    }
}

static void
take_root (measure *m)
{
  *m->f = sqrt (*m->f);
  for (int k = 0; k < m->n; k++)
    m->F[k] /= 2 * fmax (*m->f, DBL_MIN);
}

/* Not settled at the last time: the time goes on as far as it is outside. */
static void
stay_outside (measure *m, double limit, double band)
{
  const int last = m->nt - 1;
  const double *y = m->s->y, *t = m->c->t, whole = t[last] - t[0];
  *m->f = whole + (fabs (y[last]) / fmax (limit, DBL_MIN) - 1) * whole;
  for (int k = 0; k < m->n; k++)
    {
      const double L = band * sign (y[0]) * slope (m, 0, k);
      m->F[k] = whole * (sign (y[last]) * slope (m, last, k) / limit
                         - fabs (y[last]) * L / (limit * limit))
                + *m->f / whole * moved (m, m->c->dt, last, k);
    }
}

/* when |y| last leaves the band, beside its first value, from the first time on: on a line between
 * two times */
static void
settle (measure *m, double band)
{
  const double *y = m->s->y, *t = m->c->t, limit = band * fabs (y[0]);
  int i = m->nt - 1;
  while (i >= 0 && ! (fabs (y[i]) > limit))
    i--;
  if (i == m->nt - 1)
    {
      stay_outside (m, limit, band);
      return;
    }
  const double a = i < 0 ? 0 : fabs (y[i]) - limit, b = i < 0 ? 1 : limit - fabs (y[i + 1]);
  const double h = i < 0 ? 0 : t[i + 1] - t[i];
  *m->f = i < 0 ? 0 : t[i] - t[0] + h * a / (a + b);
  for (int k = 0; k < m->n; k++)
    {
      m->F[k] = 0;
      if (i < 0)
        continue;
      const double L = band * sign (y[0]) * slope (m, 0, k);
      const double A = sign (y[i]) * slope (m, i, k) - L;
      const double B = L - sign (y[i + 1]) * slope (m, i + 1, k);
      const double before = moved (m, m->c->dt, i, k), after = moved (m, m->c->dt, i + 1, k);
      m->F[k] = h * (A * b - a * B) / ((a + b) * (a + b)) + before
                + (after - before) * a / (a + b);
    }
}

void
gs_measure (int word, const gs_series *y, const gs_case_times *times, double band, int n, double *f,
            double *F)
{
  measure m = { y, times, times->nt, n, f, F };
  int i;
  switch (word)
    {
    case GS_WORD_start:
      take (&m, 0, 1);
      break;
    case GS_WORD_end:
      take (&m, m.nt - 1, 1);
      break;
    case GS_WORD_peak:
      i = largest (&m, 1, 1);
      take (&m, i, sign (y->y[i]));
      break;
    case GS_WORD_max:
      take (&m, largest (&m, 1, 0), 1);
      break;
    case GS_WORD_min:
      take (&m, largest (&m, -1, 0), 1);
      break;
    case GS_WORD_settling:
      settle (&m, band);
      break;
    default:
      integrate (&m, word);
      if (word != GS_WORD_integral && word != GS_WORD_drawn)
        divide (&m);
      if (word == GS_WORD_rms)
        take_root (&m);
    }
}
