      SUBROUTINE GSEVN( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $                  WAY, T, TN, SIDE, H, X, SIZ, IP, RP, CST, V,
     $                  ROPT, XN, W, WI, P, ISTAT, RSTAT, IE, RE, GAUSS,
     $                  FOUND, INFO )
C
C     PURPOSE
C     Looks for the first event within a step; if there is one, the step
C     is done again up to it.
C
C     ARGUMENTS
C     As GSDP8, GSRK4 (H is the whole step, W of either), GSRES, and
C     METHOD  (input) INTEGER, 4, 8, 9 or 12: the step from (T,X) was
C             GSRK4's, GSDP8's or GSPSG's, whose polynomial has the
C             states within it: it is not done again; 0: no more is one
C             of an implicit method, whose states at the points of
C             GSEVQ are in W.  With 8 and 9 W holds the stages of
C             GSDP8; where there is no event columns 1 and 6 to 13
C             stay.
C     WAY     (input) INTEGER, the way of the loops, see GSSIM.
C     SIZ, ROPT (input) as GSSIM.
C     TN      (input/output) DOUBLE PRECISION, the end of the step, on
C             exit the time of the event where there is one.
C     XN      (input/output) DOUBLE PRECISION array, dimension (NX), the
C             state at TN.
C     GAUSS   (input/output) DOUBLE PRECISION array, dimension (3): TC,
C             D, NS of GSPSG, for METHOD = 12; for 8 and 9 GAUSS(1) is
C             on exit the error of the polynomial beside the tolerance
C             where that is why FOUND is -1, else 0; GAUSS(2) is on
C             entry 1 where outputs lie within the step: then it must be
C             within three tolerances, GAUSS(2) on exit OFF of GSEVY,
C             and where FOUND is 0 it is in the columns 2 to 5 of W.
C     FOUND   (output) INTEGER, the number of the event function; 0:
C             none; -1: the step is too long to see what happens just
C             after the last event, or its error, up to the event, is
C             too large.
C     INFO    (output) INTEGER, 0 or the INFO of what failed; 10: events
C     of the user accumulate.
C
C     METHOD
C     Most steps of GSDP8 are quiet, which GSEVA tells; in the others
C     states are those of its polynomial of order 7 (GSDPE), and a step
C     is repeated where this is off by ten tolerances, or by three where
C     outputs are to be taken from it.
C     Eight points of that polynomial (of the cubic one through both
C     ends of a step of GSRK4, of that of GSPSG or GSEVQ), not evenly
C     spaced (what repeats itself would hide between them), tell whether
C     an event function falls to 0, and up to 2048 where it has a lowest
C     value that they do not resolve (ports that stick let steps grow,
C     whatever the inputs do), or its last events say so (GSUSN: where
C     these are too few the step is too long); its zero by the method of
C     Illinois. The
C     part before it is looked at again in the same way: there may be an
C     earlier one.  Where a function of the user has just had its event
C     more points are closer and closer to the beginning of the step.
C     A function of the user that rises above 0 on that polynomial first
C     must do so on the step itself, where that polynomial is highest on
C     the way to its zero, and one that falls to 0 must do that: else
C     its sign at the end of this step is all that counts (its flag is 2
C     or 3), and for a stop the step is repeated.
C     Those of the user that have been above 0 before it count as such.
C     From there on the step itself is made as long as it must be, by
C     the secant method, so that the state at the event is as accurate
C     as any other.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            METHOD, WAY, SIDE, SIZ(8), IP(*), ISTAT(*),
     $                   IE(*), FOUND, INFO
      DOUBLE PRECISION   T, TN, H, X(*), RP(*), CST(*), V(*), ROPT(*),
     $                   XN(*), W(*), WI(*), P(*), RSTAT(*), RE(*),
     $                   GAUSS(3)
      INTEGER            NQ, NU, NX, NV, NLAM, NE, JM, JK, JA, JL, KD,
     $                   I, NS, MANY, FIRST, GSUSN
      DOUBLE PRECISION   TH, EPS, GSEPS, BE, THF, ERR, TE, MOST
      LOGICAL            HELD, FINE, FAST, MORE, LATER, QUIET, LONG,
     $                   DP8, ROWS
      EXTERNAL           GSEPS, GSFUN, GSEVA, GSEVL, GSEVM, GSEVS,
     $                   GSEVD, GSEVY, GSUSC, GSUSN, GSUSZ
C
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      FOUND = 0
      INFO  = 0
      EPS = GSEPS()
      DP8  = METHOD.EQ.8 .OR. METHOD.EQ.9
      LONG = ABS( H ).GT.1.0D3*EPS*MAX( ABS( T ), ABS( TN ) )
      MOST = 1.0D0
      IF ( NLAM.GT.0 .AND. P(13).LT.0.25D0*P(14) )
     $   MOST = MAX( MOST, EPS**( 2.0D0/3.0D0 )/ROPT(2) )
      NE = IE(1)
      JM = 10
      JK = 10 + 2*NE
      JA = 10 + 3*NE
      JL = 10 + 4*NE
      KD = 1 + 5*NE
      IF ( METHOD.EQ.4 ) THEN
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, X, NQ, NU, NX,
     $               NV, NLAM, IP, RP, CST, V, W, WI, P, ISTAT, RSTAT,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
      IF ( METHOD.NE.12 .AND. METHOD.NE.0 ) THEN
         CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, TN, SIDE, XN, NQ, NU,
     $               NX, NV, NLAM, IP, RP, CST, V, RE(KD), WI, P, ISTAT,
     $               RSTAT, INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
