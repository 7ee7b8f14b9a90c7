/* gsmbp/limits.h: limits of runs that the hosts share. ROW (name, value); Octave reads the rows,
 * Python has them from its library. */
#ifndef GSMBP_LIMITS_H
#define GSMBP_LIMITS_H

#define GS_LIMITS(ROW)                                                                             \
  ROW (recorded_events, 10000)   /* events that a result lists */                                  \
  ROW (off_constraints, 1e-6)    /* of a start, relative to nominal magnitudes */                  \
  ROW (moved_start, 1e-3)        /* of one that fulfils them: more is a singular position */       \
  ROW (short_orientation, 1e-3)  /* length of Euler parameters that have no direction */           \
  ROW (past_stop, 1e-6)          /* of a start beyond an end [m or rad] */                         \
  ROW (margin_rounding, 1e-9)    /* of margins of devices, relative to their magnitude */          \
  ROW (margin_near, 1e-6)        /* states beside one, relative to nominal magnitudes */           \
  ROW (largest_angle, 1e15)      /* of a start [rad]: beyond, rounding takes the sine */           \
  ROW (fixed_steps, 2e9)         /* steps of one length, samples of a device, maxsteps */          \
  ROW (controlled_steps, 1e15)   /* steps of any length: what time resolves */

#define GS_LIMIT_MEMBER(name, value) double name;
#define GS_LIMIT_VALUE(name, value) value,
static const struct { GS_LIMITS (GS_LIMIT_MEMBER) } gs_limits = { GS_LIMITS (GS_LIMIT_VALUE) };
#endif
