      SUBROUTINE GSLEQ( N, NRHS, A, LDA, B, LDB, IW, INFO )
C
C     PURPOSE
C     To solve A*X = B, A square.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A, N >= 0.
C     NRHS    (input) INTEGER, the number of columns of B, NRHS >= 0.
C     A       (input/output) DOUBLE PRECISION array, dimension (LDA,N),
C             destroyed.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     B       (input/output) DOUBLE PRECISION array, dimension
C             (LDB,NRHS): on entry B, on exit X.
C     LDB     (input) INTEGER, LDB >= MAX(1,N).
C     IW      (workspace) INTEGER array, dimension (N).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Rows are scaled by powers of two to largest entries in [1,2), then
C     Gauss elimination with partial pivoting.
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = -i  argument i is out of range;
C     INFO = k   the k-th pivot of the scaled matrix is below 1000*eps:
C                A is singular to working precision; B is of no use.
C
      IMPLICIT NONE
      INTEGER            N, NRHS, LDA, LDB, IW(*), INFO
      DOUBLE PRECISION   A(LDA,*), B(LDB,*)
      EXTERNAL           GSLQF, GSLQS
C
      INFO = 0
      IF ( N.LT.0 ) INFO = -1
      IF ( NRHS.LT.0 ) INFO = -2
      IF ( LDA.LT.MAX( 1, N ) ) INFO = -4
      IF ( LDB.LT.MAX( 1, N ) ) INFO = -6
      IF ( INFO.NE.0 ) RETURN
      CALL GSLQF( N, NRHS, A, LDA, B, LDB, IW, INFO )
      IF ( INFO.EQ.0 ) CALL GSLQS( N, NRHS, A, LDA, B, LDB, IW )
      END
      SUBROUTINE GSLQF( N, NRHS, A, LDA, B, LDB, IW, INFO )
C
C     PURPOSE
C     Rows of A and B times powers of two, so that the largest entry of
C     a row of A is in [1,2), then A = P*L*U: part of GSLEQ.  A column of
C     ones in B becomes these powers.
C
C     ARGUMENTS
C     As in GSLEQ.
C
      IMPLICIT NONE
      INTEGER            N, NRHS, LDA, LDB, IW(*), INFO
      DOUBLE PRECISION   A(LDA,*), B(LDB,*)
      DOUBLE PRECISION   GSEPS, S, BIG
      EXTERNAL           GSEPS, GSLUF
      INTEGER            I, J, K
C
      INFO = 0
      DO 60 I = 1, N
         BIG = 0.0D0
         DO 10 J = 1, N
            IF ( .NOT.( ABS( A(I,J) ).LE.BIG ) ) BIG = ABS( A(I,J) )
   10    CONTINUE
         IF ( .NOT.( BIG.GT.1.0D-300 .AND. BIG.LE.1.0D300 ) ) THEN
            INFO = I
            RETURN
         END IF
C
C        -- S*BIG into [1/16,16), then [1,2)
         S = 1.0D0
   20    IF ( S*BIG.GE.1.6D1 ) THEN
            S = S/1.6D1
            GO TO 20
         END IF
   25    IF ( S*BIG.LT.6.25D-2 ) THEN
            S = 1.6D1*S
            GO TO 25
         END IF
   30    IF ( S*BIG.GE.2.0D0 ) THEN
            S = 0.5D0*S
            GO TO 30
         END IF
   35    IF ( S*BIG.LT.1.0D0 ) THEN
            S = 2.0D0*S
            GO TO 35
         END IF
         DO 40 J = 1, N
            A(I,J) = S*A(I,J)
   40    CONTINUE
         DO 50 J = 1, NRHS
            B(I,J) = S*B(I,J)
   50    CONTINUE
   60 CONTINUE
C
      IF ( N.EQ.1 ) THEN
         IW(1) = 1
         RETURN
      END IF
      CALL GSLUF( N, A, LDA, IW, INFO )
      IF ( INFO.NE.0 ) RETURN
      S = 1.0D3*GSEPS()
      DO 70 K = 1, N
         IF ( .NOT.( ABS( A(K,K) ).GT.S ) ) THEN
            INFO = K
            RETURN
         END IF
   70 CONTINUE
      END
      SUBROUTINE GSLQS( N, NRHS, A, LDA, B, LDB, IW )
C
C     PURPOSE
C     The solution from the factors of GSLQF: part of GSLEQ.
C
C     ARGUMENTS
C     As in GSLEQ.
C
C     METHOD
C     Columns one by one, of four rows or more four at a time: the same
C     operations.
C
      IMPLICIT NONE
      INTEGER            N, NRHS, LDA, LDB, IW(*)
      DOUBLE PRECISION   A(LDA,*), B(LDB,*)
      EXTERNAL           GSLQ3, GSLQ4, GSLQC
      DOUBLE PRECISION   X, Y
      INTEGER            J, P, Q