C
C     -- the first function that falls to 0; the part before it again
      DO 5 I = 1, NE
         IF ( METHOD.NE.0 .AND. IE(10+5*NE+I).GE.2 )
     $      IE(10+5*NE+I) = 3 - IE(10+5*NE+I)
    5 CONTINUE
      FIRST = 0
      IF ( DP8 ) THEN
         GAUSS(1) = 0.0D0
         ROWS = GAUSS(2).GT.0.0D0
         IF ( ROWS ) THEN
            CALL GSEVY( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE, H, X,
     $                  SIZ, IP, RP, CST, V, ROPT, XN, W, WI, P, ISTAT,
     $                  RSTAT, IE, RE, .FALSE., ERR, INFO )
            IF ( INFO.NE.0 ) RETURN
            GAUSS(2) = ERR
            IF ( .NOT.( ERR.LE.MOST ) .AND. LONG ) THEN
               GAUSS(1) = ERR
               FOUND = -1
               RETURN
            END IF
         END IF
         CALL GSEVA( CMD, CLO, VIN, EVT, T, H, SIDE, NX, X, W, XN, NU,
     $               NV, IP, RP, CST, V, WI, IE, RE, QUIET, INFO )
         IF ( INFO.NE.0 ) GO TO 900
         IF ( QUIET ) GO TO 28
         IF ( .NOT.ROWS ) CALL GSEVY( RHS, CON, KIN, CMD, CLO, VIN, T,
     $      TN, SIDE, H, X, SIZ, IP, RP, CST, V, ROPT, XN, W, WI, P,
     $      ISTAT, RSTAT, IE, RE, .FALSE., ERR, INFO )
         IF ( INFO.NE.0 ) RETURN
         IF ( .NOT.( ERR.LE.3.0D0*MOST ) .AND. LONG ) THEN
            GAUSS(1) = ERR
            FOUND = -1
            RETURN
         END IF
      END IF
      MORE = .FALSE.
      MANY = GSUSN( T, H, NX, IE, RE )
      IF ( MANY.GT.2048 .AND. LONG ) THEN
         FOUND = -1
         RETURN
      END IF
      MANY = MIN( MANY, 2048 )
      NS = MANY
      BE = 1.0D0
      THF = 2.0D0
   10 CONTINUE
      I = 1
      IF ( FIRST.EQ.0 ) I = SIDE
      CALL GSEVL( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, BE, NS, I,
     $            NX, X, W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE,
     $            FOUND, TH, FINE, FAST, INFO )
      IF ( INFO.NE.0 ) GO TO 900
      IF ( ( FINE .OR. FAST ) .AND. NS.LT.2048 ) THEN
         NS = 2*NS
         GO TO 10
      END IF
      IF ( FAST .AND. LONG .AND. H.GT.1.0D-2*RSTAT(7) .AND.
     $     RSTAT(7).GT.0.0D0 ) THEN
         FOUND = -1
         RETURN
      END IF
      IF ( FOUND.GT.0 .AND. TH.LT.0.999D0*THF ) THEN
C
C        -- a function that was not above 0: is it so on the way there?
         IF ( IE(JA+FOUND).EQ.0 .AND. IE(JK+FOUND).GT.2 .AND.
     $        METHOD.NE.0 .AND. METHOD.NE.12 ) THEN
            CALL GSEVM( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, FOUND,
     $                  TH, NX, X, W, XN, NU, NV, IP, RP, CST, V, WI,
     $                  IE, RE, TE, INFO )
            IF ( INFO.NE.0 ) GO TO 900
            IE(8) = IE(6)
            CALL GSEVD( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $                  WAY, T, TN, SIDE, H, TE*TH, X, SIZ, IP, RP,
     $                  CST, V, ROPT, XN, W, WI, P, ISTAT, RSTAT, IE,
     $                  RE, GAUSS, TE, ERR, INFO )
            IE(8) = 0
            IF ( INFO.NE.0 ) RETURN
            IF ( .NOT.( RE(NE+FOUND).GT.0.0D0 ) ) GO TO 15
            IF ( DP8 ) CALL GSEVY( RHS, CON, KIN, CMD, CLO, VIN, T, TN,
     $         SIDE, H, X, SIZ, IP, RP, CST, V, ROPT, XN, W, WI, P,
     $         ISTAT, RSTAT, IE, RE, .TRUE., ERR, INFO )
            IF ( INFO.NE.0 ) RETURN
         END IF
         FIRST = FOUND
         THF = TH
         BE = TH*( 1.0D0 - 1.0D-9 )
         NS = MAX( 8, INT( BE*DBLE( MANY ) ) )
         GO TO 10
      END IF
