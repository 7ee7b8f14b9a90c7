      INTEGER FUNCTION GSUSI( I, NX, IE )
C
C     PURPOSE
C     Where in RE of GSRES, behind this place, what is remembered of
C     event function I of the user stands: 1 to 4 the times of its last
C     events, the last one first; 5 is 1 where that has changed states;
C     6 what it must be above to have risen; 7 workspace of GSEVA and
C     GSEVL; 8 rounding errors of it, 1000 units of what it was in steps
C     up to events; then NX states behind the last one.
C
      IMPLICIT NONE
      INTEGER            I, NX, IE(*)
C
      GSUSI = 8*IE(1) + 3*NX + IE(2)*( 3 + 2*NX ) + IE(10)
     $        + ( I - 1 )*( 8 + NX )
      END
      SUBROUTINE GSUSB( I, T, X, NX, IE, RE )
C
C     PURPOSE
C     Before event I of the user at the time T: it is one more of those
C     that are remembered, with the state before it.
C
      IMPLICIT NONE
      INTEGER            I, NX, IE(*)
      DOUBLE PRECISION   T, X(NX), RE(*)
      INTEGER            J, K, GSUSI
      EXTERNAL           GSUSI
C
      J = GSUSI( I, NX, IE )
      DO 10 K = 4, 2, -1
         RE(J+K) = RE(J+K-1)
   10 CONTINUE
      RE(J+1) = T
      DO 20 K = 1, NX
         RE(J+8+K) = X(K)
   20 CONTINUE
      END
      SUBROUTINE GSUSA( I, X, NX, IE, RE )
C
C     PURPOSE
C     Behind event I of the user: the state, and whether it is another
C     one.
C
      IMPLICIT NONE
      INTEGER            I, NX, IE(*)
      DOUBLE PRECISION   X(NX), RE(*)
      INTEGER            J, K, GSUSI
      EXTERNAL           GSUSI
C
      J = GSUSI( I, NX, IE )
      RE(J+5) = 0.0D0
      DO 10 K = 1, NX
         IF ( ABS( RE(J+8+K) - X(K) ).GT.0.0D0 ) RE(J+5) = 1.0D0
         RE(J+8+K) = X(K)
   10 CONTINUE
      END
      LOGICAL FUNCTION GSUSU( I, G, NX, IE, RE )
C
C     PURPOSE
C     Has an event function, which is G, risen above 0?
C
C     ARGUMENTS
C     I, NX   (input) INTEGER, its number; the number of states.
C     G       (input) DOUBLE PRECISION.
C     IE, RE  (input) as GSRES.
C
C     METHOD
C     One of the user must be above what rounding errors make of 0, see
C     GSUSD, and GSUSE and GSUSZ for those that only report.
C
      IMPLICIT NONE
      INTEGER            I, NX, IE(*), GSUSI
      DOUBLE PRECISION   G, RE(*)
      EXTERNAL           GSUSI
C
      GSUSU = G.GT.0.0D0
      IF ( GSUSU .AND. IE(10+2*IE(1)+I).GT.2 )
     $   GSUSU = G.GT.RE(GSUSI( I, NX, IE )+6)
      END
      DOUBLE PRECISION FUNCTION GSUST( R )
C
C     PURPOSE
C     From when on the events of a function of the user accumulate that
C     does not rise above 0 again.
C
C     ARGUMENTS
C     R       (input) DOUBLE PRECISION array, dimension (5), what is
C             remembered of it (GSUSI), of four events at least.
C
C     METHOD
C     Where its last four events lie within 1D-9 of the time since then.
C     Where the last event has changed states and three intervals
C     between them fell one after the other, after twice the last one;
C     where all three are within 1D-8 of the time, whatever their order,
C     after ten times as long (bounces that drown in rounding errors).
C
      IMPLICIT NONE
      DOUBLE PRECISION   R(5)
