      SUBROUTINE GSNRM( NS, ISET, Q, ERR )
C
C     PURPOSE
C     Sets of four Euler parameters are divided by their norm.
C
C     ARGUMENTS
C     NS      (input) INTEGER, the number of sets.
C     ISET    (input) INTEGER array, dimension (4,NS): their places in Q.
C     Q       (input/output) DOUBLE PRECISION array, the coordinates.
C     ERR     (input/output) DOUBLE PRECISION, no less than the largest
C             error of a norm before.
C
      IMPLICIT NONE
      INTEGER            NS, ISET(4,*)
      DOUBLE PRECISION   Q(*), ERR
      DOUBLE PRECISION   S
      INTEGER            K
C
      DO 10 K = 1, NS
         S = SQRT( Q(ISET(1,K))**2 + Q(ISET(2,K))**2 + Q(ISET(3,K))**2
     $           + Q(ISET(4,K))**2 )
         ERR = MAX( ERR, ABS( S - 1.0D0 ) )
         Q(ISET(1,K)) = Q(ISET(1,K))/S
         Q(ISET(2,K)) = Q(ISET(2,K))/S
         Q(ISET(3,K)) = Q(ISET(3,K))/S
         Q(ISET(4,K)) = Q(ISET(4,K))/S
   10 CONTINUE
      END
      SUBROUTINE GSNRQ( Q, ERR )
C
C     PURPOSE
C     GSNRM for one set of neighbours, without the places.
C
C     ARGUMENTS
C     Q       (input/output) DOUBLE PRECISION array, dimension (4).
C     ERR     (input/output) as GSNRM.
C
      IMPLICIT NONE
      DOUBLE PRECISION   Q(4), ERR
      DOUBLE PRECISION   S
C
      S = SQRT( Q(1)**2 + Q(2)**2 + Q(3)**2 + Q(4)**2 )
      ERR = MAX( ERR, ABS( S - 1.0D0 ) )
      Q(1) = Q(1)/S
      Q(2) = Q(2)/S
      Q(3) = Q(3)/S
      Q(4) = Q(4)/S
      END
