      SUBROUTINE GSSIM( RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL,
     $                  EVT, RST, SIZ, TIM, X0, IOPT, ROPT, IP, RP, CST,
     $                  XOUT, VOUT, ISTAT, RSTAT, W, INFO )
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
C     OUT, CTL (external) the sampled devices, see GSSMP; called if
C             IP(26) > 0.
C     EVT, RST (external) the events, see GSRES; called if IP(28) > 0.
C     SIZ     (input) INTEGER array, dimension (8): the numbers of
C             (1) coordinates NQ and (2) speeds NU: X begins with the
C                 coordinates, then the speeds;
C             (3) states, NX >= NQ + NU;
C             (4) inputs NV;
C             (5) constraints NLAM;
C             (6) output times, NT >= 1;
C             (7) breaks NB;
C             (8) places of W, LW >= 2*NU*(R+1) + 24*NX + NV*NX + 2*NV +
C                 8*NU + 10*NQ + 7*NLAM + 3*NLAM*NU + 60, R = IP(4).
C     TIM     (input) DOUBLE PRECISION array, dimension (1+NT+NB):
C             the initial time T0 [s];
C             the output times TOUT, rising, TOUT(1) >= T0;
C             the breaks TBRK, rising: times at which the inputs may
C             jump or the scene switches (SWI).  The integration stops there, with the limits from
C             the left, and starts again with the limits from the right.
C     X0      (input) DOUBLE PRECISION array, dimension (NX).
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
C     ROPT    (input) DOUBLE PRECISION array, dimension (3+NX):
C             (1) step [s].  Method 4: the largest step; the way to each
C                 stop (output time or break) is cut into equal steps.
C                 Method 8: the first step, or 0 for an automatic one;
C             (2) method 8: relative tolerance;
C             (3) the largest step [s], or 0 for none;
C             (4) to (3+NX) method 8: absolute tolerances ATOL, in the
C                 units of the states.
C     IP, RP  (input/output) the inputs and the plans of the samples and
C             of the events, see GSINP, GSSMP and GSRES: next samples,
C             held outputs, memories and modes go on.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     XOUT    (output) DOUBLE PRECISION array, dimension (NX,NT): the
C             states, a column for every output time.
C     VOUT    (output) DOUBLE PRECISION array, dimension (MAX(1,NV),NT):
C             the inputs (the limit from the left, but at T0).
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
C             (18) memory of GSSTD; (19) where (7) is 7 the event that
C             failed, 0: none did; (20) steps close to
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
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Every stop (break, sample, the last output time; method 4: every
C     output time) is met exactly, and so is every event; there the
C     integration starts again.  Time is t0 + k*h within each way from
C     stop to stop, never a running sum.  With method 8 the output times
C     between are no stops: the states there come from the polynomial of
C     order 7 of the step around them (GSDPO), for three calls of RHS
C     more in such a step, and are moved onto the constraints as the end
C     of the step is; a step where that cannot be is repeated, shorter.
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
C     INFO = -i  argument i is out of range; -100-k: SIZ(k) is;
C     INFO = 1   more than IOPT(4) steps;
C     INFO = 2   the step became too small (method 8), also where 20000
C                steps one after the other are a ten thousandth of what
C                they were far from a singular position;
C     INFO = 3   a routine failed: see ISTAT(6) and ISTAT(7);
C     INFO = 4   the state is no longer finite;
C     INFO = 5   steps are bound by stability (method 9);
C     INFO = 8   a rate of the states is not finite at the start, behind
C                a stop, or behind RSTAT(8) (method 8: no step from
C                there, however short, ends in finite numbers).
C     INFO = 11  an event of the user has ended the run, at RSTAT(8).
C     In the cases 1 to 5, 8 and 11 the first ISTAT(5) columns of XOUT are
C     valid; where there is another it holds the state at RSTAT(8), and
C     that of VOUT the inputs.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL,
     $                   EVT, RST
      INTEGER            SIZ(8), IOPT(*), IP(*), ISTAT(20), INFO
      DOUBLE PRECISION   TIM(*), X0(*), ROPT(*), RP(*), CST(*), XOUT(*),
     $                   VOUT(*), RSTAT(20), W(*)
      EXTERNAL           GSARG, GSINI, GSBGN, GSSTO, GSRKS, GSDPS, GSINP
      DOUBLE PRECISION   T, STP(3), HMAX, M(11)
      INTEGER            NQ, NU, NX, NV, NLAM, NT, I, ISTP(3), ACTED,
     $                   LM(6), IW(7), IV, IC
C
      CALL GSARG( SIZ, TIM, X0, IOPT, ROPT, IP(4), INFO )
      IF ( INFO.NE.0 ) RETURN
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      NT   = SIZ(6)
      CALL GSINI( TIM(1), X0, TIM(NT+1), NQ, NU, NX, NV, NLAM, IOPT,
     $            ROPT, IP(4), IW, W, M, LM, HMAX, ISTAT, RSTAT )
      IV = IW(3)
      IC = IW(4)
      T  = TIM(1)
      ISTP(2) = 1
      ISTP(3) = 1
      CALL GSBGN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL, EVT, RST,
     $            T, W(IW(1)), HMAX, NQ, NU, NX, NV, NLAM, IOPT, IP, RP,
     $            CST, W(IV), W(IW(5)), W(IW(2)), W(IW(6)), W(IW(7)), W,
     $            W(IC), M(5), LM(6), ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) GO TO 20
