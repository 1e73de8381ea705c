// SPDX-License-Identifier: BSD-3-Clause
// Why a material cannot be loaded at all, how far and in which steps it can, and what the tests have not seen of it.
#include <algorithm>
#include <iterator>
#include <system_error>

#include "harness/check/tests.hpp"
#include "harness/material/offer.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::check {

namespace {

/// The steps by which a failure is told from its likes.
class Trials {
 public:
  Trials(const Material& material, const MaterialFailure& failure) : material_(material), failure_(failure) {}

  /// The same step, asked for again, also of an instance of its own.
  bool again() const {
    return failure_.step && (takes(material_, *failure_.step) || takes(material_.clone(), *failure_.step));
  }
  /// The same step, over other numbers in the memory that `Over` fills.
  template <class Over>
  bool over_others() const {
    return std::any_of(std::begin(unset_bytes), std::end(unset_bytes), [&](unsigned char byte) {
      const Over memory(byte);
      return failure_.step && takes(material_, *failure_.step);
    });
  }
  bool undeformed() const { return stands(Tensor::Identity(), Tensor::Identity()); }
  /// A body that is strained in general, and does not move.
  bool held() const {
    const Tensor F = Space(material_).stretch(1e-3, 0.2);
    return stands(F, F);
  }
  /// Along the axes of the frame.
  bool stretches(double a, double b, double c) const {
    return stands(Tensor::Identity(), Vector3(1 + a, 1 + b, 1 + c).asDiagonal());
  }
  bool only_different_stretches() const {
    if (general_strains() && !turned(1e-3, 1e-3, -1e-3)) return true;
    return !(stretches(1e-3, 1e-3, -1e-3) && stretches(1e-3, 1e-3, 1e-3)) && stretches(1e-3, 3e-4, -1e-3);
  }
  bool turned(double a, double b, double c) const {
    const Tensor stretches = Vector3(1 + a, 1 + b, 1 + c).asDiagonal();
    return stands(Tensor::Identity(), rotated(Space(material_).turn(0.7), stretches));
  }
  /// Stretches that differ, along axes of their own.
  bool general_strains() const {
    return stands(Space(material_).stretch(1e-3, 0.2), Space(material_).stretch(1e-3, 0.21)) &&
           stands(Space(material_).stretch(-1e-3, 0.2), Space(material_).stretch(-1e-3, 0.21));
  }

 private:
  bool stands(const Tensor& F0, const Tensor& F1) const {
    try {
      stepped(material_, 0, failure_.step ? failure_.step->dt : 1, F0, F1, state_at_rest(material_, 0));
      return true;
    } catch (const std::runtime_error&) {
      return false;
    }
  }

  const Material& material_;
  const MaterialFailure& failure_;
};

TestResult not_loaded_by(const std::string& cause, const std::string& sentence) {
  return {.id = ids::loading, .verdict = Verdict::fail, .cause = cause, .sentence = sentence};
}

/// Whether a body that was strained is under stress after one step more, in which it is held.
bool stress_comes_late(const Material& material) {
  constexpr double strain = 1e-3, length = 1e-2;  // of steps [s]
  Tensor F;
  F << 1 + strain, strain, 0, 0, 1 - 0.3 * strain, 0, 0, 0, 1;
  const auto comes_late = [&] {
    const Tensor I = Tensor::Identity();
    const Point moved = stepped(material, 0, length, I, F, state_at_rest(material, 0, Vector3::UnitX()));
    return moved.cauchy.isZero(0) && !hold(material, length, length, F, moved).cauchy.isZero(0);
  };
  return if_taken(comes_late, false);
}

}  // namespace

TestResult refused(const std::string& id, const char* cause, const MaterialFailure& failure) {
  const std::string words = failure.what();
  TestResult result{.id = id, .verdict = Verdict::fail, .step = failure.step};
  result.cause = cause_of_refusal(words, failure.not_finite);
  result.refused = result.cause == causes::refuses && !failure.final;
  if (cause && (result.cause == causes::refuses || result.cause == causes::not_finite)) result.cause = cause;
  const std::string what = failure.not_finite || result.cause == causes::ends_process ? words
                           : words.empty() ? "the model refuses a step without a message"
                                           : "the model refuses a step: " + words;
  result.sentence = what + (id == ids::loading ? "" : ", in the test " + id);
  return result;
}

