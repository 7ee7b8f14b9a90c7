      SUBROUTINE GSJAC( NU, NLAM, NQ, NZ, LM, LB, LC, K, Z, IW, INFO )
C
C     PURPOSE
C     The derivatives Z of accelerations and multipliers by the states
C     and inputs: K*Z_out = Z_in, with what the efforts of the tree give.
C
C     ARGUMENTS
C     NU, NLAM, NQ (input) INTEGER, the numbers of speeds, constraints
C             and coordinates.
C     NZ      (input) INTEGER, the number of states and inputs.
C     LM, LB, LC (input) DOUBLE PRECISION arrays, dimensions (NU,NU),
C             (NU,NU), (NU,NQ), from <NAME>_LIN.
C     K       (input/output) DOUBLE PRECISION array, dimension (NU+NLAM,
C             NU+NLAM): on entry its border; overwritten.
C     Z       (input/output) DOUBLE PRECISION array, dimension (NU+NLAM,
C             NZ): right sides without LIN; on exit the derivatives, where
C             INFO is 0, else the right sides.
C     IW      (workspace) INTEGER array, dimension (NU+NLAM).
C     INFO    (input/output) INTEGER; on entry 2 where the constraints
C             have lost rank: then nothing is solved; on exit > 0 where
C             it is not solved (GSJDF does).
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NQ, NZ, IW(*), INFO
      DOUBLE PRECISION   LM(NU,*), LB(NU,*), LC(NU,*), K(NU+NLAM,*),
     $                   Z(NU+NLAM,*)
      EXTERNAL           GSLQF, GSLQS
      INTEGER            I, J, N
C
      DO 20 J = 1, NQ
         DO 10 I = 1, NU
            Z(I,J) = Z(I,J) - LC(I,J)
   10    CONTINUE
   20 CONTINUE
      DO 40 J = 1, NU
         DO 30 I = 1, NU
            K(I,J) = LM(I,J)
            Z(I,NQ+J) = Z(I,NQ+J) - LB(I,J)
   30    CONTINUE
   40 CONTINUE
      IF ( INFO.EQ.2 ) RETURN
      N = NU + NLAM
      CALL GSLQF( N, NZ, K, N, Z, N, IW, INFO )
      IF ( INFO.EQ.0 ) CALL GSLQS( N, NZ, K, N, Z, N, IW )
      END
      SUBROUTINE GSJDF( NU, NLAM, NZ, LM, H, PHI, GRP, Z, HC, UD, LAM,
     $                  W, INFO )
C
C     PURPOSE
C     As GSJAC, from the right sides that it leaves, where the
C     constraints have lost rank: column by column, rank revealing.
C
C     ARGUMENTS
C     As in GSJAC, and
C     H       (input) DOUBLE PRECISION array, dimension (NLAM,NU), the
C             Jacobian of the constraints.
C     PHI     (input) DOUBLE PRECISION array, dimension (NLAM), what is
C             left of them.
C     GRP     (input) INTEGER array, dimension (NLAM), see GSQRG.
C     HC, UD, LAM (workspace) DOUBLE PRECISION arrays, dimensions (NLAM,
C             NU), (NU), (NLAM).
C     W       (workspace) DOUBLE PRECISION array, as of GSACC.
C     INFO    (output) INTEGER, 0, or 1: singular mass matrix.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NZ, GRP(*), INFO
      DOUBLE PRECISION   LM(NU,*), H(NLAM,*), PHI(*), Z(NU+NLAM,*),
     $                   HC(NLAM,*), UD(*), LAM(*), W(*)
      DOUBLE PRECISION   TOL
      EXTERNAL           GSACR, GSRTL
      INTEGER            I, J
