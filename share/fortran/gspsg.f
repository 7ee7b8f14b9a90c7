      SUBROUTINE GSPSG( RHS, CON, KIN, CMD, CLO, VIN, T, X, TC, D, TV,
     $                  NQ, NU, NX, NS, NV, NLAM, IP, RP, CST, V, RTOL,
     $                  ATOL, F, XN, FN, WI, P, ISTAT, RSTAT, ERR, EIT,
     $                  TS, SMIN, INFO )
C
C     PURPOSE
C     The motion through a position where the constraints lose rank, in
C     one step of an implicit method whose stages keep away from it.
C
C     ARGUMENTS
C     As GSDP8, and
C     X       (input) DOUBLE PRECISION array, dimension (NX), the state
C             at T, which may lie anywhere between TC-D and TC+D, at the
C             singular position as well.
C     TC, D   (input) DOUBLE PRECISION: the step is from TC-D to TC+D;
C             the singular position ought to lie at TC.
C     TV      (input) DOUBLE PRECISION array, dimension (3): the last
C             jump of the inputs before T and the first one behind it;
C             if TV(3) > 0 inputs are continued beyond them by no more
C             than that time.
C     NS      (input) INTEGER, the number of stages, 8 or 12.
C     V       (workspace) DOUBLE PRECISION array, dimension (2*NV).
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,13):
C             on entry column 1 is the right-hand side at (T,X), on exit
C             the next NS are that at the stages: GSPTH then has the
C             state at all times of the step.
C     XN, FN  (workspace) DOUBLE PRECISION arrays, dimension (NX).
C     P       (input/output) DOUBLE PRECISION array, see GSPRT, with the
C             partition of the step.
C     ERR     (output) DOUBLE PRECISION, the estimated error divided by
C             the tolerance, of the states that are not completed, and
C     EIT     (output) DOUBLE PRECISION, what the last iteration moved
C             them: rounding errors, if it is not below 0.02.
C     TS      (output) DOUBLE PRECISION, where the least pivot of the
C             constraints is least [s], and
C     SMIN    (output) DOUBLE PRECISION, its value there.
C     INFO    (output) INTEGER: 0; 1 if the singular position lies too
C             far from TC: another step is to be tried, about TS; 2 if
C             the iteration does not converge; 3 if a stage failed.
C
C     METHOD
C     Collocation at the points of Gauss, an even number: none of 8 is
C     nearer to TC than 0.18*D, none of 12 nearer than 0.12*D.  The
C     stages are completed by GSPRT.  First every stage is predicted
C     from those before it, then all of them are iterated.
C     On the branch that the mechanism takes the motion is a smooth
C     function of time, but what follows from the
C     constraints at a position close to the singular one is not known:
C     an error e of theirs is one of e/s in completed coordinates,
C     e/s**2 in speeds, e/s**3 in accelerations, s being the least
C     pivot.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, section II.7 (collocation).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NS, NV, NLAM, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), TC, D, TV(3), RP(*), CST(*), V(*),
     $                   RTOL, ATOL(*), F(NX,13), XN(*), FN(*), WI(*),
     $                   P(*), RSTAT(*), ERR, EIT, TS, SMIN
      INTEGER            I, J, K, L, ORDER(12)
      DOUBLE PRECISION   C(12), WT(12), B(12), C0, CS, S, OLD, GSEPS,
     $                   TOL
      EXTERNAL           GSEPS, GSGLN, GSGLQ, GSPSF, GSPMN, GSPSR,
     $                   GSPER, GSPTH, GSLGP
C
      CALL GSGLN( NS, C, WT )
      C0  = ( T - TC )/D
      ERR = 0.0D0
      EIT = 0.0D0
      CALL GSPSF( RHS, CON, KIN, CMD, CLO, VIN, X, TC, D, TV, C0, C, NQ,
     $            NU, NX, NS, NV, NLAM, IP, RP, CST, V, F, XN, WI, P,
     $            ISTAT, RSTAT, ORDER, INFO )
      IF ( INFO.NE.0 ) THEN
         INFO = 3
         RETURN
      END IF
      CALL GSPMN( CON, T, X, TC, D, -0.7D0, 0.7D0, NQ, NU, NX, NS, NLAM,
     $            CST, F, XN, P, CS, SMIN )
      TS = TC + CS*D
      IF ( ABS( CS ).GT.0.03D0 ) THEN
         INFO = 1
         RETURN
      END IF
