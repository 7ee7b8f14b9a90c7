      SUBROUTINE GSLNC( N, C, J, TS )
C
C     PURPOSE
C     The method of GSDP8 for runs in lanes: for stage I (2 to 12) the
C     N(I) right-hand sides of which its state is made, the first of
C     them J(1,I), and what they are multiplied by, C(1,I); for I = 1
C     those of the result; its time is T + TS(I)*H.
C
C     ARGUMENTS
C     N       (output) INTEGER array, dimension (12).
C     C       (output) DOUBLE PRECISION array, dimension (12,12).
C     J       (output) INTEGER array, dimension (12,12).
C     TS      (output) DOUBLE PRECISION array, dimension (12).
C
      IMPLICIT NONE
      INTEGER            N(12), J(12,12)
      DOUBLE PRECISION   C(12,12), TS(12)
      EXTERNAL           GSADT
      DOUBLE PRECISION   A(12,12), B(12)
      INTEGER            I, K
C
      DO 20 K = 1, 12
         B(K)  = 0.0D0
         TS(K) = 0.0D0
         DO 10 I = 1, 12
            A(I,K) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      CALL GSADT( A, B, TS )
      DO 40 I = 1, 12
         N(I) = 0
         DO 30 K = 1, 12
            IF ( I.EQ.1 ) A(I,K) = B(K)
            IF ( ABS( A(I,K) ).GT.0.0D0 ) THEN
               N(I) = N(I) + 1
               C(N(I),I) = A(I,K)
               J(N(I),I) = K
            END IF
   30    CONTINUE
   40 CONTINUE
      END
      SUBROUTINE GSLNS( M, N, C, J, H, X, W, XS )
C
C     PURPOSE
C     The state of a stage for many lanes: XS = X + H*(C(1)*W(:,J(1)) +
C     ... + C(N)*W(:,J(N))), summed up as GSDP8 does it.
C
C     ARGUMENTS
C     M       (input) INTEGER, the number of numbers: of lanes times
C             that of states.
C     N, C, J (input) a column of those of GSLNC.
C     H, X    (input) DOUBLE PRECISION arrays, dimension (M): the step
C             of the lane that a number belongs to, and the states.
C     W       (input) DOUBLE PRECISION array, dimension (M,12), the
C             right-hand sides.
C     XS      (output) DOUBLE PRECISION array, dimension (M).
C
      IMPLICIT NONE
      INTEGER            M, N, J(12)
      DOUBLE PRECISION   C(12), H(M), X(M), W(M,12), XS(M)
      INTEGER            I, A, B, D, E, F, G, O, P, Q
C
      A = J(1)
      B = J(MIN( 2, N ))
      D = J(MIN( 3, N ))
      E = J(MIN( 4, N ))
      F = J(MIN( 5, N ))
      G = J(MIN( 6, N ))
      O = J(MIN( 7, N ))
      P = J(MIN( 8, N ))
      Q = J(MIN( 9, N ))
      IF ( N.EQ.1 ) THEN
C$OMP SIMD
         DO 10 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) )
   10    CONTINUE
      ELSE IF ( N.EQ.2 ) THEN
C$OMP SIMD
         DO 20 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B) )
   20    CONTINUE
      ELSE IF ( N.EQ.3 ) THEN
C$OMP SIMD
         DO 30 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) )
   30    CONTINUE
      ELSE IF ( N.EQ.4 ) THEN
C$OMP SIMD
         DO 40 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) )
   40    CONTINUE
      ELSE IF ( N.EQ.5 ) THEN
C$OMP SIMD
         DO 50 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) + C(5)*W(I,F) )
   50    CONTINUE
      ELSE IF ( N.EQ.6 ) THEN
C$OMP SIMD
         DO 60 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) + C(5)*W(I,F)
     $            + C(6)*W(I,G) )
   60    CONTINUE
      ELSE IF ( N.EQ.7 ) THEN
C$OMP SIMD
         DO 70 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) + C(5)*W(I,F)
     $            + C(6)*W(I,G) + C(7)*W(I,O) )
   70    CONTINUE
      ELSE IF ( N.EQ.8 ) THEN
C$OMP SIMD
         DO 80 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) + C(5)*W(I,F)
     $            + C(6)*W(I,G) + C(7)*W(I,O) + C(8)*W(I,P) )
   80    CONTINUE
      ELSE
