      SUBROUTINE GSSIM( RHS, PRJ, CON, CMD, CLO, VIN, NQ, NU, NX, NV,
     $                  NLAM, T0, X0, NT, TOUT, NB, TBRK, IOPT, ROPT,
     $                  ATOL, IP, RP, CST, XOUT, LDX, VOUT, LDV, ISTAT,
     $                  RSTAT, W, LW, INFO )
C
C     PURPOSE
C     A simulation whose whole loop is compiled: integrates
C        X' = RHS( T, X, V(T,X) ),  X(T0) = X0
C     and leaves the states and inputs at the times TOUT.
C
C     ARGUMENTS
C     RHS     (external) <NAME>_RHS( T, X, V, CST, XD, INFO ).
C     PRJ     (external) <NAME>_PRJ( T, X, CST, RES, INFO ), called if
C             IOPT(2) = 1.
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ), called if IOPT(3) = 1.
C     CMD, CLO, VIN (external) the inputs, see GSINP.
C     NQ, NU  (input) INTEGER, the numbers of coordinates and of speeds:
C             X begins with the coordinates, then the speeds.
C     NX      (input) INTEGER, the number of states, NX >= NQ + NU.
C     NV      (input) INTEGER, the number of inputs.
C     NLAM    (input) INTEGER, the number of constraints.
C     T0      (input) DOUBLE PRECISION, initial time [s].
C     X0      (input) DOUBLE PRECISION array, dimension (NX).
C     NT      (input) INTEGER, the number of output times, NT >= 1.
C     TOUT    (input) DOUBLE PRECISION array, dimension (NT), rising,
C             TOUT(1) >= T0.
C     NB      (input) INTEGER, the number of breaks.
C     TBRK    (input) DOUBLE PRECISION array, dimension (NB), rising:
C             times at which the inputs may jump.  The integration stops
C             there, with the limits from the left, and starts again
C             with the limits from the right.
C     IOPT    (input) INTEGER array, dimension (4):
C             (1) method: 4 classical Runge-Kutta, fixed step;
C                         8 Dormand-Prince 8(5,3), step controlled;
C             (2) 1: X is moved onto the constraints (PRJ) after T0 and
C                 after every step, else 0;
C             (3) 1: the drift of the constraints is recorded, else 0;
C             (4) the largest number of steps, 0 for no limit.
C     ROPT    (input) DOUBLE PRECISION array, dimension (3):
C             (1) step [s].  Method 4: the largest step; the way to each
C                 stop (output time or break) is cut into equal steps.
C                 Method 8: the first step, or 0 for an automatic one;
C             (2) method 8: relative tolerance;
C             (3) method 8: the largest step [s], or 0 for none.
C     ATOL    (input) DOUBLE PRECISION array, dimension (NX), method 8:
C             absolute tolerances, in the units of the states.
C     IP, RP  (input) the inputs, see GSINP.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     XOUT    (output) DOUBLE PRECISION array, dimension (LDX,NT): the
C             states, a column for every output time.
C     LDX     (input) INTEGER, LDX >= NX.
C     VOUT    (output) DOUBLE PRECISION array, dimension (LDV,NT): the
C             inputs (the limit from the left, but at T0).
C     LDV     (input) INTEGER, LDV >= MAX(1,NV).
C     ISTAT   (output) INTEGER array, dimension (10):
C             (1) calls of RHS; (2) accepted steps; (3) rejected steps;
C             (4) projections; (5) output times reached; (6) INFO of the
C             routine that failed; (7) which one: 1 inputs, 2 RHS,
C             3 PRJ, 4 CON; (8) calls of RHS where the constraints lost
C             rank; (9), (10) zero.
C     RSTAT   (output) DOUBLE PRECISION array, dimension (10):
C             (1) largest |phi| and (2) largest |HC*u + phit| after any
C             step; (3) and (4) when; (5) largest |phi| before a
C             projection (as PRJ reports it); (6) smallest and (7)
C             largest step; (8) time reached; (9) the next step that
C             method 8 would take; (10) zero.
C     W       (workspace) DOUBLE PRECISION array, dimension (LW).  On
C             entry its first NU entries are the guess of the planned
C             motion's coordinates at T0 where CLO is used.
C     LW      (input) INTEGER, LW >= 2*NU*(R+1) + 21*NX + NV*NX + NV
C             + 3*NLAM + NLAM*NU + 40, where R = IP(4).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Every stop (output time or break) is met exactly.  Time is
C     t0 + k*h within each way from stop to stop, never a running sum.
C
C     ERROR INDICATOR
C     INFO = 0   all output times reached;
C     INFO = -i  argument i is out of range;
C     INFO = 1   more than IOPT(4) steps;
C     INFO = 2   the step became too small (method 8);
C     INFO = 3   a routine failed: see ISTAT(6) and ISTAT(7);
C     INFO = 4   the state is no longer finite.
C     In the cases 1 to 4 the first ISTAT(5) columns of XOUT are valid.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NV, NLAM, NT, NB, IOPT(*), IP(*),
     $                   LDX, LDV, ISTAT(10), LW, INFO
      DOUBLE PRECISION   T0, X0(*), TOUT(*), TBRK(*), ROPT(*), ATOL(*),
     $                   RP(*), CST(*), XOUT(LDX,*), VOUT(LDV,*),
     $                   RSTAT(10), W(*)
      INTEGER            GSFIN
      EXTERNAL           GSFIN, GSINP, GSRK4, GSDP8, GSHIN, GSCHK
      INTEGER            I, IB, IT, IX, IXN, IV, IC, IK, K, N, SIDE,
     $                   IER
      LOGICAL            FRESH
      DOUBLE PRECISION   TA, TB, T, TN, H, HN, ERR, FAC, HMAX, GSEPS,
     $                   EPS
      EXTERNAL           GSEPS
