/* collocate.c: an optimal motion on finer and finer meshes; inputs that jump, singular arcs. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gsmbp/failures.h"
#include "host/collocation/collocation_parts.h"

static void
report_mesh (const gs_solution *s, gs_found *f)
{
  gs_mesh_report *one = f->meshes + f->nmeshes++;
  *one = (gs_mesh_report){ s->mesh.n, s->r.iterations, s->error, "" };
  snprintf (one->ended, sizeof one->ended, "%s", s->r.ended);
}

/* solved, its errors, the bounds that hold it back; of one that was stopped only where it is the
 * first: else the mesh before is given back */
static gs_solution *
one_mesh (gs_search *w, const gs_motion_problem *p, const gs_mesh *mesh, const gs_guess *guess,
          gs_found *f)
{
  gs_solution *s = gs_solve_mesh (w, p, mesh, guess);
  if (! s || (s->stopped && f->nmeshes > 0))
    return s;
  gs_mesh_errors (w, s);
  f->nactive = gs_active_bounds (w, s, &f->active);
  report_mesh (s, f);
  return s;
}

/* singular arcs: solved again where the inputs there were not yet made smooth; p: with these */
static gs_solution *
made_smooth (gs_search *w, gs_motion_problem *p, const gs_mesh *mesh, gs_solution *s, gs_found *f)
{
  const int again = p->narcs == 0;
  f->narcs = gs_singular_arcs (w, s, &f->arcs);
  p->narcs = f->narcs;
  if (f->narcs == 0 || gs_search_bad (w))
    return s;
  p->arcs = gs_smooth_arcs (w, s, f->narcs, f->arcs);
  if (! again || ! (w->o->regularize > 0) || gs_search_bad (w))
    return s;
  const gs_guess guess = gs_guess_of (s);
  gs_solution *new = one_mesh (w, p, mesh, &guess, f);
  if (! new)
    return s;
  const int stopped = new->stopped;
  if (new->r.solved)
    s = new;
  s->stopped = stopped;
  return s;
}

/* solved on a mesh, with what jumps or is singular there */
static gs_solution *
meshed (gs_search *w, gs_motion_problem *p, const gs_mesh *mesh, const gs_guess *guess, gs_found *f)
{
  int stopped;
  gs_solution *s = one_mesh (w, p, mesh, guess, f);
  if (! s || s->stopped)
    return s;
  gs_solution *polished = gs_polish (w, s, &f->switches, &f->nswitches, &stopped);
  if (polished)
    {
      f->nactive = gs_active_bounds (w, polished, &f->active);
      report_mesh (polished, f);
      return polished;
    }
  if (! stopped && ! gs_search_bad (w))
    return made_smooth (w, p, mesh, s, f);
  s->stopped = stopped;
  return s;
}

static gs_mesh
first_mesh (gs_search *w)
{
  const int n = w->o->intervals;
  int *phase = gs_room_places (&w->room, n);
  double *begin = gs_room_numbers (&w->room, n), *end = gs_room_numbers (&w->room, n);
  for (int k = 0; ! gs_search_bad (w) && k < n; k++)
    {
      begin[k] = (double)k / n;
      end[k] = (double)(k + 1) / n;
    }
  return (gs_mesh){ w->o->method, n, phase, begin, end };
}

/* what is given back where the search was ended from outside: the mesh before, if any */
static gs_solution *
so_far (gs_solution *s, gs_solution *before, gs_motion *r)
{
  gs_solution *given = before ? before : s;
  r->stopped = s->stopped;
  given->r.solved = 0;
  snprintf (given->r.ended, sizeof given->r.ended, "%s",
            r->stopped == GS_TIMED_OUT ? "ended by option timeout" : "interrupted by Ctrl-C");
  return given;
}

static gs_solution *
refined (gs_search *w, const gs_motion_guess *given, gs_found *found, gs_motion *r)
{
  gs_motion_problem p = *w->p;
  gs_mesh mesh = first_mesh (w);
  gs_guess guess = gs_first_guess (w, given);
  gs_solution *before = NULL, *s = NULL;
  found->meshes
      = (gs_mesh_report *)gs_room_take (&w->room, 3 * (w->o->refinements + 1),
                                        sizeof *found->meshes);
  for (int k = 0; k <= w->o->refinements && ! gs_search_bad (w); k++)
    {
      gs_found now = *found;
      s = meshed (w, &p, &mesh, &guess, &now);
      if (! s || gs_search_bad (w))
        return NULL;
      if (! s->stopped || ! before)
        *found = now;
      if (s->stopped)
        {
          s = so_far (s, before, r);
          break;
        }
      if (found->nswitches > 0 || ! s->r.solved || s->error <= w->o->accuracy)
        break;
      if (k < w->o->refinements)
        mesh = gs_finer_mesh (w, s);
      before = s;
      guess = gs_guess_of (s);
    }
  return s;
}

int
gs_collocate (const gs_description *d, const gs_motion_problem *p, const gs_motion_guess *guess,
              const gs_motion_options *o, gs_motion *r)
{
  gs_motion_problem own = *p;
  gs_search w = { .d = d, .p = &own, .o = o, .began = gs_wall_clock () };
  gs_found found = { 0 };
  memset (r, 0, sizeof *r);
  gs_take_ends (&w, &own, guess);
  gs_solution *s = gs_search_bad (&w) ? NULL : refined (&w, guess, &found, r);
  if (s && ! gs_search_bad (&w))
    {
      r->solved = s->r.solved && s->error <= o->accuracy;
      gs_take_motion (&w, s, guess, &found, r);
      gs_say_end (&w, s, r);
    }
  if (gs_search_bad (&w))
    {
      gs_motion_free (r);
      snprintf (r->ended, sizeof r->ended, "%s", w.refused);
    }
  for (gs_solution *one = w.solutions; one; one = one->before)
    {
      gs_program_free (one->c);
      gs_room_free (&one->room);
    }
  gs_room_free (&w.room);
  return w.bad;
}
