      SUBROUTINE GSSPD( N, NRHS, A, LDA, B, LDB, INFO )
C
C     PURPOSE
C     To solve A*X = B, A symmetric and positive definite.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A, N >= 0.
C     NRHS    (input) INTEGER, the number of columns of B, NRHS >= 0.
C     A       (input/output) DOUBLE PRECISION array, dimension (LDA,N):
C             only the lower triangle is used; destroyed.
C     LDA     (input) INTEGER, LDA >= MAX(1,N).
C     B       (input/output) DOUBLE PRECISION array, dimension
C             (LDB,NRHS): on entry B, on exit X.
C     LDB     (input) INTEGER, LDB >= MAX(1,N).
C     INFO    (output) INTEGER, see below.
C
C     ERROR INDICATOR
C     INFO = 0   ok;
C     INFO = -i  argument i is out of range;
C     INFO = k   the k-th pivot is not positive to working precision:
C                A is not positive definite, B is unchanged.
C
      IMPLICIT NONE
      INTEGER            N, NRHS, LDA, LDB, INFO
      DOUBLE PRECISION   A(LDA,*), B(LDB,*)
      EXTERNAL           GSCHF, GSTRS
C
      INFO = 0
      IF ( N.LT.0 ) INFO = -1
      IF ( NRHS.LT.0 ) INFO = -2
      IF ( LDA.LT.MAX( 1, N ) ) INFO = -4
      IF ( LDB.LT.MAX( 1, N ) ) INFO = -6
      IF ( INFO.NE.0 ) RETURN
      CALL GSCHF( N, A, LDA, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSTRS( N, NRHS, A, LDA, B, LDB, 0 )
      CALL GSTRS( N, NRHS, A, LDA, B, LDB, 1 )
      END
