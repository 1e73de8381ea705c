// SPDX-License-Identifier: BSD-3-Clause
// What every basis must do: partition of unity, linear reproduction, gather as the adjoint of scatter.
#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis {
namespace {

template <class Case>
struct EveryBasisTest : testing::Test, BasisFixture<Case> {};
TYPED_TEST_SUITE(EveryBasisTest, EveryBasis, BasisCaseName);

constexpr int places = 300;

TYPED_TEST(EveryBasisTest, IsAPartitionOfUnityAndReproducesLinearFields) {
  constexpr std::size_t N = TypeParam::Dim;
  for (int k = 0; k < places; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    double sum = 0, slopes = 0;
    Vec<N> gradient{}, position{};
    Mat<N> identity{};
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      const double* node = w.node(i);
      const Vec<N> at = this->node_position(i);
      EXPECT_GE(node[0], 0);
      sum += node[0];
      for (std::size_t d = 0; d < N; ++d) {
        gradient[d] += node[1 + d];
        slopes += std::abs(node[1 + d]);
        position[d] += node[0] * at[d];
        for (std::size_t e = 0; e < N; ++e) identity[d * N + e] += at[d] * node[1 + e];
      }
    }
    EXPECT_NEAR(sum, 1, round_off);
    for (std::size_t d = 0; d < N; ++d) {
      EXPECT_NEAR(position[d], this->x[d], round_off);
      EXPECT_NEAR(gradient[d], 0, round_off * slopes);
      for (std::size_t e = 0; e < N; ++e) {
        EXPECT_NEAR(identity[d * N + e], d == e ? 1 : 0, round_off * std::max(1.0, slopes));
      }
    }
  }
}

TYPED_TEST(EveryBasisTest, GatherIsTheAdjointOfScatter) {
  constexpr std::size_t N = TypeParam::Dim;
  constexpr int K = static_cast<int>(N) + 2, G = N;  // gradients of the last G on the way out, the first G back
  for (int k = 0; k < places; ++k) {
    this->place_at_random();
    const auto A = this->random.template array<K>(1);
    const auto B = this->random.template array<G * N>(1);
    GridField<K> nodal;
    nodal.allocate(this->grid.nodes());
    this->basis.template scatter<K, G>(0, A, B, nodal.data());
    GridField<K> field, shifted;  // `shifted`: the last G components first, as gather differentiates those
    field.allocate(this->grid.nodes());
    shifted.allocate(this->grid.nodes());
    double left = 0, scale = 0;
    for (std::size_t i = 0; i < field.nodes(); ++i) {
      for (std::size_t c = 0; c < K; ++c) {
        const double f = this->random();
        field.node(i)[c] = f;
        shifted.node(i)[(c + G) % K] = f;
        left += f * nodal.node(i)[c];
        scale += std::abs(f * nodal.node(i)[c]);
      }
    }
    std::array<double, K> value, unused;
    std::array<double, G * N> gradient;
    std::array<double, 0> none;
    this->basis.template gather<K, 0>(0, field.data(), value, none);
    this->basis.template gather<K, G>(0, shifted.data(), unused, gradient);
    double right = 0;
    for (std::size_t c = 0; c < K; ++c) right += A[c] * value[c];
    for (std::size_t c = 0; c < G * N; ++c) right += B[c] * gradient[c];
    EXPECT_NEAR(left, right, round_off * std::max(1.0, scale));
    for (std::size_t c = 0; c < K; ++c) EXPECT_EQ(unused[(c + G) % K], value[c]);
  }
}

