/* gsmbp/reach.h: inverse kinematics. Calling rules: scene.h.
 *
 * Six joints: kind (6) is 1 where one turns, 0 where it slides; ka, pa (3,6) are the axes, unit
 * vectors, and points on them [m] where all coordinates are 0; r (3,3), p (3) the displacement
 * x -> r x + p that they shall make. Branches br are counted from 1. */
#ifndef GSMBP_REACH_H
#define GSMBP_REACH_H

#include "gsmbp/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* what the centre of a wrist misses of its place at the coordinates qa (n), and its Jacobian
 * jc (3,n) */
typedef void gs_ikc (const double *p, const double *r, const double *qg, const double *cst,
                     const double *qa, double *miss, double *jc);

/* of nb branches qc (n,nb) those that are real: the ns columns of qs (ldq,nb), their numbers br
 * (nb); rad (nm,nb), lim (nm), res (2,nb), dst (2), near as GSIKS. info: 1 there is none, 2 one is
 * singular */
int gsiks (int n, int nb, int nm, const double *qc, const double *rad, const double *lim,
           const double *res, double *qs, int ldq, int *ns, int *br, double *dst, int *near);

/* which of the ns columns of qs is q, to 1e-12, from 1; 0: none */
int gsikq (int n, const double *q, const double *qs, int ldq, int ns);

/* solutions of n (1 to 6) joints refined, and made complete close to singular ones; qs (n,nb),
 * ns, br, info as gsiks left them; info anew is returned */
int gsikz (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, int nb, int nm, const double *qc, const double *rad, const double *lim,
           double *qs, int *ns, int *br, int info);

/* gsikz of three joints that bring the point x0 (3; all coordinates 0) to the place r x0 + p; nb at
 * most 16 */
int gsipz (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
           const double *x0, int nb, int nm, const double *qc, const double *rad, const double *lim,
           double *qs, int *ns, int *br, int info);

/* for gsikz: the solutions that are there refined */
void gsik5 (int n, const int *kind, const double *ka, const double *pa, const double *r,
            const double *p, int nb, double *qs, int *ns, int *br);

/* for gsikz: the two solutions beside a singular position q0 (n), z (6) from gsiko; info anew is
 * returned */
int gsik4 (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, const double *q0, const double *z, int nb, double *qs, int *ns, int *br,
           int info);

/* for gsikz: the largest difference of two positions (n), modulo a turn */
double gsikk (int n, const int *kind, const double *q, const double *z);

/* for gsikz: the direction z (6) in which the tool moves least at q (n), the least singular value
 * beside the largest s */
void gsiko (int n, const int *kind, const double *ka, const double *pa, const double *r,
            const double *p, const double *q, double *z, double *s);

/* for gsikz: a solution q (6) put among the others if it is new, or in the place of one that is
 * the same and misses the pose by more */
int gsikp (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, const double *q, int nb, double *qs, int *ns, int *br, int info);

/* for gsikz: are the solutions q (6) and s (n) the same? closer: q misses the pose by less */
int gsik7 (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, const double *q, const double *s, int *closer);

/* for gsik7: the size of an arm and its pose, at least 1 */
double gsik0 (int n, const double *pa, const double *p);

/* for gsikz: solutions of six joints along the curve close to q0 (6) on which the tool hardly
 * moves; qw (6,400): the nw positions on curves so far; info anew is returned */
int gsik2 (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
           const double *q0, int nb, double *qs, int *ns, int *br, int info, int *nw, double *qw);

/* for gsik2: a position q (6) brought to the curve in at most m steps; z (6), u (6): the
 * direction of the curve and that in which the tool cannot move, on that side of what they were; g:
 * what is missed in direction u; s: the least singular value, with the sign that belongs to both */
void gsik3 (int m, const int *kind, const double *ka, const double *pa, const double *r,
            const double *p, double *q, double *z, double *u, double *g, double *s);

/* for gsik2: the length of the difference of two positions (6), modulo turns */
double gsik8 (const int *kind, const double *q, const double *z);

/* for gsik2: the solution between two positions of the curve, a and b along zb from qb, where ga
 * and gb of opposite signs are missed; qb, zb, ub as gsik3; info anew is returned */
