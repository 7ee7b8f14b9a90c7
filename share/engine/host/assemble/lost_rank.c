/* lost_rank.c: positions at which constraints depend on each other that do not elsewhere. */
#include "gsmbp/solve.h"
#include "host/assemble/assemble_parts.h"

static gs_real
row_length (const gs_pose *p, int m, int nu, int row)
{
  gs_real sum = 0;
  for (int j = 0; j < nu; j++)
    sum += p->rows[row + m * j] * p->rows[row + m * j];
  return gs_sqrt (sum);
}

/* rows (nu,nlam): each constraint divided by its length here or where the scene starts */
static void
scale_rows (const gs_work *w, const gs_pose *here, const gs_pose *first, gs_real *rows)
{
  const int m = w->s->nlam, nu = w->s->nu;
  for (int i = 0; i < m; i++)
    {
      const gs_real a = row_length (here, m, nu, i), b = row_length (first, m, nu, i);
      const gs_real size = a > b ? a : b;
      for (int j = 0; j < nu; j++)
        rows[j + nu * i] = size > 0 ? here->rows[i + m * j] / size : 0;
    }
}

/* how much constraint i of m has of the combinations v (m,m) at the places first to last - 1 */
static gs_real
share_of (int m, const gs_real *v, int i, int first, int last)
{
  gs_real most = 0;
  for (int k = first; k < last; k++)
    most = gs_abs (v[i + m * k]) > most ? gs_abs (v[i + m * k]) : most;
  return most;
}

/* v (nlam,nlam): combinations of constraints, those that have gone at the places n to rank */
static void
put_rows (const gs_work *w, const gs_real *v, int n, int rank, gs_writer *said)
{
  const int m = w->s->nlam;
  for (int i = 0, many = 0; i < m; i++)
    {
      if (! (share_of (m, v, i, n, rank) > GS_R (0.1)))
        continue;
      gs_put (said, "%s", many++ ? ", " : "");
      if (w->d->constraints)
        gs_put (said, "%s", w->d->constraints[i]);
      else
        gs_put (said, "%d", i + 1);
    }
}

int
gs_lost_rank (const gs_description *d, gs_real t, const gs_real *cst, int rank,
              const gs_real *start, const gs_real *x, int *loose, char *text, int size)
{
  gs_linear_told told;
  const gs_linear_place at = { .t = t, .cst = cst };
  gs_work w = gs_work_begin (d, &at, &told);
  const int m = d->scene->nlam, nu = d->scene->nu;
  gs_pose here, first;
  gs_writer said = { text, size, 0 };
  int n = rank;
  text[0] = 0;
  if (m == 0 || rank == 0 || ! d->scene->con)
    return 0;
  gs_real *rows = gs_numbers (&w, m * nu), *v = gs_numbers (&w, m * m), *s = gs_numbers (&w, m);
  if (rows && v && s && gs_pose_begin (&w, &here) == 0 && gs_pose_begin (&w, &first) == 0)
    {
      gs_pose_at (&w, x, &here);
      gs_pose_at (&w, start, &first);
      scale_rows (&w, &here, &first, rows);
      gs_singular_values (nu, m, rows, nu, v, m, s, GS_R (1e-4), &n);
      if (n < rank)
        {
          gs_put (&said, "%d of the %d constraints that are independent elsewhere are so, lost in "
                  "rows ", n, rank);
          put_rows (&w, v, n, rank, &said);
          for (int i = 0; loose && i < m; i++)
            loose[i] = share_of (m, v, i, n, m) > GS_R (1e-3);
          gs_put (&said, ": a change point, or links in one line");
        }
    }
  return gs_work_end (&w) == GS_LINEAR_NO_MEMORY ? -1 : n < rank;
}
