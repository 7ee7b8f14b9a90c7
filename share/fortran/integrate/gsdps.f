      SUBROUTINE GSDPS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  STP, ISTP, HMAX, SIZ, TIM, IOPT, ROPT, IP, RP,
     $                  CST, XOUT, VOUT, M, LM, IW, W, ISTAT, RSTAT,
     $                  INFO )
C
C     PURPOSE
C     From one stop to the next by the method of Dormand and Prince, or
C     through a singular position, which may end before or behind it.
C
C     ARGUMENTS
C     As GSSIM, and
C     T       (input/output) DOUBLE PRECISION, the time, that of the
C             stop on exit [s].
C     STP, ISTP (input/output) the stop, see GSSTO; on exit the one that
C             was reached.
C     HMAX    (input) DOUBLE PRECISION, the largest step [s].
C     M       (input/output) DOUBLE PRECISION array, dimension (11),
C             what is remembered from step to step: (1) the next step,
C             0 before the first one; (2) the last one [s]; (3) the
C             share of the least pivot below which GSPRT helps; (4) the
C             next step far from singular positions [s]; (5) P(1) as the
C             way of the loops wants it; (6) the relative tolerance
C             close to singular positions; (7) how small the pivot may
C             be where a step ends; of passages (8) the time before
C             which none is tried, (9) that before which none is counted
C             [s], (10) the share of the length that is tried and (11)
C             the time in which the constraints turn by 1.2 rad [s].
C     LM      (input/output) INTEGER array, dimension (6): (1) 1 if the
C             rates at X are to be computed, 2 if they are those that
C             GSDPD left, else 0; (2) 1 if the last step was
C             one of GSDP8, (3) steps that were repeated for the pivot
C             and (4) steps that were very short, one after the other;
C             (5) the stages of a passage; (6) 1 in a singular position
C             where the run starts, -1 behind an event, 0.
C     IW      (input/output) INTEGER array, dimension (7), the places of
C             (1) the state, (2) the next state, which change places,
C             (3) inputs, (4) partition, (5) stages, (6) rates and (7)
C             Jacobian of the constraints in W.
C     INFO    (output) INTEGER, as GSSIM: 0, 1, 2, 3, 5 or 8.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            ISTP(3), SIZ(8), IOPT(*), IP(*), LM(6), IW(7),
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, STP(3), HMAX, TIM(*), ROPT(*), RP(*),
     $                   CST(*), XOUT(*), VOUT(*), M(11), W(*), RSTAT(*)
      EXTERNAL           GSDPF, GSPSS, GSDPT
      DOUBLE PRECISION   HLIM
      INTEGER            IX, IXN, IV, IC, IK, TAKEN
C
      IV = IW(3)
      IC = IW(4)
      IK = IW(5)
   10 IX  = IW(1)
      IXN = IW(2)
      IF ( LM(1).GT.0 ) THEN
         CALL GSDPF( RHS, CON, KIN, CMD, CLO, VIN, IOPT(1), T, M(2),
     $               MIN( HMAX, STP(1) - T ), W(IX), SIZ(1), SIZ(2),
     $               SIZ(3), SIZ(4), SIZ(5), IP, RP, CST, W(IV),
     $               ROPT(2), ROPT(4), W(IK), W, W(IC), LM, M(1),
     $               ISTAT, RSTAT, INFO )
         LM(1) = 0
         IF ( INFO.NE.0 ) RETURN
      END IF
      CALL GSPSS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T, STP,
     $            ISTP, MIN( M(1), HMAX ), SIZ, TIM, IOPT, ROPT, IP, RP,
     $            CST, XOUT, VOUT, W(IC), M, LM, IW, W, HLIM, TAKEN,
     $            ISTAT, RSTAT, INFO )
      IF ( TAKEN.EQ.0 .AND. INFO.EQ.0 ) THEN
         IF ( LM(6).GT.0 ) THEN
            INFO = 3
            ISTAT(6) = 3
            ISTAT(7) = 8
            RETURN
         END IF
         CALL GSDPT( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $               STP, ISTP, MIN( M(1), HMAX, HLIM ), SIZ, TIM, IOPT,
     $               ROPT, IP, RP, CST, XOUT, VOUT, W(IX), W(IXN),
     $               W(IV), W(IK), W, W(IC), M, LM, TAKEN, ISTAT, RSTAT,
     $               INFO )
      ELSE IF ( TAKEN.EQ.1 ) THEN
         LM(1) = 1
         LM(2) = 0
      END IF
      IF ( TAKEN.EQ.1 ) THEN
         IW(1) = IXN
         IW(2) = IX
      END IF
      IF ( INFO.EQ.0 .AND. T.LT.STP(1) ) GO TO 10
      END
      SUBROUTINE GSDPF( RHS, CON, KIN, CMD, CLO, VIN, METHOD, T, H,
     $                  LEFT, X, NQ, NU, NX, NV, NLAM, IP, RP, CST, V,
     $                  RTOL, ATOL, F, W, P, LM, HN, ISTAT, RSTAT,
     $                  INFO )
C
C     PURPOSE
C     Before a step of GSDP8: the rates at X, F(*,1), where LM(1) is 2
C     from F(*,2); behind one (LM(2) is 1) of the length H whether
C     stability binds it; a first step HN, no longer than LEFT, where HN
C     is 0.  INFO as GSSIM: 0, 3, 5 or 8.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            METHOD, NQ, NU, NX, NV, NLAM, IP(*), LM(2),
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, H, LEFT, X(*), RP(*), CST(*), V(*), RTOL,
     $                   ATOL(*), F(NX,*), W(*), P(*), HN, RSTAT(*)
      INTEGER            GSFIN, I, IER
      EXTERNAL           GSFIN, GSFUN, GSSTD, GSHIN
C
      INFO = 3
      IF ( LM(1).EQ.2 ) THEN
         DO 10 I = 1, NX
            F(I,1) = F(I,2)
   10    CONTINUE
      ELSE
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, X, NQ, NU, NX,
     $               NV, NLAM, IP, RP, CST, V, F, W, P, ISTAT, RSTAT,
     $               IER )
         IF ( IER.NE.0 ) RETURN
      END IF
      INFO = 8
      IF ( GSFIN( NX, F ).NE.0 ) RETURN
      IF ( LM(2).EQ.1 ) THEN
         CALL GSSTD( RHS, CON, KIN, CMD, CLO, VIN, METHOD, T, H, X, NQ,
     $               NU, NX, NV, NLAM, IP, RP, CST, V, RTOL, ATOL, F, W,
     $               P, ISTAT, RSTAT )
         INFO = 5
         IF ( ISTAT(14).GT.0 .AND. METHOD.EQ.9 ) RETURN
      END IF
      INFO = 3
      IF ( HN.LE.0.0D0 ) THEN
         CALL GSHIN( RHS, CON, KIN, CMD, CLO, VIN, T, LEFT, X, NQ, NU,
     $               NX, NV, NLAM, IP, RP, CST, V, RTOL, ATOL, F, W, P,
     $               ISTAT, RSTAT, HN, IER )
         IF ( IER.NE.0 ) RETURN
      END IF
      INFO = 0
      END
