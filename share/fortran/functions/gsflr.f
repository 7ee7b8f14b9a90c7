      DOUBLE PRECISION FUNCTION GSFLR( X )
C
C     PURPOSE
C     The largest whole number that is not above X.
C
      IMPLICIT NONE
      DOUBLE PRECISION   X
      GSFLR = AINT( X )
      IF ( GSFLR.GT.X ) GSFLR = GSFLR - 1.0D0
      END
