// SPDX-License-Identifier: BSD-3-Clause
// Boxes of bodies in a tree: which pairs may meet, and which bodies may hold a point.
#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost's own headers include one
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "harness/motion/common_point.hpp"

namespace assay {

namespace {

using BoxCorner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using BodyBox = boost::geometry::model::box<BoxCorner>;

BoxCorner corner_at(const Vector3& X) { return {X.x(), X.y(), X.z()}; }

/// Wider by what the rounding of a place may shift it.
BodyBox box_around(const Revolution& r) {
  constexpr double wider = 1e-9, rounding = 1e-14;
  const Vector3 half = r.half_box();
  const Vector3 beyond = (1 + wider) * half + rounding * r.center.cwiseAbs();
  return {corner_at(r.center - beyond), corner_at(r.center + beyond)};
}

}  // namespace

struct BodyBoxes::Tree {
  boost::geometry::index::rtree<std::pair<BodyBox, std::size_t>, boost::geometry::index::rstar<8>> boxes;

  void find(const auto& place, const Visit& visit) const {
    boxes.query(boost::geometry::index::intersects(place),
                boost::make_function_output_iterator([&](const auto& found) { visit(found.second); }));
  }
};

BodyBoxes::BodyBoxes(std::span<const Revolution> bodies) {
  std::vector<std::pair<BodyBox, std::size_t>> boxes;
  for (const Revolution& body : bodies) boxes.emplace_back(box_around(body), boxes.size());
  tree_ = std::make_shared<const Tree>(Tree{{boxes.begin(), boxes.end()}});
}

void BodyBoxes::around(const Vector3& X, const Visit& visit) const {
  tree_->find(BodyBox{corner_at(X), corner_at(X)}, visit);
}

void BodyBoxes::meeting(const Revolution& body, const Visit& visit) const { tree_->find(box_around(body), visit); }

}  // namespace assay
