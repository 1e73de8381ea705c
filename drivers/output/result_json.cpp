// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/result_json.hpp"

#include <nlohmann/json.hpp>

#include "drivers/output/json_depth.hpp"
#include "drivers/output/json_figure.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

Json count_or_null(const std::optional<std::int64_t>& value) { return value ? Json(*value) : Json(nullptr); }

Json maximum(const FieldMaximum& field) {
  return Json::object({{"l2_max", json_figure(field.l2_max)}, {"linf_max", json_figure(field.linf_max)}});
}

Json errors(const ErrorFigures& error) {
  Json out;
  out["l2_half"] = json_figure(error.l2_half);
  out["l2_end"] = json_figure(error.l2_end);
  out["l2_max"] = json_figure(error.l2_max);
  out["linf_max"] = json_figure(error.linf_max);
  out["rms36_half"] = json_figure(error.rms36_half);
  out["rms36_end"] = json_figure(error.rms36_end);
  out["rms36_max"] = json_figure(error.rms36_max);
  out["velocity"] = maximum(error.velocity);
  out["deformation_gradient"] = maximum(error.deformation_gradient);
  out["jacobian"] = maximum(error.jacobian);
  out["stress"] = maximum(error.stress);
  out["relative"] = json_figure(error.relative);
  return out;
}

/// Read and written in the particle columns by all steps.
double bytes_of(const Result& result) {
  double bytes = 0;
  for (const PassFigures& pass : result.passes) bytes += pass.bytes_per_particle;
  return bytes * static_cast<double>(result.particle_steps);
}

Json passes(const std::vector<PassFigures>& list) {
  Json out = Json::array();
  for (const PassFigures& pass : list) {
    out.push_back(Json::object({{"name", pass.name},
                                {"seconds", json_figure(pass.seconds)},
                                {"bytes_per_particle", json_figure(pass.bytes_per_particle)}}));
  }
  return out;
}

Json sheet(const std::optional<SheetFigures>& figures) {
  Json out;
  out["points"] = figures ? Json(figures->points) : Json(nullptr);
  out["error_tau"] = figures ? json_figure(figures->error_tau) : Json(nullptr);
  out["error_dtau"] = figures ? json_figure(figures->error_dtau) : Json(nullptr);
  out["error_b"] = figures ? json_figure(figures->error_b) : Json(nullptr);
  out["wall_s"] = figures ? json_figure(figures->wall_s) : Json(nullptr);
  out["cached"] = figures ? Json(figures->cached) : Json(nullptr);
  return out;
}

Json screen(const std::optional<ScreenFigures>& found) {
  const ScreenFigures figures = found.value_or(ScreenFigures{});
  Json out;
  out["verdict"] = found ? Json(figures.verdict) : Json(nullptr);
  out["t"] = json_figure(figures.t);
  out["xi"] = json_figure(figures.xi);
  out["gamma"] = json_figure(figures.gamma);
  out["smallest"] = json_figure(figures.smallest);
  out["unjudged"] = found ? Json(figures.unjudged) : Json(nullptr);
  out["largest_safe_amplitude"] = json_figure(figures.largest_safe_amplitude);
  out["wall_s"] = found ? json_figure(figures.wall_s) : Json(nullptr);
  return out;
}

Json reference(const ReferenceFigures& figures) {
  Json out;
  out["closed_form"] = json_figure(figures.closed_form);
  out["rate_form"] = json_figure(figures.rate_form);
  return out;
}

Json growth(const std::optional<GrowthFigures>& figures) {
  Json out;
  out["rate"] = figures ? json_figure(figures->rate) : Json(nullptr);
  out["from"] = figures ? json_figure(figures->from) : Json(nullptr);
  out["to"] = figures ? json_figure(figures->to) : Json(nullptr);
  return out;
}

Json tractions(const std::vector<TractionRun>& runs) {
  Json out = Json::array();
  for (const TractionRun& run : runs) {
    out.push_back(Json::object({{"algorithm", run.algorithm},
                                {"form", json_text(run.form)},
                                {"spacing", json_figure(run.spacing)},
                                {"outcome", run.outcome},
                                {"t", json_figure(run.t)},
                                {"l2_end", json_figure(run.l2_end)},
                                {"l2_max", json_figure(run.l2_max)}}));
  }
  return out;
}

Json rim(const std::optional<RimFigures>& figures) {
  Json out;
  out["width"] = figures ? json_figure(figures->width) : Json(nullptr);
  out["cells"] = figures ? json_figure(figures->cells) : Json(nullptr);
  return out;
}

Json drift(const DriftFigures& figures) {
  Json out;
  out["mass"] = json_figure(figures.mass);
  out["momentum"] = json_figure(figures.momentum);
  out["angular_momentum"] = json_figure(figures.angular_momentum);
  out["energy"] = json_figure(figures.energy);
  return out;
}

