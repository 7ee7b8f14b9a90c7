      SUBROUTINE GSCTQ(
     $   INV, N, T, Q, U, QR, UR, AR, KP, KD, KI, Z, V, CST, A, TAU )
C
C     PURPOSE
C     Computed torque: efforts by the inverse dynamics INV of a tree with
C     which the error of every coordinate obeys
C     e'' + KD*e' + KP*e + KI*integral(e) = 0.
C
C     ARGUMENTS
C     INV     (external) the scene's INV.
C     N       (input) INTEGER, coordinates [1].
C     T       (input) time [s].
C     Q, U    (input) arrays (N), coordinates and their rates [SI].
C     QR, UR, AR (input) arrays (N), what they are to be, with
C             accelerations [SI].
C     KP, KD, KI (input) arrays (N), gains [1/s^2], [1/s], [1/s^3].
C     Z       (input) array (N), integrals of the errors [SI].
C     V       (input) array, inputs of the scene: zero, forces from outside
C             are not measured [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (N), accelerations that are asked for [SI].
C     TAU     (output) array (N), efforts [SI].
C
C     METHOD
C     Feedback linearization by one call of INV.
C
      IMPLICIT NONE
      INTEGER            N, I
      DOUBLE PRECISION   T, Q(N), U(N), QR(N), UR(N), AR(N), KP(N),
     $                   KD(N), KI(N), Z(N), V(*), CST(*), A(N), TAU(N)
      EXTERNAL           INV
C
      DO 10 I = 1, N
         A(I) = AR(I) + KP(I)*( QR(I) - Q(I) ) + KD(I)*( UR(I) - U(I) )
     $          + KI(I)*Z(I)
   10 CONTINUE
      CALL INV( T, Q, U, A, V, CST, TAU )
      END
