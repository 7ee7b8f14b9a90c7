      SUBROUTINE GSRSM( NU, NLAM, NH, KIND, MODE, ROW, S, SD, PRM, U )
C
C     PURPOSE
C     Modes of ports that contradict the state: they are changed to what
C     it says.
C
C     ARGUMENTS
C     NU, NLAM, NH (input) INTEGER, the numbers of speeds, constraints
C             and ports.
C     KIND    (input) INTEGER array, dimension (NH): 1 friction, 2 stops.
C     MODE    (input/output) INTEGER array, dimension (NH), see GSEVT.
C     ROW     (input) DOUBLE PRECISION array, dimension (NH,NU): SD is
C             ROW*U.
C     S, SD, PRM (input) as GSEVT.
C     U       (input) DOUBLE PRECISION array, dimension (NU), the speeds.
C
C     METHOD
C     Friction that moves does not stick, nor slide the other way; a
C     stop is not in contact away from its end, nor with a port that
C     moves.  The end of a run may be the start of another one, so that
C     there is room for its errors.  A port that is one of the speeds
C     keeps its place to rounding where it is held: friction 1D-6 of its
C     Stribeck speed, a stop 1D-6 of its travel (GSTVL) and its speed
C     of rebound.  Held along a row that turns with the state, or beside
C     loops, it moves by the errors of the steps: then the Stribeck
C     speed itself, 1D-2 of the travel, 100 speeds of rebound, and 1D-2
C     of the speeds that its row adds up.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NH, KIND(*), MODE(*)
      DOUBLE PRECISION   ROW(NH,*), S(*), SD(*), PRM(4,*), U(*)
      INTEGER            I, J, N
      DOUBLE PRECISION   SIZE, E, GAP, GSTVL
      LOGICAL            LOOSE
      EXTERNAL           GSTVL
C
      DO 20 I = 1, NH
         N = 0
         SIZE = 0.0D0
         DO 10 J = 1, NU
            IF ( ABS( ROW(I,J) ).GT.0.0D0 ) N = N + 1
            SIZE = SIZE + ABS( ROW(I,J)*U(J) )
   10    CONTINUE
         LOOSE = N.GT.1 .OR. NLAM.GT.0
         E = 0.0D0
         IF ( LOOSE ) E = 1.0D-2*SIZE
         IF ( KIND(I).EQ.1 ) THEN
            IF ( LOOSE ) E = E + PRM(2,I)
            E = MAX( E, 1.0D-6*PRM(2,I) )
            IF ( ABS( SD(I) ).GT.E .AND. DBLE( MODE(I) )*SD(I).LE.0.0D0
     $         ) MODE(I) = NINT( SIGN( 1.0D0, SD(I) ) )
         ELSE IF ( MODE(I).NE.0 ) THEN
            GAP = S(I) - PRM(1,I)
            IF ( MODE(I).GT.0 ) GAP = PRM(2,I) - S(I)
            GAP = ABS( GAP )/GSTVL( S(I), PRM(1,I) )
            IF ( LOOSE ) E = E + 1.0D2*PRM(4,I)
            E = MAX( E, PRM(4,I) )
            IF ( ABS( SD(I) ).GT.E .OR. GAP.GT.1.0D-2 .OR.
     $           ( GAP.GT.1.0D-6 .AND. .NOT.LOOSE ) ) MODE(I) = 0
         END IF
   20 CONTINUE
      END
