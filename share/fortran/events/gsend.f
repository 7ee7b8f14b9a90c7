      SUBROUTINE GSEND( OUT, CTL, CMD, CLO, VIN, EVT, RST, T, X, NU, NX,
     $                  NV, IP, RP, CST, V, W, ISTAT, INFO )
C
C     PURPOSE
C     The end of a run: an event of the user that lies there.
C
C     ARGUMENTS
C     OUT, CTL (external) see GSSMP.
C     The others as GSEVR; V (output) the inputs at T from the left.
C
C     METHOD
C     Steps end at a stop as it is just before (GSLFT); what the event
C     functions are at T itself counts here: an event belongs to the run
C     if its function is not above 0 there, else to one that goes on
C     from there.  So does one that a jump of the inputs at T brings
C     about, as within a run (GSSTO, K = -1).  No other event happens:
C     ports find their modes where a run begins.  Behind an event V is
C     from the right.  What a sample at T takes back is no event, either
C     (GSENT).
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL, CMD, CLO, VIN, EVT, RST
      INTEGER            NU, NX, NV, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      INTEGER            K, SIDE, IER
      EXTERNAL           GSENF, GSENT, GSEVK, GSINP
C
      INFO = 0
      IF ( IP(28).LE.0 ) RETURN
      CALL GSENT( OUT, CTL, CMD, CLO, VIN, EVT, T, X, NU, NX, NV, IP,
     $            RP, CST, V, W, ISTAT )
      CALL GSINP( CMD, CLO, VIN, T, -1, X, NU, NX, NV, IP, RP, CST, V,
     $            W, INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 1
      IF ( INFO.NE.0 ) RETURN
      ISTAT(7) = 0
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
      SUBROUTINE GSENT( OUT, CTL, CMD, CLO, VIN, EVT, T, X, NU, NX, NV,
     $                  IP, RP, CST, V, W, ISTAT )
C
C     PURPOSE
C     Before what an event function of the user is at T counts, where a
C     sampled device acts at T, too: one that is not above 0, but is so
C     behind that, has no event: only what is behind all that happens at
C     an instant counts (GSSTO).
C
C     ARGUMENTS
C     As GSEND; V (workspace).
C
C     METHOD
C     The devices act on trial: their memory and outputs are kept, and
C     put back.  Functions that have no event count as not having been
C     above 0.
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL, CMD, CLO, VIN, EVT
      INTEGER            NU, NX, NV, IP(*), ISTAT(*)
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      DOUBLE PRECISION   TS, GSNXT, GSEPS
      INTEGER            IE, RE, IS, RS, NE, K, I, IER
      EXTERNAL           GSNXT, GSEPS, GSENF, GSINP, GSDUE, GSKEP
C
      IF ( IP(26).LE.0 .OR. IP(28).LE.0 ) RETURN
      IS = IP(26)
      RS = IP(27)
      IE = IP(28)
      RE = IP(29)
      NE = IP(IE)
      IF ( GSNXT( NV, IP(IS), RP(RS) ).GT.T + 8.0D0*GSEPS()*ABS( T ) )
     $   RETURN
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            IER )
      IF ( IER.NE.0 ) RETURN
      CALL GSENF( EVT, T, X, NX, V, CST, IP(IE), RP(RE), K )
      IF ( K.LE.0 ) RETURN
      DO 10 I = 1, NE
         IP(IE+9+4*NE+I) = 0
         IF ( IP(IE+9+3*NE+I).EQ.1 .AND. RP(RE+NE+I-1).LE.0.0D0 )
     $      IP(IE+9+4*NE+I) = 1
   10 CONTINUE
      CALL GSKEP( 0, NV, IP(IS), RP(RS) )
      IF ( IP(IE+5).EQ.1 ) IP(IE+7) = 1
      CALL GSDUE( OUT, CTL, CMD, CLO, VIN, T, X, NU, NX, NV, IP, RP,
     $            CST, V, W, ISTAT, TS, I, IER )
      IP(IE+7) = 0
      CALL GSKEP( 1, NV, IP(IS), RP(RS) )
      ISTAT(6) = 0
      ISTAT(7) = 0
      IF ( IER.NE.0 ) RETURN
      CALL GSENF( EVT, T, X, NX, V, CST, IP(IE), RP(RE), K )
      DO 20 I = 1, NE
         IF ( IP(IE+9+2*NE+I).GT.2 .AND. IP(IE+9+4*NE+I).EQ.1 .AND.
     $        RP(RE+NE+I-1).GT.0.0D0 ) IP(IE+9+3*NE+I) = 0
   20 CONTINUE
      END
      SUBROUTINE GSENB( CMD, CLO, VIN, EVT, T, X, NU, NX, NV, IP, RP,
     $                  CST, V, W )
C
C     PURPOSE
C     The other side of GSENT, where a run begins: an event function of
C     the user that a switch or a jump at T alone brings above 0, before
C     a sampled device acts at T, has not been above 0.
C
C     ARGUMENTS
C     As GSEND; V (output) the inputs at T from the right.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            NU, NX, NV, IP(*)
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      DOUBLE PRECISION   GSNXT, GSEPS, GSLFT
      INTEGER            IE, RE, NE, K, I, IER
      EXTERNAL           GSNXT, GSEPS, GSLFT, GSENF, GSINP
C
      IF ( IP(26).LE.0 .OR. IP(28).LE.0 ) RETURN
      IF ( GSNXT( NV, IP(IP(26)), RP(IP(27)) ).GT.
     $     T + 8.0D0*GSEPS()*ABS( T ) ) RETURN
      IE = IP(28)
      RE = IP(29)
      NE = IP(IE)
      CALL GSINP( CMD, CLO, VIN, T, -1, X, NU, NX, NV, IP, RP, CST, V,
     $            W, IER )
      IF ( IER.EQ.0 ) THEN
         CALL GSENF( EVT, GSLFT( T, -1 ), X, NX, V, CST, IP(IE), RP(RE),
     $               K )
         DO 10 I = 1, NE
            IF ( IP(IE+9+2*NE+I).GT.2 .AND. RP(RE+NE+I-1).LE.0.0D0 )
     $         IP(IE+9+3*NE+I) = 0
   10    CONTINUE
      END IF
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            IER )
      END