C
      GO TO 16
C
C     -- what the polynomial alone says: all again in more points, and
C        then without it
   15 I = 10 + 5*NE + FOUND
      IF ( MORE ) IE(I) = 3 - MIN( 1, IE(I) )
      IF ( DP8 ) CALL GSEVY( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE,
     $   H, X, SIZ, IP, RP, CST, V, ROPT, XN, W, WI, P, ISTAT, RSTAT,
     $   IE, RE, .TRUE., ERR, INFO )
      IF ( INFO.NE.0 ) RETURN
      FIRST = 0
      BE = 1.0D0
      THF = 2.0D0
      NS = MANY
      IF ( .NOT.MORE ) NS = MAX( MANY, 512 )
      MORE = .TRUE.
      GO TO 10
C
   16 CONTINUE
C     -- functions that have not risen above 0 since their last event
      FOUND = 0
      DO 20 I = 1, NE
         HELD = ( IE(JK+I).EQ.1 ) .EQV. ( IE(JM+I).EQ.0 )
         IF ( I.NE.FIRST .AND. IE(JL+I).EQ.0 .AND. .NOT.HELD .AND.
     $        IE(JK+I).LT.3 .AND. RE(2*NE+I).LT.0.0D0 ) FOUND = I
   20 CONTINUE
      IF ( FOUND.GT.0 .AND. LONG ) THEN
         FOUND = -1
      ELSE IF ( FIRST.GT.0 ) THEN
         FOUND = FIRST
         IF ( IE(10+5*NE+FIRST).GE.2 .AND. LONG ) THEN
            FOUND = -1
            RETURN
         END IF
         CALL GSEVS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $               WAY, T, TN, SIDE, H, X, SIZ, IP, RP, CST, V, ROPT,
     $               XN, W, WI, P, ISTAT, RSTAT, IE, RE, GAUSS, FOUND,
     $               THF, ERR, INFO )
         IF ( INFO.EQ.0 .AND. FOUND.EQ.0 ) THEN
            FOUND = -1
            IF ( IE(JK+FIRST).EQ.2 .AND. LONG ) RETURN
            FOUND = FIRST
            GO TO 15
         END IF
         IF ( ERR.GT.MOST .AND. LONG ) FOUND = -1
         LATER = TN - T.GT.1.0D3*EPS*MAX( ABS( T ), ABS( TN ) )
         IF ( LATER ) IE(4) = 0
         IF ( INFO.EQ.0 .AND. FOUND.GT.0 ) THEN
            DO 25 I = 1, NE
               IF ( METHOD.NE.0 .AND. LATER .AND. IE(JL+I).EQ.1 .AND.
     $              IE(JK+I).GT.2 ) IE(JA+I) = 1
   25       CONTINUE
            CALL GSUSZ( RHS, CON, KIN, CMD, CLO, VIN, EVT, T, TN - T,
     $                  SIZ, FIRST, IP, RP, CST, V, WI, P, ISTAT, RSTAT,
     $                  IE, RE, RE(NE+1), INFO )
         END IF
      END IF
      IF ( FIRST.GT.0 .OR. FOUND.NE.0 ) RETURN
C
C     -- no event
   28 DO 30 I = 1, NE
         IE(JA+I) = IE(JL+I)
         RE(I) = RE(2*NE+I)
   30 CONTINUE
      CALL GSUSZ( RHS, CON, KIN, CMD, CLO, VIN, EVT, T, H, SIZ, 0, IP,
     $            RP, CST, V, WI, P, ISTAT, RSTAT, IE, RE, RE(2*NE+1),
     $            INFO )
      CALL GSUSC( NX, IE, RE )
      IE(4) = 0
      RETURN
C
  900 ISTAT(6) = INFO
      ISTAT(7) = 1
      END
      SUBROUTINE GSEVL( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, BE, NS,
     $                  SIDE, NX, X, W, XN, NU, NV, IP, RP, CST, V, WI,
     $                  IE, RE, FOUND, TH, FINE, FAST, INFO )
C
C     PURPOSE
C     The first zero of an event function on the polynomial of GSEVN, up
C     to the fraction BE of its step, in NS points.
C
C     ARGUMENTS
C     As GSEVN, and
C     FOUND   (output) INTEGER, the number of the function, 0: none.
C     TH      (output) DOUBLE PRECISION, the fraction where it is 0.
C     FINE    (output) LOGICAL, true if a function has a lowest value
C             that these points do not resolve.
C     FAST    (output) LOGICAL, true if one is too fast for them.
C
C     METHOD
C     Where a function of the user has just had its event the sign of
C     what it is within rounding errors of that time tells nothing.
C     Behind a zero four points more are looked at, where the user has
C     events: do they resolve it?
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            METHOD, NS, SIDE, NX, NU, NV, IP(*), IE(*),
     $                   FOUND, INFO
      DOUBLE PRECISION   GAUSS(3), T, H, BE, X(NX), W(NX,*), XN(NX),
     $                   RP(*), CST(*), V(*), WI(*), RE(*), TH
      LOGICAL            FINE, FAST
      INTEGER            NE, JA, JL, KG, I, J, S, J0, LAST
      DOUBLE PRECISION   A, B, C, GA, GB, GC, OLD, SLOPE, NEAR, GSEVP,
     $                   GSEPS, CURVE
      LOGICAL            SOON, ROSE, THIS, OWN, GSUSU
      EXTERNAL           GSEVP, GSEPS, GSEVB, GSEVF, GSEVI, GSUSU
