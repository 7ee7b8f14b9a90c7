      SUBROUTINE GSCHK( PRJ, CON, KIN, T, X, NQ, NU, NX, NLAM, IOPT,
     $                  JUMP, CST, P, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     After a step: X is moved onto the constraints in the way that
C     IOPT(2) says; the drift that is left, the rank of the constraints
C     and the choice of independent speeds are looked after.
C
C     ARGUMENTS
C     As GSSIM, and
C     JUMP    (input) DOUBLE PRECISION array, dimension (3): how far (1)
C             a coordinate and (2) a speed may be moved, 0 for any way;
C             (3) how far the least pivot may fall beside its largest
C             value.
C     P       (input/output) DOUBLE PRECISION array, see GSPRT.
C     INFO    (output) INTEGER, 0 or the INFO of what failed; 3 if the
C             constraints are not fulfilled to 1D-6 of the largest
C             coordinate (or of 1), or only by a jump; 4 if the least
C             pivot has fallen too far.
C
      IMPLICIT NONE
      EXTERNAL           PRJ, CON, KIN
      INTEGER            NQ, NU, NX, NLAM, IOPT(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), JUMP(3), CST(*), P(*), RSTAT(*)
      DOUBLE PRECISION   S, BIG, GAP, RATE, LEAST, TMIN
      EXTERNAL           GSMOV, GSPRC, GSPAS
      INTEGER            I, J, K, WAY, IW, IT, IG, IH
C
      INFO = 0
      IF ( NLAM.EQ.0 .AND. NQ.EQ.NU ) RETURN
      WAY = IOPT(2)
      IW = 15 + 3*NU + NQ + 2*NLAM
      IT = IW + NLAM
      IG = IT + NLAM
      IH = IG + NLAM + 10
C
C     -- onto the constraints
      CALL GSMOV( PRJ, CON, KIN, T, X, NQ, NU, NLAM, IOPT, JUMP, CST, P,
     $            ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      ISTAT(7) = 0
      IF ( NLAM.EQ.0 ) RETURN
      IF ( IOPT(3).NE.1 .AND. WAY.NE.3 .AND. WAY.NE.6 ) RETURN
C
C     -- what is left
      CALL CON( T, X, X(NQ+1), CST, P(IW), P(IT), P(IH), NLAM, P(IG),
     $          INFO )
      ISTAT(7) = 4
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.NE.0 ) GO TO 100
      ISTAT(7) = 0
      BIG = 1.0D0
      DO 10 I = 1, NQ
         BIG = MAX( BIG, ABS( X(I) ) )
   10 CONTINUE
      GAP  = 0.0D0
      RATE = 0.0D0
      DO 30 I = 1, NLAM
         S = P(IT+I-1)
         DO 20 J = 1, NU
            S = S + P(IH+I-1+NLAM*(J-1))*X(NQ+J)
   20    CONTINUE
         GAP  = MAX( GAP, ABS( P(IW+I-1) ) )
         RATE = MAX( RATE, ABS( S ) )
   30 CONTINUE
      IF ( WAY.NE.1 .AND. .NOT.( GAP.LE.1.0D-6*BIG ) ) THEN
         INFO = 3
         ISTAT(7) = 3
         IF ( WAY.EQ.3 ) ISTAT(7) = 5
         GO TO 100
      END IF
      IF ( GAP.GT.RSTAT(1) ) THEN
         RSTAT(1) = GAP
         RSTAT(3) = T
      END IF
      IF ( RATE.GT.RSTAT(2) ) THEN
         RSTAT(2) = RATE
         RSTAT(4) = T
      END IF
C
C     -- rank and partition
      CALL GSPRC( KIN, T, X, NQ, NU, NLAM, CST, P, J, LEAST, K )
      ISTAT(10) = ISTAT(10) + K
      IF ( DBLE( J ).LT.P(3) ) LEAST = 0.0D0
      IF ( LEAST.LT.JUMP(3)*P(14) ) THEN
         INFO = 4
         ISTAT(7) = 3
         GO TO 100
      END IF
      P(3)  = MAX( P(3), DBLE( J ) )
      P(13) = LEAST
      P(14) = MAX( P(14), LEAST )
      IF ( IOPT(1).EQ.4 .AND. IOPT(5).EQ.1 .AND.
     $     LEAST.LT.0.01D0*P(14) ) ISTAT(20) = ISTAT(20) + 1
      TMIN = T
      IF ( IOPT(5).EQ.1 ) THEN
         CALL GSPAS( CON, KIN, T, X, NQ, NU, NLAM, CST, P, TMIN, S )
         IF ( S.GE.0.0D0 .AND. S.LT.0.01D0*P(14) ) THEN
            ISTAT(11) = ISTAT(11) + 1
            IF ( ISTAT(11).EQ.1 ) RSTAT(16) = TMIN
            RSTAT(17) = TMIN
         END IF
         IF ( S.GE.0.0D0 .AND. S.LT.LEAST ) LEAST = S
      END IF
      IF ( LEAST.LT.RSTAT(14) ) THEN
         RSTAT(14) = LEAST
         RSTAT(15) = TMIN
      END IF
      RETURN
C
  100 ISTAT(6) = INFO
      END
      SUBROUTINE GSMOV( PRJ, CON, KIN, T, X, NQ, NU, NLAM, IOPT, JUMP,
     $                  CST, P, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     X is moved onto the constraints in the way that IOPT(2) says.
C
C     ARGUMENTS
C     As GSCHK.
C
      IMPLICIT NONE
      EXTERNAL           PRJ, CON, KIN
      INTEGER            NQ, NU, NLAM, IOPT(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), JUMP(2), CST(*), P(*), RSTAT(*)
      EXTERNAL           GSPRT, GSPNW
      INTEGER            I, K, WAY, IW, IQ
C
      INFO = 0
      IF ( NLAM.EQ.0 .AND. NQ.EQ.NU ) RETURN
      WAY = IOPT(2)
      IW  = 15 + 3*NU + NQ + 2*NLAM
      IQ  = IW + 3*NLAM + 10 + 2*NLAM*NU + 4*NU + 2*NLAM
      DO 5 I = 1, NQ + NU
         P(IQ+NQ+I-1) = X(I)
    5 CONTINUE
      IF ( P(1).GT.0.0D0 .AND. P(2).LT.0.0D0 ) THEN
         CALL GSPNW( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
         ISTAT(7) = 4
         IF ( INFO.NE.0 ) GO TO 20
      END IF
      IF ( P(1).GT.1.0D0 ) THEN
C        twice: the speeds then belong to the last position
         CALL GSPRT( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
         ISTAT(7) = 5
         IF ( INFO.NE.0 ) GO TO 20
         CALL GSPRT( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
         IF ( INFO.NE.0 ) GO TO 20
      END IF
      IF ( WAY.NE.1 .AND. ( WAY.NE.3 .OR. NQ.GT.NU ) ) THEN
         CALL PRJ( T, X, CST, P(IW), INFO )
         ISTAT(4) = ISTAT(4) + 1
         ISTAT(7) = 3
         IF ( INFO.EQ.2 ) INFO = 0
         IF ( INFO.NE.0 ) GO TO 20
         RSTAT(5) = MAX( RSTAT(5), ABS( P(IW) ) )
      END IF
      IF ( JUMP(1).GT.0.0D0 .AND. WAY.NE.1 ) THEN
         DO 8 I = 1, NQ + NU
            K = 1
            IF ( I.GT.NQ ) K = 2
            IF ( .NOT.( ABS( X(I) - P(IQ+NQ+I-1) ).LE.JUMP(K) ) )
     $         INFO = 3
    8    CONTINUE
         IF ( INFO.NE.0 ) GO TO 20
      END IF
      ISTAT(7) = 0
      RETURN
C
   20 ISTAT(6) = INFO
      END
