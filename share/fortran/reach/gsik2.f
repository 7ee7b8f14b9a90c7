      SUBROUTINE GSIK2( KIND, KA, PA, R, P, Q0, NB, QS, NS, BR, INFO,
     $                  NW, QW )
C
C     PURPOSE
C     For GSIKZ: solutions along the curve on which the tool hardly moves.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, NB, QS, NS, BR, INFO as GSIKZ, N = 6.
C     Q0      (input) DOUBLE PRECISION array, dimension (6): a position
C             close to the curve [rad, m].
C     NW      (input/output) INTEGER, positions on curves so far.
C     QW      (input/output) DOUBLE PRECISION array, dimension (6,400):
C             these.
C
C     METHOD
C     On the curve the pose is missed in the direction only in which the
C     tool cannot move. In steps of 0.1 both ways: where what is missed
C     changes its sign there is a solution, and two may be where it is
C     least. The end is where more than 1D-3 is missed, a step behind where
C     the curve closes, or where it has been before.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NS, BR(NB), INFO, NW
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q0(6)
      DOUBLE PRECISION   QS(6,NB), QW(6,400), QF(6), ZF(6), UF(6), GF
      DOUBLE PRECISION   Q(6), Z(6), U(6), G, QB(6), ZB(6), UB(6), GB
      DOUBLE PRECISION   GBB, H, S, GSIK8
      INTEGER            I, K, WAY
      LOGICAL            CLOSED
      EXTERNAL           GSIK3, GSIK8, GSIK9, GSIQL
      PARAMETER          ( H = 1.0D-1 )
C
      DO 10 I = 1, 6
         QF(I) = Q0(I)
         ZF(I) = 0.0D0
         UF(I) = 0.0D0
   10 CONTINUE
      CALL GSIK3( 4, KIND, KA, PA, R, P, QF, ZF, UF, GF, S )
      DO 20 K = 1, NW
         IF ( GSIK8( KIND, QF, QW(1,K) ).LE.0.6D0*H ) RETURN
   20 CONTINUE
      DO 70 WAY = -1, 1, 2
         DO 30 I = 1, 6
            Q(I) = QF(I)
            Z(I) = WAY*ZF(I)
            U(I) = UF(I)
   30    CONTINUE
         G = GF
         GB = GF
         CLOSED = .FALSE.
         DO 60 K = 1, 200
            GBB = GB
            GB = G
            DO 40 I = 1, 6
               QB(I) = Q(I)
               ZB(I) = Z(I)
               UB(I) = U(I)
               Q(I) = Q(I) + H*Z(I)
   40       CONTINUE
            CALL GSIK3( 4, KIND, KA, PA, R, P, Q, Z, U, G, S )
            IF ( G*GB.LE.0.0D0 ) THEN
               CALL GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, 0.0D0, GB, H,
     $                     G, NB, QS, NS, BR, INFO )
            ELSE IF ( ABS( GB ).LE.MIN( ABS( G ), ABS( GBB ) ) ) THEN
               CALL GSIQL( KIND, KA, PA, R, P, QB, ZB, UB, GB, H, NB,
     $                     QS, NS, BR, INFO )
            END IF
            IF ( NW.LT.400 ) THEN
               NW = NW + 1
               DO 50 I = 1, 6
                  QW(I,NW) = Q(I)
   50          CONTINUE
            END IF
            IF ( .NOT.( ABS( G ).LE.1.0D-3 ) ) GO TO 70
            IF ( CLOSED ) RETURN
            IF ( K.GT.2 ) CLOSED = GSIK8( KIND, Q, QF ).LE.0.6D0*H
   60    CONTINUE
   70 CONTINUE
      END
C
      SUBROUTINE GSIK3( M, KIND, KA, PA, R, P, Q, Z, U, G, S )
C
C     PURPOSE
C     For GSIK2: a position brought to the curve.
C
C     ARGUMENTS
C     M       (input) INTEGER, steps at most, >= 0.
C     KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input/output) DOUBLE PRECISION array, dimension (6).
C     Z       (input/output) DOUBLE PRECISION array, dimension (6): the
C             direction of the curve, on that side of what it was.
C     U       (input/output) DOUBLE PRECISION array, dimension (6): the
C             direction in which the tool cannot move, as Z.
C     G       (output) DOUBLE PRECISION, what is missed in direction U.
C     S       (output) DOUBLE PRECISION, the least singular value, with the
C             sign that belongs to Z and U.
C
C     METHOD
C     Newton's method without the least singular value.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            M, KIND(6), I, K, L, IT, RANK
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), Z(6)
      DOUBLE PRECISION   U(6), G, S, B(6,6), E(6), V(6,6), SV(6), D(6)
      DOUBLE PRECISION   MISS, BIG, X(6), T
      EXTERNAL           GSIKJ, GSSVD
