      SUBROUTINE GSCIM(
     $   CLO, CMD, MAS, PNT, JPT, N, NA, NO, NP, IP, ITOOL, IA, T, Q, U,
     $   PR, PDR, K, D, DQ, QG, CST, A, QJ, WJ, M, TR, MR, P, R, JP,
     $   DJU, V, IW, INFO )
C
C     PURPOSE
C     Cartesian impedance through loops and drives: a tool answers forces
C     from outside as if springs K and dampers D tied its place and axes to
C     the wanted ones; the machine's inertia (rotors with it) stays, weight,
C     inertia forces and what the drives lose are balanced.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     CMD     (external) CMD( T, QJ, CST, V, INFO ), the scene's command:
C             CMD, or CMQ where the drives have states.
C     MAS, PNT, JPT (external) the scene's MAS, PNT and JPT.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives that QJ has room for, > 1 [1].
C     NP, IP  (input) INTEGER, points and frames, which one is the tool.
C     ITOOL   (input) INTEGER, 0: K and D by the axes of ground, 1: by
C             those of the tool as it stands.
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     Q, U    (input) arrays (NA), coordinates and their rates [SI].
C     PR, PDR (input) arrays (6), place of the tool that is wanted and the
C             rotation vector of its axes, from ground; their rates [SI].
C     K, D    (input) arrays (6,6), force and moment for a shift and turn
C             (rotation vector), for a velocity and rate of turn [SI].
C     DQ      (input) array (NA), damping of the coordinates [SI].
C     QG      (in/out) array (N), all coordinates at the sample before,
C             then now [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (NA), accelerations that are asked for [SI].
C     QJ, WJ  (output, work) arrays (N,0:NO), motion that is asked for
C             [SI].
C     M, TR, MR (output) arrays (N,N), (N,NA), (NA,NA), of GSMOR [SI].
C     P, R, JP, DJU (output) arrays (3,NP), (3,3*NP), (6,N*NP), (6,NP), of
C             PNT and JPT [SI].
C     V       (output) array, inputs of the scene [SI].
C     IW      (work) INTEGER array (NA).
C     INFO    (output) INTEGER, 0, or not: the loops do not close here, or
C             the drives cannot give this motion.
C
C     METHOD
C     W = K*e + D*e' of the tool, TR'*JP'*W on the independent speeds, as
C     accelerations by the mass matrix MR; then one call of CMD at what is
C     measured.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, NP, IP, ITOOL, IA(NA), IW(NA), INFO,
     $                   I, J, L
      DOUBLE PRECISION   T, Q(NA), U(NA), PR(6), PDR(6), K(6,6), D(6,6),
     $                   DQ(NA), QG(N), CST(*), A(NA), QJ(N,0:NO),
     $                   WJ(N,0:NO), M(N,N), TR(N,NA), MR(NA,NA),
     $                   P(3,NP), R(3,3*NP), JP(6,N*NP), DJU(6,NP),
     $                   V(*), E(6), ED(6), W(6), F, RW(3,3), RE(3,3)
      EXTERNAL           CLO, CMD, MAS, PNT, JPT, GSLEQ
C
      DO 10 I = 1, NA
         A(I) = 0.0D0
   10 CONTINUE
      CALL GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, A, QG, CST, QJ, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSMOR(
     $   CLO, MAS, N, NA, NO, IA, T, CST, QJ, WJ, M, TR, MR,
     $   INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL PNT( T, QJ, CST, P, R )
      CALL JPT( T, QJ, QJ(1,1), CST, JP, DJU )
C     what is wanted less what is there, in axes of ground
      CALL GSTRN(
     $   PR(4), PDR(4), RW, ED(4) )
      DO 30 I = 1, 3
         E(I) = PR(I) - P(I,IP)
         ED(I) = PDR(I)
         DO 20 J = 1, 3
            RE(I,J) = RW(I,1)*R(J,3*IP-2) + RW(I,2)*R(J,3*IP-1)
     $                + RW(I,3)*R(J,3*IP)
   20    CONTINUE
   30 CONTINUE
      CALL GSTRV(
     $   RE, E(4) )
      DO 50 I = 1, 6
         DO 40 L = 1, N
            ED(I) = ED(I) - JP(I,N*(IP-1)+L)*QJ(L,1)
   40    CONTINUE
   50 CONTINUE
      IF ( ITOOL.NE.0 ) THEN
         CALL GSTAX(
     $      -1, R(1,3*IP-2), E )
      END IF
      IF ( ITOOL.NE.0 ) THEN
         CALL GSTAX(
     $      -1, R(1,3*IP-2), ED )
      END IF
      DO 70 I = 1, 6
         W(I) = 0.0D0
         DO 60 J = 1, 6
            W(I) = W(I) + K(I,J)*E(J) + D(I,J)*ED(J)
   60    CONTINUE
   70 CONTINUE
      IF ( ITOOL.NE.0 ) THEN
         CALL GSTAX(
     $      1, R(1,3*IP-2), W )
      END IF
      DO 80 I = 1, NA
         A(I) = -DQ(I)*U(I)
   80 CONTINUE
      DO 110 L = 1, N
         F = 0.0D0
         DO 90 J = 1, 6
            F = F + JP(J,N*(IP-1)+L)*W(J)
   90    CONTINUE
         DO 100 I = 1, NA
            A(I) = A(I) + TR(L,I)*F
  100    CONTINUE
  110 CONTINUE
      CALL GSLEQ( NA, 1, MR, NA, A, NA, IW, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, A, QG, CST, QJ, INFO )
      IF ( INFO.EQ.0 ) CALL CMD( T, QJ, CST, V, INFO )
      END
      SUBROUTINE GSTRN( W, WD, R, OM )
C
C     PURPOSE
C     Axes R (3,3) turned by the rotation vector W [rad], and their rate of
C     turn OM [rad/s] when it changes at WD [rad/s].
C
      IMPLICIT NONE
      INTEGER            I
      DOUBLE PRECISION   W(3), WD(3), R(3,3), OM(3), X, S, C, B, WX(3),
     $                   WW(3)
C
      X = SQRT( W(1)**2 + W(2)**2 + W(3)**2 )
      IF ( X.GT.1.0D-2 ) THEN
         S = SIN( X )/X
         C = 2.0D0*( SIN( 0.5D0*X )/X )**2
         B = ( 1.0D0 - S )/X**2
      ELSE
         S = 1.0D0 - X**2/6.0D0*( 1.0D0 - X**2/20.0D0 )
         C = 0.5D0 - X**2/24.0D0*( 1.0D0 - X**2/30.0D0 )
         B = 1.0D0/6.0D0 - X**2/120.0D0*( 1.0D0 - X**2/42.0D0 )
      END IF
      DO 10 I = 1, 3
         R(I,1) = C*W(I)*W(1)
         R(I,2) = C*W(I)*W(2)
         R(I,3) = C*W(I)*W(3)
         R(I,I) = R(I,I) + 1.0D0 - C*X**2
   10 CONTINUE
      R(2,1) = R(2,1) + S*W(3)
      R(1,2) = R(1,2) - S*W(3)
      R(1,3) = R(1,3) + S*W(2)
      R(3,1) = R(3,1) - S*W(2)
      R(3,2) = R(3,2) + S*W(1)
      R(2,3) = R(2,3) - S*W(1)
      WX(1) = W(2)*WD(3) - W(3)*WD(2)
      WX(2) = W(3)*WD(1) - W(1)*WD(3)
      WX(3) = W(1)*WD(2) - W(2)*WD(1)
      WW(1) = W(2)*WX(3) - W(3)*WX(2)
      WW(2) = W(3)*WX(1) - W(1)*WX(3)
      WW(3) = W(1)*WX(2) - W(2)*WX(1)
      DO 20 I = 1, 3
         OM(I) = WD(I) + C*WX(I) + B*WW(I)
   20 CONTINUE
      END
      SUBROUTINE GSTRV( R, W )
C
C     PURPOSE
C     Rotation vector W (3), at most half a turn [rad], of the axes
C     R (3,3).
C
C     METHOD
C     Euler parameters from the largest of four (Shepperd).
C
      IMPLICIT NONE
      INTEGER            I, J, K
      DOUBLE PRECISION   R(3,3), W(3), S, B, F
C
      S = R(1,1) + R(2,2) + R(3,3)
      I = 1
      IF ( R(2,2).GT.R(I,I) ) I = 2
      IF ( R(3,3).GT.R(I,I) ) I = 3
      J = MOD( I, 3 ) + 1
      K = MOD( J, 3 ) + 1
      IF ( S.GE.R(I,I) ) THEN
         S = SQRT( MAX( 1.0D0 + S, 0.0D0 ) )
         W(1) = ( R(3,2) - R(2,3) )/S
         W(2) = ( R(1,3) - R(3,1) )/S
         W(3) = ( R(2,1) - R(1,2) )/S
      ELSE
         B = SQRT( MAX( 1.0D0 + R(I,I) - R(J,J) - R(K,K), 0.0D0 ) )
         S = ( R(K,J) - R(J,K) )/B
         W(I) = B
         W(J) = ( R(J,I) + R(I,J) )/B
         W(K) = ( R(K,I) + R(I,K) )/B
         IF ( S.LT.0.0D0 ) THEN
            S = -S
            W(1) = -W(1)
            W(2) = -W(2)
            W(3) = -W(3)
         END IF
      END IF
      B = SQRT( W(1)**2 + W(2)**2 + W(3)**2 )
      F = 1.0D0
      IF ( B.GT.1.0D-8 ) F = 2.0D0*ATAN2( B, S )/B
      DO 10 I = 1, 3
         W(I) = F*W(I)
   10 CONTINUE
      END
      SUBROUTINE GSTAX( IS, R, W )
C
C     PURPOSE
C     Two vectors W (6) from the axes R (3,3) into those of ground, or back
C     (IS < 0).
C
      IMPLICIT NONE
      INTEGER            IS, I, K
      DOUBLE PRECISION   R(3,3), W(6), A(3)
C
      DO 30 K = 0, 3, 3
         DO 10 I = 1, 3
            IF ( IS.LT.0 ) THEN
               A(I) = R(1,I)*W(K+1) + R(2,I)*W(K+2) + R(3,I)*W(K+3)
            ELSE
               A(I) = R(I,1)*W(K+1) + R(I,2)*W(K+2) + R(I,3)*W(K+3)
            END IF
   10    CONTINUE
         DO 20 I = 1, 3
            W(K+I) = A(I)
   20    CONTINUE
   30 CONTINUE
      END
