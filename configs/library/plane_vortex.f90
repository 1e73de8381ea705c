! SPDX-License-Identifier: BSD-3-Clause
! A finite element code of its own, verified: total Lagrangian, bilinear quadrilaterals, lumped mass, explicit.
!   gfortran -O2 assay.f90 plane_vortex.f90 -o plane_vortex $(pkg-config --libs assay)
!   ./plane_vortex plane_vortex.yaml
program plane_vortex
  use assay
  implicit none
  integer, parameter :: real_ = kind(1d0)
  type(assay_problem) :: problem
  character(1000) :: scene = 'plane_vortex.yaml'
  real(real_) :: coarse, fine
  if (command_argument_count() > 0) call get_command_argument(1, scene)
  call problem%open(scene)
  coarse = error_of(32)
  fine = error_of(64)
  print '(a, es9.3, a, es9.3, a, f4.2)', 'errors ', coarse, ' and ', fine, ' m, order ', log(coarse / fine) / log(2d0)
  call problem%close()

contains

  ! The author's material: neo-Hookean, P = mu (F - F^-T) + lambda ln J F^-T in plane strain.
  pure function stress(F) result(P)
    real(real_), intent(in) :: F(2, 2)
    real(real_) :: P(2, 2), J, inverse_t(2, 2)
    real(real_), parameter :: E = 1d3, nu = 0.3d0, mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu))
    J = F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)
    inverse_t = reshape([F(2, 2), -F(1, 2), -F(2, 1), F(1, 1)], [2, 2]) / J
    P = mu * (F - inverse_t) + lambda * log(J) * inverse_t
  end function

  ! The largest error over time [m]: root mean square over the nodes of the ring.
  real(real_) function error_of(n)
    integer, intent(in) :: n
    real(real_), dimension(2, (n + 1)**2) :: X0, x, v, f, b, exact
    real(real_) :: mass((n + 1)**2), slope(2, 4, 4), P(2, 2), h, dt
    integer :: nodes(4), e, g, k, step, steps
    integer, parameter :: corner(2, 4) = reshape([-1, -1, 1, -1, 1, 1, -1, 1], [2, 4])
    logical :: ring((n + 1)**2)
    type(assay_points) :: points
    h = 3d0 / n
    steps = ceiling(problem%end * problem%wave_speed / (0.3d0 * h))
    dt = problem%end / steps
    X0(1, :) = [(-1.5d0 + h * mod(k, n + 1), k = 0, (n + 1)**2 - 1)]
    X0(2, :) = [(-1.5d0 + h * (k / (n + 1)), k = 0, (n + 1)**2 - 1)]
    mass = problem%density * h**2 * product(merge(0.5d0, 1d0, abs(X0) > 1.5d0 - h / 2), 1)
    ring = abs(norm2(X0, 1) - 1) < 0.25d0
    do g = 1, 4                                            ! slopes of the four functions at 2 x 2 Gauss points
      slope(:, :, g) = corner * (1 + corner([2, 1], :) * spread(corner([2, 1], g), 2, 4) / sqrt(3d0)) / (2 * h)
    end do
    call points%open(problem, X0)
    call points%eval(0d0, x=x, v=v)                        ! 1. the seeds: x and v at t = 0
    error_of = 0
    do step = 0, steps - 1
      call points%eval(step * dt, b=b)                     ! 2. the force: b at the nodes, now
      f = 0
      do e = 0, n**2 - 1
        nodes = e / n * (n + 1) + mod(e, n) + [1, 2, n + 3, n + 2]
        do g = 1, 4
          P = stress(matmul(x(:, nodes), transpose(slope(:, :, g))))
          f(:, nodes) = f(:, nodes) - h**2 / 4 * matmul(P, slope(:, :, g))
        end do
      end do
      v = v + merge(dt, dt / 2, step > 0) * (b + f / spread(mass, 1, 2))   ! to the middle of the step
      x = x + dt * v
      call points%eval((step + 1) * dt, x=exact)           ! 3. the judgement: the exact x
      error_of = max(error_of, sqrt(sum((x - exact)**2, mask=spread(ring, 1, 2)) / count(ring)))
    end do
    call points%close()
  end function
end program
