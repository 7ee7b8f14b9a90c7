/* gate JOB: the run of a file of gate_jobs.m by the Fortran run time and by the one in C, in turn;
 * prints for each its name, seconds and calls of RHS of a run, INFO, and the error of the last
 * state against quad precision in nominal magnitudes. gate JOB fortran|c: by that one, once, to be
 * counted by valgrind. gate_scene.h, the scene, is written by gate.py. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "gsmbp/integrate.h"
#include "host/fortran_scene.h"

typedef void subroutine (void);
static void absent (void) { }
#include "gate_scene.h"

extern void gssim_ (subroutine *rhs, subroutine *prj, subroutine *con, subroutine *kin,
                    subroutine *cmd, subroutine *clo, subroutine *vin, subroutine *out,
                    subroutine *ctl, subroutine *evt, subroutine *rst, const int *sizes,
                    const double *times, const double *x0, const int *counts,
                    const double *options, int *ip, double *rp, const double *cst, double *xout,
                    double *vout, int *istat, double *rstat, double *w, int *info);

enum { ROUNDS = 40 };

typedef struct
{
  int n;
  double *x;
} array;

static array t0, x0, tout, tbrk, iopt, ropt, atol_, guess, ip, rp, sizes, cst, quad,
    nominal;
static const struct { const char *name; array *to; } fields[] = {
  { "t0", &t0 }, { "x0", &x0 }, { "tout", &tout }, { "tbrk", &tbrk }, { "iopt", &iopt },
  { "ropt", &ropt }, { "atol", &atol_ }, { "guess", &guess }, { "ip", &ip }, { "rp", &rp },
  { "sizes", &sizes }, { "cst", &cst }, { "quad", &quad },
  { "nominal", &nominal }
};

/* what a run writes, and what it is called with where that has another shape */
static int *my_ip, *my_iopt;
static double *my_rp, *w, *xout, *vout, *times, *options;
static int istat[GS_COUNTED], info;
static double rstat[GS_MEASURED];

static void *
room (size_t n, size_t size)
{
  void *x = calloc (n + 1, size);
  if (! x)
    exit (2);
  return x;
}

static void
read_job (const char *name)
{
  FILE *f = fopen (name, "r");
  char word[40];
  int n;
  if (! f)
    exit (2);
  while (fscanf (f, "%39s %d", word, &n) == 2)
    for (size_t k = 0; k < sizeof fields / sizeof *fields; k++)
      if (strcmp (word, fields[k].name) == 0)
        {
          array *a = fields[k].to;
          a->n = n;
          a->x = room ((size_t) n, sizeof (double));
          for (int i = 0; i < n; i++)
            if (fscanf (f, "%lf", a->x + i) != 1)
              exit (2);
        }
  fclose (f);
}

static int *
wholes (const array *a)
{
  int *k = room ((size_t) a->n, sizeof (int));
  for (int i = 0; i < a->n; i++)
    k[i] = (int) a->x[i];
  return k;
}

static double *
joined (const array *a, const array *b, const array *c)
{
  double *x = room ((size_t) (a->n + b->n + c->n), sizeof (double));
  memcpy (x, a->x, (size_t) a->n * sizeof (double));
  memcpy (x + a->n, b->x, (size_t) b->n * sizeof (double));
  memcpy (x + a->n + b->n, c->x, (size_t) c->n * sizeof (double));
  return x;
}

static void
make_room (void)
{
  static const array none = { 0, NULL };
  my_ip = wholes (&ip);
  my_iopt = wholes (&iopt);
  my_rp = room ((size_t) rp.n, sizeof (double));
  w = room ((size_t) sizes.x[3], sizeof (double));
  xout = room ((size_t) sizes.x[1] * (size_t) tout.n, sizeof (double));
  vout = room ((size_t) sizes.x[2] * (size_t) tout.n, sizeof (double));
  times = joined (&t0, &tout, &tbrk);
  options = joined (&ropt, &atol_, &none);
}

/* the plan as it is before a run */
static void
begin (void)
{
  for (int i = 0; i < ip.n; i++)
    my_ip[i] = (int) ip.x[i];
  memcpy (my_rp, rp.x, (size_t) rp.n * sizeof (double));
  memcpy (w, guess.x, (size_t) guess.n * sizeof (double));
}

void __attribute__ ((noinline))
by_fortran (void)
{
  subroutine *f[11];
  const int counts[] = { scene.nq, scene.nu, (int) sizes.x[0], scene.nv, scene.nlam, tout.n,
                         tbrk.n, (int) sizes.x[3] };
  for (int k = 0; k < 11; k++)
    f[k] = subroutines[k];
  begin ();
  gssim_ (f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10], counts, times, x0.x,
          my_iopt, options, my_ip, my_rp, cst.x, xout, vout, istat, rstat, w, &info);
}

void __attribute__ ((noinline))
by_c (void)
{
  gs_integration r = {
    .nx = (int) sizes.x[0], .t0 = t0.x[0], .x0 = x0.x, .nt = tout.n, .tout = tout.x, .nb = tbrk.n,
    .tbrk = tbrk.x, .iopt = my_iopt, .ropt = ropt.x, .atol = atol_.x, .ip = my_ip, .rp = my_rp,
    .cst = cst.x, .xout = xout, .ldx = (int) sizes.x[1], .vout = vout, .ldv = (int) sizes.x[2], .w
    = w, .lw = (int) sizes.x[3]
  };
  begin ();
  info = gs_integrate (&scene, &r);
  memcpy (istat, r.istat, sizeof istat);
}

static double
now (void)
{
  struct timespec t;
  clock_gettime (CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

static double
seconds (void (*run) (void), int repeats)
{
  const double begin = now ();
  for (int k = 0; k < repeats; k++)
    run ();
  return (now () - begin) / repeats;
}

/* one run: its part of the line */
static void
tell (const char *who, void (*run) (void), double best)
{
  run ();
  double off = 0;
  for (int i = 0; i < quad.n; i++)
    off = fmax (off, fabs (xout[(size_t) sizes.x[1] * (size_t) (tout.n - 1) + (size_t) i]
                           - quad.x[i]) / nominal.x[i]);
  printf ("%s %.9g %d %d %.3g ", who, best, istat[GS_N_RHS], info, off);
}

int
main (int count, char **words)
{
  if (count < 2)
    return 2;
  read_job (words[1]);
  make_room ();
  if (count > 2)
    return strcmp (words[2], "c") == 0 ? by_c () : by_fortran (), 0;
  double fortran = 1e9, c = 1e9;
  const int repeats = 1 + (int) (4e-3 / fmax (1e-6, seconds (by_fortran, 3)));
  for (int k = 0; k < ROUNDS; k++)
    {
      fortran = fmin (fortran, seconds (by_fortran, repeats));
      c = fmin (c, seconds (by_c, repeats));
    }
  tell ("fortran", by_fortran, fortran);
  tell ("c", by_c, c);
  printf ("\n");
  return 0;
}
