      SUBROUTINE GSLEP( NX, J, N, H, T, AT, X, F, XN, FN, Z, TZ )
C
C     PURPOSE
C     Where GSEVA looks for events within a step of GSDP8, all lanes:
C     the states at the J-th of its eight points, and their times.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     J       (input) INTEGER, 1 to 8, where the step ends.
C     N       (input) INTEGER, 3: on the cubic polynomial through both
C             ends (GSEVH), 5: on that of GSEVC.
C     H, T, AT (input) DOUBLE PRECISION arrays, dimension (K): steps,
C             where they begin, AT < 0 where the end is taken from the
C             left.
C     X       (input) DOUBLE PRECISION array, dimension (K,NX), states
C             at the beginning.
C     F       (input) DOUBLE PRECISION array, dimension (K,NX,12), the
C             stages.
C     XN, FN  (input) DOUBLE PRECISION arrays, dimension (K,NX), states
C             and right-hand sides at the end.
C     Z       (output) DOUBLE PRECISION array, dimension (K,NX).
C     TZ      (output) DOUBLE PRECISION array, dimension (K).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX, J, N
      DOUBLE PRECISION   H(K), T(K), AT(K), X(K,NX), F(K,NX,12),
     $                   XN(K,NX), FN(K,NX), Z(K,NX), TZ(K)
      DOUBLE PRECISION   GSEVP, GSLFT, B, P, Q(K), R(K), E, S, D, C
      EXTERNAL           GSEVP, GSLFT
      INTEGER            I, L
C
      B = GSEVP( J, 8 )
      P = B*B*( 3.0D0 - 2.0D0*B )
      E = 0.0D0
      IF ( N.EQ.5 ) E = ( B*( 1.0D0 - B ) )**2
C$OMP SIMD
      DO 10 L = 1, K
         TZ(L) = T(L) + B*H(L)
         Q(L)  = H(L)*B*( 1.0D0 - B )*( 1.0D0 - B )
         R(L)  = H(L)*B*B*( B - 1.0D0 )
   10 CONTINUE
      IF ( J.LT.8 ) THEN
         DO 30 I = 1, NX
C$OMP SIMD PRIVATE( S, C, D )
            DO 20 L = 1, K
               S = ( XN(L,I) - X(L,I) )/MAX( H(L), 1.0D-300 )
               C = ( F(L,I,10) - 1.44D0*S + 0.32D0*F(L,I,1)
     $             + 0.12D0*FN(L,I) )/( -0.096D0 )
               D = ( F(L,I,7) - 1.125D0*S - 0.1875D0*F(L,I,1)
     $             + 0.3125D0*FN(L,I) - 0.1875D0*C )/8.203125D-2
               Z(L,I) = X(L,I) + P*( XN(L,I) - X(L,I) )
     $                + Q(L)*F(L,I,1) + R(L)*FN(L,I)
     $                + H(L)*E*( C + D*B )
   20       CONTINUE
   30    CONTINUE
         RETURN
      END IF
      DO 50 I = 1, NX
C$OMP SIMD
         DO 40 L = 1, K
            Z(L,I) = XN(L,I)
   40    CONTINUE
   50 CONTINUE
      DO 60 L = 1, K
         IF ( AT(L).LT.0.0D0 ) TZ(L) = GSLFT( TZ(L), -1 )
   60 CONTINUE
      END
      SUBROUTINE GSLEG( NE, J, G, INFO, G0, MARK, NOISE, OLD, OLDER,
     $                  BEND, LIMIT, Q )
C
C     PURPOSE
C     What GSEVA sees at the J-th of the eight points of a step, all
C     lanes.
C
C     ARGUMENTS
C     NE      (input) INTEGER, the number of event functions.
C     J       (input) INTEGER, 1 to 8.
C     G       (input) DOUBLE PRECISION array, dimension (K,NE), what
C             they are there.
C     INFO    (input) INTEGER array, dimension (K), not 0 where they are
C             not known.
C     G0, MARK (input) DOUBLE PRECISION arrays, dimension (K,NE): what
C             they are where the step begins; 1 where a function has
C             been above 0 since its last event, else 0.
C     NOISE   (input) DOUBLE PRECISION array, dimension (K,NE), what are
C             rounding errors of a function (GSEVF).
C     OLD, OLDER, BEND (input/output) DOUBLE PRECISION arrays, dimension
C             (K,NE): at the last point and the one before, and their
C             second divided difference (GSEVF); any at the first point.
C     LIMIT   (input/output) DOUBLE PRECISION array, dimension (K,NE):
C             how far the polynomials of GSEVA may be apart for the step
C             to be quiet; any at the first point.
C     Q       (input/output) DOUBLE PRECISION array, dimension (K), 1 on
C             exit where a function is not known.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NE, J, INFO(K)
      DOUBLE PRECISION   G(K,NE), G0(K,NE), MARK(K,NE), OLD(K,NE),
     $                   OLDER(K,NE), NOISE(K,NE), BEND(K,NE),
     $                   LIMIT(K,NE), Q(K)
      DOUBLE PRECISION   GSEVP, GSEVZ, A, B, C, D, W, P, S, V, GA, GB,
     $                   GC, CURVE, LEAST, START, OFF, NEAR, FAST, TURN
      EXTERNAL           GSEVP, GSEVZ
      INTEGER            I, L
