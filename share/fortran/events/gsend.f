      SUBROUTINE GSEND( CMD, CLO, VIN, EVT, RST, T, X, NU, NX, NV, IP,
     $                  RP, CST, V, W, ISTAT, INFO )
C
C     PURPOSE
C     The end of a run: an event of the user that lies there.
C
C     ARGUMENTS
C     As GSEVR; V (input/output) the inputs at T from the left.
C
C     METHOD
C     Steps end at a stop as it is just before (GSLFT); what the event
C     functions are at T itself counts here: an event belongs to the run
C     if its function is not above 0 there, else to one that goes on
C     from there.  So does one that a jump of the inputs at T brings
C     about, as within a run (GSSTO, K = -1).  No other event happens:
C     ports find their modes where a run begins.  Behind an event V is
C     from the right.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT, RST
      INTEGER            NU, NX, NV, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      INTEGER            K, SIDE, IER
      EXTERNAL           GSENF, GSEVK, GSINP
C
      INFO = 0
      IF ( IP(28).LE.0 ) RETURN
      CALL GSENF( EVT, T, X, NX, V, CST, IP(IP(28)), RP(IP(29)), K )
      IF ( K.LT.0 ) RETURN
      SIDE = -1
      IF ( K.GT.0 ) THEN
         SIDE = 1
         CALL GSEVK( EVT, RST, T, X, NX, IP, RP, CST, V, ISTAT, K,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
C
C     -- from the right; nothing where the run has ended already
      K = 0
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            IER )
      IF ( IER.EQ.0 .AND. IP(IP(28)+8).EQ.0 )
     $   CALL GSENF( EVT, T, X, NX, V, CST, IP(IP(28)), RP(IP(29)), K )
      IF ( K.GT.0 ) THEN
         SIDE = 1
         CALL GSEVK( EVT, RST, T, X, NX, IP, RP, CST, V, ISTAT, -1,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
      CALL GSINP( CMD, CLO, VIN, T, SIDE, X, NU, NX, NV, IP, RP, CST, V,
     $            W, INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 0
      IF ( INFO.NE.0 ) ISTAT(7) = 1
      END
      SUBROUTINE GSENF( EVT, T, X, NX, V, CST, IE, RE, K )
C
C     PURPOSE
C     For GSEND: the first event function of the user that has been
C     above 0 since its last event and is not at T; K = 0: none; -1:
C     none has been above 0.
C
C     ARGUMENTS
C     As GSRES.
C
      IMPLICIT NONE
      EXTERNAL           EVT
      INTEGER            NX, IE(*), K
      DOUBLE PRECISION   T, X(NX), V(*), CST(*), RE(*)
      INTEGER            NE, I
      EXTERNAL           GSUSG
C
      NE = IE(1)
      CALL EVT( T, X, V, IE(11), CST, RE(NE+1) )
      CALL GSUSG( NX, IE, RE )
      K = -1
      DO 10 I = NE, 1, -1
         IF ( IE(10+2*NE+I).GT.2 .AND. IE(10+3*NE+I).EQ.1 ) THEN
            K = MAX( K, 0 )
            IF ( RE(NE+I).LE.0.0D0 ) K = I
         END IF
   10 CONTINUE
      END