C
C     -- iterations
      TOL = MAX( RTOL, 5.0D3*GSEPS() )
      OLD = 1.0D300
      DO 60 L = 1, 40
         EIT = 0.0D0
         DO 50 J = 1, NS
            K = ORDER(J)
            CALL GSGLQ( NS, C, WT, C0, C(K), B )
            CALL GSPTH( NX, NS, NX, X, D, B, F, XN )
            CALL GSPSR( RHS, CON, KIN, CMD, CLO, VIN, TC + C(K)*D, TV,
     $                  XN, NQ, NU, NX, NV, NLAM, IP, RP, CST, V, FN,
     $                  WI, P, ISTAT, RSTAT, INFO )
            IF ( INFO.NE.0 ) THEN
               INFO = 3
               RETURN
            END IF
            DO 40 I = 1, NX
               S = F(I,K+1)
               F(I,K+1) = FN(I)
               FN(I) = D*WT(K)*( FN(I) - S )
   40       CONTINUE
            CALL GSPER( NQ, NU, NX, X, FN, TOL, ATOL, RTOL, P, S )
            EIT = EIT + S
   50    CONTINUE
         IF ( .NOT.( EIT.LE.1.0D300 ) ) GO TO 70
         IF ( EIT.LE.0.02D0 ) GO TO 80
         IF ( L.GT.2 .AND. EIT.GT.0.5D0*OLD .AND. EIT.LE.3.0D1 )
     $      GO TO 80
         OLD = EIT
   60 CONTINUE
   70 INFO = 2
      RETURN
C
C     -- how the last coefficients of the polynomial fall
   80 OLD = 0.0D0
      DO 110 J = NS - 4, NS - 1
         DO 90 I = 1, NX
            FN(I) = 0.0D0
   90    CONTINUE
         DO 105 K = 1, NS
            CALL GSLGP( NS, C(K), B )
            S = D*WT(K)*B(J+1)*0.5D0
            DO 100 I = 1, NX
               FN(I) = FN(I) + S*F(I,K+1)
  100       CONTINUE
  105    CONTINUE
         CALL GSPER( NQ, NU, NX, X, FN, TOL, ATOL, RTOL, P, S )
         IF ( J.LT.NS - 2 ) OLD = MAX( OLD, S )
         IF ( J.GE.NS - 2 ) ERR = MAX( ERR, S )
  110 CONTINUE
      IF ( ERR.LT.OLD ) ERR = ERR*( ERR/OLD )
      CALL GSPMN( CON, T, X, TC, D, -0.1D0, 0.1D0, NQ, NU, NX, NS, NLAM,
     $            CST, F, XN, P, CS, SMIN )
      TS = TC + CS*D
      END
      SUBROUTINE GSPSF( RHS, CON, KIN, CMD, CLO, VIN, X, TC, D, TV, C0,
     $                  C, NQ, NU, NX, NS, NV, NLAM, IP, RP, CST, V, F,
     $                  XN, WI, P, ISTAT, RSTAT, ORDER, INFO )
C
C     PURPOSE
C     The stages of GSPSG for the first time, from C0 outwards (their
C     ORDER), each by the polynomial through up to seven of those that
C     are known already.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NS, NV, NLAM, IP(*), ISTAT(*),
     $                   ORDER(12), INFO
      DOUBLE PRECISION   X(*), TC, D, TV(3), C0, C(12), RP(*), CST(*),
     $                   V(*), F(NX,13), XN(*), WI(*), P(*), RSTAT(*)
      INTEGER            I, J, K, L, N, KNOWN(13), NK
      DOUBLE PRECISION   Z(13), FROM, B(13)
      EXTERNAL           GSPSR, GSLGI
C
      N = 0
      DO 10 K = 1, NS
         IF ( C(K).GT.C0 ) THEN
            N = N + 1
            ORDER(N) = K
         END IF
   10 CONTINUE
      NK = N
      DO 20 K = NS, 1, -1
         IF ( C(K).LE.C0 ) THEN
            N = N + 1
            ORDER(N) = K
         END IF
   20 CONTINUE
