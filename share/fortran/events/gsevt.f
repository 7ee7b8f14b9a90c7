      SUBROUTINE GSEVT( K, KIND, MODE, S, SD, PRM, HOLD, GV )
C
C     PURPOSE
C     Event functions of the ports that stick or hit a stop: above 0
C     where nothing happens; an event is where one falls to 0.
C
C     ARGUMENTS
C     K       (input) INTEGER, the number of ports.
C     KIND    (input) INTEGER array, dimension (K), 1 friction, 2 stops.
C     MODE    (input) INTEGER array, dimension (K): friction: 1 or -1
C             where it slides forward or backward, 0 where it sticks;
C             stops: 1 or -1 where the upper or lower stop is in
C             contact, else 0.
C     S, SD   (input) DOUBLE PRECISION arrays, dimension (K), positions
C             and speeds of the ports.
C     PRM     (input) DOUBLE PRECISION array, dimension (4,K): friction:
C             (1) the largest force that holds, (2) its Stribeck speed:
C             a speed 1D-9 of this the other way is rest, not sliding
C             back (rounding errors where a stop holds the port, too);
C             stops: (1) lower and (2)
C             upper end, (3) restitution, (4) speed of rebound below
C             which the contact stays.
C     HOLD    (input) DOUBLE PRECISION array, dimension (K), the efforts
C             that hold the ports.
C     GV      (output) DOUBLE PRECISION array, dimension (K).
C
C     METHOD
C     A port that rests where a stop is, held by something else, or
C     leaves it does not hit it: what is left of its distance, up to
C     1D-12 of its travel (GSTVL) before its end and 1D-6 behind it, are
C     errors of rounding and of the step that came there.
C
      IMPLICIT NONE
      INTEGER            K, KIND(*), MODE(*)
      DOUBLE PRECISION   S(*), SD(*), PRM(4,*), HOLD(*), GV(*)
      INTEGER            I
      DOUBLE PRECISION   TINY, WAY, GSTVL
      EXTERNAL           GSTVL
C
      DO 10 I = 1, K
         IF ( KIND(I).EQ.1 .AND. MODE(I).EQ.0 ) THEN
            GV(I) = PRM(1,I) - ABS( HOLD(I) )
         ELSE IF ( KIND(I).EQ.1 ) THEN
            GV(I) = DBLE( MODE(I) )*SD(I) + 1.0D-9*PRM(2,I)
         ELSE IF ( MODE(I).EQ.0 ) THEN
            GV(I) = ( PRM(2,I) - S(I) )*( S(I) - PRM(1,I) )
     $              /( PRM(2,I) - PRM(1,I) )
            TINY = 1.0D-12*GSTVL( S(I), PRM(1,I) )
            WAY = SD(I)
            IF ( S(I) - PRM(1,I).LT.PRM(2,I) - S(I) ) WAY = -WAY
            IF ( GV(I).LE.TINY .AND. GV(I).GE.-1.0D6*TINY .AND.
     $           WAY.LE.1.0D-9*PRM(4,I) ) GV(I) = TINY
         ELSE
            GV(I) = -DBLE( MODE(I) )*HOLD(I)
         END IF
   10 CONTINUE
      END
      DOUBLE PRECISION FUNCTION GSTVL( S, PRM )
C
C     PURPOSE
C     The travel of a stop that errors at its nearer end are beside: its
C     range, but no more than 1 [m or rad] or the modulus of that end,
C     the larger one of them, as the other end may be out of reach.
C
C     ARGUMENTS
C     S       (input) DOUBLE PRECISION, the position of the port.
C     PRM     (input) DOUBLE PRECISION array, dimension (4), of the stop
C             as GSEVT has it.
C
      IMPLICIT NONE
      DOUBLE PRECISION   S, PRM(4), END
C
      END = PRM(1)
      IF ( PRM(2) - S.LT.S - PRM(1) ) END = PRM(2)
      GSTVL = MIN( PRM(2) - PRM(1), MAX( 1.0D0, ABS( END ) ) )
      END
