/* The table that the scene's part of a module hands to the generic part:
   sizes from the JSON and the emitted subroutines. */
#ifndef GSMBP_GLUE_SCENE_H
#define GSMBP_GLUE_SCENE_H
#include "gsmbp/scene.h"
#ifdef __cplusplus
extern "C" {
#endif
struct gs_description;
typedef void (*gsmbp_sub) (void);

/* a number of the Fortran */
typedef gs_real gs_value;

/* The sizes, as the JSON's "dimensions" name them: the one place where they are listed.
   gs.model.compile_module.m writes an initializer by name for each. */
#define GSMBP_SIZES(X)                                                                             \
  X (nq) X (nu) X (nv) X (nx) X (ny) X (ne) X (nlam) X (ncst) X (npar) X (nqj) X (nact) X (na)     \
  X (nmar) X (nxk) X (nctl) X (nev) X (nmode) X (nsm) X (nsw)
#define GSMBP_SIZE(name) int name;

/* an emitted subroutine: the end of its name, and its arguments as signature.h reads them, ""
   where the JSON does not tell their shapes */
typedef struct
{
  const char *name;
  gsmbp_sub sub;
  const char *arguments;
} gsmbp_routine;

/* what its INFO says; and_above: every greater number says so too */
typedef struct
{
  const char *name;
  int info, and_above;
  const char *text;
} gsmbp_meaning;

typedef struct
{
  const char *name;
  const char *symbol;   /* of the module in Octave: gsmbp_d_pendulum_1a2b3c4d */
  const char *left_out; /* of the requests, and why: "\nrequest: reason\n..." */
  GSMBP_SIZES (GSMBP_SIZE)
  int np;            /* points of the skeleton */
  int nbase;         /* base parameters */
  int redundant;     /* rows of the constraints that are redundant in general */
  int nsp;           /* parameters of RHP, INP, ILP, OUP, COP */
  gsmbp_sub vin;     /* the user's inputs, GSVIN */
  int nsets;         /* of Euler parameters */
  const gs_scene *run; /* as the run time in C takes it */
  const struct gs_description *about;   /* as hosts of runs do (host/start.h) */
  const int *sets;   /* ... four numbers of coordinates each */
  const int *modes;  /* nmode: the numbers of the inputs that are modes of devices with events */
  const gsmbp_routine *routines;   /* as they were emitted; the last has no name */
} gsmbp_scene;
extern const gsmbp_scene gsmbp_the_scene;

/* an emitted subroutine by the end of its name, a null pointer where there is none */
gsmbp_sub gsmbp_emitted (const char *name);

/* those that an ensemble calls (host/ensemble/ensemble.h): constants from parameters, info; the
   routines over lanes */
struct gs_lane_routines;
int gsmbp_constants (const gs_value *par, gs_value *cst);
void gsmbp_lanes (struct gs_lane_routines *lanes);

/* what INFO of a subroutine says; a null pointer: not known */
const char *gsmbp_meaning_of (const char *name, int info);
#ifdef __cplusplus
}
#endif
#endif
