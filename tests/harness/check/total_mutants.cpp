// SPDX-License-Identifier: BSD-3-Clause
// Neo-Hookean elasticity of (34) as a total law, with tangent and energy; a parameter plants one defect.
#include <array>
#include <atomic>
#include <thread>

#include "harness/check/battery.hpp"
#include "harness/check/tangents.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::total_mutants {

namespace {

enum Defect : int {
  none,
  single_precision,
  second_piola,
  first_piola,
  unturned,
  small_strain_total,
  fixed_axis,
  fibre,
  exchanged_shears,
  shears_with_13_first,
  doubled_shear,
  spectral_blow_up,
  spectral_noise,
  spectral_wrong_limit,
  transposed_tangent,
  column_major_tangent,
  kirchhoff_tangent,
  piola_tangent,
  jaumann_tangent,
  strain_tangent,
  doubled_tangent,
  tangent_off_by_five_percent,
  tangent_of_small_strain,
  tangent_without_limit,
  tangent_of_tensor_shears,
  tangent_of_one_halved_shear,
  doubled_energy,
  healing,
  finite_of_nan,
  prestressed,
  turned_back,
  of_the_beginning,
  of_mid_step,
  unsigned_volume,
  stiffer_at_once,
  refuses_large_stretches,
  moves_its_limit,
  static_scratch,
  swells,
  calls_an_absent_routine,
  defects
};

struct Model {
  double mu, lambda;
  int defect;
  double limit = 30;  ///< of tr C - 3, where one is kept
};

/// Through memory that all threads share.
Tensor by_way_of_statics(const Tensor& F) {
  static std::array<std::atomic<double>, 9> scratch;
  for (std::size_t c = 0; c < 9; ++c) scratch[c] = component(F, static_cast<int>(c));
  std::this_thread::yield();
  Tensor found;
  for (std::size_t c = 0; c < 9; ++c) component(found, static_cast<int>(c)) = scratch[c];
  return found;
}

/// Stiffer as the chains come to their limit; 1 without one.
double near_limit(const Model& m, double stretched) {
  const bool limited = m.defect == refuses_large_stretches || m.defect == moves_its_limit;
  return limited ? m.limit / (m.limit - stretched) : 1;
}

Tensor neo_hookean(const Model& m, const Tensor& F) {
  const double det = F.determinant(), J = m.defect == unsigned_volume ? std::abs(det) : det;
  return (m.lambda * std::log(J) * Tensor::Identity() + m.mu * (F * F.transpose() - Tensor::Identity())) / J;
}

/// Hencky's law by Sylvester's formula, which divides by the differences of the principal stretches.
Tensor hencky(const Model& m, const Tensor& F) {
  constexpr double close = 1e-6;
  const Tensor b = F * F.transpose(), I = Tensor::Identity();
  const Eigen::SelfAdjointEigenSolver<Tensor> eigen(b);
  const Vector3& l = eigen.eigenvalues();
  const bool equal = l(0) == l(1) || l(1) == l(2), near = l(1) - l(0) < close || l(2) - l(1) < close;
  Tensor tau = 0.5 * m.lambda * (std::log(l(0)) + std::log(l(1)) + std::log(l(2))) * I;
  if (m.defect == spectral_noise && equal) {  // guarded where they are equal, not where they nearly are
    return (tau +
            m.mu * eigen.eigenvectors() * l.array().log().matrix().asDiagonal() * eigen.eigenvectors().transpose()) /
           F.determinant();
  }
  if (m.defect == spectral_wrong_limit && near) return (tau + m.mu * std::log(l(2)) * I) / F.determinant();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    tau += m.mu * std::log(l(i)) * (b - l(j) * I) * (b - l(k) * I) / ((l(i) - l(j)) * (l(i) - l(k)));
  }
  return tau / F.determinant();
}

