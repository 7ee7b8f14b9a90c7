/* The runs of a sweep's program side by side (lane_group.h): the same ones, with the same bits, as
   those of gsmbp_ensemble. */
#ifndef GSMBP_GLUE_SWEEP_LANES_H
#define GSMBP_GLUE_SWEEP_LANES_H
#ifdef __cplusplus
extern "C" {
#endif
#include "sweep_run.h"

/* a chunk of runs that are dealt to threads */
typedef struct gs_lanes gs_lanes;

/* 1 if the runs of a sweep can be in lanes */
int gs_fit_lanes (const gs_sweep *s);

/* N runs from run FIRST (from 0) on, their rows into VALUES, as gs_sweep_row */
gs_lanes *gs_open_lanes (const gs_sweep *s, long long first, long long n, int threads,
                         double *values, char (*why)[GS_WHY]);
/* by THREAD (from 0), until there is none left; 0, or there is no memory */
int gs_run_lanes (gs_lanes *l, int thread);
void gs_close_lanes (gs_lanes *l);

#ifdef __cplusplus
}
#endif
#endif
