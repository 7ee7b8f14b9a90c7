      SUBROUTINE GSKKT( N, M, A, LDA, H, LDH, F, G, UD, LAM, W, INFO )
C
C     PURPOSE
C     Accelerations and multipliers of a system with constraints,
C        A*UD - H'*LAM = F,   H*UD = G.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A, N >= 0.
C     M       (input) INTEGER, the number of constraints, M >= 0.
C     A       (input) DOUBLE PRECISION array, dimension (LDA,N), the
C             mass matrix, symmetric positive definite (its lower
C             triangle is used).
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     H       (input) DOUBLE PRECISION array, dimension (LDH,N), the
C             constraint Jacobian, M rows.
C     LDH     (input) INTEGER, LDH >= MAX(1,M).
C     F       (input) DOUBLE PRECISION array, dimension (N).
C     G       (input) DOUBLE PRECISION array, dimension (M).
C     UD      (output) DOUBLE PRECISION array, dimension (N).
C     LAM     (output) DOUBLE PRECISION array, dimension (M).
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (N*N + N*M + M*M + 2*N + 6*M).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     A = L*L', Y = inv(L)*H' = Q*R with column pivoting; then
C     R'*w = G, R*LAM = w - Q'*inv(L)*F and UD follows.  Y'*Y, whose
C     condition is the square of that of Y, is never formed.  Dependent
C     constraints are left out of UD; LAM is then the multiplier of
C     least norm.
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = -i  argument i is out of range;
C     INFO = 1   A is not positive definite: UD, LAM are zero;
C     INFO = 2   the constraints are dependent (to about 1D-11): UD
C                fulfils the independent ones (and the others if they
C                are consistent), LAM is one of many.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), UD(*), LAM(*),
     $                   W(*)
      DOUBLE PRECISION   GSEPS, S, TOL
      EXTERNAL           GSEPS, GSCHF, GSTRS, GSQRP, GSQMV
      INTEGER            I, J, K, R, R2, IY, IT, IZ, IP, IB, IS, IC, IQ,
     $                   LD, LM
C
      INFO = 0
      IF ( N.LT.0 ) INFO = -1
      IF ( M.LT.0 ) INFO = -2
      IF ( LDA.LT.MAX( 1, N ) ) INFO = -4
      IF ( LDH.LT.MAX( 1, M ) ) INFO = -6
      IF ( INFO.NE.0 ) RETURN
C
C     -- workspace: L, Y, T, z, pivots, beta, sizes, w, spare
      LD = MAX( 1, N )
      LM = MAX( 1, M )
      IY = 1 + N*N
      IT = IY + N*M
      IZ = IT + M*M
      IP = IZ + 2*N
      IB = IP + M
      IS = IB + M
      IC = IS + M
      IQ = IC + M
C
C     -- A = L*L'
      DO 20 J = 1, N
         DO 10 I = J, N
            W(I+N*(J-1)) = A(I,J)
   10    CONTINUE
         UD(J) = 0.0D0
   20 CONTINUE
      DO 30 J = 1, M
         LAM(J) = 0.0D0
   30 CONTINUE
      CALL GSCHF( N, W, LD, INFO )
      IF ( INFO.NE.0 ) THEN
         INFO = 1
         RETURN
      END IF
C
C     -- z = inv(L)*F, Y = inv(L)*H' = Q*R
      DO 50 I = 1, N
         W(IZ+I-1) = F(I)
         DO 40 J = 1, M
            W(IY+I-1+N*(J-1)) = H(J,I)
   40    CONTINUE
   50 CONTINUE
      CALL GSTRS( N, 1, W, LD, W(IZ), LD, 0 )
      R = 0
      IF ( M.GT.0 ) THEN
         CALL GSTRS( N, M, W, LD, W(IY), LD, 0 )
         TOL = 5.0D4*GSEPS()
         CALL GSQRP( N, M, W(IY), LD, TOL, W(IP), W(IB), W(IS), R )
         CALL GSQMV( N, R, W(IY), LD, W(IB), W(IZ), 1 )
      END IF
C
C     -- R'*w = G, c = w - Q'*z
      DO 70 K = 1, R
         S = G(NINT( W(IP+K-1) ))
         DO 60 I = 1, K - 1
            S = S - W(IY+I-1+N*(K-1))*W(IQ+I-1)
   60    CONTINUE
         W(IQ+K-1) = S/W(IY+K-1+N*(K-1))
         W(IC+K-1) = W(IQ+K-1) - W(IZ+K-1)
   70 CONTINUE
      DO 80 K = 1, R
         W(IZ+K-1) = W(IQ+K-1)
   80 CONTINUE
      IF ( M.GT.0 ) CALL GSQMV( N, R, W(IY), LD, W(IB), W(IZ), 0 )
      CALL GSTRS( N, 1, W, LD, W(IZ), LD, 1 )
      DO 90 I = 1, N
         UD(I) = W(IZ+I-1)
   90 CONTINUE
C
C     -- R*y = c, LAM = P*y
      IF ( R.EQ.M ) THEN
         DO 110 K = R, 1, -1
            S = W(IC+K-1)/W(IY+K-1+N*(K-1))
            LAM(NINT( W(IP+K-1) )) = S
            DO 100 I = 1, K - 1
               W(IC+I-1) = W(IC+I-1) - W(IY+I-1+N*(K-1))*S
  100       CONTINUE
  110    CONTINUE
         RETURN
      END IF
C
C     -- fewer: T = (R rows)' = Q2*R2, y = Q2*inv(R2')*c
      INFO = 2
      IF ( R.EQ.0 ) RETURN
      DO 130 J = 1, R
         DO 120 I = 1, M
            W(IT+I-1+M*(J-1)) = 0.0D0
            IF ( I.GE.J ) W(IT+I-1+M*(J-1)) = W(IY+J-1+N*(I-1))
  120    CONTINUE
  130 CONTINUE
      CALL GSQRP( M, R, W(IT), LM, 0.0D0, W(IQ), W(IB), W(IS), R2 )
      DO 150 K = 1, R
         S = W(IC+NINT( W(IQ+K-1) )-1)
         DO 140 I = 1, K - 1
            S = S - W(IT+I-1+M*(K-1))*W(IS+I-1)
  140    CONTINUE
         W(IS+K-1) = S/W(IT+K-1+M*(K-1))
  150 CONTINUE
      DO 160 K = R + 1, M
         W(IS+K-1) = 0.0D0
  160 CONTINUE
      CALL GSQMV( M, R, W(IT), LM, W(IB), W(IS), 0 )
      DO 170 K = 1, M
         LAM(NINT( W(IP+K-1) )) = W(IS+K-1)
  170 CONTINUE
      END
