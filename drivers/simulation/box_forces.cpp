// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/box_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

struct BoxAround {
  Vector3 middle, half;  ///< [m]
  Vector3 parts;         ///< whole numbers, into which each direction is divided to be small against the motion

  /// A box in the plane is 1 m thick, and nothing changes across it.
  BoxAround(const ReferencePoint& point, bool in_space, double length)
      : middle(point.X, point.Y, in_space ? point.Z : 0), half(point.HX, point.HY, in_space ? point.HZ : 0.5) {
    constexpr double small = 1.0 / 16;  // of the length: two Gauss points along it leave some 1e-4 of the largest b
    parts = (half / (small * length)).array().ceil().max(1.0);
    if (!in_space) parts.z() = 1;
  }
};

}  // namespace

void require_boxes(const Motion& motion, const std::vector<ReferencePoint>& points, bool in_space,
                   const std::string& file) {
  constexpr double least = 1e-6;      // of the motion's length, and of the place: b is a difference
  constexpr double most_parts = 4e4;  // of a box
  constexpr double most = 1e50;       // whose cube is a number [m]
  const double length = motion->length();
  for (const ReferencePoint& point : points) {
    const BoxAround box(point, in_space, length);
    const double bound = least * std::max(std::isinf(length) ? 0 : length, box.middle.cwiseAbs().maxCoeff());
    const double smallest = (in_space ? box.half : Vector3(point.HX, point.HY, point.HX)).minCoeff();
    const auto refuse_if = [&](bool fault, const std::string& what) {
      if (fault) throw InputError({file, point.line, 1}, "HX", what);
    };
    refuse_if(smallest < bound, "half edges must be at least " + rounded_text(bound, 2) +
                                    " m here, for b is a difference of what acts on two faces, found " +
                                    rounded_text(smallest, 3));
    refuse_if(box.parts.prod() > most_parts,
              "the box is too large for a mean: divide it into boxes whose half edges are not many times " +
                  rounded_text(length, 3) + " m, over which the motion changes");
    refuse_if(box.half.maxCoeff() > most, "half edges must be at most " + rounded_text(most, 2) + " m");
  }
}

std::vector<BoxForce> box_forces(const ExactSolution& exact, double density, const std::vector<ReferencePoint>& points,
                                 bool in_space, bool quasi_static) {
  constexpr std::size_t at_once = 50'000;  // parts of boxes
  std::map<double, std::vector<std::size_t>> by_time;
  for (std::size_t i = 0; i < points.size(); ++i) by_time[points[i].t].push_back(i);
  std::vector<BoxForce> found(points.size());
  for (const auto& [t, some] : by_time) {
    const auto slice = exact.slice(t);
    std::vector<std::array<Vector3, 8>> boxes;
    std::vector<std::size_t> owners;
    const auto add_up = [&] {
      const HexahedronAverage average(Hexahedra(boxes), density, {.quasi_static = quasi_static});
      const auto forces = average.at(*slice);
      for (std::size_t k = 0; k < owners.size(); ++k) {
        BoxForce& whole = found[owners[k]];
        whole.acts.b += average.volume(k) * forces[k].b;
        whole.acts.moment += forces[k].moment;
        whole.volume += average.volume(k);
      }
      boxes.clear(), owners.clear();
      stop_if_interrupted();
    };
    for (const std::size_t i : some) {
      const BoxAround box(points[i], in_space, exact.motion()->length());
      const Vector3 part = box.half.cwiseQuotient(box.parts);
      for (int z = 0; z < box.parts.z(); ++z) {
        for (int y = 0; y < box.parts.y(); ++y) {
          for (int x = 0; x < box.parts.x(); ++x) {
            const Vector3 at = box.middle - box.half + part.cwiseProduct(Vector3(2 * x + 1, 2 * y + 1, 2 * z + 1));
            boxes.push_back(boxes_around(std::array{at}, part).front());
            owners.push_back(i);
          }
        }
      }
      if (boxes.size() >= at_once) add_up();
    }
    if (!boxes.empty()) add_up();
    for (const std::size_t i : some) found[i].acts.b /= found[i].volume;
  }
  return found;
}

}  // namespace assay::drivers
