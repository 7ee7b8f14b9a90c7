      SUBROUTINE GSPBG( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT,
     $                  XW, HC, SIZ, P, STATE )
C
C     PURPOSE
C     Whether a run starts in, or very close to, a position where the
C     constraints lose rank.  Then P knows their rank and pivots where
C     they do not.
C
C     ARGUMENTS
C     As GSPRT, and
C     HMAX    (input) DOUBLE PRECISION, no further ahead is looked [s].
C     F       (input) DOUBLE PRECISION array, the right-hand side at
C             (T,X).
C     XT, XW  (workspace) DOUBLE PRECISION arrays, dimension (NQ).
C     HC, SIZ (workspace) DOUBLE PRECISION arrays, dimensions (NLAM,NU)
C             and (NLAM).
C     P       (input/output) as GSPRT, after GSPRC at X.
C     STATE   (output) INTEGER: 0, no such position; 1, one that the
C             speeds lead out of; 2, one at rest; -1, the constraints
C             hardly turn.
C
C     METHOD
C     The pivots beyond the rank at X a little ahead, and half as far.
C     On the straight way from a singular position they grow with the
C     way, those of constraints that are redundant everywhere with its
C     square, as far as it leads off the constraints.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, STATE
      DOUBLE PRECISION   T, X(*), HMAX, CST(*), F(*), XT(*), XW(*),
     $                   HC(NLAM,*), SIZ(*), P(*)
      DOUBLE PRECISION   H, HALF, FAR, NEAR, MID, HERE
      EXTERNAL           GSPBH, GSPBV
      INTEGER            I, L, IS, NR, REST
C
      STATE = -1
      IS = 25 + 5*NU + NQ + 5*NLAM + 2*NLAM*NU
      CALL GSPBH( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT, XW,
     $            HC, SIZ, P, H, REST )
      IF ( H.LE.0.0D0 ) RETURN
      STATE = 0
      HALF = 0.5D0
      IF ( REST.EQ.1 ) HALF = SQRT( HALF )
      CALL GSPBV( CON, KIN, T, X, 0.0D0, NQ, NU, NLAM, CST, F, XT, XW,
     $            SIZ, P, NR )
      HERE = 0.0D0
      IF ( NR.GT.0 ) HERE = P(IS+NR-1)/P(IS)
      DO 10 I = MIN( NU, NLAM ), MAX( 1, NR ), -1
         CALL GSPBV( CON, KIN, T, X, 0.1D0*H, NQ, NU, NLAM, CST, F, XT,
     $               XW, SIZ, P, L )
         MID = 0.0D0
         IF ( L.GE.I ) MID = P(IS+I-1)/P(IS)
         CALL GSPBV( CON, KIN, T, X, 0.1D0*HALF*H, NQ, NU, NLAM, CST, F,
     $               XT, XW, SIZ, P, L )
         NEAR = 0.0D0
         IF ( L.GE.I ) NEAR = P(IS+I-1)/P(IS)
         IF ( I.LE.NR .OR. ( MID.GT.0.0D0 .AND. MID.LE.2.8D0*NEAR ) )
     $      GO TO 20
   10 CONTINUE
      RETURN
C
C     -- I is the rank elsewhere
   20 CALL GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW, SIZ,
     $            P, L )
      IF ( L.LT.I ) RETURN
      FAR = P(IS+I-1)/P(IS)
      IF ( I.GT.NR ) HERE = 0.0D0
      IF ( HERE.GT.0.25D0*FAR ) RETURN
      IF ( HERE.LE.1.0D-4*FAR ) STATE = 1
      IF ( I.GT.NR .AND. REST.EQ.1 ) STATE = 2
      P(3)  = DBLE( I )
      P(10) = HERE
      P(13) = HERE
      P(14) = FAR
      DO 30 I = 1, NLAM
         P(14+2*NU+NQ+I) = SIZ(I)
   30 CONTINUE
      END
      SUBROUTINE GSPBH( CON, KIN, T, X, HMAX, NQ, NU, NLAM, CST, F, XT,
     $                  XW, HC, SIZ, P, H, REST )
C
C     PURPOSE
C     For GSPBG: the time H until the constraints have turned by 0.3 rad
C     or a little less (rows that are nothing at X apart), 0 if they
C     hardly turn; SIZ, the largest lengths of their rows so far and
C     then; REST, 1 if the speeds hardly move the scene until then.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, REST
      DOUBLE PRECISION   T, X(*), HMAX, CST(*), F(*), XT(*), XW(*),
     $                   HC(NLAM,*), SIZ(*), P(*), H
      DOUBLE PRECISION   TURN, BIG, S, R, BYU, WAY
      EXTERNAL           GSPBV
      INTEGER            I, J, K, L, IM, IH, LAST
