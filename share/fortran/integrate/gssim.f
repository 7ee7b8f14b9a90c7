      SUBROUTINE GSSIM( RHS, PRJ, CON, KIN, CMD, CLO, VIN, NQ, NU, NX,
     $                  NV, NLAM, T0, X0, NT, TOUT, NB, TBRK, IOPT,
     $                  ROPT, ATOL, IP, RP, CST, XOUT, LDX, VOUT, LDV,
     $                  ISTAT, RSTAT, W, LW, OUT, CTL, EVT, RST, INFO )
C
C     PURPOSE
C     A simulation whose whole loop is compiled: integrates
C        X' = RHS( T, X, V(T,X) ),  X(T0) = X0
C     and leaves the states and inputs at the times TOUT.
C
C     ARGUMENTS
C     RHS     (external) <NAME>_RHS( T, X, V, CST, XD, INFO ).
C     PRJ     (external) <NAME>_PRJ( T, X, CST, RES, INFO ), called if
C             IOPT(2) is not 1, nor 3 where NQ = NU.
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ), called if NLAM > 0 and IOPT(3) = 1 or
C             IOPT(2) = 3 or 6.
C     KIN     (external) <NAME>_KIN( T, Q, U, CST, QDOT ), called if
C             NLAM > 0 and IOPT(5) = 1 or IOPT(2) = 3 or 6.
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
C     IOPT    (input) INTEGER array, dimension (6+IOPT(6)):
C             (1) method: 4 classical Runge-Kutta, fixed step;
C                         8 Dormand-Prince 8(5,3), step controlled;
C                         9 as 8, but it ends where steps are found to
C                           be bound by stability (INFO = 5);
C             (2) the way of the loops:
C                 1 X is left to the terms of Baumgarte within RHS;
C                 2 X is moved onto the constraints (PRJ) at T0 and
C                   after every step;
C                 3 coordinate partitioning: before every call of RHS
C                   the dependent coordinates and speeds are computed
C                   from the independent ones (GSPRT), whose errors
C                   alone steer the step;
C                 4 null space, 5 zero-eigenvalue theorem: as 2 (that
C                   RHS solves in this way is a parameter in CST);
C                 6 Kane with dependent speeds: as 2, and before every
C                   call of RHS the dependent speeds are computed from
C                   the independent ones;
C                 Euler parameters (NQ > NU) are normalized by PRJ, that
C                 is, not in the way 1;
C             (3) 1: the drift of the constraints is recorded, else 0;
C             (4) the largest number of steps, 0 for no limit;
C             (5) 1: positions where the constraints lose rank are
C                 watched for, and close to them (method 8) or where
C                 constraints are redundant the ways 2, 4, 5 and 6
C                 borrow from the way 3 (needs CON, KIN and IOPT(3) =
C                 1), else 0;
C             (6) how many constraints are on speeds alone (they have no
C                 phi): their numbers follow.
C     ROPT    (input) DOUBLE PRECISION array, dimension (3):
C             (1) step [s].  Method 4: the largest step; the way to each
C                 stop (output time or break) is cut into equal steps.
C                 Method 8: the first step, or 0 for an automatic one;
C             (2) method 8: relative tolerance;
C             (3) method 8: the largest step [s], or 0 for none.
C     ATOL    (input) DOUBLE PRECISION array, dimension (NX), method 8:
C             absolute tolerances, in the units of the states.
C     IP, RP  (input/output) the inputs and the plans of the samples and
C             of the events, see GSINP, GSSMP and GSRES: next samples,
C             held outputs, memories and modes go on.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     XOUT    (output) DOUBLE PRECISION array, dimension (LDX,NT): the
C             states, a column for every output time.
C     LDX     (input) INTEGER, LDX >= NX.
C     VOUT    (output) DOUBLE PRECISION array, dimension (LDV,NT): the
C             inputs (the limit from the left, but at T0).
C     LDV     (input) INTEGER, LDV >= MAX(1,NV).
C     ISTAT   (output) INTEGER array, dimension (20):
C             (1) calls of RHS; (2) accepted steps; (3) rejected steps;
C             (4) projections; (5) output times reached; (6) INFO of the
C             routine that failed; (7) which one: 1 inputs, 2 RHS,
C             3 PRJ, 4 CON, 5 GSPRT, 6 OUT or GSSMP, 7 RST or GSRES,
C             8 the start in a singular position: (6) is 1 where method
C             4 does not begin there, 2 at rest, 3 where no motion with
C             these speeds leaves it, 4 so after an event;
C             (8) calls of RHS where the constraints lost rank; (9)
C             calls of RHS close to a singularity of orientation angles; (10) choices of other
C             independent speeds; (11) positions passed where the
C             constraints lose rank: where the least pivot, looked for
C             between the steps (GSPAS), falls below a hundredth of its
C             largest value; (12) steps among (3) that were repeated
C             because X could not be moved onto the constraints, or only
C             by a jump, or was too close to a singular position; (13)
C             calls of RHS beside those in (1) that looked for bounds of
C             stability; (14) 1 if steps are bound by stability (GSSTD)
C             and (15) which state the eigenvalue belongs to; (16) to
C             (18) memory of GSSTD; (19) zero; (20) steps close to
C             singular positions whose estimated error is above the
C             tolerance; method 4: that end where the least pivot is
C             below a hundredth of its largest value.
C     RSTAT   (output) DOUBLE PRECISION array, dimension (20):
C             (1) largest |phi| and (2) largest |HC*u + phit| after any
C             step; (3) and (4) when; (5) largest |phi| before a
C             projection (as PRJ reports it); (6) smallest and (7)
C             largest step; (8) time reached; (9) the next step that
C             method 8 would take; (10) first and (11) last time of
C             ISTAT(8), (12) and (13) of ISTAT(9); (14) the least pivot
C             of the constraints beside the largest, as GSPRC (0 where
C             the rank is lower than elsewhere) and (15) when; (16) the
C             first and (17) the last time of ISTAT(11); where ISTAT(14)
C             is 1 (18) the time, (19) the largest eigenvalue [1/s] and
C             (20) the step [s].
C     W       (workspace) DOUBLE PRECISION array, dimension (LW).  On
C             entry its first NU entries are the guess of the planned
C             motion's coordinates at T0 where CLO is used.
C     LW      (input) INTEGER, LW >= 2*NU*(R+1) + 24*NX + NV*NX + 2*NV
C             + 8*NU + 10*NQ + 7*NLAM + 3*NLAM*NU + 60, where R = IP(4).
C     OUT, CTL (external) the sampled devices, see GSSMP; called if
C             IP(26) > 0.
C     EVT, RST (external) the events, see GSRES; called if IP(28) > 0.
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Every stop (output time, break or sample) is met exactly, and so
C     is every event; there the integration starts again.  Time is
C     t0 + k*h within each way from stop to stop, never a running sum.
C     A step of method 8 after which X cannot be moved onto the
C     constraints, or only by a jump (more than a tenth of the step's
C     own move and 100 times the tolerance: another branch), is repeated
C     with a quarter of its length.
C     Where the constraints lose rank ahead, before they have turned by
C     1.2 rad (GSAHD), the position is passed by one step of collocation
C     whose stages keep away from it (GSPSG), from an output, a break or
C     a sample in it as well; all output times within it are taken from
C     its polynomial, breaks, samples and the end stop it: the inputs
C     before a break are continued beyond it (GSINC).  Its relative
C     tolerance is no less than 5D3*eps.  Where the position that it
C     finds does not settle, the iteration does not converge or the
C     estimated error is too large, it is tried again with more stages
C     and shorter, from where that length begins.
C     A run of method 8 may start in such a position, by such a step, if
C     its speeds lead out of it (GSPBG, GSPBC).
C     Where that step cannot be had (an error that stays above the
C     tolerance) and close to such a position, and where some
C     constraints are redundant, the stages of a step, which do not lie
C     on the constraints, have accelerations of no use.  Where the
C     constraints at T0 are dependent, and where the least pivot has
C     fallen to a twentieth of its largest value, or to a quarter and a
C     step was rejected, the stages are completed by GSPRT (there until
C     it has risen to a quarter again).
C     Rounding errors of coordinates, speeds and accelerations that are
C     completed grow with the inverse of the least pivot, its square and
C     its cube: below a quarter of its largest value the relative
C     tolerance is no less than eps**(2/3), 3.7D-11, and a step that
C     ends where rounding errors pass it is repeated with 0.7 of its
C     length, five times at most, so that such a place is stepped over.
C
C     ERROR INDICATOR
C     INFO = 0   all output times reached;
C     INFO = -i  argument i is out of range;
C     INFO = 1   more than IOPT(4) steps;
C     INFO = 2   the step became too small (method 8), also where 20000
C                steps one after the other are a ten thousandth of what
C                they were far from a singular position;
C     INFO = 3   a routine failed: see ISTAT(6) and ISTAT(7);
C     INFO = 4   the state is no longer finite;
C     INFO = 5   steps are bound by stability (method 9);
C     INFO = 8   a rate of the states is not finite at the start or behind
C                a stop.
C     In the cases 1 to 5 and 8 the first ISTAT(5) columns of XOUT are
C     valid; where there is another it holds the state at RSTAT(8), and
C     that of VOUT the inputs.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL,
     $                   EVT, RST
      INTEGER            NQ, NU, NX, NV, NLAM, NT, NB, IOPT(*), IP(*),
     $                   LDX, LDV, ISTAT(20), LW, INFO
      DOUBLE PRECISION   T0, X0(*), TOUT(*), TBRK(*), ROPT(*), ATOL(*),
     $                   RP(*), CST(*), XOUT(LDX,*), VOUT(LDV,*),
     $                   RSTAT(20), W(*)
      INTEGER            GSFIN
      EXTERNAL           GSFIN, GSFUN, GSINP, GSRK4, GSDP8, GSHIN,
     $                   GSCHK, GSJMP, GSPNW, GSPST, GSSTD, GSDUE,
     $                   GSEVN, GSEVR
      INTEGER            I, IB, IT, IX, IXN, IV, IC, IK, IO, K, N, SIDE,
     $                   NTRY, NSLOW, EVENT, BEGIN, IER
      LOGICAL            FRESH, AFTER
      DOUBLE PRECISION   TA, TB, T, TN, H, HN, ERR, FAC, HMAX, JOB,
     $                   COARSE, NEAR, JUMP(3), NOJUMP(3), GSEPS, EPS,
     $                   TS, HR, HFAR, TEND, CLOSE, HLIM, TC, D, SKIP,
     $                   SHRINK, EIT, TMIN, GAUSS(3), SMIN, TSEEN,
     $                   DFULL, TURN, TV(3), B(12), C(12), WT(12),
     $                   MOVED
      INTEGER            IQ, ISZ, LOPT(6), NPASS, NS, LOOSE
      EXTERNAL           GSEPS, GSAHD, GSPSG, GSGLN, GSGLQ,
     $                   GSPTH, GSPRD, GSPBG, GSPBC
