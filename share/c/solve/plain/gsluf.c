#include "gsmbp/solve.h"

int
gsluf (int n, double *a, int lda, int *iw)
{
  return gslup (n, a, lda, iw);
}
