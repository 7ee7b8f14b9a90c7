/* gsmbp/refusals.h: why a run is refused before it begins, or warned of, in all hosts. ROW (name,
 * format): the format is that of C, Octave and Python; Octave reads the rows, Python has them from
 * its library. */
#ifndef GSMBP_REFUSALS_H
#define GSMBP_REFUSALS_H

#define GS_REFUSALS(ROW)                                                                           \
  ROW (parameter, "parameter %s must be one finite number, found: %s")                             \
  ROW (unchecked, "the scene was emitted without the subroutine %s, by which other values of its " \
       "parameters are checked: derive it again, without the option \"without\"")                  \
  ROW (not_real, "%s must be real and finite")                                                     \
  ROW (not_finite, "%s is not finite: %g")                                                         \
  ROW (largest_angle, "expected an angle of at most 1e15 rad, found %g")                           \
  ROW (off_constraints, "expected a state on the constraints at t = %.9g s, %s")                   \
  ROW (orientation, "expected Euler parameters of length 1, found (%s) = %s, which is no "         \
       "orientation")                                                                              \
  ROW (no_number, " (no number: an element has no direction there, as a disc that lies flat on "  \
       "its plane or a cylinder or spring between two points that coincide)")                     \
  ROW (outside, "; outside a margin: %s")                                                          \
  ROW (no_projection, "the start must be moved onto the constraints, which needs the subroutine " \
       "PRJ (request projection); %s was emitted without it")                                     \
  ROW (past_stop, "the start is beyond an end of the stop %s: expected %g to %g, found %g "        \
       "(m or rad)")                                                                               \
  ROW (device, "a device cannot be there: %s")                                                     \
  ROW (one_time, "the times must be two or more, that of x0 first; found %s")                      \
  ROW (times, "the times must be a vector of finite numbers, found %s")                            \
  ROW (rising_times, "the times must be strictly increasing; number %d is %.15g, the next "        \
       "%.15g")                                                                                    \
  ROW (atol, "expected one number or %d numbers, finite and >= 0, found %s")                       \
  ROW (too_many_steps, "%g s in steps of %g s are %.3g steps of %s; expected %.0e at the "         \
       "most: longer steps, or shorter runs")                                                      \
  ROW (loops, "must be one of %s; found: %s")                                                      \
  ROW (one_order, "method %s has one order alone, found %s")                                       \
  ROW (order, "expected one of %s, found %s")                                                      \
  ROW (index2_method, "the way \"index2\" of the loops is for method \"radau\" (or \"auto\"), " \
       "found method %s")                                                                          \
  ROW (no_loops, "%s has no loops; expected another way of them, or none, found \"index2\"")       \
  ROW (routine, "%s needs the subroutine %s, which %s was emitted without")                        \
  ROW (fixed, "expected %d of the coordinates, those that keep their place at the start "          \
       "(default: the actuated ones) and from which the motion of the others follows; found %s")   \
  ROW (no_loop_method, "%s was derived without the ways nullspace, svd and kane (it has no "       \
       "parameter loop_method): derive the scene again")                                           \
  ROW (no_sundials, "method \"cvode\" needs SUNDIALS 6 or 7, which is not installed (Debian: "     \
       "libsundials-dev)")                                                                         \
  ROW (no_ipopt, "Ipopt is not installed (Debian: coinor-libipopt-dev)")                           \
  ROW (no_nlopt, "NLopt is not installed (Debian: libnlopt-dev)")                                  \
  ROW (input, "expected %d finite numbers (%s), a piecewise polynomial, %s, found %s")             \
  ROW (given_mode, "the mode of %s is no input: expected 0 in its place, or that of option "       \
       "modes; found %g")                                                                          \
  ROW (wrong_mode, "expected %d of %s, %s; found %d")                                              \
  ROW (matrix, "expected %d x %d finite numbers or a piecewise polynomial, found %s")              \
  ROW (low_tolerance, "%s is below what %s precision can keep; it was raised to %.2g (atol: "      \
       "times m.nominal)")                                                                         \
  ROW (sharp_friction, "%s falls from its breakaway within vs = %.3g, the tolerance of its speed " \
       "(atol) is %.3g%s: %s may report events that are none; expected atol below vs, and vs at "  \
       "least %.3g; remedy: method \"auto\" or \"dp853\", or a larger vs")                         \
  ROW (gain_alone, "a gain needs a reference, the state about which it acts")                      \
  ROW (reference_alone, "a reference needs a gain, with which the inputs follow it")               \
  ROW (limits_alone, "bounds what a state feedback gives and needs option gain; without "          \
       "feedback give an input that keeps to its limits")                                          \
  ROW (limits_order, "of %s the lower limit must be below the upper one; found %g and %g")         \
  ROW (period, "%s: expected a period > 0 and a delay >= 0, found %g s and %g s")                  \
  ROW (too_many_samples, "%s: expected at most 2e9 samples before the start, found more")          \
  ROW (no_derivative, "the derivative of the %s by %s is not finite at this state (do two points " \
       "of a spring, damper or cylinder coincide, does an expression divide by 0 or take its "     \
       "root?); expected a state next to it")                                                      \
  ROW (singular_linear, "a linear model leaves out the motions that begin there; expected a "      \
       "state beside it")                                                                          \
  ROW (singular_rest, "multipliers are not determined there, and what balances them may be none " \
       "of an equilibrium; expected another guess")                                                \
  ROW (memory, "expected %d finite numbers, found %s")

#define GS_REFUSAL_MEMBER(name, text) const char *name;
#define GS_REFUSAL_TEXT(name, text) text,
static const struct { GS_REFUSALS (GS_REFUSAL_MEMBER) } gs_refusals
    = { GS_REFUSALS (GS_REFUSAL_TEXT) };
#endif