C
      DO 10 L = 1, K
         IF ( INFO(L).NE.0 ) Q(L) = 1.0D0
   10 CONTINUE
      B = GSEVP( J, 8 )
      D = GSEVZ( B )
      A = B
      C = 1.0D0
      IF ( J.GT.1 ) THEN
         C = GSEVP( J - 1, 8 )
         A = B - C
         D = MAX( D, GSEVZ( C ) )
         IF ( J.GT.2 ) D = MAX( D, GSEVZ( GSEVP( J - 2, 8 ) ) )
         IF ( J.GT.2 ) C = C - GSEVP( J - 2, 8 )
      END IF
      D = 0.5D0/D
      W = A + C
      START = 0.0D0
      FAST  = 0.0D0
      IF ( J.GT.2 ) START = 1.0D300
      IF ( J.GT.2 ) FAST  = A*W
      DO 40 I = 1, NE
         IF ( J.EQ.1 ) THEN
C$OMP SIMD
            DO 20 L = 1, K
               OLDER(L,I) = G0(L,I)
               OLD(L,I)   = G(L,I)
               LIMIT(L,I) = D*G(L,I)*( 2.0D0*MARK(L,I) - 1.0D0 )
               IF ( .NOT.( ABS( G(L,I) ).LE.1.0D100 ) ) LIMIT(L,I) =
     $            -1.0D300
   20       CONTINUE
         ELSE
C$OMP SIMD PRIVATE( V, GA, GB, GC, P, S, CURVE, LEAST, OFF, NEAR,
C$OMP$     TURN )
            DO 30 L = 1, K
               V  = 2.0D0*MARK(L,I) - 1.0D0
               GA = V*OLDER(L,I)
               GC = V*OLD(L,I)
               GB = V*G(L,I)
               P = ( GC - GA )/C
               S = ( GB - GC )/A
               CURVE = ( S - P )/W
               OFF  = ABS( CURVE - BEND(L,I) )*FAST
               NEAR = MIN( ABS( GA ), ABS( GC ), ABS( GB ) )
               BEND(L,I) = CURVE
               TURN  = SIGN( 1.0D0, P )*CURVE
               CURVE = ABS( CURVE )
               LEAST = MIN( GB, GC )
               IF ( START.GT.P - 2.0D0*C*CURVE ) LEAST = MIN( LEAST,
     $              GA )
               CURVE = 0.125D0*W*W*CURVE
               IF ( MIN( -P, S ).GT.0.0D0 ) CURVE = 4.0D0*CURVE
               LEAST = D*( LEAST - CURVE )
               IF ( .NOT.( ABS( G(L,I) ).LE.1.0D100 ) ) LEAST = -1.0D300
               IF ( 2.0D0*OFF.GT.MAX( GA, GC, GB ) - MIN( GA, GC, GB )
     $              .AND. OFF.GT.NOISE(L,I) .AND. NEAR.LT.2.0D0*OFF
     $              .AND. TURN.LT.0.0D0 ) LEAST = -1.0D300
               LIMIT(L,I) = MIN( LIMIT(L,I), LEAST )
               OLDER(L,I) = OLD(L,I)
               OLD(L,I)   = G(L,I)
   30       CONTINUE
         END IF
   40 CONTINUE
      END
      SUBROUTINE GSLED( NE, J, G, OLD, APART )
C
C     PURPOSE
C     How far the polynomials of GSEVA are apart at the J-th of its
C     points, all lanes.
C
C     ARGUMENTS
C     As GSLEG, and
C     G       (input) DOUBLE PRECISION array, dimension (K,NE), event
C             functions on the cubic polynomial.
C     OLD     (input) DOUBLE PRECISION array, dimension (K,NE), those on
C             the other one.
C     APART   (input/output) DOUBLE PRECISION array, dimension (K,NE),
C             the largest difference, as in the middle of the step; any
C             where J = 4.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NE, J
      DOUBLE PRECISION   G(K,NE), OLD(K,NE), APART(K,NE)
      DOUBLE PRECISION   GSEVP, GSEVZ, D
      EXTERNAL           GSEVP, GSEVZ
      INTEGER            I, L
