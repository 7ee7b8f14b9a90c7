      SUBROUTINE GSDPD( RHS, CON, KIN, CMD, CLO, VIN, T, TN, SIDE, H, X,
     $                  XN, NQ, NU, NX, NV, NLAM, IP, RP, CST, V, F, W,
     $                  P, Z, ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     Behind a step of GSDP8 its polynomial of order 7: the rates at its
C     end and three stages more.
C
C     ARGUMENTS
C     As GSDP8, and
C     XN      (input/output) DOUBLE PRECISION array, dimension (NX), the
C             state at TN, as it was moved onto the constraints; GSFUN
C             may complete it.
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,13):
C             on entry the stages of GSDP8; on exit column 2 holds the
C             rates at TN, 6 to 9 the coefficients that GSDPV takes;
C             columns 1, 12 and 13 stay.
C     W       (input/output) the W of GSINP.
C     Z       (workspace) DOUBLE PRECISION array, dimension (NX).
C     INFO    (output) INTEGER, 0 or the INFO of what failed.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TN, H, X(*), XN(*), RP(*), CST(*), V(*),
     $                   F(NX,13), W(*), P(*), Z(*), RSTAT(*)
      EXTERNAL           GSFUN, GSDPE
C
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, TN, SIDE, XN, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, F(1,2), W, P, ISTAT,
     $            RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      CALL GSDPE( RHS, CON, KIN, CMD, CLO, VIN, T, H, X, NQ, NU, NX, NV,
     $            NLAM, IP, RP, CST, V, F, 6, W, P, Z, ISTAT, RSTAT,
     $            INFO )
      END
      SUBROUTINE GSDPE( RHS, CON, KIN, CMD, CLO, VIN, T, H, X, NQ, NU,
     $                  NX, NV, NLAM, IP, RP, CST, V, F, K, W, P, Z,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The coefficients of the polynomial of GSDPD: three stages more.
C
C     ARGUMENTS
C     As GSDPD, but
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,13):
C             on entry the stages of GSDP8, in column 2 the rates at the
C             end of the step; on exit columns K to K + 3 hold the
C             coefficients that GSDPU takes; 3 to 5 are changed, the
C             others stay.
C     K       (input) INTEGER, 2 or 6.
C
C     METHOD
C     The coefficients are the published ones, carried on to 38 digits
C     as in GSDP8: A the nearest solution of the quadrature conditions
C     of its stages, D the nearest one of the conditions up to order 7.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, section II.6 (dense output for the method of order 8).
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            NQ, NU, NX, NV, NLAM, IP(*), K, ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, H, X(*), RP(*), CST(*), V(*), F(NX,13),
     $                   W(*), P(*), Z(*), RSTAT(*)
      EXTERNAL           GSFUN
      INTEGER            I
      DOUBLE PRECISION   C14, C15, C16, R5, R6, R7, R8
      DOUBLE PRECISION   A141, A147, A148, A149, A1410, A1411, A1412,
     $                   A1413, A151, A156, A157, A158, A1511, A1512,
     $                   A1513, A1514, A161, A166, A167, A168, A169,
     $                   A1613, A1614, A1615, D41, D46, D47, D48, D49,
     $                   D410, D411, D412, D413, D414, D415, D416, D51,
     $                   D56, D57, D58, D59, D510, D511, D512, D513,
     $                   D514, D515, D516, D61, D66, D67, D68, D69,
     $                   D610, D611, D612, D613, D614, D615, D616, D71,
     $                   D76, D77, D78, D79, D710, D711, D712, D713,
     $                   D714, D715, D716
      PARAMETER ( A141  = 5.616750228304795233929092196808835088D-2,
     $            A147  = 2.5350021021662481108879476533244434029D-1,
     $            A148  = -2.4623903747080248991744147544091267073D-1,
     $            A149  = -1.2419142326381636046901014062612922994D-1,
     $            A1410 = 1.5329179827876569731206322685011242997D-1,
     $            A1411 = 8.2010522956346898849166660205544010511D-3,
     $            A1412 = 7.5678976605456997613860358958423784806D-3,
     $            A1413 = -8.298D-3 )
      PARAMETER ( A151  = 3.1834648163502140506076847326062954552D-2,
     $            A156  = 2.8300909672366775528832296140254226938D-2,
     $            A157  = 5.3541988307438567622379738437171210315D-2,
     $            A158  = -5.492374857139098846465693403059960239D-2,
     $            A1511 = -1.0834732869724932285850931699437051482D-4,
     $            A1512 = 3.825710908356584129549201923226346803D-4,
     $            A1513 = -3.404650086874045608029771144923653197D-4,
     $            A1514 = 1.4131244367463250027807461836627531174D-1 )
      PARAMETER ( A161  = -4.2889630158379192340857353869179790275D-1,
     $            A166  = -4.697621415361163843144494472061115892D0,
     $            A167  = 7.6834211960625990418424095387807972522D0,
     $            A168  = 4.0689898183971100797021355433098297066D0,
     $            A169  = 3.5672718745528110927066954302055167332D-1,
     $            A1613 = -1.3990241651590146212941800973427111366D-3,
     $            A1614 = 2.9475147891527723389556272148966788837D0,
     $            A1615 = -9.1509584721798700108187018713798232322D0 )
      PARAMETER ( D41   = -8.4289382761090128651353491156926746058D0,
     $            D46   = 5.6671495351937776962531783681399719771D-1,
     $            D47   = -3.0689499459498916912797304725279267159D0,
     $            D48   = 2.3846676565120698287728149684829354651D0,
     $            D49   = 2.1170345824450282767155149947547719394D0,
     $            D410  = -8.7139158377797299206789907515508291831D-1,
     $            D411  = 2.2404374302607882758541771638108757242D0,
     $            D412  = 6.3157877876946881815570249306256900235D-1,
     $            D413  = -8.8990336451333310820698116813268590269D-2,
     $            D414  = 1.8148505520854727256656404964585408434D1,
     $            D415  = -9.1946323924783554000451984443154903043D0,
     $            D416  = -4.4360363875948939664310571970061146284D0 )
      PARAMETER ( D51   = 1.0427508642579134603413151007820153768D1,
     $            D56   = 2.4228349177525818288430175319346907856D2,
     $            D57   = 1.6520045171727028198505394886943906276D2,
     $            D58   = -3.7454675472269020279518312151748195265D2,
     $            D59   = -2.2113666853125306036270938577389199842D1,
     $            D510  = 7.733432668472263838960389880893706722D0,
     $            D511  = -3.0674084731089398182061213627694050874D1,
     $            D512  = -9.3321305264302278729567221703984904423D0,
     $            D513  = 1.5697238121770843886131091074860972666D1,
     $            D514  = -3.1139403219565177677282850409550408241D1,
     $            D515  = -9.3529243588444783865713862677002920114D0,
     $            D516  = 3.5816841486394083752465898543731419581D1 )
      PARAMETER ( D61   = 1.9985053242002433820987653617543856929D1,
     $            D66   = -3.8703730874935176555105901742118678709D2,
     $            D67   = -1.8917813819516756882830838328016853598D2,
     $            D68   = 5.2780815920542364900561016685902094876D2,
     $            D69   = -1.1573902539959630126141871134308364925D1,
     $            D610  = 6.8812326946963000169666922661290824953D0,
     $            D611  = -1.0006050966910838403183860970810240069D0,
     $            D612  = 7.7771377980534432092869265732936785435D-1,
     $            D613  = -2.7782057523535084065932004337486694044D0,
     $            D614  = -6.0196695231264120758267380846103303412D1,
     $            D615  = 8.4320405506677161018159903784204679883D1,
     $            D616  = 1.1992291136182789328035130028368748898D1 )
      PARAMETER ( D71   = -2.5693933462703749003312586129344078647D1,
     $            D76   = -1.5418974869023643374053993627104569092D2,
     $            D77   = -2.315293791760454956753603910894595838D2,
     $            D78   = 3.5763911791061412378285349909925792968D2,
     $            D79   = 9.3405324183624310003907691703634672325D1,
     $            D710  = -3.7458323136451633156875139351368782361D1,
     $            D711  = 1.0409964950896230045147246184439732151D2,
     $            D712  = 2.9840293426660503123344363578679209881D1,
     $            D713  = -4.3533456590011143754432175058249915266D1,
     $            D714  = 9.6324553959188282948394950600425855209D1,
     $            D715  = -3.9177261675615439165231486171539053858D1,
     $            D716  = -1.4972683625798562581422125275538788376D2 )
      PARAMETER ( C14   = 0.1D0,
     $            C15   = 0.2D0,
     $            C16   = 7.7777777777777777777777777777777777778D-1 )
