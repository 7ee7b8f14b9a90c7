      SUBROUTINE GSNIK( PNT, JPT, KIN, CON, T, NQ, NU, NLAM, NPT, K,
     $                  JOB, P, R, Q, QLO, QHI, IV, NS, ISET, CST, W,
     $                  DST, INFO )
C
C     PURPOSE
C     Coordinates that bring a point or frame of a scene to a pose, from
C     a guess, within limits and with the loops closed.
C
C     ARGUMENTS
C     PNT, JPT, KIN, CON (external) the scene's routines of these names;
C             CON is called if NLAM > 0.
C     T       (input) DOUBLE PRECISION, the time [s].
C     NQ, NU, NLAM (input) INTEGER, coordinates, speeds, constraints.
C     NPT     (input) INTEGER, points and frames of the scene.
C     K       (input) INTEGER, which of them is brought, 1 <= K <= NPT.
C     JOB     (input) INTEGER, 1: place and axes are given; 0: the place.
C     P       (input) DOUBLE PRECISION array, dimension (3): the place in
C             ground axes [m].
C     R       (input) DOUBLE PRECISION array, dimension (3,3): the axes in
C             ground axes, a column each [1].
C     Q       (input/output) DOUBLE PRECISION array, dimension (NQ): the
C             guess, on exit the best position found [rad, m].
C     QLO, QHI (input) DOUBLE PRECISION arrays, dimension (NQ): limits of
C             the coordinates [rad, m].
C     IV      (input) INTEGER array, dimension (NQ): the number of the
C             speed that is the rate of a coordinate, or 0.
C     NS, ISET as GSNRM.
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     W       (workspace) DOUBLE PRECISION array, dimension (NU*NU +
C             (6+NLAM)*(NU+2) + 2*NU + 3*NQ + 12*NPT + 6*NPT*(NU+1) +
C             NLAM*(NU+3)).
C     DST     (output) DOUBLE PRECISION array, dimension (2): what the
C             position misses, of the place [m], of the axes [rad].
C     INFO    (output) INTEGER
C             = 0: the pose is reached, DST and |phi| are below 1D-9;
C             = 1: it is not; no position near Q comes closer;
C             < 0: as CON.
C
C     METHOD
C     Newton's method of least squares with damping (GSNIT). Where it ends
C     without the pose, as on a position between two ways to it (a closed
C     chain stretched out), it begins again from five positions beside
C     the best one, 0.03 to 0.5 rad or m away. What is not reached then is
C     approached with phi counting a thousand times, so that DST is the
C     distance with the loops closed, to 1D-6 of itself.
C
C     REFERENCES
C     D. Marquardt, SIAM J. Appl. Math. 11 (1963), 431-441.
C
      IMPLICIT NONE
      EXTERNAL           PNT, JPT, KIN, CON
      INTEGER            NQ, NU, NLAM, NPT, K, JOB, IV(NQ), NS
      INTEGER            ISET(4,*), INFO
      DOUBLE PRECISION   T, P(3), R(3,3), Q(NQ), QLO(NQ), QHI(NQ)
      DOUBLE PRECISION   CST(*), W(*), DST(2)
      DOUBLE PRECISION   F, FB, FAR
      INTEGER            NR, IS, IB, IU, IW, I, N
      EXTERNAL           GSNIR, GSNIT
C
      NR = 3 + 3*JOB + NLAM
      IS = 1 + ( 2 + NU )*NR
      IU = IS + NU + NQ + NU*NU
      IB = IU + NU
      IW = IB + NQ
      FB = 0.0D0
      FAR = 0.03D0
      DO 60 N = 0, 5
         IF ( N.GT.0 ) THEN
