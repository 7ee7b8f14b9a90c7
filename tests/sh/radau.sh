# The rules of octave/glue/radau_rule.c: places in (0, 1], quadrature of the order 2*S - 1, stages
# of the order S, the inverse of A from its eigenvalues and eigenvectors.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/report

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
      double stages = 0, end = 0, inverse = 0, split = 0;
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
      printf ("%d %d %d %d %d %d\n", s, stages < 1e-15, end < 1e-15, inverse < 1e-13,
              split < 1e-11, r->c[0] == 0 && r->c[1] > 0 && r->c[s] == 1);
    }
  return 0;
}
EOF
gcc -std=gnu11 -Wall -Wextra -Werror -Ioctave/glue -o "$work/rules" "$work/rules.c" \
  octave/glue/radau_rule.c -lm >"$report" 2>&1
told $? 'the rules compile' "$report"
"$work/rules" >"$report"
for s in 3 5 7; do
  grep -qx "$s 1 1 1 1 1" "$report"
  told $? "the rule of $s stages has order $((2 * s - 1)), its stages order $s" "$report"
done