C
      D = GSEVZ( GSEVP( J, 8 ) )
      DO 20 I = 1, NE
C$OMP SIMD
         DO 10 L = 1, K
            IF ( J.EQ.4 ) APART(L,I) = 0.0D0
            APART(L,I) = MAX( APART(L,I), ABS( G(L,I) - OLD(L,I) )/D )
   10    CONTINUE
   20 CONTINUE
      END
      SUBROUTINE GSLEN( NE, APART, LIMIT, MARK, NEEDS, UNTIL, TN, Q )
C
C     PURPOSE
C     At the end of a step, all lanes: is it quiet, as GSEVA says?
C
C     ARGUMENTS
C     As GSLEG, GSLED, and
C     NEEDS   (input) DOUBLE PRECISION array, dimension (K,NE), 1 where
C             a function must be above 0.
C     UNTIL   (input) DOUBLE PRECISION array, dimension (K,NE): from
C             then on events of such a function may accumulate (GSUST).
C     TN      (input) DOUBLE PRECISION array, dimension (K), the ends.
C     Q       (input/output) DOUBLE PRECISION array, dimension (K), 1 on
C             exit where it is not.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NE
      DOUBLE PRECISION   APART(K,NE), LIMIT(K,NE), MARK(K,NE),
     $                   NEEDS(K,NE), UNTIL(K,NE), TN(K), Q(K)
      DOUBLE PRECISION   S, Y
      INTEGER            I, L
C
      DO 20 I = 1, NE
C$OMP SIMD PRIVATE( S, Y )
         DO 10 L = 1, K
            Y = Q(L)
            S = NEEDS(L,I)
            IF ( TN(L).GE.UNTIL(L,I) ) S = 1.0D0
            IF ( MARK(L,I).LE.0.0D0 ) Y = MAX( Y, S )
            IF ( .NOT.( LIMIT(L,I).GT.APART(L,I) .OR. ( MARK(L,I)
     $           .LE.0.0D0 .AND. LIMIT(L,I).GE.APART(L,I) ) ) )
     $         Y = 1.0D0
            Q(L) = Y
   10    CONTINUE
   20 CONTINUE
      END
      SUBROUTINE GSLEU( NX, NE, R, LOOKS, KNOWN, AT, G, FN, G0, F, C )
C
C     PURPOSE
C     After a good step without an event, all lanes: what GSEVN and
C     GSDTB remember of it.
C
C     ARGUMENTS
C     As GSLEP, GSLEG, and
C     R       (input) DOUBLE PRECISION array, dimension (K), 1 where
C             the step was good.
C     LOOKS   (input) DOUBLE PRECISION array, dimension (K), 1 where
C             events were looked for.
C     KNOWN   (input) INTEGER, 1 where the right-hand sides FN are those
C             of the next step, unless inputs jump there: they go to F.
C     G0      (input/output) on exit those at the end.
C     C       (input/output) DOUBLE PRECISION array, dimension (K,24),
C             what is remembered of the runs, see GSLNA.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX, NE, KNOWN
      DOUBLE PRECISION   R(K), LOOKS(K), AT(K), G(K,NE), FN(K,NX),
     $                   G0(K,NE), F(K,NX), C(K,24)
      DOUBLE PRECISION   IS(K), Y
      INTEGER            I, L
C
      DO 10 L = 1, K
         IS(L) = 0.0D0
         IF ( R(L).GT.0.5D0 .AND. R(L).LT.1.5D0 .AND. LOOKS(L).GT.0.0D0
     $        ) IS(L) = 1.0D0
         C(L,13) = C(L,13) + IS(L)
   10 CONTINUE
      DO 30 I = 1, NE
C$OMP SIMD PRIVATE( Y )
         DO 20 L = 1, K
            Y = G0(L,I)
            IF ( IS(L).GT.0.0D0 ) Y = G(L,I)
            G0(L,I) = Y
   20    CONTINUE
   30 CONTINUE
      IF ( KNOWN.NE.1 ) RETURN
      DO 40 L = 1, K
         IF ( AT(L).LE.0.0D0 ) IS(L) = 0.0D0
         IF ( IS(L).GT.0.0D0 ) C(L,14) = 2.0D0
   40 CONTINUE
      DO 60 I = 1, NX
C$OMP SIMD PRIVATE( Y )
         DO 50 L = 1, K
            Y = F(L,I)
            IF ( IS(L).GT.0.0D0 ) Y = FN(L,I)
            F(L,I) = Y
   50    CONTINUE
   60 CONTINUE
      END
