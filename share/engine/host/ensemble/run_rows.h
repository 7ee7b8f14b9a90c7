/* host/ensemble/run_rows.h: many runs on threads, for all hosts: what differs from run to run is a
 * table (host/ensemble/ensemble.h), all else is said as for one run (host/run/run.h). */
#ifndef GSMBP_HOST_ENSEMBLE_RUN_ROWS_H
#define GSMBP_HOST_ENSEMBLE_RUN_ROWS_H

#include "host/ensemble/ensemble.h"
#include "host/run/run.h"

#ifdef __cplusplus
extern "C" {
#endif

/* All rows by so many threads, each run to take (to, ...); inputs are no function. rows->par is not
 * read: the parameters of all runs are those of s, with which s->cst goes. 0; else r->refused says
 * why no run was begun, or r->info is GS_OUT_OF_MEMORY. r has neither states nor statistics;
 * gs_free_result gives its room back. o->ask is called by all threads; progress, where it is no
 * null pointer, is told how many runs are done. */
int gs_take_rows (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
                  const gs_run_inputs *in, const gs_rows *rows, int threads, gs_take_member *take,
                  void *to, void (*progress) (void *asked, int done), gs_run_result *r);

/* the same into results */
int gs_run_rows (const gs_description *d, const gs_run_options *o, const gs_run_start *s,
                 const gs_run_inputs *in, const gs_rows *rows, int threads, gs_results *results,
                 void (*progress) (void *asked, int done), gs_run_result *r);

#ifdef __cplusplus
}
#endif
#endif
