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
const auto bears_tractions = [](const Motion& motion) { return motion->bears_tractions(); };
const auto may_repeat = [](const Motion& motion) { return motion->may_repeat(); };
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
      {"material.adapter", text, "registered name, shared library (lib.so or lib.so:name), Fortran source or description (.yaml)",
       GET(s.material.adapter), SET(s.material.adapter = std::get<std::string>(v)), {}, {}, true},
      {"material.density", number, "density rho0 in the reference configuration [kg/m^3]", GET(s.material.density > 0 ? Value(s.material.density) : Value()),
       SET(s.material.density = real(v)), positive, {}, false,
       "of the material's description; required where it has none"},
      {"material.direction", vector,
       "axis of the model, any length; components on e_R, e_Theta, e_Z in the vortex, else on the coordinate axes",
       GET(triple_of(s.material.direction)), SET(s.material.direction = three(v)), {}, {}, false,
       "[1, 0, 0] of a model that has one"},
      {"material.isolation", choice, "where the model's code runs: in worker processes (worker) or in the process of assay (none)",
       GET(s.material.isolation == Isolation::automatic ? Value() : name_of(isolations, s.material.isolation)),
       SET(s.material.isolation = picked<Isolation>(isolations, v)), {}, {"worker", "none"}, false,
       "worker for UMAT, VUMAT and MFront, none for native models"},
      {"body.domain", choice, "shape; a ring takes its radii from the motion, square and box are given by their corners",
       GET(domain_name(s.body.domain)), SET(s.body.domain = picked<Body::Domain>(domains, v)), {}, domains, false,
       "ring for the vortex and the twisting ring, square otherwise"},
      {"body.outside", choice, "what surrounds the ring in a square or box: fixed (held) or free to move (free)",
       GET(name_of(outsides, s.body.outside)), SET(s.body.outside = picked<Body::Outside>(outsides, v)), {}, outsides,
       false, "free for a ring, held for square and box", types_of(is_vortex)},
      {"body.lower", pair, "lower corner of a square or box [m]", GET(pair_of(s.body.lower)), SET(s.body.lower = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.upper", pair, "upper corner of a square or box [m]", GET(pair_of(s.body.upper)), SET(s.body.upper = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.per_cell", pair, "particles per cell in each direction",
       GET((std::vector<double>{double(s.body.per_cell[0]), double(s.body.per_cell[1])})),
       SET((s.body.per_cell = {int(two(v)[0]), int(two(v)[1])})), {.lower = 1, .upper = 16, .whole = true}},
      {"body.lattice", choice, "particle positions: square lattice, sectors of rings, Gauss points of the cells, or random offsets",
       GET(name_of(lattices, s.body.lattice)), SET(s.body.lattice = picked<Body::Lattice>(lattices, v)), {}, lattices},
      {"body.cut", choice,
       "lattice cells at the ring's edges: clipped to the ring, or whole if their centre is inside",
       GET(s.body.lattice != Body::Lattice::polar ? name_of(cuts, s.body.cut) : Value()),
       SET(s.body.cut = picked<Body::Cut>(cuts, v)), {}, cuts, false,
       "clipped with domain_average and of the twisting ring, whole with point", {}, {"ring"}},
      {"body.jitter", number, "jittered lattice: bound on the random offset along each axis [distance between particles]",
       GET(s.body.lattice == Body::Lattice::jittered ? Value(s.body.jitter) : Value()), SET(s.body.jitter = real(v)),
       {.lower = 0, .upper = 0.5, .lower_open = true}, {}, false, "0.25"},
      {"body.seed", number, "jittered lattice: seed of the random offsets",
       GET(s.body.lattice == Body::Lattice::jittered ? Value(double(s.body.seed)) : Value()),
       SET(s.body.seed = whole(v)), {.lower = 0, .upper = 1e9, .whole = true}, {}, false, "1"},
      {"body.periodic", choice, "directions in which the body repeats; unit box: other faces at whole metres are symmetry planes",
       GET(name_of(periodics, s.body.periodic)), SET(s.body.periodic = picked<Body::Periodic>(periodics, v)), {},
       periodics, false, {}, types_of(may_repeat), cornered},
      {"body.initial_velocity.velocity", pair, "velocity at the origin [m/s]",
       GET(s.body.initial_velocity ? pair_of(s.body.initial_velocity->velocity) : Value()),
       SET(s.body.initial_velocity->velocity = two(v))},
      {"body.initial_velocity.spin", number, "angular velocity about E_z through the origin [rad/s]",
       GET(s.body.initial_velocity ? Value(s.body.initial_velocity->spin) : Value()),
       SET(s.body.initial_velocity->spin = real(v))},
      {"body.initial_velocity.stretching", vector, "symmetric part of the velocity gradient: D11, D22, D12 [1/s]",
       GET(s.body.initial_velocity ? triple_of(s.body.initial_velocity->stretching) : Value()),
       SET(s.body.initial_velocity->stretching = three(v))},
      {"grid.spacing", number, "node spacing h [m]; nodes are at multiples of h", GET(s.grid ? Value(s.grid->spacing) : Value()),
       SET(s.grid->spacing = real(v)), positive, {}, true},
      {"grid.offset", pair, "shift of the nodes from multiples of h; the body is not shifted [h]",
       GET(s.grid ? pair_of(s.grid->offset) : Value()), SET(s.grid->offset = two(v)), {.lower = 0, .upper = 1}, {},
       false, "[0, 0]"},
      {"grid.lower", pair, "lower corner of the grid [m]", GET(s.grid ? pair_of(s.grid->lower) : Value()),
       SET(s.grid->lower = two(v)), {}, {}, false, "around the body with a margin"},
      {"grid.upper", pair, "upper corner of the grid [m]", GET(s.grid ? pair_of(s.grid->upper) : Value()),
       SET(s.grid->upper = two(v)), {}, {}, false, "around the body with a margin"},
  };
}