C
      DO 60 IT = 0, M
         CALL GSIKJ( KIND, KA, PA, R, P, Q, B, E, MISS )
         CALL GSSVD( 6, 6, B, 6, V, 6, SV, 1.0D-14, RANK )
         IF ( IT.EQ.M ) GO TO 70
         DO 10 I = 1, 6
            D(I) = 0.0D0
   10    CONTINUE
         DO 40 K = 1, 5
            T = 0.0D0
            DO 20 I = 1, 6
               T = T + B(I,K)*E(I)
   20       CONTINUE
            T = T/SV(K)/SV(K)
            IF ( SV(K).LE.1.0D-7*SV(1) ) T = 0.0D0
            DO 30 I = 1, 6
               D(I) = D(I) + T*V(I,K)
   30       CONTINUE
   40    CONTINUE
         BIG = 0.0D0
         DO 45 I = 1, 6
            BIG = MAX( BIG, ABS( D(I) ) )
   45    CONTINUE
         T = MIN( 1.0D0, 0.3D0/MAX( BIG, 1.0D-300 ) )
         DO 50 I = 1, 6
            Q(I) = Q(I) + T*D(I)
   50    CONTINUE
         IF ( BIG.LE.1.0D-9 ) GO TO 70
   60 CONTINUE
   70 CONTINUE
C     -- what is across the five other directions
      L = 1
      BIG = -1.0D0
      DO 90 I = 1, 6
         T = 1.0D0
         DO 80 K = 1, 5
            T = T - ( B(I,K)/MAX( SV(K), 1.0D-300 ) )**2
   80    CONTINUE
         IF ( T.GT.BIG ) THEN
            BIG = T
            L = I
         END IF
         X(I) = 0.0D0
   90 CONTINUE
      X(L) = 1.0D0
      DO 120 K = 1, 5
         T = B(L,K)/MAX( SV(K), 1.0D-300 )**2
         DO 110 I = 1, 6
            X(I) = X(I) - T*B(I,K)
  110    CONTINUE
  120 CONTINUE
      T = 0.0D0
      G = 0.0D0
      BIG = 0.0D0
      DO 130 I = 1, 6
         T = T + X(I)*X(I)
         G = G + X(I)*U(I)
         BIG = BIG + V(I,6)*Z(I)
  130 CONTINUE
      T = SIGN( 1.0D0, G )/SQRT( MAX( T, 1.0D-300 ) )
      BIG = SIGN( 1.0D0, BIG )
      G = 0.0D0
      S = 0.0D0
      DO 140 I = 1, 6
         U(I) = T*X(I)
         Z(I) = BIG*V(I,6)
         G = G + U(I)*E(I)
         S = S + BIG*U(I)*B(I,6)
  140 CONTINUE
      END
C
      DOUBLE PRECISION FUNCTION GSIK8( KIND, Q, Z )
C
C     PURPOSE
C     For GSIK2: the length of the difference of two positions, modulo
C     turns.
C
C     ARGUMENTS
C     KIND    (input) INTEGER array, dimension (6), as GSIKN.
C     Q, Z    (input) DOUBLE PRECISION arrays, dimension (6) [rad, m].
C
C     METHOD
C     Chords of the circle of radius 1.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), I
      DOUBLE PRECISION   Q(6), Z(6), T
C
      GSIK8 = 0.0D0
CGCC$ NOVECTOR
      DO 10 I = 1, 6
         T = Q(I) - Z(I)
         IF ( KIND(I).EQ.1 ) T = 2.0D0*SIN( 0.5D0*T )
         GSIK8 = GSIK8 + T*T
   10 CONTINUE
      GSIK8 = SQRT( GSIK8 )
      END
C
      SUBROUTINE GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, A0, GA0, B0,
     $                  GB0, NB, QS, NS, BR, INFO )
C
C     PURPOSE
C     For GSIK2: the solution between two positions of the curve.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, NB, QS, NS, BR, INFO as GSIKZ, N = 6.
C     QB, ZB, UB (input) of a position, as GSIK3.
C     A0, B0  (input) DOUBLE PRECISION, how far along ZB from there the
C             curve is looked at.
C     GA0, GB0 (input) DOUBLE PRECISION, what is missed there.
C
C     METHOD
C     Eight times the place where a straight line vanishes, between
C     positions of opposite signs, one that stays counting half; then
C     Newton's method, which is the worse where the Jacobian has no digits
C     left in the direction of the curve.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NS, BR(NB), INFO, I, K, IW(6)
      INTEGER            SIDE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QB(6), ZB(6)
      DOUBLE PRECISION   UB(6), A0, GA0, B0, GB0, QS(6,NB), Q(6), Z(6)
      DOUBLE PRECISION   U(6), A, B, GA, GE, GM, S, T, W(42)
      LOGICAL            GOOD
      EXTERNAL           GSIK3, GSIKN, GSIKP
