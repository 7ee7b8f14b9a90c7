      SUBROUTINE GSPEN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  TB, TEND, TS, SIDE, TC, D, ERR, EIT, TMIN, SMIN,
     $                  NQ, NU, NX, NS, NV, NLAM, TOUT, NB, TBRK, IT,
     $                  IB, IOPT, ROPT, ATOL, IP, RP, CST, XOUT, LDX,
     $                  VOUT, LDV, X, XN, V, F, W, P, JOB, M, BEGIN,
     $                  TAKEN, AGAIN, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     A good step of GSPSG is taken: to its end or to the next break,
C     sample or end of the run, or up to an event, onto the constraints
C     there; the outputs within it.
C
C     ARGUMENTS
C     As GSPSS and GSPSG, and
C     D       (input/output) DOUBLE PRECISION, a quarter where AGAIN is.
C     AGAIN   (output) INTEGER, 1 if the state could not be moved onto
C             the constraints: a shorter step is to be tried; else 0.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            SIDE, NQ, NU, NX, NS, NV, NLAM, NB, IT, IB,
     $                   IOPT(*), IP(*), LDX, LDV, BEGIN, TAKEN, AGAIN,
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, TB, TEND, TS, TC, D, ERR, EIT, TMIN, SMIN,
     $                   TOUT(*), TBRK(*), ROPT(*), ATOL(*), RP(*),
     $                   CST(*), XOUT(LDX,*), VOUT(LDV,*), X(*), XN(*),
     $                   V(*), F(NX,*), W(*), P(*), JOB, M(4), RSTAT(*)
      EXTERNAL           GSPBC, GSPEV, GSPCK, GSPOU, GSEVR
      DOUBLE PRECISION   GAP, TN
      INTEGER            STOPS, EVENT, IER
C
      AGAIN = 0
      INFO  = 3
      IF ( BEGIN.NE.0 ) THEN
C        are the speeds those of a motion that leads out of it?
         CALL GSPBC( KIN, T, X, TC, D, NQ, NX, NS, CST, F, XN, GAP )
         IF ( GAP.GT.1.0D-6 + 1.0D2*ROPT(2) ) THEN
            ISTAT(6) = 4 - MAX( 0, BEGIN )
            ISTAT(7) = 8
            RETURN
         END IF
      END IF
      TN = TC + D
      STOPS = 0
      IF ( TEND.LE.TN ) THEN
         TN = TEND
         STOPS = 1
      END IF
      IF ( TN.LE.T + 0.01D0*D .AND. STOPS.EQ.0 ) THEN
         M(1) = T + D
         INFO = 0
         RETURN
      END IF
      CALL GSPEV( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, T, TN, STOPS,
     $            TC, D, NQ, NU, NX, NS, NV, NLAM, IOPT, ROPT, ATOL, IP,
     $            RP, CST, X, XN, V, F, W, P, EVENT, ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) RETURN
      CALL GSPCK( PRJ, CON, KIN, TN, XN, TC, D, NQ, NU, NX, NLAM, IOPT,
     $            CST, P, JOB, ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) THEN
         INFO = 0
         IF ( M(3).GT.0.15D0 ) THEN
            M(3) = 0.25D0*M(3)
            D    = 0.25D0*D
            AGAIN = 1
         ELSE
            M(1) = TC + D
         END IF
         RETURN
      END IF
      BEGIN = -MIN( 1, EVENT )
      CALL GSPOU( CMD, CLO, VIN, T, TN, TC, D, NU, NX, NS, NV, TOUT, IP,
     $            RP, CST, X, F, W, XOUT, LDX, VOUT, LDV, IT, ISTAT,
     $            IER )
      IF ( IER.NE.0 ) RETURN
