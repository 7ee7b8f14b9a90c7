      SUBROUTINE GSCTD(
     $   CLO, CMD, N, NA, NO, IA, T, Q, U, QR, UR, AR, KP, KD, KI, Z,
     $   QG, CST, A, QJ, V, INFO )
C
C     PURPOSE
C     Computed torque through loops and drives: inputs of the drives with
C     which the error of every independent coordinate obeys
C     e'' + KD*e' + KP*e + KI*integral(e) = 0.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     CMD     (external) CMD( T, QJ, CST, V, INFO ), the scene's command:
C             CMD, or CMQ where the drives have states.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives that QJ has room for, > 1 [1].
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     Q, U    (input) arrays (NA), coordinates and their rates [SI].
C     QR, UR, AR (input) arrays (NA), what they are to be, with
C             accelerations [SI].
C     KP, KD, KI (input) arrays (NA), gains [1/s^2], [1/s], [1/s^3].
C     Z       (input) array (NA), integrals of the errors [SI].
C     QG      (in/out) array (N), all coordinates at the sample before,
C             then now [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     A       (output) array (NA), accelerations that are asked for [SI].
C     QJ      (output) array (N,0:NO), motion that is asked for [SI].
C     V       (output) array, inputs of the scene [SI].
C     INFO    (output) INTEGER, 0, or not: the loops do not close here, or
C             the drives cannot give this motion.
C
C     METHOD
C     Feedback linearization: the loops closed at what is measured, then
C     one call of CMD, which goes through gears, rotors and motors.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, IA(NA), INFO, I
      DOUBLE PRECISION   T, Q(NA), U(NA), QR(NA), UR(NA), AR(NA),
     $                   KP(NA), KD(NA), KI(NA), Z(NA), QG(N), CST(*),
     $                   A(NA), QJ(N,0:NO), V(*)
      EXTERNAL           CLO, CMD
C
      DO 10 I = 1, NA
         A(I) = AR(I) + KP(I)*( QR(I) - Q(I) ) + KD(I)*( UR(I) - U(I) )
     $          + KI(I)*Z(I)
   10 CONTINUE
      CALL GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, A, QG, CST, QJ, INFO )
      IF ( INFO.EQ.0 ) CALL CMD( T, QJ, CST, V, INFO )
      END
