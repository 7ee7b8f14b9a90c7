/* failure.c: why a run ended, the one catalogue of these messages, for all hosts. */
#include <string.h>

#include "gsmbp/functions.h"
#include "host/failure.h"
#include "host/start.h"
#include "host/text.h"

/* by istat[GS_FAILED]: the routine, its name in a message */
static const struct { const char *name, *shown; } routines[] = {
  { "", "" }, { "cmd", "the inputs" }, { "rhs", "RHS" }, { "prj", "PRJ" }, { "con", "CON" },
  { "prj", "the computation of the dependent coordinates" },
  { "out", "OUT or a sampled device" }, { "rst", "an event" }, { "", "" }, { "", "" },
  { "pre", "PRE" }, { "jac", "JAC" }
};

#define GS_NOT_CLOSED                                                                              \
  "no position that closes the loops was found nearby; the mechanism may be at the end of its range"

/* what the run time means by info; other meanings are the scene's */
static const struct { int failed, info; const char *text; } causes[] = {
  { GS_AT_EVENT, 9, "more than 100 events at one instant" },
  { GS_AT_EVENT, 10, "an event comes faster and faster until its intervals are nothing beside the "
    "time (a reset that brings its expression back to zero); expected a rest, or a stop" },
  { GS_AT_EVENT, 12, "a reset gives a state a value that the loops do not leave it; expected "
    "resets of independent coordinates and speeds" },
  { GS_AT_EVENT, 13, "a mode that is given contradicts the state" },
  { GS_AT_RHS, 9, "the constraints lose rank here, where there are no derivatives by parameters "
    "(option sensitivity)" },
  { GS_AT_PRJ, 9, "the constraints lose rank here, where there are no derivatives by parameters "
    "(option sensitivity)" },
  { GS_AT_PRJ, 3, GS_NOT_CLOSED },
  { GS_AT_PARTITION, 3, GS_NOT_CLOSED },
  { GS_AT_PRJ, 4, "no step leads away from a position where the constraints lose rank" }
};

/* the arguments 1 to 3 of a routine, for info below 0; the last row: of all others */
static const struct { const char *name, *argument[3]; } arguments[] = {
  { "pre", { "par (the parameters)" } },
  { "cmd", { "t", "qj (the motion)", "xi (the internal states)" } },
  { "prj", { "t", "x (the states)" } },
  { "con", { "t", "q (the coordinates)", "u (the speeds)" } },
  { "", { "t", "x (the states)", "v (the inputs)" } }
};

const char *
gs_failed_routine (const int *istat)
{
  const int k = istat[GS_FAILED];
  return k >= 0 && k <= GS_AT_JAC ? routines[k].name : "";
}

static void
put_argument (gs_writer *w, const char *routine, int k)
{
  int i = 0, last = (int)(sizeof arguments / sizeof arguments[0]) - 1;
  while (i < last && strcmp (arguments[i].name, routine) != 0)
    i++;
  const char *name = k <= 3 ? arguments[i].argument[k - 1] : 0;
  gs_put (w, "argument %s is out of range or not finite", name ? name : "of the subroutine");
}

/* do ports have friction with events? */
static int
sticks (const gs_scene *s)
{
  for (int k = 0; k < s->nev; k++)
    if (s->event_kinds[k] == 1)
      return 1;
  return 0;
}

static void
put_cause (gs_writer *w, const gs_failed_run *f)
{
  const int failed = f->istat[GS_FAILED], info = f->istat[GS_FAILED_INFO];
  const char *text = f->d->meaning ? f->d->meaning (gs_failed_routine (f->istat), info) : NULL;
  for (size_t k = 0; k < sizeof causes / sizeof causes[0]; k++)
    if (causes[k].failed == failed && causes[k].info == info)
      text = causes[k].text;
  if (info < 0)
    put_argument (w, gs_failed_routine (f->istat), -info);
  else
    gs_put (w, "%s", text ? text : "no sentence for this number: see ERROR INDICATOR in the head "
                                   "of the subroutine");
  if (failed == GS_AT_EVENT && info == 9 && sticks (f->d->scene))
    gs_put (w, "; does friction fall within a speed vs below the tolerance of the speeds (atol)? "
            "remedy: a larger vs, or method \"dp853\"");
}

