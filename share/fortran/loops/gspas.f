      SUBROUTINE GSPAS( CON, KIN, T, X, NQ, NU, NLAM, CST, P, TMIN,
     $                  SMIN )
C
C     PURPOSE
C     Follows the least pivot of the constraints from step to step and,
C     where it has passed a minimum, looks for that between the steps,
C     on the cubics through positions and their rates.  Where the
C     constraints turn by more than 0.3 rad in a step the minimum may
C     lie within, unseen at its ends, and is looked for in every case.
C
C     ARGUMENTS
C     As GSPRT, and
C     P       (input/output) as GSPRT; on entry P(13) and HC belong to
C             X.
C     TMIN    (output) DOUBLE PRECISION, when [s].
C     SMIN    (output) DOUBLE PRECISION, the least pivot there (as
C             P(13)), or -1 if no minimum has been passed.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM
      DOUBLE PRECISION   T, X(*), CST(*), P(*), TMIN, SMIN
      DOUBLE PRECISION   H, S, TS, W, Z, TURN
      EXTERNAL           GSLPV, GSPCH
      INTEGER            I, J, K, L, IM, IW, IH, IY, IB, IP, IS, IQ, IR,
     $                   I1, I2, N, RANK, FIRST
C
      IM = 15 + 2*NU + NQ
      IW = IM + NU + 2*NLAM
      IH = IW + 3*NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      IR = IS + 3*NU + 2*NLAM + 2*NQ
      IQ = IR + NQ
C
C     -- memory: number of steps; three times with pivots; three
C        positions with rates
      DO 10 I = 5, 8
         P(I) = P(I+2)
   10 CONTINUE
      DO 20 I = IQ, IQ + 4*NQ - 1
         P(I) = P(I+2*NQ)
   20 CONTINUE
      P(4)  = P(4) + 1.0D0
      P(9)  = T
      P(10) = P(13)
      DO 30 I = 1, NQ
         P(IQ+4*NQ+I-1) = X(I)
   30 CONTINUE
      CALL KIN( T, X, X(NQ+1), CST, P(IQ+5*NQ) )
      SMIN = -1.0D0
      IF ( P(4).LT.2.0D0 ) RETURN
C
C     -- passed between the last steps, or within the last one?
      FIRST = 5
      IF ( P(4).LT.3.0D0 .OR. P(8).GT.P(6) .OR. P(8).GE.P(10) .OR.
     $     P(8).GT.0.5D0*P(14) ) THEN
         FIRST = 7
         CALL GSPCH( NQ, NU, NLAM, P, P(IY), 0, TURN )
         CALL CON( P(7), P(IQ+2*NQ), X(NQ+1), CST, P(IW), P(IW+NLAM),
     $             P(IH), NLAM, P(IW+2*NLAM), J )
         IF ( J.NE.0 .AND. J.NE.2 ) RETURN
         CALL GSPCH( NQ, NU, NLAM, P, P(IY), 1, TURN )
         IF ( TURN.LE.0.3D0 ) RETURN
      END IF
C
C     -- the minimum: samples of these steps, then finer and finer
      SMIN = P(8)
      IF ( FIRST.EQ.7 ) SMIN = 0.9D0*MIN( P(8), P(10) )
      TMIN = P(9)
      IF ( FIRST.EQ.5 ) TMIN = P(7)
      DO 80 L = 1, 4
         IF ( L.EQ.1 ) THEN
            Z = P(FIRST)
            W = ( P(9) - P(FIRST) )/16.0D0
         ELSE
            Z = TMIN - W
            W = 0.125D0*W
         END IF
         DO 70 K = 1, 15
            TS = Z + DBLE( K )*W
            I1 = 5
            IF ( TS.GE.P(7) ) I1 = 7
            I2 = IQ + NQ*( I1 - 5 )
            H  = P(I1+2) - P(I1)
            S  = ( TS - P(I1) )/H
            IF ( S.LT.0.0D0 .OR. S.GT.1.0D0 ) GO TO 70
            DO 60 I = 1, NQ
               N = I2 + I - 1
               P(IR+I-1) = P(N) + S*S*( 3.0D0 - 2.0D0*S )*( P(N+2*NQ)
     $                     - P(N) ) + H*S*( 1.0D0 - S )*( ( 1.0D0 - S )
     $                     *P(N+NQ) - S*P(N+3*NQ) )
   60       CONTINUE
            CALL CON( TS, P(IR), X(NQ+1), CST, P(IW), P(IW+NLAM), P(IH),
     $                NLAM, P(IW+2*NLAM), J )
            IF ( J.EQ.0 .OR. J.EQ.2 ) THEN
               CALL GSLPV( NU, NLAM, P(IH), P(IM), P(IY), P(IP), P(IB),
     $                     P(IS), RANK, S )
               IF ( DBLE( RANK ).LT.P(3) ) S = 0.0D0
               IF ( S.LT.SMIN ) THEN
                  SMIN = S
                  TMIN = TS
               END IF
            END IF
   70    CONTINUE
C        -- within one step: only what falls below both ends is followed
         IF ( FIRST.EQ.7 .AND. .NOT.( TMIN.LT.P(9) ) ) GO TO 90
   80 CONTINUE
   90 CONTINUE
      IF ( FIRST.EQ.5 ) RETURN
      IF ( TMIN.LT.P(9) ) THEN
C        the steps that follow find others
         P(4) = 1.0D0
      ELSE
         SMIN = -1.0D0
      END IF
      END
      SUBROUTINE GSPCH( NQ, NU, NLAM, P, HC, JOB, TURN )
C
C     PURPOSE
C     JOB = 0: HC becomes the Jacobian that P holds (GSPVT); JOB = 1:
C     TURN becomes how far that one differs from HC, beside the length
C     of its row, the largest of the rows.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NLAM, JOB
      DOUBLE PRECISION   P(*), HC(NLAM,*), TURN
      DOUBLE PRECISION   S
      INTEGER            I, J, IM, IH
C
      IM = 14 + 2*NU + NQ
      IH = IM + NU + 5*NLAM + 11
      TURN = 0.0D0
      DO 20 I = 1, NLAM
         S = 0.0D0
         DO 10 J = 1, NU
            IF ( JOB.EQ.0 ) HC(I,J) = P(IH+I-1+NLAM*(J-1))
            S = S + ( HC(I,J) - P(IH+I-1+NLAM*(J-1)) )**2
   10    CONTINUE
         IF ( S.GT.0.0D0 ) TURN = MAX( TURN, SQRT( S )/P(IM+I) )
   20 CONTINUE
      END
