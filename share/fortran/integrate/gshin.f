      SUBROUTINE GSHIN( RHS, CON, KIN, CMD, CLO, VIN, T, HMAX, X, NQ,
     $                  NU, NX, NV, NLAM, IP, RP, CST, V, RTOL, ATOL, W,
     $                  WI, P, ISTAT, RSTAT, H, INFO )
C
C     PURPOSE
C     A first step for GSDP8, from the size of the first and the second
C     derivative.
C
C     ARGUMENTS
C     As GSDP8 (W(*,1) holds the right-hand side at (T,X)), and
C     HMAX    (input) DOUBLE PRECISION, the largest step allowed [s].
C     H       (output) DOUBLE PRECISION, the step [s], 0 < H <= HMAX.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, section II.4 (starting step size).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, HMAX, X(*), RP(*), CST(*), V(*), RTOL,
     $                   ATOL(*), W(NX,*), WI(*), P(*), RSTAT(*), H
      EXTERNAL           GSFUN
      INTEGER            I
      DOUBLE PRECISION   S, D0, D1, D2, TINY
      PARAMETER          ( TINY = 1.0D-200 )
C
      D0 = 0.0D0
      D1 = 0.0D0
      DO 10 I = 1, NX
         S  = MAX( ATOL(I) + RTOL*ABS( X(I) ), TINY )
         D0 = D0 + ( X(I)/S )**2
         D1 = D1 + ( W(I,1)/S )**2
   10 CONTINUE
      H = 1.0D-6
      IF ( D0.GT.1.0D-10 .AND. D1.GT.1.0D-10 ) H = 0.01D0*SQRT( D0/D1 )
      H = MIN( H, HMAX )
      DO 20 I = 1, NX
         W(I,3) = X(I) + H*W(I,1)
   20 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T + H, -1, W(1,3),
     $            NQ, NU, NX, NV, NLAM, IP, RP, CST, V, W(1,2), WI,
     $            P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      D2 = 0.0D0
      DO 30 I = 1, NX
         S  = MAX( ATOL(I) + RTOL*ABS( X(I) ), TINY )
         D2 = D2 + ( ( W(I,2) - W(I,1) )/S )**2
   30 CONTINUE
      D2 = SQRT( D2 )/H
      S  = MAX( SQRT( D1 ), D2 )
      IF ( S.LE.1.0D-15 ) THEN
         S = MAX( 1.0D-6, 1.0D-3*H )
      ELSE
         S = ( 0.01D0/S )**0.125D0
      END IF
      H = MIN( 100.0D0*H, S, HMAX )
      END
