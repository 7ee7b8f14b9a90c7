/* roughness.c: the form by which inputs on singular arcs are made smooth: the square of their
 * distance from the cubic through the points of three intervals, for each three in turn within the
 * arc. */
#include "host/collocation/program_parts.h"

#include <math.h>

void
gs_cubic_basis (int n, const double *t, double *basis)
{
  double mean = 0;
  for (int i = 0; i < n; i++)
    mean += t[i] / n;
  for (int j = 0; j < 4; j++)
    {
      double *b = basis + n * j, norm = 0;
      for (int i = 0; i < n; i++)
        b[i] = pow ((t[i] - mean) / (t[n - 1] - t[0]), j);
      for (int again = 0; again < 2; again++)
        for (int k = 0; k < j; k++)
          {
            double share = 0;
            for (int i = 0; i < n; i++)
              share += basis[n * k + i] * b[i];
            for (int i = 0; i < n; i++)
              b[i] -= share * basis[n * k + i];
          }
      for (int i = 0; i < n; i++)
        norm += b[i] * b[i];
      for (int i = 0; i < n; i++)
        b[i] /= sqrt (norm);
    }
}

/* what lies beside the cubic through the stages of interval k and those next to it, times weight */
static int
three_intervals (const gs_program *c, int input, int k, double weight, gs_form_entry *form)
{
  const int q0 = gs_stage (c, k - 1, 0), n = gs_stage (c, k + 1, 2) - q0 + 1;
  const int column = c->nz - c->s->nv + input;
  double basis[4 * 9];
  gs_cubic_basis (n, c->tau + q0, basis);
  for (int i = 0; form && i < n; i++)
    for (int j = 0; j <= i; j++)
      {
        double off = i == j;
        for (int l = 0; l < 4; l++)
          off -= basis[n * l + i] * basis[n * l + j];
        *form++ = (gs_form_entry){ c->nz * (q0 + i) + column, c->nz * (q0 + j) + column,
                                   weight * c->h[k] / n * off };
      }
  return n * (n + 1) / 2;
}

int
gs_roughness (const gs_program *c, gs_form_entry *form)
{
  int n = 0;
  for (int a = 0; a < c->p->narcs; a++)
    {
      const gs_smooth_arc *arc = c->p->arcs + a;
      int first = 0, last = c->intervals - 1;
      while (first < c->intervals && c->tau[gs_left (c, first)] < arc->from - 1e-9)
        first++;
      while (last >= 0 && c->tau[gs_stage (c, last, 2)] > arc->until + 1e-9)
        last--;
      for (int k = first + 1; k < last; k++)
        n += three_intervals (c, arc->input, k, arc->weight, form ? form + n : NULL);
    }
  return n;
}