C
C     -- close to the singular position its own rates are of no use
C        once there are others
      Z(1) = C0
      KNOWN(1) = 1
      N = 1
      DO 60 J = 1, NS
         K = ORDER(J)
         IF ( J.EQ.1 .OR. J.EQ.NK+1 ) THEN
            FROM = C0
            DO 30 I = 1, NX
               XN(I) = X(I)
   30       CONTINUE
         END IF
         IF ( J.EQ.2 .AND. ABS( C0 ).LT.0.1D0 ) THEN
            Z(1) = Z(2)
            KNOWN(1) = KNOWN(2)
            N = 1
         END IF
         CALL GSLGI( N, Z, FROM, C(K), B )
         DO 50 I = 1, NX
            DO 40 L = 1, N
               XN(I) = XN(I) + D*B(L)*F(I,KNOWN(L))
   40       CONTINUE
   50    CONTINUE
         CALL GSPSR( RHS, CON, KIN, CMD, CLO, VIN, TC + C(K)*D, TV, XN,
     $               NQ, NU, NX, NV, NLAM, IP, RP, CST, V, F(1,K+1), WI,
     $               P, ISTAT, RSTAT, INFO )
         IF ( INFO.NE.0 ) RETURN
         FROM = C(K)
         N = N + 1
         Z(N) = C(K)
         KNOWN(N) = K + 1
   60 CONTINUE
      END
      SUBROUTINE GSPSR( RHS, CON, KIN, CMD, CLO, VIN, T, TV, X, NQ, NU,
     $                  NX, NV, NLAM, IP, RP, CST, V, XD, W, P, ISTAT,
     $                  RSTAT, INFO )
C
C     PURPOSE
C     The right-hand side of a stage of GSPSG; beyond a jump of the
C     inputs, at TV(1) or TV(2), with those up to it, continued.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, TV(3), X(*), RP(*), CST(*), V(*), XD(*),
     $                   W(*), P(*), RSTAT(*)
      DOUBLE PRECISION   TE, TF
      EXTERNAL           GSFUT
      INTEGER            SIDE
C
      SIDE = 1
      IF ( T.GE.TV(2) ) SIDE = -1
      TE = MIN( MAX( T, TV(1) ), TV(2) )
      TF = T
      IF ( TV(3).GT.0.0D0 ) TF = TE + TV(3)*TANH( ( T - TE )/TV(3) )
      CALL GSFUT( RHS, CON, KIN, CMD, CLO, VIN, T, TE, TF, SIDE, X, NQ,
     $            NU, NX, NV, NLAM, IP, RP, CST, V, XD, W, P, ISTAT,
     $            RSTAT, INFO )
      END
      SUBROUTINE GSPER( NQ, NU, NX, X, D, TOL, ATOL, RTOL, P, ERR )
C
C     PURPOSE
C     The size of D beside the tolerance, states that are completed from
C     others left out, as in GSDP8 but with TOL >= RTOL for RTOL.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NX
      DOUBLE PRECISION   X(*), D(*), TOL, ATOL(*), RTOL, P(*), ERR
      DOUBLE PRECISION   S
      INTEGER            I, N
C
      ERR = 0.0D0
      N   = 0
      DO 10 I = 1, NX
         S = 1.0D0
         IF ( I.LE.NQ + NU ) S = P(14+NU+I)
         IF ( S.GT.0.0D0 ) THEN
            N = N + 1
            S = ( ATOL(I)/RTOL + ABS( X(I) ) )*TOL
            IF ( S.GT.0.0D0 ) ERR = ERR + ( D(I)/S )**2
         END IF
   10 CONTINUE
      ERR = SQRT( ERR/DBLE( MAX( 1, N ) ) )
      END
      SUBROUTINE GSPTH( N, NS, LDF, X, D, B, F, XT )
C
C     PURPOSE
C     XT = X + D*F(1..N,2..13)*B, the first N states at the place of B
C     (GSGLQ) in a step of GSPSG.
C
      IMPLICIT NONE
      INTEGER            N, LDF, NS
      DOUBLE PRECISION   X(*), D, B(12), F(LDF,13), XT(*)
      DOUBLE PRECISION   S
      INTEGER            I, K
C
      DO 20 I = 1, N
         S = 0.0D0
         DO 10 K = 1, NS
            S = S + B(K)*F(I,K+1)
   10    CONTINUE
         XT(I) = X(I) + D*S
   20 CONTINUE
      END
      SUBROUTINE GSPMN( CON, T, X, TC, D, CA, CB, NQ, NU, NX, NS, NLAM,
     $                  CST, F, XT, P, CS, SMIN )
