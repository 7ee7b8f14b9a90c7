      SUBROUTINE GSATL( Y, X, A )
C
C     PURPOSE
C     The angle of a point by the library, where GSATV cannot.
C
C     ARGUMENTS
C     Y, X    (input) DOUBLE PRECISION, the point.
C     A       (output) DOUBLE PRECISION, its angle from the axis of X
C             [rad].
C
C     METHOD
C     ATAN2, in a file of its own, so that no compiler puts functions for
C     vectors in its place, which have fewer digits.
C
      IMPLICIT NONE
      DOUBLE PRECISION   Y, X, A
C
      A = ATAN2( Y, X )
      END
