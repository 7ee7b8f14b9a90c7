      SUBROUTINE GSIKZ( N, KIND, KA, PA, R, P, NB, NM, QC, RAD, LIM, QS,
     $                  NS, BR, INFO )
C
C     PURPOSE
C     Solutions of up to six joints refined, and made complete close to
C     singular ones.
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
C     Newton's method on the pose from every solution (GSIK5), then from
C     both sides of every branch whose radicands are above -1D7 times LIM
C     and one of them close to 0 (GSIK4), but where none is within 1D3
C     times LIM of it and the branch was refined to a solution within
C     1D-9: nothing is left to find there. Where the Jacobian has almost
C     lost rank a branch may have lost its digits: where it was not
C     refined to a solution close to it, the curve on which the tool
C     hardly moves is followed (GSIK2); also near a branch that has a
C     radicand close to 0 and another one below. New solutions take the
C     numbers of branches that have none. Places are those of a point on
C     the last axis. Which are singular is seen once more (GSIGS).
C
C     ERROR INDICATOR
C     None of its own.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NB, NM, NS, BR(NB), INFO
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QC(N,NB)
      DOUBLE PRECISION   RAD(NM,NB), LIM(NM), QS(N,NB)
      DOUBLE PRECISION   Z(6), Q(6), E(6), QW(6,400), S, PX(3,6), D(3)
      DOUBLE PRECISION   H, GSIKK
      INTEGER            I, J, K, NW
      LOGICAL            NEAR, OUT, FREE, SURE
      EXTERNAL           GSIGS, GSIKK, GSIKO, GSIKY, GSIK2, GSIK4, GSIK5
C
      DO 6 I = 1, 3
         D(I) = R(I,1)*PA(1,N) + R(I,2)*PA(2,N) + R(I,3)*PA(3,N)
     $          - PA(I,N) + P(I)
         DO 3 J = 1, 6
            PX(I,J) = PA(I,J) - PA(I,N)
    3    CONTINUE
    6 CONTINUE
      CALL GSIK5( N, KIND, KA, PX, R, D, NB, QS, NS, BR )
      NW = 0
      DO 40 K = 1, NB
         NEAR = .FALSE.
         OUT = .FALSE.
         FREE = .FALSE.
         SURE = .TRUE.
         DO 10 I = 1, NM
            IF ( LIM(I).GT.1.0D-20 .AND.
     $           ABS( RAD(I,K) ).LE.1.0D7*LIM(I) ) NEAR = .TRUE.
            IF ( RAD(I,K).LE.1.0D3*LIM(I) ) SURE = .FALSE.
            IF ( LIM(I).LE.1.0D-20 .AND. RAD(I,K).LE.LIM(I) )
     $         FREE = .TRUE.
            IF ( .NOT.( RAD(I,K).GE.-1.0D7*LIM(I) ) ) OUT = .TRUE.
   10    CONTINUE
         DO 15 I = 1, 6
            Q(I) = 0.0D0
            IF ( I.LE.N ) Q(I) = QC(I,K)
   15    CONTINUE
         IF ( OUT .AND. NEAR .AND. .NOT.FREE .AND. N.EQ.6 ) THEN
            CALL GSIKY( KIND, KA, PX, R, D, Q, E, S )
            IF ( S.LE.1.0D-8 ) CALL GSIK2( KIND, KA, PX, R, D, Q, NB,
     $                                     QS, NS, BR, INFO, NW, QW )
         ELSE IF ( .NOT.( OUT .OR. FREE ) ) THEN
            H = 1.0D0
            DO 18 J = 1, NS
               IF ( BR(J).EQ.K ) H = GSIKK( N, KIND, Q, QS(1,J) )
   18       CONTINUE
            IF ( NEAR .AND. .NOT.( SURE .AND. H.LE.1.0D-9 ) ) THEN
               CALL GSIKO( N, KIND, KA, PX, R, D, Q, Z, S )
               CALL GSIK4( N, KIND, KA, PX, R, D, Q, Z, NB, QS, NS, BR,
     $                     INFO )
            END IF
            H = 1.0D0
            DO 20 J = 1, NS
               IF ( BR(J).EQ.K ) H = GSIKK( N, KIND, Q, QS(1,J) )
   20       CONTINUE
            IF ( H.GT.1.0D-9 .AND. N.EQ.6 ) THEN
               CALL GSIKO( N, KIND, KA, PX, R, D, Q, Z, S )
               IF ( S.LE.1.0D-4 .AND.
     $              H.GT.MIN( 1.0D-6, 1.0D-9 + 1.0D-14/S ) )
     $            CALL GSIK2( KIND, KA, PX, R, D, Q, NB, QS, NS, BR,
     $                        INFO, NW, QW )
            END IF
         END IF
   40 CONTINUE
      IF ( NS.EQ.0 ) INFO = 1
      CALL GSIGS( N, KIND, KA, PX, R, D, QS, NS, INFO )
      END
