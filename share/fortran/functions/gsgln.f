      SUBROUTINE GSGLN( NS, C, WT )
C
C     PURPOSE
C     The NS points C and weights WT of Gauss between -1 and 1, the
C     points rising; NS = 2, 8 or 12.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12)
      DOUBLE PRECISION   C2, C8(4), W8(4), C12(6), W12(6)
      PARAMETER ( C2 = -5.77350269189625764509148780501957456D-1 )
      INTEGER            K
      DATA C8
     $  / -9.602898564975362316835608685694729904D-1,
     $    -7.966664774136267395915539364758304368D-1,
     $    -5.25532409916328985817739049189246349D-1,
     $    -1.834346424956498049394761423601839807D-1 /
      DATA W8
     $  / 1.012285362903762591525313543099621901D-1,
     $    2.223810344533744705443559944262408844D-1,
     $    3.137066458778872873379622019866013133D-1,
     $    3.626837833783619829651504492771956122D-1 /
      DATA C12
     $  / -9.81560634246719250690549090149280823D-1,
     $    -9.041172563704748566784658661190961925D-1,
     $    -7.69902674194304687036893833212818076D-1,
     $    -5.873179542866174472967024189405342804D-1,
     $    -3.678314989981801937526915366437175613D-1,
     $    -1.2523340851146891547244136946385313D-1 /
      DATA W12
     $  / 4.717533638651182719461596148501706032D-2,
     $    1.069393259953184309602547181939962242D-1,
     $    1.600783285433462263346525295433590719D-1,
     $    2.031674267230659217490644558097983765D-1,
     $    2.334925365383548087608498989248780563D-1,
     $    2.491470458134027850005624360429512108D-1 /
C
      DO 10 K = 1, NS/2
         IF ( NS.EQ.2 ) THEN
            C(K)  = C2
            WT(K) = 1.0D0
         ELSE IF ( NS.EQ.8 ) THEN
            C(K)  = C8(K)
            WT(K) = W8(K)
         ELSE
            C(K)  = C12(K)
            WT(K) = W12(K)
         END IF
         C(NS+1-K)  = -C(K)
         WT(NS+1-K) = WT(K)
   10 CONTINUE
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
C     METHOD
C     By polynomials of Legendre, one degree after the other, of all
C     points together.
C
      IMPLICIT NONE
      INTEGER            NS
      DOUBLE PRECISION   C(12), WT(12), CA, CB, B(12)
      DOUBLE PRECISION   P(12), OLD(12), PA(13), PB(13), S, X, Y, NEXT
      EXTERNAL           GSLGP
      INTEGER            J, K
C
      CALL GSLGP( NS + 1, CA, PA )
      CALL GSLGP( NS + 1, CB, PB )
      DO 10 K = 1, NS
         OLD(K) = 1.0D0
         P(K)   = C(K)
         B(K)   = CB - CA
   10 CONTINUE
      DO 30 J = 2, NS
         S = ( PB(J+1) - PB(J-1) ) - ( PA(J+1) - PA(J-1) )
         X = DBLE( 2*J - 1 )/DBLE( J )
         Y = DBLE( J - 1 )/DBLE( J )
         DO 20 K = 1, NS
            B(K)   = B(K) + P(K)*S
            NEXT   = X*C(K)*P(K) - Y*OLD(K)
            OLD(K) = P(K)
            P(K)   = NEXT
   20    CONTINUE
   30 CONTINUE
      DO 40 K = 1, NS
         B(K) = 0.5D0*WT(K)*B(K)
   40 CONTINUE
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