C
      IF ( N.EQ.1 ) THEN
         DO 10 J = 1, NRHS
            B(1,J) = B(1,J)/A(1,1)
   10    CONTINUE
      ELSE IF ( N.EQ.2 ) THEN
         P = IW(1)
         Q = 3 - P
         DO 20 J = 1, NRHS
            X = B(P,J)
            Y = ( B(Q,J) - A(2,1)*X )/A(2,2)
            B(1,J) = ( X - A(1,2)*Y )/A(1,1)
            B(2,J) = Y
   20    CONTINUE
      ELSE IF ( N.EQ.3 ) THEN
         CALL GSLQ3( NRHS, A, LDA, B, LDB, IW )
      ELSE
         DO 30 J = 1, NRHS - 3, 4
            CALL GSLQ4( N, A, LDA, B(1,J), LDB, IW )
   30    CONTINUE
         DO 40 J = NRHS - MOD( NRHS, 4 ) + 1, NRHS
            CALL GSLQC( N, A, LDA, B(1,J), IW )
   40    CONTINUE
      END IF
      END
      SUBROUTINE GSLQ3( NRHS, A, LDA, B, LDB, IW )
C
C     PURPOSE
C     GSLQS for three rows.
C
      IMPLICIT NONE
      INTEGER            NRHS, LDA, LDB, IW(*)
      DOUBLE PRECISION   A(LDA,*), B(LDB,*)
      DOUBLE PRECISION   X, Y, Z
      INTEGER            J, K, P(3)
C
C     -- the rows as they were interchanged
      P(1) = 1
      P(2) = 2
      P(3) = 3
      DO 10 K = 1, 2
         J = P(IW(K))
         P(IW(K)) = P(K)
         P(K) = J
   10 CONTINUE
      DO 20 J = 1, NRHS
         X = B(P(1),J)
         Y = B(P(2),J) - A(2,1)*X
         Z = B(P(3),J) - A(3,1)*X
         Z = ( Z - A(3,2)*Y )/A(3,3)
         X = X - A(1,3)*Z
         Y = ( Y - A(2,3)*Z )/A(2,2)
         B(1,J) = ( X - A(1,2)*Y )/A(1,1)
         B(2,J) = Y
         B(3,J) = Z
   20 CONTINUE
      END
      SUBROUTINE GSLQC( N, A, LDA, B, IW )
C
C     PURPOSE
C     GSLQS for one column.
C
      IMPLICIT NONE
      INTEGER            N, LDA, IW(*)
      DOUBLE PRECISION   A(LDA,*), B(*)
      DOUBLE PRECISION   S
      INTEGER            I, K
C
      DO 10 K = 1, N
         S = B(IW(K))
         B(IW(K)) = B(K)
         B(K) = S
   10 CONTINUE
      DO 30 K = 1, N
         S = B(K)
         DO 20 I = K + 1, N
            B(I) = B(I) - A(I,K)*S
   20    CONTINUE
   30 CONTINUE
      DO 50 K = N, 1, -1
         S = B(K)/A(K,K)
         B(K) = S
         DO 40 I = 1, K - 1
            B(I) = B(I) - A(I,K)*S
   40    CONTINUE
   50 CONTINUE
      END
      SUBROUTINE GSLQ4( N, A, LDA, B, LDB, IW )
C
C     PURPOSE
C     GSLQS for four columns.
C
      IMPLICIT NONE
      INTEGER            N, LDA, LDB, IW(*)
      DOUBLE PRECISION   A(LDA,*), B(LDB,4)
      DOUBLE PRECISION   S, X1, X2, X3, X4
      INTEGER            I, J, K
C
      DO 20 K = 1, N
         I = IW(K)
         DO 10 J = 1, 4
            S = B(I,J)
            B(I,J) = B(K,J)
            B(K,J) = S
   10    CONTINUE
   20 CONTINUE
      DO 40 K = 1, N
         X1 = B(K,1)
         X2 = B(K,2)
         X3 = B(K,3)
         X4 = B(K,4)
         DO 30 I = K + 1, N
            S = A(I,K)
            B(I,1) = B(I,1) - S*X1
            B(I,2) = B(I,2) - S*X2
            B(I,3) = B(I,3) - S*X3
            B(I,4) = B(I,4) - S*X4
   30    CONTINUE
   40 CONTINUE
      DO 60 K = N, 1, -1
         X1 = B(K,1)/A(K,K)
         X2 = B(K,2)/A(K,K)
         X3 = B(K,3)/A(K,K)
         X4 = B(K,4)/A(K,K)
         B(K,1) = X1
         B(K,2) = X2
         B(K,3) = X3
         B(K,4) = X4
         DO 50 I = 1, K - 1
            S = A(I,K)
            B(I,1) = B(I,1) - S*X1
            B(I,2) = B(I,2) - S*X2
            B(I,3) = B(I,3) - S*X3
            B(I,4) = B(I,4) - S*X4
   50    CONTINUE
   60 CONTINUE
      END
