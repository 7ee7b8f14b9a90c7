      SUBROUTINE GSLNM( M, R, Y, LDY, PIV, C, LAM, T, Q, BETA, S )
C
C     PURPOSE
C     The multipliers of least norm, where constraints are dependent:
C        R1*P'*LAM = C,
C     R1 the R by M upper trapezoid that GSQRP leaves of H' = Q*R1*P'.
C
C     ARGUMENTS
C     M       (input) INTEGER, the number of constraints.
C     R       (input) INTEGER, the rank, 0 <= R <= M.
C     Y       (input) DOUBLE PRECISION array, dimension (LDY,M), from
C             GSQRP.
C     LDY     (input) INTEGER, LDY >= MAX(1,R).
C     PIV     (input) DOUBLE PRECISION array, dimension (M), from GSQRP.
C     C       (input) DOUBLE PRECISION array, dimension (R).
C     LAM     (output) DOUBLE PRECISION array, dimension (M).
C     T       (workspace) DOUBLE PRECISION array, dimension (M*M).
C     Q, BETA, S (workspace) DOUBLE PRECISION arrays, dimension (M).
C
C     METHOD
C     R1' = Q2*R2, P'*LAM = Q2*inv(R2')*C.
C
      IMPLICIT NONE
      INTEGER            M, R, LDY
      DOUBLE PRECISION   Y(LDY,*), PIV(*), C(*), LAM(*), T(*), Q(*),
     $                   BETA(*), S(*)
      DOUBLE PRECISION   D
      EXTERNAL           GSQRP, GSQMV
      INTEGER            I, J, K, R2, LM
C
      LM = MAX( 1, M )
      DO 5 K = 1, M
         LAM(K) = 0.0D0
    5 CONTINUE
      IF ( R.EQ.0 ) RETURN
      DO 20 J = 1, R
         DO 10 I = 1, M
            T(I+M*(J-1)) = 0.0D0
            IF ( I.GE.J ) T(I+M*(J-1)) = Y(J,I)
   10    CONTINUE
   20 CONTINUE
      CALL GSQRP( M, R, T, LM, 0.0D0, Q, BETA, S, R2 )
      DO 40 K = 1, R
         D = C(NINT( Q(K) ))
         DO 30 I = 1, K - 1
            D = D - T(I+M*(K-1))*S(I)
   30    CONTINUE
         S(K) = D/T(K+M*(K-1))
   40 CONTINUE
      DO 50 K = R + 1, M
         S(K) = 0.0D0
   50 CONTINUE
      CALL GSQMV( M, R, T, LM, BETA, S, 0 )
      DO 60 K = 1, M
         LAM(NINT( PIV(K) )) = S(K)
   60 CONTINUE
      END
