      SUBROUTINE GSKKT( N, M, A, LDA, H, LDH, F, G, UD, LAM, W, INFO )
C
C     PURPOSE
C     GSKKR for rows that are measured each by itself and known to
C     rounding errors: INFO = 2 where they are dependent to about 1D-11.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), UD(*), LAM(*),
     $                   W(*)
      DOUBLE PRECISION   GSEPS
      INTEGER            GRP(1)
      EXTERNAL           GSEPS, GSKKR
C
      GRP(1) = 0
      CALL GSKKR( N, M, A, LDA, H, LDH, F, G, 5.0D4*GSEPS(), GRP, UD,
     $            LAM, W, INFO )
      END
      SUBROUTINE GSKKR( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $                  W, INFO )
C
C     PURPOSE
C     Accelerations and multipliers of a system with constraints,
C        A*UD - H'*LAM = F,   H*UD = G.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A, N >= 0.
C     M       (input) INTEGER, the number of constraints, M >= 0.
C     A       (input) DOUBLE PRECISION array, dimension (LDA,N), the
C             mass matrix, symmetric and positive definite, or only
C             positive semidefinite (massless links) if no motion that
C             H allows is without mass.  Its lower triangle is used.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     H       (input) DOUBLE PRECISION array, dimension (LDH,N), the
C             constraint Jacobian, M rows.
C     LDH     (input) INTEGER, LDH >= MAX(1,M).
C     F       (input) DOUBLE PRECISION array, dimension (N).
C     G       (input) DOUBLE PRECISION array, dimension (M).
C     TOL     (input) DOUBLE PRECISION: a row of H of which no more than
C             TOL times its size is left beside those before it, in the
C             metric of the inverse of A, is dependent (GSRTL).
C     GRP     (input) INTEGER array, dimension (M): the size of a row is
C             the largest length in its group, see GSQRG.  The
C             components of one vector of a joint are a group: a short
C             one of them is known no better than the longest.
C             GRP(1) = 0: every row is measured by itself.
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
C     Where a pivot of L is tiny, A is replaced by A + H'*D*H and F by
C     F + H'*D*G, which has the same solution: D is diagonal, of the
C     size of A.  Where constraints are dependent as well, G may not fit
C     all of them: LAM then follows from UD and A, F alone (GSLAM).
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = -i  argument i is out of range;
C     INFO = 1   A is not positive definite, not even on the motions
C                that H allows: UD, LAM are zero;
C     INFO = 2   the constraints are dependent (to TOL): UD
C                fulfils the independent ones (and the others if they
C                are consistent), LAM is one of many.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), TOL, UD(*),
     $                   LAM(*), W(*)
      DOUBLE PRECISION   GSEPS, S, SMALL
      EXTERNAL           GSEPS, GSCHF, GSTRS, GSQRG, GSQMV, GSAUG,
     $                   GSLNM, GSLAM
      INTEGER            I, J, K, TINY, R, IY, IT, IZ, IP, IB, IS, IC,
     $                   IQ, LD
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
      SMALL = 1.0D4*DBLE( N )*GSEPS()
      TINY = INFO
      DO 35 J = 1, N
         IF ( INFO.EQ.0 ) THEN
            IF ( W(J+N*(J-1))**2.LE.SMALL*A(J,J) ) TINY = J
         END IF
         W(IZ+J-1) = F(J)
   35 CONTINUE
      IF ( TINY.NE.0 ) THEN
         CALL GSAUG( N, M, A, LDA, H, LDH, G, GRP, W, LD, W(IZ), W(IY),
     $               W(IS), INFO )
         IF ( INFO.NE.0 ) THEN
            INFO = 1
            RETURN
         END IF
      END IF
C
C     -- z = inv(L)*F, Y = inv(L)*H' = Q*R
      DO 50 I = 1, N
         DO 40 J = 1, M
            W(IY+I-1+N*(J-1)) = H(J,I)
   40    CONTINUE
   50 CONTINUE
      CALL GSTRS( N, 1, W, LD, W(IZ), LD, 0 )
      R = 0
      IF ( M.GT.0 ) THEN
         CALL GSTRS( N, M, W, LD, W(IY), LD, 0 )
         CALL GSQRG( N, M, W(IY), LD, TOL, GRP, W(IP), W(IB), W(IS), R )
         CALL GSQMV( N, R, W(IY), LD, W(IB), W(IZ), 1 )
      END IF
