      SUBROUTINE GSIPB( NQ, NU, NLAM, NH, NC, K, KIND, MODE, MA, S, SD,
     $                  PRM, X, UA, ROW, A, H, PHIT, C, P, UD, IW, R,
     $                  HIT, INFO )
C
C     PURPOSE
C     The derivatives of what happens at an event (GSRST), as far as it
C     is no impact; else the impulses, for GSIPC.
C
C     ARGUMENTS
C     NQ, NU, NLAM, NH (input) INTEGER, the numbers of coordinates,
C             speeds, constraints and ports.
C     NC      (input) INTEGER, the number of columns of R.
C     K       (input) INTEGER, which event: see L of GSRST.
C     KIND, MODE, S, SD, PRM (input) as GSRST, before it.
C     MA      (input) INTEGER array, dimension (NH), the modes and
C     UA      (input) DOUBLE PRECISION array, dimension (NU), the speeds
C             that it has left.
C     X       (input) DOUBLE PRECISION array, NQ coordinates and NU
C             speeds before.
C     ROW     (input) DOUBLE PRECISION array, dimension (NH,NU): SD is
C             ROW*U.
C     A       (input) DOUBLE PRECISION array, dimension (NU,NU), the mass
C             matrix.
C     H, PHIT (input) DOUBLE PRECISION arrays, dimensions (NLAM,NU),
C             (NLAM): the constraints are H*U + PHIT = 0.
C     C       (workspace) DOUBLE PRECISION array, dimension (N,N), N =
C             NU + NLAM + NH.
C     P       (output) DOUBLE PRECISION array, dimension (N): the
C             impulses of the constraints and of the ports.
C     UD      (output) DOUBLE PRECISION array, dimension (NU): the jump
C             of the speeds.
C     IW      (workspace) INTEGER array, dimension (N).
C     R       (output) DOUBLE PRECISION array, dimension (NU,NC): the
C             derivatives where speeds do not jump.
C     HIT     (output) INTEGER, -1: they do not jump; 0: they do; else
C             the port that is hit.
C     INFO    (output) INTEGER, 0, or 2: the rows are dependent.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NLAM, NH, NC, K, KIND(*), MODE(*),
     $                   MA(*), IW(*), HIT, INFO
      DOUBLE PRECISION   S(*), SD(*), PRM(4,*), X(*), UA(*), ROW(NH,*),
     $                   A(NU,*), H(NLAM,*), PHIT(*), C(NU+NLAM+NH,*),
     $                   P(*), UD(*), R(NU,*)
      EXTERNAL           GSIPK, GSIPA, GSLEQ
      INTEGER            GSIPA, N, M, I, J, L
C
      INFO = 0
      HIT  = -1
      DO 20 J = 1, NC
         DO 10 I = 1, NU
            R(I,J) = 0.0D0
   10    CONTINUE
         IF ( J.GT.NQ .AND. J.LE.NQ + NU ) R(J-NQ,J) = 1.0D0
   20 CONTINUE
      IF ( K.EQ.0 ) RETURN
      IF ( K.GT.0 ) THEN
         IF ( KIND(K).EQ.1 .OR. MODE(K).NE.0 ) RETURN
         I = -1
         IF ( PRM(2,K) - S(K).LT.S(K) - PRM(1,K) ) I = 1
         IF ( DBLE( I )*SD(K).LE.0.0D0 ) RETURN
      END IF
      M = NLAM
      DO 30 I = 1, NH
         M = M + GSIPA( I, K, KIND, MA )
   30 CONTINUE
      IF ( M.EQ.0 ) RETURN
      HIT = MAX( 0, K )
C
C     -- impulses
      N = NU + NLAM + NH
      CALL GSIPK( NU, NLAM, NH, K, KIND, MA, ROW, A, H, C )
      DO 40 I = 1, N
         P(I) = 0.0D0
   40 CONTINUE
      DO 60 I = NU + 1, N
         IF ( I.LE.NU + NLAM ) P(I) = -PHIT(I-NU)
         IF ( I.EQ.NU + NLAM + HIT .AND. HIT.GT.0 ) THEN
            IF ( MA(HIT).EQ.0 ) P(I) = -PRM(3,HIT)*SD(HIT)
         END IF
         DO 50 J = 1, NU
            P(I) = P(I) - C(I,J)*X(NQ+J)
   50    CONTINUE
   60 CONTINUE
      L = N
      J = N
      CALL GSLEQ( N, 1, C, L, P, J, IW, INFO )
      IF ( INFO.NE.0 ) INFO = 2
      DO 70 I = 1, NLAM + NH
         P(I) = P(NU+I)
   70 CONTINUE
      DO 80 I = 1, NU
         UD(I) = UA(I) - X(NQ+I)
   80 CONTINUE
      END
      SUBROUTINE GSIPC( NQ, NU, NLAM, NXV, NH, NP, HIT, K, KIND, MA, SD,
     $                  PRM, ROW, A, H, D, E, C, B, IW, R, INFO )