CGCC$ NOVECTOR
            DO 20 I = 1, NU
               W(IS+I-1) = FAR*SIN( 1.0D0*( 2*I + 3*N*I + N ) )
   20       CONTINUE
            CALL KIN( T, W(IB), W(IS), CST, Q )
            DO 30 I = 1, NQ
               Q(I) = W(IB+I-1) + Q(I)
   30       CONTINUE
            FAR = 2.0D0*FAR
         END IF
         CALL GSNIT( PNT, JPT, KIN, CON, T, NQ, NU, NLAM, NPT, K, JOB,
     $               P, R, Q, QLO, QHI, IV, NS, ISET, CST, 1.0D0, W,
     $               W(IW), F, DST, INFO )
         IF ( INFO.LT.0 ) RETURN
         IF ( N.EQ.0 .OR. F.LT.0.999D0*FB ) THEN
            FB = F
            DO 40 I = 1, NQ
               W(IB+I-1) = Q(I)
   40       CONTINUE
         END IF
         IF ( FB.LE.1.0D-9 ) GO TO 70
   60 CONTINUE
   70 CONTINUE
      DO 80 I = 1, NQ
         Q(I) = W(IB+I-1)
   80 CONTINUE
      IF ( FB.GT.1.0D-9 .AND. NLAM.GT.0 ) CALL GSNIT( PNT, JPT, KIN,
     $     CON, T, NQ, NU, NLAM, NPT, K, JOB, P, R, Q, QLO, QHI, IV, NS,
     $     ISET, CST, 1.0D3, W, W(IW), F, DST, INFO )
      IF ( INFO.LT.0 ) RETURN
      DO 90 I = 1, NU
         W(IU+I-1) = 0.0D0
   90 CONTINUE
      CALL GSNIR( PNT, CON, T, NU, NLAM, NPT, K, JOB, P, R, Q, W(IU),
     $            CST, 1.0D0, W, NR, W(IW), F, DST, INFO )
      IF ( INFO.LT.0 ) RETURN
      INFO = 0
      IF ( .NOT.( F.LE.1.0D-9 ) ) INFO = 1
      END
C
      SUBROUTINE GSNIT( PNT, JPT, KIN, CON, T, NQ, NU, NLAM, NPT, K,
     $                  JOB, P, R, Q, QLO, QHI, IV, NS, ISET, CST, WT,
     $                  W, WP, F, DST, INFO )
C
C     PURPOSE
C     For GSNIK: from a guess to where nothing near comes closer.
C
C     ARGUMENTS
C     as GSNIK, and
C     WT      (input) DOUBLE PRECISION, how much phi counts.
C     WP      (workspace) DOUBLE PRECISION array, dimension (12*NPT +
C             6*NPT*(NU+1) + NLAM*(NU+3)).
C     F       (output) DOUBLE PRECISION, what Q misses.
C
C     METHOD
C     Newton's method of least squares with damping (Levenberg and
C     Marquardt) on place, rotation vector and phi, on the exact Jacobian;
C     a coordinate at its limit does not move beyond it. At most 200
C     steps, none longer than 0.5 rad or m.
C
C     ERROR INDICATOR
C     INFO as CON.
C
      IMPLICIT NONE
      EXTERNAL           PNT, JPT, KIN, CON
      INTEGER            NQ, NU, NLAM, NPT, K, JOB, IV(NQ), NS
      INTEGER            ISET(4,*), INFO
      DOUBLE PRECISION   T, P(3), R(3,3), Q(NQ), QLO(NQ), QHI(NQ)
      DOUBLE PRECISION   CST(*), WT, W(*), WP(*), DST(2)
      DOUBLE PRECISION   F, FN, MU, ERR
      INTEGER            NR, IR, IRN, IJ, IS, IQ, IA, IU, I, N
      EXTERNAL           GSNIR, GSNIJ, GSNIS, GSNRM
