      SUBROUTINE GSSMP( OUT, CTL, T, X, NX, NV, CST, V, IS, S, INFO )
C
C     PURPOSE
C     Sampled devices at one instant of a compiled run: outputs whose
C     delay is over are given out, devices whose sample is due act.
C
C     ARGUMENTS
C     OUT     (external) <NAME>_OUT( T, X, V, CST, Y, INFO ).
C     CTL     (external) <NAME>_CTL( K, T, Y, XK, CST, V ).
C     T       (input) DOUBLE PRECISION, the time [s].
C     X       (input) DOUBLE PRECISION array, dimension (NX).
C     CST     (input) DOUBLE PRECISION array, from <NAME>_PRE.
C     V       (input/output) DOUBLE PRECISION array, dimension (NV), the
C             inputs at T (from the right): the held outputs are set.
C     IS      (input/output) INTEGER array, the plan of the samples:
C             IS(1)  NC, the number of sampled devices;
C             IS(2)  NXK, the length of their memory;
C             IS(3)  NY, the number of outputs of the scene;
C             IS(4)  NH, the number of held outputs of all devices;
C             IS(5)  NP, places for outputs that are on their way;
C             IS(6)  NS, places for a record of the instants; 0: none;
C             IS(7)  instants so far;
C             IS(8)  1 where a table of the inputs tells the held outputs
C                    before the first samples (gslay.c), else 0;
C             IS(9..10)  zero;
C             then for each device: the number K of its next sample, the
C             number of its held outputs, 1 if Y must be computed anew
C             for it after others acted (it reads them and the motion);
C             then NH numbers of inputs, device by device;
C             then NP numbers of devices, 0 where a place is free, and
C             1 + NC + NP workspace (GSKEP).
C     S       (input/output) DOUBLE PRECISION array:
C             NC periods, NC delays, NH held outputs, NXK memory, NY and
C             NV workspace; then NP times and NP*NH outputs that are on
C             their way; then NS records: time, NXK memory, NV inputs;
C             then NH + NXK + NP*(1 + NH) workspace (GSKEP).
C     INFO    (output) INTEGER, 0, the INFO of OUT, or -1 if there is no
C             place for an output on its way.
C
C     METHOD
C     The sample K of a device is at K times its period. Instants that
C     differ by rounding only are one. There delayed outputs come first,
C     then the devices act in their order, each with the outputs that
C     those ahead of it have left.
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL
      INTEGER            NX, NV, IS(*), INFO
      DOUBLE PRECISION   T, X(NX), CST(*), V(*), S(*)
      INTEGER            NC, NXK, NH, NP, IN, IQ, JH, JM, JY, JV, JQ,
     $                   JO, JR, I, J, K, L, N, OLD
      DOUBLE PRECISION   LATE, GSEPS
      EXTERNAL           GSEPS
C
      INFO = 0
      NC  = IS(1)
      NXK = IS(2)
      NH  = IS(4)
      NP  = IS(5)
      IN  = 11 + 3*NC
      IQ  = IN + NH
      JH  = 1 + 2*NC
      JM  = JH + NH
      JY  = JM + NXK
      JV  = JY + IS(3)
      JQ  = JV + NV
      JO  = JQ + NP
      JR  = JO + NP*NH
      LATE = T + 8.0D0*GSEPS()*ABS( T )
C
C     -- outputs that arrive, the earliest first
   10 CONTINUE
      L = 0
      DO 20 I = 1, NP
         IF ( IS(IQ+I-1).GT.0 .AND. S(JQ+I-1).LE.LATE ) THEN
            IF ( L.EQ.0 ) L = I
            IF ( S(JQ+I-1).LT.S(JQ+L-1) ) L = I
         END IF
   20 CONTINUE
      IF ( L.GT.0 ) THEN
         N = 0
         DO 30 K = 1, IS(IQ+L-1) - 1
            N = N + IS(10+NC+K)
   30    CONTINUE
         DO 40 J = N + 1, N + IS(10+NC+IS(IQ+L-1))
            S(JH+J-1) = S(JO+NH*(L-1)+J-1)
            V(IS(IN+J-1)) = S(JH+J-1)
   40    CONTINUE
         IS(IQ+L-1) = 0
         GO TO 10
      END IF