C$OMP SIMD
         DO 90 I = 1, M
            XS(I) = X(I) + H(I)*( C(1)*W(I,A) + C(2)*W(I,B)
     $            + C(3)*W(I,D) + C(4)*W(I,E) + C(5)*W(I,F)
     $            + C(6)*W(I,G) + C(7)*W(I,O) + C(8)*W(I,P)
     $            + C(9)*W(I,Q) )
   90    CONTINUE
      END IF
      END
      SUBROUTINE GSLNT( T, C, H, TS )
C
C     PURPOSE
C     The times T + C*H of a stage for all lanes, TS.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      DOUBLE PRECISION   T(K), C, H(K), TS(K)
      INTEGER            L
C
C$OMP SIMD
      DO 10 L = 1, K
         TS(L) = T(L) + C*H(L)
   10 CONTINUE
      END
      SUBROUTINE GSLNE( NX, H, X, W, RTOL, ATOL, C, XN, ERR, S1, S2 )
C
C     PURPOSE
C     The end of a step of GSDP8 for all lanes: the states and the
C     estimated errors.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     H       (input) DOUBLE PRECISION array, dimension (K), the steps.
C     X       (input) DOUBLE PRECISION array, dimension (K,NX).
C     W       (input) DOUBLE PRECISION array, dimension (K,NX,12).
C     RTOL, ATOL (input) as GSDP8.
C     C       (input) DOUBLE PRECISION array, dimension (8): column 1 of
C             that of GSLNC.
C     XN      (output) DOUBLE PRECISION array, dimension (K,NX).
C     ERR     (output) DOUBLE PRECISION array, dimension (K), as GSDP8.
C     S1, S2  (workspace) DOUBLE PRECISION arrays, dimension (K).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   H(K), X(K,NX), W(K,NX,12), RTOL, ATOL(NX),
     $                   C(8), XN(K,NX), ERR(K), S1(K), S2(K)
      INTEGER            I, L
      DOUBLE PRECISION   S, D3, D5, Q3, Q5, Y, E1, E6, E7, E8, E9, E10,
     $                   E11, E12, G1, G9, G12
      PARAMETER ( E1    = 1.3120044994194880732501029953801793085D-2,
     $            E6    = -1.2251564463762044407205697528543837147D0,
     $            E7    = -4.9575894965725019152140799504384812683D-1,
     $            E8    = 1.6643771824549865369615304151480492819D0,
     $            E9    = -3.503288487499736816886487289838649404D-1,
     $            E10   = 3.3417911871301747902973188414208476014D-1,
     $            E11   = 8.1923206485115712465707426085956994164D-2,
     $            E12   = -2.2355307863886295258844278437796047352D-2 )
      PARAMETER ( G1    = 2.4409448818897637795275590551181102362D-1,
     $            G9    = 7.3384668828161185734136174154701250579D-1,
     $            G12   = 2.2058823529411764705882352941176470588D-2 )
C
      DO 10 L = 1, K
         S1(L)  = 0.0D0
         S2(L)  = 0.0D0
         ERR(L) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD PRIVATE( S, D3, D5, Q3, Q5, Y )
         DO 20 L = 1, K
            S = C(1)*W(L,I,1) + C(2)*W(L,I,6) + C(3)*W(L,I,7)
     $        + C(4)*W(L,I,8) + C(5)*W(L,I,9) + C(6)*W(L,I,10)
     $        + C(7)*W(L,I,11) + C(8)*W(L,I,12)
            XN(L,I) = X(L,I) + H(L)*S
            D3 = S - G1*W(L,I,1) - G9*W(L,I,9) - G12*W(L,I,12)
            D5 = E1*W(L,I,1) + E6*W(L,I,6) + E7*W(L,I,7) + E8*W(L,I,8)
     $         + E9*W(L,I,9) + E10*W(L,I,10) + E11*W(L,I,11)
     $         + E12*W(L,I,12)
            S  = ATOL(I) + RTOL*MAX( ABS( X(L,I) ), ABS( XN(L,I) ) )
            Q3 = D3/S
            Q5 = D5/S
            IF ( .NOT.( S.GT.0.0D0 ) ) THEN
               Q3 = 0.0D0
               Q5 = 0.0D0
            END IF
            S2(L) = S2(L) + Q3**2
            Y = S1(L) + Q5**2
            IF ( .NOT.( S.GT.0.0D0 ) .AND. ABS( D5 ).GT.0.0D0 )
     $         Y = 1.0D300
            S1(L) = Y
            Y = ERR(L)
            IF ( .NOT.( ABS( XN(L,I) ).LE.1.0D300 ) ) Y = 1.0D307
            ERR(L) = Y
   20    CONTINUE
   30 CONTINUE
