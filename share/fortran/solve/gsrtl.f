      SUBROUTINE GSRTL( N, M, H, LDH, PHI, GRP, TOL, W )
C
C     PURPOSE
C     The tolerance within which constraints are dependent (GSKKR) at a
C     position that does not quite fulfil them.
C
C     ARGUMENTS
C     N, M    (input) INTEGER, the numbers of speeds and of constraints.
C     H       (input) DOUBLE PRECISION array, dimension (LDH,N), the
C             constraint Jacobian.
C     LDH     (input) INTEGER, LDH >= MAX(1,M).
C     PHI     (input) DOUBLE PRECISION array, dimension (M), the values
C             of the constraints, 0 for one on speeds alone.
C     GRP     (input) INTEGER array, dimension (M), see GSQRG.
C     TOL     (output) DOUBLE PRECISION, the tolerance.
C     W       (workspace) DOUBLE PRECISION array, dimension (M).
C
C     METHOD
C     The next position on the constraints is about
C        d = max |PHI(i)|/size(i)   [rad or m]
C     away, size(i) that of row i of H (GSQRG).  On the way there, rows
C     change by parts of the size of d: of a row that is dependent
C     there, some d times its size is left here.  And where s times its
C     size is left of an independent row, the way may be as long as d/s,
C     which changes s by little only if s**2 > d (Kantorovich's
C     condition for Newton's method).  So the tolerance is the root of
C     d: above it the rank here is the rank on the constraints, below it
C     nobody can tell.  It stays between rounding errors, 1D-11, and
C     1D-2.
C
C     REFERENCE
C     Ortega and Rheinboldt 1970, Iterative solution of nonlinear
C     equations in several variables, 12.6.
C
      IMPLICIT NONE
      INTEGER            N, M, LDH, GRP(*)
      DOUBLE PRECISION   H(LDH,*), PHI(*), TOL, W(*)
      DOUBLE PRECISION   GSEPS, D, S
      EXTERNAL           GSEPS, GSGRP
      INTEGER            I, J
C
      DO 20 I = 1, M
         S = 0.0D0
         DO 10 J = 1, N
            S = S + H(I,J)*H(I,J)
   10    CONTINUE
         W(I) = SQRT( S )
   20 CONTINUE
      CALL GSGRP( M, GRP, 1.0D-3, W )
      D = 0.0D0
      DO 30 I = 1, M
         IF ( W(I).GT.0.0D0 ) D = MAX( D, ABS( PHI(I) )/W(I) )
   30 CONTINUE
      TOL = MIN( 1.0D-2, MAX( 5.0D4*GSEPS(), SQRT( D ) ) )
      END
