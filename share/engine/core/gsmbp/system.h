/* gsmbp/system.h: a scene in a run: what the routines of events.h and integrate.h share. */
#ifndef GSMBP_SYSTEM_H
#define GSMBP_SYSTEM_H

#include "gsmbp/failures.h"
#include "gsmbp/options.h"
#include "gsmbp/real.h"
#include "gsmbp/scene.h"
#include "gsmbp/statistics.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct
{
  const gs_scene *s;
  int nx;             /* states; an audit adds two to those of s */
  const int *iopt;    /* options */
  const gs_real *ropt; /* step, relative tolerance, largest step */
  const gs_real *atol; /* nx: absolute tolerances */
  int *ip;            /* the inputs and the plans of the samples and of the events, see inputs.h */
  gs_real *rp;
  const gs_real *cst; /* from <name>_pre */
  gs_real *v;         /* 2*nv: inputs */
  gs_real *w;         /* workspace of gs_inputs_of_run */
  gs_real *p;         /* the partition, see partition.h */
  int *istat;         /* GS_COUNTED: statistics */
  gs_real *rstat;     /* GS_MEASURED */
} gs_system;

#ifdef __cplusplus
}
#endif
#endif
