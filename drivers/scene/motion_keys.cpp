// SPDX-License-Identifier: BSD-3-Clause
// The keys of `motion`, of which each motion's record has its own.
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

#include "drivers/scene/key_values.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/registry.hpp"

namespace assay::drivers {

namespace {

/// Shows each key of a motion with its value; one that is answered is given to the motion.
class EachKey final : public MotionKeys {
 public:
  using Words = std::vector<std::string>;
  using Answer = std::optional<Value>;
  using Show = std::function<Answer(const MotionKey&, KeyType, const Words& words, const Value&)>;
  explicit EachKey(Show show) : show_(std::move(show)) {}

  bool number(const MotionKey& key, double& value) override { return show(key, value); }
  bool whole(const MotionKey& key, int& value) override { return show(key, value); }
  bool vector(const MotionKey& key, Vector3& value) override { return show(key, value); }
  bool tensor(const MotionKey& key, Tensor& value) override { return show(key, value); }
  bool number_or_auto(const MotionKey& key, std::optional<double>& value) override {
    return answered(show_(key, KeyType::automatic, {}, value ? Value(*value) : Value("auto")), value);
  }
  bool word(const MotionKey& key, std::span<const char* const> words, int& which) override {
    const Words names(words.begin(), words.end());
    std::string name = names[static_cast<std::size_t>(which)];
    const bool given = answered(show_(key, KeyType::choice, names, name), name);
    which = static_cast<int>(index_of(name, names));
    return given;
  }

 private:
  template <class T>
  bool show(const MotionKey& key, T& value) {
    return answered(show_(key, type_of<T>(), {}, value_of(value)), value);
  }
  static bool answered(const Answer& answer, auto& value) {
    if (answer) give(value, *answer);
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
    keys.push_back(key_by(
        "motion." + name, key.doc, type, [name](const Scene& s) { return value_in(s, name); },
        [name](Scene& s, const Value& v) { give_motion(s, name, v); },
        {.range = key.range,
         .choices = words,
         .required = key.required,
         .derived = key.derived,
         .motions = {std::string(motion->type())}}));
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

std::vector<Key> keys_before() {
  return {key("title", "one-line title for pictures and reports", ASSAY_AT(title)),
          key_by("motion.type", "which manufactured motion the body follows", KeyType::choice,
                 [](const Scene& s) { return Value(motion_type(s)); }, set_motion,
                 {.choices = types_of([](const Motion&) { return true; }), .required = true})};
}

/// Without a table the motion refuses motion.interpolation. The reader reads the file when it knows where the scene
/// lies.
std::vector<Key> keys_of_table() {
  const auto table_of = [](auto& s) { return s.motion.template as<DeformationTable>(); };
  return {
      key_by(
          "motion.path", "CSV file of F(t), in place of motion.final; columns t, F11, F12, F21, F22, others optional",
          KeyType::text, [=](const Scene& s) { return table_of(s) ? Value(table_of(s)->source()) : Value(); },
          [](Scene& s, const Value& v) { s.motion = DeformationTable(std::get<std::string>(v)); },
          {.derived = "none: F goes straight to final", .motions = {"homogeneous"}}),
      key_by(
          "motion.interpolation",
          "F between the rows of motion.path: straight lines, PCHIP (no overshoot) or a cubic spline", KeyType::choice,
          [=](const Scene& s) { return table_of(s) ? value_of(table_of(s)->interpolation()) : Value(); },
          [=](Scene& s, const Value& v) {
            if (!table_of(s)) return;
            Interpolation interpolation = table_of(s)->interpolation();
            give(interpolation, v);
            s.motion = table_of(s)->interpolated(interpolation);
          },
          {.choices = words_of<Interpolation>(),
           .derived = "linear for tabulate, monotone for what needs a body force",
           .motions = {"homogeneous"}})};
}

std::vector<Key> keys_behind() {
  const std::vector<std::string> of_vortex = types_of(is_vortex);
  const auto velocity_of = [](const Scene& s) {
    return s.frame ? Value(std::vector<double>{s.frame->velocity.x(), s.frame->velocity.y()}) : Value();
  };
  return {
      key("motion.allow_unstable",
          "run a motion that is not a stable solution for the model; otherwise the run is refused",
          ASSAY_AT(allow_unstable)),
      key("frame.angle", "angle by which body and motion are rotated against the grid, about E_z [rad]",
          ASSAY_IN(frame, angle), {.motions = of_vortex}),
      key("frame.spin", "angular velocity w: the whole motion rotates by a further angle w t [rad/s]",
          ASSAY_IN(frame, spin), {.motions = of_vortex}),
      key_by("frame.velocity", "velocity of the whole motion [m/s]", KeyType::pair, velocity_of,
             [](Scene& s, const Value& v) { give(s.frame->velocity, v); }, {.motions = of_vortex}),
  };
}

}  // namespace

std::vector<Key> motion_keys() {
  std::vector<Key> keys = keys_before(), of_motions = keys_of_motions();
  const auto instead =
      std::find_if(of_motions.begin(), of_motions.end(), [](const Key& key) { return key.path == "motion.final"; });
  const std::vector<Key> of_table = keys_of_table();
  of_motions.insert(instead, of_table.begin(), of_table.end());
  append_all(keys, of_motions);
  append_all(keys, keys_behind());
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
