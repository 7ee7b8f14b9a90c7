/* gsmbp/reach.h: inverse kinematics. Calling rules: scene.h.
 *
 * Six joints: kind (6) is 1 where one turns, 0 where it slides; ka, pa (3,6) are the axes, unit
 * vectors, and points on them [m] where all coordinates are 0; r (3,3), p (3) the displacement
 * x -> r x + p that they shall make. Branches br are counted from 1. */
#ifndef GSMBP_REACH_H
#define GSMBP_REACH_H

#include "gsmbp/real.h"
#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* what the centre of a wrist misses of its place at the coordinates qa (n), and its Jacobian
 * jc (3,n) */
typedef void gs_ikc (const gs_real *p, const gs_real *r, const gs_real *qg, const gs_real *cst,
                     const gs_real *qa, gs_real *miss, gs_real *jc);

/* of nb branches qc (n,nb) those that are real: the ns columns of qs (ldq,nb), their numbers br
 * (nb); rad (nm,nb), lim (nm), res (2,nb), dst (2), near as gs_reach_branches. info: 1 there is
 * none, 2 one is singular */
int gs_reach_branches (int n, int nb, int nm, const gs_real *qc, const gs_real *rad,
                       const gs_real *lim, const gs_real *res, gs_real *qs, int ldq, int *ns,
                       int *br, gs_real *dst, int *near);

/* which of the ns columns of qs is q, to 1e-12, from 1; 0: none */
int gs_reach_which (int n, const gs_real *q, const gs_real *qs, int ldq, int ns);

/* solutions of n (1 to 6) joints refined, and made complete close to singular ones; qs (n,nb),
 * ns, br, info as gs_reach_branches left them; info anew is returned */
int gs_reach_refine (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                     const gs_real *p, int nb, int nm, const gs_real *qc, const gs_real *rad,
                     const gs_real *lim, gs_real *qs, int *ns, int *br, int info);

/* gs_reach_refine of three joints that bring the point x0 (3; all coordinates 0) to the place r x0
 * + p; nb at most 16 */
int gs_reach_refine_place (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                           const gs_real *p, const gs_real *x0, int nb, int nm, const gs_real *qc,
                           const gs_real *rad, const gs_real *lim, gs_real *qs, int *ns, int *br,
                           int info);

/* for gs_reach_refine: the solutions that are there refined */
void gs_reach_refine_all (int n, const int *kind, const gs_real *ka, const gs_real *pa,
                          const gs_real *r, const gs_real *p, int nb, gs_real *qs, int *ns,
                          int *br);

/* for gs_reach_refine: the two solutions beside a singular position q0 (n), z (6) from
 * gs_reach_least_move; info anew is returned */
int gs_reach_beside_singular (int n, const int *kind, const gs_real *ka, const gs_real *pa,
                              const gs_real *r, const gs_real *p, const gs_real *q0,
                              const gs_real *z, int nb, gs_real *qs, int *ns, int *br, int info);

/* for gs_reach_refine: the largest difference of two positions (n), modulo a turn */
gs_real gs_reach_difference (int n, const int *kind, const gs_real *q, const gs_real *z);

/* for gs_reach_refine: the direction z (6) in which the tool moves least at q (n), the least
 * singular value beside the largest s */
void gs_reach_least_move (int n, const int *kind, const gs_real *ka, const gs_real *pa,
                          const gs_real *r, const gs_real *p, const gs_real *q, gs_real *z,
                          gs_real *s);

/* for gs_reach_refine: a solution q (6) put among the others if it is new, or in the place of one
 * that is the same and misses the pose by more */
int gs_reach_put (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                  const gs_real *p, const gs_real *q, int nb, gs_real *qs, int *ns, int *br,
                  int info);

/* for gs_reach_refine: are the solutions q (6) and s (n) the same? closer: q misses the pose by
   less */
int gs_reach_same (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                   const gs_real *p, const gs_real *q, const gs_real *s, int *closer);

