#include "gsmbp/arith.h"
#include "gsmbp/loops.h"
#include "gsmbp/solve.h"

/* A size is at least a millionth of the longest row's: a row that has always been nothing stays
 * nothing. */
void
gs_constraint_pivots (int nu, int nlam, const gs_real *hc, gs_real *size, gs_real *y, gs_real *piv,
                      gs_real *beta, gs_real *d, int *rank, gs_real *least)
{
  gs_real big = 0;
  for (int i = 0; i < nlam; i++)
    {
      gs_real s = 0;
      for (int j = 0; j < nu; j++)
        s += hc[i + nlam * j] * hc[i + nlam * j];
      size[i] = gs_max (size[i], gs_sqrt (s));
      big = gs_max (big, size[i]);
    }
  if (! (big > 0))
    big = 1;
  for (int i = 0; i < nlam; i++)
    {
      size[i] = gs_max (size[i], GS_R2 (1e-6, 1e-3) * big);
      for (int j = 0; j < nu; j++)
        y[i + nlam * j] = hc[i + nlam * j] / size[i];
    }
  gs_qr_columns (nlam, nu, y, nlam, GS_R2 (1e-7, 1e-4), piv, beta, d, rank);
  *least = *rank > 0 ? d[*rank - 1] / d[0] : 0;
}
