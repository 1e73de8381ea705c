// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/motion_keys.hpp"

#include <algorithm>

#include "drivers/scene/key_values.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/registry.hpp"

namespace assay::drivers {

namespace {

Value list_of(const Vector3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }
Vector3 vector_of(const Value& v) {
  const auto& list = std::get<std::vector<double>>(v);
  return {list[0], list[1], list[2]};
}

Value list_of(const Tensor& tensor) {
  std::vector<double> list;
  for (int i = 0; i < 9; ++i) list.push_back(component(tensor, i));
  return list;
}
Tensor tensor_of(const Value& v) {
  Tensor tensor;
  for (int i = 0; i < 9; ++i) component(tensor, i) = std::get<std::vector<double>>(v)[static_cast<std::size_t>(i)];
  return tensor;
}

/// Shows each key of a motion with its value; one that is answered is given to the motion.
class EachKey final : public MotionKeys {
 public:
  using Answer = std::optional<Value>;
  using Show = std::function<Answer(const MotionKey&, KeyType, const std::vector<std::string>& words, const Value&)>;
  explicit EachKey(Show show) : show_(std::move(show)) {}

  bool number(const MotionKey& key, double& value) override {
    return answered(show_(key, KeyType::number, {}, value), [&](const Value& v) { value = std::get<double>(v); });
  }
  bool whole(const MotionKey& key, int& value) override {
    return answered(show_(key, KeyType::number, {}, double(value)), [&](const Value& v) { drivers::give(value, v); });
  }
  bool number_or_auto(const MotionKey& key, std::optional<double>& value) override {
    return answered(show_(key, KeyType::automatic, {}, value ? Value(*value) : Value("auto")),
                    [&](const Value& v) { value = std::get<double>(v); });
  }
  bool word(const MotionKey& key, std::span<const char* const> words, int& which) override {
    const std::vector<std::string> names(words.begin(), words.end());
    return answered(show_(key, KeyType::choice, names, names[static_cast<std::size_t>(which)]), [&](const Value& v) {
      which = static_cast<int>(std::find(names.begin(), names.end(), std::get<std::string>(v)) - names.begin());
    });
  }
  bool vector(const MotionKey& key, Vector3& value) override {
    return answered(show_(key, KeyType::vector, {}, list_of(value)), [&](const Value& v) { value = vector_of(v); });
  }
  bool tensor(const MotionKey& key, Tensor& value) override {
    return answered(show_(key, KeyType::matrix, {}, list_of(value)), [&](const Value& v) { value = tensor_of(v); });
  }

