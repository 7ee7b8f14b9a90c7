C     Scene gy, emitted by GSMBP.
C
C     Units SI. Call PAR and PRE once; every other routine takes CST.
C
      SUBROUTINE GY_PAR( PAR )
C
C     PURPOSE
C     Parameters of the scene: their values in SI units.
C
C     ARGUMENTS
C     PAR     (output) DOUBLE PRECISION array, dimension (*),
C             parameters.
C
C     METHOD
C     Straight-line code; every quantity that occurs twice is named
C     once.
C
C     OPERATIONS
C     0 mul, 0 add, 0 div, 0 sqrt, 0 trig
C
      IMPLICIT NONE
      DOUBLE PRECISION   PAR(*)
C
      END

      SUBROUTINE GY_PRE( PAR, CST, INFO )
C
C     PURPOSE
C     Everything that depends on parameters alone, once.
C
C     ARGUMENTS
C     PAR     (input) DOUBLE PRECISION array, dimension (*), parameters
C             none.
C     CST     (output) DOUBLE PRECISION array, dimension (*), constants:
C             the parameters, then what depends on them alone.
C     INFO    (output) INTEGER, see ERROR INDICATOR.
C
C     METHOD
C     Straight-line code; every quantity that occurs twice is named
C     once.
C
C     ERROR INDICATOR
C     INFO = 0: ok
C     INFO = -i: argument i is bad
C
C     OPERATIONS
C     0 mul, 0 add, 0 div, 0 sqrt, 0 trig
C
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   PAR(*), CST(*)
C
      INFO = 0
      IF ( INFO.NE.0 ) RETURN
      END

      SUBROUTINE GY_INV( T, Q, U, UD, V, CST, TAU )
C
C     PURPOSE
C     Inverse dynamics of the tree: TAU = M*UD + N + G - passive and
C     given forces.
C
C     ARGUMENTS
C     T       (input) DOUBLE PRECISION, time [s].
C     Q       (input) DOUBLE PRECISION array, dimension (2), coordinates
C             q1, q2.
C     U       (input) DOUBLE PRECISION array, dimension (2), speeds
C             q1_d, q2_d.
C     UD      (input) DOUBLE PRECISION array, dimension (2),
C             accelerations q1_dd, q2_dd.
C     V       (input) DOUBLE PRECISION array, dimension (*), inputs
C             none.
C     CST     (input) DOUBLE PRECISION array, dimension (*), constants,
C             from PRE.
C     TAU     (output) DOUBLE PRECISION array, dimension (2), efforts on
C             the coordinates [N*m or N].
C
C     METHOD
C     Straight-line code; every quantity that occurs twice is named
C     once.
C     GSSC gives the sine and cosine of an angle.
C
C     OPERATIONS
C     9 mul, 5 add, 0 div, 0 sqrt, 2 trig
C
      IMPLICIT NONE
      DOUBLE PRECISION   T, Q(2), U(2), UD(2), V(*), CST(*), TAU(2)
      EXTERNAL GSSC
      DOUBLE PRECISION   SQ2, CQ2, Z1, Q2, Q1_D, Q2_D, Q1_DD, Q2_DD
C
      Q2 = Q(2)
C     -- sines and cosines
      CALL GSSC( Q2, SQ2, CQ2 )
      Q1_D = U(1)
      Q2_D = U(2)
      Q1_DD = UD(1)
      Q2_DD = UD(2)
C     -- motion of link 2
      Z1 = Q1_D*SQ2
C     -- results
      TAU(1) = 3.0D0*(Q1_DD - Q2_D*SQ2)
     $   + CQ2*(CQ2*Q1_DD - 2.0D0*Q2_D*Z1)
      TAU(2) = Q2_DD + (3.0D0 + CQ2*Q1_D)*Z1
      END

      SUBROUTINE GY_BIA( T, Q, U, V, CST, B )
