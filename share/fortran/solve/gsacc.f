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
