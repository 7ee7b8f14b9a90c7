C     The driver for programs in Fortran alone against closed forms: a
C     line `ok` or `not ok` for each.
      PROGRAM DRIVE
      IMPLICIT NONE
      EXTERNAL           ORDERS, SWITCH, CIRCLE, REFUSE, BADARG
      CALL ORDERS
      CALL SWITCH
      CALL CIRCLE
      CALL REFUSE
      CALL BADARG
      END
C
      SUBROUTINE TELL( GOOD, WHAT, FOUND )
      IMPLICIT NONE
      LOGICAL            GOOD
      CHARACTER*(*)      WHAT
      DOUBLE PRECISION   FOUND
      IF ( GOOD ) THEN
         PRINT '(3A,ES9.2)', 'ok ', WHAT, ': ', FOUND
      ELSE
         PRINT '(3A,ES9.2)', 'not ok ', WHAT, ': found ', FOUND
      END IF
      END
      SUBROUTINE SIZES( NQ, NU, NX, NV, SIZ )
      IMPLICIT NONE
      INTEGER            NQ, NU, NX, NV, SIZ(12), I
      DO 10 I = 1, 12
         SIZ(I) = 0
   10 CONTINUE
      SIZ(1) = NQ
      SIZ(2) = NU
      SIZ(3) = NX
      SIZ(4) = NV
      END
