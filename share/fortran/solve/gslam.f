      SUBROUTINE GSLAM( N, M, A, LDA, H, LDH, F, TOL, GRP, UD, LAM, W )
C
C     PURPOSE
C     The solution LAM of least norm of H'*LAM = A*UD - F, where the
C     constraints are dependent.  Arguments as GSACC.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*)
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), TOL, UD(*), LAM(*),
     $                   W(*)
      EXTERNAL           GSQRG, GSQMV, GSMUL, GSLNM
      INTEGER            I, J, R, IC, IT, IP, IB, IS, IQ
C
      IC = 1 + N*M
      IT = IC + N
      IP = IT + M*M
      IB = IP + M
      IS = IB + M
      IQ = IS + M
      CALL GSMUL( N, A, LDA, UD, W(IC) )
      DO 30 I = 1, N
         W(IC+I-1) = W(IC+I-1) - F(I)
         DO 20 J = 1, M
            W(I+N*(J-1)) = H(J,I)
   20    CONTINUE
   30 CONTINUE
      CALL GSQRG( N, M, W, N, TOL, GRP, W(IP), W(IB), W(IS), R )
      CALL GSQMV( N, R, W, N, W(IB), W(IC), 1 )
      CALL GSLNM( M, R, W, N, W(IP), W(IC), LAM, W(IT), W(IQ), W(IB),
     $            W(IS) )
      END
      SUBROUTINE GSROW( N, M, H, LDH, GRP, Y, D )
C
C     PURPOSE
C     Y = diag(D)*H, rows divided by their sizes (see GSQRG); a size
C     that is nothing to working precision beside the largest is
C     replaced by that.  Y is M by N.
C
      IMPLICIT NONE
      INTEGER            N, M, LDH, GRP(*)
      DOUBLE PRECISION   H(LDH,*), Y(M,*), D(*)
      DOUBLE PRECISION   GSEPS, TOL, S, BIG
      EXTERNAL           GSEPS, GSGRP
      INTEGER            I, J
C
      TOL = 1.0D2*GSEPS()
      BIG = 0.0D0
      DO 20 I = 1, M
         S = 0.0D0
         DO 10 J = 1, N
            S = S + H(I,J)*H(I,J)
   10    CONTINUE
         D(I) = SQRT( S )
         BIG  = MAX( BIG, D(I) )
   20 CONTINUE
      CALL GSGRP( M, GRP, 1.0D-3, D )
      IF ( .NOT.( BIG.GT.0.0D0 ) ) BIG = 1.0D0
      DO 40 I = 1, M
         S = D(I)
         IF ( S.LE.TOL*BIG ) S = BIG
         D(I) = 1.0D0/S
         DO 30 J = 1, N
            Y(I,J) = D(I)*H(I,J)
   30    CONTINUE
   40 CONTINUE
      END
