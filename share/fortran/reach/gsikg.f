      SUBROUTINE GSIKG( KA, PA, R, P, QC, NS, W, IW, INFO )
C
C     PURPOSE
C     All angles of six revolute joints in any position to each other
C     that make a displacement x -> R x + P, at most 16.
C
C     ARGUMENTS
C     KA      (input) DOUBLE PRECISION array, dimension (3,6): the axes of
C             the joints where all angles are 0, unit vectors [1].
C     PA      (input) DOUBLE PRECISION array, dimension (3,6): points on
C             them [m].
C     R       (input) DOUBLE PRECISION array, dimension (3,3) [1].
C     P       (input) DOUBLE PRECISION array, dimension (3) [m].
C     QC      (output) DOUBLE PRECISION array, dimension (6,16): the
C             angles of the NS solutions [rad], rising.
C     NS      (output) INTEGER.
C     W       (workspace) DOUBLE PRECISION array, dimension (1200).
C     IW      (workspace) INTEGER array, dimension (24).
C     INFO    (output) INTEGER, 0; 2: a solution is singular (two
C             coincide, or a joint moves without the tool), see GSIGD.
C
C     METHOD
C     The line of axis 6, told by point p and direction l, gives fifteen
C     numbers (p, l, p.p, p.l, p x l, (p.p)l - 2(p.l)p, 1) that every
C     displacement changes linearly; fourteen equations between those
C     moved by joints 3 to 5 and those moved back by joints 2 and 1. The
C     angles 1 and 2 are eliminated linearly, six equations are left, and
C     as many times the half tangent of angle 4: the half tangent of
C     angle 3 is an eigenvalue of a matrix of order 24 (Raghavan, Roth).
C     That, and the same of the chain backwards. Axes that are parallel
C     can make this singular everywhere: then the same with the last axes
C     carried by the pose to the front of the chain, until two orders of
C     the joints are regular; where none is, the same of four arms very
C     close to this one. Every candidate is refined by Newton's method on
C     the pose and taken if it misses less than 1D-11 of it; close to
C     singular positions others are looked for as GSIKZ does.
C
C     REFERENCES
C     M. Raghavan, B. Roth, J. Mech. Design 115 (1993), 502-508.
C     D. Manocha, J. Canny, IEEE Trans. Robotics Automation 10 (1994),
C     648-657.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QC(6,16)
      DOUBLE PRECISION   W(*), KB(3,6), PB(3,6), P2(3), SIZE
      DOUBLE PRECISION   PC(3,6), CEN(3)
      INTEGER            NS, IW(24), INFO, I, J, L, L0, NREG
      EXTERNAL           GSIKB, GSIK6, GSIGC
C
C     -- lengths beside their largest, about the middle of the points
      NS = 0
      INFO = 0
      SIZE = 0.0D0
      DO 20 I = 1, 3
         CEN(I) = 0.0D0
         DO 10 J = 1, 6
            CEN(I) = CEN(I) + PA(I,J)/6.0D0
   10    CONTINUE
   20 CONTINUE
      DO 40 J = 1, 6
         DO 30 I = 1, 3
            PC(I,J) = PA(I,J) - CEN(I)
            SIZE = MAX( SIZE, ABS( PC(I,J) ) )
   30    CONTINUE
   40 CONTINUE
      IF ( .NOT.( SIZE.GT.0.0D0 ) ) RETURN
      DO 60 I = 1, 3
         P2(I) = ( P(I) + R(I,1)*CEN(1) + R(I,2)*CEN(2) + R(I,3)*CEN(3)
     $             - CEN(I) )/SIZE
         DO 50 J = 1, 6
            PC(I,J) = PC(I,J)/SIZE
   50    CONTINUE
   60 CONTINUE
      NREG = 0
      DO 70 J = 1, 6
         DO 65 I = 1, 3
            KB(I,J) = KA(I,J)
            PB(I,J) = PC(I,J)
   65    CONTINUE
   70 CONTINUE
      DO 80 L = 0, 5
         IF ( L.GT.0 ) CALL GSIK6( R, P2, KB, PB )
         L0 = L
         CALL GSIKB( KB, PB, R, P2, KA, PC, L0, QC, NS, NREG, W, IW )
         IF ( NREG.GE.2 ) GO TO 130
   80 CONTINUE
      IF ( NREG.GT.0 ) GO TO 130
C     -- no order is regular: four neighbours of this arm
      DO 120 L = 1, 4
         DO 110 J = 1, 6
CGCC$ NOVECTOR
            DO 100 I = 1, 3
               KB(I,J) = KA(I,J) + 3.0D-6*L*SIN( 1.0D0*( 7*I + 3*J*L ) )
               PB(I,J) = PC(I,J) + 3.0D-6*L*COS( 1.0D0*( 5*I + 4*J*L ) )
  100       CONTINUE
            SIZE = SQRT( KB(1,J)**2 + KB(2,J)**2 + KB(3,J)**2 )
            DO 105 I = 1, 3
               KB(I,J) = KB(I,J)/SIZE
  105       CONTINUE
  110    CONTINUE
         L0 = 0
         CALL GSIKB( KB, PB, R, P2, KA, PC, L0, QC, NS, NREG, W, IW )
  120 CONTINUE
  130 CONTINUE
      CALL GSIGC( KA, PC, R, P2, QC, NS, INFO )
      END
C
      SUBROUTINE GSIGC( KA, PA, R, P, QC, NS, INFO )
