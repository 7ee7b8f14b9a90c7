      DOUBLE PRECISION FUNCTION GSEPS( )
C
C     PURPOSE
C     The distance from 1 to the next larger number of the precision
C     that this file is compiled in: 2.2D-16, or 1.9D-34 where it is
C     built with -freal-8-real-16.
C
      IMPLICIT NONE
      DOUBLE PRECISION   THIRDS
      THIRDS = 4.0D0/3.0D0
      GSEPS  = ABS( 3.0D0*( THIRDS - 1.0D0 ) - 1.0D0 )
      END
