#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/system.h"

/* the arguments of gs_check_constraints, for its parts */
typedef struct
{
  const gs_scene *s;
  gs_real t, *x;
  const int *iopt;
  const gs_real *jump, *cst;
  gs_real *p;
  int *istat;
  gs_real *rstat;
  gs_partition a;
} check;

/* x by the partition. info as gs_check_constraints */
static int
complete (check *c)
{
  int info = 0;
  if (c->p[GS_WAY] > 0 && c->p[GS_DEPENDENT] < 0)
    {
      info = gs_partition_choose (c->s, c->t, c->x, c->cst, c->p);
      c->istat[GS_FAILED] = GS_AT_CON;
    }
  if (info == 0 && c->p[GS_WAY] > 1)
    {
      /* twice: the speeds then belong to the last position */
      info = gs_complete_state (c->s, c->t, c->x, c->cst, c->p);
      c->istat[GS_FAILED] = GS_AT_PARTITION;
      if (info == 0)
        info = gs_complete_state (c->s, c->t, c->x, c->cst, c->p);
    }
  return info;
}

/* x by the scene's projection */
static int
project (check *c)
{
  int info = c->s->prj (c->t, c->x, c->cst, c->a.phi);
  c->istat[GS_N_PROJECTIONS]++;
  c->istat[GS_FAILED] = GS_AT_PRJ;
  if (info != 0 && info != 2)
    return info;
  c->rstat[GS_R_BEFORE] = gs_max (c->rstat[GS_R_BEFORE], gs_abs (c->a.phi[0]));
  return 0;
}

/* whether x was moved farther than jump allows */
static int
jumped (check *c)
{
  int nq = c->s->nq, far = 0;
  for (int i = 0; i < nq + c->s->nu; i++)
    far |= ! (gs_abs (c->x[i] - c->a.before[i]) <= c->jump[i >= nq]);
  return far;
}

/* the constraints at x and what is left of them */
static int
drift (check *c)
{
  const gs_scene *s = c->s;
  gs_partition *a = &c->a;
  gs_real *x = c->x, big = 1, gap = 0, rate = 0;
  int info = s->con (c->t, x, x + s->nq, c->cst, a->phi, a->phit, a->hc, s->nlam, a->gam);
  c->istat[GS_FAILED] = GS_AT_CON;
  if (info != 0 && info != 2)
    return info;
  c->istat[GS_FAILED] = GS_AT_NOTHING;
  for (int i = 0; i < s->nq; i++)
    big = gs_max (big, gs_abs (x[i]));
  for (int i = 0; i < s->nlam; i++)
    {
      gs_real v = a->phit[i];
      for (int j = 0; j < s->nu; j++)
        v += a->hc[i + s->nlam * j] * x[s->nq + j];
      gap = gs_max (gap, gs_abs (a->phi[i]));
      rate = gs_max (rate, gs_abs (v));
    }
  if (c->iopt[GS_LOOPS] != 1 && ! (gap <= GS_R2 (1e-6, 1e-3) * big))
    {
      c->istat[GS_FAILED] = c->iopt[GS_LOOPS] == 3 ? GS_AT_PARTITION : GS_AT_PRJ;
      return 3;
    }
  if (gap > c->rstat[GS_R_PHI])
    {
      c->rstat[GS_R_PHI] = gap;
      c->rstat[GS_T_PHI] = c->t;
    }
  if (rate > c->rstat[GS_R_RATE])
    {
      c->rstat[GS_R_RATE] = rate;
      c->rstat[GS_T_RATE] = c->t;
    }
  return 0;
}

/* positions passed where the constraints lose rank; least: the least pivot now, on exit of the last
 * step, tmin: when */
