// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/tangents.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

int at(int i, int j) { return 3 * i + j; }

/// A component 0..8 alone.
Tensor unit(int c) {
  Tensor A = Tensor::Zero();
  component(A, c) = 1;
  return A;
}

/// The part of it that is symmetric.
Tensor symmetric_unit(int c) { return 0.5 * (unit(c) + unit(c).transpose()); }

/// d (J sigma) / d F over J: d sigma / d F + sigma F^-T.
Tangent kirchhoff_over_J(const Tangent& A, const Tensor& sigma, const Tensor& F) {
  return A + column_of(sigma) * column_of(F.inverse().transpose()).transpose();
}

/// To increments l = dF F^-1: a_ijkl = A_ijkL F_lL.
Tangent spatial(const Tangent& A, const Tensor& F) {
  Tangent result;
  for (int k = 0; k < 9; k += 3) result.middleCols<3>(k) = A.middleCols<3>(k) * F.transpose();
  return result;
}

Tangent columns_exchanged(const Tangent& A) {
  Tangent result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.col(at(i, j)) = A.col(at(j, i));
  }
  return result;
}

Tangent rows_exchanged(const Tangent& A) { return columns_exchanged(A.transpose()).transpose(); }

/// The part for symmetric l.
Tangent of_strain(const Tangent& a) { return 0.5 * (a + columns_exchanged(a)); }

/// c : d = C_Jaumann : d - d sigma - sigma d.
Tangent truesdell(const Tangent& jaumann, const Tensor& sigma) {
  Tangent result = jaumann;
  for (int c = 0; c < 9; ++c) {
    const Tensor d = symmetric_unit(c);
    result.col(c) -= column_of(d * sigma + sigma * d);
  }
  return result;
}

/// d P / d F with P = tau F^-T.
Tangent of_first_piola(const Tangent& dtau_dF, const Tensor& P, const Tensor& F) {
  const Tensor inverse_transposed = F.inverse().transpose();
  Tangent result;
  for (int c = 0; c < 9; ++c) {
    const Tensor dtau = tensor_of(dtau_dF.col(c).data());
    result.col(c) = column_of((dtau - P * unit(c).transpose()) * inverse_transposed);
  }
  return result;
}

/// d S / d F with S = F^-1 P.
Tangent of_second_piola(const Tangent& dP_dF, const Tensor& P, const Tensor& F) {
  const Tensor inverse = F.inverse();
  Tangent result;
  for (int c = 0; c < 9; ++c) {
    const Tensor dP = tensor_of(dP_dF.col(c).data());
    result.col(c) = column_of(inverse * (dP - unit(c) * inverse * P));
  }
  return result;
}

/// d S / d E from d S / d F: dF = F^-T dE has that symmetric strain.
Tangent of_green_strain(const Tangent& dS_dF, const Tensor& F) {
  const Tensor inverse_transposed = F.inverse().transpose();
  Tangent result = Tangent::Zero();
  for (int c = 0; c < 9; ++c) {
    const Tensor dF = inverse_transposed * symmetric_unit(c);
    for (int k = 0; k < 9; ++k) result.col(c) += dS_dF.col(k) * component(dF, k);
  }
  return result;
}

/// The tangent without (1 - 1/factor) of what it has for the shear (k, l): of the whole column, or of its own stress.
void undo_shear(const Tangent& of_strains, const Tensor& inverse, int k, int l, double factor, bool of_column,
                Tangent& A) {
  for (int row = 0; row < 9; ++row) {
    if (!of_column && row != at(k, l) && row != at(l, k)) continue;
    const double share = (1 - 1 / factor) * of_strains(row, at(k, l));
    for (int L = 0; L < 3; ++L) {  // 2 d_kl of dF is dF_kL F^-1_Ll + dF_lL F^-1_Lk
      A(row, at(k, L)) -= share * inverse(L, l);
      A(row, at(l, L)) -= share * inverse(L, k);
    }
  }
}

/// The moduli of a tangent: stress to strain in the current configuration, both as nine components.
Tangent spatial_moduli(const Tangent& A, const Tensor& F) { return of_strain(spatial(A, F)); }

}  // namespace

