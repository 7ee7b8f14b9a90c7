      SUBROUTINE GSDPO( RHS, PRJ, CON, KIN, CMD, CLO, VIN, T, TN, SIDE,
     $                  H, X, XN, SIZ, TOUT, IOPT, ROPT, IP, RP, CST, V,
     $                  F, W, P, XOUT, VOUT, IT, OFF, ISTAT, RSTAT,
     $                  INFO )
C
C     PURPOSE
C     The outputs within a step of GSDP8, from its polynomial (GSDPD),
C     moved onto the constraints as the ends of steps are.
C
C     ARGUMENTS
C     As GSDPD, and
C     SIZ, IOPT, ROPT, XOUT, VOUT (input, output) as GSSIM.
C     TOUT    (input) DOUBLE PRECISION array, dimension (NT), the output
C             times [s].
C     IT      (input/output) INTEGER, the number of the next output
C             time, which lies before TN on entry.
C     OFF     (input/output) DOUBLE PRECISION, that of GSDPQ; on entry
C             0 and more where GSEVN has told it, and left its
C             polynomial in F: no calls of RHS.
C     INFO    (output) INTEGER, as GSCHK, or 90 if the polynomial is not
C             as accurate as the step (GSDPQ); then IT is what it was.
C             With events it is not 90: GSEVN, which repeats such a step
C             before it looks for events, has seen this one; nor in a
C             step that is none but for rounding, as at a jump.
C
      IMPLICIT NONE
      EXTERNAL           RHS, PRJ, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, SIZ(8), IOPT(*), IP(*), IT, ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TN, H, X(*), XN(*), TOUT(*), ROPT(*), RP(*),
     $                   CST(*), V(*), F(*), W(*), P(*), XOUT(*),
     $                   VOUT(*), OFF, RSTAT(*)
      EXTERNAL           GSJMP, GSDPD, GSDPQ, GSDPV, GSMOV, GSINP, GSEPS
      DOUBLE PRECISION   JUMP(2), LEAST, GSEPS
      INTEGER            NQ, NU, NX, NV, I, IX, J
C
      NQ = SIZ(1)
      NU = SIZ(2)
      NX = SIZ(3)
      NV = SIZ(4)
      CALL GSJMP( NQ, NU, X, XN, ROPT(2), ROPT(4), JUMP )
      INFO = 0
      IF ( OFF.GE.0.0D0 ) THEN
         DO 5 I = 1, NX
            DO 3 J = 2, 5
               F(NX*(J+3)+I) = F(NX*(J-1)+I)
    3       CONTINUE
            F(NX+I) = RP(IP(29)-1+5*IP(IP(28))+I)
    5    CONTINUE
         GO TO 8
      END IF
      OFF = 1.0D0
      CALL GSDPD( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE, H, X, XN,
     $            NQ, NU, NX, NV, SIZ(5), IP, RP, CST, V, F, W, P,
     $            XOUT(NX*(IT-1)+1), ISTAT, RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSDPQ( NQ, NU, NX, H, X, XN, F, P, ROPT(2), ROPT(4),
     $            XOUT(NX*(IT-1)+1), F(NX*2+1), OFF )
      LEAST = GSEPS()
      LEAST = 1.0D3*LEAST*MAX( ABS( T ), ABS( TN ) )
      IF ( .NOT.( OFF.LE.1.0D0 ) .AND. IP(28).LE.0 .AND. ABS( H ).GT.
     $     LEAST ) INFO = 90
      IF ( INFO.NE.0 ) RETURN
    8 I = IT
   10 IF ( TOUT(I).LT.TN ) THEN
         IX = NX*( I - 1 ) + 1
         CALL GSDPV( NX, H, ( TOUT(I) - T )/H, X, XN, F, XOUT(IX) )
         CALL GSMOV( PRJ, CON, KIN, TOUT(I), XOUT(IX), NQ, NU, SIZ(5),
     $               IOPT, JUMP, CST, P, ISTAT, RSTAT, INFO )
         IF ( INFO.NE.0 ) RETURN
         CALL GSINP( CMD, CLO, VIN, TOUT(I), 1, XOUT(IX), NU, NX, NV,
     $               IP, RP, CST, VOUT(NV*(I-1)+1), W, INFO )
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 1
            RETURN
         END IF
         I = I + 1
         GO TO 10
      END IF
      IT = I
      ISTAT(5) = I - 1
      END
