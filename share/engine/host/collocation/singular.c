/* singular.c: where inputs of a solution are not determined by the minimum principle itself:
 * between their limits on more than two intervals in turn, where the second derivative of the
 * Hamiltonian by them is nothing (the condition of Legendre and Clebsch holds as an equation).
 * Source: Betts (2010), section 4.14; Bryson and Ho, Applied Optimal Control, 1975, chapter 8. */
#include <math.h>

#include "host/collocation/collocation_parts.h"
#include "host/linear/linear_parts.h"

/* ------------------------------------------------------------------------------------ limits */

static double
range_of (const gs_program *c, const double *first, int step, int from)
{
  double low = first[step * from], high = low;
  for (int q = from; q < c->points; q++)
    {
      low = fmin (low, first[step * q]);
      high = fmax (high, first[step * q]);
    }
  return high - low;
}

double
gs_input_width (const gs_solution *s, int j)
{
  const gs_program *c = s->c;
  const double *v = s->r.x + c->nz - c->s->nv + j;
  double most = 0;
  for (int q = c->first; q < c->points; q++)
    most = fmax (most, fabs (v[c->nz * q]));
  const double width = range_of (c, v, c->nz, c->first) + 1e-3 * most;
  return width < 1e-6 ? 1 : width;
}

static int
at_limit (double x, double low, double high, double near)
{
  return x < low + near || x > high - near;
}

/* input widths; inner (nv,points): 1 where an input is between its limits; held (points): 1 where a
 * state or an output is at a limit; f: the functions at all points */
static void
look_at_limits (const gs_solution *s, const double *f, double *span, int *inner, int *held)
{
  const gs_program *c = s->c;
  const gs_motion_problem *p = &s->p;
  const int nv = c->s->nv, v0 = c->nz - nv;
  for (int j = 0; j < nv; j++)
    {
      const double low = p->low[v0 + j], high = p->high[v0 + j];
      span[j] = isfinite (high - low) ? high - low : gs_input_width (s, j);
      for (int q = c->first; q < c->points; q++)
        inner[nv * q + j] = span[j] > 0
                            && ! at_limit (gs_point (s, q)[v0 + j], low, high, 1e-3 * span[j]);
    }
  for (int j = 0; j < c->s->nx; j++)
    {
      const double near = 1e-6 * range_of (c, s->r.x + j, c->nz, 0);
      for (int q = c->first; q < c->points; q++)
        held[q] |= at_limit (gs_point (s, q)[j], p->low[j], p->high[j], near);
    }
  for (int i = 0; i < p->nbounded; i++)
    {
      const double *y = f + c->nf - c->s->ny + p->bounded[i];
      const double near = 1e-6 * range_of (c, y, c->nf, c->first);
      for (int q = c->first; q < c->points; q++)
        held[q] |= at_limit (y[c->nf * q], p->output_low[i], p->output_high[i], near);
    }
}

/* ------------------------------------------------------------------------- the Hamiltonian */

/* of each point the derivatives of its residuals (nr,n) and the second ones of the program (n,n) by
 * its n accelerations, multipliers and inputs */
typedef struct
{
  int n;
  double *r, *w;
} point_blocks;

static void
blocks_of (gs_search *w, const gs_solution *s, point_blocks *b)
{
  gs_program *c = s->c;
  const int nx = c->s->nx, nz = c->nz, n = nz - nx;
  const int most = s->size.jacobian > s->size.hessian ? s->size.jacobian : s->size.hessian;
  int *rows = gs_room_places (&w->room, most), *columns = gs_room_places (&w->room, most);
  double *values = gs_room_numbers (&w->room, most);
  b->n = n;
  b->r = gs_room_numbers (&w->room, (ptrdiff_t)c->nr * n * c->points);
  b->w = gs_room_numbers (&w->room, (ptrdiff_t)n * n * c->points);
  if (gs_search_bad (w))
    return;
  gs_program_evaluate (c, GS_JACOBIAN, s->r.x, 1, NULL, values);
  gs_program_places (c, GS_JACOBIAN, rows, columns);
  for (int e = 0; e < s->size.jacobian; e++)
    {
      const int q = columns[e] / nz, l = columns[e] % nz - nx;
      if (rows[e] < c->nr * (c->points - c->first) && q < c->points && l >= 0)
        b->r[c->nr * (n * q + l) + rows[e] % c->nr] += values[e];
    }
  gs_program_evaluate (c, GS_HESSIAN, s->r.x, 1, s->r.lambda, values);
  gs_program_places (c, GS_HESSIAN, rows, columns);
  for (int e = 0; e < s->size.hessian; e++)
    {
      const int q = columns[e] / nz, i = rows[e] % nz - nx, j = columns[e] % nz - nx;
      if (rows[e] / nz != q || q >= c->points || i < 0 || j < 0)
        continue;
      b->w[n * (n * q + j) + i] += values[e];
      if (i != j)
        b->w[n * (n * q + i) + j] += values[e];
    }
}

