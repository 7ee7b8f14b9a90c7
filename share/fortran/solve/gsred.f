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