C
C     PURPOSE
C     Bias forces of the tree: B = N + G - passive and given forces.
C
C     ARGUMENTS
C     T       (input) DOUBLE PRECISION, time [s].
C     Q       (input) DOUBLE PRECISION array, dimension (2), coordinates
C             q1, q2.
C     U       (input) DOUBLE PRECISION array, dimension (2), speeds
C             q1_d, q2_d.
C     V       (input) DOUBLE PRECISION array, dimension (*), inputs
C             none.
C     CST     (input) DOUBLE PRECISION array, dimension (*), constants,
C             from PRE.
C     B       (output) DOUBLE PRECISION array, dimension (2), N + G -
C             passive and given forces [N*m or N].
C
C     METHOD
C     Straight-line code; every quantity that occurs twice is named
C     once.
C     GSSC gives the sine and cosine of an angle.
C
C     OPERATIONS
C     7 mul, 2 add, 0 div, 0 sqrt, 2 trig
C
      IMPLICIT NONE
      DOUBLE PRECISION   T, Q(2), U(2), V(*), CST(*), B(2)
      EXTERNAL GSSC
      DOUBLE PRECISION   SQ2, CQ2, Z1, Q2, Q1_D, Q2_D
C
      Q2 = Q(2)
C     -- sines and cosines
      CALL GSSC( Q2, SQ2, CQ2 )
      Q1_D = U(1)
      Q2_D = U(2)
C     -- motion of link 2
      Z1 = Q1_D*SQ2
C     -- results
      B(1) = -Q2_D*(3.0D0*SQ2 + 2.0D0*CQ2*Z1)
      B(2) = (3.0D0 + CQ2*Q1_D)*Z1
      END

      SUBROUTINE GY_FWD( T, Q, U, V, TAU, CST, UD, INFO )
C
C     PURPOSE
C     Forward dynamics of the tree: UD = M\(TAU - B).
C
C     ARGUMENTS
C     T       (input) DOUBLE PRECISION, time [s].
C     Q       (input) DOUBLE PRECISION array, dimension (2), coordinates
C             q1, q2.
C     U       (input) DOUBLE PRECISION array, dimension (2), speeds
C             q1_d, q2_d.
C     V       (input) DOUBLE PRECISION array, dimension (*), inputs
C             none.
C     TAU     (input) DOUBLE PRECISION array, dimension (2), efforts on
C             the coordinates [N*m or N].
C     CST     (input) DOUBLE PRECISION array, dimension (*), constants,
C             from PRE.
C     UD      (output) DOUBLE PRECISION array, dimension (2),
C             accelerations.
C     INFO    (output) INTEGER, see ERROR INDICATOR.
C
C     METHOD
C     Straight-line code; every quantity that occurs twice is named
C     once.
C     GSSC gives the sine and cosine of an angle.
C
C     ERROR INDICATOR
C     INFO = 0: ok
C     INFO = -i: argument i is bad
C     INFO = 1: the mass matrix is not positive definite
C
C     OPERATIONS
C     8 mul, 5 add, 1 div, 0 sqrt, 2 trig
C
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, Q(2), U(2), V(*), TAU(2), CST(*), UD(2)
      DOUBLE PRECISION PIV(2), DIA(2)
      INTEGER I
      EXTERNAL GSSC
      DOUBLE PRECISION   SQ2, CQ2, Z1, C1J33, Q2, Q1_D, Q2_D, TAU_IN1,
     $   TAU_IN2
C
      INFO = 0
      IF ( .NOT.( ABS(Q(1)).LE.1.0D300 .AND. ABS(Q(2)).LE.1.0D300 ) )
     $   INFO = -2
      IF ( .NOT.( ABS(U(1)).LE.1.0D300 .AND. ABS(U(2)).LE.1.0D300 ) )
     $   INFO = -3
      IF ( .NOT.( ABS(TAU(1)).LE.1.0D300 .AND. ABS(TAU(2)).LE.1.0D300 )
     $   ) INFO = -5
      IF ( INFO.NE.0 ) RETURN
C
      Q2 = Q(2)
C     -- sines and cosines
      CALL GSSC( Q2, SQ2, CQ2 )
      Q1_D = U(1)
      Q2_D = U(2)
      TAU_IN1 = TAU(1)
      TAU_IN2 = TAU(2)
C     -- motion of link 2
      Z1 = Q1_D*SQ2
C     -- composite body of link 2
      C1J33 = 4.0D0 - SQ2**2
C     -- results
      UD(1) = (TAU_IN1 + Q2_D*(3.0D0*SQ2 + 2.0D0*CQ2*Z1))/C1J33
      UD(2) = TAU_IN2 + (-3.0D0 - CQ2*Q1_D)*Z1
      PIV(1) = C1J33
      PIV(2) = 1.0D0
      DIA(1) = C1J33
      DIA(2) = 1.0D0
      DO 10 I = 1, 2
        IF ( .NOT.( PIV(I).GT.1.0D-14*DIA(I) ) ) INFO = 1
   10 CONTINUE
      END

