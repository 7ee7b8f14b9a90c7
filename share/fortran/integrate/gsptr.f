      SUBROUTINE GSPTR( RHS, CON, KIN, CMD, CLO, VIN, T, IB, SIZ, TIM,
     $                  ROPT, IP, RP, CST, P, JOB, NS, IW, W, ISTAT,
     $                  RSTAT, PAS, INFO )
C
C     PURPOSE
C     One trial step of GSPSG from TC - D to TC + D within a run, with
C     the partition that holds at its far end and the inputs between two
C     breaks continued beyond these.
C
C     ARGUMENTS
C     As GSPSS, and
C     IB      (input) INTEGER, the next break.
C     JOB, NS (input) M(5) and LM(5) of GSDPS.
C     PAS     (input/output) DOUBLE PRECISION array, dimension (6): (1)
C             TC and (2) D, the step; on exit (3) ERR, (4) EIT, (5) TS
C             and (6) SMIN of GSPSG, too.
C     INFO    (output) INTEGER, as GSPSG.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            IB, SIZ(8), IP(*), NS, IW(7), ISTAT(*), INFO
      DOUBLE PRECISION   T, TIM(*), ROPT(*), RP(*), CST(*), P(*), JOB,
     $                   W(*), RSTAT(*), PAS(6)
      EXTERNAL           GSPFE, GSPSG
      DOUBLE PRECISION   TV(3)
      INTEGER            NT
C
      NT   = SIZ(6)
      P(1) = 2.0D0
      P(2) = -1.0D0
      CALL GSPFE( CON, KIN, T, W(IW(1)), PAS(1), PAS(2), SIZ(1), SIZ(2),
     $            SIZ(3), NS, SIZ(5), CST, W(IW(5)), W(IW(2)),
     $            W(IW(7)), P )
      TV(1) = TIM(1)
      TV(2) = TIM(1+NT)
      IF ( IB.GT.1 ) TV(1) = TIM(NT+IB)
      IF ( IB.LE.SIZ(7) ) TV(2) = TIM(NT+1+IB)
      TV(3) = 0.0D0
      IF ( MAX( TV(1) - PAS(1), PAS(1) - TV(2) ) + PAS(2).GT.TV(2) -
     $     TV(1) ) TV(3) = TV(2) - TV(1)
      CALL GSPSG( RHS, CON, KIN, CMD, CLO, VIN, T, W(IW(1)), PAS(1),
     $            PAS(2), TV, SIZ(1), SIZ(2), SIZ(3), NS, SIZ(4),
     $            SIZ(5), IP, RP, CST, W(IW(3)), ROPT(2), ROPT(4),
     $            W(IW(5)), W(IW(2)), W(IW(6)), W, P, ISTAT, RSTAT,
     $            PAS(3), PAS(4), PAS(5), PAS(6), INFO )
      P(1) = JOB
      P(2) = -1.0D0
      END
      SUBROUTINE GSPFE( CON, KIN, T, X, TC, D, NQ, NU, NX, NS, NLAM,
     $                  CST, F, XN, SIZ, P )
C
C     PURPOSE
C     The partition that holds at the end of a step of GSPSG that lies
C     farther from X, by a path with linear rates of the coordinates.
C     Lengths of rows stay those of states that the motion had.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), TC, D, CST(*), F(NX,*), XN(*), SIZ(*),
     $                   P(*)
      EXTERNAL           GSPNW, GSPRD, GSGLN, GSGLQ, GSPTH
      DOUBLE PRECISION   B(12), C(12), WT(12), TF
      INTEGER            I, IM, IER
C
      IF ( ABS( T - TC ).GT.0.6D0*D ) THEN
         CALL GSPNW( CON, KIN, T, X, NQ, NU, NLAM, CST, P, IER )
         RETURN
      END IF
      TF = TC + SIGN( D, TC - T )
      CALL GSPRD( KIN, T, X, TC, D, NQ, NX, NS, CST, F, XN )
      CALL GSGLN( NS, C, WT )
      CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TF - TC )/D, B )
      CALL GSPTH( NX, NS, NX, X, D, B, F, XN )
      IM = 14 + 2*NU + NQ
      DO 10 I = 1, NLAM
         SIZ(I) = P(IM+I)
   10 CONTINUE
      CALL GSPNW( CON, KIN, TF, XN, NQ, NU, NLAM, CST, P, IER )
      DO 20 I = 1, NLAM
         P(IM+I) = SIZ(I)
   20 CONTINUE
      END
