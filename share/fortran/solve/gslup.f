      SUBROUTINE GSLUP( N, A, LDA, IW, INFO )
C
C     PURPOSE
C     A = P*L*U with partial pivoting, plain Fortran.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order, N >= 0.
C     A       (input/output) DOUBLE PRECISION array, dimension (LDA,N):
C             on exit U and, below the diagonal, the multipliers of L
C             (its unit diagonal is not stored), rows interchanged.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     IW      (output) INTEGER array, dimension (N): row K was
C             interchanged with row IW(K).
C     INFO    (output) INTEGER: 0, or the first k with a zero pivot.
C
      IMPLICIT NONE
      INTEGER            N, LDA, IW(*), INFO
      DOUBLE PRECISION   A(LDA,*)
      DOUBLE PRECISION   S
      INTEGER            I, J, K, P
C
      INFO = 0
      DO 60 K = 1, N
         P = K
         DO 10 I = K + 1, N
            IF ( ABS( A(I,K) ).GT.ABS( A(P,K) ) ) P = I
   10    CONTINUE
         IW(K) = P
         IF ( .NOT.( ABS( A(P,K) ).GT.0.0D0 ) ) THEN
            INFO = K
            RETURN
         END IF
         IF ( P.NE.K ) THEN
            DO 20 J = 1, N
               S = A(K,J)
               A(K,J) = A(P,J)
               A(P,J) = S
   20       CONTINUE
         END IF
         S = 1.0D0/A(K,K)
         DO 30 I = K + 1, N
            A(I,K) = A(I,K)*S
   30    CONTINUE
         DO 50 J = K + 1, N
            S = A(K,J)
            DO 40 I = K + 1, N
               A(I,J) = A(I,J) - A(I,K)*S
   40       CONTINUE
   50    CONTINUE
   60 CONTINUE
      END