std::vector<Key> method_keys() {
  using enum KeyType;
  return {
      {"method.basis", choice, "grid basis: linear, uGIMP, cpGIMP, CPDI (R4), CPDI2 (Q4), B-splines of degree 2, 3 and 4",
       GET(s.method ? name_of(bases, s.method->basis) : Value()),
       SET(s.method->basis = picked<Method::Basis>(bases, v)), {}, bases},
      {"method.formulation", choice, "configuration of basis functions and force integration: current (updated) or reference (total)",
       GET(s.method ? name_of(formulations, s.method->formulation) : Value()),
       SET(s.method->formulation = picked<mpm::Formulation>(formulations, v)), {}, formulations},
      {"method.transfer", choice, "how the grid updates the velocities of the particles",
       GET(s.method ? name_of(transfers, s.method->transfer) : Value()),
       SET(s.method->transfer = picked<Method::Transfer>(transfers, v)), {}, transfers},
      {"method.affine", choice, "what apic and aflip carry: the velocity gradient (exact) or its moment (angular momentum)",
       GET(s.method && s.method->is_affine() ? name_of(affines, s.method->affine) : Value()),
       SET(s.method->affine = picked<mpm::Affine>(affines, v)), {}, affines, false, "gradient"},
      {"method.flip", number, "share of the particle's own velocity in flip and aflip; the rest comes from the grid",
       GET(s.method && s.method->keeps_velocity() ? Value(s.method->flip) : Value()), SET(s.method->flip = real(v)),
       {.lower = 0, .upper = 1}, {}, false, "1"},
      {"method.update", choice, "when the stress is updated: first, last, or last with velocities mapped again from the particles",
       GET(s.method ? name_of(updates, s.method->update) : Value()),
       SET(s.method->update = picked<Method::Update>(updates, v)), {}, updates},
      {"method.integrator", choice, "order 1 (symplectic_euler), 2 (leapfrog, velocities at half steps) or 4 (four force evaluations a step)",
       GET(s.method ? name_of(integrators, s.method->integrator) : Value()),
       SET(s.method->integrator = picked<mpm::Integrator>(integrators, v)), {}, integrators},
      {"method.mass", choice, "mass matrix: lumped by row sums, a series for its inverse, or the full matrix",
       GET(s.method ? name_of(masses, s.method->mass) : Value()),
       SET(s.method->mass = picked<mpm::Mass>(masses, v)), {}, masses},
      {"method.terms", number, "number of terms k of the mass series, of xpic and of fmpm",
       GET(s.method && s.method->has_terms() ? Value(double(s.method->terms)) : Value()),
       SET(s.method->terms = whole(v)), {.lower = 1, .upper = 100, .whole = true}, {}, false, "2"},
      {"method.courant", number, "Courant number of the fastest wave on the baseline path plus the fastest particle",
       GET(s.method ? Value(s.method->courant) : Value()), SET(s.method->courant = real(v)),
       {.lower = 0, .upper = 1, .lower_open = true}},
      {"force.response", choice, "source of the stress tau on the baseline path; none: no body force",
       GET(name_of(responses, s.force.response)), SET(s.force.response = picked<ForceChoice::Response>(responses, v)),
       {}, responses},
      {"force.evaluation", choice, "body force at the particle's reference position, or averaged over its reference domain",
       GET(name_of(evaluations, s.force.evaluation)),
       SET(s.force.evaluation = picked<ForceChoice::Evaluation>(evaluations, v)), {}, evaluations},
      {"force.inertia", choice, "grid: all of b acts through the grid; particles: they receive its part a (uses the exact solution)",
       GET(name_of(inertias, s.force.inertia)), SET(s.force.inertia = picked<mpm::Inertia>(inertias, v)), {},
       inertias},
      {"force.radii", number, "number of histories that response: shadow steps during the run", GET(double(s.force.radii)),
       SET(s.force.radii = whole(v)), {.lower = 4, .upper = 1e6, .whole = true}},
      {"force.cache", boolean, "keep the sheet on disk and reuse it in later runs", GET(s.force.cache),
       SET(s.force.cache = std::get<bool>(v))},
      {"force.tolerance", number, "requested relative error of the sheet", GET(s.force.tolerance),
       SET(s.force.tolerance = real(v)), {.lower = 1e-14, .upper = 1e-2}, {}, false,
       "1e-8; 1e-5 for a UMAT, VUMAT or MFront model"},
      {"traction.algorithm", choice, "forces on domain edges, from the exact stress, at surface particles, or on edges of undeformed length",
       GET(name_of(traction_algorithms, s.traction.algorithm)),
       SET(s.traction.algorithm = picked<mpm::TractionAlgorithm>(traction_algorithms, v)), {}, traction_algorithms,
       false, {}, types_of(bears_tractions)},
      {"traction.form", choice, "sigma n ds on the current surface (follower), or P N dA0 (reference)",
       GET(s.traction.form ? name_of(traction_forms, *s.traction.form) : Value()),
       SET(s.traction.form = picked<mpm::TractionForm>(traction_forms, v)), {}, traction_forms, false,
       "the stable one: reference where the body is stretched, follower where it is compressed", types_of(bears_tractions)},
  };
}

