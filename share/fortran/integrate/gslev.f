      SUBROUTINE GSLEP( NX, J, H, T, AT, X, F, XN, FN, Z, TZ )
C
C     PURPOSE
C     Where GSEVN looks for events within a step of GSDP8, all lanes:
C     the states at the J-th of its eight points, on the cubic
C     polynomial through both ends, and their times.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     J       (input) INTEGER, 1 to 8, where the step ends.
C     H, T, AT (input) DOUBLE PRECISION arrays, dimension (K): steps,
C             where they begin, AT < 0 where the end is taken from the
C             left.
C     X, F    (input) DOUBLE PRECISION arrays, dimension (K,NX), states
C             and right-hand sides at the beginning.
C     XN, FN  (input) DOUBLE PRECISION arrays, dimension (K,NX), those
C             at the end.
C     Z       (output) DOUBLE PRECISION array, dimension (K,NX).
C     TZ      (output) DOUBLE PRECISION array, dimension (K).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX, J
      DOUBLE PRECISION   H(K), T(K), AT(K), X(K,NX), F(K,NX), XN(K,NX),
     $                   FN(K,NX), Z(K,NX), TZ(K)
      DOUBLE PRECISION   GSEVP, GSLFT, B, P, Q(K), R(K)
      EXTERNAL           GSEVP, GSLFT
      INTEGER            I, L
C
      B = GSEVP( J, 8 )
      P = B*B*( 3.0D0 - 2.0D0*B )
C$OMP SIMD
      DO 10 L = 1, K
         TZ(L) = T(L) + B*H(L)
         Q(L)  = H(L)*B*( 1.0D0 - B )*( 1.0D0 - B )
         R(L)  = H(L)*B*B*( B - 1.0D0 )
   10 CONTINUE
      IF ( J.LT.8 ) THEN
         DO 30 I = 1, NX
C$OMP SIMD
            DO 20 L = 1, K
               Z(L,I) = X(L,I) + P*( XN(L,I) - X(L,I) ) + Q(L)*F(L,I)
     $                + R(L)*FN(L,I)
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
      SUBROUTINE GSLEG( NE, J, G, INFO, G0, MARK, OLD, OLDER, NOW, Q )
C
C     PURPOSE
C     What GSEVL sees at the J-th of the eight points of a step, all
C     lanes: do the event functions leave it to GSEVN?
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
C     OLD, OLDER (input/output) DOUBLE PRECISION arrays, dimension
C             (K,NE): at the last point and the one before; any at the
C             first point.
C     NOW     (input/output) DOUBLE PRECISION array, dimension (K,NE),
C             MARK as it is up to this point; any at the first one.
C     Q       (input/output) DOUBLE PRECISION array, dimension (K), 1 on
C             exit where a function that was above 0 is no longer, one
C             has a lowest value that the points do not resolve or that
C             is small beside its curvature, or one is not known.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NE, J, INFO(K)
      DOUBLE PRECISION   G(K,NE), G0(K,NE), MARK(K,NE), OLD(K,NE),
     $                   OLDER(K,NE), NOW(K,NE), Q(K)
      DOUBLE PRECISION   GSEVP, A, C, RA, RB, RC, S, P, D, Y, CURVE,
     $                   FINE, LOW
      EXTERNAL           GSEVP
      INTEGER            I, L
C
      DO 10 L = 1, K
         IF ( INFO(L).NE.0 ) Q(L) = 1.0D0
   10 CONTINUE
      A = GSEVP( J, 8 )
      C = 1.0D0
      IF ( J.GT.1 ) THEN
         C = GSEVP( J - 1, 8 )
         A = A - C
         IF ( J.GT.2 ) C = C - GSEVP( J - 2, 8 )
      END IF
      RA = 1.0D0/A
      RC = 1.0D0/C
      RB = 1.0D0/( A + C )
      DO 40 I = 1, NE
         IF ( J.EQ.1 ) THEN
C$OMP SIMD
            DO 20 L = 1, K
               OLD(L,I)   = G0(L,I)
               OLDER(L,I) = -1.0D0
               NOW(L,I)   = MARK(L,I)
   20       CONTINUE
         END IF
C$OMP SIMD PRIVATE( S, P, D, Y, CURVE, FINE, LOW )
         DO 30 L = 1, K
            P = ( OLD(L,I) - OLDER(L,I) )*RC
            S = ( G(L,I) - OLD(L,I) )*RA
            CURVE = ( S - P )*RB
            D = P - C*CURVE
            FINE = MIN( -P, S, 0.5D0*( S - P )*( A + C ) - OLD(L,I) )
            LOW  = MIN( -D, S + A*CURVE, 2.0D-2*CURVE*CURVE
     $             - OLDER(L,I)*CURVE + 0.25D0*D*D )
            Y = Q(L)
            IF ( MIN( OLDER(L,I), OLD(L,I), G(L,I), MAX( FINE, LOW ) )
     $           .GT.0.0D0 ) Y = 1.0D0
            IF ( .NOT.( ABS( G(L,I) ).LE.1.0D100 ) ) Y = 1.0D0
            D = NOW(L,I)
            IF ( G(L,I).LE.0.0D0 ) Y = MAX( Y, D )
            IF ( G(L,I).GT.0.0D0 ) D = 1.0D0
            Q(L) = Y
            NOW(L,I)   = D
            OLDER(L,I) = OLD(L,I)
            OLD(L,I)   = G(L,I)
   30    CONTINUE
   40 CONTINUE
      END
      SUBROUTINE GSLEN( NE, G, NOW, NEEDS, UNTIL, TN, Q )
C
C     PURPOSE
C     At the end of a step, all lanes: what GSEVN says of functions that
C     have not risen above 0 since their last event.
C
C     ARGUMENTS
C     As GSLEG, and
C     NEEDS   (input) DOUBLE PRECISION array, dimension (K,NE), 1 where
C             such a function must not be below 0.
C     UNTIL   (input) DOUBLE PRECISION array, dimension (K,NE): from
C             then on events of such a function may accumulate (GSUSZ).
C     TN      (input) DOUBLE PRECISION array, dimension (K), the ends.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NE
      DOUBLE PRECISION   G(K,NE), NOW(K,NE), NEEDS(K,NE), UNTIL(K,NE),
     $                   TN(K), Q(K)
      DOUBLE PRECISION   S, Y
      INTEGER            I, L
C
      DO 20 I = 1, NE
C$OMP SIMD PRIVATE( S, Y )
         DO 10 L = 1, K
            Y = Q(L)
            S = NEEDS(L,I)
            IF ( G(L,I).GE.0.0D0 ) S = 0.0D0
            IF ( TN(L).GE.UNTIL(L,I) ) S = 1.0D0
            IF ( NOW(L,I).LE.0.0D0 ) Y = MAX( Y, S )
            Q(L) = Y
   10    CONTINUE
   20 CONTINUE
      END
      SUBROUTINE GSLEU( NX, NE, R, LOOKS, KNOWN, AT, G, NOW, FN, G0,
     $                  MARK, F, C )
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
C     G0, MARK (input/output) on exit those at the end.
C     C       (input/output) DOUBLE PRECISION array, dimension (K,24),
C             what is remembered of the runs, see GSLNA.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX, NE, KNOWN
      DOUBLE PRECISION   R(K), LOOKS(K), AT(K), G(K,NE), NOW(K,NE),
     $                   FN(K,NX), G0(K,NE), MARK(K,NE), F(K,NX),
     $                   C(K,24)
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
            Y = MARK(L,I)
            IF ( IS(L).GT.0.0D0 ) Y = NOW(L,I)
            MARK(L,I) = Y
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
