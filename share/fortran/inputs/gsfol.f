      SUBROUTINE GSFOL( CLO, T, SIDE, NU, R, NA, IPL, NP, K, BRK, COEF,
     $                  CST, QJ, W, INFO )
C
C     PURPOSE
C     The motion of a closed chain of which NA coordinates are planned,
C     at the time T: the others come from CLO, on the branch on which
C     they were at the time before.
C
C     ARGUMENTS
C     CLO     (external) <NAME>_CLO( T, QJ, CST, RES, INFO ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     SIDE    (input) INTEGER, < 0: the limit from the left at a break.
C     NU, R   (input) INTEGER, the numbers of coordinates and of the
C             highest derivative.
C     NA      (input) INTEGER, the number of planned coordinates.
C     IPL     (input) INTEGER array, dimension (NA), their numbers.
C     NP, K, BRK, COEF (input) the planned motion, see GSPLN.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     QJ      (input/output) DOUBLE PRECISION array, dimension (NU,0:R):
C             on entry the motion at the time before (W(2) = 0: in its
C             column 0 a guess of the coordinates at T), on exit at T.
C     W       (input/output) DOUBLE PRECISION array, dimension
C             (2+NA*(R+1)+2*NU): W(1) the time of QJ [s], W(2) 1, or 0
C             if QJ holds a guess; the rest is workspace.
C     INFO    (output) INTEGER: 0; -i from GSPLN; what CLO returned; 2
C             if the chain cannot follow.
C
C     METHOD
C     Newton's method of CLO goes to some closure, near or far. From the
C     time of QJ to T the motion is followed along the plan. A step
C     counts if each dependent coordinate moves by the mean of its rates
C     at both ends times the step, but for a tenth of the larger rate
C     (and 1D-6): else another branch may have been met, and half the
C     step is tried. QJ stays on its branch when INFO is not 0.
C
      IMPLICIT NONE
      EXTERNAL           CLO, GSPLN
      INTEGER            SIDE, NU, R, NA, IPL(*), NP, K, INFO
      DOUBLE PRECISION   T, BRK(*), COEF(*), CST(*), QJ(NU,0:*), W(*)
      INTEGER            I, IF1, IQ, IU, N, SIDEN
      DOUBLE PRECISION   H, TN, DT, RES, MOVE, RATE
      LOGICAL            GOOD, ATEND
C
      IF1 = 3
      IQ  = IF1 + NA*( R + 1 ) - 1
      IU  = IQ + NU
      N   = 0
      IF ( W(2).LE.0.0D0 ) W(1) = T
      H = T - W(1)
C
   10 TN = W(1) + H
      SIDEN = 1
      IF ( ABS( TN - T ).LE.0.5D0*ABS( H ) ) TN = T
      ATEND = ABS( TN - T ).LE.0.0D0
      IF ( ATEND ) SIDEN = SIDE
      DT = TN - W(1)
      DO 20 I = 1, NU
         W(IQ+I) = QJ(I,0)
         W(IU+I) = QJ(I,1)
         IF ( W(2).GT.0.0D0 ) QJ(I,0) = QJ(I,0) + DT*QJ(I,1)
   20 CONTINUE
      CALL GSPPL( TN, SIDEN, NU, R, NA, IPL, NP, K, BRK, COEF, W(IF1),
     $            QJ, INFO )
      IF ( INFO.LT.0 ) GO TO 50
      CALL CLO( TN, QJ, CST, RES, INFO )
      GOOD = INFO.EQ.0 .AND. ( ATEND .OR. ABS( DT ).GT.0.0D0 )
      DO 30 I = 1, NU
         MOVE = QJ(I,0) - W(IQ+I) - 0.5D0*DT*( QJ(I,1) + W(IU+I) )
         RATE = MAX( ABS( QJ(I,1) ), ABS( W(IU+I) ) )
         IF ( W(2).GT.0.0D0 .AND. .NOT.( ABS( MOVE ).LE.
     $        0.1D0*ABS( DT )*RATE + 1.0D-6 ) ) GOOD = .FALSE.
   30 CONTINUE
      IF ( .NOT.GOOD ) GO TO 40
      W(1) = TN
      W(2) = 1.0D0
      H = 2.0D0*DT
      IF ( ABS( H ).GT.ABS( T - TN ) ) H = T - TN
      IF ( .NOT.ATEND ) GO TO 10
      RETURN
C
C     -- half the step
   40 IF ( W(2).LE.0.0D0 .OR. N.GE.100 .OR.
     $     ABS( DT ).LE.0.0D0 ) THEN
         IF ( INFO.EQ.0 ) INFO = 2
         GO TO 50
      END IF
      N = N + 1
      H = 0.5D0*DT
      CALL GSBAK( NU, W(IQ+1), QJ )
      GO TO 10
C
   50 CALL GSBAK( NU, W(IQ+1), QJ )
      END
C
      SUBROUTINE GSPPL( T, SIDE, NU, R, NA, IPL, NP, K, BRK, COEF, F,
     $                  QJ, INFO )
C
C     PURPOSE
C     The planned coordinates, numbers IPL, and their derivatives at the
C     time T into the rows IPL of QJ(NU,0:R); F is workspace, NA*(R+1).
C
      IMPLICIT NONE
      EXTERNAL           GSPLN
      INTEGER            SIDE, NU, R, NA, IPL(*), NP, K, INFO
      DOUBLE PRECISION   T, BRK(*), COEF(*), F(*), QJ(NU,0:*)
      INTEGER            I, J
C
      CALL GSPLN( NA, NP, K, BRK, COEF, T, SIDE, R, F, MAX( 1, NA ),
     $            INFO )
      DO 20 J = 0, R
         DO 10 I = 1, NA
            QJ(IPL(I),J) = F(I+NA*J)
   10    CONTINUE
   20 CONTINUE
      INFO = MIN( 0, INFO )
      END
C
      SUBROUTINE GSBAK( NU, W, QJ )
C
C     PURPOSE
C     Coordinates and speeds W(1..NU), W(NU+1..2*NU) back into QJ.
C
      IMPLICIT NONE
      INTEGER            NU, I
      DOUBLE PRECISION   W(*), QJ(NU,0:*)
C
      DO 10 I = 1, NU
         QJ(I,0) = W(I)
         QJ(I,1) = W(NU+I)
   10 CONTINUE
      END