std::vector<Key> remedy_keys() {
  using enum KeyType;
  return {
      {"remedies.anti_locking", choice, "F-bar: the stress uses J averaged over cells or nodes, for nearly incompressible materials",
       GET(name_of(anti_lockings, s.remedies.anti_locking)),
       SET(s.remedies.anti_locking = picked<mpm::AntiLocking>(anti_lockings, v)), {}, anti_lockings},
      {"remedies.largest_domain", number, "largest distance of a corner of a cpdi or cpdi2 domain from its particle [cells]",
       GET(s.remedies.largest_domain > 0 ? Value(s.remedies.largest_domain) : Value()),
       SET(s.remedies.largest_domain = real(v)), {.lower = 0.1, .upper = 1e6}, {}, false, "as they deform"},
      {"remedies.small_mass", number, "nodes lighter than this receive less force, in proportion to their mass [rho0 h^2]",
       GET(s.remedies.small_mass > 0 ? Value(s.remedies.small_mass) : Value()),
       SET(s.remedies.small_mass = real(v)), {.lower = 0, .upper = 1, .lower_open = true}, {}, false, "all forces"},
      {"remedies.artificial_viscosity", pair, "C1, C2 of the pressure rho h (C1 c + C2 h dV) dV in compression; dV is the rate of volume loss",
       GET(s.remedies.has_viscosity() ? pair_of(s.remedies.viscosity) : Value()),
       SET(s.remedies.viscosity = two(v)), {.lower = 0, .upper = 100}, {}, false, "none"},
  };
}

std::vector<Key> run_keys() {
  using enum KeyType;
  return {
      {"time.end", number, "end of the run [s]", GET(s.time.end), SET(s.time.end = real(v)), positive, {}, false,
       "motion.period"},
      {"time.step", number, "fixed time step dt, in place of method.courant [s]",
       GET(s.time.step ? Value(*s.time.step) : Value()), SET(s.time.step = real(v)), positive, {}, false,
       "of method.courant"},
      {"time.control", choice, "planned: equal steps from the exact motion; current: steps from the present fastest wave and particle",
       GET(name_of(controls, s.time.control)), SET(s.time.control = picked<TimeChoice::Control>(controls, v)), {},
       controls},
      {"output.errors", number, "number of samples of the error over the run", GET(double(s.output.errors)),
       SET(s.output.errors = whole(v)), {.lower = 1, .upper = 1e6, .whole = true}},
      {"output.particles", number, "number of snapshots of the particles (VTU) over the run; 0: none",
       GET(double(s.output.particles)), SET(s.output.particles = whole(v)),
       {.lower = 0, .upper = 1e5, .whole = true}},
      {"output.each_step_from", number, "also write a snapshot of every step from this time on [s]",
       GET(s.output.each_step_from ? Value(*s.output.each_step_from) : Value()),
       SET(s.output.each_step_from = real(v)), {.lower = 0}, {}, false, "none"},
      {"output.pictures", boolean, "write PNG pictures", GET(s.output.pictures),
       SET(s.output.pictures = std::get<bool>(v))},
      {"output.report", boolean, "write report.html", GET(s.output.report), SET(s.output.report = std::get<bool>(v))},
      {"output.accounts", boolean, "compute the accounts of mass, momentum and energy", GET(s.output.accounts),
       SET(s.output.accounts = std::get<bool>(v))},
      {"output.tractions", boolean, "repeat the run with each traction algorithm on grids of 4h, 2h and h, for report.html and result.json",
       GET(s.output.tractions), SET(s.output.tractions = std::get<bool>(v)), {}, {}, false, {}, types_of(bears_tractions)},
      {"limits.memory_gib", number, "refuse a run that would need more memory [GiB]", GET(s.limits.memory_gib),
       SET(s.limits.memory_gib = real(v)), positive},
      {"limits.particle_steps", number, "refuse a run of more particles times steps",
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
