      SUBROUTINE GSSEN( RHP, T, NQ, NX, NV, NP, NC, COL, X, V, CST, W,
     $                  XD, INFO )
C
C     PURPOSE
C     The rates of states and, behind them, of their derivatives by
C     parameters: S' = A*S + P.
C
C     ARGUMENTS
C     RHP     (external) <NAME>_RHP( T, X, V, CST, P, LDP, A, LDA, B,
C             LDB, XD, INFO ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     NQ, NX, NV, NP (input) INTEGER, the numbers of coordinates,
C             states, inputs and parameters of RHP.
C     NC      (input) INTEGER, the number of columns of S.
C     COL     (input) INTEGER array, dimension (NC): which column of P
C             belongs to each column of S; 0: none, S is then by a start
C             value.
C     X       (input) DOUBLE PRECISION array, dimension (NX*(1+NC)): the
C             states, then S, column after column.
C     V       (input) DOUBLE PRECISION array, dimension (NV).
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (NX*(NX+NP+NV)).
C     XD      (output) DOUBLE PRECISION array, dimension (NX*(1+NC)).
C     INFO    (output) INTEGER, that of RHP, but 9 where the constraints
C             have lost rank: there are no derivatives there.
C
      IMPLICIT NONE
      EXTERNAL           RHP, GSSE1, GSSE4
      INTEGER            NQ, NX, NV, NP, NC, COL(*), INFO
      DOUBLE PRECISION   T, X(NX,*), V(*), CST(*), W(NX,*), XD(NX,*)
      INTEGER            I, J, K, FIRST
C
      CALL RHP( T, X, V, CST, W(1,NX+1), NX, W, NX, W(1,NX+NP+1), NX,
     $          XD, INFO )
      IF ( INFO.EQ.2 ) INFO = 9
      IF ( INFO.NE.0 ) RETURN
C
C     -- coordinates whose rates are the speeds: without products
      FIRST = NQ + 1
      DO 20 J = 1, NX
         DO 10 I = 1, NQ
            IF ( J.EQ.NQ + I ) THEN
               IF ( ABS( W(I,J) - 1.0D0 ).GT.0.0D0 ) FIRST = 1
            ELSE IF ( ABS( W(I,J) ).GT.0.0D0 ) THEN
               FIRST = 1
            END IF
   10    CONTINUE
   20 CONTINUE
      IF ( 2*NQ.GT.NX ) FIRST = 1
      DO 60 K = 1, NC
         DO 30 I = 1, NX
            XD(I,K+1) = 0.0D0
   30    CONTINUE
         IF ( COL(K).GT.0 ) THEN
            DO 40 I = 1, NX
               XD(I,K+1) = W(I,NX+COL(K))
   40       CONTINUE
         END IF
         DO 50 I = 1, FIRST - 1
            XD(I,K+1) = XD(I,K+1) + X(NQ+I,K+1)
   50    CONTINUE
   60 CONTINUE
      DO 70 K = 1, NC - 3, 4
         CALL GSSE4( NX, FIRST, W, X(1,K+1), XD(1,K+1) )
   70 CONTINUE
      DO 80 K = NC - MOD( NC, 4 ) + 1, NC
         CALL GSSE1( NX, FIRST, W, X(1,K+1), XD(1,K+1) )
   80 CONTINUE
      END
      SUBROUTINE GSSE4( N, FIRST, A, S, R )
C
C     PURPOSE
C     R = R + A*S of four columns, rows from FIRST on; part of GSSEN.
C
      IMPLICIT NONE
      INTEGER            N, FIRST
      DOUBLE PRECISION   A(N,*), S(N,4), R(N,4)
      DOUBLE PRECISION   B, S1, S2, S3, S4
      INTEGER            I, J
C
      DO 20 J = 1, N
         S1 = S(J,1)
         S2 = S(J,2)
         S3 = S(J,3)
         S4 = S(J,4)
C$OMP SIMD
         DO 10 I = FIRST, N
            B = A(I,J)
            R(I,1) = R(I,1) + B*S1
            R(I,2) = R(I,2) + B*S2
            R(I,3) = R(I,3) + B*S3
            R(I,4) = R(I,4) + B*S4
   10    CONTINUE
   20 CONTINUE
      END
      SUBROUTINE GSSE1( N, FIRST, A, S, R )
C
C     PURPOSE
C     R = R + A*S of one column, rows from FIRST on; part of GSSEN.
C
      IMPLICIT NONE
      INTEGER            N, FIRST
      DOUBLE PRECISION   A(N,*), S(N), R(N)
      INTEGER            I, J
C
      DO 20 J = 1, N
C$OMP SIMD
         DO 10 I = FIRST, N
            R(I) = R(I) + A(I,J)*S(J)
   10    CONTINUE
   20 CONTINUE
      END
