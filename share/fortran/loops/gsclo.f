      SUBROUTINE GSCLO( CON, GAD, T, QJ, NU, NLAM, R, ID, IA, CST, RES,
     $                  W, IW, INFO )
C
C     PURPOSE
C     Completes a motion of a closed chain: given the coordinates IA with
C     their derivatives and a guess of the others, finds the others.  The
C     speeds are the rates of the coordinates.
C
C     ARGUMENTS
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ).
C     GAD     (external) <NAME>_GAD( T, QJ, CST, G ): the right-hand side
C             of the third derivative, called if R > 2.
C     T       (input) DOUBLE PRECISION, the time [s].
C     QJ      (input/output) DOUBLE PRECISION array, dimension (NU,0:R):
C             column k is the k-th derivative of the motion.
C     NU, NLAM (input) INTEGER, the numbers of coordinates and of
C             constraints.
C     R       (input) INTEGER, the highest derivative, at most 3.
C     ID      (input) INTEGER array, dimension (NLAM): the dependent
C             coordinates.
C     IA      (input) INTEGER array, dimension (NU-NLAM): the others.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     RES     (output) DOUBLE PRECISION, the largest |phi| left [m or
C             rad].
C     W       (workspace) DOUBLE PRECISION array, dimension (NLAM*NLAM +
C             NLAM*NU + 4*NLAM).
C     IW      (workspace) INTEGER array, dimension (NLAM).
C     INFO    (output) INTEGER
C             = 0: done; < 0: as CON; = 1: a singular position; = 2: the
C             loops do not close.
C
C     METHOD
C     Positions: Newton's method on the dependent coordinates, at most 60
C     steps, until |phi| falls no more (below 1.0D-11) or is 0; above
C     1.0D-9 at the end the loops do not close.  Derivatives of order 1,
C     2, ...: one linear system, factored once, with other right sides.
C
      IMPLICIT NONE
      EXTERNAL           CON, GAD
      INTEGER            NU, NLAM, R, ID(*), IA(*), IW(*), INFO
      DOUBLE PRECISION   T, QJ(NU,0:*), CST(*), RES, W(*)
      EXTERNAL           GSCLQ, GSCLD
      INTEGER            IH, IP, IT, IG, IS
