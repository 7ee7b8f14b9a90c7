      SUBROUTINE GSLUF( N, A, LDA, IW, INFO )
C
C     PURPOSE
C     A = P*L*U with partial pivoting.  Plain body: GSLUP for every
C     order.  Arguments as GSLUP.
C
      IMPLICIT NONE
      INTEGER            N, LDA, IW(*), INFO
      DOUBLE PRECISION   A(LDA,*)
      CALL GSLUP( N, A, LDA, IW, INFO )
      END
