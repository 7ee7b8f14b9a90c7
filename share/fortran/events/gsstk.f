      SUBROUTINE GSSTK( N, M, K, A, LDA, H, LDH, F, G, ACT, UD, LAM,
     $                  HOLD, W, INFO )
C
C     PURPOSE
C     Accelerations where some ports are held (friction that sticks,
C     contact that rests): the rows of H behind the constraints that are
C     active count as constraints, the others do not.
C
C     ARGUMENTS
C     N       (input) INTEGER, the order of A.
C     M       (input) INTEGER, the number of constraints.
C     K       (input) INTEGER, the number of ports that may be held.
C     A, LDA, F as GSKKT.
C     H       (input/output) DOUBLE PRECISION array, dimension (LDH,N),
C             M + K rows; those that are not active are overwritten.
C     LDH     (input) INTEGER, LDH >= MAX(1,M+K).
C     G       (input/output) DOUBLE PRECISION array, dimension (M+K).
C     ACT     (input) INTEGER array, dimension (K), 1: held.
C     UD      (output) DOUBLE PRECISION array, dimension (N).
C     LAM     (output) DOUBLE PRECISION array, dimension (M).
C     HOLD    (output) DOUBLE PRECISION array, dimension (K): the effort
C             that holds each port, 0 where it is not held; -1D30 or
C             1D30 where none can, see METHOD.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (N*N + N*(M+K) + (M+K)**2 + 4*N + 8*(M+K)).
C     INFO    (output) INTEGER, as GSKKT; dependent rows (two held ports
C             of a mechanism with one freedom) are no failure: 0. Their
C             efforts are those of least norm.
C
C     METHOD
C     Where the rows are dependent, each port is looked at beside the
C     constraints alone: one whose row depends on theirs (a slider at
C     its dead centre) moves as they have it, whatever holds it.  It
C     does not count as held; its effort would be without bound, towards
C     rest.
C     Else a speed that is a port's alone has the acceleration 0, not
C     what rounding makes of it.
C
      IMPLICIT NONE
      INTEGER            N, M, K, LDA, LDH, ACT(*), INFO
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), F(*), G(*), UD(*), LAM(*),
     $                   HOLD(*), W(*)
      INTEGER            I, J, L, P, R, GSONE
      DOUBLE PRECISION   S, BIG
      EXTERNAL           GSKKT, GSFRE, GSONE
      PARAMETER          ( BIG = 1.0D30 )
C
C     -- the rows of the ports that are held, behind the constraints
      L = M
      DO 20 I = 1, K
         HOLD(I) = 0.0D0
         IF ( ACT(I).EQ.1 ) THEN
            L = L + 1
            HOLD(I) = 1.0D0
            DO 10 J = 1, N
               H(L,J) = H(M+I,J)
   10       CONTINUE
            G(L) = G(M+I)
         END IF
   20 CONTINUE
      CALL GSKKT( N, L, A, LDA, H, LDH, F, G, UD, W, W(M+K+1), INFO )
      IF ( INFO.EQ.0 ) THEN
         DO 25 I = M + 1, L
            J = GSONE( N, H(I,1), LDH )
            IF ( J.GT.0 .AND. .NOT.( ABS( G(I) ).GT.0.0D0 ) )
     $         UD(J) = 0.0D0
   25    CONTINUE
      END IF
      IF ( INFO.NE.2 .OR. L.EQ.M ) GO TO 60
C
C     -- ports that the constraints move or hold by themselves
      CALL GSKKT( N, M, A, LDA, H, LDH, F, G, UD, W, W(M+K+1), INFO )
      R = M
      IF ( INFO.EQ.1 ) R = L
      IF ( INFO.EQ.1 ) GO TO 55
      P = M
      DO 50 I = 1, K
         IF ( ACT(I).EQ.1 ) THEN
            P = P + 1
            CALL GSFRE( N, M, A, LDA, H, LDH, P, W, INFO )
            IF ( INFO.EQ.0 ) THEN
               S = -G(P)
               DO 30 J = 1, N
                  S = S + H(P,J)*UD(J)
   30          CONTINUE
               HOLD(I) = SIGN( BIG, -S )
            ELSE
               R = R + 1
               DO 40 J = 1, N
                  H(R,J) = H(P,J)
   40          CONTINUE
               G(R) = G(P)
            END IF
         END IF
   50 CONTINUE
   55 CONTINUE
      CALL GSKKT( N, R, A, LDA, H, LDH, F, G, UD, W, W(M+K+1), INFO )
      IF ( INFO.EQ.2 .AND. R.GT.M ) INFO = 0