C
      NEAR = 1.0D3*GSEPS()*MAX( ABS( T ), ABS( T + H ) )
      NE = IE(1)
      JA = 10 + 3*NE
      JL = 10 + 4*NE
      KG = 1 + NE
      DO 10 I = 1, NE
         IE(JL+I) = IE(JA+I)
         RE(3*NE+I) = RE(I)
         RE(4*NE+I) = -1.0D0
   10 CONTINUE
      J0 = 1
      OWN = .FALSE.
      DO 15 I = 1, NE
         IF ( IE(10+5*NE+I).EQ.1 ) J0 = -24
         IF ( IE(10+2*NE+I).GT.2 ) OWN = .TRUE.
   15 CONTINUE
      FOUND = 0
      FINE  = .FALSE.
      FAST  = .FALSE.
      TH = 2.0D0
      LAST = NS
      DO 40 J = J0, NS
         B = BE*GSEVP( J, NS )
         SOON = ABS( B*H ).LE.NEAR
         A = B
         C = 0.0D0
         IF ( J.GT.J0 ) A = B - BE*GSEVP( J - 1, NS )
         IF ( J.EQ.J0 + 1 ) C = B - A
         IF ( J.GT.J0 + 1 ) C = B - A - BE*GSEVP( J - 2, NS )
         S = 1
         IF ( J.EQ.NS ) S = SIDE
         CALL GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, B, S, NX,
     $               X, W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 20 I = 1, NE
            RE(2*NE+I) = RE(KG+I-1)
            GA = RE(4*NE+I)
            GC = RE(3*NE+I)
            GB = RE(2*NE+I)
            IF ( J.GT.J0 ) THEN
               OLD   = ( GC - GA )/C
               SLOPE = ( GB - GC )/A
               CURVE = ( SLOPE - OLD )/( A + C )
               THIS = .FALSE.
               IF ( J.GT.1 .AND. A*H.GT.NEAR .AND. IE(10+2*NE+I).GT.2 )
     $            CALL GSEVF( I, J, NX, IE, RE, GA, GC, GB, CURVE,
     $                        A*( A + C ), THIS )
               FAST = FAST .OR. THIS
C              -- has the parabola through all three its lowest point
C                 between them, or close to them?
               IF ( MIN( GA, GC, GB ).GT.0.0D0 .AND.
     $              OLD.LT.1.25D0*C*CURVE .AND.
     $              SLOPE.GT.-1.25D0*A*CURVE .AND. 0.5D0*( A + C )**2
     $              *CURVE.GT.MIN( GA, GB, GC ) ) FINE = .TRUE.
            END IF
            RE(4*NE+I) = GC
            RE(3*NE+I) = GB
   20    CONTINUE
         IF ( J.GE.LAST .AND. FOUND.GT.0 ) RETURN
         IF ( FOUND.GT.0 ) GO TO 40
         DO 30 I = 1, NE
            IF ( RE(2*NE+I).GT.0.0D0 ) THEN
               ROSE = GSUSU( I, RE(2*NE+I), NX, IE, RE )
               IF ( .NOT.( SOON .AND. IE(10+2*NE+I).GT.2 .AND.
     $              IE(10+5*NE+I).EQ.1 ) .AND. ( IE(10+5*NE+I).LT.2 .OR.
     $              ( J.EQ.NS .AND. BE.GE.1.0D0 ) ) .AND. ROSE )
     $            IE(JL+I) = 1
            ELSE IF ( IE(JL+I).EQ.1 .AND. ( IE(10+5*NE+I).LT.2 .OR.
     $              ( J.EQ.NS .AND. BE.GE.1.0D0 ) ) ) THEN
               C = B
               CALL GSEVI( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H,
     $                     B - A, C, I, NX, X, W, XN, NU, NV, IP, RP,
     $                     CST, V, WI, IE, RE, INFO )
               IF ( INFO.NE.0 ) RETURN
               IF ( C.LT.TH ) THEN
                  TH = C
                  FOUND = I
               END IF
            END IF
   30    CONTINUE
         IF ( FOUND.GT.0 .AND. .NOT.OWN ) RETURN
         IF ( FOUND.GT.0 ) LAST = MAX( J, 0 ) + 4
   40 CONTINUE
      END
      SUBROUTINE GSEVI( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, BEGIN,
     $                  C, I, NX, X, W, XN, NU, NV, IP, RP, CST, V, WI,
     $                  IE, RE, INFO )
