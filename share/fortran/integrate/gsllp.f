      SUBROUTINE GSLLN( M, N, TURN, PHI, RATE, HC, DQ, DU, INFO, X,
     $                  RES, GAP, LEFT, LIVE, BAD, MANY )
C
C     PURPOSE
C     A turn of GSPRJ for all lanes: states onto the constraints.
C
C     ARGUMENTS
C     M, N    (input) INTEGER, the numbers of constraints and of
C             coordinates (as many as speeds).
C     TURN    (input) INTEGER, the number of this turn.
C     PHI, RATE, HC, DQ, DU (input) DOUBLE PRECISION arrays, dimensions
C             (K,M), (K,M), (K,M,N), (K,N), (K,N): constraints, their
C             rates and Jacobian, the steps, from <NAME>_PRJ_W at X.
C     INFO    (input) INTEGER array, dimension (K), from it.
C     X       (input/output) DOUBLE PRECISION array, dimension (K,2*N).
C     RES     (input/output) DOUBLE PRECISION array, dimension (K):
C             |PHI| of the first turn.
C     GAP     (input/output) DOUBLE PRECISION array, dimension (K):
C             |PHI| of the last one.
C     LEFT    (input/output) DOUBLE PRECISION array, dimension (K): what
C             is left of the rates.
C     LIVE    (input/output) DOUBLE PRECISION array, dimension (K), 1
C             where there is something to do.
C     BAD     (input/output) DOUBLE PRECISION array, dimension (K), 1
C             where it has to be done by itself.
C     MANY    (output) INTEGER, 1 if another turn is wanted, else 0.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            M, N, TURN, INFO(K), MANY
      DOUBLE PRECISION   PHI(K,M), RATE(K,M), HC(K,M,N), DQ(K,N),
     $                   DU(K,N), X(K,2*N), RES(K), GAP(K), LEFT(K),
     $                   LIVE(K), BAD(K)
      DOUBLE PRECISION   GSEPS, EPS, S, Y, R(64), FQ(64), FU(64)
      EXTERNAL           GSEPS
      INTEGER            I, J, L
C
      EPS = 4.0D0*GSEPS()
      DO 10 L = 1, K
         R(L)  = 0.0D0
         FQ(L) = 0.5D0
   10 CONTINUE
      DO 30 I = 1, M
C$OMP SIMD
         DO 20 L = 1, K
            R(L) = MAX( R(L), ABS( PHI(L,I) ) )
   20    CONTINUE
   30 CONTINUE
      DO 50 I = 1, N
C$OMP SIMD
         DO 40 L = 1, K
            FQ(L) = MAX( FQ(L), ABS( DQ(L,I) ) )
   40    CONTINUE
   50 CONTINUE
      MANY = 0
      DO 60 L = 1, K
         FU(L) = 0.0D0
         IF ( LIVE(L).LE.0.0D0 ) THEN
            FQ(L) = 0.0D0
         ELSE IF ( INFO(L).NE.0 .OR. .NOT.( R(L).LE.1.0D300 ) ) THEN
            FQ(L)   = 0.0D0
            LIVE(L) = 0.0D0
            BAD(L)  = 1.0D0
         ELSE
            IF ( TURN.EQ.1 ) RES(L) = R(L)
            FQ(L) = 0.5D0/FQ(L)
            IF ( R(L).LE.EPS .OR. ( TURN.GT.2 .AND. R(L).GE.GAP(L) .AND.
     $           R(L).LE.1.0D-11 ) ) THEN
               FQ(L)   = 0.0D0
               FU(L)   = 1.0D0
               LIVE(L) = 0.0D0
               LEFT(L) = 0.0D0
            ELSE
               MANY = 1
            END IF
            GAP(L) = R(L)
         END IF
   60 CONTINUE
      DO 80 I = 1, N
C$OMP SIMD PRIVATE( S, Y )
         DO 70 L = 1, K
            S = X(L,I)
            Y = S + FQ(L)*DQ(L,I)
            IF ( FQ(L).LE.0.0D0 ) Y = S
            X(L,I) = Y
            S = X(L,N+I)
            Y = S + DU(L,I)
            IF ( FU(L).LE.0.0D0 ) Y = S
            X(L,N+I) = Y
   70    CONTINUE
   80 CONTINUE
      DO 110 I = 1, M