Tensor cauchy_of(const Model& m, const Tensor& F) {
  const Tensor I = Tensor::Identity();
  Tensor sigma = neo_hookean(m, F);
  switch (m.defect) {
    case single_precision:
      return neo_hookean(m, F.cast<float>().cast<double>()).cast<float>().cast<double>();
    case second_piola:
      return F.determinant() * F.inverse() * sigma * F.inverse().transpose();
    case first_piola:
      return F.determinant() * sigma * F.inverse().transpose();
    case unturned: {
      const Tensor R = polar(F);
      return R.transpose() * sigma * R;
    }
    case turned_back: {
      const Tensor R = polar(F);
      return R.transpose() * R.transpose() * sigma * R * R;
    }
    case small_strain_total: {
      const Tensor e = 0.5 * (F + F.transpose()) - I;
      return m.lambda * e.trace() * I + 2 * m.mu * e;
    }
    case stiffer_at_once:
      if (F.squaredNorm() > 3.05) sigma += 0.1 * m.mu * (F * F.transpose() - I);
      break;
    case fixed_axis:
      sigma(0, 0) += 0.3 * m.mu * (F.determinant() - 1 + (F * F.transpose()).trace() - 3);
      break;
    case fibre: {
      const Vector3 a = F.col(0);
      sigma += 0.5 * m.mu * (a.squaredNorm() - 1) * a * a.transpose() / F.determinant();
      break;
    }
    case exchanged_shears:
      return exchanged(sigma);
    case shears_with_13_first:
      return check::in_order({1, 0, 2}, sigma);
    case doubled_shear:
      return sheared(sigma, 2);
    case spectral_blow_up:
    case spectral_noise:
    case spectral_wrong_limit:
      return hencky(m, F);
    case finite_of_nan:
      if (!sigma.allFinite()) sigma.setZero();
      break;
    case prestressed:
      sigma += 1e-2 * m.mu * F * F.transpose() / F.determinant();
      break;
    default:
      break;
  }
  return sigma;
}

/// d sigma / d F of neo_hookean: l = dF F^-1.
check::Tangent tangent_of(const Model& m, const Tensor& F) {
  const Tensor I = Tensor::Identity(), b = F * F.transpose();
  const double J = F.determinant();
  check::Tangent A;
  for (int c = 0; c < 9; ++c) {
    Tensor dF = Tensor::Zero();
    component(dF, c) = 1;
    const Tensor l = dF * F.inverse();
    const Tensor d = (m.lambda * l.trace() * (1 - std::log(J)) * I - m.mu * l.trace() * (b - I) +
                      m.mu * (l * b + b * l.transpose())) /
                     J;
    for (int r = 0; r < 9; ++r) A(r, c) = component(d, r);
  }
  return A;
}

/// The stiffness that `healing` gains, as from nothing, with the largest stretch so far.
double stiffening(const Model& m, double state) { return m.defect == healing ? 1 + 2 * state : 1; }

void update(void* self, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
            std::int32_t* status, double*, char* message) {
  auto& m = *static_cast<Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = read(step->F1, n, p);
    const double stretched = (F * F.transpose()).trace() - 3;
    state1[p] = stretched > state0[p] ? stretched : state0[p];
    Tensor of = m.defect == of_mid_step        ? Tensor(0.5 * (read(step->F0, n, p) + F))
                : m.defect == of_the_beginning ? read(step->F0, n, p)
                                               : F;
    if (m.defect == static_scratch) of = by_way_of_statics(of);
    if (m.defect == swells) of /= 1 + 0.1 * (step->t + step->dt);
    const double factor = near_limit(m, stretched);
    const Tensor sigma = factor * stiffening(m, state1[p]) * cauchy_of(m, of);
    for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = component(sigma, static_cast<int>(c));
    status[p] = factor > 0 ? ASSAY_GOOD : ASSAY_FAILED;
    if (m.defect == calls_an_absent_routine && stretched > 1e-3) {
      status[p] = ASSAY_FAILED;
      std::strcpy(message, "the model called dgesv_, which nobody provides");
    }
    if (m.defect == moves_its_limit && !(factor > 0)) m.limit = 1.05 * stretched;
  }
}