C
C     PURPOSE
C     The zero of event function I on the polynomial of GSEVN, between
C     the fractions BEGIN and C of its step, by the method of Illinois.
C
C     ARGUMENTS
C     As GSEVN, and
C     C       (input/output) DOUBLE PRECISION, on entry the end, where
C             the function is RE(2*NE+I), on exit where it has fallen
C             to 0.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            METHOD, I, NX, NU, NV, IP(*), IE(*), INFO
      DOUBLE PRECISION   GAUSS(3), T, H, BEGIN, C, X(NX), W(NX,*),
     $                   XN(NX), RP(*), CST(*), V(*), WI(*), RE(*)
      INTEGER            NE, K, KEPT
      DOUBLE PRECISION   A, D, GA, GB, GC
      EXTERNAL           GSEVB
C
      NE = IE(1)
      A  = BEGIN
      GB = RE(2*NE+I)
      CALL GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, A, 1, NX, X,
     $            W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE, INFO )
      IF ( INFO.NE.0 ) RETURN
      GA = MAX( RE(NE+I), 0.0D0 )
      KEPT = 0
      DO 10 K = 1, 60
         IF ( C - A.LE.1.0D-12 .OR. GA - GB.LE.0.0D0 ) RETURN
         D = ( GA*C - GB*A )/( GA - GB )
         IF ( .NOT.( D.GT.A .AND. D.LT.C ) ) D = 0.5D0*( A + C )
         CALL GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, D, 1, NX,
     $               X, W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
         GC = RE(NE+I)
         IF ( GC.GT.0.0D0 ) THEN
            A  = D
            GA = GC
            IF ( KEPT.EQ.1 ) GB = 0.5D0*GB
            KEPT = 1
         ELSE
            C  = D
            GB = GC
            IF ( KEPT.EQ.-1 ) GA = 0.5D0*GA
            KEPT = -1
            IF ( .NOT.( GC.LT.0.0D0 ) ) A = C
         END IF
   10 CONTINUE
      END
      SUBROUTINE GSEVS( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $                  WAY, T, TN, SIDE, H, X, SIZ, IP, RP, CST, V,
     $                  ROPT, XN, W, WI, P, ISTAT, RSTAT, IE, RE, GAUSS,
     $                  I, START, ERR, INFO )
C
C     PURPOSE
C     The step of GSEVN once more, as long as it must be for event
C     function I to be 0 at its end, by the secant method between the
C     last end where it is above 0 and the first where it is not; an
C     event of the user not above 0.
C
C     ARGUMENTS
C     As GSEVN, and
C     START   (input) DOUBLE PRECISION, the fraction of the step where
C             its polynomial has the zero.
C     I       (input/output) INTEGER, on exit 0 where the function does
C             not fall to 0 on the step, though on its polynomial, nor a
C             port that has just slid or rebounded come to rest or back:
C             XN and TN are not changed then.
C     ERR     (output) DOUBLE PRECISION, that of GSDP8, else 0.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            METHOD, WAY, SIDE, SIZ(8), IP(*), ISTAT(*),
     $                   IE(*), I, INFO
      DOUBLE PRECISION   T, TN, H, X(*), RP(*), CST(*), V(*), ROPT(*),
     $                   XN(*), W(*), WI(*), P(*), RSTAT(*), RE(*),
     $                   GAUSS(3), START, ERR
      INTEGER            NU, NX, NV, NE, KD, KX, K, J, PAST
      DOUBLE PRECISION   D, GC, TH, OLD, GOLD, SLOPE, TE, EPS, GSEPS,
     $                   LEAST, LO, HI
      LOGICAL            THERE, GONE
      EXTERNAL           GSEPS, GSEVB, GSEVD
C
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      EPS = GSEPS()
      NE = IE(1)
      KD = 1 + 5*NE
      KX = KD + 2*NX
      ERR = 0.0D0
      TH = START
      D = MIN( 1.0D-3, 0.5D0*TH )
      CALL GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, TH - D, 1,
     $            NX, X, W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE,
     $            INFO )
      IF ( INFO.NE.0 ) GO TO 900
      SLOPE = 0.0D0
      IF ( D.GT.0.0D0 ) SLOPE = -RE(NE+I)/D
      OLD  = 0.0D0
      GOLD = 0.0D0
      LEAST = 2.0D0*EPS*MAX( ABS( T ), ABS( TN ) )
      IE(8) = IE(6)
      PAST = 0
      LO = 0.0D0
      HI = 2.0D0
      THERE = .FALSE.
      K = 0
    2 K = K + 1
         CALL GSEVD( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $               WAY, T, TN, SIDE, H, TH, X, SIZ, IP, RP, CST, V,
     $               ROPT, XN, W, WI, P, ISTAT, RSTAT, IE, RE, GAUSS,
     $               TE, ERR, INFO )
         IF ( INFO.NE.0 ) RETURN
         GC = RE(NE+I)
         IF ( PAST.GT.0 ) GO TO 20
         IF ( IE(6).EQ.1 .AND. IE(8).EQ.0 ) GO TO 20
         IF ( GC.GT.0.0D0 ) THEN
            LO = MAX( LO, TH )
         ELSE
            HI = MIN( HI, TH )
         END IF
         IF ( K.GT.1 .AND. ABS( TH - OLD ).GT.0.0D0 .AND.
     $        ABS( GC - GOLD ).GT.0.0D0 )
     $      SLOPE = ( GC - GOLD )/( TH - OLD )
         OLD  = TH
         GOLD = GC
         D = 1.0D0
         IF ( ABS( SLOPE ).GT.0.0D0 ) D = GC/SLOPE
         THERE = ABS( D*H ).LE.LEAST .OR. ( HI - LO )*H.LE.LEAST
         IF ( THERE ) GO TO 5
