      SUBROUTINE GSIKD( IKC, N, NC, NB, AT, P, R, QG, CST, QC, DST )
C
C     PURPOSE
C     How far a place is from what the joints ahead of a wrist can reach.
C
C     ARGUMENTS
C     IKC     (external) IKC( P, R, QG, CST, QA, MISS, JC ): what the
C             centre of the wrist misses of its place at the coordinates
C             QA, and its Jacobian, dimension (3,N).
C     N       (input) INTEGER, coordinates ahead of the wrist, 1 to 3.
C     NC      (input) INTEGER, coordinates of the chain.
C     NB      (input) INTEGER, branches.
C     AT      (input) INTEGER, coordinates of the chain ahead of those N.
C     P, R, QG, CST (input) as IKC.
C     QC      (input) DOUBLE PRECISION array, dimension (NC,NB): guesses.
C     DST     (output) DOUBLE PRECISION, the distance [m].
C
C     METHOD
C     Least squares by Levenberg and Marquardt from every guess, at most
C     1000 steps; the least one counts.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      EXTERNAL           IKC
      INTEGER            N, NC, NB, AT
      DOUBLE PRECISION   P(3), R(3,3), QG(*), CST(*), QC(NC,NB), DST
      DOUBLE PRECISION   Q(3), QN(3), E(3), EN(3), J(3,3), JN(3,3), S(3)
      DOUBLE PRECISION   F, FN, MU, A(3,3)
      INTEGER            I, K, L, M, IT, INFO
      EXTERNAL           GSSPD
C
      DST = -1.0D0
      DO 80 K = 1, NB
         DO 10 I = 1, N
            Q(I) = QC(AT+I,K)
   10    CONTINUE
         CALL IKC( P, R, QG, CST, Q, E, J )
         F = E(1)**2 + E(2)**2 + E(3)**2
         MU = 1.0D-4
         DO 60 IT = 1, 1000
            DO 40 I = 1, N
               S(I) = 0.0D0
               DO 20 M = 1, 3
                  S(I) = S(I) + J(M,I)*E(M)
   20          CONTINUE
               DO 30 L = 1, N
                  A(L,I) = J(1,L)*J(1,I) + J(2,L)*J(2,I)
     $                     + J(3,L)*J(3,I)
   30          CONTINUE
               A(I,I) = A(I,I) + MU
   40       CONTINUE
            CALL GSSPD( N, 1, A, 3, S, 3, INFO )
            DO 50 I = 1, N
               QN(I) = Q(I) + S(I)
   50       CONTINUE
            CALL IKC( P, R, QG, CST, QN, EN, JN )
            FN = EN(1)**2 + EN(2)**2 + EN(3)**2
            IF ( FN.LT.F ) THEN
               MU = MAX( 0.1D0*MU, 1.0D-15 )
               DO 55 I = 1, 3
                  Q(I) = QN(I)
                  E(I) = EN(I)
                  DO 52 L = 1, 3
                     J(L,I) = JN(L,I)
   52             CONTINUE
   55          CONTINUE
               F = FN
            ELSE
               MU = 10.0D0*MU
               IF ( MU.GT.1.0D6 ) GO TO 70
            END IF
   60    CONTINUE
   70    CONTINUE
         IF ( DST.LT.0.0D0 .OR. F.LT.DST ) DST = F
   80 CONTINUE
      DST = SQRT( MAX( DST, 0.0D0 ) )
      END
