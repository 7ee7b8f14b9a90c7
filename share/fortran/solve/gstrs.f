      SUBROUTINE GSTRS( N, M, L, LDL, B, LDB, TRANS )
C
C     PURPOSE
C     Triangular solve: B := inv(L)*B, or inv(L')*B where TRANS = 1.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of L, N >= 0.
C     M       (input) INTEGER, the number of columns of B, M >= 0.
C     L       (input) DOUBLE PRECISION array, dimension (LDL,N), lower
C             triangle; the strict upper triangle is not used.
C     LDL     (input) INTEGER, LDL >= MAX(1,N).
C     B       (input/output) DOUBLE PRECISION array, dimension (LDB,M).
C     LDB     (input) INTEGER, LDB >= MAX(1,N).
C     TRANS   (input) INTEGER, 0 for L, 1 for its transpose.
C
      IMPLICIT NONE
      INTEGER            N, M, LDL, LDB, TRANS
      DOUBLE PRECISION   L(LDL,*), B(LDB,*)
      DOUBLE PRECISION   R, S
      INTEGER            I, J, K
C
      IF ( TRANS.EQ.0 ) THEN
         DO 30 K = 1, N
            R = 1.0D0/L(K,K)
            DO 20 J = 1, M
               S = B(K,J)*R
               B(K,J) = S
               DO 10 I = K + 1, N
                  B(I,J) = B(I,J) - L(I,K)*S
   10          CONTINUE
   20       CONTINUE
   30    CONTINUE
      ELSE
         DO 60 K = N, 1, -1
            R = 1.0D0/L(K,K)
            DO 50 J = 1, M
               S = B(K,J)
               DO 40 I = K + 1, N
                  S = S - L(I,K)*B(I,J)
   40          CONTINUE
               B(K,J) = S*R
   50       CONTINUE
   60    CONTINUE
      END IF
      END
