// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/entries.hpp"

#include <functional>

#include "harness/check/batches.hpp"
#include "harness/check/calls.hpp"
#include "harness/check/constant_rotation.hpp"
#include "harness/check/continuity.hpp"
#include "harness/check/derivatives.hpp"
#include "harness/check/dissipation.hpp"
#include "harness/check/elasticity.hpp"
#include "harness/check/extensions.hpp"
#include "harness/check/initial_stress.hpp"
#include "harness/check/isotropy.hpp"
#include "harness/check/last_digits.hpp"
#include "harness/check/material_symmetry.hpp"
#include "harness/check/memory.hpp"
#include "harness/check/positive_stiffness.hpp"
#include "harness/check/refusals.hpp"
#include "harness/check/repeated_stretch.hpp"
#include "harness/check/rest.hpp"
#include "harness/check/rotation.hpp"
#include "harness/check/stability.hpp"
#include "harness/check/steps.hpp"
#include "harness/check/threads.hpp"

namespace assay::check {

namespace {

template <class Test>
std::function<TestResult(const Specimen&, Evidence&)> plain(Test test) {
  return [test](const Specimen& specimen, Evidence&) { return test(specimen); };
}

/// What a material that grows cannot hold, since time brings stress and work.
template <class Test>
std::function<TestResult(const Specimen&, Evidence&)> unless_it_grows(const char* id, Test test) {
  return [=](const Specimen& specimen, Evidence& evidence) {
    if (!specimen.material->has(ASSAY_GROWS)) return test(specimen, evidence);
    return TestResult{.id = id,
                      .verdict = Verdict::not_applicable,
                      .sentence = "the model declares that it grows: time brings stress and work of its own"};
  };
}

/// A test of rotation whose finding the diagnosis looks at.
template <class Test>
std::function<TestResult(const Specimen&, Evidence&)> kept(RotationFinding Evidence::*place, Test test) {
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
  return {{"calls.repeated", nullptr,
           [](const Specimen& specimen, Evidence& evidence) {
             return repeated_calls(specimen, evidence.first.histories, evidence.repeated);
           },
           true},
          {"calls.batch", nullptr,
           [](const Specimen& specimen, Evidence& evidence) { return batches(specimen, evidence.first.batches); }},
          {"calls.alignment", nullptr, plain(alignment), true},
          {"clock", nullptr, unless_it_grows("clock", plain(clock_independence))},
          {"continuity", nullptr, plain(continuity), true}};
}

std::vector<Entry> entries() {
  const auto turning = [](When when) { return plain([when](const Specimen& s) { return rotation(s, when); }); };
  return {
      {"rest", nullptr, unless_it_grows("rest", plain(stress_at_rest))},
      {"symmetry", causes::not_indifferent, plain(symmetry)},
      {"zero_increment", nullptr, unless_it_grows("zero_increment", plain(zero_increment))},
      {"elasticity.components", nullptr, plain(shear_components)},
      {"elasticity.shear", nullptr, plain(shear_modulus)},
      {"elasticity.positive", nullptr, plain(positive_stiffness)},
      {"elasticity.class", nullptr, stiffness_class},
      {"elasticity.major", nullptr, plain(major_symmetry)},
      {"rotation.constant", causes::not_indifferent, plain(constant_rotation)},
      {"basis", causes::not_indifferent, plain(change_of_basis)},
      {"isotropy", causes::not_isotropic, plain(isotropy)},
      {"symmetry_class", causes::not_of_class, loading_class},
      {"rotation.at_rest", causes::not_indifferent,
       unless_it_grows("rotation.at_rest", kept(&Evidence::at_rest, rotation_at_rest))},
      {"rotation.before", causes::not_indifferent, turning(When::before)},
      {"rotation.during", causes::not_indifferent, turning(When::during)},
      {"rotation.after", causes::not_indifferent, turning(When::after)},
      {"rotation.apex", causes::repeated_stretch, plain(rotation_at_apex)},
      {"rotation.fixed_stretch", causes::not_indifferent, kept(&Evidence::fixed, rotation_at_fixed_stretch)},
      {"rotation.revolutions", causes::not_indifferent, plain(revolutions)},
      {"rotation.state", causes::not_indifferent, kept(&Evidence::state, rotation_of_state)},
      {"stretches.nearly_equal", causes::repeated_stretch, plain(nearly_equal_stretches)},
      {"stretches.turning", causes::repeated_stretch, plain(rotation_at_equal_stretches)},
      {"initial_stress", nullptr, plain(initial_stress)},
      {"step_halving", nullptr, plain(step_halving)},
      {"jumps", nullptr, plain(jumps)},
      {"memory", nullptr, plain(memory)},
      {"tangent", nullptr, plain(tangent)},
      {"energy", nullptr, plain(energy)},
      {"rate", nullptr, plain(rate_form)},
      {"wave_speed", nullptr, plain(wave_speed)},
      {"closed_form", nullptr, plain(closed_form)},
      {"dissipation", nullptr, unless_it_grows("dissipation", plain(dissipation))},
      {"ellipticity", nullptr, plain(ellipticity)},
      {"calls.increment", nullptr, plain(undeclared_increment)},
      {"calls.refused", nullptr, plain(refusals)},
      {"calls.threads", nullptr, plain(threads)},
      {"calls.bits", nullptr,
       [](const Specimen& specimen, Evidence& evidence) {
         return last_digits(specimen, evidence.first.histories, evidence.repeated);
       }},
      {"calls.senseless", nullptr, plain(senseless_deformation)},
  };
}

}  // namespace assay::check
