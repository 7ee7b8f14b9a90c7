      SUBROUTINE GSDMOV( PRJ, SIZ, T, CST, JUMP, X, Z, ISTAT, INFO )
C
C     PURPOSE
C     A state after a step: are its numbers finite; it is moved onto the
C     constraints of its scene, but not farther than JUMP.
C
C     ARGUMENTS
C     PRJ, SIZ, CST  as GSRUN8.
C     T       (input) DOUBLE PRECISION, the time [s].
C     JUMP    (input) DOUBLE PRECISION array, dimension (2): how far a
C             coordinate and a speed may be moved; JUMP(1) <= 0: as far
C             as PRJ does.
C     X       (input/output) DOUBLE PRECISION array, dimension (NX).
C     Z       (workspace) DOUBLE PRECISION array, dimension (NX).
C     ISTAT   (input/output) INTEGER array, dimension (6), as GSRUN8.
C     INFO    (output) INTEGER, 0, 8 or 9 as GSRUN8.
C
      IMPLICIT NONE
      EXTERNAL           PRJ
      INTEGER            SIZ(12), ISTAT(6), INFO
      DOUBLE PRECISION   T, CST(*), JUMP(2), X(*), Z(*)
      INTEGER            GSFIN
      EXTERNAL           GSFIN
      DOUBLE PRECISION   RES
      INTEGER            I, K
C
      INFO = 9
      IF ( GSFIN( SIZ(3), X ).NE.0 ) RETURN
      INFO = 0
      IF ( SIZ(8).EQ.0 ) RETURN
      DO 10 I = 1, SIZ(3)
         Z(I) = X(I)
   10 CONTINUE
      CALL PRJ( T, X, CST, RES, INFO )
      ISTAT(4) = INFO
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.EQ.0 .AND. JUMP(1).GT.0.0D0 ) THEN
         DO 20 I = 1, SIZ(1) + SIZ(2)
            K = 1
            IF ( I.GT.SIZ(1) ) K = 2
            IF ( .NOT.( ABS( X(I) - Z(I) ).LE.JUMP(K) ) ) ISTAT(4) = 3
   20    CONTINUE
         IF ( ISTAT(4).EQ.3 ) INFO = 3
      END IF
      IF ( INFO.NE.0 ) INFO = 8
      END
