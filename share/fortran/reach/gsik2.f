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
      EXTERNAL           GSIK3, GSIK4, GSIK8, GSIK9
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
               CALL GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, GB, G, H, NB,
     $                     QS, NS, BR, INFO )
            ELSE IF ( ABS( GB ).LE.MIN( ABS( G ), ABS( GBB ) ) ) THEN
               CALL GSIK4( 6, KIND, KA, PA, R, P, QB, ZB, NB, QS, NS,
     $                     BR, INFO )
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
      DO 10 I = 1, 6
         T = Q(I) - Z(I)
         IF ( KIND(I).EQ.1 ) T = 2.0D0*SIN( 0.5D0*T )
         GSIK8 = GSIK8 + T*T
   10 CONTINUE
      GSIK8 = SQRT( GSIK8 )
      END
C
      SUBROUTINE GSIK9( KIND, KA, PA, R, P, QB, ZB, UB, GB, G, H, NB,
     $                  QS, NS, BR, INFO )
C
C     PURPOSE
C     For GSIK2: the solution between two positions of the curve.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, NB, QS, NS, BR, INFO as GSIKZ, N = 6.
C     QB, ZB, UB, GB (input) of the first position, as GSIK3.
C     G       (input) DOUBLE PRECISION, of the second.
C     H       (input) DOUBLE PRECISION, the step between them.
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
      DOUBLE PRECISION   UB(6), GB, G, H, QS(6,NB), Q(6), Z(6), U(6)
      DOUBLE PRECISION   A, B, GA, GE, GM, S, T, W(42)
      LOGICAL            GOOD
      EXTERNAL           GSIK3, GSIKN, GSIKP
C
      A = 0.0D0
      B = H
      SIDE = 0
      GA = GB
      GE = G
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
      DO 30 I = 1, 6
         IF ( KIND(I).EQ.1 ) Q(I) = ATAN2( SIN( Q(I) ), COS( Q(I) ) )
   30 CONTINUE
      CALL GSIKP( 6, KIND, KA, PA, R, P, Q, NB, QS, NS, BR, INFO )
      CALL GSIKN( 6, KIND, KA, PA, R, P, Q, W, IW, GOOD )
      IF ( GOOD ) CALL GSIKP( 6, KIND, KA, PA, R, P, Q, NB, QS, NS, BR,
     $                        INFO )
      END
