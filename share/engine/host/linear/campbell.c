/* campbell.c: modes followed by their shapes from speed to speed. */
#include <math.h>

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
 * new one; last (nrows): where the shapes lie. How many rows there are then */
static int
join (int rows, int n, const gs_real *const *shapes, int nrows, const gs_real **last, int *row)
{
  for (int j = 0; j < n; j++)
    row[j] = -1;
  for (;;)
    {
      gs_real best = GS_R (0.5);
      int mode = -1, to = -1;
      for (int j = 0; j < n; j++)
        for (int i = 0; i < nrows && row[j] < 0; i++)
          if (! gs_is_among (i, n, row))
            {
              const gs_real like = likeness (rows, last[i], shapes[j]);
              if (like > best)
                {
                  best = like;
                  mode = j;
                  to = i;
                }
            }
      if (mode < 0)
        break;
      row[mode] = to;
    }
  for (int j = 0; j < n; j++)
    if (row[j] < 0)
      row[j] = nrows++;
  for (int j = 0; j < n; j++)
    last[row[j]] = shapes[j];
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

int
gs_follow_modes (const gs_campbell *c, const gs_real **room, int *order, int *row)
{
  const gs_real **last = room;
  int nrows = 0, first = 0;
  for (int k = 0; k < c->nspeeds; first += c->many[k++])
    {
      const gs_real **shapes = room + c->total;
      for (int j = 0; j < c->many[k]; j++)
        shapes[j] = c->shapes + (ptrdiff_t)2 * c->rows * (first + j);
      nrows = join (c->rows, c->many[k], shapes, nrows, last, row + first);
    }
  for (int i = 0; i < nrows; i++)
    {
      int at = i;
      for (; at > 0 && stands_behind (c, row, order[at - 1], i); at--)
        order[at] = order[at - 1];
      order[at] = i;
    }
  for (int j = 0; j < c->total; j++)
    for (int i = 0; i < nrows; i++)
      if (order[i] == row[j])
        {
          row[j] = i;
          break;
        }
  return nrows;
}
