! SPDX-License-Identifier: BSD-3-Clause
! Hill's plasticity on isotropic elasticity, in axes that the host turns (axes: corotational): small increments, linear
! hardening, the flow at the end of the step.
!   sqrt(s : P : s) <= yield + H p,   d eps_p = d lambda P s
! PROPS: E, nu, yield stress, H; Hill's F, G, H, L, M, N about the axes 1, 2, 3. STATEV: p.
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
  real(dp) :: elastic(6, 6), hill(6, 6), trial(6), found(6), system(6, 6), inverse(6, 6), norm, excess, slope, &
              multiplier, flow(6), derivative(6)
  integer :: k, step

  elastic = 0
  elastic(1:3, 1:3) = props(1) * props(2) / ((1 + props(2)) * (1 - 2 * props(2)))
  hill = 0
  hill(1:3, 1:3) = reshape([props(6) + props(7), -props(7), -props(6), -props(7), props(5) + props(7), -props(5), &
                            -props(6), -props(5), props(5) + props(6)], [3, 3])
  do k = 1, 3
    elastic(k, k) = elastic(k, k) + props(1) / (1 + props(2))
    elastic(3 + k, 3 + k) = props(1) / (2 * (1 + props(2)))
    hill(3 + k, 3 + k) = 2 * props(11 - k)
  end do
  trial = stress + matmul(elastic, dstran)
  stress = trial
  ddsdde = elastic
  ! under pressure alone rounding may leave less than nothing
  if (sqrt(max(0._dp, dot_product(trial, matmul(hill, trial)))) <= props(3) + props(4) * statev(1)) return
  ! Newton's method for the multiplier: s = (1 + multiplier C P)^-1 trial
  multiplier = 0
  do step = 1, 60
    call solve()
    if (abs(excess) < 1e-13_dp * props(3)) exit
    multiplier = max(multiplier - excess / slope, multiplier / 10)
  end do
  stress = found
  statev(1) = statev(1) + multiplier * norm
  flow = matmul(hill, found) / norm
  inverse = matmul(inverse, elastic)
  derivative = matmul(inverse, flow)
  ! d norm (1 - H multiplier) = H norm d multiplier, d s = (1 + multiplier C P)^-1 C (d eps - norm flow d multiplier)
  slope = (1 - props(4) * multiplier) / (norm * (props(4) + (1 - props(4) * multiplier) * dot_product(flow, derivative)))
  do k = 1, 6
    ddsdde(:, k) = inverse(:, k) - derivative * (derivative(k) * norm * slope)
  end do

contains

  subroutine solve()
    integer :: j
    system = multiplier * matmul(elastic, hill)
    do j = 1, 6
      system(j, j) = system(j, j) + 1
    end do
    call invert(system, inverse)
    found = matmul(inverse, trial)
    norm = sqrt(dot_product(found, matmul(hill, found)))
    excess = norm - props(3) - props(4) * (statev(1) + multiplier * norm)
    flow = matmul(hill, found) / norm
    slope = -(1 - props(4) * multiplier) * norm * dot_product(flow, matmul(inverse, matmul(elastic, flow))) &
            - props(4) * norm
  end subroutine solve

  ! Gauss and Jordan, without pivots: close to the identity.
  subroutine invert(a, b)
    real(dp), intent(inout) :: a(6, 6)
    real(dp), intent(out) :: b(6, 6)
    real(dp) :: factor
    integer :: i, j
    b = 0
    do i = 1, 6
      b(i, i) = 1
    end do
    do i = 1, 6
      factor = a(i, i)
      a(i, :) = a(i, :) / factor
      b(i, :) = b(i, :) / factor
      do j = 1, 6
        if (j == i) cycle
        factor = a(j, i)
        a(j, :) = a(j, :) - factor * a(i, :)
        b(j, :) = b(j, :) - factor * b(i, :)
      end do
    end do
  end subroutine invert
end subroutine umat
