// SPDX-License-Identifier: BSD-3-Clause
// Divides the parameters of a slow test. Some run for each change. The others are instantiated with a prefix that
// begins with "Long", and run with ./dev test --deep.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace assay {

template <class T>
struct Divided {
  std::vector<T> some;    ///< the first of each `step`
  std::vector<T> others;  ///< the rest
};

/// T: the ParamType of the suite; `all`: testing::Values(...) or another generator; `step`: at least 1.
template <class T>
Divided<T> one_of_each(std::size_t step, const testing::internal::ParamGenerator<T>& all) {
  Divided<T> divided;
  std::size_t k = 0;
  for (const T& value : all) (k++ % step == 0 ? divided.some : divided.others).push_back(value);
  return divided;
}

}  // namespace assay
