      SUBROUTINE GSHPJ( HLD, MAS, CON, T, X, V, CST, NQ, NU, NLAM, NH,
     $                  KIND, MODE, ROW, S, SD, PRM, A, H, PHIT, U, W,
     $                  INFO )
C
C     PURPOSE
C     A state is moved to where the ports that are held are held: stops
C     in contact to their ends, the speeds of all of them to 0.
C
C     ARGUMENTS
C     As in GSIPT and GSHLD, and
C     ROW, S, SD, PRM, A, H, PHIT, U (workspace) as there and in GSIPM.
C     INFO    (output) INTEGER, 0, or as CON and GSKKT; then X may have
C             been moved in part.
C
C     METHOD
C     As GSPRJ does with the loops: the nearest state in the metric of
C     the mass matrix, on the constraints as well, by two steps of
C     Newton for the coordinates (where the speeds are their rates) and
C     one for the speeds.  A port that is one of the speeds keeps both
C     by itself where there are no loops: X stays.
C
      IMPLICIT NONE
      EXTERNAL           HLD, MAS, CON
      INTEGER            NQ, NU, NLAM, NH, KIND(*), MODE(*), INFO
      DOUBLE PRECISION   T, X(*), V(*), CST(*), ROW(NH,*), S(*), SD(*),
     $                   PRM(4,*), A(*), H(*), PHIT(*), U(*), W(*)
      EXTERNAL           GSHPS, GSHPO
      INTEGER            K
      DOUBLE PRECISION   OFF, FAST
C
      INFO = 0
      CALL HLD( T, X, V, CST, ROW, NH, S, SD, PRM )
      CALL GSHPO( NU, NLAM, NH, KIND, MODE, ROW, S, SD, PRM, OFF, FAST )
      DO 10 K = 1, 2
         IF ( NQ.NE.NU .OR. OFF.LE.1.0D-14 ) GO TO 20
         CALL GSHPS( MAS, CON, 1, T, X, CST, NQ, NU, NLAM, NH, KIND,
     $               MODE, ROW, S, SD, PRM, A, H, PHIT, U, W, INFO )
         IF ( INFO.NE.0 ) RETURN
         CALL HLD( T, X, V, CST, ROW, NH, S, SD, PRM )
         CALL GSHPO( NU, NLAM, NH, KIND, MODE, ROW, S, SD, PRM, OFF,
     $               FAST )
         FAST = MAX( FAST, 1.0D0 )
   10 CONTINUE
   20 IF ( FAST.GT.1.0D-14 ) CALL GSHPS( MAS, CON, 2, T, X, CST, NQ, NU,
     $   NLAM, NH, KIND, MODE, ROW, S, SD, PRM, A, H, PHIT, U, W, INFO )
      END
      SUBROUTINE GSHPO( NU, NLAM, NH, KIND, MODE, ROW, S, SD, PRM, OFF,
     $                  FAST )
C
C     PURPOSE
C     How far ports that are held are from where they are held: OFF of
C     stops beside the way between their ends, FAST of speeds beside the
C     slowest rebound or Stribeck's speed; 0 where no held port has
C     other speeds or loops beside it.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NH, KIND(*), MODE(*)
      DOUBLE PRECISION   ROW(NH,*), S(*), SD(*), PRM(4,*), OFF, FAST
      INTEGER            I, J, N, LEAST
      DOUBLE PRECISION   GAP, SLOW, GSTVL
      EXTERNAL           GSTVL
C
      OFF  = 0.0D0
      FAST = 0.0D0
      LEAST = 0
      DO 20 I = 1, NH
         GAP = -1.0D0
         IF ( KIND(I).EQ.1 .AND. MODE(I).EQ.0 ) THEN
            GAP  = 0.0D0
            SLOW = PRM(2,I)
         ELSE IF ( KIND(I).EQ.2 .AND. MODE(I).NE.0 ) THEN
            GAP = PRM(1,I)
            IF ( MODE(I).GT.0 ) GAP = PRM(2,I)
            GAP = ABS( GAP - S(I) )/GSTVL( S(I), PRM(1,I) )
            SLOW = PRM(4,I)
         END IF
         IF ( GAP.GE.0.0D0 ) THEN
            N = 0
            DO 10 J = 1, NU
               IF ( ABS( ROW(I,J) ).GT.0.0D0 ) N = N + 1
   10       CONTINUE
            LEAST = MAX( LEAST, N )
            OFF  = MAX( OFF, GAP )
            FAST = MAX( FAST, ABS( SD(I) )/SLOW )
         END IF
   20 CONTINUE
      IF ( LEAST.GT.1 .OR. ( LEAST.GT.0 .AND. NLAM.GT.0 ) ) RETURN
      OFF  = 0.0D0
      FAST = 0.0D0
      END
      SUBROUTINE GSHPS( MAS, CON, JOB, T, X, CST, NQ, NU, NLAM, NH,
     $                  KIND, MODE, ROW, S, SD, PRM, A, H, PHIT, U, W,
     $                  INFO )
