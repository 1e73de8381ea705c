// SPDX-License-Identifier: BSD-3-Clause
// Defects that are planted into the passes of a step, for tests of the patch tests.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "mpm/patch/patch.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm {

inline Bench quick_patch_bench() { return bench_of(elastic_material(), true); }

/// Ids of the tests that fail.
inline std::set<std::string> failed_tests(const MethodReport& report) {
  std::set<std::string> ids;
  for (const auto& test : report.tests) {
    if (test.verdict == check::Verdict::fail) ids.insert(test.id);
  }
  return ids;
}

/// A defect: a pass put behind another one, or before it.
struct Defect {
  const char* name;
  const char* at;  ///< the pass it is put to; "forces": the one that gives them
  bool before = false;
  std::function<void(State<2>&, const Instant&)> act;
  std::vector<Method> methods;
  std::set<std::string> must_fail;
  std::function<void(State<2>&)> bind = {};  ///< before the passes after it are bound
};

inline Pass<2> pass_of(const Defect& defect) {
  Pass<2> pass;
  pass.name = defect.name;
  pass.bind = [act = defect.act, bind = defect.bind](State<2>& s) -> Kernel {
    if (bind) bind(s);
    return [&s, act](const Instant& now) { act(s, now); };
  };
  return pass;
}

/// The bench of a method with the defect in every step.
inline Bench broken_bench(const Defect& defect) {
  Bench bench = quick_patch_bench();
  bench.passes = [defect](const Setup<2>& setup) {
    auto passes = compose(setup);
    std::string at = defect.at;
    if (at == "forces") at = setup.method.update == Update::usf ? "grid_forces" : "particles_to_grid";
    for (std::size_t k = 0; k < passes.size(); ++k) {
      if (passes[k].name != at) continue;
      passes.insert(passes.begin() + static_cast<std::ptrdiff_t>(k + (defect.before ? 0 : 1)), pass_of(defect));
      ++k;
    }
    return passes;
  };
  return bench;
}

/// By every method, in the tests that the defect names.
inline void expect_caught(const Defect& defect) {
  for (const Method& method : defect.methods) {
    const std::string where = std::string(defect.name) + ", " + name_of(method);
    const auto report = run_patch_tests(method, broken_bench(defect));
    EXPECT_FALSE(report.passes()) << where;
    const auto found = failed_tests(report);
    for (const std::string& id : defect.must_fail) EXPECT_EQ(found.count(id), 1u) << where << ": " << id;
    for (const auto& test : report.tests) {
      EXPECT_EQ(test.cause.empty(), test.verdict != check::Verdict::fail) << where << ": " << test.id;
    }
  }
}

}  // namespace assay::mpm