C
C     -- stages 14 to 16
      DO 10 I = 1, NX
         Z(I) = X(I) + H*( A141*F(I,1) + A147*F(I,7) + A148*F(I,8)
     $        + A149*F(I,9) + A1410*F(I,10) + A1411*F(I,11)
     $        + A1412*F(I,12) + A1413*F(I,2) )
   10 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T + C14*H, 1, Z, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, F(1,3), W, P, ISTAT,
     $            RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NX
         Z(I) = X(I) + H*( A151*F(I,1) + A156*F(I,6) + A157*F(I,7)
     $        + A158*F(I,8) + A1511*F(I,11) + A1512*F(I,12)
     $        + A1513*F(I,2) + A1514*F(I,3) )
   20 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T + C15*H, 1, Z, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, F(1,4), W, P, ISTAT,
     $            RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 30 I = 1, NX
         Z(I) = X(I) + H*( A161*F(I,1) + A166*F(I,6) + A167*F(I,7)
     $        + A168*F(I,8) + A169*F(I,9) + A1613*F(I,2)
     $        + A1614*F(I,3) + A1615*F(I,4) )
   30 CONTINUE
      CALL GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T + C16*H, 1, Z, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, F(1,5), W, P, ISTAT,
     $            RSTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
C
C     -- the coefficients
      DO 40 I = 1, NX
         R5 = D41*F(I,1) + D46*F(I,6) + D47*F(I,7) + D48*F(I,8)
     $      + D49*F(I,9) + D410*F(I,10) + D411*F(I,11) + D412*F(I,12)
     $      + D413*F(I,2) + D414*F(I,3) + D415*F(I,4) + D416*F(I,5)
         R6 = D51*F(I,1) + D56*F(I,6) + D57*F(I,7) + D58*F(I,8)
     $      + D59*F(I,9) + D510*F(I,10) + D511*F(I,11) + D512*F(I,12)
     $      + D513*F(I,2) + D514*F(I,3) + D515*F(I,4) + D516*F(I,5)
         R7 = D61*F(I,1) + D66*F(I,6) + D67*F(I,7) + D68*F(I,8)
     $      + D69*F(I,9) + D610*F(I,10) + D611*F(I,11) + D612*F(I,12)
     $      + D613*F(I,2) + D614*F(I,3) + D615*F(I,4) + D616*F(I,5)
         R8 = D71*F(I,1) + D76*F(I,6) + D77*F(I,7) + D78*F(I,8)
     $      + D79*F(I,9) + D710*F(I,10) + D711*F(I,11) + D712*F(I,12)
     $      + D713*F(I,2) + D714*F(I,3) + D715*F(I,4) + D716*F(I,5)
         F(I,K) = R5
         F(I,K+1) = R6
         F(I,K+2) = R7
         F(I,K+3) = R8
   40 CONTINUE
      END
      SUBROUTINE GSDPV( NX, H, B, X, XN, F, Z )
