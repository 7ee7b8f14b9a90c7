      SUBROUTINE GSRKS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  TB, SIDE, SIZ, IOPT, ROPT, IP, RP, CST, IW, W,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     From one stop to the next by the classical method of Runge and
C     Kutta, in equal steps of at most ROPT(1), and ROPT(3) where that is
C     above 0.
C
C     ARGUMENTS
C     As GSSIM, and
C     T       (input/output) DOUBLE PRECISION, the time, TB on exit [s].
C     TB      (input) DOUBLE PRECISION, the time of the stop [s].
C     SIDE    (input) INTEGER, the side from which the inputs are taken
C             there, see GSINP.
C     IW      (input/output) INTEGER array, dimension (7), the places of
C             (1) the state, (2) the next state, which change places,
C             (3) inputs, (4) partition, (5) stages in W.
C     INFO    (output) INTEGER, as GSSIM: 0, 1, 3 or 4.
C
C     METHOD
C     Time is TA + k*H, TA being the last place where the length of the
C     steps changed.  GSEVN may want shorter steps: a tenth, until the
C     event or the stop is there.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            SIDE, SIZ(8), IOPT(*), IP(*), IW(7), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TB, ROPT(*), RP(*), CST(*), W(*), RSTAT(*)
      EXTERNAL           GSRKL, GSRKT, GSSTD, GSRK4, GSRKQ
      DOUBLE PRECISION   TA, TN, H, HR
      INTEGER            NQ, NU, NX, NV, NLAM, K, N, AT, AGAIN, IX, IXN,
     $                   IV, IC, IK, IER
C
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      IV = IW(3)
      IC = IW(4)
      IK = IW(5)
      TA = T
      HR = ROPT(1)
C
   20 CALL GSRKL( TA, TB, HR, ROPT(3), N, H, RSTAT )
      DO 30 K = 1, N
         IX  = IW(1)
         IXN = IW(2)
         CALL GSRKT( TA, TB, SIDE, H, K, N, T, TN, AT )
         INFO = 1
         IF ( IOPT(4).GT.0 .AND. ISTAT(2).GE.IOPT(4) ) RETURN
         INFO = 3
         CALL GSSTD( RHS, CON, KIN, CMD, CLO, VIN, IOPT(1), T, H, W(IX),
     $               NQ, NU, NX, NV, NLAM, IP, RP, CST, W(IV), ROPT(2),
     $               ROPT(4), W(IK), W, W(IC), ISTAT, RSTAT )
         CALL GSRK4( RHS, CON, KIN, CMD, CLO, VIN, T, TN, AT, H, W(IX),
     $               NQ, NU, NX, NV, NLAM, IP, RP, CST, W(IV), W(IXN),
     $               W(IK), W, W(IC), ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) RETURN
         CALL GSRKQ( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T, TN,
     $               TB, AT, H, TA, HR, SIZ, IOPT, ROPT, IP, RP, CST,
     $               IW, W, ISTAT, RSTAT, AGAIN, INFO )
         IF ( INFO.NE.0 ) RETURN
         IF ( AGAIN.EQ.1 ) GO TO 20
   30 CONTINUE
      INFO = 0
      T = TB
      END
      SUBROUTINE GSRKL( TA, TB, HR, HMAX, N, H, RSTAT )
C
C     PURPOSE
C     N equal steps H, no longer than HR, and HMAX where that is above
C     0, from TA to the stop TB of GSRKS; of very many the first is as
C     long as that: behind it steps are longer.
C
      IMPLICIT NONE
      INTEGER            N
      DOUBLE PRECISION   TA, TB, HR, HMAX, H, MANY, RSTAT(*)
C
      H = HR
      IF ( HMAX.GT.0.0D0 ) H = MIN( HR, HMAX )
      MANY = ( TB - TA )/H*( 1.0D0 - 1.0D-9 )
      N = MAX( 1, INT( MIN( MANY, 2.0D9 ) ) + 1 )
      IF ( MANY.LE.2.0D9 ) H = ( TB - TA )/DBLE( N )
      RSTAT(6) = MIN( RSTAT(6), H )
      RSTAT(7) = MAX( RSTAT(7), H )
      END
      SUBROUTINE GSRKT( TA, TB, SIDE, H, K, N, T, TN, AT )
