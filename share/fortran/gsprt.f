      SUBROUTINE GSPRT( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
C
C     PURPOSE
C     Completes a state by its partition into independent and dependent
C     speeds: the independent ones, and the coordinates as far as these
C     move them, stay as they are; the dependent ones follow from
C        phi(q,T) = 0   and   HC*u + phit = 0.
C
C     ARGUMENTS
C     CON     (external) <NAME>_CON.
C     KIN     (external) <NAME>_KIN( T, Q, U, CST, QDOT ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     X       (input/output) DOUBLE PRECISION array: NQ coordinates, NU
C             speeds; the dependent ones are the guess on entry.
C     NQ, NU, NLAM (input) INTEGER, see GSSIM.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     P       (input/output) DOUBLE PRECISION array, dimension
C             (24 + 8*NU + 10*NQ + 7*NLAM + 2*NLAM*NU), by GSPRC:
C             P(1)   0 for no partition, 1 for speeds alone (Kane with
C                    dependent speeds), 2 for coordinates and speeds
C                    (coordinate partitioning);
C             P(2)   R, the number of dependent speeds, < 0 if no set
C                    has been chosen;
C             P(3)   the largest rank that the constraints had so far;
C             P(4..10) GSPAS's memory;
C             P(11)  R2, the number of dependent displacements;
C             P(12)  1 if there are constraints on speeds alone, else 0;
C             P(13), P(14) the least pivot of HC, now and the largest so
C                    far;
C             P(15..14+NU) the numbers of the speeds, R dependent first;
C             P(15+NU..14+2*NU+NQ) 0 for each coordinate and speed that
C                    is completed, 1 for the others;
C             P(15+2*NU+NQ..14+2*NU+NQ+NLAM) the largest sizes that the
C                    rows of HC had so far;
C             the next NU entries are the numbers of the speeds, R2 with
C                    dependent displacements first (without constraints
C                    on speeds alone the same as above);
C             the next NLAM entries are 0 for each constraint on speeds
C                    alone, 1 for the others: set by the caller;
C             the rest is workspace.
C     INFO    (output) INTEGER: 0; 3 if Newton's method found no
C             position; or what CON returned.
C
C     METHOD
C     Newton's method on the dependent speeds' displacements du, with
C     dq = KIN(du), so that Euler parameters stay on their sphere but
C     for terms of second order.  Columns of HC that are dependent are
C     left where they are; more rows than columns are solved by least
C     squares.
C
C     REFERENCE
C     Wehage and Haug 1982, generalized coordinate partitioning for
C     dimension reduction in analysis of constrained dynamic systems.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, INFO
      DOUBLE PRECISION   T, X(*), CST(*), P(*)
      DOUBLE PRECISION   GSEPS, EPS, D, OLD, BIG, S
      EXTERNAL           GSEPS, GSPFA, GSPLS
      INTEGER            I, J, K, R, R2, RANK, IO, IE, IR, IW, IT, IG,
     $                   IH, IY, IB, IP, IS, IC, IU, ID
C
      INFO = 0
      R  = NINT( P(2) )
      R2 = NINT( P(11) )
      IF ( R.LE.0 ) RETURN
      IO = 15
      IE = IO + 2*NU + NQ + NLAM
      IR = IE + NU
      IW = IR + NLAM
      IT = IW + NLAM
      IG = IT + NLAM
      IH = IG + NLAM + 10
      IY = IH + NLAM*NU
      IB = IY + NLAM*NU
      IP = IB + NU
      IS = IP + NU
      IC = IS + NU + NLAM
      IU = IC + NLAM
      ID = IU + NU
      EPS = GSEPS()
      OLD = 0.0D0
C
      DO 100 K = 1, 30
         CALL CON( T, X, X(NQ+1), CST, P(IW), P(IT), P(IH), NLAM, P(IG),
     $             INFO )
         IF ( INFO.EQ.2 ) INFO = 0
         IF ( INFO.NE.0 ) RETURN
         IF ( P(1).LT.2.0D0 ) GO TO 110
C
C        -- the displacement that closes the loops
         CALL GSPFA( NLAM, R2, P(IH), P(IE), P(IR), P(IY), P(IP), P(IB),
     $               P(IS), RANK )
         DO 30 I = 1, NLAM
            P(IC+I-1) = -P(IR+I-1)*P(IW+I-1)
   30    CONTINUE
         CALL GSPLS( NLAM, R2, RANK, P(IY), P(IP), P(IB), P(IC), NU,
     $               P(IE), P(IU) )
         CALL KIN( T, X, P(IU), CST, P(ID) )
         D   = 0.0D0
         BIG = 1.0D0
         DO 40 I = 1, NQ
            D   = MAX( D, ABS( P(ID+I-1) ) )
            BIG = MAX( BIG, ABS( X(I) ) )
   40    CONTINUE
         IF ( .NOT.( D.LE.1.0D300 ) ) GO TO 120
         S = MIN( 1.0D0, 0.5D0/MAX( D, 0.5D0 ) )
         DO 50 I = 1, NQ
            X(I) = X(I) + S*P(ID+I-1)
   50    CONTINUE
         IF ( D.LE.4.0D0*EPS*BIG ) GO TO 110
         IF ( K.GT.1 .AND. D.GE.0.25D0*OLD .AND. D.LE.1.0D-8*BIG )
     $      GO TO 110
         OLD = D
  100 CONTINUE
  120 INFO = 3
      RETURN
C
C     -- the speeds
  110 IF ( P(1).LT.2.0D0 .OR. P(12).GT.0.0D0 ) THEN
         DO 115 I = 1, NLAM
            P(IC+I-1) = 1.0D0
  115    CONTINUE
         CALL GSPFA( NLAM, R, P(IH), P(IO), P(IC), P(IY), P(IP), P(IB),
     $               P(IS), RANK )
      END IF
      DO 140 I = 1, NLAM
         S = -P(IT+I-1)
         DO 130 J = 1, NU
            S = S - P(IH+I-1+NLAM*(J-1))*X(NQ+J)
  130    CONTINUE
         P(IC+I-1) = S
  140 CONTINUE
      CALL GSPLS( NLAM, R, RANK, P(IY), P(IP), P(IB), P(IC), NU, P(IO),
     $            P(IU) )
      DO 150 J = 1, NU
         X(NQ+J) = X(NQ+J) + P(IU+J-1)
  150 CONTINUE
      END
      SUBROUTINE GSPFA( M, R, HC, ORDER, ROWS, Y, PIV, BETA, SIZ, RANK )
C
C     PURPOSE
C     The factorization of GSPRT: Y = diag(ROWS)*HC(1..M,ORDER(1..R)) by
C     GSQRP.
C
      IMPLICIT NONE
      INTEGER            M, R, RANK
      DOUBLE PRECISION   HC(M,*), ORDER(*), ROWS(*), Y(M,*), PIV(*),
     $                   BETA(*), SIZ(*)
      DOUBLE PRECISION   GSEPS, TOL
      EXTERNAL           GSEPS, GSQRP
      INTEGER            I, J, K
C
      DO 20 J = 1, R
         K = NINT( ORDER(J) )
         DO 10 I = 1, M
            Y(I,J) = ROWS(I)*HC(I,K)
   10    CONTINUE
   20 CONTINUE
      TOL = 1.0D5*GSEPS()
      CALL GSQRP( M, R, Y, M, TOL, PIV, BETA, SIZ, RANK )
      END
      SUBROUTINE GSPLS( M, R, RANK, Y, PIV, BETA, B, NU, ORDER, DU )
C
C     PURPOSE
C     The step of GSPRT: DU(ORDER(1..R)) solves Y*DU = B by least
C     squares, Y (M by R) as GSQRP left it with RANK; the other entries
C     of DU are zero.  B is destroyed.
C
      IMPLICIT NONE
      INTEGER            M, R, RANK, NU
      DOUBLE PRECISION   Y(M,*), PIV(*), BETA(*), B(*), ORDER(*), DU(*)
      EXTERNAL           GSQMV
      INTEGER            I, K
C
      DO 10 I = 1, NU
         DU(I) = 0.0D0
   10 CONTINUE
      IF ( R.EQ.0 ) RETURN
      CALL GSQMV( M, RANK, Y, M, BETA, B, 1 )
      DO 30 K = RANK, 1, -1
         B(K) = B(K)/Y(K,K)
         DU(NINT( ORDER(NINT( PIV(K) )) )) = B(K)
         DO 20 I = 1, K - 1
            B(I) = B(I) - Y(I,K)*B(K)
   20    CONTINUE
   30 CONTINUE
      END
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
      DOUBLE PRECISION   S
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
      IF ( S.LT.0.8D0 ) THEN
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
      SUBROUTINE GSLPV( NU, NLAM, HC, SIZE, Y, PIV, BETA, D, RANK,
     $                  LEAST )
C
C     PURPOSE
C     Pivots of the constraint Jacobian HC (NLAM by NU), each row divided
C     by the largest length SIZE it had so far (at least a millionth of
C     the longest row's); RANK and LEAST as GSPRC.
C     Y, PIV, BETA, D and RANK are what GSQRC leaves.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, RANK
      DOUBLE PRECISION   HC(NLAM,*), SIZE(*), Y(NLAM,*), PIV(*),
     $                   BETA(*), D(*), LEAST
      DOUBLE PRECISION   S, BIG
      EXTERNAL           GSQRC
      INTEGER            I, J
C
      BIG = 0.0D0
      DO 20 I = 1, NLAM
         S = 0.0D0
         DO 10 J = 1, NU
            S = S + HC(I,J)*HC(I,J)
   10    CONTINUE
         SIZE(I) = MAX( SIZE(I), SQRT( S ) )
         BIG = MAX( BIG, SIZE(I) )
   20 CONTINUE
      IF ( .NOT.( BIG.GT.0.0D0 ) ) BIG = 1.0D0
C
C     -- a row that has always been nothing stays nothing
      DO 40 I = 1, NLAM
         SIZE(I) = MAX( SIZE(I), 1.0D-6*BIG )
         DO 30 J = 1, NU
            Y(I,J) = HC(I,J)/SIZE(I)
   30    CONTINUE
   40 CONTINUE
      CALL GSQRC( NLAM, NU, Y, NLAM, 1.0D-7, PIV, BETA, D, RANK )
      LEAST = 0.0D0
      IF ( RANK.GT.0 ) LEAST = D(RANK)/D(1)
      END
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
   80 CONTINUE
      IF ( FIRST.EQ.5 ) RETURN
      IF ( TMIN.LT.P(9) ) THEN
C        the steps that follow find others
         P(4) = 1.0D0
      ELSE
         SMIN = -1.0D0
      END IF
      END
