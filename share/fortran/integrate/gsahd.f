      SUBROUTINE GSAHD( CON, KIN, T, X, H, REST, NQ, NU, NX, NS, NLAM,
     $                  CST, F, XT, HC, P, TC, D, TURN )
C
C     PURPOSE
C     Looks for a position where the constraints lose rank, from T on
C     until they have turned by 1.2 rad, or where T lies close to one,
C     before and behind.
C
C     ARGUMENTS
C     As GSPSG, and
C     H       (input/output) DOUBLE PRECISION, the next step, on exit no
C             more than what turns the constraints by about 1 rad.
C     REST    (input) DOUBLE PRECISION, twice the rest of the run: what
C             is farther is none of its business.
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,13):
C             on entry column 1 is the right-hand side at (T,X), on exit
C             the others are a path on from there for GSPTH, by rates of
C             the coordinates that are linear in time, for TC, D.
C     HC      (workspace) DOUBLE PRECISION array, dimension (NLAM,NU).
C     TC, D   (output) DOUBLE PRECISION, see GSPSG: D > 0 if there is
C             one at TC; until D behind it the constraints turn by
C             about 1 rad.
C     TURN    (output) DOUBLE PRECISION, the time of 1.2 rad.
C
C     METHOD
C     Rates that are linear in time need two points of Gauss.  Of three
C     looks the middle one the least, the pivot between them is no less
C     than a line twice as steep as they are has it.  Constraints that
C     turn by less than 0.12 rad do not lose their rank.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), H, REST, CST(*), F(NX,13), XT(*),
     $                   HC(NLAM,*), P(*), TC, D, TURN
      DOUBLE PRECISION   S, S0, S1, S2, CS, SMIN, BIG, T0, WAY
      EXTERNAL           GSPVT, GSPMN, GSPRD, GSPCH
      INTEGER            I, K, N2
C
C     -- how far one can see
      D  = 0.0D0
      T0 = T
      N2 = 2
      S = 0.01D0*H
      DO 10 I = 1, 12
         CALL GSPRD( KIN, T, X, T0, S, NQ, NX, N2, CST, F, XT )
         CALL GSPVT( CON, T, X, T0, S, 0.0D0, NQ, NU, NX, N2, NLAM, CST,
     $         F, XT, P, S0 )
         CALL GSPCH( NQ, NU, NLAM, P, HC, 0, TURN )
         CALL GSPVT( CON, T, X, T0, S, 1.0D0, NQ, NU, NX, N2, NLAM, CST,
     $         F, XT, P, S1 )
         CALL GSPCH( NQ, NU, NLAM, P, HC, 1, TURN )
         IF ( TURN.LE.0.3D0 ) GO TO 20
         S = 0.1D0*S
   10 CONTINUE
   20 TURN = 1.2D0*S/MAX( TURN, 1.0D-10 )
      H = MIN( H, TURN )
      BIG = P(14)
      WAY = TURN
      IF ( S0.GE.0.3D0*BIG ) WAY = MIN( TURN, REST )
      IF ( WAY.LT.0.1D0*TURN ) RETURN
      CALL GSPRD( KIN, T, X, T0, WAY, NQ, NX, N2, CST, F, XT )
C
C     -- the next least pivot
      IF ( S0.LT.0.3D0*BIG ) THEN
         CALL GSPMN( CON, T, X, T0, WAY, -0.6D0, 1.0D0, NQ, NU, NX, N2,
     $               NLAM, CST, F, XT, P, CS, SMIN )
      ELSE
         S1 = S0
         DO 30 K = 1, 9
            CALL GSPVT( CON, T, X, T0, WAY, 0.125D0*DBLE( K ), NQ, NU,
     $                  NX, N2, NLAM, CST, F, XT, P, S2 )
            IF ( K.GT.1 .AND. S1.LT.S0 .AND. S1.LE.S2 ) GO TO 40
            S0 = S1
            S1 = S2
   30    CONTINUE
         RETURN
   40    IF ( 3.0D0*S1 - 2.0D0*MAX( S0, S2 ).GT.0.25D0*BIG ) RETURN
         CALL GSPMN( CON, T, X, T0, WAY, 0.125D0*DBLE( K-2 ),
     $               0.125D0*DBLE( K ), NQ, NU, NX, N2, NLAM, CST, F,
     $               XT, P, CS, SMIN )
      END IF
      IF ( SMIN.GT.0.2D0*BIG ) RETURN
C
      CALL GSPRD( KIN, T, X, T0, TURN, NQ, NX, NS, CST, F, XT )
      TC = T + CS*WAY
      D  = 0.8D0*TURN
      END
      SUBROUTINE GSPRD( KIN, T, X, TC, D, NQ, NX, NS, CST, F, XT )
C
C     PURPOSE
C     The rates F of GSPSG for a path from X at T with the rates F(*,1),
C     those of the coordinates being linear in time.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NX, NS
      DOUBLE PRECISION   T, X(*), TC, D, CST(*), F(NX,13), XT(*)
      DOUBLE PRECISION   C(12), WT(12)
      EXTERNAL           GSGLN
      INTEGER            I, K
C
      CALL GSGLN( NS, C, WT )
      CALL KIN( T, X, F(NQ+1,1), CST, XT )
      DO 30 K = 1, NS
         DO 10 I = 1, NX
            F(I,K+1) = F(I,1)
   10    CONTINUE
         DO 20 I = 1, NQ
            F(I,K+1) = F(I,K+1) + ( TC + C(K)*D - T )*XT(I)
   20    CONTINUE
   30 CONTINUE
      END
