      SUBROUTINE GSRK4( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE, H, X,
     $                  NQ, NU, NX, NV, NLAM, IP, RP, CST, V, XN, W, WI,
     $                  P, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     One step of the classical Runge-Kutta method of order 4.
C
C     ARGUMENTS
C     As GSFUN, and
C     T       (input) DOUBLE PRECISION, the time of X [s].
C     TN      (input) DOUBLE PRECISION, the time at the end, T + H, as
C             the caller rounds it.
C     SIDE    (input) INTEGER, < 0 if a jump of the inputs may lie at
C             TN: the inputs are taken from the left there.
C     H       (input) DOUBLE PRECISION, the step [s].
C     X       (input/output) DOUBLE PRECISION array, dimension (NX).
C     XN      (output) DOUBLE PRECISION array, dimension (NX): the state
C             at TN.  May not share storage with X.
C     W       (workspace) DOUBLE PRECISION array, dimension (3*NX).
C     WI      (input/output) the W of GSINP.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, table II.1.2.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TN, H, X(*), RP(*), CST(*), V(*), XN(*),
     $                   W(NX,3), WI(*), P(*), RSTAT(*)
      EXTERNAL           GSFUN
      INTEGER            I
      DOUBLE PRECISION   H2, H6, TM
C
      H2 = 0.5D0*H
      H6 = H/6.0D0
      TM = T + H2
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, 1, X,
     $            NQ, NU, NX, NV, NLAM, IP, RP, CST, V, W(1,1), WI,
     $            P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 10 I = 1, NX
         W(I,3) = X(I) + H2*W(I,1)
   10 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, TM, 1, W(1,3),
     $            NQ, NU, NX, NV, NLAM, IP, RP, CST, V, W(1,2), WI,
     $            P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NX
         W(I,3) = X(I) + H2*W(I,2)
         W(I,1) = W(I,1) + 2.0D0*W(I,2)
   20 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, TM, 1, W(1,3),
     $            NQ, NU, NX, NV, NLAM, IP, RP, CST, V, W(1,2), WI,
     $            P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 30 I = 1, NX
         W(I,3) = X(I) + H*W(I,2)
         W(I,1) = W(I,1) + 2.0D0*W(I,2)
   30 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, TN, SIDE, W(1,3),
     $            NQ, NU, NX, NV, NLAM, IP, RP, CST, V, W(1,2), WI,
     $            P, ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 40 I = 1, NX
         XN(I) = X(I) + H6*( W(I,1) + W(I,2) )
   40 CONTINUE
      END