C
C     PURPOSE
C     For GSIKG: solutions made complete close to singular ones.
C
C     ARGUMENTS
C     KA, PA, R, P (input) as GSIKG.
C     QC, NS  (input/output) as GSIKG.
C     INFO    (output) INTEGER, as GSIKG.
C
C     METHOD
C     As GSIKZ, from the solutions where the least singular value of the
C     Jacobian is below 1D-4 of the largest; double ones by GSIGD.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), QC(6,16)
      DOUBLE PRECISION   Q(6,16), Z(6), QW(6,400), S
      INTEGER            NS, M, BR(16), KIND(6), I, K, INFO, NW
      EXTERNAL           GSIGD, GSIKA, GSIKO, GSIK2, GSIK4, GSIK5
      DATA               KIND / 6*1 /
C
      M = 0
      INFO = 0
      DO 20 K = 1, NS
         CALL GSIKO( 6, KIND, KA, PA, R, P, QC(1,K), Z, S )
         IF ( S.LE.1.0D-4 ) M = M + 1
         DO 10 I = 1, 6
            Q(I,K) = QC(I,K)
   10    CONTINUE
         BR(K) = K
   20 CONTINUE
      IF ( M.EQ.0 ) RETURN
      NW = 0
      CALL GSIK5( 6, KIND, KA, PA, R, P, 16, Q, NS, BR )
      M = NS
      DO 30 K = 1, M
         CALL GSIKO( 6, KIND, KA, PA, R, P, Q(1,K), Z, S )
         IF ( S.LE.1.0D-4 ) THEN
            DO 25 I = 1, 6
               QC(I,1) = Q(I,K)
   25       CONTINUE
            CALL GSIK4( 6, KIND, KA, PA, R, P, QC, Z, 16, Q, NS, BR,
     $                  INFO )
            CALL GSIK2( KIND, KA, PA, R, P, QC, 16, Q, NS, BR, INFO, NW,
     $                  QW )
         END IF
   30 CONTINUE
      CALL GSIGD( KA, PA, R, P, Q, NS, INFO )
      M = NS
      NS = 0
      DO 40 K = 1, M
         CALL GSIKA( Q(1,K), QC, NS )
   40 CONTINUE
      END
C
      SUBROUTINE GSIK6( R, P, KA, PA )
C
C     PURPOSE
C     For GSIKG: the last axis of a chain carried to its front by the
C     displacement that the chain makes.
C
C     ARGUMENTS
C     R, P    (input) as GSIKG.
C     KA, PA  (input/output) as GSIKG.
C
C     METHOD
C     T1 ... T6 = D is T6' T1 ... T5 = D, where T6' = D T6 D**(-1) turns
C     by the same angle about the axis that D gives it.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   R(3,3), P(3), KA(3,6), PA(3,6), K(3), X(3)
      INTEGER            I, J
C
      DO 10 I = 1, 3
         K(I) = R(I,1)*KA(1,6) + R(I,2)*KA(2,6) + R(I,3)*KA(3,6)
         X(I) = R(I,1)*PA(1,6) + R(I,2)*PA(2,6) + R(I,3)*PA(3,6) + P(I)
   10 CONTINUE
      DO 30 J = 6, 2, -1
         DO 20 I = 1, 3
            KA(I,J) = KA(I,J-1)
            PA(I,J) = PA(I,J-1)
   20    CONTINUE
   30 CONTINUE
      DO 40 I = 1, 3
         KA(I,1) = K(I)
         PA(I,1) = X(I)
   40 CONTINUE
      END
C
      SUBROUTINE GSIKB( KA, PA, R, P, K0, P0, L0, QC, NS, NREG, W, IW )
C
C     PURPOSE
C     For GSIKG: GSIK1 of an arm and of the same taken backwards.
C
C     ARGUMENTS
C     NREG    (input/output) INTEGER, how many orders of the joints were
C             regular; the others as GSIK1.
C
C     METHOD
C     The opposite displacement.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), K0(3,6)
      DOUBLE PRECISION   P0(3,6), QC(6,16), W(*), KB(3,6), PB(3,6)
      DOUBLE PRECISION   RB(3,3), D(3)
      INTEGER            L0, NS, NREG, IW(24), I, J, L, INFO
      EXTERNAL           GSIK1
C
      CALL GSIK1( KA, PA, R, P, K0, P0, R, P, 1, L0, QC, NS, W, IW,
     $            INFO )
      IF ( INFO.EQ.0 ) NREG = NREG + 1
      DO 30 I = 1, 3
         DO 10 J = 1, 6
            KB(I,J) = KA(I,7-J)
            PB(I,J) = PA(I,7-J)
   10    CONTINUE
         DO 20 L = 1, 3
            RB(I,L) = R(L,I)
   20    CONTINUE
   30 CONTINUE
      DO 40 I = 1, 3
         D(I) = -( RB(I,1)*P(1) + RB(I,2)*P(2) + RB(I,3)*P(3) )
   40 CONTINUE
      CALL GSIK1( KB, PB, RB, D, K0, P0, R, P, -1, L0, QC, NS, W, IW,
     $            INFO )
      IF ( INFO.EQ.0 ) NREG = NREG + 1
      END
C
      SUBROUTINE GSIK1( KA, PA, R, P, K0, P0, R0, D0, WAY, L0, QC, NS,
     $                  W, IW, INFO )