C
C     -- multipliers and what holds
   60 CONTINUE
      DO 70 I = 1, M
         LAM(I) = W(I)
   70 CONTINUE
      L = M
      DO 80 I = 1, K
         IF ( ABS( HOLD(I) ).LT.BIG .AND. ACT(I).EQ.1 ) THEN
            L = L + 1
            HOLD(I) = W(L)
         END IF
   80 CONTINUE
      END
      SUBROUTINE GSFRE( N, M, A, LDA, H, LDH, P, W, FREE )
C
C     PURPOSE
C     Whether an effort along row P of H can change a speed that the
C     first M rows leave free.
C
C     ARGUMENTS
C     N, M, A, LDA, H, LDH as GSSTK.
C     P       (input) INTEGER, the row.
C     W       (workspace) as GSSTK.
C     FREE    (output) INTEGER, 1 if it can, 0 if not.
C
C     METHOD
C     The acceleration under a unit effort, with and without the
C     constraints; 0 where the square root of the ratio of their
C     energies is below 1D-10, ten times the tolerance of GSKKT.  Where
C     A is singular by itself, that of the row alone is one with the
C     largest mass.
C
      IMPLICIT NONE
      INTEGER            N, M, LDA, LDH, P, FREE
      DOUBLE PRECISION   A(LDA,*), H(LDH,*), W(*)
      DOUBLE PRECISION   GSEPS, E, S, BIG
      INTEGER            I, J, IG, IL, IU, IF, IW, JOB, INFO
      EXTERNAL           GSEPS, GSKKT
C
      IF = 1
      IU = IF + N
      IG = IU + N
      IL = IG + M
      IW = IL + M
      BIG = 0.0D0
      S   = 0.0D0
      DO 10 J = 1, N
         W(IF+J-1) = H(P,J)
         BIG = MAX( BIG, A(J,J) )
         S = S + 0.5D0*H(P,J)**2
   10 CONTINUE
      DO 20 I = 1, M
         W(IG+I-1) = 0.0D0
   20 CONTINUE
      FREE = 1
      S = S/BIG
      DO 50 JOB = 0, 1
         CALL GSKKT( N, M*JOB, A, LDA, H, LDH, W(IF), W(IG), W(IU),
     $               W(IL), W(IW), INFO )
         IF ( INFO.EQ.1 .AND. JOB.EQ.0 ) GO TO 50
         IF ( INFO.EQ.1 ) RETURN
         E = 0.0D0
         DO 40 J = 1, N
            E = E + 0.5D0*A(J,J)*W(IU+J-1)**2
            DO 30 I = J + 1, N
               E = E + A(I,J)*W(IU+I-1)*W(IU+J-1)
   30       CONTINUE
   40    CONTINUE
         IF ( JOB.EQ.0 ) S = E
   50 CONTINUE
      IF ( SQRT( MAX( 0.0D0, E ) ).LE.5.0D5*GSEPS()*SQRT( S ) ) FREE = 0
      END
      INTEGER FUNCTION GSONE( N, ROW, LDR )
C
C     PURPOSE
C     Which entry of a row is not 0; 0: none, or several.
C
C     ARGUMENTS
C     N       (input) INTEGER, their number.
C     ROW     (input) DOUBLE PRECISION array, dimension (LDR,N).
C
      IMPLICIT NONE
      INTEGER            N, LDR
      DOUBLE PRECISION   ROW(LDR,*)
      INTEGER            J, MANY
C
      GSONE = 0
      MANY = 0
      DO 10 J = 1, N
         IF ( ABS( ROW(1,J) ).GT.0.0D0 ) THEN
            MANY = MANY + 1
            GSONE = J
         END IF
   10 CONTINUE
      IF ( MANY.GT.1 ) GSONE = 0
      END