C
C        -- the secant; half way between the bounds where it leaves them
         IF ( HI.LE.1.0D0 ) THEN
            TH = TH - D
            IF ( .NOT.( TH.GT.LO .AND. TH.LT.HI ) .OR. MOD( K, 8 ).EQ.0
     $         ) TH = 0.5D0*( LO + HI )
            IF ( K.LT.80 .AND. ABS( TH - OLD ).GT.0.0D0 ) GO TO 2
            THERE = .TRUE.
         ELSE IF ( K.LT.12 .AND. ABS( D ).LE.0.1D0 ) THEN
            TH = MIN( 1.0D0, MAX( 0.0D0, TH - D ) )
            IF ( ABS( TH - OLD ).GT.0.0D0 ) GO TO 2
         END IF
    5    IF ( IE(6).EQ.1 ) THEN
            TH = OLD
            IE(8) = 0
            GO TO 2
         END IF
C
C     -- an event of the user has happened: a little later it must be
   20 CONTINUE
      IF ( IE(10+2*NE+I).GT.2 .AND. GC.GT.0.0D0 .AND. TH.LT.1.0D0 .AND.
     $     PAST.LT.8 ) THEN
         TH = MIN( 1.0D0, TH + 2.0D0**PAST*EPS*MAX( ABS( T ), ABS( TN )
     $        )/H )
         PAST = PAST + 1
         GO TO 2
      END IF
      GONE = ( ( IE(10+2*NE+I).EQ.1 ) .NEQV. ( IE(10+I).EQ.0 ) ) .AND.
     $       TE - T.LE.1.0D3*EPS*MAX( ABS( T ), ABS( TN ) )
      IF ( GC.GT.0.0D0 .AND. METHOD.NE.12 .AND. METHOD.NE.0 .AND.
     $     IE(10+5*NE+I).LT.2 .AND. ( IE(10+2*NE+I).GT.2 .OR. GONE .OR.
     $     .NOT.THERE ) ) THEN
         I = 0
         RETURN
      END IF
      TN = TE
      DO 30 J = 1, NX
         XN(J) = RE(KX+J-1)
   30 CONTINUE
      RETURN
C
  900 ISTAT(6) = INFO
      ISTAT(7) = 1
      END
      SUBROUTINE GSEVD( RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT, METHOD,
     $                  WAY, T, TN, SIDE, H, TH, X, SIZ, IP, RP, CST, V,
     $                  ROPT, XN, W, WI, P, ISTAT, RSTAT, IE, RE, GAUSS,
     $                  TE, ERR, INFO )
C
C     PURPOSE
C     The fraction TH of the step of GSEVN once more, to TE: its end and
C     the event functions there, RE(NE+1..2*NE).  The rates at X, the
C     first column of W, stay.
C
C     ARGUMENTS
C     As GSEVN and GSEVS.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN, EVT
      INTEGER            METHOD, WAY, SIDE, SIZ(8), IP(*), ISTAT(*),
     $                   IE(*), INFO
      DOUBLE PRECISION   T, TN, H, TH, X(*), RP(*), CST(*), V(*),
     $                   ROPT(*), XN(*), W(*), WI(*), P(*), RSTAT(*),
     $                   RE(*), GAUSS(3), TE, ERR
      INTEGER            NQ, NU, NX, NV, NLAM, NE, KD, KX, S
      DOUBLE PRECISION   C, HE
      EXTERNAL           GSEVX, GSEVV, GSDP8, GSRK4, GSUSG