std::vector<std::pair<std::string, Tangent>> with_other_shears(const Tangent& given, const Tensor& F, bool in_plane) {
  constexpr int shears[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  constexpr const char* names[] = {"12", "13", "23"};
  const Tangent of_strains = of_strain(spatial(given, F));
  const Tensor inverse = F.inverse();
  std::vector<std::pair<std::string, Tangent>> all;
  for (unsigned which = 1; which < (in_plane ? 2u : 8u); ++which) {
    std::string words;
    for (unsigned s = 0; s < 3; ++s) {
      if (which & 1u << s) words += (words.empty() ? "" : ", ") + std::string(names[s]);
    }
    words = (words.size() > 2 ? "the shears " : "the shear ") + words + " of the tangent " +
            (words.size() > 2 ? "are " : "is ");
    for (const double factor : {2.0, 0.5}) {
      for (const bool of_column : {true, false}) {
        Tangent A = given;
        for (unsigned s = 0; s < 3; ++s) {
          if (which & 1u << s) undo_shear(of_strains, inverse, shears[s][0], shears[s][1], factor, of_column, A);
        }
        all.emplace_back(words + (factor > 1 ? "doubled" : "halved"), A);
      }
    }
  }
  return all;
}

std::vector<std::pair<std::string, Tangent>> other_conventions(const Tangent& A, const Tensor& sigma, const Tensor& F) {
  const double J = F.determinant();
  const Tensor P = first_piola_kirchhoff(sigma, F);
  const Tangent tau_over_J = kirchhoff_over_J(A, sigma, F), piola = of_first_piola(J * tau_over_J, P, F);
  const Tangent plain = of_strain(spatial(A, F)), jaumann = of_strain(spatial(tau_over_J, F));
  const Tangent second_piola = of_second_piola(piola, P, F);
  return {{"transposed", A.transpose()},
          {"d sigma / d F with the indices of F exchanged (column-major)", columns_exchanged(A)},
          {"d (J sigma) / d F, of the Kirchhoff stress", J * tau_over_J},
          {"d P / d F, of the first Piola-Kirchhoff stress", piola},
          {"d sigma / d eps, of a strain in the current configuration", plain},
          {"the modulus of the Jaumann rate of J sigma, over J (Abaqus)", jaumann},
          {"d (J sigma) / d F over J, of the Kirchhoff stress", tau_over_J},
          {"d sigma / d l, of a displacement in the current configuration", spatial(A, F)},
          {"d P^T / d F, of the nominal stress", rows_exchanged(piola)},
          {"the modulus of the Truesdell rate, of the current configuration", truesdell(jaumann, sigma)},
          {"d S / d F, of the second Piola-Kirchhoff stress", second_piola},
          {"d S / d E, of the second Piola-Kirchhoff stress and the Green strain", of_green_strain(second_piola, F)}};
}

namespace {

/// The part that a change of shape brings, of the deviator: beside a large bulk modulus it is hardly seen in the whole.
Tangent of_shape(const Tangent& A, const Tensor& F) {
  constexpr int diagonal[] = {0, 4, 8};
  Tangent a = spatial_moduli(A, F);
  for (int c = 0; c < 9; ++c) {
    const double mean = (a(0, c) + a(4, c) + a(8, c)) / 3;
    for (const int d : diagonal) a(d, c) -= mean;
  }
  for (int r = 0; r < 9; ++r) {
    const double mean = (a(r, 0) + a(r, 4) + a(r, 8)) / 3;
    for (const int d : diagonal) a(r, d) -= mean;
  }
  return a;
}

/// d sigma / d F of a law whose Jaumann rate of sigma, or of J sigma, is C : d.
Tangent hypoelastic_tangent(const Specimen& specimen, const Sample& s, const Stiffness& C, bool of_kirchhoff) {
  Tangent A;
  for (int column = 0; column < 9; ++column) {
    const Tensor l = unit(column) * s.F1.inverse(), w = 0.5 * (l - l.transpose()), &sigma = s.end.cauchy;
    Tensor d = stress_of(C, l) + w * sigma - sigma * w;
    if (of_kirchhoff) d -= l.trace() * sigma;
    A.col(column) = column_of(d);
  }
  return within(specimen.space, A);
}

}  // namespace

Tangent within(const Space& space, const Tangent& A) {
  Tangent result = A;
  for (int column = 0; column < 9; ++column) {
    if (!space.has(column)) result.col(column).setZero();
  }
  return result;
}

double apart(const Tangent& a, const Tangent& b) {
  if (!a.allFinite() || !b.allFinite()) return INFINITY;
  const double d = size_of(a - b) / size_of(b);
  return std::isfinite(d) ? d : INFINITY;
}

double apart_in_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F) {
  constexpr double none = 1e-6;    // of the whole: less is rounding of the differences
  if (space.is_plane()) return 0;  // whose moduli have no columns for what leaves it
  if (!a.allFinite() || !b.allFinite()) return INFINITY;
  const Tangent wanted = of_shape(b, F);
  const double size = size_of(wanted);
  if (!(size > none * size_of(b))) return 0;
  return size_of(of_shape(a, F) - wanted) / size;
}

