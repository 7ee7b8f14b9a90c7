      SUBROUTINE GSKDS( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $                  W, INFO )
C
C     PURPOSE
C     The way 4 of GSACC.  D*H*P = Q*(R1,R2) (D scales the rows, columns
C     are chosen by size); the first R speeds depend on the others:
C     ud1 = d + C*ud2, C = -inv(R1)*R2, d = inv(R1)*Q1'*D*G.  The
C     partial velocities of the others are those of Kane's equations:
C        ( C'*A11*C + C'*A12 + A21*C + A22 )*ud2
C           = F2 + C'*F1 - ( A21 + C'*A11 )*d,
C     LAM = D*Q1*inv(R1')*( A*UD - F )1 if the rank is full.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, GRP(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), TOL, UD(*),
     $                   LAM(*), W(*)
      DOUBLE PRECISION   S
      EXTERNAL           GSROW, GSQRC, GSQMV, GSRED, GSLAM
      INTEGER            I, J, K, R, NF, IE, IH, IB, IP, IS, IC, ID, IG,
     $                   IA, IX
C
C     -- workspace: reduced matrix, E, D*H, beta, pivots, sizes, right
C        side, scales, D*G
      IE = 1 + N*N
      IH = IE + N*N
      IB = IH + N*M
      IP = IB + N
      IS = IP + N
      IC = IS + N
      ID = IC + N
      IG = ID + M
      CALL GSROW( N, M, H, LDH, GRP, W(IH), W(ID) )
      DO 10 K = 1, M
         W(IG+K-1) = W(ID+K-1)*G(K)
   10 CONTINUE
      CALL GSQRC( M, N, W(IH), M, TOL, W(IP), W(IB), W(IS), R )
      CALL GSQMV( M, R, W(IH), M, W(IB), W(IG), 1 )
      NF = N - R
C
C     -- C over R2, d over Q'*D*G
      DO 40 J = R + 1, N + 1
         IX = IH + M*( J - 1 ) - 1
         IF ( J.EQ.N + 1 ) IX = IG - 1
         DO 30 I = R, 1, -1
            S = W(IX+I)
            IF ( J.LE.N ) S = -S
            DO 20 K = I + 1, R
               S = S - W(IH+I-1+M*(K-1))*W(IX+K)
   20       CONTINUE
            W(IX+I) = S/W(IH+I-1+M*(I-1))
   30    CONTINUE
   40 CONTINUE
C
C     -- E = A11*C + A12 (R by NF), e = A*d in the order of P
      DO 70 J = 1, NF
         DO 60 I = 1, R
            IA = NINT( W(IP+I-1) )
            K  = NINT( W(IP+R+J-1) )
            S  = A(MAX(IA,K),MIN(IA,K))
            DO 50 K = 1, R
               IX = NINT( W(IP+K-1) )
               S  = S + A(MAX(IA,IX),MIN(IA,IX))
     $                  *W(IH+K-1+M*(R+J-1))
   50       CONTINUE
            W(IE+I-1+N*(J-1)) = S
   60    CONTINUE
   70 CONTINUE
      DO 90 I = 1, N
         IA = NINT( W(IP+I-1) )
         S  = F(IA)
         DO 80 K = 1, R
            IX = NINT( W(IP+K-1) )
            S  = S - A(MAX(IA,IX),MIN(IA,IX))*W(IG+K-1)
   80    CONTINUE
         W(IC+I-1) = S
   90 CONTINUE
C
C     -- the reduced equations: A22 + C'*E + (A12'*C)
      DO 130 J = 1, NF
         DO 120 I = J, NF
            IA = NINT( W(IP+R+I-1) )
            IX = NINT( W(IP+R+J-1) )
            S  = A(MAX(IA,IX),MIN(IA,IX))
            DO 110 K = 1, R
               IX = NINT( W(IP+K-1) )
               S  = S + W(IH+K-1+M*(R+I-1))*W(IE+K-1+N*(J-1))
     $              + A(MAX(IA,IX),MIN(IA,IX))*W(IH+K-1+M*(R+J-1))
  110       CONTINUE
            W(R+I+N*(R+J-1)) = S
  120    CONTINUE
         DO 125 K = 1, R
            W(IC+R+J-1) = W(IC+R+J-1) + W(IH+K-1+M*(R+J-1))*W(IC+K-1)
  125    CONTINUE
  130 CONTINUE
      CALL GSRED( N, R, A, LDA, W, W(IC), INFO )
      IF ( INFO.NE.0 ) RETURN
C
C     -- all speeds; what acts on the dependent ones: A*UD - F
      DO 150 I = 1, N
         IF ( I.LE.R ) THEN
            S = W(IG+I-1)
            DO 140 J = 1, NF
               S = S + W(IH+I-1+M*(R+J-1))*W(IC+R+J-1)
  140       CONTINUE
         ELSE
            S = W(IC+I-1)
         END IF
         UD(NINT( W(IP+I-1) )) = S
  150 CONTINUE
      IF ( R.LT.M ) THEN
         CALL GSLAM( N, M, A, LDA, H, LDH, F, TOL, GRP, UD, LAM, W )
         INFO = 2
         RETURN
      END IF
      DO 180 I = 1, R
         S = -W(IC+I-1)
         DO 160 J = 1, NF
            S = S + W(IE+I-1+N*(J-1))*W(IC+R+J-1)
  160    CONTINUE
         DO 170 K = 1, I - 1
            S = S - W(IH+K-1+M*(I-1))*LAM(K)
  170    CONTINUE
         LAM(I) = S/W(IH+I-1+M*(I-1))
  180 CONTINUE
      CALL GSQMV( M, R, W(IH), M, W(IB), LAM, 0 )
      DO 190 K = 1, M
         LAM(K) = LAM(K)*W(ID+K-1)
  190 CONTINUE
      END
