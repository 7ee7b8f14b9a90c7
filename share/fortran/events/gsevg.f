      SUBROUTINE GSEVG( N, NH, NC, K, KIND, MODE, S, PRM, HOLD, D, Z,
     $                  G )
C
C     PURPOSE
C     The derivatives of event function K of GSEVT.
C
C     ARGUMENTS
C     N       (input) INTEGER, the rows of Z ahead of those of the ports.
C     NH      (input) INTEGER, the number of ports.
C     NC      (input) INTEGER, the number of columns: what it is
C             differentiated by.
C     K       (input) INTEGER, the number of the port.
C     KIND, MODE, S, PRM, HOLD (input) as GSEVT.
C     D       (input) DOUBLE PRECISION array, dimension (6*NH,NC): of
C             each port the derivatives of S, SD, PRM(1..4).
C     Z       (input) DOUBLE PRECISION array, dimension (N+NH,NC): behind
C             the first N rows the derivatives of HOLD; read where port K
C             is held.
C     G       (output) DOUBLE PRECISION array, dimension (NC).
C
      IMPLICIT NONE
      INTEGER            N, NH, NC, K, KIND(*), MODE(*)
      DOUBLE PRECISION   S(*), PRM(4,*), HOLD(*), D(6*NH,*), Z(N+NH,*),
     $                   G(*)
      DOUBLE PRECISION   A, B, R, SIDE
      INTEGER            J, L
C
      L = 6*( K - 1 )
      SIDE = DBLE( MODE(K) )
      IF ( KIND(K).EQ.1 .AND. MODE(K).NE.0 ) THEN
         DO 10 J = 1, NC
            G(J) = SIDE*D(L+2,J) + 1.0D-9*D(L+4,J)
   10    CONTINUE
      ELSE IF ( KIND(K).EQ.2 .AND. MODE(K).EQ.0 ) THEN
         R = PRM(2,K) - PRM(1,K)
         A = ( PRM(2,K) - S(K) )/R
         B = ( S(K) - PRM(1,K) )/R
         DO 20 J = 1, NC
            G(J) = ( A - B )*D(L+1,J) + B*B*D(L+4,J) - A*A*D(L+3,J)
   20    CONTINUE
      ELSE IF ( KIND(K).EQ.2 ) THEN
         DO 30 J = 1, NC
            G(J) = -SIDE*Z(N+K,J)
   30    CONTINUE
      ELSE
         SIDE = SIGN( 1.0D0, HOLD(K) )
         DO 40 J = 1, NC
            G(J) = D(L+3,J) - SIDE*Z(N+K,J)
   40    CONTINUE
      END IF
      END
      SUBROUTINE GSHJC( NU, NLAM, NH, NQ, NZ, ACT, LM, LB, LC, K, Z, IW,
     $                  INFO )
C
C     PURPOSE
C     GSJAC of a scene with NH ports that may be held: their rows stand
C     behind the constraints.
C
C     ARGUMENTS
C     As GSJAC, with NLAM+NH for NLAM, and
C     ACT     (input/output) INTEGER array, dimension (NH), 1: the port
C             is held; else its row says that its effort is 0.  0 on
C             exit where the constraints and the ports before it hold it
C             already.
C     INFO    (output) INTEGER, 0; 2: the constraints are dependent; 3:
C             ports are, so that their efforts are not unique: those of
C             the first ones stand for all, accelerations are right.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NH, NQ, NZ, ACT(*), IW(*), INFO
      DOUBLE PRECISION   LM(NU,*), LB(NU,*), LC(NU,*),
     $                   K(NU+NLAM+NH,*), Z(NU+NLAM+NH,*)
      EXTERNAL           GSJAC, GSHJD, GSHJP
      INTEGER            I, J, L, N, TWICE