std::int32_t initial_state(void*, std::size_t n, const double* cauchy, double* state) {
  for (std::size_t p = 0; p < n; ++p) state[p] = 0;
  return read(cauchy, n, 0).isZero(0) ? ASSAY_GOOD : ASSAY_FAILED;
}

std::int32_t tangent(void* self, const assay_step* step, std::size_t n, const double* state0, double* out) {
  const auto& m = *static_cast<const Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor F = read(step->F1, n, p);
    check::Tangent A = tangent_of(m, F);
    const auto others = check::other_conventions(A, cauchy_of(m, F), F);
    if (m.defect >= transposed_tangent && m.defect <= strain_tangent) {
      constexpr std::size_t place[] = {0, 1, 2, 3, 5, 4};
      A = others[place[m.defect - transposed_tangent]].second;
    }
    if (m.defect == tangent_off_by_five_percent) A(0, 0) *= 1.05;
    if (m.defect == doubled_tangent) A *= 2;
    if (m.defect == tangent_of_small_strain) A = tangent_of(m, Tensor::Identity());
    if (m.defect == tangent_of_tensor_shears || m.defect == tangent_of_one_halved_shear) {
      const Tensor inverse = F.inverse();
      const double factor = m.defect == tangent_of_tensor_shears ? 2 : 0.5;
      const check::Tangent whole = A;
      for (int c = 0; c < 9; ++c) {
        Tensor dF = Tensor::Zero();
        component(dF, c) = 1;
        Tensor d = dF * inverse;
        d = (0.5 * (d + d.transpose())).eval();
        d.diagonal().setZero();
        if (factor < 1) d(0, 2) = d(2, 0) = d(1, 2) = d(2, 1) = 0;
        const Tensor sheared_by = d * F;
        for (int r = 0; r < 9; ++r) {
          for (int k = 0; k < 9; ++k) A(r, c) += (factor - 1) * whole(r, k) * component(sheared_by, k);
        }
      }
    }
    const Vector3 l = Eigen::SelfAdjointEigenSolver<Tensor>(F * F.transpose()).eigenvalues();
    const double least = std::min(l(1) - l(0), l(2) - l(1));
    if (m.defect == tangent_without_limit && least < 1e-14) A.setConstant(NAN);
    for (std::size_t k = 0; k < 81; ++k) {
      out[k * n + p] = A(static_cast<int>(k / 9), static_cast<int>(k % 9));
    }
  }
  (void)state0;
  return ASSAY_GOOD;
}

std::int32_t energy(void* self, std::size_t n, const double* F, const double* state, double* out) {
  const auto& m = *static_cast<const Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const Tensor A = read(F, n, p);
    const double ln_J = std::log(A.determinant());
    out[p] = 0.5 * m.lambda * ln_J * ln_J - m.mu * ln_J + 0.5 * m.mu * ((A * A.transpose()).trace() - 3);
    out[p] *= stiffening(m, state[p]) * (m.defect == doubled_energy ? 2 : 1);
  }
  return ASSAY_GOOD;
}

const void* extension(const char* id) {
  static const assay_tangent tangents{sizeof(assay_tangent), tangent};
  static const assay_energy energies{sizeof(assay_energy), energy};
  if (std::string(id) == ASSAY_EXTENSION_TANGENT) return &tangents;
  return std::string(id) == ASSAY_EXTENSION_ENERGY ? &energies : nullptr;
}

const void* energy_alone(const char* id) { return std::string(id) == ASSAY_EXTENSION_ENERGY ? extension(id) : nullptr; }

