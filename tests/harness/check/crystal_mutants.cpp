// SPDX-License-Identifier: BSD-3-Clause
// Crystals that declare a class: S = C E of Green's strain in axes given by three angles, and increments whose axes are
// vectors of the state; each with a planted defect, or with another class declared than the moduli have.
#include <array>
#include <cstdint>

#include "harness/check/battery.hpp"
#include "tests/harness/check/crystal_law.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check_tests::crystal_mutants {

namespace {

constexpr std::size_t moduli_count = 11;

Matrix6 matrix_of(const double* p) {
  return CrystalModuli{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10]}.matrix();
}

/// Parameters: moduli, three angles, and the BondDefect.
struct Crystal {
  static constexpr std::size_t state_size = 0;
  Matrix6 C;

  explicit Crystal(const double* p) {
    const double* angles = p + moduli_count;
    C = turned_stiffness(matrix_of(p), crystal_axes(angles[0], angles[1], angles[2]), static_cast<int>(angles[3]));
  }

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const Tensor& F = step.F1;
    const double J = F.determinant();
    if (!(J > 0)) return std::nullopt;
    const Tensor S = tensor_of_stress(C * voigt_strain(0.5 * (F.transpose() * F - Tensor::Identity())));
    return Tensor(F * S * F.transpose() / J);
  }
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}
};

/// The same with an overstress of as much stiffness that relaxes in 0.1 s; the defect is of that alone. State: the
/// strain that it has forgotten.
struct RelaxingCrystal {
  static constexpr std::size_t state_size = 6;
  Matrix6 C, over;

  explicit RelaxingCrystal(const double* p) {
    const Tensor R = crystal_axes(p[moduli_count], p[moduli_count + 1], p[moduli_count + 2]);
    C = turned_stiffness(matrix_of(p), R, bond_right);
    over = turned_stiffness(matrix_of(p), R, static_cast<int>(p[moduli_count + 3]));
  }

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const Tensor& F = step.F1;
    if (!(F.determinant() > 0)) return std::nullopt;
    const double times = step.dt / 0.1;
    const Tensor E = 0.5 * (F.transpose() * F - Tensor::Identity());
    const Tensor forgotten = (read_symmetric(state0) + times * E) / (1 + times);
    write_symmetric(forgotten, state1);
    const Tensor S = tensor_of_stress(C * voigt_strain(E) + over * voigt_strain(E - forgotten));
    return Tensor(F * S * F.transpose() / F.determinant());
  }
  bool rest(const Tensor& cauchy, double* state) const {
    std::fill_n(state, state_size, 0.0);
    return cauchy.isZero(0);
  }
  void misbehave(std::size_t, double*, double*) const {}
};

/// How the axes of the state turn: with the body, against it, or as they are set up in the first step, not by that.
enum class Axes { right, backwards, from_the_second_step };

/// Increments of the logarithmic strain; state: stress, and the axes of the crystal, which turn.
template <Axes turn>
struct TurningCrystal {
  static constexpr std::size_t state_size = 15;
  Matrix6 C;
  Tensor axes;
  int defect;

  explicit TurningCrystal(const double* p)
      : C(matrix_of(p)),
        axes(crystal_axes(p[moduli_count], p[moduli_count + 1], p[moduli_count + 2])),
        defect(static_cast<int>(p[moduli_count + 3])) {}

  std::optional<Tensor> take(const PointStep& step, const double* state0, double* state1) const {
    const Tensor f = step.F1 * step.F0.inverse(), Q = polar(f);
    if (!(step.F1.determinant() > 0)) return std::nullopt;
    const Tensor before = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state0 + 6);
    const bool first = before.isZero(0);
    const Tensor R = first ? axes : Tensor(before * (turn == Axes::backwards ? Q : Q.transpose()));
    const Tensor strain = logarithm(f * Q.transpose());
    const Tensor increment = tensor_of_stress(turned_stiffness(C, R, defect) * voigt_strain(strain));
    const Tensor sigma = Q * read_symmetric(state0) * Q.transpose() + increment;
    write_symmetric(sigma, state1);
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state1 + 6) = R;
    return sigma;
  }
  bool rest(const Tensor& cauchy, double* state) const {
    write_symmetric(cauchy, state);
    const bool later = turn == Axes::from_the_second_step;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(state + 6) = later ? Tensor(Tensor::Zero()) : axes;
    return true;
  }
  void misbehave(std::size_t, double*, double*) const {}
};

