/* host/implicit/implicit.h: a run by an implicit method, for stiff scenes (radau, cvode) and for
 * long runs that keep their energy (gauss), in double precision. Calling rules: gsmbp/scene.h.
 *
 * scene, run: as gs_integrate takes them. The emitted jac, lin, bia, mas, con and tan are used
 * where the scene has them. iopt[GS_METHOD] is 0, with resume 9. The result is that of
 * gs_integrate, or GS_METHOD_FAILED with the flag of the method in istat[GS_CAUSE] (an order that
 * it does not have, too), GS_OUT_OF_MEMORY, GS_RATE_NOT_FINITE. */
#ifndef GS_HOST_IMPLICIT_H
#define GS_HOST_IMPLICIT_H
#include <stddef.h>
#include "gsmbp/integrate.h"
#include "gsmbp/methods.h"
#ifdef __cplusplus
extern "C" {
#endif

/* what the implicit methods have beside the options of gs_integrate */
typedef struct
{
  int order;          /* the largest order: of BDF 1 to 5, of Radau 5, 9 or 13; of Gauss 4, 6, 8 */
  int index2;         /* 1: loops in index 2, for Radau alone; the scene has mas, con and tan */
  int resume;         /* 1: the run goes on where gs_integrate ended with GS_STIFF */
  int columns;        /* of derivatives that are behind the states, among the nx of the run */
  int followed;       /* how many states of devices the inputs of a planned motion follow */
  const int *follows; /* followed: which ones, from 1 on */
  char *text;         /* what the method said when it failed, or a null pointer; */
  size_t length;      /* ... room in it */
} gs_implicit;

typedef int gs_implicit_method (const gs_scene *scene, gs_integration *run,
                                const gs_implicit *options);

/* gs_radau, gs_gauss, ...; of a library by itself gs_cvode (host/cvode) */
#define GS_DECLARED_core(word)
#define GS_DECLARED_both(word)
#define GS_DECLARED_engine(word) extern gs_implicit_method gs_##word;
#define GS_DECLARED_library(word) extern gs_implicit_method gs_##word;
#define GS_DECLARED(word, number, steps, by, orders, order) GS_DECLARED_##by (word)
GS_METHODS (GS_DECLARED)

/* the method of the engine with this name; a null pointer: it has none */
gs_implicit_method *gs_method_named (const char *name);

#ifdef __cplusplus
}
#endif
#endif