/* for gs_reach_same: the size of an arm and its pose, at least 1 */
gs_real gs_reach_size (int n, const gs_real *pa, const gs_real *p);

/* for gs_reach_refine: solutions of six joints along the curve close to q0 (6) on which the tool
 * hardly moves; qw (6,400): the nw positions on curves so far; info anew is returned */
int gs_reach_curve (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                    const gs_real *p, const gs_real *q0, int nb, gs_real *qs, int *ns, int *br,
                    int info, int *nw, gs_real *qw);

/* for gs_reach_curve: a position q (6) brought to the curve in at most m steps; z (6), u (6): the
 * direction of the curve and that in which the tool cannot move, on that side of what they were; g:
 * what is missed in direction u; s: the least singular value, with the sign that belongs to both */
void gs_reach_onto_curve (int m, const int *kind, const gs_real *ka, const gs_real *pa,
                          const gs_real *r, const gs_real *p, gs_real *q, gs_real *z, gs_real *u,
                          gs_real *g, gs_real *s);

/* for gs_reach_curve: the length of the difference of two positions (6), modulo turns */
gs_real gs_reach_distance (const int *kind, const gs_real *q, const gs_real *z);

/* for gs_reach_curve: the solution between two positions of the curve, a and b along zb from qb,
 * where ga and gb of opposite signs are missed; qb, zb, ub as gs_reach_onto_curve; info anew is
 * returned */
int gs_reach_between (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                      const gs_real *p, const gs_real *qb, const gs_real *zb, const gs_real *ub,
                      gs_real a, gs_real ga, gs_real b, gs_real gb, int nb, gs_real *qs, int *ns,
                      int *br, int info);

/* for gs_reach_curve: the two solutions about a position of the curve, qb, zb, ub, gb as
 * gs_reach_onto_curve, where less is missed than a step h before and behind; info anew is
 * returned */
int gs_reach_about (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                    const gs_real *p, const gs_real *qb, const gs_real *zb, const gs_real *ub,
                    gs_real gb, gs_real h, int nb, gs_real *qs, int *ns, int *br, int info);

/* how far a place is from what the n (1 to 3) joints ahead of a wrist reach [m], from the nb
 * guesses qc (nc,nb), rows at+1 to at+n */
void gs_reach_beyond (gs_ikc *ikc, int n, int nc, int nb, int at, const gs_real *p,
                      const gs_real *r, const gs_real *qg, const gs_real *cst, const gs_real *qc,
                      gs_real *dst);

/* how close six joints come to a pose out of reach, dst (2) [m, rad], from nb guesses qc (6,nb),
 * 0: eight of its own; x0 (3): the tool's point where all coordinates are 0 */
void gs_reach_closest (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                       const gs_real *p, const gs_real *x0, int nb, const gs_real *qc,
                       gs_real *dst);

/* for gs_reach_closest: the closest position near the guess q, what it misses e (6), and the square
 * of that */
void gs_reach_closest_near (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                            const gs_real *p, gs_real *q, gs_real *e, gs_real *f);

/* sine and cosine sc (2,4) of the angles th at which co[0] cos 2th + co[1] sin 2th + co[2] cos
 * th + co[3] sin th + co[4] = 0; rad (4): -1 where there is none, 0 at a double one */
void gs_circle_angles (const gs_real *co, gs_real *sc, gs_real *rad);

/* for gs_circle_angles: that sum and its derivative */
void gs_circle_sum (const gs_real *co, gs_real th, gs_real *f, gs_real *fd);

/* for gs_circle_angles: a (5), the polynomial of degree four of x = tan ((th - far)/2) */
void gs_circle_quartic (const gs_real *co, gs_real size, gs_real *far, gs_real *a);

/* for gs_circle_angles: the roots zr + i*zi (4) of a[0] + ... + a[4]*x**4 */
void gs_quartic_roots (const gs_real *a, gs_real *zr, gs_real *zi);

