# The routines of share/fortran that emitted wrappers call, by themselves: projection, motions of
# closed chains, Jacobians through loops, impacts, against closed forms; in double and in quad
# precision.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/alone.f" <<'F'
      PROGRAM ALONE
      CALL CIRCLE
      CALL LINE
      CALL APART
      CALL NORMS
      CALL CRANK
      CALL JACOBI
      CALL SYSTMS
      CALL IMPACT
      END
      SUBROUTINE TELL( WHAT, ERR )
      CHARACTER*(*) WHAT
      DOUBLE PRECISION ERR
      WRITE (*,'(ES11.3E4,1X,A)') ERR, WHAT
      END
C
C     a particle onto a circle of radius 2: along the ray, the speed
C     loses its part along it
      SUBROUTINE CIRCLE
      EXTERNAL ONCIRC, MASS2, NOKIN
      DOUBLE PRECISION X(4), W(100), CST(1), RES, E, C, S
      INTEGER ISET(4), INFO
      DATA ISET / 4*0 /
      CST(1) = 1.0D0
      C = 0.6D0
      S = 0.8D0
      X(1) = 2.3D0*C
      X(2) = 2.3D0*S
      X(3) = 0.5D0*C - 0.7D0*S
      X(4) = 0.5D0*S + 0.7D0*C
      CALL GSPRJ( ONCIRC, MASS2, NOKIN, 0.0D0, X, 2, 2, 1, 0, 0, ISET,
     $            CST, RES, W, INFO )
      E = MAX( ABS( X(1) - 2*C ), ABS( X(2) - 2*S ), ABS( X(3)
     $  + 0.7D0*S ), ABS( X(4) - 0.7D0*C ), ABS( RES - 0.645D0 ) )
      CALL TELL( 'GSPRJ: a circle, nearest point', E + ABS( INFO ) )
      END
      SUBROUTINE ONCIRC( T, Q, U, CST, PHI, PHIT, HC, LDH, GAM, INFO )
      INTEGER LDH, INFO
      DOUBLE PRECISION T, Q(2), U(2), CST(1), PHI(1), PHIT(1),
     $                 HC(LDH,2), GAM(1)
      PHI(1) = 0.5D0*( Q(1)**2 + Q(2)**2 ) - 2.0D0
      PHIT(1) = 0.0D0
      HC(1,1) = Q(1)
      HC(1,2) = Q(2)
      GAM(1) = -U(1)**2 - U(2)**2
      INFO = 0
      END
      SUBROUTINE MASS2( T, Q, CST, M, LDM )
      INTEGER LDM
      DOUBLE PRECISION T, Q(2), CST(1), M(LDM,2)
      M(1,1) = 3.0D0
      M(1,2) = 0.0D0
      M(2,1) = 0.0D0
      M(2,2) = 3.0D0*CST(1)
      END
      SUBROUTINE NOKIN( T, Q, U, CST, QDOT )
      DOUBLE PRECISION T, Q(*), U(*), CST(*), QDOT(*)
      END
C
C     onto a line that moves, q1 + 2*q2 = 1 + 3*t: by inv(M)*H'
      SUBROUTINE LINE
      EXTERNAL ONLINE, MASS2, NOKIN
      DOUBLE PRECISION X(4), W(100), CST(1), RES, E, D, V
      INTEGER ISET(4), INFO
      DATA ISET / 4*0 /
      CST(1) = 4.0D0
      X(1) = 0.3D0
      X(2) = -0.1D0
      X(3) = 1.5D0
      X(4) = 0.25D0
C     M = diag(3,12), H = (1,2): inv(M)*H' = (1/3,1/6), H*that = 2/3
      D = ( 1.0D0 + 3*0.1D0 - ( X(1) + 2*X(2) ) )/( 2.0D0/3 )
      V = ( 3.0D0 - ( X(3) + 2*X(4) ) )/( 2.0D0/3 )
      E = 0.0D0
      CALL GSPRJ( ONLINE, MASS2, NOKIN, 0.1D0, X, 2, 2, 1, 0, 0, ISET,
     $            CST, RES, W, INFO )
      E = MAX( E, ABS( X(1) - 0.3D0 - D/3 ), ABS( X(2) + 0.1D0 - D/6 ),
     $         ABS( X(3) - 1.5D0 - V/3 ), ABS( X(4) - 0.25D0 - V/6 ) )
      CALL TELL( 'GSPRJ: a moving line, metric of the mass matrix',
     $           E + ABS( INFO ) )
      END
      SUBROUTINE ONLINE( T, Q, U, CST, PHI, PHIT, HC, LDH, GAM, INFO )
      INTEGER LDH, INFO
      DOUBLE PRECISION T, Q(2), U(2), CST(1), PHI(1), PHIT(1),
     $                 HC(LDH,2), GAM(1)
      PHI(1) = Q(1) + 2*Q(2) - 1.0D0 - 3*T
      PHIT(1) = -3.0D0
      HC(1,1) = 1.0D0
      HC(1,2) = 2.0D0
      GAM(1) = 0.0D0
      INFO = 0
      END