C
C     PURPOSE
C     The least pivot of the constraints, SMIN, and its place CS between
C     CA and CB, on the path of GSPSG from X at T with the rates F.
C     XT is workspace of NX entries.  SMIN = 0 where the rank is lower
C     than elsewhere.
C
      IMPLICIT NONE
      EXTERNAL           CON
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), TC, D, CA, CB, CST(*), F(NX,13),
     $                   XT(*), P(*), CS, SMIN
      DOUBLE PRECISION   S, Z, SP, W
      EXTERNAL           GSPVT
      INTEGER            K, L
C
      SMIN = 1.0D300
      CS   = 0.5D0*( CA + CB )
      W    = ( CB - CA )/12.0D0
      DO 20 L = 1, 4
         Z = CS
         DO 10 K = -6, 6
            S = Z + DBLE( K )*W
            IF ( S.GE.CA - 0.1D0*W .AND. S.LE.CB + 0.1D0*W ) THEN
               CALL GSPVT( CON, T, X, TC, D, S, NQ, NU, NX, NS, NLAM,
     $               CST, F, XT, P, SP )
               IF ( SP.LT.SMIN ) THEN
                  SMIN = SP
                  CS   = S
               END IF
            END IF
   10    CONTINUE
         W = 0.2D0*W
   20 CONTINUE
      END
      SUBROUTINE GSPVT( CON, T, X, TC, D, CT, NQ, NU, NX, NS, NLAM, CST,
     $                  F, XT, P, SP )
C
C     PURPOSE
C     The least pivot SP of the constraints at TC + CT*D on the path of
C     GSPMN, beside the largest; 1D300 where CON fails.
C
      IMPLICIT NONE
      EXTERNAL           CON
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), TC, D, CT, CST(*), F(NX,13), XT(*),
     $                   P(*), SP
      DOUBLE PRECISION   C(12), WT(12), B(12)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSLPV
      INTEGER            I, IM, IW, IH, IY, IB, IP, IS, RANK, INFO
C
      IM = 15 + 2*NU + NQ
      IW = IM + NU + 2*NLAM
      IH = IW + 3*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      SP = 1.0D300
      CALL GSGLN( NS, C, WT )
      CALL GSGLQ( NS, C, WT, ( T - TC )/D, CT, B )
      CALL GSPTH( NQ, NS, NX, X, D, B, F, XT )
      CALL CON( TC + CT*D, XT, X(NQ+1), CST, P(IW), P(IW+NLAM), P(IH),
     $          NLAM, P(IW+2*NLAM), INFO )
      IF ( INFO.NE.0 .AND. INFO.NE.2 ) RETURN
C
C     -- with lengths of rows of its own: those of P are of states that
C        the motion had
      DO 10 I = 1, NLAM
         P(IW+I-1) = P(IM+I-1)
   10 CONTINUE
      CALL GSLPV( NU, NLAM, P(IH), P(IW), P(IY), P(IP), P(IB), P(IS),
     $            RANK, SP )
      SP = 0.0D0
      I  = NINT( P(3) )
      IF ( I.GT.0 .AND. RANK.GE.I ) SP = P(IS+I-1)/P(IS)
      END
      SUBROUTINE GSGLN( NS, C, WT )
C
C     PURPOSE
C     The NS points C and weights WT of Gauss between -1 and 1, the
C     points rising; NS even, 12 at most.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12)
      DOUBLE PRECISION   P(13), PI, D
      EXTERNAL           GSLGP
      INTEGER            K, L
C
      PI = 4.0D0*ATAN( 1.0D0 )
      DO 20 K = 1, NS/2
         C(K) = -COS( PI*( DBLE( K ) - 0.25D0 )/( DBLE( NS ) + 0.5D0 ) )
         DO 10 L = 1, 6
            CALL GSLGP( NS + 1, C(K), P )
            D    = DBLE( NS )*( P(NS) - C(K)*P(NS+1) )
     $             /( 1.0D0 - C(K)**2 )
            C(K) = C(K) - P(NS+1)/D
   10    CONTINUE
         WT(K)       = 2.0D0/( ( 1.0D0 - C(K)**2 )*D*D )
         C(NS+1-K)  = -C(K)
         WT(NS+1-K) = WT(K)
   20 CONTINUE
      END
      SUBROUTINE GSLGP( N, X, P )