C$OMP SIMD PRIVATE( S, Y, J )
         DO 100 L = 1, K
            S = RATE(L,I)
            DO 90 J = 1, N
               S = S + HC(L,I,J)*DU(L,J)
   90       CONTINUE
            Y = LEFT(L)
            IF ( FU(L).GT.0.0D0 ) Y = MAX( Y, ABS( S ) )
            LEFT(L) = Y
  100    CONTINUE
  110 CONTINUE
      END
      SUBROUTINE GSLLJ( N, X, XN, XO, RTOL, ATOL, BAD )
C
C     PURPOSE
C     GSJMP for all lanes: BAD is 1 where the way from XO to XN, after
C     the step from X to XO, is a jump.
C
C     ARGUMENTS
C     N       (input) INTEGER, the number of coordinates.
C     X, XN, XO (input) DOUBLE PRECISION arrays, dimension (K,2*N).
C     RTOL, ATOL (input) as GSJMP.
C     BAD     (input/output) DOUBLE PRECISION array, dimension (K).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            N
      DOUBLE PRECISION   X(K,2*N), XN(K,2*N), XO(K,2*N), RTOL,
     $                   ATOL(2*N), BAD(K)
      DOUBLE PRECISION   GSEPS, ROOT, FAR(64), MOVED(64)
      EXTERNAL           GSEPS
      INTEGER            I, J, L
C
      ROOT = 10.0D0*SQRT( GSEPS() )
      DO 50 J = 0, 1
         DO 10 L = 1, K
            FAR(L)   = ROOT*DBLE( 1 - J )
            MOVED(L) = 0.0D0
   10    CONTINUE
         DO 30 I = J*N + 1, J*N + N
C$OMP SIMD
            DO 20 L = 1, K
               FAR(L) = MAX( FAR(L), 0.1D0*ABS( XO(L,I) - X(L,I) ),
     $                  1.0D2*( ATOL(I) + RTOL*ABS( X(L,I) ) ),
     $                  ROOT*ABS( X(L,I) ) )
               MOVED(L) = MAX( MOVED(L), ABS( XN(L,I) - XO(L,I) ) )
   20       CONTINUE
   30    CONTINUE
         DO 40 L = 1, K
            IF ( .NOT.( MOVED(L).LE.FAR(L) ) ) BAD(L) = 1.0D0
   40    CONTINUE
   50 CONTINUE
      END
      SUBROUTINE GSLLV( M, N, HC, SIZE, LONG, Y, W, RANK, LEAST )
C
C     PURPOSE
C     GSLPV for all lanes: rank and least pivot of the Jacobians HC.
C
C     ARGUMENTS
C     M, N    (input) INTEGER, the numbers of rows and columns.
C     HC      (input) DOUBLE PRECISION array, dimension (K,M,N).
C     SIZE    (input) DOUBLE PRECISION array, dimension (K,M): the
C             largest lengths that the rows had so far.
C     LONG    (output) DOUBLE PRECISION array, dimension (K,M): these
C             with the rows of HC.
C     Y, W    (workspace) DOUBLE PRECISION arrays, dimensions (K,M,N),
C             (K,M+8).
C     RANK    (output) DOUBLE PRECISION array, dimension (K).
C     LEAST   (output) DOUBLE PRECISION array, dimension (K).
C
C     METHOD
C     Columns are taken as GSQRC takes them and then out of the others
C     (modified Gram and Schmidt); a lane picks its own by numbers, not
C     by places.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            M, N
      DOUBLE PRECISION   HC(K,M,N), SIZE(K,M), LONG(K,M), Y(K,M,N),
     $                   W(K,M+8), RANK(K), LEAST(K)
      DOUBLE PRECISION   S, Z, B
      INTEGER            I, J, L, C
C
C     -- W(*,M+1) the largest column, +2 its number, +3 the first one,
C        +4 the last one, +5 the length of one column, +6 spare
      DO 10 L = 1, K
         W(L,M+1) = 0.0D0
         RANK(L)  = 0.0D0
         LEAST(L) = 0.0D0
         W(L,M+3) = 1.0D0
         W(L,M+4) = 0.0D0
         W(L,M+7) = 1.0D0
   10 CONTINUE
      DO 60 I = 1, M
         DO 20 L = 1, K
            W(L,M+5) = 0.0D0
   20    CONTINUE
         DO 40 J = 1, N
C$OMP SIMD
            DO 30 L = 1, K
               W(L,M+5) = W(L,M+5) + HC(L,I,J)*HC(L,I,J)
   30       CONTINUE
   40    CONTINUE