C
      GSUST = R(1) + 1.0D9*( R(1) - R(4) )
      IF ( R(5).GT.0.0D0 .AND. R(1) - R(2).LT.R(2) - R(3) .AND.
     $     R(2) - R(3).LT.R(3) - R(4) )
     $   GSUST = MIN( GSUST, R(1) + 2.0D0*( R(1) - R(2) ) )
      IF ( R(5).GT.0.0D0 .AND. R(1) - R(4).LT.1.0D-8*ABS( R(1) ) )
     $   GSUST = MIN( GSUST, R(1) + 10.0D0*( R(1) - R(4) ) )
      END
      INTEGER FUNCTION GSUSN( T, H, NX, IE, RE )
C
C     PURPOSE
C     In how many points event functions of the user must be looked at
C     in a step from T to T + H: 8; where it goes past four intervals of
C     the last events of a function 8 for each that it may hold.  What
C     repeats itself may else look as if it were slow.  Intervals of
C     1D-9 of the time are those of events that accumulate.
C
      IMPLICIT NONE
      INTEGER            NX, IE(*)
      DOUBLE PRECISION   T, H, RE(*)
      INTEGER            NE, I, J, JC, GSUSI
      DOUBLE PRECISION   D, SOON, MOST, LEAST
      EXTERNAL           GSUSI
C
      NE = IE(1)
      JC = 10 + 6*NE + 3*IE(10)
      MOST = 8.0D0
      LEAST = 1.0D-9*MAX( ABS( T ), ABS( T + H ) )
      DO 10 I = 1, NE
         IF ( IE(10+2*NE+I).LT.3 .OR. IE(JC+I).LT.4 ) GO TO 10
         J = GSUSI( I, NX, IE )
         D = ( RE(J+1) - RE(J+4) )/3.0D0
         SOON = RE(J+1) + 4.0D0*D
         IF ( D.GT.LEAST .AND. T.LT.SOON .AND. T + H.GT.SOON )
     $      MOST = MAX( MOST, MIN( 8.0D0*H, 1.0D6*D )/D )
   10 CONTINUE
      GSUSN = INT( MOST )
      END
      SUBROUTINE GSUSZ( RHS, CON, KIN, CMD, CLO, VIN, EVT, T, H, SIZ,
     $                  NOT, IP, RP, CST, V, WI, P, ISTAT, RSTAT, IE,
     $                  RE, G, INFO )
C
C     PURPOSE
C     After a step, or its part up to an event: do events of the user
C     accumulate?
C
C     ARGUMENTS
C     As GSEVN, and
C     T, H    (input) DOUBLE PRECISION, its beginning and length.
C     NOT     (input) INTEGER, the event function that ends it, or 0.
C     ISTAT   (input/output) INTEGER array: where INFO = 10, (6) and (7)
C             say so, (19) is the function that does, of several one
C             that changes states.
C     G       (input) DOUBLE PRECISION array, dimension (NE), the event
C             functions at the end.
C     INFO    (output) INTEGER, 0; 10: they do.
C
C     METHOD
C     Where a function has its fourth event within 1000 units of
C     rounding of the time; or where GSUST says so and it has not risen
C     since, though it should have: it does not go on falling (GSUSF).
C     One that only reports does not accumulate: where it seems so it
C     has to rise higher, tenfold, to have risen again.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            SIZ(8), NOT, IP(*), ISTAT(*), IE(*), INFO
      DOUBLE PRECISION   T, H, RP(*), CST(*), V(*), WI(*), P(*),
     $                   RSTAT(*), RE(*), G(*)
      INTEGER            NE, NX, I, J, JC, GSUSI
      DOUBLE PRECISION   END, GSEPS, GSUST
      LOGICAL            YES
      EXTERNAL           GSEPS, GSUSF, GSUSI, GSUST