static void
passages (check *c, gs_real *least, gs_real *tmin)
{
  gs_real s;
  gs_follow_pivot (c->s, c->t, c->x, c->cst, c->p, tmin, &s);
  if (s >= 0 && s < GS_R (0.01) * c->p[GS_LARGEST])
    {
      if (++c->istat[GS_N_PASSED] == 1)
        c->rstat[GS_T_PASSED] = *tmin;
      c->rstat[GS_T_PASSED_LAST] = *tmin;
    }
  if (s >= 0 && s < *least)
    *least = s;
}

/* rank and partition */
static int
rank_of (check *c)
{
  gs_real *p = c->p, least, tmin = c->t;
  int rank, change;
  gs_partition_rank (c->s, c->t, c->x, c->cst, p, &rank, &least, &change);
  c->istat[GS_N_PARTITIONS] += change;
  if ((gs_real)rank < p[GS_RANK])
    least = 0;
  if (least < c->jump[2] * p[GS_LARGEST])
    {
      c->istat[GS_FAILED] = GS_AT_PRJ;
      return 4;
    }
  p[GS_RANK] = gs_max (p[GS_RANK], (gs_real)rank);
  p[GS_PIVOT] = least;
  p[GS_LARGEST] = gs_max (p[GS_LARGEST], least);
  if (c->iopt[GS_METHOD] == 4 && c->iopt[GS_WATCH] == 1 && least < GS_R (0.01) * p[GS_LARGEST])
    c->istat[GS_N_LOOSE]++;
  if (c->iopt[GS_WATCH] == 1)
    passages (c, &least, &tmin);
  if (least < c->rstat[GS_R_PIVOT])
    {
      c->rstat[GS_R_PIVOT] = least;
      c->rstat[GS_T_PIVOT] = tmin;
    }
  return 0;
}

/* onto the constraints */
static int
move (check *c)
{
  const gs_scene *s = c->s;
  gs_copy (s->nq + s->nu, c->x, c->a.before);
  int way = c->iopt[GS_LOOPS], info = complete (c);
  if (info == 0 && way != 1 && (way != 3 || s->nq > s->nu))
    info = project (c);
  if (info == 0 && c->jump[0] > 0 && way != 1 && jumped (c))
    info = 3;
  if (info == 0)
    c->istat[GS_FAILED] = GS_AT_NOTHING;
  return info;
}

/* everything but the note of a failure */
static int
run (check *c)
{
  const gs_scene *s = c->s;
  int way = c->iopt[GS_LOOPS], info = move (c);
  if (info != 0)
    return info;
  if (s->nlam == 0 || (c->iopt[GS_DRIFT] != 1 && way != 3 && way != 6))
    return 0;
  info = drift (c);
  return info != 0 ? info : rank_of (c);
}

/* the note of a failure of PART */
static int
noted (int (*part) (check *), const gs_scene *s, gs_real t, gs_real *x, const int *iopt,
       const gs_real *jump, const gs_real *cst, gs_real *p, int *istat, gs_real *rstat)
{
  if (s->nlam == 0 && s->nq == s->nu)
    return 0;
  check c = { s, t, x, iopt, jump, cst, p, istat, rstat,
              gs_partition_of (s->nq, s->nu, s->nlam, p) };
  int info = part (&c);
  if (info != 0)
    istat[GS_FAILED_INFO] = info;
  return info;
}

/* Not fulfilled are constraints of which more than 1e-6 of the largest coordinate (or of 1) is
 * left. */
int
gs_check_constraints (const gs_scene *s, gs_real t, gs_real *x, const int *iopt,
                      const gs_real *jump, const gs_real *cst, gs_real *p, int *istat,
                      gs_real *rstat)
{
  return noted (run, s, t, x, iopt, jump, cst, p, istat, rstat);
}

int
gs_move_onto (const gs_scene *s, gs_real t, gs_real *x, const int *iopt, const gs_real *jump,
              const gs_real *cst, gs_real *p, int *istat, gs_real *rstat)
{
  return noted (move, s, t, x, iopt, jump, cst, p, istat, rstat);
}
