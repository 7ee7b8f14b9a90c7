      SUBROUTINE GSQRP( N, M, Y, LDY, TOL, PIV, BETA, SIZ, RANK )
C
C     PURPOSE
C     Rank-revealing factorization Y*P = Q*R by Householder reflections
C     with column interchanges; every column is measured by itself
C     (GSQRG with GRP = 0).
C
      IMPLICIT NONE
      INTEGER            N, M, LDY, RANK
      DOUBLE PRECISION   Y(LDY,*), TOL, PIV(*), BETA(*), SIZ(*)
      INTEGER            GRP(1)
      EXTERNAL           GSQRG
C
      GRP(1) = 0
      CALL GSQRG( N, M, Y, LDY, TOL, GRP, PIV, BETA, SIZ, RANK )
      END
      SUBROUTINE GSQRG( N, M, Y, LDY, TOL, GRP, PIV, BETA, SIZ, RANK )
C
C     PURPOSE
C     Rank-revealing factorization Y*P = Q*R by Householder reflections
C     with column interchanges.
C
C     ARGUMENTS
C     N, M    (input) INTEGER, rows and columns of Y, N, M >= 0.
C     Y       (input/output) DOUBLE PRECISION array, dimension (LDY,M):
C             on exit the first RANK rows of its upper triangle hold R;
C             below the diagonal are the vectors of the reflections
C             I - BETA(K)*v*v', v(K) = 1.
C     LDY     (input) INTEGER, LDY >= MAX(1,N).
C     TOL     (input) DOUBLE PRECISION: a column is dependent on those
C             before it if what is left of it is not above TOL times its
C             size (or if that is not above TOL/500 or 4D-14 times the
C             largest).
C     GRP     (input) INTEGER array, dimension (M): the group of every
C             column, named by its first one.  The size of a column is
C             the largest length in its group, or a thousandth of the
C             largest of all where that is more; GRP(1) = 0: its own.
C     PIV     (output) DOUBLE PRECISION array, dimension (M): column K
C             of Y*P is column PIV(K) of Y (a whole number).
C     BETA    (output) DOUBLE PRECISION array, dimension (MIN(N,M)).
C     SIZ     (workspace) DOUBLE PRECISION array, dimension (M).
C     RANK    (output) INTEGER, the rank found.
C
      IMPLICIT NONE
      INTEGER            N, M, LDY, GRP(*), RANK
      DOUBLE PRECISION   Y(LDY,*), TOL, PIV(*), BETA(*), SIZ(*)
      DOUBLE PRECISION   GSEPS, S, D, BIG, BEST, SMALL
      EXTERNAL           GSEPS, GSGRP
      INTEGER            I, J, K, P
C
      BIG = 0.0D0
      DO 20 J = 1, M
         S = 0.0D0
         DO 10 I = 1, N
            S = S + Y(I,J)*Y(I,J)
   10    CONTINUE
         SIZ(J) = S
         PIV(J) = DBLE( J )
         BIG = MAX( BIG, S )
   20 CONTINUE
      CALL GSGRP( M, GRP, 1.0D-6, SIZ )
      SMALL = MIN( TOL/5.0D2, 2.0D2*GSEPS() )
C
      RANK = 0
      DO 110 K = 1, MIN( N, M )
C
C        -- the column of which most is left, relative to its size
         P = 0
         D = 0.0D0
         BEST = TOL*TOL
         DO 40 J = K, M
            IF ( SIZ(J).GT.SMALL*SMALL*BIG ) THEN
               S = 0.0D0
               DO 30 I = K, N
                  S = S + Y(I,J)*Y(I,J)
   30          CONTINUE
               IF ( S.GT.BEST*SIZ(J) ) THEN
                  BEST = S/SIZ(J)*( 1.0D0 + 1.0D-8 )
                  P = J
                  D = S
               END IF
            END IF
   40    CONTINUE
         IF ( P.EQ.0 ) RETURN
         IF ( P.NE.K ) THEN
            DO 50 I = 1, N
               S = Y(I,K)
               Y(I,K) = Y(I,P)
               Y(I,P) = S
   50       CONTINUE
            S = PIV(K)
            PIV(K) = PIV(P)
            PIV(P) = S
            S = SIZ(K)
            SIZ(K) = SIZ(P)
            SIZ(P) = S
         END IF
         RANK = K
C
C        -- the reflection
         D = -SIGN( SQRT( D ), Y(K,K) )
         BETA(K) = ( D - Y(K,K) )/D
         S = 1.0D0/( Y(K,K) - D )
         DO 70 I = K + 1, N
            Y(I,K) = Y(I,K)*S
   70    CONTINUE
         Y(K,K) = D
         DO 100 J = K + 1, M
            S = Y(K,J)
            DO 80 I = K + 1, N
               S = S + Y(I,K)*Y(I,J)
   80       CONTINUE
            S = S*BETA(K)
            Y(K,J) = Y(K,J) - S
            DO 90 I = K + 1, N
               Y(I,J) = Y(I,J) - S*Y(I,K)
   90       CONTINUE
  100    CONTINUE
  110 CONTINUE
      END
      SUBROUTINE GSGRP( M, GRP, PART, SIZ )
