      SUBROUTINE GSFFW(
     $   INV, N, T, Q, U, QR, UR, AR, KP, KD, KI, Z, V, CST, A, TAU )
C
C     PURPOSE
C     Feedforward: the efforts of the motion that is wanted, by the
C     inverse dynamics INV of a tree, and a PID controller of each
C     coordinate.
C
C     ARGUMENTS
C     INV     (external) the scene's INV.
C     N       (input) INTEGER, coordinates [1].
C     T       (input) time [s].
C     Q, U    (input) arrays (N), coordinates and their rates [SI].
C     QR, UR, AR (input) arrays (N), what they are to be, with
C             accelerations [SI].
C     KP, KD, KI (input) arrays (N), gains: effort for an error, its rate,
C             its integral [SI].
C     Z       (input) array (N), integrals of the errors [SI].
C     V       (input) array, inputs of the scene: zero, forces from outside
C             are not measured [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (N), accelerations that are asked for [SI].
C     TAU     (output) array (N), efforts [SI].
C
C     METHOD
C     INV along the wanted motion, not along the measured one.
C
      IMPLICIT NONE
      INTEGER            N, I
      DOUBLE PRECISION   T, Q(N), U(N), QR(N), UR(N), AR(N), KP(N),
     $                   KD(N), KI(N), Z(N), V(*), CST(*), A(N), TAU(N)
      EXTERNAL           INV
C
      DO 10 I = 1, N
         A(I) = AR(I)
   10 CONTINUE
      CALL INV( T, QR, UR, A, V, CST, TAU )
      DO 20 I = 1, N
         TAU(I) = TAU(I) + KP(I)*( QR(I) - Q(I) )
     $            + KD(I)*( UR(I) - U(I) ) + KI(I)*Z(I)
   20 CONTINUE
      END