C
C     PURPOSE
C     The polynomials of Legendre of degrees 0 to N-1 at X, N >= 2.
C
      IMPLICIT NONE
      INTEGER            N
      DOUBLE PRECISION   X, P(N)
      INTEGER            J
C
      P(1) = 1.0D0
      P(2) = X
      DO 10 J = 2, N - 1
         P(J+1) = ( DBLE( 2*J - 1 )*X*P(J) - DBLE( J - 1 )*P(J-1) )
     $            /DBLE( J )
   10 CONTINUE
      END
      SUBROUTINE GSGLQ( NS, C, WT, CA, CB, B )
C
C     PURPOSE
C     B, so that the sum of B(K)*F(C(K)) is the integral from CA to CB
C     of the polynomial of degree NS-1 through F at the points of GSGLN.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12), CA, CB, B(12)
      DOUBLE PRECISION   P(12), PA(13), PB(13), S
      EXTERNAL           GSLGP
      INTEGER            J, K
C
      CALL GSLGP( NS + 1, CA, PA )
      CALL GSLGP( NS + 1, CB, PB )
      DO 20 K = 1, NS
         CALL GSLGP( NS, C(K), P )
         S = CB - CA
         DO 10 J = 2, NS
            S = S + P(J)*( ( PB(J+1) - PB(J-1) )
     $                   - ( PA(J+1) - PA(J-1) ) )
   10    CONTINUE
         B(K) = 0.5D0*WT(K)*S
   20 CONTINUE
      END
      SUBROUTINE GSLGI( N, Z, CA, CB, B )
C
C     PURPOSE
C     B, so that the sum of B(K)*F(Z(K)) is the integral from CA to CB
C     of the polynomial through F at those of the N places Z that are
C     nearest to CB, seven at most; the other B are 0.
C
      IMPLICIT NONE
      INTEGER            N
      DOUBLE PRECISION   Z(*), CA, CB, B(*)
      DOUBLE PRECISION   G(4), WG(4), S, X
      INTEGER            I, J, K, M, NEAR(7)
C
C     -- the nearest ones
      M = 0
      DO 20 K = 1, N
         B(K) = 0.0D0
         I = 0
         DO 10 J = 1, N
            IF ( J.LT.K .AND. ABS( Z(J) - CB ).LE.ABS( Z(K) - CB ) )
     $         I = I + 1
            IF ( J.GT.K .AND. ABS( Z(J) - CB ).LT.ABS( Z(K) - CB ) )
     $         I = I + 1
   10    CONTINUE
         IF ( I.LT.7 .AND. M.LT.7 ) THEN
            M = M + 1
            NEAR(M) = K
         END IF
   20 CONTINUE
C
C     -- four points of Gauss
      G(4)  = SQRT( 3.0D0/7.0D0 + 2.0D0/7.0D0*SQRT( 1.2D0 ) )
      G(3)  = SQRT( 3.0D0/7.0D0 - 2.0D0/7.0D0*SQRT( 1.2D0 ) )
      WG(4) = 0.5D0 - SQRT( 30.0D0 )/36.0D0
      WG(3) = 0.5D0 + SQRT( 30.0D0 )/36.0D0
      DO 30 I = 1, 2
         G(I)  = -G(5-I)
         WG(I) = WG(5-I)
   30 CONTINUE
      DO 60 I = 1, 4
         X = 0.5D0*( CA + CB ) + 0.5D0*( CB - CA )*G(I)
         DO 50 K = 1, M
            S = 0.5D0*( CB - CA )*WG(I)
            DO 40 J = 1, M
               IF ( J.NE.K ) S = S*( X - Z(NEAR(J)) )
     $                            /( Z(NEAR(K)) - Z(NEAR(J)) )
   40       CONTINUE
            B(NEAR(K)) = B(NEAR(K)) + S
   50    CONTINUE
   60 CONTINUE
      END
      SUBROUTINE GSAHD( CON, KIN, T, X, H, NQ, NU, NX, NS, NLAM, CST, F,
     $                  XT, HC, P, TC, D, TURN )
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
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), H, CST(*), F(NX,13), XT(*),
     $                   HC(NLAM,*), P(*), TC, D, TURN
      DOUBLE PRECISION   S, S0, S1, S2, CS, SMIN, BIG, T0
      EXTERNAL           GSPVT, GSPMN, GSPRD, GSPCH
      INTEGER            I, K
