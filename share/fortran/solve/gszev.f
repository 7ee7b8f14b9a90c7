      SUBROUTINE GSZEV( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $                  W, INFO )
C
C     PURPOSE
C     The way 3 of GSACC.  D*H*V = U*S (D scales the rows), V = (V1,V2)
C     with S2 = 0: p = V1*inv(S1)*U1'*D*G, K = V2, and
C     LAM = D*U1*inv(S1)*V1'*( A*UD - F ) if the rank is full.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), TOL, UD(*),
     $                   LAM(*), W(*)
      DOUBLE PRECISION   S
      EXTERNAL           GSSVD, GSROW, GSMUL, GSRED, GSLAM
      INTEGER            I, J, K, R, IV, IH, IC, IZ, IS, ID
C
C     -- workspace: reduced matrix, V, D*H, A*v, F - A*p, singular
C        values and then the reduced right side, scales
      IV = 1 + N*N
      IH = IV + N*N
      IC = IH + N*M
      IZ = IC + N
      IS = IZ + N
      ID = IS + N
      CALL GSROW( N, M, H, LDH, GRP, W(IH), W(ID) )
      CALL GSSVD( M, N, W(IH), M, W(IV), N, W(IS), TOL, R )
C
C     -- p, and F - A*p
      DO 10 I = 1, N
         UD(I) = 0.0D0
   10 CONTINUE
      DO 40 J = 1, R
         S = 0.0D0
         DO 20 K = 1, M
            S = S + W(IH+K-1+M*(J-1))*W(ID+K-1)*G(K)
   20    CONTINUE
         S = S/W(IS+J-1)/W(IS+J-1)
         DO 30 I = 1, N
            UD(I) = UD(I) + W(IV+I-1+N*(J-1))*S
   30    CONTINUE
   40 CONTINUE
      CALL GSMUL( N, A, LDA, UD, W(IC) )
      DO 50 I = 1, N
         W(IZ+I-1) = F(I) - W(IC+I-1)
   50 CONTINUE
C
C     -- the reduced equations
      DO 90 J = R + 1, N
         CALL GSMUL( N, A, LDA, W(IV+N*(J-1)), W(IC) )
         DO 70 K = J, N
            S = 0.0D0
            DO 60 I = 1, N
               S = S + W(IV+I-1+N*(K-1))*W(IC+I-1)
   60       CONTINUE
            W(K+N*(J-1)) = S
   70    CONTINUE
         S = 0.0D0
         DO 80 I = 1, N
            S = S + W(IV+I-1+N*(J-1))*W(IZ+I-1)
   80    CONTINUE
         W(IS+J-1) = S
   90 CONTINUE
      CALL GSRED( N, R, A, LDA, W, W(IS), INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 110 J = R + 1, N
         DO 100 I = 1, N
            UD(I) = UD(I) + W(IV+I-1+N*(J-1))*W(IS+J-1)
  100    CONTINUE
  110 CONTINUE
C
C     -- multipliers
      IF ( R.LT.M ) THEN
         CALL GSLAM( N, M, A, LDA, H, LDH, F, TOL, GRP, UD, LAM, W )
         INFO = 2
         RETURN
      END IF
      CALL GSMUL( N, A, LDA, UD, W(IC) )
      DO 120 K = 1, M
         LAM(K) = 0.0D0
  120 CONTINUE
      DO 150 J = 1, R
         S = 0.0D0
         DO 130 I = 1, N
            S = S + W(IV+I-1+N*(J-1))*( W(IC+I-1) - F(I) )
  130    CONTINUE
         S = S/W(IS+J-1)/W(IS+J-1)
         DO 140 K = 1, M
            LAM(K) = LAM(K) + W(IH+K-1+M*(J-1))*S*W(ID+K-1)
  140    CONTINUE
  150 CONTINUE
      END
