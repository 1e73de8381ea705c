// SPDX-License-Identifier: BSD-3-Clause
// drivers -> {adapters, mpm} -> harness, read off the include lines; and within a floor from room to room.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/house/tree.hpp"

namespace assay::test_floors {
namespace {

using namespace assay::house;

const std::map<std::string, std::set<std::string>> may_include{
    {"harness", {"harness"}},
    {"adapters", {"harness", "adapters"}},
    {"mpm", {"harness", "mpm"}},
    {"drivers", {"harness", "adapters", "mpm", "drivers"}},
};

/// The rooms of a floor, the lowest first; "": files in no room. A room includes itself and those below.
const std::map<std::string, std::vector<std::string>> rooms{
    {"harness",
     {"", "numeric", "material", "motion", "history", "sheet", "stability", "control", "exact", "perturbed", "check"}},
    {"mpm",
     {"data", "grid", "basis", "setup", "seeding", "kernels", "step", "mass", "material", "effects", "", "patch"}},
    {"adapters", {"models", "", "foreign", "process", "worker", "abaqus"}},
    {"drivers", {"text",       "system",   "format",   "picture",  "result",       "scene",  "material",      "output",
                 "simulation", "check",    "findings", "explain",  "tabulation",   "path",   "point_drivers", "library",
                 "study",      "mistakes", "judge",    "standard", "command_line", "export", "verbs",         ""}},
};

/// Foreign headers that only one floor may know.
const std::map<std::string, std::string> only_in{
    {"yaml-cpp/", "drivers"},
    {"nlohmann/", "drivers"},
    {"CLI/", "drivers"},
    {"stb/", "drivers"},
    {"fmt/", "drivers"},
    {"muParser", "drivers"},
    {"zlib.h", "drivers"},
    {"hdf5.h", "drivers"},
    {"dlfcn.h", "adapters"},
    {"boost/dll", "adapters"},
    {"filesystem", "not harness"},
    {"fstream", "not harness"},
    {"boost/numeric/odeint", "harness"},
};

std::string floor_of(const std::string& path) { return path.substr(0, path.find('/')); }

std::string room_of(const std::string& path) {
  const std::size_t begin = path.find('/') + 1, end = path.find('/', begin);
  return end == path.npos ? "" : path.substr(begin, end - begin);
}

/// What is wrong with a file of a floor that has rooms and what it includes of that floor; empty where nothing is.
std::string fault_of_rooms(const std::string& path, const std::string& included) {
  const auto floor = rooms.find(floor_of(path));
  if (floor == rooms.end() || floor_of(included) != floor->first) return {};
  const auto rank = [&](const std::string& file) {
    return std::find(floor->second.begin(), floor->second.end(), room_of(file)) - floor->second.begin();
  };
  const auto end = static_cast<std::ptrdiff_t>(floor->second.size());
  if (rank(path) == end) return "'" + room_of(path) + "' is no room of " + floor->first;
  return rank(included) <= rank(path) ? "" : "is in a room above '" + room_of(path) + "'";
}

/// What is wrong with one include of a file on `floor`; empty where nothing is.
std::string fault(const std::string& floor, const Include& include) {
  if (include.quoted) {
    const std::string target = floor_of(include.name);
    if (include.name == "git_description.hpp" || include.name.ends_with(".inc")) return {};  // generated
    if (may_include.count(target) == 0) return "is not written from the root";
    if (may_include.at(floor).count(target) == 0) return floor + " must not include " + target;
    return {};
  }
  for (const auto& [prefix, owner] : only_in) {
    if (include.name.rfind(prefix, 0) != 0) continue;
    const bool allowed = owner == "not harness" ? floor != "harness" : floor == owner;
    if (!allowed) return "belongs to " + owner + " only";
  }
  return {};
}

TEST(Floors, EveryIncludeRespectsThem) {
  int seen = 0;
  for (const auto& [floor, unused] : may_include) {
    for (const std::string& path : files_in(floor, {".hpp", ".cpp", ".h", ".c"}, true)) {
      for (const Include& include : includes_of(text_of(path))) {
        ++seen;
        const std::string what = fault(floor, include) + fault_of_rooms(path, include.quoted ? include.name : "");
        EXPECT_TRUE(what.empty()) << path << ":" << include.line << ": " << include.name << " " << what;
      }
    }
  }
  EXPECT_GT(seen, 50);
}

// The rule itself catches what it is there for.
TEST(Floors, FaultsAreCaught) {
  EXPECT_NE(fault("harness", {1, "mpm/grid.hpp", true}), "");
  EXPECT_NE(fault("harness", {1, "adapters/registry.hpp", true}), "");
  EXPECT_NE(fault("mpm", {1, "adapters/registry.hpp", true}), "");
  EXPECT_NE(fault("adapters", {1, "mpm/grid.hpp", true}), "");
  EXPECT_NE(fault("mpm", {1, "drivers/scene/scene.hpp", true}), "");
  EXPECT_NE(fault("mpm", {1, "grid.hpp", true}), "");
  EXPECT_NE(fault("mpm", {1, "../harness/tensor.hpp", true}), "");
  EXPECT_NE(fault("adapters", {1, "yaml-cpp/yaml.h", false}), "");
  EXPECT_NE(fault("mpm", {1, "zlib.h", false}), "");
  EXPECT_NE(fault("harness", {1, "muParser.h", false}), "");
  EXPECT_NE(fault("drivers", {1, "dlfcn.h", false}), "");
  EXPECT_NE(fault("drivers", {1, "boost/numeric/odeint.hpp", false}), "");
  EXPECT_NE(fault("harness", {1, "fstream", false}), "");
  EXPECT_EQ(fault("drivers", {1, "yaml-cpp/yaml.h", false}), "");
  EXPECT_EQ(fault("drivers", {1, "zlib.h", false}), "");
  EXPECT_EQ(fault("harness", {1, "boost/numeric/odeint.hpp", false}), "");
  EXPECT_EQ(fault("drivers", {1, "mpm/grid.hpp", true}), "");
}

TEST(Rooms, AnIncludeThatPointsUpIsCaught) {
  EXPECT_NE(fault_of_rooms("harness/motion/kinds/vortex.hpp", "harness/sheet/sheet.hpp"), "");
  EXPECT_NE(fault_of_rooms("harness/attic/box.hpp", "harness/numeric/tensor.hpp"), "") << "no such room";
  EXPECT_NE(fault_of_rooms("mpm/effects/images.cpp", "mpm/compose.hpp"), "");
  EXPECT_EQ(fault_of_rooms("harness/sheet/sheet.hpp", "harness/motion/kinds/vortex.hpp"), "");
  EXPECT_EQ(fault_of_rooms("mpm/compose.cpp", "mpm/effects/images.hpp"), "");
  EXPECT_EQ(fault_of_rooms("mpm/effects/images.cpp", "harness/check/judge.hpp"), "") << "another floor";
  EXPECT_EQ(fault_of_rooms("drivers/verbs/run.cpp", "drivers/scene/scene.hpp"), "");
  EXPECT_NE(fault_of_rooms("adapters/process/forked.cpp", "adapters/worker/worker_process.hpp"), "");
  EXPECT_NE(fault_of_rooms("drivers/scene/scene.hpp", "drivers/verbs/run.hpp"), "");
}

TEST(Floors, HeadersOfOursAreLight) {
  for (const auto& [floor, unused] : may_include) {
    for (const std::string& path : files_in(floor, {".hpp"}, true)) {
      for (const Include& include : includes_of(text_of(path))) {
        for (const char* heavy :
             {"yaml-cpp/", "nlohmann/json.hpp", "CLI/", "boost/numeric/odeint", "stb/", "zlib.h", "muParser"}) {
          EXPECT_NE(include.name.rfind(heavy, 0), 0u) << path << ":" << include.line << ": heavy header in a header";
        }
      }
    }
  }
}

}  // namespace
}  // namespace assay::test_floors