/* eigenvalues e and orthonormal eigenvectors v of the symmetric a (n,n), by Jacobi's rotations */
static void
symmetric_modes (int n, double *a, double *e, double *v)
{
  for (int k = 0; k < n * n; k++)
    v[k] = k % (n + 1) == 0;
  for (int sweep = 0; sweep < 60; sweep++)
    for (int p = 0; p < n; p++)
      for (int q = p + 1; q < n; q++)
        {
          if (a[p + n * q] == 0)
            continue;
          const double angle = 0.5 * atan2 (2 * a[p + n * q], a[q + n * q] - a[p + n * p]);
          const double c = cos (angle), s = sin (angle);
          for (int k = 0; k < n; k++)
            {
              const double x = a[k + n * p], y = a[k + n * q];
              a[k + n * p] = c * x - s * y;
              a[k + n * q] = s * x + c * y;
            }
          for (int k = 0; k < n; k++)
            {
              const double x = a[p + n * k], y = a[q + n * k];
              a[p + n * k] = c * x - s * y;
              a[q + n * k] = s * x + c * y;
            }
          for (int k = 0; k < n; k++)
            {
              const double x = v[k + n * p], y = v[k + n * q];
              v[k + n * p] = c * x - s * y;
              v[k + n * q] = s * x + c * y;
            }
          a[p + n * q] = a[q + n * p] = 0;
        }
  for (int k = 0; k < n; k++)
    e[k] = a[k + n * k];
}

/* how accelerations and multipliers follow the inputs: D (n,nv), by the residuals R (nr,n); loops
 * may repeat */
static int
follow_inputs (gs_search *w, const gs_solution *s, const double *r, const double *span, double *D)
{
  const gs_program *c = s->c;
  const int nr = c->nr, nv = c->s->nv, n = c->nz - c->s->nx, no = n - nv;
  gs_linear_told told;
  const gs_linear_place place = { .t = 0, .cst = w->p->cst };
  gs_work work = gs_work_begin (w->d, &place, &told);
  gs_real *a = gs_numbers (&work, nr * no), *inverse = gs_numbers (&work, nr * no);
  if (a && inverse)
    {
      for (int k = 0; k < nr * no; k++)
        a[k] = r[k];
      if (no > 0)
        gs_pseudo_inverse (&work, nr, no, a, 2.2e-16 * (nr > no ? nr : no), inverse);
      for (int j = 0; j < nv; j++)
        for (int l = 0; l < n; l++)
          {
            double sum = l == no + j;
            for (int i = 0; l < no && i < nr; i++)
              sum -= (double)inverse[l + no * i] * r[nr * (no + j) + i];
            D[n * j + l] = sum * span[j];
          }
    }
  return gs_work_end (&work) == GS_LINEAR_NO_MEMORY;
}

/* of the inner inputs at the point q (nv, 1 each): 0 where the Hamiltonian bends by it */
static void
look_at_point (gs_search *w, const gs_solution *s, const point_blocks *b, int q, double most,
               const double *span, double *room, int *inner)
{
  const gs_program *c = s->c;
  const int n = b->n, nv = c->s->nv;
  const double weight = gs_integral_weight (c, q), *W = b->w + n * n * q;
  double *D = room, *H = D + n * nv, *e = H + nv * nv, *V = e + nv;
  int m = 0, which = 0;
  if (follow_inputs (w, s, b->r + c->nr * n * q, span, D))
    w->bad = 1;
  for (int j = 0; j < nv; j++)   /* those between their limits, first */
    if (inner[j])
      {
        for (int l = 0; l < n; l++)
          D[n * m + l] = D[n * j + l];
        m++;
      }
  for (int i = 0; i < m; i++)
    for (int j = 0; j < m; j++)
      {
        H[i + m * j] = 0;
        for (int k = 0; k < n; k++)
          for (int l = 0; l < n; l++)
            H[i + m * j] += D[n * i + k] * W[k + n * l] * D[n * j + l] / weight;
      }
  symmetric_modes (m, H, e, V);
  for (int j = 0; j < nv; j++)
    if (inner[j])
      {
        inner[j] = 0;
        for (int k = 0; k < m; k++)
          inner[j] |= fabs (e[k]) < most && fabs (V[which + m * k]) > 0.1;
        which++;
      }
}

/* ------------------------------------------------------------------------------------- arcs */

/* the largest distance of input j from a cubic through the points of three intervals, from the
 * point first to last */