C
C     PURPOSE
C     The state Z at the fraction B of a step of GSDP8 from X to XN, on
C     the polynomial that GSDPD left in F.
C
      IMPLICIT NONE
      INTEGER            NX
      DOUBLE PRECISION   H, B, X(NX), XN(NX), F(NX,13), Z(NX)
      EXTERNAL           GSDPU
C
      CALL GSDPU( NX, H, B, X, F, XN, F(1,2), F(1,6), Z )
      END
      SUBROUTINE GSDPU( NX, H, B, X, XD, XN, XDN, C, Z )
C
C     PURPOSE
C     As GSDPV, from the rates XD, XDN at the ends and the coefficients C
C     of GSDPE; XN itself at the end.
C
      IMPLICIT NONE
      INTEGER            NX
      DOUBLE PRECISION   H, B, X(NX), XD(NX), XN(NX), XDN(NX), C(NX,4),
     $                   Z(NX)
      DOUBLE PRECISION   D, R3, R4, R
      INTEGER            I
C
      DO 10 I = 1, NX
         D  = XN(I) - X(I)
         R3 = H*XD(I) - D
         R4 = D - H*XDN(I) - R3
         R  = H*( C(I,1) + B*( C(I,2) + ( 1.0D0 - B )*( C(I,3)
     $      + B*C(I,4) ) ) )
         R  = R3 + B*( R4 + ( 1.0D0 - B )*R )
         Z(I) = X(I) + B*( D + ( 1.0D0 - B )*R )
   10 CONTINUE
      IF ( B.LT.1.0D0 ) RETURN
      DO 20 I = 1, NX
         Z(I) = XN(I)
   20 CONTINUE
      END
      SUBROUTINE GSDPQ( NQ, NU, NX, H, X, XN, F, P, RTOL, ATOL, Z, W,
     $                  OFF )
