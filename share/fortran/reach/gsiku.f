      SUBROUTINE GSIKU( KIND, KA, PA, R, P, X0, NB, QC, DST )
C
C     PURPOSE
C     How close six joints bring a tool to a pose out of reach.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P (input) as GSIKN.
C     X0      (input) DOUBLE PRECISION array, dimension (3): the tool's
C             point where all angles are 0 [m].
C     NB      (input) INTEGER, guesses; 0: eight of its own.
C     QC      (input) DOUBLE PRECISION array, dimension (6,NB): guesses of
C             the joints' coordinates [rad, m].
C     DST     (output) DOUBLE PRECISION array, dimension (2): what the
C             closest position misses, of the place [m], of the axes
C             [rad]: the sum of the squares is the least that was found.
C
C     METHOD
C     Least squares by Levenberg and Marquardt from every guess, at most
C     100 steps.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            KIND(6), NB
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), X0(3), QC(6,*)
      DOUBLE PRECISION   DST(2), PX(3,6), D(3), Q(6), LEAST, F, E(6)
      INTEGER            I, J, K, N
      EXTERNAL           GSIKY
C
      DO 20 I = 1, 3
         D(I) = R(I,1)*X0(1) + R(I,2)*X0(2) + R(I,3)*X0(3) + P(I)
     $          - X0(I)
         DO 10 J = 1, 6
            PX(I,J) = PA(I,J) - X0(I)
   10    CONTINUE
   20 CONTINUE
      LEAST = -1.0D0
      N = NB
      IF ( N.EQ.0 ) N = 8
      DO 40 K = 1, N
         DO 30 I = 1, 6
            IF ( NB.EQ.0 ) THEN
               Q(I) = 1.1D0*( MOD( K*( 2*I + 1 ), 7 ) - 3 )
            ELSE
               Q(I) = QC(I,K)
            END IF
   30    CONTINUE
         CALL GSIKY( KIND, KA, PX, R, D, Q, E, F )
         IF ( LEAST.LT.0.0D0 .OR. F.LT.LEAST ) THEN
            LEAST = F
            DST(1) = SQRT( E(1)**2 + E(2)**2 + E(3)**2 )
            DST(2) = SQRT( E(4)**2 + E(5)**2 + E(6)**2 )
         END IF
   40 CONTINUE
      END
C
      SUBROUTINE GSIKY( KIND, KA, PA, R, P, Q, E, F )
C
C     PURPOSE
C     For GSIKU: the closest position near a guess.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P (input) as GSIKN.
C     Q       (input/output) DOUBLE PRECISION array, dimension (6).
C     E       (output) DOUBLE PRECISION array, dimension (6): what it
C             misses, see GSIKJ.
C     F       (output) DOUBLE PRECISION, the sum of its squares.
C
C     METHOD
C     See GSIKU.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), E(6), F
      DOUBLE PRECISION   RJ(6,6), JN(6,6), EN(6), QN(6), A(6,6), S(6)
      DOUBLE PRECISION   MU, FN, MISS
      INTEGER            KIND(6), I, K, L, IT, INFO
      EXTERNAL           GSIKJ, GSSPD
C
      MU = 1.0D-4
      CALL GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, MISS )
      F = 0.0D0
      DO 10 I = 1, 6
         F = F + E(I)**2
   10 CONTINUE
      DO 70 IT = 1, 100
         DO 40 I = 1, 6
            S(I) = 0.0D0
            DO 30 K = 1, 6
               S(I) = S(I) + RJ(K,I)*E(K)
               A(K,I) = 0.0D0
               DO 20 L = 1, 6
                  A(K,I) = A(K,I) + RJ(L,K)*RJ(L,I)
   20          CONTINUE
   30       CONTINUE
            A(I,I) = A(I,I) + MU
   40    CONTINUE
         CALL GSSPD( 6, 1, A, 6, S, 6, INFO )
         DO 50 I = 1, 6
            QN(I) = Q(I) + S(I)
   50    CONTINUE
         CALL GSIKJ( KIND, KA, PA, R, P, QN, JN, EN, MISS )
         FN = 0.0D0
         DO 55 I = 1, 6
            FN = FN + EN(I)**2
   55    CONTINUE
         IF ( FN.LT.F ) THEN
            MU = MAX( 0.1D0*MU, 1.0D-15 )
            DO 65 I = 1, 6
               Q(I) = QN(I)
               E(I) = EN(I)
               DO 60 K = 1, 6
                  RJ(K,I) = JN(K,I)
   60          CONTINUE
   65       CONTINUE
            F = FN
         ELSE
            MU = 10.0D0*MU
            IF ( MU.GT.1.0D6 ) RETURN
         END IF
   70 CONTINUE
      END
