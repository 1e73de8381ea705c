! SPDX-License-Identifier: BSD-3-Clause
! Plane stress: 11, 22, 12. PROPS: E, nu, law. Law 1: linear elasticity of strain increments. Law 2: incompressible
! neo-Hookean, sigma = mu (b - F33^2 I) with F33 = 1/J2; DDSDDE for finite strain. Law 3: as 1, with four components
! written. Law 4: as 1, and asks for a shorter step where a strain increment exceeds 0.1. Law 5: as 1, with the shear
! modulus doubled. Law 6: as 2, with F^T F.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(*), statev(*), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  real(dp) :: e, nu, g, b(2, 2), thin
  integer :: law

  if (ndi /= 2 .or. nshr /= 1 .or. ntens /= 3) error stop 'not plane stress'
  e = props(1)
  nu = props(2)
  law = nint(props(3))
  g = e / (2 * (1 + nu))
  ddsdde = 0
  if (law == 2 .or. law == 6) then
    b = matmul(dfgrd1(1:2, 1:2), transpose(dfgrd1(1:2, 1:2)))
    if (law == 6) b = matmul(transpose(dfgrd1(1:2, 1:2)), dfgrd1(1:2, 1:2))
    thin = 1 / (dfgrd1(1, 1) * dfgrd1(2, 2) - dfgrd1(1, 2) * dfgrd1(2, 1))
    stress(1) = g * (b(1, 1) - thin**2)
    stress(2) = g * (b(2, 2) - thin**2)
    stress(3) = g * b(1, 2)
    ddsdde(1:2, 1:2) = 2 * g * thin**2
    ddsdde(1, 1) = ddsdde(1, 1) + 2 * g * b(1, 1)
    ddsdde(2, 2) = ddsdde(2, 2) + 2 * g * b(2, 2)
    ddsdde(1:2, 3) = g * b(1, 2)
    ddsdde(3, 1:2) = g * b(1, 2)
    ddsdde(3, 3) = g * (b(1, 1) + b(2, 2)) / 2
    return
  end if
  if (law == 4 .and. maxval(abs(dstran)) > 0.1_dp) pnewdt = 0.25_dp
  ddsdde(1, 1:2) = [1._dp, nu] * e / (1 - nu**2)
  ddsdde(2, 1:2) = [nu, 1._dp] * e / (1 - nu**2)
  ddsdde(3, 3) = merge(2 * g, g, law == 5)
  stress(1:3) = stress(1:3) + matmul(ddsdde, dstran)
  if (law == 3) stress(4) = 0
end subroutine umat
