      SUBROUTINE GSDRHS( RHS, INP, T, SIDE, X, NV, CST, V, XD, ISTAT,
     $                   INFO )
C
C     PURPOSE
C     The rates of the states of a scene under its inputs.
C
C     ARGUMENTS
C     RHS, INP, CST  as GSRUN8.
C     T       (input) DOUBLE PRECISION, the time [s].
C     SIDE    (input) INTEGER, < 0: the rates just before T (GSLFT),
C             where the inputs or the scene may switch at T.
C     X       (input) DOUBLE PRECISION array, dimension (NX), states.
C     NV      (input) INTEGER, the number of inputs.
C     V       (output) DOUBLE PRECISION array, dimension (NV), inputs.
C     XD      (output) DOUBLE PRECISION array, dimension (NX), rates.
C     ISTAT   (input/output) INTEGER array, dimension (6), as GSRUN8.
C     INFO    (output) INTEGER, 0, 7 or 10 as GSRUN8.
C
      IMPLICIT NONE
      EXTERNAL           RHS, INP
      INTEGER            SIDE, NV, ISTAT(6), INFO
      DOUBLE PRECISION   T, X(*), CST(*), V(*), XD(*)
      DOUBLE PRECISION   GSLFT, TL
      EXTERNAL           GSLFT
      INTEGER            LOST
C
      TL = GSLFT( T, SIDE )
      IF ( NV.GT.0 ) CALL INP( TL, X, V )
      CALL RHS( TL, X, V, CST, XD, INFO )
      ISTAT(3) = ISTAT(3) + 1
      ISTAT(4) = INFO
      IF ( INFO.EQ.3 ) THEN
         INFO = 0
      ELSE IF ( INFO.EQ.0 .OR. INFO.EQ.2 ) THEN
         LOST = INFO/2
         INFO = 0
         IF ( ISTAT(5).LT.0 ) ISTAT(5) = LOST
         IF ( ISTAT(5).NE.LOST ) INFO = 10
      ELSE
         INFO = 7
      END IF
      END
