/* gsmbp/options.h: the options of a run. Octave reads the rows, Python has them from its
 * library. */
#ifndef GSMBP_OPTIONS_H
#define GSMBP_OPTIONS_H

/* ROW (name, kind, default): kinds of GS_KINDS, or the words of GS_METHODS (methods.h) and of
 * GS_STARTS; default none: what the run needs */
#define GS_OPTIONS(ROW)                                                                            \
  ROW (method, method, dp853)       /* of integration */                                           \
  ROW (step, any, none)             /* of fixed steps [s], 1e-3; otherwise the first one */        \
  ROW (rtol, tolerance, 1e-10)      /* relative tolerance */                                       \
  ROW (atol, any, none)             /* absolute tolerance, one or one for each state */            \
  ROW (maxstep, nonnegative, 0)     /* largest step [s]; 0: no limit */                            \
  ROW (maxsteps, steps, 0)          /* most steps; 0: no limit */                                  \
  ROW (timeout, nonnegative, 0)     /* wall time [s]; 0: no limit */                               \
  ROW (maxorder, any, none)         /* of implicit methods */                                      \
  ROW (loops, any, none)            /* constraint method */                                        \
  ROW (projection, flag, none)      /* older words for "loops" */                                  \
  ROW (drift, flag, none)           /* watch the constraints; true with loops */                   \
  ROW (input, any, none)            /* constants, piecewise polynomial or function */              \
  ROW (motion, any, none)           /* reference trajectory */                                     \
  ROW (gain, any, none)             /* state feedback about the reference */                       \
  ROW (reference, any, none)        /* the state that the feedback acts about */                   \
  ROW (limits, any, none)           /* of what the feedback gives */                               \
  ROW (breaks, list, none)          /* times at which inputs jump [s] */                           \
  ROW (memory, list, none)          /* of sampled devices */                                       \
  ROW (samples, flag, true)         /* record the instants of sampled devices */                   \
  ROW (modes, list, none)           /* of events of ports */                                       \
  ROW (audit, positive, none)       /* an energy that is usual in the scene [J] */                 \
  ROW (sensitivity, names, none)    /* derivatives by parameters and starts */                     \
  ROW (fixed, names, none)          /* coordinates held at the start meanwhile */                  \
  ROW (dx0, numbers, none)          /* derivatives at the start */                                 \
  ROW (start, start, check)         /* check x0, or move it onto the constraints */

/* ROW (kind, text): what a message expects of a value */
#define GS_KINDS(ROW)                                                                              \
  ROW (flag, "true or false")                                                                      \
  ROW (number, "a finite number")                                                                  \
  ROW (positive, "a finite number above 0")                                                        \
  ROW (nonnegative, "a finite number >= 0")                                                        \
  ROW (tolerance, "a number above 0 and below 1")                                                  \
  ROW (whole, "a whole number >= 0")                                                               \
  ROW (steps, "a whole number from 0 (no limit) to 2e9")                                           \
  ROW (numbers, "finite numbers")                                                                  \
  ROW (list, "a vector of finite numbers")                                                         \
  ROW (text, "a text")                                                                             \
  ROW (names, "a name or a list of names")

#define GS_STARTS(ROW)                                                                             \
  ROW (check, 0)                                                                                   \
  ROW (project, 1)

/* ROW (word, number): iopt[GS_LOOPS]; index2, of radau and auto alone, has that of projection */
#define GS_LOOP_METHODS(ROW)                                                                       \
  ROW (baumgarte, 1)                                                                               \
  ROW (projection, 2)                                                                              \
  ROW (partitioning, 3)                                                                            \
  ROW (nullspace, 4)                                                                               \
  ROW (svd, 5)                                                                                     \
  ROW (kane, 6)                                                                                    \
  ROW (index2, 2)

/* ROW (word): what goals and demands of a design say of a quantity over the times of a load case;
 * value, mass: of none */
#define GS_DESIGN_WORDS(ROW)                                                                       \
  ROW (start)                                                                                      \
  ROW (end)                                                                                        \
  ROW (mean)                                                                                       \
  ROW (integral)                                                                                   \
  ROW (drawn)    /* the integral where it is positive */                                           \
  ROW (square)   /* the mean of squares */                                                         \
  ROW (rms)                                                                                        \
  ROW (peak)     /* the largest modulus */                                                         \
  ROW (max)                                                                                        \
  ROW (min)                                                                                        \
  ROW (each)     /* at every time; of demands */                                                   \
  ROW (settling) /* the time until the modulus stays within a band */                              \
  ROW (value)    /* of a variable */                                                               \
  ROW (mass)     /* of links */

/* how a design is solved; how the best of the combinations of choices is found */
#define GS_DESIGN_SOLVERS(ROW)                                                                     \
  ROW (auto)                                                                                       \
  ROW (slsqp)                                                                                      \
  ROW (mma)                                                                                        \
  ROW (cobyla)                                                                                     \
  ROW (ipopt)
#define GS_DESIGN_CHOICES(ROW)                                                                     \
  ROW (auto)                                                                                       \
  ROW (all)                                                                                        \
  ROW (branch)

/* iopt: IOPT of gs_integrate */
enum
{
  GS_METHOD = 0, /* 4 classical Runge-Kutta, fixed step; 8 Dormand-Prince 8(5,3), step controlled; 9
                    as 8, but it ends where steps are found to be bound by stability */
  GS_LOOPS,      /* the way of the loops, see integrate.c: 1 Baumgarte, 2 projection, 3
                    partitioning, 4 null space, 5 zero-eigenvalue theorem, 6 Kane with dependent
                    speeds */
  GS_DRIFT,      /* 1: the drift of the constraints is recorded */
  GS_MOST_STEPS, /* the largest number of steps, 0 for no limit */
  GS_WATCH,      /* 1: positions where the constraints lose rank are watched for */
  GS_ON_SPEEDS   /* how many constraints are on speeds alone; their numbers, from 1, follow */
};
#endif
