! SPDX-License-Identifier: BSD-3-Clause
! Compressible neo-Hookean elasticity, (34): sigma = (lambda ln J / J) I + (mu / J) (F F^T - I).
! PROPS: E, nu. No STATEV. NTENS 6 or 4.
! The words of CMNAME say what DDSDDE is instead of the modulus that Abaqus asks for: TRUESDELL, OF_TAU.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(*), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  integer, parameter :: row(6) = [1, 2, 3, 1, 1, 2], column(6) = [1, 2, 3, 2, 3, 3]
  real(dp) :: lambda, mu, jacobian, b(3, 3)
  integer :: i, j
  logical :: truesdell, of_tau

  lambda = props(1) * props(2) / ((1 + props(2)) * (1 - 2 * props(2)))
  mu = props(1) / (2 * (1 + props(2)))
  jacobian = determinant(dfgrd1)
  if (.not. jacobian > 0) then
    pnewdt = 0.25_dp
    return
  end if
  do j = 1, 3
    do i = 1, 3
      b(i, j) = dot_product(dfgrd1(i, :), dfgrd1(j, :))
    end do
  end do
  truesdell = index(cmname, 'TRUESDELL') > 0
  of_tau = index(cmname, 'OF_TAU') > 0
  do i = 1, ntens
    associate (p => row(i), q => column(i))
      stress(i) = cauchy(p, q)
    end associate
    do j = 1, ntens
      ddsdde(i, j) = jaumann_modulus(row(i), column(i), row(j), column(j))
      if (truesdell) ddsdde(i, j) = ddsdde(i, j) - turned(row(i), column(i), row(j), column(j))
      if (of_tau) ddsdde(i, j) = jacobian * ddsdde(i, j)
    end do
  end do
  sse = lambda / 2 * log(jacobian)**2 - mu * log(jacobian) + mu / 2 * (b(1, 1) + b(2, 2) + b(3, 3) - 3)

contains

  pure real(dp) function unit(p, q)
    integer, intent(in) :: p, q
    unit = merge(1._dp, 0._dp, p == q)
  end function unit

  pure real(dp) function determinant(f)
    real(dp), intent(in) :: f(3, 3)
    determinant = f(1, 1) * (f(2, 2) * f(3, 3) - f(2, 3) * f(3, 2)) &
                - f(1, 2) * (f(2, 1) * f(3, 3) - f(2, 3) * f(3, 1)) &
                + f(1, 3) * (f(2, 1) * f(3, 2) - f(2, 2) * f(3, 1))
  end function determinant

  ! (1 / J) (J sigma)^Jaumann = (1 / J) (lambda tr(d) I + mu (d b + b d)), symmetrised in d
  pure real(dp) function jaumann_modulus(p, q, r, s)
    integer, intent(in) :: p, q, r, s
    jaumann_modulus = (lambda * unit(p, q) * unit(r, s) &
                       + mu / 2 * (unit(p, r) * b(q, s) + unit(p, s) * b(q, r) + unit(q, s) * b(p, r) &
                                   + unit(q, r) * b(p, s))) / jacobian
  end function jaumann_modulus

  ! d sigma + sigma d, symmetrised in d
  pure real(dp) function turned(p, q, r, s)
    integer, intent(in) :: p, q, r, s
    turned = (unit(p, r) * cauchy(q, s) + unit(p, s) * cauchy(q, r) + unit(q, s) * cauchy(p, r) &
              + unit(q, r) * cauchy(p, s)) / 2
  end function turned

  pure real(dp) function cauchy(p, q)
    integer, intent(in) :: p, q
    cauchy = lambda * log(jacobian) / jacobian * unit(p, q) + mu / jacobian * (b(p, q) - unit(p, q))
  end function cauchy
end subroutine umat