C
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      NE = IE(1)
      KD = 1 + 5*NE
      KX = KD + 2*NX
      TE = T + TH*H
      S  = 1
      IF ( TH.GE.1.0D0 ) THEN
         TE = TN
         S  = SIDE
      END IF
      HE = TH*H
      IF ( METHOD.EQ.4 ) THEN
         CALL GSRK4( RHS, CON, KIN, CMD, CLO, VIN, T, TE, S, HE, X, NQ,
     $               NU, NX, NV, NLAM, IP, RP, CST, V, RE(KX), W(NX+1),
     $               WI, P, ISTAT, RSTAT, INFO )
      ELSE IF ( METHOD.EQ.12 .OR. METHOD.EQ.0 ) THEN
         CALL GSEVX( METHOD, GAUSS, T, H, TH, NX, X, W, XN, RE(KD),
     $               RE(KX) )
      ELSE
         CALL GSDP8( RHS, CON, KIN, CMD, CLO, VIN, T, TE, S, HE, X, NQ,
     $               NU, NX, NV, NLAM, IP, RP, CST, V, ROPT(2), ROPT(4),
     $               RE(KX), ERR, W, WI, P, ISTAT, RSTAT, INFO )
      END IF
      IF ( INFO.NE.0 ) RETURN
      IF ( METHOD.NE.12 .AND. METHOD.NE.0 .AND. WAY.NE.1 .AND.
     $     ( NQ.GT.NU .OR. ( NLAM.GT.0 .AND. WAY.NE.3 ) ) ) THEN
         CALL PRJ( TE, RE(KX), CST, C, INFO )
         ISTAT(4) = ISTAT(4) + 1
         IF ( INFO.EQ.2 ) INFO = 0
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 3
            RETURN
         END IF
      END IF
      CALL GSEVV( CMD, CLO, VIN, EVT, TE, S, RE(KX), NU, NX, NV, IP, RP,
     $            CST, V, WI, IE(11), RE(NE+1), INFO )
      IF ( INFO.NE.0 ) THEN
         ISTAT(6) = INFO
         ISTAT(7) = 1
         RETURN
      END IF
      CALL GSUSG( NX, IE, RE )
      END
      SUBROUTINE GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, B,
     $                  SIDE, NX, X, W, XN, NU, NV, IP, RP, CST, V, WI,
     $                  IE, RE, INFO )
C
C     PURPOSE
C     Event functions at the fraction B of the step of GSEVN, on its
C     polynomial: RE(NE+1..2*NE).
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            METHOD, SIDE, NX, NU, NV, IP(*), IE(*), INFO
      DOUBLE PRECISION   GAUSS(3), T, H, B, X(NX), W(NX,*), XN(NX),
     $                   RP(*), CST(*), V(*), WI(*), RE(*)
      INTEGER            NE, KD, KZ
      EXTERNAL           GSEVX, GSEVV, GSUSG
C
      NE = IE(1)
      KD = 1 + 5*NE
      KZ = KD + NX
      CALL GSEVX( METHOD, GAUSS, T, H, B, NX, X, W, XN, RE(KD), RE(KZ) )
      CALL GSEVV( CMD, CLO, VIN, EVT, T + B*H, SIDE, RE(KZ), NU, NX, NV,
     $            IP, RP, CST, V, WI, IE(11), RE(NE+1), INFO )
      CALL GSUSG( NX, IE, RE )
      END
      SUBROUTINE GSEVM( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, I, TH,
     $                  NX, X, W, XN, NU, NV, IP, RP, CST, V, WI, IE,
     $                  RE, TM, INFO )
C
C     PURPOSE
C     Where event function I is highest on the polynomial of GSEVN, on
C     the way to its zero at the fraction TH of the step: of seven
C     points the fraction TM of that way.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            METHOD, I, NX, NU, NV, IP(*), IE(*), INFO
      DOUBLE PRECISION   GAUSS(3), T, H, TH, X(NX), W(NX,*), XN(NX),
     $                   RP(*), CST(*), V(*), WI(*), RE(*), TM
      INTEGER            NE, K
      DOUBLE PRECISION   C, MOST
      EXTERNAL           GSEVB
C
      NE = IE(1)
      TM = 0.5D0
      MOST = 0.0D0
      DO 10 K = 1, 7
         C = 0.125D0*DBLE( K )
         CALL GSEVB( CMD, CLO, VIN, EVT, METHOD, GAUSS, T, H, C*TH, 1,
     $               NX, X, W, XN, NU, NV, IP, RP, CST, V, WI, IE, RE,
     $               INFO )
         IF ( INFO.NE.0 ) RETURN
         IF ( RE(NE+I).GT.MOST ) THEN
            MOST = RE(NE+I)
            TM = C
         END IF
   10 CONTINUE
      END
      DOUBLE PRECISION FUNCTION GSEVP( J, NS )
C
C     PURPOSE
C     The J-th of NS points of the step, as a fraction of it: their
C     distances grow evenly, threefold from the first to the last.  From
C     0 to -24 each is a quarter of the next; the one before is 0.
C
      IMPLICIT NONE
      INTEGER            J, NS
      DOUBLE PRECISION   B
      B = DBLE( MAX( 1, J ) )/DBLE( NS )
      GSEVP = 0.5D0*B*( 1.0D0 + B )
      IF ( J.LT.1 ) GSEVP = GSEVP*0.25D0**( 1 - J )
      IF ( J.LT.-24 ) GSEVP = 0.0D0
      END
      SUBROUTINE GSEVX( METHOD, GAUSS, T, H, B, NX, X, W, XN, XDN, Z )
