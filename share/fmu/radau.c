/* radau.c: a run of co-simulation by radau, for stiff scenes; FMUs of other methods do without this
 * file and share/engine/host/implicit. */
#include "fmu.h"
#include "host/implicit/implicit.h"

int
gsf_radau (const gs_scene *s, gs_integration *run, char *said, size_t room)
{
  const gs_implicit options = { .order = 13, .text = said, .length = room };
  return gs_radau (s, run, &options);
}
