/* held.c: rates where efforts of any size hold some speeds. */
#include "host/linear/linear_parts.h"

/* the mechanics at a state: mass matrix m, accelerations by efforts s (nu,nu); the constraints h,
 * its pseudo-inverse g (nu,nlam) */
typedef struct
{
  gs_work *w;
  const gs_real *x, *v;
  int nheld;
  const int *held;
  gs_real *m, *s, *h, *g;
  gs_real *by;      /* (nu,nheld): accelerations by the held efforts, */
  gs_real *inverse; /* (nheld,nheld): the efforts by the held accelerations, */
  gs_real *effort;  /* nheld: those that hold, */
  gs_real *added;   /* nu: the accelerations that they give */
} holding;

static int
room (holding *p)
{
  gs_work *w = p->w;
  const int n = w->s->nu, c = w->s->nlam;
  p->m = gs_numbers (w, n * n);
  p->s = gs_numbers (w, n * n);
  p->h = gs_numbers (w, c * n);
  p->g = gs_numbers (w, c * n);
  p->by = gs_numbers (w, n * p->nheld);
  p->inverse = gs_numbers (w, p->nheld * p->nheld);
  p->effort = gs_numbers (w, p->nheld);
  p->added = gs_numbers (w, n);
  return w->told->verdict;
}

/* s := N*inv (N'*M*N)*N', N (nu,f) what the constraints leave free */
static int
accelerations (holding *p)
{
  gs_work *w = p->w;
  const int n = w->s->nu;
  gs_real *free = gs_numbers (w, n * n), *turned = gs_numbers (w, n * n);
  gs_real *moved = gs_numbers (w, n * n), *small = gs_numbers (w, n * n);
  gs_real *inverse = gs_numbers (w, n * n);
  if (! free || ! turned || ! moved || ! small || ! inverse)
    return w->told->verdict;
  const int f = gs_null_space (w, w->s->nlam, n, p->h, GS_R (1e-9), free);
  for (int i = 0; i < n; i++)
    gs_put_row (f, free, n, i, turned + f * i, 1, 0);
  gs_product (n, n, f, p->m, free, moved);
  gs_product (f, n, f, turned, moved, small);
  gs_pseudo_inverse (w, f, f, small, GS_R (1e-15), inverse);
  gs_product (n, f, f, free, inverse, moved);
  gs_product (n, f, n, moved, turned, p->s);
  return w->told->verdict;
}

static int
mechanics (holding *p)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nu, c = s->nlam;
  gs_real *phi = gs_numbers (w, 3 * c);
  if (! phi || ! s->mas || ! s->lin)
    return phi ? gs_work_failed (w, GS_LINEAR_ABSENT, s->mas ? "lin" : "mas", 0)
               : w->told->verdict;
  s->mas (w->t, p->x, w->cst, p->m, n);
  if (c > 0)
    {
      const int info
          = s->con (w->t, p->x, p->x + s->nq, w->cst, phi, phi + c, p->h, c, phi + 2 * c);
      if (info != 0 && info != 2)
        return gs_work_failed (w, GS_LINEAR_FAILED, "con", info);
      gs_pseudo_inverse (w, c, n, p->h, GS_R (1e-13), p->g);
    }
  return accelerations (p);
}

/* how an effort is put against the accelerations that it would take */
static void
efforts (holding *p, const gs_real *xd)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nu, k = p->nheld;
  gs_real *square = gs_numbers (w, k * k), *rate = gs_numbers (w, k);
  if (! square || ! rate)
    return;
  for (int j = 0; j < k; j++)
    {
      gs_copy (n, p->s + n * p->held[2 * j + 1], p->by + n * j);
      rate[j] = -xd[s->nq + p->held[2 * j + 1]];
    }
  for (int i = 0; i < k; i++)
    gs_put_row (k, p->by, n, p->held[2 * i + 1], square, k, i);
  gs_pseudo_inverse (w, k, k, square, GS_R (1e-15), p->inverse);
  gs_product (k, k, 1, p->inverse, rate, p->effort);
  gs_product (n, k, 1, p->by, p->effort, p->added);
}

/* the rates of the constraints differentiated by the coordinates, dv (nlam,nq), at the speeds u */
static void
rate_rows (const holding *p, const gs_real *u, gs_real *x, gs_real *dp, gs_real *dv)
{
  const gs_scene *s = p->w->s;
  gs_copy (s->nx, p->x, x);
  gs_copy (s->nu, u, x + s->nq);
  s->tan (p->w->t, x, p->w->cst, dp, s->nlam, dv, s->nlam);
}

/* what the multipliers of the efforts have of the coordinates, out of r (nu,nq); up (nu,nq): how
 * the accelerations have to follow the constraints */
