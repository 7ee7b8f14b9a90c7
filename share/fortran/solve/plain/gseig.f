      SUBROUTINE GSEIG( N, A, LDA, WR, WI, W, INFO )
C
C     PURPOSE
C     Eigenvalues of a general matrix.  Plain body: reduction to
C     Hessenberg form and QR steps.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A, N >= 0.
C     A       (input/output) DOUBLE PRECISION array, dimension (LDA,N),
C             destroyed.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     WR, WI  (output) DOUBLE PRECISION arrays, dimension (N): real and
C             imaginary parts.
C     W       (workspace) DOUBLE PRECISION array, dimension (4*N).
C     INFO    (output) INTEGER, 0, or > 0: not all were found.
C
C     METHOD
C     Householder reflections; Francis' double step with deflation, as
C     in EISPACK's HQR.
C
C     REFERENCES
C     Golub, van Loan, Matrix Computations, section 7.5.
C
      IMPLICIT NONE
      INTEGER            N, LDA, INFO
      DOUBLE PRECISION   A(LDA,*), WR(*), WI(*), W(*)
      EXTERNAL           GSHES, GSHQR
C
      CALL GSHES( N, A, LDA, W )
      CALL GSHQR( N, A, LDA, WR, WI, INFO )
      END
C
      SUBROUTINE GSHES( N, A, LDA, V )
C
C     PURPOSE
C     For GSEIG: a matrix similar to A with zeros below the first
C     subdiagonal.
C
C     ARGUMENTS
C     N, A, LDA as GSEIG.
C     V       (workspace) DOUBLE PRECISION array, dimension (N).
C
C     METHOD
C     Householder reflections from both sides.
C
      IMPLICIT NONE
      INTEGER            N, LDA, I, J, K
      DOUBLE PRECISION   A(LDA,*), V(*), S, H, T
C
      DO 90 K = 1, N - 2
         S = 0.0D0
         DO 10 I = K + 1, N
            S = MAX( S, ABS( A(I,K) ) )
   10    CONTINUE
         IF ( S.GT.0.0D0 ) THEN
            T = 0.0D0
            DO 20 I = K + 1, N
               V(I) = A(I,K)/S
               T = T + V(I)**2
   20       CONTINUE
            T = SIGN( SQRT( T ), V(K+1) )
            V(K+1) = V(K+1) + T
            H = T*V(K+1)
            DO 50 J = K, N
               T = 0.0D0
               DO 30 I = K + 1, N
                  T = T + V(I)*A(I,J)
   30          CONTINUE
               DO 40 I = K + 1, N
                  A(I,J) = A(I,J) - V(I)*( T/H )
   40          CONTINUE
   50       CONTINUE
            DO 80 I = 1, N
               T = 0.0D0
               DO 60 J = K + 1, N
                  T = T + A(I,J)*V(J)
   60          CONTINUE
               DO 70 J = K + 1, N
                  A(I,J) = A(I,J) - V(J)*( T/H )
   70          CONTINUE
   80       CONTINUE
            DO 85 I = K + 2, N
               A(I,K) = 0.0D0
   85       CONTINUE
         END IF
   90 CONTINUE
      END
C
      SUBROUTINE GSHQR( N, A, LDA, WR, WI, INFO )
C
C     PURPOSE
C     For GSEIG: eigenvalues of a matrix of Hessenberg form.
C
C     ARGUMENTS
C     as GSEIG.
C
C     METHOD
C     From the last row on; at most 60 steps an eigenvalue, every tenth
C     with an exceptional shift.
C
      IMPLICIT NONE
      INTEGER            N, LDA, INFO, EN, L, ITS
      DOUBLE PRECISION   A(LDA,*), WR(*), WI(*), T, X, Y, Z, P, Q, EPS
      DOUBLE PRECISION   GSEPS
      INTEGER            I
      EXTERNAL           GSEPS, GSHQS
C
      INFO = 0
      EPS = GSEPS()
      T = 0.0D0
      EN = N
      ITS = 0
   10 CONTINUE
      IF ( EN.LT.1 ) RETURN