C
C     -- arguments
      INFO = 0
      IF ( NQ.LT.0 ) INFO = -8
      IF ( NU.LT.0 ) INFO = -9
      IF ( NX.LT.MAX( 1, NQ + NU ) ) INFO = -10
      IF ( NV.LT.0 ) INFO = -11
      IF ( NLAM.LT.0 ) INFO = -12
      IF ( NT.LT.1 ) INFO = -15
      IF ( NB.LT.0 ) INFO = -17
      IF ( LDX.LT.NX ) INFO = -26
      IF ( LDV.LT.MAX( 1, NV ) ) INFO = -28
      I = 2*NU*( IP(4) + 1 ) + 24*NX + NV*NX + 2*NV + 8*NU
     $    + 10*NQ + 7*NLAM + 3*NLAM*NU
      IF ( LW.LT.I + 60 ) INFO = -32
      IF ( INFO.NE.0 ) RETURN
      IF ( .NOT.( ABS( T0 ).LE.1.0D300 ) ) INFO = -13
      IF ( GSFIN( NX, X0 ).NE.0 ) INFO = -14
      IF ( GSFIN( NT, TOUT ).NE.0 ) INFO = -16
      IF ( GSFIN( NB, TBRK ).NE.0 ) INFO = -18
      IF ( IOPT(1).NE.4 .AND. IOPT(1).NE.8 .AND. IOPT(1).NE.9 )
     $   INFO = -19
      IF ( IOPT(2).LT.1 .OR. IOPT(2).GT.6 ) INFO = -19
      IF ( IOPT(1).EQ.4 .AND. .NOT.( ROPT(1).GT.0.0D0 ) ) INFO = -20
      IF ( IOPT(1).GE.8 .AND. .NOT.( ROPT(2).GT.0.0D0 .AND.
     $     ROPT(1).GE.0.0D0 .AND. ROPT(3).GE.0.0D0 ) ) INFO = -20
      IF ( INFO.NE.0 ) RETURN
      IF ( IOPT(1).EQ.4 .AND. ( TOUT(NT) - T0 )/ROPT(1).GT.2.0D9 )
     $   INFO = -20
      IF ( TOUT(1).LT.T0 ) INFO = -16
      DO 10 I = 2, NT
         IF ( TOUT(I).LE.TOUT(I-1) ) INFO = -16
   10 CONTINUE
      DO 20 I = 2, NB
         IF ( TBRK(I).LE.TBRK(I-1) ) INFO = -18
   20 CONTINUE
      IF ( IOPT(1).GE.8 ) THEN
         DO 30 I = 1, NX
            IF ( .NOT.( ATOL(I).GE.0.0D0 ) ) INFO = -21
   30    CONTINUE
      END IF
      IF ( INFO.NE.0 ) RETURN
