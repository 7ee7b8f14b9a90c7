      SUBROUTINE GSPTR( RHS, CON, KIN, CMD, CLO, VIN, T, X, TC, D, T0,
     $                  NQ, NU, NX, NS, NV, NLAM, NT, TOUT, NB, TBRK,
     $                  IB, IP, RP, CST, V, RTOL, ATOL, F, XN, FN, SIZ,
     $                  W, P, JOB, ISTAT, RSTAT, ERR, EIT, TMIN, SMIN,
     $                  INFO )
C
C     PURPOSE
C     One trial step of GSPSG from TC - D to TC + D within a run, with
C     the partition that holds at its far end and the inputs between two
C     breaks continued beyond these.
C
C     ARGUMENTS
C     As GSPSG and GSPSS, and
C     SIZ     (workspace) DOUBLE PRECISION array, dimension (NLAM).
C     TMIN    (output) DOUBLE PRECISION, TS of GSPSG [s].
C     INFO    (output) INTEGER, as GSPSG.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NS, NV, NLAM, NT, NB, IB, IP(*),
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), TC, D, T0, TOUT(*), TBRK(*), RP(*),
     $                   CST(*), V(*), RTOL, ATOL(*), F(NX,*), XN(*),
     $                   FN(*), SIZ(*), W(*), P(*), JOB, RSTAT(*), ERR,
     $                   EIT, TMIN, SMIN
      EXTERNAL           GSPFE, GSPSG
      DOUBLE PRECISION   TV(3)
C
      P(1) = 2.0D0
      P(2) = -1.0D0
      CALL GSPFE( CON, KIN, T, X, TC, D, NQ, NU, NX, NS, NLAM, CST, F,
     $            XN, SIZ, P )
      TV(1) = T0
      TV(2) = TOUT(NT)
      IF ( IB.GT.1 ) TV(1) = TBRK(IB-1)
      IF ( IB.LE.NB ) TV(2) = TBRK(IB)
      TV(3) = 0.0D0
      IF ( MAX( TV(1) - TC, TC - TV(2) ) + D.GT.TV(2) - TV(1) )
     $   TV(3) = TV(2) - TV(1)
      CALL GSPSG( RHS, CON, KIN, CMD, CLO, VIN, T, X, TC, D, TV, NQ, NU,
     $            NX, NS, NV, NLAM, IP, RP, CST, V, RTOL, ATOL, F, XN,
     $            FN, W, P, ISTAT, RSTAT, ERR, EIT, TMIN, SMIN, INFO )
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