TestResult not_loaded(const Material& material, const std::runtime_error& error) {
  const auto* failure = dynamic_cast<const MaterialFailure*>(&error);
  const auto* beginning = dynamic_cast<const CannotBegin*>(&error);
  const auto* of_system = dynamic_cast<const std::system_error*>(&error);
  if (of_system && of_system->code() == std::errc::invalid_argument)
    return not_loaded_by(causes::disturbs_process,
                         "after its calls no thread can be started: " + of_system->code().message());
  if (!failure || beginning) {
    return not_loaded_by(cause_of_refusal(beginning ? beginning->reason : "", false), error.what());
  }
  TestResult plain = refused(ids::loading, nullptr, *failure);
  if (failure->final || (plain.cause != causes::refuses && plain.cause != causes::not_finite)) return plain;
  const Trials trials(material, *failure);
  if (trials.again()) {
    plain.cause = causes::hidden_state;
    plain.sentence += "; when the same step is repeated, it takes it: data is kept outside the state, or is never set";
  } else if (trials.over_others<OverStack>()) {
    plain.cause = causes::hidden_state, plain.refused = false;
    plain.sentence += "; if the stack holds other numbers, it takes it: a local variable is read before it is set";
  } else if (trials.over_others<OverHeap>()) {
    plain.cause = causes::hidden_state, plain.refused = false;
    plain.sentence += "; if allocated memory holds other numbers, it takes it: an array is read before it is set";
  } else if (trials.general_strains() && !trials.held()) {
    plain.sentence += "; in a step in which a strained body does not move, too";
  } else if (trials.only_different_stretches()) {
    plain = refused(ids::loading, causes::repeated_stretch, *failure);
    plain.sentence += ": if principal stretches are equal, and only then";
  } else if (!trials.undeformed()) {
    plain.sentence += "; in a step without deformation, too";
  } else if (trials.general_strains()) {
    plain.sentence += "; but not in general strains, which have no zero component";
  }
  return plain;
}

TestResult not_finite_beyond(const MaterialFailure& failure) {
  TestResult result = refused(ids::loading, nullptr, failure);
  result.sentence += ": as soon as the stress leaves the linear range";
  return result;
}

TestResult without_stress(const Material& material) {
  return not_loaded_by(causes::no_stress,
                       stress_comes_late(material)
                           ? "a strain gives no stress in its own step, but in the next step, in which the body is "
                             "held: the stress is that of the beginning of a step (DFGRD0 for DFGRD1, STRAN without "
                             "DSTRAN)"
                           : "no small strain from rest makes any stress, under any pressure that was tried");
}

namespace {

constexpr double reached = 0.999;  ///< of a strain that was asked for

bool has_reached(const Specimen& specimen) { return specimen.amplitude >= reached * specimen.options.effort.strain; }

/// Whether the material answers in a straight line as far as the tests go.
bool stays_linear(const Specimen& specimen) { return specimen.linear && specimen.onset >= 0.5 * specimen.amplitude; }

/// Whether what is refused is the size of an increment of strain, and not the strain.
bool takes_shorter_increments(const Specimen& specimen) {
  constexpr int shorter = 16;
  if (!specimen.refusal) return false;
  Specimen farther = specimen;
  farther.amplitude = 2 * specimen.amplitude;
  return if_taken([&] { return from_rest(specimen, out_and_back(farther), shorter * specimen.steps()), true; }, false);
}

/// Of the stress of a small step from rest.
bool is_no_number_unpressed(const Material& material) {
  constexpr double small = 1e-6;
  const Tensor I = Tensor::Identity();
  try {
    stepped(material, 0, 1, I, Space(material).stretch(small, 1), state_at_rest(material, 0));
  } catch (const MaterialFailure& failure) {
    return failure.not_finite;
  }
  return false;
}

}  // namespace

