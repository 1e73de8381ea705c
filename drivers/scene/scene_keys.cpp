// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

#include "drivers/scene/key_values.hpp"

namespace assay::drivers {

namespace {

const auto bears_tractions = [](const Motion& motion) { return motion->bears_tractions(); };
const auto may_repeat = [](const Motion& motion) { return motion->may_repeat(); };

bool is_jittered(const Scene& scene) { return scene.body.lattice == Body::Lattice::jittered; }

#define IF(condition) [](const Scene& s) { return condition; }

std::vector<Key> body_keys() {
  const std::vector<std::string> cornered{"square", "box"};
  return {
      key("material.adapter",
          "registered name, shared library (lib.so or lib.so:name), Fortran source or description (.yaml)",
          ASSAY_AT(material.adapter), {.required = true}),
      key("material.density", "density rho0 in the reference configuration [kg/m^3]", ASSAY_AT(material.density),
          {.range = positive,
           .derived = "of the material's description; required where it has none",
           .shown = IF(s.material.density > 0)}),
      key("material.direction",
          "axis of the model, any length; components on e_R, e_Theta, e_Z in the vortex, else on the coordinate axes",
          ASSAY_AT(material.direction), {.derived = "[1, 0, 0] of a model that has one"}),
      key("material.isolation",
          "where the model's code runs: in worker processes (worker) or in the process of assay (none)",
          ASSAY_AT(material.isolation),
          {.choices = {"worker", "none"},
           .derived = "worker for UMAT, VUMAT and MFront, none for native models",
           .shown = IF(s.material.isolation != Isolation::automatic)}),
      key("body.domain", "shape; a ring takes its radii from the motion, square and box are given by their corners",
          ASSAY_AT(body.domain), {.derived = "ring for the vortex and the twisting ring, square otherwise"}),
      key("body.outside", "what surrounds the ring in a square or box: fixed (held) or free to move (free)",
          ASSAY_AT(body.outside),
          {.derived = "free for a ring, held for square and box", .motions = types_of(is_vortex)}),
      key("body.lower", "lower corner of a square or box [m]", ASSAY_AT(body.lower), {.domains = cornered}),
      key("body.upper", "upper corner of a square or box [m]", ASSAY_AT(body.upper), {.domains = cornered}),
      key("body.per_cell", "particles per cell in each direction", ASSAY_AT(body.per_cell),
          {.range = {.lower = 1, .upper = 16, .whole = true}}),
      key("body.lattice",
          "particle positions: square lattice, sectors of rings, Gauss points of the cells, or random offsets",
          ASSAY_AT(body.lattice)),
      key("body.cut", "lattice cells at the ring's edges: clipped to the ring, or whole if their centre is inside",
          ASSAY_AT(body.cut),
          {.derived = "clipped with domain_average and of the twisting ring, whole with point",
           .domains = {"ring"},
           .shown = IF(s.body.lattice != Body::Lattice::polar)}),
      key("body.jitter", "jittered lattice: bound on the random offset along each axis [distance between particles]",
          ASSAY_AT(body.jitter),
          {.range = {.lower = 0, .upper = 0.5, .lower_open = true}, .derived = "0.25", .shown = IF(is_jittered(s))}),
      key("body.seed", "jittered lattice: seed of the random offsets", ASSAY_AT(body.seed),
          {.range = {.lower = 0, .upper = 1e9, .whole = true}, .derived = "1", .shown = IF(is_jittered(s))}),
      key("body.periodic",
          "directions in which the body repeats; unit box: other faces at whole metres are symmetry planes",
          ASSAY_AT(body.periodic), {.motions = types_of(may_repeat), .domains = cornered}),
      key("body.initial_velocity.velocity", "velocity at the origin [m/s]", ASSAY_IN(body.initial_velocity, velocity)),
      key("body.initial_velocity.spin", "angular velocity about E_z through the origin [rad/s]",
          ASSAY_IN(body.initial_velocity, spin)),
      key("body.initial_velocity.stretching", "symmetric part of the velocity gradient: D11, D22, D12 [1/s]",
          ASSAY_IN(body.initial_velocity, stretching)),
      key("grid.spacing", "node spacing h [m]; nodes are at multiples of h", ASSAY_IN(grid, spacing),
          {.range = positive, .required = true}),
      key("grid.offset", "shift of the nodes from multiples of h; the body is not shifted [h]", ASSAY_IN(grid, offset),
          {.range = {.lower = 0, .upper = 1}, .derived = "[0, 0]"}),
      key("grid.lower", "lower corner of the grid [m]", ASSAY_IN(grid, lower),
          {.derived = "around the body with a margin"}),
      key("grid.upper", "upper corner of the grid [m]", ASSAY_IN(grid, upper),
          {.derived = "around the body with a margin"}),
  };
}

std::vector<Key> method_keys() {
  return {
      key("method.basis", "grid basis: " + mpm::bases_in_words(), ASSAY_IN(method, basis)),
      key("method.formulation",
          "configuration of basis functions and force integration: current (updated) or reference (total)",
          ASSAY_IN(method, formulation)),
      key("method.transfer", "how the grid updates the velocities of the particles", ASSAY_IN(method, transfer)),
      key("method.affine", "what apic and aflip carry: the velocity gradient (exact) or its moment (angular momentum)",
          ASSAY_IN(method, affine), {.derived = "gradient", .shown = IF(s.method->is_affine())}),
      key("method.flip", "share of the particle's own velocity in flip and aflip; the rest comes from the grid",
          ASSAY_IN(method, flip),
          {.range = {.lower = 0, .upper = 1}, .derived = "1", .shown = IF(s.method->keeps_velocity())}),
      key("method.update",
          "when the stress is updated: first, last, or last with velocities mapped again from the particles",
          ASSAY_IN(method, update)),
      key("method.integrator",
          "order 1 (symplectic_euler), 2 (leapfrog, velocities at half steps) or 4 (four force evaluations a step)",
          ASSAY_IN(method, integrator)),
      key("method.mass", "mass matrix: lumped by row sums, a series for its inverse, or the full matrix",
          ASSAY_IN(method, mass)),
      key("method.terms", "number of terms k of the mass series, of xpic and of fmpm", ASSAY_IN(method, terms),
          {.range = {.lower = 1, .upper = 100, .whole = true}, .derived = "2", .shown = IF(s.method->has_terms())}),
      key("method.courant", "Courant number of the fastest wave on the baseline path plus the fastest particle",
          ASSAY_IN(method, courant), {.range = {.lower = 0, .upper = 1, .lower_open = true}}),
      key("force.response", "source of the stress tau on the baseline path; none: no body force",
          ASSAY_AT(force.response)),
      key("force.evaluation", "body force at the particle's reference position, or averaged over its reference domain",
          ASSAY_AT(force.evaluation)),
      key("force.inertia",
          "grid: all of b acts through the grid; particles: they receive its part a (uses the exact solution)",
          ASSAY_AT(force.inertia)),
      key("force.radii", "number of histories that response: shadow steps during the run", ASSAY_AT(force.radii),
          {.range = {.lower = 4, .upper = 1e6, .whole = true}}),
      key("force.cache", "keep the sheet on disk and reuse it in later runs", ASSAY_AT(force.cache)),
      key("force.tolerance", "requested relative error of the sheet", ASSAY_AT(force.tolerance),
          {.range = {.lower = 1e-14, .upper = 1e-2}, .derived = "1e-8; 1e-5 for a UMAT, VUMAT or MFront model"}),
      key("traction.algorithm",
          "forces on domain edges, from the exact stress, at surface particles, or on edges of undeformed length",
          ASSAY_AT(traction.algorithm), {.motions = types_of(bears_tractions)}),
      key("traction.form", "sigma n ds on the current surface (follower), or P N dA0 (reference)",
          ASSAY_AT(traction.form),
          {.derived = "the stable one: reference where the body is stretched, follower where it is compressed",
           .motions = types_of(bears_tractions)}),
  };
}

std::vector<Key> remedy_keys() {
  return {
      key("remedies.anti_locking",
          "F-bar: the stress uses J averaged over cells or nodes, for nearly incompressible materials",
          ASSAY_AT(remedies.anti_locking)),
      key("remedies.largest_domain", "largest distance of a corner of a cpdi or cpdi2 domain from its particle [cells]",
          ASSAY_AT(remedies.largest_domain),
          {.range = {.lower = 0.1, .upper = 1e6},
           .derived = "as they deform",
           .shown = IF(s.remedies.largest_domain > 0)}),
      key("remedies.small_mass", "nodes lighter than this receive less force, in proportion to their mass [rho0 h^2]",
          ASSAY_AT(remedies.small_mass),
          {.range = {.lower = 0, .upper = 1, .lower_open = true},
           .derived = "all forces",
           .shown = IF(s.remedies.small_mass > 0)}),
      key("remedies.artificial_viscosity",
          "C1, C2 of the pressure rho h (C1 c + C2 h dV) dV in compression; dV is the rate of volume loss",
          ASSAY_AT(remedies.viscosity),
          {.range = {.lower = 0, .upper = 100}, .derived = "none", .shown = IF(s.remedies.has_viscosity())}),
  };
}

std::vector<Key> run_keys() {
  return {
      key("time.end", "end of the run [s]", ASSAY_AT(time.end), {.range = positive, .derived = "motion.period"}),
      key("time.step", "fixed time step dt, in place of method.courant [s]", ASSAY_AT(time.step),
          {.range = positive, .derived = "of method.courant"}),
      key("time.control",
          "planned: equal steps from the exact motion; current: steps from the present fastest wave and particle",
          ASSAY_AT(time.control)),
      key("output.errors", "number of samples of the error over the run", ASSAY_AT(output.errors),
          {.range = {.lower = 1, .upper = 1e6, .whole = true}}),
      key("output.particles", "number of snapshots of the particles (VTU) over the run; 0: none",
          ASSAY_AT(output.particles), {.range = {.lower = 0, .upper = 1e5, .whole = true}}),
      key("output.each_step_from", "also write a snapshot of every step from this time on [s]",
          ASSAY_AT(output.each_step_from), {.range = {.lower = 0}, .derived = "none"}),
      key("output.pictures", "write PNG pictures", ASSAY_AT(output.pictures)),
      key("output.report", "write report.html", ASSAY_AT(output.report)),
      key("output.accounts", "compute the accounts of mass, momentum and energy", ASSAY_AT(output.accounts)),
      key("output.tractions",
          "repeat the run with each traction algorithm on grids of 4h, 2h and h, for report.html and result.json",
          ASSAY_AT(output.tractions), {.motions = types_of(bears_tractions)}),
      key("limits.memory_gib", "refuse a run that would need more memory [GiB]", ASSAY_AT(limits.memory_gib),
          {.range = positive}),
      key("limits.particle_steps", "refuse a run of more particles times steps", ASSAY_AT(limits.particle_steps),
          {.range = positive}),
  };
}

#undef IF

/// Whether a list, of all where it is empty, has the word.
bool admits(const std::vector<std::string>& list, const std::string& word) {
  return list.empty() || is_one_of(word, list);
}

}  // namespace

const std::vector<Section>& scene_sections() {
  static const std::vector<Section> sections{
      {"motion", "the manufactured motion", true},
      {"motion.amplitude", "amplitude g(t) of the motion"},
      {"frame", "observer's frame for the vortex; without it: the body's own frame", false, true,
       [](Scene& s) { s.frame.emplace(); }},
      {"material", "the constitutive model", true},
      {"material.parameters", "material parameters by name, in SI units", false, false, nullptr, true},
      {"body", "the particles"},
      {"body.initial_velocity",
       "initial velocity of a free body, with force.response: none; without it: that of the motion", false, true,
       [](Scene& s) { s.body.initial_velocity.emplace(); }},
      {"grid", "the background grid", false, true, [](Scene& s) { s.grid.emplace(); }},
      {"method", "the particle method; without it, a scene can only be tabulated, evaluated and checked", false, true,
       [](Scene& s) { s.method.emplace(); }},
      {"force", "the body force"},
      {"traction", "how prescribed tractions act on the grid"},
      {"remedies", "cures for known weaknesses of a method; each has a cost, and none is on by default"},
      {"time", "duration and time steps"},
      {"output", "what is written"},
      {"limits", "limits on the memory and the work of a run"},
      {"expect", "expected results, by key of result.json", false, false, nullptr, true},
  };
  return sections;
}

const std::vector<Key>& scene_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all = motion_keys();
    for (const auto& part : {body_keys(), method_keys(), remedy_keys(), run_keys()}) append_all(all, part);
    return all;
  }();
  return keys;
}

bool of_motion(const Key& key, const Scene& scene) { return admits(key.motions, motion_type(scene)); }

bool applies(const Key& key, const Scene& scene) {
  return of_motion(key, scene) && admits(key.domains, domain_name(scene.body.domain));
}

bool applies(const Section& section, const Scene& scene) {
  const auto& keys = scene_keys();
  return section.free_keys || std::any_of(keys.begin(), keys.end(), [&](const Key& key) {
           return key.path.starts_with(section.path + ".") && applies(key, scene);
         });
}

std::vector<std::string> names_under(const std::string& section, const Scene* scene) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& path) {
    if (parent_of(path) == section) names.push_back(last_part(path));
  };
  for (const Key& key : scene_keys()) {
    if (!scene || applies(key, *scene)) add(key.path);
  }
  for (const Section& part : scene_sections()) {
    if (!scene || applies(part, *scene)) add(part.path);
  }
  return names;
}

std::string domain_name(Body::Domain domain) { return word_of(domain); }

}  // namespace assay::drivers
