// SPDX-License-Identifier: BSD-3-Clause
// A total law and one in increments that offer their rate, wave speed and closed form; a parameter plants one defect in
// what they offer.
#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::extension_mutants {

namespace {

enum Defect : int {
  none,
  rate_without_spin,
  rate_of_another_stiffness,
  half_wave_speed,
  closed_form_of_another_stiffness,
  halved_slope,
  closed_form_of_no_number,
  slope_of_no_number,
  defects
};

/// P and d P / d eps along F = I + eps E1 E1 [Pa]: 11, and 22 = 33.
struct Uniaxial {
  double axial, lateral, axial_slope, lateral_slope;
};

struct Parameters {
  double mu, lambda;
  int defect;
  explicit Parameters(const double* p) : mu(p[0]), lambda(p[1]), defect(static_cast<int>(p[2])) {}
  void misbehave(std::size_t, double*, double*) const {}
};

/// Neo-Hookean elasticity (34).
struct Total : Parameters {
  static constexpr std::size_t state_size = 0;
  using Parameters::Parameters;

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const double J = step.F1.determinant();
    if (!(J > 0)) return std::nullopt;
    const Tensor b = step.F1 * step.F1.transpose();
    return (lambda * std::log(J) * Tensor::Identity() + mu * (b - Tensor::Identity())) / J;
  }
  bool rest(const Tensor&, double*) const { return true; }

  Tensor rate(const Tensor& F, const Tensor& l, const Tensor&) const {
    const double J = F.determinant();
    const Tensor I = Tensor::Identity(), b = F * F.transpose();
    return (lambda * l.trace() * (1 - std::log(J)) * I - mu * l.trace() * (b - I) + mu * (l * b + b * l.transpose())) /
           J;
  }
  double stiffest(const Tensor& F) const { return lambda + mu * (1 + F.squaredNorm()); }
  Uniaxial uniaxial(double F, double m) const {
    const double ln = std::log(F);
    return {m * (F - 1 / F) + lambda * ln / F, lambda * ln, m * (1 + 1 / (F * F)) + lambda * (1 - ln) / (F * F),
            lambda / F};
  }
};

/// The Jaumann rate of the Cauchy stress, which is the state, is that of linear elasticity.
struct Incremental : Parameters {
  static constexpr std::size_t state_size = 9;
  using Parameters::Parameters;

  Tensor elastic(const Tensor& d) const { return lambda * d.trace() * Tensor::Identity() + 2 * mu * d; }
  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    if (!(step.F1.determinant() > 0)) return std::nullopt;
    const Tensor l = (step.F1 - step.F0) * (0.5 * (step.F0 + step.F1)).inverse();
    const Tensor Q = cayley(0.5 * (l - l.transpose()));
    const Tensor sigma = Q * read(state0, 1, 0) * Q.transpose() + elastic(0.5 * (l + l.transpose()));
    write(sigma, state1, 1, 0);
    return sigma;
  }
  bool rest(const Tensor& cauchy, double* state) const {
    write(cauchy, state, 1, 0);
    return true;
  }

  Tensor rate(const Tensor&, const Tensor& l, const Tensor& sigma) const {
    const Tensor w = 0.5 * (l - l.transpose());
    return elastic(0.5 * (l + l.transpose())) + w * sigma - sigma * w;
  }
  double stiffest(const Tensor&) const { return 2 * (lambda + 2 * mu); }
  Uniaxial uniaxial(double F, double m) const {
    const double ln = std::log(F);
    return {(lambda + 2 * m) * ln, lambda * F * ln, (lambda + 2 * m) / F, lambda * (1 + ln)};
  }
};

template <class Model>
std::int32_t rate(void* self, double, std::size_t n, const double* F, const double* l, const double* cauchy,
                  const double*, double* cauchy_rate, double* state_rate) {
  const auto& model = *static_cast<const Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    Tensor gradient = read(l, n, p);
    if (model.defect == rate_without_spin) gradient = (0.5 * (gradient + gradient.transpose())).eval();
    const double stiffer = model.defect == rate_of_another_stiffness ? 1.2 : 1;
    const Tensor found = stiffer * model.rate(read(F, n, p), gradient, read(cauchy, n, p));
    write(found, cauchy_rate, n, p);
    if (Model::state_size > 0) write(found, state_rate, n, p);
  }
  return ASSAY_GOOD;
}

