      SUBROUTINE GSEVA( CMD, CLO, VIN, EVT, T, H, SIDE, NX, X, W, XN,
     $                  NU, NV, IP, RP, CST, V, WI, IE, RE, QUIET,
     $                  INFO )
C
C     PURPOSE
C     Whether a step of GSDP8 is quiet: no event function comes close to
C     0 in it, beside what a polynomial through its stages may hide.
C
C     ARGUMENTS
C     As GSEVN, and
C     QUIET   (output) LOGICAL; if it is true IE and RE are as GSEVL
C             leaves them.
C
C     METHOD
C     Eight points of the polynomial of GSEVC.  What it is away from the
C     cubic one of GSEVH, in two of them, is twice and more what it may
C     be off; to this comes what functions may fall by between points,
C     from their second differences, which must not change faster than
C     these points resolve (GSEVF).  A function of the user that has
C     just had its event or whose last events say that there are more
C     (GSUSN), or one of a port that is not above 0, is not quiet; one
C     that is not above 0 may be 0 all the time.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT
      INTEGER            SIDE, NX, NU, NV, IP(*), IE(*), INFO
      DOUBLE PRECISION   T, H, X(NX), W(NX,*), XN(NX), RP(*), CST(*),
     $                   V(*), WI(*), RE(*)
      LOGICAL            QUIET
      INTEGER            NE, JK, JA, JL, I, J, S, GSUSN
      DOUBLE PRECISION   GAUSS(3), A, B, C, D, OLD, SLOPE, LEAST, CURVE,
     $                   GA, GB, GC, GSEVP, GSEVZ
      LOGICAL            FAST
      EXTERNAL           GSEVP, GSEVZ, GSEVB, GSEVF, GSUSN
C
      NE = IE(1)
      JK = 10 + 2*NE
      JA = 10 + 3*NE
      JL = 10 + 4*NE
      QUIET = .FALSE.
      INFO = 0
      GAUSS(1) = 0.0D0
      DO 10 I = 1, NE
         IE(JL+I) = IE(JA+I)
         IF ( IE(10+5*NE+I).NE.0 ) RETURN
         IF ( IE(JA+I).EQ.0 .AND. IE(JK+I).LE.2 ) RETURN
         RE(4*NE+I) = 0.0D0
   10 CONTINUE
      IF ( GSUSN( T, H, NX, IE, RE ).GT.8 ) RETURN