C
C     PURPOSE
C     The K-th of N steps H of GSRKS from TA to TB: from T to TN, AT < 0
C     where the inputs are taken from the left there.
C
      IMPLICIT NONE
      INTEGER            SIDE, K, N, AT
      DOUBLE PRECISION   TA, TB, H, T, TN
C
      T  = TA + DBLE( K - 1 )*H
      TN = TA + DBLE( K )*H
      AT = 1
      IF ( K.EQ.N ) THEN
         TN = TB
         AT = SIDE
      END IF
      END
      SUBROUTINE GSRKQ( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  TN, TB, AT, H, TA, HR, SIZ, IOPT, ROPT, IP, RP,
     $                  CST, IW, W, ISTAT, RSTAT, AGAIN, INFO )
C
C     PURPOSE
C     After a step of GSRK4 within GSRKS: up to an event in it, onto the
C     constraints.  AGAIN is 1 where steps of another length HR begin at
C     TA, else 0.  Other arguments as GSRKS and GSRKT.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            AT, SIZ(8), IOPT(*), IP(*), IW(7), ISTAT(*),
     $                   AGAIN, INFO
      DOUBLE PRECISION   T, TN, TB, H, TA, HR, ROPT(*), RP(*), CST(*),
     $                   W(*), RSTAT(*)
      INTEGER            GSFIN
      EXTERNAL           GSFIN, GSEVN, GSCHK, GSEVO, GSEVR
      DOUBLE PRECISION   GAUSS(3), NOJUMP(3)
      INTEGER            NQ, NU, NX, NV, NLAM, I, EVENT, IX, IXN, IV,
     $                   IC, IK, IER
C
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      IX   = IW(1)
      IXN  = IW(2)
      IV   = IW(3)
      IC   = IW(4)
      IK   = IW(5)
      DO 10 I = 1, 3
         GAUSS(I)  = 0.0D0
         NOJUMP(I) = 0.0D0
   10 CONTINUE
      EVENT = 0
      AGAIN = 0
      INFO  = 3
      IF ( IP(28).GT.0 ) THEN
         CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, IOPT(1),
     $               IOPT(2), T, TN, AT, H, W(IX), SIZ, IP, RP, CST,
     $               W(IV), ROPT, W(IXN), W(IK), W, W(IC), ISTAT, RSTAT,
     $               IP(IP(28)), RP(IP(29)), GAUSS, EVENT, IER )
         IF ( IER.NE.0 ) RETURN
         IF ( EVENT.LT.0 ) THEN
            TA = T
            HR = 0.1D0*H
            AGAIN = 1
            INFO  = 0
            RETURN
         END IF
      END IF
C
C     -- the step is good
      RSTAT(8) = TN
      IF ( GSFIN( NX, W(IXN) ).NE.0 ) THEN
         INFO = 4
         RETURN
      END IF
      IW(1) = IXN
      IW(2) = IX
      ISTAT(2) = ISTAT(2) + 1
      CALL GSCHK( PRJ, CON, KIN, TN, W(IXN), NQ, NU, NX, NLAM, IOPT,
     $            NOJUMP, CST, W(IC), ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) RETURN
      IF ( IP(28).GT.0 .AND. EVENT.EQ.0 ) CALL GSEVO( RST, IOPT(1), TN,
     $   W(IXN), NX, IP, RP, CST, W(IV), ROPT(2), ROPT(4), I )
      IF ( EVENT.GT.0 ) CALL GSEVR( CMD, CLO, VIN, EVT, RST, TN, W(IXN),
     $   NU, NX, NV, IP, RP, CST, W(IV), W, ISTAT, EVENT, IER )
      IF ( IER.NE.0 ) RETURN
      IF ( EVENT.GT.0 ) THEN
         IF ( IP(IP(28)+8).GT.0 ) INFO = 11
         IF ( INFO.EQ.11 ) RETURN
      END IF
      IF ( TN.LT.TB .AND. ( EVENT.GT.0 .OR. HR.LT.ROPT(1) ) ) THEN
         TA = TN
         HR = ROPT(1)
         AGAIN = 1
      END IF
      INFO = 0
      END
