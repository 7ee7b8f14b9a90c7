      SUBROUTINE GSIKS( N, NB, NM, QC, RAD, LIM, RES, QS, LDQ, NS, BR,
     $                  DST, NEAR, INFO )
C
C     PURPOSE
C     Of all branches of a closed form of inverse kinematics, those that
C     are real.
C
C     ARGUMENTS
C     N       (input) INTEGER, coordinates, N >= 1.
C     NB      (input) INTEGER, branches, NB >= 1.
C     NM      (input) INTEGER, numbers that a branch depends on, NM >= 1.
C     QC      (input) DOUBLE PRECISION array, dimension (N,NB): the
C             coordinates of each branch [rad, m].
C     RAD     (input) DOUBLE PRECISION array, dimension (NM,NB): radicands
C             of its roots and squares of what its directions are found
C             from, beside their largest values [1].
C     LIM     (input) DOUBLE PRECISION array, dimension (NM): where RAD is
C             at most that, the pose is singular [1].
C     RES     (input) DOUBLE PRECISION array, dimension (2,NB): what each
C             branch misses, of the place [m] and of the axes: the largest
C             change of a unit vector [1].
C     QS      (output) DOUBLE PRECISION array, dimension (LDQ,NB): the NS
C             solutions, a column each, then 0.
C     LDQ     (input) INTEGER, LDQ >= N.
C     NS      (output) INTEGER, number of solutions.
C     BR      (output) INTEGER array, dimension (NB): their branches.
C     DST     (output) DOUBLE PRECISION array, dimension (2): 0, or where
C             there is no solution what the best branch misses [m, 1]; of a
C             root that is not real the branch has 0 in its place.
C     NEAR    (output) INTEGER, 1 where a branch is close to another or a
C             coordinate almost free: the radicand of a root is within 1D7
C             times LIM of 0, a square (LIM below 1D-20) below 1D-6; or
C             where a solution misses more than 1D-13; else 0.
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     A branch is real where no radicand is below -1D-12, which is taken
C     for the rounding of a double root, and what it misses is below
C     1D-9. Of two branches that are equal to 1D-12 the first counts.
C
C     ERROR INDICATOR
C     INFO =  0  ok;
C     INFO = -9  LDQ is below N;
C     INFO =  1  there is no solution;
C     INFO =  2  a solution is singular: two branches coincide, or a
C                coordinate is free.
C
      IMPLICIT NONE
      INTEGER            N, NB, NM, LDQ, NS, BR(NB), NEAR, INFO
      DOUBLE PRECISION   QC(N,NB), RAD(NM,NB), LIM(NM), RES(2,NB)
      DOUBLE PRECISION   QS(LDQ,NB), DST(2), LEAST, MISS, WIDE
      INTEGER            I, K, GSIKQ, LOW
      LOGICAL            REAL, EDGE, BESIDE
      EXTERNAL           GSIKQ
C
      NS = 0
      NEAR = 0
      INFO = 0
      DST(1) = 0.0D0
      DST(2) = 0.0D0
      IF ( LDQ.LT.N ) THEN
         INFO = -9
         RETURN
      END IF
      LEAST = -1.0D0
      WIDE = 1.0D-6
      DO 2 I = 1, NM
         WIDE = MAX( WIDE, 1.0D7*LIM(I) )
    2 CONTINUE
      DO 5 K = 1, NB
         BR(K) = 0
         DO 3 I = 1, N
            QS(I,K) = 0.0D0
    3    CONTINUE
    5 CONTINUE
      DO 30 K = 1, NB
         REAL = .TRUE.
         EDGE = .FALSE.
         BESIDE = .FALSE.
C        -- where all of RAD is large, as it is as a rule, all is said
         LOW = 0
         DO 8 I = 1, NM
            IF ( .NOT.( RAD(I,K).GT.WIDE ) ) LOW = LOW + 1
    8    CONTINUE
         IF ( LOW.GT.0 ) THEN
            DO 10 I = 1, NM
               IF ( .NOT.( RAD(I,K).GE.-1.0D-12 ) ) REAL = .FALSE.
               IF ( RAD(I,K).LE.LIM(I) ) EDGE = .TRUE.
               IF ( LIM(I).GT.1.0D-20 .AND.
     $              ABS( RAD(I,K) ).LE.1.0D7*LIM(I) ) BESIDE = .TRUE.
               IF ( LIM(I).LE.1.0D-20 .AND. RAD(I,K).GT.LIM(I) .AND.
     $              RAD(I,K).LE.1.0D-6 ) BESIDE = .TRUE.
   10       CONTINUE
         END IF
         IF ( BESIDE ) NEAR = 1
         MISS = MAX( RES(1,K), RES(2,K) )
         IF ( .NOT.( REAL .AND. MISS.LE.1.0D-9 ) ) THEN
            REAL = .FALSE.
            IF ( LEAST.LT.0.0D0 .OR. MISS.LT.LEAST ) THEN
               LEAST = MISS
               DST(1) = RES(1,K)
               DST(2) = RES(2,K)
            END IF
         END IF
         IF ( REAL .AND. MISS.GT.1.0D-13 ) NEAR = 1
         IF ( REAL ) THEN
            IF ( GSIKQ( N, QC(1,K), QS, LDQ, NS ).EQ.0 ) THEN
               NS = NS + 1
               BR(NS) = K
               DO 20 I = 1, N
                  QS(I,NS) = QC(I,K)
   20          CONTINUE
            END IF
            IF ( EDGE ) INFO = 2
         END IF
   30 CONTINUE
      IF ( NS.EQ.0 ) INFO = 1
      IF ( NS.GT.0 ) THEN
         DST(1) = 0.0D0
         DST(2) = 0.0D0
      END IF
      END
C
      INTEGER FUNCTION GSIKQ( N, Q, QS, LDQ, NS )
C
C     PURPOSE
C     Which of the NS columns of QS is Q, to 1D-12: its number, or 0.
C
C     ARGUMENTS
C     N       (input) INTEGER, coordinates.
C     Q       (input) DOUBLE PRECISION array, dimension (N) [rad, m].
C     QS      (input) DOUBLE PRECISION array, dimension (LDQ,NS).
C     LDQ     (input) INTEGER, LDQ >= N.
C     NS      (input) INTEGER, columns, NS >= 0.
C
C     METHOD
C     Differences of components, up to the first that is larger.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      INTEGER            N, LDQ, NS, I, K
      DOUBLE PRECISION   Q(N), QS(LDQ,*)
C
      GSIKQ = 0
      DO 20 K = 1, NS
         DO 10 I = 1, N
            IF ( ABS( Q(I) - QS(I,K) ).GT.1.0D-12 ) GO TO 20
   10    CONTINUE
         GSIKQ = K
         RETURN
   20 CONTINUE
      END
