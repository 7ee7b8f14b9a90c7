      SUBROUTINE GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, SIDE, X, NQ,
     $                  NU, NX, NV, NLAM, IP, RP, CST, V, XD, W, P,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The right-hand side under its inputs: V by GSINP, XD by RHS.
C
C     ARGUMENTS
C     As GSINP; RHS (external) is <NAME>_RHS, and
C     CON, KIN (external) see GSPRT, called if P(1) > 0.
C     X       (input/output) DOUBLE PRECISION array, dimension (NX): if
C             P(1) > 0 its dependent speeds, and if P(1) > 1 its
C             dependent coordinates as well, are completed first.
C     NQ, NLAM (input) INTEGER, the numbers of coordinates and of
C             constraints.
C     V       (input/output) DOUBLE PRECISION array, dimension (NV):
C             kept where it is constant (IP(1) = IP(2) = 0).
C     XD      (output) DOUBLE PRECISION array, dimension (NX).
C     P       (input/output) DOUBLE PRECISION array, the partition, see
C             GSPRT.
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics: entry 1
C             counts the calls, entry 8 those where the constraints lost
C             rank (RHS returned 2: its result is usable, multipliers
C             are not unique), entry 9 those close to a singularity of
C             orientation angles (RHS returned 3); on failure entry 6 is
C             the INFO of the routine that failed and entry 7 names it:
C             1 the inputs, 2 RHS, 5 the partition.
C     RSTAT   (input/output) DOUBLE PRECISION array, GSSIM's statistics:
C             10 and 11 the first and the last time of the calls in
C             ISTAT(8), 12 and 13 of those in ISTAT(9).
C     INFO    (output) INTEGER, 0 or the INFO of what failed.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), XD(*), W(*),
     $                   P(*), RSTAT(*)
      EXTERNAL           GSFUT
      DOUBLE PRECISION   TV, TF
C
      TV = T
      TF = T
      CALL GSFUT( RHS, CON, KIN, CMD, CLO, VIN, T, TV, TF, SIDE, X, NQ,
     $            NU, NX, NV, NLAM, IP, RP, CST, V, XD, W, P, ISTAT,
     $            RSTAT, INFO )
      END
      SUBROUTINE GSFUT( RHS, CON, KIN, CMD, CLO, VIN, T, TV, TF, SIDE,
     $                  X, NQ, NU, NX, NV, NLAM, IP, RP, CST, V, XD, W,
     $                  P, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     GSFUN with the inputs as they go on from the time TV to TF: the
C     stages of GSPSG that lie beyond a jump of the inputs, at TV, have
C     those before it, continued.  Where TF and TV differ V has 2*NV
C     entries.  With SIDE < 0 RHS is called just before T (GSLFT).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TV, TF, X(*), RP(*), CST(*), V(*), XD(*),
     $                   W(*), P(*), RSTAT(*)
      DOUBLE PRECISION   GSLFT
      EXTERNAL           GSINP, GSINC, GSPRT, GSLFT
      INTEGER            K
C
      INFO = 0
      IF ( P(1).GT.0.0D0 ) THEN
         CALL GSPRT( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 5
            RETURN
         END IF
      END IF
      IF ( IP(1).NE.0 .OR. IP(2).NE.0 ) THEN
         IF ( TF.GE.TV .AND. TF.LE.TV ) THEN
            CALL GSINP( CMD, CLO, VIN, TV, SIDE, X, NU, NX, NV, IP, RP,
     $                  CST, V, W, INFO )
         ELSE
            CALL GSINC( CMD, CLO, VIN, TV, TF, X, NU, NX, NV, IP, RP,
     $                  CST, V, V(NV+1), W, INFO )
         END IF
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 1
            RETURN
         END IF
      END IF
      CALL RHS( GSLFT( T, SIDE ), X, V, CST, XD, INFO )
      ISTAT(1) = ISTAT(1) + 1
      IF ( INFO.EQ.2 .OR. INFO.EQ.3 ) THEN
         K = INFO + 6
         IF ( ISTAT(K).EQ.0 ) RSTAT(2*K-6) = T
         RSTAT(2*K-5) = T
         ISTAT(K) = ISTAT(K) + 1
         INFO = 0
      ELSE IF ( INFO.NE.0 ) THEN
         ISTAT(6) = INFO
         ISTAT(7) = 2
      END IF
      END
      SUBROUTINE GSINC( CMD, CLO, VIN, TV, TF, X, NU, NX, NV, IP, RP,
     $                  CST, V, VK, W, INFO )
C
C     PURPOSE
C     The inputs V at TF as those on the other side of TV go on there:
C     by the polynomial of degree 5 through six values as far from TV as
C     TF at most, so that five derivatives are continuous at TV.
C     VK is workspace of NV entries, the rest as GSINP.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN
      INTEGER            NU, NX, NV, IP(*), INFO
      DOUBLE PRECISION   TV, TF, X(*), RP(*), CST(*), V(*), VK(*), W(*)
      DOUBLE PRECISION   Z(6), S
      EXTERNAL           GSINP
      INTEGER            I, J, K
C
CGCC$ NOVECTOR
      DO 10 K = 1, 6
         Z(K) = -SIN( ATAN( 1.0D0 )*DBLE( 2*K - 1 )/6.0D0 )**2
   10 CONTINUE
      DO 20 I = 1, NV
         V(I) = 0.0D0
   20 CONTINUE
      DO 50 K = 1, 6
         CALL GSINP( CMD, CLO, VIN, TV + Z(K)*( TF - TV ), 1, X, NU, NX,
     $               NV, IP, RP, CST, VK, W, INFO )
         IF ( INFO.NE.0 ) RETURN
         S = 1.0D0
         DO 30 J = 1, 6
            IF ( J.NE.K ) S = S*( 1.0D0 - Z(J) )/( Z(K) - Z(J) )
   30    CONTINUE
         DO 40 I = 1, NV
            V(I) = V(I) + S*VK(I)
   40    CONTINUE
   50 CONTINUE
      END
