      INTEGER FUNCTION GSFIN( N, X )
C
C     PURPOSE
C     To find the first entry of X that is not a finite number.
C
C     ARGUMENTS
C     N       (input) INTEGER, the number of entries.
C     X       (input) DOUBLE PRECISION array, dimension (N).
C
C     RESULT
C     0 if every entry is finite, else the index of the first that is
C     infinite or no number.
C
C     METHOD
C     By magnitude: |X(I)| .LE. 1D300 fails for infinities and for what
C     is no number. Valid only where -ffast-math is not used.
C
      IMPLICIT NONE
      INTEGER            N, I
      DOUBLE PRECISION   X(*), BIG
      PARAMETER          ( BIG = 1.0D300 )
      GSFIN = 0
      DO 10 I = 1, N
         IF ( .NOT.( ABS( X(I) ).LE.BIG ) ) THEN
            GSFIN = I
            RETURN
         END IF
   10 CONTINUE
      END
