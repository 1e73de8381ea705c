! SPDX-License-Identifier: BSD-3-Clause
! The library of assay (assay.h) for Fortran 2018: copy this file into your code, and link with -lassay.
!
!   use assay
!   type(assay_problem) :: problem
!   type(assay_points) :: points
!   call problem%open('vortex.yaml')                  ! or text=..., sets=[character(40) :: 'motion.period=2', ...]
!   call points%open(problem, X)                      ! X(dimension, n): reference positions [m]
!   call points%eval(0d0, x=x, v=v)                   ! positions [m] and velocities [m/s], (dimension, n)
!   call points%eval(t, b=b)                          ! body force per mass [m/s^2], (dimension, n)
!
! Every procedure has an optional last argument `fault`, of type(assay_fault): its code is 0 where all is well, else one
! of assay_finding ... assay_outside, with a message. Without `fault` an error ends the program with that message.
! Points, nodes and cells are numbered from 1. Arrays that are not contiguous are copied by the compiler.
module assay
  use, intrinsic :: iso_c_binding
  implicit none
  private

  integer, parameter, public :: assay_done = 0, assay_finding = 1, assay_bad_input = 2, assay_system = 3, &
    assay_beyond_end = 4, assay_outside = 5
  integer, parameter, public :: assay_triangle = 5, assay_quadrilateral = 9, assay_tetrahedron = 10, &
    assay_hexahedron = 12

  type, public :: assay_fault
    integer :: code = 0
    integer :: line = 0, column = 0          ! in file; 0: unknown
    integer(c_int64_t) :: point = 0          ! number of the point; 0: none
    character(256) :: file = ''
    character(128) :: key = ''               ! of the scene, or the argument
    character(512) :: message = ''
  end type

  type, public :: assay_problem
    type(c_ptr), private :: handle = c_null_ptr
    integer :: dimension = 0                 ! 2: plane strain, 3
    real(c_double) :: end = 0                ! last time that may be asked for [s]
    real(c_double) :: period = 0             ! T of the motion [s]
    real(c_double) :: density = 0            ! rho0 [kg/m^3]
    real(c_double) :: wave_speed = 0         ! fastest of the material [m/s]
    real(c_double) :: particle_speed = 0     ! fastest of the exact motion [m/s]
  contains
    procedure :: open => open_problem
    procedure :: at_current
    procedure :: describe                    ! JSON
    procedure :: warnings                    ! a sentence a line
    procedure :: close => close_problem
  end type

  type, public :: assay_points
    type(c_ptr), private :: handle = c_null_ptr
    integer :: dimension = 0, n = 0
  contains
    procedure :: open => open_points
    procedure :: eval
    procedure :: tractions
    procedure :: close => close_points
  end type

  type, public :: assay_cells
    type(c_ptr), private :: handle = c_null_ptr
    integer :: dimension = 0, n = 0
  contains
    procedure :: open => open_cells
    procedure :: eval => eval_cells
    procedure :: close => close_cells
  end type

  type, public :: assay_mesh
    type(c_ptr), private :: handle = c_null_ptr
    integer :: dimension = 0, n = 0          ! n: nodes
  contains
    procedure :: open => open_mesh
    procedure :: loads
    procedure :: close => close_mesh
  end type

  type, bind(C) :: c_error
    integer(c_int32_t) :: struct_size, code, line, column
    integer(c_int64_t) :: point
    character(kind=c_char) :: file(256), key(128), message(512)
  end type

  type, bind(C) :: c_options
    integer(c_int32_t) :: struct_size, api_major = 1
    type(c_ptr) :: scene = c_null_ptr, text = c_null_ptr
    integer(c_size_t) :: set_count = 0
    type(c_ptr) :: sets = c_null_ptr
    real(c_double) :: end = 0
    integer(c_int32_t) :: threads = 0
  end type

  type, bind(C) :: c_facts
    integer(c_int32_t) :: struct_size, dimension
    real(c_double) :: end, period, density, wave_speed, particle_speed
  end type

  type, bind(C) :: c_field                   ! assay_field and assay_const_field
    type(c_ptr) :: data = c_null_ptr
    integer(c_ptrdiff_t) :: point_stride = 0, component_stride = 1
  end type

  type, bind(C) :: c_view
    integer(c_int32_t) :: struct_size, reserved = 0
    type(c_ptr) :: status = c_null_ptr
    type(c_field) :: x, v, a, F, P, sigma, b, b_static
  end type

  type, bind(C) :: c_mesh_options
    integer(c_int32_t) :: struct_size, element
    integer(c_size_t) :: nodes, elements
    type(c_ptr) :: X, connectivity
    integer(c_int32_t) :: gauss = 0, quasi_static = 0
  end type

  abstract interface
    subroutine closing(handle) bind(C)
      import c_ptr
      type(c_ptr), value :: handle
    end subroutine
    integer(c_int) function telling(problem, buffer, size, needed) bind(C)
      import c_int, c_ptr, c_size_t
      type(c_ptr), value :: problem, buffer
      integer(c_size_t), value :: size
      integer(c_size_t), intent(out) :: needed
    end function
  end interface
  procedure(closing), bind(C, name='assay_close') :: c_close
  procedure(closing), bind(C, name='assay_points_close') :: c_points_close
  procedure(closing), bind(C, name='assay_cells_close') :: c_cells_close
  procedure(closing), bind(C, name='assay_mesh_close') :: c_mesh_close
  procedure(telling), bind(C, name='assay_describe') :: c_describe
  procedure(telling), bind(C, name='assay_warnings') :: c_warnings

  interface
    integer(c_int) function c_open(options, problem, error) bind(C, name='assay_open')
      import
      type(c_options), intent(in) :: options
      type(c_ptr), intent(out) :: problem
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_get_facts(problem, facts, error) bind(C, name='assay_get_facts')
      import
      type(c_ptr), value :: problem
      type(c_facts), intent(inout) :: facts
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_points_open(problem, n, components, X, points, error) bind(C, name='assay_points_open')
      import
      type(c_ptr), value :: problem
      integer(c_size_t), value :: n
      integer(c_int), value :: components
      type(c_field), intent(in) :: X
      type(c_ptr), intent(out) :: points
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_eval(points, t, first, count, out, error) bind(C, name='assay_eval')
      import
      type(c_ptr), value :: points
      real(c_double), value :: t
      integer(c_size_t), value :: first, count
      type(c_view), intent(in) :: out
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_tractions(points, t, first, count, N, traction, error) bind(C, name='assay_tractions')
      import
      type(c_ptr), value :: points
      real(c_double), value :: t
      integer(c_size_t), value :: first, count
      type(c_field), intent(in) :: N, traction
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_cells_open(problem, n, corners, cells, error) bind(C, name='assay_cells_open')
      import
      type(c_ptr), value :: problem, corners
      integer(c_size_t), value :: n
      type(c_ptr), intent(out) :: cells
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_cells_eval(cells, t, b, volume, error) bind(C, name='assay_cells_eval')
      import
      type(c_ptr), value :: cells, volume
      real(c_double), value :: t
      type(c_field), intent(in) :: b
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_mesh_open(problem, options, mesh, error) bind(C, name='assay_mesh_open')
      import
      type(c_ptr), value :: problem
      type(c_mesh_options), intent(in) :: options
      type(c_ptr), intent(out) :: mesh
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_nodal_loads(mesh, t, force, error) bind(C, name='assay_nodal_loads')
      import
      type(c_ptr), value :: mesh
      real(c_double), value :: t
      type(c_field), intent(in) :: force
      type(c_error), intent(inout) :: error
    end function
    integer(c_int) function c_at_current(problem, t, n, components, x, X0, out, error) bind(C, name='assay_at_current')
      import
      type(c_ptr), value :: problem
      real(c_double), value :: t
      integer(c_size_t), value :: n
      integer(c_int), value :: components
      type(c_field), intent(in) :: x, X0
      type(c_view), intent(in) :: out
      type(c_error), intent(inout) :: error
    end function
  end interface

