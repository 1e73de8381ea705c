// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

#include "drivers/scene/key_values.hpp"
#include "drivers/scene/motion_keys.hpp"

namespace assay::drivers {

namespace {

const std::vector<std::string> isolations{"automatic", "worker", "none"};
const std::vector<std::string> domains{"ring", "square", "box"};
const std::vector<std::string> outsides{"held", "free"};
const std::vector<std::string> bases{"linear", "ugimp", "cpgimp", "cpdi", "cpdi2", "bspline2", "bspline3", "bspline4"};
const std::vector<std::string> formulations{"updated", "total"};
const std::vector<std::string> transfers{"pic", "flip", "xpic", "fmpm", "apic", "aflip"};
const std::vector<std::string> affines{"gradient", "moment"};
const std::vector<std::string> integrators{"symplectic_euler", "leapfrog", "symplectic_rkn4"};
const std::vector<std::string> masses{"lumped", "series", "consistent"};
const std::vector<std::string> updates{"usf", "usl", "musl"};
const std::vector<std::string> lattices{"cartesian", "polar", "gauss", "jittered"};
const std::vector<std::string> cuts{"clipped", "whole"};
const std::vector<std::string> evaluations{"point", "domain_average"};
const std::vector<std::string> inertias{"grid", "particles"};
const std::vector<std::string> traction_algorithms{"edges", "virtual_stress", "particles", "undeformed_edges"};
const std::vector<std::string> periodics{"none", "x", "y", "both"};
const std::vector<std::string> traction_forms{"follower", "reference"};
const std::vector<std::string> with_traction{"homogeneous", "rotating_stretch", "twisting_ring", "axis_aligned",
                                             "bar_1d"};
const std::vector<std::string> anti_lockings{"none", "cell", "node"};
const std::vector<std::string> controls{"planned", "current"};
const std::vector<std::string> responses{"none", "closed_form", "sheet", "shadow"};

#define GET(expression) [](const Scene& s) -> Value { return expression; }
#define SET(statement) [](Scene& s, const Value& v) { statement; }

// clang-format off
std::vector<Key> body_keys() {
  using enum KeyType;
  const std::vector<std::string> cornered{"square", "box"};
  return {
      {"material.adapter", text, "registered name, shared library (lib.so or lib.so:name) or description (.yaml)",
       GET(s.material.adapter), SET(s.material.adapter = std::get<std::string>(v)), {}, {}, true},
      {"material.density", number, "rho0 [kg/m^3]", GET(s.material.density > 0 ? Value(s.material.density) : Value()),
       SET(s.material.density = real(v)), positive, {}, false,
       "of the material's description; required where it has none"},
      {"material.direction", vector,
       "axis of a model that has one, normalised: along e_R, e_Theta, e_Z of the vortex, along the axes otherwise",
       GET(triple_of(s.material.direction)), SET(s.material.direction = three(v)), {}, {}, false,
       "[1, 0, 0] of a model that has one"},
      {"material.isolation", choice, "the model's code runs in processes of its own (worker) or in this one (none)",
       GET(s.material.isolation == Isolation::automatic ? Value() : name_of(isolations, s.material.isolation)),
       SET(s.material.isolation = picked<Isolation>(isolations, v)), {}, {"worker", "none"}, false,
       "worker for UMAT, VUMAT and MFront, none for native models"},
      {"body.domain", choice, "shape; the ring takes its radii from the motion, square and box have corners",
       GET(domain_name(s.body.domain)), SET(s.body.domain = picked<Body::Domain>(domains, v)), {}, domains, false,
       "ring for the vortex and the twisting ring, square otherwise"},
      {"body.outside", choice, "what surrounds the ring in a square or box stands still (held) or is left to itself",
       GET(name_of(outsides, s.body.outside)), SET(s.body.outside = picked<Body::Outside>(outsides, v)), {}, outsides,
       false, "free for a ring, held for square and box", {"vortex"}},
      {"body.lower", pair, "lower corner [m]", GET(pair_of(s.body.lower)), SET(s.body.lower = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.upper", pair, "upper corner [m]", GET(pair_of(s.body.upper)), SET(s.body.upper = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.per_cell", pair, "particles a cell in each direction",
       GET((std::vector<double>{double(s.body.per_cell[0]), double(s.body.per_cell[1])})),
       SET((s.body.per_cell = {int(two(v)[0]), int(two(v)[1])})), {.lower = 1, .upper = 16, .whole = true}},
      {"body.lattice", choice, "arrangement of the particles: squares along the axes; sectors of rings, on a ring; Gauss points of the cells; squares moved at random",
       GET(name_of(lattices, s.body.lattice)), SET(s.body.lattice = picked<Body::Lattice>(lattices, v)), {}, lattices},
      {"body.cut", choice,
       "cells of a Cartesian lattice at the ring's edges: clipped, or whole where their centre is in",
       GET(s.body.lattice != Body::Lattice::polar ? name_of(cuts, s.body.cut) : Value()),
       SET(s.body.cut = picked<Body::Cut>(cuts, v)), {}, cuts, false,
       "clipped with domain_average and of the twisting ring, whole with point", {}, {"ring"}},
      {"body.jitter", number, "of a jittered lattice: particles are moved along each axis by less than this [distance between them]",
       GET(s.body.lattice == Body::Lattice::jittered ? Value(s.body.jitter) : Value()), SET(s.body.jitter = real(v)),
       {.lower = 0, .upper = 0.5, .lower_open = true}, {}, false, "0.25"},
      {"body.seed", number, "of a jittered lattice: another number moves the particles otherwise",
       GET(s.body.lattice == Body::Lattice::jittered ? Value(double(s.body.seed)) : Value()),
       SET(s.body.seed = whole(v)), {.lower = 0, .upper = 1e9, .whole = true}, {}, false, "1"},
      {"body.periodic", choice, "directions in which the body repeats; other faces at whole metres of the unit box's motions are symmetry planes",
       GET(name_of(periodics, s.body.periodic)), SET(s.body.periodic = picked<Body::Periodic>(periodics, v)), {},
       periodics, false, {}, {"axis_aligned", "bar_1d", "rigid"}, cornered},
      {"body.initial_velocity.velocity", pair, "of the origin [m/s]",
       GET(s.body.initial_velocity ? pair_of(s.body.initial_velocity->velocity) : Value()),
       SET(s.body.initial_velocity->velocity = two(v))},
      {"body.initial_velocity.spin", number, "about E_z through the origin [rad/s]",
       GET(s.body.initial_velocity ? Value(s.body.initial_velocity->spin) : Value()),
       SET(s.body.initial_velocity->spin = real(v))},
      {"body.initial_velocity.stretching", vector, "D11, D22, D12 of the velocity's gradient [1/s]",
       GET(s.body.initial_velocity ? triple_of(s.body.initial_velocity->stretching) : Value()),
       SET(s.body.initial_velocity->stretching = three(v))},
      {"grid.spacing", number, "h [m]; nodes lie at multiples of h", GET(s.grid ? Value(s.grid->spacing) : Value()),
       SET(s.grid->spacing = real(v)), positive, {}, true},
      {"grid.offset", pair, "nodes lie this far beyond multiples of h, and bodies where they are [h]",
       GET(s.grid ? pair_of(s.grid->offset) : Value()), SET(s.grid->offset = two(v)), {.lower = 0, .upper = 1}, {},
       false, "[0, 0]"},
      {"grid.lower", pair, "lower corner [m]", GET(s.grid ? pair_of(s.grid->lower) : Value()),
       SET(s.grid->lower = two(v)), {}, {}, false, "around the body with a margin"},
      {"grid.upper", pair, "upper corner [m]", GET(s.grid ? pair_of(s.grid->upper) : Value()),
       SET(s.grid->upper = two(v)), {}, {}, false, "around the body with a margin"},
  };
}

std::vector<Key> method_keys() {
  using enum KeyType;
  return {
      {"method.basis", choice, "weights of the grid: linear, uGIMP, cpGIMP, CPDI (R4), CPDI2 (Q4), B-splines of degree 2, 3 and 4",
       GET(s.method ? name_of(bases, s.method->basis) : Value()),
       SET(s.method->basis = picked<Method::Basis>(bases, v)), {}, bases},
      {"method.formulation", choice, "configuration in which weights are made and forces integrated",
       GET(s.method ? name_of(formulations, s.method->formulation) : Value()),
       SET(s.method->formulation = picked<mpm::Formulation>(formulations, v)), {}, formulations},
      {"method.transfer", choice, "grid to particle",
       GET(s.method ? name_of(transfers, s.method->transfer) : Value()),
       SET(s.method->transfer = picked<Method::Transfer>(transfers, v)), {}, transfers},
      {"method.affine", choice, "what apic and aflip carry: the velocity's gradient (exact), or its moment (angular momentum)",
       GET(s.method && s.method->is_affine() ? name_of(affines, s.method->affine) : Value()),
       SET(s.method->affine = picked<mpm::Affine>(affines, v)), {}, affines, false, "gradient"},
      {"method.flip", number, "share of the particle's own velocity in flip and aflip; the rest is the grid's",
       GET(s.method && s.method->keeps_velocity() ? Value(s.method->flip) : Value()), SET(s.method->flip = real(v)),
       {.lower = 0, .upper = 1}, {}, false, "1"},
      {"method.update", choice, "when the stress is updated: first, last, last with remapped velocity",
       GET(s.method ? name_of(updates, s.method->update) : Value()),
       SET(s.method->update = picked<Method::Update>(updates, v)), {}, updates},
      {"method.integrator", choice, "of first, of second order (velocities half a step before the positions), of fourth (four forces a step)",
       GET(s.method ? name_of(integrators, s.method->integrator) : Value()),
       SET(s.method->integrator = picked<mpm::Integrator>(integrators, v)), {}, integrators},
      {"method.mass", choice, "mass matrix: its row sums, a series of its inverse, itself",
       GET(s.method ? name_of(masses, s.method->mass) : Value()),
       SET(s.method->mass = picked<mpm::Mass>(masses, v)), {}, masses},
      {"method.terms", number, "k: terms of the mass series, of xpic and of fmpm",
       GET(s.method && s.method->has_terms() ? Value(double(s.method->terms)) : Value()),
       SET(s.method->terms = whole(v)), {.lower = 1, .upper = 100, .whole = true}, {}, false, "2"},
      {"method.courant", number, "of the fastest wave on the baseline path plus the fastest particle",
       GET(s.method ? Value(s.method->courant) : Value()), SET(s.method->courant = real(v)),
       {.lower = 0, .upper = 1, .lower_open = true}},
      {"force.response", choice, "where tau comes from; none: no body force at all",
       GET(name_of(responses, s.force.response)), SET(s.force.response = picked<ForceChoice::Response>(responses, v)),
       {}, responses},
      {"force.evaluation", choice, "body force at the particle's reference position, or averaged over its domain",
       GET(name_of(evaluations, s.force.evaluation)),
       SET(s.force.evaluation = picked<ForceChoice::Evaluation>(evaluations, v)), {}, evaluations},
      {"force.inertia", choice, "b by the grid; or its part a given to the particles, which uses the exact solution",
       GET(name_of(inertias, s.force.inertia)), SET(s.force.inertia = picked<mpm::Inertia>(inertias, v)), {},
       inertias},
      {"force.radii", number, "histories that response shadow takes along", GET(double(s.force.radii)),
       SET(s.force.radii = whole(v)), {.lower = 4, .upper = 1e6, .whole = true}},
      {"force.cache", boolean, "keep the sheet on disk, and take it from there", GET(s.force.cache),
       SET(s.force.cache = std::get<bool>(v))},
      {"force.tolerance", number, "requested relative error of the sheet", GET(s.force.tolerance),
       SET(s.force.tolerance = real(v)), {.lower = 1e-14, .upper = 1e-2}},
      {"traction.algorithm", choice, "by the corners of the domains on the surface (middle of the edge: B-splines); as the exact stress continued beyond it; at the particles; by the undeformed length",
       GET(name_of(traction_algorithms, s.traction.algorithm)),
       SET(s.traction.algorithm = picked<mpm::TractionAlgorithm>(traction_algorithms, v)), {}, traction_algorithms,
       false, {}, with_traction},
      {"traction.form", choice, "sigma n ds on the surface as it is (follower), or P N dA0 (reference)",
       GET(s.traction.form ? name_of(traction_forms, *s.traction.form) : Value()),
       SET(s.traction.form = picked<mpm::TractionForm>(traction_forms, v)), {}, traction_forms, false,
       "the stable one: reference where the body is stretched, follower where it is compressed", with_traction},
  };
}

std::vector<Key> remedy_keys() {
  using enum KeyType;
  return {
      {"remedies.anti_locking", choice, "the stress is that of a volume ratio J averaged over cells or nodes (F-bar), for nearly incompressible materials",
       GET(name_of(anti_lockings, s.remedies.anti_locking)),
       SET(s.remedies.anti_locking = picked<mpm::AntiLocking>(anti_lockings, v)), {}, anti_lockings},
      {"remedies.largest_domain", number, "domains of cpdi and cpdi2 are shortened so that no corner is farther from its particle [cells]",
       GET(s.remedies.largest_domain > 0 ? Value(s.remedies.largest_domain) : Value()),
       SET(s.remedies.largest_domain = real(v)), {.lower = 0.1, .upper = 1e6}, {}, false, "as they deform"},
      {"remedies.small_mass", number, "lighter nodes take up force in proportion to their mass [rho0 h^2]",
       GET(s.remedies.small_mass > 0 ? Value(s.remedies.small_mass) : Value()),
       SET(s.remedies.small_mass = real(v)), {.lower = 0, .upper = 1, .lower_open = true}, {}, false, "all forces"},
      {"remedies.artificial_viscosity", pair, "C1 and C2 of the pressure rho h (C1 c + C2 h dV) dV against shrinking, dV the rate of volume that is lost",
       GET(s.remedies.has_viscosity() ? pair_of(s.remedies.viscosity) : Value()),
       SET(s.remedies.viscosity = two(v)), {.lower = 0, .upper = 100}, {}, false, "none"},
  };
}

std::vector<Key> run_keys() {
  using enum KeyType;
  return {
      {"time.end", number, "end of the run [s]", GET(s.time.end), SET(s.time.end = real(v)), positive, {}, false,
       "motion.period"},
      {"time.step", number, "fixes dt [s] instead of method.courant",
       GET(s.time.step ? Value(*s.time.step) : Value()), SET(s.time.step = real(v)), positive, {}, false,
       "of method.courant"},
      {"time.control", choice, "steps of equal length, planned by the exact motion; or by the fastest wave and particle there are now",
       GET(name_of(controls, s.time.control)), SET(s.time.control = picked<TimeChoice::Control>(controls, v)), {},
       controls},
      {"output.errors", number, "samples of the error over the run", GET(double(s.output.errors)),
       SET(s.output.errors = whole(v)), {.lower = 1, .upper = 1e6, .whole = true}},
      {"output.particles", number, "snapshots of the particles (VTU) over the run; 0: none",
       GET(double(s.output.particles)), SET(s.output.particles = whole(v)),
       {.lower = 0, .upper = 1e5, .whole = true}},
      {"output.each_step_from", number, "snapshots of every step from this time on, besides [s]",
       GET(s.output.each_step_from ? Value(*s.output.each_step_from) : Value()),
       SET(s.output.each_step_from = real(v)), {.lower = 0}, {}, false, "none"},
      {"output.pictures", boolean, "PNG pictures", GET(s.output.pictures),
       SET(s.output.pictures = std::get<bool>(v))},
      {"output.report", boolean, "report.html", GET(s.output.report), SET(s.output.report = std::get<bool>(v))},
      {"output.accounts", boolean, "accounts of mass, momentum and energy", GET(s.output.accounts),
       SET(s.output.accounts = std::get<bool>(v))},
      {"output.tractions", boolean, "the same motion under tractions by every algorithm on grids of 4h, 2h and h, side by side in report.html and result.json",
       GET(s.output.tractions), SET(s.output.tractions = std::get<bool>(v)), {}, {}, false, {}, with_traction},
      {"limits.memory_gib", number, "a run that would need more memory is refused [GiB]", GET(s.limits.memory_gib),
       SET(s.limits.memory_gib = real(v)), positive},
      {"limits.particle_steps", number, "a run of more particles times steps is refused",
       GET(s.limits.particle_steps), SET(s.limits.particle_steps = real(v)), positive},
  };
}

// clang-format on
#undef GET
#undef SET

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return list.empty() || std::find(list.begin(), list.end(), word) != list.end();
}

}  // namespace

const std::vector<Section>& scene_sections() {
  static const std::vector<Section> sections{
      {"motion", "the manufactured motion", true},
      {"motion.amplitude", "g(t)"},
      {"frame", "the frame from which the vortex is seen; absent: the body's own", false, true,
       [](Scene& s) { s.frame.emplace(); }},
      {"material", "the constitutive model", true},
      {"material.parameters", "parameters of the material by name, SI units", false, false, nullptr, true},
      {"body", "the particles"},
      {"body.initial_velocity", "of a body left to itself, with force.response: none; absent: that of the motion",
       false, true, [](Scene& s) { s.body.initial_velocity.emplace(); }},
      {"grid", "the background grid", false, true, [](Scene& s) { s.grid.emplace(); }},
      {"method", "the particle method; without it a scene serves tabulate and eval", false, true,
       [](Scene& s) { s.method.emplace(); }},
      {"force", "the body force"},
      {"traction", "how prescribed tractions reach the grid"},
      {"remedies", "against what a method alone does not hold; each costs, and is absent by default"},
      {"time", "the clock"},
      {"output", "what is written"},
      {"limits", "what a run may cost"},
      {"expect", "what must be found, by key of result.json", false, false, nullptr, true},
  };
  return sections;
}

const std::vector<Key>& scene_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all = motion_keys();
    for (auto part : {body_keys(), method_keys(), remedy_keys(), run_keys()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return keys;
}

bool of_motion(const Key& key, const Scene& scene) { return contains(key.motions, motion_type(scene)); }

bool applies(const Key& key, const Scene& scene) {
  return of_motion(key, scene) && contains(key.domains, domain_name(scene.body.domain));
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
    const std::size_t dot = path.rfind('.');
    const std::string parent = dot == path.npos ? std::string() : path.substr(0, dot);
    if (parent == section) names.push_back(dot == path.npos ? path : path.substr(dot + 1));
  };
  for (const Key& key : scene_keys()) {
    if (!scene || applies(key, *scene)) add(key.path);
  }
  for (const Section& part : scene_sections()) {
    if (!scene || applies(part, *scene)) add(part.path);
  }
  return names;
}

std::string domain_name(Body::Domain domain) { return std::get<std::string>(name_of(domains, domain)); }

}  // namespace assay::drivers
