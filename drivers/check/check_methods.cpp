// SPDX-License-Identifier: BSD-3-Clause
// `assay check --methods`: the patch tests of every particle method that can be composed.
#include "adapters/builtin.hpp"
#include "drivers/check/check.hpp"
#include "drivers/check/methods_report.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

/// All that can be composed, or the one of that name.
std::vector<mpm::Method> chosen_methods(const std::string& name) {
  std::vector<mpm::Method> all = mpm::all_methods();
  if (name.empty()) return all;
  std::vector<std::string> names;
  for (const mpm::Method& method : all) {
    if (name_of(method) == name) return {method};
    names.push_back(name_of(method));
  }
  throw InputError({}, "--methods",
                   unknown("method '" + one_line(name, 60) + "'", name, names) + "; --methods alone prints them all");
}

}  // namespace

int check_methods(const CheckOptions& options) {
  watch_interrupts();
  const Stopwatch watch;
  CheckedMethods checked;
  const auto material = std::make_shared<const Material>(adapters::builtin_table("neo_hookean"),
                                                         std::map<std::string, double>{{"E", 1e3}, {"nu", 0.3}});
  const mpm::Bench bench = mpm::bench_of(material, options.quick);
  const std::vector<mpm::Method> methods = chosen_methods(options.material);
  Progress progress("check", options.verbosity == Verbosity::quiet);
  for (const mpm::Method& method : methods) {
    stop_if_interrupted();
    progress.update(static_cast<double>(checked.methods.size()) / static_cast<double>(methods.size()), name_of(method));
    checked.methods.push_back(mpm::run_patch_tests(method, bench));
  }
  progress.finish();
  checked.wall_s = watch.seconds();
  stop_if_interrupted();
  tell_check(options, methods_text(checked, options.verbosity), methods_json(checked),
             methods_junit(checked, options.junit_name), methods_markdown(checked));
  return checked.passes() ? 0 : 1;
}

}  // namespace assay::drivers