C
C     PURPOSE
C     For GSIKG: solutions by one order of the joints, added to those that
C     are there.
C
C     ARGUMENTS
C     KA, PA, R, P (input) as GSIKG, in the order of the elimination.
C     K0, P0, R0, D0 (input) the same in the order of the chain.
C     WAY     (input) INTEGER, 1 or -1: backwards.
C     L0      (input) INTEGER, how many axes were carried to the front.
C     QC, NS  (input/output) as GSIKG.
C     W       (workspace) DOUBLE PRECISION array, dimension (1200).
C     IW      (workspace) INTEGER array, dimension (24).
C
C     METHOD
C     See GSIKG.
C
C     ERROR INDICATOR
C     INFO =  0  ok;
C     INFO =  1  the equations are singular: there are no candidates;
C     INFO =  2  they are almost so.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), K0(3,6)
      DOUBLE PRECISION   P0(3,6), R0(3,3), D0(3), QC(6,16), W(*)
      DOUBLE PRECISION   Q(6), F(14,27), G(14,9), H(6,9,3), SHIFT
      DOUBLE PRECISION   ER(24), EI(24), T
      DOUBLE PRECISION   Q0(6)
      INTEGER            WAY, L0, NS, IW(24), I, J, INFO, EIG, KIND(6)
      LOGICAL            GOOD
      EXTERNAL           GSIKL, GSIKR, GSIKE, GSIKC, GSEIG, GSIKV, GSIKN
      EXTERNAL           GSIKA
      DATA               KIND / 6*1 /
C
      CALL GSIKL( KA, PA, F )
      CALL GSIKR( KA, PA, R, P, G )
      CALL GSIKE( F, G, H, W )
      CALL GSIKC( H, SHIFT, W, W(577), W(721), IW, INFO )
      IF ( INFO.EQ.1 ) RETURN
      CALL GSEIG( 24, W, 24, ER, EI, W(577), EIG )
      IF ( EIG.NE.0 ) INFO = 1
      IF ( EIG.NE.0 ) RETURN
      DO 20 I = 1, 24
         IF ( ABS( EI(I) ).LE.1.0D-3*( 1.0D0 + ABS( ER(I) ) ) ) THEN
            Q(3) = SHIFT + 2.0D0*ATAN( ER(I) )
            CALL GSIKV( KA, PA, R, F, G, H, Q, W )
            IF ( WAY.LT.0 ) THEN
               DO 10 J = 1, 3
                  T = Q(J)
                  Q(J) = -Q(7-J)
                  Q(7-J) = -T
   10          CONTINUE
            END IF
            DO 15 J = 1, 6
               Q0(MOD( J + 5 - L0, 6 )+1) = Q(J)
   15       CONTINUE
            CALL GSIKN( 6, KIND, K0, P0, R0, D0, Q0, W, IW, GOOD )
            IF ( GOOD ) CALL GSIKA( Q0, QC, NS )
         END IF
   20 CONTINUE
      END
C
      SUBROUTINE GSIKT( K, P, S, C, X, E )
C
C     PURPOSE
C     A point X and a direction E turned about the axis K through P.
C
C     ARGUMENTS
C     K, P    (input) DOUBLE PRECISION arrays, dimension (3).
C     S, C    (input) DOUBLE PRECISION, sine and cosine of the angle.
C     X, E    (input/output) DOUBLE PRECISION arrays, dimension (3).
C
C     METHOD
C     Rodrigues.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   K(3), P(3), S, C, X(3), E(3), U(3), D
      INTEGER            I
C
      D = K(1)*E(1) + K(2)*E(2) + K(3)*E(3)
      U(1) = K(2)*E(3) - K(3)*E(2)
      U(2) = K(3)*E(1) - K(1)*E(3)
      U(3) = K(1)*E(2) - K(2)*E(1)
      DO 10 I = 1, 3
         E(I) = C*E(I) + S*U(I) + ( 1.0D0 - C )*D*K(I)
         X(I) = X(I) - P(I)
   10 CONTINUE
      D = K(1)*X(1) + K(2)*X(2) + K(3)*X(3)
      U(1) = K(2)*X(3) - K(3)*X(2)
      U(2) = K(3)*X(1) - K(1)*X(3)
      U(3) = K(1)*X(2) - K(2)*X(1)
      DO 20 I = 1, 3
         X(I) = P(I) + C*X(I) + S*U(I) + ( 1.0D0 - C )*D*K(I)
   20 CONTINUE
      END
C
      SUBROUTINE GSIKW( X, E, V )
C
C     PURPOSE
C     Fourteen numbers of a line that displacements change linearly, and
C     affinely together.
C
C     ARGUMENTS
C     X, E    (input) DOUBLE PRECISION arrays, dimension (3): a point of
C             it, its direction.
C     V       (output) DOUBLE PRECISION array, dimension (14): X, E, X.X,
C             X.E, X x E, (X.X)E - 2(X.E)X.
C
C     METHOD
C     As said.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   X(3), E(3), V(14)
      INTEGER            I
C
      V(7) = X(1)*X(1) + X(2)*X(2) + X(3)*X(3)
      V(8) = X(1)*E(1) + X(2)*E(2) + X(3)*E(3)
      V(9) = X(2)*E(3) - X(3)*E(2)
      V(10) = X(3)*E(1) - X(1)*E(3)
      V(11) = X(1)*E(2) - X(2)*E(1)
      DO 10 I = 1, 3
         V(I) = X(I)
         V(3+I) = E(I)
         V(11+I) = V(7)*E(I) - 2.0D0*V(8)*X(I)
   10 CONTINUE
      END
C
      SUBROUTINE GSIKF( M, N, L, F )