C
C     -- how far one can see
      D  = 0.0D0
      T0 = T
      S = 0.01D0*H
      DO 10 I = 1, 12
         CALL GSPRD( KIN, T, X, T0, S, NQ, NX, NS, CST, F, XT )
         CALL GSPVT( CON, T, X, T0, S, 0.0D0, NQ, NU, NX, NS, NLAM, CST,
     $         F, XT, P, S0 )
         CALL GSPCH( NQ, NU, NLAM, P, HC, 0, TURN )
         CALL GSPVT( CON, T, X, T0, S, 1.0D0, NQ, NU, NX, NS, NLAM, CST,
     $         F, XT, P, S1 )
         CALL GSPCH( NQ, NU, NLAM, P, HC, 1, TURN )
         IF ( TURN.LE.0.3D0 ) GO TO 20
         S = 0.1D0*S
   10 CONTINUE
   20 TURN = 1.2D0*S/MAX( TURN, 1.0D-10 )
      H = MIN( H, TURN )
      CALL GSPRD( KIN, T, X, T0, TURN, NQ, NX, NS, CST, F, XT )
      BIG = P(14)
C
C     -- the next least pivot
      IF ( S0.LT.0.3D0*P(14) ) THEN
         CALL GSPMN( CON, T, X, T0, TURN, -0.6D0, 1.0D0, NQ, NU, NX, NS,
     $               NLAM, CST, F, XT, P, CS, SMIN )
      ELSE
         S1 = S0
         DO 30 K = 1, 9
            CALL GSPVT( CON, T, X, T0, TURN, 0.125D0*DBLE( K ), NQ, NU,
     $                  NX, NS, NLAM, CST, F, XT, P, S2 )
            IF ( K.GT.1 .AND. S1.LT.S0 .AND. S1.LE.S2 ) GO TO 40
            S0 = S1
            S1 = S2
   30    CONTINUE
         RETURN
   40    CALL GSPMN( CON, T, X, T0, TURN, 0.125D0*DBLE( K-2 ),
     $               0.125D0*DBLE( K ), NQ, NU, NX, NS, NLAM, CST, F,
     $               XT, P, CS, SMIN )
      END IF
      IF ( SMIN.GT.0.2D0*BIG ) RETURN
C
      TC = T + CS*TURN
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
      SUBROUTINE GSPCH( NQ, NU, NLAM, P, HC, JOB, TURN )
C
C     PURPOSE
C     JOB = 0: HC becomes the Jacobian that P holds (GSPVT); JOB = 1:
C     TURN becomes how far that one differs from HC, beside the length
C     of its row, the largest of the rows.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NLAM, JOB
      DOUBLE PRECISION   P(*), HC(NLAM,*), TURN
      DOUBLE PRECISION   S
      INTEGER            I, J, IM, IH
C
      IM = 14 + 2*NU + NQ
      IH = IM + NU + 5*NLAM + 11
      TURN = 0.0D0
      DO 20 I = 1, NLAM
         S = 0.0D0
         DO 10 J = 1, NU
            IF ( JOB.EQ.0 ) HC(I,J) = P(IH+I-1+NLAM*(J-1))
            S = S + ( HC(I,J) - P(IH+I-1+NLAM*(J-1)) )**2
   10    CONTINUE
         IF ( S.GT.0.0D0 ) TURN = MAX( TURN, SQRT( S )/P(IM+I) )
   20 CONTINUE
      END
      SUBROUTINE GSPBG( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT,
     $                  XW, HC, SIZ, P, STATE )
C
C     PURPOSE
C     Whether a run starts in, or very close to, a position where the
C     constraints lose rank.  Then P knows their rank and pivots where
C     they do not.
C
C     ARGUMENTS
C     As GSPRT, and
C     HMAX    (input) DOUBLE PRECISION, no further ahead is looked [s].
C     F       (input) DOUBLE PRECISION array, the right-hand side at
C             (T,X).
C     XT, XW  (workspace) DOUBLE PRECISION arrays, dimension (NQ).
C     HC, SIZ (workspace) DOUBLE PRECISION arrays, dimensions (NLAM,NU)
C             and (NLAM).
C     P       (input/output) as GSPRT, after GSPRC at X.
C     STATE   (output) INTEGER: 0, no such position; 1, one that the
C             speeds lead out of; 2, one at rest; -1, the constraints
C             hardly turn.
C
C     METHOD
C     The pivots beyond the rank at X a little ahead, and half as far.
C     On the straight way from a singular position they grow with the
C     way, those of constraints that are redundant everywhere with its
C     square, as far as it leads off the constraints.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, STATE
      DOUBLE PRECISION   T, X(*), HMAX, CST(*), F(*), XT(*), XW(*),
     $                   HC(NLAM,*), SIZ(*), P(*)
      DOUBLE PRECISION   H, HALF, FAR, NEAR, MID, HERE
      EXTERNAL           GSPBH, GSPBV
      INTEGER            I, L, IS, NR, REST
