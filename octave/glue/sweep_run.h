/* One run of a sweep without Octave: the job's numbers, the scene's subroutines, GSSIM or an
   implicit method, what is kept.  A run is a function of its number alone. */
#ifndef GSMBP_GLUE_SWEEP_RUN_H
#define GSMBP_GLUE_SWEEP_RUN_H
#include "gsmbp_scene.h"
#include "host/implicit/implicit.h"
#include "sweep_files.h"

enum { GS_SUBS = 11 };   /* subroutines that GSSIM takes */
enum { GS_FINAL = 1, GS_PEAK, GS_MAX, GS_MIN, GS_MEAN, GS_RMS, GS_AT, GS_WHOLE, GS_FIRST, GS_LAST,
       GS_COUNT, GS_MARGIN };

typedef struct
{
  const double *x;
  long long n;
} gs_array;

typedef struct
{
  const gs_job *job;
  gs_array cst, x0, tout, tbrk, ropt, atol, rp, guess, par, samples, nominal;
  gs_array groups;                                /* of each event the first one with its name */
  int *ip, *iopt, *follows, *which, *way, *number, *time;   /* from 1 on, as GSMBP numbers things */
  long long nip, niopt, followed, varied, runs, kept, wholes, columns;
  int nx, ldx, ldv, lw, order, index2, check_start;
  int lanes;                             /* 1: in lanes, where they can be */
  double t0;
  gsmbp_sub sub[GS_SUBS];
  gs_implicit_method *implicit_method;   /* a null pointer: GSSIM alone */
  const char **broken;                   /* for each run: why its parameters cannot be, or null */
} gs_sweep;

typedef struct
{
  double *cst, *x0, *xout, *vout, *yout, *rstat, *w, *rp, *par, *times, *options;
  int nb;   /* breaks behind the output times in times */
  int *ip, *istat, *iopt;
  char text[2400];   /* of a refused start, or of an implicit method that failed */
  int info;
} gs_sweep_room;

/* 0, or WHY says what is wrong; the job has to stay */
int gs_open_sweep (gs_sweep *s, const gs_job *job, char *why);
void gs_close_sweep (gs_sweep *s);
gs_sweep_room *gs_make_room (const gs_sweep *s);
void gs_free_room (gs_sweep_room *r);

/* run I (from 0) into ROW (s->columns); WHY: "", or why it failed */
void gs_sweep_row (const gs_sweep *s, gs_sweep_room *r, long long i, double *row, char *why);

/* the same in two parts, between which R is run. CST: its constants, INFO that of PRE for them; a
   null pointer: PRE is called. 0: it does not begin and its row is filled; else it is run where
   r->info is 0 */
int gs_begin_row (const gs_sweep *s, gs_sweep_room *r, long long i, const double *cst, int info,
                  double *row, char *why);
void gs_end_row (const gs_sweep *s, gs_sweep_room *r, double *row, char *why);

/* a plan from one room into another, but for the record of the events */
void gs_take_plan (const gs_sweep *s, const int *from_ip, const double *from, int *ip, double *rp);
#endif