C
C     -- how far both polynomials are apart: RE(4*NE+I)
      DO 40 J = 4, 6, 2
         B = GSEVP( J, 8 )
         CALL GSEVB( CMD, CLO, VIN, EVT, 3, GAUSS, T, H, B, 1, NX, X, W,
     $               XN, NU, NV, IP, RP, CST, V, WI, IE, RE, INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 20 I = 1, NE
            RE(2*NE+I) = RE(NE+I)
   20    CONTINUE
         CALL GSEVB( CMD, CLO, VIN, EVT, 5, GAUSS, T, H, B, 1, NX, X, W,
     $               XN, NU, NV, IP, RP, CST, V, WI, IE, RE, INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 30 I = 1, NE
            RE(4*NE+I) = MAX( RE(4*NE+I), ABS( RE(NE+I) - RE(2*NE+I) )
     $                   /GSEVZ( B ) )
   30    CONTINUE
   40 CONTINUE
C
C     -- the points: RE(2*NE+I) the last one, RE(3*NE+I) that before it
      DO 50 I = 1, NE
         RE(2*NE+I) = RE(I)
         RE(3*NE+I) = RE(I)
   50 CONTINUE
      C = 1.0D0
      DO 70 J = 1, 8
         B = GSEVP( J, 8 )
         A = B
         IF ( J.GT.1 ) A = B - GSEVP( J - 1, 8 )
         S = 1
         IF ( J.EQ.8 ) S = SIDE
         CALL GSEVB( CMD, CLO, VIN, EVT, 5, GAUSS, T, H, B, S, NX, X, W,
     $               XN, NU, NV, IP, RP, CST, V, WI, IE, RE, INFO )
         IF ( INFO.NE.0 ) RETURN
         D = GSEVZ( B )
         IF ( J.GT.1 ) D = MAX( D, GSEVZ( B - A ) )
         IF ( J.GT.2 ) D = MAX( D, GSEVZ( B - A - C ) )
         DO 60 I = 1, NE
            GA = RE(3*NE+I)
            GC = RE(2*NE+I)
            GB = RE(NE+I)
            IF ( IE(JA+I).EQ.0 ) THEN
               GA = -GA
               GC = -GC
               GB = -GB
            END IF
            LEAST = GB
            IF ( J.GT.1 ) THEN
               OLD   = ( GC - GA )/C
               SLOPE = ( GB - GC )/A
               CURVE = ( SLOPE - OLD )/( A + C )
               FAST = .FALSE.
               IF ( IE(JK+I).GT.2 ) CALL GSEVF( I, J, NX, IE, RE, GA,
     $            GC, GB, CURVE, A*( A + C ), FAST )
               IF ( FAST ) RETURN
C              -- where it rises from its beginning that does not count
               IF ( J.GT.2 .OR. .NOT.( OLD.GT.2.0D0*C*ABS( CURVE ) ) )
     $            LEAST = MIN( LEAST, GA )
               LEAST = MIN( LEAST, GC )
               CURVE = 0.125D0*( A + C )**2*ABS( CURVE )
               IF ( OLD.LT.0.0D0 .AND. SLOPE.GT.0.0D0 )
     $            CURVE = 4.0D0*CURVE
               LEAST = LEAST - CURVE
            END IF
            GA = 2.0D0*D*RE(4*NE+I)
            IF ( .NOT.( LEAST.GT.GA .OR. ( LEAST.GE.GA .AND.
     $           IE(JA+I).EQ.0 ) ) ) RETURN
            RE(3*NE+I) = RE(2*NE+I)
            RE(2*NE+I) = RE(NE+I)
   60    CONTINUE
         C = A
   70 CONTINUE
      QUIET = .TRUE.
      END
      SUBROUTINE GSEVF( I, J, NX, IE, RE, GA, GC, GB, CURVE, W, FAST )
C
C     PURPOSE
C     Is an event function of the user too fast for the points that are
C     looked at, so that it may pass 0 between them?
C
C     ARGUMENTS
C     I       (input) INTEGER, its number.
C     J       (input) INTEGER, the number of the last point: from 3 on
C             the one before was told.
C     NX      (input) INTEGER, the number of states.
C     IE, RE  (input/output) as GSRES; CURVE is kept in RE (GSUSI).
C     GA, GC, GB (input) DOUBLE PRECISION, what it is at the last three.
C     CURVE   (input) DOUBLE PRECISION, their second divided difference.
C     W       (input) DOUBLE PRECISION, the distance of the last point
C             from the one before, times that from the first of them.
C     FAST    (output) LOGICAL, true if it is.
C
C     METHOD
C     It does not go on ever faster, as a power does from 0, and the
C     parabola through the three points before misses the last one by
C     more than half of what they are apart, and of what the function is.
C
      IMPLICIT NONE
      INTEGER            I, J, NX, IE(*)
      DOUBLE PRECISION   RE(*), GA, GC, GB, CURVE, W
      LOGICAL            FAST
      DOUBLE PRECISION   OFF
      INTEGER            K, GSUSI
      EXTERNAL           GSUSI
C
      K = GSUSI( I, NX, IE )
      OFF = ABS( CURVE - RE(K+7) )*W
      FAST = J.GT.2 .AND. SIGN( 1.0D0, GC - GA )*CURVE.LT.0.0D0 .AND.
     $       2.0D0*OFF.GT.MAX( GA, GC, GB ) - MIN( GA, GC, GB ) .AND.
     $       OFF.GT.MAX( RE(K+6), RE(K+8) ) .AND.
     $       MIN( ABS( GA ), ABS( GC ), ABS( GB ) ).LT.2.0D0*OFF
      RE(K+7) = CURVE
      END
      DOUBLE PRECISION FUNCTION GSEVZ( B )
C
C     PURPOSE
C     The error of a cubic polynomial through both ends of a step, at
C     the fraction B of it, beside that in its middle.
C
      IMPLICIT NONE
      DOUBLE PRECISION   B
      GSEVZ = 16.0D0*( B*( 1.0D0 - B ) )**2
      END
      SUBROUTINE GSEVY( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE, H, X,
     $                  SIZ, IP, RP, CST, V, ROPT, XN, W, WI, P, ISTAT,
     $                  RSTAT, IE, RE, AGAIN, OFF, INFO )
C
C     PURPOSE
C     The polynomial of order 7 of a step of GSDP8 into the columns 2 to
C     5 of W.
C
C     ARGUMENTS
C     As GSEVN, and
C     AGAIN   (input) LOGICAL, true if the step was made again to another
C             end in the meantime: it is made as it was first.
C     OFF     (output) DOUBLE PRECISION, as that of GSDPQ.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, SIZ(8), IP(*), ISTAT(*), IE(*), INFO
      DOUBLE PRECISION   T, TN, H, X(*), RP(*), CST(*), V(*), ROPT(*),
     $                   XN(*), W(*), WI(*), P(*), RSTAT(*), RE(*), OFF
      LOGICAL            AGAIN
      INTEGER            NX, KD, KZ, KX, I
      EXTERNAL           GSDP8, GSDPE, GSDPN, GSDPU
C
      INFO = 0
      NX = SIZ(3)
      KD = 1 + 5*IE(1)
      KZ = KD + NX
      KX = KZ + NX
      IF ( AGAIN ) CALL GSDP8( RHS, CON, KIN, CMD, CLO, VIN, T, TN,
     $   SIDE, H, X, SIZ(1), SIZ(2), NX, SIZ(4), SIZ(5), IP, RP, CST, V,
     $   ROPT(2), ROPT(4), RE(KX), OFF, W, WI, P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 10 I = 1, NX
         W(NX+I) = RE(KD+I-1)
   10 CONTINUE
      CALL GSDPE( RHS, CON, KIN, CMD, CLO, VIN, T, H, X, SIZ(1), SIZ(2),
     $            NX, SIZ(4), SIZ(5), IP, RP, CST, V, W, 2, WI, P,
     $            RE(KX), ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSDPU( NX, H, 7.0D0/9.0D0, X, W, XN, RE(KD), W(NX+1),
     $            RE(KZ) )
      CALL GSDPN( SIZ(1), SIZ(2), NX, X, XN, P, ROPT(2), ROPT(4),
     $            RE(KX), RE(KZ), OFF )
      END
      SUBROUTINE GSEVC( NX, H, B, X, W, XN, XDN, Z )
C
C     PURPOSE
C     From the state Z of GSEVH at the fraction B of a step of GSDP8
C     that of a polynomial of order 5: it has the rates of the stages 7
C     and 10 as well, at the fractions 1/4 and 3/5.
C
C     METHOD
C     Z += H*b**2*(1 - b)**2*(p + q*b).
C
      IMPLICIT NONE
      INTEGER            NX
      DOUBLE PRECISION   H, B, X(NX), W(NX,*), XN(NX), XDN(NX), Z(NX)
      DOUBLE PRECISION   F, S, P, Q
      INTEGER            I
C
      F = H*( B*( 1.0D0 - B ) )**2
      DO 10 I = 1, NX
         S = ( XN(I) - X(I) )/H
         P = ( W(I,10) - 1.44D0*S + 0.32D0*W(I,1) + 0.12D0*XDN(I) )
     $       /( -0.096D0 )
         Q = ( W(I,7) - 1.125D0*S - 0.1875D0*W(I,1) + 0.3125D0*XDN(I)
     $       - 0.1875D0*P )/8.203125D-2
         Z(I) = Z(I) + F*( P + Q*B )
   10 CONTINUE
      END