C
C     -- workspace: inputs, states, constraints, stages
      IX  = 2*NU*( IP(4) + 1 ) + 5*NX + NV*NX + 21
      IXN = IX + NX
      IV  = IXN + NX
      IC  = IV + MAX( 1, 2*NV )
      IK  = IC + 24 + 8*NU + 10*NQ + 7*NLAM + 2*NLAM*NU
      IO  = IK + 13*NX
      IQ  = IO + 3*NX
      EPS = GSEPS()
      COARSE = EPS**( 2.0D0/3.0D0 )
      CLOSE  = 0.25D0*( EPS/MAX( ROPT(2), COARSE ) )**( 1.0D0/3.0D0 )
      DO 40 I = 1, 20
         ISTAT(I) = 0
         RSTAT(I) = 0.0D0
   40 CONTINUE
      RSTAT(14) = 1.0D0
      W(NU*( IP(4) + 1 )+2) = 0.0D0
      CALL GSPST( NQ, NU, NLAM, IOPT, W(IC) )
      JOB = W(IC)
      NEAR = 0.05D0
      NOJUMP(1) = 0.0D0
      NOJUMP(2) = 0.0D0
      NOJUMP(3) = 0.0D0
      NTRY = 0
      HFAR = 0.0D0
      NSLOW = 0
      SKIP   = -1.0D300
      TSEEN  = -1.0D300
      SHRINK = 1.0D0
      TURN   = 0.0D0
      NS     = 8
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
      AFTER = .FALSE.
      HMAX  = TOUT(NT) - T0
      IF ( ROPT(3).GT.0.0D0 ) HMAX = MIN( HMAX, ROPT(3) )
      RSTAT(6) = HMAX