C
C     PURPOSE
C     The derivatives of an impact: of the speeds after it.
C
C     ARGUMENTS
C     As GSIPB, and
C     NXV     (input) INTEGER, how many columns of D are ahead of those
C             by parameters; NP (input) INTEGER, how many these are.
C     HIT     (input) INTEGER, from GSIPB.
C     D       (input) DOUBLE PRECISION array, dimension (6*NH,NXV+NP+1):
C             of each port the derivatives of S, SD, PRM(1..4) by
C             coordinates, speeds, ..., parameters, time.
C     E       (input) DOUBLE PRECISION array, dimension (N,NQ+NP+1): those
C             of A*UD - H'*P - ROW'*P, H*UA + PHIT and ROW*UA by
C             coordinates, parameters, time at fixed UD, UA, P.
C     C, B    (workspace) DOUBLE PRECISION arrays, dimensions (N,N),
C             (N,NQ+NU+NP+1).
C     R       (output) DOUBLE PRECISION array, dimension (NU,
C             NQ+NU+NP+1): by coordinates, speeds before, parameters,
C             time.
C
C     METHOD
C     With the rows W of the constraints and of the ports that take part
C     A*(UA - U) = W'*P, W*UA = c, differentiated; c is -e times the
C     speed of the port that is hit, -PHIT of the constraints, 0 of the
C     others.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NLAM, NXV, NH, NP, HIT, K, KIND(*),
     $                   MA(*), IW(*), INFO
      DOUBLE PRECISION   SD(*), PRM(4,*), ROW(*), A(NU,*), H(*),
     $                   D(6*NH,*), E(NU+NLAM+NH,*), C(*),
     $                   B(NU+NLAM+NH,*), R(NU,*)
      EXTERNAL           GSIPK, GSIPA, GSLEQ
      INTEGER            GSIPA, N, NC, I, J, L, JD, JE
C
      N  = NU + NLAM + NH
      NC = NQ + NU + NP + 1
      DO 30 J = 1, NC
         JE = J
         JD = J
         IF ( J.GT.NQ + NU ) THEN
            JE = J - NU
            JD = J - NQ - NU + NXV
         END IF
         DO 10 I = 1, N
            B(I,J) = 0.0D0
            IF ( J.LE.NQ .OR. J.GT.NQ + NU ) THEN
               B(I,J) = -E(I,JE)
            ELSE IF ( I.LE.NU ) THEN
               B(I,J) = A(I,J-NQ)
            END IF
   10    CONTINUE
         DO 20 I = 1, NH
            IF ( GSIPA( I, K, KIND, MA ).EQ.0 ) B(NU+NLAM+I,J) = 0.0D0
   20    CONTINUE
         IF ( HIT.GT.0 ) THEN
            L = 6*( HIT - 1 )
            IF ( MA(HIT).EQ.0 ) B(NU+NLAM+HIT,J) = B(NU+NLAM+HIT,J)
     $         - PRM(3,HIT)*D(L+2,JD) - SD(HIT)*D(L+5,JD)
         END IF
   30 CONTINUE
      CALL GSIPK( NU, NLAM, NH, K, KIND, MA, ROW, A, H, C )
      L = N
      J = N
      CALL GSLEQ( N, NC, C, L, B, J, IW, INFO )
      IF ( INFO.NE.0 ) INFO = 2
      IF ( INFO.NE.0 ) RETURN
      DO 50 J = 1, NC
         DO 40 I = 1, NU
            R(I,J) = B(I,J)
   40    CONTINUE
   50 CONTINUE
      END
      SUBROUTINE GSIPK( NU, NLAM, NH, K, KIND, MA, ROW, A, H, C )
C
C     PURPOSE
C     The matrix C of the impact of GSIPB; a port that does not take part
C     has no impulse.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NH, K, KIND(*), MA(*)
      DOUBLE PRECISION   ROW(NH,*), A(NU,*), H(NLAM,*),
     $                   C(NU+NLAM+NH,*)
      EXTERNAL           GSIPA
      INTEGER            GSIPA, I, J, L
C
      DO 20 J = 1, NU + NLAM + NH
         DO 10 I = 1, NU + NLAM + NH
            C(I,J) = 0.0D0
            IF ( I.LE.NU .AND. J.LE.NU ) C(I,J) = A(I,J)
   10    CONTINUE
   20 CONTINUE
      DO 50 I = 1, NLAM
         DO 40 J = 1, NU
            C(NU+I,J) = H(I,J)
            C(J,NU+I) = -H(I,J)
   40    CONTINUE
   50 CONTINUE
      DO 70 I = 1, NH
         L = NU + NLAM + I
         IF ( GSIPA( I, K, KIND, MA ).EQ.0 ) THEN
            C(L,L) = 1.0D0
         ELSE
            DO 60 J = 1, NU
               C(L,J) = ROW(I,J)
               C(J,L) = -ROW(I,J)
   60       CONTINUE
         END IF
   70 CONTINUE
      END
      INTEGER FUNCTION GSIPA( I, K, KIND, MA )
C
C     PURPOSE
C     1 if port I takes part in the impact K of GSIPB, else 0.
C
      IMPLICIT NONE
      INTEGER            I, K, KIND(*), MA(*)
      GSIPA = 0
      IF ( I.EQ.K ) GSIPA = 1
      IF ( KIND(I).EQ.2 .AND. MA(I).NE.0 ) GSIPA = 1
      IF ( KIND(I).EQ.1 .AND. MA(I).EQ.0 .AND. K.LT.0 ) GSIPA = 1
      END
