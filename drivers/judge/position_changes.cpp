// SPDX-License-Identifier: BSD-3-Clause
// What can be wrong with how positions and times are written down.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "drivers/judge/changes.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

void for_each_vector(JudgedRun& run, const auto& act) {
  for (JudgedFrame& frame : run.frames) {
    for (Vector3& X : frame.X) act(X, false);
    for (Vector3& x : frame.x) act(x, false);
    for (Vector3& v : frame.v) act(v, true);
  }
}

Change linear(const Tensor& T) {
  return [T](JudgedRun& run) {
    for_each_vector(run, [&](Vector3& x, bool) { x = T * x; });
    for (JudgedFrame& frame : run.frames) {
      for (Tensor& F : frame.F) F = T * F * T.transpose();
      for (Tensor& sigma : frame.sigma) sigma = T * sigma * T.transpose();
    }
  };
}

std::string times(double factor) { return rounded_text(factor, 4); }

struct LengthUnit {
  double factor;            ///< [m]
  const char *words, *key;  ///< of a map
};
constexpr std::array<LengthUnit, 5> length_units{
    {{1e-3, "mm", "mm"}, {1e-2, "cm", "cm"}, {1e-6, "um", "um"}, {0.0254, "inches", "in"}, {1e3, "km", "km"}}};

/// All vectors.
Candidate in_unit(const LengthUnit& unit) {
  return {"length_unit",
          std::string("lengths are in ") + unit.words + ", not in m: `units: {length: " + unit.key + "}`",
          [factor = unit.factor](JudgedRun& run) {
            for_each_vector(run, [&](Vector3& x, bool) { x *= factor; });
            run.rounding *= factor;
            for (JudgedFrame& frame : run.frames) {
              for (double& volume : frame.volume) volume *= factor * factor * factor;
            }
          }};
}

/// Lengths in another unit, of all vectors or of the present positions alone.
void add_units(std::vector<Candidate>& all) {
  for (const LengthUnit& unit : length_units) {
    all.push_back(in_unit(unit));
    all.push_back({"length_unit",
                   std::string("the positions are in ") + unit.words + ", and the reference positions in m",
                   [factor = unit.factor](JudgedRun& run) {
                     for (JudgedFrame& frame : run.frames) {
                       for (Vector3& x : frame.x) x *= factor;
                     }
                   }});
  }
}

void add_meanings(std::vector<Candidate>& all) {
  all.push_back({"displacement_for_position", "what is given as position x is the displacement u: `u:` instead of `x:`",
                 [](JudgedRun& run) {
                   for (JudgedFrame& frame : run.frames) {
                     for (std::size_t p = 0; p < frame.X.size(); ++p) frame.x[p] += frame.X[p];
                   }
                 }});
  all.push_back({"position_for_displacement", "what is given as displacement u is the position x: `x:` instead of `u:`",
                 [](JudgedRun& run) {
                   for (JudgedFrame& frame : run.frames) {
                     for (std::size_t p = 0; p < frame.X.size(); ++p) frame.x[p] -= frame.X[p];
                   }
                 }});
  all.push_back({"position_and_reference_exchanged", "x and X are exchanged", [](JudgedRun& run) {
                   for (JudgedFrame& frame : run.frames) {
                     if (!frame.X.empty()) frame.X = std::exchange(frame.x, frame.X);
                   }
                 }});
}

/// Of all vectors; and of x alone, where X comes from elsewhere.
void add_turned(std::vector<Candidate>& all, const std::string& cause, const std::string& sentence, const Tensor& T,
                bool has_X) {
  all.push_back({cause, sentence, linear(T)});
  if (!has_X) return;
  all.push_back({cause, sentence + ", in x alone: X is right", [T](JudgedRun& run) {
                   for (JudgedFrame& frame : run.frames) {
                     for (Vector3& x : frame.x) x = T * x;
                   }
                 }});
}

