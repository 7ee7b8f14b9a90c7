      SUBROUTINE GSPEN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  STP, ISTP, PAS, SIZ, TIM, IOPT, ROPT, IP, RP,
     $                  CST, XOUT, VOUT, P, M, LM, IW, W, TAKEN, AGAIN,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     A good step of GSPSG is taken: to its end or to the next break,
C     sample or end of the run, or up to an event, onto the constraints
C     there; the outputs within it.
C
C     ARGUMENTS
C     As GSPSS, and
C     PAS     (input/output) as GSPTR has it; D a quarter where AGAIN
C             is.
C     AGAIN   (output) INTEGER, 1 if the state could not be moved onto
C             the constraints: a shorter step is to be tried; else 0.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            ISTP(3), SIZ(8), IOPT(*), IP(*), LM(6), IW(7),
     $                   TAKEN, AGAIN, ISTAT(*), INFO
      DOUBLE PRECISION   T, STP(3), PAS(6), TIM(*), ROPT(*), RP(*),
     $                   CST(*), XOUT(*), VOUT(*), P(*), M(11), W(*),
     $                   RSTAT(*)
      EXTERNAL           GSPBC, GSPEV, GSPCK, GSPOU, GSEVR
      DOUBLE PRECISION   GAP, TN, TC, D
      INTEGER            NQ, NU, NX, NV, IX, IXN, STOPS, EVENT, IER
C
      NQ = SIZ(1)
      NU = SIZ(2)
      NX = SIZ(3)
      NV = SIZ(4)
      IX = IW(1)
      IXN = IW(2)
      TC = PAS(1)
      D  = PAS(2)
      AGAIN = 0
      INFO  = 3
      IF ( LM(6).NE.0 ) THEN
C        are the speeds those of a motion that leads out of it?
         CALL GSPBC( KIN, T, W(IX), TC, D, NQ, NX, LM(5), CST, W(IW(5)),
     $               W(IXN), GAP )
         IF ( GAP.GT.1.0D-6 + 1.0D2*ROPT(2) ) THEN
            ISTAT(6) = 4 - MAX( 0, LM(6) )
            ISTAT(7) = 8
            RETURN
         END IF
      END IF
      TN = TC + D
      STOPS = 0
      IF ( STP(2).LE.TN ) THEN
         TN = STP(2)
         STOPS = 1
      END IF
      IF ( TN.LE.T + 0.01D0*D .AND. STOPS.EQ.0 ) THEN
         M(8) = T + D
         INFO = 0
         RETURN
      END IF
      CALL GSPEV( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, T, TN, STOPS,
     $            TC, D, LM(5), SIZ, IOPT, ROPT, IP, RP, CST, IW, W, P,
     $            EVENT, ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) RETURN
      CALL GSPCK( PRJ, CON, KIN, TN, W(IXN), TC, D, NQ, NU, NX, SIZ(5),
     $            IOPT, CST, P, M(5), ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) THEN
         INFO = 0
         IF ( M(10).GT.0.15D0 ) THEN
            M(10)  = 0.25D0*M(10)
            PAS(2) = 0.25D0*D
            AGAIN  = 1
         ELSE
            M(8) = TC + D
         END IF
         RETURN
      END IF
      LM(6) = -MIN( 1, EVENT )
      CALL GSPOU( CMD, CLO, VIN, T, TN, TC, D, NU, NX, LM(5), NV,
     $            TIM(2), IP, RP, CST, W(IX), W(IW(5)), W, XOUT, VOUT,
     $            ISTP(2), ISTAT, IER )
      IF ( IER.NE.0 ) RETURN