C
C     PURPOSE
C     Values at the angles 0, 90 and 180 degrees become the coefficients
C     of cosine, sine and 1.
C
C     ARGUMENTS
C     M, N, L (input) INTEGER.
C     F       (input/output) DOUBLE PRECISION array, dimension (M,3,L) if
C             N = 1, else of M*N in the place of M: the middle index is
C             that of the angle.
C
C     METHOD
C     Half the sum and half the difference of the values at 0 and 180.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            M, N, L, I, J
      DOUBLE PRECISION   F(M*N,3,L), A, B
C
      DO 20 J = 1, L
         DO 10 I = 1, M*N
            A = F(I,1,J)
            B = F(I,3,J)
            F(I,3,J) = 0.5D0*( A + B )
            F(I,1,J) = 0.5D0*( A - B )
            F(I,2,J) = F(I,2,J) - F(I,3,J)
   10    CONTINUE
   20 CONTINUE
      END
C
      SUBROUTINE GSIKL( KA, PA, F )
C
C     PURPOSE
C     For GSIKG: the numbers of axis 6 moved by joints 5, 4 and 3.
C
C     ARGUMENTS
C     KA, PA  (input) as GSIKG.
C     F       (output) DOUBLE PRECISION array, dimension (14,27): the
C             coefficients of (cos, sin, 1) of angle 5, times that of
C             angle 4, times that of angle 3; 5 runs first.
C
C     METHOD
C     Values at 0, 90 and 180 degrees.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), F(14,27), X(3), E(3)
      DOUBLE PRECISION   S(3), C(3)
      INTEGER            I, J, K, L
      EXTERNAL           GSIKT, GSIKW, GSIKF
      DATA               S / 0.0D0, 1.0D0, 0.0D0 /
      DATA               C / 1.0D0, 0.0D0, -1.0D0 /
C
      DO 40 I = 1, 3
         DO 30 J = 1, 3
            DO 20 K = 1, 3
               DO 10 L = 1, 3
                  X(L) = PA(L,6)
                  E(L) = KA(L,6)
   10          CONTINUE
               CALL GSIKT( KA(1,5), PA(1,5), S(K), C(K), X, E )
               CALL GSIKT( KA(1,4), PA(1,4), S(J), C(J), X, E )
               CALL GSIKT( KA(1,3), PA(1,3), S(I), C(I), X, E )
               CALL GSIKW( X, E, F(1,9*(I-1)+3*(J-1)+K) )
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      CALL GSIKF( 14, 1, 9, F )
      CALL GSIKF( 14, 3, 3, F )
      CALL GSIKF( 14, 9, 1, F )
      END
C
      SUBROUTINE GSIKR( KA, PA, R, P, G )
C
C     PURPOSE
C     For GSIKG: the numbers of the line where axis 6 shall be, moved back
C     by joints 1 and 2.
C
C     ARGUMENTS
C     KA, PA, R, P (input) as GSIKG.
C     G       (output) DOUBLE PRECISION array, dimension (14,9): the
C             coefficients of (cos, sin, 1) of angle 2, times that of
C             angle 1; 2 runs first.
C
C     METHOD
C     Values at 0, 90 and 180 degrees.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), G(14,9), X(3)
      DOUBLE PRECISION   E(3), S(3), C(3)
      INTEGER            I, J, L
      EXTERNAL           GSIKT, GSIKW, GSIKF
      DATA               S / 0.0D0, -1.0D0, 0.0D0 /
      DATA               C / 1.0D0, 0.0D0, -1.0D0 /
C
      DO 30 I = 1, 3
         DO 20 J = 1, 3
            DO 10 L = 1, 3
               E(L) = R(L,1)*KA(1,6) + R(L,2)*KA(2,6) + R(L,3)*KA(3,6)
               X(L) = R(L,1)*PA(1,6) + R(L,2)*PA(2,6) + R(L,3)*PA(3,6)
     $                + P(L)
   10       CONTINUE
            CALL GSIKT( KA(1,1), PA(1,1), S(I), C(I), X, E )
            CALL GSIKT( KA(1,2), PA(1,2), S(J), C(J), X, E )
            CALL GSIKW( X, E, G(1,3*(I-1)+J) )
   20    CONTINUE
   30 CONTINUE
      CALL GSIKF( 14, 1, 3, G )
      CALL GSIKF( 14, 3, 1, G )
      END
C
      SUBROUTINE GSIKE( F, G, H, W )
C
C     PURPOSE
C     For GSIKG: six equations without the angles 1 and 2.
C
C     ARGUMENTS
C     F, G    (input) from GSIKL, GSIKR.
C     H       (output) DOUBLE PRECISION array, dimension (6,9,3): the
C             coefficients of x4**i * x5**j (j = 0, 1, 2 first), times
C             cos, sin and 1 of angle 3; x4, x5: half tangents, times
C             (1 + x4**2)(1 + x5**2).
C     W       (workspace) DOUBLE PRECISION array, dimension (322).
C
C     METHOD
C     Combinations of the equations in which angles 1 and 2 have no part,
C     by the singular vectors of their coefficients.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   F(14,9,3), G(14,9), H(6,9,3), W(8,*), S(14)
      DOUBLE PRECISION   V(14,14), B(6,3,3), A, Z
      INTEGER            I, J, J4, J5, K, L, RANK
      EXTERNAL           GSSVD
