      SUBROUTINE GSSCL( X, S, C )
C
C     PURPOSE
C     Sine and cosine of an angle by the library, see GSSC.
C
C     ARGUMENTS
C     X       (input) DOUBLE PRECISION, angle [rad].
C     S       (output) DOUBLE PRECISION, its sine.
C     C       (output) DOUBLE PRECISION, its cosine.
C
      IMPLICIT NONE
      DOUBLE PRECISION   X, S, C
      S = SIN(X)
      C = COS(X)
      END