int gsik9 (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
           const double *qb, const double *zb, const double *ub, double a, double ga, double b,
           double gb, int nb, double *qs, int *ns, int *br, int info);

/* for gsik2: the two solutions about a position of the curve, qb, zb, ub, gb as gsik3, where less
 * is missed than a step h before and behind; info anew is returned */
int gsiql (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
           const double *qb, const double *zb, const double *ub, double gb, double h, int nb,
           double *qs, int *ns, int *br, int info);

/* how far a place is from what the n (1 to 3) joints ahead of a wrist reach [m], from the nb
 * guesses qc (nc,nb), rows at+1 to at+n */
void gsikd (gs_ikc *ikc, int n, int nc, int nb, int at, const double *p, const double *r,
            const double *qg, const double *cst, const double *qc, double *dst);

/* how close six joints come to a pose out of reach, dst (2) [m, rad], from nb guesses qc (6,nb),
 * 0: eight of its own; x0 (3): the tool's point where all coordinates are 0 */
void gsiku (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
            const double *x0, int nb, const double *qc, double *dst);

/* for gsiku: the closest position near the guess q, what it misses e (6), and the square of that
 * */
void gsiky (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
            double *q, double *e, double *f);

/* sine and cosine sc (2,4) of the angles th at which co[0] cos 2th + co[1] sin 2th + co[2] cos
 * th + co[3] sin th + co[4] = 0; rad (4): -1 where there is none, 0 at a double one */
void gscir (const double *co, double *sc, double *rad);

/* for gscir: that sum and its derivative */
void gscif (const double *co, double th, double *f, double *fd);

/* for gscir: a (5), the polynomial of degree four of x = tan ((th - far)/2) */
void gsciq (const double *co, double size, double *far, double *a);

/* for gscir: the roots zr + i*zi (4) of a[0] + ... + a[4]*x**4 */
void gscie (const double *a, double *zr, double *zi);

/* coordinates q that bring point k (from 1) of npt to the place p and (job = 1) the axes r, from
 * a guess, within qlo and qhi, with the loops closed; iv (nq): the speeds (from 1) that are rates;
 * dst (2): what is missed; w as GSNIK. info: 1 not reached, < 0 as con */
int gsnik (const gs_scene *g, double t, int nq, int nu, int nlam, int npt, int k, int job,
           const double *p, const double *r, double *q, const double *qlo, const double *qhi,
           const int *iv, int ns, const int *iset, const double *cst, double *w, double *dst);

/* for gsnik: the same from the guess alone, to where nothing near comes closer; f: what q misses,
 * where phi counts wt times */
int gsnit (const gs_scene *g, double t, int nq, int nu, int nlam, int npt, int k, int job,
           const double *p, const double *r, double *q, const double *qlo, const double *qhi,
           const int *iv, int ns, const int *iset, const double *cst, double wt, double *w,
           double *wp, double *f, double *dst);

/* for gsnik: what a position misses, res (nr), its length f; u (nu): zeros. info as con */
int gsnir (const gs_scene *g, double t, int nu, int nlam, int npt, int k, int job,
           const double *p, const double *r, const double *q, const double *u, const double *cst,
           double wt, double *res, int nr, double *w, double *f, double *dst);

/* the rotation vector v that turns the axes s into r */
void gsniv (const double *r, const double *s, double *v);

/* for gsnik: the Jacobian j (nr,nu) of what gsnir gives. info as con */
int gsnij (const gs_scene *g, double t, const double *q, int nu, int nlam, int npt, int k, int job,
           const double *u, const double *cst, double wt, double *j, int nr, double *w);

/* for gsnik: a damped step from q to qn; a (nu,nu), s (nu), qdot (nq) are workspace */
void gsnis (const gs_scene *g, double t, int nq, int nu, int nr, const double *j,
            const double *res, double mu, const double *q, const double *qlo, const double *qhi,
            const int *iv, double *u, const double *cst, double *a, double *s, double *qn,
            double *qdot);

/* all angles qc (6,16) of six revolute joints in any position to each other, ns solutions,
 * rising; w: 1200, iw: 24. info: 2 a solution is singular */
int gsikg (const double *ka, const double *pa, const double *r, const double *p, double *qc,
           int *ns, double *w, int *iw);

