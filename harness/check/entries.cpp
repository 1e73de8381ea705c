// SPDX-License-Identifier: BSD-3-Clause
// The list of the battery's tests, in their order.
#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

std::function<TestResult(const Specimen&, Evidence&)> plain(auto test) {
  return [test](const Specimen& specimen, Evidence&) { return test(specimen); };
}

/// What a material that grows cannot hold, since time brings stress and work.
std::function<TestResult(const Specimen&, Evidence&)> unless_it_grows(auto test) {
  return [=](const Specimen& specimen, Evidence& evidence) {
    return specimen.material->has(ASSAY_GROWS)
               ? left_out("the model declares that it grows: time brings stress and work of its own")
               : test(specimen, evidence);
  };
}

/// A test of rotation whose finding the diagnosis looks at.
std::function<TestResult(const Specimen&, Evidence&)> kept(RotationFinding Evidence::*place, auto test) {
  return [=](const Specimen& specimen, Evidence& evidence) {
    evidence.*place = test(specimen);
    return (evidence.*place).result;
  };
}

TestResult stiffness_class(const Specimen& specimen, Evidence& evidence) {
  evidence.symmetry = class_at_rest(specimen);
  return evidence.symmetry.result;
}

TestResult loading_class(const Specimen& specimen, Evidence& evidence) {
  return class_in_loading(specimen, evidence.symmetry.axes);
}

}  // namespace

std::vector<Entry> first_entries() {
  return {{ids::repeated, nullptr,
           [](const Specimen& specimen, Evidence& evidence) {
             return repeated_calls(specimen, evidence.first.histories, evidence.repeated);
           },
           true},
          {ids::batch, nullptr,
           [](const Specimen& specimen, Evidence& evidence) { return batches(specimen, evidence.first.batches); }},
          {ids::alignment, nullptr, plain(alignment), true},
          {ids::clock, nullptr, unless_it_grows(plain(clock_independence))},
          {ids::continuity, nullptr, plain(continuity), true}};
}

std::vector<Entry> entries() {
  const auto turning = [](When when) { return plain([when](const Specimen& s) { return rotation(s, when); }); };
  return {
      {ids::rest, nullptr, unless_it_grows(plain(stress_at_rest))},
      {ids::symmetry, causes::not_indifferent, plain(symmetry)},
      {ids::zero_increment, nullptr, unless_it_grows(plain(zero_increment))},
      {ids::shear_components, nullptr, plain(shear_components)},
      {ids::shear_modulus, nullptr, plain(shear_modulus)},
      {ids::positive_stiffness, nullptr, plain(positive_stiffness)},
      {ids::class_at_rest, nullptr, stiffness_class},
      {ids::major_symmetry, nullptr, plain(major_symmetry)},
      {ids::constant_rotation, causes::not_indifferent, plain(constant_rotation)},
      {ids::basis, causes::not_indifferent, plain(change_of_basis)},
      {ids::isotropy, causes::not_isotropic, plain(isotropy)},
      {ids::class_in_loading, causes::not_of_class, loading_class},
      {ids::rotation_at_rest, causes::not_indifferent, unless_it_grows(kept(&Evidence::at_rest, rotation_at_rest))},
      {ids::rotation_before, causes::not_indifferent, turning(When::before)},
      {ids::rotation_during, causes::not_indifferent, turning(When::during)},
      {ids::rotation_after, causes::not_indifferent, turning(When::after)},
      {ids::rotation_at_apex, causes::repeated_stretch, plain(rotation_at_apex)},
      {ids::fixed_stretch, causes::not_indifferent, kept(&Evidence::fixed, rotation_at_fixed_stretch)},
      {ids::revolutions, causes::not_indifferent, plain(revolutions)},
      {ids::rotation_of_state, causes::not_indifferent, kept(&Evidence::state, rotation_of_state)},
      {ids::nearly_equal_stretches, causes::repeated_stretch, plain(nearly_equal_stretches)},
      {ids::turning_stretches, causes::repeated_stretch, plain(rotation_at_equal_stretches)},
      {ids::initial_stress, nullptr, plain(initial_stress)},
      {ids::step_halving, nullptr, plain(step_halving)},
      {ids::jumps, nullptr, plain(jumps)},
      {ids::memory, nullptr, plain(memory)},
      {ids::tangent, nullptr, plain(tangent)},
      {ids::energy, nullptr, plain(energy)},
      {ids::rate, nullptr, plain(rate_form)},
      {ids::wave_speed, nullptr, plain(wave_speed)},
      {ids::closed_form, nullptr, plain(closed_form)},
      {ids::dissipation, nullptr, unless_it_grows(plain(dissipation))},
      {ids::ellipticity, nullptr, plain(ellipticity)},
      {ids::increment, nullptr, plain(undeclared_increment)},
      {ids::refused, nullptr, plain(refusals)},
      {ids::threads, nullptr, plain(threads)},
      {ids::bits, nullptr,
       [](const Specimen& specimen, Evidence& evidence) {
         return last_digits(specimen, evidence.first.histories, evidence.repeated);
       }},
      {ids::senseless, nullptr, plain(senseless_deformation)},
  };
}

}  // namespace assay::check