C
      CALL GSHJD( NU, NLAM, NH, ACT, K, TWICE )
      N = NU + NLAM + NH
      L = NU + NLAM
      DO 30 I = 1, NH
         IF ( ACT(I).EQ.1 ) THEN
            L = L + 1
            DO 10 J = 1, NU
               K(L,J) = K(NU+NLAM+I,J)
               K(J,L) = K(J,NU+NLAM+I)
   10       CONTINUE
            DO 20 J = 1, NZ
               Z(L,J) = Z(NU+NLAM+I,J)
   20       CONTINUE
         END IF
   30 CONTINUE
      CALL GSHJP( N, L, L, K, 1 )
      CALL GSHJP( N, L, NZ, Z, 1 )
      INFO = 0
      J = L - NU
      CALL GSJAC( NU, J, NQ, NZ, LM, LB, LC, K, Z, IW, INFO )
      CALL GSHJP( N, L, NZ, Z, -1 )
      DO 60 I = NH, 1, -1
         DO 50 J = 1, NZ
            IF ( ACT(I).EQ.1 ) THEN
               Z(NU+NLAM+I,J) = Z(L,J)
            ELSE
               Z(NU+NLAM+I,J) = 0.0D0
            END IF
   50    CONTINUE
         IF ( ACT(I).EQ.1 ) L = L - 1
   60 CONTINUE
      IF ( INFO.NE.0 ) INFO = 2
      IF ( INFO.EQ.0 .AND. TWICE.GT.0 ) INFO = 3
      END
      SUBROUTINE GSHJP( N, L, M, A, WAY )
C
C     PURPOSE
C     The first L rows of M columns of A(N,*) to a leading dimension of L
C     (WAY = 1), or back (-1).
C
      IMPLICIT NONE
      INTEGER            N, L, M, WAY
      DOUBLE PRECISION   A(*)
      INTEGER            I, J
C
      IF ( L.EQ.N ) RETURN
      IF ( WAY.GT.0 ) THEN
         DO 20 J = 1, M - 1
            DO 10 I = 1, L
               A(I+L*J) = A(I+N*J)
   10       CONTINUE
   20    CONTINUE
      ELSE
         DO 40 J = M - 1, 1, -1
            DO 30 I = L, 1, -1
               A(I+N*J) = A(I+L*J)
   30       CONTINUE
   40    CONTINUE
      END IF
      END
      SUBROUTINE GSHJD( NU, NLAM, NH, ACT, K, TWICE )
C
C     PURPOSE
C     Which ports of GSHJC the constraints and the ports before them hold
C     already: ACT becomes 0, TWICE is how many.
C
C     METHOD
C     Gram and Schmidt; the first NU rows and columns of K are workspace.
C
      IMPLICIT NONE
      INTEGER            NU, NLAM, NH, ACT(*), TWICE
      DOUBLE PRECISION   K(NU+NLAM+NH,*)
      DOUBLE PRECISION   S, SIZE
      INTEGER            I, J, L, R, P
C
      TWICE = 0
      R = 0
      DO 80 L = 1, NLAM + NH
         IF ( L.GT.NLAM ) THEN
            IF ( ACT(MAX( 1, L - NLAM )).NE.1 ) GO TO 80
         END IF
         P = R + 1
         IF ( P.GT.NU ) GO TO 70
         SIZE = 0.0D0
         DO 10 J = 1, NU
            K(J,P) = K(NU+L,J)
            SIZE = SIZE + K(J,P)**2
   10    CONTINUE
         DO 40 I = 1, 2*R
            S = 0.0D0
            DO 20 J = 1, NU
               S = S + K(J,P)*K(J,1+MOD( I-1, R ))
   20       CONTINUE
            DO 30 J = 1, NU
               K(J,P) = K(J,P) - S*K(J,1+MOD( I-1, R ))
   30       CONTINUE
   40    CONTINUE
         S = 0.0D0
         DO 50 J = 1, NU
            S = S + K(J,P)**2
   50    CONTINUE
         IF ( S.LE.1.0D-20*SIZE ) GO TO 70
         DO 60 J = 1, NU
            K(J,P) = K(J,P)/SQRT( S )
   60    CONTINUE
         R = P
         GO TO 80
   70    IF ( L.GT.NLAM ) THEN
            ACT(L-NLAM) = 0
            TWICE = TWICE + 1
         END IF
   80 CONTINUE
      END