C
C     two rows that cannot hold together, q1 = 0 and q1 = a gap: beyond
C     1e-9 there is no such position (INFO = 3)
      SUBROUTINE APART
      EXTERNAL ONTWO, MASS2, NOKIN
      DOUBLE PRECISION X(4), W(200), CST(2), RES, E
      INTEGER ISET(4), INFO, K
      DATA ISET / 4*0 /
      E = 0.0D0
      DO 10 K = 0, 12
         CST(1) = 1.0D0
         CST(2) = 3.0D0*0.1D0**K
         X(1) = 0.2D0
         X(2) = 0.4D0
         X(3) = 0.0D0
         X(4) = 0.0D0
         CALL GSPRJ( ONTWO, MASS2, NOKIN, 0.0D0, X, 2, 2, 2, 0, 0, ISET,
     $               CST, RES, W, INFO )
         IF ( K.LE.9 .AND. INFO.NE.3 ) E = E + 1.0D0
         IF ( K.GE.10 .AND. INFO.NE.0 ) E = E + 1.0D0
   10 CONTINUE
      CALL TELL( 'GSPRJ: rows that cannot hold together are told', E )
      END
      SUBROUTINE ONTWO( T, Q, U, CST, PHI, PHIT, HC, LDH, GAM, INFO )
      INTEGER LDH, INFO
      DOUBLE PRECISION T, Q(2), U(2), CST(2), PHI(2), PHIT(2),
     $                 HC(LDH,2), GAM(2)
      INTEGER I
      DO 10 I = 1, 2
         PHI(I) = Q(1) - ( I - 1 )*CST(2)
         PHIT(I) = 0.0D0
         HC(I,1) = 1.0D0
         HC(I,2) = 0.0D0
         GAM(I) = 0.0D0
   10 CONTINUE
      INFO = 0
      END
C
      SUBROUTINE NORMS
      DOUBLE PRECISION Q(8), ERR, E
      INTEGER ISET(4,2), I
      DATA ISET / 8, 1, 2, 3, 4, 5, 6, 7 /
      DATA Q / 1.0D0, 2.0D0, 4.0D0, 1.0D0, 1.0D0, 1.0D0, 1.0D0, 2.0D0 /
      ERR = 0.0D0
      CALL GSNRM( 2, ISET, Q, ERR )
      E = MAX( ABS( Q(3) - 0.8D0 ), ABS( Q(8) - 0.4D0 ),
     $         ABS( Q(2) - 0.4D0 ), ABS( ERR - 4.0D0 ) )
      DO 10 I = 4, 7
         E = MAX( E, ABS( Q(I) - 0.5D0 ) )
   10 CONTINUE
      CALL TELL( 'GSNRM: two sets', E )
      Q(2) = 2.0D0
      Q(3) = 4.0D0
      Q(4) = 1.0D0
      Q(5) = -2.0D0
      ERR = 4.5D0
      CALL GSNRQ( Q(2), ERR )
      E = MAX( ABS( Q(2) - 0.4D0 ), ABS( Q(3) - 0.8D0 ),
     $         ABS( Q(4) - 0.2D0 ), ABS( Q(5) + 0.4D0 ),
     $         ABS( ERR - 4.5D0 ) )
      CALL TELL( 'GSNRQ: one set', E )
      END