C
      A = A0
      B = B0
      SIDE = 0
      GA = GA0
      GE = GB0
      DO 20 K = 1, 8
         T = A
         IF ( ABS( GA - GE ).GT.0.0D0 )
     $      T = A + ( B - A )*( GA/( GA - GE ) )
         DO 10 I = 1, 6
            Q(I) = QB(I) + T*ZB(I)
            Z(I) = ZB(I)
            U(I) = UB(I)
   10    CONTINUE
         CALL GSIK3( 4, KIND, KA, PA, R, P, Q, Z, U, GM, S )
         IF ( GM*GA.GT.0.0D0 ) THEN
            IF ( SIDE.GT.0 ) GE = 0.5D0*GE
            SIDE = 1
            A = T
            GA = GM
         ELSE
            IF ( SIDE.LT.0 ) GA = 0.5D0*GA
            SIDE = -1
            B = T
            GE = GM
         END IF
   20 CONTINUE
CGCC$ NOVECTOR
      DO 30 I = 1, 6
         IF ( KIND(I).EQ.1 ) Q(I) = ATAN2( SIN( Q(I) ), COS( Q(I) ) )
   30 CONTINUE
      CALL GSIKP( 6, KIND, KA, PA, R, P, Q, NB, QS, NS, BR, INFO )
      CALL GSIKN( 6, KIND, KA, PA, R, P, Q, W, IW, GOOD )
      IF ( GOOD ) CALL GSIKP( 6, KIND, KA, PA, R, P, Q, NB, QS, NS, BR,
     $                        INFO )
      END
C
      SUBROUTINE GSIQL( KIND, KA, PA, R, P, QB, ZB, UB, GB, H, NB, QS,
     $                  NS, BR, INFO )
C
C     PURPOSE
C     For GSIK2: the two solutions about a position of the curve where
C     less is missed than a step before and behind.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, NB, QS, NS, BR, INFO as GSIKZ, N = 6.
C     QB, ZB, UB, GB (input) of the position, as GSIK3.
C     H       (input) DOUBLE PRECISION, the step.
C
C     METHOD
C     The place of the least, by golden sections, until what is missed has
C     the other sign: then a solution is on each side (GSIK9). Where it
C     keeps its sign, and is flat to 1D-3 of itself, Newton's method from
C     both sides of the least (GSIK4).
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NS, BR(NB), INFO, I, K
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QB(6), ZB(6)
      DOUBLE PRECISION   UB(6), GB, H, QS(6,NB), Q(6), Z(6), U(6), X(4)
      DOUBLE PRECISION   G(4), S, PHI
      EXTERNAL           GSIK3, GSIK4, GSIK9
      PARAMETER          ( PHI = 0.61803398874989485D0 )
C
C     -- X(1) < X(2) < X(3), the least about X(2); X(4) is new
      X(1) = -H
      X(3) = H
      X(2) = 0.0D0
      X(4) = -H
      G(2) = ABS( GB )
      DO 40 K = 1, 30
         IF ( K.EQ.2 ) X(4) = H
         IF ( K.GT.2 ) THEN
            X(4) = X(2) + ( 1.0D0 - PHI )*( X(3) - X(2) )
            IF ( X(2) - X(1).GT.X(3) - X(2) )
     $         X(4) = X(2) - ( 1.0D0 - PHI )*( X(2) - X(1) )
         END IF
         DO 10 I = 1, 6
            Q(I) = QB(I) + X(4)*ZB(I)
            Z(I) = ZB(I)
            U(I) = UB(I)
   10    CONTINUE
         CALL GSIK3( 4, KIND, KA, PA, R, P, Q, Z, U, G(4), S )
         G(4) = SIGN( 1.0D0, GB )*G(4)
         IF ( K.LE.2 ) THEN
            G(MIN( 2*K-1, 3 )) = G(4)
            IF ( .NOT.( G(4).GT.G(2) ) ) RETURN
         ELSE IF ( G(4).LE.0.0D0 ) THEN
            DO 20 I = 1, 4
               G(I) = SIGN( 1.0D0, GB )*G(I)
   20       CONTINUE
            CALL GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, X(1), G(1),
     $                  X(4), G(4), NB, QS, NS, BR, INFO )
            CALL GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, X(4), G(4),
     $                  X(3), G(3), NB, QS, NS, BR, INFO )
            RETURN
         ELSE IF ( G(4).LT.G(2) ) THEN
            I = 1
            IF ( X(4).LT.X(2) ) I = 3
            X(I) = X(2)
            G(I) = G(2)
            X(2) = X(4)
            G(2) = G(4)
         ELSE
            I = 3
            IF ( X(4).LT.X(2) ) I = 1
            X(I) = X(4)
            G(I) = G(4)
         END IF
         IF ( K.GE.2 .AND. MAX( G(1), G(3) ).LE.1.001D0*G(2) ) GO TO 45
   40 CONTINUE
   45 CONTINUE
      DO 50 I = 1, 6
         Q(I) = QB(I) + X(2)*ZB(I)
         Z(I) = ZB(I)
         U(I) = UB(I)
   50 CONTINUE
      CALL GSIK3( 4, KIND, KA, PA, R, P, Q, Z, U, G(4), S )
      CALL GSIK4( 6, KIND, KA, PA, R, P, Q, Z, NB, QS, NS, BR, INFO )
      END