C
C     PURPOSE
C     One step of GSHPJ: the coordinates (JOB = 1), or the speeds (JOB =
C     2).  Arguments as there.
C
      IMPLICIT NONE
      EXTERNAL           MAS, CON
      INTEGER            JOB, NQ, NU, NLAM, NH, KIND(*), MODE(*), INFO
      DOUBLE PRECISION   T, X(*), CST(*), ROW(NH,*), S(*), SD(*),
     $                   PRM(4,*), A(*), H(NLAM+NH,*), PHIT(*), U(*),
     $                   W(*)
      EXTERNAL           GSIPM, GSKKT
      INTEGER            IG, IF, ID, IL, IW, I, J, L, M
      DOUBLE PRECISION   G
      LOGICAL            HELD
C
C     -- right side, forces, step, impulses
      M  = NLAM + NH
      IG = 1 + NQ + 2*NLAM
      IF = IG + M
      ID = IF + NU
      IL = ID + NU
      IW = IL + M
      CALL GSIPM( MAS, CON, T, X, CST, NQ, NU, NLAM, NH, ROW, A, H,
     $            PHIT, U, W, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NLAM
         G = -W(NQ+I)
         IF ( JOB.EQ.2 ) THEN
            G = -PHIT(I)
            DO 10 J = 1, NU
               G = G - H(I,J)*U(J)
   10       CONTINUE
         END IF
         W(IG+I-1) = G
   20 CONTINUE
      L = NLAM
      DO 40 I = 1, NH
         HELD = ( KIND(I).EQ.2 .AND. MODE(I).NE.0 ) .OR.
     $          ( KIND(I).EQ.1 .AND. MODE(I).EQ.0 .AND. JOB.EQ.2 )
         IF ( HELD ) THEN
            L = L + 1
            DO 30 J = 1, NU
               H(L,J) = H(NLAM+I,J)
   30       CONTINUE
            G = -SD(I)
            IF ( JOB.EQ.1 .AND. MODE(I).GT.0 ) G = PRM(2,I) - S(I)
            IF ( JOB.EQ.1 .AND. MODE(I).LT.0 ) G = PRM(1,I) - S(I)
            W(IG+L-1) = G
         END IF
   40 CONTINUE
      DO 50 J = 1, NU
         W(IF+J-1) = 0.0D0
   50 CONTINUE
      CALL GSKKT( NU, L, A, NU, H, M, W(IF), W(IG), W(ID), W(IL), W(IW),
     $            INFO )
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.NE.0 ) RETURN
      L = 0
      IF ( JOB.EQ.2 ) L = NQ
      DO 60 J = 1, NU
         X(L+J) = X(L+J) + W(ID+J-1)
   60 CONTINUE
      END
      SUBROUTINE GSEVO( RST, METHOD, T, X, NX, IP, RP, CST, V, RTOL,
     $                  ATOL, MOVED )
C
C     PURPOSE
C     Behind a step: X is moved to where the ports that are held are
C     held (GSHPJ), by no more than the errors of steps.
C
C     ARGUMENTS
C     RST     (external) as GSRES.
C     METHOD  (input) INTEGER, 4: a step of GSRK4; else of a tolerance.
C     T       (input) DOUBLE PRECISION, the time [s].
C     X       (input/output) DOUBLE PRECISION array, dimension (NX).
C     NX      (input) INTEGER, the number of states.
C     IP, RP, CST as GSINP, IP(28) > 0; V (input) its inputs at T.
C     RTOL, ATOL (input) DOUBLE PRECISION and array of dimension (NX),
C             tolerances.
C     MOVED   (output) INTEGER, 1 if X was moved, else 0.
C
      IMPLICIT NONE
      EXTERNAL           RST
      INTEGER            METHOD, NX, IP(*), MOVED
      DOUBLE PRECISION   T, X(NX), RP(*), CST(*), V(*), RTOL, ATOL(NX)
      INTEGER            IE, NE, KZ, I, HELD, INFO
      DOUBLE PRECISION   MOST
C
      MOVED = 0
      IE = IP(28) - 1
      NE = IP(IE+1)
      KZ = IP(29) - 1 + 5*NE + NX
      HELD = 0
      DO 10 I = 1, NE
         IF ( IP(IE+10+2*NE+I).EQ.1 .AND. IP(IE+10+I).EQ.0 ) HELD = 1
         IF ( IP(IE+10+2*NE+I).EQ.2 .AND. IP(IE+10+I).NE.0 ) HELD = 1
   10 CONTINUE
      IF ( HELD.EQ.0 ) RETURN
      DO 20 I = 1, NX
         RP(KZ+I) = X(I)
   20 CONTINUE
      CALL RST( T, X, V, IP(IE+11), -5, CST, INFO )
      DO 30 I = 1, NX
         MOST = 1.0D-3*( 1.0D0 + ABS( X(I) ) )
         IF ( METHOD.NE.4 ) MOST = 1.0D3*( ATOL(I) + RTOL*ABS( X(I) ) )
         IF ( ABS( X(I) - RP(KZ+I) ).GT.0.0D0 ) MOVED = 1
         IF ( .NOT.( ABS( X(I) - RP(KZ+I) ).LE.MOST ) ) INFO = 1
   30 CONTINUE
      IF ( INFO.EQ.0 ) RETURN
      MOVED = 0
      DO 40 I = 1, NX
         X(I) = RP(KZ+I)
   40 CONTINUE
      END