C
C     -- R'*w = G, c = w - Q'*z
      DO 70 K = 1, R
         S = G(INT( W(IP+K-1) ))
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
            LAM(INT( W(IP+K-1) )) = S
            DO 100 I = 1, K - 1
               W(IC+I-1) = W(IC+I-1) - W(IY+I-1+N*(K-1))*S
  100       CONTINUE
  110    CONTINUE
         RETURN
      END IF
C
C     -- fewer
      INFO = 2
      IF ( TINY.NE.0 ) THEN
         CALL GSLAM( N, M, A, LDA, H, LDH, F, TOL, GRP, UD, LAM, W )
      ELSE
         CALL GSLNM( M, R, W(IY), LD, W(IP), W(IC), LAM, W(IT), W(IQ),
     $               W(IB), W(IS) )
      END IF
      END
      SUBROUTINE GSAUG( N, M, A, LDA, H, LDH, G, GRP, L, LDL, Z, Y, D,
     $                  INFO )
C
C     PURPOSE
C     L*L' = A + H'*D*D*H and Z := Z + H'*D*D*G for GSKKR, where A alone
C     has no safe factor; D(i)**2 = max(A(j,j))/size(i)**2, the sizes of
C     GSROW: a row of rounding errors must not count as a constraint.
C
C     ARGUMENTS
C     As GSKKR, and
C     L       (input/output) DOUBLE PRECISION array, dimension (LDL,N):
C             on entry the factor of A alone if INFO = 0.  It is kept,
C             and Z as well, if its worst pivot is the better one.
C     Z       (input/output) DOUBLE PRECISION array, dimension (2*N):
C             the second half is workspace.
C     Y, D    (workspace) DOUBLE PRECISION arrays, dimension (M,N), (M).
C     INFO    (input/output) INTEGER, on entry that of GSCHF on A alone,
C             on exit 0, or > 0 if neither matrix is positive definite.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*), LDL, INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), G(*), L(LDL,*), Z(*),
     $                   Y(M,*), D(*)
      DOUBLE PRECISION   GSEPS, S, BIG, FIRST, WORST, TOL
      EXTERNAL           GSEPS, GSCHF, GSROW
      INTEGER            I, J, K
C
C     -- the worst pivot of A alone, the size of A
      FIRST = 0.0D0
      BIG   = 0.0D0
      IF ( INFO.EQ.0 ) FIRST = 1.0D0
      DO 20 J = 1, N
         BIG = MAX( BIG, A(J,J) )
         IF ( INFO.EQ.0 ) FIRST = MIN( FIRST, L(J,J)**2/A(J,J) )
         DO 10 I = J, N
            L(I,J) = A(I,J)
   10    CONTINUE
   20 CONTINUE
      IF ( .NOT.( BIG.GT.0.0D0 ) ) BIG = 1.0D0
C
C     -- with the constraints
      CALL GSROW( N, M, H, LDH, GRP, Y, D )
      DO 60 K = 1, M
         DO 50 J = 1, N
            S = BIG*Y(K,J)
            Z(J) = Z(J) + S*D(K)*G(K)
            DO 40 I = J, N
               L(I,J) = L(I,J) + S*Y(K,I)
   40       CONTINUE
   50    CONTINUE
   60 CONTINUE
      DO 70 J = 1, N
         Z(N+J) = L(J,J)
   70 CONTINUE
      CALL GSCHF( N, L, LDL, INFO )
      WORST = 0.0D0
      IF ( INFO.EQ.0 ) THEN
         WORST = 1.0D0
         DO 80 J = 1, N
            WORST = MIN( WORST, L(J,J)**2/Z(N+J) )
   80    CONTINUE
      END IF
      INFO = 0
      TOL = 1.0D2*DBLE( N )*GSEPS()
      IF ( WORST.GE.FIRST .AND. WORST.GT.TOL ) RETURN
C
C     -- they do not help: A alone
      DO 100 J = 1, N
         DO 90 I = J, N
            L(I,J) = A(I,J)
   90    CONTINUE
  100 CONTINUE
      CALL GSCHF( N, L, LDL, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 130 K = 1, M
         DO 120 J = 1, N
            Z(J) = Z(J) - BIG*Y(K,J)*D(K)*G(K)
  120    CONTINUE
  130 CONTINUE
      END