C$OMP SIMD PRIVATE( S )
      DO 40 L = 1, K
         S = S1(L) + 0.01D0*S2(L)
         IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D0
         S = ABS( H(L) )*S1(L)/SQRT( DBLE( MAX( 1, NX ) )*S )
         IF ( ERR(L).GT.0.0D0 ) S = ERR(L)
         ERR(L) = S
   40 CONTINUE
      END
      SUBROUTINE GSLNK( NX, FRESH, F, W, X, XS, RTOL, ATOL, NS, C,
     $                  SLOW )
C
C     PURPOSE
C     GSDPF for all lanes behind the right-hand sides F: those of lanes
C     that wanted them go to W; whether they are finite and stability
C     binds the last step.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     FRESH   (input) DOUBLE PRECISION array, dimension (K), 1 where the
C             right-hand sides were wanted.
C     F       (input) DOUBLE PRECISION array, dimension (K,NX).
C     W       (input/output) DOUBLE PRECISION array, dimension
C             (K,NX,12), column 12 that of the last stage of the step.
C     X, XS   (input) DOUBLE PRECISION arrays, dimension (K,NX): the
C             states, and those of that stage.
C     RTOL, ATOL (input) as GSDP8.
C     NS      (input) INTEGER, how many steps that look bound are too
C             many.
C     C       (input/output) DOUBLE PRECISION array, dimension (K,24),
C             what is remembered of the runs, see GSLNA.
C     SLOW    (output) DOUBLE PRECISION array, dimension (K), 1 where
C             GSDPF has to look by itself.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX, NS
      DOUBLE PRECISION   FRESH(K), F(K,NX), W(K,NX,12), X(K,NX),
     $                   XS(K,NX), RTOL, ATOL(NX), C(K,24), SLOW(K)
      INTEGER            I, L
      DOUBLE PRECISION   S, P, Q, Y, A(64), B(64)
C
      DO 10 L = 1, K
         A(L) = 0.0D0
         B(L) = 0.0D0
         SLOW(L) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD PRIVATE( S, P, Q, Y )
         DO 20 L = 1, K
            Y = W(L,I,1)
            IF ( FRESH(L).GT.0.0D0 ) Y = F(L,I)
            W(L,I,1) = Y
            S = ATOL(I) + RTOL*ABS( X(L,I) )
            IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D308
            P = ( Y - W(L,I,12) )/S
            Q = ( X(L,I) - XS(L,I) )/S
            A(L) = A(L) + P**2
            B(L) = B(L) + Q**2
            P = SLOW(L)
            IF ( .NOT.( ABS( Y ).LE.1.0D300 ) ) P = 1.0D0
            SLOW(L) = P
   20    CONTINUE
   30 CONTINUE
C$OMP SIMD PRIVATE( S, P, Q, Y )
      DO 40 L = 1, K
         S = C(L,11)
         P = C(L,12)
         Q = 0.0D0
         IF ( ABS( C(L,17) )*SQRT( A(L) ).GT.5.0D0*SQRT( B(L) ) )
     $      Q = 1.0D0
         Y = S
         IF ( Q.GT.0.0D0 ) Y = S + 1.0D0
         IF ( Q.LE.0.0D0 .AND. P.GE.5.0D0 ) Y = 0.0D0
         P = P + 1.0D0
         IF ( Q.GT.0.0D0 ) P = 0.0D0
         Q = SLOW(L)
         IF ( C(L,2).LE.0.0D0 ) Q = 1.0D0
         IF ( C(L,15).GT.0.0D0 .AND. C(L,22).LE.0.0D0 .AND.
     $        Y.GE.DBLE( NS ) ) Q = 1.0D0
         IF ( C(L,14).LE.0.0D0 ) Q = 0.0D0
         SLOW(L) = Q
         IF ( C(L,15).LE.0.0D0 .OR. C(L,14).LE.0.0D0 .OR.
     $        C(L,22).GT.0.0D0 .OR. Q.GT.0.0D0 ) THEN
            Y = S
            P = C(L,12)
         END IF
         C(L,11) = Y
         C(L,12) = P
         IF ( Q.LE.0.0D0 ) C(L,13) = C(L,13) + FRESH(L)
         IF ( Q.LE.0.0D0 ) C(L,14) = 0.0D0
   40 CONTINUE
      END
      SUBROUTINE GSLNA( NX, RUNS, C, HLIM, H, HS, TN, AT, SLOW )