C
C     PURPOSE
C     How accurate is the polynomial that GSDPD left in F?
C
C     ARGUMENTS
C     NQ, NU, NX, H, X, XN, P, RTOL, ATOL  as GSDP8.
C     F       (input) DOUBLE PRECISION array, dimension (NX,13), and
C     Z       (input) DOUBLE PRECISION array, dimension (NX), as GSDPD
C             left them: Z is the state of its last stage.
C     W       (workspace) DOUBLE PRECISION array, dimension (NX).
C     OFF     (output) DOUBLE PRECISION, its error beside three of the
C             tolerances: at most 1 where it is as accurate as the step.
C
C     METHOD
C     The error is its state at the place of the last stage of GSDPD
C     less Z. In steps that stability bounds the ends are damped and
C     what is within them is not.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NX
      DOUBLE PRECISION   H, X(NX), XN(NX), F(NX,13), P(*), RTOL,
     $                   ATOL(NX), Z(NX), W(NX), OFF
      EXTERNAL           GSDPV, GSDPN
C
      CALL GSDPV( NX, H, 7.0D0/9.0D0, X, XN, F, W )
      CALL GSDPN( NQ, NU, NX, X, XN, P, RTOL, ATOL, Z, W, OFF )
      END
      SUBROUTINE GSDPN( NQ, NU, NX, X, XN, P, RTOL, ATOL, Z, W, OFF )
C
C     PURPOSE
C     OFF of GSDPQ, from the state W of the polynomial and Z.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NX
      DOUBLE PRECISION   X(NX), XN(NX), P(*), RTOL, ATOL(NX), Z(NX),
     $                   W(NX), OFF
      DOUBLE PRECISION   E, S
      INTEGER            I, N
C
      E = 0.0D0
      N = 0
      DO 10 I = 1, NX
         IF ( P(1).GT.0.0D0 .AND. I.LE.NQ + NU .AND.
     $        NINT( P(2) ).LT.NU ) THEN
            IF ( P(14+NU+I).LE.0.0D0 ) GO TO 10
         END IF
         S = ATOL(I) + RTOL*MAX( ABS( X(I) ), ABS( XN(I) ) )
         IF ( .NOT.( S.GT.0.0D0 ) ) GO TO 10
         E = E + ( ( W(I) - Z(I) )/S )**2
         N = N + 1
   10 CONTINUE
      OFF = 0.3D0*SQRT( E/DBLE( MAX( 1, N ) ) )
      END
