/* collocate.c: optimal motions for the module. */
#include <time.h>

#include "host/collocation/collocation.h"

/* asked some twenty times a second of processor time: not 0, the search is to end */
typedef int gs_question (void);

typedef struct
{
  gs_question *question;
  clock_t next;
} gs_asking;

static int
ask (void *data)
{
  gs_asking *a = data;
  if (clock () < a->next)
    return 0;
  a->next = clock () + CLOCKS_PER_SEC / 20;
  return a->question ();
}

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

/* as gs_collocate; question may be a null pointer */
int
gs_loop_collocate (const gs_motion_problem *p, const gs_motion_guess *guess, gs_motion_options *o,
                   gs_question *question, gs_motion *r)
{
  gs_asking asking = { .question = question, .next = clock () };
  if (question)
    {
      o->ask = ask;
      o->asked = &asking;
    }
  return gs_collocate (gs_loop_about (), p, guess, o, r);
}

void
gs_loop_motion_free (gs_motion *r)
{
  gs_motion_free (r);
}

/* bytes of the structures that Python fills and reads as well */
int
gs_loop_motion_size (int which)
{
  static const size_t sizes[] = { sizeof (gs_motion_problem), sizeof (gs_motion_guess),
                                  sizeof (gs_motion_options), sizeof (gs_motion),
                                  sizeof (gs_cost_product), sizeof (gs_active_bound),
                                  sizeof (gs_singular_arc), sizeof (gs_mesh_report) };
  return (int)sizes[which];
}