void
gs_cause (const gs_failed_run *f, char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  put_cause (&w, f);
}

static void
put_singular_start (gs_writer *w, const gs_failed_run *f)
{
  static const char *const reasons[] = { "only method \"dp853\" begins there",
    "at rest it may go on in more than one way",
    "no motion with these speeds was found that leaves it" };
  const int info = f->istat[GS_FAILED_INFO];
  if (info >= 1 && info <= 3)
    gs_put (w, "expected a start where the constraints are independent; at t = %.9g s they lose "
            "rank: %s; start beside that position", f->t, reasons[info - 1]);
  else
    gs_put (w, "an event at t = %.9g s, where the constraints lose rank: no motion with the speeds "
            "that it leaves was found, how it goes on is not determined", f->t);
}

/* the routine that failed, or the event by its name */
static void
put_routine (gs_writer *w, const gs_failed_run *f)
{
  const int failed = f->istat[GS_FAILED], event = f->istat[GS_CAUSE];
  gs_put (w, "%s", routines[failed].shown);
  if (failed == GS_AT_EVENT && event > 0)
    gs_put (w, ", %s,", f->d->events[event - 1]);
  gs_put (w, " failed with INFO = %d at t = %.9g s: ", f->istat[GS_FAILED_INFO], f->t);
  put_cause (w, f);
}

static void
put_failed_call (gs_writer *w, const gs_failed_run *f)
{
  const int failed = f->istat[GS_FAILED];
  if (failed == GS_AT_START)
    put_singular_start (w, f);
  else if (failed == GS_BEFORE_START)
    gs_put (w, "%s", f->said ? f->said : "");
  else if (failed >= GS_AT_INPUTS && failed <= GS_AT_JAC)
    put_routine (w, f);
}

static void
put_failure (gs_writer *w, const gs_failed_run *f)
{
  switch (f->info)
    {
    case GS_TOO_MANY:
      gs_put (w, "more steps than option maxsteps allows, at t = %.9g s", f->t);
      return;
    case GS_TOO_SMALL:
      gs_put (w, "the step became too small at t = %.9g s: a singularity, or too small a "
              "tolerance", f->t);
      break;
    case GS_ROUTINE_FAILED:
      put_failed_call (w, f);
      if (f->istat[GS_FAILED] >= GS_AT_START)
        return;
      break;
    case GS_NOT_FINITE:
      gs_put (w, "the state is no longer finite at t = %.9g s: take smaller steps", f->t);
      break;
    case GS_METHOD_FAILED:
      gs_put (w, "the method stopped at t = %.9g s with flag %d: %s", f->t, f->istat[GS_CAUSE],
              f->said ? f->said : "");
      break;
    case GS_OUT_OF_MEMORY:
      gs_put (w, "there was no memory for the method");
      break;
    case GS_RATE_NOT_FINITE:
      gs_put (w, "a rate of the states is not finite at t = %.9g s", f->t);
      break;
    case GS_INTERRUPTED:
      gs_put (w, "interrupted by Ctrl-C at t = %.9g s", f->t);
      break;
    case GS_TIMED_OUT:
      gs_put (w, "ended by option timeout at t = %.9g s", f->t);
      break;
    default:
      gs_put (w, "the run ended with INFO = %d", f->info);
    }
  if (f->istat[GS_IS_STIFF] > 0)
    gs_put (w, "; the steps are bound by stability");
}

void
gs_failure (const gs_failed_run *f, char *text, int size)
{
  gs_writer w = { text, size, 0 };
  text[0] = 0;
  put_failure (&w, f);
  const gs_scene *s = f->d->scene;
  if (f->x && gs_not_finite (s->nx, f->x) == 0 && gs_not_finite (s->nv, f->v) == 0)
    {
      const int said = (int)strlen (text);
      gs_outside_text (f->d, (gs_real)f->t, f->x, f->v, f->cst, f->par, text + said, size - said);
    }
}