C
      STATE = -1
      IS = 25 + 5*NU + NQ + 5*NLAM + 2*NLAM*NU
      CALL GSPBH( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT, XW,
     $            HC, SIZ, P, H, REST )
      IF ( H.LE.0.0D0 ) RETURN
      STATE = 0
      HALF = 0.5D0
      IF ( REST.EQ.1 ) HALF = SQRT( HALF )
      CALL GSPBV( CON, KIN, T, X, 0.0D0, NQ, NU, NLAM, CST, F, XT, XW,
     $            SIZ, P, NR )
      HERE = 0.0D0
      IF ( NR.GT.0 ) HERE = P(IS+NR-1)/P(IS)
      DO 10 I = MIN( NU, NLAM ), MAX( 1, NR ), -1
         CALL GSPBV( CON, KIN, T, X, 0.1D0*H, NQ, NU, NLAM, CST, F, XT,
     $               XW, SIZ, P, L )
         MID = 0.0D0
         IF ( L.GE.I ) MID = P(IS+I-1)/P(IS)
         CALL GSPBV( CON, KIN, T, X, 0.1D0*HALF*H, NQ, NU, NLAM, CST, F,
     $               XT, XW, SIZ, P, L )
         NEAR = 0.0D0
         IF ( L.GE.I ) NEAR = P(IS+I-1)/P(IS)
         IF ( I.LE.NR .OR. ( MID.GT.0.0D0 .AND. MID.LE.2.8D0*NEAR ) )
     $      GO TO 20
   10 CONTINUE
      RETURN
C
C     -- I is the rank elsewhere
   20 CALL GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW, SIZ,
     $            P, L )
      IF ( L.LT.I ) RETURN
      FAR = P(IS+I-1)/P(IS)
      IF ( I.GT.NR ) HERE = 0.0D0
      IF ( HERE.GT.0.25D0*FAR ) RETURN
      IF ( HERE.LE.1.0D-4*FAR ) STATE = 1
      IF ( I.GT.NR .AND. REST.EQ.1 ) STATE = 2
      P(3)  = DBLE( I )
      P(10) = HERE
      P(13) = HERE
      P(14) = FAR
      DO 30 I = 1, NLAM
         P(14+2*NU+NQ+I) = SIZ(I)
   30 CONTINUE
      END
      SUBROUTINE GSPBH( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT,
     $                  XW, HC, SIZ, P, H, REST )
C
C     PURPOSE
C     For GSPBG: the time H until the constraints have turned by 0.3 rad
C     or a little less (rows that are nothing at X apart), 0 if they
C     hardly turn; SIZ, the largest lengths of their rows so far and
C     then; REST, 1 if the speeds hardly move the scene until then.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, REST
      DOUBLE PRECISION   T, X(*), HMAX, CST(*), F(*), XT(*), XW(*),
     $                   HC(NLAM,*), SIZ(*), P(*), H
      DOUBLE PRECISION   TURN, BIG, S, R, BYU, WAY
      EXTERNAL           GSPBV
      INTEGER            I, J, K, L, IM, IH, LAST
C
      IM  = 14 + 2*NU + NQ
      IH  = IM + NU + 5*NLAM + 10
      H   = 0.0D0
      BIG = 0.0D0
      LAST = 0
      DO 60 K = 0, 42
         DO 10 I = 1, NLAM
            SIZ(I) = P(IM+I)
   10    CONTINUE
         CALL GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW,
     $               SIZ, P, L )
         TURN = 1.0D300
         IF ( L.LT.0 ) GO TO 50
         TURN = 0.0D0
         DO 40 I = 1, NLAM
            S = 0.0D0
            R = 0.0D0
            DO 20 J = 1, NU
               IF ( K.EQ.0 ) HC(I,J) = P(IH+I+NLAM*(J-1))
               R = R + HC(I,J)**2
               S = S + ( P(IH+I+NLAM*(J-1)) - HC(I,J) )**2
   20       CONTINUE
            IF ( K.EQ.0 ) BIG = MAX( BIG, R )
            IF ( R.GT.1.0D-6*BIG ) TURN = MAX( TURN, S/R )
   40    CONTINUE
   50    IF ( LAST.EQ.1 ) GO TO 70
         IF ( TURN.GT.0.09D0 .OR. K.EQ.41 ) THEN
            LAST = 1
            IF ( TURN.GT.0.09D0 ) H = 0.5D0*H
            IF ( K.LT.2 ) H = 0.0D0
         ELSE
            H = HMAX*0.5D0**( 40 - K )
         END IF
   60 CONTINUE
   70 IF ( .NOT.( TURN.GE.1.0D-4 .AND. TURN.LE.0.09D0 ) ) H = 0.0D0
