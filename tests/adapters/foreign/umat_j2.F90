! SPDX-License-Identifier: BSD-3-Clause
! J2 plasticity by radial return: isotropic and kinematic hardening, both linear, small increments of strain.
!   sqrt(3/2) |dev sigma - alpha| <= yield + H p,   d alpha = (2/3) C d eps_p
! PROPS: E, nu, yield stress, H, C. STATEV: alpha (11, 22, 33, 12, 13, 23), p.
! STRESS arrives rotated; alpha is rotated here (UNROTATED: the classic omission). ELASTIC_DDSDDE: another one.
! BACK_STRESS_ALONE: H is 0, and STATEV is alpha alone.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(nstatv), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  external :: rotsig, sinv
  real(dp) :: bulk, shear, excess, increment, alpha(6), xi(6), mean, mises, p
  integer :: i

  bulk = props(1) / (3 * (1 - 2 * props(2)))
  shear = props(1) / (2 * (1 + props(2)))
#ifdef UNROTATED
  alpha = statev(1:6)
#else
  call rotsig(statev, drot, alpha, 1, 3, 3)
#endif
#ifdef BACK_STRESS_ALONE
  p = 0
#else
  p = statev(7)
#endif
  call fill_elastic(bulk, shear, ddsdde)
  do i = 1, ntens
    stress = stress + ddsdde(:, i) * dstran(i)
  end do
  xi = -alpha
  xi(1:ntens) = xi(1:ntens) + stress
  call sinv(xi, mean, mises, ndi, nshr)
  xi(1:3) = xi(1:3) - mean
  excess = mises - props(3) - props(4) * p
  if (excess > 0) then
    increment = excess / (3 * shear + props(4) + props(5))
    stress = stress - 3 * shear * increment / mises * xi(1:ntens)
    alpha = alpha + props(5) * increment / mises * xi
#ifndef ELASTIC_DDSDDE
    call fill_elastic(bulk, shear * (1 - 3 * shear * increment / mises), ddsdde)
    do i = 1, ntens
      ddsdde(:, i) = ddsdde(:, i) - 9 * shear**2 / mises**2 * xi(1:ntens) * xi(i) &
                     * (1 / (3 * shear + props(4) + props(5)) - increment / mises)
    end do
#endif
#ifndef BACK_STRESS_ALONE
    statev(7) = p + increment
    spd = spd + (props(3) + props(4) * statev(7)) * increment
#endif
  end if
  statev(1:6) = alpha

contains

  subroutine fill_elastic(bulk, shear, moduli)
    real(dp), intent(in) :: bulk, shear
    real(dp), intent(out) :: moduli(:, :)
    integer :: k
    moduli = 0
    moduli(1:3, 1:3) = bulk - 2 * shear / 3
    do k = 1, size(moduli, 1)
      moduli(k, k) = moduli(k, k) + merge(2 * shear, shear, k <= 3)
    end do
  end subroutine fill_elastic
end subroutine umat
