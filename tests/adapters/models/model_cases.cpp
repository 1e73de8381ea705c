// SPDX-License-Identifier: BSD-3-Clause
#include "tests/adapters/models/model_cases.hpp"

#include <ostream>

#include "tests/adapters/models/references/drucker_prager.hpp"
#include "tests/adapters/models/references/elastic.hpp"
#include "tests/adapters/models/references/hypoelastic.hpp"
#include "tests/adapters/models/references/j2_jaumann.hpp"
#include "tests/adapters/models/references/j2_multiplicative.hpp"
#include "tests/adapters/models/references/viscoplastic.hpp"
#include "tests/adapters/models/references/zener.hpp"

namespace assay::model_tests {

namespace {

using Cases = std::vector<ModelCase>;

constexpr int slices = 60;  ///< of a history, in each of which a regime may change once

Parameters moduli(double E, double nu) { return {{"E", E}, {"nu", nu}}; }

Parameters joined(Parameters a, const Parameters& b) {
  a.insert(b.begin(), b.end());
  return a;
}

void add_elastic(Cases& all, double E, double nu, double peak) {
  const Lame c(E, nu);
  all.push_back({"neo_hookean", "neo_hookean", moduli(E, nu), peak,
                 [=](const History& h) { return neo_hookean_stress(c, h.F(h.end)); }});
  all.push_back({"saint_venant_kirchhoff", "saint_venant_kirchhoff", moduli(E, nu), peak,
                 [=](const History& h) { return saint_venant_kirchhoff_stress(c, h.F(h.end)); }});
}

void add_hypoelastic(Cases& all, double E, double nu, double peak) {
  const std::pair<const char*, Spin> rates[] = {{"hypoelastic_jaumann", jaumann_spin},
                                                {"hypoelastic_green_naghdi", green_naghdi_spin},
                                                {"hypoelastic_logarithmic", logarithmic_spin}};
  for (const auto& [name, spin] : rates) {
    all.push_back({name, name, moduli(E, nu), peak, [=, s = spin](const History& h) {
                     return hypoelastic_stress(h, {E, nu}, s);
                   }});
  }
}

void add_mooney_rivlin(Cases& all, double c10, double c01, double kappa, double peak) {
  all.push_back({"mooney_rivlin",
                 "mooney_rivlin",
                 {{"c10", c10}, {"c01", c01}, {"bulk_modulus", kappa}},
                 peak,
                 [=](const History& h) { return mooney_rivlin_stress(c10, c01, kappa, h.F(h.end)); }});
}

void add_orthotropic(Cases& all, const Orthotropy& c, double peak) {
  const Parameters parameters{{"E_r", c.E_r},     {"E_t", c.E_t},     {"E_z", c.E_z},
                              {"nu_rt", c.nu_rt}, {"nu_rz", c.nu_rz}, {"nu_tz", c.nu_tz},
                              {"G_rt", c.G_rt},   {"G_rz", c.G_rz},   {"G_tz", c.G_tz}};
  all.push_back({"orthotropic_cylindrical", "orthotropic_cylindrical", parameters, peak,
                 [=](const History& h) { return orthotropic_stress(c, h.F(h.end), h.direction); }});
}

void add_fluid(Cases& all, const Fluid& c, double peak) {
  const Parameters parameters{{"bulk_modulus", c.modulus},
                              {"viscosity", c.viscosity},
                              {"bulk_viscosity", c.bulk_viscosity},
                              {"exponent", c.exponent}};
  all.push_back({"compressible_fluid", "compressible_fluid", parameters, peak,
                 [=](const History& h) { return fluid_stress(c, h.F(h.end), velocity_gradient(h, h.end)); }});
}

void add_zener(Cases& all, double E, double nu, double ratio, double time, double peak) {
  all.push_back({"zener", "zener", joined(moduli(E, nu), {{"viscous_ratio", ratio}, {"relaxation_time", time}}), peak,
                 [=](const History& h) {
                   return zener_stress(h, {E, nu}, ratio, time);
                 }});
}

void add_viscoplastic(Cases& all, const Viscoplasticity& c, double peak) {
  Parameters parameters =
      joined(moduli(c.E, c.nu), {{"reference_rate", c.rate}, {"reference_stress", c.stress}, {"exponent", c.exponent}});
  const char* name = c.yield_stress > 0 ? "perzyna" : "norton";
  if (c.yield_stress > 0) {
    parameters = joined(parameters, {{"yield_stress", c.yield_stress}, {"hardening_modulus", c.hardening}});
  }
  all.push_back({name, name, parameters, peak, [=](const History& h) { return viscoplastic_point(c, h, 100).cauchy; }});
}

void add_j2(Cases& all, const std::string& set, const Hardening& c, double peak) {
  all.push_back({"j2_jaumann_" + set, "j2_jaumann", c.parameters(), peak,
                 [=](const History& h) { return j2_jaumann::integrated(c, h, slices).stress; }});
  all.push_back({"j2_multiplicative_" + set, "j2_multiplicative", c.parameters(), peak,
                 [=](const History& h) { return j2_multiplicative::integrated(c, h, slices).stress; }});
}

void add_cone(Cases& all, const drucker_prager::Cone& c, double peak) {
  const Parameters parameters = joined(moduli(c.E, c.nu), {{"cohesion", c.cohesion},
                                                           {"friction", c.friction},
                                                           {"dilatancy", c.dilatancy},
                                                           {"hardening_modulus", c.hardening}});
  all.push_back({"drucker_prager", "drucker_prager", parameters, peak,
                 [=](const History& h) { return drucker_prager::reference(c, h).cauchy; }});
}

void add_damage(Cases& all, const Damage& c, double peak) {
  const Parameters parameters =
      joined(moduli(c.E, c.nu), {{"kappa_0", c.kappa_0}, {"kappa_f", c.kappa_f}, {"D_max", c.D_max}});
  all.push_back({"damage", "damage", parameters, peak, [=](const History& h) { return damage_stress(c, h, 1); }});
}

void number(Cases& all) {
  for (std::size_t i = 0; i < all.size(); ++i) all[i].name += "_" + std::to_string(i);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const ModelCase& c) { return out << c.name; }

std::vector<ModelCase> quick_model_cases() {
  Cases all;
  add_elastic(all, 1000, 0.3, 1);
  add_hypoelastic(all, 1000, 0.3, 0.12);
  add_mooney_rivlin(all, 110, 60, 900, 0.7);
  add_orthotropic(all, {1000, 2500, 1600, 0.2, 0.3, 0.4, 450, 500, 700}, 0.4);
  add_fluid(all, {2000, 30, 20, 7}, 0.5);
  add_zener(all, 1000, 0.3, 1.7, 0.3, 1);
  number(all);
  return all;
}

std::vector<ModelCase> all_model_cases() {
  Cases all;
  add_elastic(all, 2.5e4, 0.41, 0.37);
  add_elastic(all, 800, -0.2, 1.3);
  add_hypoelastic(all, 2e5, 0.37, 0.4);
  add_hypoelastic(all, 700, 0.1, 1);
  add_mooney_rivlin(all, 40, 80, 3000, 1.1);
  add_orthotropic(all, {900, 400, 2000, 0.25, -0.1, 0.05, 300, 150, 250}, 1);
  add_fluid(all, {2000, 300, 0, 1}, 1.2);
  add_zener(all, 5e4, 0.45, 0.4, 0.05, 0.3);
  add_zener(all, 1000, 0.2, 6, 3, 1.2);
  add_viscoplastic(all, {1000, 0.3, 0, 0, 0.5, 30, 1}, 0.2);
  add_viscoplastic(all, {1000, 0.3, 0, 0, 0.5, 60, 3}, 0.1);
  add_viscoplastic(all, {2e4, 0.4, 0, 0, 0.1, 500, 2}, 0.3);
  add_viscoplastic(all, {1000, 0.3, 20, 30, 0.5, 30, 1}, 0.1);
  add_viscoplastic(all, {1000, 0.3, 40, 0, 0.2, 60, 3}, 0.1);
  add_j2(all, "perfect", {20, 0, 0, 0, 0, 1000, 0.3}, 0.1);
  add_j2(all, "linear", {250, 900, 0, 0, 0, 2e4, 0.35}, 0.06);
  add_j2(all, "voce", {20, 30, 15, 12, 0, 1000, 0.3}, 0.15);
  add_j2(all, "back_stress", {20, 30, 15, 12, 80, 1000, 0.2}, 0.1);
  add_cone(all, {1000, 0.3, 20, 0.25, 0.1, 30}, 0.1);
  add_cone(all, {3000, 0.2, 30, 0.15, 0.15, 0}, 0.05);
  add_damage(all, {1000, 0.3, 2, 15, 0.9}, 0.3);
  add_damage(all, {4e4, 0.4, 100, 2000, 0.7}, 0.2);
  add_viscoplastic(all, {1000, 0.3, 0, 0, 0.5, 30, 4.5}, 0.2);
  number(all);
  return all;
}

}  // namespace assay::model_tests
