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
C                    (coordinate partitioning), 3 the same with a set
C                    that is kept as long as it may be;
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
C     for terms of second order, until a displacement is so small that
C     what is left is rounding; the speeds come from HC at that place.
C     Columns of HC that are dependent are left where they are; more
C     rows than columns are solved by least squares.
C
C     REFERENCE
C     Wehage and Haug 1982, generalized coordinate partitioning for
C     dimension reduction in analysis of constrained dynamic systems.
C
      IMPLICIT NONE
      EXTERNAL           CON, KIN
      INTEGER            NQ, NU, NLAM, INFO
      DOUBLE PRECISION   T, X(*), CST(*), P(*)
      DOUBLE PRECISION   GSEPS, D, NEAR, OLD, BIG, S
      LOGICAL            CLOSED
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
      NEAR = 1.0D-2*SQRT( GSEPS() )
      OLD = 0.0D0
      CLOSED = .FALSE.
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
         IF ( CLOSED ) GO TO 110
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
         CLOSED = D.LE.NEAR .OR. ( K.GT.1 .AND. D.GE.0.25D0*OLD
     $            .AND. D.LE.1.0D-8*BIG )
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