C
C     -- the way there, what the speeds alone do of it
      CALL KIN( T, X, X(NQ+1), CST, XW )
      BYU = 0.0D0
      WAY = 0.0D0
      DO 80 I = 1, NQ
         BYU = MAX( BYU, ABS( H*XW(I) ) )
         WAY = MAX( WAY, ABS( XT(I) - X(I) ) )
   80 CONTINUE
      REST = 0
      IF ( BYU.LE.1.0D-3*WAY ) REST = 1
      END
      SUBROUTINE GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW,
     $                  SIZ, P, RANK )
C
C     PURPOSE
C     The pivots of the constraints H behind T on the path from X with
C     the accelerations in F, as GSLPV leaves them in P, the lengths of
C     rows in SIZ; RANK, or -1 where CON fails.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, RANK
      DOUBLE PRECISION   T, X(*), H, CST(*), F(*), XT(*), XW(*), SIZ(*),
     $                   P(*)
      DOUBLE PRECISION   LEAST
      EXTERNAL           GSLPV
      INTEGER            I, IW, IH, IY, IB, IP, IS, INFO
C
      IW = 15 + 3*NU + NQ + 2*NLAM
      IH = IW + 3*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      CALL KIN( T, X, X(NQ+1), CST, XT )
      CALL KIN( T, X, F(NQ+1), CST, XW )
      DO 10 I = 1, NQ
         XT(I) = X(I) + H*( XT(I) + 0.5D0*H*XW(I) )
   10 CONTINUE
      RANK = -1
      CALL CON( T + H, XT, X(NQ+1), CST, P(IW), P(IW+NLAM), P(IH), NLAM,
     $          P(IW+2*NLAM), INFO )
      IF ( INFO.NE.0 .AND. INFO.NE.2 ) RETURN
      CALL GSLPV( NU, NLAM, P(IH), SIZ, P(IY), P(IP), P(IB), P(IS),
     $            RANK, LEAST )
      END
      SUBROUTINE GSPBC( KIN, T, X, TC, D, NQ, NX, NS, CST, F, XW, GAP )
C
C     PURPOSE
C     How far the speeds of X at T differ from those of the step of
C     GSPSG with the stages F, as rates of coordinates, beside the
C     largest.  XW is workspace of NQ entries.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NX, NS
      DOUBLE PRECISION   T, X(*), TC, D, CST(*), F(NX,13), XW(*), GAP
      DOUBLE PRECISION   C(12), WT(12), P(12), P0(12), B(12), S, BIG
      EXTERNAL           GSGLN, GSLGP
      INTEGER            I, J, K
C
      CALL GSGLN( NS, C, WT )
      CALL GSLGP( NS, ( T - TC )/D, P0 )
      DO 20 K = 1, NS
         CALL GSLGP( NS, C(K), P )
         S = 0.0D0
         DO 10 J = 1, NS
            S = S + ( DBLE( J ) - 0.5D0 )*P(J)*P0(J)
   10    CONTINUE
         B(K) = WT(K)*S
   20 CONTINUE
      CALL KIN( T, X, X(NQ+1), CST, XW )
      GAP = 0.0D0
      BIG = 0.0D0
      DO 40 I = 1, NQ
         S = 0.0D0
         DO 30 K = 1, NS
            S = S + B(K)*F(I,K+1)
   30    CONTINUE
         GAP = MAX( GAP, ABS( S - XW(I) ) )
         BIG = MAX( BIG, ABS( XW(I) ) )
   40 CONTINUE
      IF ( BIG.GT.0.0D0 ) GAP = GAP/BIG
      END
