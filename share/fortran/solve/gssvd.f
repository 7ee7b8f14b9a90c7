      SUBROUTINE GSSVD( M, N, B, LDB, V, LDV, S, TOL, RANK )
C
C     PURPOSE
C     Singular values and right singular vectors, B*V = U*diag(S), by
C     one-sided Jacobi rotations.  The last N - RANK columns of V are
C     the eigenvectors of B'*B to the eigenvalue zero.
C
C     ARGUMENTS
C     M, N    (input) INTEGER, rows and columns of B, M, N >= 0.
C     B       (input/output) DOUBLE PRECISION array, dimension (LDB,N):
C             on exit B*V, whose columns are orthogonal.
C     LDB     (input) INTEGER, LDB >= MAX(1,M).
C     V       (output) DOUBLE PRECISION array, dimension (LDV,N),
C             orthogonal.
C     LDV     (input) INTEGER, LDV >= MAX(1,N).
C     S       (output) DOUBLE PRECISION array, dimension (N), the
C             singular values, falling.
C     TOL     (input) DOUBLE PRECISION: S(k) counts if it is above
C             TOL*S(1).
C     RANK    (output) INTEGER, how many count, at most MIN(M,N).
C
C     METHOD
C     Cyclic sweeps; of two columns the longer one is kept first, so
C     that the vanishing ones gather at the end.  A pair is left alone
C     where its angle, or the shorter column beside the longest of all,
C     is nothing to working precision.
C
C     REFERENCE
C     Golub, van Loan, Matrix Computations, section 8.6.3 (one-sided
C     Jacobi).
C
      IMPLICIT NONE
      INTEGER            M, N, LDB, LDV, RANK
      DOUBLE PRECISION   B(LDB,*), V(LDV,*), S(*), TOL
      DOUBLE PRECISION   GSEPS, EPS, BIG, P, Q, R, Z, C, D
      EXTERNAL           GSEPS, GSROT
      INTEGER            I, J, K, SWEEP, TURNS
      LOGICAL            SMALL
C
C     (MIN and MAX of a NaN differ between compilers: none here)
      EPS = GSEPS()
      BIG = 0.0D0
      DO 30 J = 1, N
         DO 10 I = 1, N
            V(I,J) = 0.0D0
   10    CONTINUE
         V(J,J) = 1.0D0
         P = 0.0D0
         DO 20 I = 1, M
            P = P + B(I,J)*B(I,J)
   20    CONTINUE
         IF ( P.GT.BIG ) BIG = P
   30 CONTINUE
C
      DO 90 SWEEP = 1, 60
         TURNS = 0
         DO 80 J = 1, N - 1
            DO 70 K = J + 1, N
               P = 0.0D0
               Q = 0.0D0
               R = 0.0D0
               DO 40 I = 1, M
                  P = P + B(I,J)*B(I,J)
                  Q = Q + B(I,K)*B(I,K)
                  R = R + B(I,J)*B(I,K)
   40          CONTINUE
               SMALL = P.LE.EPS*EPS*BIG .OR. Q.LE.EPS*EPS*BIG
               IF ( P.LE.EPS*EPS*BIG .AND. Q.LE.EPS*EPS*BIG ) GO TO 70
               IF ( ABS( R ).LE.EPS*SQRT( P )*SQRT( Q ) .OR.
     $              SMALL ) THEN
C
C                 -- nothing to turn: at most an interchange
                  IF ( Q.LE.P ) GO TO 70
                  C = 0.0D0
                  D = 1.0D0
                  IF ( .NOT.SMALL ) TURNS = TURNS + 1
               ELSE
                  Z = ( Q - P )/( 2.0D0*R )
                  D = SIGN( 1.0D0, Z )/( ABS( Z ) + SQRT( 1.0D0
     $                + Z*Z ) )
                  C = 1.0D0/SQRT( 1.0D0 + D*D )
                  D = -C*D
                  IF ( Q.GT.P ) THEN
                     Z = C
                     C = -D
                     D = Z
                  END IF
                  TURNS = TURNS + 1
               END IF
               CALL GSROT( M, B(1,J), B(1,K), C, D )
               CALL GSROT( N, V(1,J), V(1,K), C, D )
   70       CONTINUE
   80    CONTINUE
         IF ( TURNS.EQ.0 ) GO TO 100
   90 CONTINUE
C
  100 RANK = 0
      DO 120 J = 1, N
         P = 0.0D0
         DO 110 I = 1, M
            P = P + B(I,J)*B(I,J)
  110    CONTINUE
         S(J) = SQRT( P )
         IF ( J.LE.MIN( M, N ) .AND. RANK.EQ.J-1 .AND.
     $        S(J).GT.TOL*S(1) ) RANK = J
  120 CONTINUE
      END
      SUBROUTINE GSROT( N, X, Y, C, S )
C
C     PURPOSE
C     A plane rotation: (X,Y) := (C*X + S*Y, C*Y - S*X).
C
      IMPLICIT NONE
      INTEGER            N, I
      DOUBLE PRECISION   X(*), Y(*), C, S, T
      DO 10 I = 1, N
         T    = C*X(I) + S*Y(I)
         Y(I) = C*Y(I) - S*X(I)
         X(I) = T
   10 CONTINUE
      END
