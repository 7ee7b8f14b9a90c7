/* linear.c: starts and linear models for the module. */
#include "host/linear/linear.h"

/* in loops.c, made by render.py */
extern const gs_description *gs_loop_about (void);

/* the state x as every calculation takes it, moved onto the constraints, or checked; the verdict */
int
gs_loop_start (double t, const double *cst, const double *par, int check, double *x,
               gs_start *found)
{
  const gs_start_given given = { .t = t, .cst = cst, .par = par, .check = check };
  const int verdict = gs_close_start (gs_loop_about (), &given, x, found);
  return verdict == GS_START_TAKEN && check ? gs_check_margins (gs_loop_about (), &given, x, found)
                                            : verdict;
}

int
gs_loop_linear (const gs_linear_place *at, const gs_linear_asked *asked, gs_linear_model *model,
                gs_linear_told *told)
{
  return gs_linear (gs_loop_about (), at, asked, model, told);
}

int
gs_loop_trim (const gs_linear_place *at, const gs_trim_asked *asked, gs_trim_found *found,
              gs_linear_told *told)
{
  return gs_trim (gs_loop_about (), at, asked, found, told);
}

int
gs_loop_vibrate (const gs_linear_place *at, const gs_vibrations_asked *asked, gs_vibrations *found,
                 gs_linear_told *told)
{
  return gs_vibrate (gs_loop_about (), at, asked, found, told);
}

int
gs_loop_modes (const gs_linear_place *at, const gs_vibrations *found, double *values,
               const double *vectors, gs_modes *modes, gs_linear_told *told)
{
  return gs_modes_of (gs_loop_about (), at, found, values, vectors, modes, told);
}

int
gs_loop_rest_slopes (const gs_linear_place *at, const gs_slopes_asked *asked,
                     gs_rest_slopes *found, gs_linear_told *told)
{
  return gs_slopes_of_rest (gs_loop_about (), at, asked, found, told);
}

/* bytes of the structures that Python fills and reads as well */
int
gs_loop_linear_size (int which)
{
  static const size_t sizes[] = { sizeof (gs_linear_place), sizeof (gs_linear_asked),
                                  sizeof (gs_linear_model), sizeof (gs_linear_told),
                                  sizeof (gs_start), sizeof (gs_trim_asked),
                                  sizeof (gs_trim_found), sizeof (gs_vibrations_asked),
                                  sizeof (gs_vibrations), sizeof (gs_modes),
                                  sizeof (gs_campbell), sizeof (gs_slopes_asked),
                                  sizeof (gs_rest_slopes), sizeof (gs_pole_slopes) };
  return (int)sizes[which];
}
