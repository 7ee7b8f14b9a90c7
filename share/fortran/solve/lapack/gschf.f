      SUBROUTINE GSCHF( N, A, LDA, INFO )
C
C     PURPOSE
C     Cholesky factor of a symmetric positive definite matrix.  LAPACK
C     body: GSCHP where the order is small, else DPOTRF.  Arguments as
C     GSCHP.
C
      IMPLICIT NONE
      INTEGER            N, LDA, INFO
      DOUBLE PRECISION   A(LDA,*)
      DOUBLE PRECISION   GSEPS, S
      EXTERNAL           GSEPS, DPOTRF
      INTEGER            J, K, SMALL
      PARAMETER          ( SMALL = 100 )
C
      IF ( N.LE.SMALL ) THEN
         CALL GSCHP( N, A, LDA, INFO )
         RETURN
      END IF
      CALL DPOTRF( 'L', N, A, LDA, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 J = 1, N
         S = 0.0D0
         DO 10 K = 1, J
            S = S + A(J,K)*A(J,K)
   10    CONTINUE
         IF ( .NOT.( A(J,J)*A(J,J).GT.DBLE( N )*GSEPS()*S ) ) THEN
            INFO = J
            RETURN
         END IF
   20 CONTINUE
      END