C
      SUBROUTINE GSIPZ( KIND, KA, PA, R, P, X0, NB, NM, QC, RAD, LIM,
     $                  QS, NS, BR, INFO )
C
C     PURPOSE
C     GSIKZ of three joints that bring a point to a place.
C
C     ARGUMENTS
C     KIND, KA, PA (input) as GSIKN, of which three joints count.
C     R, P    (input) as GSIKN; X0 shall come to R*X0 + P.
C     X0      (input) DOUBLE PRECISION array, dimension (3): the point where
C             all coordinates are 0 [m].
C     NB      (input) INTEGER, branches, NB <= 16.
C     NM, QC, RAD, LIM, QS, NS, BR, INFO as GSIKZ, N = 3.
C
C     METHOD
C     Six joints, of which three are none, see GSIKJ; about the point.
C
C     ERROR INDICATOR
C     None of its own.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB, NM, NS, BR(NB), INFO, K6(6), I, J
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), X0(3), QC(3,NB)
      DOUBLE PRECISION   RAD(NM,NB), LIM(NM), QS(3,NB), C6(6,16)
      DOUBLE PRECISION   S6(6,16), A6(3,6), P6(3,6), D(3)
      EXTERNAL           GSIKZ
C
      DO 20 I = 1, 3
         K6(I) = KIND(I)
         K6(3+I) = 2
         D(I) = R(I,1)*X0(1) + R(I,2)*X0(2) + R(I,3)*X0(3) - X0(I)
     $          + P(I)
         DO 10 J = 1, 3
            A6(I,J) = KA(I,J)
            A6(I,3+J) = 0.0D0
            P6(I,J) = PA(I,J) - X0(I)
            P6(I,3+J) = 0.0D0
   10    CONTINUE
         DO 15 J = 1, NB
            C6(I,J) = QC(I,J)
            C6(3+I,J) = 0.0D0
            S6(I,J) = QS(I,J)
            S6(3+I,J) = 0.0D0
   15    CONTINUE
   20 CONTINUE
      CALL GSIKZ( 6, K6, A6, P6, R, D, NB, NM, C6, RAD, LIM, S6, NS, BR,
     $            INFO )
      DO 40 J = 1, NB
         DO 30 I = 1, 3
            QS(I,J) = S6(I,J)
   30    CONTINUE
   40 CONTINUE
      END
C
      SUBROUTINE GSIK5( N, KIND, KA, PA, R, P, NB, QS, NS, BR )
C
C     PURPOSE
C     For GSIKZ: the solutions that are there refined.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P, NB, QS, NS, BR as GSIKZ.
C
C     METHOD
C     Newton's method on the pose. One that misses more than 1D-14 of the
C     size of the arm may become one far from it, others stay close. One
C     that is not refined is kept if it misses less than 1D-11. One that
C     becomes another is left out.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NB, NS, BR(NB), I, K, L, M, IW(6)
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QS(N,NB)
      DOUBLE PRECISION   Q(6), W(42), E(6), MISS, SIZE, FAR, GSIKK
      DOUBLE PRECISION   GSIK0
      LOGICAL            GOOD, KEEP, SAME, CLOSER
      EXTERNAL           GSIKJ, GSIKK, GSIKN, GSIK0, GSIK7
C
      SIZE = GSIK0( N, PA, P )
      M = NS
      NS = 0
      DO 50 K = 1, M
         DO 10 I = 1, 6
            Q(I) = 0.0D0
            IF ( I.LE.N ) Q(I) = QS(I,K)
   10    CONTINUE
         CALL GSIKJ( KIND, KA, PA, R, P, Q, W, E, MISS )
         CALL GSIKN( N, KIND, KA, PA, R, P, Q, W, IW, GOOD )
         KEEP = GOOD .OR. MISS.LE.1.0D-11
         FAR = 0.0D0
         IF ( MISS.LE.1.0D-14*SIZE ) FAR = GSIKK( N, KIND, Q, QS(1,K) )
         IF ( .NOT.GOOD .OR. FAR.GT.1.0D-2 ) THEN
            DO 20 I = 1, N
               Q(I) = QS(I,K)
   20       CONTINUE
         END IF
         DO 30 L = 1, NS
            IF ( KEEP ) THEN
               CALL GSIK7( N, KIND, KA, PA, R, P, Q, QS(1,L), SAME,
     $                     CLOSER )
               KEEP = .NOT.SAME
            END IF
   30    CONTINUE
         IF ( KEEP ) THEN
            NS = NS + 1
            BR(NS) = BR(K)
            DO 40 I = 1, N
               QS(I,NS) = Q(I)
   40       CONTINUE
         END IF
   50 CONTINUE
      DO 70 K = NS + 1, M
         BR(K) = 0
         DO 60 I = 1, N
            QS(I,K) = 0.0D0
   60    CONTINUE
   70 CONTINUE
      END