C     (completed from others it would be moved close to such a position)
      W(IC) = 0.0D0
      CALL GSCHK( PRJ, CON, KIN, T, W(IX), NQ, NU, NX, NLAM, IOPT,
     $            NOJUMP, CST, W(IC), ISTAT, RSTAT, IER )
      W(IC) = JOB
      IF ( IER.NE.0 ) GO TO 903
      CALL GSINP( CMD, CLO, VIN, T, 1, W(IX), NU, NX, NV, IP, RP, CST,
     $            W(IV), W, IER )
      ISTAT(6) = IER
      ISTAT(7) = 1
      IF ( IER.NE.0 ) GO TO 903
      ISTAT(7) = 0
      CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, W(IX), NU, NX, NV, IP, RP,
     $            CST, W(IV), W, ISTAT, 0, IER )
      IF ( IER.NE.0 ) GO TO 903
      CALL GSDUE( OUT, CTL, CMD, CLO, VIN, T, W(IX), NU, NX, NV, IP, RP,
     $            CST, W(IV), W, ISTAT, TS, I, IER )
      IF ( IER.NE.0 ) GO TO 903
C
C     -- a start in a singular position? by its speeds, or at rest
      BEGIN = 0
      IF ( NLAM.EQ.0 .OR. IOPT(5).NE.1 .OR. IOPT(2).EQ.1 ) GO TO 90
      DO 60 I = 1, NX
         W(IK+I-1) = 0.0D0
   60 CONTINUE
      CALL GSPBG( CON, KIN, T, W(IX), HMAX, NQ, NU, NLAM, CST, W(IK),
     $            W(IXN), W(IO), W(IQ), W(IK+NX), W(IC), BEGIN )
      IF ( BEGIN.LT.0 ) THEN
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, W(IX), NQ, NU,
     $               NX, NV, NLAM, IP, RP, CST, W(IV), W(IK), W, W(IC),
     $               ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         CALL GSPBG( CON, KIN, T, W(IX), HMAX, NQ, NU, NLAM, CST, W(IK),
     $               W(IXN), W(IO), W(IQ), W(IK+NX), W(IC), BEGIN )
         BEGIN = MAX( 0, BEGIN )
      END IF
      IF ( BEGIN.EQ.2 .OR. ( BEGIN.EQ.1 .AND. IOPT(1).EQ.4 ) )
     $   GO TO 906
C
C     -- dependent constraints: see METHOD
      IF ( JOB.LT.2.0D0 .AND. W(IC+2).LT.DBLE( NLAM ) ) THEN
         JOB   = 2.0D0
         W(IC) = JOB
      END IF
   90 IF ( JOB.GT.0.0D0 .AND. BEGIN.EQ.0 ) THEN
         CALL GSPNW( CON, KIN, T, W(IX), NQ, NU, NLAM, CST, W(IC), IER )
         ISTAT(6) = IER
         ISTAT(7) = 4
         IF ( IER.NE.0 ) GO TO 903
         ISTAT(7) = 0
      END IF
C
C     -- the next stop, TB; SIDE < 0 where it is a break or a sample
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
            AFTER = .FALSE.
            GO TO 130
         END IF
      END IF
C
C     -- samples; TS is the time of the next ones
      CALL GSDUE( OUT, CTL, CMD, CLO, VIN, T, W(IX), NU, NX, NV, IP, RP,
     $            CST, W(IV), W, ISTAT, TS, I, IER )
      IF ( IER.NE.0 ) GO TO 903
      IF ( I.EQ.1 ) THEN
         FRESH = .TRUE.
         AFTER = .FALSE.
      END IF
      CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, W(IX), NU, NX, NV, IP, RP,
     $            CST, W(IV), W, ISTAT, -1, IER )
      IF ( IER.NE.0 ) GO TO 903
C
      TA = T
      TB = TOUT(IT)
      SIDE = 1
      IF ( IB.LE.NB ) THEN
         IF ( TBRK(IB).LE.TB ) SIDE = -1
         TB = MIN( TB, TBRK(IB) )
      END IF
      IF ( TS.LE.TB + 8.0D0*EPS*ABS( TB ) ) THEN
         SIDE = -1
         IF ( TS.LT.TB - 8.0D0*EPS*ABS( TB ) ) TB = TS
      END IF
      TEND = MIN( TOUT(NT), TS )
      IF ( IB.LE.NB ) TEND = MIN( TEND, TBRK(IB) )
      EVENT = 0
      IF ( IOPT(1).GE.8 ) GO TO 300
