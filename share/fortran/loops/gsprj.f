      SUBROUTINE GSPRJ( CON, MAS, KIN, T, X, NQ, NU, NLAM, QUASI, NS,
     $                  ISET, CST, RES, W, INFO )
C
C     PURPOSE
C     X is moved onto phi = 0 and HC*U + PHIT = 0 by the shortest way in
C     the metric of the mass matrix; Euler parameters get the norm 1.
C
C     ARGUMENTS
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ).
C     MAS     (external) <NAME>_MAS( T, Q, CST, M, LDM ).
C     KIN     (external) <NAME>_KIN( T, Q, U, CST, QDOT ), called if
C             QUASI = 1.
C     T       (input) DOUBLE PRECISION, the time [s].
C     X       (input/output) DOUBLE PRECISION array: NQ coordinates, NU
C             speeds; moved if INFO is 0.
C     NQ, NU, NLAM (input) INTEGER, the numbers of coordinates, speeds
C             and constraints.
C     QUASI   (input) INTEGER, 1 where the speeds are not the rates of
C             the coordinates, else 0.
C     NS      (input) INTEGER, the number of sets of Euler parameters.
C     ISET    (input) INTEGER array, dimension (4,NS): their places.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     RES     (output) DOUBLE PRECISION, the largest |phi| and error of
C             the norm of Euler parameters before [m or rad].
C     W       (workspace) DOUBLE PRECISION array, dimension (2*NU*NU +
C             2*NU*NLAM + NLAM*NLAM + 5*NU + 10*NLAM + 2*NQ).
C     INFO    (output) INTEGER
C             = 0: done; < 0: as CON; = 1: the mass matrix is singular;
C             = 3: no position with phi = 0 was found.
C
C     METHOD
C     Newton's method: M*DX = H'*LAM, H*DX = -phi (GSKKT), at most 50
C     steps, none longer than 0.5 rad or m, until |phi| is below 4
C     epsilon or falls no more (below 1.0D-11); above 1.0D-9 at the end
C     there is no such position.  Then one such step for the speeds.
C
      IMPLICIT NONE
      EXTERNAL           CON, MAS, KIN
      INTEGER            NQ, NU, NLAM, QUASI, NS, ISET(4,*), INFO
      DOUBLE PRECISION   T, X(*), CST(*), RES, W(*)
      EXTERNAL           GSNRM, GSPJQ, GSPJU
      INTEGER            IH, IP, IT, IG, IF, ID, IL, IQ, IU, IW, I
