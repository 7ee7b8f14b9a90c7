      SUBROUTINE GSDTRY( RHS, PRJ, INP, SIZ, NX, CST, TZ, SIDE, NT,
     $                   TOUT, X, RTOL, ATOL, MOST, T, H, IT, RATES,
     $                   XOUT, XN, F, V, ISTAT, INFO )
C
C     PURPOSE
C     One trial step of GSRUN8, onto the constraints; the outputs within
C     it; the length of the next one.
C
C     ARGUMENTS
C     As GSRUN8, and
C     NX      (input) INTEGER, SIZ(3).
C     TZ      (input) DOUBLE PRECISION, where steps end [s].
C     SIDE    (input) INTEGER, < 0 if something switches at TZ.
C     X       (input/output) DOUBLE PRECISION array, dimension (NX), the
C             state at T, on exit that at its end if the step was good.
C     T       (input/output) DOUBLE PRECISION, the time, likewise [s].
C     H       (input/output) DOUBLE PRECISION, the step, on exit the next
C             one [s].
C     IT      (input/output) INTEGER, the number of the next output.
C     RATES   (output) INTEGER, 1 if the rates at X are to be computed.
C     XN      (workspace) DOUBLE PRECISION array, dimension (NX).
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,15),
C             column 1 the rates at X.
C     V       (workspace) DOUBLE PRECISION array, dimension (NV).
C     INFO    (output) INTEGER, 0 or 5 to 10 as GSRUN8.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, INP
      INTEGER            SIZ(12), NX, SIDE, NT, MOST, IT, RATES,
     $                   ISTAT(6), INFO
      DOUBLE PRECISION   CST(*), TZ, TOUT(NT), X(NX), RTOL, ATOL(NX), T,
     $                   H, XOUT(NX,NT), XN(NX), F(NX,15), V(*)
      DOUBLE PRECISION   GSEPS, EPS, ERR, FAC, HK, JUMP(2), OFF, TN
      EXTERNAL           GSEPS, GSDST8, GSJMP, GSDMOV, GSDOUT
      INTEGER            I, AT, DENSE
C
      EPS = GSEPS()
      HK = H
      TN = T + HK
      AT = 1
      IF ( T + 1.01D0*HK.GE.TZ ) THEN
         HK = TZ - T
         TN = TZ
         AT = SIDE
      ELSE IF ( T + 2.0D0*HK.GT.TZ ) THEN
         HK = 0.5D0*( TZ - T )
         TN = T + HK
      END IF
      INFO = 5
      IF ( MOST.GT.0 .AND. ISTAT(1) + ISTAT(2).GE.MOST ) RETURN
      INFO = 6
      IF ( HK.LE.16.0D0*EPS*MAX( ABS( T ), ABS( TZ ) ) .AND. TN.LT.TZ )
     $   RETURN
C
C     -- the step, onto the constraints, and the outputs within it
      DENSE = 0
      OFF   = 0.0D0
      CALL GSDST8( RHS, INP, T, TN, AT, HK, X, NX, SIZ(4), CST,
     $             RTOL, ATOL, V, XN, ERR, F, ISTAT, INFO )
      IF ( INFO.EQ.0 .AND. ERR.LE.1.0D0 ) THEN
         CALL GSJMP( SIZ(1), SIZ(2), X, XN, RTOL, ATOL, JUMP )
         CALL GSDMOV( PRJ, SIZ, TN, CST, JUMP, XN, F(1,14), ISTAT,
     $                INFO )
         IF ( INFO.EQ.0 .AND. TOUT(IT).LT.TN ) THEN
            DENSE = 1
            CALL GSDOUT( RHS, PRJ, INP, SIZ, NX, CST, NT, TOUT, X, RTOL,
     $                   ATOL, JUMP, T, TN, AT, HK, XN, F, V, IT, XOUT,
     $                   OFF, ISTAT, INFO )
         END IF
      END IF
C
C     -- good, or to be repeated
      IF ( INFO.EQ.0 .AND. ERR.LE.1.0D0 .AND. OFF.LE.1.0D0 ) THEN
         FAC = 6.0D0
         IF ( ERR.GT.0.0D0 ) FAC = MIN( FAC, 0.9D0*ERR**(-0.125D0) )
         IF ( OFF.GT.0.0D0 ) FAC = MIN( FAC, 0.9D0*OFF**(-0.125D0) )
         FAC = MAX( FAC, 1.0D0/3.0D0 )
         IF ( HK.GE.0.99D0*H .OR. HK*FAC.GT.H ) H = HK*FAC
         T = TN
         ISTAT(1) = ISTAT(1) + 1
         RATES = 1
         IF ( DENSE.EQ.1 .AND. AT.GT.0 ) RATES = 0
         DO 10 I = 1, NX
            X(I) = XN(I)
            IF ( DENSE.EQ.1 ) F(I,1) = F(I,2)
   10    CONTINUE
      ELSE
         ISTAT(2) = ISTAT(2) + 1
         FAC = 0.25D0
         IF ( INFO.EQ.0 .AND. ERR.LE.1.0D300 )
     $      FAC = MIN( 0.9D0, MAX( 0.2D0, 0.9D0*
     $            MAX( ERR, OFF )**(-0.125D0) ) )
         H = HK*FAC
         RATES = 0
         IF ( INFO.EQ.0 .AND. ERR.GT.1.0D300 ) INFO = 9
         IF ( H.GT.1.0D3*EPS*MAX( ABS( T ), ABS( TZ ) ) ) INFO = 0
      END IF
      END
      SUBROUTINE GSDOUT( RHS, PRJ, INP, SIZ, NX, CST, NT, TOUT, X, RTOL,
     $                   ATOL, JUMP, T, TN, AT, H, XN, F, V, IT, XOUT,
     $                   OFF, ISTAT, INFO )