C
C     -- the stop that it is
      STP(1)  = TN
      ISTP(1) = 1
      IF ( STOPS.EQ.1 ) THEN
         IF ( ISTP(3).LE.SIZ(7) ) THEN
            IF ( TIM(1+SIZ(6)+ISTP(3)).LE.TN ) ISTP(1) = -1
         END IF
         IF ( STP(3).LE.TN ) ISTP(1) = -1
      END IF
      IF ( PAS(6).LT.0.01D0*P(14) .AND. PAS(5).GE.T .AND. PAS(5).LE.TN
     $     .AND. PAS(5).GT.M(9) ) THEN
         ISTAT(11) = ISTAT(11) + 1
         IF ( ISTAT(11).EQ.1 ) RSTAT(16) = PAS(5)
         RSTAT(17) = PAS(5)
         M(9) = PAS(5) + 0.1D0*D
      END IF
      IF ( TN.GE.TC + D ) M(8) = TC + D
      IF ( MAX( PAS(3), PAS(4) ).GT.1.0D0 ) ISTAT(20) = ISTAT(20) + 1
      TAKEN = 1
      RSTAT(7) = MAX( RSTAT(7), TN - T )
      T = TN
      RSTAT(8) = T
      ISTAT(2) = ISTAT(2) + 1
      ISTAT(6) = 0
      ISTAT(7) = 0
      IF ( EVENT.GT.0 ) CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, W(IXN),
     $   NU, NX, NV, IP, RP, CST, W(IW(3)), W, ISTAT, EVENT, IER )
      IF ( IER.EQ.0 ) INFO = 0
      IF ( EVENT.GT.0 .AND. IER.EQ.0 ) THEN
         IF ( IP(IP(28)+8).GT.0 ) INFO = 11
      END IF
      END
      SUBROUTINE GSPEV( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, T, TN,
     $                  STOPS, TC, D, NS, SIZ, IOPT, ROPT, IP, RP, CST,
     $                  IW, W, P, EVENT, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The next state in W at TN on the path of GSPSG, or at the first
C     event before it: then TN is its time, EVENT its number and STOPS,
C     which says that TN is a stop, 0.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            STOPS, NS, SIZ(8), IOPT(*), IP(*), IW(7),
     $                   EVENT, ISTAT(*), INFO
      DOUBLE PRECISION   T, TN, TC, D, ROPT(*), RP(*), CST(*), W(*),
     $                   P(*), RSTAT(*)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSEVN
      DOUBLE PRECISION   B(12), C(12), WT(12), GAUSS(3), H
      INTEGER            NX, AT
C
      NX    = SIZ(3)
      INFO  = 0
      EVENT = 0
      GAUSS(1) = TC
      GAUSS(2) = D
      GAUSS(3) = DBLE( NS )
      CALL GSGLN( NS, C, WT )
   10 CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TN - TC )/D, B )
      CALL GSPTH( NX, NS, NX, W(IW(1)), D, B, W(IW(5)), W(IW(2)) )
      IF ( IP(28).LE.0 ) RETURN
      AT = 1
      IF ( STOPS.EQ.1 ) AT = -1
      H = TN - T
      CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, 12, IOPT(2),
     $            T, TN, AT, H, W(IW(1)), SIZ, IP, RP, CST, W(IW(3)),
     $            ROPT, W(IW(2)), W(IW(5)), W, P, ISTAT, RSTAT,
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
     $                  TOUT, IP, RP, CST, X, F, W, XOUT, VOUT, IT,
     $                  ISTAT, INFO )
C
C     PURPOSE
C     The outputs before TN, from the polynomial of GSPSG; IT is the
C     next one.  INFO is 0 or that of the inputs.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN
      INTEGER            NU, NX, NS, NV, IP(*), IT, ISTAT(*), INFO
      DOUBLE PRECISION   T, TN, TC, D, TOUT(*), RP(*), CST(*), X(*),
     $                   F(NX,*), W(*), XOUT(NX,*), VOUT(*)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSINP
      DOUBLE PRECISION   B(12), C(12), WT(12)
C
      INFO = 0
      CALL GSGLN( NS, C, WT )
   10 IF ( TOUT(IT).GE.TN ) RETURN
      CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TOUT(IT) - TC )/D, B )
      CALL GSPTH( NX, NS, NX, X, D, B, F, XOUT(1,IT) )
      CALL GSINP( CMD, CLO, VIN, TOUT(IT), 1, XOUT(1,IT), NU, NX, NV,
     $            IP, RP, CST, VOUT(NV*(IT-1)+1), W, INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 1
      IF ( INFO.NE.0 ) RETURN
      ISTAT(5) = IT
      IT = IT + 1
      GO TO 10
      END
