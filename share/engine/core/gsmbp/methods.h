/* gsmbp/methods.h: the methods of integration. Octave reads the rows, Python has them from its
 * library, and the manual's table is made of them (share/make/options). */
#ifndef GSMBP_METHODS_H
#define GSMBP_METHODS_H

/* ROW (word, number, steps, by, orders, order): number: iopt[GS_METHOD], 0: no steps of
 * gs_integrate; steps: controlled by the tolerances, or fixed, of the option step; by: gs_integrate
 * (core), gs_WORD of share/engine/host (engine), of a library by itself (library), gs_integrate and
 * from where its steps are bound by stability radau (both); orders: of the option maxorder, order:
 * its default */
#define GS_METHODS(ROW)                                                                            \
  ROW (dp853, 8, controlled, core, none, 0)         /* Dormand and Prince, order 8(5,3) */         \
  ROW (rk4, 4, fixed, core, none, 0)                /* classical Runge-Kutta, order 4 */           \
  ROW (cvode, 0, controlled, library, 1 2 3 4 5, 5) /* BDF of SUNDIALS, for stiff scenes */        \
  ROW (radau, 0, controlled, engine, 5 9 13, 13)    /* Radau IIA, for stiff scenes */              \
  ROW (gauss, 0, fixed, engine, 4 6 8, 6)           /* collocation of Gauss, keeps the energy */   \
  ROW (auto, 9, controlled, both, 5 9 13, 13)       /* dp853, then radau where it is stiff */
#endif
