/* start.c: the start of a run and why one failed, for the module, their arguments one by one. */
#include <stdio.h>

#include "host/failure.h"
#include "host/start.h"

/* made of the table by render.py */
extern const gs_description gs_loop_description;

/* the verdict and its message, the state that it is of, from 0, or -1 */
int
gs_loop_start (double t, const double *cst, const double *par, int check, const int *modes,
               double *x, int *state, char *text, int size)
{
  const gs_start_given g = { t, cst, par, 0, check, modes };
  gs_start s;
  gs_take_start (&gs_loop_description, &g, x, &s);
  snprintf (text, (size_t)size, "%s", s.text);
  *state = s.state;
  return s.verdict;
}

int
gs_loop_samples_from (double t0, const double *cst, int *ip, double *rp, char *text, int size)
{
  gs_start s;
  gs_check_samples (&gs_loop_description, t0, cst, ip, rp, &s);
  snprintf (text, (size_t)size, "%s", s.verdict == GS_START_TAKEN ? "" : s.text);
  return s.verdict;
}

void
gs_loop_settle (const double *cst, double *x)
{
  gs_settle_states (&gs_loop_description, 0, cst, 0, x);
}

void
gs_loop_wrong_mode (double t, const double *cst, const int *modes, const double *x, int k,
                    char *text, int size)
{
  const gs_start_given g = { t, cst, 0, 0, 1, modes };
  gs_wrong_mode (&gs_loop_description, &g, x, k, text, size);
}

/* margins that are passed in n columns: how many; first: the column of each, text: n texts of the
 * given size */
int
gs_loop_margins (int n, const double *t, const double *x, int ldx, const double *v, int ldv,
                 const double *cst, const double *par, int *first, char *text, int size)
{
  const gs_description *d = &gs_loop_description;
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

void
gs_loop_outside (double t, const double *x, const double *v, const double *cst, const double *par,
                 char *text, int size)
{
  gs_outside_text (&gs_loop_description, t, x, v, cst, par, text, size);
}

/* why a run ended */
void
gs_loop_failure (int info, const int *istat, double t, const char *said, char *text, int size)
{
  gs_failure (&(gs_failed_run){ &gs_loop_description, info, istat, t, said }, text, size);
}