C
C     -- from stop to stop
   10 RSTAT(8) = T
      CALL GSSTO( OUT, CTL, CMD, CLO, VIN, EVT, RST, IOPT(1), T,
     $            W(IW(1)), SIZ, TIM, IP, RP, CST, W(IV), W, XOUT, VOUT,
     $            STP, ISTP, ACTED, ISTAT, INFO )
      IF ( INFO.NE.0 ) GO TO 20
      IF ( ISTP(2).GT.NT ) RETURN
      IF ( ACTED.EQ.1 ) THEN
         LM(1) = 1
         LM(2) = 0
      END IF
      IF ( IOPT(1).EQ.4 ) THEN
         CALL GSRKS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $               STP(1), ISTP(1), SIZ, IOPT, ROPT, IP, RP, CST, IW,
     $               W, ISTAT, RSTAT, INFO )
      ELSE
         CALL GSDPS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $               STP, ISTP, HMAX, SIZ, TIM, IOPT, ROPT, IP, RP, CST,
     $               XOUT, VOUT, M, LM, IW, W, ISTAT, RSTAT, INFO )
      END IF
      IF ( INFO.NE.0 ) GO TO 20
C
C     -- the inputs at the stop, from the left, for the record
      CALL GSINP( CMD, CLO, VIN, T, ISTP(1), W(IW(1)), NU, NX, NV, IP,
     $            RP, CST, W(IV), W, I )
      IF ( I.EQ.0 ) GO TO 10
      INFO = 3
      ISTAT(6) = I
      ISTAT(7) = 1
C
C     -- it failed: where it came to
   20 IF ( ISTAT(5).GE.NT ) RETURN
      DO 30 I = 1, NX
         XOUT(NX*ISTAT(5)+I) = W(IW(1)+I-1)
   30 CONTINUE
      DO 40 I = 1, NV
         VOUT(NV*ISTAT(5)+I) = W(IV+I-1)
   40 CONTINUE
      END
      SUBROUTINE GSINI( T0, X0, TLAST, NQ, NU, NX, NV, NLAM, IOPT, ROPT,
     $                  R, IW, W, M, LM, HMAX, ISTAT, RSTAT )
C
C     PURPOSE
C     The workspace of a run: places in it, the state, the partition,
C     the memory of GSDPS; statistics are zero.
C
C     ARGUMENTS
C     As GSSIM and GSDPS, and
C     TLAST   (input) DOUBLE PRECISION, the last output time [s].
C     R       (input) INTEGER, IP(4).
C     HMAX    (output) DOUBLE PRECISION, the largest step [s].
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NX, NV, NLAM, IOPT(*), R, IW(7), LM(6),
     $                   ISTAT(20)
      DOUBLE PRECISION   T0, X0(*), TLAST, ROPT(*), W(*), M(11), HMAX,
     $                   RSTAT(20)
      DOUBLE PRECISION   GSEPS, EPS
      EXTERNAL           GSEPS, GSPST
      INTEGER            I
C
C     -- inputs, states, constraints, stages
      IW(1) = 2*NU*( R + 1 ) + 5*NX + NV*NX + 21
      IW(2) = IW(1) + NX
      IW(3) = IW(2) + NX
      IW(4) = IW(3) + MAX( 1, 2*NV )
      IW(5) = IW(4) + 24 + 8*NU + 10*NQ + 7*NLAM + 2*NLAM*NU
      IW(6) = IW(5) + 13*NX
      IW(7) = IW(6) + 3*NX
      DO 10 I = 1, 20
         ISTAT(I) = 0
         RSTAT(I) = 0.0D0
   10 CONTINUE
      RSTAT(14) = 1.0D0
      W(NU*( R + 1 )+2) = 0.0D0
      DO 20 I = 1, NX
         W(IW(1)+I-1) = X0(I)
   20 CONTINUE
      CALL GSPST( NQ, NU, NLAM, IOPT, W(IW(4)) )
      HMAX = TLAST - T0
      IF ( ROPT(3).GT.0.0D0 ) HMAX = MIN( HMAX, ROPT(3) )
      RSTAT(6) = HMAX
C
C     -- memory: steps, then passages
      EPS   = GSEPS()
      M(1)  = ROPT(1)
      M(2)  = 0.0D0
      M(3)  = 0.05D0
      M(4)  = 0.0D0
      M(5)  = W(IW(4))
      M(6)  = EPS**( 2.0D0/3.0D0 )
      M(7)  = 0.25D0*( EPS/MAX( ROPT(2), M(6) ) )**( 1.0D0/3.0D0 )
      M(8)  = -1.0D300
      M(9)  = -1.0D300
      M(10) = 1.0D0
      M(11) = 0.0D0
      LM(1) = 1
      LM(2) = 0
      LM(3) = 0
      LM(4) = 0
      LM(5) = 8
      LM(6) = 0
      END
