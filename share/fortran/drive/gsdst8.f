      SUBROUTINE GSDST8( RHS, INP, T, TN, SIDE, H, X, NX, NV, CST, RTOL,
     $                   ATOL, V, XN, ERR, F, ISTAT, INFO )
C
C     PURPOSE
C     One trial step of the Runge-Kutta method of Dormand and Prince of
C     order 8 with its error estimate of orders 5 and 3.
C
C     ARGUMENTS
C     As GSDRHS, and
C     T       (input) DOUBLE PRECISION, the time of X [s].
C     TN      (input) DOUBLE PRECISION, the time at the end, T + H, as
C             the caller rounds it [s].
C     SIDE    (input) INTEGER, < 0 if the inputs or the scene may switch
C             at TN: the rates there are those just before.
C     H       (input) DOUBLE PRECISION, the step [s].
C     X       (input) DOUBLE PRECISION array, dimension (NX).
C     RTOL    (input) DOUBLE PRECISION, relative tolerance.
C     ATOL    (input) DOUBLE PRECISION array, dimension (NX), absolute
C             tolerances.
C     XN      (output) DOUBLE PRECISION array, dimension (NX): the state
C             at TN.  May not share storage with X.
C     ERR     (output) DOUBLE PRECISION, the estimated error divided by
C             the tolerance: the step is to be accepted if ERR <= 1.
C             1.0D307 if a number of XN is not finite.
C     F       (input/output) DOUBLE PRECISION array, dimension (NX,13):
C             on entry column 1 holds the rates at (T,X).
C
C     METHOD
C     Twelve stages, the first given.  With e5 and e3 the differences to
C     the embedded formulae of order 5 and 3, each scaled by the
C     tolerance, ERR = H*e5**2/SQRT(e5**2 + 0.01*e3**2).
C     The coefficients are the published ones, carried on to 38 digits
C     from the order conditions: C2..C5 are multiples of 6 +- SQRT(6),
C     B the quadrature on the nodes, A the nearest solution of all
C     conditions up to order 8 (it lies within 4D-30 of the published
C     digits), E the nearest solution of those up to order 5.
C
C     REFERENCE
C     Hairer, Norsett, Wanner, Solving Ordinary Differential Equations
C     I, section II.5 (method) and II.10 (error estimate).
C
      IMPLICIT NONE
      EXTERNAL           RHS, INP
      INTEGER            SIDE, NX, NV, ISTAT(*), INFO
      DOUBLE PRECISION   T, TN, H, X(NX), CST(*), RTOL, ATOL(NX), V(*),
     $                   XN(NX), ERR, F(NX,13)
      EXTERNAL           GSDRHS, GSFIN
      INTEGER            GSFIN, I
      DOUBLE PRECISION   S, E5, E3, D5, D3
      DOUBLE PRECISION   C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, A21,
     $                   A31, A32, A41, A43, A51, A53, A54, A61, A64,
     $                   A65, A71, A74, A75, A76, A81, A84, A85, A86,
     $                   A87, A91, A94, A95, A96, A97, A98, A101, A104,
     $                   A105, A106, A107, A108, A109, A111, A114,
     $                   A115, A116, A117, A118, A119, A1110, A121,
     $                   A124, A125, A126, A127, A128, A129, A1210,
     $                   A1211, B1, B6, B7, B8, B9, B10, B11, B12, E1,
     $                   E6, E7, E8, E9, E10, E11, E12, G1, G9, G12
      PARAMETER ( C2    = 5.2600151958767731878558754448801609008D-2,
     $            C3    = 7.8900227938151597817838131673202413512D-2,
     $            C4    = 1.1835034190722739672675719750980362027D-1,
     $            C5    = 2.8164965809277260327324280249019637973D-1,
     $            C6    = 3.3333333333333333333333333333333333333D-1,
     $            C7    = 2.5D-1,
     $            C8    = 3.0769230769230769230769230769230769231D-1,
     $            C9    = 6.5128205128205128205128205128205128205D-1,
     $            C10   = 6.0D-1,
     $            C11   = 8.5714285714285714285714285714285714286D-1 )
      PARAMETER ( A21   = 5.2600151958767731878558754448801609008D-2 )
      PARAMETER ( A31   = 1.9725056984537899454459532918300603378D-2,
     $            A32   = 5.9175170953613698363378598754901810134D-2 )
      PARAMETER ( A41   = 2.9587585476806849181689299377450905067D-2,
     $            A43   = 8.8762756430420547545067898132352715201D-2 )
      PARAMETER ( A51   = 2.4136513415926668550236979866451012631D-1,
     $            A53   = -8.8454947932828608534486496271706060422D-1,
     $            A54   = 9.2483400326179200311573796654274685764D-1 )
      PARAMETER ( A61   = 3.7037037037037037037037037037037037037D-2,
     $            A64   = 1.7082860872947387127960448217320269807D-1,
     $            A65   = 1.2546768756682242501669181412309359822D-1 )
      PARAMETER ( A71   = 3.7109375D-2,
     $            A74   = 1.7025221101954403931497806027171435744D-1,
     $            A75   = 6.0216538980455960685021939728285642563D-2,
     $            A76   = -1.7578125D-2 )
      PARAMETER ( A81   = 3.7092000118504792710877931983635565443D-2,
     $            A84   = 1.7038392571223999381021405470448671109D-1,
     $            A85   = 1.0726203044637328465180919916779205528D-1,
     $            A86   = -1.5319437748624401752793615823621775794D-2,
     $            A87   = 8.273789163814022887584737660015136294D-3 )
      PARAMETER ( A91   = 6.2411095871607571711442957781204574618D-1,
     $            A94   = -3.3608926294469412940685710982459877531D0,
     $            A95   = -8.6821934684172600681818989145257415931D-1,
     $            A96   = 2.7592099699446708304941560079685495462D1,
     $            A97   = 2.0154067550477893408618678897886364167D1,
     $            A98   = -4.3489884181069958847736625514403292181D1 )
      PARAMETER ( A101  = 4.7766253643826436589043390852739152287D-1,
     $            A104  = -2.4881146199716676419264258646823966931D0,
     $            A105  = -5.9029082683684299637144647574313522176D-1,
     $            A106  = 2.1230051448181194234728894989704873027D1,
     $            A107  = 1.5279233632882423583259692293748442209D1,
     $            A108  = -3.3288210968984862919445326558695882291D1,
     $            A109  = -2.0331201708508626135822292859292552846D-2 )
      PARAMETER ( A111  = -9.3714243008598732571704021658041552814D-1,
     $            A114  = 5.1863724288440637083002385320895363761D0,
     $            A115  = 1.0914373489967295781850025465390492309D0,
     $            A116  = -8.1497870107469261251399726735690918797D0,
     $            A117  = -1.8520065659996959864156618070114775078D1,
     $            A118  = 2.2739487099350504281897005673359727308D1,
     $            A119  = 2.4936055526796523898708939676188817179D0,
     $            A1110 = -3.046764471898219500382366902200055004D0 )
      PARAMETER ( A121  = 2.2733101475165382079235976844938774245D0,
     $            A124  = -1.0534495466737250198406668987892857914D1,
     $            A125  = -2.0008720582248624990967571844381719685D0,
     $            A126  = -1.7958931863118798917276595053361827338D1,
     $            A127  = 2.7948884529419960050849980883715913462D1,
     $            A128  = -2.858998277135023694740655086735730542D0,
     $            A129  = -8.8728569335306295443354928925846447156D0,
     $            A1210 = 1.2360567175794303064726620152757372915D1,
     $            A1211 = 6.4339274601576353035597048404606867587D-1 )
      PARAMETER ( B1    = 5.4293734116568762238053576636253801608D-2,
     $            B6    = 4.4503128927524088814411395056556346879D0,
     $            B7    = 1.8915178993145003830428159904359329816D0,
     $            B8    = -5.8012039600105847814672114226971519456D0,
     $            B9    = 3.1116436695781989440891606236975861761D-1,
     $            B10   = -1.5216094966251607855617880680537322141D-1,
     $            B11   = 2.0136540080403034837477653750070189956D-1,
     $            B12   = 4.4710615727772590517688556904243178753D-2 )
      PARAMETER ( E1    = 1.3120044994194880732501029953801793085D-2,
     $            E6    = -1.2251564463762044407205697528543837147D0,
     $            E7    = -4.9575894965725019152140799505384812683D-1,
     $            E8    = 1.6643771824549865369615304151480492819D0,
     $            E9    = -3.503288487499736816886487289838649404D-1,
     $            E10   = 3.3417911871301747902973188414208476014D-1,
     $            E11   = 8.1923206485115712465707426085956994164D-2,
     $            E12   = -2.2355307863886295258844278437796047352D-2 )
      PARAMETER ( G1    = 2.4409448818897637795275590551181102362D-1,
     $            G9    = 7.3384668828161185734136174154701250579D-1,
     $            G12   = 2.2058823529411764705882352941176470588D-2 )
