      SUBROUTINE GSRST( N, M, K, L, KIND, MODE, S, SD, PRM, HOLD, A,
     $                  LDA, H, LDH, PHIT, U, W, INFO )
C
C     PURPOSE
C     What happens at event L: modes change, speeds jump at an impact.
C
C     ARGUMENTS
C     N, M    (input) INTEGER, the numbers of speeds and constraints.
C     K, KIND, S, SD, PRM, HOLD as GSEVT.
C     L       (input) INTEGER, the port whose event it is; 0: the modes
C             at the start are found; -1: ports that stick come to rest.
C     MODE    (input/output) INTEGER array, dimension (K).
C     A       (input) DOUBLE PRECISION array, dimension (LDA,N), the
C             mass matrix.
C     H       (input) DOUBLE PRECISION array, dimension (LDH,N): the
C             Jacobian of the constraints, below it the rows of the
C             ports (SD = row*U).
C     PHIT    (input) DOUBLE PRECISION array, dimension (M): the
C             constraints are H*U + PHIT = 0.
C     U       (input/output) DOUBLE PRECISION array, dimension (N).
C     W       (workspace) DOUBLE PRECISION array, dimension (2*N*N
C             + 2*N*(M+K) + (M+K)**2 + 4*N + 9*(M+K)).
C     INFO    (output) INTEGER, 0; 1: singular mass matrix.
C
C     METHOD
C     Friction that comes to rest sticks, as one that starts slower than
C     1e-9*PRM(2,*) does; one whose holding force passes its limit
C     slides to where it is pushed.  What sticks at last comes to rest
C     exactly (L = -1), not before: where the loops stop a port by their
C     geometry, as at a dead centre, the rest of the machine would have
C     to stop for it.
C     At a stop U+ = U + inv(A)*H'*p, so that the port's speed becomes
C     -e times itself, (1) without one where the rebound would be slower
C     than PRM(4): then the stop stays in contact, as one does against
C     which a port at rest is pushed. Constraints and stops
C     in contact take part in the impact and only push; friction does
C     not: no finite force resists an impulse. Then friction slides
C     where its port moves.
C
      IMPLICIT NONE
      INTEGER            N, M, K, L, KIND(*), MODE(*), LDA, LDH, INFO
      DOUBLE PRECISION   S(*), SD(*), PRM(4,*), HOLD(*), A(LDA,*),
     $                   H(LDH,*), PHIT(*), U(*), W(*)
      INTEGER            I
      DOUBLE PRECISION   E, GSATE, GSTVL
      EXTERNAL           GSATE, GSIMP, GSTVL
C
      INFO = 0
      IF ( L.EQ.0 ) THEN
         DO 10 I = 1, K
            MODE(I) = 0
            E = 1.0D-9*PRM(2,I)
            IF ( KIND(I).EQ.1 .AND. SD(I).GT.E ) MODE(I) = 1
            IF ( KIND(I).EQ.1 .AND. SD(I).LT.-E ) MODE(I) = -1
            IF ( KIND(I).EQ.2 .AND. ABS( SD(I) ).LE.PRM(4,I) ) THEN
               E = GSATE( S(I), PRM(1,I) )
               IF ( S(I).GE.PRM(2,I) - E ) MODE(I) = 1
               IF ( S(I).LE.PRM(1,I) + E ) MODE(I) = -1
            END IF
   10    CONTINUE
      ELSE IF ( L.LT.0 ) THEN
         CALL GSIMP( N, M, K, 0, 0.0D0, KIND, MODE, A, LDA, H, LDH,
     $               PHIT, U, W, INFO )
      ELSE IF ( KIND(L).EQ.1 .AND. MODE(L).NE.0 ) THEN
         MODE(L) = 0
      ELSE IF ( KIND(L).EQ.1 ) THEN
         MODE(L) = 1
         IF ( HOLD(L).GT.0.0D0 ) MODE(L) = -1
      ELSE IF ( MODE(L).NE.0 ) THEN
         MODE(L) = 0
      ELSE
         I = -1
         IF ( PRM(2,L) - S(L).LT.S(L) - PRM(1,L) ) I = 1
         E = 1.0D-9*GSTVL( S(L), PRM(1,L) )
         IF ( ABS( SD(L) ).LE.1.0D-9*PRM(4,L) .AND.
     $        MIN( PRM(2,L) - S(L), S(L) - PRM(1,L) ).LE.E ) MODE(L) = I
         IF ( DBLE( I )*SD(L).LE.0.0D0 .OR. MODE(L).NE.0 ) RETURN
         E = PRM(3,L)
         IF ( E*ABS( SD(L) ).LE.PRM(4,L) ) THEN
            E = 0.0D0
            MODE(L) = I
         END IF
         CALL GSIMP( N, M, K, L, -E*SD(L), KIND, MODE, A, LDA, H, LDH,
     $               PHIT, U, W, INFO )
      END IF
      END
      DOUBLE PRECISION FUNCTION GSATE( S, PRM )
