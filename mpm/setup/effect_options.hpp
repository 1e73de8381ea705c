// SPDX-License-Identifier: BSD-3-Clause
// What a scene tells the effects that have keys of their own.
#pragma once

#include <any>
#include <array>
#include <map>
#include <typeindex>

namespace assay::mpm {

/// Each effect keeps its options in a type of its own. A scene that says nothing about an effect leaves them as the
/// type initializes them, and then the effect is absent.
class EffectOptions {
 public:
  template <class T>
  const T& of() const {
    static const T untold{};
    const auto told = told_.find(typeid(T));
    return told == told_.end() ? untold : std::any_cast<const T&>(told->second);
  }
  template <class T>
  T& tell() {
    return std::any_cast<T&>(told_.try_emplace(typeid(T), T{}).first->second);
  }

 private:
  std::map<std::type_index, std::any> told_;
};

// Options that other parts of the program read besides the effect.

/// remedies.anti_locking: F-bar over cells, or over the functions of nodes. Nearly incompressible materials then resist
/// changes of a cell's volume, not of each particle's.
enum class AntiLocking { none, cell, node };
constexpr std::array<const char*, 3> names_of(AntiLocking) { return {"none", "cell", "node"}; }

/// remedies.largest_domain; 0 leaves the domains as they deform.
struct LargestDomain {
  double cells = 0;
};

/// remedies.artificial_viscosity: C1 and C2 of q = rho h (C1 c + C2 h |tr D|) |tr D| in compression.
struct ArtificialViscosity {
  std::array<double, 2> C{};
  bool acts() const { return C[0] > 0 || C[1] > 0; }
};

}  // namespace assay::mpm
