#include "gsmbp/solve.h"

int
gschf (int n, double *a, int lda)
{
  return gschp (n, a, lda);
}
