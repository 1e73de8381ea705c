// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/diagnosis_rows.hpp"

#include "harness/check/shear_order.hpp"

namespace assay::check {

namespace {

constexpr const char* of_frames[] = {
    "elasticity.components",  "elasticity.shear",     "isotropy",        "rotation.constant", "basis",
    "rotation.at_rest",       "rotation.before",      "rotation.during", "rotation.after",    "rotation.apex",
    "rotation.fixed_stretch", "rotation.revolutions", "rotation.state",  "stretches.turning", "initial_stress",
    "elasticity.class",       "symmetry_class"};
constexpr const char* of_time[] = {"rest",         "clock", "zero_increment", "rotation.at_rest",
                                   "step_halving", "jumps", "dissipation",    "initial_stress"};

using Found = std::optional<Suspicion>;

/// As `said_by`, of what is right or wrong whatever its size.
Found of(const Findings& f, const std::string& id) {
  Found said = said_by(f, id);
  if (said) said->size = INFINITY;
  return said;
}

/// Whether a body that stands in a turned frame is wrong already.
bool wrong_once_for_all(const Findings& f) { return f.failed("rotation.constant") || f.failed("basis"); }

/// A pressure is the same in every frame: what else differs has a cause of its own.
bool is_pressure_beside_frames(const Findings& f) {
  return f.evidence.pressed_at_rest && f.failed("rotation.constant");
}

/// A stress that time brings to a body at rest: growth, swelling.
Found grows(const Findings& f) {
  if (!f.evidence.grows_at_rest || !(f.failed("rest") || f.failed("clock"))) return std::nullopt;
  return Suspicion{causes::grows,
                   "an undeformed body becomes stressed with time, for every step length: it has a strain of its own, "
                   "such as growth or swelling. If this is intended, declare " +
                       f.evidence.growth_declaration};
}

/// What is kept elsewhere follows no clock, nor does what hangs on where arrays lie.
Found clock(const Findings& f) {
  return f.failed("calls.repeated") || f.failed("calls.alignment") ? std::nullopt : of(f, "clock");
}

Found increment_of_scalars(const Findings& f) {
  return f.evidence.has_state_that_turns ? std::nullopt : of(f, "calls.increment");  // nor has it a spin
}

Found increment(const Findings& f) { return of(f, "calls.increment"); }

Found pressure_at_rest_alone(const Findings& f) {
  const bool other = rest_is_of_stretches(f.verdicts) || f.is_explained("rest");
  return is_pressure_beside_frames(f) && !other ? of(f, "rest") : std::nullopt;
}

Found stress_at_rest_row(const Findings& f) {
  const bool other = is_pressure_beside_frames(f) || rest_is_of_stretches(f.verdicts) || f.is_explained("rest");
  return other ? std::nullopt : of(f, "rest");
}

/// A stress that is held grows without bounds: then no test of rotation means anything.
Found growth(const Findings& f) {
  const bool grows = f.failed("rotation.revolutions") && !f.failed("rotation.constant") &&
                     !std::isfinite(f.find("rotation.revolutions")->measure.value_or(0));
  return grows ? of(f, "dissipation") : std::nullopt;
}

/// Relaxation that overshoots comes with time.
Found overshoots(const Findings& f) {
  if (f.evidence.overshoots.empty() || !f.verdicts.failed("dissipation")) return std::nullopt;
  return Suspicion{causes::dissipation, f.evidence.overshoots};
}

/// Where steps are so long that the stress explodes, tests of frames mean nothing.
Found overshoots_beyond_frames(const Findings& f) {
  constexpr double exploded = 10;  // times the largest stress
  const std::vector<TestResult>& tests = f.verdicts.tests();
  const bool explodes = std::any_of(tests.begin(), tests.end(), [](const TestResult& test) {
    return test.verdict == Verdict::fail && is_of(Explains::frames, test.id) &&
           !(test.measure.value_or(INFINITY) <= exploded);
  });
  return explodes ? overshoots(f) : std::nullopt;
}

Found nearly_equal_stretches_row(const Findings& f) {
  return wrong_once_for_all(f) ? std::nullopt : of(f, "stretches.nearly_equal");
}

Found zero_increment_row(const Findings& f) {
  return wrong_once_for_all(f) || f.is_explained("zero_increment") ? std::nullopt : of(f, "zero_increment");
}

Found components(const Findings& f) { return said_by(f, "elasticity.components"); }

Found shear(const Findings& f) { return said_by(f, "elasticity.shear"); }

Found shear_beside_components(const Findings& f) {
  return f.failed("elasticity.components") ? said_by(f, "elasticity.shear") : std::nullopt;
}

Found initial_stress_in_other_order(const Findings& f) {
  const Found said = of(f, "initial_stress");
  return said && is_of_order(said->cause) ? said : std::nullopt;
}

Found isotropy_row(const Findings& f) {
  if (!f.failed("isotropy")) return std::nullopt;
  const TestResult& test = *f.find("isotropy");
  return Suspicion{is_of_order(test.cause) ? test.cause : causes::not_isotropic,
                   "a body that was rotated before it is loaded has another stress: " + test.sentence};
}

/// Of a stiffness that is mixed up as a whole: a frame shows it as well.
Found no_class(const Findings& f) {
  const Found said = said_by(f, "elasticity.class");
  const bool mixed_up = said && (f.evidence.symmetry.fits_no_class || said->cause != causes::not_of_class);
  return mixed_up ? said : std::nullopt;
}

/// Of another class, which no frame shows.
Found other_class(const Findings& f) { return no_class(f) ? std::nullopt : of(f, "elasticity.class"); }

Found other_class_in_loading(const Findings& f) { return of(f, "symmetry_class"); }

Found isotropy_and_basis(const Findings& f) { return f.failed("basis") ? isotropy_row(f) : std::nullopt; }

/// A body that is held does not relax, and one that turns does, where rounding makes a strain of its turn.
Found rests_when_held(const Findings& f) {
  const bool overshoots = !f.evidence.overshoots.empty();  // which grows by anything, as by another step
  const bool rests = f.failed("step_halving") && f.find("step_halving")->cause == causes::drifts && !overshoots;
  return rests ? of(f, "step_halving") : std::nullopt;
}

constexpr Row before[] = {
    {overshoots_beyond_frames, Explains::frames, Beside::any},
    {overshoots, Explains::time, Beside::any},
    {rests_when_held, Explains::frames, Beside::any},
    {grows, Explains::time, Beside::any},
    {clock, Explains::time, Beside::no_time},
    {increment_of_scalars, Explains::frames, Beside::any},
    {increment, Explains::its_own_test, Beside::any},
    {pressure_at_rest_alone, Explains::its_own_test, Beside::any},
    {stress_at_rest_row, Explains::frames, Beside::any},
    {growth, Explains::frames, Beside::any},
    {nearly_equal_stretches_row, Explains::frames, Beside::any},
    {zero_increment_row, Explains::its_own_test, Beside::any},
    {components, Explains::frames, Beside::no_frames},
    {shear_beside_components, Explains::frames, Beside::any},
    {shear, Explains::frames, Beside::no_frames},
    {no_class, Explains::frames, Beside::no_frames},
    {initial_stress_in_other_order, Explains::frames, Beside::any},
};

constexpr Row after[] = {
    {isotropy_and_basis, Explains::frames, Beside::no_frames},
    {isotropy_row, Explains::its_own_test, Beside::no_frames},
    {other_class, Explains::its_own_test, Beside::any},
    {other_class_in_loading, Explains::its_own_test, Beside::no_frames},
};

}  // namespace

bool is_of(Explains group, const std::string& test) {
  const auto holds = [&](const auto& ids) {
    return std::any_of(std::begin(ids), std::end(ids), [&](const char* id) { return test == id; });
  };
  switch (group) {
    case Explains::frames:
      return holds(of_frames);
    case Explains::time:
      return holds(of_time);
    case Explains::its_own_test:
      break;
  }
  return false;
}

std::span<const Row> rows_before_rotation() { return before; }
std::span<const Row> rows_after_rotation() { return after; }

bool rest_is_of_stretches(const Verdicts& verdicts) {
  const auto rest = verdicts.of("rest"), equal = verdicts.of("stretches.nearly_equal");
  return rest && equal && equal->cause == causes::repeated_stretch &&
         (rest->cause == causes::refuses || rest->cause == causes::not_finite);
}

}  // namespace assay::check