/* for gsikg: its solutions made complete close to singular ones; info as gsikg */
int gsigc (const double *ka, const double *pa, const double *r, const double *p, double *qc,
           int *ns);

/* for gsikg: of ns solutions q (6,16) double ones made one; info as gsikg */
int gsigd (const double *ka, const double *pa, const double *r, const double *p, double *q,
           int *ns);

/* for gsikg and gsikz: info, or 2 where one of ns solutions qs (n,ns) is singular: the least
 * singular value of the Jacobian is at most 3e-8 of the largest */
int gsigs (int n, const int *kind, const double *ka, const double *pa, const double *r,
           const double *p, const double *qs, int ns, int info);

/* for gsikg: the last axis of a chain carried to its front by the displacement it makes */
void gsik6 (const double *r, const double *p, double *ka, double *pa);

/* for gsikg: gsik1 of an arm and of the same backwards; regular: how many were so, added up */
void gsikb (const double *ka, const double *pa, const double *r, const double *p, const double *k0,
            const double *p0, int l0, double *qc, int *ns, int *regular, double *w, int *iw);

/* for gsikg: solutions by one order of the joints, way = -1: backwards, l0 axes carried to the
 * front; k0, p0, r0, d0: in the order of the chain. info: 1 singular, 2 almost so */
int gsik1 (const double *ka, const double *pa, const double *r, const double *p, const double *k0,
           const double *p0, const double *r0, const double *d0, int way, int l0, double *qc,
           int *ns, double *w, int *iw);

/* a point x and a direction e turned about the axis k through p, sine s and cosine c */
void gsikt (const double *k, const double *p, double s, double c, double *x, double *e);

/* fourteen numbers v of a line, that displacements change linearly */
void gsikw (const double *x, const double *e, double *v);

/* values at 0, 90, 180 degrees in f (m*n,3,l) become coefficients of cosine, sine and 1 */
void gsikf (int m, int n, int l, double *f);

/* for gsikg: the numbers f (14,27) of axis 6 moved by joints 5, 4, 3 */
void gsikl (const double *ka, const double *pa, double *f);

/* for gsikg: those, g (14,9), of the line where it shall be, moved back by joints 1 and 2 */
void gsikr (const double *ka, const double *pa, const double *r, const double *p, double *g);

/* for gsikg: six equations h (6,9,3) without the angles 1 and 2; w: 322 */
void gsike (const double *f, const double *g, double *h, double *w);

/* for gsike: row i (from 1) of h (6,9) in half tangents, from b (6,3,3) */
void gsikh (const double *b, int i, double *h);

/* for gsikg: the matrix a (24,24) whose eigenvalues are half tangents of angle 3 from shift on;
 * s2 (12,12), x (12,24), iw (12) are workspace. info: 1 singular, 2 almost so */
int gsikc (const double *h, double *shift, double *a, double *s2, double *x, int *iw);

/* for gsikg: twelve equations s (12,12): those of cosine times a, of sine times b, of one times
 * c */
void gsikm (const double *h, double a, double b, double c, double *s);

/* for gsikg: the other angles of a candidate, whose angle 3 is in q (6); w: 500 */
void gsikv (const double *ka, const double *pa, const double *r, const double *f, const double *g,
            const double *h, double *q, double *w);

/* for gsikv: angles 4 and 5 from the products v (3,4) of their half tangents */
void gsikx (const double *v, double *q4, double *q5);

/* a candidate q (6; behind the n-th joint 0) refined; good: 1 if less than 1e-11 of the pose is
 * missed; w: 42, iw: 6 */
void gsikn (int n, const int *kind, const double *ka, const double *pa, const double *r,
            const double *p, double *q, double *w, int *iw, int *good);

/* for gsikn: the step in the place of what is missed, w (6,7) the Jacobian and that; info as
 * gsleq */
int gsiki (int n, double *w, int *iw);

/* for gsikn: the Jacobian rj (6,6), what is missed e (6), and the largest of it */
void gsikj (const int *kind, const double *ka, const double *pa, const double *r, const double *p,
            const double *q, double *rj, double *e, double *miss);

/* for gsikg: a solution put among the others, which rise */
void gsika (const double *q, double *qc, int *ns);

#ifdef __cplusplus
}
#endif
#endif
