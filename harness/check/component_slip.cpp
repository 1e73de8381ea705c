// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/component_slip.hpp"

#include <algorithm>

#include "harness/check/names.hpp"

namespace assay::check {

namespace {

constexpr const char* component_names[] = {"11", "22", "33", "12", "13", "23"};

/// Shears by their places 3, 4 and 5.
ComponentSlip weighed(const std::vector<std::size_t>& shears, double times, const char* cause, const char* how) {
  ComponentSlip slip{.cause = cause, .how = how};
  for (const std::size_t c : shears) {
    slip.times[c] = times;
    slip.components += (slip.components.empty() ? ""
                        : c == shears.back()    ? " and "
                                                : ", ") +
                       std::string(component_names[c]);
  }
  return slip;
}

std::vector<ComponentSlip> all_slips() {
  std::vector<ComponentSlip> all;
  const std::vector<std::vector<std::size_t>> some{{3}, {4}, {5}, {4, 5}, {3, 4}, {3, 5}};
  for (const auto& shears : some) {
    all.push_back(weighed(shears, 2, causes::shear_factor, "doubled"));
    all.push_back(weighed(shears, 0.5, causes::shear_factor, "halved"));
    all.push_back(weighed(shears, -1, causes::wrong_sign, "of the wrong sign"));
  }
  all.push_back(weighed({3, 4, 5}, -1, causes::wrong_sign, "of the wrong sign"));
  for (const std::array<int, 2>& pair : {std::array{1, 2}, std::array{0, 2}, std::array{0, 1}}) {
    const auto [i, j] = pair;
    ComponentSlip slip{.cause = causes::other_order, .how = "exchanged"};
    std::swap(slip.from[static_cast<std::size_t>(i)], slip.from[static_cast<std::size_t>(j)]);
    slip.components = std::string(component_names[i]) + " and " + component_names[j];
    all.push_back(slip);
  }
  const std::string normals = "11, 22 and 33";
  all.push_back({{1, 2, 0, 3, 4, 5}, {1, 1, 1, 1, 1, 1}, causes::other_order, normals, "in the order 22, 33, 11"});
  all.push_back({{2, 0, 1, 3, 4, 5}, {1, 1, 1, 1, 1, 1}, causes::other_order, normals, "in the order 33, 11, 22"});
  return all;
}

}  // namespace

std::string ComponentSlip::of(const std::string& what) const {
  const bool several = components.size() > 2;
  return std::string(several ? "components " : "component ") + components + " of " + what +
         (several ? " are " : " is ") + how;
}

Tensor ComponentSlip::undone(const Tensor& A) const {
  Tensor right = A;
  for (std::size_t c = 0; c < 6; ++c) {
    const auto [i, j] = six_places[c];
    const auto [k, l] = six_places[static_cast<std::size_t>(from[c])];
    right(k, l) = A(i, j) / times[c];
    right(l, k) = A(j, i) / times[c];
  }
  return right;
}

Stiffness ComponentSlip::undone(const Stiffness& C) const {
  Stiffness right = C;
  for (int c = 0; c < 6; ++c) {
    const auto at = static_cast<std::size_t>(c);
    right.row(from[at]) = C.row(c) / times[at];
  }
  return right;
}

const std::vector<ComponentSlip>& component_slips() {
  static const std::vector<ComponentSlip> all = all_slips();
  return all;
}

std::optional<ComponentSlip> slip_that(const std::function<bool(const ComponentSlip&)>& leaves_it_right) {
  const auto& all = component_slips();
  const auto found = std::find_if(all.begin(), all.end(), leaves_it_right);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

}  // namespace assay::check
