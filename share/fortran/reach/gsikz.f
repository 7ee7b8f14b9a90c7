      SUBROUTINE GSIKZ( N, KIND, KA, PA, R, P, NB, NM, QC, RAD, LIM, QS,
     $                  NS, BR, INFO )
C
C     PURPOSE
C     Solutions of up to six joints refined, and made complete close to a
C     double one.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     NB, NM, QC, RAD, LIM (input) as GSIKS.
C     QS      (input/output) DOUBLE PRECISION array, dimension (N,NB).
C     NS      (input/output) INTEGER, number of solutions, <= NB.
C     BR      (input/output) INTEGER array, dimension (NB).
C     INFO    (input/output) INTEGER, as GSIKS; 0 or 2 where solutions are
C             found.
C
C     METHOD
C     Newton's method on the pose from every solution, then from every
C     branch whose radicands are above -1D7 times LIM and one of them
C     close to 0, from places on both sides of it, where the Jacobian
C     loses rank. A pair closer than 3D-8 (more where the Jacobian is
C     almost singular) counts once: the one that misses less. New ones
C     take the numbers of branches that have none.
C
C     ERROR INDICATOR
C     None of its own.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NB, NM, NS, BR(NB), INFO
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QC(N,NB)
      DOUBLE PRECISION   RAD(NM,NB), LIM(NM), QS(N,NB)
      DOUBLE PRECISION   Z(6), Q(6), W(42), S, H, GSIKK
      INTEGER            IW(6), I, K, L, WAY
      LOGICAL            GOOD, FREE
      EXTERNAL           GSIKK, GSIKN, GSIKO, GSIKP
C
C     -- those that are there
      DO 5 I = 1, 6
         Q(I) = 0.0D0
    5 CONTINUE
      DO 20 K = 1, NS
         DO 10 I = 1, N
            Q(I) = QS(I,K)
   10    CONTINUE
         CALL GSIKN( N, KIND, KA, PA, R, P, Q, W, IW, GOOD )
         H = GSIKK( N, KIND, Q, QS(1,K) )
         IF ( GOOD .AND. H.LE.1.0D-2 ) THEN
            DO 15 I = 1, N
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
            CALL GSIKO( N, KIND, KA, PA, R, P, QC(1,K), Z, S )
            H = 1.0D-2
            DO 55 L = 1, 5
               DO 50 WAY = -1, 1, 2
                  DO 40 I = 1, 6
                     Q(I) = WAY*H*Z(I)
                     IF ( I.LE.N ) Q(I) = QC(I,K) + Q(I)
   40             CONTINUE
                  CALL GSIKN( N, KIND, KA, PA, R, P, Q, W, IW, GOOD )
                  IF ( GOOD ) CALL GSIKP( N, KIND, KA, PA, R, P, Q, S,
     $                                    NB, QS, NS, BR, INFO )
   50          CONTINUE
               H = 0.1D0*H
   55       CONTINUE
         END IF
   60 CONTINUE
      END
C
      DOUBLE PRECISION FUNCTION GSIKK( N, KIND, Q, Z )
C
C     PURPOSE
C     For GSIKZ: the largest difference of two positions, modulo a turn.
C
C     ARGUMENTS
C     N, KIND (input) as GSIKN.
C     Q, Z    (input) DOUBLE PRECISION arrays, dimension (N) [rad, m].
C
C     METHOD
C     Chords of the circle of radius 1.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), I
      DOUBLE PRECISION   Q(N), Z(N), T
C
      GSIKK = 0.0D0
      DO 10 I = 1, N
         T = ABS( Q(I) - Z(I) )
         IF ( KIND(I).EQ.1 ) T = ABS( 2.0D0*SIN( 0.5D0*T ) )
         GSIKK = MAX( GSIKK, T )
   10 CONTINUE
      END
C
      SUBROUTINE GSIKO( N, KIND, KA, PA, R, P, Q, Z, S )
C
C     PURPOSE
C     For GSIKZ: the direction in which the tool moves least.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input) DOUBLE PRECISION array, dimension (N) [rad, m].
C     Z       (output) DOUBLE PRECISION array, dimension (6), length 1;
C             behind the N-th 0.
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
      INTEGER            N, KIND(6), I, RANK
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(N), Z(6), S
      DOUBLE PRECISION   QA(6), RJ(6,6), E(6), V(6,6), SV(6), MISS
      EXTERNAL           GSIKJ, GSSVD
C
      DO 5 I = 1, 6
         QA(I) = 0.0D0
         IF ( I.LE.N ) QA(I) = Q(I)
    5 CONTINUE
      CALL GSIKJ( KIND, KA, PA, R, P, QA, RJ, E, MISS )
      CALL GSSVD( 6, N, RJ, 6, V, 6, SV, 1.0D-14, RANK )
      DO 10 I = 1, 6
         Z(I) = 0.0D0
         IF ( I.LE.N ) Z(I) = V(I,N)
   10 CONTINUE
      S = SV(N)
      END
C
      SUBROUTINE GSIKP( N, KIND, KA, PA, R, P, Q, S, NB, QS, NS, BR,
     $                  INFO )
C
C     PURPOSE
C     For GSIKZ: a solution put among the others if it is new, or in the
C     place of one that misses the pose by more.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input) DOUBLE PRECISION array, dimension (6).
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
      INTEGER            N, KIND(6), NB, NS, BR(NB), INFO, I, K, L
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), S
      DOUBLE PRECISION   QS(N,NB), QA(6), RJ(6,6), E(6), HERE, THERE
      DOUBLE PRECISION   TOL, GSIKK
      EXTERNAL           GSIKJ, GSIKK
C
      TOL = 3.0D-8 + 1.0D-13/MAX( S, 1.0D-10 )
      DO 20 K = 1, NS
         IF ( GSIKK( N, KIND, Q, QS(1,K) ).LE.TOL ) THEN
            DO 10 I = 1, 6
               QA(I) = 0.0D0
               IF ( I.LE.N ) QA(I) = QS(I,K)
   10       CONTINUE
            CALL GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, HERE )
            CALL GSIKJ( KIND, KA, PA, R, P, QA, RJ, E, THERE )
            IF ( HERE + 1.0D-15.LT.0.5D0*THERE ) THEN
               DO 15 I = 1, N
                  QS(I,K) = Q(I)
   15          CONTINUE
            END IF
            RETURN
         END IF
   20 CONTINUE
      IF ( NS.GE.NB ) RETURN
      NS = NS + 1
      DO 30 I = 1, N
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
