/* The scene's part of a module, compiled for every scene with gsmbp_sizes.h,
   which gsmbp_build writes from the JSON:
     GSMBP_DECLARE  extern void pendulum_par_ (void); ...
     GSMBP_BY_VALUE GS_FORTRAN_rhs (run_rhs, pendulum_rhs_) ...: those that runs call
     GSMBP_RUN      the members of gs_scene by name: .nq = 1, .rhs = run_rhs, ...
     GSMBP_LISTS    arrays of what runs need of the scene, GSMBP_ABOUT its members by name
                    (gs_description)
     GSMBP_SETS     four numbers of coordinates for each set of Euler parameters, then 0
     GSMBP_MODES    the numbers of the inputs that are modes, then 0
     GSMBP_TABLE    the members of gsmbp_scene by name: .name = "pendulum", .nq = 1, ...
     GSMBP_ROUTINES the subroutines: { "par", pendulum_par_, "" }, ...
     GSMBP_MEANINGS what their INFO says: { "rhs", 1, 0, "the mass matrix is singular" }, ...
     GSMBP_INSTALL  Gpendulum_1a2b3c4d, the symbol that Octave looks up  */
#include "gsmbp_scene.h"
#include "gsmbp_sizes.h"
#include "host/ensemble/ensemble.h"
#include "host/fortran_scene.h"
#include <string.h>

GSMBP_DECLARE
GSMBP_BY_VALUE

GSMBP_LISTS
static const gs_scene run = { GSMBP_RUN };
static const int sets[] = { GSMBP_SETS };
static const int modes[] = { GSMBP_MODES };
static const gsmbp_routine routines[] = { GSMBP_ROUTINES { 0, 0, 0 } };
static const gsmbp_meaning meanings[] = { GSMBP_MEANINGS { 0, 0, 0, 0 } };

const char *
gsmbp_meaning_of (const char *name, int info)
{
  const char *text = 0;
  for (const gsmbp_meaning *m = meanings; m->name; m++)
    if (strcmp (name, m->name) == 0 && (m->info == info || (m->and_above && info > m->info)))
      text = m->text;
  return text;
}

static const gs_description about = { .scene = &run, .meaning = gsmbp_meaning_of,
                                      .pre = gsmbp_constants, .fortran_inputs = 1, GSMBP_ABOUT };
const gsmbp_scene gsmbp_the_scene
    = { GSMBP_TABLE, .run = &run, .about = &about, .sets = sets, .modes = modes,
        .routines = routines };

gsmbp_sub
gsmbp_emitted (const char *name)
{
  for (const gsmbp_routine *r = routines; r->name; r++)
    if (strcmp (name, r->name) == 0)
      return r->sub;
  return 0;
}

int
gsmbp_constants (const gs_value *par, gs_value *cst)
{
  int info = 0;
  ((void (*) (const gs_value *, gs_value *, int *)) gsmbp_emitted ("pre")) (par, cst, &info);
  return info;
}

void
gsmbp_lanes (gs_lane_routines *lanes)
{
  lanes->rhs = (gs_rhs_w *) gsmbp_emitted ("rhs_w");
  lanes->evt = (gs_evt_w *) gsmbp_emitted ("evt_w");
  lanes->con = (gs_con_w *) gsmbp_emitted ("con_w");
  lanes->prj = (gs_prj_w *) gsmbp_emitted ("prj_w");
  lanes->pre = (gs_pre_w *) gsmbp_emitted ("pre_w");
}

#if ! defined (GSMBP_NO_OCTAVE)   /* the program of a sweep has none */
extern void *Ggsmbp_module (void *library, _Bool relative);

void *
GSMBP_INSTALL (void *library, _Bool relative)
{
  return Ggsmbp_module (library, relative);
}
#endif
