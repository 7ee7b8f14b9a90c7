      SUBROUTINE GSIKZ( KIND, KA, PA, R, P, NB, NM, QC, RAD, LIM, QS,
     $                  NS, BR, INFO )
C
C     PURPOSE
C     Solutions of six joints close to a double one, refined and made
C     complete.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P (input) as GSIKN.
C     NB, NM, QC, RAD, LIM (input) as GSIKS.
C     QS      (input/output) DOUBLE PRECISION array, dimension (6,NB).
C     NS      (input/output) INTEGER, number of solutions, <= NB.
C     BR      (input/output) INTEGER array, dimension (NB).
C     INFO    (input/output) INTEGER, as GSIKS; 0 or 2 where solutions are
C             found.
C
C     METHOD
C     Newton's method on the pose from every branch whose radicands are
C     above -1D7 times LIM, and from places on both sides of it, where the
C     Jacobian loses rank. A pair closer than 3D-8 (more where the
C     Jacobian is almost singular) counts once. New ones take the numbers
C     of branches that have none.
C
C     ERROR INDICATOR
C     None of its own.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NM, NS, BR(NB), INFO
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QC(6,NB)
      DOUBLE PRECISION   RAD(NM,NB), LIM(NM), QS(6,NB)
      DOUBLE PRECISION   Z(6), Q(6), W(42), S, H
      INTEGER            IW(6), I, K, L, WAY
      LOGICAL            GOOD, FREE
      EXTERNAL           GSIKN, GSIKO, GSIKP
C
C     -- those that are there
      DO 20 K = 1, NS
         DO 10 I = 1, 6
            Q(I) = QS(I,K)
   10    CONTINUE
         CALL GSIKN( KIND, KA, PA, R, P, Q, W, IW, GOOD )
         H = 0.0D0
         DO 13 I = 1, 6
            S = ABS( Q(I) - QS(I,K) )
            IF ( KIND(I).EQ.1 ) S = ABS( 2.0D0*SIN( 0.5D0*S ) )
            H = MAX( H, S )
   13    CONTINUE
         IF ( GOOD .AND. H.LE.1.0D-2 ) THEN
            DO 15 I = 1, 6
               QS(I,K) = Q(I)
   15       CONTINUE
         END IF
   20 CONTINUE
C     -- and beside every branch that is almost real
      DO 60 K = 1, NB
         GOOD = .FALSE.
         FREE = .FALSE.
         DO 30 I = 1, NM
            IF ( LIM(I).GT.1.0D-20 .AND.
     $           ABS( RAD(I,K) ).LE.1.0D7*LIM(I) ) GOOD = .TRUE.
            IF ( LIM(I).LE.1.0D-20 .AND. RAD(I,K).LE.LIM(I) )
     $         FREE = .TRUE.
   30    CONTINUE
         DO 35 I = 1, NM
            IF ( .NOT.( RAD(I,K).GE.-1.0D7*LIM(I) ) ) GOOD = .FALSE.
   35    CONTINUE
         IF ( GOOD .AND. .NOT.FREE ) THEN
            CALL GSIKO( KIND, KA, PA, R, P, QC(1,K), Z, S )
            H = 1.0D-2
            DO 55 L = 1, 5
               DO 50 WAY = -1, 1, 2
                  DO 40 I = 1, 6
                     Q(I) = QC(I,K) + WAY*H*Z(I)
   40             CONTINUE
                  CALL GSIKN( KIND, KA, PA, R, P, Q, W, IW, GOOD )
                  IF ( GOOD ) CALL GSIKP( KIND, Q, S, NB, QS, NS, BR,
     $                                    INFO )
   50          CONTINUE
               H = 0.1D0*H
   55       CONTINUE
         END IF
   60 CONTINUE
      END
C
      SUBROUTINE GSIKO( KIND, KA, PA, R, P, Q, Z, S )
C
C     PURPOSE
C     For GSIKZ: the direction in which the tool moves least.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, Q (input) as GSIKN.
C     Z       (output) DOUBLE PRECISION array, dimension (6), length 1.
C     S       (output) DOUBLE PRECISION, the least singular value of the
C             Jacobian.
C
C     METHOD
C     Singular values.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), I, RANK
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), Z(6), S
      DOUBLE PRECISION   RJ(6,6), E(6), V(6,6), SV(6), MISS
      EXTERNAL           GSIKJ, GSSVD
C
      CALL GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, MISS )
      CALL GSSVD( 6, 6, RJ, 6, V, 6, SV, 1.0D-14, RANK )
      DO 10 I = 1, 6
         Z(I) = V(I,6)
   10 CONTINUE
      S = SV(6)
      END
C
      SUBROUTINE GSIKP( KIND, Q, S, NB, QS, NS, BR, INFO )
C
C     PURPOSE
C     For GSIKZ: a solution put among the others if it is new.
C
C     ARGUMENTS
C     KIND, Q (input) as GSIKN.
C     S       (input) DOUBLE PRECISION, least singular value there.
C     NB, QS, NS, BR, INFO as GSIKZ.
C
C     METHOD
C     Differences modulo a turn.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NS, BR(NB), INFO, I, K, L
      DOUBLE PRECISION   Q(6), S, QS(6,NB), D, T, TOL
C
      TOL = 3.0D-8 + 1.0D-13/MAX( S, 1.0D-10 )
      DO 20 K = 1, NS
         D = 0.0D0
         DO 10 I = 1, 6
            T = ABS( Q(I) - QS(I,K) )
            IF ( KIND(I).EQ.1 ) T = ABS( 2.0D0*SIN( 0.5D0*T ) )
            D = MAX( D, T )
   10    CONTINUE
         IF ( D.LE.TOL ) RETURN
   20 CONTINUE
      IF ( NS.GE.NB ) RETURN
      NS = NS + 1
      DO 30 I = 1, 6
         QS(I,NS) = Q(I)
   30 CONTINUE
      DO 50 L = 1, NB
         DO 40 K = 1, NS - 1
            IF ( BR(K).EQ.L ) GO TO 50
   40    CONTINUE
         BR(NS) = L
         IF ( INFO.EQ.1 ) INFO = 0
         RETURN
   50 CONTINUE
      END