C
C     -- arguments
      INFO = 0
      IF ( NQ.LT.0 ) INFO = -7
      IF ( NU.LT.0 ) INFO = -8
      IF ( NX.LT.MAX( 1, NQ + NU ) ) INFO = -9
      IF ( NV.LT.0 ) INFO = -10
      IF ( NLAM.LT.0 ) INFO = -11
      IF ( NT.LT.1 ) INFO = -14
      IF ( NB.LT.0 ) INFO = -16
      IF ( LDX.LT.NX ) INFO = -25
      IF ( LDV.LT.MAX( 1, NV ) ) INFO = -27
      I = 2*NU*( IP(4) + 1 ) + 21*NX + NV*NX + NV + 3*NLAM + NLAM*NU
      IF ( LW.LT.I + 40 ) INFO = -31
      IF ( INFO.NE.0 ) RETURN
      IF ( .NOT.( ABS( T0 ).LE.1.0D300 ) ) INFO = -12
      IF ( GSFIN( NX, X0 ).NE.0 ) INFO = -13
      IF ( GSFIN( NT, TOUT ).NE.0 ) INFO = -15
      IF ( GSFIN( NB, TBRK ).NE.0 ) INFO = -17
      IF ( IOPT(1).NE.4 .AND. IOPT(1).NE.8 ) INFO = -18
      IF ( IOPT(1).EQ.4 .AND. .NOT.( ROPT(1).GT.0.0D0 ) ) INFO = -19
      IF ( IOPT(1).EQ.8 .AND. .NOT.( ROPT(2).GT.0.0D0 .AND.
     $     ROPT(1).GE.0.0D0 .AND. ROPT(3).GE.0.0D0 ) ) INFO = -19
      IF ( INFO.NE.0 ) RETURN
      IF ( IOPT(1).EQ.4 .AND. ( TOUT(NT) - T0 )/ROPT(1).GT.2.0D9 )
     $   INFO = -19
      IF ( TOUT(1).LT.T0 ) INFO = -15
      DO 10 I = 2, NT
         IF ( TOUT(I).LE.TOUT(I-1) ) INFO = -15
   10 CONTINUE
      DO 20 I = 2, NB
         IF ( TBRK(I).LE.TBRK(I-1) ) INFO = -17
   20 CONTINUE
      IF ( IOPT(1).EQ.8 ) THEN
         DO 30 I = 1, NX
            IF ( .NOT.( ATOL(I).GE.0.0D0 ) ) INFO = -20
   30    CONTINUE
      END IF
      IF ( INFO.NE.0 ) RETURN
C
C     -- workspace: inputs, states, constraints, stages
      IX  = 2*NU*( IP(4) + 1 ) + 5*NX + NV*NX + 21
      IXN = IX + NX
      IV  = IXN + NX
      IC  = IV + MAX( 1, NV )
      IK  = IC + 3*NLAM + NLAM*NU + 10
      EPS = GSEPS()
      DO 40 I = 1, 10
         ISTAT(I) = 0
         RSTAT(I) = 0.0D0
   40 CONTINUE
      DO 50 I = 1, NX
         W(IX+I-1) = X0(I)
   50 CONTINUE