constexpr assay_parameter parameters[] = {{"C11", "Pa", 1000, 0, 1e12, ""},
                                          {"C22", "Pa", 1000, 0, 1e12, ""},
                                          {"C33", "Pa", 1000, 0, 1e12, ""},
                                          {"C12", "Pa", 600, -1e12, 1e12, ""},
                                          {"C13", "Pa", 600, -1e12, 1e12, ""},
                                          {"C23", "Pa", 600, -1e12, 1e12, ""},
                                          {"C1212", "Pa", 500, 0, 1e12, ""},
                                          {"C1313", "Pa", 500, 0, 1e12, ""},
                                          {"C2323", "Pa", 500, 0, 1e12, ""},
                                          {"C1123", "Pa", 0, -1e12, 1e12, ""},
                                          {"C21_over_C12", "1", 1, 0, 10, ""},
                                          {"phi1", "rad", 0.4, -7, 7, "Bunge's angles"},
                                          {"Phi", "rad", 0.9, -7, 7, ""},
                                          {"phi2", "rad", 1.7, -7, 7, ""},
                                          {"defect", "1", 0, 0, bond_defects - 1, ""}};

constexpr assay_state_variable relaxing_state[] = {
    {"forgotten", "1", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "strain"}};

constexpr assay_state_variable turning_state[] = {{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, ""},
                                                  {"a", "1", ASSAY_VECTOR, ASSAY_ROLE_PLAIN, "axis of the crystal"},
                                                  {"b", "1", ASSAY_VECTOR, ASSAY_ROLE_PLAIN, "likewise"},
                                                  {"c", "1", ASSAY_VECTOR, ASSAY_ROLE_PLAIN, "likewise"}};

using Values = std::map<std::string, double>;

Values values_of(const CrystalModuli& m) {
  return {{"C11", m.C11},
          {"C22", m.C22},
          {"C33", m.C33},
          {"C12", m.C12},
          {"C13", m.C13},
          {"C23", m.C23},
          {"C1212", m.C1212},
          {"C1313", m.C1313},
          {"C2323", m.C2323},
          {"C1123", m.C1123},
          {"C21_over_C12", m.C21_over_C12}};
}

template <std::int32_t material_class>
const void* class_extension(const char* id) {
  static const assay_symmetry declared{sizeof(assay_symmetry), material_class};
  return std::string(id) == ASSAY_EXTENSION_SYMMETRY ? &declared : nullptr;
}

template <class Model, std::int32_t material_class>
const assay_material* declaring(const char* name, std::uint32_t flags, std::span<const assay_state_variable> state) {
  static const assay_material table = [&] {
    assay_material t = table_of<Model>(name, flags, parameters, state);
    t.symmetry = ASSAY_ANISOTROPIC;
    t.extension = class_extension<material_class>;
    return t;
  }();
  return &table;
}

template <std::int32_t material_class>
const assay_material* total() {
  return declaring<Crystal, material_class>("crystal_for_tests", 0, {});
}

template <std::int32_t material_class>
const assay_material* relaxing() {
  return declaring<RelaxingCrystal, material_class>("relaxing_crystal_for_tests", ASSAY_RATE_DEPENDENT, relaxing_state);
}

template <std::int32_t material_class, Axes turn = Axes::right>
const assay_material* turning() {
  return declaring<TurningCrystal<turn>, material_class>("turning_crystal_for_tests", ASSAY_USES_INCREMENT,
                                                         turning_state);
}

const CrystalModuli cube = cubic_moduli(1000, 600, 500);
const CrystalModuli beech{140, 230, 1400, 80, 100, 150, 46, 107, 161};
const CrystalModuli fibres = transversely_isotropic_moduli(120, 900, 60, 50, 45);
const CrystalModuli quartz{868, 868, 1058, 70, 119, 119, 399, 582, 582, -180};
const CrystalModuli zircon{1000, 1000, 1200, 600, 600, 600, 420, 500, 500};

// K and all shear moduli are positive: a stretch along one axis and a contraction along the next give work
const CrystalModuli slipping_cube = cubic_moduli(600, 700, 500);