C
C     PURPOSE
C     The state Z at the fraction B of the step of GSEVN; METHOD = 3, 5:
C     of a step of GSDP8 by GSEVH, and by GSEVC.
C
      IMPLICIT NONE
      INTEGER            METHOD, NX
      DOUBLE PRECISION   GAUSS(3), T, H, B, X(NX), W(NX,*), XN(NX),
     $                   XDN(NX), Z(NX)
      DOUBLE PRECISION   C(12), WT(12), Q(12)
      INTEGER            NS
      EXTERNAL           GSDPU, GSEVC, GSEVH, GSEVQ, GSGLN, GSGLQ, GSPTH
C
      IF ( METHOD.EQ.0 ) THEN
         CALL GSEVQ( NX, B, W, Z )
         RETURN
      END IF
      IF ( METHOD.EQ.8 .OR. METHOD.EQ.9 ) THEN
         CALL GSDPU( NX, H, B, X, W, XN, XDN, W(1,2), Z )
         RETURN
      END IF
      IF ( METHOD.NE.12 ) THEN
         CALL GSEVH( NX, H, B, X, W, XN, XDN, Z )
         IF ( METHOD.EQ.5 ) CALL GSEVC( NX, H, B, X, W, XN, XDN, Z )
         RETURN
      END IF
      NS = NINT( GAUSS(3) )
      CALL GSGLN( NS, C, WT )
      CALL GSGLQ( NS, C, WT, ( T - GAUSS(1) )/GAUSS(2),
     $            ( T + B*H - GAUSS(1) )/GAUSS(2), Q )
      CALL GSPTH( NX, NS, NX, X, GAUSS(2), Q, W, Z )
      END
      SUBROUTINE GSEVH( NX, H, B, X, XD, XN, XDN, Z )
C
C     PURPOSE
C     The cubic polynomial through the ends of a step, at the fraction B
C     of it; XN itself at its end.
C
      IMPLICIT NONE
      INTEGER            NX
      DOUBLE PRECISION   H, B, X(NX), XD(NX), XN(NX), XDN(NX), Z(NX)
      DOUBLE PRECISION   P, Q, R
      INTEGER            I
C
      P = B*B*( 3.0D0 - 2.0D0*B )
      Q = H*B*( 1.0D0 - B )*( 1.0D0 - B )
      R = H*B*B*( B - 1.0D0 )
      DO 10 I = 1, NX
         Z(I) = X(I) + P*( XN(I) - X(I) ) + Q*XD(I) + R*XDN(I)
   10 CONTINUE
      IF ( B.LT.1.0D0 ) RETURN
      DO 20 I = 1, NX
         Z(I) = XN(I)
   20 CONTINUE
      END
      SUBROUTINE GSEVQ( NX, B, W, Z )
C
C     PURPOSE
C     The polynomial of order 7 at the fraction B of a step, from the
C     states W at the fractions (1 - cos(i*pi/7))/2, i = 0, ..., 7; as
C     what it is away from the first one, without rounding errors there.
C
      IMPLICIT NONE
      INTEGER            NX
      DOUBLE PRECISION   B, W(NX,8), Z(NX)
      DOUBLE PRECISION   C(8), F
      INTEGER            I, J, K
C
CGCC$ NOVECTOR
      DO 10 J = 1, 8
         C(J) = 0.5D0*( 1.0D0 - COS( DBLE( J - 1 )*ACOS( -1.0D0 )
     $                               /7.0D0 ) )
   10 CONTINUE
      DO 20 I = 1, NX
         Z(I) = 0.0D0
   20 CONTINUE
      DO 50 J = 2, 8
         F = 1.0D0
         DO 30 K = 1, 8
            IF ( K.NE.J ) F = F*( B - C(K) )/( C(J) - C(K) )
   30    CONTINUE
         DO 40 I = 1, NX
            Z(I) = Z(I) + F*( W(I,J) - W(I,1) )
   40    CONTINUE
   50 CONTINUE
      DO 60 I = 1, NX
         Z(I) = W(I,1) + Z(I)
   60 CONTINUE
      END
      SUBROUTINE GSEVV( CMD, CLO, VIN, EVT, T, SIDE, X, NU, NX, NV, IP,
     $                  RP, CST, V, W, MODE, GV, INFO )
C
C     PURPOSE
C     Event functions under the inputs of a run (GSINP).
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT, GSINP
      INTEGER            SIDE, NU, NX, NV, IP(*), MODE(*), INFO
      DOUBLE PRECISION   T, X(NX), RP(*), CST(*), V(*), W(*), GV(*)
      DOUBLE PRECISION   GSLFT
      EXTERNAL           GSLFT
C
      INFO = 0
      IF ( IP(1).NE.0 .OR. IP(2).NE.0 ) CALL GSINP( CMD, CLO, VIN, T,
     $   SIDE, X, NU, NX, NV, IP, RP, CST, V, W, INFO )
      IF ( INFO.EQ.0 ) CALL EVT( GSLFT( T, SIDE ), X, V,
     $   MODE, CST, GV )
      END
