// SPDX-License-Identifier: BSD-3-Clause
// Defects that are planted into the passes of a step, for tests of the patch tests.
#pragma once

#include <gtest/gtest.h>

#include <set>

#include "mpm/basis/basis_linear.hpp"
#include "mpm/basis/basis_ugimp.hpp"
#include "mpm/kernels/variants/table.hpp"
#include "mpm/patch/patch.hpp"
#include "mpm/patch/rotation.hpp"
#include "mpm/step/surface_loads.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm {

template <int Dim = 2>
Bench<Dim> quick_patch_bench() {
  return bench_of<Dim>(elastic_material(), true);
}

/// Ids of the tests that fail.
inline std::set<std::string> failed_tests(const MethodReport& report) {
  std::set<std::string> ids;
  for (const auto& test : report.tests) {
    if (test.verdict == check::Verdict::fail) ids.insert(test.id);
  }
  return ids;
}

/// `check --methods` runs them all (tests/drivers/check/test_check_methods.cpp); the margins are those of each basis
/// here.
inline std::vector<Method> one_of_each_basis() {
  std::vector<Method> methods = methods_that_are(true);
  std::erase_if(methods, [](const Method& method) {
    return method.transfer != Transfer::flip || !method.is_lumped() || method.update != Update::usl;
  });
  return methods;
}

/// One corner of each piece of the surface bears all of its force.
template <int Dim>
void bear_on_one_corner(State<Dim>& s, const Instant&) {
  for (SurfacePoint<Dim>& point : s.template own<SurfaceLoads<Dim>>().points) {
    point.corner = point.piece->corners[0];
    for (std::size_t d = 0; d < Dim; ++d) point.offset[d] = point.piece->X[0][d] - s.setup.seeds.X[d][point.particle];
  }
}

/// With a margin of ten to what is rounding.
template <int Dim>
void expect_promises_kept(const Method& method) {
  const MethodReport report = run_patch_tests(method, quick_patch_bench<Dim>());
  EXPECT_TRUE(report.passes());
  EXPECT_EQ(report.tests.size(), Dim == 2 ? 17u : 22u);
  std::set<std::string> ids;
  for (const auto& test : report.tests) {
    EXPECT_TRUE(ids.insert(test.id).second) << test.id;
    ASSERT_TRUE(test.measure) << test.id << ": " << test.sentence;
    EXPECT_FALSE(test.sentence.empty()) << test.id;
    EXPECT_TRUE(test.cause.empty()) << test.id;
    const bool promised = test.verdict == check::Verdict::pass;
    EXPECT_EQ(promised, exemption(method, test.id).empty()) << test.id;
    EXPECT_EQ(promised, test.threshold.has_value()) << test.id;
    EXPECT_EQ(promised, test.sentence.find("not promised: ") == std::string::npos) << test.sentence;
    // rounding, or an error that falls, with a margin
    const bool is_error = test.id.starts_with("rotation.") || test.id == "tilted.strain" || test.id == "tilted.stress";
    const double share = is_error ? 0.9 : 0.1;
    if (promised) {
      EXPECT_LT(*test.measure, share * *test.threshold) << test.id;
    }
  }
}

/// A defect: a pass put behind another one, or before it.
template <int Dim>
struct DefectIn {
  const char* name;
  const char* at;  ///< the pass it is put to; "forces": the one that gives them
  bool before = false;
  std::function<void(State<Dim>&, const Instant&)> act;
  std::vector<Method> methods;
  std::set<std::string> must_fail;
  std::function<void(State<Dim>&)> bind{};  ///< before the passes after it are bound; with "= {}" g++ 12 breaks down
  std::set<std::string> must_pass = {};     ///< what is blind for it
};
using Defect = DefectIn<2>;

template <int Dim>
Pass<Dim> pass_of(const DefectIn<Dim>& defect) {
  Pass<Dim> pass;
  pass.name = defect.name;
  pass.bind = [act = defect.act, bind = defect.bind](State<Dim>& s) -> Kernel {
    if (bind) bind(s);
    return [&s, act](const Instant& now) { act(s, now); };
  };
  return pass;
}

