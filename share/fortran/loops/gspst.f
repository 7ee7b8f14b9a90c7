      SUBROUTINE GSPST( NQ, NU, NLAM, IOPT, P )
C
C     PURPOSE
C     The partition of GSPRT before anything is known of constraints.
C
C     ARGUMENTS
C     NQ, NU, NLAM (input) INTEGER, see GSSIM.
C     IOPT    (input) INTEGER array, see GSSIM: the way of the loops and
C             the constraints on speeds alone.
C     P       (output) DOUBLE PRECISION array, see GSPRT.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NLAM, IOPT(*)
      DOUBLE PRECISION   P(*)
      INTEGER            I, N
C
C$OMP SIMD
      DO 10 I = 1, 24 + 8*NU + 10*NQ + 7*NLAM + 2*NLAM*NU
         P(I) = 0.0D0
   10 CONTINUE
      IF ( NLAM.GT.0 .AND. IOPT(2).EQ.3 ) P(1) = 2.0D0
      IF ( NLAM.GT.0 .AND. IOPT(2).EQ.6 ) P(1) = 1.0D0
      P(2) = -1.0D0
      N = 14 + 3*NU + NQ + NLAM
      DO 20 I = 1, NLAM
         P(N+I) = 1.0D0
   20 CONTINUE
      DO 30 I = 1, IOPT(6)
         P(N+IOPT(6+I)) = 0.0D0
         P(12) = 1.0D0
   30 CONTINUE
      END