C
C     PURPOSE
C     GSDTA for all lanes, far from singular positions: the lengths of
C     the next trial steps.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     RUNS    (input) DOUBLE PRECISION array, dimension (K), 1 where a
C             step is next; 0: H is 0.
C     C       (input/output) DOUBLE PRECISION array, dimension (K,24):
C             of each run (1) the time, (2) M(1) of GSDPS, (3) the
C             largest step, (4) the time of the stop and (16) its side,
C             (5) the next output time, (6) and (7) the least and the
C             largest step, (8) and (9) steps that were good and others,
C             (10) how many there may be, (11) and (12) ISTAT(16) and
C             ISTAT(17), (13) calls of the right-hand side, (14) and
C             (15) LM(1) and LM(2), (17) to (19) M(2) to M(4), (20)
C             RSTAT(9), (21) 1 if a step was good since it came here,
C             (22) ISTAT(14), (23) and (24) P(13) and P(14).
C     HLIM    (input) DOUBLE PRECISION array, dimension (K): no step is
C             longer.
C     H, HS   (output) DOUBLE PRECISION arrays, dimensions (K), (K,NX):
C             the steps, and those that the states belong to.
C     TN, AT  (output) DOUBLE PRECISION arrays, dimension (K), as GSDTA.
C     SLOW    (output) DOUBLE PRECISION array, dimension (K), 1 where
C             GSDTA has to look by itself.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   RUNS(K), C(K,24), HLIM(K), H(K), HS(K,NX),
     $                   TN(K), AT(K), SLOW(K)
      DOUBLE PRECISION   GSEPS, EPS, S, Z, Y, B
      EXTERNAL           GSEPS
      INTEGER            I, L
C
      EPS = 1.6D1*GSEPS()
C$OMP SIMD PRIVATE( S, Z, Y, B )
      DO 10 L = 1, K
         B = C(L,4)
         S = MIN( C(L,2), C(L,3), HLIM(L) )
         Z = C(L,1) + S
         Y = 1.0D0
         IF ( C(L,1) + 1.01D0*S.GE.B ) THEN
            S = B - C(L,1)
            Z = B
            Y = C(L,16)
         ELSE IF ( C(L,1) + 2.0D0*S.GT.B ) THEN
            S = 0.5D0*( B - C(L,1) )
            Z = C(L,1) + S
         END IF
         AT(L) = Y
         Y = 0.0D0
         IF ( C(L,8) + C(L,9).GE.C(L,10) ) Y = 1.0D0
         IF ( S.LE.EPS*MAX( ABS( C(L,1) ), ABS( B ) ) .AND. Z.LT.B )
     $      Y = 1.0D0
         IF ( C(L,23).LT.C(L,18)*C(L,24) ) Y = 1.0D0
         IF ( C(L,23).LT.0.25D0*C(L,24) .AND. S.LE.1.0D-4*C(L,19) )
     $      Y = 1.0D0
         IF ( RUNS(L).LE.0.0D0 ) THEN
            S = 0.0D0
            Z = C(L,1)
            Y = 0.0D0
         END IF
         IF ( RUNS(L).GT.0.0D0 ) C(L,17) = S
         SLOW(L) = Y
         TN(L)   = Z
         H(L)    = S
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD
         DO 20 L = 1, K
            HS(L,I) = H(L)
   20    CONTINUE
   30 CONTINUE
      END
      SUBROUTINE GSLNJ( RUNS, C, TN, ERR, R )
C
C     PURPOSE
C     Trial steps of GSDP8 in all lanes: R is 1 where they are good, 2
C     where they are to be repeated, 3 where GSDTB has to look by
C     itself, 0 where there were none.  Arguments as GSLNA; ERR as
C     GSLNE.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      DOUBLE PRECISION   RUNS(K), C(K,24), TN(K), ERR(K), R(K)
      DOUBLE PRECISION   S
      INTEGER            L