/// The bench of a method with the defect in every step.
template <int Dim>
Bench<Dim> broken_bench(const DefectIn<Dim>& defect) {
  auto bench = quick_patch_bench<Dim>();
  bench.passes = [defect](const Setup<Dim>& setup) {
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

/// The groups of tests that those ids belong to; in the plane all.
template <int Dim>
MethodReport run_groups_of(const std::set<std::string>& ids, const Method& method, const Bench<Dim>& bench) {
  if constexpr (Dim == 2) {
    return run_patch_tests(method, bench);
  } else {
    using Group = std::vector<check::TestResult> (*)(const Method&, const Bench<3>&);
    const std::vector<std::pair<const char*, Group>> groups{
        {"weights.", completeness<3>}, {"translation", translation<3>}, {"slab.", turning_slabs},
        {"tilted.", turning_cube},     {"stress.", constant_stress<3>}, {"surface.", surface<3>},
        {"momentum.", momentum<3>}};
    MethodReport report{method, {}};
    for (const auto& [begin, group] : groups) {
      if (std::none_of(ids.begin(), ids.end(), [&b = begin](const std::string& id) { return id.starts_with(b); }))
        continue;
      for (check::TestResult& test : group(method, bench)) report.tests.push_back(std::move(test));
    }
    return report;
  }
}

/// By every method, in the tests that the defect names.
template <int Dim>
void expect_caught_in(const DefectIn<Dim>& defect) {
  std::set<std::string> named = defect.must_fail;
  named.insert(defect.must_pass.begin(), defect.must_pass.end());
  for (const Method& method : defect.methods) {
    const std::string where = std::string(defect.name) + ", " + name_of(method);
    const auto report = run_groups_of(named, method, broken_bench(defect));
    EXPECT_FALSE(report.passes()) << where;
    const auto found = failed_tests(report);
    for (const std::string& id : defect.must_fail) EXPECT_EQ(found.count(id), 1u) << where << ": " << id;
    for (const std::string& id : defect.must_pass) EXPECT_EQ(found.count(id), 0u) << where << ": " << id;
    for (const auto& test : report.tests) {
      EXPECT_EQ(test.cause.empty(), test.verdict != check::Verdict::fail) << where << ": " << test.id;
    }
  }
}
inline void expect_caught(const Defect& defect) { expect_caught_in<2>(defect); }

template <int Dim>
void transpose(State<Dim>& s, Column column, std::size_t i = 0, std::size_t j = 1) {
  for (std::size_t p = 0; p < s.particles; ++p)
    std::swap(s.column(column, i * Dim + j)[p], s.column(column, j * Dim + i)[p]);
}

/// Stress columns: 11, 22, 33, 12, 13, 23.
inline void swap_stress(State<3>& s, int a, int b) {
  for (std::size_t p = 0; p < s.particles; ++p)
    std::swap(s.column(Column::stress, a)[p], s.column(Column::stress, b)[p]);
}

/// Of every so many particles.
inline auto scale_components(Column column, std::vector<int> components, double factor, std::size_t every) {
  return [=](auto& s, const Instant&) {
    for (const int c : components) {
      for (std::size_t p = 0; p < s.particles; p += every) s.column(column, c)[p] *= factor;
    }
  };
}

/// A basis whose weights somebody has spoilt.
template <class Inner, int Dim, int Width, auto Spoil>
class Spoilt : public SeparableBasis<Spoilt<Inner, Dim, Width, Spoil>, Dim, Width> {
 public:
  static constexpr BasisTraits traits = Inner::traits;
  static constexpr std::size_t domain_components = Inner::domain_components;
  static constexpr bool may_cross_edges = false;

  Spoilt(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : SeparableBasis<Spoilt, Dim, Width>(grid), inner_(grid, half_size, particles) {}

  template <class... Domain>
  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F, const Domain&... half) {
    return inner_.place(p, x, F, half...);
  }
  double along(std::size_t p, std::size_t d) const { return inner_.along(p, d); }
  void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    inner_.line(p, d, value, slope, first);
    for (int k = 0; k < Width; ++k) Spoil(d, k, Width, value[k], slope[k]);
  }

 private:
  Inner inner_;
};

template <class Basis, int Dim>
void use_basis(State<Dim>& s) {
  s.basis = std::make_shared<Basis>(s.setup.grid, s.setup.seeds.half_size, s.particles);
  s.template own<Kernels<Dim>>() = baseline::table<Basis, Dim>();
}

template <auto Spoil, int Dim>
void spoil(State<Dim>& s) {
  if (s.setup.method.basis == Basis::linear) {
    use_basis<Spoilt<LinearBasis<Dim>, Dim, 2, Spoil>>(s);
  } else {
    use_basis<Spoilt<UgimpBasis<Dim>, Dim, 3, Spoil>>(s);
  }
}

}  // namespace assay::mpm
