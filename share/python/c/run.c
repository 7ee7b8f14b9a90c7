/* run.c: runs and planned motions for the module. */
#include <time.h>

#include "gsmbp/limits.h"
#include "gsmbp/options.h"
#include "gsmbp/refusals.h"
#include "host/planned.h"
#include "host/run/run.h"

/* asked some twenty times a second of processor time: 0, or the info by which the run is to end */
typedef int gs_question (void);

typedef struct
{
  gs_question *question;
  clock_t next;
  int calls;
} gs_asking;

/* ask of gs_run_options */
static int
ask (void *data, double t)
{
  gs_asking *a = data;
  (void)t;
  if (++a->calls % 8 != 0 || clock () < a->next)
    return 0;
  a->next = clock () + CLOCKS_PER_SEC / 20;
  return a->question ();
}

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

/* a run; question may be a null pointer */
int
gs_loop_run (gs_run_options *o, const gs_run_start *s, const gs_run_inputs *in,
             gs_question *question, gs_run_result *r)
{
  gs_asking asking = { .question = question, .next = clock () };
  if (question)
    {
      o->ask = ask;
      o->asked = &asking;
    }
  return gs_run (gs_loop_about (), o, s, in, r);
}

/* the same up to its first step */
int
gs_loop_prepare (const gs_run_options *o, const gs_run_start *s, const gs_run_inputs *in,
                 gs_run_result *r)
{
  return gs_run_prepare (gs_loop_about (), o, s, in, r);
}

/* bytes of the structures that Python fills and reads as well */
int
gs_loop_size (int which)
{
  static const size_t sizes[] = { sizeof (gs_run_options), sizeof (gs_run_start),
                                  sizeof (gs_run_inputs), sizeof (gs_run_result),
                                  sizeof (gs_planned_asked), sizeof (gs_planned_found) };
  return (int)sizes[which];
}

#define NAME(name) #name "\n"
#define ONE(constant, name) #name "\n"
#define TWO(name, value) #name "\t" #value "\n"
#define TEXT(name, text) #name "\t" text "\n"
#define THREE(name, kind, value) #name "\t" #kind "\t" #value "\n"
#define SIX(name, a, b, c, d, e) #name "\t" #a "\t" #b "\t" #c "\t" #d "\t" #e "\n"

/* the tables that hosts share, a line for each row, tabs between its parts */
const char *
gs_loop_table (int which)
{
  static const char *const tables[] = {
    GS_COUNTS (ONE), GS_VALUES (ONE), GS_OPTIONS (THREE), GS_KINDS (TEXT), GS_METHODS (SIX),
    GS_LOOP_METHODS (TWO), GS_LIMITS (TWO), GS_REFUSALS (TEXT), GS_VERDICTS (NAME)
  };
  return tables[which];
}

/* where in rp the records of the sampled devices begin; sizes: how many there are room for, how
 * many instants there were, where in rp the memory begins */
int
gs_loop_samples (const gs_scene *s, int *ip, double *rp, int *sizes)
{
  gs_samples a = gs_planned_samples (s, ip, rp);
  sizes[0] = a.ns;
  sizes[1] = *a.count;
  sizes[2] = (int)(a.memory - rp);
  return (int)(a.record - rp);
}

/* the same of the events: how many there is room for, how many there were */
int
gs_loop_events (int nx, int *ip, double *rp, int *sizes)
{
  gs_events a = gs_planned_events (nx, ip, rp);
  sizes[0] = a.nr;
  sizes[1] = *a.count;
  return (int)(a.record - rp);
}

int
gs_loop_planned (const gs_planned_asked *asked, gs_planned_found *found)
{
  return gs_whole_motion (gs_loop_about (), asked, found);
}
