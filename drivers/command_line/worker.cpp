// SPDX-License-Identifier: BSD-3-Clause
// The life of a worker.
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

#include "adapters/foreign/foreign_library.hpp"
#include "adapters/process/fate.hpp"
#include "adapters/worker/worker.hpp"
#include "drivers/command_line/command_line.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/material/tool_process.hpp"
#include "drivers/result/result.hpp"
#include "drivers/simulation/stress_offload.hpp"

namespace assay::drivers {

namespace {

void work(adapters::WorkerFloor& floor) {
  adapters::on_model_end = adapters::end_by_word;
  const std::string task = floor.task, kind = task.substr(0, task.find('\n'));
  if (kind == model_task) return serve_material(floor, task.substr(kind.size() + 1));
  if (kind == tool_task) return serve_tool(task.substr(kind.size() + 1));
  if (kind == stress_task) return serve_stress<2>(floor, task.substr(kind.size() + 1));
  if (kind == space_stress_task) return serve_stress<3>(floor, task.substr(kind.size() + 1));
  std::fprintf(stderr, "a worker knows no task '%s'\n", kind.c_str());
}

}  // namespace

bool is_worker(int argc, const char* const* argv) {
  return (argc == 2 || argc == 3) && std::strcmp(argv[1], "worker") == 0;
}

int worker(const char* build_of_host) noexcept {
  try {
    return adapters::run_worker(work, build_text(), build_of_host ? build_of_host : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "assay worker: is started by other verbs: %s\n", error.what());
    return 2;
  }
}

}  // namespace assay::drivers