C
C     a slider crank, q = (crank, rod, slider) from the crank: closed
C     forms of the motion and its three derivatives
      SUBROUTINE CRANK
      EXTERNAL CRCON, CRGAD
      DOUBLE PRECISION QJ(3,0:3), P(3,0:3), W(40), CST(2), RES, A, B, L,
     $                 R, E
      INTEGER ID(2), IA(1), IW(2), INFO, I, K
      DATA ID / 2, 3 /, IA / 1 /
      R = 0.3D0
      L = 0.9D0
      CST(1) = R
      CST(2) = L
      P(1,0) = 0.8D0
      P(1,1) = 1.7D0
      P(1,2) = 0.0D0
      P(1,3) = 0.0D0
      A = COS( P(1,0) )
      B = SIN( P(1,0) )
      P(2,0) = -ASIN( R*B/L )
      P(2,1) = -R*A*P(1,1)/( L*COS( P(2,0) ) )
      P(2,2) = ( R*B*P(1,1)**2/L + SIN( P(2,0) )*P(2,1)**2 )
     $         /COS( P(2,0) )
      P(2,3) = ( R*A*P(1,1)**3/L + 3*SIN( P(2,0) )*P(2,1)*P(2,2)
     $         + COS( P(2,0) )*P(2,1)**3 )/COS( P(2,0) )
      P(3,0) = R*A + L*COS( P(2,0) )
      P(3,1) = -R*B*P(1,1) - L*SIN( P(2,0) )*P(2,1)
      P(3,2) = -R*A*P(1,1)**2 - L*( COS( P(2,0) )*P(2,1)**2
     $       + SIN( P(2,0) )*P(2,2) )
      P(3,3) = R*B*P(1,1)**3 - L*( 3*COS( P(2,0) )*P(2,1)*P(2,2)
     $       - SIN( P(2,0) )*P(2,1)**3 + SIN( P(2,0) )*P(2,3) )
      DO 20 K = 0, 3
         DO 10 I = 1, 3
            QJ(I,K) = P(I,K)
            IF ( I.GT.1 ) QJ(I,K) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      QJ(3,0) = 1.0D0
      CALL GSCLO( CRCON, CRGAD, 0.0D0, QJ, 3, 2, 3, ID, IA, CST, RES, W,
     $            IW, INFO )
      E = ABS( INFO )
      DO 40 K = 0, 3
         DO 30 I = 1, 3
            E = MAX( E, ABS( QJ(I,K) - P(I,K) ) )
   30    CONTINUE
   40 CONTINUE
      CALL TELL( 'GSCLO: a slider crank, three derivatives', E )
      END
      SUBROUTINE CRCON( T, Q, U, CST, PHI, PHIT, HC, LDH, GAM, INFO )
      INTEGER LDH, INFO
      DOUBLE PRECISION T, Q(3), U(3), CST(2), PHI(2), PHIT(2),
     $                 HC(LDH,3), GAM(2)
      PHI(1) = CST(1)*SIN( Q(1) ) + CST(2)*SIN( Q(2) )
      PHI(2) = Q(3) - CST(1)*COS( Q(1) ) - CST(2)*COS( Q(2) )
      PHIT(1) = 0.0D0
      PHIT(2) = 0.0D0
      HC(1,1) = CST(1)*COS( Q(1) )
      HC(1,2) = CST(2)*COS( Q(2) )
      HC(1,3) = 0.0D0
      HC(2,1) = CST(1)*SIN( Q(1) )
      HC(2,2) = CST(2)*SIN( Q(2) )
      HC(2,3) = 1.0D0
      GAM(1) = CST(1)*SIN( Q(1) )*U(1)**2 + CST(2)*SIN( Q(2) )*U(2)**2
      GAM(2) = -CST(1)*COS( Q(1) )*U(1)**2 - CST(2)*COS( Q(2) )*U(2)**2
      INFO = 0
      END
      SUBROUTINE CRGAD( T, QJ, CST, G )
      DOUBLE PRECISION T, QJ(3,0:3), CST(2), G(2)
      INTEGER I
      G(1) = 0.0D0
      G(2) = 0.0D0
      DO 10 I = 1, 2
         G(1) = G(1) + CST(I)*( 3*SIN( QJ(I,0) )*QJ(I,1)*QJ(I,2)
     $        + COS( QJ(I,0) )*QJ(I,1)**3 )
         G(2) = G(2) - CST(I)*( 3*COS( QJ(I,0) )*QJ(I,1)*QJ(I,2)
     $        - SIN( QJ(I,0) )*QJ(I,1)**3 )
   10 CONTINUE
      END
