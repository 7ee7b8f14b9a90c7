      DOUBLE PRECISION FUNCTION GSLFT( T, SIDE )
C
C     PURPOSE
C     The time that stands for T: with SIDE < 0, the limit from the
C     left, one just before it, so that what switches at T has not yet
C     switched; else T itself.
C
C     ARGUMENTS
C     T       (input) DOUBLE PRECISION, the time [s].
C     SIDE    (input) INTEGER, < 0: the limit from the left.
C
      IMPLICIT NONE
      INTEGER            SIDE
      DOUBLE PRECISION   T
      DOUBLE PRECISION   GSEPS
      EXTERNAL           GSEPS
C
      GSLFT = T
      IF ( SIDE.LT.0 ) GSLFT = T - MAX( 2.0D0*GSEPS()*ABS( T ),
     $                                  1.0D-300 )
      END
