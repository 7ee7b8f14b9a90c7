#include "gsmbp/solve.h"

int
gsluf (int n, gs_real *a, int lda, int *iw)
{
  return gslup (n, a, lda, iw);
}
