/* plan.h: the plan of the inputs of an instance (gsmbp/plan.h): constants, held outputs of sampled
 * devices, modes of events. */
#ifndef GSF_PLAN_H
#define GSF_PLAN_H

#include "fmu.h"
#include "gsmbp/plan.h"

/* places for outputs of sampled devices that are on their way, for each device */
enum { GSF_ON_THE_WAY = 32 };
/* records of events of the user: those that are kept, and as many as an instant may have */
enum { GSF_KEPT = 32, GSF_RECORDS = GSF_KEPT + 104 };

int gsf_plan_numbers (const gsf_model *m);
int gsf_plan_wholes (const gsf_model *m);

/* the plan without values: places, starts */
void gsf_plan (gsf_instance *a);

/* periods, delays and the first samples at the time t0 */
int gsf_plan_samples (gsf_instance *a, double t0);

/* the parts of the plan; only where the scene has such devices */
gs_samples gsf_samples (const gsf_instance *a);
gs_events gsf_events (const gsf_instance *a);

#endif
