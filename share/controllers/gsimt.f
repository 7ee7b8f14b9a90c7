      SUBROUTINE GSIMT(
     $   INV, MAS, N, T, Q, U, QR, UR, AR, K, D, ZETA, V, CST, A, M,
     $   TAU )
C
C     PURPOSE
C     Impedance: a tree answers forces from outside as if springs K and
C     dampers tied its coordinates to the wanted motion; its own weight
C     and inertia forces are balanced by INV, its inertia stays.
C
C     ARGUMENTS
C     INV, MAS (external) the scene's INV and MAS.
C     N       (input) INTEGER, coordinates [1].
C     T       (input) time [s].
C     Q, U    (input) arrays (N), coordinates and their rates [SI].
C     QR, UR, AR (input) arrays (N), what they are to be, with
C             accelerations [SI].
C     K, D    (input) arrays (N), stiffness and damping [SI].
C     ZETA    (input) damping ratio: where it is not 0, the damping of a
C             coordinate is 2*ZETA*sqrt(K*M), M its entry of the mass
C             matrix where the tree is now, and D is not used [1].
C     V       (input) array, inputs of the scene: zero, forces from outside
C             are not measured [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (N), accelerations that are asked for [SI].
C     M       (output) array (N,N), mass matrix where ZETA is not 0 [SI].
C     TAU     (output) array (N), efforts [SI].
C
C     METHOD
C     INV at the measured state with the wanted accelerations.
C
      IMPLICIT NONE
      INTEGER            N, I
      DOUBLE PRECISION   T, Q(N), U(N), QR(N), UR(N), AR(N), K(N), D(N),
     $                   ZETA, V(*), CST(*), A(N), M(N,N), TAU(N), DI
      EXTERNAL           INV, MAS
C
      DO 10 I = 1, N
         A(I) = AR(I)
   10 CONTINUE
      CALL INV( T, Q, U, A, V, CST, TAU )
      IF ( ZETA.GT.0.0D0 ) CALL MAS( T, Q, CST, M, N )
      DO 20 I = 1, N
         DI = D(I)
         IF ( ZETA.GT.0.0D0 ) DI = 2.0D0*ZETA*SQRT( K(I)*M(I,I) )
         TAU(I) = TAU(I) + K(I)*( QR(I) - Q(I) ) + DI*( UR(I) - U(I) )
   20 CONTINUE
      END
