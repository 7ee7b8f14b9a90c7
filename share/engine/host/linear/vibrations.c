/* vibrations.c: the matrix of small vibrations about a state, at rest or spinning. */
#include "gsmbp/functions.h"
#include "host/linear/linear_parts.h"

enum { TURNS = 30 };

typedef struct
{
  gs_work *w;
  const gs_vibrations_asked *asked;
  gs_vibrations *r;
  const gs_real *v;
  gs_real *whole, *xd; /* (nx,nx), nx: the held Jacobian and its rates */
} vibrating;

static int
jacobian_there (vibrating *p)
{
  gs_vibrations *r = p->r;
  if (gs_held_rates (p->w, r->x, p->v, p->asked->nheld, p->asked->held, p->whole, p->xd) != 0)
    return p->w->told->verdict;
  return gs_loop_tangent (p->w, r->x, NULL, 0, p->asked->nheld, p->asked->held, r->tangent,
                          r->independent, &r->n);
}

/* ------------------------------------------------------------------------------ steady states */

/* places among the independent states: z, those that are no speeds; f, those whose rates vanish */
static void
split (const vibrating *p, int *nz, int *z, int *nf, int *f)
{
  const gs_scene *s = p->w->s;
  *nz = *nf = 0;
  for (int i = 0; i < p->r->n; i++)
    {
      const int k = p->r->independent[i];
      if (k < s->nq || k >= s->nq + s->nu)
        z[(*nz)++] = i;
      if (k >= s->nq)
        f[(*nf)++] = i;
    }
}

/* j (nf,nz): the rates that shall vanish by the unknowns */
static void
slopes (const vibrating *p, int nz, const int *z, int nf, const int *f, gs_real *j)
{
  const int nx = p->w->s->nx;
  for (int c = 0; c < nz; c++)
    for (int i = 0; i < nf; i++)
      {
        gs_real sum = 0;
        for (int k = 0; k < nx; k++)
          sum += p->whole[p->r->independent[f[i]] + nx * k] * p->r->tangent[k + nx * z[c]];
        j[i + nf * c] = sum;
      }
}

/* the state onto the constraints; what is held stays where it is */
static int
close_state (vibrating *p)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const int n = s->nlam, k = p->asked->nheld, m = n + k;
  gs_free_velocities held = { k, 0, gs_places (w, k), gs_places (w, 1) };
  gs_real *phi = gs_numbers (w, 3 * n), *h = gs_numbers (w, n * s->nu);
  gs_real *a = gs_numbers (w, m * s->nu), *inverse = gs_numbers (w, s->nu * m);
  gs_real *b = gs_numbers (w, m), *u = gs_numbers (w, s->nu);
  if (n == 0 && s->nq == s->nu)
    return 0;
  if (! held.q || ! held.u || ! phi || ! h || ! a || ! inverse || ! b || ! u)
    return w->told->verdict;
  for (int i = 0; i < k; i++)
    held.q[i] = p->asked->held[2 * i];
  if (! gs_close_rest (w, &held, p->r->x))
    {
      gs_writer said = gs_work_refused (w, GS_LINEAR_REFUSED);
      gs_put (&said, "no steady state found near this one: the loops do not close there");
      return w->told->verdict;
    }
  if (n > 0)
    s->con (w->t, p->r->x, p->r->x + s->nq, w->cst, phi, phi + n, h, n, phi + 2 * n);
  for (int i = 0; i < n; i++)
    {
      gs_put_row (s->nu, h, n, i, a, m, i);
      b[i] = phi[n + i];
      for (int j = 0; j < s->nu; j++)
        b[i] += h[i + n * j] * p->r->x[s->nq + j];
    }
  for (int i = 0; i < k; i++)
    a[n + i + m * p->asked->held[2 * i + 1]] = 1;
  gs_pseudo_inverse (w, m, s->nu, a, GS_R (1e-13), inverse);
  gs_product (s->nu, m, 1, inverse, b, u);
  gs_take (s->nu, 1, u, p->r->x + s->nq);
  return 0;
}

/* 1 where the rates f vanish beside what nominal deviations give */
static int
is_steady (const vibrating *p, int nz, const int *z, int nf, const int *f, const gs_real *j)
{
  const double *nominal = p->w->d->nominal;
  for (int i = 0; i < nf; i++)
    {
      const int k = p->r->independent[f[i]];
      gs_real scale = 0;
      for (int c = 0; c < nz; c++)
        scale += gs_abs (j[i + nf * c]) * (gs_real)nominal[p->r->independent[z[c]]];
      if (! (gs_abs (p->xd[k]) <= GS_R (1e-12) * gs_max (scale, (gs_real)nominal[k])))
        return 0;
    }
  return 1;
}

/* Newton's step of the state, speeds as they are; its largest part */
static gs_real
step (vibrating *p, int nz, const int *z, int nf, const int *f, gs_real *j)
{
  gs_work *w = p->w;
  const gs_scene *s = w->s;
  const double *nominal = w->d->nominal;
  gs_real *inverse = gs_numbers (w, nz * nf), *g = gs_numbers (w, nf), *dz = gs_numbers (w, nz);
  gs_real most = 0;
  if (! inverse || ! g || ! dz)
    return 0;
  for (int c = 0; c < nz; c++)
    for (int i = 0; i < nf; i++)
      j[i + nf * c] *= (gs_real)nominal[p->r->independent[z[c]]];
  for (int i = 0; i < nf; i++)
    g[i] = -p->xd[p->r->independent[f[i]]];
  gs_pseudo_inverse (w, nf, nz, j, (gs_real)gs_most (nz, nf) * gs_epsilon (), inverse);
  gs_product (nz, nf, 1, inverse, g, dz);
  for (int c = 0; c < nz; c++)
    {
      most = gs_max (most, gs_abs (dz[c]));
      dz[c] *= (gs_real)nominal[p->r->independent[z[c]]];
      for (int k = 0; k < s->nx; k++)
        if (k < s->nq || k >= s->nq + s->nu)
          p->r->x[k] += p->r->tangent[k + s->nx * z[c]] * dz[c];
    }
  return most;
}

