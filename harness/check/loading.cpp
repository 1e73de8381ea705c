// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/loading.hpp"

#include <string>
#include <system_error>

#include "harness/check/specimen.hpp"

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

/// Whether a body that was strained is under stress after one step more, in which it is held.
bool stress_comes_late(const Material& material) {
  constexpr double strain = 1e-3, length = 1e-2;  // of steps [s]
  Tensor F;
  F << 1 + strain, strain, 0, 0, 1 - 0.3 * strain, 0, 0, 0, 1;
  try {
    const Tensor I = Tensor::Identity();
    const Point moved = stepped(material, 0, length, I, F, state_at_rest(material, 0, Vector3::UnitX()));
    const Point held = stepped(material, length, length, F, F, moved.state);
    return moved.cauchy.isZero(0) && !held.cauchy.isZero(0);
  } catch (const MaterialFailure&) {
    return false;
  }
}

}  // namespace

TestResult refused(const std::string& id, const char* cause, const MaterialFailure& failure) {
  TestResult result{.id = id, .verdict = Verdict::fail, .step = failure.step};
  const std::string words = failure.what();
  result.cause = cause_of_refusal(words, failure.not_finite);
  result.refused = result.cause == causes::refuses && !failure.final;
  if (cause && (result.cause == causes::refuses || result.cause == causes::not_finite)) result.cause = cause;
  const std::string what = failure.not_finite || result.cause == causes::ends_process ? words
                           : words.empty() ? "the model refuses a step without a message"
                                           : "the model refuses a step: " + words;
  result.sentence = what + (id == "loading" ? "" : ", in the test " + id);
  return result;
}

TestResult not_loaded(const Material& material, const std::runtime_error& error) {
  const auto* failure = dynamic_cast<const MaterialFailure*>(&error);
  const auto* beginning = dynamic_cast<const CannotBegin*>(&error);
  const auto* of_system = dynamic_cast<const std::system_error*>(&error);
  if (of_system && of_system->code() == std::errc::invalid_argument)
    return {.id = "loading",
            .verdict = Verdict::fail,
            .cause = causes::disturbs_process,
            .sentence = "after its calls no thread can be started: " + of_system->code().message()};
  if (!failure || beginning) {
    const std::string cause = cause_of_refusal(beginning ? beginning->reason : "", false);
    return {.id = "loading", .verdict = Verdict::fail, .cause = cause, .sentence = error.what()};
  }
  TestResult plain = refused("loading", nullptr, *failure);
  if (failure->final || (plain.cause != causes::refuses && plain.cause != causes::not_finite)) return plain;
  const Trials trials(material, *failure);
  if (trials.again()) {
    plain.cause = causes::hidden_state;
    plain.sentence += "; when the same step is repeated, it takes it: data is kept outside the state, or is never set";
  } else if (trials.general_strains() && !trials.held()) {
    plain.sentence += "; in a step in which a strained body does not move, too";
  } else if (trials.only_different_stretches()) {
    plain = refused("loading", causes::repeated_stretch, *failure);
    plain.sentence += ": if principal stretches are equal, and only then";
  } else if (!trials.undeformed()) {
    plain.sentence += "; in a step without deformation, too";
  } else if (trials.general_strains()) {
    plain.sentence += "; but not in general strains, which have no zero component";
  }
  return plain;
}

TestResult not_finite_beyond(const MaterialFailure& failure) {
  TestResult result = refused("loading", nullptr, failure);
  result.sentence += ": as soon as the stress leaves the linear range";
  return result;
}

TestResult without_stress(const Material& material) {
  TestResult result{.id = "loading", .verdict = Verdict::fail, .cause = causes::no_stress};
  result.sentence = stress_comes_late(material)
                        ? "a strain gives no stress in its own step, but in the next step, in which the body is held: "
                          "the stress is that of the beginning of a step (DFGRD0 for DFGRD1, STRAN without DSTRAN)"
                        : "no small strain from rest makes any stress, under any pressure that was tried";
  return result;
}

}  // namespace assay::check
