      SUBROUTINE GSSTD( RHS, CON, KIN, CMD, CLO, VIN, METHOD, T, H, X,
     $                  NQ, NU, NX, NV, NLAM, IP, RP, CST, V, RTOL,
     $                  ATOL, W, WI, P, ISTAT, RSTAT )
C
C     PURPOSE
C     Watches for steps that are bound by the stability of an explicit
C     method: once found, that is recorded and no more is done.
C
C     ARGUMENTS
C     As GSDP8, and
C     METHOD  (input) INTEGER, as IOPT(1) of GSSIM: 4, or 8 or 9.
C     H       (input) DOUBLE PRECISION, the step from here, method 4, or
C             to here, methods 8 and 9 [s].
C     X       (input) DOUBLE PRECISION array, dimension (NX): the state
C             at T.
C     W       (input) DOUBLE PRECISION array, dimension (NX,13), methods
C             8 and 9: columns 12 and 13 as GSDP8 left them, column 1
C             the right-hand side at X.  Columns 2 to 5 are workspace,
C             with method 4 too.
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics: (13)
C             calls of RHS for this, (14) 1 if found, (15) the state
C             that the eigenvalue belongs to; memory: (16) steps that
C             looked so, (17) steps that did not since, (18) when the
C             next look is due.
C     RSTAT   (input/output) DOUBLE PRECISION array, GSSIM's statistics:
C             (18) when found [s], (19) the largest eigenvalue [1/s],
C             (20) the step [s].
C
C     METHOD
C     Method 4: the largest eigenvalue (GSSTF) before the steps 1, 11,
C     101, 1001, 2001 and so on; beyond 2.78/H the method is unstable.
C     Methods 8 and 9: two points at the end of a step, that of the last
C     stage and the result, differ mostly in the direction of the
C     largest eigenvalue; the difference of the right-hand sides there
C     tells its size.  Steps that are bound by it swing about 6.4/H; if
C     it looks beyond 5/H at 500 steps (method 9: 100) with no run of 6
C     others between, the eigenvalue itself decides, from 4/H on.  Fewer
C     steps are no loss: a system that comes to rest is soon there.
C
C     REFERENCE
C     Hairer, Wanner, Solving Ordinary Differential Equations II,
C     section IV.2 (stiffness detection).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            METHOD, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*)
      DOUBLE PRECISION   T, H, X(*), RP(*), CST(*), V(*), RTOL, ATOL(*),
     $                   W(NX,*), WI(*), P(*), RSTAT(*)
      EXTERNAL           GSSTE
      DOUBLE PRECISION   S, A, B
      INTEGER            I
C
      IF ( ISTAT(14).GT.0 .OR. ISTAT(2).LT.ISTAT(18) ) RETURN
      A = 0.0D0
      B = 0.0D0
      IF ( METHOD.NE.4 ) THEN
         DO 10 I = 1, NX
            S = ATOL(I) + RTOL*ABS( X(I) )
            IF ( S.GT.0.0D0 ) THEN
               A = A + ( ( W(I,1) - W(I,12) )/S )**2
               B = B + ( ( X(I) - W(I,13) )/S )**2
            END IF
   10    CONTINUE
      END IF
      CALL GSSTE( RHS, CON, KIN, CMD, CLO, VIN, METHOD, T, H, X, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, RTOL, ATOL, A, B,
     $            W(1,2), WI, P, ISTAT, RSTAT )
      END
      SUBROUTINE GSSTE( RHS, CON, KIN, CMD, CLO, VIN, METHOD, T, H, X,
     $                  NQ, NU, NX, NV, NLAM, IP, RP, CST, V, RTOL,
     $                  ATOL, A, B, W, WI, P, ISTAT, RSTAT )
C
C     PURPOSE
C     GSSTD with the sums of squares of the differences of the right-
C     hand sides, A, and of the states, B, each divided by its
C     tolerance.
C     W       (workspace) DOUBLE PRECISION array, dimension (NX,4).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            METHOD, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*)
      DOUBLE PRECISION   T, H, X(*), RP(*), CST(*), V(*), RTOL, ATOL(*),
     $                   A, B, W(*), WI(*), P(*), RSTAT(*)
      EXTERNAL           GSSTF
      DOUBLE PRECISION   RHO, LIMIT
      INTEGER            K, N
C
      IF ( ISTAT(14).GT.0 .OR. ISTAT(2).LT.ISTAT(18) ) RETURN
      IF ( METHOD.EQ.4 ) THEN
         ISTAT(18) = ISTAT(2) + MIN( 1000, MAX( 10, 9*ISTAT(2) ) )
         LIMIT = 2.78D0
      ELSE
         LIMIT = 4.0D0
         IF ( ABS( H )*SQRT( A ).GT.5.0D0*SQRT( B ) ) THEN
            ISTAT(16) = ISTAT(16) + 1
            ISTAT(17) = 0
         ELSE
            ISTAT(17) = ISTAT(17) + 1
            IF ( ISTAT(17).GE.6 ) ISTAT(16) = 0
         END IF
         N = 500
         IF ( METHOD.EQ.9 ) N = 100
         IF ( ISTAT(16).LT.N ) RETURN
         ISTAT(16) = 0
      END IF
      CALL GSSTF( RHS, CON, KIN, CMD, CLO, VIN, T, X, NQ, NU, NX, NV,
     $            NLAM, IP, RP, CST, V, RTOL, ATOL, ABS( H )/LIMIT, W,
     $            WI, P, ISTAT, RHO, K )
      IF ( RHO*ABS( H ).LE.LIMIT ) RETURN
      ISTAT(14) = 1
      ISTAT(15) = K
      RSTAT(18) = T
      RSTAT(19) = RHO
      RSTAT(20) = ABS( H )
      END
