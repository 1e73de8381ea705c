// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

namespace assay::drivers {

namespace {

const Range positive{.lower = 0, .lower_open = true};

const std::vector<std::string> motion_types{"vortex", "homogeneous"};
const std::vector<std::string> amplitude_types{"sine", "one_minus_cosine", "ramp"};
const std::vector<std::string> domains{"ring", "square", "box"};
const std::vector<std::string> outsides{"held", "free"};
const std::vector<std::string> bases{"linear", "ugimp", "cpdi"};
const std::vector<std::string> transfers{"pic", "flip"};
const std::vector<std::string> updates{"usf", "usl", "musl"};
const std::vector<std::string> responses{"none", "closed_form", "sheet"};

/// The enumerator whose name is at its place in the list; the reader has checked that it is there.
template <class Enum>
Enum picked(const std::vector<std::string>& names, const Value& value) {
  return static_cast<Enum>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
}
template <class Enum>
Value name_of(const std::vector<std::string>& names, Enum value) {
  return names[static_cast<std::size_t>(value)];
}

double real(const Value& value) { return std::get<double>(value); }
int whole(const Value& value) { return static_cast<int>(std::get<double>(value)); }
Value pair_of(const std::array<double, 2>& p) { return std::vector<double>{p[0], p[1]}; }
std::array<double, 2> two(const Value& value) {
  const auto& list = std::get<std::vector<double>>(value);
  return {list[0], list[1]};
}
Value pair_of(const std::optional<std::array<double, 2>>& p) { return p ? pair_of(*p) : Value(); }
const Vortex& vortex(const Scene& s) { return std::get<Vortex>(s.motion); }
Vortex& vortex(Scene& s) { return std::get<Vortex>(s.motion); }

void set_motion(Scene& s, const Value& v) {
  if (std::get<std::string>(v) == "vortex") {
    s.motion = Vortex{};
  } else {
    s.motion = Homogeneous{};
  }
}
double period(const Scene& s) {
  const auto* v = std::get_if<Vortex>(&s.motion);
  return v ? v->amplitude.period : std::get<Homogeneous>(s.motion).period;
}
void set_period(Scene& s, const Value& v) {
  auto* vortex_motion = std::get_if<Vortex>(&s.motion);
  (vortex_motion ? vortex_motion->amplitude.period : std::get<Homogeneous>(s.motion).period) = real(v);
}
Value final_gradient(const Scene& s) {
  const Tensor& F = std::get<Homogeneous>(s.motion).final;
  std::vector<double> list;
  for (int i = 0; i < 9; ++i) list.push_back(component(F, i));
  return list;
}
void set_final_gradient(Scene& s, const Value& v) {
  const auto& list = std::get<std::vector<double>>(v);
  for (int i = 0; i < 9; ++i) component(std::get<Homogeneous>(s.motion).final, i) = list[static_cast<std::size_t>(i)];
}

#define GET(expression) [](const Scene& s) -> Value { return expression; }
#define SET(statement) [](Scene& s, const Value& v) { statement; }

// clang-format off
std::vector<Key> motion_keys() {
  using enum KeyType;
  const std::vector<std::string> of_vortex{"vortex"}, of_homogeneous{"homogeneous"};
  return {
      {"title", text, "one line for pictures and reports", GET(s.title), SET(s.title = std::get<std::string>(v))},
      {"motion.type", choice, "the manufactured motion", GET(motion_type(s)), set_motion, {}, motion_types, true},
      {"motion.inner", number, "inner radius ri [m]", GET(vortex(s).inner), SET(vortex(s).inner = real(v)), positive,
       {}, false, {}, of_vortex},
      {"motion.outer", number, "outer radius ro [m]", GET(vortex(s).outer), SET(vortex(s).outer = real(v)), positive,
       {}, false, {}, of_vortex},
      {"motion.final", matrix, "deformation gradient at t = period, det > 0 [1]", final_gradient, set_final_gradient,
       {}, {}, true, {}, of_homogeneous},
      {"motion.period", number, "T [s]", GET(period(s)), set_period, positive},
      {"motion.profile_power", number, "m of h = (1 - s^2)^m; m = 1 would leave a traction on the ring's faces",
       GET(double(vortex(s).profile_power)), SET(vortex(s).profile_power = whole(v)),
       {.lower = 2, .upper = 64, .whole = true}, {}, false, {}, of_vortex},
      {"motion.amplitude.type", choice, "g(t): A sin(pi t/T), A (1 - cos(2 pi t/T))/2, A t/T held after T",
       GET(name_of(amplitude_types, vortex(s).amplitude.type)),
       SET(vortex(s).amplitude.type = picked<Amplitude::Type>(amplitude_types, v)), {}, amplitude_types, false, {},
       of_vortex},
      {"motion.amplitude.peak", number, "A [rad]", GET(vortex(s).amplitude.peak),
       SET(vortex(s).amplitude.peak = real(v)), {}, {}, false, {}, of_vortex},
      {"motion.allow_unstable", boolean, "kept for the stability screen of motions; this version does not screen",
       GET(s.allow_unstable), SET(s.allow_unstable = std::get<bool>(v))},
  };
}

std::vector<Key> body_keys() {
  using enum KeyType;
  const std::vector<std::string> cornered{"square", "box"};
  return {
      {"material.adapter", text, "registered name, shared library (lib.so or lib.so:name) or description (.yaml)",
       GET(s.material.adapter), SET(s.material.adapter = std::get<std::string>(v)), {}, {}, true},
      {"material.density", number, "rho0 [kg/m^3]", GET(s.material.density > 0 ? Value(s.material.density) : Value()),
       SET(s.material.density = real(v)), positive, {}, false,
       "of the material's description; required where it has none"},
      {"body.domain", choice, "shape; the ring takes its radii from the vortex, square and box have corners",
       GET(domain_name(s.body.domain)), SET(s.body.domain = picked<Body::Domain>(domains, v)), {}, domains, false,
       "ring for the vortex, square otherwise"},
      {"body.outside", choice, "what surrounds the ring in a square or box stands still (held) or is left to itself",
       GET(name_of(outsides, s.body.outside)), SET(s.body.outside = picked<Body::Outside>(outsides, v)), {}, outsides,
       false, "free for a ring, held for square and box"},
      {"body.lower", pair, "lower corner [m]", GET(pair_of(s.body.lower)), SET(s.body.lower = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.upper", pair, "upper corner [m]", GET(pair_of(s.body.upper)), SET(s.body.upper = two(v)), {}, {}, false,
       {}, {}, cornered},
      {"body.per_cell", pair, "particles a cell in each direction",
       GET((std::vector<double>{double(s.body.per_cell[0]), double(s.body.per_cell[1])})),
       SET((s.body.per_cell = {int(two(v)[0]), int(two(v)[1])})), {.lower = 1, .upper = 16, .whole = true}},
      {"body.lattice", choice, "arrangement of the particles", GET(s.body.lattice),
       SET(s.body.lattice = std::get<std::string>(v)), {}, {"cartesian"}},
      {"grid.spacing", number, "h [m]; nodes lie at multiples of h", GET(s.grid ? Value(s.grid->spacing) : Value()),
       SET(s.grid->spacing = real(v)), positive, {}, true},
      {"grid.lower", pair, "lower corner [m]", GET(s.grid ? pair_of(s.grid->lower) : Value()),
       SET(s.grid->lower = two(v)), {}, {}, false, "around the body with a margin"},
      {"grid.upper", pair, "upper corner [m]", GET(s.grid ? pair_of(s.grid->upper) : Value()),
       SET(s.grid->upper = two(v)), {}, {}, false, "around the body with a margin"},
  };
}

std::vector<Key> method_keys() {
  using enum KeyType;
  return {
      {"method.basis", choice, "weights of the grid: linear, uGIMP, CPDI (R4)",
       GET(s.method ? name_of(bases, s.method->basis) : Value()),
       SET(s.method->basis = picked<Method::Basis>(bases, v)), {}, bases},
      {"method.formulation", choice, "configuration in which forces are integrated",
       GET(s.method ? Value(s.method->formulation) : Value()), SET(s.method->formulation = std::get<std::string>(v)),
       {}, {"updated"}},
      {"method.transfer", choice, "grid to particle",
       GET(s.method ? name_of(transfers, s.method->transfer) : Value()),
       SET(s.method->transfer = picked<Method::Transfer>(transfers, v)), {}, transfers},
      {"method.update", choice, "when the stress is updated: first, last, last with remapped velocity",
       GET(s.method ? name_of(updates, s.method->update) : Value()),
       SET(s.method->update = picked<Method::Update>(updates, v)), {}, updates},
      {"method.mass", choice, "mass matrix", GET(s.method ? Value(s.method->mass) : Value()),
       SET(s.method->mass = std::get<std::string>(v)), {}, {"lumped"}},
      {"method.courant", number, "of the fastest wave on the baseline path plus the fastest particle",
       GET(s.method ? Value(s.method->courant) : Value()), SET(s.method->courant = real(v)),
       {.lower = 0, .upper = 1, .lower_open = true}},
      {"force.response", choice, "where tau comes from; none: no body force at all",
       GET(name_of(responses, s.force.response)), SET(s.force.response = picked<ForceChoice::Response>(responses, v)),
       {}, responses},
      {"force.evaluation", choice, "body force at the particle's reference position", GET(s.force.evaluation),
       SET(s.force.evaluation = std::get<std::string>(v)), {}, {"point"}},
      {"force.tolerance", number, "requested relative error of the sheet", GET(s.force.tolerance),
       SET(s.force.tolerance = real(v)), {.lower = 1e-14, .upper = 1e-2}},
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
      {"output.errors", number, "samples of the error over the run", GET(double(s.output.errors)),
       SET(s.output.errors = whole(v)), {.lower = 1, .upper = 1e6, .whole = true}},
      {"output.particles", number, "snapshots of the particles (VTU) over the run; 0: none",
       GET(double(s.output.particles)), SET(s.output.particles = whole(v)),
       {.lower = 0, .upper = 1e5, .whole = true}},
      {"output.pictures", boolean, "PNG pictures", GET(s.output.pictures),
       SET(s.output.pictures = std::get<bool>(v))},
      {"output.report", boolean, "report.html", GET(s.output.report), SET(s.output.report = std::get<bool>(v))},
      {"output.accounts", boolean, "accounts of mass, momentum and energy", GET(s.output.accounts),
       SET(s.output.accounts = std::get<bool>(v))},
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
      {"material", "the constitutive model", true},
      {"material.parameters", "parameters of the material by name, SI units", false, false, nullptr, true},
      {"body", "the particles"},
      {"grid", "the background grid", false, true, [](Scene& s) { s.grid.emplace(); }},
      {"method", "the particle method; without it a scene serves tabulate and eval", false, true,
       [](Scene& s) { s.method.emplace(); }},
      {"force", "the body force"},
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
    for (auto part : {body_keys(), method_keys(), run_keys()}) all.insert(all.end(), part.begin(), part.end());
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

std::string motion_type(const Scene& scene) { return motion_types[scene.motion.index()]; }

std::string domain_name(Body::Domain domain) { return std::get<std::string>(name_of(domains, domain)); }

}  // namespace assay::drivers
