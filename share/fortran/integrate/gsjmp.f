      SUBROUTINE GSJMP( NQ, NU, X, XN, RTOL, ATOL, JUMP )
C
C     PURPOSE
C     How far a coordinate, JUMP(1), and a speed, JUMP(2), may be moved
C     after the step from X to XN, so that it is no jump: a tenth of the
C     step's own move, or 100 times the tolerance of the largest, or
C     what rounding does to it close to a singular position (its root).
C
      IMPLICIT NONE
      INTEGER            NQ, NU
      DOUBLE PRECISION   X(*), XN(*), RTOL, ATOL(*), JUMP(2)
      DOUBLE PRECISION   GSEPS, ROOT
      EXTERNAL           GSEPS
      INTEGER            I, K
C
      ROOT    = 10.0D0*SQRT( GSEPS() )
      JUMP(1) = ROOT
      JUMP(2) = 0.0D0
      DO 10 I = 1, NQ + NU
         K = 1
         IF ( I.GT.NQ ) K = 2
         JUMP(K) = MAX( JUMP(K), 0.1D0*ABS( XN(I) - X(I) ),
     $             1.0D2*( ATOL(I) + RTOL*ABS( X(I) ) ),
     $             ROOT*ABS( X(I) ) )
   10 CONTINUE
      END
