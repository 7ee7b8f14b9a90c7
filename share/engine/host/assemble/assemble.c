/* assemble.c: from the guess to the states that are found. */
#include <stdint.h>
#include <stdlib.h>

#include "gsmbp/refusals.h"
#include "host/assemble/assemble_parts.h"

typedef struct
{
  gs_work *w;
  const gs_assembly_asked *a;
  gs_assembly *found;
  gs_real *guess;     /* nx */
  uint64_t chance;
} assembly;

static int
refuse (assembly *s, const char *format, ...)
{
  va_list values;
  va_start (values, format);
  vsnprintf (s->found->text, sizeof s->found->text, format, values);
  va_end (values);
  s->found->n = 0;
  return 0;
}

/* ------------------------------------------------------------------------------ what is refused */

static int
check_angles (assembly *s)
{
  const gs_description *d = s->w->d;
  gs_start start;
  if (gs_check_angles (d, s->guess, &start) == GS_START_TAKEN)
    return 1;
  return refuse (s, "the guess of %s: %s", d->states[start.state], start.text);
}

/* sets of Euler parameters: all of one may stay, or none; zeros have no direction */
static int
check_orientations (assembly *s)
{
  const gs_description *d = s->w->d;
  for (int k = 0; k < d->nsets; k++)
    {
      const int *set = d->sets + 4 * k;
      int many = 0, one = 0, some = 0;
      gs_start start;
      for (int j = 0; j < 4; j++)
        {
          one = many == 0 && s->a->held[set[j]] ? j : one;
          many += s->a->held[set[j]];
          some |= gs_abs (s->guess[set[j]]) > 0;
        }
      if (! some)
        {
          gs_refuse_orientation (d, k, s->guess, &start);
          return refuse (s, "%s", start.text);
        }
      if (many > 0 && many < 4)
        return refuse (s, "option hold: %s is one of the Euler parameters (%s, %s, %s, %s) of one "
                       "orientation: hold all four, or none (one alone would freeze the "
                       "orientation)", d->states[set[one]], d->states[set[0]], d->states[set[1]],
                       d->states[set[2]], d->states[set[3]]);
    }
  return 1;
}

static int
check_routines (assembly *s)
{
  const gs_scene *scene = s->w->s;
  if (scene->nlam > 0 && ! scene->con)
    return refuse (s, gs_refusals.routine, "assembly", "CON", scene->name);
  for (int i = 0; i < scene->nq; i++)
    if (s->a->held[i])
      return 1;
  if (scene->nlam > 0 && ! scene->prj)
    return refuse (s, gs_refusals.no_projection, scene->name);
  return 1;
}

/* -------------------------------------------------------------------------------- many branches */

