/* One run of an ensemble: its arrays, its start, by whom it is made. */
#include "host/ensemble/member.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/arith.h"
#include "gsmbp/plan.h"

/* n numbers that nobody has written yet */
static gs_real *
room (size_t n)
{
  return malloc ((n + 1) * sizeof (gs_real));
}

int
gs_make_member (const gs_ensemble *e, gs_member *m)
{
  const gs_integration *all = &e->run;
  const size_t nt = (size_t)all->nt;
  memset (m, 0, sizeof *m);
  m->run = *all;
  m->cst = room ((size_t)e->ncst);
  m->x0 = room ((size_t)all->nx);
  m->values = room ((size_t)e->npar);
  m->par = malloc (((size_t)e->npar + 1) * sizeof (double));
  m->run.xout = room ((size_t)all->ldx * nt);
  m->run.vout = room ((size_t)all->ldv * nt);
  m->run.w = room ((size_t)all->lw);
  m->run.rp = room (e->reals);
  m->run.ip = malloc ((e->wholes + 1) * sizeof (int));
  if (m->cst && m->x0 && m->values && m->par && m->run.xout && m->run.vout && m->run.w && m->run.rp
      && m->run.ip)
    return 0;
  gs_free_member (m);
  return GS_OUT_OF_MEMORY;
}

void
gs_free_member (gs_member *m)
{
  void *all[] = { m->cst, m->x0, m->values, m->par, m->run.xout, m->run.vout, m->run.w, m->run.rp,
                  m->run.ip };
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++)
    free (all[k]);
  memset (m, 0, sizeof *m);
}

static gs_real
entry (const gs_table *t, int i, int k)
{
  return t->x[i * t->row + k * t->column];
}

/* constants from the parameters of the run; info of pre */
static int
constants (const gs_ensemble *e, const gs_rows *rows, const gs_known_row *known, gs_member *m)
{
  gs_copy (e->npar, rows->par, m->values);
  for (int k = 0; rows->table.x && k < rows->varied; k++)
    m->values[rows->which[k] - 1] = entry (&rows->table, known->row, k);
  for (int k = 0; k < e->npar; k++)
    m->par[k] = (double)m->values[k];
  if (! rows->table.x || known->cst)
    gs_copy (e->ncst, known->cst ? known->cst : e->run.cst, m->cst);
  if (! rows->table.x || known->cst)
    return known->cst ? known->info : 0;
  return e->pre (m->values, m->cst);
}

/* The plan from which the run begins. The record of its events, of which nothing is read before it
 * is written, stays as it is: it takes most of the room, and the time of a short run. */
static void
take_plan (const gs_ensemble *e, gs_member *m)
{
  gs_integration *r = &m->run;
  const gs_real *from = e->run.rp;
  memcpy (r->ip, e->run.ip, e->wholes * sizeof (int));
  size_t first = e->reals, next = e->reals;
  if (r->ip[GS_EVENTS] > 0)
    {
      const gs_events a = gs_planned_events (r->nx, r->ip, r->rp);
      first = (size_t)(a.record - r->rp);
      next = (size_t)(a.level - r->rp);
    }
  memcpy (r->rp, from, first * sizeof (gs_real));
  memcpy (r->rp + next, from + next, (e->reals - next) * sizeof (gs_real));
}

/* as before its first step: constants, start, plan, inputs are set, outputs are none */
static void
empty (const gs_ensemble *e, gs_member *m)
{
  gs_integration *r = &m->run;
  const gs_integration *all = &e->run;
  memset (r->istat, 0, sizeof r->istat);
  memset (r->rstat, 0, sizeof r->rstat);
  for (ptrdiff_t k = 0; k < (ptrdiff_t)all->ldx * all->nt; k++)
    r->xout[k] = NAN;   /* where a run is left */
  memset (r->vout, 0, (size_t)all->ldv * (size_t)all->nt * sizeof (gs_real));
  gs_zero (all->lw, r->w);
  r->last.h = 0;
  r->rstat[GS_T_REACHED] = all->t0;
  r->cst = m->cst;
  r->x0 = m->x0;
  m->info = 0;
  m->pre = 0;
  m->begun = 0;
  m->text[0] = 0;
}