/* coordinates q that bring point k (from 1) of npt to the place p and (job = 1) the axes r, from
 * a guess, within qlo and qhi, with the loops closed; iv (nq): the speeds (from 1) that are rates;
 * dst (2): what is missed; w as gs_reach_point. info: 1 not reached, < 0 as con */
int gs_reach_point (const gs_scene *g, gs_real t, int nq, int nu, int nlam, int npt, int k, int job,
                    const gs_real *p, const gs_real *r, gs_real *q, const gs_real *qlo,
                    const gs_real *qhi, const int *iv, int ns, const int *iset, const gs_real *cst,
                    gs_real *w, gs_real *dst);

/* for gs_reach_point: the same from the guess alone, to where nothing near comes closer; f: what q
 * misses, where phi counts wt times */
int gs_reach_point_near (const gs_scene *g, gs_real t, int nq, int nu, int nlam, int npt, int k,
                         int job, const gs_real *p, const gs_real *r, gs_real *q,
                         const gs_real *qlo, const gs_real *qhi, const int *iv, int ns,
                         const int *iset, const gs_real *cst, gs_real wt, gs_real *w, gs_real *wp,
                         gs_real *f, gs_real *dst);

/* for gs_reach_point: what a position misses, res (nr), its length f; u (nu): zeros. info as con */
int gs_reach_missed (const gs_scene *g, gs_real t, int nu, int nlam, int npt, int k, int job,
                     const gs_real *p, const gs_real *r, const gs_real *q, const gs_real *u,
                     const gs_real *cst, gs_real wt, gs_real *res, int nr, gs_real *w, gs_real *f,
                     gs_real *dst);

/* the rotation vector v that turns the axes s into r */
void gs_rotation_vector (const gs_real *r, const gs_real *s, gs_real *v);

/* for gs_reach_point: the Jacobian j (nr,nu) of what gs_reach_missed gives. info as con */
int gs_reach_jacobian (const gs_scene *g, gs_real t, const gs_real *q, int nu, int nlam, int npt,
                       int k, int job, const gs_real *u, const gs_real *cst, gs_real wt, gs_real *j,
                       int nr, gs_real *w);

/* for gs_reach_point: a damped step from q to qn; a (nu,nu), s (nu), qdot (nq) are workspace */
void gs_reach_step (const gs_scene *g, gs_real t, int nq, int nu, int nr, const gs_real *j,
                    const gs_real *res, gs_real mu, const gs_real *q, const gs_real *qlo,
                    const gs_real *qhi, const int *iv, gs_real *u, const gs_real *cst, gs_real *a,
                    gs_real *s, gs_real *qn, gs_real *qdot);

/* all angles qc (6,16) of six revolute joints in any position to each other, ns solutions,
 * rising; w: 1200, iw: 24. info: 2 a solution is singular */
int gs_arm_angles (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                   gs_real *qc, int *ns, gs_real *w, int *iw);

/* for gs_arm_angles: its solutions made complete close to singular ones; info as gs_arm_angles */
int gs_arm_complete (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                     gs_real *qc, int *ns);

/* for gs_arm_angles: of ns solutions q (6,16) double ones made one; info as gs_arm_angles */
int gs_arm_doubles (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                    gs_real *q, int *ns);

/* for gs_arm_angles and gs_reach_refine: info, or 2 where one of ns solutions qs (n,ns) is
 * singular: the least singular value of the Jacobian is at most 3e-8 of the largest */
int gs_arm_singular (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                     const gs_real *p, const gs_real *qs, int ns, int info);

/* for gs_arm_angles: the last axis of a chain carried to its front by the displacement it makes */
void gs_arm_last_to_front (const gs_real *r, const gs_real *p, gs_real *ka, gs_real *pa);

/* for gs_arm_angles: gs_arm_one_order of an arm and of the same backwards; regular: how many were
   so, added up */