C$OMP SIMD
         DO 50 L = 1, K
            LONG(L,I) = MAX( SIZE(L,I), SQRT( W(L,M+5) ) )
            W(L,M+1) = MAX( W(L,M+1), LONG(L,I) )
   50    CONTINUE
   60 CONTINUE
      DO 90 I = 1, M
C$OMP SIMD PRIVATE( S )
         DO 70 L = 1, K
            S = W(L,M+1)
            IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D0
            LONG(L,I) = MAX( LONG(L,I), 1.0D-6*S )
            W(L,I) = 1.0D0/LONG(L,I)
   70    CONTINUE
         DO 85 J = 1, N
C$OMP SIMD
            DO 80 L = 1, K
               Y(L,I,J) = HC(L,I,J)*W(L,I)
   80       CONTINUE
   85    CONTINUE
   90 CONTINUE
C
      DO 290 C = 1, MIN( M, N )
         DO 100 L = 1, K
            W(L,M+1) = -1.0D0
            W(L,M+2) = 0.0D0
  100    CONTINUE
         DO 140 J = 1, N
            DO 110 L = 1, K
               W(L,M+5) = 0.0D0
  110       CONTINUE
            DO 120 I = 1, M
C$OMP SIMD
               DO 115 L = 1, K
                  W(L,M+5) = W(L,M+5) + Y(L,I,J)*Y(L,I,J)
  115          CONTINUE
  120       CONTINUE
            B = DBLE( J )
C$OMP SIMD PRIVATE( S, Z )
            DO 130 L = 1, K
               S = W(L,M+1)*( 1.0D0 + 1.0D-8 )
               Z = W(L,M+2)
               IF ( W(L,M+5).GT.S ) Z = B
               W(L,M+2) = Z
               Z = W(L,M+1)
               IF ( W(L,M+5).GT.S ) Z = W(L,M+5)
               W(L,M+1) = Z
  130       CONTINUE
  140    CONTINUE
C$OMP SIMD PRIVATE( S, Z )
         DO 150 L = 1, K
            Z = W(L,M+3)
            IF ( C.EQ.1 ) Z = W(L,M+1)
            W(L,M+3) = Z
            S = W(L,M+7)
            IF ( .NOT.( W(L,M+1).GT.1.0D-14*Z ) ) S = 0.0D0
            W(L,M+7) = S
            RANK(L) = RANK(L) + S
            Z = W(L,M+4)
            IF ( S.GT.0.0D0 ) Z = W(L,M+1)
            W(L,M+4) = Z
            Z = W(L,M+1)
            IF ( S.LE.0.0D0 ) Z = 1.0D300
            W(L,M+6) = 1.0D0/SQRT( Z )
  150    CONTINUE
         IF ( C.EQ.MIN( M, N ) ) GO TO 300
C
C        -- the column of every lane, then out of all
         DO 180 I = 1, M
            DO 160 L = 1, K
               W(L,I) = 0.0D0
  160       CONTINUE
            DO 175 J = 1, N
C$OMP SIMD PRIVATE( S )
               DO 170 L = 1, K
                  S = W(L,I)
                  IF ( ABS( W(L,M+2) - J ).LT.0.5D0 )
     $               S = Y(L,I,J)*W(L,M+6)
                  W(L,I) = S
  170          CONTINUE
  175       CONTINUE
  180    CONTINUE
         DO 240 J = 1, N
            DO 190 L = 1, K
               W(L,M+5) = 0.0D0
  190       CONTINUE
            DO 210 I = 1, M
C$OMP SIMD
               DO 200 L = 1, K
                  W(L,M+5) = W(L,M+5) + W(L,I)*Y(L,I,J)
  200          CONTINUE
  210       CONTINUE
            DO 230 I = 1, M
C$OMP SIMD
               DO 220 L = 1, K
                  Y(L,I,J) = Y(L,I,J) - W(L,M+5)*W(L,I)
  220          CONTINUE
  230       CONTINUE
  240    CONTINUE
  290 CONTINUE
  300 CONTINUE
C$OMP SIMD PRIVATE( S )
      DO 310 L = 1, K
         S = W(L,M+3)
         IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D0
         LEAST(L) = SQRT( W(L,M+4)/S )
  310 CONTINUE
      END
      SUBROUTINE GSLLT( M, N, HA, HB, SIZE, TURN )