C
C     -- y' = y*cos(t), z' = -2*t*z**2: y = exp(sin(t)), z = 1/(1+t**2)
      SUBROUTINE CURVES( T, X, V, CST, XD, INFO )
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, X(2), V(1), CST(1), XD(2)
      INFO = 0
      XD(1) = X(1)*COS( T )
      XD(2) = -2.0D0*T*X(2)**2
      END
      DOUBLE PRECISION FUNCTION OFF( NT, TOUT, X )
      IMPLICIT NONE
      INTEGER            NT, K
      DOUBLE PRECISION   TOUT(NT), X(2,NT)
      OFF = 0.0D0
      DO 10 K = 1, NT
         OFF = MAX( OFF, ABS( X(1,K) - EXP( SIN( TOUT(K) ) ) ),
     $              ABS( X(2,K) - 1.0D0/( 1.0D0 + TOUT(K)**2 ) ) )
   10 CONTINUE
      END
      SUBROUTINE ORDERS
      IMPLICIT NONE
      EXTERNAL           CURVES, GSNON, GSRUN4, GSRUN8
      INTEGER            SIZ(12), ISTAT(6), INFO, J, K
      DOUBLE PRECISION   CST(1), TB(1), TOUT(41), X(2), T, XOUT(2,41),
     $                   W(40), E(3), ATOL(2), RTOL, OFF
      CALL SIZES( 0, 0, 2, 0, SIZ )
      DO 10 K = 1, 41
         TOUT(K) = 0.05D0*DBLE( K - 1 )
   10 CONTINUE
      DO 20 J = 1, 2
         X(1) = 1.0D0
         X(2) = 1.0D0
         CALL GSRUN4( CURVES, GSNON, GSNON, SIZ, CST, 0, TB, 41, TOUT,
     $                X, 0.05D0/DBLE( J ), T, XOUT, W, ISTAT, INFO )
         E(J) = OFF( 41, TOUT, XOUT )
         CALL TELL( INFO.EQ.0 .AND. ISTAT(1).EQ.40*J .AND. ISTAT(6)
     $              .EQ.41, 'rk4 comes to the end', DBLE( ISTAT(1) ) )
   20 CONTINUE
      RTOL = LOG( E(1)/E(2) )/LOG( 2.0D0 )
      CALL TELL( ABS( RTOL - 4.0D0 ).LT.0.1D0, 'rk4 has the order 4',
     $           RTOL )
      DO 30 J = 1, 3
         RTOL = 1.0D-3*1.0D-3**J
         ATOL(1) = RTOL
         ATOL(2) = RTOL
         X(1) = 1.0D0
         X(2) = 1.0D0
         CALL GSRUN8( CURVES, GSNON, GSNON, SIZ, CST, 0, TB, 41, TOUT,
     $                X, RTOL, ATOL, 0, T, XOUT, W, ISTAT, INFO )
         E(J) = OFF( 41, TOUT, XOUT )
         CALL TELL( INFO.EQ.0 .AND. E(J).LE.10.0D0*RTOL .AND.
     $              ISTAT(1).LT.40,
     $              'dp853 keeps its tolerance between steps, too',
     $              E(J) )
   30 CONTINUE
      CALL TELL( E(3).LT.1.0D-4*E(1), 'a smaller tolerance, a smaller'
     $           //' error', E(3) )
      END
C
C     -- x'' = v - x; v jumps from 0 to 1 at t = 1: x = 1 - cos(t-1)
      SUBROUTINE SPRING( T, X, V, CST, XD, INFO )
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, X(2), V(1), CST(1), XD(2)
      INFO = 0
      XD(1) = X(2)
      XD(2) = V(1) - X(1)
      END
      SUBROUTINE JUMP( T, X, V )
      IMPLICIT NONE
      DOUBLE PRECISION   T, X(2), V(1)
      V(1) = 0.0D0
      IF ( T.GE.1.0D0 ) V(1) = 1.0D0
      END
      SUBROUTINE SWITCH
      IMPLICIT NONE
      EXTERNAL           SPRING, JUMP, GSNON, GSRUN4, GSRUN8
      INTEGER            SIZ(12), ISTAT(6), INFO, J, NB
      DOUBLE PRECISION   CST(1), TB(2), TOUT(2), X(2), T, XOUT(4),
     $                   W(40), ATOL(2), E(2)
      CALL SIZES( 1, 1, 2, 1, SIZ )
      SIZ(9) = 1
      TB(1) = 5.0D0
      TB(2) = 1.0D0
      TOUT(1) = 0.0D0
      TOUT(2) = 2.5D0
      ATOL(1) = 1.0D-12
      ATOL(2) = 1.0D-12
      X(1) = 0.0D0
      X(2) = 0.0D0
      CALL GSRUN8( SPRING, GSNON, JUMP, SIZ, CST, 2, TB, 2, TOUT, X,
     $             1.0D-12, ATOL, 0, T, XOUT, W, ISTAT, INFO )
      E(1) = ABS( X(1) - 1.0D0 + COS( 1.5D0 ) )
      CALL TELL( INFO.EQ.0 .AND. E(1).LT.1.0D-11 .AND. ISTAT(2).EQ.0,
     $           'dp853: an input jumps at one of the times TB', E(1) )
      DO 10 J = 1, 2
         NB = 2
         X(1) = 0.0D0
         X(2) = 0.0D0
         CALL GSRUN4( SPRING, GSNON, JUMP, SIZ, CST, NB, TB, 2, TOUT,
     $                X, 0.3D0/DBLE( J ), T, XOUT, W, ISTAT, INFO )
         E(J) = ABS( X(1) - 1.0D0 + COS( 1.5D0 ) )
   10 CONTINUE
      E(2) = LOG( E(1)/E(2) )/LOG( 2.0D0 )
      CALL TELL( ABS( E(2) - 4.0D0 ).LT.0.2D0,
     $           'rk4: the order 4, an input jumps', E(2) )
      NB = 0
      CALL GSRUN4( SPRING, GSNON, JUMP, SIZ, CST, NB, TB, 2, TOUT, X,
     $             0.3D0, T, XOUT, W, ISTAT, INFO )
      CALL TELL( INFO.EQ.4, 'a time at which the scene switches is'
     $           //' missing: INFO', DBLE( INFO ) )
      END
C
C     -- a mass on the circle x**2 + y**2 = 1: x = cos(t), y = sin(t)
      SUBROUTINE ROUND( T, X, V, CST, XD, INFO )
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, X(4), V(1), CST(2), XD(4), C
      INFO = 0
      IF ( T.GT.CST(1) ) INFO = INT( CST(2) )
      C = X(3)**2 + X(4)**2
      XD(1) = X(3)
      XD(2) = X(4)
      XD(3) = -C*X(1)
      XD(4) = -C*X(2)
      END
      SUBROUTINE ONTO( T, X, CST, RES, INFO )
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, X(4), CST(1), RES, R, S
      INFO = 0
      R = SQRT( X(1)**2 + X(2)**2 )
      RES = ABS( R - 1.0D0 )
      X(1) = X(1)/R
      X(2) = X(2)/R
      S = X(1)*X(3) + X(2)*X(4)
      X(3) = X(3) - S*X(1)
      X(4) = X(4) - S*X(2)
      END
      SUBROUTINE TURN( METHOD, CST, X, MOST, E, GAP, ISTAT, INFO )
      IMPLICIT NONE
      EXTERNAL           ROUND, ONTO, GSNON, GSRUN4, GSRUN8
      INTEGER            METHOD, SIZ(12), ISTAT(6), INFO, MOST, K
      DOUBLE PRECISION   CST(2), TB(1), TOUT(21), X(4), E, GAP, T,
     $                   XOUT(4,21), W(64), ATOL(4)
      CALL SIZES( 2, 2, 4, 0, SIZ )
      SIZ(8) = 1
      DO 10 K = 1, 21
         TOUT(K) = 0.5D0*DBLE( K - 1 )
   10 CONTINUE
      DO 20 K = 1, 4
         ATOL(K) = 1.0D-10
   20 CONTINUE
      IF ( METHOD.EQ.4 ) CALL GSRUN4( ROUND, ONTO, GSNON, SIZ, CST, 0,
     $   TB, 21, TOUT, X, 0.05D0, T, XOUT, W, ISTAT, INFO )
      IF ( METHOD.EQ.8 ) CALL GSRUN8( ROUND, ONTO, GSNON, SIZ, CST, 0,
     $   TB, 21, TOUT, X, 1.0D-10, ATOL, MOST, T, XOUT, W, ISTAT, INFO )
      E = 0.0D0
      GAP = 0.0D0
      DO 30 K = 1, ISTAT(6)
         E = MAX( E, ABS( XOUT(1,K) - COS( TOUT(K) ) ),
     $            ABS( XOUT(2,K) - SIN( TOUT(K) ) ) )
         GAP = MAX( GAP, ABS( XOUT(1,K)**2 + XOUT(2,K)**2 - 1.0D0 ),
     $              ABS( XOUT(1,K)*XOUT(3,K) + XOUT(2,K)*XOUT(4,K) ) )
   30 CONTINUE
      END
      SUBROUTINE BEGIN( X )
      IMPLICIT NONE
      DOUBLE PRECISION   X(4)
      X(1) = 1.0D0
      X(2) = 0.0D0
      X(3) = 0.0D0
      X(4) = 1.0D0
      END
      SUBROUTINE CIRCLE
      IMPLICIT NONE
      INTEGER            ISTAT(6), INFO, K
      DOUBLE PRECISION   CST(2), X(4), E, GAP
      CST(1) = 1.0D9
      CST(2) = 0.0D0
      DO 10 K = 4, 8, 4
         CALL BEGIN( X )
         CALL TURN( K, CST, X, 0, E, GAP, ISTAT, INFO )
         CALL TELL( INFO.EQ.0 .AND. E.LT.10.0D0**(-K), 'a circle',
     $              E )
         CALL TELL( INFO.EQ.0 .AND. GAP.LT.1.0D-14,
     $              'and all outputs are on it', GAP )
   10 CONTINUE
C     -- constraints that depend on each other all along are no reason
      CST(1) = -1.0D0
      CST(2) = 2.0D0
      CALL BEGIN( X )
      CALL TURN( 8, CST, X, 0, E, GAP, ISTAT, INFO )
      CALL TELL( INFO.EQ.0 .AND. ISTAT(5).EQ.1 .AND. E.LT.1.0D-8,
     $           'constraints that depend on each other', E )
      END
C
C     -- what the driver refuses or cannot do
      SUBROUTINE REFUSE
      IMPLICIT NONE
      EXTERNAL           CURVES, GSNON, GSRUN4, GSRUN8
      INTEGER            SIZ(12), ISTAT(6), INFO, K
      DOUBLE PRECISION   CST(2), TB(1), TOUT(2), X(4), T, XOUT(4),
     $                   W(64), ATOL(2), E, GAP
      DO 10 K = 1, 3
         CALL SIZES( 0, 0, 2, 0, SIZ )
         SIZ(9+K) = 1
         CALL GSRUN4( CURVES, GSNON, GSNON, SIZ, CST, 0, TB, 2, TOUT,
     $                X, 0.1D0, T, XOUT, W, ISTAT, INFO )
         CALL TELL( INFO.EQ.K, 'rk4 refuses events, samples: INFO',
     $              DBLE( INFO ) )
         CALL GSRUN8( CURVES, GSNON, GSNON, SIZ, CST, 0, TB, 2, TOUT,
     $                X, 0.1D0, ATOL, 0, T, XOUT, W, ISTAT, INFO )
         CALL TELL( INFO.EQ.K, 'dp853 refuses events, samples: INFO',
     $              DBLE( INFO ) )
   10 CONTINUE
      CST(1) = 3.0D0
      CST(2) = 2.0D0
      DO 20 K = 4, 8, 4
         CALL BEGIN( X )
         CALL TURN( K, CST, X, 0, E, GAP, ISTAT, INFO )
         CALL TELL( INFO.EQ.10 .AND. ISTAT(6).EQ.8 - K/4,
     $              'constraints lose rank behind 3 s: INFO',
     $              DBLE( INFO ) )
         CST(2) = 1.0D0
         CALL BEGIN( X )
         CALL TURN( K, CST, X, 0, E, GAP, ISTAT, INFO )
         CALL TELL( INFO.EQ.7 .AND. ISTAT(4).EQ.1, 'RHS fails: INFO',
     $              DBLE( INFO ) )
         CST(2) = 2.0D0
         CALL BEGIN( X )
         X(1) = 1.001D0
         CALL TURN( K, CST, X, 0, E, GAP, ISTAT, INFO )
         CALL TELL( INFO.EQ.11 .AND. ABS( X(1) - 1.001D0 ).LT.1.0D-12,
     $              'a start beside the constraints: INFO',
     $              DBLE( INFO ) )
   20 CONTINUE
      CST(1) = 1.0D9
      CALL BEGIN( X )
      CALL TURN( 8, CST, X, 3, E, GAP, ISTAT, INFO )
      CALL TELL( INFO.EQ.5 .AND. ISTAT(1) + ISTAT(2).EQ.3,
     $           'no more than 3 steps: INFO', DBLE( INFO ) )
C     -- y' = y*cos(t), z' = -2*t*z**2 from z(0) = -1: z = 1/(t**2-1)
      CALL SIZES( 0, 0, 2, 0, SIZ )
      TOUT(1) = 0.0D0
      TOUT(2) = 2.0D0
      X(1) = 1.0D0
      X(2) = -1.0D0
      ATOL(1) = 0.0D0
      ATOL(2) = 0.0D0
      CALL GSRUN8( CURVES, GSNON, GSNON, SIZ, CST, 0, TB, 2, TOUT, X,
     $             1.0D-8, ATOL, 0, T, XOUT, W, ISTAT, INFO )
      CALL TELL( ( INFO.EQ.6 .OR. INFO.EQ.9 ) .AND. ABS( T - 1.0D0 )
     $           .LT.1.0D-6, 'a state beyond all bounds at 1 s', T )
      END
C
C     -- arguments out of their ranges, and what stays as it was
      SUBROUTINE BADARG
      IMPLICIT NONE
      EXTERNAL           CURVES, GSNON, GSRUN4, GSRUN8
      INTEGER            SIZ(12), ISTAT(6), INFO, K, NB, NT, MOST
      DOUBLE PRECISION   CST(1), TB(1), TOUT(2), X(2), T, XOUT(4),
     $                   W(40), ATOL(2), RTOL, H
      DO 10 K = 4, 13
         CALL SIZES( 0, 0, 2, 0, SIZ )
         NB = 1
         NT = 2
         MOST = 0
         RTOL = 1.0D-6
         H = 0.1D0
         TB(1) = 1.0D0
         TOUT(1) = 0.0D0
         TOUT(2) = 1.0D0
         X(1) = 1.0D0
         X(2) = 1.0D0
         ATOL(1) = 1.0D-6
         ATOL(2) = 1.0D-6
         IF ( K.EQ.4 ) SIZ(3) = 0
         IF ( K.EQ.5 ) GO TO 10
         IF ( K.EQ.6 ) NB = -1
         IF ( K.EQ.7 ) TB(1) = 1.0D0/( TOUT(1)*TOUT(1) )
         IF ( K.EQ.8 ) NT = 0
         IF ( K.EQ.9 ) TOUT(2) = 0.0D0
         IF ( K.EQ.10 ) X(2) = 1.0D0/( TOUT(1)*TOUT(1) )
         IF ( K.EQ.11 ) RTOL = 1.0D0
         IF ( K.EQ.11 ) H = 0.0D0
         IF ( K.EQ.12 ) ATOL(2) = -1.0D0
         IF ( K.EQ.13 ) MOST = -1
         CALL GSRUN8( CURVES, GSNON, GSNON, SIZ, CST, NB, TB, NT, TOUT,
     $                X, RTOL, ATOL, MOST, T, XOUT, W, ISTAT, INFO )
         CALL TELL( INFO.EQ.-K, 'dp853: an argument out of its range',
     $              DBLE( INFO ) )
         IF ( K.GT.11 ) GO TO 10
         CALL GSRUN4( CURVES, GSNON, GSNON, SIZ, CST, NB, TB, NT, TOUT,
     $                X, H, T, XOUT, W, ISTAT, INFO )
         CALL TELL( INFO.EQ.-K, 'rk4: an argument out of its range',
     $              DBLE( INFO ) )
   10 CONTINUE
      END
