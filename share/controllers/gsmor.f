      SUBROUTINE GSMOR(
     $   CLO, MAS, N, NA, NO, IA, T, CST, QJ, WJ, M, TR,
     $   MR, INFO )
C
C     PURPOSE
C     Mass matrix of a scene in its independent speeds: M projected on the
C     motions that the loops leave free.
C
C     ARGUMENTS
C     CLO     (external) CLO( T, QJ, CST, INFO ), the scene's closure; of
C             a tree it has nothing to do.
C     MAS     (external) the scene's MAS: drives' rotors are in it.
C     N, NA   (input) INTEGER, coordinates, independent ones [1].
C     NO      (input) INTEGER, derivatives that QJ has room for [1].
C     IA      (input) INTEGER array (NA), which ones are independent.
C     T       (input) time [s].
C     CST     (input) array, parameters and constants, from PRE [SI].
C     QJ      (input) array (N,0:NO), coordinates, of GSMOT [SI].
C     WJ      (work) array (N,0:NO).
C     M       (output) array (N,N), mass matrix of the tree [SI].
C     TR      (output) array (N,NA), speeds of all by the independent ones,
C             but for what moves by itself [SI].
C     MR      (output) array (NA,NA), TR'*M*TR [SI].
C     INFO    (output) INTEGER, 0, or not: a singular position.
C
C     METHOD
C     TR by CLO with unit speeds, less the speeds that are there when the
C     independent ones rest.
C
      IMPLICIT NONE
      INTEGER            N, NA, NO, IA(NA), INFO, I, J, K, L
      DOUBLE PRECISION   T, CST(*), QJ(N,0:NO), WJ(N,0:NO), M(N,N),
     $                   TR(N,NA), MR(NA,NA)
      EXTERNAL           CLO, MAS
C
      DO 60 K = 0, NA
         DO 20 I = 1, N
            WJ(I,0) = QJ(I,0)
            DO 10 J = 1, NO
               WJ(I,J) = 0.0D0
   10       CONTINUE
   20    CONTINUE
         J = MAX( K, 1 )
         IF ( K.GT.0 ) WJ(IA(J),1) = 1.0D0
         CALL CLO( T, WJ, CST, INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 50 I = 1, N
            IF ( K.EQ.0 ) M(I,1) = WJ(I,1)
            TR(I,J) = WJ(I,1) - M(I,1)
   50    CONTINUE
   60 CONTINUE
      CALL MAS( T, QJ, CST, M, N )
      DO 100 J = 1, NA
         DO 80 I = 1, N
            WJ(I,0) = 0.0D0
            DO 70 L = 1, N
               WJ(I,0) = WJ(I,0) + M(I,L)*TR(L,J)
   70       CONTINUE
   80    CONTINUE
         DO 95 I = 1, NA
            MR(I,J) = 0.0D0
            DO 90 L = 1, N
               MR(I,J) = MR(I,J) + TR(L,I)*WJ(L,0)
   90       CONTINUE
   95    CONTINUE
  100 CONTINUE
      END
