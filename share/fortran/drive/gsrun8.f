      SUBROUTINE GSRUN8( RHS, PRJ, INP, SIZ, CST, NB, TB, NT, TOUT, X,
     $                   RTOL, ATOL, MOST, T, XOUT, W, ISTAT, INFO )
C
C     PURPOSE
C     A run of a scene in a program of Fortran alone: the method of
C     Dormand and Prince of order 8 with steps of controlled error.
C
C     ARGUMENTS
C     RHS     (external) <NAME>_RHS of the scene.
C     PRJ     (external) <NAME>_PRJ; GSNON where the scene has none.
C     INP     (external) SUBROUTINE INP( T, X, V ), which sets the inputs
C             V at the time T [s], with the states X; GSNON where the
C             scene has no inputs.  Where V jumps at a time, that is
C             one of TB, and INP is called just before it and at it.
C     SIZ     (input) INTEGER array, dimension (12), from <NAME>_SIZ
C             (request sizes): NQ = SIZ(1), NU = SIZ(2), NX = SIZ(3),
C             NV = SIZ(4).
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     NB      (input) INTEGER, the number of times in TB.
C     TB      (input) DOUBLE PRECISION array, dimension (NB): times at
C             which steps end, in any order: those of <NAME>_SWI, and
C             those at which the inputs jump [s].
C     NT      (input) INTEGER, the number of output times, at least 1.
C     TOUT    (input) DOUBLE PRECISION array, dimension (NT): the start,
C             output times, the end, ascending [s].
C     X       (input/output) DOUBLE PRECISION array, dimension (NX), the
C             state: on entry that at TOUT(1), on the constraints to 1D-6
C             of its largest entry or of 1 (call PRJ), on exit that at T.
C     RTOL    (input) DOUBLE PRECISION, relative tolerance, above 0 and
C             below 1.
C     ATOL    (input) DOUBLE PRECISION array, dimension (NX), absolute
C             tolerances, at least 0.
C     MOST    (input) INTEGER, the largest number of steps, those that
C             are repeated counted; 0: no limit.
C     T       (output) DOUBLE PRECISION, the time that was reached [s].
C     XOUT    (output) DOUBLE PRECISION array, dimension (NX,NT): the
C             states at TOUT, ISTAT(6) of them.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (16*NX + NV).
C     ISTAT   (output) INTEGER array, dimension (6): (1) steps; (2)
C             steps that were repeated; (3) calls of RHS; (4) INFO of
C             RHS or PRJ, called last; (5) 1 if the constraints depend
C             on each other at the start; (6) output times reached.
C     INFO    (output) INTEGER:
C             0   the end is reached;
C             -i  argument i is out of its range, nothing was computed;
C             1   the scene has ports that stick or hit stops: this
C                 driver cannot run it;
C             2   the scene has events of the user: likewise;
C             3   the scene has sampled devices: likewise (for these
C                 scenes emit C: gsmbp_c, and the run time share/engine);
C             4   NB is less than SIZ(9): times at which the scene
C                 switches are missing in TB;
C             5   the limit of steps is reached at T;
C             6   the step became too small at T;
C             7   RHS failed at T, ISTAT(4) is its INFO;
C             8   PRJ failed at T, ISTAT(4) is its INFO, 3 also where a
C                 step would have to jump onto the constraints;
C             9   the state is not finite behind T;
C             10  behind T the constraints lose rank, or are dependent
C                 at the start alone: the driver goes through no
C                 singular position;
C             11  X at the start is not on the constraints.
C
C     METHOD
C     Steps of GSDST8, each moved onto the constraints by PRJ, if that is
C     no jump (GSJMP). They end at the times TB and at the end alone:
C     states at other output times are those of the polynomial of order 7
C     of a step (GSDEN8), moved onto the constraints.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, sections II.4, II.5, II.6 and II.10.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, INP
      INTEGER            SIZ(12), NB, NT, MOST, ISTAT(6), INFO
      DOUBLE PRECISION   CST(*), TB(*), TOUT(NT), X(*), RTOL, ATOL(*),
     $                   T, XOUT(*), W(*)
      EXTERNAL           GSDBEG, GSDTOL, GSDSTP, GSDRHS, GSDHIN, GSDTRY
      DOUBLE PRECISION   TZ, H
      INTEGER            I, IF, IT, IV, NX, SIDE, RATES
C
      NX = SIZ(3)
      IF = NX + 1
      IV = 16*NX + 1
      CALL GSDBEG( PRJ, SIZ, CST, NB, TB, NT, TOUT, X, XOUT, W, ISTAT,
     $             INFO )
      IF ( INFO.EQ.0 ) CALL GSDTOL( NX, RTOL, ATOL, MOST, INFO )
      IF ( INFO.NE.0 ) RETURN
      T  = TOUT(1)
      IT = 2
C
C     -- from stop to stop
   10 IF ( IT.GT.NT ) RETURN
      CALL GSDSTP( NB, TB, T, TOUT(NT), TZ, SIDE )
      H = 0.0D0
      RATES = 1
C
C     -- from step to step
   20 IF ( RATES.EQ.1 ) CALL GSDRHS( RHS, INP, T, 1, X, SIZ(4), CST,
     $                               W(IV), W(IF), ISTAT, INFO )
      IF ( INFO.EQ.0 .AND. .NOT.( H.GT.0.0D0 ) )
     $   CALL GSDHIN( RHS, INP, T, TZ - T, X, NX, SIZ(4), CST, RTOL,
     $                ATOL, W(IV), W(IF), ISTAT, H, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSDTRY( RHS, PRJ, INP, SIZ, NX, CST, TZ, SIDE, NT, TOUT, X,
     $             RTOL, ATOL, MOST, T, H, IT, RATES, XOUT, W, W(IF),
     $             W(IV), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      IF ( IT.LE.NT ) THEN
         IF ( TOUT(IT).LE.T ) THEN
            DO 30 I = 1, NX
               XOUT(NX*(IT-1)+I) = X(I)
   30       CONTINUE
            ISTAT(6) = IT
            IT = IT + 1
         END IF
      END IF
      IF ( T.GE.TZ ) GO TO 10
      GO TO 20
      END
      SUBROUTINE GSDTOL( NX, RTOL, ATOL, MOST, INFO )
C
C     PURPOSE
C     Are the arguments RTOL, ATOL and MOST of GSRUN8 within their
C     ranges? INFO as GSRUN8.
C
      IMPLICIT NONE
      INTEGER            NX, MOST, INFO
      DOUBLE PRECISION   RTOL, ATOL(NX)
      INTEGER            GSFIN, I
      EXTERNAL           GSFIN
C
      INFO = -11
      IF ( .NOT.( RTOL.GT.0.0D0 .AND. RTOL.LT.1.0D0 ) ) RETURN
      INFO = -12
      IF ( GSFIN( NX, ATOL ).NE.0 ) RETURN
      DO 10 I = 1, NX
         IF ( ATOL(I).LT.0.0D0 ) RETURN
   10 CONTINUE
      INFO = -13
      IF ( MOST.LT.0 ) RETURN
      INFO = 0
      END
