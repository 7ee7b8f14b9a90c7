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
      DOUBLE PRECISION   GSEPS, S, BIG
      EXTERNAL           GSEPS, GSLUF
      INTEGER            I, J, K
C
      INFO = 0
      IF ( N.LT.0 ) INFO = -1
      IF ( NRHS.LT.0 ) INFO = -2
      IF ( LDA.LT.MAX( 1, N ) ) INFO = -4
      IF ( LDB.LT.MAX( 1, N ) ) INFO = -6
      IF ( INFO.NE.0 ) RETURN
C
C     -- scale
      DO 60 I = 1, N
         BIG = 0.0D0
         DO 10 J = 1, N
            IF ( .NOT.( ABS( A(I,J) ).LE.BIG ) ) BIG = ABS( A(I,J) )
   10    CONTINUE
         IF ( .NOT.( BIG.GT.1.0D-300 .AND. BIG.LE.1.0D300 ) ) THEN
            INFO = I
            RETURN
         END IF
         S = 1.0D0
   20    IF ( S*BIG.GE.2.0D0 ) THEN
            S = 0.5D0*S
            GO TO 20
         END IF
   30    IF ( S*BIG.LT.1.0D0 ) THEN
            S = 2.0D0*S
            GO TO 30
         END IF
         DO 40 J = 1, N
            A(I,J) = S*A(I,J)
   40    CONTINUE
         DO 50 J = 1, NRHS
            B(I,J) = S*B(I,J)
   50    CONTINUE
   60 CONTINUE
C
C     -- factor
      CALL GSLUF( N, A, LDA, IW, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 70 K = 1, N
         IF ( .NOT.( ABS( A(K,K) ).GT.1.0D3*GSEPS() ) ) THEN
            INFO = K
            RETURN
         END IF
   70 CONTINUE
C
C     -- solve
      DO 120 J = 1, NRHS
         DO 75 K = 1, N
            S = B(IW(K),J)
            B(IW(K),J) = B(K,J)
            B(K,J) = S
   75    CONTINUE
         DO 90 K = 1, N
            S = B(K,J)
            DO 80 I = K + 1, N
               B(I,J) = B(I,J) - A(I,K)*S
   80       CONTINUE
   90    CONTINUE
         DO 110 K = N, 1, -1
            S = B(K,J)/A(K,K)
            B(K,J) = S
            DO 100 I = 1, K - 1
               B(I,J) = B(I,J) - A(I,K)*S
  100       CONTINUE
  110    CONTINUE
  120 CONTINUE
      END