/// An upper bound for the strains of the battery.
template <class Model>
std::int32_t wave_speed(void* self, double density, std::size_t n, const double* F, const double*, const double*,
                        double* speed) {
  const auto& model = *static_cast<const Model*>(self);
  for (std::size_t p = 0; p < n; ++p) {
    const double c = std::sqrt(model.stiffest(read(F, n, p)) / density);
    speed[p] = model.defect == half_wave_speed ? 0.4 * c : c;
  }
  return ASSAY_GOOD;
}

template <class Model>
std::int32_t closed_form(void* self, std::int32_t baseline, std::size_t n, const double* eps, double* tau,
                         double* slope) {
  const auto& model = *static_cast<const Model*>(self);
  if (baseline != ASSAY_BASELINE_UNIAXIAL_STRAIN) return ASSAY_FAILED;  // there is none of simple shear
  std::fill_n(tau, 9 * n, 0.0);
  std::fill_n(slope, 9 * n, 0.0);
  const double stiffer = model.defect == closed_form_of_another_stiffness ? 1.2 : 1;
  const double part = model.defect == halved_slope ? 0.5 : 1;
  for (std::size_t p = 0; p < n; ++p) {
    const Uniaxial found = model.uniaxial(1 + eps[p], stiffer * model.mu);
    tau[p] = found.axial, slope[p] = part * found.axial_slope;
    for (const std::size_t c : {4, 8}) tau[c * n + p] = found.lateral, slope[c * n + p] = part * found.lateral_slope;
    if (model.defect == closed_form_of_no_number) tau[8 * n + p] = NAN;
    if (model.defect == slope_of_no_number) slope[8 * n + p] = NAN;
  }
  return ASSAY_GOOD;
}

template <class Model>
const void* extension(const char* id) {
  static const assay_rate rates{sizeof(assay_rate), rate<Model>};
  static const assay_wave_speed speeds{sizeof(assay_wave_speed), wave_speed<Model>};
  static const assay_closed_form forms{sizeof(assay_closed_form), closed_form<Model>};
  const std::string asked = id;
  if (asked == ASSAY_EXTENSION_RATE) return &rates;
  if (asked == ASSAY_EXTENSION_WAVE_SPEED) return &speeds;
  return asked == ASSAY_EXTENSION_CLOSED_FORM ? &forms : nullptr;
}

}  // namespace

std::vector<Subject> subjects() {
  static const assay_parameter parameters[] = {{"mu", "Pa", 400, 0, 1e12, "shear modulus"},
                                               {"lambda", "Pa", 600, 0, 1e12, "Lame's first"},
                                               {"defect", "1", 0, 0, defects - 1, "which"}};
  static const assay_state_variable stress[] = {{"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"}};
  static const assay_material total = [] {
    assay_material t = table_of<Total>("offering_for_tests", 0, parameters, {});
    t.extension = extension<Total>;
    return t;
  }();
  static const assay_material incremental = [] {
    assay_material t = table_of<Incremental>("offering_increments_for_tests", ASSAY_USES_INCREMENT, parameters, stress);
    t.extension = extension<Incremental>;
    return t;
  }();
  using namespace check::causes;
  std::vector<Subject> all;
  add(all, &total,
      {{"offering", none, ""},
       {"rate_without_spin", rate_without_spin, rate_form},
       {"rate_of_another_stiffness", rate_of_another_stiffness, rate_form},
       {"half_wave_speed", half_wave_speed, check::causes::wave_speed},
       {"closed_form_of_another_stiffness", closed_form_of_another_stiffness, check::causes::closed_form},
       {"halved_slope", halved_slope, check::causes::closed_form},
       {"closed_form_of_no_number", closed_form_of_no_number, check::causes::closed_form},
       {"slope_of_no_number", slope_of_no_number, check::causes::closed_form}});
  add(all, &incremental,
      {{"offering_increments", none, ""},
       {"rate_of_increments_without_spin", rate_without_spin, rate_form},
       {"half_wave_speed_of_increments", half_wave_speed, check::causes::wave_speed},
       {"closed_form_of_other_increments", closed_form_of_another_stiffness, check::causes::closed_form}});
  return all;
}

}  // namespace assay::check_tests::extension_mutants
