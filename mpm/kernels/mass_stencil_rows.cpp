// SPDX-License-Identifier: BSD-3-Clause
// The rows of a mass matrix in space: one for all nodes inside the body, and some of their own.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mpm/kernels/mass_stencil.hpp"

namespace assay::mpm {

/// Which nodes are inside the body, where all rows are alike: what they give and what is around them follows from their
/// sums, first and second moments, which are those of one that has the median of the sums.
template <int Dim>
std::vector<bool> MassStencil<Dim>::nodes_inside(const GridGeometry<Dim>& grid, const Multiply& multiply,
                                                 std::size_t& middle_node, std::vector<bool>& has_mass) const {
  constexpr double same_sum = 64 * std::numeric_limits<double>::epsilon();
  GridField<Dim> x, first, second;
  for (auto* field : {&x, &first, &second}) field->allocate(nodes_);
  const auto places = [&](std::size_t i) {
    std::array<double, Dim> at;
    for (std::size_t d = 0; d < Dim; ++d) {
      at[d] = static_cast<double>(i % static_cast<std::size_t>(grid.count[d])) - 0.5 * grid.count[d];
      i /= static_cast<std::size_t>(grid.count[d]);
    }
    return at;
  };
  const auto fill = [&](const auto& of) {
    for (std::size_t i = 0; i < nodes_; ++i) {
      const std::array<double, 3> values = of(places(i));
      std::copy_n(values.begin(), Dim, x.node(i));
    }
  };
  fill([](const auto& at) {
    return std::array{1.0, at[0] + 0.7 * at[1] + 0.4 * at[Dim - 1], at[1] - 0.6 * at[Dim - 1]};
  });
  multiply(x, first);
  fill([](const auto& at) { return std::array{at[0] * at[0], at[1] * at[1], at[Dim - 1] * at[Dim - 1]}; });
  multiply(x, second);
  std::vector<std::size_t> with_mass;
  has_mass.assign(nodes_, false);
  for (std::size_t i = 0; i < nodes_; ++i) {
    has_mass[i] = first.node(i)[0] != 0;
    if (has_mass[i]) with_mass.push_back(i);
  }
  std::vector<bool> inside(nodes_, false);
  if (with_mass.empty()) return inside;
  const auto median = with_mass.begin() + static_cast<std::ptrdiff_t>(with_mass.size() / 2);
  std::nth_element(with_mass.begin(), median, with_mass.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(first.node(a)[0], a) < std::pair(first.node(b)[0], b);
  });
  middle_node = *median;
  /// Sum, first and second moments about the node itself.
  const auto moments = [&](std::size_t i) {
    const auto at = places(i);
    const double *f = first.node(i), *s = second.node(i), sum = f[0];
    const double along = (f[1] - (at[0] + 0.7 * at[1] + 0.4 * at[Dim - 1]) * sum) / sum;
    const double across = (f[2] - (at[1] - 0.6 * at[Dim - 1]) * sum) / sum;
    double spread = 0;
    for (std::size_t d = 0; d < Dim; ++d) spread += (1 + 0.1 * static_cast<double>(d)) * (s[d] / sum - at[d] * at[d]);
    return std::array{sum, along, across, spread};
  };
  const auto of_middle = moments(middle_node);
  const double cells = farthest_;  // of which rounding is amplified in moments
  for (const std::size_t i : with_mass) {
    const auto own = moments(i);
    bool same = std::abs(own[0] - of_middle[0]) <= same_sum * cells * of_middle[0];
    for (std::size_t k = 1; k < own.size(); ++k) same &= std::abs(own[k] - of_middle[k]) <= same_sum * cells * cells;
    inside[i] = same;
  }
  return inside;
}

/// Particle by particle, for the nodes alone whose rows are not those of the middle.
template <int Dim>
void MassStencil<Dim>::find_rows(const GridGeometry<Dim>& grid, const Multiply& multiply, const AddRows& add_rows) {
  alike_.assign(offsets_.size(), 0.0);
  std::size_t middle_node = 0;
  std::vector<bool> has_mass;
  const std::vector<bool> inside = nodes_inside(grid, multiply, middle_node, has_mass);
  const auto reach = static_cast<std::size_t>(offsets_.back());
  for (std::size_t i = 0; i < nodes_; ++i) {
    if (!has_mass[i]) continue;
    const bool at_end = i < reach + rows_at_once<Dim> || nodes_ < i + reach + rows_at_once<Dim>;
    kinds_[i] = at_end ? Kind::at_end : inside[i] ? Kind::alike : Kind::own;
    own_[i] = kinds_[i] != Kind::alike || i == middle_node ? 1 : 0;
  }
  make_room();
  if (values_.empty()) return;
  add_rows(rows());
  for (std::size_t k = 0; k < alike_.size(); ++k) alike_[k] = value_of_own(k, middle_node);
}

template void MassStencil<ASSAY_DIMENSION>::find_rows(const GridGeometry<ASSAY_DIMENSION>&, const Multiply&,
                                                      const AddRows&);

}  // namespace assay::mpm
