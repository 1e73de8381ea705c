// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/motion_keys.hpp"

#include <utility>

#include "drivers/scene/key_values.hpp"

namespace assay::drivers {

namespace {

const std::vector<std::string> motion_types{
    "vortex", "homogeneous", "rotating_stretch", "twisting_ring", "axis_aligned", "bar_1d", "rigid"};
const std::vector<std::string> amplitude_types{"sine", "one_minus_cosine", "ramp"};
const std::vector<std::string> interpolations{"linear", "monotone", "spline"};
const std::vector<std::string> rotate_types{"none", "simultaneous", "after"};
constexpr double box_peak = 0.1;  ///< A of the motions in the unit box unless the scene says otherwise

template <class Which>
Which& as(Scene& s) {
  return std::get<Which>(s.motion);
}
template <class Which>
const Which& as(const Scene& s) {
  return std::get<Which>(s.motion);
}

/// The ring's motion itself, or the twist of one that expands, too.
const Vortex& vortex(const Scene& s) {
  const auto* ring = std::get_if<TwistingRing>(&s.motion);
  return ring ? ring->twist : as<Vortex>(s);
}
Vortex& vortex(Scene& s) { return const_cast<Vortex&>(vortex(std::as_const(s))); }
const Amplitude& amplitude(const Scene& s) { return *amplitude_of(s.motion); }
Amplitude& amplitude(Scene& s) { return const_cast<Amplitude&>(amplitude(std::as_const(s))); }

std::string type_name(const Vortex&) { return motion_types[0]; }
std::string type_name(const Homogeneous&) { return motion_types[1]; }
std::string type_name(const RotatingStretch&) { return motion_types[2]; }
std::string type_name(const DeformationTable&) { return motion_types[1]; }
std::string type_name(const TwistingRing&) { return motion_types[3]; }
std::string type_name(const AxisAligned& motion) { return motion_types[motion.one_dimensional ? 5 : 4]; }
std::string type_name(const Rigid&) { return motion_types[6]; }

AxisAligned box_motion(bool one_dimensional) { return {{Amplitude::Type::sine, box_peak, 1}, one_dimensional, false}; }

void set_motion(Scene& s, const Value& v) {
  const std::vector<Motion> motions{
      Vortex{}, Homogeneous{}, RotatingStretch{}, TwistingRing{}, box_motion(false), box_motion(true), Rigid{}};
  for (std::size_t k = 0; k < motion_types.size(); ++k) {
    if (motion_types[k] == std::get<std::string>(v)) s.motion = motions[k];
  }
}

/// The reader reads the file when it knows where the scene lies.
void set_path(Scene& s, const Value& v) { s.motion = DeformationTable(std::get<std::string>(v)); }
Value path_of(const Scene& s) {
  const auto* table = std::get_if<DeformationTable>(&s.motion);
  return table ? Value(table->source()) : Value();
}

/// Without a table scene_check refuses the key.
void set_interpolation(Scene& s, const Value& v) {
  if (auto* table = std::get_if<DeformationTable>(&s.motion)) {
    s.motion = table->interpolated(picked<Interpolation>(interpolations, v));
  }
}
Value interpolation_of(const Scene& s) {
  const auto* table = std::get_if<DeformationTable>(&s.motion);
  return table ? name_of(interpolations, table->interpolation()) : Value();
}

void set_period(Scene& s, const Value& v) {
  if (amplitude_of(s.motion)) amplitude(s).period = real(v);
  if (auto* motion = std::get_if<Homogeneous>(&s.motion)) motion->period = real(v);
  if (auto* motion = std::get_if<RotatingStretch>(&s.motion)) motion->period = real(v);
  if (auto* motion = std::get_if<Rigid>(&s.motion)) motion->period = real(v);
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

void set_wave_speed(Scene& s, const Value& v) {
  as<AxisAligned>(s).amplitude.period = 1 / real(v);
  as<AxisAligned>(s).given_speed = true;
}

const Vector3& axis(const Scene& s) {
  const auto* stretch = std::get_if<RotatingStretch>(&s.motion);
  return stretch ? stretch->axis : as<Rigid>(s).axis;
}
Vector3& axis(Scene& s) { return const_cast<Vector3&>(axis(std::as_const(s))); }

Value list_of(const Vector3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }
Vector3 vector_of(const Value& v) { return {three(v)[0], three(v)[1], three(v)[2]}; }

#define GET(expression) [](const Scene& s) -> Value { return expression; }
#define SET(statement) [](Scene& s, const Value& v) { statement; }

// clang-format off
std::vector<Key> amplitude_keys() {
  using enum KeyType;
  const std::vector<std::string> polar{"vortex", "twisting_ring"}, boxes{"axis_aligned", "bar_1d"},
      all{"vortex", "twisting_ring", "axis_aligned", "bar_1d"};
  return {
      {"motion.profile_power", number, "m of the profile h = (1 - s^2)^m; m = 1 is excluded: the ring's faces would need tractions",
       GET(double(vortex(s).profile_power)), SET(vortex(s).profile_power = whole(v)),
       {.lower = 2, .upper = 64, .whole = true}, {}, false, {}, polar},
      {"motion.expansion", number, "e: radii change by e sin(pi t/T) U(R), with U = 1 at the outer radius [m]",
       GET(as<TwistingRing>(s).expansion), SET(as<TwistingRing>(s).expansion = real(v)), {}, {}, true, {},
       {"twisting_ring"}},
      {"motion.amplitude.type", choice, "sine: A sin(pi t/T); one_minus_cosine: A (1 - cos(2 pi t/T))/2; ramp: A t/T to T; unit box: sine only",
       GET(name_of(amplitude_types, amplitude(s).type)),
       SET(amplitude(s).type = picked<Amplitude::Type>(amplitude_types, v)), {}, amplitude_types, false, {}, all},
      {"motion.amplitude.peak", number, "A: peak angle of a ring [rad]; in the unit box, peak displacement, less than 1/pi [m]",
       GET(amplitude(s).peak), SET(amplitude(s).peak = real(v)), {}, {}, false, "1 of a ring, 0.1 in the unit box", all},
      {"motion.wave_speed", automatic, "c, which sets T = 1/c [m/s]; auto: c = sqrt(E/rho0) with the material's parameter E",
       GET(as<AxisAligned>(s).given_speed ? Value(as<AxisAligned>(s).wave_speed()) : Value("auto")), set_wave_speed,
       {.lower = least_wave_speed, .upper = most_wave_speed}, {}, false, {}, boxes},
  };
}

std::vector<Key> stretch_keys() {
  using enum KeyType;
  const std::vector<std::string> of_stretch{"rotating_stretch"}, of_rigid{"rigid"};
  return {
      {"motion.stretch", number, "a: the stretch along E1 is 1 + a sin^2(pi t/T), or 1 + a q(2 t/T) with rotate: after [1]",
       GET(as<RotatingStretch>(s).stretch), SET(as<RotatingStretch>(s).stretch = real(v)),
       {.lower = -1, .lower_open = true}, {}, true, {}, of_stretch},
      {"motion.shear", number, "k of the shear U12 = k (U11 - 1)/a [1]", GET(as<RotatingStretch>(s).shear),
       SET(as<RotatingStretch>(s).shear = real(v)), {}, {}, false, {}, of_stretch},
      {"motion.rotation", number, "total angle of rotation beta [rad]", GET(as<RotatingStretch>(s).rotation),
       SET(as<RotatingStretch>(s).rotation = real(v)), {}, {}, false, {}, of_stretch},
      {"motion.velocity", vector, "velocity of the whole body [m/s]", GET(list_of(as<Rigid>(s).velocity)),
       SET(as<Rigid>(s).velocity = vector_of(v)), {}, {}, false, {}, of_rigid},
      {"motion.spin", number, "angular velocity of the whole body about the axis through the origin [rad/s]", GET(as<Rigid>(s).spin),
       SET(as<Rigid>(s).spin = real(v)), {}, {}, false, {}, of_rigid},
      {"motion.axis", vector, "axis of the rotation; need not be a unit vector", GET(list_of(axis(s))), SET(axis(s) = vector_of(v)), {}, {},
       false, {}, {"rotating_stretch", "rigid"}},
      {"motion.rotate", choice, "when the body rotates: never (none), while it stretches (simultaneous) or afterwards (after)", 
       GET(name_of(rotate_types, as<RotatingStretch>(s).rotate)),
       SET(as<RotatingStretch>(s).rotate = picked<RotatingStretch::Rotate>(rotate_types, v)), {}, rotate_types, false, {},
       of_stretch},
  };
}

std::vector<Key> frame_keys() {
  using enum KeyType;
  const std::vector<std::string> of_vortex{"vortex"};
  return {
      {"frame.angle", number, "angle by which body and motion are rotated against the grid, about E_z [rad]",
       GET(s.frame ? Value(s.frame->angle) : Value()), SET(s.frame->angle = real(v)), {}, {}, false, {}, of_vortex},
      {"frame.spin", number, "angular velocity w: the whole motion rotates by a further angle w t [rad/s]",
       GET(s.frame ? Value(s.frame->spin) : Value()), SET(s.frame->spin = real(v)), {}, {}, false, {}, of_vortex},
      {"frame.velocity", pair, "velocity of the whole motion [m/s]",
       GET(s.frame ? pair_of({s.frame->velocity.x(), s.frame->velocity.y()}) : Value()),
       SET((s.frame->velocity = {two(v)[0], two(v)[1], 0})), {}, {}, false, {}, of_vortex},
  };
}

}  // namespace

std::vector<Key> motion_keys() {
  using enum KeyType;
  const std::vector<std::string> polar{"vortex", "twisting_ring"}, of_homogeneous{"homogeneous"},
      with_period{"vortex", "homogeneous", "rotating_stretch", "twisting_ring", "rigid"};
  std::vector<Key> keys{
      {"title", text, "one-line title for pictures and reports", GET(s.title), SET(s.title = std::get<std::string>(v))},
      {"motion.type", choice, "which manufactured motion the body follows", GET(motion_type(s)), set_motion, {}, motion_types, true},
      {"motion.inner", number, "inner radius ri of the ring [m]", GET(vortex(s).inner), SET(vortex(s).inner = real(v)), positive,
       {}, false, {}, polar},
      {"motion.outer", number, "outer radius ro of the ring [m]", GET(vortex(s).outer), SET(vortex(s).outer = real(v)), positive,
       {}, false, {}, polar},
      {"motion.path", text, "CSV file of F(t), in place of motion.final; columns t, F11, F12, F21, F22, others optional",
       path_of, set_path, {}, {}, false, "none: F goes straight to final", of_homogeneous},
      {"motion.interpolation", choice,
       "F between the rows of motion.path: straight lines, PCHIP (no overshoot) or a cubic spline",
       interpolation_of, set_interpolation, {}, interpolations, false,
       "linear for tabulate, monotone for what needs a body force", of_homogeneous},
      {"motion.final", matrix, "deformation gradient at t = motion.period, det F > 0 [1]", final_gradient, set_final_gradient,
       {}, {}, false, "none: required unless path is given", of_homogeneous},
      {"motion.period", number, "time T of the motion [s]; with motion.path, T is the time of the last row", GET(period_of(s.motion)), set_period,
       positive, {}, false, {}, with_period},
  };
  for (auto part : {amplitude_keys(), stretch_keys()}) keys.insert(keys.end(), part.begin(), part.end());
  keys.push_back({"motion.allow_unstable", boolean,
                  "run a motion that is not a stable solution for the model; otherwise the run is refused",
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
