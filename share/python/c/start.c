/* start.c: settled states and margins of devices for the module, their arguments one by one. */
#include "host/start.h"

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

void
gs_loop_settle (const double *cst, double *x)
{
  gs_settle_states (gs_loop_about (), 0, cst, 0, x);
}

/* margins that are passed in n columns: how many; first: the column of each, text: n texts of the
 * given size */
int
gs_loop_margins (int n, const double *t, const double *x, int ldx, const double *v, int ldv,
                 const double *cst, const double *par, int *first, char *text, int size)
{
  const gs_description *d = gs_loop_about ();
  gs_passed_margin list[d->nmargins + 1];
  const int many = gs_margins_of_run (d, n, t, x, ldx, v, ldv, cst, list);
  for (int i = 0; i < many; i++)
    {
      first[i] = list[i].first;
      gs_margin_text (d, list[i].k, list[i].least, x + (size_t)ldx * (size_t)list[i].at, par,
                      text + size * i, size);
    }
  return many;
}

/* INFO of a subroutine in words, or a null pointer */
const char *
gs_loop_meaning (const char *routine, int info)
{
  return gs_loop_about ()->meaning (routine, info);
}
