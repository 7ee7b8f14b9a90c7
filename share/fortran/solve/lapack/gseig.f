      SUBROUTINE GSEIG( N, A, LDA, WR, WI, W, INFO )
C
C     PURPOSE
C     Eigenvalues of a general matrix.  LAPACK body: DGEEV.
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
      IMPLICIT NONE
      INTEGER            N, LDA, INFO
      DOUBLE PRECISION   A(LDA,*), WR(*), WI(*), W(*), VL(1,1), VR(1,1)
      EXTERNAL           DGEEV
C
      CALL DGEEV( 'N', 'N', N, A, LDA, WR, WI, VL, 1, VR, 1, W, 4*N,
     $            INFO )
      END
