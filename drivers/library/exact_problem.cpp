// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/library/exact_problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "adapters/process/process_watch.hpp"
#include "adapters/process/shortage.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/result/result.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::drivers {

namespace {

constexpr const char* text_file = "text";  ///< how messages call a scene that is no file

/// Effects of a step are left out (left_out.cpp), and so are their keys.
Scene scene_without_steps(std::string_view text, const std::string& file, const std::vector<std::string>& sets) {
  Tree root = scene_tree(text, file);
  for (const std::string& setting : sets) apply_setting(root, parse_setting(setting));
  std::erase_if(root.entries, [](const Tree::Entry& entry) { return entry.key == "remedies"; });
  return scene_of(root, file, sha256_hex(text));
}

Scene scene_of_options(const assay_options& options) {
  refuse_call_if(!options.scene == !options.text, "options.scene", "give either scene, a path, or text");
  refuse_call_if(options.set_count > 0 && !options.sets, "options.sets", "must not be null");
  std::vector<std::string> sets;
  for (std::size_t k = 0; k < options.set_count; ++k) {
    refuse_call_if(!options.sets[k], "options.sets", "must not be null");
    sets.emplace_back(options.sets[k]);
  }
  if (options.text) {
    const std::string_view text = options.text;
    refuse_call_if(text.size() > largest_text, "options.text",
                   "is longer than " + std::to_string(largest_text) + " bytes");
    return scene_without_steps(text, text_file, sets);
  }
  refuse_call_if(is_stream(options.scene), "options.scene", "is a stream, which belongs to the host: give its text");
  return scene_without_steps(read_bytes(options.scene), options.scene, sets);
}

void check_options(const assay_options& options) {
  constexpr std::int32_t most_threads = 1024;
  constexpr std::size_t most_sets = 100'000;
  refuse_call_if(
      options.api_major != ASSAY_API_MAJOR, "options.api_major",
      "is " + std::to_string(options.api_major) + ", and this library serves " + std::to_string(ASSAY_API_MAJOR));
  refuse_call_if(!(options.end >= 0) || std::isinf(options.end), "options.end", "must be a time [s], or 0");
  refuse_call_if(options.threads < 0 || options.threads > most_threads, "options.threads",
                 "must be 0 .. " + std::to_string(most_threads));
  refuse_call_if(options.set_count > most_sets, "options.set_count", "must be at most " + std::to_string(most_sets));
}

}  // namespace

std::shared_ptr<const ExactSlice> SliceCache::at(const ExactSolution& solution, double t) {
  constexpr std::size_t most = 32;  // times that threads may be at
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(guard_);
    const auto found = std::ranges::find_if(entries_, [&](const auto& each) { return each->t == t; });
    if (found != entries_.end()) {
      entry = *found;
    } else {
      if (entries_.size() == most)
        entries_.erase(std::ranges::min_element(entries_, {}, [](const auto& each) { return each->used; }));
      entry = entries_.emplace_back(std::make_shared<Entry>());
      entry->t = t;
    }
    entry->used = ++uses_;
  }
  std::call_once(entry->once, [&] { entry->slice = solution.slice(t); });
  return {entry, entry->slice.get()};
}

ExactProblem::ExactProblem(const assay_options& options) {
  const KeptWarnings heard;
  adapters::take_shortage();  // of another problem that went on all the same
  check_options(options);
  open(options);
  tables_.all_are_told();
  for (const std::string& sentence : heard.sentences()) warnings_ += sentence + "\n";
}

