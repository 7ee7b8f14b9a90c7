      SUBROUTINE GSLUF( N, A, LDA, IW, INFO )
C
C     PURPOSE
C     A = P*L*U with partial pivoting.  LAPACK body: GSLUP where the
C     order is small, else DGETRF.  Arguments as GSLUP.
C
      IMPLICIT NONE
      INTEGER            N, LDA, IW(*), INFO
      DOUBLE PRECISION   A(LDA,*)
      EXTERNAL           DGETRF, GSLUP
      INTEGER            SMALL
      PARAMETER          ( SMALL = 100 )
C
      IF ( N.LE.SMALL ) THEN
         CALL GSLUP( N, A, LDA, IW, INFO )
      ELSE
         CALL DGETRF( N, N, A, LDA, IW, INFO )
      END IF
      END
