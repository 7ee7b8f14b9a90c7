      SUBROUTINE GSCHF( N, A, LDA, INFO )
C
C     PURPOSE
C     Cholesky factor of a symmetric positive definite matrix.  Plain
C     body: GSCHP for every order.  Arguments as GSCHP.
C
      IMPLICIT NONE
      INTEGER            N, LDA, INFO
      DOUBLE PRECISION   A(LDA,*)
      CALL GSCHP( N, A, LDA, INFO )
      END
