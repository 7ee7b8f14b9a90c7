      SUBROUTINE GSSPJ( CON, TAN, COP, T, NX, NQ, NU, NLAM, NS, ISET,
     $                  NP, NC, COL, X, CST, W, IW, INFO )
C
C     PURPOSE
C     The derivatives S of states by parameters, behind the states as in
C     GSSEN, onto the derivatives of the constraints:
C        DP*SQ + dphi/dp = 0,  HC*SU + DV*SQ + d(HC*U + PHIT)/dp = 0,
C     and Euler parameters keep their norm: Q'*SQ = 0.
C
C     ARGUMENTS
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ), called if NLAM > 0.
C     TAN     (external) <NAME>_TAN( T, X, CST, DP, LDP, DV, LDV ),
C             called if NLAM > 0.
C     COP     (external) <NAME>_COP( T, X, CST, PP, LDPP, PV, LDPV ),
C             called if NLAM > 0.
C     T       (input) DOUBLE PRECISION, the time [s].
C     NX, NQ, NU, NLAM (input) INTEGER, the numbers of states,
C             coordinates, speeds and constraints.
C     NS      (input) INTEGER, the number of sets of Euler parameters.
C     ISET    (input) INTEGER array, dimension (4,NS): their places.
C     NP, NC, COL, X  as in GSSEN; of X (input/output) S is moved, by
C             the least squares of its coordinates, then of its speeds.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     W       (workspace) DOUBLE PRECISION array, dimension (
C             (NLAM+NS)*(NQ+NLAM+NS+NC) + NLAM*(NQ+NU+2*NP+3)).
C     IW      (workspace) INTEGER array, dimension (NLAM+NS).
C     INFO    (output) INTEGER, 0; < 0 as CON; 9 where the constraints
C             have lost rank.
C
      IMPLICIT NONE
      EXTERNAL           CON, TAN, COP
      INTEGER            NX, NQ, NU, NLAM, NS, ISET(4,*), NP, NC,
     $                   COL(*), IW(*), INFO
      DOUBLE PRECISION   T, X(NX,*), CST(*), W(*)
      EXTERNAL           GSSPL
      INTEGER            N, ID, IG, IR, IV, IH, IP, IQ, IF, I, J, K
C
C     -- rows by coordinates, their squares, right sides; rates by
C        coordinates, by speeds; by parameters; what CON leaves
      N  = NLAM + NS
      ID = 1
      IG = ID + N*NQ
      IR = IG + N*N
      IV = IR + N*NC
      IH = IV + NLAM*NQ
      IP = IH + NLAM*NU
      IQ = IP + NLAM*NP
      IF = IQ + NLAM*NP
      INFO = 0
      DO 10 I = ID, IG - 1
         W(I) = 0.0D0
   10 CONTINUE
      IF ( NLAM.GT.0 ) THEN
         CALL CON( T, X, X(NQ+1,1), CST, W(IF), W(IF+NLAM), W(IH), NLAM,
     $             W(IF+2*NLAM), INFO )
         IF ( INFO.EQ.2 ) INFO = 9
         IF ( INFO.NE.0 ) RETURN
         CALL TAN( T, X, CST, W(ID), N, W(IV), NLAM )
         CALL COP( T, X, CST, W(IP), NLAM, W(IQ), NLAM )
      END IF
      DO 30 K = 1, NS
         DO 20 J = 1, 4
            W(ID+NLAM+K-1+N*(ISET(J,K)-1)) = X(ISET(J,K),1)
   20    CONTINUE
   30 CONTINUE
      DO 50 K = 1, NC
         DO 40 I = 1, N
            W(IR+I-1+N*(K-1)) = 0.0D0
            IF ( I.LE.NLAM .AND. COL(K).GT.0 )
     $         W(IR+I-1+N*(K-1)) = W(IP+I-1+NLAM*(COL(K)-1))
   40    CONTINUE
   50 CONTINUE
      CALL GSSPL( N, NQ, NC, W(ID), N, X(1,2), NX, W(IR), N, W(IG), IW,
     $            INFO )
      IF ( INFO.NE.0 .OR. NLAM.EQ.0 ) RETURN
C
C     -- speeds
      DO 80 K = 1, NC
         DO 70 I = 1, NLAM
            IF = IR + I - 1 + NLAM*(K-1)
            W(IF) = 0.0D0
            IF ( COL(K).GT.0 ) W(IF) = W(IQ+I-1+NLAM*(COL(K)-1))
            DO 60 J = 1, NQ
               W(IF) = W(IF) + W(IV+I-1+NLAM*(J-1))*X(J,K+1)
   60       CONTINUE
   70    CONTINUE
   80 CONTINUE
      CALL GSSPL( NLAM, NU, NC, W(IH), NLAM, X(NQ+1,2), NX, W(IR), NLAM,
     $            W(IG), IW, INFO )
      END
      SUBROUTINE GSSPL( M, N, NC, D, LDD, S, LDS, R, LDR, G, IW, INFO )
C
C     PURPOSE
C     S is moved by the least squares onto D*S + R = 0, rows of D that
C     are zero apart; part of GSSPJ.
C
C     ARGUMENTS
C     M, N, NC (input) INTEGER: D is M by N, S N by NC, R M by NC.
C     D       (input) DOUBLE PRECISION array, dimension (LDD,N).
C     S       (input/output) DOUBLE PRECISION array, dimension (LDS,NC).
C     R       (input) DOUBLE PRECISION array, dimension (LDR,NC);
C             overwritten.
C     G       (workspace) DOUBLE PRECISION array, dimension (M,M).
C     IW      (workspace) INTEGER array, dimension (M).
C     INFO    (output) INTEGER, 0, or 9: the rows are dependent.
C
      IMPLICIT NONE
      INTEGER            M, N, NC, LDD, LDS, LDR, IW(*), INFO
      DOUBLE PRECISION   D(LDD,*), S(LDS,*), R(LDR,*), G(M,*)
      EXTERNAL           GSLEQ
      INTEGER            I, J, K, L
C
      DO 60 I = 1, M
         DO 20 J = 1, M
            G(I,J) = 0.0D0
            DO 10 K = 1, N
               G(I,J) = G(I,J) + D(I,K)*D(J,K)
   10       CONTINUE
   20    CONTINUE
         DO 50 K = 1, NC
            R(I,K) = -R(I,K)
            DO 30 J = 1, N
               R(I,K) = R(I,K) - D(I,J)*S(J,K)
   30       CONTINUE
            IF ( G(I,I).LE.0.0D0 ) R(I,K) = 0.0D0
   50    CONTINUE
         IF ( G(I,I).LE.0.0D0 ) G(I,I) = 1.0D0
   60 CONTINUE
      L = M
      K = M
      J = LDR
      CALL GSLEQ( L, NC, G, K, R, J, IW, INFO )
      IF ( INFO.NE.0 ) INFO = 9
      IF ( INFO.NE.0 ) RETURN
      DO 90 K = 1, NC
         DO 80 I = 1, N
            DO 70 J = 1, M
               S(I,K) = S(I,K) + D(J,I)*R(J,K)
   70       CONTINUE
   80    CONTINUE
   90 CONTINUE
      END