C
C     -- workspace: matrix, Jacobian, constraints, their rates, right
C        sides, sizes of rows
      IH = 1 + NLAM*NLAM
      IP = IH + NLAM*NU
      IT = IP + NLAM
      IG = IT + NLAM
      IS = IG + NLAM
      CALL GSCLQ( CON, T, QJ, NU, NLAM, ID, CST, RES, W, W(IH), W(IP),
     $            W(IT), W(IG), IW, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSCLD( CON, GAD, T, QJ, NU, NLAM, R, ID, IA, CST, W, W(IH),
     $            W(IP), W(IT), W(IG), W(IS), IW, INFO )
      END
      SUBROUTINE GSCLQ( CON, T, QJ, NU, NLAM, ID, CST, RES, S, H, P, PT,
     $                  G, IW, INFO )
C
C     PURPOSE
C     The dependent coordinates of a position, part of GSCLO; on exit H
C     and PT are those of CON there.
C
C     ARGUMENTS
C     As in GSCLO, and workspace: S(NLAM,NLAM), H(NLAM,NU), P, PT, G
C     (NLAM).
C
      IMPLICIT NONE
      EXTERNAL           CON
      INTEGER            NU, NLAM, ID(*), IW(*), INFO
      DOUBLE PRECISION   T, QJ(NU,0:*), CST(*), RES, S(NLAM,*),
     $                   H(NLAM,*), P(*), PT(*), G(*)
      DOUBLE PRECISION   OLD
      EXTERNAL           GSCLM, GSLEQ
      INTEGER            I, K
C
      OLD = 0.0D0
      DO 30 K = 0, 60
         CALL CON( T, QJ(1,0), QJ(1,1), CST, P, PT, H, NLAM, G, INFO )
         IF ( INFO.NE.0 .OR. K.EQ.60 ) GO TO 40
         RES = 0.0D0
         DO 10 I = 1, NLAM
            RES = MAX( RES, ABS( P(I) ) )
   10    CONTINUE
         IF ( RES.LE.0.0D0 ) RETURN
         IF ( K.GT.1 .AND. RES.GE.OLD .AND. RES.LE.1.0D-11 ) RETURN
         OLD = RES
         CALL GSCLM( NLAM, ID, H, S )
         CALL GSLEQ( NLAM, 1, S, NLAM, P, NLAM, IW, INFO )
         IF ( INFO.NE.0 ) INFO = 1
         IF ( INFO.NE.0 ) RETURN
         DO 20 I = 1, NLAM
            QJ(ID(I),0) = QJ(ID(I),0) - P(I)
   20    CONTINUE
   30 CONTINUE
   40 IF ( INFO.EQ.0 .AND. RES.GT.1.0D-9 ) INFO = 2
      END
      SUBROUTINE GSCLD( CON, GAD, T, QJ, NU, NLAM, R, ID, IA, CST, S, H,
     $                  P, PT, G, SIZ, IW, INFO )
C
C     PURPOSE
C     The derivatives of the dependent coordinates, part of GSCLO: of
C     order KIND from HC_dep*x_dep = right - HC_ind*x_ind.
C
C     ARGUMENTS
C     As in GSCLO and GSCLQ, and
C     SIZ     (workspace) DOUBLE PRECISION array, dimension (NLAM), what
C             GSLQF scales rows by.
C
      IMPLICIT NONE
      EXTERNAL           CON, GAD
      INTEGER            NU, NLAM, R, ID(*), IA(*), IW(*), INFO
      DOUBLE PRECISION   T, QJ(NU,0:*), CST(*), S(NLAM,*), H(NLAM,*),
     $                   P(*), PT(*), G(*), SIZ(*)
      EXTERNAL           GSCLM, GSLQF, GSLQS
      INTEGER            I, J, KIND
C
      IF ( R.LT.1 ) RETURN
      CALL GSCLM( NLAM, ID, H, S )
      DO 10 I = 1, NLAM
         SIZ(I) = 1.0D0
   10 CONTINUE
      CALL GSLQF( NLAM, 1, S, NLAM, SIZ, NLAM, IW, INFO )
      IF ( INFO.NE.0 ) INFO = 1
      IF ( INFO.NE.0 ) RETURN
      DO 50 KIND = 1, R
         IF ( KIND.EQ.2 ) CALL CON( T, QJ(1,0), QJ(1,1), CST, P, PT, H,
     $                              NLAM, G, INFO )
         IF ( INFO.NE.0 ) RETURN
         IF ( KIND.EQ.3 ) CALL GAD( T, QJ, CST, G )
         DO 30 I = 1, NLAM
            P(I) = G(I)
            IF ( KIND.EQ.1 ) P(I) = -PT(I)
            DO 20 J = 1, NU - NLAM
               P(I) = P(I) - H(I,IA(J))*QJ(IA(J),KIND)
   20       CONTINUE
            P(I) = SIZ(I)*P(I)
   30    CONTINUE
         CALL GSLQS( NLAM, 1, S, NLAM, P, NLAM, IW )
         DO 40 I = 1, NLAM
            QJ(ID(I),KIND) = P(I)
   40    CONTINUE
   50 CONTINUE
      END
      SUBROUTINE GSCLM( NLAM, ID, H, S )
C
C     PURPOSE
C     The columns of the dependent coordinates in H, part of GSCLO.
C
C     ARGUMENTS
C     As in GSCLO and GSCLQ.
C
      IMPLICIT NONE
      INTEGER            NLAM, ID(*)
      DOUBLE PRECISION   H(NLAM,*), S(NLAM,*)
      INTEGER            I, J
C
      DO 20 J = 1, NLAM
         DO 10 I = 1, NLAM
            S(I,J) = H(I,ID(J))
   10    CONTINUE
   20 CONTINUE
      END