C
      DO 20 J = 1, 14
         DO 10 I = 1, 8
            W(I,J) = G(J,I)
   10    CONTINUE
   20 CONTINUE
      CALL GSSVD( 8, 14, W, 8, V, 14, S, 1.0D-14, RANK )
      DO 90 K = 1, 3
         DO 60 I = 1, 6
            DO 50 J4 = 1, 3
               DO 40 J5 = 1, 3
                  J = 3*J4 - 3 + J5
                  A = 0.0D0
                  DO 30 L = 1, 14
                     Z = F(L,J,K)
                     IF ( K.EQ.3 .AND. J.EQ.9 ) Z = Z - G(L,9)
                     A = A + V(L,8+I)*Z
   30             CONTINUE
                  B(I,J5,J4) = A
   40          CONTINUE
   50       CONTINUE
   60    CONTINUE
         DO 80 I = 1, 6
            CALL GSIKH( B, I, H(1,1,K) )
   80    CONTINUE
   90 CONTINUE
      END
C
      SUBROUTINE GSIKH( B, I, H )
C
C     PURPOSE
C     For GSIKE: cosines and sines of angles 5 and 4 by half tangents.
C
C     ARGUMENTS
C     B       (input) DOUBLE PRECISION array, dimension (6,3,3): by
C             equation, (cos, sin, 1) of angle 5 and of angle 4.
C     I       (input) INTEGER, the equation.
C     H       (output) DOUBLE PRECISION array, dimension (6,9): row I is
C             set.
C
C     METHOD
C     cos: 1 - x**2, sin: 2 x, 1: 1 + x**2.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   B(6,3,3), H(6,9), T(3,3)
      INTEGER            I, J, K
C
      DO 10 K = 1, 3
         T(1,K) = B(I,3,K) + B(I,1,K)
         T(2,K) = 2.0D0*B(I,2,K)
         T(3,K) = B(I,3,K) - B(I,1,K)
   10 CONTINUE
      DO 20 J = 1, 3
         H(I,J) = T(J,3) + T(J,1)
         H(I,3+J) = 2.0D0*T(J,2)
         H(I,6+J) = T(J,3) - T(J,1)
   20 CONTINUE
      END
C
      SUBROUTINE GSIKC( H, SHIFT, A, S2, X, IW, INFO )
C
C     PURPOSE
C     For GSIKG: the matrix whose eigenvalues are the half tangents of
C     angle 3 from SHIFT on.
C
C     ARGUMENTS
C     H       (input) from GSIKE.
C     SHIFT   (output) DOUBLE PRECISION [rad].
C     A       (output) DOUBLE PRECISION array, dimension (24,24).
C     S2      (workspace) DOUBLE PRECISION array, dimension (12,12).
C     X       (workspace) DOUBLE PRECISION array, dimension (12,24).
C     IW      (workspace) INTEGER array, dimension (12).
C     INFO    (output) INTEGER, 0, or 1: the leading matrix is singular
C             wherever the half tangents begin; 2: it is almost so, A has
C             an entry above 1D4.
C
C     METHOD
C     Of eight places to begin the one with the smallest matrix.
C
      IMPLICIT NONE
      DOUBLE PRECISION   H(6,9,3), SHIFT, A(24,24), S2(12,12), X(12,24)
      DOUBLE PRECISION   BIG, LEAST, TH, C, S
      INTEGER            IW(12), INFO, I, J, K, BAD
      EXTERNAL           GSIKM, GSLEQ
C
      LEAST = -1.0D0
      INFO = 1
      DO 60 K = 1, 8
         TH = 0.37D0 + 0.785398D0*K
         C = COS( TH )
         S = SIN( TH )
         CALL GSIKM( H, -C, -S, 1.0D0, S2 )
         CALL GSIKM( H, C, S, 1.0D0, X )
         CALL GSIKM( H, -2.0D0*S, 2.0D0*C, 0.0D0, X(1,13) )
         CALL GSLEQ( 12, 24, S2, 12, X, 12, IW, BAD )
         IF ( BAD.EQ.0 ) THEN
            BIG = 0.0D0
            DO 20 J = 1, 24
               DO 10 I = 1, 12
                  BIG = MAX( BIG, ABS( X(I,J) ) )
   10          CONTINUE
   20       CONTINUE
            IF ( BIG.LE.1.0D200 .AND.
     $           ( LEAST.LT.0.0D0 .OR. BIG.LT.LEAST ) ) THEN
               LEAST = BIG
               SHIFT = TH
               INFO = 0
               DO 40 J = 1, 24
                  DO 30 I = 1, 12
                     A(I,J) = 0.0D0
                     A(12+I,J) = -X(I,J)
   30             CONTINUE
   40          CONTINUE
               DO 50 I = 1, 12
                  A(I,12+I) = 1.0D0
   50          CONTINUE
            END IF
         END IF
   60 CONTINUE
      IF ( LEAST.GT.1.0D4 ) INFO = 2
      END
C
      SUBROUTINE GSIKM( H, A, B, C, S )
C
C     PURPOSE
C     For GSIKG: twelve equations from the six, those times x4 too.
C
C     ARGUMENTS
C     H       (input) from GSIKE.
C     A, B, C (input) DOUBLE PRECISION: the six are A times those of cos,
C             B of sin, C of 1.
C     S       (output) DOUBLE PRECISION array, dimension (12,12): columns
C             x4**i * x5**j, i = 0 to 3, j = 0 to 2 first.
C
C     METHOD
C     Copies.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   H(6,9,3), A, B, C, S(12,12)
      INTEGER            I, J
C
      DO 30 I = 1, 6
         DO 10 J = 1, 12
            S(I,J) = 0.0D0
            S(6+I,J) = 0.0D0
   10    CONTINUE
         DO 20 J = 1, 9
            S(I,J) = A*H(I,J,1) + B*H(I,J,2) + C*H(I,J,3)
            S(6+I,3+J) = S(I,J)
   20    CONTINUE
   30 CONTINUE
      END