C     -- the last small subdiagonal element
      DO 20 L = EN, 2, -1
         Z = ABS( A(L-1,L-1) ) + ABS( A(L,L) )
         IF ( Z.LE.0.0D0 ) Z = 1.0D-300
         IF ( ABS( A(L,L-1) ).LE.EPS*Z ) GO TO 30
   20 CONTINUE
      L = 1
   30 CONTINUE
      X = A(EN,EN)
      IF ( L.EQ.EN ) THEN
         WR(EN) = X + T
         WI(EN) = 0.0D0
         EN = EN - 1
         ITS = 0
         GO TO 10
      END IF
      Y = A(EN-1,EN-1)
      Z = A(EN,EN-1)*A(EN-1,EN)
      IF ( L.EQ.EN - 1 ) THEN
         P = 0.5D0*( Y - X )
         Q = P*P + Z
         Z = SQRT( ABS( Q ) )
         IF ( Q.GE.0.0D0 ) THEN
            P = P + SIGN( Z, P )
            WR(EN-1) = X + T + P
            WR(EN) = WR(EN-1)
            IF ( ABS( P ).GT.0.0D0 ) WR(EN) = X + T
     $         - A(EN,EN-1)*A(EN-1,EN)/P
            WI(EN-1) = 0.0D0
            WI(EN) = 0.0D0
         ELSE
            WR(EN-1) = X + T + P
            WR(EN) = WR(EN-1)
            WI(EN-1) = Z
            WI(EN) = -Z
         END IF
         EN = EN - 2
         ITS = 0
         GO TO 10
      END IF
      IF ( ITS.GE.60 ) THEN
         INFO = EN
         RETURN
      END IF
      ITS = ITS + 1
      IF ( MOD( ITS, 10 ).EQ.0 ) THEN
         T = T + X
         DO 40 I = 1, EN
            A(I,I) = A(I,I) - X
   40    CONTINUE
         X = 0.75D0*( ABS( A(EN,EN-1) ) + ABS( A(EN-1,EN-2) ) )
         Y = X
         Z = -0.4375D0*X*X
      END IF
      CALL GSHQS( N, A, LDA, L, EN, X, Y, Z )
      GO TO 10
      END
C
      SUBROUTINE GSHQS( N, A, LDA, L, EN, X, Y, Z )
C
C     PURPOSE
C     For GSHQR: one double QR step on rows and columns L to EN.
C
C     ARGUMENTS
C     N, A, LDA as GSEIG.
C     L, EN   (input) INTEGER, EN >= L + 2.
C     X, Y, Z (input) DOUBLE PRECISION: the shifts have the sum X + Y and
C             the product X*Y - Z.
C
C     METHOD
C     The first column of the step, then the bulge is chased down.
C
      IMPLICIT NONE
      INTEGER            N, LDA, L, EN, M, K, I, J, LAST
      DOUBLE PRECISION   A(LDA,*), X, Y, Z, P, Q, R, S, U, V, W, F, G
C
      P = 0.0D0
      Q = 0.0D0
      R = 0.0D0
      DO 10 M = EN - 2, L, -1
         U = A(M,M)
         R = X - U
         S = Y - U
         P = ( R*S - Z )/A(M+1,M) + A(M,M+1)
         Q = A(M+1,M+1) - U - R - S
         R = A(M+2,M+1)
         S = ABS( P ) + ABS( Q ) + ABS( R )
         P = P/S
         Q = Q/S
         R = R/S
         IF ( M.EQ.L ) GO TO 20
         F = ABS( A(M,M-1) )*( ABS( Q ) + ABS( R ) )
         G = ABS( P )*( ABS( A(M-1,M-1) ) + ABS( U )
     $       + ABS( A(M+1,M+1) ) )
         IF ( F.LE.2.0D-16*G ) GO TO 20
   10 CONTINUE
      M = L
   20 CONTINUE
      DO 30 I = M + 2, EN
         A(I,I-2) = 0.0D0
         IF ( I.GT.M + 2 ) A(I,I-3) = 0.0D0
   30 CONTINUE
      DO 70 K = M, EN - 1
         LAST = MIN( K + 3, EN )
         IF ( K.GT.M ) THEN
            P = A(K,K-1)
            Q = A(K+1,K-1)
            R = 0.0D0
            IF ( K.LT.EN - 1 ) R = A(K+2,K-1)
            U = ABS( P ) + ABS( Q ) + ABS( R )
            IF ( U.LE.0.0D0 ) GO TO 70
            P = P/U
            Q = Q/U
            R = R/U
         ELSE
            U = 1.0D0
         END IF
         S = SIGN( SQRT( P*P + Q*Q + R*R ), P )
         IF ( K.GT.M ) THEN
            A(K,K-1) = -S*U
         ELSE IF ( L.NE.M ) THEN
            A(K,K-1) = -A(K,K-1)
         END IF
         P = P + S
         U = P/S
         V = Q/S
         W = R/S
         Q = Q/P
         R = R/P
         DO 40 J = K, N
            F = A(K,J) + Q*A(K+1,J)
            IF ( K.LT.EN - 1 ) THEN
               F = F + R*A(K+2,J)
               A(K+2,J) = A(K+2,J) - F*W
            END IF
            A(K+1,J) = A(K+1,J) - F*V
            A(K,J) = A(K,J) - F*U
   40    CONTINUE
         DO 50 I = 1, LAST
            F = U*A(I,K) + V*A(I,K+1)
            IF ( K.LT.EN - 1 ) THEN
               F = F + W*A(I,K+2)
               A(I,K+2) = A(I,K+2) - F*R
            END IF
            A(I,K+1) = A(I,K+1) - F*Q
            A(I,K) = A(I,K) - F
   50    CONTINUE
   70 CONTINUE
      END
