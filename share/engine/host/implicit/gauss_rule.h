/* The rule of collocation at the points of Gauss (gauss_rule.c), with what loops need beside it. */
#ifndef GS_HOST_GAUSS_RULE_H
#define GS_HOST_GAUSS_RULE_H

enum { GAUSS = 4 };   /* the most stages */
typedef long double longer;

/* X: the number A; LOST: what its rounding takes away */
static inline void
gs_round_off (longer a, double *x, double *lost)
{
  *x = (double) a;
  *lost = (double) (a - *x);
}

typedef struct
{
  int stages;
  longer c[GAUSS], a[GAUSS][GAUSS], b[GAUSS], ahead[GAUSS][GAUSS];   /* AHEAD: from step to step */
  /* of the points of Lobatto, one more than stages, the first of which is the start: the
     displacements there (TO, without the start), the impulses of forces that act there (at the
     stages FORCE, without the end; WEIGHT), what they displace, solved (BACK) */
  longer at[GAUSS + 1], weight[GAUSS + 1], to[GAUSS][GAUSS], force[GAUSS][GAUSS],
      back[GAUSS][GAUSS];
} gauss_rule;

extern void gsmbp_gauss_rule (gauss_rule *w, int order);
/* B: the weights of the stages up to the fraction AT of a step */
extern void gsmbp_gauss_weights (const gauss_rule *w, longer at, longer *b);
/* ... of the states at the start, the stages and the end, for the polynomial through them */
extern void gsmbp_gauss_values (const gauss_rule *w, longer at, longer *b);
#endif