C
C     -- classical Runge-Kutta, N equal steps of at most HR
      HR = ROPT(1)
  200 CONTINUE
      N = MAX( 1, INT( ( TB - TA )/HR*( 1.0D0 - 1.0D-9 ) ) + 1 )
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
         CALL GSSTD( RHS, CON, KIN, CMD, CLO, VIN, IOPT(1), T, H, W(IX),
     $               NQ, NU, NX, NV, NLAM, IP, RP, CST, W(IV), ROPT(2),
     $               ATOL, W(IK), W, W(IC), ISTAT, RSTAT )
         CALL GSRK4( RHS, CON, KIN, CMD, CLO, VIN, T, TN, I, H, W(IX),
     $               NQ, NU, NX, NV, NLAM, IP, RP, CST, W(IV), W(IXN),
     $               W(IK), W, W(IC), ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         IF ( IP(28).GT.0 ) THEN
            CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, IOPT(1),
     $                  IOPT(2), T, TN, I, H, W(IX), NQ, NU, NX, NV,
     $                  NLAM, IP, RP, CST, W(IV), ROPT(2), ATOL, W(IXN),
     $                  W(IK), W, W(IC), ISTAT, RSTAT, IP(IP(28)),
     $                  RP(IP(29)), GAUSS, EVENT, IER )
            IF ( IER.NE.0 ) GO TO 903
            IF ( EVENT.LT.0 ) THEN
               TA = T
               HR = 0.1D0*H
               GO TO 200
            END IF
         END IF
         I   = IX
         IX  = IXN
         IXN = I
         RSTAT(8) = TN
         IF ( GSFIN( NX, W(IX) ).NE.0 ) THEN
            IX = IXN
            GO TO 904
         END IF
         ISTAT(2) = ISTAT(2) + 1
         CALL GSCHK( PRJ, CON, KIN, TN, W(IX), NQ, NU, NX, NLAM, IOPT,
     $               NOJUMP, CST, W(IC), ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         IF ( EVENT.GT.0 ) CALL GSEVR( CMD, CLO, VIN, EVT, RST, TN,
     $      W(IX), NU, NX, NV, IP, RP, CST, W(IV), W, ISTAT, EVENT, IER
     $      )
         IF ( IER.NE.0 ) GO TO 903
         IF ( TN.LT.TB .AND. ( EVENT.GT.0 .OR. HR.LT.ROPT(1) ) ) THEN
            TA = TN
            HR = ROPT(1)
            GO TO 200
         END IF
  210 CONTINUE
      T = TB
      GO TO 400
C
C     -- Dormand-Prince 8(5,3)
  300 CONTINUE
      IF ( FRESH ) THEN
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, W(IX), NQ, NU,
     $               NX, NV, NLAM, IP, RP, CST, W(IV), W(IK), W, W(IC),
     $               ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) GO TO 903
         IF ( GSFIN( NX, W(IK) ).NE.0 ) GO TO 908
         FRESH = .FALSE.
         IF ( AFTER ) THEN
            CALL GSSTD( RHS, CON, KIN, CMD, CLO, VIN, IOPT(1), T, H,
     $                  W(IX), NQ, NU, NX, NV, NLAM, IP, RP, CST, W(IV),
     $                  ROPT(2), ATOL, W(IK), W, W(IC), ISTAT, RSTAT )
            IF ( ISTAT(14).GT.0 .AND. IOPT(1).EQ.9 ) GO TO 905
         END IF
         IF ( HN.LE.0.0D0 ) THEN
            CALL GSHIN( RHS, CON, KIN, CMD, CLO, VIN, T,
     $                  MIN( HMAX, TB - T ), W(IX), NQ, NU, NX, NV,
     $                  NLAM, IP, RP, CST, W(IV), ROPT(2), ATOL, W(IK),
     $                  W, W(IC), ISTAT, RSTAT, HN, IER )
            IF ( IER.NE.0 ) GO TO 903
         END IF
      END IF
C
C     -- a singular position ahead?
      HLIM = 1.0D300
      IF ( NLAM.EQ.0 .OR. IOPT(5).NE.1 .OR. IOPT(2).EQ.1 .OR.
     $     T.LT.SKIP ) GO TO 309
      H = MIN( HN, HMAX )
      I = 0
      IF ( W(IC+3).LT.3.0D0 .OR. H.GT.0.25D0*TURN .OR.
     $     W(IC+12).LT.0.25D0*W(IC+13) ) I = 1
      IF ( W(IC+9).LT.W(IC+7) .AND. W(IC+9)*( W(IC+8) - W(IC+6) ).LT.
     $     MAX( 3.0D0*H, TURN )*( W(IC+7) - W(IC+9) ) ) I = 1
      IF ( I.EQ.0 ) GO TO 309
      HLIM = H
      CALL GSAHD( CON, KIN, T, W(IX), HLIM, NQ, NU, NX, NS, NLAM, CST,
     $            W(IK), W(IXN), W(IQ), W(IC), TC, D, TURN )
      IF ( .NOT.( D.GT.0.0D0 .AND. T.LE.TC + 0.5D0*D ) ) GO TO 309
      DFULL = SHRINK*D
      D     = DFULL
      IF ( T.LT.TC - 0.5D0*D ) D = MIN( D, TC - T )
      NPASS = 0
      MOVED = 1.0D300
  301 IF ( T.GT.TC + 0.5D0*D .OR. NPASS.GT.12 ) GO TO 309
      IF ( T.LT.TC - 1.05D0*D ) THEN
         HLIM = MIN( HLIM, TC - D - T )
         GO TO 309
      END IF
      D = MAX( D, TC - T )
      NPASS = NPASS + 1
