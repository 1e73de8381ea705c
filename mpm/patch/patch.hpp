// SPDX-License-Identifier: BSD-3-Clause
// The patch tests of the particle method: motions and states that a method should carry exactly, run with real sizes.
#pragma once

#include <vector>

#include "mpm/patch/bench.hpp"

namespace assay::mpm {

/// One method's results.
struct MethodReport {
  Method method;
  std::vector<check::TestResult> tests;
  bool passes() const;
};

/// Every patch test of one method. What the method does not promise is measured too, and n/a.
MethodReport run_patch_tests(const Method& method, const Bench& bench);

/// A bench for a material without history. Throws MaterialFailure.
Bench bench_of(std::shared_ptr<const Material> material, bool quick);

// Each file of this folder holds one group.

/// Uniform motion through several cells: v uniform, F = I, momentum kept.
std::vector<check::TestResult> translation(const Method& method, const Bench& bench);

/// Rigid rotation by an irrational angle under the body force that it needs: errors of displacement, F and J.
std::vector<check::TestResult> rotation(const Method& method, const Bench& bench);

/// Internal force at inner nodes of a body under constant stress, in five arrangements of the particles.
std::vector<check::TestResult> constant_stress(const Method& method, const Bench& bench);

/// Force at all nodes of a loaded body under constant stress, its surface included: tension between two ends with free
/// sides, and tractions on all faces.
std::vector<check::TestResult> surface(const Method& method, const Bench& bench);

/// Sum of the weights, of their gradients, and of both with the nodes' positions, on an irregular set.
std::vector<check::TestResult> completeness(const Method& method, const Bench& bench);

/// Linear and angular momentum over one step of an irregular set.
std::vector<check::TestResult> momentum(const Method& method, const Bench& bench);

}  // namespace assay::mpm