C
      SUBROUTINE GSIKV( KA, PA, R, F, G, H, Q, W )
C
C     PURPOSE
C     For GSIKG: the other angles of a candidate.
C
C     ARGUMENTS
C     KA, PA, R, F, G, H (input) as there.
C     Q       (input/output) DOUBLE PRECISION array, dimension (6): angle
C             3, on exit all.
C     W       (workspace) DOUBLE PRECISION array, dimension (500).
C
C     METHOD
C     Angles 4 and 5 from the vector that the twelve equations take to
C     nothing, 1 and 2 by least squares, 6 from the rotation.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), F(14,3,3,3), G(14,9)
      DOUBLE PRECISION   H(6,9,3), Q(6), W(*), S(14), B(14), X(3), E(3)
      DOUBLE PRECISION   M(3), Y(8), U(3)
      INTEGER            I, J, K, L, RANK
      EXTERNAL           GSIKM, GSSVD, GSIKX, GSIKT
C
      CALL GSIKM( H, COS( Q(3) ), SIN( Q(3) ), 1.0D0, W )
      CALL GSSVD( 12, 12, W, 12, W(145), 12, S, 1.0D-14, RANK )
      CALL GSIKX( W(145+132), Q(4), Q(5) )
C     -- right side of the equations for angles 1 and 2
      M(3) = 1.0D0
      DO 40 L = 1, 14
         B(L) = -G(L,9)
         DO 30 I = 1, 3
            DO 20 J = 1, 3
               DO 10 K = 1, 3
                  M(1) = F(L,K,J,I)
                  IF ( K.EQ.1 ) M(1) = M(1)*COS( Q(5) )
                  IF ( K.EQ.2 ) M(1) = M(1)*SIN( Q(5) )
                  IF ( J.EQ.1 ) M(1) = M(1)*COS( Q(4) )
                  IF ( J.EQ.2 ) M(1) = M(1)*SIN( Q(4) )
                  IF ( I.EQ.1 ) M(1) = M(1)*COS( Q(3) )
                  IF ( I.EQ.2 ) M(1) = M(1)*SIN( Q(3) )
                  B(L) = B(L) + M(1)
   10          CONTINUE
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      DO 60 J = 1, 8
         DO 50 L = 1, 14
            W(14*(J-1)+L) = G(L,J)
   50    CONTINUE
         Y(J) = 0.0D0
   60 CONTINUE
      CALL GSSVD( 14, 8, W, 14, W(113), 8, S, 1.0D-12, RANK )
      DO 90 K = 1, RANK
         M(1) = 0.0D0
         DO 70 L = 1, 14
            M(1) = M(1) + W(14*(K-1)+L)*B(L)
   70    CONTINUE
         M(1) = M(1)/S(K)**2
         DO 80 J = 1, 8
            Y(J) = Y(J) + M(1)*W(112+8*(K-1)+J)
   80    CONTINUE
   90 CONTINUE
      Q(1) = ATAN2( Y(6), Y(3) )
      Q(2) = ATAN2( Y(8), Y(7) )
C     -- angle 6: a direction across its axis, U, becomes E
      K = 1
      IF ( ABS( KA(2,6) ).LT.ABS( KA(K,6) ) ) K = 2
      IF ( ABS( KA(3,6) ).LT.ABS( KA(K,6) ) ) K = 3
      DO 100 I = 1, 3
         U(I) = -KA(K,6)*KA(I,6)
         IF ( I.EQ.K ) U(I) = U(I) + 1.0D0
  100 CONTINUE
      DO 110 I = 1, 3
         E(I) = R(I,1)*U(1) + R(I,2)*U(2) + R(I,3)*U(3)
         X(I) = 0.0D0
  110 CONTINUE
      DO 120 I = 1, 5
         CALL GSIKT( KA(1,I), PA(1,I), -SIN( Q(I) ), COS( Q(I) ), X, E )
  120 CONTINUE
      Q(6) = ATAN2( KA(1,6)*( U(2)*E(3) - U(3)*E(2) )
     $              + KA(2,6)*( U(3)*E(1) - U(1)*E(3) )
     $              + KA(3,6)*( U(1)*E(2) - U(2)*E(1) ),
     $              U(1)*E(1) + U(2)*E(2) + U(3)*E(3) )
      END
C
      SUBROUTINE GSIKX( V, Q4, Q5 )
C
C     PURPOSE
C     For GSIKV: angles 4 and 5 from the products of their half tangents.
C
C     ARGUMENTS
C     V       (input) DOUBLE PRECISION array, dimension (3,4): x5**j *
C             x4**i, j = 0 to 2, i = 0 to 3, times any number.
C     Q4, Q5  (output) DOUBLE PRECISION [rad].
C
C     METHOD
C     The ratio of the two largest that differ by one half tangent.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   V(3,4), Q4, Q5, BIG, D
      INTEGER            I, J
C
      BIG = -1.0D0
      DO 20 I = 1, 3
         DO 10 J = 1, 3
            D = V(J,I)**2 + V(J,I+1)**2
            IF ( D.GT.BIG ) THEN
               BIG = D
               Q4 = 2.0D0*ATAN2( V(J,I+1), V(J,I) )
            END IF
   10    CONTINUE
   20 CONTINUE
      BIG = -1.0D0
      DO 40 I = 1, 4
         DO 30 J = 1, 2
            D = V(J,I)**2 + V(J+1,I)**2
            IF ( D.GT.BIG ) THEN
               BIG = D
               Q5 = 2.0D0*ATAN2( V(J+1,I), V(J,I) )
            END IF
   30    CONTINUE
   40 CONTINUE
      END
