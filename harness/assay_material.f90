! SPDX-License-Identifier: BSD-3-Clause
! The assay material ABI, version 1.2, in Fortran: assay_material.h line by line, and what makes a table of it. The
! header is the reference of what the members mean; tests compare every size and offset with it.
!
! Arrays of n points are a(n, components) here: point p is a(p, :), tensors by rows (tensor_of, rows_of).
module assay_abi
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
  implicit none
  public

  integer(c_int32_t), parameter :: assay_abi_major = 1, assay_abi_minor = 2
  integer(c_size_t), parameter :: assay_batch_max = 4096, assay_message_size = 512
  integer(c_int32_t), parameter :: assay_failed = -1, assay_doubtful = 0, assay_good = 1
  ! Kinds and roles of a state variable.
  integer(c_int32_t), parameter :: assay_scalar = 0, assay_vector = 1, assay_symmetric_tensor = 2, assay_tensor = 3
  integer(c_int32_t), parameter :: assay_role_plain = 0, assay_role_rotates_itself = 1, assay_role_direction = 2, &
    assay_role_field = 3
  integer(c_int32_t), parameter :: assay_isotropic = 0, assay_cylindrically_orthotropic = 1, assay_anisotropic = 2
  ! Class of an anisotropic material, for assay_symmetry.
  integer(c_int32_t), parameter :: assay_monoclinic = 1, assay_orthotropic = 2, assay_trigonal = 3, &
                                   assay_tetragonal = 4, assay_hexagonal = 5, assay_transversely_isotropic = 6, &
                                   assay_cubic = 7
  ! Flags, added together.
  integer(c_int32_t), parameter :: assay_non_smooth = 1, assay_rate_dependent = 2, assay_thread_safe = 4, &
                                   assay_uses_increment = 8, assay_in_plane = 16, assay_grows = 32
  integer(c_int32_t), parameter :: assay_baseline_simple_shear = 1, assay_baseline_uniaxial_strain = 2
  character(len=*), parameter :: assay_extension_rate = 'assay.rate/1', assay_extension_tangent = 'assay.tangent/1', &
                                 assay_extension_energy = 'assay.energy/1', &
                                 assay_extension_wave_speed = 'assay.wave_speed/1', &
                                 assay_extension_closed_form = 'assay.closed_form/1', &
                                 assay_extension_reason = 'assay.reason/1', &
                                 assay_extension_example = 'assay.example/1', &
                                 assay_extension_symmetry = 'assay.symmetry/1'

  type, bind(c) :: assay_parameter
    type(c_ptr) :: name = c_null_ptr, unit = c_null_ptr
    real(c_double) :: default_value, lower, upper
    type(c_ptr) :: doc = c_null_ptr
  end type assay_parameter

  type, bind(c) :: assay_state_variable
    type(c_ptr) :: name = c_null_ptr, unit = c_null_ptr
    integer(c_int32_t) :: kind, role
    type(c_ptr) :: doc = c_null_ptr
  end type assay_state_variable

  type, bind(c) :: assay_step
    real(c_double) :: t, dt
    type(c_ptr) :: F0, F1 ! (n, 9): call c_f_pointer(step%F1, F1, [n, 9_c_size_t])
  end type assay_step

  type, bind(c) :: assay_material
    integer(c_int32_t) :: abi_major = 0, struct_size = 0
    type(c_ptr) :: name = c_null_ptr, version = c_null_ptr, licence = c_null_ptr, doc = c_null_ptr
    integer(c_int32_t) :: symmetry = assay_isotropic, flags = 0, parameter_count = 0, state_count = 0
    type(c_ptr) :: parameters = c_null_ptr, state = c_null_ptr
    type(c_funptr) :: create = c_null_funptr, destroy = c_null_funptr, initial_state = c_null_funptr, &
                      update = c_null_funptr, extension = c_null_funptr
    type(c_funptr) :: create_of = c_null_funptr, extension_of = c_null_funptr ! since 1.1
  end type assay_material

  ! Extensions: struct_size is that of the type; assay_example holds an address of values, assay_symmetry a class, the
  ! others a function.
  type, bind(c) :: assay_rate
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: rate
  end type assay_rate

  type, bind(c) :: assay_tangent
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: tangent
  end type assay_tangent

  type, bind(c) :: assay_energy
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: energy
  end type assay_energy

  type, bind(c) :: assay_wave_speed
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: wave_speed
  end type assay_wave_speed

  type, bind(c) :: assay_closed_form
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: tau
  end type assay_closed_form

  type, bind(c) :: assay_reason
    integer(c_int32_t) :: struct_size
    type(c_funptr) :: reason
  end type assay_reason

  type, bind(c) :: assay_example
    integer(c_int32_t) :: struct_size
    type(c_ptr) :: parameters
  end type assay_example

  type, bind(c) :: assay_symmetry
    integer(c_int32_t) :: struct_size
    integer(c_int32_t) :: material_class
  end type assay_symmetry

  abstract interface
    function assay_create(parameters, message) bind(c) result(self)
      import
      real(c_double), intent(in) :: parameters(*)
      character(kind=c_char), intent(inout) :: message(*)
      type(c_ptr) :: self
    end function assay_create

    subroutine assay_destroy(self) bind(c)
      import
      type(c_ptr), value :: self
    end subroutine assay_destroy

    function assay_initial_state(self, n, cauchy, state) bind(c) result(status)
      import
      type(c_ptr), value :: self
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: cauchy(n, 9)
      real(c_double), intent(inout) :: state(n, *)
      integer(c_int32_t) :: status
    end function assay_initial_state

    subroutine assay_update(self, step, n, state0, state1, cauchy, status, dt_factor, message) bind(c)
      import
      type(c_ptr), value :: self
      type(assay_step), intent(in) :: step
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: state0(n, *)
      real(c_double), intent(inout) :: state1(n, *), cauchy(n, 9)
      integer(c_int32_t), intent(inout) :: status(n)
      real(c_double), intent(inout) :: dt_factor
      character(kind=c_char), intent(inout) :: message(*)
    end subroutine assay_update

    function assay_extension(id) bind(c) result(table)
      import
      character(kind=c_char), intent(in) :: id(*)
      type(c_ptr) :: table
    end function assay_extension

    function assay_create_of(table, parameters, message) bind(c) result(self)
      import
      type(assay_material), intent(in) :: table
      real(c_double), intent(in) :: parameters(*)
      character(kind=c_char), intent(inout) :: message(*)
      type(c_ptr) :: self
    end function assay_create_of

    function assay_extension_of(table, id) bind(c) result(extension)
      import
      type(assay_material), intent(in) :: table
      character(kind=c_char), intent(in) :: id(*)
      type(c_ptr) :: extension
    end function assay_extension_of

    function assay_rate_function(self, t, n, F, velocity_gradient, cauchy, state, cauchy_rate, state_rate) bind(c) &
      result(status)
      import
      type(c_ptr), value :: self
      real(c_double), value :: t
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: F(n, 9), velocity_gradient(n, 9), cauchy(n, 9), state(n, *)
      real(c_double), intent(inout) :: cauchy_rate(n, 9), state_rate(n, *)
      integer(c_int32_t) :: status
    end function assay_rate_function

    ! a field (assay_role_field) has throughout the step the value that it has in state0
    function assay_tangent_function(self, step, n, state0, tangent) bind(c) result(status)
      import
      type(c_ptr), value :: self
      type(assay_step), intent(in) :: step
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: state0(n, *)
      real(c_double), intent(inout) :: tangent(n, 9, 9) ! point, component of F1, component of the stress
      integer(c_int32_t) :: status
    end function assay_tangent_function

    function assay_energy_function(self, n, F, state, energy) bind(c) result(status)
      import
      type(c_ptr), value :: self
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: F(n, 9), state(n, *)
      real(c_double), intent(inout) :: energy(n)
      integer(c_int32_t) :: status
    end function assay_energy_function

    function assay_wave_speed_function(self, density, n, F, cauchy, state, speed) bind(c) result(status)
      import
      type(c_ptr), value :: self
      real(c_double), value :: density
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: F(n, 9), cauchy(n, 9), state(n, *)
      real(c_double), intent(inout) :: speed(n)
      integer(c_int32_t) :: status
    end function assay_wave_speed_function

    function assay_closed_form_function(self, baseline, n, eps, tau, dtau_deps) bind(c) result(status)
      import
      type(c_ptr), value :: self
      integer(c_int32_t), value :: baseline
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: eps(n)
      real(c_double), intent(inout) :: tau(n, 9), dtau_deps(n, 9)
      integer(c_int32_t) :: status
    end function assay_closed_form_function

    function assay_reason_function(self) bind(c) result(sentence)
      import
      type(c_ptr), value :: self
      type(c_ptr) :: sentence
    end function assay_reason_function
  end interface