static int
refuse_steady (vibrating *p, int nf, const int *f)
{
  const gs_description *d = p->w->d;
  int worst = p->r->independent[f[0]];
  for (int i = 1; i < nf; i++)
    {
      const int k = p->r->independent[f[i]];
      if (gs_abs (p->xd[k]) / (gs_real)d->nominal[k]
          > gs_abs (p->xd[worst]) / (gs_real)d->nominal[worst])
        worst = k;
    }
  gs_writer said = gs_work_refused (p->w, GS_LINEAR_REFUSED);
  gs_put (&said, "no steady state found near this one: %s still changes by %g a second",
          d->states[worst], (double)p->xd[worst]);
  return p->w->told->verdict;
}

/* the state moved to where nothing but what is held moves at other than constant speed */
static int
find_steady (vibrating *p)
{
  gs_work *w = p->w;
  int *z = gs_places (w, w->s->nx), *f = gs_places (w, w->s->nx), nz = 0, nf = 0;
  gs_real *j = gs_numbers (w, w->s->nx * w->s->nx);
  if (! z || ! f || ! j)
    return w->told->verdict;
  for (int turn = 0; turn < TURNS; turn++)
    {
      gs_block *begin = w->blocks;
      if (jacobian_there (p) != 0)
        return w->told->verdict;
      split (p, &nz, z, &nf, f);
      slopes (p, nz, z, nf, f, j);
      if (is_steady (p, nz, z, nf, f, j))
        return 0;
      const gs_real most = step (p, nz, z, nf, f, j);
      if (close_state (p) != 0 || most <= GS_R (1e-12))
        return w->told->verdict;
      gs_work_back (w, begin);
    }
  return refuse_steady (p, nf, f);
}

/* ------------------------------------------------------------------------------- the matrix */

/* the largest of the accelerations beside what a deviation of nominal magnitude gives; a (n,n) */
static void
doubt (const vibrating *p, const gs_real *a)
{
  const gs_scene *s = p->w->s;
  const double *nominal = p->w->d->nominal;
  gs_vibrations *r = p->r;
  gs_real most = 1;
  gs_writer said = { r->doubt, sizeof r->doubt, 0 };
  int worst = -1;
  r->doubt[0] = '\0';
  for (int i = 0; i < r->n; i++)
    {
      const int k = r->independent[i];
      gs_real limit = 0;
      if (k < s->nq || k >= s->nq + s->nu)
        continue;
      for (int j = 0; j < r->n; j++)
        limit += gs_abs (a[i + r->n * j]) * (gs_real)nominal[r->independent[j]];
      limit = GS_R (1e-6) * gs_max (limit, (gs_real)nominal[k]);
      if (gs_abs (p->xd[k]) / limit > most)
        {
          most = gs_abs (p->xd[k]) / limit;
          worst = k;
        }
    }
  if (worst < 0)
    return;
  gs_put (&said, "%s with an acceleration of %.3g ", p->w->d->states[worst],
          (double)p->xd[worst]);
  gs_put_rate_unit (p->w, worst, &said);
}

/* a in nominal magnitudes; entries below the rounding of the largest one of their row are zero:
 * balancing would enlarge them */
static void
scale (const vibrating *p)
{
  const double *nominal = p->w->d->nominal;
  gs_vibrations *r = p->r;
  const int n = r->n;
  for (int i = 0; i < n; i++)
    {
      gs_real most = 0;
      for (int j = 0; j < n; j++)
        {
          r->a[i + n * j] *= (gs_real)(nominal[r->independent[j]] / nominal[r->independent[i]]);
          most = gs_max (most, gs_abs (r->a[i + n * j]));
        }
      for (int j = 0; j < n; j++)
        if (gs_abs (r->a[i + n * j]) < GS_R (1e-17) * most)
          r->a[i + n * j] = 0;
    }
}

/* the states on which something depends, and their part of a */
static void
keep (gs_vibrations *r)
{
  const int n = r->n;
  r->nfelt = 0;
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++)
      if (r->a[i + n * j] != 0)
        {
          r->felt[r->nfelt++] = j;
          break;
        }
  for (int j = 0; j < r->nfelt; j++)
    for (int i = 0; i < r->nfelt; i++)
      r->square[i + r->nfelt * j] = r->a[r->felt[i] + n * r->felt[j]];
}

int
gs_vibrate (const gs_description *d, const gs_linear_place *at, const gs_vibrations_asked *asked,
            gs_vibrations *r, gs_linear_told *told)
{
  gs_work w = gs_work_begin (d, at, told);
  const int nx = d->scene->nx;
  vibrating p = { &w, asked, r, at->v, gs_numbers (&w, nx * nx), gs_numbers (&w, nx) };
  gs_real *rows = gs_numbers (&w, nx * nx);
  gs_copy (nx, at->x, r->x);
  r->n = r->nfelt = 0;
  if (p.whole && p.xd && rows && (! asked->steady || find_steady (&p) == 0)
      && jacobian_there (&p) == 0)
    {
      for (int i = 0; i < r->n; i++)
        gs_put_row (nx, p.whole, nx, r->independent[i], rows, r->n, i);
      gs_product (r->n, nx, r->n, rows, r->tangent, r->a);
      doubt (&p, r->a);
      scale (&p);
      keep (r);
    }
  return gs_work_end (&w);
}
