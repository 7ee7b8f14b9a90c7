      SUBROUTINE GSRES( EVT, RST, T, X, NX, V, CST, K, IE, RE, INFO )
C
C     PURPOSE
C     An event of a compiled run, and those that follow from it at the
C     same instant.
C
C     ARGUMENTS
C     EVT     (external) <NAME>_EVT( T, X, V, MODE, CST, GV ).
C     RST     (external) <NAME>_RST( T, X, V, MODE, K, CST, INFO ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     X       (input/output) DOUBLE PRECISION array, dimension (NX).
C     V       (input/output) DOUBLE PRECISION array, the inputs at T; the
C             modes in it are set.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     K       (input) INTEGER, the number of the event function; 0: the
C             start, modes are found; -1: inputs may have jumped.
C     IE      (input/output) INTEGER array, the plan of the events:
C             IE(1)  NE, the number of event functions (and modes);
C             IE(2)  NR, places for a record;
C             IE(3)  events so far;
C             IE(4)  events since the time went on;
C             IE(5)  1 if the modes at the start are given;
C             IE(6)  1: behind the events RST is called once more, with
C                    K = -2 (GSMBP's runs that carry derivatives by
C                    parameters have an RST of their own); 2: only events
C                    of the user are recorded, and counted; else 0;
C             IE(7)  (output) K, while RST is called;
C             IE(8)  1 while GSEVN looks for the time of an event in a
C                    run with IE(6) = 1: states alone are wanted;
C             IE(9)  (output) the number of the event function that ends
C                    the run, 0: none does; where INFO = 13 that of the
C                    mode;
C             IE(10) NS, how many inputs are switched at events of the
C                    user;
C             then NE modes, NE numbers of inputs that are the modes,
C             NE kinds (1, 2: see GSEVT; 3: an event of the user, 4: one
C             that ends the run, 5: one that only reports), NE marks, 1
C             where the function was above 0 since its last event, NE
C             workspace, NE flags, 1 where the function has just had its
C             event or the run begins; NS numbers of event functions, NS of the inputs
C             that they switch, NS flags, 1 where the input is held; NE
C             numbers, how many events a function has had, and the
C             number of the one that has had the last, 0: none has.
C     RE      (input/output) DOUBLE PRECISION array: NE event functions,
C             4*NE and 3*NX workspace (GSEVN); then NR records: time, number, mode
C             after, NX states before, NX after; then NE levels, what an
C             event function of the user is at its last event but for
C             rounding errors (it counts from there), NS values of
C             inputs that are held, NE times of the first and NE of the
C             last event of a function that has had one, and NE*(8+NX)
C             numbers of what is remembered of the user's (GSUSI), at
C             first 0.
C     INFO    (output) INTEGER, 0; the INFO of RST; 9: 100 events and
C             more at one instant; 13: a mode that is given contradicts
C             the state (GSRSM), or is one of an event of the user.
C
C     METHOD
C     An event of the user that falls to 0 at the same instant, or by
C     what another one sets, follows that one.
C     Where an event changes accelerations, ports that are held may no
C     longer be: they are let go, the most violated first; of those that
C     are at rest and slide some may have to stick again, or are pushed
C     against a stop (GSRSF).  Those that stick then come to rest exactly.
C
      IMPLICIT NONE
      EXTERNAL           EVT, RST, GSRSG, GSUSA, GSUSB, GSUSD, GSUSE,
     $                   GSUSL, GSUSU
      INTEGER            NX, K, IE(*), INFO
      DOUBLE PRECISION   T, X(NX), V(*), CST(*), RE(*)
      INTEGER            NE, JM, JK, JA, JL, JV, JC, JT, I, L, N, R, LS,
     $                   RS
      DOUBLE PRECISION   LEAST, G
      LOGICAL            HELD, GSUSU
C
      INFO = 0
      NE = IE(1)
      JM = 10
      JK = 10 + 2*NE
      JA = 10 + 3*NE
      JL = 10 + 4*NE
      JV = 5*NE + 3*NX + IE(2)*( 3 + 2*NX )
      JC = 10 + 6*NE + 3*IE(10)
      JT = JV + NE + IE(10)
      IE(7) = K
      IE(9) = 0
      CALL GSUSE( K, NX, IE, RE )
      L  = K
      IF ( L.EQ.0 .AND. IE(5).EQ.1 ) THEN
         L = -1
         CALL GSRSG( RST, T, X, V, CST, IE, INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
      LS = -1
      RS = 0
      IF ( L.EQ.0 ) LS = 0
   10 CONTINUE
      IF ( L.GE.0 ) THEN
         R = 0
         IF ( L.GT.0 ) THEN
            IE(4) = IE(4) + 1
            IF ( IE(4).GT.100 ) THEN
               INFO = 9
               RETURN
            END IF
            IF ( IE(6).NE.2 .OR. IE(JK+L).GT.2 ) THEN
               IE(3) = IE(3) + 1
               IE(JC+L) = IE(JC+L) + 1
               IE(JC+NE+1) = L
               IF ( IE(JC+L).EQ.1 ) RE(JT+L) = T
               RE(JT+NE+L) = T
               IF ( IE(3).LE.IE(2) ) R = 5*NE + 3*NX
     $                                   + ( IE(3) - 1 )*( 3 + 2*NX )
            END IF
         END IF
         IF ( R.GT.0 ) THEN
            RE(R+1) = T
            RE(R+2) = DBLE( L )
            DO 20 I = 1, NX
               RE(R+3+I) = X(I)
   20       CONTINUE
         END IF
         IF ( L.GT.0 ) THEN
            IF ( IE(JK+L).GT.2 ) THEN
               CALL EVT( T, X, V, IE(JM+1), CST, RE(NE+1) )
               CALL GSUSB( L, T, X, NX, IE, RE )
            END IF
            G = RE(NE+L)
         END IF
         CALL RST( T, X, V, IE(JM+1), L, CST, INFO )
         IF ( INFO.NE.0 ) RETURN
         IF ( L.GT.0 ) THEN
            IF ( IE(JK+L).EQ.1 .AND. IE(JM+L).EQ.0 ) THEN
               LS = L
               RS = R
            END IF
         END IF
         IF ( R.GT.0 ) THEN
            RE(R+3) = DBLE( IE(JM+L) )
            DO 30 I = 1, NX
               RE(R+3+NX+I) = X(I)
   30       CONTINUE
         END IF
      END IF
      CALL EVT( T, X, V, IE(JM+1), CST, RE )
      IF ( L.GT.0 ) THEN
         IF ( IE(JK+L).GT.2 ) THEN
            CALL GSUSA( L, X, NX, IE, RE )
            CALL GSUSL( L, K, G, NX, V, IE, RE )
         END IF
      END IF
C
C     -- ports that cannot be held; other stops that are hit just now,
C        also at the start
      N = 0
      LEAST = 0.0D0
      DO 40 I = 1, NE
         HELD = ( IE(JK+I).EQ.1 ) .EQV. ( IE(JM+I).EQ.0 )
         IF ( HELD .AND. RE(I).LT.LEAST ) THEN
            N = I
            LEAST = RE(I)
         END IF
   40 CONTINUE
      DO 50 I = 1, NE
         G = RE(I)
         IF ( IE(JK+I).GT.2 ) G = G - RE(JV+I)
         IF ( N.EQ.0 .AND. I.NE.L .AND. IE(JK+I).GE.2 .AND.
     $        IE(JM+I).EQ.0 .AND. G.LE.0.0D0 .AND.
     $        ( IE(JA+I).EQ.1 .OR. ( K.EQ.0 .AND. L.LE.0 .AND.
     $        IE(JK+I).EQ.2 ) ) ) N = I
   50 CONTINUE
C
C     -- friction at rest that slides against its push, stops that ports
C        at rest are pushed against
      IF ( N.EQ.0 ) THEN
         R = 0
         DO 52 I = 1, NE
            IE(JL+I) = IE(JM+I)
            HELD = ( IE(JK+I).EQ.1 ) .EQV. ( IE(JM+I).EQ.0 )
            IF ( IE(JK+I).LE.2 .AND. .NOT.HELD ) R = 1
   52    CONTINUE
         IF ( R.EQ.1 ) CALL RST( T, X, V, IE(JM+1), -3, CST, INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 53 I = 1, NE
            IF ( IE(JM+I).NE.IE(JL+I) .AND. I.NE.L ) N = I
            IE(JM+I) = IE(JL+I)
   53    CONTINUE
      END IF
      IF ( L.GT.0 ) IE(JA+L) = 0
      IF ( N.GT.0 ) THEN
         L = N
         GO TO 10
      END IF
C
C     -- what sticks comes to rest
      IF ( LS.GE.0 ) THEN
         CALL RST( T, X, V, IE(JM+1), -1, CST, INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 55 I = 1, NX
            IF ( RS.GT.0 ) RE(RS+3+NX+I) = X(I)
   55    CONTINUE
         CALL EVT( T, X, V, IE(JM+1), CST, RE )
      END IF
      IF ( IE(6).EQ.1 ) CALL RST( T, X, V, IE(JM+1), -2, CST, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSUSD( NX, IE, RE, RE )
C
C     -- functions that are above 0 yet, or have risen
      DO 60 I = 1, NE
         HELD = ( IE(JK+I).EQ.1 ) .EQV. ( IE(JM+I).EQ.0 )
         IF ( .NOT.( RE(I).GT.0.0D0 ) ) IE(JA+I) = 0
         IF ( GSUSU( I, RE(I), NX, IE, RE ) .OR. ( IE(JK+I).EQ.1 .AND.
     $        HELD ) ) IE(JA+I) = 1
   60 CONTINUE
      END
      SUBROUTINE GSRSG( RST, T, X, V, CST, IE, INFO )
C
C     PURPOSE
C     Do the modes that are given at the start agree with the state?
C
C     ARGUMENTS
C     As GSRES; IE(9) and INFO = 13 tell the first one that does not.
C
      IMPLICIT NONE
      EXTERNAL           RST
      INTEGER            IE(*), INFO
      DOUBLE PRECISION   T, X(*), V(*), CST(*)
      INTEGER            NE, JM, JK, JL, I, PORTS
C
      NE = IE(1)
      JM = 10
      JK = 10 + 2*NE
      JL = 10 + 4*NE
      INFO = 0
      PORTS = 0
      DO 10 I = 1, NE
         IE(JL+I) = IE(JM+I)
         IF ( IE(JK+I).LE.2 ) PORTS = 1
   10 CONTINUE
      IF ( PORTS.EQ.1 ) CALL RST( T, X, V, IE(JM+1), -4, CST, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = NE, 1, -1
         IF ( IE(JM+I).NE.IE(JL+I) .OR. ( IE(JK+I).GT.2 .AND.
     $        IE(JM+I).NE.0 ) ) THEN
            IE(9) = I
            INFO  = 13
         END IF
         IE(JM+I) = IE(JL+I)
   20 CONTINUE
      END
