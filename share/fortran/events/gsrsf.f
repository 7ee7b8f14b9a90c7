      SUBROUTINE GSRSF( STK, HLD, T, X, V, MODE, CST, NU, NV, NH, KIND,
     $                  IPL, VM, UD, LAM, HOLD, ROW, S, SD, PRM )
C
C     PURPOSE
C     Friction at rest that slides against its push: the mode of the
C     first such port is set to 0; or, where there is none, that of the
C     first stop that a port at rest is pushed against.
C
C     ARGUMENTS
C     As GSHLD, NU (input) INTEGER, the number of speeds, and
C     MODE    (input/output) INTEGER array, dimension (NH).
C
C     METHOD
C     Several ports may be let go at one instant, and what lets one go
C     may hold another.  One that is at rest slides the right way if it
C     could not be held: if the effort that would hold it, the modes of
C     the others being as they are, is beyond its limit and against the
C     way it slides.  This and what lets ports go (GSRES) are the pivots
C     of a linear complementarity problem in the ports at rest.  A stop
C     pushes if it would in contact.  Where another port that moves alike
C     is held, it is enough.
C
      IMPLICIT NONE
      EXTERNAL           STK, HLD
      INTEGER            NU, NV, NH, MODE(*), KIND(*), IPL(*)
      DOUBLE PRECISION   T, X(*), V(*), CST(*), VM(*), UD(*), LAM(*),
     $                   HOLD(*), ROW(NH,*), S(*), SD(*), PRM(4,*)
      INTEGER            I, J, L, GSHLJ
      DOUBLE PRECISION   A, B, C, GSATE
      EXTERNAL           GSATE, GSHLD, GSHLJ
C
      CALL HLD( T, X, V, CST, ROW, NH, S, SD, PRM )
      DO 10 I = 1, NH
         IF ( KIND(I).EQ.1 .AND. MODE(I).NE.0 .AND.
     $        ABS( SD(I) ).LE.1.000001D-9*PRM(2,I) ) THEN
            IF ( GSHLJ( NU, NH, I, KIND, MODE, ROW ).EQ.1 ) GO TO 10
            L = MODE(I)
            MODE(I) = 0
            CALL GSHLD( STK, HLD, T, X, V, MODE, CST, NV, NH, KIND, IPL,
     $                  VM, UD, LAM, HOLD, ROW, S, SD, PRM )
            IF ( DBLE( L )*HOLD(I).GT.-( 1.0D0 - 1.0D-9 )*PRM(1,I) )
     $         RETURN
            MODE(I) = L
         END IF
   10 CONTINUE
      DO 30 I = 1, NH
         A = PRM(2,I) - S(I)
         B = S(I) - PRM(1,I)
         IF ( KIND(I).NE.2 .OR. MODE(I).NE.0 ) GO TO 30
         IF ( MIN( A, B ).GT.GSATE( S(I), PRM(1,I) ) .OR.
     $        ABS( SD(I) ).GT.1.0D-9*PRM(4,I) ) GO TO 30
         IF ( GSHLJ( NU, NH, I, KIND, MODE, ROW ).EQ.1 ) GO TO 30
         MODE(I) = 1
         IF ( B.LT.A ) MODE(I) = -1
         CALL GSHLD( STK, HLD, T, X, V, MODE, CST, NV, NH, KIND, IPL,
     $               VM, UD, LAM, HOLD, ROW, S, SD, PRM )
         C = 0.0D0
         DO 20 J = 1, NH
            C = MAX( C, ABS( HOLD(J) ) )
            IF ( KIND(J).EQ.1 ) C = MAX( C, PRM(1,J) )
   20    CONTINUE
         IF ( DBLE( MODE(I) )*HOLD(I).LT.-1.0D-9*C ) RETURN
         MODE(I) = 0
   30 CONTINUE
      END
      INTEGER FUNCTION GSHLJ( NU, NH, I, KIND, MODE, ROW )
C
C     PURPOSE
C     1 if another port is held that moves as port I does (friction and
C     a stop in one joint), else 0.
C
C     ARGUMENTS
C     As GSRSF.
C
      IMPLICIT NONE
      INTEGER            NU, NH, I, KIND(*), MODE(*)
      DOUBLE PRECISION   ROW(NH,*)
      INTEGER            J, N
      DOUBLE PRECISION   A, B, C
C
      GSHLJ = 0
      DO 20 J = 1, NH
         IF ( J.NE.I .AND. ( KIND(J).EQ.1 .EQV. MODE(J).EQ.0 ) ) THEN
            A = 0.0D0
            B = 0.0D0
            C = 0.0D0
            DO 10 N = 1, NU
               A = A + ROW(I,N)**2
               B = B + ROW(J,N)**2
               C = C + ROW(I,N)*ROW(J,N)
   10       CONTINUE
            IF ( C**2.GE.( 1.0D0 - 1.0D-12 )*A*B ) GSHLJ = 1
         END IF
   20 CONTINUE
      END