C
C$OMP SIMD PRIVATE( S )
      DO 10 L = 1, K
         S = 2.0D0
         IF ( ERR(L).LE.1.0D0 ) S = 1.0D0
         IF ( ERR(L).LE.1.0D0 .AND. C(L,5).LT.TN(L) ) S = 3.0D0
         IF ( .NOT.( ERR(L).LE.1.0D300 ) ) S = 3.0D0
         IF ( RUNS(L).LE.0.0D0 ) S = 0.0D0
         R(L) = S
   10 CONTINUE
      END
      SUBROUTINE GSLNU( NX, R, H, TN, ERR, C, X, XN )
C
C     PURPOSE
C     The end of a trial step in all lanes, see GSLNJ: where R is 1 X
C     becomes XN; the lengths of the next steps, where R is 1 or 2.
C     The eighth root of the error is that of three square roots.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   R(K), H(K), TN(K), ERR(K), C(K,24), X(K,NX),
     $                   XN(K,NX)
      DOUBLE PRECISION   S, Z, Y, F, G
      INTEGER            L
      EXTERNAL           GSLNG
C
C$OMP SIMD PRIVATE( S, Z, Y, F, G )
      DO 10 L = 1, K
         S = R(L)
         F = MIN( 1.0D300, MAX( 1.0D-16, ERR(L) ) )
         F = 0.9D0/SQRT( SQRT( SQRT( F ) ) )
         G = H(L)*MAX( MIN( 6.0D0, F ), 1.0D0/3.0D0 )
         Z = C(L,2)
         Y = C(L,2)
         IF ( H(L).GE.0.99D0*Z .OR. G.GT.Z ) Y = G
         IF ( S.GT.1.5D0 ) Y = H(L)*MIN( 0.9D0, MAX( 0.2D0, F ) )
         IF ( S.LT.0.5D0 .OR. S.GT.2.5D0 ) Y = Z
         C(L,2) = Y
         IF ( S.GT.0.5D0 .AND. S.LT.1.5D0 ) THEN
            C(L,1)  = TN(L)
            C(L,6)  = MIN( C(L,6), H(L) )
            C(L,7)  = MAX( C(L,7), H(L) )
            C(L,8)  = C(L,8) + 1.0D0
            C(L,14) = 1.0D0
            C(L,15) = 1.0D0
            C(L,18) = 0.05D0
            C(L,20) = Y
            C(L,21) = 1.0D0
            IF ( C(L,23).GE.0.25D0*C(L,24) ) C(L,19) = Y
         END IF
         IF ( S.GT.1.5D0 .AND. S.LT.2.5D0 ) THEN
            C(L,9)  = C(L,9) + 1.0D0
            C(L,18) = 0.25D0
         END IF
         IF ( S.GT.0.5D0 .AND. S.LT.2.5D0 ) C(L,13) = C(L,13) + 11.0D0
   10 CONTINUE
      CALL GSLNG( NX, R, X, XN )
      END
      SUBROUTINE GSLNP( RUNS, C, H, TN, AT, SLOW )
C
C     PURPOSE
C     GSRKT for all lanes: the next steps of GSRK4.
C
C     ARGUMENTS
C     As GSLNA, but C: (1) the time, (2) where steps of this length
C     began, (3) the length, (4) the time of the stop and (16) its side,
C     (5) the number of the step and (6) how many there are, (8) steps
C     that were done, (10) how many there may be, (13) calls, (17) when
C     GSSTD is to look.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      DOUBLE PRECISION   RUNS(K), C(K,24), H(K), TN(K), AT(K), SLOW(K)
      DOUBLE PRECISION   S, Y
      INTEGER            L