C
C     PURPOSE
C     The outputs within a step of GSRUN8, from its polynomial, moved
C     onto the constraints.
C
C     ARGUMENTS
C     As GSDTRY, and
C     JUMP    (input) as GSDMOV.
C     TN, AT, H, XN (input) the end of the step, whether something
C             switches there, its length, the state there.
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,15),
C             on entry the stages of GSDST8, on exit column 2 has the
C             rates at TN.
C     OFF     (output) DOUBLE PRECISION, the error of the polynomial
C             beside three of the tolerances: above 1 it is not as
C             accurate as the step, and there are no outputs.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, INP
      INTEGER            SIZ(12), NX, NT, AT, IT, ISTAT(6), INFO
      DOUBLE PRECISION   CST(*), TOUT(NT), X(NX), RTOL, ATOL(NX),
     $                   JUMP(2), T, TN, H, XN(NX), F(NX,15), V(*),
     $                   XOUT(NX,NT), OFF
      EXTERNAL           GSDRHS, GSDEN8, GSDAT8, GSDMOV, GSEPS
      DOUBLE PRECISION   GSEPS, LEAST, S
      INTEGER            I, K
C
      OFF = 0.0D0
      CALL GSDRHS( RHS, INP, TN, AT, XN, SIZ(4), CST, V, F(1,2), ISTAT,
     $             INFO )
      IF ( INFO.EQ.0 )
     $   CALL GSDEN8( RHS, INP, T, H, X, NX, SIZ(4), CST, V, F, F(1,14),
     $                ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
C
C     -- at the place of its last stage the state is known
      CALL GSDAT8( NX, H, 7.0D0/9.0D0, X, XN, F, F(1,15) )
      K = 0
      DO 10 I = 1, NX
         S = ATOL(I) + RTOL*MAX( ABS( X(I) ), ABS( XN(I) ) )
         IF ( S.GT.0.0D0 ) THEN
            OFF = OFF + ( ( F(I,15) - F(I,14) )/S )**2
            K = K + 1
         END IF
   10 CONTINUE
      OFF = 0.3D0*SQRT( OFF/DBLE( MAX( 1, K ) ) )
      LEAST = GSEPS()
      LEAST = 1.0D3*LEAST*MAX( ABS( T ), ABS( TN ) )
      IF ( H.LE.LEAST ) OFF = MIN( OFF, 1.0D0 )
      IF ( .NOT.( OFF.LE.1.0D0 ) ) RETURN
C
      K = IT
   20 IF ( TOUT(K).LT.TN ) THEN
         CALL GSDAT8( NX, H, ( TOUT(K) - T )/H, X, XN, F, XOUT(1,K) )
         CALL GSDMOV( PRJ, SIZ, TOUT(K), CST, JUMP, XOUT(1,K), F(1,14),
     $                ISTAT, INFO )
         IF ( INFO.NE.0 ) RETURN
         K = K + 1
         GO TO 20
      END IF
      IT = K
      ISTAT(6) = K - 1
      END
      SUBROUTINE GSDHIN( RHS, INP, T, HMAX, X, NX, NV, CST, RTOL, ATOL,
     $                   V, F, ISTAT, H, INFO )
C
C     PURPOSE
C     A first step for GSDST8, from the size of the first and the second
C     derivative.
C
C     ARGUMENTS
C     As GSDST8 (F(*,1) holds the rates at (T,X)), and
C     HMAX    (input) DOUBLE PRECISION, the largest step allowed [s].
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,3).
C     H       (output) DOUBLE PRECISION, the step [s], 0 < H <= HMAX.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, section II.4 (starting step size).
C
      IMPLICIT NONE
      EXTERNAL           RHS, INP
      INTEGER            NX, NV, ISTAT(6), INFO
      DOUBLE PRECISION   T, HMAX, X(NX), CST(*), RTOL, ATOL(NX), V(*),
     $                   F(NX,3), H
      EXTERNAL           GSDRHS
      INTEGER            I
      DOUBLE PRECISION   S, D0, D1, D2, TINY
      PARAMETER          ( TINY = 1.0D-200 )
C
      D0 = 0.0D0
      D1 = 0.0D0
      DO 10 I = 1, NX
         S  = MAX( ATOL(I) + RTOL*ABS( X(I) ), TINY )
         D0 = D0 + ( X(I)/S )**2
         D1 = D1 + ( F(I,1)/S )**2
   10 CONTINUE
      H = 1.0D-6
      IF ( D0.GT.1.0D-10 .AND. D1.GT.1.0D-10 ) H = 0.01D0*SQRT( D0/D1 )
      H = MIN( H, HMAX )
      DO 20 I = 1, NX
         F(I,3) = X(I) + H*F(I,1)
   20 CONTINUE
      CALL GSDRHS( RHS, INP, T + H, -1, F(1,3), NV, CST, V, F(1,2),
     $             ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      D2 = 0.0D0
      DO 30 I = 1, NX
         S  = MAX( ATOL(I) + RTOL*ABS( X(I) ), TINY )
         D2 = D2 + ( ( F(I,2) - F(I,1) )/S )**2
   30 CONTINUE
      D2 = SQRT( D2 )/H
      S  = MAX( SQRT( D1 ), D2 )
      IF ( S.LE.1.0D-15 ) THEN
         S = MAX( 1.0D-6, 1.0D-3*H )
      ELSE
         S = ( 0.01D0/S )**0.125D0
      END IF
      H = MIN( 100.0D0*H, S, HMAX )
      END
