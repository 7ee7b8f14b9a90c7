/* host/ensemble/member.h: one run of an ensemble: its arrays, how it begins, how it is made. */
#ifndef GS_HOST_MEMBER_H
#define GS_HOST_MEMBER_H

#include "host/ensemble/ensemble.h"

/* a run, and its constants (ncst) and info of pre if they are known, else a null pointer */
typedef struct
{
  int row;
  const gs_real *cst;
  int info;
} gs_known_row;

/* the arrays of m, which gs_free_member frees. 0; GS_OUT_OF_MEMORY, nothing is kept */
int gs_make_member (const gs_ensemble *e, gs_member *m);
void gs_free_member (gs_member *m);

/* m becomes a run from its start. 1; 0: it has ended already, m->info, pre or broken says how */
int gs_begin_member (const gs_ensemble *e, const gs_rows *rows, const gs_known_row *known,
                     gs_member *m);

/* it is made; on from where gs_integrate or the lanes ended it, by the implicit method */
void gs_run_member (const gs_ensemble *e, gs_member *m);
void gs_go_on (const gs_ensemble *e, gs_member *m);

#endif