C
C     -- the partition that holds at the far end
      W(IC)   = 2.0D0
      W(IC+1) = -1.0D0
      IF ( ABS( T - TC ).GT.0.6D0*D ) THEN
         CALL GSPNW( CON, KIN, T, W(IX), NQ, NU, NLAM, CST, W(IC), IER )
      ELSE
         TMIN = TC + SIGN( D, TC - T )
         CALL GSPRD( KIN, T, W(IX), TC, D, NQ, NX, NS, CST, W(IK),
     $         W(IXN) )
         CALL GSGLN( NS, C, WT )
         CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TMIN - TC )/D, B )
         CALL GSPTH( NX, NS, NX, W(IX), D, B, W(IK), W(IXN) )
         ISZ = IC + 14 + 2*NU + NQ
         DO 305 I = 1, NLAM
            W(IQ+I-1) = W(ISZ+I-1)
  305    CONTINUE
         CALL GSPNW( CON, KIN, TMIN, W(IXN), NQ, NU, NLAM, CST, W(IC),
     $               IER )
C        lengths of rows are those of states that the motion had
         DO 306 I = 1, NLAM
            W(ISZ+I-1) = W(IQ+I-1)
  306    CONTINUE
      END IF
      TV(1) = T0
      TV(2) = TOUT(NT)
      IF ( IB.GT.1 ) TV(1) = TBRK(IB-1)
      IF ( IB.LE.NB ) TV(2) = TBRK(IB)
      TV(3) = 0.0D0
      IF ( MAX( TV(1) - TC, TC - TV(2) ) + D.GT.TV(2) - TV(1) )
     $   TV(3) = TV(2) - TV(1)
      CALL GSPSG( RHS, CON, KIN, CMD, CLO, VIN, T, W(IX), TC, D, TV, NQ,
     $      NU, NX, NS, NV, NLAM, IP, RP, CST, W(IV), ROPT(2), ATOL,
     $      W(IK), W(IXN), W(IO), W, W(IC), ISTAT, RSTAT, ERR, EIT,
     $      TMIN, SMIN, IER )
      W(IC)   = JOB
      W(IC+1) = -1.0D0
      IF ( IER.EQ.1 .AND. ABS( TMIN - TC ).LT.0.7D0*MOVED ) THEN
         MOVED = ABS( TMIN - TC )
         TC = TMIN
         IF ( T.LT.TC - D .AND. T.GT.TC - 1.4D0*D ) D = TC - T
         GO TO 301
      END IF
      MOVED = 1.0D300
C
C     -- where the rank is kept after all the usual steps do better
      IF ( IER.EQ.0 .AND. SMIN.GT.1.0D-3*W(IC+13) ) THEN
         SKIP   = TC + D
         SHRINK = 1.0D0
         GO TO 309
      END IF
      FAC = 0.5D0
      IF ( IER.EQ.0 )
     $   FAC = 0.9D0*MAX( ERR, 1.0D-8 )**( -1.0D0/DBLE( NS + 1 ) )
      IF ( IER.EQ.0 .AND. ( ERR.LE.1.0D0 .OR. ERR.LE.3.0D0*EIT .OR.
     $     ( SHRINK.LT.0.15D0 .AND. ERR.LE.1.0D4 ) ) ) GO TO 302
      IF ( SHRINK.LT.0.02D0 ) THEN
         SKIP   = TC + D
         SHRINK = 1.0D0
         GO TO 309
      END IF
      IF ( NS.EQ.8 .AND. FAC.LT.0.8D0 ) THEN
         NS = 12
         GO TO 301
      END IF
      FAC    = MAX( 0.25D0, FAC )
      SHRINK = FAC*SHRINK*MIN( 1.0D0, D/DFULL )
      D      = FAC*D
      GO TO 301
C
C     -- to its end or to the next break, sample or end of the run
  302 SHRINK = MIN( 1.0D0, SHRINK*MIN( 1.5D0, MAX( 1.0D0, FAC ) ) )
      IF ( BEGIN.NE.0 ) THEN