double apart_in_whole_and_shape(const Space& space, const Tangent& a, const Tangent& b, const Tensor& F) {
  return std::max(apart(a, b), apart_in_shape(space, a, b, F));
}

std::string farthest_component(const Tangent& given, const Tangent& right, const Tensor& F) {
  const Tangent is = spatial_moduli(given, F), wanted = spatial_moduli(right, F);
  int row = 0, column = 0;
  if (!(is - wanted).allFinite()) return {};
  (is - wanted).cwiseAbs().maxCoeff(&row, &column);
  const auto name = [](int component) {
    const int i = component / 3 + 1, j = component % 3 + 1;
    return std::to_string(std::min(i, j)) + std::to_string(std::max(i, j));
  };
  const double found = is(row, column), expected = wanted(row, column);
  int digits = 2;
  while (digits < 17 && rounded(found, digits) == rounded(expected, digits)) ++digits;
  return "farthest off: what the strain " + name(column) + " adds to the stress " + name(row) + ", which is " +
         rounded(found, digits) + " in place of " + rounded(expected, digits);
}

FromElasticity from_elasticity(const Specimen& specimen, const Sample& s, const Tangent& given) {
  FromElasticity found;
  for (const bool of_kirchhoff : {false, true}) {
    const Tangent turned = hypoelastic_tangent(specimen, s, Stiffness::Zero(), of_kirchhoff);
    const Tangent whole = hypoelastic_tangent(specimen, s, specimen.stiffness, of_kirchhoff);
    const Tangent elastic = whole - turned;
    const double share = share_along(given - turned, elastic);
    const Tangent nearest = turned + share * elastic;
    const double miss = apart_in_whole_and_shape(specimen.space, given, nearest, s.F1);
    found.whole = std::min(found.whole, apart(given, whole));
    if (miss < found.fitted) found.fitted = miss, found.share = share;
  }
  return found;
}

FromRight from_right(const Specimen& specimen, const Sample& s, const Tangent& given, const Tangent& right) {
  FromRight found;
  std::vector<Tangent> turning{Tangent::Zero()};
  for (const bool of_kirchhoff : {false, true})
    turning.push_back(hypoelastic_tangent(specimen, s, Stiffness::Zero(), of_kirchhoff));
  for (const Tangent& turned : turning) {
    const double factor = share_along(given - turned, right - turned);
    const Tangent multiple = turned + factor * (right - turned);
    const double miss = apart_in_whole_and_shape(specimen.space, given, multiple, s.F1);
    if (miss < found.miss) found.miss = miss, found.factor = factor;
    if (specimen.space.is_plane()) continue;  // whose moduli have no columns for what leaves it
    const Tangent wanted = spatial_moduli(right - turned, s.F1), moduli = spatial_moduli(given - turned, s.F1);
    found.transposed = std::min(found.transposed, apart(moduli, wanted.transpose()));
    found.straight = std::min(found.straight, apart(moduli, wanted));
  }
  return found;
}

}  // namespace assay::check
