      SUBROUTINE GSPSS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  TB, TEND, TS, SIDE, H, T0, NQ, NU, NX, NV, NLAM,
     $                  NT, TOUT, NB, TBRK, IT, IB, IOPT, ROPT, ATOL,
     $                  IP, RP, CST, XOUT, LDX, VOUT, LDV, X, XN, V, F,
     $                  FN, HC, W, P, JOB, M, NS, BEGIN, HLIM, TAKEN,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The passage of a position where the constraints lose rank, if one
C     is ahead: by one step of GSPSG to its end, or to the next break,
C     sample or end of the run.
C
C     ARGUMENTS
C     As GSDPS and GSPSG, and
C     H       (input) DOUBLE PRECISION, the next step of GSDP8 [s].
C     X       (input) DOUBLE PRECISION array, dimension (NX), the state.
C     XN      (output) DOUBLE PRECISION array, dimension (NX), the state
C             behind the passage where TAKEN = 1.
C     HC      (workspace) DOUBLE PRECISION array, dimension (NLAM,NU).
C     JOB     (input) DOUBLE PRECISION, M(5) of GSDPS.
C     M       (input/output) DOUBLE PRECISION array, dimension (4), M(8)
C             to M(11) of GSDPS.
C     NS      (input/output) INTEGER, the number of stages, 8 or 12.
C     BEGIN   (input/output) INTEGER, LM(6) of GSDPS.
C     HLIM    (output) DOUBLE PRECISION, the longest step of GSDP8 where
C             there is no passage yet [s].
C     TAKEN   (output) INTEGER, 1 if the position was passed: then T is
C             the time behind it, TB and SIDE belong to it; else 0.
C     INFO    (output) INTEGER, as GSSIM: 0 or 3.
C
C     METHOD
C     See GSSIM: where the position does not settle, the iteration does
C     not converge or the error is too large, with more stages, then
C     shorter, from where that length begins.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, NT, NB, IT, IB,
     $                   IOPT(*), IP(*), LDX, LDV, NS, BEGIN, TAKEN,
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, TB, TEND, TS, H, T0, TOUT(*), TBRK(*),
     $                   ROPT(*), ATOL(*), RP(*), CST(*), XOUT(LDX,*),
     $                   VOUT(LDV,*), X(*), XN(*), V(*), F(NX,*), FN(*),
     $                   HC(*), W(*), P(*), JOB, M(4), HLIM, RSTAT(*)
      EXTERNAL           GSPSW, GSPTR, GSPEN
      DOUBLE PRECISION   TC, D, DFULL, MOVED, FAC, ERR, EIT, TMIN, SMIN
      INTEGER            NPASS, AGAIN, IER
C
      INFO  = 0
      TAKEN = 0
      HLIM  = 1.0D300
      D     = 0.0D0
      IF ( NLAM.GT.0 .AND. IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND.
     $     T.GE.M(1) ) CALL GSPSW( CON, KIN, T, X, H, NQ, NU, NX, NS,
     $                             NLAM, CST, F, XN, HC, P, M(4), HLIM,
     $                             TC, D )
      IF ( .NOT.( D.GT.0.0D0 ) ) RETURN
      IF ( .NOT.( T.LE.TC + 0.5D0*D ) ) RETURN
      DFULL = M(3)*D
      D     = DFULL
      IF ( T.LT.TC - 0.5D0*D ) D = MIN( D, TC - T )
      NPASS = 0
      MOVED = 1.0D300
   10 IF ( T.GT.TC + 0.5D0*D .OR. NPASS.GT.12 ) RETURN
      IF ( T.LT.TC - 1.05D0*D ) THEN
         HLIM = MIN( HLIM, TC - D - T )
         RETURN
      END IF
      D = MAX( D, TC - T )
      NPASS = NPASS + 1
      CALL GSPTR( RHS, CON, KIN, CMD, CLO, VIN, T, X, TC, D, T0, NQ, NU,
     $            NX, NS, NV, NLAM, NT, TOUT, NB, TBRK, IB, IP, RP, CST,
     $            V, ROPT(2), ATOL, F, XN, FN, HC, W, P, JOB, ISTAT,
     $            RSTAT, ERR, EIT, TMIN, SMIN, IER )
      IF ( IER.EQ.1 .AND. ABS( TMIN - TC ).LT.0.7D0*MOVED ) THEN
         MOVED = ABS( TMIN - TC )
         TC = TMIN
         IF ( T.LT.TC - D .AND. T.GT.TC - 1.4D0*D ) D = TC - T
         GO TO 10
      END IF
      MOVED = 1.0D300
