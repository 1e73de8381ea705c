// SPDX-License-Identifier: BSD-3-Clause
// Libraries whose bytes are damaged at random, through the program: one line and status 2, or success; nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/some_of.hpp"

namespace assay::drivers::test_damaged_libraries {
namespace {

namespace fs = std::filesystem;

struct Library {
  std::string name, file, keys;
};

void PrintTo(const Library& library, std::ostream* out) { *out << library.name; }

/// Cut, or with bytes changed: many of them where the headers are.
std::string damaged(std::string bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return random() % n; };
  constexpr std::size_t identity = 64, headers = 1024;
  if (below(5) == 0) return bytes.substr(0, below(bytes.size()));
  constexpr std::size_t counts[] = {1, 3, 10, 100};
  for (std::size_t k = counts[below(4)]; k > 0; --k) {
    const std::size_t place = below(10);
    const std::size_t at = place < 2 ? below(identity) : place < 6 ? below(headers) : below(bytes.size());
    bytes[at] = static_cast<char>(below(256));
  }
  return bytes;
}

class DamagedLibrary : public testing::TestWithParam<Library> {
 protected:
  void SetUp() override {
    if (!fs::exists(GetParam().file)) GTEST_SKIP() << "no Fortran compiler";
    fs::create_directories(temporary_);
  }

  Ending assay_here(const std::vector<std::string>& words) {
    fs::remove_all(scratch_ / "data");
    return assay(words, [this] {
      setenv("TMPDIR", temporary_.c_str(), 1);
      setenv("ASSAY_DATA_HOME", (scratch_ / "data").c_str(), 1);
    });
  }

  void expect_decent(const Ending& ending, const std::string& what) {
    const auto lines = std::count(ending.said.begin(), ending.said.end(), '\n');
    EXPECT_TRUE(ending.status == 0 || ending.status == 2)
        << what << ": status " << ending.status << ": " << ending.said;
    if (ending.status == 2) {
      EXPECT_EQ(lines, 1) << what << ": " << ending.said;
      EXPECT_FALSE(fs::exists(scratch_ / "data/materials/x.yaml")) << what;
    }
    EXPECT_TRUE(fs::is_empty(temporary_)) << what << " has left something";
  }

  const ScratchFolder scratch_;
  const std::string temporary_ = scratch_ / "tmp";
};

TEST_P(DamagedLibrary, IsRefusedInOneLineOrServes) {
  constexpr int samples = 10;  // seconds; thousands were run by hand
  const std::string whole = bytes_of(GetParam().file);
  const std::string file =
      scratch_.write("model.yaml", std::string("library: lib.so\ntime_limit: 2\n") + GetParam().keys);
  std::mt19937 random(3);
  for (int sample = 0; sample < samples; ++sample) {
    scratch_.write("lib.so", damaged(whole, random));
    const std::string what = std::to_string(sample);
    expect_decent(assay_here({"materials", file}), "materials " + what);
    expect_decent(assay_here({"register", file, "--as", "x"}), "register " + what);
  }
}

TEST_P(DamagedLibrary, UndamagedServes) {
  const std::string file =
      scratch_.write("model.yaml", std::string("library: ") + GetParam().file + "\n" + GetParam().keys);
  const Ending ending = assay_here({"materials", file});
  EXPECT_EQ(ending.status, 0) << ending.said;
  expect_decent(ending, "materials");
}

const auto cases_of_damaged_library = one_of_each<DamagedLibrary::ParamType>(
    4, testing::Values(Library{"native", built("materials/libneo_hookean.so"), ""},
                       Library{"umat", built("tests/foreign/umat_j2.so"),
                               "interface: umat\nproperties: [1e3, 0.3, 10, 20, 50]\n"
                               "state: {back_stress: symmetric_tensor, p: scalar}\n"},
                       Library{"mfront", built("tests/foreign/mfront_norton.so"),
                               "interface: mfront\nproperties: {YoungModulus: 1e3, PoissonRatio: 0.3}\n"}));
const auto name_of_damaged_library = [](const auto& instance) { return std::string(instance.param.name); };
INSTANTIATE_TEST_SUITE_P(Interfaces, DamagedLibrary, testing::ValuesIn(cases_of_damaged_library.some),
                         name_of_damaged_library);
INSTANTIATE_TEST_SUITE_P(LongInterfaces, DamagedLibrary, testing::ValuesIn(cases_of_damaged_library.others),
                         name_of_damaged_library);

/// What no random damage hits every time.
TEST(DamagedLibraries, ANativeOneThatEndsTheProcessIsRefused) {
  const std::string plugins = built("tests/plugins/");
  for (const auto& [name, words] :
       {std::pair{"entry_crashes", "was ended by signal 6 (Aborted) when it was loaded"},
        std::pair{"entry_exits", "without a result when it was loaded; its last output: no licence"}}) {
    const std::string file = plugins + name + ".so";
    for (const char* verb : {"materials", "register"}) {
      const Ending ending = assay({verb, file});
      EXPECT_EQ(ending.status, 2) << verb;
      EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
      EXPECT_NE(ending.said.find(words), std::string::npos) << ending.said;
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_damaged_libraries