void gs_arm_both_ways (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                       const gs_real *k0, const gs_real *p0, int l0, gs_real *qc, int *ns,
                       int *regular, gs_real *w, int *iw);

/* for gs_arm_angles: solutions by one order of the joints, way = -1: backwards, l0 axes carried to
 * the front; k0, p0, r0, d0: in the order of the chain. info: 1 singular, 2 almost so */
int gs_arm_one_order (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                      const gs_real *k0, const gs_real *p0, const gs_real *r0, const gs_real *d0,
                      int way, int l0, gs_real *qc, int *ns, gs_real *w, int *iw);

/* a point x and a direction e turned about the axis k through p, sine s and cosine c */
void gs_turn_line (const gs_real *k, const gs_real *p, gs_real s, gs_real c, gs_real *x,
                   gs_real *e);

/* fourteen numbers v of a line, that displacements change linearly */
void gs_line_numbers (const gs_real *x, const gs_real *e, gs_real *v);

/* values at 0, 90, 180 degrees in f (m*n,3,l) become coefficients of cosine, sine and 1 */
void gs_fourier_coefficients (int m, int n, int l, gs_real *f);

/* for gs_arm_angles: the numbers f (14,27) of axis 6 moved by joints 5, 4, 3 */
void gs_arm_left_lines (const gs_real *ka, const gs_real *pa, gs_real *f);

/* for gs_arm_angles: those, g (14,9), of the line where it shall be, moved back by joints 1 and
   2 */
void gs_arm_right_lines (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *p,
                         gs_real *g);

/* for gs_arm_angles: six equations h (6,9,3) without the angles 1 and 2; w: 322 */
void gs_arm_equations (const gs_real *f, const gs_real *g, gs_real *h, gs_real *w);

/* for gs_arm_equations: row i (from 1) of h (6,9) in half tangents, from b (6,3,3) */
void gs_arm_half_tangents (const gs_real *b, int i, gs_real *h);

/* for gs_arm_angles: the matrix a (24,24) whose eigenvalues are half tangents of angle 3 from shift
 * on; s2 (12,12), x (12,24), iw (12) are workspace. info: 1 singular, 2 almost so */
int gs_arm_matrix (const gs_real *h, gs_real *shift, gs_real *a, gs_real *s2, gs_real *x, int *iw);

/* for gs_arm_angles: twelve equations s (12,12): those of cosine times a, of sine times b, of one
 * times c */
void gs_arm_twelve (const gs_real *h, gs_real a, gs_real b, gs_real c, gs_real *s);

/* for gs_arm_angles: the other angles of a candidate, whose angle 3 is in q (6); w: 500 */
void gs_arm_candidate (const gs_real *ka, const gs_real *pa, const gs_real *r, const gs_real *f,
                       const gs_real *g, const gs_real *h, gs_real *q, gs_real *w);

/* for gs_arm_candidate: angles 4 and 5 from the products v (3,4) of their half tangents */
void gs_arm_two_angles (const gs_real *v, gs_real *q4, gs_real *q5);

/* a candidate q (6; behind the n-th joint 0) refined; good: 1 if less than 1e-11 of the pose is
 * missed; w: 42, iw: 6 */
void gs_arm_refine (int n, const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                    const gs_real *p, gs_real *q, gs_real *w, int *iw, int *good);

/* for gs_arm_refine: the step in the place of what is missed, w (6,7) the Jacobian and that; info
 * as gs_solve_general */
int gs_arm_refine_step (int n, gs_real *w, int *iw);

/* for gs_arm_refine: the Jacobian rj (6,6), what is missed e (6), and the largest of it */
void gs_arm_missed (const int *kind, const gs_real *ka, const gs_real *pa, const gs_real *r,
                    const gs_real *p, const gs_real *q, gs_real *rj, gs_real *e, gs_real *miss);

/* for gs_arm_angles: a solution put among the others, which rise */
void gs_arm_add (const gs_real *q, gs_real *qc, int *ns);

#ifdef __cplusplus
}
#endif
#endif
