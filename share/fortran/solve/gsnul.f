      SUBROUTINE GSNUL( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $                  W, INFO )
C
C     PURPOSE
C     The way 2 of GSACC.  H'*P = Q*R, Q = (Q1,Q2), K = Q2; with
C     UD = Q*(w,z): R1'*w = P'*G, and R*P'*LAM = Q1'*( A*UD - F ).
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), TOL, UD(*),
     $                   LAM(*), W(*)
      DOUBLE PRECISION   S
      EXTERNAL           GSQRG, GSQMV, GSMUL, GSRED, GSLNM
      INTEGER            I, J, R, IY, IC, IZ, IT, IP, IB, IS, IQ
C
C     -- workspace: reduced matrix, Y, c, w, T, pivots, beta, sizes,
C        spare
      IY = 1 + N*N
      IC = IY + N*M
      IZ = IC + N
      IT = IZ + N
      IP = IT + M*M
      IB = IP + M
      IS = IB + M
      IQ = IS + M
C
      DO 20 I = 1, N
         DO 10 J = 1, M
            W(IY+I-1+N*(J-1)) = H(J,I)
   10    CONTINUE
         W(IZ+I-1) = 0.0D0
   20 CONTINUE
      CALL GSQRG( N, M, W(IY), N, TOL, GRP, W(IP), W(IB), W(IS), R )
C
C     -- w, and c = Q'*( F - A*Q1*w )
      DO 40 J = 1, R
         S = G(NINT( W(IP+J-1) ))
         DO 30 I = 1, J - 1
            S = S - W(IY+I-1+N*(J-1))*W(IZ+I-1)
   30    CONTINUE
         W(IZ+J-1) = S/W(IY+J-1+N*(J-1))
   40 CONTINUE
      DO 50 I = 1, N
         UD(I) = W(IZ+I-1)
   50 CONTINUE
      CALL GSQMV( N, R, W(IY), N, W(IB), UD, 0 )
      CALL GSMUL( N, A, LDA, UD, W(IC) )
      DO 60 I = 1, N
         W(IC+I-1) = F(I) - W(IC+I-1)
   60 CONTINUE
      CALL GSQMV( N, R, W(IY), N, W(IB), W(IC), 1 )
C
C     -- the reduced equations
      DO 90 J = R + 1, N
         DO 70 I = 1, N
            UD(I) = 0.0D0
   70    CONTINUE
         UD(J) = 1.0D0
         CALL GSQMV( N, R, W(IY), N, W(IB), UD, 0 )
         CALL GSMUL( N, A, LDA, UD, W(1+N*(J-1)) )
         CALL GSQMV( N, R, W(IY), N, W(IB), W(1+N*(J-1)), 1 )
   90 CONTINUE
      CALL GSRED( N, R, A, LDA, W, W(IC), INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 100 I = 1, N
         UD(I) = W(IZ+I-1)
         IF ( I.GT.R ) UD(I) = W(IC+I-1)
  100 CONTINUE
      CALL GSQMV( N, R, W(IY), N, W(IB), UD, 0 )
C
C     -- multipliers
      CALL GSMUL( N, A, LDA, UD, W(IC) )
      DO 110 I = 1, N
         W(IC+I-1) = W(IC+I-1) - F(I)
  110 CONTINUE
      CALL GSQMV( N, R, W(IY), N, W(IB), W(IC), 1 )
      IF ( R.EQ.M ) THEN
         DO 130 J = R, 1, -1
            S = W(IC+J-1)/W(IY+J-1+N*(J-1))
            LAM(NINT( W(IP+J-1) )) = S
            DO 120 I = 1, J - 1
               W(IC+I-1) = W(IC+I-1) - W(IY+I-1+N*(J-1))*S
  120       CONTINUE
  130    CONTINUE
      ELSE
         INFO = 2
         CALL GSLNM( M, R, W(IY), N, W(IP), W(IC), LAM, W(IT), W(IQ),
     $               W(IB), W(IS) )
      END IF
      END
