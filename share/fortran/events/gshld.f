      SUBROUTINE GSHLD( STK, HLD, T, X, V, MODE, CST, NV, NH, KIND, IPL,
     $                  VM, UD, LAM, HOLD, ROW, S, SD, PRM )
C
C     PURPOSE
C     The ports that may be held, as the modes in MODE have them.
C
C     ARGUMENTS
C     STK     (external) <NAME>_STK( T, X, V, CST, UD, LAM, HOLD, INFO ).
C     HLD     (external) <NAME>_HLD( T, X, V, CST, ROW, LDR, S, SD,
C             PRM ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     X, V    (input) DOUBLE PRECISION arrays, states and inputs.
C     MODE    (input) INTEGER array, dimension (NH).
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     NV, NH  (input) INTEGER, the numbers of inputs and ports.
C     KIND    (input) INTEGER array, dimension (NH): 1 friction, 2 a
C             stop.
C     IPL     (input) INTEGER array, dimension (NH): the places of the
C             modes in V.
C     VM      (output) DOUBLE PRECISION array, dimension (NV): V with
C             these modes.
C     UD, LAM (workspace) DOUBLE PRECISION arrays, of STK.
C     HOLD    (output) DOUBLE PRECISION array, dimension (NH): what holds
C             the ports, 0 where nothing does.
C     ROW, S, SD, PRM (output) DOUBLE PRECISION arrays, dimensions (NH,
C             NU), (NH), (NH), (4,NH), as HLD gives them (NU speeds).
C
      IMPLICIT NONE
      EXTERNAL           STK, HLD
      INTEGER            NV, NH, MODE(*), KIND(*), IPL(*)
      DOUBLE PRECISION   T, X(*), V(*), CST(*), VM(*), UD(*), LAM(*),
     $                   HOLD(*), ROW(NH,*), S(*), SD(*), PRM(4,*)
      INTEGER            I, HELD, INFO
C
      DO 10 I = 1, NV
         VM(I) = V(I)
   10 CONTINUE
      HELD = 0
      DO 20 I = 1, NH
         VM(IPL(I)) = DBLE( MODE(I) )
         HOLD(I) = 0.0D0
         IF ( KIND(I).EQ.2 .AND. MODE(I).NE.0 ) HELD = 1
         IF ( KIND(I).EQ.1 .AND. MODE(I).EQ.0 ) HELD = 1
   20 CONTINUE
      IF ( HELD.EQ.1 ) CALL STK( T, X, VM, CST, UD, LAM, HOLD, INFO )
      CALL HLD( T, X, VM, CST, ROW, NH, S, SD, PRM )
      END
      SUBROUTINE GSIPT( STK, HLD, MAS, CON, T, X, V, MODE, K, CST, NQ,
     $                  NU, NV, NLAM, NH, KIND, IPL, W, INFO )
C
C     PURPOSE
C     What happens at an event of a scene: modes change, speeds jump.
C
C     ARGUMENTS
C     STK, HLD (external) as in GSHLD.
C     MAS     (external) <NAME>_MAS( T, Q, CST, M, LDM ).
C     CON     (external) <NAME>_CON( T, Q, U, CST, PHI, PHIT, HC, LDH,
C             GAM, INFO ), called if NLAM > 0 (else GSNON).
C     T, CST, NV, NH, KIND, IPL as in GSHLD.
C     X       (input/output) DOUBLE PRECISION array, the states: NQ
C             coordinates, NU speeds, ...; the speeds jump.
C     V       (input/output) DOUBLE PRECISION array, the inputs; modes
C             are set.
C     MODE    (input/output) INTEGER array, dimension (NH).
C     K       (input) INTEGER, which event: see L of GSRST; -3: GSRSF;
C             -4: GSRSM; -5: GSHPJ.
C     NQ, NU, NLAM (input) INTEGER, the numbers of coordinates, speeds and
C             constraints.
C     W       (workspace) DOUBLE PRECISION array, dimension (3*NU*NU +
C             3*NU*(NLAM+NH) + NH*NU + (NLAM+NH)**2 + NV + NQ + 6*NU +
C             14*(NLAM+NH) + 10*NH + 4).
C     INFO    (output) INTEGER, 0, or as CON and GSRST.
C
      IMPLICIT NONE
      EXTERNAL           STK, HLD, MAS, CON
      INTEGER            MODE(*), K, NQ, NU, NV, NLAM, NH, KIND(*),
     $                   IPL(*), INFO
      DOUBLE PRECISION   T, X(*), V(*), CST(*), W(*)
      EXTERNAL           GSHLD, GSHPJ, GSIPM, GSRSF, GSRSM, GSRST
      INTEGER            IL, IH, IR, IS, ID, IP, IA, IJ, IT, IU, IW, I
C
C     -- inputs, accelerations, multipliers, what holds, rows, places,
C        speeds and parameters of the ports, M, H, PHIT, speeds
      IL = 1 + NV + NU
      IH = IL + MAX( 1, NLAM )
      IR = IH + NH
      IS = IR + NH*NU
      ID = IS + NH
      IP = ID + NH
      IA = IP + 4*NH
      IJ = IA + NU*NU
      IT = IJ + ( NLAM + NH )*NU
      IU = IT + MAX( 1, NLAM )
      IW = IU + NU
      INFO = 0
      IF ( K.EQ.-3 ) THEN
         CALL GSRSF( STK, HLD, T, X, V, MODE, CST, NU, NV, NH, KIND,
     $               IPL, W, W(1+NV), W(IL), W(IH), W(IR), W(IS), W(ID),
     $               W(IP) )
         RETURN
      END IF
      IF ( K.EQ.-4 ) THEN
         CALL HLD( T, X, V, CST, W(IR), NH, W(IS), W(ID), W(IP) )
         CALL GSRSM( NU, NLAM, NH, KIND, MODE, W(IR), W(IS), W(ID),
     $               W(IP), X(NQ+1) )
         RETURN
      END IF
      IF ( K.EQ.-5 ) THEN
         CALL GSHPJ( HLD, MAS, CON, T, X, V, CST, NQ, NU, NLAM, NH,
     $               KIND, MODE, W(IR), W(IS), W(ID), W(IP), W(IA),
     $               W(IJ), W(IT), W(IU), W(IW), INFO )
         RETURN
      END IF
      CALL GSHLD( STK, HLD, T, X, V, MODE, CST, NV, NH, KIND, IPL, W,
     $            W(1+NV), W(IL), W(IH), W(IR), W(IS), W(ID), W(IP) )
      CALL GSIPM( MAS, CON, T, X, CST, NQ, NU, NLAM, NH, W(IR), W(IA),
     $            W(IJ), W(IT), W(IU), W(IW), INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSRST( NU, NLAM, NH, K, KIND, MODE, W(IS), W(ID), W(IP),
     $            W(IH), W(IA), NU, W(IJ), NLAM + NH, W(IT), W(IU),
     $            W(IW), INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 10 I = 1, NU
         X(NQ+I) = W(IU+I-1)
   10 CONTINUE
      DO 20 I = 1, NH
         V(IPL(I)) = DBLE( MODE(I) )
   20 CONTINUE
      END
      SUBROUTINE GSIPM( MAS, CON, T, X, CST, NQ, NU, NLAM, NH, ROW, A,
     $                  H, PHIT, U, W, INFO )
C
C     PURPOSE
C     The mass matrix A and the Jacobian H of the loops with the rows of
C     the ports below, part of GSIPT.
C
C     ARGUMENTS
C     As in GSIPT; A(NU,NU), H(NLAM+NH,NU), PHIT (NLAM), U (NU) (output);
C     W (workspace), dimension (NQ+2*NLAM).
C
      IMPLICIT NONE
      EXTERNAL           MAS, CON
      INTEGER            NQ, NU, NLAM, NH, INFO
      DOUBLE PRECISION   T, X(*), CST(*), ROW(NH,*), A(*),
     $                   H(NLAM+NH,*), PHIT(*), U(*), W(*)
      INTEGER            I, J
C
      DO 10 I = 1, NQ
         W(I) = X(I)
   10 CONTINUE
      DO 20 I = 1, NU
         U(I) = X(NQ+I)
   20 CONTINUE
      CALL MAS( T, W, CST, A, NU )
      IF ( NLAM.GT.0 ) THEN
         CALL CON( T, W, U, CST, W(NQ+1), PHIT, H, NLAM + NH,
     $             W(NQ+NLAM+1), INFO )
         IF ( INFO.NE.0 ) RETURN
      END IF
      DO 40 J = 1, NU
         DO 30 I = 1, NH
            H(NLAM+I,J) = ROW(I,J)
   30    CONTINUE
   40 CONTINUE
      END
      SUBROUTINE GSNON
C
C     PURPOSE
C     Stands among the arguments where a scene has no such routine; it is
C     never called.
C
      RETURN
      END
