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
      SUBROUTINE GSLNT( K, T, C, H, TS )
C
C     PURPOSE
C     The times T + C*H of a stage for K lanes, TS.
C
      IMPLICIT NONE
      INTEGER            K
      DOUBLE PRECISION   T(K), C, H(K), TS(K)
      INTEGER            L
C
C$OMP SIMD
      DO 10 L = 1, K
         TS(L) = T(L) + C*H(L)
   10 CONTINUE
      END
      SUBROUTINE GSLNE( K, NX, H, X, W, RTOL, ATOL, C, XN, ERR, S1, S2 )
C
C     PURPOSE
C     The end of a step of GSDP8 for K lanes: the states and the
C     estimated errors.
C
C     ARGUMENTS
C     K, NX   (input) INTEGER, the numbers of lanes and of states.
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
      INTEGER            K, NX
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
      SUBROUTINE GSLNB( K, NX, X, W, XS, RTOL, ATOL, A, B )
C
C     PURPOSE
C     The sums A and B of GSSTE for K lanes: at the states X of a step's
C     end, whose right-hand sides are W(:,:,1), XS the states and
C     W(:,:,12) the right-hand sides of its last stage.
C
C     ARGUMENTS
C     Arrays of lanes as GSLNE; A, B (output) of dimension (K).
C
      IMPLICIT NONE
      INTEGER            K, NX
      DOUBLE PRECISION   X(K,NX), W(K,NX,12), XS(K,NX), RTOL, ATOL(NX),
     $                   A(K), B(K)
      INTEGER            I, L
      DOUBLE PRECISION   S, P, Q
C
      DO 10 L = 1, K
         A(L) = 0.0D0
         B(L) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NX
C$OMP SIMD PRIVATE( S, P, Q )
         DO 20 L = 1, K
            S = ATOL(I) + RTOL*ABS( X(L,I) )
            IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D308
            P = ( W(L,I,1) - W(L,I,12) )/S
            Q = ( X(L,I) - XS(L,I) )/S
            A(L) = A(L) + P**2
            B(L) = B(L) + Q**2
   20    CONTINUE
   30 CONTINUE
      END
      SUBROUTINE GSLN4( S, M, H, X, W, XS )
C
C     PURPOSE
C     The states of GSRK4 for many lanes, after its S-th right-hand
C     side.
C
C     ARGUMENTS
C     S       (input) INTEGER, 1 to 4.
C     M       (input) INTEGER, the number of numbers, see GSLNS.
C     H, X    (input) as GSLNS.
C     W       (input/output) DOUBLE PRECISION array, dimension (M,2):
C             on entry column 1 (S = 1) or 2 is the right-hand side.
C     XS      (output) DOUBLE PRECISION array, dimension (M): the state
C             for the next one, or behind the step.
C
      IMPLICIT NONE
      INTEGER            S, M
      DOUBLE PRECISION   H(M), X(M), W(M,2), XS(M)
      DOUBLE PRECISION   H2, H6
      INTEGER            I
C
      IF ( S.EQ.1 ) THEN
C$OMP SIMD PRIVATE( H2 )
         DO 10 I = 1, M
            H2 = 0.5D0*H(I)
            XS(I) = X(I) + H2*W(I,1)
   10    CONTINUE
      ELSE IF ( S.EQ.2 ) THEN
C$OMP SIMD PRIVATE( H2 )
         DO 20 I = 1, M
            H2 = 0.5D0*H(I)
            XS(I)  = X(I) + H2*W(I,2)
            W(I,1) = W(I,1) + 2.0D0*W(I,2)
   20    CONTINUE
      ELSE IF ( S.EQ.3 ) THEN
C$OMP SIMD
         DO 30 I = 1, M
            XS(I)  = X(I) + H(I)*W(I,2)
            W(I,1) = W(I,1) + 2.0D0*W(I,2)
   30    CONTINUE
      ELSE
C$OMP SIMD PRIVATE( H6 )
         DO 40 I = 1, M
            H6 = H(I)/6.0D0
            XS(I) = X(I) + H6*( W(I,1) + W(I,2) )
   40    CONTINUE
      END IF
      END
