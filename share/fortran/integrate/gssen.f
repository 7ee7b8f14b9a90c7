      SUBROUTINE GSSEN( RHP, T, NTOP, NX, NV, NP, NC, COL, X, V, CST, W,
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
C     NTOP    (input) INTEGER, the number of coordinates if the speeds
C             are their rates, whatever the parameters are: their rows
C             need no products; else 0.
C     NX, NV, NP (input) INTEGER, the numbers of states, inputs and
C             parameters of RHP.
C     NC      (input) INTEGER, the number of columns of S.
C     COL     (input) INTEGER array, dimension (NC): which column of P
C             belongs to each column of S; 0: none, S is then by a start
C             value.
C     X       (input) DOUBLE PRECISION array, dimension (NX*(1+NC)): the
C             states, then S, column after column.
C     V       (input) DOUBLE PRECISION array, dimension (NV).
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (NX*(NX+NP+NV+1)).
C     XD      (output) DOUBLE PRECISION array, dimension (NX*(1+NC)).
C     INFO    (output) INTEGER, that of RHP, but 9 where the constraints
C             have lost rank: there are no derivatives there.
C
      IMPLICIT NONE
      EXTERNAL           RHP, GSSE1, GSSE4
      INTEGER            NTOP, NX, NV, NP, NC, COL(*), INFO
      DOUBLE PRECISION   T, X(NX,*), V(*), CST(*), W(NX,*), XD(NX,*)
      INTEGER            I, K, P(4)
C
      CALL RHP( T, X, V, CST, W(1,NX+1), NX, W, NX, W(1,NX+NP+1), NX,
     $          XD, INFO )
      IF ( INFO.EQ.2 ) INFO = 9
      IF ( INFO.NE.0 ) RETURN
C
C     -- a column of zeros for start values
      DO 10 I = 1, NX
         W(I,NX+NP+NV+1) = 0.0D0
   10 CONTINUE
      DO 30 K = 1, NC
         P(1+MOD( K-1, 4 )) = NX + COL(K)
         IF ( COL(K).EQ.0 ) P(1+MOD( K-1, 4 )) = NX + NP + NV + 1
         IF ( MOD( K, 4 ).EQ.0 ) THEN
            CALL GSSE4( NTOP, NX, W, W(1,P(1)), W(1,P(2)), W(1,P(3)),
     $                  W(1,P(4)), X(1,MAX( K-2, 1 )),
     $                  XD(1,MAX( K-2, 1 )) )
         ELSE IF ( K.GT.NC - MOD( NC, 4 ) ) THEN
            CALL GSSE1( NTOP, NX, W, W(1,P(1+MOD( K-1, 4 ))), X(1,K+1),
     $                  XD(1,K+1) )
         END IF
   30 CONTINUE
      END
      SUBROUTINE GSSE4( NTOP, N, A, P1, P2, P3, P4, S, R )
C
C     PURPOSE
C     R = P + A*S of four columns, part of GSSEN.
C
      IMPLICIT NONE
      INTEGER            NTOP, N
      DOUBLE PRECISION   A(N,*), P1(*), P2(*), P3(*), P4(*), S(N,4),
     $                   R(N,4)
      DOUBLE PRECISION   R1, R2, R3, R4
      INTEGER            I, J
C
      DO 10 I = 1, NTOP
         R(I,1) = P1(I) + S(NTOP+I,1)
         R(I,2) = P2(I) + S(NTOP+I,2)
         R(I,3) = P3(I) + S(NTOP+I,3)
         R(I,4) = P4(I) + S(NTOP+I,4)
   10 CONTINUE
      DO 30 I = NTOP + 1, N
         R1 = P1(I)
         R2 = P2(I)
         R3 = P3(I)
         R4 = P4(I)
         DO 20 J = 1, N
            R1 = R1 + A(I,J)*S(J,1)
            R2 = R2 + A(I,J)*S(J,2)
            R3 = R3 + A(I,J)*S(J,3)
            R4 = R4 + A(I,J)*S(J,4)
   20    CONTINUE
         R(I,1) = R1
         R(I,2) = R2
         R(I,3) = R3
         R(I,4) = R4
   30 CONTINUE
      END
      SUBROUTINE GSSE1( NTOP, N, A, P, S, R )
C
C     PURPOSE
C     R = P + A*S of one column, part of GSSEN.
C
      IMPLICIT NONE
      INTEGER            NTOP, N
      DOUBLE PRECISION   A(N,*), P(*), S(*), R(*)
      DOUBLE PRECISION   R1
      INTEGER            I, J
C
      DO 10 I = 1, NTOP
         R(I) = P(I) + S(NTOP+I)
   10 CONTINUE
      DO 30 I = NTOP + 1, N
         R1 = P(I)
         DO 20 J = 1, N
            R1 = R1 + A(I,J)*S(J)
   20    CONTINUE
         R(I) = R1
   30 CONTINUE
      END