CrystalModuli split_beech() {
  CrystalModuli m = beech;
  m.C12 = 190;  // the root of C11 C22 is 179
  return m;
}

CrystalModuli lamina() {
  CrystalModuli m = beech;
  m.C21_over_C12 = 1.3;
  return m;
}

CrystalModuli fibres_sheared(double factor) {
  CrystalModuli m = fibres;
  m.C1212 *= factor;
  return m;
}

void add_totals(std::vector<Subject>& all) {
  using namespace check::causes;
  add(all, total<ASSAY_CUBIC>(),
      {{"cube", bond_right, ""},
       {"cube_of_wrong_sign", bond_wrong_sign, not_of_class},
       {"cube_of_strain_as_stress", bond_of_stress, shear_factor},
       {"cube_turned_on", bond_turned_on, not_of_class},
       {"cube_of_transposed_turn", bond_transposed, not_of_class}},
      values_of(cube));
  add(all, total<ASSAY_CUBIC>(), {{"zircon_called_cubic", bond_right, not_of_class}}, values_of(zircon));
  add(all, total<ASSAY_ORTHOTROPIC>(),
      {{"beech", bond_right, ""},
       {"beech_of_another_place", bond_of_another_place, not_of_class},
       {"beech_of_two_slips", bond_of_stress_for_both, shear_factor}},
      values_of(beech));
  add(all, total<ASSAY_CUBIC>(), {{"slipping_cube", bond_right, not_positive}}, values_of(slipping_cube));
  add(all, total<ASSAY_ORTHOTROPIC>(), {{"split_beech", bond_right, not_positive}}, values_of(split_beech()));
  add(all, total<ASSAY_ORTHOTROPIC>(), {{"lamina_of_other_contraction", bond_right, dissipation}}, values_of(lamina()));
  add(all, total<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"bundle", bond_right, ""}}, values_of(fibres));
  add(all, total<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"bundle_of_wrong_shear", bond_right, not_of_class}},
      values_of(fibres_sheared(1.3)));
  add(all, total<ASSAY_TRIGONAL>(), {{"quartz", bond_right, ""}}, values_of(quartz));
  add(all, total<ASSAY_HEXAGONAL>(), {{"quartz_called_hexagonal", bond_right, not_of_class}}, values_of(quartz));
}

void add_with_a_state(std::vector<Subject>& all) {
  using namespace check::causes;
  add(all, relaxing<ASSAY_CUBIC>(),
      {{"relaxing_cube", bond_right, ""}, {"relaxing_cube_of_wrong_sign", bond_wrong_sign, not_of_class}},
      values_of(cube));
  add(all, turning<ASSAY_CUBIC>(),
      {{"turning_cube", bond_right, ""},
       {"turning_cube_of_wrong_sign", bond_wrong_sign, not_of_class},
       {"turning_cube_of_strain_as_stress", bond_of_stress, shear_factor}},
      values_of(cube));
  add(all, turning<ASSAY_CUBIC, Axes::backwards>(), {{"cube_turning_backwards", bond_right, wrong_spin}},
      values_of(cube));
  add(all, turning<ASSAY_CUBIC, Axes::from_the_second_step>(),
      {{"cube_turning_from_the_second_step", bond_right, state_not_rotated}}, values_of(cube));
  add(all, turning<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"turning_bundle", bond_right, ""}}, values_of(fibres));
  add(all, turning<ASSAY_TRANSVERSELY_ISOTROPIC>(), {{"turning_bundle_of_wrong_shear", bond_right, not_of_class}},
      values_of(fibres_sheared(0.85)));
  add(all, turning<ASSAY_CUBIC>(), {{"turning_slipping_cube", bond_right, not_positive}}, values_of(slipping_cube));
  add(all, relaxing<ASSAY_CUBIC>(), {{"relaxing_slipping_cube", bond_right, not_positive}}, values_of(slipping_cube));
  add(all, turning<ASSAY_TETRAGONAL>(), {{"zircon", bond_right, ""}}, values_of(zircon));
  add(all, turning<ASSAY_ORTHOTROPIC>(), {{"turning_lamina_of_other_contraction", bond_right, dissipation}},
      values_of(lamina()));
}

}  // namespace

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  add_totals(all);
  add_with_a_state(all);
  return all;
}

}  // namespace assay::check_tests::crystal_mutants
