      SUBROUTINE GSUSE( K, NX, IE, RE )
C
C     PURPOSE
C     Before GSRES acts at event K: which event functions of the user
C     have had their event just now; all of them at the start (K = 0).
C     And what their rounding errors are: those that only report must be
C     above them to have risen.
C
C     METHOD
C     These are 1000 units of rounding of what they were in the step up
C     to an event: a speed that is held at 0 may not be 0 but for
C     rounding errors.
C
      IMPLICIT NONE
      INTEGER            K, NX, IE(*)
      DOUBLE PRECISION   RE(*)
      INTEGER            NE, I, J, GSUSI
      DOUBLE PRECISION   GSEPS
      EXTERNAL           GSEPS, GSUSI
C
      NE = IE(1)
      DO 10 I = 1, NE
         IF ( K.GE.0 ) IE(10+5*NE+I) = 0
         IF ( K.EQ.0 .AND. IE(10+2*NE+I).GT.2 ) IE(10+5*NE+I) = 1
         IF ( K.GT.0 .AND. IE(10+2*NE+I).GT.2 ) THEN
            J = GSUSI( I, NX, IE )
            RE(J+8) = MAX( RE(J+8), 1.0D3*GSEPS()*MAX( ABS( RE(I) ),
     $         ABS( RE(2*NE+I) ), ABS( RE(4*NE+I) ) ) )
            IF ( IE(10+2*NE+I).EQ.5 ) RE(J+6) = MAX( RE(J+6), RE(J+8) )
         END IF
   10 CONTINUE
      END
      SUBROUTINE GSUSL( L, K, G, NX, V, IE, RE )
C
C     PURPOSE
C     After event L of the user, which GSRES met at event K: its level,
C     the inputs that it switches, whether it ends the run.
C
C     ARGUMENTS
C     L, K    (input) INTEGER, numbers of event functions.
C     G       (input) DOUBLE PRECISION, function L before the event.
C     NX      (input) INTEGER, the number of states.
C     V       (input) DOUBLE PRECISION array, the inputs, switched.
C     IE, RE  (input/output) as GSRES; RE(I) are the event functions
C             after the event.
C
C     METHOD
C     Where the event was looked for within a step (L = K) and what it
C     sets has not changed its own function, this is 0 but for rounding
C     errors: it is taken for 0, or a body that has just left the ground
C     would be below it yet.  So are functions that were the same number
C     within the step: their events are at the same instant (GSRES); and
C     the same with the other sign, the way back, which would fall by
C     rounding errors; it was below 0 before.
C
      IMPLICIT NONE
      INTEGER            L, K, NX, IE(*)
      DOUBLE PRECISION   G, V(*), RE(*)
      INTEGER            NE, NS, JL, JS, I, J
      DOUBLE PRECISION   SIZE, OLD, LIKE
C
      NE = IE(1)
      NS = IE(10)
      JL = 5*NE + 3*NX + IE(2)*( 3 + 2*NX )
      JS = 10 + 6*NE
      IE(10+5*NE+L) = 1
      OLD = RE(JL+L)
      IF ( L.EQ.K .OR. ABS( RE(L) - OLD ).GT.0.0D0 ) RE(JL+L) = 0.0D0
      SIZE = MAX( ABS( RE(2*NE+L) ), ABS( RE(4*NE+L) ) )
      IF ( L.EQ.K .AND. ABS( G - OLD ).LE.1.0D-2*SIZE .AND.
     $     ABS( RE(L) - G ).LE.MAX( 0.5D0*ABS( G ), 1.0D-8*SIZE ) ) THEN
         RE(JL+L) = RE(L)
         DO 5 I = 1, NE
            LIKE = SIGN( 1.0D0, RE(2*NE+I) )*SIGN( 1.0D0, RE(2*NE+L) )
            IF ( IE(10+2*NE+I).GT.2 .AND. I.NE.L .AND.
     $           ABS( RE(2*NE+I) - LIKE*RE(2*NE+L) )
     $           .LE.1.0D-8*ABS( RE(2*NE+L) ) .AND.
     $           ABS( RE(I) - LIKE*RE(L) ).LE.1.0D-8*SIZE ) THEN
               RE(JL+I) = RE(I)
               IF ( LIKE.LT.0.0D0 ) THEN
                  IE(10+3*NE+I) = 0
                  IE(10+5*NE+I) = 1
               END IF
            END IF
    5    CONTINUE
      END IF
      IF ( IE(10+2*NE+L).EQ.4 .AND. IE(9).EQ.0 ) IE(9) = L
      DO 20 I = 1, NS
         IF ( IE(JS+I).EQ.L ) THEN
            DO 10 J = 1, NS
               IF ( IE(JS+NS+J).EQ.IE(JS+NS+I) ) IE(JS+2*NS+J) = 0
   10       CONTINUE
            IE(JS+2*NS+I) = 1
            RE(JL+NE+I) = V(IE(JS+NS+I))
         END IF
   20 CONTINUE
      END
      SUBROUTINE GSUSD( NX, IE, RE, G )