C
      IM  = 14 + 2*NU + NQ
      IH  = IM + NU + 5*NLAM + 10
      H   = 0.0D0
      BIG = 0.0D0
      LAST = 0
      DO 60 K = 0, 24
         DO 10 I = 1, NLAM
            SIZ(I) = P(IM+I)
   10    CONTINUE
         CALL GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW,
     $               SIZ, P, L )
         TURN = 1.0D300
         IF ( L.LT.0 ) GO TO 50
         TURN = 0.0D0
         DO 40 I = 1, NLAM
            S = 0.0D0
            R = 0.0D0
            DO 20 J = 1, NU
               IF ( K.EQ.0 ) HC(I,J) = P(IH+I+NLAM*(J-1))
               R = R + HC(I,J)**2
               S = S + ( P(IH+I+NLAM*(J-1)) - HC(I,J) )**2
   20       CONTINUE
            IF ( K.EQ.0 ) BIG = MAX( BIG, R )
            IF ( R.GT.1.0D-6*BIG ) TURN = MAX( TURN, S/R )
   40    CONTINUE
   50    IF ( LAST.EQ.2 .OR. ( TURN.LE.0.09D0 .AND. ( LAST.EQ.1 .OR.
     $        K.EQ.21 ) ) ) GO TO 70
         IF ( TURN.GT.0.09D0 ) THEN
            LAST = LAST + 1
            H = 0.5D0*H
            IF ( K.LT.2 ) H = 0.0D0
         ELSE
            H = HMAX*0.25D0**( 20 - K )
         END IF
   60 CONTINUE
   70 IF ( .NOT.( TURN.GE.1.0D-4 .AND. TURN.LE.0.09D0 ) ) H = 0.0D0
C
C     -- the way there, what the speeds alone do of it
      CALL KIN( T, X, X(NQ+1), CST, XW )
      BYU = 0.0D0
      WAY = 0.0D0
      DO 80 I = 1, NQ
         BYU = MAX( BYU, ABS( H*XW(I) ) )
         WAY = MAX( WAY, ABS( XT(I) - X(I) ) )
   80 CONTINUE
      REST = 0
      IF ( BYU.LE.1.0D-3*WAY ) REST = 1
      END
      SUBROUTINE GSPBV( CON, KIN, T, X, H, NQ, NU, NLAM, CST, F, XT, XW,
     $                  SIZ, P, RANK )
C
C     PURPOSE
C     The pivots of the constraints H behind T on the path from X with
C     the accelerations in F, as GSLPV leaves them in P, the lengths of
C     rows in SIZ; RANK, or -1 where CON fails.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, RANK
      DOUBLE PRECISION   T, X(*), H, CST(*), F(*), XT(*), XW(*), SIZ(*),
     $                   P(*)
      DOUBLE PRECISION   LEAST
      EXTERNAL           GSLPV
      INTEGER            I, IW, IH, IY, IB, IP, IS, INFO
C
      IW = 15 + 3*NU + NQ + 2*NLAM
      IH = IW + 3*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      CALL KIN( T, X, X(NQ+1), CST, XT )
      CALL KIN( T, X, F(NQ+1), CST, XW )
      DO 10 I = 1, NQ
         XT(I) = X(I) + H*( XT(I) + 0.5D0*H*XW(I) )
   10 CONTINUE
      RANK = -1
      CALL CON( T + H, XT, X(NQ+1), CST, P(IW), P(IW+NLAM), P(IH), NLAM,
     $          P(IW+2*NLAM), INFO )
      IF ( INFO.NE.0 .AND. INFO.NE.2 ) RETURN
      CALL GSLPV( NU, NLAM, P(IH), SIZ, P(IY), P(IP), P(IB), P(IS),
     $            RANK, LEAST )
      END
      SUBROUTINE GSPBC( KIN, T, X, TC, D, NQ, NX, NS, CST, F, XW, GAP )
C
C     PURPOSE
C     How far the speeds of X at T differ from those of the step of
C     GSPSG with the stages F, as rates of coordinates, beside the
C     largest.  XW is workspace of NQ entries.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NX, NS
      DOUBLE PRECISION   T, X(*), TC, D, CST(*), F(NX,13), XW(*), GAP
      DOUBLE PRECISION   C(12), WT(12), P(12), P0(12), B(12), S, BIG
      EXTERNAL           GSGLN, GSLGP
      INTEGER            I, J, K
C
      CALL GSGLN( NS, C, WT )
      CALL GSLGP( NS, ( T - TC )/D, P0 )
      DO 20 K = 1, NS
         CALL GSLGP( NS, C(K), P )
         S = 0.0D0
         DO 10 J = 1, NS
            S = S + ( DBLE( J ) - 0.5D0 )*P(J)*P0(J)
   10    CONTINUE
         B(K) = WT(K)*S
   20 CONTINUE
      CALL KIN( T, X, X(NQ+1), CST, XW )
      GAP = 0.0D0
      BIG = 0.0D0
      DO 40 I = 1, NQ
         S = 0.0D0
         DO 30 K = 1, NS
            S = S + B(K)*F(I,K+1)
   30    CONTINUE
         GAP = MAX( GAP, ABS( S - XW(I) ) )
         BIG = MAX( BIG, ABS( XW(I) ) )
   40 CONTINUE
      IF ( BIG.GT.0.0D0 ) GAP = GAP/BIG
      END