C
      SUBROUTINE GSIKN( N, KIND, KA, PA, R, P, Q, W, IW, GOOD )
C
C     PURPOSE
C     For GSIKG and GSIKZ: a candidate refined.
C
C     ARGUMENTS
C     N       (input) INTEGER, joints, 1 to 6.
C     KIND    (input) INTEGER array, dimension (6): 1 where a joint turns,
C             0 where it slides. Joints behind the N-th slide along 0.
C     KA, PA, R, P (input) as GSIKG.
C     Q       (input/output) DOUBLE PRECISION array, dimension (6) [rad,
C             m]; behind the N-th 0.
C     W       (workspace) DOUBLE PRECISION array, dimension (42).
C     IW      (workspace) INTEGER array, dimension (6).
C     GOOD    (output) LOGICAL, whether the pose is missed by less than
C             1D-11.
C
C     METHOD
C     Newton's method on the exact Jacobian, at most 40 steps, or 44
C     where the last ones are close, none longer than 0.3 rad; of fewer
C     than six joints that of Gauss and Newton. The end is where a step
C     makes it no better, but not a long one between two solutions: they
C     are found behind that. Where rounding is left at
C     a Jacobian that has almost lost rank, two steps in all directions
C     but that one (GSIK3).
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), W(6,7)
      DOUBLE PRECISION   MISS, LAST, BEST(6), BIG, PART, Z(6), U(6)
      INTEGER            N, KIND(6), IW(6), I, IT, INFO
      LOGICAL            GOOD
      EXTERNAL           GSIKI, GSIKJ, GSIK3
C
      LAST = -1.0D0
      BIG = 0.0D0
      DO 40 IT = 1, 44
         CALL GSIKJ( KIND, KA, PA, R, P, Q, W, W(1,7), MISS )
         IF ( .NOT.( MISS.LE.1.0D10 ) ) GO TO 50
         IF ( LAST.LT.0.0D0 .OR. MISS.LT.LAST ) THEN
            LAST = MISS
            DO 10 I = 1, 6
               BEST(I) = Q(I)
   10       CONTINUE
            IF ( MISS.LE.2.0D-16 ) GO TO 50
         ELSE IF ( LAST.LE.2.0D-15 .OR.
     $             LAST.LE.1.0D-12 .AND. BIG.LE.1.0D-9 ) THEN
            GO TO 50
         END IF
         IF ( IT.GE.40 .AND. LAST.GT.1.0D-6 ) GO TO 50
         CALL GSIKI( N, W, IW, INFO )
         IF ( INFO.NE.0 ) GO TO 50
         BIG = 0.0D0
         DO 20 I = 1, 6
            BIG = MAX( BIG, ABS( W(I,7) ) )
   20    CONTINUE
         PART = MIN( 1.0D0, 0.3D0/MAX( BIG, 1.0D-300 ) )
         DO 30 I = 1, 6
            Q(I) = Q(I) + PART*W(I,7)
   30    CONTINUE
   40 CONTINUE
   50 CONTINUE
      IF ( N.EQ.6 .AND. LAST.GT.2.0D-15 .AND. LAST.LE.1.0D-9 ) THEN
         DO 55 I = 1, 6
            Q(I) = BEST(I)
            Z(I) = 0.0D0
            U(I) = 0.0D0
   55    CONTINUE
         CALL GSIK3( 2, KIND, KA, PA, R, P, Q, Z, U, BIG, PART )
         CALL GSIKJ( KIND, KA, PA, R, P, Q, W, W(1,7), MISS )
         DO 58 I = 1, 6
            IF ( MISS.LT.LAST ) BEST(I) = Q(I)
   58    CONTINUE
         LAST = MIN( LAST, MISS )
      END IF
      GOOD = LAST.GE.0.0D0 .AND. LAST.LE.1.0D-11
      IF ( .NOT.GOOD ) RETURN
CGCC$ NOVECTOR
      DO 60 I = 1, 6
         Q(I) = BEST(I)
         IF ( KIND(I).EQ.1 ) Q(I) = ATAN2( SIN( Q(I) ), COS( Q(I) ) )
   60 CONTINUE
      END
C
      SUBROUTINE GSIKI( N, W, IW, INFO )
C
C     PURPOSE
C     For GSIKN: the step.
C
C     ARGUMENTS
C     N       (input) INTEGER, joints, 1 to 6.
C     W       (input/output) DOUBLE PRECISION array, dimension (6,7): the
C             Jacobian, and what is missed; the step in its place.
C     IW      (workspace) INTEGER array, dimension (6).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Linear equations; of fewer than six joints the normal equations of
C     least squares.
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = k   the Jacobian has lost rank, as GSLEQ or GSSPD.
C
      IMPLICIT NONE
      INTEGER            N, IW(6), INFO, I, K, L
      DOUBLE PRECISION   W(6,7), A(6,6), S(6)
      EXTERNAL           GSLEQ, GSSPD
C
      IF ( N.EQ.6 ) THEN
         CALL GSLEQ( 6, 1, W, 6, W(1,7), 6, IW, INFO )
         RETURN
      END IF
      DO 30 I = 1, N
         S(I) = 0.0D0
         DO 20 K = 1, N
            A(K,I) = 0.0D0
            DO 10 L = 1, 6
               A(K,I) = A(K,I) + W(L,K)*W(L,I)
   10       CONTINUE
   20    CONTINUE
         DO 25 L = 1, 6
            S(I) = S(I) + W(L,I)*W(L,7)
   25    CONTINUE
   30 CONTINUE
      CALL GSSPD( N, 1, A, 6, S, 6, INFO )
      DO 40 I = 1, 6
         W(I,7) = 0.0D0
         IF ( I.LE.N ) W(I,7) = S(I)
   40 CONTINUE
      END