 private:
  template <class Take>
  bool answered(const Answer& answer, const Take& take) {
    if (answer) take(*answer);
    return answer.has_value();
  }
  Show show_;
};

/// Absent where the scene's motion has no such key.
Value value_in(const Scene& scene, const std::string& name) {
  Value found;
  EachKey each([&](const MotionKey& key, KeyType, const auto&, const Value& value) -> EachKey::Answer {
    if (key.name == name) found = value;
    return std::nullopt;
  });
  Motion(scene.motion)->keys(each);
  return found;
}

void give_motion(Scene& scene, const std::string& name, const Value& value) {
  EachKey each([&](const MotionKey& key, KeyType, const auto&, const Value&) {
    return key.name == name ? EachKey::Answer(value) : std::nullopt;
  });
  scene.motion->keys(each);
}

/// The keys of one motion, in its order.
std::vector<Key> keys_of(Motion motion) {
  std::vector<Key> keys;
  EachKey each([&](const MotionKey& key, KeyType type, const auto& words, const Value&) -> EachKey::Answer {
    const std::string name = key.name;
    keys.push_back({"motion." + name,
                    type,
                    key.doc,
                    [name](const Scene& s) { return value_in(s, name); },
                    [name](Scene& s, const Value& v) { give_motion(s, name, v); },
                    key.range,
                    words,
                    key.required,
                    key.derived,
                    {std::string(motion->type())}});
    return std::nullopt;
  });
  motion->keys(each);
  return keys;
}

/// The keys of all motions, each once: a motion that has it later adds its word. The order within each motion stays.
std::vector<Key> keys_of_motions() {
  std::vector<Key> all;
  const auto place = [&](const std::string& path) {
    return std::find_if(all.begin(), all.end(), [&](const Key& key) { return key.path == path; });
  };
  for (const Motion& motion : motion_registry().samples()) {
    const std::vector<Key> own = keys_of(motion);
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (const auto same = place(own[k].path); same != all.end()) {
        same->motions.push_back(own[k].motions.front());
        continue;
      }
      auto before = all.end();
      for (std::size_t next = k + 1; next < own.size() && before == all.end(); ++next) before = place(own[next].path);
      all.insert(before, own[k]);
    }
  }
  return all;
}

void set_motion(Scene& s, const Value& v) {
  for (const Motion& sample : motion_registry().samples()) {
    if (sample->type() == std::get<std::string>(v)) s.motion = sample;
  }
}

/// The reader reads the file when it knows where the scene lies.
void set_path(Scene& s, const Value& v) { s.motion = DeformationTable(std::get<std::string>(v)); }
Value path_of(const Scene& s) {
  const auto* table = s.motion.as<DeformationTable>();
  return table ? Value(table->source()) : Value();
}

/// Without a table the motion refuses the key.
void set_interpolation(Scene& s, const Value& v) {
  if (auto* table = s.motion.as<DeformationTable>()) {
    Interpolation interpolation = table->interpolation();
    give(interpolation, v);
    s.motion = table->interpolated(interpolation);
  }
}
Value interpolation_of(const Scene& s) {
  const auto* table = s.motion.as<DeformationTable>();
  return table ? value_of(table->interpolation()) : Value();
}

void set_frame_velocity(Scene& s, const Value& v) {
  const auto& list = std::get<std::vector<double>>(v);
  s.frame->velocity = {list[0], list[1], 0};
}
Value frame_velocity_of(const Scene& s) {
  return s.frame ? Value(std::vector<double>{s.frame->velocity.x(), s.frame->velocity.y()}) : Value();
}

std::vector<Key> keys_before() {
  return {
      key("title", "one-line title for pictures and reports", ASSAY_AT(title)),
      {"motion.type",
       KeyType::choice,
       "which manufactured motion the body follows",
       [](const Scene& s) { return Value(motion_type(s)); },
       set_motion,
       {},
       types_of([](const Motion&) { return true; }),
       true},
  };
}

std::vector<Key> keys_of_table() {
  const std::vector<std::string> of_homogeneous{"homogeneous"};
  return {
      {"motion.path",
       KeyType::text,
       "CSV file of F(t), in place of motion.final; columns t, F11, F12, F21, F22, others optional",
       path_of,
       set_path,
       {},
       {},
       false,
       "none: F goes straight to final",
       of_homogeneous},
      {"motion.interpolation",
       KeyType::choice,
       "F between the rows of motion.path: straight lines, PCHIP (no overshoot) or a cubic spline",
       interpolation_of,
       set_interpolation,
       {},
       words_of<Interpolation>(),
       false,
       "linear for tabulate, monotone for what needs a body force",
       of_homogeneous},
  };
}

std::vector<Key> keys_behind() {
  const std::vector<std::string> of_vortex = types_of(is_vortex);
  return {
      key("motion.allow_unstable",
          "run a motion that is not a stable solution for the model; otherwise the run is refused",
          ASSAY_AT(allow_unstable)),
      key("frame.angle", "angle by which body and motion are rotated against the grid, about E_z [rad]",
          ASSAY_IN(frame, angle), {.motions = of_vortex}),
      key("frame.spin", "angular velocity w: the whole motion rotates by a further angle w t [rad/s]",
          ASSAY_IN(frame, spin), {.motions = of_vortex}),
      {"frame.velocity",
       KeyType::pair,
       "velocity of the whole motion [m/s]",
       frame_velocity_of,
       set_frame_velocity,
       {},
       {},
       false,
       {},
       of_vortex},
  };
}

}  // namespace

std::vector<Key> motion_keys() {
  std::vector<Key> keys = keys_before();
  for (auto part : {keys_of_motions(), keys_behind()}) keys.insert(keys.end(), part.begin(), part.end());
  const auto instead =
      std::find_if(keys.begin(), keys.end(), [](const Key& key) { return key.path == "motion.final"; });
  const std::vector<Key> table = keys_of_table();
  keys.insert(instead, table.begin(), table.end());
  return keys;
}

std::vector<std::string> types_of(const std::function<bool(const Motion&)>& holds) {
  std::vector<std::string> types;
  for (const Motion& sample : motion_registry().samples()) {
    if (holds(sample)) types.emplace_back(sample->type());
  }
  return types;
}

std::string motion_type(const Scene& scene) { return std::string(scene.motion->type()); }

}  // namespace assay::drivers