static void
follow_constraints (const holding *p, gs_real *r, gs_real *up)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nu, c = s->nlam;
  gs_real *x = gs_numbers (w, s->nx), *dp = gs_numbers (w, c * s->nq);
  gs_real *still = gs_numbers (w, c * s->nq), *dv = gs_numbers (w, c * s->nq);
  gs_real *left = gs_numbers (w, n), *lambda = gs_numbers (w, c), *u = gs_numbers (w, n);
  if (! x || ! dp || ! still || ! dv || ! left || ! lambda || ! u)
    return;
  gs_product (n, n, 1, p->m, p->added, left);
  for (int j = 0; j < p->nheld; j++)
    left[p->held[2 * j + 1]] -= p->effort[j];
  for (int i = 0; i < c; i++)
    lambda[i] = gs_dot (n, 0, p->g + n * i, left);
  rate_rows (p, u, x, dp, still);
  for (int k = 0; k < n; k++)
    {
      u[k] = 1;
      rate_rows (p, u, x, dp, dv);
      u[k] = 0;
      for (int j = 0; j < s->nq; j++)
        for (int i = 0; i < c; i++)
          r[k + n * j] -= lambda[i] * (dv[i + c * j] - still[i + c * j]);
    }
  rate_rows (p, p->added, x, dp, dv);
  for (int i = 0; i < c * s->nq; i++)
    dv[i] = still[i] - dv[i];
  gs_product (n, c, s->nq, p->g, dv, up);
}

/* the change of the added accelerations by the coordinates, into the rows of the speeds of a */
static void
add_change (const holding *p, gs_real *a)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nu;
  gs_real *m = gs_numbers (w, n * n), *b = gs_numbers (w, n * n), *u = gs_numbers (w, n);
  gs_real *r = gs_numbers (w, n * s->nq), *c = gs_numbers (w, n * s->nq);
  gs_real *up = gs_numbers (w, n * s->nq), *change = gs_numbers (w, n * s->nq);
  if (! m || ! b || ! u || ! r || ! c || ! up || ! change)
    return;
  s->lin (w->t, p->x, p->x + s->nq, p->added, p->v, w->cst, m, b, r, n);
  s->lin (w->t, p->x, p->x + s->nq, u, p->v, w->cst, m, b, c, n);
  gs_take (n * s->nq, 1, c, r);
  if (s->nlam > 0)
    {
      follow_constraints (p, r, up);
      gs_product (n, n, s->nq, p->m, up, change);
      gs_take (n * s->nq, -1, change, r);
    }
  gs_product (n, n, s->nq, p->s, r, change);
  for (int j = 0; j < s->nq; j++)
    for (int i = 0; i < n; i++)
      a[s->nq + i + s->nx * j] += up[i + n * j] - change[i + n * j];
}

/* a less the accelerations that the held efforts give */
static void
take_out (const holding *p, gs_real *a)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nu, k = p->nheld;
  gs_real *rows = gs_numbers (w, k * s->nx), *effort = gs_numbers (w, k * s->nx);
  gs_real *out = gs_numbers (w, n * s->nx);
  if (! rows || ! effort || ! out)
    return;
  for (int i = 0; i < k; i++)
    gs_put_row (s->nx, a, s->nx, s->nq + p->held[2 * i + 1], rows, k, i);
  gs_product (k, k, s->nx, p->inverse, rows, effort);
  gs_product (n, k, s->nx, p->by, effort, out);
  for (int j = 0; j < s->nx; j++)
    gs_take (n, 1, out + n * j, a + s->nq + s->nx * j);
}

int
gs_held_rates (gs_work *w, const gs_real *x, const gs_real *v, int nheld, const int *held,
                  gs_real *a, gs_real *xd)
{
  const gs_scene *s = w->s;
  gs_block *begin = w->blocks;
  holding p = { .w = w, .x = x, .v = v, .nheld = nheld, .held = held };
  int row, column, moves = 0;
  if (gs_jacobian_there (w, x, v, a, NULL, NULL, NULL) != 0
      || gs_rates_there (w, w->t, x, v, xd) != 0)
    return w->told->verdict;
  if (gs_first_not_finite (s->nx, s->nx, a, &row, &column))
    return gs_no_derivative (w, "rate of ", w->d->states[row], column);
  if (nheld > 0 && room (&p) == 0 && mechanics (&p) == 0)
    {
      efforts (&p, xd);
      for (int i = 0; i < s->nu; i++)
        moves |= p.added[i] != 0;
      if (moves)
        add_change (&p, a);
      take_out (&p, a);
      gs_take (s->nu, -1, p.added, xd + s->nq);
    }
  gs_work_back (w, begin);
  return w->told->verdict;
}