contains

  ! What a call said, to the caller; without a fault the program ends.
  subroutine tell(code, error, fault)
    integer, intent(in) :: code
    type(c_error), intent(in) :: error
    type(assay_fault), intent(out), optional :: fault
    type(assay_fault) :: found
    found%code = code
    if (code /= 0) then
      found%line = error%line
      found%column = error%column
      found%point = error%point + 1
      found%file = string(error%file)
      found%key = string(error%key)
      found%message = string(error%message)
    end if
    if (present(fault)) then
      fault = found
    else if (code /= 0) then
      error stop trim(found%message)
    end if
  end subroutine

  ! The shape of an argument does not fit.
  subroutine refuse(key, message, fault)
    character(*), intent(in) :: key, message
    type(assay_fault), intent(out), optional :: fault
    if (.not. present(fault)) error stop key // ': ' // message
    fault = assay_fault(code=assay_bad_input, key=key, message=key // ': ' // message)
  end subroutine

  pure function string(chars) result(text)
    character(kind=c_char), intent(in) :: chars(:)
    character(size(chars)) :: text
    integer :: i
    text = ''
    do i = 1, size(chars)
      if (chars(i) == c_null_char) exit
      text(i:i) = chars(i)
    end do
  end function

  function new_error() result(error)
    type(c_error) :: error
    error%struct_size = int(c_sizeof(error), c_int32_t)
    error%code = 0
    error%line = 0
    error%column = 0
    error%point = -1
    error%file = c_null_char
    error%key = c_null_char
    error%message = c_null_char
  end function

  ! Vectors (components, n), or (9, n) and (6, n), as a field; a null one where the array is absent.
  function field_of(values) result(field)
    real(c_double), intent(in), target, contiguous, optional :: values(:, :)
    type(c_field) :: field
    if (.not. present(values)) return
    if (size(values) > 0) field%data = c_loc(values)
    field%point_stride = size(values, 1)
  end function

  function tensors_of(values) result(field)
    real(c_double), intent(in), target, contiguous, optional :: values(:, :, :)
    type(c_field) :: field
    if (.not. present(values)) return
    if (size(values) > 0) field%data = c_loc(values)
    field%point_stride = 9
  end function

  logical function fits(values, components, n)
    real(c_double), intent(in), optional :: values(:, :)
    integer, intent(in) :: components, n
    fits = .true.
    if (present(values)) fits = size(values, 1) == components .and. size(values, 2) == n
  end function

  ! Row-major (3, 3) of the library to (i, j) of Fortran.
  subroutine turn(values)
    real(c_double), intent(inout), optional :: values(:, :, :)
    integer :: p
    if (.not. present(values)) return
    do p = 1, size(values, 3)
      values(:, :, p) = transpose(values(:, :, p))
    end do
  end subroutine

  ! scene: path of a scene; or text: its text. sets: changes of it, 'key.path=value'. end: last time that will be asked
  ! for [s], 0: time.end of the scene. threads: with which the response is tabulated.
  subroutine open_problem(self, scene, text, sets, end, threads, fault)
    class(assay_problem), intent(inout) :: self
    character(*), intent(in), optional :: scene, text, sets(:)
    real(c_double), intent(in), optional :: end
    integer, intent(in), optional :: threads
    type(assay_fault), intent(out), optional :: fault
    character(kind=c_char, len=:), allocatable, target :: scene_, text_
    character(kind=c_char), allocatable, target :: sets_(:, :)
    type(c_ptr), allocatable, target :: places(:)
    type(c_options) :: options
    type(c_facts) :: facts
    type(c_error) :: error
    integer :: i, code
    call self%close()
    options%struct_size = int(c_sizeof(options), c_int32_t)
    if (present(scene)) then
      scene_ = trim(scene) // c_null_char
      options%scene = c_loc(scene_)
    end if
    if (present(text)) then
      text_ = text // c_null_char
      options%text = c_loc(text_)
    end if
    if (present(sets)) then
      allocate(sets_(len(sets) + 1, size(sets)), places(size(sets)))
      do i = 1, size(sets)
        sets_(:, i) = c_null_char
        sets_(:len_trim(sets(i)), i) = transfer(sets(i), c_null_char, len_trim(sets(i)))
        places(i) = c_loc(sets_(1, i))
      end do
      options%set_count = size(sets)
      options%sets = c_loc(places)
    end if
    if (present(end)) options%end = end
    if (present(threads)) options%threads = threads
    error = new_error()
    code = c_open(options, self%handle, error)
    if (code == 0) then
      facts%struct_size = int(c_sizeof(facts), c_int32_t)
      code = c_get_facts(self%handle, facts, error)
      self%dimension = facts%dimension
      self%end = facts%end
      self%period = facts%period
      self%density = facts%density
      self%wave_speed = facts%wave_speed
      self%particle_speed = facts%particle_speed
    end if
    call tell(code, error, fault)
  end subroutine

  subroutine close_problem(self)
    class(assay_problem), intent(inout) :: self
    call c_close(self%handle)
    self%handle = c_null_ptr
  end subroutine

  function describe(self) result(text)
    class(assay_problem), intent(in) :: self
    character(:), allocatable :: text
    text = told(c_describe, self%handle)
  end function

  function warnings(self) result(text)
    class(assay_problem), intent(in) :: self
    character(:), allocatable :: text
    text = told(c_warnings, self%handle)
  end function

  function told(function_, handle) result(text)
    procedure(telling) :: function_
    type(c_ptr), intent(in) :: handle
    character(:), allocatable :: text
    character(kind=c_char), allocatable, target :: buffer(:)
    integer(c_size_t) :: size, needed
    text = ''
    size = 0
    if (function_(handle, c_null_ptr, size, needed) /= 0) return
    size = needed
    allocate(buffer(size))
    if (function_(handle, c_loc(buffer), size, needed) == 0) text = trim(string(buffer))
  end function

  ! X(dimension, n): reference positions [m]; they are copied. In the plane a third component is ignored.
  subroutine open_points(self, problem, X, fault)
    class(assay_points), intent(inout) :: self
    type(assay_problem), intent(in) :: problem
    real(c_double), intent(in), target, contiguous :: X(:, :)
    type(assay_fault), intent(out), optional :: fault
    type(c_error) :: error
    integer :: code
    call self%close()
    error = new_error()
    code = c_points_open(problem%handle, size(X, 2, c_size_t), size(X, 1), field_of(X), self%handle, error)
    self%dimension = problem%dimension
    self%n = size(X, 2)
    call tell(code, error, fault)
  end subroutine

  subroutine close_points(self)
    class(assay_points), intent(inout) :: self
    call c_points_close(self%handle)
    self%handle = c_null_ptr
  end subroutine

  ! The fields of the points at time t [s]:
  !   x, v, a (dimension, n)    position [m], velocity [m/s], acceleration [m/s^2]
  !   F, P (3, 3, n)            deformation gradient [1], first Piola-Kirchhoff stress [Pa]; F(i, j, p) is F_ij
  !   sigma (6, n)              Cauchy stress [Pa]: 11, 22, 33, 12, 13, 23
  !   b, b_static (dimension, n)   body force per mass [m/s^2], with and without inertia
  !   status (n)                0, or assay_outside where the motion is not defined and all else is NaN: no fault then
  ! first: number of the point from which on; then n is what the arrays hold, so that threads can share one set.
  subroutine eval(self, t, x, v, a, F, P, sigma, b, b_static, status, first, fault)
    class(assay_points), intent(in) :: self
    real(c_double), intent(in) :: t
    real(c_double), intent(inout), target, contiguous, optional :: x(:, :), v(:, :), a(:, :), sigma(:, :), b(:, :), &
      b_static(:, :), F(:, :, :), P(:, :, :)
    integer(c_int32_t), intent(inout), target, contiguous, optional :: status(:)
    integer, intent(in), optional :: first
    type(assay_fault), intent(out), optional :: fault
    type(c_view) :: view
    type(c_error) :: error
    integer :: n, from, code
    from = 1
    if (present(first)) from = first
    n = extent(self%n - from + 1, present(first), x, v, a, F, P, sigma, b, b_static)
    call view_of(self%dimension, n, view, code, x, v, a, F, P, sigma, b, b_static, status)
    if (code /= 0 .or. from < 1 .or. n < 0) then
      call refuse('eval', 'the shape of an array is not that of the points', fault)
      return
    end if
    error = new_error()
    code = c_eval(self%handle, t, int(from - 1, c_size_t), int(n, c_size_t), view, error)
    call turn(F)
    call turn(P)
    if (code == assay_outside .and. present(status)) code = 0
    call tell(code, error, fault)
  end subroutine

  ! How many points arrays hold: n, or what the first of them says.
  integer function extent(n, ask, x, v, a, F, P, sigma, b, b_static)
    integer, intent(in) :: n
    logical, intent(in) :: ask
    real(c_double), intent(in), optional :: x(:, :), v(:, :), a(:, :), sigma(:, :), b(:, :), b_static(:, :), &
      F(:, :, :), P(:, :, :)
    extent = n
    if (.not. ask) return
    if (present(P)) extent = size(P, 3)
    if (present(F)) extent = size(F, 3)
    if (present(sigma)) extent = size(sigma, 2)
    if (present(b_static)) extent = size(b_static, 2)
    if (present(a)) extent = size(a, 2)
    if (present(v)) extent = size(v, 2)
    if (present(x)) extent = size(x, 2)
    if (present(b)) extent = size(b, 2)
  end function

  subroutine view_of(dimension, n, view, code, x, v, a, F, P, sigma, b, b_static, status)
    integer, intent(in) :: dimension, n
    type(c_view), intent(out) :: view
    integer, intent(out) :: code
    real(c_double), intent(in), target, contiguous, optional :: x(:, :), v(:, :), a(:, :), sigma(:, :), b(:, :), &
      b_static(:, :), F(:, :, :), P(:, :, :)
    integer(c_int32_t), intent(in), target, contiguous, optional :: status(:)
    logical :: good
    good = fits(x, dimension, n) .and. fits(v, dimension, n) .and. fits(a, dimension, n) .and. fits(sigma, 6, n) .and. &
      fits(b, dimension, n) .and. fits(b_static, dimension, n)
    if (present(F)) good = good .and. all(shape(F) == [3, 3, n])
    if (present(P)) good = good .and. all(shape(P) == [3, 3, n])
    if (present(status)) good = good .and. size(status) == n
    code = merge(0, 1, good)
    view%struct_size = int(c_sizeof(view), c_int32_t)
    view%x = field_of(x)
    view%v = field_of(v)
    view%a = field_of(a)
    view%F = tensors_of(F)
    view%P = tensors_of(P)
    view%sigma = field_of(sigma)
    view%b = field_of(b)
    view%b_static = field_of(b_static)
    if (present(status)) view%status = c_loc(status)
  end subroutine

  ! traction(dimension, n): P N per reference area [Pa] at time t [s]; N(dimension, n): outward reference normals of the
  ! points, of any length.
  subroutine tractions(self, t, N, traction, fault)
    class(assay_points), intent(in) :: self
    real(c_double), intent(in) :: t
    real(c_double), intent(in), target, contiguous :: N(:, :)
    real(c_double), intent(inout), target, contiguous :: traction(:, :)
    type(assay_fault), intent(out), optional :: fault
    type(c_error) :: error
    if (.not. (fits(N, self%dimension, self%n) .and. fits(traction, self%dimension, self%n))) then
      call refuse('tractions', 'the shape of an array is not that of the points', fault)
      return
    end if
    error = new_error()
    call tell(c_tractions(self%handle, t, 0_c_size_t, size(N, 2, c_size_t), field_of(N), field_of(traction), error), &
      error, fault)
  end subroutine

  ! corners(dimension, corners of one, n): 4 counterclockwise in the plane, 8 in VTK's order in space [m].
  subroutine open_cells(self, problem, corners, fault)
    class(assay_cells), intent(inout) :: self
    type(assay_problem), intent(in) :: problem
    real(c_double), intent(in), target, contiguous :: corners(:, :, :)
    type(assay_fault), intent(out), optional :: fault
    type(c_error) :: error
    integer :: code
    call self%close()
    self%dimension = problem%dimension
    self%n = size(corners, 3)
    if (size(corners, 1) /= self%dimension .or. size(corners, 2) /= 2**self%dimension) then
      call refuse('cells', 'needs corners(dimension, corners of a cell, cells)', fault)
      return
    end if
    error = new_error()
    code = c_cells_open(problem%handle, size(corners, 3, c_size_t), c_loc(corners), self%handle, error)
    call tell(code, error, fault)
  end subroutine

  ! b(dimension, n): means of b over the cells at time t [m/s^2]; volume(n): of the cells [m^3].
  subroutine eval_cells(self, t, b, volume, fault)
    class(assay_cells), intent(in) :: self
    real(c_double), intent(in) :: t
    real(c_double), intent(inout), target, contiguous :: b(:, :)
    real(c_double), intent(inout), target, contiguous, optional :: volume(:)
    type(assay_fault), intent(out), optional :: fault
    type(c_error) :: error
    type(c_ptr) :: volumes
    logical :: good
    good = fits(b, self%dimension, self%n)
    volumes = c_null_ptr
    if (present(volume)) then
      good = good .and. size(volume) == self%n
      volumes = c_loc(volume)
    end if
    if (.not. good) then
      call refuse('cells', 'the shape of an array is not that of the cells', fault)
      return
    end if
    error = new_error()
    call tell(c_cells_eval(self%handle, t, field_of(b), volumes, error), error, fault)
  end subroutine

  subroutine close_cells(self)
    class(assay_cells), intent(inout) :: self
    call c_cells_close(self%handle)
    self%handle = c_null_ptr
  end subroutine

  ! element: assay_quadrilateral ...; X(dimension, nodes): reference nodes [m]; connectivity(nodes of one, elements):
  ! their numbers from 1, in VTK's order. gauss: points along each direction, 0: as many as the element needs.
  subroutine open_mesh(self, problem, element, X, connectivity, gauss, quasi_static, fault)
    class(assay_mesh), intent(inout) :: self
    type(assay_problem), intent(in) :: problem
    integer, intent(in) :: element, connectivity(:, :)
    real(c_double), intent(in), target, contiguous :: X(:, :)
    integer, intent(in), optional :: gauss
    logical, intent(in), optional :: quasi_static
    type(assay_fault), intent(out), optional :: fault
    integer(c_int64_t), allocatable, target :: numbers(:, :)
    type(c_mesh_options) :: options
    type(c_error) :: error
    integer :: code
    call self%close()
    self%dimension = problem%dimension
    self%n = size(X, 2)
    if (size(X, 1) /= self%dimension) then
      call refuse('mesh', 'needs X(dimension, nodes)', fault)
      return
    end if
    allocate(numbers, source=int(connectivity, c_int64_t) - 1)
    options%struct_size = int(c_sizeof(options), c_int32_t)
    options%element = element
    options%nodes = size(X, 2)
    options%elements = size(connectivity, 2)
    options%X = c_loc(X)
    options%connectivity = c_loc(numbers)
    if (present(gauss)) options%gauss = gauss
    if (present(quasi_static)) options%quasi_static = merge(1, 0, quasi_static)
    error = new_error()
    code = c_mesh_open(problem%handle, options, self%handle, error)
    call tell(code, error, fault)
  end subroutine

  ! force(dimension, nodes): consistent nodal forces of body force and tractions at time t [s], in N.
  subroutine loads(self, t, force, fault)
    class(assay_mesh), intent(in) :: self
    real(c_double), intent(in) :: t
    real(c_double), intent(inout), target, contiguous :: force(:, :)
    type(assay_fault), intent(out), optional :: fault
    type(c_error) :: error
    if (.not. fits(force, self%dimension, self%n)) then
      call refuse('mesh', 'needs force(dimension, nodes)', fault)
      return
    end if
    error = new_error()
    call tell(c_nodal_loads(self%handle, t, field_of(force), error), error, fault)
  end subroutine

  subroutine close_mesh(self)
    class(assay_mesh), intent(inout) :: self
    call c_mesh_close(self%handle)
    self%handle = c_null_ptr
  end subroutine

  ! Fields as those of points, of the points that the exact motion has at x_now(dimension, n) [m] at time t [s]; X:
  ! their reference positions. For codes that know current positions alone: say so beside their results.
  subroutine at_current(self, t, x_now, X, v, a, F, P, sigma, b, b_static, status, fault)
    class(assay_problem), intent(in) :: self
    real(c_double), intent(in) :: t
    real(c_double), intent(in), target, contiguous :: x_now(:, :)
    real(c_double), intent(inout), target, contiguous, optional :: X(:, :), v(:, :), a(:, :), sigma(:, :), b(:, :), &
      b_static(:, :), F(:, :, :), P(:, :, :)
    integer(c_int32_t), intent(inout), target, contiguous, optional :: status(:)
    type(assay_fault), intent(out), optional :: fault
    type(c_view) :: view
    type(c_error) :: error
    integer :: n, code
    n = size(x_now, 2)
    call view_of(self%dimension, n, view, code, X, v, a, F, P, sigma, b, b_static, status)
    if (code /= 0) then
      call refuse('at_current', 'the shape of an array is not that of x_now', fault)
      return
    end if
    view%x = c_field()
    error = new_error()
    code = c_at_current(self%handle, t, int(n, c_size_t), size(x_now, 1), field_of(x_now), field_of(X), view, error)
    call turn(F)
    call turn(P)
    if (code == assay_outside .and. present(status)) code = 0
    call tell(code, error, fault)
  end subroutine
end module
