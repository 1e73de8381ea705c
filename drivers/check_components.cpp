// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_components.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/foreign/foreign_table.hpp"
#include "drivers/check_elsewhere.hpp"
#include "drivers/check_steps.hpp"
#include "drivers/material/material_description.hpp"

namespace assay::drivers {

namespace {

using adapters::ForeignModel;

std::optional<ForeignModel> silent_model(const CheckedMaterial& checked) {
  if (checked.description.empty()) return std::nullopt;
  auto model = read_description(checked.description).foreign;
  const bool silent = model && model->interface == adapters::ForeignInterface::umat && !model->components_are_said;
  return silent ? model : std::nullopt;
}

/// Whether a shear 13 has no stress of its own, or one that is nothing like that of a shear 12; or is the end.
bool fails_out_of_plane(const ForeignModel& model, const std::map<std::string, double>& parameters) {
  constexpr double limit_s = 20, little = 1e-2, much = 1e2, shear = 1e-4;
  const auto rows = made_elsewhere(
      [&]() -> check::History {
        const Material material(adapters::foreign_table(model), parameters);
        std::vector<double> row;
        for (const int place : {1, 2}) {
          Tensor F = Tensor::Identity();
          component(F, place) = shear;
          const Answer answer = answer_of(material, {0, 1, Tensor::Identity(), F, material.initial_state(1), true});
          row.push_back(is_good(answer) ? std::abs(answer[stress_of_answer + static_cast<std::size_t>(place)]) : NAN);
        }
        return {row};
      },
      limit_s);
  if (!rows) return true;
  const double in_plane = rows->front()[0], out_of_plane = rows->front()[1];
  return !(out_of_plane > little * in_plane && out_of_plane < much * in_plane);
}

}  // namespace

void hint_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how) {
  std::optional<ForeignModel> model;
  if (checked.passes() || checked.report.diagnosis.empty() || !(model = silent_model(checked))) return;
  const std::map<std::string, double> parameters(checked.parameters.begin(), checked.parameters.end());
  const CheckTask task{checked.name, [&](const CheckReporter& reporter) {
                         CheckedMaterial found;
                         if (!fails_out_of_plane(*model, parameters)) {
                           found.error = "it takes shears out of the plane";
                           return found;
                         }
                         reporter.begins("loading");
                         model->components = {4};
                         const Material material(adapters::foreign_table(*model), parameters);
                         check::Effort quick = effort;
                         quick.quick = true;
                         found.report = check::run_battery(material, {.effort = quick});
                         return found;
                       }};
  CheckProcesses quietly = how;
  quietly.progress = {};
  if (!check_in_processes({task}, quietly).front().passes()) return;
  checked.report.diagnosis.front().sentence +=
      "; with components: [4] in its description it passes: it fills the components of plane strain alone";
}

}  // namespace assay::drivers
