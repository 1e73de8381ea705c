// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/names.hpp"

namespace assay::check {

namespace {

constexpr double probe = 0x1p-17;       ///< 8e-6, of strain: most materials yield later; beside 1 exact in single
                                        ///< precision, too
constexpr double linear_within = 1e-3;  ///< relative: between probes of one and of two sizes

struct Probes {
  Stiffness slope = Stiffness::Zero();  ///< by central differences of single steps from rest
  double one_sided = 0;                 ///< the largest difference between tension and compression, over the strain
};

/// About rest under a pressure [Pa], by steps of that length [s]. Of a material of the plane 12 alone the shears 13 and
/// 23 are taken for like the shear 12.
Probes probes_of(const Material& material, double pressure, double size, double length) {
  const std::vector<double> rest = state_at_rest(material, pressure);
  const Tensor I = Tensor::Identity(), at_rest = stepped(material, 0, length, I, I, rest).cauchy;
  Probes probes;
  const Space space(material);
  for (int column = 0; column < 6; ++column) {
    const int i = six_places[static_cast<std::size_t>(column)][0], j = six_places[static_cast<std::size_t>(column)][1];
    if (!space.has(3 * i + j)) {
      probes.slope(column, column) = probes.slope(3, 3);
      continue;
    }
    const auto stress = [&](double strain) {
      Tensor F = Tensor::Identity();
      F(i, j) += strain;
      if (i != j) F(j, i) += strain;
      return stepped(material, 0, length, Tensor::Identity(), F, rest).cauchy;
    };
    const Tensor there = stress(size), back = stress(-size), slope = (there - back) / (2 * size);
    probes.one_sided = std::max(probes.one_sided, (there + back - 2 * at_rest).cwiseAbs().maxCoeff() / (2 * size));
    for (int row = 0; row < 6; ++row) {
      const auto [k, l] = six_places[static_cast<std::size_t>(row)];
      probes.slope(row, column) = slope(k, l);
    }
  }
  return probes;
}

}  // namespace

Probed probed(const Material& material, double pressure, double length) {
  const Probes whole = probes_of(material, pressure, probe, length);
  const Probes half = probes_of(material, pressure, 0.5 * probe, length);
  const double change = size_of(half.slope - whole.slope);
  return {whole.slope, std::max(change, whole.one_sided) < linear_within * size_of(whole.slope), change};
}

std::vector<RelaxingPart> relaxing_parts(const Material& material, double pressure, double modulus) {
  constexpr std::array<double, 6> lengths{1e-9, 1e-6, 1e-3, 1, 1e3, 1e6};  // [s]
  constexpr double significant = 0.02, least = 1e-6;                       // of the stiffness beside it, of the modulus
  std::vector<RelaxingPart> parts;
  try {
    std::array<std::array<Probes, 2>, lengths.size() + 1> found{};  // by two sizes; in infinitely long steps nothing
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      found[k] = {probes_of(material, pressure, probe, lengths[k]),
                  probes_of(material, pressure, 0.5 * probe, lengths[k])};
    }
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      const auto &brief = found[k], &longer = found[k + 1];
      const Stiffness part = brief[0].slope - longer[0].slope, again = brief[1].slope - longer[1].slope;
      const double beside = std::max(size_of(brief[0].slope), size_of(longer[0].slope));
      if (!(size_of(part) > std::max(significant * beside, least * modulus))) continue;
      const double noise = size_of(part - again);
      const double change = std::max({noise, brief[0].one_sided, longer[0].one_sided});
      if (change > linear_within * size_of(part)) continue;
      parts.push_back({part, lengths[k], k + 1 < lengths.size() ? lengths[k + 1] : INFINITY, noise});
    }
  } catch (const MaterialFailure&) {
    return {};
  }
  return parts;
}

Tensor stress_of(const Stiffness& stiffness, const Tensor& H) {
  Eigen::Matrix<double, 6, 1> strain;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = six_places[static_cast<std::size_t>(c)];
    strain(c) = 0.5 * (H(i, j) + H(j, i));
  }
  const Eigen::Matrix<double, 6, 1> stress = stiffness * strain;
  Tensor sigma;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = six_places[static_cast<std::size_t>(c)];
    sigma(i, j) = sigma(j, i) = stress(c);
  }
  return sigma;
}

namespace {

constexpr int shear_row[] = {0, 0, 1}, shear_column[] = {1, 2, 2};
constexpr ShearOrder of_13_and_23 = other_orders[0];

std::string lying(const std::string& of, const std::string& order) {
  return "the shear components of " + of + " are in the order " + order + ", instead of 12, 13, 23";
}

}  // namespace

Tensor in_order(const ShearOrder& order, const Tensor& A) {
  Tensor read = A;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(order[i]);
    read(shear_row[i], shear_column[i]) = A(shear_row[at], shear_column[at]);
    read(shear_column[i], shear_row[i]) = A(shear_column[at], shear_row[at]);
  }
  return read;
}

ShearOrder reversed(const ShearOrder& order) {
  ShearOrder back{};
  for (std::size_t i = 0; i < 3; ++i) back[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return back;
}

Stiffness matrix_of(const ShearOrder& order) {
  Stiffness P = Stiffness::Identity();
  P.bottomRightCorner<3, 3>().setZero();
  for (std::size_t i = 0; i < 3; ++i) P(3 + static_cast<int>(i), 3 + order[i]) = 1;
  return P;
}

const char* cause_of(const ShearOrder& order) {
  return order == of_13_and_23 ? causes::components_swapped : causes::other_order;
}

bool is_of_order(const std::string& cause) {
  return cause == causes::components_swapped || cause == causes::other_order;
}

std::string words_of(const ShearOrder& order) {
  constexpr const char* names[] = {"12", "13", "23"};
  return std::string(names[order[0]]) + ", " + names[order[1]] + ", " + names[order[2]];
}

std::string misplaced(const ShearOrder& order, const std::string& of) {
  return order == of_13_and_23 ? "components 13 and 23 of " + of + " are exchanged" : lying(of, words_of(order));
}

std::string misplaced_in_one(const ShearOrder& order) {
  const ShearOrder strain = reversed(order);
  if (strain == order) return misplaced(order, "stress or strain");
  return lying("the stress", words_of(order)) + ", or those of the strain in the order " + words_of(strain);
}

std::string misplaced_somewhere(const ShearOrder& order) {
  if (order == of_13_and_23) return "13 and 23 are exchanged somewhere";
  const ShearOrder other = reversed(order);
  return "somewhere " + lying("a tensor", words_of(order) + (other == order ? "" : " or " + words_of(other)));
}

}  // namespace assay::check
