#include "gsmbp/solve.h"

int
gschf (int n, gs_real *a, int lda)
{
  return gschp (n, a, lda);
}
