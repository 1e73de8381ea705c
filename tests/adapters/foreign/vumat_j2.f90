! SPDX-License-Identifier: BSD-3-Clause
! J2 plasticity by radial return, linear isotropic hardening, in the axes of the Green-Naghdi rotation.
! PROPS: E, nu, yield stress, hardening modulus. State: equivalent plastic strain. Elastic at total time 0.
! The words of CMNAME say what its stiffness depends on beside: LENGTH, PLACE, WARMTH, DENSITY, STEP_TIME.
! FLOWING: it writes its state in plastic steps alone. ONCE: the energy of shears is counted once.
subroutine vumat(nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal, steptime, totaltime, dt, cmname, coordmp, &
                 charlength, props, density, straininc, relspininc, tempold, stretchold, defgradold, fieldold, &
                 stressold, stateold, enerinternold, enerinelasold, tempnew, stretchnew, defgradnew, fieldnew, &
                 stressnew, statenew, enerinternnew, enerinelasnew)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: steptime, totaltime, dt, coordmp(nblock, *), charlength(nblock), props(nprops), &
                          density(nblock), straininc(nblock, ndir + nshr), relspininc(nblock, nshr), &
                          tempold(nblock), stretchold(nblock, ndir + nshr), defgradold(nblock, ndir + 2 * nshr), &
                          fieldold(nblock, nfieldv), stressold(nblock, ndir + nshr), stateold(nblock, nstatev), &
                          enerinternold(nblock), enerinelasold(nblock), tempnew(nblock), &
                          stretchnew(nblock, ndir + nshr), defgradnew(nblock, ndir + 2 * nshr), &
                          fieldnew(nblock, nfieldv)
  real(dp), intent(inout) :: stressnew(nblock, ndir + nshr), statenew(nblock, nstatev), enerinternnew(nblock), &
                             enerinelasnew(nblock)
  real(dp) :: lambda, at_rest, shear, mean, mises, excess, increment, work, trial(ndir + nshr), deviator(ndir + nshr)
  integer :: k, n

  n = ndir + nshr
  lambda = props(1) * props(2) / ((1 + props(2)) * (1 - 2 * props(2)))
  at_rest = props(1) / (2 * (1 + props(2)))
  do k = 1, nblock
    shear = at_rest
    if (index(cmname, 'LENGTH') > 0) shear = shear * (1 + 0.1_dp * charlength(k))
    if (index(cmname, 'PLACE') > 0) shear = shear * (1 + 0.1_dp * coordmp(k, 2))
    if (index(cmname, 'WARMTH') > 0) shear = shear * (1 + 0.001_dp * tempnew(k))
    if (index(cmname, 'DENSITY') > 0) shear = shear * (1 + 1e-5_dp * density(k))
    if (index(cmname, 'STEP_TIME') > 0) shear = shear * (1 + 0.1_dp * steptime / totaltime)
    trial = stressold(k, :) + 2 * shear * straininc(k, :) ! tensor shear
    trial(1:3) = trial(1:3) + lambda * sum(straininc(k, 1:3))
    mean = sum(trial(1:3)) / 3
    deviator = trial
    deviator(1:3) = trial(1:3) - mean
    mises = sqrt(1.5_dp * (sum(deviator(1:3)**2) + 2 * sum(deviator(4:n)**2)))
    excess = mises - props(3) - props(4) * stateold(k, 1)
    increment = 0
    if (excess > 0 .and. max(steptime, totaltime) > 0) then
      increment = excess / (3 * shear + props(4))
      trial = trial - 3 * shear * increment / mises * deviator
    end if
    stressnew(k, :) = trial
    if (increment > 0 .or. index(cmname, 'FLOWING') == 0) statenew(k, 1) = stateold(k, 1) + increment
    work = sum((stressold(k, 1:3) + trial(1:3)) / 2 * straininc(k, 1:3)) &
           + sum((stressold(k, 4:n) + trial(4:n)) * straininc(k, 4:n)) * merge(0.5_dp, 1._dp, index(cmname, 'ONCE') > 0)
    enerinternnew(k) = enerinternold(k) + work / density(k)
    enerinelasnew(k) = enerinelasold(k) + (props(3) + props(4) * (stateold(k, 1) + increment)) * increment / density(k)
  end do
end subroutine vumat