C
C     -- the stop that it is
      TB   = TN
      SIDE = 1
      IF ( STOPS.EQ.1 ) THEN
         IF ( IB.LE.NB ) THEN
            IF ( TBRK(IB).LE.TN ) SIDE = -1
         END IF
         IF ( TS.LE.TN ) SIDE = -1
      END IF
      IF ( SMIN.LT.0.01D0*P(14) .AND. TMIN.GE.T .AND. TMIN.LE.TN
     $     .AND. TMIN.GT.M(2) ) THEN
         ISTAT(11) = ISTAT(11) + 1
         IF ( ISTAT(11).EQ.1 ) RSTAT(16) = TMIN
         RSTAT(17) = TMIN
         M(2) = TMIN + 0.1D0*D
      END IF
      IF ( TN.GE.TC + D ) M(1) = TC + D
      IF ( MAX( ERR, EIT ).GT.1.0D0 ) ISTAT(20) = ISTAT(20) + 1
      TAKEN = 1
      RSTAT(7) = MAX( RSTAT(7), TN - T )
      T = TN
      RSTAT(8) = T
      ISTAT(2) = ISTAT(2) + 1
      ISTAT(6) = 0
      ISTAT(7) = 0
      IF ( EVENT.GT.0 ) CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, XN, NU,
     $   NX, NV, IP, RP, CST, V, W, ISTAT, EVENT, IER )
      IF ( IER.EQ.0 ) INFO = 0
      END
      SUBROUTINE GSPEV( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, T, TN,
     $                  STOPS, TC, D, NQ, NU, NX, NS, NV, NLAM, IOPT,
     $                  ROPT, ATOL, IP, RP, CST, X, XN, V, F, W, P,
     $                  EVENT, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The state XN at TN on the path of GSPSG, or at the first event
C     before it: then TN is its time, EVENT its number and STOPS, which
C     says that TN is a stop, 0.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            STOPS, NQ, NU, NX, NS, NV, NLAM, IOPT(*),
     $                   IP(*), EVENT, ISTAT(*), INFO
      DOUBLE PRECISION   T, TN, TC, D, ROPT(*), ATOL(*), RP(*), CST(*),
     $                   X(*), XN(*), V(*), F(NX,*), W(*), P(*),
     $                   RSTAT(*)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSEVN
      DOUBLE PRECISION   B(12), C(12), WT(12), GAUSS(3), H
      INTEGER            AT
C
      INFO  = 0
      EVENT = 0
      GAUSS(1) = TC
      GAUSS(2) = D
      GAUSS(3) = DBLE( NS )
      CALL GSGLN( NS, C, WT )
   10 CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TN - TC )/D, B )
      CALL GSPTH( NX, NS, NX, X, D, B, F, XN )
      IF ( IP(28).LE.0 ) RETURN
      AT = 1
      IF ( STOPS.EQ.1 ) AT = -1
      H = TN - T
      CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, 12, IOPT(2),
     $            T, TN, AT, H, X, NQ, NU, NX, NV, NLAM, IP, RP, CST,
     $            V, ROPT(2), ATOL, XN, F, W, P, ISTAT, RSTAT,
     $            IP(IP(28)), RP(IP(29)), GAUSS, EVENT, INFO )
      IF ( INFO.NE.0 ) RETURN
      IF ( EVENT.NE.0 ) STOPS = 0
      IF ( EVENT.LT.0 ) THEN
         TN = T + 0.1D0*H
         GO TO 10
      END IF
      END
      SUBROUTINE GSPCK( PRJ, CON, KIN, TN, XN, TC, D, NQ, NU, NX, NLAM,
     $                  IOPT, CST, P, JOB, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     GSCHK at the end of a passage; close to the singular position
C     nothing is moved.  INFO as GSCHK.
C
      IMPLICIT NONE
      EXTERNAL           PRJ, CON, KIN
      INTEGER            NQ, NU, NX, NLAM, IOPT(*), ISTAT(*), INFO
      DOUBLE PRECISION   TN, XN(*), TC, D, CST(*), P(*), JOB, RSTAT(*)
      EXTERNAL           GSCHK
      DOUBLE PRECISION   NOJUMP(3)
      INTEGER            I, LOPT(6)
C
      DO 10 I = 1, 6
         LOPT(I) = IOPT(I)
   10 CONTINUE
      DO 20 I = 1, 3
         NOJUMP(I) = 0.0D0
   20 CONTINUE
      P(4) = 0.0D0
      IF ( TN.LT.TC + 0.6D0*D ) THEN
         LOPT(2) = 1
         P(1)    = 0.0D0
      END IF
      CALL GSCHK( PRJ, CON, KIN, TN, XN, NQ, NU, NX, NLAM, LOPT, NOJUMP,
     $            CST, P, ISTAT, RSTAT, INFO )
      P(1) = JOB
      P(2) = -1.0D0
      END
      SUBROUTINE GSPOU( CMD, CLO, VIN, T, TN, TC, D, NU, NX, NS, NV,
     $                  TOUT, IP, RP, CST, X, F, W, XOUT, LDX, VOUT,
     $                  LDV, IT, ISTAT, INFO )
C
C     PURPOSE
C     The outputs before TN, from the polynomial of GSPSG; IT is the
C     next one.  INFO is 0 or that of the inputs.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN
      INTEGER            NU, NX, NS, NV, IP(*), LDX, LDV, IT, ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TN, TC, D, TOUT(*), RP(*), CST(*), X(*),
     $                   F(NX,*), W(*), XOUT(LDX,*), VOUT(LDV,*)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSINP
      DOUBLE PRECISION   B(12), C(12), WT(12)
C
      INFO = 0
      CALL GSGLN( NS, C, WT )
   10 IF ( TOUT(IT).GE.TN ) RETURN
      CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TOUT(IT) - TC )/D, B )
      CALL GSPTH( NX, NS, NX, X, D, B, F, XOUT(1,IT) )
      CALL GSINP( CMD, CLO, VIN, TOUT(IT), 1, XOUT(1,IT), NU, NX, NV,
     $            IP, RP, CST, VOUT(1,IT), W, INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 1
      IF ( INFO.NE.0 ) RETURN
      ISTAT(5) = IT
      IT = IT + 1
      GO TO 10
      END
