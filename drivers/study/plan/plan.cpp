// SPDX-License-Identifier: BSD-3-Clause
// From a study's axes to its cases.
#include "drivers/study/plan/study.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/study/plan/study_reader.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/program_identity.hpp"
#include "drivers/text/sha256.hpp"

namespace assay::drivers {

namespace {

/// A base scene with what the study sets in every case.
struct Base {
  Tree tree;
  std::string file, sha256;
};

Base base_of(const Study& study, const std::string& file) {
  const std::string text = read_bytes(file);
  Base base{scene_tree(text, file), file, sha256_hex(text)};
  std::erase_if(base.tree.entries, [](const Tree::Entry& entry) { return entry.key == "expect"; });
  // what a case leaves unless the study asks for more
  for (const char* modest : {"output.particles=0", "output.report=false"})
    apply_setting(base.tree, parse_setting(modest));
  for (const Setting& setting : study.set) {
    if (setting.path != threads_key) apply_setting(base.tree, setting);
  }
  return base;
}

int threads_of(const Setting& setting) {
  return static_cast<int>(number_value(setting.value, threads_key, {.lower = 1, .upper = 4096, .whole = true}));
}

/// Names of levels that hold what stands between them are quoted where there are several axes with names.
std::string level_text(const Study& study, const std::string& name) {
  const auto named = std::ranges::count_if(study.axes, [](const auto& axis) { return !axis.is_key; });
  const bool plain = named < 2 || (name.find(", ") == name.npos && !name.starts_with('"'));
  return plain ? name : '"' + name + '"';
}

std::string label_of(const Study& study, const std::vector<AxisValue>& values, bool with_resolution) {
  std::string text;
  for (const AxisValue& value : values) {
    const auto axis = std::ranges::find_if(study.axes, [&](const StudyAxis& each) { return each.name == value.axis; });
    if (!with_resolution && !study.refine.empty() && sets_key(*axis, study.refine)) continue;
    text +=
        (text.empty() ? "" : ", ") + (axis->is_key ? value.axis + "=" + value.value : level_text(study, value.value));
  }
  return text.empty() ? "all" : one_line(text);
}

InputError not_a_number(const Study& study) {
  return {study.refine_where, "refine", "'" + one_line(study.refine, 80) + "' is no number of the scene"};
}

/// The value of the refined key, which is a number.
Figure resolution_of(const Study& study, const Scene& scene) {
  if (study.refine.empty()) return std::nullopt;
  for (const Key& key : scene_keys()) {
    if (key.path != study.refine) continue;
    const Value value = key.get(scene);
    if (const auto* number = std::get_if<double>(&value)) return *number;
  }
  throw not_a_number(study);
}

/// Of a key that no scene has a number at.
void check_refined(const Study& study) {
  const auto& keys = scene_keys();
  const bool can_be = std::ranges::any_of(keys, [&](const Key& key) {
    return key.path == study.refine && (key.type == KeyType::number || key.type == KeyType::automatic);
  });
  if (!study.refine.empty() && !can_be) throw not_a_number(study);
}

/// What no case is spared is no fault of a case.
void check_cases(const Plan& plan) {
  const auto& cases = plan.cases;
  if (std::ranges::all_of(cases, [](const PlannedCase& one) { return !one.invalid.empty(); }))
    throw InputError({plan.study.file, 0, 0}, "", "no case can be; the first: " + cases.front().invalid);
}

/// Makes cases of combinations.
class Planner {
 public:
  explicit Planner(const Study& study) : study_(study) {}

