C SPDX-License-Identifier: BSD-3-Clause
C J2 plasticity with linear kinematic hardening, by radial return, for
C small increments of strain, three-dimensional or in plane strain.
C   sqrt(3/2) |dev(STRESS) - alpha| <= Y,  d alpha = (2/3) H d eps_p
C PROPS:  1 E [Pa], 2 nu, 3 yield stress Y [Pa], 4 modulus H [Pa]
C STATEV: 1 to 6 back stress alpha (11, 22, 33, 12, 13, 23) [Pa],
C         7 equivalent plastic strain
C Try it: assay check j2_kinematic.f --props 1e3,.3,5,50
      SUBROUTINE UMAT(STRESS,STATEV,DDSDDE,SSE,SPD,SCD,RPL,DDSDDT,
     1 DRPLDE,DRPLDT,STRAN,DSTRAN,TIME,DTIME,TEMP,DTEMP,PREDEF,DPRED,
     2 CMNAME,NDI,NSHR,NTENS,NSTATV,PROPS,NPROPS,COORDS,DROT,PNEWDT,
     3 CELENT,DFGRD0,DFGRD1,NOEL,NPT,LAYER,KSPT,JSTEP,KINC)
      INCLUDE 'ABA_PARAM.INC'
      CHARACTER*80 CMNAME
      DIMENSION STRESS(NTENS),STATEV(NSTATV),DDSDDE(NTENS,NTENS),
     1 DDSDDT(NTENS),DRPLDE(NTENS),STRAN(NTENS),DSTRAN(NTENS),TIME(2),
     2 PREDEF(1),DPRED(1),PROPS(NPROPS),COORDS(3),DROT(3,3),
     3 DFGRD0(3,3),DFGRD1(3,3),JSTEP(4)
      DIMENSION ALPHA(6),XI(6)
C
      G=PROPS(1)/(2.D0*(1.D0+PROPS(2)))
      BULK=PROPS(1)/(3.D0*(1.D0-2.D0*PROPS(2)))
      Y=PROPS(3)
      H=PROPS(4)
C STRESS comes in turned by DROT; a tensor in STATEV does not.
      CALL ROTSIG(STATEV(1:6),DROT,ALPHA,1,3,3)
      CALL MODULI(DDSDDE,NTENS,NDI,BULK,G)
      DO I=1,NTENS
        DO J=1,NTENS
          STRESS(J)=STRESS(J)+DDSDDE(J,I)*DSTRAN(I)
        END DO
      END DO
      P=(STRESS(1)+STRESS(2)+STRESS(3))/3.D0
      S2=0.D0
      DO I=1,NTENS
        XI(I)=STRESS(I)-ALPHA(I)
        IF (I.LE.NDI) XI(I)=XI(I)-P
        S2=S2+XI(I)**2
        IF (I.GT.NDI) S2=S2+XI(I)**2
      END DO
      Q=SQRT(1.5D0*S2)
      IF (Q.GT.Y) THEN
        DEP=(Q-Y)/(3.D0*G+H)
        DO I=1,NTENS
          STRESS(I)=STRESS(I)-3.D0*G*DEP/Q*XI(I)
          ALPHA(I)=ALPHA(I)+H*DEP/Q*XI(I)
        END DO
        CALL MODULI(DDSDDE,NTENS,NDI,BULK,G*(1.D0-3.D0*G*DEP/Q))
        FACTOR=9.D0*G**2/Q**2*(1.D0/(3.D0*G+H)-DEP/Q)
        DO I=1,NTENS
          DO J=1,NTENS
            DDSDDE(J,I)=DDSDDE(J,I)-FACTOR*XI(J)*XI(I)
          END DO
        END DO
        STATEV(7)=STATEV(7)+DEP
      END IF
      STATEV(1:6)=ALPHA
      END
C Isotropic elasticity, for shears 2 eps.
      SUBROUTINE MODULI(D,N,NDI,BULK,G)
      INCLUDE 'ABA_PARAM.INC'
      DIMENSION D(N,N)
      D=0.D0
      DO I=1,N
        IF (I.LE.NDI) THEN
          D(1:NDI,I)=BULK-2.D0*G/3.D0
          D(I,I)=D(I,I)+2.D0*G
        ELSE
          D(I,I)=G
        END IF
      END DO
      END