/// What the verb eval does, so that its tables hold the same numbers.
void ExactProblem::open(const assay_options& options) {
  scene_ = scene_of_options(options);
  require_acceleration(scene_);
  if (const std::string swing = swing_sentence(scene_); !swing.empty()) warn(swing);
  material_ = material_of(scene_, library_);
  end_ = options.end > 0 ? options.end : scene_.time.end;
  if (const auto* table = scene_.motion.as<DeformationTable>(); table && end_ > table->last())
    throw RefusedCall("options.end", "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  warn_of_instability(scene_, *material_, end_, true);
  if (scene_.force.response == ForceChoice::Response::none) scene_.force.response = ForceChoice::Response::sheet;
  three_ = scene_.dimension == 3 || scene_.motion->is_spatial();
  solution_ = exact_solution_of_points(scene_, material_, end_, true, std::max(1, options.threads));
  last_ = last_time();
  const std::string deeds = adapters::habit_words(adapters::marks_of(&material_->table()).habits);
  if (!deeds.empty()) warn("the model " + deeds);
}

/// Beyond the end a formula goes on, a history and a table of one do not. A curve over the strain has been all the way
/// once the motion has been through its period.
double ExactProblem::last_time() const {
  constexpr double ever = std::numeric_limits<double>::infinity();
  if (const auto* table = scene_.motion.as<DeformationTable>()) return std::min(end_, table->last());
  const Response* response = solution_->response();
  if (response && !response->sheet()) return ever;
  if (response) return response->sheet()->is_curve() && end_ >= scene_.motion->period() ? ever : end_;
  const bool in_box = scene_.motion.as<AxisAligned>();
  return material_->is_function_of_F() && !in_box ? ever : end_;
}

std::shared_ptr<const ExactSlice> ExactProblem::slice(double t) const {
  constexpr double rounding = 1e-9;  // of a sum of steps
  refuse_call_if(!(t >= 0) || std::isinf(t), "t", "must be a time of 0 or more [s]");
  if (t > last_ * (1 + rounding))
    throw RefusedCall(
        "t",
        rounded_text(t, 6) + " s is beyond " + rounded_text(last_, 6) + " s, where the response ends: set options.end",
        ASSAY_BEYOND_END);
  return slices_.at(*solution_, std::min(t + 0.0, last_));  // 0 for -0
}

bool ExactProblem::holds(const Vector3& X) const { return is_within_motion(scene_, X); }

assay_facts ExactProblem::facts() const {
  constexpr double wave_periods = 4;  // in which the fastest wave is looked for, as by a run
  assay_facts facts ASSAY_FACTS_INIT;
  facts.dimension = dimension();
  facts.end = end_;
  facts.period = scene_.motion->period();
  facts.density = density();
  for (const Path& path : baseline_paths(scene_))
    facts.wave_speed = std::max(facts.wave_speed, fastest_wave_on_path(*material_, path, density(),
                                                                       std::min(end_, wave_periods * facts.period)));
  Scene until_end = scene_;
  until_end.time.end = end_;
  facts.particle_speed = fastest_of_motion(until_end);
  return facts;
}

std::string ExactProblem::description() const {
  using Json = nlohmann::ordered_json;
  const Provenance built = build_information();
  Json all;
  all["version"] = built.version;
  all["git"] = built.git;
  all["compiler"] = built.compiler;
  all["title"] = scene_.title;
  all["file"] = scene_.file;
  all["scene_sha256"] = scene_.sha256;
  all["dimension"] = dimension();
  all["end"] = end_;
  const char* version = material_->table().version;
  all["material"] = {{"name", material_->name()},
                     {"version", version ? Json(version) : Json()},
                     {"library", library_.empty() ? Json() : Json(library_)}};
  Json response;
  const Response* of_path = solution_->response();
  const auto source = solution_->source();
  if (const Sheet* sheet = of_path ? of_path->sheet() : nullptr) {
    response = {{"kind", sheet->is_curve() ? "curve" : "sheet"},
                {"points", sheet->points()},
                {"cached", sheet->restored()},
                {"error_tau", json_figure(sheet->error_tau())},
                {"error_dtau", json_figure(sheet->error_dtau())}};
  } else if (of_path) {
    response = {{"kind", "closed_form"}};
  } else if (source) {
    response = {{"kind", source->what}, {"points", source->points}, {"error_tau", json_figure(source->error)}};
  } else {
    response = {{"kind", "formula"}};
  }
  response["asked"] = scene_.force.tolerance;
  all["response"] = response;
  all["scene"] = resolved_yaml(scene_);
  return json_document(all);
}

}  // namespace assay::drivers