/* a start that is refused ends the run as a routine that fails, with a verdict */
static int
refused (gs_member *m, const gs_start *start)
{
  m->info = start->verdict == GS_START_NO_MEMORY ? GS_OUT_OF_MEMORY : GS_ROUTINE_FAILED;
  m->run.istat[GS_FAILED_INFO] = start->verdict;
  m->run.istat[GS_FAILED] = GS_BEFORE_START;
  snprintf (m->text, sizeof m->text, "%s", start->text);
  return 0;
}

/* the state x0 of the run onto the constraints; 0: refused */
static int
take_start (const gs_ensemble *e, gs_member *m)
{
  gs_integration *r = &m->run;
  gs_start_given g = { .t = r->t0, .cst = m->cst, .par = m->par, .check = e->check };
  gs_start start;
  if (e->run.ip[GS_EVENTS] > 0)
    {
      const gs_events a = gs_planned_events (r->nx, e->run.ip, e->run.rp);
      g.modes = a.given ? a.mode : NULL;
    }
  if (gs_take_start (e->about, &g, m->x0, &start) != GS_START_TAKEN)
    return refused (m, &start);
  return 1;
}

/* the first samples, and inputs of its own */
static int
take_inputs (const gs_ensemble *e, const gs_rows *rows, gs_member *m)
{
  gs_integration *r = &m->run;
  gs_start start;
  if (e->scene->nctl > 0
      && gs_check_samples (e->about, r->t0, m->cst, r->ip, r->rp, &start) != GS_START_TAKEN)
    return refused (m, &start);
  gs_real *constant = r->rp + r->ip[GS_TABLE + 3] - 1;
  for (int k = 0; k < e->scene->nv && rows->inputs.x; k++)
    constant[k] = entry (&rows->inputs, m->row, k);
  return 1;
}

int
gs_begin_member (const gs_ensemble *e, const gs_rows *rows, const gs_known_row *known,
                 gs_member *m)
{
  const gs_integration *all = &e->run;
  const gs_scene *s = e->scene;
  m->row = known->row;
  empty (e, m);
  m->broken = rows->broken ? rows->broken[m->row] : NULL;
  if (m->broken)
    return 0;
  m->info = all->ask ? all->ask (all->asked, all->t0) : 0;
  if (m->info != 0)
    return 0;
  m->pre = constants (e, rows, known, m);
  if (m->pre != 0)
    return 0;
  gs_copy (all->nx, all->x0, m->x0);
  for (int k = 0; k < s->nx && rows->starts.x; k++)
    m->x0[k] = entry (&rows->starts, m->row, k);
  if (! take_start (e, m))
    return 0;
  take_plan (e, m);
  if (! take_inputs (e, rows, m))
    return 0;
  if (s->nq == s->nu)
    gs_copy (s->nu, m->x0, m->run.w);
  else if (e->guess)
    gs_copy (s->nu, e->guess, m->run.w);
  m->scene = *s;
  m->inputs = (gs_fortran_inputs){ .ip = m->run.ip, .rp = m->run.rp, .cst = m->cst };
  if (e->fortran_inputs)
    m->scene.data = &m->inputs;
  m->begun = 1;
  return 1;
}

/* resume: on from where gs_integrate found its steps bound by stability */
static void
by_implicit (const gs_ensemble *e, gs_member *m, int resume)
{
  gs_implicit o = *e->implicit;
  o.resume = resume;
  o.text = m->text;
  o.length = sizeof m->text;
  m->info = e->method (&m->scene, &m->run, &o);
}

void
gs_go_on (const gs_ensemble *e, gs_member *m)
{
  if (m->info == GS_STIFF && e->run.iopt[GS_METHOD] != 0 && e->method)
    by_implicit (e, m, 1);
}

void
gs_run_member (const gs_ensemble *e, gs_member *m)
{
  if (e->run.iopt[GS_METHOD] != 0)
    {
      m->info = gs_integrate (&m->scene, &m->run);
      gs_go_on (e, m);
    }
  else if (e->method)
    by_implicit (e, m, 0);
}
