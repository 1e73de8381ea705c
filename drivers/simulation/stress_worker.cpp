// SPDX-License-Identifier: BSD-3-Clause
// The worker's side of the stress pass.
#include <algorithm>
#include <map>
#include <string>

#include "adapters/worker/worker.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/simulation/stress_offload.hpp"

namespace assay::drivers {

namespace {

mpm::StressColumns<2> columns_in(const StressPage& page, double* base) {
  mpm::StressColumns<2> columns = page.columns;
  const auto move = [&](double*& column) {
    if (column) column = base + (column - page.base);
  };
  for (auto* list : {&columns.deformation_gradient, &columns.velocity_gradient}) std::ranges::for_each(*list, move);
  std::ranges::for_each(columns.stress, move);
  std::ranges::for_each(columns.history, move);
  move(columns.volume_scale), move(columns.volume_scale_before);
  return columns;
}

void step(StressPage& page, const mpm::StressColumns<2>& columns, const Material& material,
          mpm::BlockScratch<2>& scratch) {
  for (page.block = page.begin; page.block < page.end; page.block += mpm::block_size) {
    const std::size_t end = std::min(page.end, page.block + mpm::block_size);
    const mpm::BlockOutcome outcome = mpm::update_block(columns, material, page.block, end, {page.t, page.dt}, scratch);
    if (!outcome.inverted && !outcome.refused) continue;
    page.found = outcome.inverted ? StressPage::Found::inverted : StressPage::Found::refused;
    page.particle = outcome.inverted ? *outcome.inverted : *outcome.refused;
    page.message[outcome.message.copy(page.message, ASSAY_MESSAGE_SIZE - 1)] = '\0';
    return;
  }
}

}  // namespace

void serve_stress(adapters::WorkerFloor& floor, const std::string& task) {
  const adapters::SharedMemory memory = adapters::SharedMemory::of_file(adapters::columns_file);
  auto& page = *reinterpret_cast<StressPage*>(floor.arrays);
  adapters::next_request(floor.control);
  const adapters::WatchedProcess watched(floor.control);
  const assay_material* table = table_of_task(task);
  std::map<std::string, double> parameters;
  for (std::uint32_t k = 0; k < table->parameter_count; ++k)
    parameters[table->parameters[k].name] = parameters_behind(page)[k];
  const Material material(table, parameters);
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
