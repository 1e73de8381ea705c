// SPDX-License-Identifier: BSD-3-Clause
// The worker's side of the stress pass.
#include <algorithm>
#include <cstring>
#include <sstream>

#include "adapters/worker/servant.hpp"
#include "adapters/worker/watched_call.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/simulation/stress_offload.hpp"
#include "drivers/simulation/stress_page.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// In declared order.
std::map<std::string, double> parameters_in(const std::string& line, const assay_material& table) {
  std::map<std::string, double> parameters;
  std::istringstream words(line);
  std::string word;
  for (std::uint32_t k = 0; k < table.parameter_count && words >> word; ++k) {
    parameters[table.parameters[k].name] = parse_number(word).value_or(0);
  }
  return parameters;
}

mpm::StressColumns<2> columns_in(const StressPage& page, double* base) {
  mpm::StressColumns<2> columns;
  for (std::size_t c = 0; c < 4; ++c) {
    columns.deformation_gradient[c] = base + page.deformation_gradient[c];
    columns.velocity_gradient[c] = base + page.velocity_gradient[c];
  }
  for (std::size_t c = 0; c < 5; ++c) columns.stress[c] = base + page.stress[c];
  for (std::size_t end : {0, 1}) columns.history[end] = base + page.history[end];
  if (page.scales_volume[0] != 0) columns.volume_scale = base + page.volume_scale[0];
  if (page.scales_volume[1] != 0) columns.volume_scale_before = base + page.volume_scale[1];
  columns.rate_of_F = page.rate_of_F != 0;
  return columns;
}

void refuse(StressPage& page, std::size_t particle, const std::string& message) {
  page.found = StressPage::Found::refused;
  page.particle = particle;
  page.message[message.copy(page.message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
}

void step(StressPage& page, const mpm::StressColumns<2>& columns, const Material& material,
          mpm::BlockScratch<2>& scratch) {
  for (page.block = page.begin; page.block < page.end; page.block += mpm::block_size) {
    const std::size_t end = std::min(page.end, page.block + mpm::block_size);
    const mpm::BlockOutcome outcome = mpm::update_block(columns, material, page.block, end, {page.t, page.dt}, scratch);
    if (outcome.inverted) {
      page.found = StressPage::Found::inverted;
      page.particle = *outcome.inverted;
      return;
    }
    if (outcome.refused) return refuse(page, *outcome.refused, outcome.message);
  }
}

}  // namespace

void serve_stress(adapters::WorkerFloor& floor, const std::string& task) {
  const adapters::SharedMemory memory = adapters::SharedMemory::of_file(adapters::columns_file);
  auto& page = *reinterpret_cast<StressPage*>(floor.arrays);
  const std::size_t line = task.find('\n');
  adapters::next_request(floor.control);
  const adapters::WatchedProcess watched(floor.control);
  const assay_material* table = table_of_task(task.substr(line + 1));
  const Material material(table, parameters_in(task.substr(0, line), *table));
  const mpm::StressColumns<2> columns = columns_in(page, static_cast<double*>(memory.data()));
  mpm::BlockScratch<2> scratch(page.scratch);
  for (;;) {
    adapters::next_request(floor.control);
    {
      const adapters::ForeignCall marks(floor.control);
      step(page, columns, material, scratch);
    }
    adapters::answer(floor.control);
  }
}

}  // namespace assay::drivers