C
C     -- the start
      T  = T0
      TA = T0
      IT = 1
      IB = 1
      HN = ROPT(1)
      FRESH = .TRUE.
      HMAX  = TOUT(NT) - T0
      IF ( ROPT(3).GT.0.0D0 ) HMAX = MIN( HMAX, ROPT(3) )
      RSTAT(6) = HMAX
      CALL GSCHK( PRJ, CON, T, W(IX), NQ, NU, NX, NLAM, IOPT, CST,
     $            W(IC), ISTAT, RSTAT, IER )
      IF ( IER.NE.0 ) GO TO 903
      CALL GSINP( CMD, CLO, VIN, T, 1, W(IX), NU, NX, NV, IP, RP, CST,
     $            W(IV), W, IER )
      ISTAT(6) = IER
      ISTAT(7) = 1
      IF ( IER.NE.0 ) GO TO 903
      ISTAT(7) = 0
C
C     -- the next stop, TB; SIDE < 0 where it is a break
  100 CONTINUE
      RSTAT(8) = T
      IF ( T.GE.TOUT(IT) ) THEN
         DO 110 I = 1, NX
            XOUT(I,IT) = W(IX+I-1)
  110    CONTINUE
         DO 120 I = 1, NV
            VOUT(I,IT) = W(IV+I-1)
  120    CONTINUE
         ISTAT(5) = IT
         IT = IT + 1
         IF ( IT.GT.NT ) RETURN
      END IF
  130 IF ( IB.LE.NB ) THEN
         IF ( TBRK(IB).LE.T ) THEN
            IB = IB + 1
            FRESH = .TRUE.
            GO TO 130
         END IF
      END IF
      TA = T
      TB = TOUT(IT)
      SIDE = 1
      IF ( IB.LE.NB ) THEN
         IF ( TBRK(IB).LE.TB ) SIDE = -1
         TB = MIN( TB, TBRK(IB) )
      END IF
      IF ( IOPT(1).EQ.8 ) GO TO 300