C
C$OMP SIMD PRIVATE( S, Y )
      DO 10 L = 1, K
         S = C(L,3)
         IF ( RUNS(L).LE.0.0D0 ) S = 0.0D0
         H(L) = S
         S = C(L,1)
         IF ( RUNS(L).GT.0.0D0 ) S = C(L,2) + ( C(L,5) - 1.0D0 )*C(L,3)
         C(L,1) = S
         Y = 1.0D0
         S = C(L,2) + C(L,5)*C(L,3)
         IF ( C(L,5).GE.C(L,6) ) THEN
            S = C(L,4)
            Y = C(L,16)
         END IF
         AT(L) = Y
         IF ( RUNS(L).LE.0.0D0 ) S = C(L,1)
         TN(L) = S
         Y = 0.0D0
         IF ( C(L,8).GE.C(L,10) ) Y = 1.0D0
         IF ( RUNS(L).LE.0.0D0 ) Y = 0.0D0
         SLOW(L) = Y
   10 CONTINUE
      END
      SUBROUTINE GSLNR( NX, RUNS, XN, R )
C
C     PURPOSE
C     Steps of GSRK4 in all lanes: R is 1 where they are good, 3 where a
C     number of XN may not be finite (their moduli add up to more than
C     1E300), 0 where there were none.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   RUNS(K), XN(K,NX), R(K)
      DOUBLE PRECISION   S(K), Y
      INTEGER            I, L
C
      DO 10 L = 1, K
         S(L) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD
         DO 20 L = 1, K
            S(L) = S(L) + ABS( XN(L,I) )
   20    CONTINUE
   30 CONTINUE
C$OMP SIMD PRIVATE( Y )
      DO 40 L = 1, K
         Y = RUNS(L)
         IF ( .NOT.( S(L).LE.1.0D300 ) .AND. Y.GT.0.0D0 ) Y = 3.0D0
         R(L) = Y
   40 CONTINUE
      END
      SUBROUTINE GSLNQ( NX, R, TN, C, X, XN )
C
C     PURPOSE
C     The end of a step of GSRK4 in all lanes, see GSLNR: where R is 1 X
C     becomes XN.  C as GSLNP.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   R(K), TN(K), C(K,24), X(K,NX), XN(K,NX)
      INTEGER            L
      EXTERNAL           GSLNG
C
C$OMP SIMD
      DO 10 L = 1, K
         IF ( R(L).GT.0.5D0 .AND. R(L).LT.1.5D0 ) THEN
            C(L,1)  = TN(L)
            C(L,5)  = C(L,5) + 1.0D0
            C(L,8)  = C(L,8) + 1.0D0
            C(L,13) = C(L,13) + 4.0D0
            C(L,21) = 1.0D0
         END IF
   10 CONTINUE
      CALL GSLNG( NX, R, X, XN )
      END
      SUBROUTINE GSLNG( NX, R, X, XN )
C
C     PURPOSE
C     The states of all lanes behind a step: where R is 1 X becomes XN.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   R(K), X(K,NX), XN(K,NX)
      DOUBLE PRECISION   Y
      INTEGER            I, L
C
      DO 30 I = 1, NX
C$OMP SIMD PRIVATE( Y )
         DO 20 L = 1, K
            Y = X(L,I)
            IF ( R(L).GT.0.5D0 .AND. R(L).LT.1.5D0 ) Y = XN(L,I)
            X(L,I) = Y
   20    CONTINUE
   30 CONTINUE
      END
      SUBROUTINE GSLN4( S, NX, H, X, W, XS )
C
C     PURPOSE
C     The states of GSRK4 for all lanes, after its S-th right-hand side.
C
C     ARGUMENTS
C     S       (input) INTEGER, 1 to 4.
C     NX      (input) INTEGER, the number of states.
C     H       (input) DOUBLE PRECISION array, dimension (K), the steps.
C     X       (input) DOUBLE PRECISION array, dimension (K,NX), the
C             states.
C     W       (input) DOUBLE PRECISION array, dimension (K,NX,4): the
C             right-hand sides 1 to S.
C     XS      (output) DOUBLE PRECISION array, dimension (K,NX): the
C             state for the next one, or behind the step.
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            S, NX
      DOUBLE PRECISION   H(K), X(K,NX), W(K,NX,4), XS(K,NX)
      DOUBLE PRECISION   HS(K)
      INTEGER            I, L
C
      DO 10 L = 1, K
         HS(L) = H(L)
         IF ( S.LE.2 ) HS(L) = 0.5D0*H(L)
         IF ( S.EQ.4 ) HS(L) = H(L)/6.0D0
   10 CONTINUE
      IF ( S.LE.3 ) THEN
         DO 30 I = 1, NX