contains

  ! A table of these functions; the compiler compares them with the interfaces above. `parameters` and `state` must live
  ! as long as the process.
  function material_table(name, version, licence, doc, symmetry, flags, parameters, create, destroy, update, state, &
                          initial_state, extension) result(table)
    character(len=*), intent(in) :: name, version, licence, doc
    integer(c_int32_t), intent(in) :: symmetry, flags
    type(assay_parameter), intent(in), target :: parameters(:)
    procedure(assay_create) :: create
    procedure(assay_destroy) :: destroy
    procedure(assay_update) :: update
    type(assay_state_variable), intent(in), target, optional :: state(:)
    procedure(assay_initial_state), optional :: initial_state
    procedure(assay_extension), optional :: extension
    type(assay_material) :: table
    table%struct_size = int(c_sizeof(table), c_int32_t)
    table%name = c_text(name)
    table%version = c_text(version)
    table%licence = c_text(licence)
    table%doc = c_text(doc)
    table%symmetry = symmetry
    table%flags = flags
    table%parameter_count = size(parameters, kind=c_int32_t)
    if (size(parameters) > 0) table%parameters = c_loc(parameters(1))
    table%create = c_funloc(create)
    table%destroy = c_funloc(destroy)
    table%update = c_funloc(update)
    if (present(state)) then
      table%state_count = size(state, kind=c_int32_t)
      if (size(state) > 0) table%state = c_loc(state(1))
    end if
    if (present(initial_state)) table%initial_state = c_funloc(initial_state)
    if (present(extension)) table%extension = c_funloc(extension)
    table%abi_major = assay_abi_major
  end function material_table

  ! One parameter; required where the default is absent.
  function parameter_of(name, unit, lower, upper, doc, default_value) result(parameter)
    character(len=*), intent(in) :: name, unit, doc
    real(c_double), intent(in) :: lower, upper
    real(c_double), intent(in), optional :: default_value
    type(assay_parameter) :: parameter
    parameter%name = c_text(name)
    parameter%unit = c_text(unit)
    parameter%doc = c_text(doc)
    parameter%lower = lower
    parameter%upper = upper
    parameter%default_value = ieee_value(1._c_double, ieee_quiet_nan)
    if (present(default_value)) parameter%default_value = default_value
  end function parameter_of

  function state_variable_of(name, unit, kind, role, doc) result(variable)
    character(len=*), intent(in) :: name, unit, doc
    integer(c_int32_t), intent(in) :: kind, role
    type(assay_state_variable) :: variable
    variable%name = c_text(name)
    variable%unit = c_text(unit)
    variable%kind = kind
    variable%role = role
    variable%doc = c_text(doc)
  end function state_variable_of

  ! A tensor of nine components by rows, and back.
  pure function tensor_of(rows) result(tensor)
    real(c_double), intent(in) :: rows(9)
    real(c_double) :: tensor(3, 3)
    tensor = transpose(reshape(rows, [3, 3]))
  end function tensor_of

  pure function rows_of(tensor) result(rows)
    real(c_double), intent(in) :: tensor(3, 3)
    real(c_double) :: rows(9)
    rows = reshape(transpose(tensor), [9])
  end function rows_of

  ! A text of C that lives as long as the process.
  function c_text(text) result(address)
    character(len=*), intent(in) :: text
    type(c_ptr) :: address
    character(kind=c_char), pointer :: copy(:)
    integer :: i
    allocate (copy(len(text) + 1))
    do i = 1, len(text)
      copy(i) = text(i:i)
    end do
    copy(len(text) + 1) = c_null_char
    address = c_loc(copy(1))
  end function c_text

  ! Writes the text, cut where it is too long, into a message of the interface.
  pure subroutine say(message, text)
    character(kind=c_char), intent(inout) :: message(*)
    character(len=*), intent(in) :: text
    integer :: i, length
    length = min(len(text), int(assay_message_size) - 1)
    do i = 1, length
      message(i) = text(i:i)
    end do
    message(length + 1) = c_null_char
  end subroutine say

  ! Whether a text of C is this one, as in is_text(id, assay_extension_rate).
  pure function is_text(c, text) result(same)
    character(kind=c_char), intent(in) :: c(*)
    character(len=*), intent(in) :: text
    logical :: same
    integer :: i
    same = .false.
    do i = 1, len(text)
      if (c(i) /= text(i:i)) return
    end do
    same = c(len(text) + 1) == c_null_char
  end function is_text
end module assay_abi