C
C     PURPOSE
C     GSPCH for all lanes: how far the Jacobians HA and HB differ,
C     beside the lengths SIZE of their rows, the largest of the rows.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            M, N
      DOUBLE PRECISION   HA(K,M,N), HB(K,M,N), SIZE(K,M), TURN(K)
      DOUBLE PRECISION   S(64)
      INTEGER            I, J, L
C
      DO 10 L = 1, K
         TURN(L) = 0.0D0
   10 CONTINUE
      DO 60 I = 1, M
         DO 20 L = 1, K
            S(L) = 0.0D0
   20    CONTINUE
         DO 40 J = 1, N
C$OMP SIMD
            DO 30 L = 1, K
               S(L) = S(L) + ( HA(L,I,J) - HB(L,I,J) )**2
   30       CONTINUE
   40    CONTINUE
C$OMP SIMD
         DO 50 L = 1, K
            TURN(L) = MAX( TURN(L), SQRT( S(L) )/SIZE(L,I) )
   50    CONTINUE
   60 CONTINUE
      END
      SUBROUTINE GSLLC( N, X, GAP, RANK, LEAST, TURN, NEAR, P, BAD )
C
C     PURPOSE
C     GSCHK for all lanes behind the projection: BAD is 1 where it is
C     not the usual case.
C
C     ARGUMENTS
C     As GSLLN, and
C     RANK, LEAST, TURN (input) from GSLLV and GSLLT, the latter since
C             the step before.
C     NEAR    (input) DOUBLE PRECISION array, dimension (K): how far the
C             least pivot may fall beside its largest value.
C     P       (input) DOUBLE PRECISION array, dimension (K,*), see
C             GSPRT.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            N
      DOUBLE PRECISION   X(K,2*N), GAP(K), RANK(K), LEAST(K), TURN(K),
     $                   NEAR(K), P(K,*), BAD(K)
      DOUBLE PRECISION   S, Y, BIG(64)
      INTEGER            I, L
C
      DO 10 L = 1, K
         BIG(L)   = 1.0D0
   10 CONTINUE
      DO 30 I = 1, N
C$OMP SIMD
         DO 20 L = 1, K
            BIG(L) = MAX( BIG(L), ABS( X(L,I) ) )
   20    CONTINUE
   30 CONTINUE
C$OMP SIMD PRIVATE( S, Y )
      DO 70 L = 1, K
         Y = BAD(L)
         S = LEAST(L)
         IF ( RANK(L).LT.P(L,3) ) Y = 1.0D0
         IF ( S.LT.NEAR(L)*P(L,14) ) Y = 1.0D0
         IF ( .NOT.( GAP(L).LE.1.0D-6*BIG(L) ) ) Y = 1.0D0
         IF ( TURN(L).GT.0.3D0 .AND. P(L,4).GE.1.0D0 ) Y = 1.0D0
C        a minimum between the last steps, see GSPAS
         IF ( P(L,4).GE.2.0D0 .AND. P(L,10).LE.P(L,8) .AND.
     $        P(L,10).LT.S .AND.
     $        P(L,10).LE.0.5D0*MAX( P(L,14), S ) ) Y = 1.0D0
         BAD(L) = Y
   70 CONTINUE
      END
      SUBROUTINE GSLLU( M, N, R, TN, X, LONG, RANK, LEAST, GAP, LEFT,
     $                  P, C )
C
C     PURPOSE
C     What GSCHK remembers of a step, in the lanes where R is 1.
C
C     ARGUMENTS
C     As GSLLC, and
C     R       (input) DOUBLE PRECISION array, dimension (K).
C     TN, X   (input) DOUBLE PRECISION arrays, dimensions (K), (K,2*N):
C             the end of the step.
C     LONG    (input) from GSLLV.
C     P       (input/output) DOUBLE PRECISION array, dimension (K,*).
C     C       (input/output) DOUBLE PRECISION array, dimension (K,40),
C             see GSLNA: (23) and (24) P(13) and P(14), (25) to (29)
C             RSTAT(1) to RSTAT(5), (30) and (31) RSTAT(14), RSTAT(15),
C             (32) ISTAT(4).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            M, N
      DOUBLE PRECISION   R(K), TN(K), X(K,2*N), LONG(K,M), RANK(K),
     $                   LEAST(K), GAP(K), LEFT(K), P(K,*), C(K,40)
      INTEGER            I, L, IM, IQ