// Against the weights of the nodes one by one: r_i = x_i - sum_j w_j x_j.
TYPED_TEST(EveryBasisTest, MomentsAndAffineScatterAreSumsOverNodes) {
  constexpr std::size_t N = TypeParam::Dim;
  constexpr int K = 2 * static_cast<int>(N), M = static_cast<int>(N) + 1;
  const double h = this->grid.spacing;
  for (int k = 0; k < places; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    Vec<N> middle{};
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      for (std::size_t d = 0; d < N; ++d) middle[d] += w.node(i)[0] * this->node_position(i)[d];
    }
    const auto A = this->random.template array<M>(1);
    const auto C = this->random.template array<N * N>(1 / h);
    GridField<K> field;
    GridField<M> found;
    field.allocate(this->grid.nodes());
    found.allocate(this->grid.nodes());
    scatter_affine<M, N>(this->basis, 0, A, C, found.data());
    Mat<N> first{}, second{};
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      const double weight = w.node(i)[0];
      Vec<N> r;
      for (std::size_t d = 0; d < N; ++d) r[d] = this->node_position(i)[d] - middle[d];
      for (std::size_t c = 0; c < K; ++c) field.node(i)[c] = this->random();
      for (std::size_t c = 0; c < N * N; ++c) {
        first[c] += weight * field.node(i)[c / N] * r[c % N];
        second[c] += weight * r[c / N] * r[c % N];
      }
      for (std::size_t c = 0; c < M; ++c) {
        double value = A[c];
        for (std::size_t d = 0; c > 0 && d < N; ++d) value += C[(c - 1) * N + d] * r[d];
        EXPECT_NEAR(found.node(i)[c], weight * value, round_off);
      }
    }
    const Mat<N> moment = first_moment<K, N>(this->basis, 0, field.data());
    const Mat<N> spread = second_moment<N>(this->basis, 0);
    for (std::size_t c = 0; c < N * N; ++c) {
      EXPECT_NEAR(moment[c], first[c], round_off * h);
      EXPECT_NEAR(spread[c], second[c], round_off * h * h);
    }
  }
}

/// Some that share their nodes, four and fewer and more in a row, and some that do not.
TYPED_TEST(EveryBasisTest, SeveralAtOnceGiveTheBitsOfOneByOne) {
  constexpr std::size_t N = TypeParam::Dim, n = 29;
  constexpr int K = 2 * TypeParam::Dim, G = TypeParam::Dim;
  typename TypeParam::Basis several(this->grid, this->half, n);
  Mat<N> identity{};
  for (std::size_t d = 0; d < N; ++d) identity[d * N + d] = 1;
  for (std::size_t p = 0; p < n; ++p) {
    Vec<N> at = this->random.template array<N>(1e-3 * this->grid.spacing);
    for (std::size_t d = 0; d < N; ++d)
      at[d] += (p < 11 ? 0.3 : p < 17 ? 1.3 : 0.41 * static_cast<double>(p % 5)) * this->grid.spacing;
    ASSERT_TRUE(several.place(p, at, identity));
  }
  typename TypeParam::Basis::Nodes nodes;
  several.expand(0, n, nodes);
  GridField<K> field, together, apart;
  for (auto* f : {&field, &together, &apart}) f->allocate(this->grid.nodes());
  for (std::size_t i = 0; i < field.nodes(); ++i) {
    for (std::size_t c = 0; c < K; ++c) field.node(i)[c] = this->random();
  }
  Taken<K, G, N> taken;
  several.sum_all(nodes, n, field.data(), taken);
  Given<K, N> given;
  for (std::size_t p = 0; p < n; ++p) {
    NodePacks<K, N> found, given_one;
    several.template sum<K, true>(nodes, p, field.data(), found);
    for (std::size_t c = 0; c < K; ++c) {
      EXPECT_EQ(taken.value[c][p], found.value[c]) << p;
      for (std::size_t d = 0; c < G && d < N; ++d) EXPECT_EQ(taken.slope[d][c][p], found.other[d][c]) << p;
    }
    for (std::size_t c = 0; c < GridField<K>::stride; ++c) {
      given.value[p][c] = c < K ? this->random() : 0;
      for (std::size_t d = 0; d < N; ++d) given.other[d][p][c] = c < K ? this->random() : 0;
    }
    given.template get<true>(p, given_one);
    several.template add<K, true>(nodes, p, given_one, apart.data());
  }
  several.template add_all<K, true>(nodes, n, given, together.data());
  for (std::size_t i = 0; i < field.nodes(); ++i) {
    for (std::size_t c = 0; c < K; ++c) EXPECT_EQ(together.node(i)[c], apart.node(i)[c]) << i;
  }
}