C
C     -- where the rank is kept after all the usual steps do better
      IF ( IER.EQ.0 .AND. SMIN.GT.1.0D-3*P(14) ) THEN
         M(1) = TC + D
         M(3) = 1.0D0
         RETURN
      END IF
      FAC = 0.5D0
      IF ( IER.EQ.0 )
     $   FAC = 0.9D0*MAX( ERR, 1.0D-8 )**( -1.0D0/DBLE( NS + 1 ) )
      IF ( IER.EQ.0 .AND. ( ERR.LE.1.0D0 .OR. ERR.LE.3.0D0*EIT .OR.
     $     ( M(3).LT.0.15D0 .AND. ERR.LE.1.0D4 ) ) ) THEN
         M(3) = MIN( 1.0D0, M(3)*MIN( 1.5D0, MAX( 1.0D0, FAC ) ) )
         CALL GSPEN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T, TB,
     $               TEND, TS, SIDE, TC, D, ERR, EIT, TMIN, SMIN, NQ,
     $               NU, NX, NS, NV, NLAM, TOUT, NB, TBRK, IT, IB, IOPT,
     $               ROPT, ATOL, IP, RP, CST, XOUT, LDX, VOUT, LDV, X,
     $               XN, V, F, W, P, JOB, M, BEGIN, TAKEN, AGAIN, ISTAT,
     $               RSTAT, INFO )
         IF ( AGAIN.EQ.1 ) GO TO 10
         RETURN
      END IF
      IF ( M(3).LT.0.02D0 ) THEN
         M(1) = TC + D
         M(3) = 1.0D0
         RETURN
      END IF
      IF ( NS.EQ.8 .AND. FAC.LT.0.8D0 ) THEN
         NS = 12
         GO TO 10
      END IF
      FAC  = MAX( 0.25D0, FAC )
      M(3) = FAC*M(3)*MIN( 1.0D0, D/DFULL )
      D    = FAC*D
      GO TO 10
      END
      SUBROUTINE GSPSW( CON, KIN, T, X, H, NQ, NU, NX, NS, NLAM, CST, F,
     $                  XT, HC, P, TURN, HLIM, TC, D )
C
C     PURPOSE
C     Looks ahead for a singular position (GSAHD), where the step H is
C     so long, or the least pivot so small or falling so fast, that one
C     may be near.  D is 0 if it did not look or saw none.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), H, CST(*), F(NX,*), XT(*), HC(*),
     $                   P(*), TURN, HLIM, TC, D
      EXTERNAL           GSAHD
      INTEGER            LOOK
C
      D    = 0.0D0
      LOOK = 0
      IF ( P(4).LT.3.0D0 .OR. H.GT.0.25D0*TURN .OR.
     $     P(13).LT.0.25D0*P(14) ) LOOK = 1
      IF ( P(10).LT.P(8) .AND. P(10)*( P(9) - P(7) ).LT.
     $     MAX( 3.0D0*H, TURN )*( P(8) - P(10) ) ) LOOK = 1
      IF ( LOOK.EQ.0 ) RETURN
      HLIM = H
      CALL GSAHD( CON, KIN, T, X, HLIM, NQ, NU, NX, NS, NLAM, CST, F,
     $            XT, HC, P, TC, D, TURN )
      END