C
C     PURPOSE
C     How near to an end of a stop a port at rest is at it: by rounding
C     errors, and by the way that a rebound that is none makes in 1D-9 of
C     a second; never more than 1D-9 of its travel.
C
C     ARGUMENTS
C     S       (input) DOUBLE PRECISION, the position.
C     PRM     (input) DOUBLE PRECISION array, dimension (4), of the stop
C             as GSEVT has it.
C
      IMPLICIT NONE
      DOUBLE PRECISION   S, PRM(4), GSTVL
      EXTERNAL           GSTVL
C
      GSATE = GSTVL( S, PRM )
      GSATE = MIN( 1.0D-9*GSATE, 1.0D-9*PRM(4) + 1.0D-12*ABS( S ) )
      END
      SUBROUTINE GSIMP( N, M, K, L, V, KIND, MODE, A, LDA, H, LDH, PHIT,
     $                  U, W, INFO )
C
C     PURPOSE
C     The impulse of GSRST after which the speed of port L is V (L = 0:
C     of none), that of the ports in contact 0, and the constraints are
C     fulfilled. L = 0: ports that stick are at rest as well.  A speed
C     that is such a port's alone is 0 without rounding errors, unless
C     rows depend on each other.
C
      IMPLICIT NONE
      INTEGER            N, M, K, L, KIND(*), MODE(*), LDA, LDH, INFO
      DOUBLE PRECISION   V, A(LDA,*), H(LDH,*), PHIT(*), U(*), W(*)
      INTEGER            I, J, R, T, ND, NR, IA, IH, IF, IG, ID, IL, IW,
     $                   BAD, GSONE
      DOUBLE PRECISION   X, SIZE
      LOGICAL            FULL
      EXTERNAL           GSKKT, GSONE
C
      ND = N
      NR = M + K
      IA = 1
      IH = IA + ND*N
      IF = IH + NR*N
      IG = IF + N
      ID = IG + NR
      IL = ID + N
      IW = IL + NR
   10 CONTINUE
C
C     -- rows that take part: W(IG) what they must change
      R = 0
      DO 40 I = 1, NR
         T = 0
         X = 0.0D0
         IF ( I.LE.M ) THEN
            T = 1
            X = -PHIT(I)
         ELSE IF ( I-M.EQ.L ) THEN
            T = 1
            X = V
         ELSE IF ( KIND(I-M).EQ.2 .AND. MODE(I-M).NE.0 ) THEN
            T = 1
         ELSE IF ( KIND(I-M).EQ.1 .AND. MODE(I-M).EQ.0 .AND. L.EQ.0 )
     $      THEN
            T = 1
         END IF
         IF ( T.EQ.1 ) THEN
            R = R + 1
            DO 30 J = 1, N
               W(IH+R-1+NR*(J-1)) = H(I,J)
               X = X - H(I,J)*U(J)
   30       CONTINUE
            W(IG+R-1) = X
         END IF
   40 CONTINUE
      IF ( R.EQ.0 ) GO TO 100
      DO 60 J = 1, N
         W(IF+J-1) = 0.0D0
         DO 50 I = 1, N
            W(IA+I-1+ND*(J-1)) = A(I,J)
   50    CONTINUE
   60 CONTINUE
      CALL GSKKT( N, R, W(IA), ND, W(IH), NR, W(IF), W(IG), W(ID),
     $            W(IL), W(IW), INFO )
      FULL = INFO.EQ.0
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.NE.0 ) RETURN
C
C     -- a stop in contact cannot pull
      BAD = 0
      IF ( L.GT.0 ) THEN
         R = M
         DO 70 I = 1, K
            IF ( I.EQ.L ) THEN
               R = R + 1
            ELSE IF ( KIND(I).EQ.2 .AND. MODE(I).NE.0 ) THEN
               R = R + 1
               IF ( DBLE( MODE(I) )*W(IL+R-1).GT.0.0D0 .AND. BAD.EQ.0 )
     $            BAD = I
            END IF
   70    CONTINUE
      END IF
      IF ( BAD.GT.0 ) THEN
         MODE(BAD) = 0
         GO TO 10
      END IF
      DO 80 J = 1, N
         U(J) = U(J) + W(ID+J-1)
   80 CONTINUE
      DO 90 I = 1, K
         J = GSONE( N, H(M+I,1), LDH )
         IF ( I.NE.L .AND. J.GT.0 .AND. FULL .AND. ( ( KIND(I).EQ.2
     $        .AND. MODE(I).NE.0 ) .OR. ( KIND(I).EQ.1 .AND.
     $        MODE(I).EQ.0 .AND. L.EQ.0 ) ) ) U(J) = 0.0D0
   90 CONTINUE
C
C     -- friction slides where its port moves
  100 CONTINUE
      IF ( L.EQ.0 ) RETURN
      DO 120 I = 1, K
         IF ( KIND(I).EQ.1 ) THEN
            X = 0.0D0
            SIZE = 0.0D0
            DO 110 J = 1, N
               X = X + H(M+I,J)*U(J)
               SIZE = SIZE + ABS( H(M+I,J)*U(J) )
     $                + ABS( H(M+I,J)*W(ID+J-1) )
  110       CONTINUE
            IF ( ABS( X ).GT.1.0D-10*SIZE ) THEN
               MODE(I) = 1
               IF ( X.LT.0.0D0 ) MODE(I) = -1
            END IF
         END IF
  120 CONTINUE
      END
