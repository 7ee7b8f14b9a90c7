/* modes.c: modes of eigenvalues and eigenvectors: their order, frequencies, shapes. */
#include <stdlib.h>

#include "host/linear/linear_parts.h"

static gs_real
size_of (const gs_real *z)
{
  return gs_sqrt (z[0] * z[0] + z[1] * z[1]);
}

static int
rising (const void *a, const void *b)
{
  const gs_real x = *(const gs_real *)a, y = *(const gs_real *)b;
  return (x > y) - (x < y);
}

/* eigenvalues below 1e-9 of the largest one are zero */
static void
round_to_zero (int n, gs_real *e)
{
  gs_real most = 0;
  for (int i = 0; i < n; i++)
    most = gs_max (most, size_of (e + 2 * i));
  for (int i = 0; i < n; i++)
    if (size_of (e + 2 * i) <= GS_R (1e-9) * most)
      e[2 * i] = e[2 * i + 1] = 0;
}

/* which eigenvalues have imaginary parts above 0, by rising size: how many */
static int
list_pairs (int n, const gs_real *e, int *pairs)
{
  int many = 0;
  for (int i = 0; i < n; i++)
    {
      if (! (e[2 * i + 1] > 0))
        continue;
      int at = many++;
      for (; at > 0 && size_of (e + 2 * pairs[at - 1]) > size_of (e + 2 * i); at--)
        pairs[at] = pairs[at - 1];
      pairs[at] = i;
    }
  return many;
}

/* z (2,n): the deviations of the n states in the mode of the eigenvalue e and vector v: a*z = e*z
 * gives those on which nothing depends */
static void
deviations (const gs_vibrations *r, const gs_real *e, const gs_real *v, gs_real *z)
{
  const gs_real square = e[0] * e[0] + e[1] * e[1];
  for (int i = 0; i < r->n; i++)
    {
      gs_real sum[2] = { 0, 0 };
      for (int j = 0; j < r->nfelt; j++)
        for (int c = 0; c < 2; c++)
          sum[c] += r->a[i + r->n * r->felt[j]] * v[2 * j + c];
      z[2 * i] = (sum[0] * e[0] + sum[1] * e[1]) / square;
      z[2 * i + 1] = (sum[1] * e[0] - sum[0] * e[1]) / square;
    }
  for (int j = 0; j < r->nfelt; j++)
    for (int c = 0; c < 2; c++)
      z[2 * r->felt[j] + c] = v[2 * j + c];
}

/* shape (2,told) of these deviations, the largest amplitude 1 (of equal ones, but for rounding, the
 * first), zero where states of devices vibrate alone; x: (2,nx) */
static void
shape_of (const gs_work *w, const gs_vibrations *r, int told, const gs_real *z, gs_real *x,
          gs_real *shape)
{
  const int nx = w->s->nx;
  gs_real all = 0, own = 0;
  int top = 0;
  for (int i = 0; i < nx; i++)
    {
      x[2 * i] = x[2 * i + 1] = 0;
      for (int j = 0; j < r->n; j++)
        for (int c = 0; c < 2; c++)
          x[2 * i + c] += r->tangent[i + nx * j] * z[2 * j + c]
                          * (gs_real)w->d->nominal[r->independent[j]];
      const gs_real share = size_of (x + 2 * i) / (gs_real)w->d->nominal[i];
      all = gs_max (all, share);
      if (i < told)
        own = gs_max (own, share);
      if (i < told && size_of (x + 2 * i) > size_of (x + 2 * top) * (1 + GS_R (1e-9)))
        top = i;
    }
  const gs_real re = x[2 * top], im = x[2 * top + 1], square = re * re + im * im;
  for (int i = 0; i < told; i++)
    {
      const int counts = own > GS_R (1e-12) * all;
      shape[2 * i] = counts ? (x[2 * i] * re + x[2 * i + 1] * im) / square : 0;
      shape[2 * i + 1] = counts ? (x[2 * i + 1] * re - x[2 * i] * im) / square : 0;
    }
}

int
gs_modes_of (const gs_description *d, const gs_linear_place *at, const gs_vibrations *r, gs_real *e,
             const gs_real *v, gs_modes *modes, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  const gs_scene *s = d->scene;
  const int k = r->nfelt, rows = s->nq > 0 ? s->nq : s->nx;
  int *pairs = gs_places (&w, k);
  gs_real *z = gs_numbers (&w, 2 * r->n), *x = gs_numbers (&w, 2 * s->nx);
  modes->n = modes->nreal = 0;
  modes->rigid = r->n - k;
  if (! pairs || ! z || ! x)
    return gs_work_end (&w);
  round_to_zero (k, e);
  modes->n = list_pairs (k, e, pairs);
  for (int i = 0; i < modes->n; i++)
    {
      const gs_real *own = e + 2 * pairs[i];
      gs_copy (2, own, modes->eigenvalues + 2 * i);
      modes->frequency[i] = size_of (own);
      modes->damping[i] = 0 - own[0] / modes->frequency[i];
      deviations (r, own, v + 2 * k * pairs[i], z);
      shape_of (&w, r, rows, z, x, modes->shapes + 2 * rows * i);
    }
  for (int i = 0; i < k; i++)
    if (e[2 * i] == 0 && e[2 * i + 1] == 0)
      modes->rigid++;
    else if (e[2 * i + 1] == 0)
      modes->real[modes->nreal++] = e[2 * i];
  qsort (modes->real, (size_t)modes->nreal, sizeof *modes->real, rising);
  return gs_work_end (&w);
}
