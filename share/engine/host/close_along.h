/* close_along.h: the loops of a closed chain closed on the branch of a guess. */
#ifndef GS_HOST_CLOSE_ALONG_H
#define GS_HOST_CLOSE_ALONG_H
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* q (nu), a guess of the coordinates of the closed chain s, becomes the position at the time t in
 * which the na planned ones, numbers ipl from 1, are those of target (na): the loops are closed
 * along the straight way of the planned coordinates from the guess. r: the order of the rows of
 * clo; w: nu*(r + 5) + 2*na numbers. done: the part of the way that was tried last, 0 to 1. info:
 * 0, or what clo returned, 2 where the chain cannot follow; q is then what was reached. */
int gs_close_along (const gs_scene *s, gs_real t, int r, int na, const int *ipl,
                    const gs_real *target, const gs_real *cst, gs_real *q, gs_real *done,
                    gs_real *w);

#ifdef __cplusplus
}
#endif
#endif