C
C     PURPOSE
C     Event functions of the user, G, from their levels on.  A level
C     that later events of the same instant have left is none.  To have
C     risen they must be above ten times their level, and 0.7 of
C     what that was at the event before (noise: levels may be small by
C     chance); reports above the largest so far.
C
      IMPLICIT NONE
      INTEGER            NX, IE(*)
      DOUBLE PRECISION   RE(*), G(*)
      INTEGER            NE, JL, I, J, GSUSI
      EXTERNAL           GSUSI
C
      NE = IE(1)
      JL = 5*NE + 3*NX + IE(2)*( 3 + 2*NX )
      DO 10 I = 1, NE
         IF ( IE(10+2*NE+I).GT.2 ) THEN
            J = GSUSI( I, NX, IE ) + 6
            IF ( IE(10+2*NE+I).NE.5 .AND. IE(10+5*NE+I).EQ.1 )
     $         RE(J) = 0.7D0*RE(J)
            RE(J) = MAX( RE(J), 10.0D0*ABS( RE(JL+I) ) )
            IF ( ABS( G(I) - RE(JL+I) ).GT.ABS( RE(JL+I) ) )
     $         RE(JL+I) = 0.0D0
            G(I) = G(I) - RE(JL+I)
         END IF
   10 CONTINUE
      END
      SUBROUTINE GSUSG( NX, IE, RE )
C
C     PURPOSE
C     Event functions in RE(NE+1..2*NE) of GSEVN from the levels of the
C     user's on.
C
      IMPLICIT NONE
      INTEGER            NX, IE(*)
      DOUBLE PRECISION   RE(*)
      INTEGER            NE, JL, I
C
      NE = IE(1)
      JL = 5*NE + 3*NX + IE(2)*( 3 + 2*NX )
      DO 10 I = 1, NE
         IF ( IE(10+2*NE+I).GT.2 ) RE(NE+I) = RE(NE+I) - RE(JL+I)
   10 CONTINUE
      END
      SUBROUTINE GSUSC( NX, IE, RE )
C
C     PURPOSE
C     After a step without an event: levels that event functions of the
C     user, RE(1..NE), have left behind are none; no function has just
C     had its event.
C
      IMPLICIT NONE
      INTEGER            NX, IE(*)
      DOUBLE PRECISION   RE(*)
      INTEGER            NE, JL, I
      DOUBLE PRECISION   G
C
      NE = IE(1)
      JL = 5*NE + 3*NX + IE(2)*( 3 + 2*NX )
      DO 10 I = 1, NE
         IF ( IE(10+2*NE+I).GT.2 ) THEN
            IE(10+5*NE+I) = 0
            G = RE(I) + RE(JL+I)
            IF ( G*RE(I).GT.0.0D0 ) THEN
               RE(I) = G
               RE(JL+I) = 0.0D0
            END IF
         END IF
   10 CONTINUE
      END
