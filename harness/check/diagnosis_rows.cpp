// SPDX-License-Identifier: BSD-3-Clause
// The table that diagnoses are made of: what was found, and the cause that it tells.
#include "harness/check/diagnosis.hpp"

#include "harness/check/stiffness.hpp"

namespace assay::check {

namespace {

using Found = std::optional<Suspicion>;
using Says = std::function<Found(const Facts&)>;
using Where = std::function<bool(const Facts&)>;

// What is said.

/// What a failed test says, with its measure as the size.
Found said_by(const Facts& f, const std::string& id) {
  const TestResult* test = f.failure(id);
  if (!test) return std::nullopt;
  const double measure = test->measure.value_or(INFINITY);
  return Suspicion{test->cause, test->sentence, std::isfinite(measure) ? measure : INFINITY};
}

Says by_size(const char* id) {
  return [=](const Facts& f) { return said_by(f, id); };
}

/// Of what is right or wrong whatever its size.
Says by(const char* id) {
  return [=](const Facts& f) {
    const TestResult* test = f.failure(id);
    return test ? Found(Suspicion{test->cause, test->sentence}) : std::nullopt;
  };
}

Says that(const char* cause, const char* words) {
  return [=](const Facts&) { return Suspicion{cause, words}; };
}

/// What a model is said to be of which no more is known; a stress that is not symmetric says more.
Suspicion unnamed(const Facts& f, const std::string& sentence) {
  const TestResult* asymmetry = f.failure(ids::symmetry);
  return asymmetry ? Suspicion{asymmetry->cause, asymmetry->sentence} : Suspicion{causes::not_indifferent, sentence};
}

/// A law that turns nothing has no spin that could be wrong.
Suspicion not_turned(const Facts& f, const std::string& sentence) {
  return f.evidence.has_spin ? Suspicion{causes::wrong_spin, sentence} : unnamed(f, sentence);
}

Found constant_unnamed(const Facts& f) { return unnamed(f, f.failure(ids::constant_rotation)->sentence); }

Found overshoot_words(const Facts& f) { return Suspicion{causes::dissipation, f.evidence.overshoots}; }

Found growth_words(const Facts& f) {
  return Suspicion{causes::grows,
                   "an undeformed body becomes stressed with time, for every step length: it has a strain of its own, "
                   "such as growth or swelling. If this is intended, declare " +
                       f.evidence.growth_declaration};
}

Found isotropy_words(const Facts& f) {
  const TestResult* test = f.failure(ids::isotropy);
  if (!test) return std::nullopt;
  return Suspicion{is_of_order(test->cause) ? test->cause : causes::not_isotropic,
                   "a body that was rotated before it is loaded has another stress: " + test->sentence};
}

Found drift_words(const Facts& f) {
  return Suspicion{causes::drifts, "'" + f.evidence.drifting + "' of the state changes in steps without deformation, " +
                                       "and this makes later stresses wrong"};
}

Found steps_words(const Facts& f) {
  return Suspicion{
      causes::explicit_spin,
      "the increment that rotates the stress is not a rotation, or part of the rotation is taken as strain: " +
          f.evidence.fixed.result.sentence};
}

Found left_behind_words(const Facts& f) {
  return Suspicion{causes::state_not_rotated,
                   "when the body rotates, " + f.evidence.state.left_behind +
                       " of the state does not rotate with it, and this makes the stress wrong"};
}

Found left_behind_later_words(const Facts& f) {
  return Suspicion{causes::state_not_rotated,
                   "the stress turns with the body, but " + f.evidence.state.left_behind +
                       " of the state does not, and this makes the stress of later loads wrong"};
}

Found fixed_stretch_words(const Facts& f) { return not_turned(f, f.evidence.fixed.result.sentence); }

constexpr double unmoved = 0.02;  ///< of the body's angle

/// Of the body's angle: by which a small turn turns the stress, where that is not 1.
std::optional<double> other_spin(const RotationFinding& fixed) {
  return fixed.spin && std::abs(*fixed.spin - 1) > unmoved ? fixed.spin : std::nullopt;
}

Found another_angle(const Facts& f) {
  const RotationFinding& fixed = f.evidence.fixed;
  const bool other_angle = fixed.turned && std::abs(*fixed.turned - 1) > unmoved;
  // A large turn may be taken for another one, by which it comes to the same place.
  const std::optional<double> small = other_spin(fixed), times = small || !other_angle ? small : fixed.turned;
  if (!times) return std::nullopt;
  return Suspicion{causes::wrong_spin, "the stress rotates by " + rounded(*times) +
                                           " times the angle of the body's rotation" +
                                           (fixed.turned ? "" : ", and its increments are not rotations")};
}

Found any_turn(const Facts& f) {
  for (const char* id : {ids::rotation_during, ids::rotation_after, ids::rotation_before, ids::rotation_at_rest}) {
    const Found said = said_by(f, id);
    if (said) return said->cause.empty() ? not_turned(f, said->sentence) : said;
  }
  return std::nullopt;
}

Found any_frame(const Facts& f) {
  if (f.failed(ids::constant_rotation)) return constant_unnamed(f);
  if (!f.failed(ids::basis) || f.failed(ids::isotropy)) return std::nullopt;
  return unnamed(f, f.failure(ids::basis)->sentence);
}

// Where it is said.

Where failed_in(const char* id) {
  return [=](const Facts& f) { return f.failed(id); };
}

Where failed_by(const char* id, const char* cause) {
  return [=](const Facts& f) { return f.failed(id) && f.cause(id) == cause; };
}

Where both(const Where& one, const Where& other) {
  return [=](const Facts& f) { return one(f) && other(f); };
}

Where no(const Where& where) {
  return [=](const Facts& f) { return !where(f); };
}

Where neither(const Where& one, const Where& other) { return both(no(one), no(other)); }

Where is(bool Evidence::*fact) {
  return [=](const Facts& f) { return f.evidence.*fact; };
}

bool overshoots(const Facts& f) { return !f.evidence.overshoots.empty() && f.failed(ids::dissipation); }

bool explodes_in_frames(const Facts& f) {
  constexpr double exploded = 10;  // times the largest stress
  return f.any_failure([](const TestResult& test) {
    return is_of(Explains::frames, test.id) && !(test.measure.value_or(INFINITY) <= exploded);
  });
}

bool grows(const Facts& f) { return f.evidence.grows_at_rest && (f.failed(ids::rest) || f.failed(ids::clock)); }

bool grows_by_anything(const Facts& f) { return !f.evidence.overshoots.empty(); }

bool is_finite_in_revolutions(const Facts& f) {
  return !f.failed(ids::revolutions) || std::isfinite(f.failure(ids::revolutions)->measure.value_or(0));
}

/// Whether a body that stands in a turned frame is wrong already.
bool is_wrong_once_for_all(const Facts& f) { return f.failed(ids::constant_rotation) || f.failed(ids::basis); }

/// A pressure is the same in every frame: what else differs has a cause of its own.
bool is_pressure_beside_frames(const Facts& f) {
  return f.evidence.pressed_at_rest && f.failed(ids::constant_rotation);
}

bool rest_is_told(const Facts& f) { return rest_is_of_stretches(f) || f.is_explained(ids::rest); }

bool zero_increment_is_told(const Facts& f) { return f.is_explained(ids::zero_increment); }

/// Of a stiffness that is mixed up as a whole: a frame shows it as well.
bool is_of_no_class(const Facts& f) {
  return f.failed(ids::class_at_rest) &&
         (f.evidence.symmetry.fits_no_class || f.cause(ids::class_at_rest) != causes::not_of_class);
}

bool initial_stress_is_in_another_order(const Facts& f) { return is_of_order(f.cause(ids::initial_stress)); }

/// Whether a test fails where the stress of sym(Q - I) is found, or nearly.
Where is_of_small_strain(const char* id, double RotationFinding::*multiple) {
  constexpr double within = 0.1;
  return [=](const Facts& f) { return f.failed(id) && std::abs(f.evidence.at_rest.*multiple - 1) < within; };
}

/// Whether the test of a constant rotation says more than the turned step, which also says of what.
bool says_more_than_a_step(const Facts& f) {
  const std::string cause = f.cause(ids::constant_rotation);
  // principal axes in a wrong order are right at right angles, too
  if (cause.empty() || (cause == causes::shear_factor && f.failed(ids::nearly_equal_stretches))) return false;
  const Found step = said_by_turned_step(f);
  return !(step && step->cause == cause);
}

bool drifts(const Facts& f) { return f.failed(ids::constant_rotation) && !f.evidence.drifting.empty(); }

bool is_unmoved(const Facts& f) {
  const std::optional<double>& turned = f.evidence.fixed.turned;
  return turned && !(std::abs(*turned) > unmoved);
}

/// Whether an error of a stretched body that turns is one of the length of the steps.
bool is_of_steps(const Facts& f) {
  const RotationFinding& fixed = f.evidence.fixed;
  const bool small_turns_are_right = fixed.spin && std::abs(*fixed.spin - 1) <= unmoved;
  return (fixed.result.order && !other_spin(fixed)) || small_turns_are_right;
}

bool leaves_state_behind(const Facts& f) { return !f.evidence.state.left_behind.empty(); }

bool fails_after_a_turn(const Facts& f) { return f.failed(ids::rotation_after) || f.failed(ids::rotation_during); }

}  // namespace

const std::vector<Row>& rows() {
  using enum Explains;
  using enum Beside;
  static const Where fixed = failed_in(ids::fixed_stretch), constant = failed_in(ids::constant_rotation),
                     needs_a_spin = both(is(&Evidence::right_without_spin), is(&Evidence::has_spin));
  static const std::vector<Row> all{
      // Where steps are so long that the stress explodes, tests of frames mean nothing.
      {frames, any, overshoot_words, both(overshoots, explodes_in_frames)},
      {time, any, overshoot_words, overshoots},
      // A body that is held does not relax, and one that turns does, where rounding makes a strain of its turn.
      {frames, any, by(ids::step_halving), both(failed_by(ids::step_halving, causes::drifts), no(grows_by_anything))},
      {time, any, growth_words, grows},
      // What is kept elsewhere follows no clock, nor does what hangs on where arrays lie.
      {time, no_time, by(ids::clock), neither(failed_in(ids::repeated), failed_in(ids::alignment))},
      {frames, any, by(ids::increment), no(is(&Evidence::has_state_that_turns))},  // nor has it a spin
      {its_own_test, any, by(ids::increment)},
      {its_own_test, any, by(ids::rest), both(is_pressure_beside_frames, no(rest_is_told))},
      {frames, any, by(ids::rest), neither(is_pressure_beside_frames, rest_is_told)},
      // A stress that is held grows without bounds: then no test of rotation means anything.
      {frames, any, by(ids::dissipation), neither(is_finite_in_revolutions, constant)},
      {frames, any, by(ids::nearly_equal_stretches), no(is_wrong_once_for_all)},
      {its_own_test, any, by(ids::zero_increment), neither(is_wrong_once_for_all, zero_increment_is_told)},
      {frames, no_frames, by(ids::symmetry), both(failed_in(ids::symmetry), is(&Evidence::asymmetric_at_rest))},
      {frames, no_frames, by_size(ids::shear_components)},
      {frames, any, by_size(ids::shear_modulus), failed_in(ids::shear_components)},
      {frames, no_frames, by_size(ids::shear_modulus)},
      {frames, no_frames, by_size(ids::class_at_rest), is_of_no_class},
      {frames, any, by(ids::initial_stress), initial_stress_is_in_another_order},

      // Of models that do not turn with the body: which tensor does not, and how it turns instead.
      {frames, no_frames,
       that(causes::small_strain,
            "a rigid rotation Q gives the stress of the strain sym(Q - I): the strain measure is not valid for finite "
            "rotations"),
       is_of_small_strain(ids::rotation_at_rest, &RotationFinding::small_strain)},
      {frames, no_frames,
       that(causes::small_strain,
            "a rigid rotation Q gives the viscous stress of the strain sym(Q - I): the strain rate is sym(F1 - F0)/dt, "
            "which is not valid for finite rotations"),
       is_of_small_strain(ids::constant_rotation, &RotationFinding::relaxing_small_strain)},
      {frames, no_frames, by_size(ids::constant_rotation), failed_by(ids::constant_rotation, causes::rotation_missing)},
      {frames, no_frames, by_size(ids::constant_rotation), says_more_than_a_step},
      {frames, no_frames, said_by_turned_step},
      {frames, no_frames, drift_words, drifts},
      {frames, no_frames,
       that(causes::rotation_missing, "the stress of a stretched body does not rotate with the body"),
       both(fixed, is_unmoved)},
      {frames, no_frames, constant_unnamed, both(both(fixed, constant), no(needs_a_spin))},
      {frames, no_frames,
       that(causes::wrong_spin,
            "the stress is right in every frame if the axes of stretch are fixed, and wrong if they rotate: components "
            "of the spin are missing or mixed up"),
       both(fixed, constant)},
      {frames, no_frames, steps_words, both(fixed, is_of_steps)},
      {frames, no_frames, another_angle, fixed},
      {frames, no_frames, left_behind_words, both(fixed, leaves_state_behind)},
      {frames, no_frames, fixed_stretch_words, fixed},
      {frames, no_frames, constant_unnamed, both(constant, no(is(&Evidence::right_without_spin)))},
      {frames, no_frames, left_behind_later_words, both(fails_after_a_turn, leaves_state_behind)},
      {frames, no_frames, by(ids::revolutions)},
      {frames, no_frames, any_turn},
      {frames, no_frames, any_frame},

      // What is left where no rotation explains the tests of frames.
      {frames, no_frames, isotropy_words, failed_in(ids::basis)},
      {its_own_test, no_frames, isotropy_words},
      {its_own_test, any, by(ids::class_at_rest), no(is_of_no_class)},  // of another class, which no frame shows
      {its_own_test, no_frames, by(ids::class_in_loading)},
  };
  return all;
}

}  // namespace assay::check
