      SUBROUTINE GSRUN4( RHS, PRJ, INP, SIZ, CST, NB, TB, NT, TOUT, X,
     $                   H, T, XOUT, W, ISTAT, INFO )
C
C     PURPOSE
C     A run of a scene in a program of Fortran alone: the classical
C     Runge-Kutta method of order 4 with fixed steps.
C
C     ARGUMENTS
C     As GSRUN8, and
C     H       (input) DOUBLE PRECISION, the step [s], above 0. Between
C             output times and times of TB steps are equal and at most
C             as long as that.
C     W       (workspace) DOUBLE PRECISION array, dimension
C             (4*NX + NV).
C     INFO    (output) INTEGER, as GSRUN8; never 6.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, table II.1.2.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, INP
      INTEGER            SIZ(12), NB, NT, ISTAT(6), INFO
      DOUBLE PRECISION   CST(*), TB(*), TOUT(NT), X(*), H, T,
     $                   XOUT(*), W(*)
      INTEGER            GSFIN
      EXTERNAL           GSDBEG, GSDSTP, GSDST4, GSDMOV, GSFIN
      DOUBLE PRECISION   TA, TN, TZ, HK, MANY, JUMP(2)
      INTEGER            I, IT, IV, K, N, NX, AT, SIDE
C
      NX = SIZ(3)
      IV = 4*NX + 1
      CALL GSDBEG( PRJ, SIZ, CST, NB, TB, NT, TOUT, X, XOUT, W, ISTAT,
     $             INFO )
      IF ( INFO.NE.0 ) RETURN
      INFO = -11
      IF ( GSFIN( 1, H ).NE.0 .OR. .NOT.( H.GT.0.0D0 ) ) RETURN
      T  = TOUT(1)
      IT = 2
      JUMP(1) = 0.0D0
      JUMP(2) = 0.0D0
C
C     -- from stop to stop
   10 INFO = 0
      IF ( IT.GT.NT ) RETURN
      TA = T
      CALL GSDSTP( NB, TB, TA, TOUT(IT), TZ, SIDE )
      MANY = ( TZ - TA )/H*( 1.0D0 - 1.0D-9 )
      INFO = 5
      IF ( MANY.GT.2.0D9 ) RETURN
      N  = INT( MANY ) + 1
      HK = ( TZ - TA )/DBLE( N )
      DO 30 K = 1, N
         TN = TA + DBLE( K )*HK
         AT = 1
         IF ( K.EQ.N ) THEN
            TN = TZ
            AT = SIDE
         END IF
         CALL GSDST4( RHS, INP, T, TN, AT, HK, X, NX, SIZ(4), CST,
     $                W(IV), W, W(NX+1), ISTAT, INFO )
         IF ( INFO.EQ.0 )
     $      CALL GSDMOV( PRJ, SIZ, TN, CST, JUMP, W, W(NX+1), ISTAT,
     $                   INFO )
         IF ( INFO.NE.0 ) RETURN
         DO 20 I = 1, NX
            X(I) = W(I)
   20    CONTINUE
         T = TN
         ISTAT(1) = ISTAT(1) + 1
   30 CONTINUE
      IF ( T.GE.TOUT(IT) ) THEN
         DO 40 I = 1, NX
            XOUT(NX*(IT-1)+I) = X(I)
   40    CONTINUE
         ISTAT(6) = IT
         IT = IT + 1
      END IF
      GO TO 10
      END
      SUBROUTINE GSDST4( RHS, INP, T, TN, SIDE, H, X, NX, NV, CST, V,
     $                   XN, F, ISTAT, INFO )
C
C     PURPOSE
C     One step of the classical Runge-Kutta method of order 4.
C
C     ARGUMENTS
C     As GSDST8, and
C     F       (workspace) DOUBLE PRECISION array, dimension (NX,3).
C
      IMPLICIT NONE
      EXTERNAL           RHS, INP
      INTEGER            SIDE, NX, NV, ISTAT(6), INFO
      DOUBLE PRECISION   T, TN, H, X(NX), CST(*), V(*), XN(NX), F(NX,3)
      EXTERNAL           GSDRHS
      INTEGER            I
      DOUBLE PRECISION   H2, H6, TM
C
      H2 = 0.5D0*H
      H6 = H/6.0D0
      TM = T + H2
      CALL GSDRHS( RHS, INP, T, 1, X, NV, CST, V, F(1,1), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 10 I = 1, NX
         F(I,3) = X(I) + H2*F(I,1)
   10 CONTINUE
      CALL GSDRHS( RHS, INP, TM, 1, F(1,3), NV, CST, V, F(1,2), ISTAT,
     $             INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NX
         F(I,3) = X(I) + H2*F(I,2)
         F(I,1) = F(I,1) + 2.0D0*F(I,2)
   20 CONTINUE
      CALL GSDRHS( RHS, INP, TM, 1, F(1,3), NV, CST, V, F(1,2), ISTAT,
     $             INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 30 I = 1, NX
         F(I,3) = X(I) + H*F(I,2)
         F(I,1) = F(I,1) + 2.0D0*F(I,2)
   30 CONTINUE
      CALL GSDRHS( RHS, INP, TN, SIDE, F(1,3), NV, CST, V, F(1,2),
     $             ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 40 I = 1, NX
         XN(I) = X(I) + H6*( F(I,1) + F(I,2) )
   40 CONTINUE
      END
