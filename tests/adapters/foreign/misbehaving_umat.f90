! SPDX-License-Identifier: BSD-3-Clause
! Linear elasticity of small increments that misbehaves on demand. STATEV(1) counts the calls.
! PROPS: E, nu, which misbehaviour (misbehaving_umat_c.c lists them), from which total time on.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dtime, temp, &
                dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, coords, drot, pnewdt, celent, &
                dfgrd0, dfgrd1, noel, npt, layer, kspt, jstep, kinc)
  use, intrinsic :: iso_c_binding, only: c_double, c_int
  use, intrinsic :: iso_fortran_env, only: int64
  implicit none
  integer, parameter :: dp = kind(1d0)
  integer, intent(in) :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, jstep(4), kinc
  character(len=80), intent(in) :: cmname
  real(dp), intent(inout) :: stran(ntens)
  real(dp), intent(in) :: dstran(ntens), time(2), dtime, temp, dtemp, predef(*), dpred(*), &
                          props(nprops), coords(3), drot(3, 3), celent, dfgrd0(3, 3), dfgrd1(3, 3)
  real(dp), intent(inout) :: stress(ntens), statev(*), sse, spd, scd, pnewdt
  real(dp), intent(out) :: ddsdde(ntens, ntens)
  real(dp), intent(inout) :: rpl, ddsddt(ntens), drplde(ntens), drpldt
  integer, parameter :: stops = 2, asks_for_shorter = 13, calls_xit = 14, returns_nan = 15, writes = 18, forgets = 20
  integer, parameter :: writes_strain = 25, asks_for_nothing = 29
  integer(int64), parameter :: quiet_nan = int(z'7ff8000000000000', int64)
  interface
    subroutine misbehave(which, stress, statev, nstatv) bind(c)
      import :: c_double, c_int
      integer(c_int), value :: which, nstatv
      real(c_double), intent(inout) :: stress(*), statev(*)
    end subroutine misbehave
  end interface
  external :: xit
  real(dp) :: shear
  integer :: which, i, unit

  which = nint(props(3))
  if (time(2) + dtime < props(4)) which = 0
  if (which == forgets .and. time(2) < 1e-6_dp) then
    stress = 0
    statev(1:nstatv) = 0
  end if
  shear = props(1) / (2 * (1 + props(2)))
  ddsdde = 0
  ddsdde(1:3, 1:3) = props(1) * props(2) / ((1 + props(2)) * (1 - 2 * props(2)))
  do i = 1, ntens
    ddsdde(i, i) = ddsdde(i, i) + merge(2 * shear, shear, i <= 3)
  end do
  do i = 1, ntens
    stress = stress + ddsdde(:, i) * dstran(i)
  end do
  if (nstatv > 0) statev(1) = statev(1) + 1

  select case (which)
  case (0, forgets)
    continue
  case (stops)
    stop
  case (writes_strain)
    stran(1) = stran(1) + dstran(1)
  case (asks_for_shorter)
    pnewdt = 0.25_dp
  case (asks_for_nothing)
    pnewdt = transfer(quiet_nan, 1._dp)
  case (calls_xit)
    call xit
  case (returns_nan)
    stress = transfer(quiet_nan, 1._dp)
  case (writes)
    write (6, *) 'to unit 6:', time(2)
    write (7, *) 'to unit 7:', time(2)
    open (newunit=unit, file='scratch.dat', position='append')
    write (unit, *) time(2)
    close (unit)
  case default
    call misbehave(which, stress, statev, nstatv)
  end select
end subroutine umat
