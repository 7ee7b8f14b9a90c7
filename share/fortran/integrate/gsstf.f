      SUBROUTINE GSSTF( RHS, CON, KIN, CMD, CLO, VIN, T, X, NQ, NU, NX,
     $                  NV, NLAM, IP, RP, CST, V, RTOL, ATOL, H, W, WI,
     $                  P, ISTAT, RHO, K )
C
C     PURPOSE
C     The largest eigenvalue of the right-hand side, by modulus, inputs
C     included: what bounds the step of an explicit method.
C
C     ARGUMENTS
C     As GSDP8, and
C     X       (input) DOUBLE PRECISION array, dimension (NX).
C     H       (input) DOUBLE PRECISION: an eigenvalue of which H times
C             the modulus is less than 1 is not looked for [s].
C     W       (workspace) DOUBLE PRECISION array, dimension (NX,4).
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics: entry 13
C             counts the calls of RHS.
C     RHO     (output) DOUBLE PRECISION, the estimate [1/s], or 0 if the
C             right-hand side could not be computed or if there is none.
C     K       (output) INTEGER, the state that moves most in the
C             direction of this eigenvalue, in its tolerance.
C
C     METHOD
C     The power method on differences of the right-hand side.  Lengths
C     are the largest entry, divided by ATOL(I)/RTOL + |X(I)|.  A real
C     eigenvalue shows itself by equal growth in succession; under a
C     pair of complex ones growth goes up and down, and its geometric
C     mean over the last 24 of 32 iterations is taken.
C     An eigenvalue RHO whose left vector has the part C of the first
C     direction lets N iterations grow by C*RHO**N or more.  Once they
C     have grown by less than 1E-4/H**N none with H*RHO above 1 is
C     left but where C is less than 1E-4, and that is the end.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*), K
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), RTOL, ATOL(*),
     $                   H, W(NX,4), WI(*), P(*), RHO
      DOUBLE PRECISION   GSEPS, S, D, GROWTH, OLD, SUM, PART, RST(20)
      EXTERNAL           GSEPS, GSFUN
      INTEGER            I, J, N, INFO, IST(20)
C
      RHO = 0.0D0
      K   = 1
      DO 10 I = 1, 20
         IST(I) = 0
         RST(I) = 0.0D0
   10 CONTINUE
      DO 20 I = 1, NX
         W(I,3) = X(I)
         W(I,4) = ABS( X(I) ) + 1.0D0
         IF ( RTOL.GT.0.0D0 ) W(I,4) = ABS( X(I) ) + ATOL(I)/RTOL
         IF ( .NOT.( W(I,4).GT.0.0D0 ) ) W(I,4) = 1.0D0
         W(I,2) = W(I,4)*( 0.5D0 + MOD( 0.618D0*DBLE( I ), 1.0D0 ) )
   20 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, W(1,3), NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, W, WI, P, IST, RST,
     $            INFO )
      IF ( INFO.NE.0 ) GO TO 200
      N   = 0
      OLD = 0.0D0
      SUM = 0.0D0
      PART = 1.0D0
      D   = SQRT( GSEPS() )
      DO 100 J = 1, 32
         S = 0.0D0
         DO 30 I = 1, NX
            S = MAX( S, ABS( W(I,2) )/W(I,4) )
   30    CONTINUE
         IF ( .NOT.( S.GT.0.0D0 .AND. S.LE.1.0D300 ) ) GO TO 200
         S = D/S
         DO 40 I = 1, NX
            W(I,3) = X(I) + S*W(I,2)
   40    CONTINUE
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, W(1,3), NQ, NU,
     $               NX, NV, NLAM, IP, RP, CST, V, W(1,2), WI, P, IST,
     $               RST, INFO )
         IF ( INFO.NE.0 ) GO TO 200
         GROWTH = 0.0D0
         DO 50 I = 1, NX
            W(I,2) = W(I,2) - W(I,1)
            S = ABS( W(I,2) )/W(I,4)
            IF ( S.GT.GROWTH ) THEN
               GROWTH = S
               K = I
            END IF
   50    CONTINUE
         GROWTH = GROWTH/D
         IF ( .NOT.( GROWTH.GT.0.0D0 ) ) GO TO 200
         N = N + 1
         IF ( ABS( GROWTH - OLD ).GT.0.02D0*GROWTH ) N = 0
         OLD = GROWTH
         IF ( J.GT.8 ) SUM = SUM + LOG( GROWTH )
         IF ( N.EQ.3 ) THEN
            RHO = GROWTH
            GO TO 200
         END IF
         PART = MIN( 1.0D300, PART*GROWTH*H )
         IF ( PART.LT.1.0D-4 ) GO TO 200
  100 CONTINUE
      RHO = EXP( SUM/24.0D0 )
  200 ISTAT(13) = ISTAT(13) + IST(1)
      END