std::vector<std::string> not_tested(const Specimen& specimen) {
  std::vector<std::string> all;
  if (specimen.material->table().parameter_count > 0 && !Offer<assay_closed_form>(specimen)) {
    all.emplace_back("whether the values of the parameters are right (there is no reference)");
  }
  const char* why = takes_shorter_increments(specimen) ? " (it takes them only in shorter increments)"
                    : specimen.refusal                 ? " (it refuses them)"
                                       : " (that is far beyond the linear range; --strain asks for more)";
  if (!has_reached(specimen)) all.push_back("strains above " + rounded(specimen.amplitude) + why);
  if (specimen.material->has(ASSAY_NON_SMOOTH) && stays_linear(specimen)) {
    all.emplace_back(
        "a threshold such as first yield (a kink is declared, and the stress grows almost linearly over the first half "
        "of the strains)");
  }
  if (specimen.pressure > 0 && !specimen.options.effort.pressure && is_no_number_unpressed(specimen))
    all.emplace_back("a body without pressure, as at the start of a run (its stress is not a number)");
  if (specimen.space.is_plane()) all.emplace_back("shears out of the plane");
  if (specimen.options.effort.step != 1) all.push_back("steps above " + rounded(specimen.options.effort.step) + " s");
  return all;
}

std::optional<TestResult> not_reached(const Specimen& specimen) {
  if (specimen.refusal && cause_of_refusal(specimen.refusal->what(), false) == causes::missing_routine) {
    return refused("loading", nullptr, *specimen.refusal);
  }
  const double asked = specimen.options.effort.strain;
  if (!specimen.options.effort.strain_is_asked && takes_shorter_increments(specimen)) return std::nullopt;
  const bool kink = specimen.refusal && specimen.material->has(ASSAY_NON_SMOOTH) && stays_linear(specimen);
  if (!kink && (has_reached(specimen) || !specimen.options.effort.strain_is_asked)) return std::nullopt;
  TestResult result = not_loaded_by("", "");
  if (specimen.refusal) result = refused("loading", nullptr, *specimen.refusal);
  result.refused = false;  // at smaller strains it is the same
  result.cause = kink ? causes::refuses : causes::not_reached;
  const std::string far = rounded(specimen.amplitude);
  const std::string words = specimen.refusal ? result.sentence + ". " : "";
  result.sentence = kink ? words + "It refuses every step beyond the linear range, up to a strain of " + far +
                               "; a kink is declared (non_smooth), and cannot be tested"
                         : words + "The requested strain is " + rounded(asked) + "; the model reaches " + far +
                               (takes_shorter_increments(specimen) ? ", and more only in shorter increments" : "");
  return result;
}

std::optional<double> own_pace(const Material& material, const Report& report) {
  constexpr double shortest = 1e-12, longest = 1e-3;  // [s]; the usual tests resolve what takes more
  constexpr double alike = 0.02, usual_strain = 0.01;
  constexpr double per_length = 250;  // what decays as exp(-t / T) has lost `alike` in T / 25: steps of T to 10 T
  if (!material.has(ASSAY_RATE_DEPENDENT)) return std::nullopt;
  const Tensor I = Tensor::Identity();
  const Tensor strained = Space(material).stretch(report.strain > 0 ? report.strain : usual_strain, 1);
  const auto stress_of_step = [&](double length) {
    return stepped(material, 0, length, I, strained, state_at_rest(material, report.pressure)).cauchy;
  };
  const auto pace = [&]() -> std::optional<double> {
    const Tensor sudden = stress_of_step(shortest);
    const double size = largest_of(sudden);
    double same = 0;
    for (double length = 10 * shortest; length < 2 * longest; length *= 10) {
      const Tensor stress = stress_of_step(length);
      const bool differs = !(distance(stress, sudden) <= alike * size);
      if (differs && same > 0 && largest_of(stress) < size) return per_length * same;  // it has relaxed
      if (differs) return std::nullopt;
      same = length;
    }
    return std::nullopt;
  };
  return if_taken(pace, std::nullopt);  // a refusal says nothing of time
}

}  // namespace assay::check
