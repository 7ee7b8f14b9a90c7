      SUBROUTINE GSMOT(
     $   CLO, N, NA, NO, IA, T, Q, U, A, QG, CST, QJ,
     $   INFO )
C
C     PURPOSE
C     Motion of all coordinates of a scene from that of the independent
C     ones: the others follow through the loops.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives that QJ has room for, > 1 [1].
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     Q, U, A (input) arrays (NA), independent coordinates, their rates
C             and accelerations [SI].
C     QG      (in/out) array (N), coordinates near by, as they were at the
C             sample before; then the coordinates [SI].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     QJ      (output) array (N,0:NO), coordinates and derivatives; those
C             above 2 are zero [SI].
C     INFO    (output) INTEGER, 0, or not: the loops do not close here; QG
C             is then as it was.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, IA(NA), INFO, I, J
      DOUBLE PRECISION   T, Q(NA), U(NA), A(NA), QG(N), CST(*),
     $                   QJ(N,0:NO)
      EXTERNAL           CLO
C
      DO 20 I = 1, N
         QJ(I,0) = QG(I)
         DO 10 J = 1, NO
            QJ(I,J) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      DO 30 I = 1, NA
         QJ(IA(I),0) = Q(I)
         QJ(IA(I),1) = U(I)
         QJ(IA(I),2) = A(I)
   30 CONTINUE
      CALL CLO( T, QJ, CST, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 40 I = 1, N
         QG(I) = QJ(I,0)
   40 CONTINUE
      END