static double
ringing (const gs_solution *s, int j, int first, int last)
{
  const gs_program *c = s->c;
  double most = 0, basis[4 * 9];
  for (int k = 1; k < c->intervals - 1; k++)
    {
      if (gs_left (c, k - 1) < first || gs_stage (c, k + 1, 2) > last)
        continue;
      const int from = gs_stage (c, k - 1, 0);
      const int n = gs_stage (c, k + 1, 2) - from + 1;
      gs_cubic_basis (n, s->t + from, basis);
      for (int i = 0; i < n; i++)
        {
          double off = 0;
          for (int l = 0; l < n; l++)
            {
              double share = i == l;
              for (int a = 0; a < 4; a++)
                share -= basis[n * a + i] * basis[n * a + l];
              off += share * gs_point (s, from + l)[c->nz - c->s->nv + j];
            }
          most = fmax (most, fabs (off));
        }
    }
  return most;
}

/* flat (nv,points) and held in turn as arcs */
static int
arcs_of (const gs_solution *s, const int *flat, const int *held, gs_singular_arc *list)
{
  const gs_program *c = s->c;
  const int nv = c->s->nv, least = 2 * c->rule.own + 2;
  int n = 0;
  for (int j = 0; j < nv; j++)
    for (int q = c->first, end; q < c->points; q = end)
      {
        for (end = q + 1; end < c->points && flat[nv * end + j] == flat[nv * q + j]
                          && (! flat[nv * q + j] || held[end] == held[q]);
             end++)
          ;
        if (! flat[nv * q + j] || end - q < least)
          continue;
        list[n++] = (gs_singular_arc){ j, held[q], s->t[q], s->t[end - 1],
                                       ringing (s, j, q, end - 1), 0 };
      }
  return n;
}

int
gs_singular_arcs (gs_search *w, gs_solution *s, gs_singular_arc **arcs)
{
  const gs_program *c = s->c;
  const int nv = c->s->nv, n = c->nz - c->s->nx;
  point_blocks b;
  if (! s->r.solved || nv == 0)
    return 0;
  *arcs = (gs_singular_arc *)gs_room_take (&w->room, nv * c->points, sizeof **arcs);
  double *f = gs_room_numbers (&w->room, s->size.functions);
  double *span = gs_room_numbers (&w->room, nv);
  double *room = gs_room_numbers (&w->room, n * nv + 2 * nv * nv + nv);
  int *inner = gs_room_places (&w->room, nv * c->points);
  int *held = gs_room_places (&w->room, c->points);
  blocks_of (w, s, &b);
  if (gs_search_bad (w))
    return 0;
  gs_program_evaluate (s->c, GS_FUNCTIONS, s->r.x, 1, NULL, f);
  look_at_limits (s, f, span, inner, held);
  const double most = 1e-6 * (1 + fabs (s->r.goal)) / gs_whole_duration (s);
  for (int q = c->first; q < c->points; q++)
    look_at_point (w, s, &b, q, most, span, room, inner + nv * q);
  return gs_search_bad (w) ? 0 : arcs_of (s, inner, held, *arcs);
}

/* ------------------------------------------------------------------------- made smooth */

/* the mean size of the parts of the Hamiltonian, times the duration */
static double
size_of_goal (gs_search *w, const gs_solution *s)
{
  const gs_program *c = s->c;
  const int nx = c->s->nx;
  double *l = gs_room_numbers (&w->room, nx * c->points), sum = 0;
  if (gs_search_bad (w))
    return 0;
  gs_costates (s, l);
  for (int q = c->first; q < c->points; q++)
    for (int j = 0; j < nx; j++)
      sum += fabs (l[nx * q + j] * gs_rate_at (c, j, q));
  return sum / (c->points - c->first) * gs_whole_duration (s);
}

/* less one interval where another arc begins; the weight is a share of the size of the
 * Hamiltonian's parts by the square of the input's width */
gs_smooth_arc *
gs_smooth_arcs (gs_search *w, const gs_solution *s, int n, gs_singular_arc *arcs)
{
  const gs_program *c = s->c;
  const int last = c->intervals - 1;
  gs_smooth_arc *smooth = (gs_smooth_arc *)gs_room_take (&w->room, n, sizeof *smooth);
  const double size = size_of_goal (w, s), whole = gs_whole_duration (s);
  for (int i = 0; ! gs_search_bad (w) && i < n; i++)
    {
      const double width = gs_input_width (s, arcs[i].input);
      double a = (arcs[i].from - s->t[0]) / whole, b = (arcs[i].until - s->t[0]) / whole;
      int k = 0, l = last;
      while (k < last && s->at[gs_stage (c, k, 2)] < a)
        k++;
      a = a <= s->at[gs_stage (c, 0, 2)] ? 0 : s->at[gs_stage (c, k, 2)];
      while (l > 0 && s->at[gs_left (c, l)] > b)
        l--;
      b = b < s->at[gs_left (c, last)] ? s->at[gs_left (c, l)] : b;
      arcs[i].weight = w->o->regularize * size / (width * width);
      smooth[i] = (gs_smooth_arc){ arcs[i].input, a, b, arcs[i].weight };
    }
  return smooth;
}
