// SPDX-License-Identifier: BSD-3-Clause
// That the stress follows small changes of the deformation, and steps so short that their strain looks like none.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/specimen.hpp"
#include "harness/check/tests.hpp"
#include "harness/material/state_variable.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

/// The largest amplitude at which the material takes a loading at once; 0 where there is none.
double amplitude_at_once(const Specimen& specimen, double s) {
  constexpr double least = 1e-6;
  for (double amplitude = specimen.amplitude; amplitude > least; amplitude *= 0.5) {
    const Tensor F = specimen.space.turn(s) * specimen.space.stretch(amplitude, s);
    if (if_taken([&] { return stress_at_once(specimen, F), true; }, false)) return amplitude;
  }
  return 0;
}

}  // namespace

/// A change of F in its last digits changes the stress no more than that.
TestResult continuity(const Specimen& specimen) {
  constexpr double most = 1e-4, per_change = 1e3;
  const Space space = specimen.space;
  double worst = 0, at = 0;
  for (const double s : {0.11, 0.23, 0.37}) {
    const double amplitude = amplitude_at_once(specimen, s);
    if (amplitude == 0) continue;
    const Tensor F = space.turn(s) * space.stretch(amplitude, s);
    const Tensor expected = stress_at_once(specimen, F);
    const double scale = specimen.scale(size_of(expected));
    for (const double change : {1e-14, 1e-12, 1e-10, 1e-8}) {
      const double error = distance(stress_at_once(specimen, F + change * space.stretch(1, s)), expected) / scale;
      const double excess = error - per_change * change / amplitude;
      if (!(excess <= worst)) worst = std::isfinite(excess) ? excess : INFINITY, at = change;
    }
  }
  return judged(worst, most, "the stress follows F without jumps", causes::no_convergence,
                "a change of F by " + rounded(at) + " changes the stress by " + rounded(worst) +
                    " of itself: it is no continuous function of F");
}

namespace {

/// The end of a step to place s of a path; nothing where the material refuses it.
using Path = std::function<std::optional<Point>(double s)>;

/// A place where the stress changes by more than the path does.
struct Jump {
  double at = 0, size = 0;  ///< size [Pa]
  bool remembered = false;  ///< the state changes there, too
};

/// Each variable of the state relative to its own largest component.
bool state_jumps(const assay_material& table, const Point& before, const Point& after) {
  constexpr double least = 1e-6;
  const std::vector<StatePlace> places = state_of(table);
  return std::any_of(places.begin(), places.end(), [&](const StatePlace& place) {
    const Variable was = place.in(before.state), is = place.in(after.state);
    return is.distance(was) > least * std::max(was.largest(), is.largest());
  });
}

/// Halves an interval again and again, and keeps the half whose change is not that of the `slope` [Pa]; nothing where
/// the material refuses a step.
std::optional<Jump> narrowed(const assay_material& table, const Path& path, double s0, double s1, const Tensor& slope) {
  constexpr int halvings = 24;
  std::optional<Point> before = path(s0), after = path(s1);
  for (int k = 0; k < halvings && before && after; ++k) {
    const double middle = 0.5 * (s0 + s1);
    std::optional<Point> between = path(middle);
    if (!between) return std::nullopt;
    const Tensor expected = slope * (middle - s0);
    const bool left =
        distance(between->cauchy - before->cauchy, expected) > distance(after->cauchy - between->cauchy, expected);
    (left ? after : before) = std::move(between);
    (left ? s1 : s0) = middle;
  }
  if (!before || !after) return std::nullopt;
  return Jump{s0, distance(after->cauchy, before->cauchy), state_jumps(table, *before, *after)};
}

/// The largest jump of a path, looked for where the stress departs most from a smooth course.
Jump largest_jump(const Specimen& specimen, const Path& path, double& largest) {
  const int intervals = specimen.options.effort.quick ? 24 : 60;
  const std::size_t candidates = specimen.options.effort.quick ? 3 : 6;
  std::vector<std::optional<Tensor>> stress;
  for (int k = 0; k <= intervals; ++k) {
    const std::optional<Point> point = path(static_cast<double>(k) / intervals);
    stress.push_back(point ? std::optional(point->cauchy) : std::nullopt);
    if (point) largest = std::max(largest, size_of(point->cauchy));
  }
  struct Bend {
    double size, s;
    Tensor slope;
  };
  std::vector<Bend> bends;
  for (std::size_t k = 1; k + 2 < stress.size(); ++k) {
    if (!stress[k - 1] || !stress[k] || !stress[k + 1] || !stress[k + 2]) continue;
    const Tensor slope = 0.5 * intervals * (*stress[k] - *stress[k - 1] + *stress[k + 2] - *stress[k + 1]);
    bends.push_back(
        {distance(*stress[k + 1] - *stress[k], slope / intervals), static_cast<double>(k) / intervals, slope});
  }
  std::sort(bends.begin(), bends.end(), [](const Bend& a, const Bend& b) { return a.size > b.size; });
  bends.resize(std::min(bends.size(), candidates));
  Jump found;
  for (const Bend& bend : bends) {
    const auto jump = narrowed(specimen.material->table(), path, bend.s, bend.s + 1.0 / intervals, bend.slope);
    if (jump && !jump->remembered && jump->size > found.size) found = *jump;
  }
  return found;
}

}  // namespace

