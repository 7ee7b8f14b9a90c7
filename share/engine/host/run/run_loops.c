/* run_loops.c: how the constraints of a run are kept; the routines that the run needs. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gsmbp/options.h"
#include "gsmbp/refusals.h"
#include "host/run/run_parts.h"
#include "host/text.h"

#define ROW_NUMBER(word, number) { #word, number },
static const struct { const char *word; int number; } ways[] = { GS_LOOP_METHODS (ROW_NUMBER) };

enum { WAYS = sizeof ways / sizeof *ways };

int
gs_lacks (gs_whole_run *w, int there, const char *what, const char *routine)
{
  char name[20] = "";
  for (size_t k = 0; k + 1 < sizeof name && routine[k]; k++)
    name[k] = (char)toupper ((unsigned char)routine[k]);
  return ! there && gs_refuse (w->r, GS_REFUSED_ROUTINE, routine, gs_refusals.routine, what, name,
                               w->d->scene->name);
}

/* ... that a way needs */
static int
way_lacks (gs_whole_run *w, int there, const char *way, const char *routine)
{
  char what[60];
  snprintf (what, sizeof what, "the way \"%s\"", way);
  return gs_lacks (w, there, what, routine);
}

/* the way where none is given: constraints and Euler parameters are projected where PRJ is there;
 * the steps of gauss are those of the independent coordinates alone */
static const char *
needed_way (const gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  const int euler = s->nq > s->nu;
  if (strcmp (w->o->method, "gauss") == 0 && s->nlam > 0 && ! euler && s->kin && s->con)
    return "partitioning";
  return s->prj && (s->nlam > 0 || euler) ? "projection" : "baumgarte";
}

static int
check_index2 (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  if (s->nlam == 0)
    return gs_refuse (w->r, GS_REFUSED_OPTION, "loops", gs_refusals.no_loops, s->name);
  if (strcmp (w->o->method, "radau") != 0 && strcmp (w->o->method, "auto") != 0)
    return gs_refuse (w->r, GS_REFUSED_OPTION, "loops", gs_refusals.index2_method, w->o->method);
  return way_lacks (w, s->mas != NULL, "index2", "mas")
         || way_lacks (w, s->con != NULL, "index2", "con")
         || way_lacks (w, s->tan != NULL, "index2", "tan");
}

static int
check_routines (gs_whole_run *w, int way)
{
  const gs_scene *s = w->d->scene;
  const int euler = s->nq > s->nu, splits = way == 3 || way == 6;
  const int projects = way > 1 && (way != 3 || euler || (s->nlam > 0 && w->by));
  const char *word = w->index2 ? "index2" : ways[way - 1].word;
  return gs_lacks (w, s->rhs != NULL, "the run", "rhs")
         || (splits && way_lacks (w, s->con != NULL, word, "con"))
         || (splits && way_lacks (w, s->kin != NULL, word, "kin"))
         || (projects && way_lacks (w, s->prj != NULL, word, "prj"))
         || (s->nctl > 0
             && (gs_lacks (w, s->ctl != NULL, "the run", "ctl")
                 || gs_lacks (w, s->ctp != NULL, "the run", "ctp")
                 || gs_lacks (w, s->ny == 0 || s->out, "the run", "out")))
         || (s->nev > 0
             && (gs_lacks (w, s->evt != NULL, "the run", "evt")
                 || gs_lacks (w, s->rst != NULL, "the run", "rst")));
}

gs_real
gs_wanted_loop_method (const gs_whole_run *w)
{
  const int way = w->iopt[GS_LOOPS];
  return way > 3 ? (gs_real)(way - 2) : 1;
}

/* a word that is none */
static int
refuse_word (gs_whole_run *w, const char *word)
{
  char all[200] = "";
  gs_writer list = { all, (int)sizeof all, 0 };
  for (int k = 0; k < WAYS; k++)
    gs_put (&list, k > 0 ? ", %s" : "%s", ways[k].word);
  return gs_refuse (w->r, GS_REFUSED_OPTION, "loops", gs_refusals.loops, all, word);
}

/* the constants with that parameter */
int
gs_set_loop_method (gs_whole_run *w)
{
  const gs_description *d = w->d;
  const double wanted = (double)gs_wanted_loop_method (w);
  memmove (w->r->cst, w->s->cst, (size_t)d->ncst * sizeof (gs_real));
  if (d->loop_method < 0 && wanted > 1)
    return gs_refuse (w->r, GS_REFUSED_OPTION, "loops", gs_refusals.no_loop_method,
                      d->scene->name);
  if (d->loop_method < 0 || ! w->s->par)
    return 0;
  const double found = w->s->par[d->loop_method];
  if (found >= wanted && found <= wanted)
    return 0;
  gs_real *par = malloc ((size_t)(d->npar + 1) * sizeof *par);
  for (int k = 0; par && k < d->npar; k++)
    par[k] = (gs_real)w->s->par[k];
  if (par)
    par[d->loop_method] = (gs_real)wanted;
  if (! par || ! d->pre || d->pre (par, w->r->cst) != 0)
    gs_refuse (w->r, GS_REFUSED_OPTION, "loops", "its parameter loop_method cannot be %g", wanted);
  free (par);
  return w->r->refused;
}

int
gs_choose_loops (gs_whole_run *w)
{
  const gs_scene *s = w->d->scene;
  const char *word = w->o->loops ? w->o->loops : needed_way (w);
  int k = 0;
  while (k < WAYS && strcmp (ways[k].word, word) != 0)
    k++;
  if (k == WAYS)
    return refuse_word (w, word);
  w->index2 = strcmp (word, "index2") == 0;
  int way = ways[k].number;
  if (w->index2 && check_index2 (w))
    return 1;
  if (s->nlam == 0)   /* nothing but Euler parameters to look after */
    way = way > 1 && s->nq > s->nu ? 2 : 1;
  const int watched = w->o->drift < 0 ? s->nlam > 0 && s->con : w->o->drift;
  w->iopt[GS_LOOPS] = way;
  w->iopt[GS_DRIFT] = watched;
  w->iopt[GS_WATCH] = watched && s->nlam > 0 && s->kin;
  w->iopt[GS_ON_SPEEDS] = w->d->nspeedrows;
  for (int i = 0; i < w->d->nspeedrows; i++)
    w->iopt[GS_ON_SPEEDS + 1 + i] = w->d->speedrows[i];
  if (w->o->drift > 0 && gs_lacks (w, s->con != NULL, "option drift", "con"))
    return 1;
  w->r->loop_method = (int)gs_wanted_loop_method (w);
  return check_routines (w, way);
}