C
C     -- stages 2 to 12
      ERR = 0.0D0
      DO 10 I = 1, NX
         F(I,13) = X(I) + H*( A21*F(I,1) )
   10 CONTINUE
      CALL GSDRHS( RHS, INP, T + C2*H, 1, F(1,13), NV, CST, V,
     $             F(1,2), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 20 I = 1, NX
         F(I,13) = X(I) + H*( A31*F(I,1) + A32*F(I,2) )
   20 CONTINUE
      CALL GSDRHS( RHS, INP, T + C3*H, 1, F(1,13), NV, CST, V,
     $             F(1,3), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 30 I = 1, NX
         F(I,13) = X(I) + H*( A41*F(I,1) + A43*F(I,3) )
   30 CONTINUE
      CALL GSDRHS( RHS, INP, T + C4*H, 1, F(1,13), NV, CST, V,
     $             F(1,4), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 40 I = 1, NX
         F(I,13) = X(I) + H*( A51*F(I,1) + A53*F(I,3) + A54*F(I,4) )
   40 CONTINUE
      CALL GSDRHS( RHS, INP, T + C5*H, 1, F(1,13), NV, CST, V,
     $             F(1,5), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 50 I = 1, NX
         F(I,13) = X(I) + H*( A61*F(I,1) + A64*F(I,4) + A65*F(I,5) )
   50 CONTINUE
      CALL GSDRHS( RHS, INP, T + C6*H, 1, F(1,13), NV, CST, V,
     $             F(1,6), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 60 I = 1, NX
         F(I,13) = X(I) + H*( A71*F(I,1) + A74*F(I,4) + A75*F(I,5)
     $              + A76*F(I,6) )
   60 CONTINUE
      CALL GSDRHS( RHS, INP, T + C7*H, 1, F(1,13), NV, CST, V,
     $             F(1,7), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 70 I = 1, NX
         F(I,13) = X(I) + H*( A81*F(I,1) + A84*F(I,4) + A85*F(I,5)
     $              + A86*F(I,6) + A87*F(I,7) )
   70 CONTINUE
      CALL GSDRHS( RHS, INP, T + C8*H, 1, F(1,13), NV, CST, V,
     $             F(1,8), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 80 I = 1, NX
         F(I,13) = X(I) + H*( A91*F(I,1) + A94*F(I,4) + A95*F(I,5)
     $              + A96*F(I,6) + A97*F(I,7) + A98*F(I,8) )
   80 CONTINUE
      CALL GSDRHS( RHS, INP, T + C9*H, 1, F(1,13), NV, CST, V,
     $             F(1,9), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 90 I = 1, NX
         F(I,13) = X(I) + H*( A101*F(I,1) + A104*F(I,4) + A105*F(I,5)
     $              + A106*F(I,6) + A107*F(I,7) + A108*F(I,8)
     $              + A109*F(I,9) )
   90 CONTINUE
      CALL GSDRHS( RHS, INP, T + C10*H, 1, F(1,13), NV, CST, V,
     $             F(1,10), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 100 I = 1, NX
         F(I,13) = X(I) + H*( A111*F(I,1) + A114*F(I,4) + A115*F(I,5)
     $              + A116*F(I,6) + A117*F(I,7) + A118*F(I,8)
     $              + A119*F(I,9) + A1110*F(I,10) )
  100 CONTINUE
      CALL GSDRHS( RHS, INP, T + C11*H, 1, F(1,13), NV, CST, V,
     $             F(1,11), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
      DO 110 I = 1, NX
         F(I,13) = X(I) + H*( A121*F(I,1) + A124*F(I,4) + A125*F(I,5)
     $              + A126*F(I,6) + A127*F(I,7) + A128*F(I,8)
     $              + A129*F(I,9) + A1210*F(I,10) + A1211*F(I,11) )
  110 CONTINUE
      CALL GSDRHS( RHS, INP, TN, SIDE, F(1,13), NV, CST, V,
     $             F(1,12), ISTAT, INFO )
      IF ( INFO.NE.0 ) RETURN
C
C     -- the result and the error
      E5 = 0.0D0
      E3 = 0.0D0
      DO 200 I = 1, NX
         S = B1*F(I,1) + B6*F(I,6) + B7*F(I,7) + B8*F(I,8) + B9*F(I,9)
     $     + B10*F(I,10) + B11*F(I,11) + B12*F(I,12)
         XN(I) = X(I) + H*S
         D3 = S - G1*F(I,1) - G9*F(I,9) - G12*F(I,12)
         D5 = E1*F(I,1) + E6*F(I,6) + E7*F(I,7) + E8*F(I,8)
     $      + E9*F(I,9) + E10*F(I,10) + E11*F(I,11) + E12*F(I,12)
         S  = ATOL(I) + RTOL*MAX( ABS( X(I) ), ABS( XN(I) ) )
         IF ( S.GT.0.0D0 ) THEN
            E3 = E3 + ( D3/S )**2
            E5 = E5 + ( D5/S )**2
         ELSE IF ( ABS( D5 ).GT.0.0D0 ) THEN
            E5 = 1.0D300
         END IF
  200 CONTINUE
      S = E5 + 0.01D0*E3
      IF ( .NOT.( S.GT.0.0D0 ) ) S = 1.0D0
      ERR = ABS( H )*E5/SQRT( DBLE( MAX( 1, NX ) )*S )
      IF ( GSFIN( NX, XN ).NE.0 ) ERR = 1.0D307
      END
