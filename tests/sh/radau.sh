# The rules of radau_rule.c of share/engine/host/implicit: places in (0, 1], quadrature of the order
# 2*S - 1, stages of the order S, the inverse of A from its eigenvalues and eigenvectors, the rule
# of the estimate of the order S.
. tests/tools/check.sh
work_folder
home=share/engine/host/implicit

cat >"$work/rules.c" <<'EOF'
#include <math.h>
#include <stdio.h>
#include "radau_rule.h"

int
main (void)
{
  for (int s = 3; s <= 7; s += 2)
    {
      const radau_rule *r = gsmbp_radau_rule (s);
      double stages = 0, end = 0, inverse = 0, split = 0, weights = 0;
      for (int q = 1; q <= 2 * s - 1; q++)
        for (int i = 0; i < s; i++)
          {
            double sum = -pow (r->c[i + 1], q) / q;
            for (int j = 0; j < s; j++)
              sum += r->a[i][j] * pow (r->c[j + 1], q - 1);
            if (q <= s)
              stages = fmax (stages, fabs (sum));
            if (i == s - 1)
              end = fmax (end, fabs (sum));
          }
      for (int i = 0; i < s; i++)
        for (int j = 0; j < s; j++)
          {
            double one = -(i == j), a = r->root * r->right[i] * r->left[j] - r->inverse[i][j];
            for (int k = 0; k < s; k++)
              one += r->a[i][k] * r->inverse[k][j];
            for (int k = 0; k < r->pairs; k++)
              a += 2 * creal (r->roots[k] * r->rights[k][i] * r->lefts[k][j]);
            inverse = fmax (inverse, fabs (one));
            split = fmax (split, fabs (a));
          }
      for (int q = 1; q <= s; q++)   /* the rule that the error is estimated by */
        {
          double sum = (q == 1 ? 1 / r->root : 0) - 1.0 / q;
          for (int j = 0; j < s; j++)
            for (int i = 0; i < s; i++)
              sum += ((i == s - 1) + r->estimate[i]) * r->a[i][j] * pow (r->c[j + 1], q - 1);
          weights = fmax (weights, fabs (sum));
        }
      printf ("%d %d %d %d %d %d %d\n", s, stages < 1e-15, end < 1e-15, inverse < 1e-13,
              split < 1e-11, weights < 1e-14, r->c[0] == 0 && r->c[1] > 0 && r->c[s] == 1);
    }
  return 0;
}
EOF
gcc -std=gnu11 -Wall -Wextra -Werror -I$home -o "$work/rules" "$work/rules.c" \
  $home/radau_rule.c -lm >"$report" 2>&1
told $? 'the rules compile' "$report"
"$work/rules" >"$report"
for s in 3 5 7; do
  grep -qx "$s 1 1 1 1 1 1" "$report"
  told $? "the rule of $s stages has order $((2 * s - 1)), its stages order $s" "$report"
done

# Linear systems along lists: the residuals of systems of many shapes, real and complex; a pivot
# that vanishes or is small on the diagonal; places that appear later.
cat >"$work/solve.c" <<'EOF'
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "radau_solve.h"

enum { MOST = 40 };
static double J[MOST * MOST], ordered[MOST * MOST], lu[MOST * MOST], x[MOST], work[MOST];
static double complex clu[MOST * MOST], cx[MOST], cwork[MOST];
static int pivot[MOST];

/* the largest residual of (SHIFT - J) X = 1, 2, ...; the order is taken again where it has to be */
static double
residual (radau_order *o, double complex shift)
{
  int n = o->n;
  double worst = 0;
  gsmbp_take_order (o, J, ordered);
  if (gsmbp_real_factors (o, creal (shift), ordered, lu, pivot) == SMALL_PIVOT)
    {
      gsmbp_take_order (o, J, ordered);
      if (gsmbp_real_factors (o, creal (shift), ordered, lu, pivot) != 0)
        return 1;
    }
  if (gsmbp_complex_factors (o, shift, ordered, clu, pivot) != 0)
    return 1;
  for (int i = 0; i < n; i++)
    cx[i] = i + 1;
  gsmbp_complex_solve (o, clu, pivot, cx, cwork);
  if (gsmbp_real_factors (o, creal (shift), ordered, lu, pivot) != 0)
    return 1;
  for (int i = 0; i < n; i++)
    x[i] = i + 1;
  gsmbp_real_solve (o, lu, pivot, x, work);
  for (int i = 0; i < n; i++)
    {
      double r = creal (shift) * x[i] - (i + 1);
      double complex c = shift * cx[i] - (i + 1);
      for (int j = 0; j < n; j++)
        r -= J[i + n * j] * x[j], c -= J[i + n * j] * cx[j];
      worst = fmax (worst, fmax (fabs (r), cabs (c)) / (i + 1));
    }
  return worst;
}

int
main (void)
{
  double worst = 0;
  int lists = 0;
  srand (1);
  for (int turn = 0; turn < 400; turn++)
    {
      radau_order o;
      int n = 1 + rand () % MOST, apart = 1 + rand () % 8, full = rand () % 3;
      gsmbp_new_order (&o, n);
      for (int k = 0; k < 2; k++)   /* then with more places */
        {
          for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
              J[i + n * j] = (i / apart == j / apart || rand () % 40 < full + 2 * k)
                             * (rand () / (double) RAND_MAX - 0.5);
          worst = fmax (worst, residual (&o, 8 + 5 * I));
          lists += o.sparse > 0 && o.sparse < n;
        }
      gsmbp_free_order (&o);
    }
  printf ("%s %d\n", worst < 1e-12 ? "small" : "large", lists > 200);
  /* 2 - J of blocks of two with -1 across and hardly anything on the diagonal */
  double least[] = { 0, 1e-12, 1e-9, 1e-7 };
  for (int k = 0; k < 4; k++)
    {
      radau_order o;
      gsmbp_new_order (&o, 8);
      for (int i = 0; i < 8; i++)
        for (int j = 0; j < 8; j++)
          J[i + 8 * j] = i / 2 != j / 2 ? 0 : i == j ? 2 - least[k] : 1;
      double r = residual (&o, 2);
      printf ("%s %d\n", r < 1e-14 ? "small" : "large", o.sparse == 0 && o.plain);
      gsmbp_free_order (&o);
    }
  return 0;
}
EOF
gcc -std=gnu11 -O1 -fsanitize=address,undefined -Wall -Wextra -Werror -I$home \
  -o "$work/solve" "$work/solve.c" $home/radau_solve.c $home/radau_order.c -lm \
  >"$report" 2>&1
told $? 'the linear systems compile' "$report"
"$work/solve" >"$report" 2>&1
[ "$(tr '\n' ' ' <"$report")" = 'small 1 small 1 small 1 small 1 small 1 ' ]
told $? 'systems along lists have small residuals, also where pivots are small or vanish' \
  "$report"
