      SUBROUTINE GSPSS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  STP, ISTP, H, SIZ, TIM, IOPT, ROPT, IP, RP, CST,
     $                  XOUT, VOUT, P, M, LM, IW, W, HLIM, TAKEN, ISTAT,
     $                  RSTAT, INFO )
C
C     PURPOSE
C     The passage of a position where the constraints lose rank, if one
C     is ahead: by one step of GSPSG to its end, or to the next break,
C     sample or end of the run.
C
C     ARGUMENTS
C     As GSDPS, and
C     H       (input) DOUBLE PRECISION, the next step of GSDP8 [s].
C     P       (input/output) DOUBLE PRECISION array, the partition, see
C             GSPRT, that in W.
C     HLIM    (output) DOUBLE PRECISION, the longest step of GSDP8 where
C             there is no passage yet [s].
C     TAKEN   (output) INTEGER, 1 if the position was passed: then T is
C             the time behind it, to which STP(1), ISTP(1) and the next
C             state in W belong; else 0.
C     INFO    (output) INTEGER, as GSSIM: 0 or 3.
C
C     METHOD
C     See GSSIM: where the position does not settle, the iteration does
C     not converge or the error is too large, with more stages, then
C     shorter, from where that length begins.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            ISTP(3), SIZ(8), IOPT(*), IP(*), LM(6), IW(7),
     $                   TAKEN, ISTAT(*), INFO
      DOUBLE PRECISION   T, STP(3), H, TIM(*), ROPT(*), RP(*), CST(*),
     $                   XOUT(*), VOUT(*), P(*), M(11), W(*), HLIM,
     $                   RSTAT(*)
      EXTERNAL           GSPSW, GSPTR, GSPEN
      DOUBLE PRECISION   TC, D, DFULL, MOVED, FAC, PAS(6)
      INTEGER            NPASS, AGAIN, IER
C
      INFO  = 0
      TAKEN = 0
      HLIM  = 1.0D300
      D     = 0.0D0
      IF ( SIZ(5).GT.0 .AND. IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND.
     $     T.GE.M(8) ) CALL GSPSW( CON, KIN, T, W(IW(1)), H,
     $                             2.0D0*( TIM(1+SIZ(6)) - T ), SIZ(1),
     $                             SIZ(2), SIZ(3), LM(5), SIZ(5), CST,
     $                             W(IW(5)), W(IW(2)), W(IW(7)), P,
     $                             M(11), HLIM, TC, D )
      IF ( .NOT.( D.GT.0.0D0 ) ) RETURN
      IF ( .NOT.( T.LE.TC + 0.5D0*D ) ) RETURN
      DFULL = M(10)*D
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
      PAS(1) = TC
      PAS(2) = D
      CALL GSPTR( RHS, CON, KIN, CMD, CLO, VIN, T, ISTP(3), SIZ, TIM,
     $            ROPT, IP, RP, CST, P, M(5), LM(5), IW, W, ISTAT,
     $            RSTAT, PAS, IER )
      IF ( IER.EQ.1 .AND. ABS( PAS(5) - TC ).LT.0.7D0*MOVED ) THEN
         MOVED = ABS( PAS(5) - TC )
         TC = PAS(5)
         IF ( T.LT.TC - D .AND. T.GT.TC - 1.4D0*D ) D = TC - T
         GO TO 10
      END IF
      MOVED = 1.0D300
C
C     -- where the rank is kept after all the usual steps do better
      IF ( IER.EQ.0 .AND. PAS(6).GT.1.0D-3*P(14) ) THEN
         M(8)  = TC + D
         M(10) = 1.0D0
         RETURN
      END IF
      FAC = 0.5D0
      IF ( IER.EQ.0 ) FAC = 0.9D0*MAX( PAS(3), 1.0D-8 )**( -1.0D0/
     $                      DBLE( LM(5) + 1 ) )
      IF ( IER.EQ.0 .AND. ( PAS(3).LE.1.0D0 .OR. PAS(3).LE.3.0D0*PAS(4)
     $     .OR. ( M(10).LT.0.15D0 .AND. PAS(3).LE.1.0D4 ) ) ) THEN
         M(10) = MIN( 1.0D0, M(10)*MIN( 1.5D0, MAX( 1.0D0, FAC ) ) )
         CALL GSPEN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $               STP, ISTP, PAS, SIZ, TIM, IOPT, ROPT, IP, RP, CST,
     $               XOUT, VOUT, P, M, LM, IW, W, TAKEN, AGAIN, ISTAT,
     $               RSTAT, INFO )
         D = PAS(2)
         IF ( AGAIN.EQ.1 ) GO TO 10
         RETURN
      END IF
      IF ( M(10).LT.0.02D0 ) THEN
         M(8)  = TC + D
         M(10) = 1.0D0
         RETURN
      END IF
      IF ( LM(5).EQ.8 .AND. FAC.LT.0.8D0 ) THEN
         LM(5) = 12
         GO TO 10
      END IF
      FAC   = MAX( 0.25D0, FAC )
      M(10) = FAC*M(10)*MIN( 1.0D0, D/DFULL )
      D     = FAC*D
      GO TO 10
      END
      SUBROUTINE GSPSW( CON, KIN, T, X, H, REST, NQ, NU, NX, NS, NLAM,
     $                  CST, F, XT, HC, P, TURN, HLIM, TC, D )
C
C     PURPOSE
C     Looks ahead for a singular position (GSAHD), where the step H is
C     so long, or the least pivot so small or falling so fast, that one
C     may be near.  D is 0 if it did not look or saw none; REST as
C     GSAHD.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), H, REST, CST(*), F(NX,*), XT(*),
     $                   HC(*), P(*), TURN, HLIM, TC, D
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
      CALL GSAHD( CON, KIN, T, X, HLIM, REST, NQ, NU, NX, NS, NLAM, CST,
     $            F, XT, HC, P, TC, D, TURN )
      END