void add_axes(std::vector<Candidate>& all, int dimension, bool has_X) {
  const auto of = [](double a, double b, double c, double d) {
    Tensor T = Tensor::Identity();
    T(0, 0) = a, T(0, 1) = b, T(1, 0) = c, T(1, 1) = d;
    return T;
  };
  add_turned(all, "axes_mirrored", "the axes are mirrored: x points the other way", of(-1, 0, 0, 1), has_X);
  add_turned(all, "axes_mirrored", "the axes are mirrored: y points the other way", of(1, 0, 0, -1), has_X);
  add_turned(all, "axes_exchanged", "x and y are exchanged", of(0, 1, 1, 0), has_X);
  add_turned(all, "axes_turned", "the axes are turned by 90 degrees", of(0, 1, -1, 0), has_X);
  add_turned(all, "axes_turned", "the axes are turned by -90 degrees", of(0, -1, 1, 0), has_X);
  add_turned(all, "axes_turned", "the axes are turned by 180 degrees", of(-1, 0, 0, -1), has_X);
  if (dimension < 3) return;
  for (const auto& [sentence, order] :
       {std::pair{"the axes are exchanged: its x, y, z are y, z, x", std::array{2, 0, 1}},
        {"the axes are exchanged: its x, y, z are z, x, y", std::array{1, 2, 0}},
        {"y and z are exchanged", std::array{0, 2, 1}},
        {"x and z are exchanged", std::array{2, 1, 0}}}) {
    Tensor T = Tensor::Zero();
    for (int d = 0; d < 3; ++d) T(d, order[static_cast<std::size_t>(d)]) = 1;
    add_turned(all, "axes_exchanged", sentence, T, has_X);
  }
}

BodyPlace place_of(const Seeds& seeds) {
  Vector3 lower = Vector3::Constant(HUGE_VAL), upper = -lower;
  for (const Vector3& X : seeds.X) {
    if (X.allFinite()) lower = lower.cwiseMin(X), upper = upper.cwiseMax(X);
  }
  return {0.5 * (lower + upper), (upper - lower).maxCoeff()};
}

void add_origin(std::vector<Candidate>& all, const Seeds& seeds, const Vector3& centre, int dimension) {
  Vector3 shift = place_of(seeds).centre - centre;
  if (dimension == 2) shift.z() = 0;
  if (!(shift.norm() > 0.1 * seeds.spacing)) return;
  std::string words;
  for (int d = 0; d < dimension; ++d) words += (d > 0 ? ", " : "") + rounded_text(shift[d], 4);
  all.push_back({"origin_shifted",
                 "the origin is shifted: the centre of the body lies " + words + " m from that of the scene",
                 [shift](JudgedRun& run) {
                   for_each_vector(run, [&](Vector3& x, bool is_rate) {
                     if (!is_rate) x -= shift;
                   });
                 }});
}

Change clock(double scale, double offset) {
  return [scale, offset](JudgedRun& run) {
    for (JudgedFrame& frame : run.frames) {
      frame.t = std::max(scale * frame.t + offset, 0.0);
      frame.t_velocity = std::max(scale * frame.t_velocity + offset, 0.0);
    }
  };
}

