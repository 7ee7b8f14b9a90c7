/* Small scenes with and without loops that C and Fortran both call. */
#ifndef CHAINS_H
#define CHAINS_H

#include "compare.h"
#include "gsmbp/scene.h"

enum { MOST = 5 };

/* cst: a length; con fails from cst[1] on, loses rank from cst[2] on; prj fails from cst[3] on */
typedef void phi_function (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi,
                           gs_real *phit, gs_real *dq);

/* ------------------------------------------------------------
 * scenes: phi, its rate and its derivatives dq (nlam,nq) */

/* a point on a circle */
static void
circle (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi, gs_real *phit, gs_real *dq)
{
  (void)t;
  phi[0] = q[0] * q[0] + q[1] * q[1] - cst[0] * cst[0];
  phit[0] = 0.0;
  dq[0] = 2 * q[0];
  dq[1] = 2 * q[1];
}

/* four bars, of which the long ones are 2 and cst[0]: a parallelogram or nearly one */
static void
four_bar (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi, gs_real *phit, gs_real *dq)
{
  const gs_real length[] = { 1.0, cst[0], -1.0 };
  (void)t;
  phi[0] = -2.0;
  phi[1] = 0.0;
  phit[0] = phit[1] = 0.0;
  for (int i = 0; i < 3; i++)
    {
      phi[0] += length[i] * gs_cos (q[i]);
      phi[1] += length[i] * gs_sin (q[i]);
      dq[2 * i] = -length[i] * gs_sin (q[i]);
      dq[1 + 2 * i] = length[i] * gs_cos (q[i]);
    }
}

/* a blade x, y, angle, slide on moving ground: one constraint twice, its row 2 on speeds alone */
static void
blade (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi, gs_real *phit, gs_real *dq)
{
  memset (dq, 0, 12 * sizeof *dq);
  phi[0] = q[1] - cst[0] * gs_sin (q[3]) - 0.1 * t;
  phi[1] = 0.0;
  phi[2] = 3.0 * phi[0];
  phit[0] = -0.1;
  phit[1] = 0.0;
  phit[2] = -0.3;
  dq[0 + 3] = 1.0;
  dq[0 + 9] = -cst[0] * gs_cos (q[3]);
  dq[1 + 0] = gs_sin (q[2]);
  dq[1 + 3] = -gs_cos (q[2]);
  dq[2 + 3] = 3.0;
  dq[2 + 9] = -3.0 * cst[0] * gs_cos (q[3]);
}

/* Euler parameters and a slide: one direction cosine follows the slide */
static void
body (gs_real t, const gs_real *q, const gs_real *cst, gs_real *phi, gs_real *phit, gs_real *dq)
{
  (void)t;
  phi[0] = 2 * (q[1] * q[3] + q[0] * q[2]) - cst[0] * gs_sin (q[4]);
  phit[0] = 0.0;
  dq[0] = 2 * q[2];
  dq[1] = 2 * q[3];
  dq[2] = 2 * q[0];
  dq[3] = 2 * q[1];
  dq[4] = -cst[0] * gs_cos (q[4]);
}

static const gs_scene *scene;   /* what the routines below belong to */
static phi_function *phi_of;

/* qdot = u, or Euler parameters by angular speeds in the body */
static void
kin (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  int turning = scene->nq - scene->nu;
  (void)t;
  (void)cst;
  if (turning)
    {
      qdot[0] = 0.5 * (-q[1] * u[0] - q[2] * u[1] - q[3] * u[2]);
      qdot[1] = 0.5 * (q[0] * u[0] - q[3] * u[1] + q[2] * u[2]);
      qdot[2] = 0.5 * (q[3] * u[0] + q[0] * u[1] - q[1] * u[2]);
      qdot[3] = 0.5 * (-q[2] * u[0] + q[1] * u[1] + q[0] * u[2]);
    }
  for (int i = turning ? 4 : 0; i < scene->nq; i++)
    qdot[i] = u[i - turning];
}

