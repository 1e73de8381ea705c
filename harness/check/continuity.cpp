// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/continuity.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// Stress after one step from rest.
Tensor stress_at_once(const Specimen& specimen, const Tensor& F) {
  return stepped(*specimen.material, 0, 1, Tensor::Identity(), F, specimen.rest_state()).cauchy;
}

/// The largest amplitude at which the material takes a loading at once; 0 where there is none.
double amplitude_at_once(const Specimen& specimen, double s) {
  constexpr double least = 1e-6;
  for (double amplitude = specimen.amplitude; amplitude > least; amplitude *= 0.5) {
    try {
      stress_at_once(specimen, specimen.space.turn(s) * specimen.space.stretch(amplitude, s));
      return amplitude;
    } catch (const MaterialFailure&) {
    }
  }
  return 0;
}

}  // namespace

TestResult continuity(const Specimen& specimen) {
  constexpr double most = 1e-4, per_change = 1e3;
  TestResult result{.id = "continuity", .threshold = most};
  const Space space = specimen.space;
  double worst = 0, at = 0;
  for (const double s : {0.11, 0.23, 0.37}) {
    const double amplitude = amplitude_at_once(specimen, s);
    if (amplitude == 0) continue;
    const Tensor F = space.turn(s) * space.stretch(amplitude, s);
    const Tensor expected = stress_at_once(specimen, F);
    const double scale = std::max(expected.cwiseAbs().maxCoeff(), specimen.least_stress());
    for (const double change : {1e-14, 1e-12, 1e-10, 1e-8}) {
      const double error = distance(stress_at_once(specimen, F + change * space.stretch(1, s)), expected) / scale;
      const double excess = error - per_change * change / amplitude;
      if (!(excess <= worst)) worst = std::isfinite(excess) ? excess : INFINITY, at = change;
    }
  }
  result.measure = worst;
  result.verdict = worst <= most ? Verdict::pass : Verdict::fail;
  if (result.verdict == Verdict::fail) result.cause = causes::no_convergence;
  result.sentence = worst <= most ? "the stress follows F without jumps"
                                  : "a change of F by " + rounded(at) + " changes the stress by " + rounded(worst) +
                                        " of itself: it is no continuous function of F";
  return result;
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
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    double change = 0, largest = 0;
    for (const std::size_t end = at + static_cast<std::size_t>(components_of_kind(table.state[v].kind)); at < end;
         ++at) {
      change = std::max(change, std::abs(after.state[at] - before.state[at]));
      largest = std::max({largest, std::abs(before.state[at]), std::abs(after.state[at])});
    }
    if (change > least * largest) return true;
  }
  return false;
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
    if (point) largest = std::max(largest, point->cauchy.cwiseAbs().maxCoeff());
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

TestResult jumps(const Specimen& specimen) {
  constexpr double most = 1e-4;
  const Material& material = *specimen.material;
  const Space space = specimen.space;
  const auto path_from = [&](const Tensor& F0, const std::vector<double>& state0, double amplitude) {
    return Path([&material, space, F0, state0, amplitude](double s) -> std::optional<Point> {
      try {
        return stepped(material, 0, 1, F0, space.stretch(amplitude, s), state0);
      } catch (const MaterialFailure&) {
        return std::nullopt;
      }
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
  const Loading there{[&](double t) { return space.stretch(specimen.amplitude, loaded * t); }, 1};
  const March found = march(material, there, {.steps = specimen.steps() / 2, .state = specimen.rest_state()});
  look(path_from(there.F(1), found.marks[0].state, specimen.amplitude));
  TestResult result{.id = "jumps", .measure = worst.size / largest, .threshold = most};
  result.sentence = "the stress has no jumps along paths of single steps";
  if (*result.measure <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::jump;
  result.sentence = "the stress jumps by " + percent(*result.measure) +
                    " of its largest value when F changes in its last digits, and no state variable shows it";
  return result;
}

}  // namespace assay::check
