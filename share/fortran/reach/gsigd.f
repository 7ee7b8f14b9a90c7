      SUBROUTINE GSIGD( KA, PA, R, P, Q, NS, INFO )
C
C     PURPOSE
C     For GSIKG: double solutions made one; is a solution singular?
C
C     ARGUMENTS
C     KA, PA, R, P (input) as GSIKG.
C     Q       (input/output) DOUBLE PRECISION array, dimension (6,16):
C             solutions [rad].
C     NS      (input/output) INTEGER, their number.
C     INFO    (output) INTEGER, 2: a solution is singular; else 0.
C
C     METHOD
C     Rounding errors E of the pose divide a double solution into two
C     that are the square root of E apart. Two solutions become the
C     position half way between them where this misses the pose by less
C     than 4D-14 of the size of the arm: nothing tells them apart.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6,16)
      DOUBLE PRECISION   X(6), RJ(6,6), E(6), MISS, D, GSIK0, GSIKK
      INTEGER            NS, INFO, I, J, K, L, KIND(6)
      LOGICAL            ONE
      EXTERNAL           GSIGS, GSIK0, GSIKJ, GSIKK
      DATA               KIND / 6*1 /
C
      INFO = 0
      DO 50 K = NS, 2, -1
         ONE = .FALSE.
         DO 30 J = 1, K - 1
            D = GSIKK( 6, KIND, Q(1,K), Q(1,J) )
            IF ( ONE .OR. D.GT.1.0D-4 ) GO TO 30
CGCC$ NOVECTOR
            DO 10 I = 1, 6
               D = Q(I,K) - Q(I,J)
               D = Q(I,J) + 0.5D0*ATAN2( SIN( D ), COS( D ) )
               X(I) = ATAN2( SIN( D ), COS( D ) )
   10       CONTINUE
            CALL GSIKJ( KIND, KA, PA, R, P, X, RJ, E, MISS )
            ONE = MISS.LE.4.0D-14*GSIK0( 6, PA, P )
            DO 20 I = 1, 6
               IF ( ONE ) Q(I,J) = X(I)
   20       CONTINUE
   30    CONTINUE
         IF ( ONE ) THEN
            INFO = 2
            NS = NS - 1
            DO 40 L = K, NS
               DO 35 I = 1, 6
                  Q(I,L) = Q(I,L+1)
   35          CONTINUE
   40       CONTINUE
         END IF
   50 CONTINUE
      CALL GSIGS( 6, KIND, KA, PA, R, P, Q, NS, INFO )
      END
C
      SUBROUTINE GSIGS( N, KIND, KA, PA, R, P, QS, NS, INFO )
C
C     PURPOSE
C     For GSIKG and GSIKZ: is a solution singular?
C
C     ARGUMENTS
C     N, KIND, KA, PA, R, P (input) as GSIKN.
C     QS      (input) DOUBLE PRECISION array, dimension (N,NS): solutions
C             [rad, m].
C     NS      (input) INTEGER, their number.
C     INFO    (input/output) INTEGER, 2 where one is.
C
C     METHOD
C     The least singular value of the Jacobian is at most 3D-8 of the
C     largest: the square root of rounding errors, to which a double
C     solution is known.
C
      IMPLICIT NONE
      INTEGER            N, KIND(6), NS, INFO, K
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QS(N,*)
      DOUBLE PRECISION   Z(6), S
      EXTERNAL           GSIKO
C
      DO 10 K = 1, NS
         CALL GSIKO( N, KIND, KA, PA, R, P, QS(1,K), Z, S )
         IF ( S.LE.3.0D-8 ) INFO = 2
   10 CONTINUE
      END
