      SUBROUTINE GSIMD(
     $   CLO, CMD, MAS, N, NA, NO, IA, T, Q, U, QR, UR, AR, K, D, ZETA,
     $   QG, CST, A, QJ, WJ, M, TR, MR, V, IW, INFO )
C
C     PURPOSE
C     Impedance through loops and drives: a machine answers forces from
C     outside as if springs K and dampers tied its independent coordinates
C     to the wanted motion; its inertia (rotors with it) stays, weight,
C     inertia forces and what the drives lose are balanced.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     CMD     (external) CMD( T, QJ, CST, V, INFO ), the scene's command:
C             CMD, or CMQ where the drives have states.
C     MAS     (external) the scene's MAS.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives that QJ has room for, > 1 [1].
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     Q, U    (input) arrays (NA), coordinates and their rates [SI].
C     QR, UR, AR (input) arrays (NA), what they are to be, with
C             accelerations [SI].
C     K, D    (input) arrays (NA), stiffness and damping [SI].
C     ZETA    (input) damping ratio: where it is not 0, the damping of a
C             coordinate is 2*ZETA*sqrt(K*M), M its entry of the mass
C             matrix of the independent speeds, and D is not used [1].
C     QG      (in/out) array (N), all coordinates at the sample before,
C             then now [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (NA), accelerations that are asked for [SI].
C     QJ, WJ  (output, work) arrays (N,0:NO), motion that is asked for
C             [SI].
C     M, TR, MR (output) arrays (N,N), (N,NA), (NA,NA), of GSMOR [SI].
C     V       (output) array, inputs of the scene [SI].
C     IW      (work) INTEGER array (NA).
C     INFO    (output) INTEGER, 0, or not: the loops do not close here, or
C             the drives cannot give this motion.
C
C     METHOD
C     The springs and dampers as accelerations by the mass matrix MR; then
C     one call of CMD at what is measured.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, IA(NA), IW(NA), INFO, I
      DOUBLE PRECISION   T, Q(NA), U(NA), QR(NA), UR(NA), AR(NA), K(NA),
     $                   D(NA), ZETA, QG(N), CST(*), A(NA), QJ(N,0:NO),
     $                   WJ(N,0:NO), M(N,N), TR(N,NA), MR(NA,NA), V(*),
     $                   DI
      EXTERNAL           CLO, CMD, MAS, GSLEQ
C
      CALL GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, AR, QG, CST, QJ, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSMOR(
     $   CLO, MAS, N, NA, NO, IA, T, CST, QJ, WJ, M, TR, MR,
     $   INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 10 I = 1, NA
         DI = D(I)
         IF ( ZETA.GT.0.0D0 ) DI = 2.0D0*ZETA*SQRT( K(I)*MR(I,I) )
         A(I) = K(I)*( QR(I) - Q(I) ) + DI*( UR(I) - U(I) )
   10 CONTINUE
      CALL GSLEQ( NA, 1, MR, NA, A, NA, IW, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NA
         A(I) = AR(I) + A(I)
   20 CONTINUE
      CALL GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, A, QG, CST, QJ, INFO )
      IF ( INFO.EQ.0 ) CALL CMD( T, QJ, CST, V, INFO )
      END
