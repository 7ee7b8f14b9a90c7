/* host/ensemble/row_groups.h: which thread makes which row. Where the constants of GS_LANES runs
 * are computed at once (gs_pre_w), a thread takes the next rows as a group; where there are none
 * left it takes rows of the groups of others, so that no row waits for a thread while another one
 * is idle. */
#ifndef GS_HOST_ROW_GROUPS_H
#define GS_HOST_ROW_GROUPS_H

#include "host/ensemble/member.h"

typedef struct gs_row_groups gs_row_groups;

/* for so many threads; a null pointer: no memory */
gs_row_groups *gs_open_rows (const gs_ensemble *e, const gs_rows *rows, int threads);
void gs_close_rows (gs_row_groups *all);

/* the next row of a thread, its constants into cst (ncst) where they are computed at once; 0: all
 * are taken */
int gs_next_row (gs_row_groups *all, int thread, gs_real *cst, gs_known_row *row);

/* no row is given out any more */
void gs_stop_rows (gs_row_groups *all);

#endif