/* a number from -1 to 1, the same ones at every call (Vigna's splitmix64) */
static double
by_chance (assembly *s)
{
  uint64_t z = s->chance += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

static int
is_euler (const gs_description *d, int coordinate)
{
  return gs_is_among (coordinate, 4 * d->nsets, d->sets);
}

static int
is_turning (const gs_description *d, int coordinate)
{
  return d->angles && d->angles[coordinate] && ! is_euler (d, coordinate);
}

/* x: another guess: angles by up to half a turn, lengths by up to the largest one, any
 * orientation */
static void
guess_again (assembly *s, gs_real *x)
{
  const gs_description *d = s->w->d;
  const int nq = s->w->s->nq;
  double longest = fmax (1e-3, s->a->longest);
  for (int i = 0; i < nq; i++)
    if (! is_turning (d, i) && ! is_euler (d, i))
      longest = fmax (longest, fabs ((double)s->guess[i]));
  gs_copy (s->w->s->nx, s->guess, x);
  for (int i = 0; i < nq; i++)
    {
      const double change = by_chance (s);
      if (! s->a->held[i])
        x[i] += change * (is_turning (d, i) ? 3.14159265358979323846 : longest);
    }
  for (int k = 0; k < 4 * d->nsets; k++)
    {
      const double size = sqrt (-2 * log (0.5 - 0.5 * by_chance (s)));
      const double turn = cos (3.14159265358979323846 * by_chance (s));
      if (! s->a->held[d->sets[k]])
        x[d->sets[k]] = size * turn;
    }
  gs_unit_orientations (d, x);
}

/* the turns, and the sign of Euler parameters, that bring x next to y: x is changed */
static void
unwind (const gs_work *w, const gs_real *y, gs_real *x)
{
  const gs_description *d = w->d;
  const gs_real turn = 2 * GS_R (3.14159265358979323846264338327950288);
  for (int i = 0; i < w->s->nq; i++)
    if (is_turning (d, i))
      x[i] -= turn * gs_round ((x[i] - y[i]) / turn);
  for (int k = 0; k < d->nsets; k++)
    {
      const int *set = d->sets + 4 * k;
      gs_real sum = 0;
      for (int j = 0; j < 4; j++)
        sum += x[set[j]] * y[set[j]];
      for (int j = 0; j < 4 && sum < 0; j++)
        x[set[j]] = -x[set[j]];
    }
}

/* the largest difference of the coordinates of x and y, turns and signs aside; z: nx numbers */
static gs_real
apart (const gs_work *w, const gs_real *x, const gs_real *y, gs_real *z)
{
  const int nq = w->s->nq;
  gs_copy (w->s->nx, x, z);
  unwind (w, y, z);
  for (int i = 0; i < nq; i++)
    z[i] -= y[i];
  return gs_largest_modulus (nq, z);
}

/* x (nx,n): is y one of these columns? z: nx numbers */
static int
is_known (const assembly *s, const gs_real *x, const gs_real *y, gs_real *z)
{
  const gs_real size = gs_largest_modulus (s->w->s->nq, y);
  for (int k = 0; k < s->found->n; k++)
    if (! (apart (s->w, x + s->w->s->nx * k, y, z) > GS_R (1e-6) * (size > 1 ? size : 1)))
      return 1;
  return 0;
}

/* the columns of x by their distance from the guess; z: nx numbers */
static void
sort_states (const assembly *s, gs_real *x, gs_real *z)
{
  const int nx = s->w->s->nx;
  for (int k = 1; k < s->found->n; k++)
    for (int i = k; i > 0; i--)
      {
        gs_real *const a = x + nx * (i - 1), *const b = a + nx;
        const gs_real near = apart (s->w, b, s->guess, z);
        if (! (near < apart (s->w, a, s->guess, z)))
          break;
        gs_swap (nx, a, b);
      }
}

static void
find_branches (assembly *s, gs_real *x)
{
  gs_work *w = s->w;
  const int nx = w->s->nx, many = 1 + s->a->branches;
  gs_real *y = gs_numbers (w, nx), *z = gs_numbers (w, nx);
  char first[1200] = "";
  if (! y || ! z)
    return;
  for (int k = 0; k < many; k++)
    {
      gs_closing c = { .anywhere = k > 0, .listed = 1 };
      if (k == 0)
        gs_copy (nx, s->guess, y);
      else
        guess_again (s, y);
      gs_close_guess (w, s->a, y, &c);
      if (c.unclosed[0] && ! first[0])
        memcpy (first, c.unclosed, sizeof first);
      if (c.unclosed[0])
        continue;
      unwind (w, s->guess, y);
      if (! is_known (s, x, y, z))
        gs_copy (nx, y, x + nx * s->found->n++);
    }
  if (s->found->n == 0)
    refuse (s, "none of %d guesses: %s", many, first);
  sort_states (s, x, z);
}

/* ------------------------------------------------------------------------------------- warnings */

static void
tell_limits (const assembly *s)
{
  const int nq = s->w->s->nq;
  gs_writer said = { s->found->beyond, sizeof s->found->beyond, 0 };
  for (int k = 0; k < nq && s->a->limits; k++)
    {
      const double low = s->a->limits[k], high = s->a->limits[k + nq], x = (double)s->guess[k];
      if (s->a->held[k] && ! (low <= x && x <= high))
        gs_put (&said, "%s%s = %.6g %s is outside the limits of its joint; expected %.6g to %.6g",
                said.length ? "; " : "option hold: ", s->w->d->states[k], x,
                is_turning (s->w->d, k) ? "rad" : "m", low, high);
    }
}

/* where the first of the states is at which constraints have lost rank */
static void
tell_rank (const assembly *s, const gs_real *start, const gs_real *x)
{
  char lost[1000];
  const gs_work *w = s->w;
  if (! s->found->lost[0] && gs_lost_rank (w->d, w->t, w->cst, s->a->rank, start, x, NULL,
                                           lost, sizeof lost) > 0)
    snprintf (s->found->lost, sizeof s->found->lost, "at the position found %s; is it meant? "
              "(angles are in rad)", lost);
}

/* ---------------------------------------------------------------------------------------- whole */

/* are filters of sensors and observers where their rates vanish? */
static int
is_settled (const assembly *s, gs_real *y)
{
  const gs_work *w = s->w;
  gs_copy (w->s->nx, s->guess, y);
  gs_settle_states (w->d, w->t, w->cst, NULL, y);
  for (int i = 0; i < w->s->nx; i++)
    if (! (fabs ((double)(y[i] - s->guess[i]))
           <= 1e-9 * (w->d->nominal[i] + fabs ((double)s->guess[i]))))
      return 0;
  return 1;
}

static void
close_loops (assembly *s, gs_real *x)
{
  gs_closing c = { 0 };
  s->found->n = 1;
  if (s->w->s->nlam == 0)
    gs_unit_orientations (s->w->d, x);
  else if (s->a->branches > 0)
    {
      s->found->n = 0;
      find_branches (s, x);
    }
  else
    {
      gs_close_guess (s->w, s->a, x, &c);
      if (c.unclosed[0] || c.elsewhere[0])
        refuse (s, "%s", c.unclosed[0] ? c.unclosed : c.elsewhere);
    }
}

int
gs_assemble (const gs_description *d, const gs_assembly_asked *a, const gs_real *start,
             gs_real *x, gs_assembly *found)
{
  gs_linear_told told;
  const gs_linear_place at = { .t = a->t, .cst = a->cst };
  gs_work w = gs_work_begin (d, &at, &told);
  const int nx = d->scene->nx;
  assembly s = { &w, a, found, gs_numbers (&w, nx), 7 };
  gs_real *y = gs_numbers (&w, nx);
  *found = (gs_assembly){ 0 };
  if (s.guess && y)
    {
      gs_copy (nx, x, s.guess);
      if (check_angles (&s) && check_orientations (&s) && check_routines (&s))
        {
          const int settled = a->settle || is_settled (&s, y);
          close_loops (&s, x);
          for (int k = 0; k < found->n; k++)
            {
              tell_rank (&s, start, x + nx * k);
              if (settled)
                gs_settle_states (d, a->t, a->cst, NULL, x + nx * k);
            }
          if (found->n > 0)
            tell_limits (&s);
        }
    }
  return gs_work_end (&w) == GS_LINEAR_NO_MEMORY;
}