C
      SUBROUTINE GSIK4( N, KIND, KA, PA, R, P, Q0, Z, NB, QS, NS, BR,
     $                  INFO )
C
C     PURPOSE
C     For GSIKZ: the two solutions beside a singular position.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P, NB, QS, NS, BR, INFO as GSIKZ.
C     Q0      (input) DOUBLE PRECISION array, dimension (N) [rad, m].
C     Z       (input) DOUBLE PRECISION array, dimension (6), from GSIKO.
C
C     METHOD
C     Newton's method from five places on each side: along Z the pose is
C     missed by a parabola, and it stays on its side of the vertex.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NB, NS, BR(NB), INFO, I, L, WAY
      INTEGER            IW(6)
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q0(N), Z(6)
      DOUBLE PRECISION   QS(N,NB), Q(6), W(42), H
      LOGICAL            GOOD
      EXTERNAL           GSIKN, GSIKP
C
      H = 1.0D-2
      DO 30 L = 1, 5
         DO 20 WAY = -1, 1, 2
            DO 10 I = 1, 6
               Q(I) = WAY*H*Z(I)
               IF ( I.LE.N ) Q(I) = Q0(I) + Q(I)
   10       CONTINUE
            CALL GSIKN( N, KIND, KA, PA, R, P, Q, W, IW, GOOD )
            IF ( GOOD ) CALL GSIKP( N, KIND, KA, PA, R, P, Q, NB, QS,
     $                              NS, BR, INFO )
   20    CONTINUE
         H = 0.1D0*H
   30 CONTINUE
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
CGCC$ NOVECTOR
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
C             Jacobian beside the largest.
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
      S = SV(N)/MAX( SV(1), 1.0D-300 )
      END
C
      SUBROUTINE GSIKP( N, KIND, KA, PA, R, P, Q, NB, QS, NS, BR, INFO )
C
C     PURPOSE
C     For GSIKZ: a solution put among the others if it is new, or in the
C     place of one that is the same and misses the pose by more.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input) DOUBLE PRECISION array, dimension (6).
C     NB, QS, NS, BR, INFO as GSIKZ.
C
C     METHOD
C     Compared with each by GSIK7; one that misses more than 1D-14 of the
C     size of the arm is none. Where there is no room it takes that of the
C     one that misses most, if that is more than this.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NB, NS, BR(NB), INFO, I, K, L
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), QS(N,NB)
      DOUBLE PRECISION   RJ(6,6), E(6), X(6), MISS, MOST, GSIK0
      LOGICAL            SAME, CLOSER
      EXTERNAL           GSIKJ, GSIK0, GSIK7
C
      MOST = 1.0D-14*GSIK0( N, PA, P )
      CALL GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, MISS )
      IF ( MISS.GT.MOST ) RETURN
      DO 20 K = 1, NS
         CALL GSIK7( N, KIND, KA, PA, R, P, Q, QS(1,K), SAME, CLOSER )
         IF ( SAME ) THEN
            DO 10 I = 1, N
               IF ( CLOSER ) QS(I,K) = Q(I)
   10       CONTINUE
            RETURN
         END IF
   20 CONTINUE
      IF ( NS.GE.NB ) THEN
         L = 0
         DO 26 K = 1, NS
            DO 24 I = 1, 6
               X(I) = 0.0D0
               IF ( I.LE.N ) X(I) = QS(I,K)
   24       CONTINUE
            CALL GSIKJ( KIND, KA, PA, R, P, X, RJ, E, MISS )
            IF ( MISS.GT.MOST ) THEN
               MOST = MISS
               L = K
            END IF
   26    CONTINUE
         DO 28 I = 1, N
            IF ( L.GT.0 ) QS(I,L) = Q(I)
   28    CONTINUE
         RETURN
      END IF
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
C
      SUBROUTINE GSIK7( N, KIND, KA, PA, R, P, Q, S, SAME, CLOSER )
