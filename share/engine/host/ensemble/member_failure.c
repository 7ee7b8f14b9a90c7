/* Why a run of an ensemble failed. */
#include <stdio.h>

#include "gsmbp/plan.h"
#include "host/ensemble/ensemble.h"
#include "host/failure.h"

int
gs_member_is_done (const gs_member *m)
{
  return m->begun && (m->info == GS_DONE || m->info == GS_ENDED);
}

/* its parameters have no constants */
static void
no_constants (const gs_ensemble *e, const gs_member *m, char *text, int size)
{
  int istat[GS_COUNTED] = { 0 };
  istat[GS_FAILED] = GS_AT_PRE;
  istat[GS_FAILED_INFO] = m->pre;
  const gs_failed_run failed = { .d = e->about, .istat = istat };
  const int said = snprintf (text, (size_t)size, "its parameters cannot be: ");
  gs_cause (&failed, text + said, size - said);
}

/* which of the given modes contradicts the state x */
static void
wrong_mode (const gs_ensemble *e, const gs_member *m, const gs_real *x, char *text, int size)
{
  const gs_events a = gs_planned_events (m->run.nx, e->run.ip, e->run.rp);
  const gs_start_given g = { .t = m->run.t0, .cst = m->cst, .par = m->par,
                             .modes = a.given ? a.mode : NULL };
  const int said = snprintf (text, (size_t)size, "option modes: ");
  gs_wrong_mode (e->about, &g, x, m->run.istat[GS_CAUSE] - 1, text + said, size - said);
}

/* it ended before its time, in the state after its rows */
static void
ended_early (const gs_ensemble *e, const gs_member *m, char *text, int size)
{
  const gs_integration *r = &m->run;
  const int k = r->istat[GS_N_OUTPUTS];
  gs_failed_run failed = { .d = e->about, .info = m->info, .istat = r->istat, .said = m->text,
                           .t = (double)r->rstat[GS_T_REACHED], .cst = m->cst, .par = m->par };
  if (k < r->nt)
    {
      failed.x = r->xout + (ptrdiff_t)r->ldx * k;
      failed.v = r->vout + (ptrdiff_t)r->ldv * k;
    }
  if (failed.x && m->info == GS_ROUTINE_FAILED && r->istat[GS_FAILED] == GS_AT_EVENT
      && r->istat[GS_FAILED_INFO] == GS_WRONG_MODE)
    wrong_mode (e, m, failed.x, text, size);
  else
    gs_failure (&failed, text, size);
}

void
gs_member_failure (const gs_ensemble *e, const gs_member *m, char *text, int size)
{
  text[0] = 0;
  if (m->broken)
    snprintf (text, (size_t)size, "%s", m->broken);
  else if (m->pre != 0)
    no_constants (e, m, text, size);
  else if (! m->begun && m->info == GS_INTERRUPTED)
    snprintf (text, (size_t)size, "not begun: interrupted by Ctrl-C");
  else if (! m->begun && m->info == GS_TIMED_OUT)
    snprintf (text, (size_t)size, "not begun: ended by option timeout");
  else if (! gs_member_is_done (m))
    ended_early (e, m, text, size);
}