C
      SUBROUTINE GSIKJ( KIND, KA, PA, R, P, Q, RJ, E, MISS )
C
C     PURPOSE
C     For GSIKN: Jacobian, and what a position misses.
C
C     ARGUMENTS
C     KIND, KA, PA, R, P, Q (input) as GSIKN.
C     RJ      (output) DOUBLE PRECISION array, dimension (6,6): velocity
C             of the point that stood at the origin, angular velocity.
C     E       (output) DOUBLE PRECISION array, dimension (6): its place
C             and rotation vector, wanted less there.
C     MISS    (output) DOUBLE PRECISION, the largest of E.
C
C     METHOD
C     Axes and points moved from the first joint on. Where KIND(4) is 2
C     the place alone is asked for: joints 4 to 6 are none, with unit rows
C     in the place of those of the rotation.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   KA(3,6), PA(3,6), R(3,3), P(3), Q(6), RJ(6,6)
      DOUBLE PRECISION   E(6), MISS, X(3), A(3,3), K(3), O(3), S, C
      INTEGER            KIND(6), I, J, L
      EXTERNAL           GSIKT, GSNIV
C
      DO 20 J = 1, 3
         X(J) = 0.0D0
         DO 10 I = 1, 3
            A(I,J) = 0.0D0
   10    CONTINUE
         A(J,J) = 1.0D0
   20 CONTINUE
C     -- A, X: rotation of the joints so far, and where the origin comes
      DO 60 J = 1, 6
         DO 30 I = 1, 3
            K(I) = A(I,1)*KA(1,J) + A(I,2)*KA(2,J) + A(I,3)*KA(3,J)
            O(I) = A(I,1)*PA(1,J) + A(I,2)*PA(2,J) + A(I,3)*PA(3,J)
     $             + X(I)
   30    CONTINUE
         IF ( KIND(J).NE.1 ) THEN
            DO 35 I = 1, 3
               X(I) = X(I) + Q(J)*K(I)
   35       CONTINUE
         ELSE
            S = SIN( Q(J) )
            C = COS( Q(J) )
            DO 40 L = 1, 3
               E(L) = 0.0D0
   40       CONTINUE
            CALL GSIKT( K, O, S, C, X, A(1,1) )
            CALL GSIKT( K, O, S, C, E, A(1,2) )
            CALL GSIKT( K, O, S, C, E, A(1,3) )
         END IF
         DO 50 I = 1, 3
            RJ(I,J) = O(I)
            RJ(3+I,J) = K(I)
   50    CONTINUE
   60 CONTINUE
      DO 80 J = 1, 6
         DO 70 I = 1, 3
            O(I) = X(I) - RJ(I,J)
            K(I) = RJ(3+I,J)
   70    CONTINUE
         IF ( KIND(J).NE.1 ) THEN
            DO 75 I = 1, 3
               RJ(I,J) = K(I)
               RJ(3+I,J) = 0.0D0
   75       CONTINUE
         ELSE
            RJ(1,J) = K(2)*O(3) - K(3)*O(2)
            RJ(2,J) = K(3)*O(1) - K(1)*O(3)
            RJ(3,J) = K(1)*O(2) - K(2)*O(1)
         END IF
   80 CONTINUE
      IF ( KIND(4).EQ.2 ) THEN
         DO 86 J = 1, 3
            DO 84 I = 4, 6
               RJ(I,J) = 0.0D0
   84       CONTINUE
            RJ(3+J,3+J) = 1.0D0
            E(3+J) = -Q(3+J)
   86    CONTINUE
      ELSE
         CALL GSNIV( R, A, E(4) )
      END IF
      MISS = 0.0D0
      DO 90 I = 1, 3
         E(I) = P(I) - X(I)
         MISS = MAX( MISS, ABS( E(I) ), ABS( E(3+I) ) )
   90 CONTINUE
      END
C
      SUBROUTINE GSIKA( Q, QC, NS )
C
C     PURPOSE
C     For GSIKG: a solution put among the others, which rise.
C
C     ARGUMENTS
C     Q       (input) DOUBLE PRECISION array, dimension (6) [rad].
C     QC, NS  (input/output) as GSIKG.
C
C     METHOD
C     One that is there to 1D-8 is not put there again.
C
C     ERROR INDICATOR
C     None; a seventeenth is left out.
C
      IMPLICIT NONE
      DOUBLE PRECISION   Q(6), QC(6,16), D
      INTEGER            NS, I, J, K
C
      DO 20 J = 1, NS
         D = 0.0D0
CGCC$ NOVECTOR
         DO 10 I = 1, 6
            D = MAX( D, ABS( SIN( 0.5D0*( Q(I) - QC(I,J) ) ) ) )
   10    CONTINUE
         IF ( D.LE.5.0D-9 ) RETURN
   20 CONTINUE
      IF ( NS.GE.16 ) RETURN
      K = NS
   30 CONTINUE
      IF ( K.GE.1 ) THEN
         IF ( QC(1,K).GT.Q(1) ) THEN
            DO 40 I = 1, 6
               QC(I,K+1) = QC(I,K)
   40       CONTINUE
            K = K - 1
            GO TO 30
         END IF
      END IF
      DO 50 I = 1, 6
         QC(I,K+1) = Q(I)
   50 CONTINUE
      NS = NS + 1
      END
