! SPDX-License-Identifier: BSD-3-Clause
! The UMAT of umat_neo_hookean.f90 with a mistake in STRESS, which the third of PROPS chooses by the numbers of
! component_faults.h. NTENS 6.
subroutine faulty_umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, &
                       temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, &
                       pnewdt, celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(in) :: stran(ntens), dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(*), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  external :: umat

  call umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
            dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, 2, coords, drot, pnewdt, celent, dfgrd0, &
            dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  select case (nint(props(3)))
  case (1)
    stress([5, 6]) = stress([6, 5])
  case (2)
    stress(6) = 2 * stress(6)
  case (3)
    stress(5) = stress(5) / 2
  case (4)
    stress(5) = -stress(5)
  case (5)
    stress([2, 3]) = stress([3, 2])
  case (6)
    stress(6) = 1.05_dp * stress(6)
  case (7)
    stress(3) = 1.05_dp * stress(3)
  end select
end subroutine faulty_umat
