! SPDX-License-Identifier: BSD-3-Clause
! The same list as abi_layout.c, of the module assay_abi.
module abi_layout
  use, intrinsic :: iso_c_binding
  use assay_abi
  implicit none
  private
  integer(c_int64_t) :: found(200)
  integer(c_int32_t) :: count

contains

  function abi_layout_fortran(room, values) bind(c) result(n)
    integer(c_int32_t), value :: room
    integer(c_int64_t), intent(inout) :: values(room)
    integer(c_int32_t) :: n
    count = 0
    call of_descriptions()
    call of_table()
    call of_extensions()
    call of_constants()
    n = min(count, room)
    values(:n) = found(:n)
  end function abi_layout_fortran

  subroutine add(value)
    integer(c_int64_t), intent(in) :: value
    count = count + 1
    found(count) = value
  end subroutine add

  subroutine add_offset(member, begin)
    type(c_ptr), intent(in) :: member, begin
    call add(transfer(member, 1_c_int64_t) - transfer(begin, 1_c_int64_t))
  end subroutine add_offset

  subroutine of_descriptions()
    type(assay_parameter), target :: p
    type(assay_state_variable), target :: v
    type(assay_step), target :: s
    call add(int(c_sizeof(p), c_int64_t))
    call add_offset(c_loc(p%name), c_loc(p))
    call add_offset(c_loc(p%unit), c_loc(p))
    call add_offset(c_loc(p%default_value), c_loc(p))
    call add_offset(c_loc(p%lower), c_loc(p))
    call add_offset(c_loc(p%upper), c_loc(p))
    call add_offset(c_loc(p%doc), c_loc(p))
    call add(int(c_sizeof(v), c_int64_t))
    call add_offset(c_loc(v%name), c_loc(v))
    call add_offset(c_loc(v%unit), c_loc(v))
    call add_offset(c_loc(v%kind), c_loc(v))
    call add_offset(c_loc(v%role), c_loc(v))
    call add_offset(c_loc(v%doc), c_loc(v))
    call add(int(c_sizeof(s), c_int64_t))
    call add_offset(c_loc(s%t), c_loc(s))
    call add_offset(c_loc(s%dt), c_loc(s))
    call add_offset(c_loc(s%F0), c_loc(s))
    call add_offset(c_loc(s%F1), c_loc(s))
  end subroutine of_descriptions

  subroutine of_table()
    type(assay_material), target :: t
    call add(int(c_sizeof(t), c_int64_t))
    call add_offset(c_loc(t%abi_major), c_loc(t))
    call add_offset(c_loc(t%struct_size), c_loc(t))
    call add_offset(c_loc(t%name), c_loc(t))
    call add_offset(c_loc(t%version), c_loc(t))
    call add_offset(c_loc(t%licence), c_loc(t))
    call add_offset(c_loc(t%doc), c_loc(t))
    call add_offset(c_loc(t%symmetry), c_loc(t))
    call add_offset(c_loc(t%flags), c_loc(t))
    call add_offset(c_loc(t%parameter_count), c_loc(t))
    call add_offset(c_loc(t%state_count), c_loc(t))
    call add_offset(c_loc(t%parameters), c_loc(t))
    call add_offset(c_loc(t%state), c_loc(t))
    call add_offset(c_loc(t%create), c_loc(t))
    call add_offset(c_loc(t%destroy), c_loc(t))
    call add_offset(c_loc(t%initial_state), c_loc(t))
    call add_offset(c_loc(t%update), c_loc(t))
    call add_offset(c_loc(t%extension), c_loc(t))
    call add_offset(c_loc(t%create_of), c_loc(t))
    call add_offset(c_loc(t%extension_of), c_loc(t))
  end subroutine of_table

  subroutine of_extensions()
    type(assay_rate), target :: rate
    type(assay_tangent), target :: tangent
    type(assay_energy), target :: energy
    type(assay_wave_speed), target :: wave_speed
    type(assay_closed_form), target :: closed_form
    type(assay_reason), target :: reason
    type(assay_example), target :: example
    type(assay_symmetry), target :: symmetry
    call add_extension(c_sizeof(rate), c_loc(rate), c_loc(rate%struct_size), c_loc(rate%rate))
    call add_extension(c_sizeof(tangent), c_loc(tangent), c_loc(tangent%struct_size), c_loc(tangent%tangent))
    call add_extension(c_sizeof(energy), c_loc(energy), c_loc(energy%struct_size), c_loc(energy%energy))
    call add_extension(c_sizeof(wave_speed), c_loc(wave_speed), c_loc(wave_speed%struct_size), &
                       c_loc(wave_speed%wave_speed))
    call add_extension(c_sizeof(closed_form), c_loc(closed_form), c_loc(closed_form%struct_size), &
                       c_loc(closed_form%tau))
    call add_extension(c_sizeof(reason), c_loc(reason), c_loc(reason%struct_size), c_loc(reason%reason))
    call add_extension(c_sizeof(example), c_loc(example), c_loc(example%struct_size), c_loc(example%parameters))
    call add_extension(c_sizeof(symmetry), c_loc(symmetry), c_loc(symmetry%struct_size), &
                       c_loc(symmetry%material_class))
  end subroutine of_extensions

  subroutine add_extension(bytes, begin, struct_size, member)
    integer(c_size_t), intent(in) :: bytes
    type(c_ptr), intent(in) :: begin, struct_size, member
    call add(int(bytes, c_int64_t))
    call add_offset(struct_size, begin)
    call add_offset(member, begin)
  end subroutine add_extension

  subroutine of_constants()
    integer :: i
    integer(c_int32_t), parameter :: constants(*) = [ &
      assay_abi_major, assay_abi_minor, int(assay_batch_max, c_int32_t), int(assay_message_size, c_int32_t), &
      assay_failed, assay_doubtful, assay_good, &
      assay_scalar, assay_vector, assay_symmetric_tensor, assay_tensor, &
      assay_role_plain, assay_role_rotates_itself, assay_role_direction, assay_role_field, &
      assay_isotropic, assay_cylindrically_orthotropic, assay_anisotropic, &
      assay_monoclinic, assay_orthotropic, assay_trigonal, assay_tetragonal, assay_hexagonal, &
      assay_transversely_isotropic, assay_cubic, &
      assay_non_smooth, assay_rate_dependent, assay_thread_safe, assay_uses_increment, assay_in_plane, assay_grows, &
      assay_baseline_simple_shear, assay_baseline_uniaxial_strain]
    do i = 1, size(constants)
      call add(int(constants(i), c_int64_t))
    end do
  end subroutine of_constants
end module abi_layout
