! SPDX-License-Identifier: BSD-3-Clause
! Elasticity of a crystal: nine moduli in axes of its own, turned by Bond's matrices.
! PROPS: C11, C22, C33, C12, C13, C23, C1212, C1313, C2323, C21 / C12, Bunge's angles phi1, Phi, phi2 [rad].
! Small increments; STATEV: the three axes of the crystal, which DROT turns (fixed axes). COROTATIONAL: axes that stand
! still, for a host that turns them. GREEN: S = C E of Green's strain, from DFGRD1.
! Mistakes: WRONG_SIGN of one coefficient, STRESS_BOND for the strain, TURNED_ON: the stress as the strain, not back.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, parameter :: first(6) = [1, 2, 3, 1, 1, 2], second(6) = [1, 2, 3, 2, 3, 3]
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(nstatv), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  real(dp) :: axes(3, 3), moduli(6, 6), m(6, 6), n(6, 6)

  axes = euler(props(11), props(12), props(13))
#if !defined(GREEN) && !defined(COROTATIONAL)
  if (time(2) > 0) axes = transpose(reshape(statev(1:9), [3, 3]))
  axes = matmul(axes, transpose(drot))
  statev(1:9) = reshape(transpose(axes), [9])
#endif
  m = bond(axes)
  n = m
  n(1:3, 4:6) = n(1:3, 4:6) / 2
  n(4:6, 1:3) = n(4:6, 1:3) * 2
#ifdef WRONG_SIGN
  n(4, 5) = -n(4, 5)
#endif
#if defined(STRESS_BOND)
  moduli = matmul(transpose(n), matmul(crystal_moduli(), m))
#elif defined(TURNED_ON)
  moduli = matmul(m, matmul(crystal_moduli(), n))
#else
  moduli = matmul(transpose(n), matmul(crystal_moduli(), n))
#endif
#ifdef GREEN
  call total()
#else
  ddsdde = moduli
  stress = stress + matmul(moduli, dstran)
#endif

contains

  ! Rows: the axes of the crystal.
  function euler(phi1, tilt, phi2) result(r)
    real(dp), intent(in) :: phi1, tilt, phi2
    real(dp) :: r(3, 3)
    r(1, :) = [cos(phi1) * cos(phi2) - sin(phi1) * sin(phi2) * cos(tilt), &
               sin(phi1) * cos(phi2) + cos(phi1) * sin(phi2) * cos(tilt), sin(phi2) * sin(tilt)]
    r(2, :) = [-cos(phi1) * sin(phi2) - sin(phi1) * cos(phi2) * cos(tilt), &
               -sin(phi1) * sin(phi2) + cos(phi1) * cos(phi2) * cos(tilt), cos(phi2) * sin(tilt)]
    r(3, :) = [sin(phi1) * sin(tilt), -cos(phi1) * sin(tilt), cos(tilt)]
  end function euler

  function crystal_moduli() result(c)
    real(dp) :: c(6, 6)
    integer :: k
    c = 0
    do k = 1, 3
      c(k, k) = props(k)
      c(3 + k, 3 + k) = props(6 + k)
    end do
    c(1, 2) = props(4)
    c(2, 1) = props(4) * props(10)
    c(1, 3) = props(5)
    c(3, 1) = props(5)
    c(2, 3) = props(6)
    c(3, 2) = props(6)
  end function crystal_moduli

  ! Of stresses.
  function bond(r) result(b)
    real(dp), intent(in) :: r(3, 3)
    real(dp) :: b(6, 6)
    integer :: row, column
    do column = 1, 6
      do row = 1, 6
        b(row, column) = r(first(row), first(column)) * r(second(row), second(column))
        if (column > 3) b(row, column) = b(row, column) + r(first(row), second(column)) * r(second(row), first(column))
      end do
    end do
  end function bond

  ! sigma = F S F^T / J, and the tangent of J sigma with Jaumann's rate, over J.
  subroutine total()
    real(dp) :: strain(3, 3), piola(6), s(3, 3), jacobian, push(6, 6), delta(3, 3)
    integer :: a, b, i, j, k, l
    strain = matmul(transpose(dfgrd1), dfgrd1) / 2
    delta = 0
    do k = 1, 3
      strain(k, k) = strain(k, k) - 0.5_dp
      delta(k, k) = 1
    end do
    do k = 1, 6
      piola(k) = strain(first(k), second(k)) * merge(1, 2, k <= 3)
    end do
    piola = matmul(moduli, piola)
    do k = 1, 6
      s(first(k), second(k)) = piola(k)
      s(second(k), first(k)) = piola(k)
    end do
    jacobian = dfgrd1(1, 1) * (dfgrd1(2, 2) * dfgrd1(3, 3) - dfgrd1(2, 3) * dfgrd1(3, 2)) &
               - dfgrd1(1, 2) * (dfgrd1(2, 1) * dfgrd1(3, 3) - dfgrd1(2, 3) * dfgrd1(3, 1)) &
               + dfgrd1(1, 3) * (dfgrd1(2, 1) * dfgrd1(3, 2) - dfgrd1(2, 2) * dfgrd1(3, 1))
    s = matmul(dfgrd1, matmul(s, transpose(dfgrd1))) / jacobian
    do k = 1, 6
      stress(k) = s(first(k), second(k))
    end do
    push = bond(dfgrd1)
    ddsdde = matmul(push, matmul(moduli, transpose(push))) / jacobian
    do b = 1, 6
      do a = 1, 6
        i = first(a)
        j = second(a)
        k = first(b)
        l = second(b)
        ddsdde(a, b) = ddsdde(a, b) + (delta(i, k) * s(j, l) + delta(i, l) * s(j, k) + delta(j, k) * s(i, l) &
                                       + delta(j, l) * s(i, k)) / 2
      end do
    end do
  end subroutine total
end subroutine umat
