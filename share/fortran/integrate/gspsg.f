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
