      SUBROUTINE GSBGN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL,
     $                  EVT, RST, T, X, HMAX, NQ, NU, NX, NV, NLAM,
     $                  IOPT, IP, RP, CST, V, F, XT, XW, HC, W, P, JOB,
     $                  BEGIN, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The start of a run: X is moved onto the constraints, what is due
C     at T happens, and it is looked whether the constraints have less
C     than their rank there.
C
C     ARGUMENTS
C     As GSSIM, and
C     T       (input) DOUBLE PRECISION, the time of the start [s].
C     X       (input/output) DOUBLE PRECISION array, dimension (NX).
C     HMAX    (input) DOUBLE PRECISION, no further ahead is looked [s].
C     V       (output) DOUBLE PRECISION array, dimension (2*NV): the
C             inputs.
C     F       (workspace) DOUBLE PRECISION array, dimension (NX,13).
C     XT, XW  (workspace) DOUBLE PRECISION arrays, dimension (NX).
C     HC      (workspace) DOUBLE PRECISION array, dimension (NLAM,NU).
C     W       (workspace) DOUBLE PRECISION array, see GSINP.
C     P       (input/output) DOUBLE PRECISION array, see GSPRT.
C     JOB     (input/output) DOUBLE PRECISION, P(1) as the way of the
C             loops wants it; 2 where the constraints are dependent.
C     BEGIN   (output) INTEGER: 0; 1 in a singular position that the
C             speeds lead out of.
C     INFO    (output) INTEGER, as GSSIM: 0 or 3.
C
C     METHOD
C     The state is first moved without a partition: completed from
C     others it would be moved close to a singular position.  Whether T
C     lies in one GSPBG tells by the speeds, and by the accelerations
C     where these hardly move the constraints.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, OUT, CTL,
     $                   EVT, RST
      INTEGER            NQ, NU, NX, NV, NLAM, IOPT(*), IP(*), BEGIN,
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), HMAX, RP(*), CST(*), V(*), F(NX,*),
     $                   XT(*), XW(*), HC(*), W(*), P(*), JOB, RSTAT(*)
      EXTERNAL           GSCHK, GSINP, GSEVR, GSDUE, GSPBG, GSFUN, GSPCN
      DOUBLE PRECISION   NOJUMP(3), TS
      INTEGER            I, IER
C
      INFO  = 3
      BEGIN = 0
      DO 10 I = 1, 3
         NOJUMP(I) = 0.0D0
   10 CONTINUE
      P(1) = 0.0D0
      CALL GSCHK( PRJ, CON, KIN, T, X, NQ, NU, NX, NLAM, IOPT, NOJUMP,
     $            CST, P, ISTAT, RSTAT, IER )
      P(1) = JOB
      IF ( IER.NE.0 ) RETURN
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            IER )
      ISTAT(6) = IER
      ISTAT(7) = 1
      IF ( IER.NE.0 ) RETURN
      ISTAT(7) = 0
      CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, X, NU, NX, NV, IP, RP,
     $            CST, V, W, ISTAT, 0, IER )
      IF ( IER.NE.0 ) RETURN
      CALL GSDUE( OUT, CTL, CMD, CLO, VIN, T, X, NU, NX, NV, IP, RP,
     $            CST, V, W, ISTAT, TS, I, IER )
      IF ( IER.NE.0 ) RETURN
C
C     -- a start in a singular position? by its speeds, or at rest
      IF ( NLAM.GT.0 .AND. IOPT(5).EQ.1 .AND. IOPT(2).NE.1 ) THEN
         DO 20 I = 1, NX
            F(I,1) = 0.0D0
   20    CONTINUE
         CALL GSPBG( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT, XW,
     $               HC, F(1,2), P, BEGIN )
         IF ( BEGIN.LT.0 ) THEN
            CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, X, NQ, NU,
     $                  NX, NV, NLAM, IP, RP, CST, V, F, W, P, ISTAT,
     $                  RSTAT, IER )
            IF ( IER.NE.0 ) RETURN
            CALL GSPBG( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT,
     $                  XW, HC, F(1,2), P, BEGIN )
            BEGIN = MAX( 0, BEGIN )
         END IF
         IF ( BEGIN.EQ.2 .OR. ( BEGIN.EQ.1 .AND. IOPT(1).EQ.4 ) ) THEN
            ISTAT(6) = BEGIN
            ISTAT(7) = 8
            RETURN
         END IF
C
C        dependent constraints: see GSSIM
         IF ( JOB.LT.2.0D0 .AND. P(3).LT.DBLE( NLAM ) ) THEN
            JOB  = 2.0D0
            P(1) = JOB
         END IF
      END IF
      IF ( JOB.GT.0.0D0 .AND. BEGIN.EQ.0 ) THEN
         CALL GSPCN( CON, KIN, T, X, NQ, NU, NLAM, CST, P, ISTAT, IER )
         IF ( IER.NE.0 ) RETURN
      END IF
      INFO = 0
      END
