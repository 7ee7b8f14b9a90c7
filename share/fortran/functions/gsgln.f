      SUBROUTINE GSGLN( NS, C, WT )
C
C     PURPOSE
C     The NS points C and weights WT of Gauss between -1 and 1, the
C     points rising; NS even, 12 at most.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12)
      DOUBLE PRECISION   P(13), PI, D
      EXTERNAL           GSLGP
      INTEGER            K, L
C
      PI = 4.0D0*ATAN( 1.0D0 )
      DO 20 K = 1, NS/2
         C(K) = -COS( PI*( DBLE( K ) - 0.25D0 )/( DBLE( NS ) + 0.5D0 ) )
         DO 10 L = 1, 6
            CALL GSLGP( NS + 1, C(K), P )
            D    = DBLE( NS )*( P(NS) - C(K)*P(NS+1) )
     $             /( 1.0D0 - C(K)**2 )
            C(K) = C(K) - P(NS+1)/D
   10    CONTINUE
         WT(K)       = 2.0D0/( ( 1.0D0 - C(K)**2 )*D*D )
         C(NS+1-K)  = -C(K)
         WT(NS+1-K) = WT(K)
   20 CONTINUE
      END
      SUBROUTINE GSLGP( N, X, P )
C
C     PURPOSE
C     The polynomials of Legendre of degrees 0 to N-1 at X, N >= 2.
C
      IMPLICIT NONE
      INTEGER            N
      DOUBLE PRECISION   X, P(N)
      INTEGER            J
C
      P(1) = 1.0D0
      P(2) = X
      DO 10 J = 2, N - 1
         P(J+1) = ( DBLE( 2*J - 1 )*X*P(J) - DBLE( J - 1 )*P(J-1) )
     $            /DBLE( J )
   10 CONTINUE
      END
      SUBROUTINE GSGLQ( NS, C, WT, CA, CB, B )
C
C     PURPOSE
C     B, so that the sum of B(K)*F(C(K)) is the integral from CA to CB
C     of the polynomial of degree NS-1 through F at the points of GSGLN.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12), CA, CB, B(12)
      DOUBLE PRECISION   P(12), PA(13), PB(13), S
      EXTERNAL           GSLGP
      INTEGER            J, K
C
      CALL GSLGP( NS + 1, CA, PA )
      CALL GSLGP( NS + 1, CB, PB )
      DO 20 K = 1, NS
         CALL GSLGP( NS, C(K), P )
         S = CB - CA
         DO 10 J = 2, NS
            S = S + P(J)*( ( PB(J+1) - PB(J-1) )
     $                   - ( PA(J+1) - PA(J-1) ) )
   10    CONTINUE
         B(K) = 0.5D0*WT(K)*S
   20 CONTINUE
      END
      SUBROUTINE GSLGI( N, Z, CA, CB, B )
C
C     PURPOSE
C     B, so that the sum of B(K)*F(Z(K)) is the integral from CA to CB
C     of the polynomial through F at those of the N places Z that are
C     nearest to CB, seven at most; the other B are 0.
C
      IMPLICIT NONE
      INTEGER            N
      DOUBLE PRECISION   Z(*), CA, CB, B(*)
      DOUBLE PRECISION   G(4), WG(4), S, X
      INTEGER            I, J, K, M, NEAR(7)
C
C     -- the nearest ones
      M = 0
      DO 20 K = 1, N
         B(K) = 0.0D0
         I = 0
         DO 10 J = 1, N
            IF ( J.LT.K .AND. ABS( Z(J) - CB ).LE.ABS( Z(K) - CB ) )
     $         I = I + 1
            IF ( J.GT.K .AND. ABS( Z(J) - CB ).LT.ABS( Z(K) - CB ) )
     $         I = I + 1
   10    CONTINUE
         IF ( I.LT.7 .AND. M.LT.7 ) THEN
            M = M + 1
            NEAR(M) = K
         END IF
   20 CONTINUE
C
C     -- four points of Gauss
      G(4)  = SQRT( 3.0D0/7.0D0 + 2.0D0/7.0D0*SQRT( 1.2D0 ) )
      G(3)  = SQRT( 3.0D0/7.0D0 - 2.0D0/7.0D0*SQRT( 1.2D0 ) )
      WG(4) = 0.5D0 - SQRT( 30.0D0 )/36.0D0
      WG(3) = 0.5D0 + SQRT( 30.0D0 )/36.0D0
      DO 30 I = 1, 2
         G(I)  = -G(5-I)
         WG(I) = WG(5-I)
   30 CONTINUE
      DO 60 I = 1, 4
         X = 0.5D0*( CA + CB ) + 0.5D0*( CB - CA )*G(I)
         DO 50 K = 1, M
            S = 0.5D0*( CB - CA )*WG(I)
            DO 40 J = 1, M
               IF ( J.NE.K ) S = S*( X - Z(NEAR(J)) )
     $                            /( Z(NEAR(K)) - Z(NEAR(J)) )
   40       CONTINUE
            B(NEAR(K)) = B(NEAR(K)) + S
   50    CONTINUE
   60 CONTINUE
      END
