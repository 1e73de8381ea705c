// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/motion_keys.hpp"

#include "drivers/scene/key_values.hpp"

namespace assay::drivers {

namespace {

const Range positive{.lower = 0, .lower_open = true};

const std::vector<std::string> motion_types{"vortex", "homogeneous", "rotating_stretch"};
const std::vector<std::string> amplitude_types{"sine", "one_minus_cosine", "ramp"};
const std::vector<std::string> rotate_types{"none", "simultaneous", "after"};

const Vortex& vortex(const Scene& s) { return std::get<Vortex>(s.motion); }
Vortex& vortex(Scene& s) { return std::get<Vortex>(s.motion); }
const RotatingStretch& rotating(const Scene& s) { return std::get<RotatingStretch>(s.motion); }
RotatingStretch& rotating(Scene& s) { return std::get<RotatingStretch>(s.motion); }

std::string type_name(const Vortex&) { return motion_types[0]; }
std::string type_name(const Homogeneous&) { return motion_types[1]; }
std::string type_name(const RotatingStretch&) { return motion_types[2]; }
std::string type_name(const DeformationTable&) { return motion_types[1]; }

void set_motion(Scene& s, const Value& v) {
  const auto& name = std::get<std::string>(v);
  if (name == "vortex")
    s.motion = Vortex{};
  else if (name == "homogeneous")
    s.motion = Homogeneous{};
  else
    s.motion = RotatingStretch{};
}

/// The reader reads the file when it knows where the scene lies.
void set_path(Scene& s, const Value& v) { s.motion = DeformationTable(std::get<std::string>(v)); }
Value path_of(const Scene& s) {
  const auto* table = std::get_if<DeformationTable>(&s.motion);
  return table ? Value(table->source()) : Value();
}

void set_period(Scene& s, const Value& v) {
  if (auto* motion = std::get_if<Vortex>(&s.motion)) motion->amplitude.period = real(v);
  if (auto* motion = std::get_if<Homogeneous>(&s.motion)) motion->period = real(v);
  if (auto* motion = std::get_if<RotatingStretch>(&s.motion)) motion->period = real(v);
}

Value final_gradient(const Scene& s) {
  const auto* motion = std::get_if<Homogeneous>(&s.motion);
  if (!motion) return {};
  std::vector<double> list;
  for (int i = 0; i < 9; ++i) list.push_back(component(motion->final, i));
  return list;
}
void set_final_gradient(Scene& s, const Value& v) {
  auto* motion = std::get_if<Homogeneous>(&s.motion);
  const auto& list = std::get<std::vector<double>>(v);
  for (int i = 0; motion && i < 9; ++i) component(motion->final, i) = list[static_cast<std::size_t>(i)];
}

#define GET(expression) [](const Scene& s) -> Value { return expression; }
#define SET(statement) [](Scene& s, const Value& v) { statement; }

// clang-format off
std::vector<Key> vortex_keys() {
  using enum KeyType;
  const std::vector<std::string> of_vortex{"vortex"};
  return {
      {"motion.profile_power", number, "m of h = (1 - s^2)^m; m = 1 would leave a traction on the ring's faces",
       GET(double(vortex(s).profile_power)), SET(vortex(s).profile_power = whole(v)),
       {.lower = 2, .upper = 64, .whole = true}, {}, false, {}, of_vortex},
      {"motion.amplitude.type", choice, "g(t): A sin(pi t/T), A (1 - cos(2 pi t/T))/2, A t/T held after T",
       GET(name_of(amplitude_types, vortex(s).amplitude.type)),
       SET(vortex(s).amplitude.type = picked<Amplitude::Type>(amplitude_types, v)), {}, amplitude_types, false, {},
       of_vortex},
      {"motion.amplitude.peak", number, "A [rad]", GET(vortex(s).amplitude.peak),
       SET(vortex(s).amplitude.peak = real(v)), {}, {}, false, {}, of_vortex},
  };
}

std::vector<Key> stretch_keys() {
  using enum KeyType;
  const std::vector<std::string> of_stretch{"rotating_stretch"};
  return {
      {"motion.stretch", number, "a: along E1 the length is 1 + a sin^2(pi t/T), or 1 + a q(2 t/T) before rotating [1]",
       GET(rotating(s).stretch), SET(rotating(s).stretch = real(v)), {.lower = -1, .lower_open = true}, {}, true, {},
       of_stretch},
      {"motion.shear", number, "k: U12 = k (U11 - 1)/a [1]", GET(rotating(s).shear), SET(rotating(s).shear = real(v)),
       {}, {}, false, {}, of_stretch},
      {"motion.rotation", number, "beta, the whole angle [rad]", GET(rotating(s).rotation),
       SET(rotating(s).rotation = real(v)), {}, {}, false, {}, of_stretch},
      {"motion.axis", vector, "of the rotation, normalised",
       GET((std::vector<double>{rotating(s).axis.x(), rotating(s).axis.y(), rotating(s).axis.z()})),
       SET((rotating(s).axis = {three(v)[0], three(v)[1], three(v)[2]})), {}, {}, false, {}, of_stretch},
      {"motion.rotate", choice, "not at all, while it stretches, or after it", 
       GET(name_of(rotate_types, rotating(s).rotate)),
       SET(rotating(s).rotate = picked<RotatingStretch::Rotate>(rotate_types, v)), {}, rotate_types, false, {},
       of_stretch},
  };
}

std::vector<Key> frame_keys() {
  using enum KeyType;
  const std::vector<std::string> of_vortex{"vortex"};
  return {
      {"frame.angle", number, "by which body and motion are turned against the grid, about E_z [rad]",
       GET(s.frame ? Value(s.frame->angle) : Value()), SET(s.frame->angle = real(v)), {}, {}, false, {}, of_vortex},
      {"frame.spin", number, "w: the whole motion turns by w t more [rad/s]",
       GET(s.frame ? Value(s.frame->spin) : Value()), SET(s.frame->spin = real(v)), {}, {}, false, {}, of_vortex},
      {"frame.velocity", pair, "of the whole motion [m/s]",
       GET(s.frame ? pair_of({s.frame->velocity.x(), s.frame->velocity.y()}) : Value()),
       SET((s.frame->velocity = {two(v)[0], two(v)[1], 0})), {}, {}, false, {}, of_vortex},
  };
}

}  // namespace

std::vector<Key> motion_keys() {
  using enum KeyType;
  const std::vector<std::string> of_vortex{"vortex"}, of_homogeneous{"homogeneous"};
  std::vector<Key> keys{
      {"title", text, "one line for pictures and reports", GET(s.title), SET(s.title = std::get<std::string>(v))},
      {"motion.type", choice, "the manufactured motion", GET(motion_type(s)), set_motion, {}, motion_types, true},
      {"motion.inner", number, "inner radius ri [m]", GET(vortex(s).inner), SET(vortex(s).inner = real(v)), positive,
       {}, false, {}, of_vortex},
      {"motion.outer", number, "outer radius ro [m]", GET(vortex(s).outer), SET(vortex(s).outer = real(v)), positive,
       {}, false, {}, of_vortex},
      {"motion.path", text, "CSV file of F(t) in place of final: columns t, F11, F12, F21, F22 and perhaps the others",
       path_of, set_path, {}, {}, false, "none: F goes straight to final", of_homogeneous},
      {"motion.final", matrix, "deformation gradient at t = period, det > 0 [1]", final_gradient, set_final_gradient,
       {}, {}, false, "none: required unless path is given", of_homogeneous},
      {"motion.period", number, "T [s]; of a path the time of its last row", GET(period_of(s.motion)), set_period,
       positive},
  };
  for (auto part : {vortex_keys(), stretch_keys()}) keys.insert(keys.end(), part.begin(), part.end());
  keys.push_back({"motion.allow_unstable", boolean,
                  "run a motion that is not a stable solution for the model: it is refused otherwise",
                  GET(s.allow_unstable), SET(s.allow_unstable = std::get<bool>(v))});
  for (const Key& key : frame_keys()) keys.push_back(key);
  return keys;
}

// clang-format on
#undef GET
#undef SET

std::string motion_type(const Scene& scene) {
  return std::visit([](const auto& motion) { return type_name(motion); }, scene.motion);
}

}  // namespace assay::drivers