Json health(const HealthFigures& figures) {
  Json out;
  out["jacobian_min"] = json_figure(figures.jacobian_min);
  out["fastest"] = json_figure(figures.fastest);
  out["courant"] = json_figure(figures.courant);
  out["domain_extent"] = json_figure(figures.domain_extent);
  out["energy"] = json_figure(figures.energy);
  return out;
}

Json expectations(const std::vector<ExpectationOutcome>& list) {
  Json out = Json::array();
  for (const ExpectationOutcome& item : list) {
    out.push_back(
        Json::object({{"key", item.key}, {"expected", item.expected}, {"found", item.found}, {"holds", item.holds}}));
  }
  return out;
}

Json provenance(const Provenance& from) {
  Json out;
  out["version"] = from.version;
  out["git"] = from.git;
  out["compiler"] = from.compiler;
  out["flags"] = from.flags;
  out["libraries"] = from.libraries;
  out["material"] = from.material;
  out["scene_sha256"] = from.scene_sha256;
  return out;
}

Json tree(const Result& result) {
  Json out;
  out["outcome"] = result.outcome;
  out["reason"] = json_text(result.reason);
  out["warnings"] = result.warnings;
  out["t"] = json_figure(result.t);
  out["dt"] = json_figure(result.dt);
  out["steps"] = count_or_null(result.steps);
  out["particles"] = count_or_null(result.particles);
  out["particles_held"] =
      result.particles && result.moving_particles ? Json(*result.particles - *result.moving_particles) : Json(nullptr);
  out["uses_exact_solution"] = result.uses_exact_solution;
  out["error"] = errors(result.error);
  out["setup_s"] = json_figure(result.setup_s);
  out["wall_s"] = json_figure(result.wall_s);
  out["finish_s"] = json_figure(result.finish_s);
  out["cpu_s"] = json_figure(result.cpu_s);
  out["step_cpu_s"] = json_figure(result.step_cpu_s);
  out["peak_rss_bytes"] = result.peak_rss_bytes;
  out["work"] = Json::object({{"particle_steps", result.particle_steps},
                              {"material_calls", result.material_calls},
                              {"hand_overs", result.hand_overs},
                              {"wake_ups", result.wake_ups},
                              {"bytes", bytes_of(result)}});
  out["particle_steps_per_s"] = json_figure(result.particle_steps_per_s);
  out["passes"] = passes(result.passes);
  out["sheet"] = sheet(result.sheet);
  out["screen"] = screen(result.screen);
  out["reference"] = reference(result.reference);
  out["rim"] = rim(result.rim);
  out["growth"] = growth(result.growth);
  if (result.tractions) out["tractions"] = tractions(result.tractions->runs);
  out["drift"] = drift(result.drift);
  out["health"] = health(result.health);
  out["last_good"] = json_text(result.last_good);
  out["replay"] = json_text(result.replay);
  out["expect"] = expectations(result.expect);
  out["provenance"] = provenance(result.provenance);
  return out;
}

FlatValue leaf(const Json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  return std::monostate{};
}

template <typename Visit>
void visit_leaves(const Json& object, const std::string& prefix, const Visit& visit) {
  for (const auto& item : object.items()) {
    const std::string key = prefix.empty() ? item.key() : prefix + "." + item.key();
    if (item.value().is_object()) {
      visit_leaves(item.value(), key, visit);
    } else if (!item.value().is_array()) {
      visit(key, item.value());
    }
  }
}

}  // namespace

std::string result_json(const Result& result) {
  // A reason may quote foreign text: bytes that are no UTF-8 must not stop the report.
  return tree(result).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::map<std::string, FlatValue> flatten(const Result& result) {
  std::map<std::string, FlatValue> out;
  visit_leaves(tree(result), {}, [&](const std::string& key, const Json& value) { out[key] = leaf(value); });
  return out;
}

std::vector<std::string> flat_keys() {
  std::vector<std::string> out;
  visit_leaves(tree(Result{}), {}, [&](const std::string& key, const Json&) { out.push_back(key); });
  return out;
}

std::optional<ReadResult> read_result_json(const std::string& text) {
  if (is_nested_deeply(text)) return std::nullopt;
  const Json root = Json::parse(text, nullptr, false);
  if (!root.is_object() || !root.value("outcome", Json()).is_string()) return std::nullopt;
  ReadResult read;
  visit_leaves(root, {}, [&](const std::string& key, const Json& value) { read.figures[key] = leaf(value); });
  for (const Json& pass : root.value("passes", Json::array())) {
    if (!pass.is_object()) return std::nullopt;
    const auto number = [&](const char* key) {
      const Json value = pass.value(key, Json());
      return value.is_number() ? value.get<double>() : 0;
    };
    const Json name = pass.value("name", Json());
    if (!name.is_string()) return std::nullopt;
    read.passes.push_back({name.get<std::string>(), number("seconds"), number("bytes_per_particle")});
  }
  return read;
}

}  // namespace assay::drivers