C
C     -- devices that act
      OLD = 2
      N = 0
      DO 90 K = 1, NC
         IF ( DBLE( IS(10+K) )*S(K).LE.LATE ) THEN
            IF ( IS(3).GT.0 .AND. OLD + IS(10+2*NC+K).GT.1 ) THEN
               CALL OUT( T, X, V, CST, S(JY), INFO )
               IF ( INFO.EQ.2 .OR. INFO.EQ.3 ) INFO = 0
               IF ( INFO.NE.0 ) RETURN
               OLD = 0
            END IF
            DO 50 I = 1, NV
               S(JV+I-1) = V(I)
   50       CONTINUE
            CALL CTL( K, T, S(JY), S(JM), CST, S(JV) )
            IS(10+K) = IS(10+K) + 1
            IF ( S(NC+K).GT.0.0D0 ) THEN
               L = 0
               DO 60 I = 1, NP
                  IF ( IS(IQ+I-1).EQ.0 ) L = I
   60          CONTINUE
               IF ( L.EQ.0 ) THEN
                  INFO = -1
                  RETURN
               END IF
               IS(IQ+L-1) = K
               S(JQ+L-1)  = DBLE( IS(10+K) - 1 )*S(K) + S(NC+K)
               DO 70 J = N + 1, N + IS(10+NC+K)
                  S(JO+NH*(L-1)+J-1) = S(JV+IS(IN+J-1)-1)
   70          CONTINUE
            ELSE
               DO 80 J = N + 1, N + IS(10+NC+K)
                  S(JH+J-1) = S(JV+IS(IN+J-1)-1)
                  V(IS(IN+J-1)) = S(JH+J-1)
   80          CONTINUE
               IF ( OLD.EQ.0 ) OLD = 1
            END IF
         END IF
         N = N + IS(10+NC+K)
   90 CONTINUE
C
C     -- the record
      IS(7) = IS(7) + 1
      IF ( IS(7).GT.IS(6) ) RETURN
      L = JR + ( IS(7) - 1 )*( 1 + NXK + NV )
      S(L) = T
      DO 100 I = 1, NXK
         S(L+I) = S(JM+I-1)
  100 CONTINUE
      DO 110 I = 1, NV
         S(L+NXK+I) = V(I)
  110 CONTINUE
      END
      SUBROUTINE GSKEP( BACK, NV, IS, S )
C
C     PURPOSE
C     What an instant of the sampled devices changes is kept (BACK = 0),
C     or as it was kept (BACK = 1).
C
C     ARGUMENTS
C     NV      (input) INTEGER, the number of inputs.
C     IS, S   (input/output) the plan of the samples, see GSSMP.
C
      IMPLICIT NONE
      INTEGER            BACK, NV, IS(*)
      DOUBLE PRECISION   S(*)
      INTEGER            NC, NK, NP, NQ, IQ, IK, JH, JQ, JK, I
C
      NC = IS(1)
      NK = IS(4) + IS(2)
      NP = IS(5)
      NQ = NP*( 1 + IS(4) )
      IQ = 10 + 3*NC + IS(4)
      IK = IQ + NP + 1
      JH = 2*NC
      JQ = JH + NK + IS(3) + NV
      JK = JQ + NQ + IS(6)*( 1 + IS(2) + NV )
      IF ( BACK.EQ.0 ) IS(IK) = IS(7)
      IS(7) = IS(IK)
      DO 2 I = 1, NC
         IF ( BACK.EQ.0 ) IS(IK+I) = IS(10+I)
         IS(10+I) = IS(IK+I)
    2 CONTINUE
      DO 4 I = 1, NP
         IF ( BACK.EQ.0 ) IS(IK+NC+I) = IS(IQ+I)
         IS(IQ+I) = IS(IK+NC+I)
    4 CONTINUE
      DO 10 I = 1, NK
         IF ( BACK.EQ.0 ) S(JK+I) = S(JH+I)
         S(JH+I) = S(JK+I)
   10 CONTINUE
      DO 20 I = 1, NQ
         IF ( BACK.EQ.0 ) S(JK+NK+I) = S(JQ+I)
         S(JQ+I) = S(JK+NK+I)
   20 CONTINUE
      END
