/* campbell.c: modes followed by their shapes from speed to speed. */
#include <math.h>
#include <stdlib.h>

#include "host/linear/linear_parts.h"

/* how alike two shapes (2,rows) are, 0 to 1 */
static gs_real
likeness (int rows, const gs_real *a, const gs_real *b)
{
  gs_real re = 0, im = 0, aa = 0, bb = 0;
  for (int i = 0; i < 2 * rows; i += 2)
    {
      re += a[i] * b[i] + a[i + 1] * b[i + 1];
      im += a[i] * b[i + 1] - a[i + 1] * b[i];
      aa += a[i] * a[i] + a[i + 1] * a[i + 1];
      bb += b[i] * b[i] + b[i + 1] * b[i + 1];
    }
  return aa > 0 && bb > 0 ? gs_sqrt ((re * re + im * im) / (aa * bb)) : 0;
}

/* rows of the n modes of one speed: each that of the most alike shape which a row had last, or a
 * new one; last (nrows): where the shapes lie. How many rows there are then; -1: no memory */
static int
join (int rows, int n, const gs_real *shapes, int nrows, const gs_real **last, int *row)
{
  const int pairs = n * nrows, size = 2 * rows;
  gs_real *like = calloc ((size_t)pairs + 1, sizeof *like);   /* (nrows,n) */
  if (! like)
    return -1;
  for (int k = 0; k < pairs; k++)
    like[k] = likeness (rows, last[k % nrows], shapes + size * (k / nrows));
  for (int j = 0; j < n; j++)
    row[j] = -1;
  for (;;)
    {
      int best = 0;
      for (int k = 1; k < pairs; k++)
        best = like[k] > like[best] ? k : best;
      if (! (like[best] > GS_R (0.5)))
        break;
      const int own = best % nrows, mode = best / nrows;
      row[mode] = own;
      for (int j = 0; j < n; j++)
        like[own + nrows * j] = 0;
      gs_zero (nrows, like + nrows * mode);
    }
  free (like);
  for (int j = 0; j < n; j++)
    {
      if (row[j] < 0)
        row[j] = nrows++;
      last[row[j]] = shapes + size * j;
    }
  return nrows;
}

/* the frequency of a row at a speed, whose n modes have the rows; infinite where it has none */
static float
frequency_of (int n, const int *row, const gs_real *frequency, int wanted)
{
  for (int j = 0; j < n; j++)
    if (row[j] == wanted)
      return (float)frequency[j];   /* equal but for rounding */
  return INFINITY;
}

/* is row a to stand behind row b? By rising frequencies at the first speed where they differ */
static int
stands_behind (const gs_campbell *c, const int *row, int a, int b)
{
  for (int k = 0, first = 0; k < c->nspeeds; first += c->many[k++])
    {
      const float fa = frequency_of (c->many[k], row + first, c->frequency + first, a);
      const float fb = frequency_of (c->many[k], row + first, c->frequency + first, b);
      if (fa > fb || fa < fb)
        return fa > fb;
    }
  return 0;
}

/* the rows (nrows) in their order, which row is to follow */
static void
sort_rows (const gs_campbell *c, int nrows, int *order, int *row)
{
  for (int i = 0; i < nrows; i++)
    {
      int at = i;
      for (; at > 0 && stands_behind (c, row, order[at - 1], i); at--)
        order[at] = order[at - 1];
      order[at] = i;
    }
  for (int j = 0; j < c->total; j++)
    {
      int at = 0;
      while (order[at] != row[j])
        at++;
      row[j] = at;
    }
}

int
gs_follow_modes (const gs_campbell *c, int *row)
{
  const gs_real **last = calloc ((size_t)c->total + 1, sizeof *last);
  int *order = calloc ((size_t)c->total + 1, sizeof *order), nrows = last && order ? 0 : -1;
  for (int k = 0, first = 0; k < c->nspeeds && nrows >= 0; first += c->many[k++])
    nrows = join (c->rows, c->many[k], c->shapes + (ptrdiff_t)2 * c->rows * first, nrows, last,
                  row + first);
  if (nrows > 0)
    sort_rows (c, nrows, order, row);
  free (order);
  free (last);
  return nrows;
}