TYPED_TEST(EveryBasisTest, ReachHoldsAllNodesThatHaveWeight) {
  for (int k = 0; k < places; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    NodeBox<TypeParam::Dim> box;
    this->basis.reach(0, 1, box);
    for (std::size_t d = 0; d < TypeParam::Dim; ++d) {
      ASSERT_GE(box.first[d], 0);
      ASSERT_LE(box.end[d], this->grid.count[d]);
    }
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      bool inside = true;
      std::size_t rest = i;
      for (std::size_t d = 0; d < TypeParam::Dim; ++d) {
        const auto at = static_cast<std::int32_t>(rest % static_cast<std::size_t>(this->grid.count[d]));
        inside = inside && at >= box.first[d] && at < box.end[d];
        rest /= static_cast<std::size_t>(this->grid.count[d]);
      }
      for (int c = 0; c <= TypeParam::Dim && !inside; ++c) EXPECT_EQ(w.node(i)[c], 0);
    }
  }
}

// sum x_i (x) grad w_i = I makes the moment of the internal forces that of the stress itself: none where it is
// symmetric. All bases here reproduce linear fields, so all of them must; the unsymmetric stress shows that it is seen.
TYPED_TEST(EveryBasisTest, InternalForcesHaveNoResultantAndNoMoment) {
  constexpr std::size_t N = TypeParam::Dim;
  for (int k = 0; k < places; ++k) {
    this->place_at_random();
    auto sigma = this->random.template array<N * N>(1e3);
    for (const bool symmetric : {false, true}) {
      if (symmetric) {
        for (std::size_t i = 0; i < N; ++i) {
          for (std::size_t j = 0; j < i; ++j) sigma[i * N + j] = sigma[j * N + i];
        }
      }
      GridField<static_cast<int>(N)> force;
      force.allocate(this->grid.nodes());
      this->basis.template scatter<N, N>(0, {}, sigma, force.data());
      Vec<N> total{};
      double moment = 0, scale = 0;  // about the third axis
      for (std::size_t i = 0; i < force.nodes(); ++i) {
        const double* f = force.node(i);
        const Vec<N> at = this->node_position(i);
        for (std::size_t d = 0; d < N; ++d) total[d] += f[d], scale += std::abs(f[d]);
        moment += at[0] * f[1] - at[1] * f[0];
      }
      for (const double sum : total) EXPECT_NEAR(sum, 0, round_off * scale);
      EXPECT_NEAR(moment, symmetric ? 0 : sigma[N] - sigma[1], round_off * scale);
    }
  }
}

TYPED_TEST(EveryBasisTest, RefusesToPlaceOutsideTheGrid) {
  constexpr std::size_t N = TypeParam::Dim;
  Mat<N> identity{};
  for (std::size_t d = 0; d < N; ++d) identity[d * N + d] = 1;
  for (std::size_t d = 0; d < N; ++d) {
    const double first = this->grid.coordinate(static_cast<int>(d), 0);
    const double last = this->grid.coordinate(static_cast<int>(d), this->grid.count[d] - 1);
    for (const double wrong : {first - 1e-9, last + 1e-9, -1e300, 1e300, std::nan(""), HUGE_VAL}) {
      Vec<N> at{};
      at[d] = wrong;
      EXPECT_FALSE(this->basis.place(0, at, identity)) << wrong << " in direction " << d;
    }
    Vec<N> at{};
    at[d] = first + 0.6 * this->grid.spacing;
    EXPECT_TRUE(this->basis.place(0, at, identity));
    at[d] = last - 0.6 * this->grid.spacing;
    EXPECT_TRUE(this->basis.place(0, at, identity));
    double sum = 0;
    const auto w = this->weights();
    for (std::size_t i = 0; i < w.nodes(); ++i) sum += w.node(i)[0];
    EXPECT_NEAR(sum, 1, round_off);  // nothing wrapped around to the other side: checked by the address sanitizer too
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis
