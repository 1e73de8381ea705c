// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/kept_numbers.hpp"

#include <algorithm>

#include "drivers/system/input_error.hpp"

namespace assay::drivers {

KeptNumbers::KeptNumbers(bool in_file) {
  if (!in_file) return;
  try {
    file_.emplace();
  } catch (const SystemError&) {  // memory will do
  }
}

void KeptNumbers::put(std::size_t at, std::span<const double> numbers) {
  if (file_) {
    try {
      file_->write_at(at * sizeof(double), {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()});
      return;
    } catch (const SystemError&) {
      go_to_memory(at);
    }
  }
  memory_.resize(std::max(memory_.size(), at + numbers.size()));
  std::ranges::copy(numbers, memory_.begin() + static_cast<std::ptrdiff_t>(at));
}

std::vector<double> KeptNumbers::first(std::size_t count) const {
  std::vector<double> numbers(count);
  if (!file_) {
    std::copy_n(memory_.begin(), std::min(count, memory_.size()), numbers.begin());
    return numbers;
  }
  file_->read(0, reinterpret_cast<char*>(numbers.data()), count * sizeof(double));
  return numbers;
}

void KeptNumbers::go_to_memory(std::size_t count) {
  memory_ = first(count);
  file_.reset();
}

}  // namespace assay::drivers