C
C     -- mass matrix, Jacobian, constraints, their rates, right sides,
C        step, multipliers, position, speeds
      IH = 1 + NU*NU
      IP = IH + NLAM*NU
      IT = IP + NLAM
      IG = IT + NLAM
      IF = IG + NLAM
      ID = IF + NU
      IL = ID + NU
      IQ = IL + NLAM
      IU = IQ + NQ
      IW = IU + NU
      INFO = 0
      RES  = 0.0D0
      IF ( NS.GT.0 ) CALL GSNRM( NS, ISET, X, RES )
      DO 10 I = 1, NQ
         W(IQ+I-1) = X(I)
   10 CONTINUE
      DO 20 I = 1, NU
         W(IU+I-1) = X(NQ+I)
   20 CONTINUE
      CALL GSPJQ( CON, MAS, KIN, T, W(IQ), W(IU), NQ, NU, NLAM, QUASI,
     $            NS, ISET, CST, RES, W, W(IH), W(IP), W(IT), W(IG),
     $            W(IF), W(ID), W(IL), W(IW+NQ), W(IW), INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSPJU( MAS, T, W(IQ), W(IU), NU, NLAM, CST, W, W(IH), W(IP),
     $            W(IT), W(IF), W(ID), W(IL), W(IW+NQ), INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 30 I = 1, NQ
         X(I) = W(IQ+I-1)
   30 CONTINUE
      DO 40 I = 1, NU
         X(NQ+I) = W(IU+I-1) + W(ID+I-1)
   40 CONTINUE
      END
      SUBROUTINE GSPJQ( CON, MAS, KIN, T, Q, U, NQ, NU, NLAM, QUASI, NS,
     $                  ISET, CST, RES, A, H, P, PT, G, F, DX, LAM, W,
     $                  DQ, INFO )
C
C     PURPOSE
C     The position Q onto phi = 0, part of GSPRJ; on exit H and PT are
C     those of CON there.
C
C     ARGUMENTS
C     As in GSPRJ; Q (input/output) the coordinates, U (input) the
C     speeds, the others workspace: A(NU,NU), H(NLAM,NU), P, PT, G, LAM
C     (NLAM), F, DX (NU), DQ (NQ), W that of GSKKT.
C
      IMPLICIT NONE
      EXTERNAL           CON, MAS, KIN
      INTEGER            NQ, NU, NLAM, QUASI, NS, ISET(4,*), INFO
      DOUBLE PRECISION   T, Q(*), U(*), CST(*), RES, A(NU,*),
     $                   H(NLAM,*), P(*), PT(*), G(*), F(*), DX(*),
     $                   LAM(*), W(*), DQ(*)
      DOUBLE PRECISION   R, OLD, ERR, EPS, GSEPS
      EXTERNAL           GSEPS, GSKKT, GSNRM
      INTEGER            I, K
C
      EPS = GSEPS()
      OLD = 0.0D0
      DO 10 I = 1, NU
         F(I) = 0.0D0
   10 CONTINUE
      DO 50 K = 1, 50
         CALL CON( T, Q, U, CST, P, PT, H, NLAM, G, INFO )
         IF ( INFO.NE.0 ) RETURN
         R = 0.0D0
         DO 20 I = 1, NLAM
            R = MAX( R, ABS( P(I) ) )
            P(I) = -P(I)
   20    CONTINUE
         IF ( K.EQ.1 ) RES = MAX( RES, R )
         IF ( R.LE.4.0D0*EPS ) RETURN
         IF ( K.GT.2 .AND. R.GE.OLD .AND. R.LE.1.0D-11 ) RETURN
         OLD = R
         CALL MAS( T, Q, CST, A, NU )
         CALL GSKKT( NU, NLAM, A, NU, H, NLAM, F, P, DX, LAM, W, INFO )
         IF ( INFO.EQ.1 ) RETURN
C
C        -- a step of more than half a radian (or metre) is shortened
         R = 0.5D0
         DO 30 I = 1, NU
            R = MAX( R, ABS( DX(I) ) )
   30    CONTINUE
         IF ( QUASI.EQ.1 ) THEN
            CALL KIN( T, Q, DX, CST, DQ )
            DO 35 I = 1, NQ
               Q(I) = Q(I) + DQ(I)*( 0.5D0/R )
   35       CONTINUE
         ELSE
            DO 40 I = 1, NQ
               Q(I) = Q(I) + DX(I)*( 0.5D0/R )
   40       CONTINUE
         END IF
         IF ( NS.GT.0 ) CALL GSNRM( NS, ISET, Q, ERR )
   50 CONTINUE
      INFO = 0
      IF ( OLD.GT.1.0D-9 ) INFO = 3
      END
      SUBROUTINE GSPJU( MAS, T, Q, U, NU, NLAM, CST, A, H, P, PT, F, DX,
     $                  LAM, W, INFO )
C
C     PURPOSE
C     The step DX that moves the speeds U onto H*U + PT = 0, part of
C     GSPRJ.
C
C     ARGUMENTS
C     As in GSPJQ.
C
      IMPLICIT NONE
      EXTERNAL           MAS
      INTEGER            NU, NLAM, INFO
      DOUBLE PRECISION   T, Q(*), U(*), CST(*), A(NU,*), H(NLAM,*),
     $                   P(*), PT(*), F(*), DX(*), LAM(*), W(*)
      EXTERNAL           GSKKT
      INTEGER            I, J
C
      CALL MAS( T, Q, CST, A, NU )
      DO 20 I = 1, NLAM
         P(I) = -PT(I)
         DO 10 J = 1, NU
            P(I) = P(I) - H(I,J)*U(J)
   10    CONTINUE
   20 CONTINUE
      CALL GSKKT( NU, NLAM, A, NU, H, NLAM, F, P, DX, LAM, W, INFO )
      IF ( INFO.NE.1 ) INFO = 0
      END