C
C     -- classical Runge-Kutta, N equal steps
      N = MAX( 1, INT( ( TB - TA )/ROPT(1)*( 1.0D0 - 1.0D-9 ) ) + 1 )
      H = ( TB - TA )/DBLE( N )
      RSTAT(6) = MIN( RSTAT(6), H )
      RSTAT(7) = MAX( RSTAT(7), H )
      DO 210 K = 1, N
         T  = TA + DBLE( K - 1 )*H
         TN = TA + DBLE( K )*H
         I  = 1
         IF ( K.EQ.N ) THEN
            TN = TB
            I  = SIDE
         END IF
         IF ( IOPT(4).GT.0 .AND. ISTAT(2).GE.IOPT(4) ) GO TO 901
         CALL GSRK4( RHS, CMD, CLO, VIN, T, TN, I, H, W(IX), NU, NX, NV,
     $               IP, RP, CST, W(IV), W(IXN), W(IK), W, ISTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         I   = IX
         IX  = IXN
         IXN = I
         RSTAT(8) = TN
         IF ( GSFIN( NX, W(IX) ).NE.0 ) GO TO 904
         ISTAT(2) = ISTAT(2) + 1
         IF ( IOPT(2).EQ.1 .OR. IOPT(3).EQ.1 ) THEN
            CALL GSCHK( PRJ, CON, TN, W(IX), NQ, NU, NX, NLAM, IOPT,
     $                  CST, W(IC), ISTAT, RSTAT, IER )
            IF ( IER.NE.0 ) GO TO 903
         END IF
  210 CONTINUE
      T = TB
      GO TO 400
C
C     -- Dormand-Prince 8(5,3)
  300 CONTINUE
      IF ( FRESH ) THEN
         CALL GSFUN( RHS, CMD, CLO, VIN, T, 1, W(IX), NU, NX, NV, IP,
     $               RP, CST, W(IV), W(IK), W, ISTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         FRESH = .FALSE.
         IF ( HN.LE.0.0D0 ) THEN
            CALL GSHIN( RHS, CMD, CLO, VIN, T, MIN( HMAX, TB - T ),
     $                  W(IX), NU, NX, NV, IP, RP, CST, W(IV), ROPT(2),
     $                  ATOL, W(IK), W, ISTAT, HN, IER )
            IF ( IER.NE.0 ) GO TO 903
         END IF
      END IF
      H  = MIN( HN, HMAX )
      TN = T + H
      I  = 1
      IF ( T + 1.01D0*H.GE.TB ) THEN
         H  = TB - T
         TN = TB
         I  = SIDE
      ELSE IF ( T + 2.0D0*H.GT.TB ) THEN
         H  = 0.5D0*( TB - T )
         TN = T + H
      END IF
      IF ( IOPT(4).GT.0 .AND. ISTAT(2) + ISTAT(3).GE.IOPT(4) ) GO TO 901
      IF ( H.LE.16.0D0*EPS*MAX( ABS( T ), ABS( TB ) ) .AND. TN.LT.TB )
     $   GO TO 902
      CALL GSDP8( RHS, CMD, CLO, VIN, T, TN, I, H, W(IX), NU, NX, NV,
     $            IP, RP, CST, W(IV), ROPT(2), ATOL, W(IXN), ERR, W(IK),
     $            W, ISTAT, IER )
      IF ( IER.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         FAC = 6.0D0
         IF ( ERR.GT.0.0D0 ) FAC = MIN( FAC, 0.9D0*ERR**(-0.125D0) )
         FAC = MAX( FAC, 1.0D0/3.0D0 )
         IF ( H.GE.0.99D0*HN .OR. H*FAC.GT.HN ) HN = H*FAC
         I   = IX
         IX  = IXN
         IXN = I
         T   = TN
         RSTAT(6) = MIN( RSTAT(6), H )
         RSTAT(7) = MAX( RSTAT(7), H )
         RSTAT(8) = T
         RSTAT(9) = HN
         ISTAT(2) = ISTAT(2) + 1
         ISTAT(6) = 0
         ISTAT(7) = 0
         IF ( IOPT(2).EQ.1 .OR. IOPT(3).EQ.1 ) THEN
            CALL GSCHK( PRJ, CON, T, W(IX), NQ, NU, NX, NLAM, IOPT, CST,
     $                  W(IC), ISTAT, RSTAT, IER )
            IF ( IER.NE.0 ) GO TO 903
         END IF
         FRESH = .TRUE.
         IF ( T.LT.TB ) GO TO 300
      ELSE
         ISTAT(3) = ISTAT(3) + 1
         FAC = 0.25D0
         IF ( IER.EQ.0 .AND. ERR.LE.1.0D300 )
     $      FAC = MIN( 0.9D0, MAX( 0.2D0, 0.9D0*ERR**(-0.125D0) ) )
         HN = H*FAC
         IF ( IER.NE.0 .AND.
     $        HN.LE.1.0D3*EPS*MAX( ABS( T ), ABS( TB ) ) ) GO TO 903
         GO TO 300
      END IF
C
C     -- the inputs at the stop, from the left, for the record
  400 CONTINUE
      CALL GSINP( CMD, CLO, VIN, T, SIDE, W(IX), NU, NX, NV, IP, RP,
     $            CST, W(IV), W, IER )
      IF ( IER.EQ.0 ) GO TO 100
      ISTAT(6) = IER
      ISTAT(7) = 1
      GO TO 903
C
  901 INFO = 1
      RETURN
  902 INFO = 2
      RETURN
  903 INFO = 3
      RETURN
  904 INFO = 4
      END
      SUBROUTINE GSCHK( PRJ, CON, T, X, NQ, NU, NX, NLAM, IOPT, CST, W,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     After a step: projection of X onto the constraints, and the drift
C     that is left.  Arguments as GSSIM; W has 3*NLAM + NLAM*NU + 10
C     entries.
C
      IMPLICIT NONE
      EXTERNAL           PRJ, CON
      INTEGER            NQ, NU, NX, NLAM, IOPT(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), CST(*), W(*), RSTAT(*)
      INTEGER            I, J, IPT, IG, IHC
      DOUBLE PRECISION   S
C
      INFO = 0
      IF ( NLAM.EQ.0 .AND. NQ.EQ.NU ) RETURN
      IF ( IOPT(2).EQ.1 ) THEN
         CALL PRJ( T, X, CST, W, INFO )
         ISTAT(4) = ISTAT(4) + 1
         IF ( INFO.EQ.2 ) INFO = 0
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 3
            RETURN
         END IF
         RSTAT(5) = MAX( RSTAT(5), ABS( W(1) ) )
      END IF
      IF ( IOPT(3).NE.1 .OR. NLAM.EQ.0 ) RETURN
      IPT = NLAM + 1
      IG  = IPT + NLAM
      IHC = IG + NLAM
      CALL CON( T, X, X(NQ+1), CST, W, W(IPT), W(IHC), NLAM, W(IG),
     $          INFO )
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.NE.0 ) THEN
         ISTAT(6) = INFO
         ISTAT(7) = 4
         RETURN
      END IF
      DO 20 I = 1, NLAM
         S = W(IPT+I-1)
         DO 10 J = 1, NU
            S = S + W(IHC+I-1+NLAM*(J-1))*X(NQ+J)
   10    CONTINUE
         IF ( ABS( W(I) ).GT.RSTAT(1) ) THEN
            RSTAT(1) = ABS( W(I) )
            RSTAT(3) = T
         END IF
         IF ( ABS( S ).GT.RSTAT(2) ) THEN
            RSTAT(2) = ABS( S )
            RSTAT(4) = T
         END IF
   20 CONTINUE
      END