C
      INFO = 0
      NX  = SIZ(3)
      NE  = IE(1)
      JC  = 10 + 6*NE + 3*IE(10)
      END = T + H
      DO 10 I = 1, NE
         IF ( IE(10+2*NE+I).LT.3 ) GO TO 10
         J = GSUSI( I, NX, IE )
         YES = .FALSE.
         IF ( I.EQ.NOT ) THEN
            IF ( IE(JC+I).GE.3 ) YES = RE(J+3).GE.END
     $         - 1.0D3*GSEPS()*ABS( END )
            IF ( YES .AND. IE(10+2*NE+I).EQ.5 ) THEN
               RE(J+6) = 10.0D0*MAX( RE(J+6), ABS( RE(2*NE+I) ),
     $                               ABS( RE(4*NE+I) ) )
               YES = .FALSE.
            END IF
         ELSE IF ( IE(10+3*NE+I) + IE(10+4*NE+I).EQ.0 .AND.
     $             IE(10+2*NE+I).NE.5 ) THEN
            IF ( IE(JC+I).GE.4 ) YES = END.GE.GSUST( RE(J+1) )
            IF ( YES ) CALL GSUSF( RHS, CON, KIN, CMD, CLO, VIN, EVT, I,
     $         -G(I)/MAX( 1.0D-300, END - RE(J+1) ), 5.0D-6*MAX( H,
     $         RSTAT(7) ), SIZ, IP, RP, CST, V, WI, P, ISTAT, RSTAT, IE,
     $         RE, RE(J+1), RE(J+9), YES )
         END IF
         IF ( YES ) THEN
            IF ( INFO.EQ.0 .OR. RE(J+5).GT.0.0D0 ) ISTAT(19) = I
            INFO = 10
            ISTAT(6) = INFO
            ISTAT(7) = 7
         END IF
   10 CONTINUE
      END
      SUBROUTINE GSUSF( RHS, CON, KIN, CMD, CLO, VIN, EVT, I, FELL, D,
     $                  SIZ, IP, RP, CST, V, WI, P, ISTAT, RSTAT, IE,
     $                  RE, T, X, ROSE )
C
C     PURPOSE
C     Behind its last event: does event function I rise, as one does
C     that was thrown back, or does it go on falling?
C
C     ARGUMENTS
C     As GSEVN, and
C     FELL    (input) DOUBLE PRECISION, how fast it has fallen since, in
C             the mean.
C     D       (input) DOUBLE PRECISION, a small time [s].
C     T, X    (input) DOUBLE PRECISION, that event and the state behind
C             it.
C     ROSE    (output) LOGICAL, false where it falls.
C
C     METHOD
C     Its rate is that of the difference quotient of second order along
C     the rates of the states; it falls where that is below -FELL/100.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            I, SIZ(8), IP(*), ISTAT(*), IE(*)
      DOUBLE PRECISION   FELL, D, RP(*), CST(*), V(*), WI(*), P(*),
     $                   RSTAT(*), RE(*), T, X(*)
      LOGICAL            ROSE
      INTEGER            NU, NX, NE, KG, KZ, KX, J, K, INFO
      DOUBLE PRECISION   S, RATE
      EXTERNAL           GSEVV, GSFUN
C
      NU = SIZ(2)
      NX = SIZ(3)
      NE = IE(1)
      KG = 1 + 3*NE
      KZ = 1 + 5*NE + NX
      KX = KZ + NX
      ROSE = .TRUE.
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, X, SIZ(1), NU, NX,
     $            SIZ(4), SIZ(5), IP, RP, CST, V, RE(KX), WI, P, ISTAT,
     $            RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      RATE = 0.0D0
      DO 20 K = 1, 2
         S = DBLE( 2*K - 3 )
         DO 10 J = 1, NX
            RE(KZ+J-1) = X(J) + S*D*RE(KX+J-1)
   10    CONTINUE
         CALL GSEVV( CMD, CLO, VIN, EVT, T + S*D, 1, RE(KZ), NU, NX,
     $               SIZ(4), IP, RP, CST, V, WI, IE(11), RE(KG), INFO )
         IF ( INFO.NE.0 ) RETURN
         RATE = RATE + S*RE(KG+I-1)/( 2.0D0*D )
   20 CONTINUE
      ROSE = .NOT.( RATE.LT.-0.01D0*FELL )
      END