  /// `refined`: of a source of the error, ends the label.
  PlannedCase planned(const Combination& combination, const std::string& refined = {}) {
    PlannedCase one;
    one.values = combination.values;
    one.label = label_of(study_, one.values, true) + refined;
    one.series = label_of(study_, one.values, false);
    for (const NotApplicable& each : study_.not_applicable) {
      if (one.invalid.empty() && each.where.holds(one.values)) one.invalid = each.because;
    }
    try {
      if (one.invalid.empty()) read(combination.settings, one);
    } catch (const InputError& error) {
      if (!study_.skips_invalid) throw InputError(std::string(error.what()) + " (case: " + one.label + ")");
      one.invalid = error.what();
    }
    one.timed = one.invalid.empty() && !study_.timing.none && study_.timing.where.holds(one.values);
    return one;
  }

 private:
  /// Each scene is read once.
  const Base& base(const std::vector<Setting>& settings) {
    std::string file = study_.scene;
    for (const Setting& setting : settings) {
      if (setting.path == scene_key) file = scene_file(setting.value);
    }
    const auto found = bases_.find(file);
    return found != bases_.end() ? found->second : bases_.emplace(file, base_of(study_, file)).first->second;
  }

  void read(const std::vector<Setting>& settings, PlannedCase& one) {
    const Base& from = base(settings);
    Tree tree = from.tree;
    for (const auto* list : {&study_.set, &settings}) {
      for (const Setting& setting : *list) {
        if (setting.path == threads_key) {
          one.threads = threads_of(setting);
        } else if (list == &settings && setting.path != scene_key) {
          apply_setting(tree, setting);
        }
      }
    }
    Scene scene = scene_of(tree, from.file, from.sha256);
    if (!scene.method) throw InputError(study_.scene_where, scene_key, "has no method: there is nothing to run");
    one.resolution = resolution_of(study_, scene);
    try {
      scene = in_dimension(scene, [&](auto dimension) {
        const auto problem = assemble<dimension.value>(scene, one.threads);
        one.particle_steps = static_cast<double>(problem.setup.seeds.size()) * static_cast<double>(problem.steps);
        return problem.scene;
      });
    } catch (const MaterialFailure&) {
      one.particle_steps = 0;  // the run will say so
    }
    one.yaml = resolved_yaml(scene);
    one.key = case_key(scene, one.yaml, one.threads);
  }

  const Study& study_;
  std::map<std::string, Base> bases_;  ///< by file
};

/// The cases that the budget adds, each after the one whose error it divides.
void add_budget(const Study& study, Planner& planner, const std::vector<Combination>& combinations, Plan& plan) {
  if (!study.budget) return;
  const std::size_t count = plan.cases.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!study.budget->of.holds(plan.cases[i].values) || !plan.cases[i].invalid.empty()) continue;
    for (std::size_t k = 0; k < study.budget->sources.size(); ++k) {
      const BudgetSource& source = study.budget->sources[k];
      Combination finer = combinations[i];
      finer.settings.insert(finer.settings.end(), source.settings.begin(), source.settings.end());
      PlannedCase one = planner.planned(finer, ", " + one_line(source.name) + " refined");
      one.base = i, one.source = k, one.timed = false;
      one.number = plan.cases.size() + 1;
      plan.cases.push_back(std::move(one));
    }
  }
}

}  // namespace

Plan plan_of(Study study, const std::function<void(double)>& progress) {
  loaded_identity();  // before the library of a material is among those of the program
  Plan plan;
  check_refined(study);
  const std::vector<Combination> combinations = combinations_of(study);
  Planner planner(study);
  for (const Combination& combination : combinations) {
    plan.cases.push_back(planner.planned(combination));
    plan.cases.back().number = plan.cases.size();
    if (progress) progress(static_cast<double>(plan.cases.size()) / static_cast<double>(combinations.size()));
  }
  add_budget(study, planner, combinations, plan);
  std::set<std::string> timed;  // a scene that stands twice is one run
  for (const PlannedCase& one : plan.cases) {
    if (one.timed) timed.insert(one.key);
  }
  for (PlannedCase& one : plan.cases) one.timed = timed.contains(one.key);
  plan.study = std::move(study);
  check_cases(plan);
  return plan;
}

}  // namespace assay::drivers