C
      NR = 3 + 3*JOB + NLAM
      IR = 1
      IRN = IR + NR
      IJ = IRN + NR
      IS = IJ + NR*NU
      IQ = IS + NU
      IA = IQ + NQ
      IU = IA + NU*NU
      ERR = 0.0D0
      DO 10 I = 1, NQ
         Q(I) = MIN( MAX( Q(I), QLO(I) ), QHI(I) )
   10 CONTINUE
      CALL GSNRM( NS, ISET, Q, ERR )
      DO 20 I = 0, NU - 1
         W(IU+I) = 0.0D0
   20 CONTINUE
      CALL GSNIR( PNT, CON, T, NU, NLAM, NPT, K, JOB, P, R, Q,
     $            W(IU), CST, WT, W(IR), NR, WP, F, DST, INFO )
      IF ( INFO.LT.0 ) RETURN
      MU = 1.0D-3
      DO 50 N = 1, 200
         IF ( F.LE.1.0D-15 ) RETURN
         CALL GSNIJ( JPT, CON, T, Q, NU, NLAM, NPT, K, JOB, W(IU), CST,
     $               WT, W(IJ), NR, WP, INFO )
         IF ( INFO.LT.0 ) RETURN
   30    CONTINUE
         CALL GSNIS( KIN, T, NQ, NU, NR, W(IJ), W(IR), MU, Q, QLO, QHI,
     $               IV, W(IU), CST, W(IA), W(IS), W(IQ), WP )
         CALL GSNRM( NS, ISET, W(IQ), ERR )
         CALL GSNIR( PNT, CON, T, NU, NLAM, NPT, K, JOB, P, R,
     $               W(IQ), W(IU), CST, WT, W(IRN), NR, WP, FN, DST,
     $               INFO )
         IF ( INFO.LT.0 ) RETURN
         IF ( .NOT.( FN.LT.F ) ) THEN
            MU = 8.0D0*MU
            IF ( MU.LE.1.0D8 ) GO TO 30
            RETURN
         END IF
         MU = MAX( 0.1D0*MU, 1.0D-14 )
         DO 40 I = 0, NQ - 1
            Q(1+I) = W(IQ+I)
   40    CONTINUE
         DO 45 I = 0, NR - 1
            W(IR+I) = W(IRN+I)
   45    CONTINUE
         F = FN
   50 CONTINUE
      END
C
      SUBROUTINE GSNIR( PNT, CON, T, NU, NLAM, NPT, K, JOB, P, R, Q,
     $                  U, CST, WT, RES, NR, W, F, DST, INFO )
C
C     PURPOSE
C     For GSNIK: what a position misses.
C
C     ARGUMENTS
C     as GSNIK, and
C     U       (input) DOUBLE PRECISION array, dimension (NU): zeros.
C     WT      (input) DOUBLE PRECISION, how much phi counts.
C     RES     (output) DOUBLE PRECISION array, dimension (NR): place,
C             rotation vector, WT*phi: what is wanted less what is there.
C     NR      (input) INTEGER, 3 + 3*JOB + NLAM.
C     W       (workspace) DOUBLE PRECISION array, dimension (12*NPT +
C             NLAM*(NU+3)).
C     F       (output) DOUBLE PRECISION, the length of RES.
C
C     METHOD
C     Places and axes by PNT.
C
C     ERROR INDICATOR
C     INFO as CON.
C
      IMPLICIT NONE
      EXTERNAL           PNT, CON
      INTEGER            NU, NLAM, NPT, K, JOB, NR, INFO
      DOUBLE PRECISION   T, P(3), R(3,3), Q(*), U(NU), CST(*), RES(NR)
      DOUBLE PRECISION   WT, W(*), F, DST(2)
      INTEGER            I, IC
      EXTERNAL           GSNIV
C
      INFO = 0
      CALL PNT( T, Q, CST, W, W(1+3*NPT) )
      DO 10 I = 1, 3
         RES(I) = P(I) - W(3*(K-1)+I)
   10 CONTINUE
      DST(1) = SQRT( RES(1)**2 + RES(2)**2 + RES(3)**2 )
      DST(2) = 0.0D0
      IF ( JOB.EQ.1 ) THEN
         CALL GSNIV( R, W(1+3*NPT+9*(K-1)), RES(4) )
         DST(2) = SQRT( RES(4)**2 + RES(5)**2 + RES(6)**2 )
      END IF
      IF ( NLAM.GT.0 ) THEN
         IC = 1 + 12*NPT
         CALL CON( T, Q, U, CST, RES(4+3*JOB), W(IC), W(IC+NLAM), NLAM,
     $             W(IC+NLAM+NLAM*NU), INFO )
         DO 20 I = 4 + 3*JOB, NR
            RES(I) = -WT*RES(I)
   20    CONTINUE
      END IF
      F = 0.0D0
      DO 30 I = 1, NR
         F = F + RES(I)**2
   30 CONTINUE
      F = SQRT( F )
      END
