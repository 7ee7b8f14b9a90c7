      SUBROUTINE GSDPT( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  STP, ISTP, HTRY, SIZ, TIM, IOPT, ROPT, IP, RP,
     $                  CST, XOUT, VOUT, X, XN, V, F, W, P, M, LM,
     $                  TAKEN, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     One trial step of GSDP8 within a run, onto the constraints and up
C     to an event in it; the outputs within it; the length of the next
C     one.
C
C     ARGUMENTS
C     As GSDPS, and
C     HTRY    (input) DOUBLE PRECISION, the step to be tried [s]: less
C             where the stop is near.
C     X       (input) DOUBLE PRECISION array, dimension (NX), the state.
C     XN      (output) DOUBLE PRECISION array, dimension (NX), the next
C             state where TAKEN = 1.
C     V, F, W, P as GSDP8.
C     TAKEN   (output) INTEGER, 1 if the step was good: then T is its
C             end; else 0.
C     INFO    (output) INTEGER, as GSSIM: 0, 1, 2, 3 or 8.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            ISTP(3), SIZ(8), IOPT(*), IP(*), LM(6), TAKEN,
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, STP(3), HTRY, TIM(*), ROPT(*), RP(*),
     $                   CST(*), XOUT(*), VOUT(*), X(*), XN(*), V(*),
     $                   F(*), W(*), P(*), M(11), RSTAT(*)
      EXTERNAL           GSDTA, GSDP8, GSDTB
      DOUBLE PRECISION   TN, H, ERR
      INTEGER            AT, IER
C
      TAKEN = 0
      CALL GSDTA( CON, KIN, T, STP(1), ISTP(1), HTRY, SIZ, IOPT, CST, X,
     $            P, M, LM, TN, AT, H, ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSDP8( RHS, CON, KIN, CMD, CLO, VIN, T, TN, AT, H, X, SIZ(1),
     $            SIZ(2), SIZ(3), SIZ(4), SIZ(5), IP, RP, CST, V,
     $            ROPT(2), ROPT(4), XN, ERR, F, W, P, ISTAT, RSTAT, IER
     $            )
      CALL GSDTB( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $            STP(1), TN, AT, H, ERR, IER, SIZ, TIM, IOPT, ROPT, IP,
     $            RP, CST, XOUT, VOUT, ISTP(2), X, XN, V, F, W, P, M,
     $            LM, TAKEN, ISTAT, RSTAT, INFO )
      END
      SUBROUTINE GSDTA( CON, KIN, T, TB, SIDE, HTRY, SIZ, IOPT, CST, X,
     $                  P, M, LM, TN, AT, H, ISTAT, INFO )
C
C     PURPOSE
C     Before a trial step of GSDP8 from T: its length H, its end TN, AT
C     < 0 where the inputs are taken from the left there, and whether
C     there may be another step.  Arguments as GSDPT.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            SIDE, SIZ(8), IOPT(*), LM(6), AT, ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TB, HTRY, CST(*), X(*), P(*), M(11), TN, H
      EXTERNAL           GSEPS, GSDPP
      DOUBLE PRECISION   GSEPS, EPS
C
      EPS = GSEPS()
      H  = HTRY
      TN = T + H
      AT = 1
      IF ( T + 1.01D0*H.GE.TB ) THEN
         H  = TB - T
         TN = TB
         AT = SIDE
      ELSE IF ( T + 2.0D0*H.GT.TB ) THEN
         H  = 0.5D0*( TB - T )
         TN = T + H
      END IF
      M(2) = H
      CALL GSDPP( CON, KIN, T, X, H, SIZ(1), SIZ(2), SIZ(5), IOPT, CST,
     $            M(3), M(4), P, LM(4), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      INFO = 1
      IF ( IOPT(4).GT.0 .AND. ISTAT(2) + ISTAT(3).GE.IOPT(4) ) RETURN
      INFO = 2
      IF ( H.LE.16.0D0*EPS*MAX( ABS( T ), ABS( TB ) ) .AND. TN.LT.TB )
     $   RETURN
      IF ( LM(4).GT.20000 ) RETURN
      INFO = 0
      END
      SUBROUTINE GSDTB( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST, T,
     $                  TB, TN, AT, H, ERR, IER, SIZ, TIM, IOPT, ROPT,
     $                  IP, RP, CST, XOUT, VOUT, IT, X, XN, V, F, W, P,
     $                  M, LM, TAKEN, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     After a trial step of GSDP8, with its ERR and its INFO in IER: up
C     to an event in it, onto the constraints; the outputs within it, of
C     which IT is the next; the length of the next step, or that with
C     which it is repeated.  Arguments as GSDPT, of which TAKEN = 0 on
C     entry, and GSDTA; IER is changed.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, RST
      INTEGER            AT, IER, SIZ(8), IOPT(*), IP(*), IT, LM(6),
     $                   TAKEN, ISTAT(*), INFO
      DOUBLE PRECISION   T, TB, TN, H, ERR, TIM(*), ROPT(*), RP(*),
     $                   CST(*), XOUT(*), VOUT(*), X(*), XN(*), V(*),
     $                   F(*), W(*), P(*), M(11), RSTAT(*)
      EXTERNAL           GSEPS, GSEVN, GSDPC, GSDPO, GSEVO, GSEVR
      DOUBLE PRECISION   GSEPS, EPS, FAC, HD, OFF, GAUSS(3)
      INTEGER            NQ, NU, NX, NV, NLAM, I, LOOSE, EVENT, DENSE,
     $                   MOVED
C
      NQ    = SIZ(1)
      NU    = SIZ(2)
      NX    = SIZ(3)
      NV    = SIZ(4)
      NLAM  = SIZ(5)
      EPS   = GSEPS()
      INFO  = 0
      FAC = ERR
      IF ( IOPT(5).EQ.1 .AND. P(13).LT.0.25D0*P(14) )
     $   ERR = ERR*ROPT(2)/MAX( ROPT(2), M(6) )
      LOOSE = 0
      IF ( FAC.GT.1.0D0 .AND. ERR.LE.1.0D0 ) LOOSE = 1
C
C     -- up to an event, if there is one within a good step
      EVENT = 0
      IF ( IP(28).GT.0 .AND. IER.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         DO 10 I = 1, 3
            GAUSS(I) = 0.0D0
   10    CONTINUE
         IF ( TIM(1+IT).LT.TN ) GAUSS(2) = 1.0D0
         CALL GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, IOPT(1),
     $               IOPT(2), T, TN, AT, H, X, SIZ, IP, RP, CST, V,
     $               ROPT, XN, F, W, P, ISTAT, RSTAT, IP(IP(28)),
     $               RP(IP(29)), GAUSS, EVENT, IER )
         M(2) = H
         IF ( EVENT.LT.0 ) THEN
            ERR = 1.0D10
            IF ( GAUSS(1).GT.1.0D0 ) ERR = MIN( ERR, GAUSS(1) )
         END IF
         IF ( IER.EQ.10 .AND. ISTAT(7).EQ.7 ) THEN
            INFO = 3
            RETURN
         END IF
      END IF
C
C     -- a good step: onto the constraints with it
      IF ( IER.EQ.0 .AND. ERR.LE.1.0D0 )
     $   CALL GSDPC( PRJ, CON, KIN, TN, TB, X, XN, NQ, NU, NX, NLAM,
     $               IOPT, ROPT, ROPT(4), CST, P, M(7), LM(3), ISTAT,
     $               RSTAT, IER )
C
C     -- the outputs within it
      DENSE = 0
      IF ( IER.EQ.0 .AND. ERR.LE.1.0D0 .AND. TIM(1+IT).LT.TN ) THEN
         DENSE = 1
         HD = H
         IF ( EVENT.GT.0 ) HD = TN - T
         OFF = -1.0D0
         IF ( IP(28).GT.0 .AND. EVENT.EQ.0 ) OFF = GAUSS(2)
         CALL GSDPO( RHS, PRJ, CON, KIN, CMD, CLO, VIN, T, TN, AT, HD,
     $               X, XN, SIZ, TIM(2), IOPT, ROPT, IP, RP, CST, V, F,
     $               W, P, XOUT, VOUT, IT, OFF, ISTAT, RSTAT, IER )
         IF ( IER.NE.0 .AND. IER.NE.90 ) P(4) = 0.0D0
         HD = HD*MAX( 0.3D0, 0.9D0*MAX( OFF, 1.0D-8 )**(-0.125D0) )
      END IF
      IF ( IER.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         TAKEN = 1
         FAC = 6.0D0
         IF ( ERR.GT.0.0D0 ) FAC = MIN( FAC, 0.9D0*ERR**(-0.125D0) )
         FAC = MAX( FAC, 1.0D0/3.0D0 )
         IF ( H.GE.0.99D0*M(1) .OR. H*FAC.GT.M(1) ) M(1) = H*FAC
         IF ( DENSE.EQ.1 .AND. HD.GT.1.0D3*EPS*ABS( TN ) ) THEN
C           -- two events and an output between them at one time but for
C              rounding: the next step need not be as short
            IF ( TIM(1+IT).LT.TN + M(1) ) M(1) = MIN( M(1), HD )
         END IF
         T = TN
         RSTAT(6) = MIN( RSTAT(6), H )
         RSTAT(7) = MAX( RSTAT(7), H )
         RSTAT(8) = T
         RSTAT(9) = M(1)
         ISTAT(2) = ISTAT(2) + 1
         ISTAT(6) = 0
         ISTAT(7) = 0
         ISTAT(20) = ISTAT(20) + LOOSE
         LM(6) = -MIN( 1, EVENT )
         LM(1) = 1
         IF ( DENSE.EQ.1 .AND. AT.GT.0 .AND. IP(28).LE.0 ) LM(1) = 2
         MOVED = 0
         IF ( IP(28).GT.0 .AND. EVENT.EQ.0 ) CALL GSEVO( RST, IOPT(1),
     $      TN, XN, NX, IP, RP, CST, V, ROPT(2), ROPT(4), MOVED )
         IF ( IP(28).GT.0 .AND. AT.GT.0 .AND. NLAM.EQ.0 .AND. NQ.EQ.NU
     $        .AND. MOVED.EQ.0 ) THEN
C           -- GSEVN knows the rates where the step ends
            LM(1) = 2
            DO 20 I = 1, NX
               F(NX+I) = RP(IP(29)-1+5*IP(IP(28))+I)
   20       CONTINUE
         END IF
         LM(2) = 1
         LM(3) = 0
         M(3)  = 0.05D0
         IF ( P(13).GE.0.25D0*P(14) ) THEN
            M(4) = M(1)
            IF ( P(1).GT.M(5) ) THEN
               P(1) = M(5)
               P(2) = -1.0D0
            END IF
         END IF
         IF ( EVENT.GT.0 ) THEN
            LM(1) = 1
            LM(2) = 0
            CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, XN, NU, NX, NV, IP,
     $                  RP, CST, V, W, ISTAT, EVENT, IER )
            IF ( IP(IP(28)+8).GT.0 ) INFO = 11
            IF ( IER.NE.0 ) INFO = 3
         END IF
      ELSE
         ISTAT(3) = ISTAT(3) + 1
         FAC = 0.25D0
         IF ( IER.EQ.0 .AND. ERR.LE.1.0D300 )
     $      FAC = MIN( 0.9D0, MAX( 0.2D0, 0.9D0*ERR**(-0.125D0) ) )
         M(1) = H*FAC
         IF ( .NOT.( ERR.LE.1.0D300 .AND. IER.EQ.0 ) .AND. IER.NE.90
     $        .AND. M(1).LE.1.0D3*EPS*MAX( ABS( T ), ABS( TB ) ) ) THEN
            INFO = 8
            IF ( IER.NE.0 ) INFO = 3
            RETURN
         END IF
         IF ( IER.EQ.90 ) M(1) = HD
         IF ( IER.NE.0 .AND. IER.NE.90 ) P(2) = -1.0D0
         IF ( IER.EQ.4 .AND. ISTAT(7).EQ.3 ) THEN
            M(1)  = 0.7D0*H
            LM(3) = LM(3) + 1
         END IF
         M(3) = 0.25D0
      END IF
      END
      SUBROUTINE GSDPP( CON, KIN, T, X, H, NQ, NU, NLAM, IOPT, CST,
     $                  NEAR, HFAR, P, NSLOW, ISTAT, INFO )
C
C     PURPOSE
C     Before a trial step: the partition that its stages need, where the
C     least pivot is below the share NEAR of its largest value GSPRT,
C     and how many steps, NSLOW, were very short beside HFAR.  INFO as
C     GSSIM: 0 or 3.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, IOPT(*), NSLOW, ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), H, CST(*), NEAR, HFAR, P(*)
      EXTERNAL           GSPCN
      INTEGER            IER
C
      INFO = 0
      IF ( NLAM.GT.0 .AND. IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND.
     $     P(1).LT.2.0D0 .AND. P(13).LT.NEAR*P(14) ) THEN
         P(1) = 2.0D0
         P(2) = -1.0D0
      END IF
      IF ( P(1).GT.0.0D0 .AND. P(2).LT.0.0D0 ) THEN
         ISTAT(10) = ISTAT(10) + 1
         CALL GSPCN( CON, KIN, T, X, NQ, NU, NLAM, CST, P, ISTAT, IER )
         IF ( IER.NE.0 ) INFO = 3
         IF ( IER.NE.0 ) RETURN
      END IF
      NSLOW = NSLOW + 1
      IF ( IOPT(5).NE.1 .OR. H.GT.1.0D-4*HFAR .OR.
     $     P(13).GE.0.25D0*P(14) ) NSLOW = 0
      END
      SUBROUTINE GSDPC( PRJ, CON, KIN, TN, TB, X, XN, NQ, NU, NX, NLAM,
     $                  IOPT, ROPT, ATOL, CST, P, CLOSE, NTRY, ISTAT,
     $                  RSTAT, INFO )
C
C     PURPOSE
C     After a good step from X to XN at TN: onto the constraints, but by
C     no jump, nor, the first NTRY < 5 times, to where the least pivot
C     is below the share CLOSE of its largest value.  INFO as GSCHK.
C
      IMPLICIT NONE
      EXTERNAL           PRJ, CON, KIN
      INTEGER            NQ, NU, NX, NLAM, IOPT(*), NTRY, ISTAT(*), INFO
      DOUBLE PRECISION   TN, TB, X(*), XN(*), ROPT(*), ATOL(*), CST(*),
     $                   P(*), CLOSE, RSTAT(*)
      EXTERNAL           GSJMP, GSCHK
      DOUBLE PRECISION   JUMP(3)
C
      INFO = 0
      IF ( NLAM.EQ.0 .AND. NQ.EQ.NU ) RETURN
      CALL GSJMP( NQ, NU, X, XN, ROPT(2), ATOL, JUMP )
      JUMP(3) = 0.0D0
      IF ( IOPT(5).EQ.1 .AND. IOPT(2).NE.1 .AND. NTRY.LT.5 .AND.
     $     TN.LT.TB ) JUMP(3) = CLOSE
      CALL GSCHK( PRJ, CON, KIN, TN, XN, NQ, NU, NX, NLAM, IOPT, JUMP,
     $            CST, P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) ISTAT(12) = ISTAT(12) + 1
      END
