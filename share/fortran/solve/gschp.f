      SUBROUTINE GSCHP( N, A, LDA, INFO )
C
C     PURPOSE
C     Cholesky factor of a symmetric positive definite matrix,
C     A = L*L', plain Fortran.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order, N >= 0.
C     A       (input/output) DOUBLE PRECISION array, dimension (LDA,N):
C             on entry the lower triangle of A, on exit that of L.  The
C             strict upper triangle is not touched.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     INFO    (output) INTEGER: 0, or k > 0 if the k-th pivot is not
C             above N*eps times the k-th diagonal entry (A is not
C             positive definite to working precision, or holds what is
C             no number).
C
      IMPLICIT NONE
      INTEGER            N, LDA, INFO
      DOUBLE PRECISION   A(LDA,*)
      DOUBLE PRECISION   GSEPS, EPS, D, S
      EXTERNAL           GSEPS
      INTEGER            I, J, K
C
      INFO = 0
      EPS  = DBLE( N )*GSEPS()
      DO 50 J = 1, N
         S = A(J,J)
         D = S
         DO 10 K = 1, J - 1
            D = D - A(J,K)*A(J,K)
   10    CONTINUE
         IF ( .NOT.( D.GT.EPS*S .AND. D.LE.1.0D300 ) ) THEN
            INFO = J
            RETURN
         END IF
         D = SQRT( D )
         A(J,J) = D
         DO 30 K = 1, J - 1
            S = A(J,K)
            DO 20 I = J + 1, N
               A(I,J) = A(I,J) - A(I,K)*S
   20       CONTINUE
   30    CONTINUE
         D = 1.0D0/D
         DO 40 I = J + 1, N
            A(I,J) = A(I,J)*D
   40    CONTINUE
   50 CONTINUE
      END
