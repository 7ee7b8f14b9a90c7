/* The runs of a sweep without Octave: what the job says of them, as the engine takes it, all
   of them by gs_take_rows (host/ensemble), what is kept.  A run is a function of its number
   alone. */
#ifndef GSMBP_GLUE_SWEEP_RUN_H
#define GSMBP_GLUE_SWEEP_RUN_H
#include "gsmbp_scene.h"
#include "host/ensemble/run_rows.h"
#include "sweep_files.h"

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
  gs_description about;
  gs_lane_routines lanes;
  gs_run_options options;
  gs_run_start start;
  gs_run_inputs inputs;
  gs_array samples;
  gs_array groups;                       /* of each event the first one with its name */
  int *modes, *planned, *which, *way, *number, *time;   /* from 1 on, as GSMBP numbers things */
  long long varied, runs, kept, wholes, columns;
  const char **broken;                   /* for each run: why its parameters cannot be, or null, */
  char *reasons;                         /* ... their texts */
} gs_sweep;

/* 0, or WHY says what is wrong; the job has to stay */
int gs_open_sweep (gs_sweep *s, const gs_job *job, char *why);
void gs_close_sweep (gs_sweep *s);

/* N runs from run FIRST (from 0) on by so many threads, into ROWS (s->columns each); WHY: of each
   "", or why it failed.  0, or REFUSED says why none was made */
int gs_sweep_rows (const gs_sweep *s, long long first, int n, int threads, double *rows,
                   char (*why)[GS_WHY], char *refused);
#endif
