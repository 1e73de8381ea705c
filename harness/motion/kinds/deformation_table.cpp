// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/deformation_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "harness/motion/registry.hpp"

namespace assay {

namespace {

constexpr int looks = 32;             ///< between two rows
constexpr double least_share = 0.25;  ///< of its own path's smallest det F that the family may reach
constexpr int fractions = 16;         ///< of xi between the family's ends at which that is looked at
constexpr int halvings = 40;
constexpr double rounding = 1e-12;  ///< of a component's largest value

struct Rows {
  std::vector<double> times;
  std::vector<Tensor> F;
  Interpolation interpolation = Interpolation::monotone;

  Path baseline() const {
    if (times.size() < 2 || F.size() != times.size() || interpolation > Interpolation::spline)
      throw std::runtime_error("no table");
    return DeformationTable("", times, F, interpolation).baseline();
  }
};

void fields(auto& archive, Rows& rows) { archive(rows.times, rows.F, rows.interpolation); }

}  // namespace

DeformationTable::DeformationTable(std::string source)
    : DeformationTable(std::move(source), std::array{0.0, 1.0},
                       std::array<Tensor, 2>{Tensor::Identity(), Tensor::Identity()}, Interpolation::monotone) {}

DeformationTable::DeformationTable(std::string source, std::span<const double> times, std::span<const Tensor> F,
                                   Interpolation interpolation)
    : source_(std::move(source)), times_(times.begin(), times.end()), interpolation_(interpolation) {
  for (int c = 0; c < 9; ++c) {
    std::vector<double> values;
    for (const Tensor& row : F) values.push_back(component(row, c));
    components_.emplace_back(times_, values, interpolation_);
  }
}

DeformationTable DeformationTable::interpolated(Interpolation interpolation) const {
  return {source_, times_, rows(), interpolation};
}

std::vector<Tensor> DeformationTable::rows() const {
  std::vector<Tensor> F(times_.size());
  for (int c = 0; c < 9; ++c) {
    const auto values = components_[static_cast<std::size_t>(c)].values();
    for (std::size_t row = 0; row < F.size(); ++row) component(F[row], c) = values[row];
  }
  return F;
}

Tensor DeformationTable::value(double t, int derivative) const {
  Tensor tensor;
  for (int c = 0; c < 9; ++c) {
    const Interpolant::Value at = components_[static_cast<std::size_t>(c)].at(t);
    component(tensor, c) = derivative == 0 ? at.value : derivative == 1 ? at.slope : at.curvature;
  }
  return tensor;
}

ExactState DeformationTable::at(const Vector3& X, double t) const {
  const Tensor F = value(t, 0), rate = value(t, 1);
  return {F * X, rate * X, value(t, 2) * X, F, rate};
}

std::optional<DeformationTable::Departure> DeformationTable::farthest_departure() const {
  std::optional<Departure> farthest;
  for (int c = 0; c < 9; ++c) {
    const Interpolant& of_time = components_[static_cast<std::size_t>(c)];
    double largest = 0;
    for (const double value : of_time.values()) largest = std::max(largest, std::abs(value));
    const Interpolant::Departure found = of_time.farthest_departure();
    if (found.by > rounding * largest && !(farthest && farthest->by >= found.by)) farthest = Departure{found, c};
  }
  return farthest;
}

DeformationTable::Determinant DeformationTable::smallest_determinant() const {
  Determinant smallest;
  for (std::size_t row = 0; row + 1 < times_.size(); ++row) {
    for (int k = 1; k <= looks; ++k) {
      const double t = k < looks ? times_[row] + (times_[row + 1] - times_[row]) * k / looks : times_[row + 1];
      const double det = value(t, 0).determinant();
      if (!(det >= smallest.value)) smallest = {t, det, row};
    }
  }
  return smallest;
}

double DeformationTable::lowest_parameter() const {
  const double least = least_share * smallest_determinant().value;
  const auto stays_above = [&](double xi) {
    for (std::size_t row = 0; row + 1 < times_.size(); ++row) {
      for (int k = 0; k < looks; ++k) {
        const Tensor F = value(times_[row] + (times_[row + 1] - times_[row]) * (k + 1) / looks, 0);
        const Tensor part = Tensor::Identity() + xi * (F - Tensor::Identity());
        if (!(part.determinant() >= least)) return false;
      }
    }
    return true;
  };
  double width = 1;
  for (int pass = 0; pass < halvings; ++pass, width *= 0.5) {
    bool all = true;
    for (int k = 0; all && k < fractions; ++k) all = stays_above(1 - width * (fractions - k) / fractions);
    if (all) break;
  }
  return 1 - width;
}

Path DeformationTable::baseline() const {
  Path path;
  path.name = "table";
  path.parameter = {lowest_parameter(), 1};
  path.curved = [table = std::make_shared<const DeformationTable>(*this)](double xi, double t) {
    return PathPoint{Tensor::Identity() + xi * (table->value(t, 0) - Tensor::Identity()), xi * table->value(t, 1)};
  };
  // F', F'' or F''' jumps at every row: between two rows all is smooth
  path.reversals = [times = times_](double end) {
    std::vector<double> inner(times.begin() + 1, std::lower_bound(times.begin() + 1, times.end() - 1, end));
    return inner;
  };
  path.recipe = recipe("table", Rows{times_, rows(), interpolation_});
  return path;
}

bool DeformationTable::plane() const {
  for (const double t : times_) {
    const Tensor F = value(t, 0);
    if (F(0, 2) != 0 || F(1, 2) != 0 || F(2, 0) != 0 || F(2, 1) != 0 || F(2, 2) != 1) return false;
  }
  return true;
}

namespace {

/// `homogeneous` with a path: the file behind it is read by whoever reads the scene.
class DeformationTableKind final : public MotionOf<DeformationTableKind, DeformationTable> {
 public:
  using MotionOf::MotionOf;
  std::string_view type() const override { return "homogeneous"; }
  double period() const override { return m.last(); }
  bool is_plane() const override { return m.plane(); }
  void keys(Keys& keys) override {
    double last = m.last();
    period_key(keys, last);
  }
  std::optional<MotionFault> fault(const MotionUse& use) const override {
    if (use.gives("motion.final"))
      return MotionFault{"motion.final", "cannot be combined with motion.path, which gives F at all times"};
    if (use.end > m.last())
      return MotionFault{"time.end", "must not exceed the last time of motion.path, " + use.text(m.last(), "s") +
                                         ", found " + use.text(use.end, "s")};
    return std::nullopt;
  }
};

}  // namespace

std::unique_ptr<MotionKind> kind_of(const DeformationTable& motion) {
  return std::make_unique<DeformationTableKind>(motion);
}

void register_deformation_table(MotionRegistry& registry) { registry.path<Rows>("table"); }

}  // namespace assay