C$OMP SIMD
            DO 20 L = 1, K
               XS(L,I) = X(L,I) + HS(L)*W(L,I,S)
   20       CONTINUE
   30    CONTINUE
      ELSE
         DO 50 I = 1, NX
C$OMP SIMD
            DO 40 L = 1, K
               XS(L,I) = X(L,I) + HS(L)*( W(L,I,1) + 2.0D0*W(L,I,2)
     $                 + 2.0D0*W(L,I,3) + W(L,I,4) )
   40       CONTINUE
   50    CONTINUE
      END IF
      END
      SUBROUTINE GSLNH( NX, D, X, CHANGE, SIZE, GOES, XS )
C
C     PURPOSE
C     Before a turn of GSSTF, all lanes: the states beside those of the
C     run.
C
C     ARGUMENTS
C     NX      (input) INTEGER, the number of states.
C     D       (input) DOUBLE PRECISION, how far they are beside them, of
C             their sizes.
C     X, CHANGE (input) DOUBLE PRECISION arrays, dimension (K,NX), the
C             states and where to.
C     SIZE    (input) DOUBLE PRECISION array, dimension (K,NX), one by
C             the usual sizes of the states.
C     GOES    (input/output) DOUBLE PRECISION array, dimension (K), 1
C             for the lanes that take part; on exit those that CHANGE
C             does not lead away do no longer.
C     XS      (output) DOUBLE PRECISION array, dimension (K,NX).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   D, X(K,NX), CHANGE(K,NX), SIZE(K,NX), GOES(K),
     $                   XS(K,NX)
      DOUBLE PRECISION   S(K), F
      INTEGER            I, L
C
      DO 10 L = 1, K
         S(L) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD PRIVATE( F )
         DO 20 L = 1, K
            F = ABS( CHANGE(L,I) )*SIZE(L,I)
            S(L) = MAX( S(L), F )
   20    CONTINUE
   30 CONTINUE
C$OMP SIMD PRIVATE( F )
      DO 40 L = 1, K
         F = GOES(L)
         IF ( .NOT.( S(L).GT.0.0D0 ) ) F = 0.0D0
         IF ( .NOT.( S(L).LE.1.0D300 ) ) F = 0.0D0
         GOES(L) = F
         IF ( F.LE.0.5D0 ) S(L) = 1.0D0
         S(L) = F*D/S(L)
   40 CONTINUE
      DO 60 I = 1, NX
C$OMP SIMD PRIVATE( F )
         DO 50 L = 1, K
            F = X(L,I)
            IF ( GOES(L).GT.0.5D0 ) F = F + S(L)*CHANGE(L,I)
            XS(L,I) = F
   50    CONTINUE
   60 CONTINUE
      END
      SUBROUTINE GSLNI( NX, BASE, SIZE, CHANGE, GROWTH, AT )
C
C     PURPOSE
C     Behind it: the change of the rates, its largest entry beside the
C     usual sizes of the states and which one that is, all lanes.
C
C     ARGUMENTS
C     NX, SIZE as GSLNH.
C     BASE    (input) DOUBLE PRECISION array, dimension (K,NX), the
C             rates at the states of the run.
C     CHANGE  (input/output) DOUBLE PRECISION array, dimension (K,NX),
C             on entry the rates beside them, on exit less BASE.
C     GROWTH, AT (output) DOUBLE PRECISION arrays, dimension (K).
C
      IMPLICIT NONE
      INTEGER            K
      PARAMETER          ( K = 16 )
      INTEGER            NX
      DOUBLE PRECISION   BASE(K,NX), SIZE(K,NX), CHANGE(K,NX),
     $                   GROWTH(K), AT(K)
      DOUBLE PRECISION   F, G, B
      INTEGER            I, L
C
      DO 10 L = 1, K
         GROWTH(L) = 0.0D0
         AT(L)     = 1.0D0
   10 CONTINUE
      DO 30 I = 1, NX
         B = DBLE( I )
C$OMP SIMD PRIVATE( F, G )
         DO 20 L = 1, K
            CHANGE(L,I) = CHANGE(L,I) - BASE(L,I)
            F = ABS( CHANGE(L,I) )*SIZE(L,I)
            G = AT(L)
            IF ( F.GT.GROWTH(L) ) G = B
            AT(L) = G
            GROWTH(L) = MAX( GROWTH(L), F )
   20    CONTINUE
   30 CONTINUE
      END
