      SUBROUTINE GSFFD(
     $   CLO, CMD, N, NA, NO, IA, T, Q, U, RJ, KP, KD, KI, Z, ID, QG,
     $   CST, QJ, V, INFO )
C
C     PURPOSE
C     Feedforward through loops and drives: the inputs of the motion that
C     is wanted, and a PID controller of each coordinate on its drive.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     CMD     (external) CMD( T, QJ, CST, V, INFO ), the scene's command:
C             CMD, or CMQ where the drives are taken as quasi-static.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives in RJ and QJ, > 1 [1].
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     Q, U    (input) arrays (NA), coordinates and their rates [SI].
C     RJ      (input) array (NA,0:NO), what they are to be, with
C             derivatives [SI].
C     KP, KD, KI (input) arrays (NA), gains: input for an error, its rate,
C             its integral [SI].
C     Z       (input) array (NA), integrals of the errors [SI].
C     ID      (input) INTEGER array (NA), which input of the scene drives
C             each coordinate.
C     QG      (in/out) array (N), all coordinates wanted at the sample
C             before, then now [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     QJ      (output) array (N,0:NO), the motion that is wanted [SI].
C     V       (output) array, inputs of the scene [SI].
C     INFO    (output) INTEGER, 0, or not: the loops do not close on the
C             wanted motion, or the drives cannot give it.
C
C     METHOD
C     CMD along the wanted motion, not along the measured one.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, IA(NA), ID(NA), INFO, I, J
      DOUBLE PRECISION   T, Q(NA), U(NA), RJ(NA,0:NO), KP(NA), KD(NA),
     $                   KI(NA), Z(NA), QG(N), CST(*), QJ(N,0:NO), V(*)
      EXTERNAL           CLO, CMD
C
      DO 20 I = 1, N
         QJ(I,0) = QG(I)
         DO 10 J = 1, NO
            QJ(I,J) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      DO 40 I = 1, NA
         DO 30 J = 0, NO
            QJ(IA(I),J) = RJ(I,J)
   30    CONTINUE
   40 CONTINUE
      CALL CLO( T, QJ, CST, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 50 I = 1, N
         QG(I) = QJ(I,0)
   50 CONTINUE
      CALL CMD( T, QJ, CST, V, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 60 I = 1, NA
         V(ID(I)) = V(ID(I)) + KP(I)*( RJ(I,0) - Q(I) )
     $              + KD(I)*( RJ(I,1) - U(I) ) + KI(I)*Z(I)
   60 CONTINUE
      END
