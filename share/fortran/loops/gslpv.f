      SUBROUTINE GSLPV( NU, NLAM, HC, SIZE, Y, PIV, BETA, D, RANK,
     $                  LEAST )
C
C     PURPOSE
C     Pivots of the constraint Jacobian HC (NLAM by NU), each row divided
C     by the largest length SIZE it had so far (at least a millionth of
C     the longest row's); RANK and LEAST as GSPRC.
C     Y, PIV, BETA, D and RANK are what GSQRC leaves.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, RANK
      DOUBLE PRECISION   HC(NLAM,*), SIZE(*), Y(NLAM,*), PIV(*),
     $                   BETA(*), D(*), LEAST
      DOUBLE PRECISION   S, BIG
      EXTERNAL           GSQRC
      INTEGER            I, J
C
      BIG = 0.0D0
      DO 20 I = 1, NLAM
         S = 0.0D0
         DO 10 J = 1, NU
            S = S + HC(I,J)*HC(I,J)
   10    CONTINUE
         SIZE(I) = MAX( SIZE(I), SQRT( S ) )
         BIG = MAX( BIG, SIZE(I) )
   20 CONTINUE
      IF ( .NOT.( BIG.GT.0.0D0 ) ) BIG = 1.0D0
C
C     -- a row that has always been nothing stays nothing
      DO 40 I = 1, NLAM
         SIZE(I) = MAX( SIZE(I), 1.0D-6*BIG )
         DO 30 J = 1, NU
            Y(I,J) = HC(I,J)/SIZE(I)
   30    CONTINUE
   40 CONTINUE
      CALL GSQRC( NLAM, NU, Y, NLAM, 1.0D-7, PIV, BETA, D, RANK )
      LEAST = 0.0D0
      IF ( RANK.GT.0 ) LEAST = D(RANK)/D(1)
      END