C        are the speeds those of a motion that leads out of it?
         CALL GSPBC( KIN, T, W(IX), TC, D, NQ, NX, NS, CST, W(IK),
     $               W(IXN), H )
         IF ( H.GT.1.0D-6 + 1.0D2*ROPT(2) ) THEN
            BEGIN = 4 - MAX( 0, BEGIN )
            GO TO 906
         END IF
      END IF
      TN = TC + D
      CALL GSGLN( NS, C, WT )
      I = 0
      IF ( TEND.LE.TN ) THEN
         TN = TEND
         I  = 1
      END IF
      IF ( TN.LE.T + 0.01D0*D .AND. I.EQ.0 ) THEN
         SKIP = T + D
         GO TO 309
      END IF
      GAUSS(1) = TC
      GAUSS(2) = D
      GAUSS(3) = DBLE( NS )
      EVENT = 0
  307 CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TN - TC )/D, B )
      CALL GSPTH( NX, NS, NX, W(IX), D, B, W(IK), W(IXN) )
      IF ( IP(28).GT.0 ) THEN
         K = 1
         IF ( I.EQ.1 ) K = -1
         H  = TN - T
         CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, 12,
     $               IOPT(2), T, TN, K, H, W(IX), NQ, NU, NX, NV, NLAM,
     $               IP, RP, CST, W(IV), ROPT(2), ATOL, W(IXN), W(IK),
     $               W, W(IC), ISTAT, RSTAT, IP(IP(28)), RP(IP(29)),
     $               GAUSS, EVENT, IER )
         IF ( IER.NE.0 ) GO TO 903
         IF ( EVENT.NE.0 ) I = 0
         IF ( EVENT.LT.0 ) THEN
            TN = T + 0.1D0*H
            GO TO 307
         END IF
      END IF
      DO 303 K = 1, 6
         LOPT(K) = IOPT(K)
  303 CONTINUE
      W(IC+3) = 0.0D0
      IF ( TN.LT.TC + 0.6D0*D ) THEN
         LOPT(2) = 1
         W(IC)   = 0.0D0
      END IF
      CALL GSCHK( PRJ, CON, KIN, TN, W(IXN), NQ, NU, NX, NLAM, LOPT,
     $            NOJUMP, CST, W(IC), ISTAT, RSTAT, IER )
      W(IC)   = JOB
      W(IC+1) = -1.0D0
      IF ( IER.NE.0 .AND. SHRINK.GT.0.15D0 ) THEN
         SHRINK = 0.25D0*SHRINK
         D      = 0.25D0*D
         GO TO 301
      ELSE IF ( IER.NE.0 ) THEN
         SKIP = TC + D
         GO TO 309
      END IF
      BEGIN = -MIN( 1, EVENT )
  304 IF ( TOUT(IT).LT.TN ) THEN
         CALL GSGLQ( NS, C, WT, ( T - TC )/D, ( TOUT(IT) - TC )/D, B )
         CALL GSPTH( NX, NS, NX, W(IX), D, B, W(IK), XOUT(1,IT) )
         CALL GSINP( CMD, CLO, VIN, TOUT(IT), 1, XOUT(1,IT), NU, NX, NV,
     $               IP, RP, CST, VOUT(1,IT), W, ISTAT(6) )
         ISTAT(7) = 1
         IF ( ISTAT(6).NE.0 ) GO TO 903
         ISTAT(5) = IT
         IT = IT + 1
         GO TO 304
      END IF
      TB   = TN
      SIDE = 1
      IF ( I.EQ.1 ) THEN
         IF ( IB.LE.NB ) THEN
            IF ( TBRK(IB).LE.TN ) SIDE = -1
         END IF
         IF ( TS.LE.TN ) SIDE = -1
      END IF
      IF ( SMIN.LT.0.01D0*W(IC+13) .AND. TMIN.GE.T .AND. TMIN.LE.TN
     $     .AND. TMIN.GT.TSEEN ) THEN
         ISTAT(11) = ISTAT(11) + 1
         IF ( ISTAT(11).EQ.1 ) RSTAT(16) = TMIN
         RSTAT(17) = TMIN
         TSEEN = TMIN + 0.1D0*D
      END IF
      IF ( TN.GE.TC + D ) SKIP = TC + D
      IF ( MAX( ERR, EIT ).GT.1.0D0 ) ISTAT(20) = ISTAT(20) + 1
      H = TN - T
      I   = IX
      IX  = IXN
      IXN = I
      T   = TN
      RSTAT(7) = MAX( RSTAT(7), H )
      RSTAT(8) = T
      ISTAT(2) = ISTAT(2) + 1
      ISTAT(6) = 0
      ISTAT(7) = 0
      FRESH = .TRUE.
      AFTER = .FALSE.
      IF ( EVENT.GT.0 ) CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, W(IX),
     $   NU, NX, NV, IP, RP, CST, W(IV), W, ISTAT, EVENT, IER )
      IF ( IER.NE.0 ) GO TO 903
      GO TO 400
C
  309 IF ( BEGIN.GT.0 ) THEN
         BEGIN = 3
         GO TO 906
      END IF
      H  = MIN( HN, HMAX, HLIM )
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
      IF ( NLAM.GT.0 .AND. IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND.
     $     W(IC).LT.2.0D0 .AND. W(IC+12).LT.NEAR*W(IC+13) ) THEN
         W(IC)   = 2.0D0
         W(IC+1) = -1.0D0
      END IF
      IF ( W(IC).GT.0.0D0 .AND. W(IC+1).LT.0.0D0 ) THEN
         ISTAT(10) = ISTAT(10) + 1
         CALL GSPNW( CON, KIN, T, W(IX), NQ, NU, NLAM, CST, W(IC), IER )
         ISTAT(6) = IER
         ISTAT(7) = 4
         IF ( IER.NE.0 ) GO TO 903
         ISTAT(7) = 0
      END IF
      IF ( IOPT(4).GT.0 .AND. ISTAT(2) + ISTAT(3).GE.IOPT(4) ) GO TO 901
      IF ( H.LE.16.0D0*EPS*MAX( ABS( T ), ABS( TB ) ) .AND. TN.LT.TB )
     $   GO TO 902
      NSLOW = NSLOW + 1
      IF ( IOPT(5).NE.1 .OR. H.GT.1.0D-4*HFAR .OR.
     $     W(IC+12).GE.0.25D0*W(IC+13) ) NSLOW = 0
      IF ( NSLOW.GT.20000 ) GO TO 902
      CALL GSDP8( RHS, CON, KIN, CMD, CLO, VIN, T, TN, I, H, W(IX), NQ,
     $            NU, NX, NV, NLAM, IP, RP, CST, W(IV), ROPT(2), ATOL,
     $            W(IXN), ERR, W(IK), W, W(IC), ISTAT, RSTAT, IER )
      FAC = ERR
      IF ( IOPT(5).EQ.1 .AND. W(IC+12).LT.0.25D0*W(IC+13) )
     $   ERR = ERR*ROPT(2)/MAX( ROPT(2), COARSE )
      LOOSE = 0
      IF ( FAC.GT.1.0D0 .AND. ERR.LE.1.0D0 ) LOOSE = 1