static int
con (gs_real t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi, gs_real *phit,
     gs_real *hc, int ldh, gs_real *gam)
{
  gs_real dq[MOST * MOST], unit[MOST] = { 0 }, qdot[MOST];
  if (t >= cst[1])
    return 1;
  phi_of (t, q, cst, phi, phit, dq);
  for (int j = 0; j < scene->nu; j++)
    {
      unit[j] = 1.0;
      kin (t, q, unit, cst, qdot);
      unit[j] = 0.0;
      for (int i = 0; i < scene->nlam; i++)
        {
          hc[i + ldh * j] = 0.0;
          for (int k = 0; k < scene->nq; k++)
            hc[i + ldh * j] += dq[i + scene->nlam * k] * qdot[k];
        }
    }
  for (int i = 0; i < scene->nlam; i++)
    gam[i] = u[i % scene->nu];
  return t >= cst[2] ? 2 : 0;
}

/* onto one constraint after the other */
static inline int
prj (gs_real t, gs_real *x, const gs_real *cst, gs_real *res)
{
  int nq = scene->nq, nu = scene->nu, nlam = scene->nlam;
  gs_real phi[MOST], phit[MOST], hc[MOST * MOST], gam[MOST], du[MOST], qdot[MOST], s = 0.0;
  gs_real most = 0.0;
  if (t >= cst[3])
    return 5;
  for (int k = 0; k < 60 * nlam; k++)
    {
      int i = k % nlam;
      gs_real h2 = 0.0, gap;
      if (con (t, x, x + nq, cst, phi, phit, hc, nlam, gam) == 1)
        return 1;
      if (k < nlam)
        most = gs_abs (phi[i]) > most ? gs_abs (phi[i]) : most;
      gap = -phit[i];
      for (int j = 0; j < nu; j++)
        {
          h2 += hc[i + nlam * j] * hc[i + nlam * j];
          gap -= hc[i + nlam * j] * x[nq + j];
        }
      if (h2 == 0.0)
        continue;
      for (int j = 0; j < nu; j++)
        {
          du[j] = -phi[i] * hc[i + nlam * j] / h2;
          x[nq + j] += gap * hc[i + nlam * j] / h2;
        }
      kin (t, x, du, cst, qdot);
      for (int j = 0; j < nq; j++)
        x[j] += qdot[j];
    }
  if (nq > nu)
    {
      for (int i = 0; i < 4; i++)
        s += x[i] * x[i];
      for (int i = 0; i < 4; i++)
        x[i] /= gs_sqrt (s);
    }
  *res = most;
  return 0;
}

/* the same as Fortran calls them */
static void
con_ (const gs_real *t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *phi,
      gs_real *phit, gs_real *hc, const int *ldh, gs_real *gam, int *info)
{
  *info = con (*t, q, u, cst, phi, phit, hc, *ldh, gam);
}

static inline void
kin_ (const gs_real *t, const gs_real *q, const gs_real *u, const gs_real *cst, gs_real *qdot)
{
  kin (*t, q, u, cst, qdot);
}

static inline void
prj_ (const gs_real *t, gs_real *x, const gs_real *cst, gs_real *res, int *info)
{
  *info = prj (*t, x, cst, res);
}

static const struct
{
  const char *what;
  phi_function *phi;
  int nq, nu, nlam, alone;
  gs_real length, x[2 * MOST];
} list[] = {
  { "circle", circle, 2, 2, 1, 0, 1.3, { 1.3, 0.0, 0.0, 1.0 } },
  { "parallelogram", four_bar, 3, 3, 2, 0, 2.0, { -0.8, 0.0, -0.8, 1.0, 0.0, 1.0 } },
  { "four bars", four_bar, 3, 3, 2, 0, 2.01, { -0.8, 0.05, -0.8, 1.0, 0.0, 1.0 } },
  { "blade", blade, 4, 4, 3, 1, 0.7, { 0.1, 0.0, 0.4, 0.0, 0.3, 0.2, 0.8, 0.1 } },
  { "body", body, 5, 4, 1, 0, 0.9, { 0.8, 0.3, 0.4, 0.33, 0.1, 0.7, 0.9, -0.4, 1.1 } },
  { "free body", body, 4, 3, 0, 0, 0.9, { 0.8, 0.3, 0.4, 0.3, 0.7, 0.9, -0.4 } },
  { "free point", circle, 2, 2, 0, 0, 1.3, { 0.3, 0.2, 0.4, 1.0 } },
};
enum { SCENES = sizeof list / sizeof *list };

static inline gs_scene
scene_of (int k)
{
  gs_scene s = { .name = list[k].what, .nq = list[k].nq, .nu = list[k].nu,
                 .nx = list[k].nq + list[k].nu, .nlam = list[k].nlam,
                 .con = con, .kin = kin, .prj = prj };
  return s;
}

#endif
