      SUBROUTINE GSACC( WAY, N, M, A, LDA, H, LDH, F, G, UD, LAM, W,
     $                  INFO )
C
C     PURPOSE
C     GSACR for rows that are measured each by itself and known to
C     rounding errors: INFO = 2 where they are dependent to about 1D-11.
C
      IMPLICIT NONE
      INTEGER            WAY, N, M, LDA, LDH, INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), UD(*), LAM(*),
     $                   W(*)
      DOUBLE PRECISION   GSEPS
      INTEGER            GRP(1)
      EXTERNAL           GSEPS, GSACR
C
      GRP(1) = 0
      CALL GSACR( WAY, N, M, A, LDA, H, LDH, F, G, 5.0D4*GSEPS(), GRP,
     $            UD, LAM, W, INFO )
      END
      SUBROUTINE GSACR( WAY, N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD,
     $                  LAM, W, INFO )
C
C     PURPOSE
C     Accelerations and multipliers of a system with constraints,
C        A*UD - H'*LAM = F,   H*UD = G,
C     in one of four ways.
C
C     ARGUMENTS
C     WAY     (input) INTEGER:
C             1  multipliers (GSKKR);
C             2  null space of H, the orthogonal complement of its rows,
C                from a QR factorization of H';
C             3  eigenvectors of H'*H to the eigenvalue zero (zero-
C                eigenvalue theorem), from singular values of H;
C             4  Kane's equations with dependent speeds: a set of
C                independent ones chosen by size, the others eliminated.
C     N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM (as GSKKR, but in
C             the ways 2, 3, 4 without the metric of A)
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (2*N*N + N*M + M*M + 4*N + 8*M).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     2, 3, 4: UD = p + K*z, H*K = 0, H*p = G;
C     K'*A*K*z = K'*( F - A*p ).  LAM is the solution of least norm of
C     H'*LAM = A*UD - F.  A may be semidefinite as long as K'*A*K is
C     definite.  3 and 4 divide the rows of H by their sizes first.
C
C     REFERENCES
C     1 Ju and Hsu 1991, (25).
C     2 Kim and Vanderploeg 1986, QR decomposition for state space
C       representation of constrained mechanical dynamic systems.
C     3 Walton and Steeves 1969, a new matrix theorem and its
C       application for establishing independent coordinates.
C     4 Kane and Levinson 1985, Dynamics, sections 2.13 and 4.4.
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = -i  argument i is out of range;
C     INFO = 1   A is not positive definite on the motions that H
C                allows: UD, LAM are zero;
C     INFO = 2   the constraints are dependent (to TOL): UD
C                fulfils the independent ones (and the others if they
C                are consistent), LAM is one of many.
C
      IMPLICIT NONE
      INTEGER            WAY, N, M, LDA, LDH, GRP(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), TOL, UD(*),
     $                   LAM(*), W(*)
      EXTERNAL           GSKKR, GSNUL, GSZEV, GSKDS
      INTEGER            I
C
      INFO = 0
      IF ( WAY.LT.1 .OR. WAY.GT.4 ) INFO = -1
      IF ( N.LT.0 ) INFO = -2
      IF ( M.LT.0 ) INFO = -3
      IF ( LDA.LT.MAX( 1, N ) ) INFO = -5
      IF ( LDH.LT.MAX( 1, M ) ) INFO = -7
      IF ( INFO.NE.0 ) RETURN
      IF ( WAY.EQ.1 .OR. N.EQ.0 .OR. M.EQ.0 ) THEN
         CALL GSKKR( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $               W, INFO )
      ELSE IF ( WAY.EQ.2 ) THEN
         CALL GSNUL( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $               W, INFO )
      ELSE IF ( WAY.EQ.3 ) THEN
         CALL GSZEV( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $               W, INFO )
      ELSE
         CALL GSKDS( N, M, A, LDA, H, LDH, F, G, TOL, GRP, UD, LAM,
     $               W, INFO )
      END IF
      IF ( INFO.EQ.1 ) THEN
         DO 10 I = 1, N
            UD(I) = 0.0D0
   10    CONTINUE
         DO 20 I = 1, M
            LAM(I) = 0.0D0
   20    CONTINUE
      END IF
      END
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
      SUBROUTINE GSMUL( N, A, LDA, X, Y )
C
C     PURPOSE
C     Y = A*X, A symmetric of order N with its lower triangle stored.
C
      IMPLICIT NONE
      INTEGER            N, LDA
      DOUBLE PRECISION   A(LDA,*), X(*), Y(*)
      DOUBLE PRECISION   R, S
      INTEGER            I, J
C
      DO 10 I = 1, N
         Y(I) = 0.0D0
   10 CONTINUE
      DO 30 J = 1, N
         S = X(J)
         R = A(J,J)*S
         DO 20 I = J + 1, N
            Y(I) = Y(I) + A(I,J)*S
            R = R + A(I,J)*X(I)
   20    CONTINUE
         Y(J) = Y(J) + R
   30 CONTINUE
      END
      SUBROUTINE GSRED( N, R, A, LDA, B, Z, INFO )
C
C     PURPOSE
C     The reduced equations of GSACC: rows and columns of B (N by N,
C     lower triangle, destroyed) and rows of Z behind R; Z becomes the
C     solution.  INFO = 1 if a pivot is not above the rounding errors of
C     A, else 0.
C
      IMPLICIT NONE
      INTEGER            N, R, LDA, INFO
      DOUBLE PRECISION   A(LDA,*), B(N,*), Z(*)
      DOUBLE PRECISION   GSEPS, TOL
      EXTERNAL           GSEPS, GSSPD
      INTEGER            J
C
      INFO = 0
      IF ( R.EQ.N ) RETURN
      TOL = 0.0D0
      DO 10 J = 1, N
         TOL = MAX( TOL, A(J,J) )
   10 CONTINUE
      TOL = 10.0D0*DBLE( N )*GSEPS()*TOL
      CALL GSSPD( N - R, 1, B(R+1,R+1), N, Z(R+1), N, INFO )
      IF ( INFO.NE.0 ) INFO = 1
      DO 20 J = R + 1, N
         IF ( .NOT.( B(J,J)*B(J,J).GT.TOL ) ) INFO = 1
   20 CONTINUE
      END
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