C
C     derivatives whose solution is known, and the rows made of them
      SUBROUTINE JACOBI
      DOUBLE PRECISION LM(2,2), LB(2,2), LC(2,2), K(3,3), Z(3,5),
     $                 S(3,5), A(4,5), B(1,3), R(1,5), E
      INTEGER IW(3), INFO, I, J, L
      LM(1,1) = 2.0D0
      LM(1,2) = 0.5D0
      LM(2,1) = 0.5D0
      LM(2,2) = 3.0D0
      DO 20 J = 1, 2
         DO 10 I = 1, 2
            LB(I,J) = 0.1D0*I - 0.3D0*J
            LC(I,J) = 0.7D0*I + 0.2D0*J**2
            K(I,J) = LM(I,J)
   10    CONTINUE
         K(3,J) = 2.0D0*J - 1
         K(J,3) = -K(3,J)
   20 CONTINUE
      K(3,3) = 0.0D0
      DO 50 J = 1, 5
         DO 30 I = 1, 3
            S(I,J) = SIN( 1.0D0*I + 2*J )
   30    CONTINUE
         DO 40 I = 1, 3
            Z(I,J) = K(I,1)*S(1,J) + K(I,2)*S(2,J) + K(I,3)*S(3,J)
            IF ( I.LE.2 .AND. J.LE.2 ) Z(I,J) = Z(I,J) + LC(I,J)
            IF ( I.LE.2 .AND. J.GT.2 .AND. J.LE.4 )
     $         Z(I,J) = Z(I,J) + LB(I,J-2)
   40    CONTINUE
   50 CONTINUE
      K(1,1) = 1.0D10
      INFO = 0
      CALL GSJAC( 2, 1, 2, 5, LM, LB, LC, K, Z, IW, INFO )
      E = ABS( INFO )
      DO 70 J = 1, 5
         DO 60 I = 1, 3
            E = MAX( E, ABS( Z(I,J) - S(I,J) ) )
   60    CONTINUE
   70 CONTINUE
      CALL TELL( 'GSJAC: derivatives through a constraint', E )
      DO 90 J = 1, 5
         DO 80 I = 1, 4
            A(I,J) = 7.0D0
   80    CONTINUE
         R(1,J) = 1.0D0*J
   90 CONTINUE
      CALL GSJRW( 2, 2, 4, 1, 0, Z, 3, A, 4, A(1,5), 4 )
      E = ABS( A(1,3) - 1 ) + ABS( A(2,4) - 1 )
      DO 110 J = 1, 5
         DO 100 I = 1, 2
            E = MAX( E, ABS( A(2+I,J) - S(I,J) ) )
            IF ( J.NE.I+2 ) E = E + ABS( A(I,J) )
  100    CONTINUE
  110 CONTINUE
      CALL TELL( 'GSJRW: rows of the speeds', E )
      DO 120 L = 1, 3
         B(1,L) = 1.0D0/L
  120 CONTINUE
      CALL GSJTH( 1, 3, 5, B, 1, Z, 3, R, 1 )
      E = 0.0D0
      DO 130 J = 1, 5
         E = MAX( E, ABS( R(1,J) - J - S(1,J) - S(2,J)/2 - S(3,J)/3 ) )
  130 CONTINUE
      CALL TELL( 'GSJTH: a product is added', E )
      END
C
C     systems of 1 to 6 rows of all sizes, with 1 to 9 right sides; products
C     of many rows and of few
      SUBROUTINE SYSTMS
      DOUBLE PRECISION A(6,6), B(6,9), X(6,9), C(9,9), E, P
      INTEGER IW(6), N, M, I, J, K, INFO
      E = 0.0D0
      P = 0.0D0
      DO N = 1, 6
         DO M = 1, 9
            DO J = 1, 6
               DO I = 1, 6
                  A(I,J) = COS( 1.0D0*( I*J + N ) )
                  IF ( MOD( I, N ).EQ.MOD( J + 1, N ) ) A(I,J) = 3.0D0
                  A(I,J) = A(I,J)*1.0D3**( I - 3 )
               END DO
            END DO
            DO J = 1, M
               DO I = 1, 9
                  IF ( I.LE.6 ) X(I,J) = SIN( 1.0D0*( 3*I + J*J ) )
                  C(I,J) = 0.0D0
               END DO
               DO I = 1, N
                  B(I,J) = 0.0D0
                  DO K = 1, N
                     B(I,J) = B(I,J) + A(I,K)*X(K,J)
                  END DO
                  C(I,J) = -B(I,J)
               END DO
            END DO
            CALL GSJTH( N, N, M, A, 6, X, 6, C, 9 )
            CALL GSLEQ( N, M, A, 6, B, 6, IW, INFO )
            E = E + ABS( INFO )
            DO J = 1, M
               DO I = 1, N
                  E = MAX( E, ABS( B(I,J) - X(I,J) ) )
                  P = MAX( P, ABS( C(I,J) )*1.0D3**( 3 - I ) )
               END DO
            END DO
         END DO
      END DO
      CALL TELL( 'GSLEQ: systems of every size', E )
      CALL TELL( 'GSJTH: products of every size', P )
      END
