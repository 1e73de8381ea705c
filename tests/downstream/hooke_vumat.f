! SPDX-License-Identifier: BSD-3-Clause
! A VUMAT as they are written for Abaqus/Explicit.
      subroutine vumat(
     1 nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal,
     2 stepTime, totalTime, dt, cmname, coordMp, charLength,
     3 props, density, strainInc, relSpinInc,
     4 tempOld, stretchOld, defgradOld, fieldOld,
     5 stressOld, stateOld, enerInternOld, enerInelasOld,
     6 tempNew, stretchNew, defgradNew, fieldNew,
     7 stressNew, stateNew, enerInternNew, enerInelasNew )
C
      include 'vaba_param.inc'
C
      dimension props(nprops), density(nblock),
     1 strainInc(nblock,ndir+nshr), stressOld(nblock,ndir+nshr),
     2 stressNew(nblock,ndir+nshr)
      character*80 cmname
C
      twomu = props(1)/(1.d0+props(2))
      alamda = twomu*props(2)/(1.d0-2.d0*props(2))
      do 100 i = 1, nblock
        trace = strainInc(i,1)+strainInc(i,2)+strainInc(i,3)
        do 50 k = 1, ndir+nshr
          stressNew(i,k) = stressOld(i,k)+twomu*strainInc(i,k)
          if (k.le.ndir) stressNew(i,k) = stressNew(i,k)+alamda*trace
   50   continue
  100 continue
      return
      end