C
      CALL GSRTL( NU, NLAM, H, NLAM, PHI, GRP, TOL, W )
      DO 20 J = 1, NU
         DO 10 I = 1, NLAM
            HC(I,J) = H(I,J)
   10    CONTINUE
   20 CONTINUE
      DO 50 J = 1, NZ
         CALL GSACR( 1, NU, NLAM, LM, NU, HC, NLAM, Z(1,J), Z(NU+1,J),
     $               TOL, GRP, UD, LAM, W, INFO )
         IF ( INFO.EQ.1 ) RETURN
         DO 30 I = 1, NU
            Z(I,J) = UD(I)
   30    CONTINUE
         DO 40 I = 1, NLAM
            Z(NU+I,J) = LAM(I)
   40    CONTINUE
   50 CONTINUE
      INFO = 0
      END
      SUBROUTINE GSJRW( NU, NQ, NX, NV, QUASI, Z, LDZ, A, LDA, B, LDB )
C
C     PURPOSE
C     The rows of coordinates and speeds of the Jacobians of the states'
C     rates, A by states and B by inputs.
C
C     ARGUMENTS
C     NU, NQ, NX, NV (input) INTEGER, the numbers of speeds, coordinates,
C             states, inputs.
C     QUASI   (input) INTEGER: 1: the first NQ rows are there already; 0:
C             the speeds are the rates of the coordinates.
C     Z       (input) DOUBLE PRECISION array, dimension (LDZ,NX+NV), the
C             derivatives of the accelerations.
C     A, B    (output) DOUBLE PRECISION arrays, dimensions (LDA,NX),
C             (LDB,NV).
C
      IMPLICIT NONE
      INTEGER            NU, NQ, NX, NV, QUASI, LDZ, LDA, LDB
      DOUBLE PRECISION   Z(LDZ,*), A(LDA,*), B(LDB,*)
      INTEGER            I, J
C
      DO 20 J = 1, NX
         DO 10 I = 1, NU
            A(NQ+I,J) = Z(I,J)
   10    CONTINUE
   20 CONTINUE
      DO 40 J = 1, NV
         DO 30 I = 1, NU
            B(NQ+I,J) = Z(I,NX+J)
   30    CONTINUE
   40 CONTINUE
      IF ( QUASI.EQ.1 ) RETURN
      DO 70 I = 1, NU
         DO 50 J = 1, NX
            A(I,J) = 0.0D0
   50    CONTINUE
         A(I,NU+I) = 1.0D0
         DO 60 J = 1, NV
            B(I,J) = 0.0D0
   60    CONTINUE
   70 CONTINUE
      END
      SUBROUTINE GSJTH( NR, NL, NZ, BY, LDB, Z, LDZ, A, LDA )
C
C     PURPOSE
C     What rows of a Jacobian get through accelerations and multipliers:
C     A = A + BY*Z.
C
C     ARGUMENTS
C     NR, NL, NZ (input) INTEGER: BY is NR by NL, Z NL by NZ, A NR by NZ.
C     BY, Z, A DOUBLE PRECISION arrays of leading dimensions LDB, LDZ,
C             LDA; BY and Z (input), A (input/output).
C
      IMPLICIT NONE
      INTEGER            NR, NL, NZ, LDB, LDZ, LDA
      DOUBLE PRECISION   BY(LDB,*), Z(LDZ,*), A(LDA,*)
      DOUBLE PRECISION   S
      INTEGER            I, J, L, MANY
      PARAMETER          ( MANY = 6 )
C
C     -- few rows: along them; many: down the columns
      IF ( NR.LT.MIN( NZ, MANY ) ) THEN
         DO 30 I = 1, NR
            DO 20 L = 1, NL
               S = BY(I,L)
               DO 10 J = 1, NZ
                  A(I,J) = A(I,J) + S*Z(L,J)
   10          CONTINUE
   20       CONTINUE
   30    CONTINUE
         RETURN
      END IF
      DO 60 J = 1, NZ
         DO 50 L = 1, NL
            S = Z(L,J)
C$OMP SIMD
            DO 40 I = 1, NR
               A(I,J) = A(I,J) + BY(I,L)*S
   40       CONTINUE
   50    CONTINUE
   60 CONTINUE
      END
