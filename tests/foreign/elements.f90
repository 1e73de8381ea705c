! SPDX-License-Identifier: BSD-3-Clause
! A finite element code that knows nothing of assay: total Lagrangian, quadrilaterals, lumped mass, explicit. It reads
! what `assay export --to nodal-loads` writes. usage: elements FOLDER H WAVE_SPEED END, writes FOLDER/out.csv
program elements
  use force_tables
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  integer, parameter :: real_ = real64, frames = 10
  integer, parameter :: corner(2, 4) = reshape([-1, -1, 1, -1, 1, 1, -1, 1], [2, 4])
  character(1000) :: folder, word
  real(real_) :: h, wave, end_time, dt, P(2, 2), t
  real(real_), allocatable :: slope(:, :, :, :), area(:, :)  ! of the functions at the Gauss points of each element
  real(real_), allocatable, dimension(:, :) :: X0, x, v, f, load
  real(real_), allocatable :: mass(:)
  integer, allocatable :: id(:), mesh(:, :)
  type(force_table) :: loads
  integer :: e, g, k, step, steps, status, out

  call get_command_argument(1, folder)
  call get_command_argument(2, word)
  read(word, *) h
  call get_command_argument(3, word)
  read(word, *) wave
  call get_command_argument(4, word)
  read(word, *) end_time
  call read_nodes(trim(folder) // '/seeds.csv')
  call read_elements(trim(folder) // '/elements.csv')
  call loads%read(trim(folder) // '/loads.bin', status)
  if (status /= 0 .or. loads%points /= size(id)) stop 3

  steps = frames * ceiling(end_time * wave / (0.3_real_ * h) / frames)
  dt = end_time / steps
  allocate(slope(2, 4, 4, size(mesh, 2)), area(4, size(mesh, 2)))
  do e = 1, size(mesh, 2)
    do g = 1, 4
      call at_gauss_point(X0(:, mesh(:, e)), g, slope(:, :, g, e), area(g, e))
    end do
  end do
  allocate(f, mold=X0)
  allocate(load, mold=X0)
  x = X0
  open(newunit=out, file=trim(folder) // '/out.csv', status='replace', action='write')
  write(out, '(a)') 't,id,X,Y,ux,uy'
  do step = 0, steps
    t = step * dt
    if (mod(step, steps / frames) == 0) then
      do k = 1, size(id)
        write(out, '(es24.16, ",", i0, 4(",", es24.16))') t, id(k), X0(:, k), x(:, k) - X0(:, k)
      end do
    end if
    call loads%at(t, load)
    f = load
    do e = 1, size(mesh, 2)
      do g = 1, 4
        P = stress(matmul(x(:, mesh(:, e)), transpose(slope(:, :, g, e))))
        f(:, mesh(:, e)) = f(:, mesh(:, e)) - area(g, e) * matmul(P, slope(:, :, g, e))
      end do
    end do
    v = v + merge(dt, dt / 2, step > 0) * f / spread(mass, 1, 2)  ! to the middle of the step
    x = x + dt * v
  end do
  close(out)

contains

  ! Neo-Hookean, E = 1000 Pa, nu = 0.3, in plane strain.
  pure function stress(F) result(P)
    real(real_), intent(in) :: F(2, 2)
    real(real_) :: P(2, 2), J, inverse_t(2, 2)
    real(real_), parameter :: E = 1e3_real_, nu = 0.3_real_, mu = E / (2 * (1 + nu)), &
                              lambda = E * nu / ((1 + nu) * (1 - 2 * nu))
    J = F(1, 1) * F(2, 2) - F(1, 2) * F(2, 1)
    inverse_t = reshape([F(2, 2), -F(1, 2), -F(2, 1), F(1, 1)], [2, 2]) / J
    P = mu * (F - inverse_t) + lambda * log(J) * inverse_t
  end function

  ! 2 x 2 Gauss points, by number, and the four nodes of an element.
  pure subroutine at_gauss_point(X, number, slope, area)
    real(real_), intent(in) :: X(2, 4)
    integer, intent(in) :: number
    real(real_), intent(out) :: slope(2, 4), area
    real(real_) :: local(2, 4), J(2, 2)
    local = corner * (1 + corner([2, 1], :) * spread(corner([2, 1], number), 2, 4) / sqrt(3.0_real_)) / 4
    J = matmul(X, transpose(local))
    area = J(1, 1) * J(2, 2) - J(1, 2) * J(2, 1)
    slope = matmul(reshape([J(2, 2), -J(1, 2), -J(2, 1), J(1, 1)], [2, 2]) / area, local)
  end subroutine

  integer function lines_of(unit)
    integer, intent(in) :: unit
    integer :: state
    lines_of = -1
    do
      read(unit, *, iostat=state)
      if (state /= 0) exit
      lines_of = lines_of + 1
    end do
    rewind(unit)
    read(unit, *)
  end function

  subroutine read_nodes(file)
    character(*), intent(in) :: file
    integer :: unit, n, i
    real(real_) :: volume
    open(newunit=unit, file=file, status='old', action='read')
    n = lines_of(unit)
    allocate(id(n), X0(2, n), v(2, n), mass(n))
    do i = 1, n
      read(unit, *) id(i), X0(:, i), volume, mass(i), v(:, i)
    end do
    close(unit)
  end subroutine

  subroutine read_elements(file)
    character(*), intent(in) :: file
    integer :: unit, n, i, number
    open(newunit=unit, file=file, status='old', action='read')
    n = lines_of(unit)
    allocate(mesh(4, n))
    do i = 1, n
      read(unit, *) number, mesh(:, i)
    end do
    close(unit)
  end subroutine
end program
