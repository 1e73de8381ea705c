// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/host_values.hpp"

#include <algorithm>

namespace assay::adapters {

HostValues host_values_of(const ForeignModel& model) {
  HostValues values;
  values.element = model.element;
  values.point = model.point;
  values.step = model.step;
  values.temperature = model.temperature;
  values.length = model.characteristic_length;
  for (const ForeignField& field : model.fields) values.fields.push_back(field.value);
  return values;
}

void Surroundings::take_back(GuardedArrays& arrays) {
  for (const std::size_t word : arrays.take_back(words)) {
    const auto at = std::lower_bound(written.begin(), written.end(), word);
    if (at == written.end() || *at != word) written.insert(at, word);
  }
}

std::vector<std::size_t> Surroundings::left_at_times() const {
  std::vector<std::size_t> components;
  for (std::size_t k = 0; k < state_left.size(); ++k) {
    if (state_left[k] && state_written[k]) components.push_back(k + 1);
  }
  return components;
}

}  // namespace assay::adapters
