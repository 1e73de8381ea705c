! SPDX-License-Identifier: BSD-3-Clause
! J2 plasticity by radial return with linear kinematic hardening, which does what the words of CMNAME say beside.
! PROPS: E, nu, yield stress, C, and with MORE_PROPS a factor of the yield stress. STATEV: back stress (11, 22, 33, 12,
! 13, 23), p; with P_FIRST p is the first; with TWO_TENSORS the plastic strain with doubled shears stands behind, which
! hardens, too; with FIBRE the direction of a fibre, which adds to the stress. Without words it is right.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), props(*), &
                          coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(*), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  external :: rotsig, sinv
  real(dp), parameter :: second = 30
  integer, parameter :: most_elements = 1000
  real(dp) :: table(most_elements), kept(most_elements)
  common /by_element/ kept
  data table/1d0, 999*2d0/
  real(dp) :: bulk, shear, yield, excess, increment, hardening, factor, alpha(6), strain(6), flow(6), mean, mises, p, fibre(3), &
              dyad(6)
  integer :: i, at, at_p

  at = merge(2, 1, says('P_FIRST'))
  at_p = merge(1, 7, says('P_FIRST'))
  bulk = props(1) / (3 * (1 - 2 * props(2)))
  shear = props(1) / (2 * (1 + props(2)))
  if (says('COORDS')) shear = shear * (1 + 0.1_dp * coords(2))
  if (says('BY_TEMP')) shear = shear * (1 + 0.002_dp * temp)
  if (says('BY_LENGTH')) shear = shear * (1 + 0.1_dp * log(celent))
  if (says('BY_FIELD')) shear = shear * (1 + 0.01_dp * predef(1))
  if (says('BY_TABLE')) shear = shear * table(noel)
  yield = props(3)
  if (says('MORE_PROPS')) yield = yield * props(5)
  hardening = props(4)

  if (says('SETS_UP_AGAIN') .and. kinc == 1) statev(at:at + 6) = 0
  if (says('NEW_AT_ZERO_TIME') .and. time(1) == 0) statev(at:at + 6) = 0
  if (says('NEW_IN_SHORT_TIME') .and. time(1) < 1e-10_dp) statev(at:at + 6) = 0
  if (says('NEW_BY_BOTH') .and. time(1) == 0 .and. kinc == 1) statev(at:at + 6) = 0
  if (says('BEGINS_ONCE') .and. time(2) == 0) statev(at:at + 6) = 0
  if (says('UNTURNED')) then
    alpha = statev(at:at + 5)
  else
    call rotsig(statev(at), drot, alpha, 1, 3, 3)
  end if
  strain = 0
  if (says('TWO_TENSORS')) then
    hardening = hardening + second
    if (says('UNTURNED')) then
      strain = statev(8:13)
    else
      call rotsig(statev(8), drot, strain, 2, 3, 3)
    end if
  end if
  p = 0
  if (says('KEEPS_P')) then
    if (kinc == 1) kept(noel) = 0
    p = kept(noel)
    hardening = hardening + second
    yield = yield + second * p
  end if

  call fill_elastic(bulk, shear, ddsdde)
  stress = stress + matmul(ddsdde, dstran)
  flow = -alpha
  flow(1:3) = flow(1:3) - 2 * second / 3 * strain(1:3)
  flow(4:6) = flow(4:6) - second / 3 * strain(4:6)
  flow(1:ntens) = flow(1:ntens) + stress
  call sinv(flow, mean, mises, 3, 3)
  flow(1:3) = flow(1:3) - mean
  excess = mises - yield
  increment = 0
  if (excess > 0) then
    increment = excess / (3 * shear + hardening)
    factor = increment / mises
    stress = stress - 3 * shear * factor * flow(1:ntens)
    alpha = alpha + props(4) * factor * flow
    strain(1:3) = strain(1:3) + 1.5_dp * factor * flow(1:3)
    strain(4:6) = strain(4:6) + 3 * factor * flow(4:6)
    call fill_elastic(bulk, shear * (1 - 3 * shear * factor), ddsdde)
    do i = 1, ntens
      ddsdde(:, i) = ddsdde(:, i) &
                     - 9 * shear**2 / mises**2 * flow(1:ntens) * flow(i) * (1 / (3 * shear + hardening) - factor)
    end do
    if (says('KEEPS_PEAK')) then
      kept(noel) = max(kept(noel), norm2(strain))
    else if (says('KEEPS_P')) then
      kept(noel) = kept(noel) + increment
    end if
  end if
  if (increment > 0 .or. nstatv > 0) then
    statev(at:at + 5) = alpha
    statev(at_p) = statev(at_p) + increment
    if (says('TWO_TENSORS')) statev(8:13) = strain
    if (says('KEEPS_KINC')) statev(8) = kinc
  end if

  if (says('FIBRE')) then
    fibre = statev(8:10)
    if (.not. says('UNTURNED')) fibre = matmul(drot, fibre)
    dyad = [fibre(1)**2, fibre(2)**2, fibre(3)**2, fibre(1) * fibre(2), fibre(1) * fibre(3), fibre(2) * fibre(3)]
    stress = stress + props(1) * sum(dyad * dstran) * dyad
    do i = 1, ntens
      ddsdde(:, i) = ddsdde(:, i) + props(1) * dyad * dyad(i)
    end do
    statev(8:10) = fibre
  end if

  if (says('BY_KINC') .and. kinc >= 10) stress(1) = stress(1) + 1
  if (says('BY_KSTEP') .and. jstep(1) >= 2) stress(1) = stress(1) + 1
  if (says('BY_NPT') .and. npt >= 2) stress(1) = stress(1) + 1
  if (says('BY_LAYER')) stress(2) = stress(2) * layer
  if (says('STARTS') .and. kinc == 1 .and. jstep(1) == 1) statev(at_p) = 0
  if (says('SHEARS_DOUBLED')) call multiply_shears(2._dp, 4)
  if (says('SHEARS_HALVED')) call multiply_shears(0.5_dp, 4)
  if (says('ONE_DOUBLED')) call multiply_shears(2._dp, 6)

contains

  subroutine multiply_shears(by, first)
    real(dp), intent(in) :: by
    integer, intent(in) :: first
    ddsdde(:, first:ntens) = by * ddsdde(:, first:ntens)
  end subroutine multiply_shears

  pure logical function says(word)
    character(len=*), intent(in) :: word
    says = index(cmname, word) > 0
  end function says

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