C
C     PURPOSE
C     For GSIKZ: whether two solutions are the same.
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input) DOUBLE PRECISION array, dimension (6).
C     S       (input) DOUBLE PRECISION array, dimension (N).
C     SAME    (output) LOGICAL.
C     CLOSER  (output) LOGICAL, whether Q misses the pose by less.
C
C     METHOD
C     A pose is known to about 1D-15 of its size E, a solution to E over
C     the least singular value of the Jacobian. Where the determinants
C     have the same sign two solutions within ten times that, what they
C     miss and 3D-8 are the same. Where they have not a singular position
C     is between them, where the pose is missed by an eighth of the
C     distance times the sum of these values: they are the same where that
C     is below E/4. So is S if it is that position, taken for a double
C     solution: if its value is below a quarter of that of Q and what it
C     misses, or E, is between; Q takes its place where it misses more
C     than 2 E (E/2 where the place alone counts). Of fewer joints than
C     the pose has freedoms two are the same if half way between them the
C     pose is missed by no more than 2 E above what they miss.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), I
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), S(N)
      DOUBLE PRECISION   X(6), RJ(6,6), E(6), HERE, THERE, SIZE
      DOUBLE PRECISION   Z(6), U(6), A, B, G, D, GSIKK, GSIK0, GSIK8
      LOGICAL            SAME, CLOSER
      EXTERNAL           GSIKJ, GSIKK, GSIK0, GSIK3, GSIK8
C
      SAME = .FALSE.
      CLOSER = .FALSE.
      IF ( .NOT.( GSIKK( N, KIND, Q, S ).LE.1.0D-1 ) ) RETURN
      SIZE = 1.0D-15*GSIK0( N, PA, P )
      DO 10 I = 1, 6
         X(I) = 0.0D0
         IF ( I.LE.N ) X(I) = S(I)
         Z(I) = 0.0D0
         U(I) = 0.0D0
   10 CONTINUE
      CALL GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, HERE )
      CALL GSIKJ( KIND, KA, PA, R, P, X, RJ, E, THERE )
      CLOSER = HERE + 1.0D-15.LT.0.5D0*THERE
      IF ( N.EQ.6 ) THEN
         D = GSIK8( KIND, Q, X )
         CALL GSIK3( 0, KIND, KA, PA, R, P, X, Z, U, G, A )
         DO 20 I = 1, 6
            X(I) = Q(I)
   20    CONTINUE
         CALL GSIK3( 0, KIND, KA, PA, R, P, X, Z, U, G, B )
         SAME = D*ABS( A - B ).LE.2.0D0*SIZE
         IF ( A*B.GT.0.0D0 ) SAME = ( D - 3.0D-8 )
     $        *MAX( ABS( A ), ABS( B ) )
     $        .LE.1.0D1*SIZE + 2.0D0*( HERE + THERE )
         IF ( ABS( A ).LE.0.25D0*ABS( B ) .AND.
     $        D*ABS( B ).LE.4.0D0*MAX( THERE, SIZE ) ) THEN
            SAME = .TRUE.
            CLOSER = THERE.GT.2.0D0*SIZE .AND. HERE.LE.0.5D0*THERE
            IF ( KIND(4).EQ.2 ) CLOSER = THERE.GT.0.5D0*SIZE .AND.
     $                                   HERE.LE.0.5D0*THERE
         END IF
      ELSE
CGCC$ NOVECTOR
         DO 30 I = 1, N
            D = Q(I) - S(I)
            IF ( KIND(I).EQ.1 ) D = ATAN2( SIN( D ), COS( D ) )
            X(I) = S(I) + 0.5D0*D
   30    CONTINUE
         CALL GSIKJ( KIND, KA, PA, R, P, X, RJ, E, D )
         SAME = D.LE.MAX( HERE, THERE ) + 2.0D0*SIZE
      END IF
      END
C
      DOUBLE PRECISION FUNCTION GSIK0( N, PA, P )
C
C     PURPOSE
C     For GSIK7: the size of an arm and its pose, at least 1.
C
C     ARGUMENTS
C     N, PA, P (input) as GSIKN.
C
C     METHOD
C     The largest coordinate.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, I, J
      DOUBLE PRECISION   PA(3,6), P(3)
C
      GSIK0 = 1.0D0
      DO 20 I = 1, 3
         GSIK0 = MAX( GSIK0, ABS( P(I) ) )
         DO 10 J = 1, N
            GSIK0 = MAX( GSIK0, ABS( PA(I,J) ) )
   10    CONTINUE
   20 CONTINUE
      END
