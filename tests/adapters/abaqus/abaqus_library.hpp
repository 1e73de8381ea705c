// SPDX-License-Identifier: BSD-3-Clause
// The companion library, loaded as before a foreign model, and its routines as a Fortran compiler calls them.
#pragma once

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

#include "harness/numeric/tensor.hpp"
#include "tests/support/built.hpp"

namespace assay::adapters {

inline void* abaqus_library() {
  static void* const handle = dlopen(built("libassay_abaqus.so").c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!handle) throw std::runtime_error(dlerror());
  return handle;
}

/// The address of a routine or of a variable.
template <class T>
T* abaqus(const std::string& symbol) {
  void* found = dlsym(abaqus_library(), symbol.c_str());
  if (!found) throw std::runtime_error("no symbol " + symbol);
  return reinterpret_cast<T*>(found);
}

/// "x " padded as a Fortran character variable.
inline std::string padded(std::string text, std::size_t size) {
  text.resize(size, ' ');
  return text;
}

inline Tensor random_symmetric(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Tensor A;
  for (int c = 0; c < 9; ++c) component(A, c) = uniform(random);
  return A + A.transpose();
}

/// What a routine throws to in a test instead of ending the process.
struct Ended {
  std::string what;
};

/// While it lives, the end of the analysis is an Ended.
class EndsAreThrown {
 public:
  using Hook = void (*)(const char* what);
  EndsAreThrown() : hook_(abaqus<Hook>("assay_abaqus_on_end")), before_(*hook_) {
    *hook_ = [](const char* what) { throw Ended{what}; };
  }
  ~EndsAreThrown() { *hook_ = before_; }
  EndsAreThrown(const EndsAreThrown&) = delete;
  EndsAreThrown& operator=(const EndsAreThrown&) = delete;

 private:
  Hook* hook_;
  Hook before_;
};

}  // namespace assay::adapters