C
      SUBROUTINE GSNIV( R, S, V )
C
C     PURPOSE
C     The rotation vector V that turns axes S into axes R.
C
C     ARGUMENTS
C     R, S    (input) DOUBLE PRECISION arrays, dimension (3,3): axes, a
C             column each [1].
C     V       (output) DOUBLE PRECISION array, dimension (3) [rad].
C
C     METHOD
C     Axis and sine from the skew part of R S', close to half a turn the
C     axis from the symmetric part.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   R(3,3), S(3,3), V(3), E(3,3), A(3), SI, CO, TH
      DOUBLE PRECISION   D
      INTEGER            I, J, L
C
      DO 20 I = 1, 3
         DO 10 J = 1, 3
            E(I,J) = R(I,1)*S(J,1) + R(I,2)*S(J,2) + R(I,3)*S(J,3)
   10    CONTINUE
   20 CONTINUE
      V(1) = 0.5D0*( E(3,2) - E(2,3) )
      V(2) = 0.5D0*( E(1,3) - E(3,1) )
      V(3) = 0.5D0*( E(2,1) - E(1,2) )
      SI = SQRT( V(1)**2 + V(2)**2 + V(3)**2 )
      CO = 0.5D0*( E(1,1) + E(2,2) + E(3,3) - 1.0D0 )
      TH = ATAN2( SI, CO )
      IF ( SI.GT.1.0D-3 .OR. CO.GT.0.0D0 ) THEN
         IF ( SI.GT.0.0D0 ) THEN
            DO 30 I = 1, 3
               V(I) = V(I)*( TH/SI )
   30       CONTINUE
         END IF
         RETURN
      END IF
      L = 1
      IF ( E(2,2).GT.E(L,L) ) L = 2
      IF ( E(3,3).GT.E(L,L) ) L = 3
      D = 0.0D0
      SI = 0.0D0
      DO 40 I = 1, 3
         A(I) = 0.5D0*( E(I,L) + E(L,I) )
         IF ( I.EQ.L ) A(I) = A(I) - CO
         D = D + A(I)**2
         SI = SI + A(I)*V(I)
   40 CONTINUE
      D = SIGN( SQRT( D ), SI )
      DO 50 I = 1, 3
         V(I) = A(I)*( TH/D )
   50 CONTINUE
      END
C
      SUBROUTINE GSNIJ( JPT, CON, T, Q, NU, NLAM, NPT, K, JOB, U, CST,
     $                  WT, RJ, NR, W, INFO )
C
C     PURPOSE
C     For GSNIK: the Jacobian of place, rotation and phi in the speeds.
C
C     ARGUMENTS
C     as GSNIR, and
C     RJ      (output) DOUBLE PRECISION array, dimension (NR,NU).
C     W       (workspace) DOUBLE PRECISION array, dimension (6*NPT*(NU+1)
C             + NLAM*(NU+3)).
C
C     METHOD
C     JPT and CON.
C
C     ERROR INDICATOR
C     INFO as CON.
C
      IMPLICIT NONE
      EXTERNAL           JPT, CON
      INTEGER            NU, NLAM, NPT, K, JOB, NR, INFO
      DOUBLE PRECISION   T, Q(*), U(NU), CST(*), WT, RJ(NR,NU), W(*)
      INTEGER            I, J, L, IC, N
C
      INFO = 0
      N = 3 + 3*JOB
      CALL JPT( T, Q, U, CST, W, W(1+6*NPT*NU) )
      DO 20 J = 1, NU
         L = 6*( ( K - 1 )*NU + J - 1 )
         DO 10 I = 1, N
            RJ(I,J) = W(L+I)
   10    CONTINUE
   20 CONTINUE
      IF ( NLAM.EQ.0 ) RETURN
      IC = 1 + 6*NPT*( NU + 1 )
      CALL CON( T, Q, U, CST, W(IC), W(IC+NLAM), W(IC+2*NLAM), NLAM,
     $          W(IC+2*NLAM+NLAM*NU), INFO )
      DO 40 J = 1, NU
         DO 30 I = 1, NLAM
            RJ(N+I,J) = WT*W(IC+2*NLAM+(J-1)*NLAM+I-1)
   30    CONTINUE
   40 CONTINUE
      END
