#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

#include <math.h>

/* A size is at least a millionth of the longest row's: a row that has always been nothing stays
 * nothing. */
void
gslpv (int nu, int nlam, const double *hc, double *size, double *y, double *piv, double *beta,
       double *d, int *rank, double *least)
{
  double big = 0.0;
  for (int i = 0; i < nlam; i++)
    {
      double s = 0.0;
      for (int j = 0; j < nu; j++)
        s += hc[i + nlam * j] * hc[i + nlam * j];
      size[i] = gs_max (size[i], sqrt (s));
      big = gs_max (big, size[i]);
    }
  if (! (big > 0.0))
    big = 1.0;
  for (int i = 0; i < nlam; i++)
    {
      size[i] = gs_max (size[i], 1e-6 * big);
      for (int j = 0; j < nu; j++)
        y[i + nlam * j] = hc[i + nlam * j] / size[i];
    }
  gsqrc (nlam, nu, y, nlam, 1e-7, piv, beta, d, rank);
  *least = *rank > 0 ? d[*rank - 1] / d[0] : 0.0;
}