/// interval: between frames of the whole run [s].
void add_clock(std::vector<Candidate>& all, const JudgedState& now, double interval, ExactParticles& exact) {
  const double period = exact.solution().motion()->period();
  const auto error_by = [&](double scale, double offset) {
    JudgedRun changed = now.run;
    clock(scale, offset)(changed);
    const bool from_positions = now.run.map.seeds.empty() && now.run.frames.front().X.empty();
    return position_error(changed, from_positions ? seeds_of(changed, exact) : now.seeds, now.pairing, exact)
        .relative();
  };
  for (const auto& [factor, unit] : {std::pair{1e-3, "ms"}, {1e-6, "us"}, {60.0, "minutes"}}) {
    all.push_back({"time_unit", std::string("times are in ") + unit + ", not in s", clock(factor, 0)});
    all.push_back({"time_unit", std::string("times are in s, not in ") + unit, clock(1 / factor, 0)});
  }
  if (only_at_rest(now.run, 0.5 * period)) return;  // where any time is as good as another
  const double reach = std::min(std::max(2.2 * interval, 0.1 * period), 0.5 * period);
  const double offset = least_place(-reach, reach, [&](double t) { return error_by(1, t); });
  std::string in_frames;
  if (interval > 0 && std::abs(std::abs(offset) / interval - 1) < 0.03)
    in_frames = ", the interval of the frames: one is too many or missing at the beginning";
  all.push_back({clock_offset,
                 "times are " + times(std::abs(offset)) + " s too " + (offset < 0 ? "late" : "early") + in_frames,
                 clock(1, offset), false, offset});
  const double scale = least_place(0.5, 2, [&](double factor) { return error_by(factor, 0); });
  all.push_back({clock_rate,
                 "the clock is " + times(100 * std::abs(1 / scale - 1)) + " % too " + (scale < 1 ? "fast" : "slow") +
                     ": times are to be multiplied by " + times(scale),
                 clock(scale, 0), false, scale - 1});
}

/// spacing: of all particles [m].
void add_identities(std::vector<Candidate>& all, const JudgedState& now, double spacing) {
  constexpr double of_another = 0.5;  // of the spacing: no particle is taken for its neighbour
  if (now.pairing == Pairing::nearest || now.error.worst < of_another * spacing) return;
  all.push_back({"identities_lost",
                 "ids or reference positions are not those of the same particle in all frames: positions fit if "
                 "each particle is taken for the nearest one",
                 [](JudgedRun& run) {
                   for (std::size_t k = 0; k < run.frames.size(); ++k) {
                     run.frames[k].id.clear();
                     if (k > 0) run.frames[k].X.clear();
                   }
                 },
                 true});
}

}  // namespace

std::string size_words(const Seeds& seeds, const BodyPlace& body) {
  constexpr double other = 5;  // a ring alone, of a square around it, is a part of it
  const double ratio = place_of(seeds).size / body.size;
  if (!std::isfinite(ratio) || (ratio < other && ratio * other > 1)) return {};
  return "the body is " + rounded_text(ratio, 3) + " times as large as that of the scene: is the unit of length right?";
}

std::optional<Candidate> unit_by_size(const Seeds& seeds, const BodyPlace& body) {
  constexpr double alike = 4, near = 2;  // bodies may be wider than what moves of them
  const double ratio = place_of(seeds).size / body.size;
  if (!(body.size > 0) || !std::isfinite(ratio) || (ratio < alike && ratio * alike > 1)) return std::nullopt;
  const auto off = [&](const LengthUnit& unit) { return std::abs(std::log(ratio * unit.factor)); };
  const LengthUnit& unit = *std::ranges::min_element(length_units, {}, off);
  if (!(off(unit) < std::log(near))) return std::nullopt;
  Candidate candidate = in_unit(unit);
  candidate.sentence += "; as they are, the body is " + rounded_text(ratio, 3) + " times as large as that of the scene";
  return candidate;
}

std::vector<Candidate> position_changes(const JudgedState& now, const Seeds& seeds, const BodyPlace& body,
                                        double interval, ExactParticles& exact, const Causes& left_out) {
  std::vector<Candidate> all;
  const bool has_X = !now.run.map.seeds.empty() || !now.run.frames.front().X.empty();
  add_units(all), add_meanings(all), add_axes(all, exact.dimension(), has_X), add_identities(all, now, seeds.spacing);
  add_origin(all, seeds, body.centre, exact.dimension());
  add_clock(all, now, interval, exact);
  std::erase_if(all, [&](const Candidate& each) { return std::ranges::find(left_out, each.cause) != left_out.end(); });
  return all;
}

}  // namespace assay::drivers
