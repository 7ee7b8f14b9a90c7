      SUBROUTINE GSSTK( N, M, K, A, LDA, H, LDH, F, G, ACT, UD, LAM,
     $                  HOLD, W, INFO )
C
C     PURPOSE
C     Accelerations where some ports are held (friction that sticks,
C     contact that rests): the rows of H behind the constraints that are
C     active count as constraints, the others do not.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A.
C     M       (input) INTEGER, the number of constraints.
C     K       (input) INTEGER, the number of ports that may be held.
C     A, LDA, F as GSKKT.
C     H       (input/output) DOUBLE PRECISION array, dimension (LDH,N),
C             M + K rows; those that are not active are overwritten.
C     LDH     (input) INTEGER, LDH >= MAX(1,M+K).
C     G       (input/output) DOUBLE PRECISION array, dimension (M+K).
C     ACT     (input) INTEGER array, dimension (K), 1: held.
C     UD      (output) DOUBLE PRECISION array, dimension (N).
C     LAM     (output) DOUBLE PRECISION array, dimension (M).
C     HOLD    (output) DOUBLE PRECISION array, dimension (K): the effort
C             that holds each port, 0 where it is not held.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (N*N + N*(M+K) + (M+K)**2 + 2*N + 7*(M+K)).
C     INFO    (output) INTEGER, as GSKKT; dependent rows (two held ports
C             of a mechanism with one freedom) are no failure: 0. Their
C             efforts are those of least norm.
C
      IMPLICIT NONE
      INTEGER            N, M, K, LDA, LDH, ACT(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), UD(*), LAM(*),
     $                   HOLD(*), W(*)
      INTEGER            I, J, L
      EXTERNAL           GSKKT
C
      L = M
      DO 20 I = 1, K
         IF ( ACT(I).EQ.1 ) THEN
            L = L + 1
            DO 10 J = 1, N
               H(L,J) = H(M+I,J)
   10       CONTINUE
            G(L) = G(M+I)
         END IF
   20 CONTINUE
      CALL GSKKT( N, L, A, LDA, H, LDH, F, G, UD, W, W(M+K+1), INFO )
      IF ( INFO.EQ.2 .AND. L.GT.M ) INFO = 0
      DO 30 I = 1, M
         LAM(I) = W(I)
   30 CONTINUE
      L = M
      DO 40 I = 1, K
         HOLD(I) = 0.0D0
         IF ( ACT(I).EQ.1 ) THEN
            L = L + 1
            HOLD(I) = W(L)
         END IF
   40 CONTINUE
      END
