// SPDX-License-Identifier: BSD-3-Clause
// Whatever the bytes: the reader returns a scene or throws InputError with one line, and the resolved form of a scene
// reads back to itself. A scene that can be run is composed, or refused in one line, or its material fails. Anything
// else is a fault. What follows a record separator (0x1e) is a --set argument.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/material/material_failure.hpp"
#include "tests/fuzz/composition.hpp"

namespace {

using namespace assay::drivers;

[[noreturn]] void fault(const char* what, const std::string& text) {
  std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
  std::abort();
}

void check_resolved(const Scene& scene) {
  const std::string once = resolved_yaml(scene);
  try {
    const std::string twice = resolved_yaml(scene_from_text(once, scene.file));
    if (once != twice) fault("resolved.yaml changes when it is resolved again", once + "----\n" + twice);
  } catch (const InputError& error) {
    fault(error.what(), once);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = all.find('\x1e');
  std::vector<std::string> settings;
  if (cut != all.npos) settings.emplace_back(all.substr(cut + 1));
  const std::string text(all.substr(0, cut));
  try {
    const Scene scene = scene_from_text(text, "scene.yaml", settings);
    check_resolved(scene);
    assay::fuzz::compose_scene(scene);
  } catch (const InputError& error) {
    const std::string line = error.what();
    if (line.empty() || line.find('\n') != line.npos) fault("not one line", line);
  } catch (const assay::MaterialFailure& failure) {
    if (std::string(failure.what()).empty()) fault("a material fails without a word", text);
  } catch (const std::exception& error) {
    fault(error.what(), text);
  }
  return 0;
}