C
      SUBROUTINE GSNIS( KIN, T, NQ, NU, NR, RJ, RES, MU, Q, QLO, QHI,
     $                  IV, U, CST, A, S, QN, QDOT )
C
C     PURPOSE
C     For GSNIK: one damped step, QN, from Q.
C
C     ARGUMENTS
C     as GSNIK, GSNIR and GSNIJ, and
C     MU      (input) DOUBLE PRECISION, the damping.
C     A       (workspace) DOUBLE PRECISION array, dimension (NU,NU).
C     S       (workspace) DOUBLE PRECISION array, dimension (NU).
C     QN      (output) DOUBLE PRECISION array, dimension (NQ).
C     QDOT    (workspace) DOUBLE PRECISION array, dimension (NQ).
C
C     METHOD
C     (J'J + MU) S = J' RES; speeds of coordinates at a limit that S would
C     pass are held and the rest solved anew.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      EXTERNAL           KIN
      INTEGER            NQ, NU, NR, IV(NQ)
      DOUBLE PRECISION   T, RJ(NR,NU), RES(NR), MU, Q(NQ), QLO(NQ)
      DOUBLE PRECISION   QHI(NQ), U(NU), CST(*), A(NU,NU), S(NU)
      DOUBLE PRECISION   QN(NQ), QDOT(NQ), BIG
      INTEGER            I, J, L, INFO, MORE, TRY
      EXTERNAL           GSSPD
C
      DO 5 J = 1, NU
         U(J) = 0.0D0
    5 CONTINUE
      DO 60 TRY = 1, NU + 1
         DO 20 J = 1, NU
            DO 10 I = 1, J
               A(I,J) = 0.0D0
               DO 8 L = 1, NR
                  A(I,J) = A(I,J) + RJ(L,I)*RJ(L,J)
    8          CONTINUE
               IF ( MAX( U(I), U(J) ).GT.0.5D0 ) A(I,J) = 0.0D0
               A(J,I) = A(I,J)
   10       CONTINUE
            A(J,J) = A(J,J) + MU
            S(J) = 0.0D0
            DO 15 L = 1, NR
               S(J) = S(J) + RJ(L,J)*RES(L)
   15       CONTINUE
            IF ( U(J).GT.0.5D0 ) S(J) = 0.0D0
   20    CONTINUE
         CALL GSSPD( NU, 1, A, NU, S, NU, INFO )
         MORE = 0
         DO 30 I = 1, NQ
            J = IV(I)
            IF ( J.GT.0 ) THEN
               IF ( U(J).LT.0.5D0 .AND.
     $              ( ( Q(I).LE.QLO(I) .AND. S(J).LT.0.0D0 ) .OR.
     $                ( Q(I).GE.QHI(I) .AND. S(J).GT.0.0D0 ) ) ) THEN
                  U(J) = 1.0D0
                  MORE = 1
               END IF
            END IF
   30    CONTINUE
         IF ( MORE.EQ.0 ) GO TO 70
   60 CONTINUE
   70 CONTINUE
      BIG = 0.0D0
      DO 80 J = 1, NU
         BIG = MAX( BIG, ABS( S(J) ) )
   80 CONTINUE
      DO 90 J = 1, NU
         IF ( BIG.GT.0.5D0 ) S(J) = S(J)*( 0.5D0/BIG )
         U(J) = 0.0D0
   90 CONTINUE
      CALL KIN( T, Q, S, CST, QDOT )
      DO 100 I = 1, NQ
         QN(I) = MIN( MAX( Q(I) + QDOT(I), QLO(I) ), QHI(I) )
  100 CONTINUE
      END
