      SUBROUTINE GSINP( CMD, CLO, VIN, T, SIDE, X, NU, NX, NV, IP, RP,
     $                  CST, V, W, INFO )
C
C     PURPOSE
C     The inputs V at time T during a compiled run: constants, a table,
C     a planned motion carried through the actuators, or a subroutine of
C     the user; with or without linear state feedback along a reference,
C        V = v0(T) - K(T)*( X - x0(T) ),
C     within limits where these are given.
C
C     ARGUMENTS
C     CMD     (external) <NAME>_CMD, called if IP(1) = 2.
C     CLO     (external) <NAME>_CLO, called if IP(1) = 2 and IP(3) = 1.
C     VIN     (external) called if IP(1) = 3:
C                CALL VIN( T, SIDE, X, NX, NV, IP, RP, CST, V, INFO ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     SIDE    (input) INTEGER, < 0: the limit from the left at a jump.
C     X       (input) DOUBLE PRECISION array, dimension (NX).
C     NU      (input) INTEGER, the number of speeds.
C     NX      (input) INTEGER, the number of states.
C     NV      (input) INTEGER, the number of inputs.
C     IP      (input) INTEGER array, what v0, K and x0 are:
C             IP(1)  v0: 0 constant, 1 piecewise polynomial (a table),
C                    2 planned motion through CMD, 3 user's VIN;
C             IP(2)  1 for state feedback, else 0;
C             IP(3)  1 if CLO completes the planned motion (loops);
C             IP(4)  R, highest derivative of the motion that CMD takes;
C             IP(5)  NA, the number of planned coordinates;
C             IP(6..9)   v0 as NP, K, IB, IC: GSPLN's pieces, order,
C                    and where in RP its breaks and coefficients begin
C                    (a constant v0 begins at RP(IP(9)));
C             IP(10..13) the planned motion, NA components;
C             IP(14..17) the reference state x0, NX components;
C             IP(18..21) the gain K, NV*NX components, by columns;
C             IP(22)     where in X the states of the devices begin, of
C                    which CMD reads the internal ones (XI); 0: none;
C             IP(23)     the number of inputs that are held outputs of
C                    sampled devices; IP(24) where in IP their numbers
C                    and IP(25) where in RP their values begin;
C             IP(26)     where in IP and IP(27) where in RP the plan of
C                    the samples begins (GSSMP); 0: there is none;
C             IP(28)     where in IP and IP(29) where in RP the plan of
C                    the events begins (GSRES); 0: there is none;
C             IP(30)     where in RP the limits of V begin, NV lower and NV
C                    upper ones, which hold with feedback; 0: none;
C             IP(30+I)   the number of the I-th planned coordinate;
C             from IP(31+NA) on: the user's own.
C     RP      (input) DOUBLE PRECISION array, breaks and coefficients,
C             held outputs.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     V       (output) DOUBLE PRECISION array, dimension (NV).
C     W       (input/output) DOUBLE PRECISION workspace, dimension
C             (2*NU*(R+1) + 5*NX + NV*NX + 20).  The first NU*(R+1)
C             entries hold QJ(NU,0:R): on entry the guess of the
C             dependent coordinates for CLO (any, where IP(3) = 0), on
C             exit the whole motion. Where IP(3) = 1 the next one is the
C             time of QJ and the one after it 1, or 0 if QJ is a guess:
C             the motion is followed from there to T (GSFOL).
C     INFO    (output) INTEGER, 0 or what CMD, CLO, VIN returned.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN
      INTEGER            SIDE, NU, NX, NV, IP(*), INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      INTEGER            I, J, K, R, NA, NS, IF1, IXI, IXR, IK, IER
C
      INFO = 0
      R   = IP(4)
      NA  = IP(5)
      IF1 = NU*( R + 1 ) + 1
      IXI = IF1 + NU*( R + 1 )
      IXR = IXI + 4*NX + 20
      IK  = IXR + NX
C
C     -- v0
      IF ( IP(1).EQ.0 ) THEN
         DO 10 I = 1, NV
            V(I) = RP(IP(9)+I-1)
   10    CONTINUE
      ELSE IF ( IP(1).EQ.1 ) THEN
         CALL GSPLN( NV, IP(6), IP(7), RP(IP(8)), RP(IP(9)), T, SIDE,
     $               0, V, MAX( 1, NV ), IER )
         IF ( IER.LT.0 ) INFO = IER
      ELSE IF ( IP(1).EQ.2 ) THEN
         IF ( IP(3).EQ.1 ) THEN
            CALL GSFOL( CLO, T, SIDE, NU, R, NA, IP(31), IP(10), IP(11),
     $                  RP(IP(12)), RP(IP(13)), CST, W, W(IF1), INFO )
         ELSE
            CALL GSPPL( T, SIDE, NU, R, NA, IP(31), IP(10), IP(11),
     $                  RP(IP(12)), RP(IP(13)), W(IF1), W, INFO )
         END IF
         DO 40 I = 1, NX
            W(IXI+I-1) = 0.0D0
            IF ( IP(22).GT.0 .AND. IP(22)+I-1.LE.NX )
     $         W(IXI+I-1) = X(IP(22)+I-1)
   40    CONTINUE
         IF ( INFO.EQ.0 )
     $      CALL CMD( T, W, W(IXI), CST, V, W(IXI+NX), INFO )
      ELSE
         CALL VIN( T, SIDE, X, NX, NV, IP, RP, CST, V, INFO )
      END IF
      IF ( INFO.NE.0 ) RETURN
      IF ( IP(2).EQ.0 ) GO TO 70
C
C     -- feedback
      CALL GSPLN( NX, IP(14), IP(15), RP(IP(16)), RP(IP(17)), T, SIDE,
     $            0, W(IXR), MAX( 1, NX ), IER )
      IF ( IER.LT.0 ) INFO = IER
      CALL GSPLN( NV*NX, IP(18), IP(19), RP(IP(20)), RP(IP(21)), T,
     $            SIDE, 0, W(IK), MAX( 1, NV*NX ), IER )
      IF ( IER.LT.0 ) INFO = IER
      DO 60 J = 1, NX
         DO 50 I = 1, NV
            V(I) = V(I) - W(IK+I-1+NV*(J-1))*( X(J) - W(IXR+J-1) )
   50    CONTINUE
   60 CONTINUE
      IF ( IP(30).LE.0 ) GO TO 70
      DO 65 I = 1, NV
         V(I) = MIN( MAX( V(I), RP(IP(30)+I-1) ), RP(IP(30)+NV+I-1) )
   65 CONTINUE
C
C     -- what is held, modes, what events of the user have switched
   70 DO 80 I = 1, IP(23)
         V(IP(IP(24)+I-1)) = RP(IP(25)+I-1)
   80 CONTINUE
      IF ( IP(28).LE.0 ) RETURN
      NA = IP(IP(28))
      J  = IP(28) + 10
      DO 90 I = 1, NA
         IF ( IP(J+NA+I-1).GT.0 ) V(IP(J+NA+I-1)) = DBLE( IP(J+I-1) )
   90 CONTINUE
      NS = IP(IP(28)+9)
      J  = IP(28) + 10 + 6*NA
      K  = IP(29) + 6*NA + 3*NX + IP(IP(28)+1)*( 3 + 2*NX )
      DO 100 I = 1, NS
         IF ( IP(J+2*NS+I-1).EQ.1 ) V(IP(J+NS+I-1)) = RP(K+I-1)
  100 CONTINUE
      END
