/* gs_check_arguments: are the arguments of a run within their ranges? info is -i for the argument i
 * of gs_integrate,
 * -100-k for SIZ(k), -109 for ldx and -110 for ldv, which the Fortran does not have. */

#include "gsmbp/arith.h"
#include "gsmbp/functions.h"
#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"

static int
sizes (const gs_scene *s, const gs_integration *r)
{
  int info = 0;
  if (s->nq < 0)
    info = -101;
  if (s->nu < 0)
    info = -102;
  if (r->nx < gs_most (1, s->nq + s->nu))
    info = -103;
  if (s->nv < 0)
    info = -104;
  if (s->nlam < 0)
    info = -105;
  if (r->nt < 1)
    info = -106;
  if (r->nb < 0)
    info = -107;
  if (r->ldx < r->nx)
    info = -109;
  if (r->ldv < gs_most (1, s->nv))
    info = -110;
  if (r->lw < gs_room (s, r->nx, r->ip[GS_DERIVATIVES]))
    info = -108;
  return info;
}

static int
numbers (const gs_integration *r)
{
  const int method = r->iopt[GS_METHOD], way = r->iopt[GS_LOOPS];
  const gs_real *ropt = r->ropt;
  int info = 0;
  if (! (gs_abs (r->t0) <= GS_HUGE) || gs_not_finite (r->nt, r->tout) != 0
      || gs_not_finite (r->nb, r->tbrk) != 0)
    info = -13;
  if (gs_not_finite (r->nx, r->x0) != 0)
    info = -14;
  if ((method != 4 && method != 8 && method != 9) || way < 1 || way > 6)
    info = -15;
  if (method == 4 && ! (ropt[0] > 0))
    info = -16;
  if (method >= 8 && ! (ropt[1] > 0 && ropt[0] >= 0 && ropt[2] >= 0))
    info = -16;
  return info;
}

static int
rising (int n, const gs_real *t)
{
  for (int i = 1; i < n; i++)
    if (t[i] <= t[i - 1])
      return 0;
  return 1;
}

int
gs_check_arguments (const gs_scene *s, const gs_integration *r)
{
  int info = sizes (s, r);
  if (info == 0)
    info = numbers (r);
  if (info != 0)
    return info;
  const gs_real h = r->ropt[2] > 0 ? gs_min (r->ropt[0], r->ropt[2]) : r->ropt[0];
  if (r->iopt[GS_METHOD] == 4 && r->tout[r->nt - 1] - r->t0 > GS_R (2e9) * h)
    info = -16;
  if (r->tout[0] < r->t0 || ! rising (r->nt, r->tout) || ! rising (r->nb, r->tbrk))
    info = -13;
  for (int i = 0; i < r->nx && r->iopt[GS_METHOD] >= 8; i++)
    if (! (r->atol[i] >= 0))
      info = -16;
  return info;
}
