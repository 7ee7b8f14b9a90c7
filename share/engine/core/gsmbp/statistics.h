/* gsmbp/statistics.h: what a run counts and measures: one row for each number of ISTAT and RSTAT of
 * gs_integrate. ROW (constant, name): the place in istat or rstat, the name in Octave and
 * Python. */
#ifndef GSMBP_STATISTICS_H
#define GSMBP_STATISTICS_H

/* istat */
#define GS_COUNTS(ROW)                                                                             \
  ROW (GS_N_RHS, calls)                           /* calls of rhs */                               \
  ROW (GS_N_STEPS, accepted)                      /* accepted steps */                             \
  ROW (GS_N_REJECTED, rejected)                   /* rejected steps */                             \
  ROW (GS_N_PROJECTIONS, projections)             /* calls of prj */                               \
  ROW (GS_N_OUTPUTS, outputs)                     /* output times reached */                       \
  ROW (GS_FAILED_INFO, failed_info)               /* info of the routine that failed */            \
  ROW (GS_FAILED, failed)                         /* which one, see failures.h */                  \
  ROW (GS_N_RANK_LOST, rank_losses)               /* calls of rhs where constraints lost rank */   \
  ROW (GS_N_ANGLES, angle_singularities)          /* ... near a singularity of angles */           \
  ROW (GS_N_PARTITIONS, partition_changes)        /* choices of other independent speeds */        \
  ROW (GS_N_PASSED, singular_positions)           /* positions passed where they lose rank */      \
  ROW (GS_N_REPEATED, repeated)                   /* rejected steps that could not be moved onto   \
                                                     the constraints, or only by a jump, or were   \
                                                     too close to a singular position */           \
  ROW (GS_N_STABILITY, stability_calls)           /* calls of rhs that looked for such bounds */   \
  ROW (GS_IS_STIFF, stiff)                        /* 1 if steps are bound by stability, and */     \
  ROW (GS_STIFF_STATE, stiff_state)               /* the state (from 1) of the eigenvalue */       \
  ROW (GS_N_JACOBIANS, jacobians)                 /* implicit: evaluations of the Jacobian */      \
  ROW (GS_N_NEWTON, newton)                       /* ... iterations of Newton's method */          \
  ROW (GS_N_DIVERGED, diverged)                   /* ... steps in which it did not converge */     \
  ROW (GS_CAUSE, cause)                           /* the event that failed, 0: none did; the flag  \
                                                     of an implicit method that stopped */         \
  ROW (GS_N_LOOSE, loose)                         /* steps close to singular positions whose error \
                                                     is above the tolerance; method 4: that end in \
                                                     one */

/* rstat */
#define GS_VALUES(ROW)                                                                             \
  ROW (GS_R_PHI, phi)                             /* largest |phi| and */                          \
  ROW (GS_R_RATE, phidot)                         /* largest |HC*u + phit| after any step; */      \
  ROW (GS_T_PHI, phi_at)                          /* when */                                       \
  ROW (GS_T_RATE, phidot_at)                      /* ... [s] */                                    \
  ROW (GS_R_BEFORE, before_projection)            /* largest |phi| before a projection */          \
  ROW (GS_H_LEAST, smallest_step)                 /* of the accepted ones [s] */                   \
  ROW (GS_H_LARGEST, largest_step)                /* ... [s] */                                    \
  ROW (GS_T_REACHED, reached)                     /* time reached [s] */                           \
  ROW (GS_H_NEXT, next_step)                      /* that method 8 would take [s] */               \
  ROW (GS_T_RANK_LOST, first_rank_loss)           /* times of GS_N_RANK_LOST [s] */                \
  ROW (GS_T_RANK_LOST_LAST, last_rank_loss)                                                        \
  ROW (GS_T_ANGLES, first_angles)                 /* times of GS_N_ANGLES [s] */                   \
  ROW (GS_T_ANGLES_LAST, last_angles)                                                              \
  ROW (GS_R_PIVOT, least_pivot)                   /* of constraints, relative to the largest */    \
  ROW (GS_T_PIVOT, least_pivot_at)                /* ... and when [s] */                           \
  ROW (GS_T_PASSED, first_singular)               /* times of GS_N_PASSED [s] */                   \
  ROW (GS_T_PASSED_LAST, last_singular)                                                            \
  ROW (GS_T_STIFF, stiff_at)                      /* when steps were found to be bound by          \
                                                     stability [s], */                             \
  ROW (GS_R_STIFF, stiff_eigenvalue)              /* the largest eigenvalue [1/s] */               \
  ROW (GS_H_STIFF, stiff_step)                    /* and the step [s] */

#define GS_ROW_CONSTANT(constant, name) constant,
enum { GS_COUNTS (GS_ROW_CONSTANT) GS_COUNTED };
enum { GS_VALUES (GS_ROW_CONSTANT) GS_MEASURED };

/* the memory of gs_watch_stiffness, of explicit methods: steps that looked bound by stability,
 * steps since that did not, when the next look is due */
enum { GS_SEEN_STIFF = GS_N_JACOBIANS, GS_SEEN_FREE, GS_NEXT_LOOK };
#endif
