// SPDX-License-Identifier: BSD-3-Clause
// Of each optional effect a scene with it and the same without: what its tests look at, and what its price is measured
// with.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "mpm/compose.hpp"

namespace assay::bench {

struct EffectScene {
  std::string effect;                      ///< its name
  std::string scene;                       ///< below configs/, without .yaml
  std::vector<std::string> without, with;  ///< settings
};

/// For the messages of tests.
inline void PrintTo(const EffectScene& way, std::ostream* out) { *out << "of " << way.scene; }

/// Settings of a scene that is short and has no effect around its steps but the comparison itself.
inline std::vector<std::string> quiet() {
  return {"expect={}", "output={errors: 1, particles: 0, pictures: false, report: false, accounts: false}"};
}

/// The paper's vortex, coarse, with b in closed form at the particles: what the spine takes.
inline std::vector<std::string> plain() {
  return {"grid.spacing=0.125", "time.end=0.02", "force={response: closed_form, evaluation: point}"};
}

/// materials: the folder of the models' libraries.
inline std::vector<EffectScene> effect_scenes(const std::string& materials) {
  std::vector<EffectScene> list;
  const auto add = [&](const std::string& effect, const std::string& scene, const std::vector<std::string>& base,
                       const std::vector<std::string>& without, const std::vector<std::string>& with) {
    EffectScene entry{effect, scene, quiet(), quiet()};
    for (auto* sets : {&entry.without, &entry.with}) sets->insert(sets->end(), base.begin(), base.end());
    entry.without.insert(entry.without.end(), without.begin(), without.end());
    entry.with.insert(entry.with.end(), with.begin(), with.end());
    list.push_back(std::move(entry));
  };
  const auto of_vortex = [&](const std::string& effect, const std::vector<std::string>& without,
                             const std::vector<std::string>& with) {
    add(effect, "paper/vortex_cpdi", plain(), without, with);
  };
  const std::vector<std::string> biaxial{"time.end=0.02"};
  const std::string none = "force={response: none, evaluation: point}", by = "traction.algorithm=";
  const std::string total = "method={basis: bspline2, formulation: total, integrator: ";
  const std::string zener =
      "material={adapter: zener, density: 1000, parameters: "
      "{E: 1.0e3, nu: 0.3, viscous_ratio: 1.0, relaxation_time: 0.2}}";
  const std::string model =
      "material={adapter: " + materials + "/libneo_hookean.so, density: 1000, parameters: {E: 1.0e3}, ";
  of_vortex("body_force", {none}, {});
  of_vortex("averaging", {}, {"force.evaluation=domain_average", "body.cut=whole"});
  of_vortex("moving_frame", {}, {"frame={spin: 1.3}"});
  of_vortex("inertia_to_particles", {}, {"force.inertia=particles"});
  add("edge_traction", "motions/homogeneous_biaxial", biaxial, {none}, {});
  add("virtual_stress", "motions/homogeneous_biaxial", biaxial, {none}, {by + "virtual_stress"});
  add("particle_traction", "motions/homogeneous_biaxial", biaxial, {none}, {by + "particles"});
  add("undeformed_traction", "motions/homogeneous_biaxial", biaxial, {none}, {by + "undeformed_edges"});
  add("images", "motions/rigid", {none, "time.end=0.02", "motion={type: rigid, velocity: [0.6, 0.4, 0], period: 1}"},
      {}, {"body.periodic=both"});
  of_vortex("outside_held", {}, {"body={domain: square, outside: held}"});
  of_vortex("history", {none}, {none, zener});
  add("material_direction", "models/vortex_orthotropic_cylindrical", {"grid.spacing=0.125", "time.end=0.02", none},
      {zener}, {});
  of_vortex("affine_velocity", {}, {"method.transfer=apic"});
  of_vortex("convected_corners", {}, {"method.basis=cpdi2"});
  of_vortex("own_domains", {}, {"body={domain: ring, lattice: polar}"});
  of_vortex("mass_matrix", {}, {"method.mass=series"});
  of_vortex("velocity_terms", {"method.transfer=pic"}, {"method.transfer=xpic"});
  of_vortex("force_stages", {total + "symplectic_euler}"}, {total + "symplectic_rkn4}"});
  of_vortex("stress_first", {}, {"method.update=usf"});
  of_vortex("remapped_velocity", {}, {"method.update=musl"});
  for (const auto& effect : mpm::effects<2>()) {
    if (!effect.example.empty()) of_vortex(effect.name, {}, {effect.key + "=" + effect.example});
  }
  of_vortex("time_control", {}, {"time.control=current"});
  of_vortex("energy_account", {}, {"output.accounts=true"});
  of_vortex("screening", {none}, {});
  of_vortex("error_sampling", {none}, {});
  of_vortex("shadow", {}, {"force.response=shadow"});
  of_vortex("isolation", {model + "isolation: none}"}, {model + "isolation: worker}"});
  of_vortex("snapshots", {}, {"output.particles=2"});
  of_vortex("pictures", {}, {"output.pictures=true"});
  of_vortex("report", {}, {"output.report=true"});
  add("traction_table", "motions/homogeneous_biaxial", biaxial, {}, {"output.tractions=true"});
  return list;
}

}  // namespace assay::bench
