/* SPDX-License-Identifier: BSD-3-Clause */
#include "tests/house/abi_layout.h"

#include <stddef.h>

#include "harness/assay_material.h"

#define SIZE(type) {"sizeof(" #type ")", (int64_t)sizeof(type)}
#define AT(type, member) {#type "." #member, (int64_t)offsetof(type, member)}
#define IS(constant) {#constant, constant}
#define EXTENSION(type, member) SIZE(type), AT(type, struct_size), AT(type, member)

static const abi_layout_entry layout[] = {
    SIZE(assay_parameter), AT(assay_parameter, name), AT(assay_parameter, unit), AT(assay_parameter, default_value),
    AT(assay_parameter, lower), AT(assay_parameter, upper), AT(assay_parameter, doc),
    SIZE(assay_state_variable), AT(assay_state_variable, name), AT(assay_state_variable, unit),
    AT(assay_state_variable, kind), AT(assay_state_variable, role), AT(assay_state_variable, doc),
    SIZE(assay_step), AT(assay_step, t), AT(assay_step, dt), AT(assay_step, F0), AT(assay_step, F1),
    SIZE(assay_material), AT(assay_material, abi_major), AT(assay_material, struct_size), AT(assay_material, name),
    AT(assay_material, version), AT(assay_material, licence), AT(assay_material, doc), AT(assay_material, symmetry),
    AT(assay_material, flags), AT(assay_material, parameter_count), AT(assay_material, state_count),
    AT(assay_material, parameters), AT(assay_material, state), AT(assay_material, create),
    AT(assay_material, destroy), AT(assay_material, initial_state), AT(assay_material, update),
    AT(assay_material, extension), AT(assay_material, create_of), AT(assay_material, extension_of),
    EXTENSION(assay_rate, rate), EXTENSION(assay_tangent, tangent), EXTENSION(assay_energy, energy),
    EXTENSION(assay_wave_speed, wave_speed), EXTENSION(assay_closed_form, tau), EXTENSION(assay_reason, reason),
    EXTENSION(assay_example, parameters), EXTENSION(assay_symmetry, material_class),
    IS(ASSAY_ABI_MAJOR), IS(ASSAY_ABI_MINOR), IS(ASSAY_BATCH_MAX), IS(ASSAY_MESSAGE_SIZE),
    IS(ASSAY_FAILED), IS(ASSAY_DOUBTFUL), IS(ASSAY_GOOD),
    IS(ASSAY_SCALAR), IS(ASSAY_VECTOR), IS(ASSAY_SYMMETRIC_TENSOR), IS(ASSAY_TENSOR),
    IS(ASSAY_ROLE_PLAIN), IS(ASSAY_ROLE_ROTATES_ITSELF), IS(ASSAY_ROLE_DIRECTION), IS(ASSAY_ROLE_FIELD),
    IS(ASSAY_ISOTROPIC), IS(ASSAY_CYLINDRICALLY_ORTHOTROPIC), IS(ASSAY_ANISOTROPIC),
    IS(ASSAY_MONOCLINIC), IS(ASSAY_ORTHOTROPIC), IS(ASSAY_TRIGONAL), IS(ASSAY_TETRAGONAL), IS(ASSAY_HEXAGONAL),
    IS(ASSAY_TRANSVERSELY_ISOTROPIC), IS(ASSAY_CUBIC),
    IS(ASSAY_NON_SMOOTH), IS(ASSAY_RATE_DEPENDENT), IS(ASSAY_THREAD_SAFE), IS(ASSAY_USES_INCREMENT),
    IS(ASSAY_IN_PLANE), IS(ASSAY_GROWS),
    IS(ASSAY_BASELINE_SIMPLE_SHEAR), IS(ASSAY_BASELINE_UNIAXIAL_STRAIN),
};

int32_t abi_layout_c(const abi_layout_entry **entries) {
  *entries = layout;
  return (int32_t)(sizeof layout / sizeof *layout);
}