C
C     -- up to an event, if there is one within a good step
      EVENT = 0
      IF ( IP(28).GT.0 .AND. IER.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, IOPT(1),
     $               IOPT(2), T, TN, I, H, W(IX), NQ, NU, NX, NV, NLAM,
     $               IP, RP, CST, W(IV), ROPT(2), ATOL, W(IXN), W(IK),
     $               W, W(IC), ISTAT, RSTAT, IP(IP(28)), RP(IP(29)),
     $               GAUSS, EVENT, IER )
         IF ( EVENT.LT.0 ) ERR = 1.0D10
      END IF
C
C     -- a good step: onto the constraints with it
      IF ( IER.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         CALL GSJMP( NQ, NU, W(IX), W(IXN), ROPT(2), ATOL, JUMP )
         JUMP(3) = 0.0D0
         IF ( IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND. NTRY.LT.5 .AND.
     $        TN.LT.TB ) JUMP(3) = CLOSE
         CALL GSCHK( PRJ, CON, KIN, TN, W(IXN), NQ, NU, NX, NLAM, IOPT,
     $               JUMP, CST, W(IC), ISTAT, RSTAT, IER )
         IF ( IER.NE.0 ) ISTAT(12) = ISTAT(12) + 1
      END IF
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
         ISTAT(20) = ISTAT(20) + LOOSE
         BEGIN = -MIN( 1, EVENT )
         FRESH = .TRUE.
         AFTER = .TRUE.
         NEAR  = 0.05D0
         NTRY  = 0
         IF ( W(IC+12).GE.0.25D0*W(IC+13) ) HFAR = HN
         IF ( W(IC).GT.JOB .AND. W(IC+12).GE.0.25D0*W(IC+13) ) THEN
            W(IC)   = JOB
            W(IC+1) = -1.0D0
         END IF
         IF ( EVENT.GT.0 ) THEN
            AFTER = .FALSE.
            CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, W(IX), NU, NX, NV,
     $                  IP, RP, CST, W(IV), W, ISTAT, EVENT, IER )
            IF ( IER.NE.0 ) GO TO 903
         END IF
         IF ( T.LT.TB ) GO TO 300
      ELSE
         ISTAT(3) = ISTAT(3) + 1
         FAC = 0.25D0
         IF ( IER.EQ.0 .AND. ERR.LE.1.0D300 )
     $      FAC = MIN( 0.9D0, MAX( 0.2D0, 0.9D0*ERR**(-0.125D0) ) )
         HN = H*FAC
         IF ( IER.NE.0 .AND.
     $        HN.LE.1.0D3*EPS*MAX( ABS( T ), ABS( TB ) ) ) GO TO 903
         IF ( IER.NE.0 ) W(IC+1) = -1.0D0
         IF ( IER.EQ.4 .AND. ISTAT(7).EQ.3 ) THEN
            HN   = 0.7D0*H
            NTRY = NTRY + 1
         END IF
         NEAR = 0.25D0
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
      GO TO 909
  902 INFO = 2
      GO TO 909
  903 INFO = 3
      GO TO 909
  904 INFO = 4
      GO TO 909
  906 INFO = 3
      ISTAT(6) = BEGIN
      ISTAT(7) = 8
      GO TO 909
  905 INFO = 5
      GO TO 909
  908 INFO = 8
  909 IF ( ISTAT(5).GE.NT ) RETURN
      DO 910 I = 1, NX
         XOUT(I,ISTAT(5)+1) = W(IX+I-1)
  910 CONTINUE
      DO 920 I = 1, NV
         VOUT(I,ISTAT(5)+1) = W(IV+I-1)
  920 CONTINUE
      END
      SUBROUTINE GSJMP( NQ, NU, X, XN, RTOL, ATOL, JUMP )
C
C     PURPOSE
C     How far a coordinate, JUMP(1), and a speed, JUMP(2), may be moved
C     after the step from X to XN, so that it is no jump: a tenth of the
C     step's own move, or 100 times the tolerance of the largest, or
C     what rounding does to it close to a singular position (its root).
C
      IMPLICIT NONE
      INTEGER            NQ, NU
      DOUBLE PRECISION   X(*), XN(*), RTOL, ATOL(*), JUMP(2)
      DOUBLE PRECISION   GSEPS, ROOT
      EXTERNAL           GSEPS
      INTEGER            I, K
C
      ROOT    = 10.0D0*SQRT( GSEPS() )
      JUMP(1) = ROOT
      JUMP(2) = 0.0D0
      DO 10 I = 1, NQ + NU
         K = 1
         IF ( I.GT.NQ ) K = 2
         JUMP(K) = MAX( JUMP(K), 0.1D0*ABS( XN(I) - X(I) ),
     $             1.0D2*( ATOL(I) + RTOL*ABS( X(I) ) ),
     $             ROOT*ABS( X(I) ) )
   10 CONTINUE
      END
