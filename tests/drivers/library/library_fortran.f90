! SPDX-License-Identifier: BSD-3-Clause
! The Fortran module of the library, drivers/library/assay.f90: values, shapes, and what it refuses.
! usage: library_fortran SCENE     the plane vortex of configs/library
program library_fortran
  use assay
  use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  implicit none
  real(c_double), parameter :: t = 0.3d0, pi = acos(-1d0), tiny_ = 1d-12
  type(assay_problem) :: problem, other
  type(assay_points) :: points
  type(assay_cells) :: cells
  type(assay_mesh) :: mesh
  type(assay_fault) :: fault
  character(1000) :: scene
  character(40) :: sets(1) = 'motion.amplitude.peak=0.1'
  real(c_double) :: X0(2, 3) = reshape([1d0, 0d0, 0.9d0, 0.1d0, -0.3d0, 0.8d0], [2, 3])
  real(c_double), dimension(2, 3) :: x, v, a, b, b_static, again, traction
  real(c_double) :: F(3, 3, 3), P(3, 3, 3), sigma(6, 3), angle, corners(2, 4, 1), mean(2, 1), volume(1), force(2, 4)
  real(c_double) :: wide(4, 3) = 0
  integer(c_int32_t) :: status(3)
  integer :: i, failures = 0

  call get_command_argument(1, scene)
  call problem%open(scene)
  call expect(problem%dimension == 2 .and. abs(problem%end - 1) < tiny_ .and. problem%density > 999, 'facts')
  call expect(index(problem%describe(), '{') == 1, 'a description')
  call expect(len(problem%warnings()) == 0, 'no warnings')
  call points%open(problem, X0)
  call points%eval(t, x=x, v=v, a=a, F=F, P=P, sigma=sigma, b=b, b_static=b_static, status=status, fault=fault)
  call expect(fault%code == assay_done .and. all(status == 0), 'a status')
  angle = 0.25d0 * sin(pi * t)
  call expect(norm2(x(:, 1) - [cos(angle), sin(angle)]) < tiny_, 'x on the circle R = 1')
  call expect(norm2(v(:, 1) - pi * 0.25d0 * cos(pi * t) * [-sin(angle), cos(angle)]) < tiny_, 'v there')
  call expect(maxval(abs(a + b_static - b)) < 1d-11, 'b_static is b without the inertia')
  do i = 1, 3                                              ! P = J sigma F^-T, so P F^T is the Cauchy stress (J = 1)
    call expect(maxval(abs(matmul(P(:, :, i), transpose(F(:, :, i))) - &
      reshape([sigma(1, i), sigma(4, i), sigma(5, i), sigma(4, i), sigma(2, i), sigma(6, i), sigma(5, i), sigma(6, i), &
      sigma(3, i)], [3, 3]))) < 1d-9, 'P and F are (i, j)')
  end do
  call points%eval(t, b=again(:, 2:3), first=2)
  call expect(all(abs(again(:, 2:3) - b(:, 2:3)) <= 0), 'a part of the points')
  call points%eval(t, b=wide(1:3:2, :))
  call expect(all(abs(wide(1:3:2, :) - b) <= 0) .and. all(abs(wide(2:4:2, :)) <= 0), 'an array with strides')
  call points%tractions(t, spread([2d0, 0d0], 2, 3), traction)
  call expect(maxval(abs(traction - P(1:2, 1, :))) < 1d-9, 'tractions')
  call problem%at_current(t, x, X=again, b=traction)
  call expect(maxval(abs(again - X0)) < 1d-9 .and. maxval(abs(traction - b)) < 1d-6, 'current positions lead back')

  corners(:, :, 1) = reshape([1d0, 0d0, 1.01d0, 0d0, 1.01d0, 0.01d0, 1d0, 0.01d0], [2, 4])
  call cells%open(problem, corners)
  call cells%eval(t, mean, volume)
  call expect(abs(volume(1) - 1d-4) < 1d-15 .and. norm2(mean(:, 1) - b(:, 1)) < 1, 'a cell')
  call mesh%open(problem, assay_quadrilateral, corners(:, :, 1), reshape([1, 2, 3, 4], [4, 1]))
  call mesh%loads(t, force)
  call expect(all(abs(force) < 1d3) .and. any(abs(force) > 0), 'nodal loads')

  call other%open(scene, sets=sets, end=0.5d0, threads=1)
  call expect(abs(other%particle_speed / problem%particle_speed - 0.4d0) < 1d-2, 'a change of the scene')
  call other%close()
  call other%open(text='material: {adapter: neo_hookean, parameters: {E: 1, nu: 0.3}, density: 1}' // new_line('a') // &
    'motion: {type: vortex, inner: wide}', fault=fault)
  call expect(fault%code == assay_bad_input .and. fault%line == 2 .and. len_trim(fault%message) > 0, 'a bad scene')
  call points%eval(t, b=force, fault=fault)
  call expect(fault%code == assay_bad_input .and. index(fault%message, 'shape') > 0, 'a wrong shape')
  X0(1, 2) = ieee_value(1d0, ieee_quiet_nan)
  call points%open(problem, X0, fault)
  call expect(fault%code == assay_bad_input .and. fault%point == 2, 'a point that is no number')
  call points%eval(t, b=b, fault=fault)
  call expect(fault%code == assay_bad_input, 'points that were not opened')
  call mesh%close()
  call cells%close()
  call points%close()
  call problem%close()
  call problem%close()
  if (failures > 0) error stop 1
  print '(a)', 'all as expected'

contains

  subroutine expect(holds, what)
    logical, intent(in) :: holds
    character(*), intent(in) :: what
    if (holds) return
    failures = failures + 1
    print '(2a)', 'not as expected: ', what
  end subroutine
end program
