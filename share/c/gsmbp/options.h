/* gsmbp/options.h: the options of a run. */
#ifndef GSMBP_OPTIONS_H
#define GSMBP_OPTIONS_H

/* iopt: IOPT of GSSIM */
enum
{
  GS_METHOD = 0, /* 4 classical Runge-Kutta, fixed step; 8 Dormand-Prince 8(5,3), step controlled; 9
                    as 8, but it ends where steps are found to be bound by stability */
  GS_LOOPS,      /* the way of the loops, see gssim.c: 1 Baumgarte, 2 projection, 3 partitioning,
                    4 null space, 5 zero-eigenvalue theorem, 6 Kane with dependent speeds */
  GS_DRIFT,      /* 1: the drift of the constraints is recorded */
  GS_MOST_STEPS, /* the largest number of steps, 0 for no limit */
  GS_WATCH,      /* 1: positions where the constraints lose rank are watched for */
  GS_ON_SPEEDS   /* how many constraints are on speeds alone; their numbers, from 1, follow */
};
#endif
