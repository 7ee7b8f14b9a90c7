      DOUBLE PRECISION FUNCTION GSNXT( NV, IS, S )
C
C     PURPOSE
C     The next time at which a sampled device acts or gives out [s].
C
C     ARGUMENTS
C     NV      (input) INTEGER, the number of inputs.
C     IS, S   (input) the plan of the samples, see GSSMP.
C
      IMPLICIT NONE
      INTEGER            NV, IS(*)
      DOUBLE PRECISION   S(*)
      INTEGER            NC, IQ, JQ, I
C
      NC = IS(1)
      IQ = 11 + 3*NC + IS(4)
      JQ = 1 + 2*NC + IS(4) + IS(2) + IS(3) + NV
      GSNXT = 1.0D300
      DO 10 I = 1, NC
         GSNXT = MIN( GSNXT, DBLE( IS(10+I) )*S(I) )
   10 CONTINUE
      DO 20 I = 1, IS(5)
         IF ( IS(IQ+I-1).GT.0 ) GSNXT = MIN( GSNXT, S(JQ+I-1) )
   20 CONTINUE
      END