C
C     PURPOSE
C     Every entry of SIZ (dimension M) becomes the largest of its group,
C     and no less than PART times the largest of all: GRP(I) is the
C     first member of the group of I.  GRP(1) = 0: all stay what they
C     are.
C
      IMPLICIT NONE
      INTEGER            M, GRP(*)
      DOUBLE PRECISION   PART, SIZ(*)
      DOUBLE PRECISION   BIG
      INTEGER            I
C
      IF ( GRP(1).EQ.0 ) RETURN
      BIG = 0.0D0
      DO 10 I = 1, M
         SIZ(GRP(I)) = MAX( SIZ(GRP(I)), SIZ(I) )
         BIG = MAX( BIG, SIZ(I) )
   10 CONTINUE
      DO 20 I = 1, M
         SIZ(I) = MAX( SIZ(GRP(I)), PART*BIG )
   20 CONTINUE
      END
      SUBROUTINE GSQRC( N, M, Y, LDY, TOL, PIV, BETA, SIZ, RANK )
C
C     PURPOSE
C     As GSQRP, but the next column is the one of which most is left in
C     its own unit: the first RANK columns are far from dependent, and
C     inv(R11)*R12 has no large entries.  A column is dependent if what
C     is left of it is not above TOL times the largest column.
C
      IMPLICIT NONE
      INTEGER            N, M, LDY, RANK
      DOUBLE PRECISION   Y(LDY,*), TOL, PIV(*), BETA(*), SIZ(*)
      DOUBLE PRECISION   S, D, BIG
      EXTERNAL           GSHRF
      INTEGER            I, J, K, P
C
      BIG = 0.0D0
      DO 10 J = 1, M
         PIV(J) = DBLE( J )
   10 CONTINUE
      RANK = 0
      DO 60 K = 1, MIN( N, M )
         P = K
         D = -1.0D0
         DO 30 J = K, M
            S = 0.0D0
            DO 20 I = K, N
               S = S + Y(I,J)*Y(I,J)
   20       CONTINUE
            IF ( S.GT.D*( 1.0D0 + 1.0D-8 ) ) THEN
               P = J
               D = S
            END IF
   30    CONTINUE
         IF ( K.EQ.1 ) BIG = D
         IF ( .NOT.( D.GT.TOL*TOL*BIG ) ) RETURN
         IF ( P.NE.K ) THEN
            DO 40 I = 1, N
               S = Y(I,K)
               Y(I,K) = Y(I,P)
               Y(I,P) = S
   40       CONTINUE
            S = PIV(K)
            PIV(K) = PIV(P)
            PIV(P) = S
         END IF
         RANK = K
         SIZ(K) = SQRT( D )
         CALL GSHRF( N, M, K, Y, LDY, D, BETA(K) )
   60 CONTINUE
      END
      SUBROUTINE GSHRF( N, M, K, Y, LDY, D, BETA )
C
C     PURPOSE
C     The K-th Householder reflection, as in GSQRP: D is the squared
C     length of rows K to N of column K.
C
      IMPLICIT NONE
      INTEGER            N, M, K, LDY
      DOUBLE PRECISION   Y(LDY,*), D, BETA
      DOUBLE PRECISION   R, S
      INTEGER            I, J
C
      R = -SIGN( SQRT( D ), Y(K,K) )
      BETA = ( R - Y(K,K) )/R
      S = 1.0D0/( Y(K,K) - R )
      DO 10 I = K + 1, N
         Y(I,K) = Y(I,K)*S
   10 CONTINUE
      Y(K,K) = R
      DO 40 J = K + 1, M
         S = Y(K,J)
         DO 20 I = K + 1, N
            S = S + Y(I,K)*Y(I,J)
   20    CONTINUE
         S = S*BETA
         Y(K,J) = Y(K,J) - S
         DO 30 I = K + 1, N
            Y(I,J) = Y(I,J) - S*Y(I,K)
   30    CONTINUE
   40 CONTINUE
      END
      SUBROUTINE GSQMV( N, K, Y, LDY, BETA, B, TRANS )
C
C     PURPOSE
C     B := Q*B, or Q'*B where TRANS = 1, Q from GSQRP with rank K; B has
C     N entries.
C
      IMPLICIT NONE
      INTEGER            N, K, LDY, TRANS
      DOUBLE PRECISION   Y(LDY,*), BETA(*), B(*)
      DOUBLE PRECISION   S
      INTEGER            I, J, L
C
      DO 30 L = 1, K
         J = L
         IF ( TRANS.EQ.0 ) J = K + 1 - L
         S = B(J)
         DO 10 I = J + 1, N
            S = S + Y(I,J)*B(I)
   10    CONTINUE
         S = S*BETA(J)
         B(J) = B(J) - S
         DO 20 I = J + 1, N
            B(I) = B(I) - S*Y(I,J)
   20    CONTINUE
   30 CONTINUE
      END