C
C     two masses that are coupled, the first hits its lower stop: its
C     speed becomes -e times itself, the impulse moves the other
      SUBROUTINE IMPACT
      EXTERNAL IMSTK, IMHLD, IMMAS, GSNON
      DOUBLE PRECISION X(4), V(1), CST(1), W(200), E, D
      INTEGER MODE(1), KIND(1), IPL(1), INFO
      X(1) = 0.0D0
      X(2) = 1.0D0
      X(3) = -0.9D0
      X(4) = 0.4D0
      V(1) = 0.0D0
      MODE(1) = 0
      KIND(1) = 2
      IPL(1) = 1
      CST(1) = 0.6D0
      CALL GSIPT( IMSTK, IMHLD, IMMAS, GSNON, 0.0D0, X, V, MODE, 1, CST,
     $            2, 2, 1, 0, 1, KIND, IPL, W, INFO )
      D = 0.9D0*( 1.0D0 + 0.6D0 )
      E = MAX( ABS( X(3) - 0.6D0*0.9D0 ), ABS( X(4) - 0.4D0 + D/3 ),
     $         ABS( 1.0D0*MODE(1) ), ABS( 1.0D0*INFO ) )
      CALL TELL( 'GSIPT: an impact with restitution', E )
      END
C
      SUBROUTINE IMMAS( T, Q, CST, M, LDM )
      INTEGER LDM
      DOUBLE PRECISION T, Q(2), CST(1), M(LDM,2)
      M(1,1) = 2.0D0
      M(1,2) = 1.0D0
      M(2,1) = 1.0D0
      M(2,2) = 3.0D0
      END
      SUBROUTINE IMSTK( T, X, V, CST, UD, LAM, HOLD, INFO )
      DOUBLE PRECISION T, X(4), V(1), CST(1), UD(2), LAM(1), HOLD(1)
      INTEGER INFO
      UD(1) = 0.0D0
      UD(2) = 0.0D0
      LAM(1) = 0.0D0
      HOLD(1) = 0.0D0
      INFO = 0
      END
      SUBROUTINE IMHLD( T, X, V, CST, ROW, LDR, S, SD, PRM )
      INTEGER LDR
      DOUBLE PRECISION T, X(4), V(1), CST(1), ROW(LDR,2), S(1), SD(1),
     $                 PRM(4,1)
      ROW(1,1) = 1.0D0
      ROW(1,2) = 0.0D0
      S(1) = X(1)
      SD(1) = X(3)
      PRM(1,1) = 0.0D0
      PRM(2,1) = 5.0D0
      PRM(3,1) = CST(1)
      PRM(4,1) = 1.0D-3
      END
F
# quad precision is computed by a library: no level of optimization matters
for precision in double quad; do
  flags='-O2' least=1e-14
  [ $precision = quad ] && flags='-O0 -freal-8-real-16' least=1e-30
  gfortran $flags -o "$work/alone" "$work/alone.f" share/fortran/*/*.f \
    share/fortran/solve/plain/*.f 2>"$work/log"
  told $? "$precision: compiles" "$work/log"
  "$work/alone" | awk -v least=$least -v precision=$precision '
    { error = $1; sub(/^ *[^ ]+ /, "")
      print (error + 0 <= least ? "ok " : "not ok ") $0, "in " precision, "precision: error", error,
        "(at most " least ")" }
    END { if (NR != 12) print "not ok " NR " of twelve answers in " precision " precision" }'
done
