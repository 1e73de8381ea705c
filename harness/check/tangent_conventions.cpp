// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/tangent_conventions.hpp"

#include <Eigen/LU>

namespace assay::check {

namespace {

int at(int i, int j) { return 3 * i + j; }

/// d (J sigma) / d F over J: d sigma / d F + sigma F^-T.
Tangent kirchhoff_over_J(const Tangent& A, const Tensor& sigma, const Tensor& F) {
  const Tensor inverse = F.inverse();
  Tangent result = A;
  for (int row = 0; row < 9; ++row) {
    for (int k = 0; k < 3; ++k) {
      for (int L = 0; L < 3; ++L) result(row, at(k, L)) += component(sigma, row) * inverse(L, k);
    }
  }
  return result;
}

/// To increments l = dF F^-1: a_ijkl = A_ijkL F_lL.
Tangent spatial(const Tangent& A, const Tensor& F) {
  Tangent result = Tangent::Zero();
  for (int row = 0; row < 9; ++row) {
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) {
        for (int L = 0; L < 3; ++L) result(row, at(k, l)) += A(row, at(k, L)) * F(l, L);
      }
    }
  }
  return result;
}

/// The part for symmetric l.
Tangent of_strain(const Tangent& a) {
  Tangent result;
  for (int row = 0; row < 9; ++row) {
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) result(row, at(k, l)) = 0.5 * (a(row, at(k, l)) + a(row, at(l, k)));
    }
  }
  return result;
}

Tangent rows_exchanged(const Tangent& A) {
  Tangent result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.row(at(i, j)) = A.row(at(j, i));
  }
  return result;
}

/// c : d = C_Jaumann : d - d sigma - sigma d.
Tangent truesdell(const Tangent& jaumann, const Tensor& sigma) {
  Tangent result = jaumann;
  for (int c = 0; c < 9; ++c) {
    Tensor d = Tensor::Zero();
    component(d, c) += 0.5;
    d = (d + d.transpose()).eval();
    const Tensor turned = d * sigma + sigma * d;
    for (int r = 0; r < 9; ++r) result(r, c) -= component(turned, r);
  }
  return result;
}

/// d S / d F with S = F^-1 P.
Tangent of_second_piola(const Tangent& piola, const Tensor& P, const Tensor& F) {
  const Tensor inverse = F.inverse();
  Tangent result;
  for (int c = 0; c < 9; ++c) {
    Tensor dF = Tensor::Zero(), dP;
    component(dF, c) = 1;
    for (int r = 0; r < 9; ++r) component(dP, r) = piola(r, c);
    const Tensor dS = inverse * (dP - dF * inverse * P);
    for (int r = 0; r < 9; ++r) result(r, c) = component(dS, r);
  }
  return result;
}

/// d S / d E from d S / d F: dF = F^-T dE has that symmetric strain.
Tangent of_green_strain(const Tangent& dS_dF, const Tensor& F) {
  const Tensor inverse_transposed = F.inverse().transpose();
  Tangent result;
  for (int c = 0; c < 9; ++c) {
    Tensor dE = Tensor::Zero();
    component(dE, c) += 0.5;
    dE = (dE + dE.transpose()).eval();
    const Tensor dF = inverse_transposed * dE;
    for (int r = 0; r < 9; ++r) {
      result(r, c) = 0;
      for (int k = 0; k < 9; ++k) result(r, c) += dS_dF(r, k) * component(dF, k);
    }
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

}  // namespace

Tangent spatial_moduli(const Tangent& A, const Tensor& F) { return of_strain(spatial(A, F)); }

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
  const Tensor inverse = F.inverse();
  const Tangent tau_over_J = kirchhoff_over_J(A, sigma, F);
  Tangent columns, piola = Tangent::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int row = 0; row < 9; ++row) columns(row, at(i, j)) = A(row, at(j, i));
    }
  }
  // P = tau F^-T: dP_iJ = dtau_im F^-1_Jm - tau_im F^-1_Jk dF_kL F^-1_Lm
  for (int i = 0; i < 3; ++i) {
    for (int jj = 0; jj < 3; ++jj) {
      for (int k = 0; k < 3; ++k) {
        for (int L = 0; L < 3; ++L) {
          double value = 0;
          for (int m = 0; m < 3; ++m) {
            value +=
                J * (tau_over_J(at(i, m), at(k, L)) * inverse(jj, m) - sigma(i, m) * inverse(jj, k) * inverse(L, m));
          }
          piola(at(i, jj), at(k, L)) = value;
        }
      }
    }
  }
  const Tangent plain = of_strain(spatial(A, F)), jaumann = of_strain(spatial(tau_over_J, F));
  const Tangent second_piola = of_second_piola(piola, J * sigma * inverse.transpose(), F);
  return {{"transposed", A.transpose()},
          {"d sigma / d F with the indices of F exchanged (column-major)", columns},
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

}  // namespace assay::check