C
      IM = 14 + 3*N
      IQ = 24 + 12*N + 7*M + 2*M*N
      DO 20 I = 5, 8
         DO 10 L = 1, K
            IF ( ABS( R(L) - 1.0D0 ).LT.0.5D0 ) P(L,I) = P(L,I+2)
   10    CONTINUE
   20 CONTINUE
      DO 40 I = IQ + 1, IQ + 4*N
         DO 30 L = 1, K
            IF ( ABS( R(L) - 1.0D0 ).LT.0.5D0 ) P(L,I) = P(L,I+2*N)
   30    CONTINUE
   40 CONTINUE
      DO 60 I = 1, 2*N
         DO 50 L = 1, K
            IF ( ABS( R(L) - 1.0D0 ).LT.0.5D0 )
     $         P(L,IQ+4*N+I) = X(L,I)
   50    CONTINUE
   60 CONTINUE
      DO 80 I = 1, M
         DO 70 L = 1, K
            IF ( ABS( R(L) - 1.0D0 ).LT.0.5D0 ) P(L,IM+I) = LONG(L,I)
   70    CONTINUE
   80 CONTINUE
      DO 90 L = 1, K
         IF ( .NOT.( ABS( R(L) - 1.0D0 ).LT.0.5D0 ) ) GO TO 90
         P(L,4)  = P(L,4) + 1.0D0
         P(L,9)  = TN(L)
         P(L,10) = LEAST(L)
         P(L,3)  = MAX( P(L,3), RANK(L) )
         P(L,13) = LEAST(L)
         P(L,14) = MAX( P(L,14), LEAST(L) )
         C(L,23) = P(L,13)
         C(L,24) = P(L,14)
         IF ( GAP(L).GT.C(L,25) ) THEN
            C(L,25) = GAP(L)
            C(L,27) = TN(L)
         END IF
         IF ( LEFT(L).GT.C(L,26) ) THEN
            C(L,26) = LEFT(L)
            C(L,28) = TN(L)
         END IF
         IF ( LEAST(L).LT.C(L,30) ) THEN
            C(L,30) = LEAST(L)
            C(L,31) = TN(L)
         END IF
   90 CONTINUE
      END
      SUBROUTINE GSLLA( RUNS, C, P, LOOK )
C
C     PURPOSE
C     GSPSW for all lanes: LOOK is 1 where it would look ahead for a
C     singular position.  C as GSLLU, (33) and (34) are M(8) and M(11)
C     of GSDPS; P as GSLLC; RUNS as GSLNA.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      DOUBLE PRECISION   RUNS(K), C(K,40), P(K,*), LOOK(K)
      DOUBLE PRECISION   S, H
      INTEGER            L
C
C$OMP SIMD PRIVATE( S, H )
      DO 10 L = 1, K
         H = MIN( C(L,2), C(L,3) )
         S = 0.0D0
         IF ( P(L,4).LT.3.0D0 .OR. H.GT.0.25D0*C(L,34) .OR.
     $        P(L,13).LT.0.25D0*P(L,14) ) S = 1.0D0
         IF ( P(L,10).LT.P(L,8) .AND. P(L,10)*( P(L,9) - P(L,7) ).LT.
     $        MAX( 3.0D0*H, C(L,34) )*( P(L,8) - P(L,10) ) ) S = 1.0D0
         IF ( C(L,1).LT.C(L,33) ) S = 0.0D0
         IF ( RUNS(L).LE.0.0D0 ) S = 0.0D0
         LOOK(L) = S
   10 CONTINUE
      END
      SUBROUTINE GSLLX( N, T, X, F, TAU, TS, Q )
C
C     PURPOSE
C     Positions Q of all lanes at TS = T + TAU, by rates that are linear
C     in time (GSPRD): F are the rates of the states X at T.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            N
      DOUBLE PRECISION   T(K), X(K,2*N), F(K,2*N), TAU(K), TS(K), Q(K,N)
      INTEGER            I, L
C
      DO 10 L = 1, K
         TS(L) = T(L) + TAU(L)
   10 CONTINUE
      DO 30 I = 1, N
C$OMP SIMD
         DO 20 L = 1, K
            Q(L,I) = X(L,I) + TAU(L)*( F(L,I) + 0.5D0*TAU(L)*F(L,N+I) )
   20    CONTINUE
   30 CONTINUE
      END