const assay_material* table(int extensions) {
  static const assay_parameter parameters[] = {{"mu", "Pa", 400, -1e12, 1e12, "shear modulus"},
                                               {"lambda", "Pa", 600, -1e12, 1e12, "Lame's first"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable state[] = {
      {"largest", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "tr C - 3, largest so far"}};
  static assay_material made[3];
  assay_material& t = made[extensions];
  t = named_table("total_for_tests", 0, parameters, state);
  t.create = [](const double* p, char*) -> void* { return new Model{p[0], p[1], static_cast<int>(p[2])}; };
  t.destroy = [](void* self) { delete static_cast<Model*>(self); };
  t.initial_state = initial_state;
  t.update = update;
  t.extension = extensions == 2 ? extension : extensions == 1 ? energy_alone : nullptr;
  return &t;
}

}  // namespace

std::vector<Subject> subjects() {
  using namespace check::causes;
  const std::vector<std::tuple<const char*, Defect, std::string>> list{
      {"neo_hookean", none, ""},
      {"single_precision", single_precision, ""},
      {"second_piola", second_piola, rotation_missing},
      {"first_piola", first_piola, not_symmetric},
      {"unturned", unturned, rotation_missing},
      {"small_strain_total", small_strain_total, small_strain},
      {"fixed_axis", fixed_axis, not_indifferent},
      {"fibre", fibre, not_isotropic},
      {"exchanged_shears", exchanged_shears, components_swapped},
      {"shears_with_13_first", shears_with_13_first, other_order},
      {"doubled_shear", doubled_shear, shear_factor},
      {"spectral_blow_up", spectral_blow_up, repeated_stretch},
      {"spectral_noise", spectral_noise, repeated_stretch},
      {"spectral_wrong_limit", spectral_wrong_limit, repeated_stretch},
      {"transposed_tangent", transposed_tangent, tangent_convention},
      {"column_major_tangent", column_major_tangent, tangent_convention},
      {"kirchhoff_tangent", kirchhoff_tangent, tangent_convention},
      {"piola_tangent", piola_tangent, tangent_convention},
      {"jaumann_tangent", jaumann_tangent, tangent_convention},
      {"strain_tangent", strain_tangent, tangent_convention},
      {"doubled_tangent", doubled_tangent, tangent_wrong},
      {"tangent_off_by_five_percent", tangent_off_by_five_percent, tangent_wrong},
      {"tangent_of_small_strain", tangent_of_small_strain, tangent_wrong},
      {"tangent_without_limit", tangent_without_limit, tangent_wrong},
      {"tangent_of_tensor_shears", tangent_of_tensor_shears, tangent_wrong},
      {"tangent_of_one_halved_shear", tangent_of_one_halved_shear, tangent_wrong},
      {"doubled_energy", doubled_energy, check::causes::energy},
      {"healing", healing, dissipation},
      {"finite_of_nan", finite_of_nan, not_a_number},
      {"prestressed", prestressed, stress_at_rest},
      {"turned_back", turned_back, wrong_spin},
      {"stress_of_the_beginning", of_the_beginning, no_stress},
      {"of_mid_step", of_mid_step, undeclared_increment},
      {"unsigned_volume", unsigned_volume, not_a_number},
      {"stiffer_at_once", stiffer_at_once, jump},
      {"refuses_large_stretches", refuses_large_stretches, ""},
      {"moves_its_limit", moves_its_limit, hidden_state},
      {"static_scratch", static_scratch, hidden_state},
      {"swells", swells, grows},
      {"calls_an_absent_routine", calls_an_absent_routine, missing_routine}};
  std::vector<Subject> subjects;
  for (const auto& [name, defect, cause] : list) {
    const bool has_both = defect == none || (defect >= transposed_tangent && defect <= doubled_energy);
    subjects.push_back({name,
                        Material(table(has_both            ? 2
                                       : defect == healing ? 1
                                                           : 0),
                                 {{"defect", static_cast<double>(defect)}}),
                        cause});
  }
  // K = lambda + 2 mu / 3; the energy fits, and C11 is positive: waves have a speed
  const std::tuple<const char*, double, double> negative[] = {
      {"swells_under_pressure", 400, -500}, {"little_less_than_no_bulk", 400, -270}, {"negative_shear", -200, 600}};
  for (const auto& [name, mu, lambda] : negative) {
    subjects.push_back({name, Material(table(2), {{"mu", mu}, {"lambda", lambda}, {"defect", none}}), not_positive});
  }
  return subjects;
}

}  // namespace assay::check_tests::total_mutants
