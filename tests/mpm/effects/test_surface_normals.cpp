// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/surface_normals.hpp"

#include <gtest/gtest.h>

#include "mpm/basis/corners.hpp"
#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_surface_normals {
namespace {

/// Corners of each face of a domain, as surface pieces have them, and on which side of it its axis points outwards.
struct FaceOfDomain {
  std::array<std::size_t, 4> corners;
  double side;
};

std::vector<FaceOfDomain> faces_of_domain() {
  std::vector<FaceOfDomain> faces;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::size_t along = d == 0 ? 1 : 0, across = d == 2 ? 1 : 2;
    for (const bool upper : {false, true}) {
      FaceOfDomain face;
      for (std::size_t k = 0; k < 4; ++k)
        face.corners[k] = (upper ? 1u << d : 0u) | (k & 1 ? 1u << along : 0u) | (k & 2 ? 1u << across : 0u);
      face.side = (d == 1 ? -1 : 1) * (upper ? 1 : -1);  // E_x x E_z = -E_y
      faces.push_back(face);
    }
  }
  return faces;
}

// What pushes a corner from the faces is what its function's gradient does inside: forces of constant stress cancel.
TEST(SurfaceNormals, OfACornerAddUpToTheGradientOfItsFunction) {
  Random random{11};
  for (int trial = 0; trial < 20; ++trial) {
    Corners<3> x;
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t d = 0; d < 3; ++d) x[c][d] = (c >> d & 1 ? 1.0 : 0.0) + 0.25 * random();
    }
    const CornerAverage<3> average = average_over(x);
    std::array<Vec<3>, 8> sums{};
    for (const FaceOfDomain& face : faces_of_domain()) {
      std::array<Vec<3>, 4> at;
      for (std::size_t k = 0; k < 4; ++k) at[k] = x[face.corners[k]];
      const auto normals = normals_of_ends(at, face.side);
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t d = 0; d < 3; ++d) sums[face.corners[k]][d] += normals[k][d];
      }
    }
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(sums[c][d], average.volume * average.gradient[c][d], 1e-14);
    }
  }
}

// Of a face that is no parallelogram corners bear different shares.
TEST(SurfaceNormals, OfATrapezoidAreNotAQuarterEach) {
  const std::array<Vec<3>, 4> x{{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  const auto normals = normals_of_ends(x, 1);
  double area = 0;
  for (const auto& n : normals) area += n[2];
  EXPECT_NEAR(area, 1.5, 1e-15);
  EXPECT_NEAR(normals[0][2], 5.0 / 12, 1e-15);  // by hand: integral of (1 - a)(1 - b)(2 - b) da db
  EXPECT_NEAR(normals[3][2], 1.0 / 3, 1e-15);
}

}  // namespace
}  // namespace assay::mpm::test_surface_normals
