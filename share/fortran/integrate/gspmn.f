      SUBROUTINE GSPMN( CON, T, X, TC, D, CA, CB, NQ, NU, NX, NS, NLAM,
     $                  CST, F, XT, P, CS, SMIN )
C
C     PURPOSE
C     The least pivot of the constraints, SMIN, and its place CS between
C     CA and CB, on the path of GSPSG from X at T with the rates F.
C     XT is workspace of NX entries.  SMIN = 0 where the rank is lower
C     than elsewhere.
C
      IMPLICIT NONE
      EXTERNAL           CON
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), TC, D, CA, CB, CST(*), F(NX,13),
     $                   XT(*), P(*), CS, SMIN
      DOUBLE PRECISION   S, Z, SP, W
      EXTERNAL           GSPVT
      INTEGER            K, L
C
      SMIN = 1.0D300
      CS   = 0.5D0*( CA + CB )
      W    = ( CB - CA )/12.0D0
      DO 20 L = 1, 4
         Z = CS
         DO 10 K = -6, 6
            S = Z + DBLE( K )*W
            IF ( S.GE.CA - 0.1D0*W .AND. S.LE.CB + 0.1D0*W ) THEN
               CALL GSPVT( CON, T, X, TC, D, S, NQ, NU, NX, NS, NLAM,
     $               CST, F, XT, P, SP )
               IF ( SP.LT.SMIN ) THEN
                  SMIN = SP
                  CS   = S
               END IF
            END IF
   10    CONTINUE
         W = 0.2D0*W
   20 CONTINUE
      END
      SUBROUTINE GSPVT( CON, T, X, TC, D, CT, NQ, NU, NX, NS, NLAM, CST,
     $                  F, XT, P, SP )
C
C     PURPOSE
C     The least pivot SP of the constraints at TC + CT*D on the path of
C     GSPMN, beside the largest; 1D300 where CON fails.
C
      IMPLICIT NONE
      EXTERNAL           CON
      INTEGER            NQ, NU, NX, NS, NLAM
      DOUBLE PRECISION   T, X(*), TC, D, CT, CST(*), F(NX,13), XT(*),
     $                   P(*), SP
      DOUBLE PRECISION   C(12), WT(12), B(12)
      EXTERNAL           GSGLN, GSGLQ, GSPTH, GSLPV
      INTEGER            I, IM, IW, IH, IY, IB, IP, IS, RANK, INFO
C
      IM = 15 + 2*NU + NQ
      IW = IM + NU + 2*NLAM
      IH = IW + 3*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      SP = 1.0D300
      CALL GSGLN( NS, C, WT )
      CALL GSGLQ( NS, C, WT, ( T - TC )/D, CT, B )
      CALL GSPTH( NQ, NS, NX, X, D, B, F, XT )
      CALL CON( TC + CT*D, XT, X(NQ+1), CST, P(IW), P(IW+NLAM), P(IH),
     $          NLAM, P(IW+2*NLAM), INFO )
      IF ( INFO.NE.0 .AND. INFO.NE.2 ) RETURN
C
C     -- with lengths of rows of its own: those of P are of states that
C        the motion had
      DO 10 I = 1, NLAM
         P(IW+I-1) = P(IM+I-1)
   10 CONTINUE
      CALL GSLPV( NU, NLAM, P(IH), P(IW), P(IY), P(IP), P(IB), P(IS),
     $            RANK, SP )
      SP = 0.0D0
      I  = NINT( P(3) )
      IF ( I.GT.0 .AND. RANK.GE.I ) SP = P(IS+I-1)/P(IS)
      END
      SUBROUTINE GSPTH( N, NS, LDF, X, D, B, F, XT )
C
C     PURPOSE
C     XT = X + D*F(1..N,2..13)*B, the first N states at the place of B
C     (GSGLQ) in a step of GSPSG.
C
      IMPLICIT NONE
      INTEGER            N, LDF, NS
      DOUBLE PRECISION   X(*), D, B(12), F(LDF,13), XT(*)
      DOUBLE PRECISION   S
      INTEGER            I, K
C
      DO 20 I = 1, N
         S = 0.0D0
         DO 10 K = 1, NS
            S = S + B(K)*F(I,K+1)
   10    CONTINUE
         XT(I) = X(I) + D*S
   20 CONTINUE
      END