/// Along paths of single steps the stress jumps nowhere, unless the state does: a crack is remembered, a switch that
/// opens where the branches differ is not.
TestResult jumps(const Specimen& specimen) {
  constexpr double most = 1e-4;
  const Material& material = *specimen.material;
  const Space space = specimen.space;
  const auto path_from = [&](const Tensor& F0, const std::vector<double>& state0, double amplitude) {
    return Path([&material, space, F0, state0, amplitude](double s) {
      const auto step = [&] { return std::optional(stepped(material, 0, 1, F0, space.stretch(amplitude, s), state0)); };
      return if_taken(step, std::nullopt);
    });
  };
  double largest = specimen.least_stress();
  Jump worst;
  const auto look = [&](const Path& path) {
    const Jump jump = largest_jump(specimen, path, largest);
    if (jump.size > worst.size) worst = jump;
  };
  for (const double sign : {1.0, -1.0})
    look(path_from(Tensor::Identity(), specimen.rest_state(), sign * specimen.amplitude));
  constexpr double loaded = 0.3;
  const Loading there = stretch_to(specimen, loaded);
  const March found = from_rest(specimen, there, specimen.steps() / 2);
  look(path_from(there.F(1), found.marks[0].state, specimen.amplitude));
  const double share = worst.size / largest;
  return judged(share, most, "the stress has no jumps along paths of single steps", causes::jump,
                "the stress jumps by " + percent(share) +
                    " of its largest value when F changes in its last digits, and no state variable shows it");
}

namespace {

constexpr double usual = 1e-4, less_than_usual = 3e-5;  ///< strains of steps that every model takes
constexpr double smaller_strains[] = {1e-5, 1e-6, 1e-7, 1e-8};

/// A stretch of size one: a turn of the body would turn its stress, which hosts do in place of some models.
Tensor direction(const Space& space) {
  constexpr double small = 1e-3;
  const Tensor stretch = space.stretch(small, 0.3) - Tensor::Identity();
  const Tensor d = stretch + stretch.transpose();
  return d / stable_norm(d);
}

/// The stress that steps of a strain from the beginning of a sample make, over that strain.
class AnswerToStep {
 public:
  AnswerToStep(const Specimen& specimen, const Sample& sample)
      : material_(*specimen.material), s_(sample), d_(direction(specimen.space)), still_(after(0)) {}

  double to(double strain) const { return stable_norm(Tensor(after(strain) - still_)) / strain; }
  double stress() const { return stable_norm(still_); }

 private:
  Tensor after(double strain) const {
    return stepped(material_, s_.t, s_.dt, s_.F0, (Tensor::Identity() + strain * d_) * s_.F0, s_.state0).cauchy;
  }

  const Material& material_;
  const Sample& s_;
  Tensor d_, still_;
};

/// Simple shear whose numbers are powers of two: F F^-1 is the unit tensor to the last bit, and a step in which the
/// body is held has a strain of zero for whoever looks.
Tensor plain_shear(double gamma) {
  Tensor F = Tensor::Identity();
  F(0, 1) = gamma;
  return F;
}

/// The relaxation of a body that is held goes on as that of one that hardly moves.
std::optional<TestResult> rests_when_held(const Specimen& specimen) {
  constexpr double hardly = 1e-9, most = 1e-3;
  constexpr int steps = 8;
  const double gamma = std::exp2(std::floor(std::log2(0.5 * specimen.amplitude)));
  Point loaded;
  loaded.state = specimen.rest_state();
  for (int k = 0; k < steps; ++k) {
    loaded = stepped(specimen, 1.0 * k / steps, 1.0 / steps, plain_shear(gamma * k / steps),
                     plain_shear(gamma * (k + 1) / steps), loaded.state);
  }
  for (const double length : {1e-2, 1.0, 1e2, 1e4}) {  // [s]
    try {
      const auto after = [&](double strain) {
        return stepped(specimen, 1, length, plain_shear(gamma), plain_shear(gamma + strain), loaded.state).cauchy;
      };
      const Tensor held = after(0), moved = after(hardly);
      const double size = std::max(stable_norm(loaded.cauchy), specimen.least_stress());
      const double apart = stable_norm(Tensor(held - moved)) / size;
      if (apart <= most) continue;
      return failed(causes::drifts, apart, most,
                    "a body that does not move for " + rounded(length) +
                        " s has another stress than a body that is strained by " + rounded(hardly) +
                        " in this time, by " + percent(apart) +
                        " of the stress: the model skips steps without deformation");
    } catch (const MaterialFailure&) {  // of the length of a step
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<TestResult> short_steps(const Specimen& specimen) {
  if (specimen.rate_dependent()) {
    if (auto found = if_taken([&] { return rests_when_held(specimen); }, std::nullopt)) return found;
  }
  constexpr double share = 0.01, least_stiffness = 0.05, alike = 0.3;
  const double digits = is_of_single_precision(specimen) ? 1e-5 : 1e-10;
  for (const Sample& sample : samples_of(specimen)) {
    try {
      const AnswerToStep answer(specimen, sample);
      const double expected = answer.to(usual);
      const bool is_straight = std::abs(answer.to(less_than_usual) - expected) <= alike * expected;
      if (!(expected >= least_stiffness * specimen.modulus) || !is_straight) continue;
      for (const double strain : smaller_strains) {
        if (expected * strain < digits / share * answer.stress()) break;
        const double found = answer.to(strain);
        if (!(found < share * expected)) continue;
        return failed(causes::no_convergence, found / expected, share,
                      "a strain of " + rounded(strain) +
                          " in one step adds no stress to a loaded body, although a strain of " + rounded(usual) +
                          " does: the model skips small steps, so a slow loading adds no stress at all");
      }
    } catch (const MaterialFailure&) {  // of a step at once
    }
  }
  return std::nullopt;
}

}  // namespace assay::check
