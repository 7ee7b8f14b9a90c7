      SUBROUTINE GSPNW( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
C
C     PURPOSE
C     The first or a new choice of the dependent speeds at X, whatever
C     the present one.  Arguments as GSPRT.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, INFO
      DOUBLE PRECISION   T, X(*), CST(*), P(*)
      DOUBLE PRECISION   LEAST
      EXTERNAL           GSPRC
      INTEGER            IW, RANK, CHANGE
C
      IW = 15 + 3*NU + NQ + 2*NLAM
      CALL CON( T, X, X(NQ+1), CST, P(IW), P(IW+NLAM),
     $          P(IW+3*NLAM+10), NLAM, P(IW+2*NLAM), INFO )
      IF ( INFO.EQ.2 ) INFO = 0
      IF ( INFO.NE.0 ) RETURN
      P(2) = -1.0D0
      CALL GSPRC( KIN, T, X, NQ, NU, NLAM, CST, P, RANK, LEAST, CHANGE )
      END
      SUBROUTINE GSPCN( CON, KIN, T, X, NQ, NU, NLAM, CST, P, ISTAT,
     $                  INFO )
C
C     PURPOSE
C     GSPNW within a run: ISTAT(6) and ISTAT(7) of GSSIM tell if CON
C     fails.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), CST(*), P(*)
      EXTERNAL           GSPNW
C
      CALL GSPNW( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 4
      IF ( INFO.EQ.0 ) ISTAT(7) = 0
      END
      SUBROUTINE GSPRC( KIN, T, X, NQ, NU, NLAM, CST, P, RANK, LEAST,
     $                  CHANGE )
C
C     PURPOSE
C     The rank of the constraints at X, and the choice of the dependent
C     speeds of GSPRT where P(1) > 0: by column pivoting of HC, each row
C     divided by the largest size it had so far (one that vanishes now
C     is seen to vanish).  A set that has been chosen is kept as long as the
C     volume that its columns span is at least 0.8 of the best one's
C     (the product of the diagonals of their triangular factors): where
C     it is much less, errors of the independent ones are multiplied.
C     With P(1) = 3 it is kept down to 0.05: every change costs a method
C     that keeps the energy some of that.
C
C     ARGUMENTS
C     As GSPRT, and
C     P       (input/output) as GSPRT; on entry its HC is that at X.
C     RANK    (output) INTEGER, the rank of HC to 1D-7.
C     LEAST   (output) DOUBLE PRECISION, the least pivot of HC divided
C             by the largest (0 if HC is zero).
C     CHANGE  (output) INTEGER, 1 if another set was chosen, else 0.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NU, NLAM, RANK, CHANGE
      DOUBLE PRECISION   T, X(*), CST(*), P(*), LEAST
      DOUBLE PRECISION   S, KEPT
      EXTERNAL           GSLPV, GSVOL, GSQRC, GSPWT
      INTEGER            I, J, K, N, IO, IM, IE, IR, IH, IY, IB, IP, IS,
     $                   IU
C
      CHANGE = 0
      IO = 15
      IM = IO + 2*NU + NQ
      IE = IM + NLAM
      IR = IE + NU
      IH = IR + 4*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      IU = IS + NU + 2*NLAM
C
C     -- the best set
      CALL GSLPV( NU, NLAM, P(IH), P(IM), P(IY), P(IP), P(IB), P(IS),
     $            RANK, LEAST )
      IF ( P(1).LE.0.0D0 ) RETURN
C
C     -- is the present one good enough?
      S = 0.0D0
      IF ( NINT( P(2) ).EQ.RANK ) THEN
         DO 20 J = 1, RANK
            K = NINT( P(IO+J-1) )
            DO 10 I = 1, NLAM
               P(IY+I-1+NLAM*(J-1)) = P(IH+I-1+NLAM*(K-1))/P(IM+I-1)
   10       CONTINUE
   20    CONTINUE
         CALL GSVOL( NLAM, RANK, P(IY), P(IS), S )
      END IF
      KEPT = 0.8D0
      IF ( P(1).GT.2.5D0 ) KEPT = 0.05D0
      IF ( S.LT.KEPT ) THEN
         IF ( P(2).GE.0.0D0 ) CHANGE = 1
         P(2)  = DBLE( RANK )
         P(11) = P(2)
         DO 30 J = 1, NU
            P(IO+J-1) = P(IP+J-1)
            P(IE+J-1) = P(IP+J-1)
   30    CONTINUE
      ELSE IF ( P(12).LE.0.0D0 ) THEN
         RETURN
      END IF
C
C     -- displacements: constraints on speeds alone do not count
      IF ( P(12).GT.0.0D0 ) THEN
         DO 50 I = 1, NLAM
            S = 0.0D0
            IF ( P(IM+I-1).GT.0.0D0 ) S = P(IR+I-1)/P(IM+I-1)
            DO 40 J = 1, NU
               P(IY+I-1+NLAM*(J-1)) = S*P(IH+I-1+NLAM*(J-1))
   40       CONTINUE
   50    CONTINUE
         CALL GSQRC( NLAM, NU, P(IY), NLAM, 1.0D-7, P(IE), P(IB), P(IS),
     $               N )
         P(11) = DBLE( N )
      END IF
      CALL GSPWT( KIN, T, X, NQ, NU, CST, P, P(IE), P(IU) )
      END
      SUBROUTINE GSPWT( KIN, T, X, NQ, NU, CST, P, ORDER, W )
C
C     PURPOSE
C     Which coordinates and speeds count in the step control (see
C     GSPRT): those that are not completed from others.  ORDER is that
C     of the displacements, W workspace of NU + NQ entries.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NU
      DOUBLE PRECISION   T, X(*), CST(*), P(*), ORDER(*), W(*)
      INTEGER            I, J, K, IX
C
      IX = 14 + NU
      DO 10 I = 1, NQ
         P(IX+I) = 0.0D0
         IF ( P(1).LT.2.0D0 ) P(IX+I) = 1.0D0
   10 CONTINUE
      DO 20 J = 1, NU
         K = NINT( P(14+J) )
         P(IX+NQ+K) = 1.0D0
         IF ( J.LE.NINT( P(2) ) ) P(IX+NQ+K) = 0.0D0
         W(J) = 0.0D0
   20 CONTINUE
      DO 40 J = NINT( P(11) ) + 1, NU
         K = NINT( ORDER(J) )
         W(K) = 1.0D0
         CALL KIN( T, X, W, CST, W(NU+1) )
         W(K) = 0.0D0
         DO 30 I = 1, NQ
            IF ( ABS( W(NU+I) ).GT.1.0D-12 ) P(IX+I) = 1.0D0
   30    CONTINUE
   40 CONTINUE
      END
      SUBROUTINE GSVOL( M, R, Y, SIZ, RATIO )
C
C     PURPOSE
C     The volume that the R columns of Y (M rows) span, divided by the
C     product of SIZ(1..R).  Y is destroyed.
C
      IMPLICIT NONE
      INTEGER            M, R
      DOUBLE PRECISION   Y(M,*), SIZ(*), RATIO
      DOUBLE PRECISION   D, BETA
      EXTERNAL           GSHRF
      INTEGER            I, K
C
      RATIO = 1.0D0
      DO 20 K = 1, R
         D = 0.0D0
         DO 10 I = K, M
            D = D + Y(I,K)*Y(I,K)
   10    CONTINUE
         RATIO = RATIO*SQRT( D )/SIZ(K)
         IF ( .NOT.( D.GT.0.0D0 ) ) RETURN
         CALL GSHRF( M, R, K, Y, M, D, BETA )
   20 CONTINUE
      END
