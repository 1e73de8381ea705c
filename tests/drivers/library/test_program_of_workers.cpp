// SPDX-License-Identifier: BSD-3-Clause
// Which program the workers of the library are, and which one is refused: each test has a library beside which there is
// none.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "drivers/library/assay.h"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::library_test::test_program_of_workers {
namespace {

namespace fs = std::filesystem;
using drivers::ScratchFolder;

class ProgramOfWorkers : public testing::Test {
 protected:
  void SetUp() override { ::setenv("ASSAY_MATERIAL_PATH", built("tests/foreign").c_str(), 1); }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    ::unsetenv("ASSAY_PROGRAM");
  }

 private:
  const std::string path_ = std::getenv("PATH");
};

/// A copy of the library in a folder of its own.
class Copied {
 public:
  Copied() {
    Dl_info known{};
    ::dladdr(reinterpret_cast<const void*>(&assay_version), &known);
    fs::copy_file(fs::canonical(known.dli_fname), scratch / "libassay.so.1");
    handle_ = ::dlopen((scratch / "libassay.so.1").c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  int code_of_foreign(std::string& words, const std::string& material = "mfront_neo_hookean.yaml") const {
    assay_options options = ASSAY_OPTIONS_INIT;
    const std::string text = "motion: {type: vortex}\nmaterial: {adapter: '" + tree_folder() +
                             "/tests/adapters/foreign/" + material + "', density: 1000}\n";
    options.text = text.c_str();
    assay_error error = ASSAY_ERROR_INIT;
    assay_problem* problem = nullptr;
    const auto open = reinterpret_cast<decltype(&assay_open)>(::dlsym(handle_, "assay_open"));
    const int code = open(&options, &problem, &error);
    words = error.message;
    reinterpret_cast<decltype(&assay_close)>(::dlsym(handle_, "assay_close"))(problem);
    return code;
  }
  const ScratchFolder scratch;

 private:
  void* handle_ = nullptr;
};

/// A program of the shell, beside the library.
void put_program(const Copied& copied, const std::string& lines) {
  fs::permissions(copied.scratch.write("assay", "#!/bin/sh\n" + lines), fs::perms::owner_all);
}

TEST_F(ProgramOfWorkers, IsNeeded) {
  const Copied copied;
  ::setenv("PATH", "/nowhere", 1);
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_SYSTEM);
  EXPECT_NE(words.find("$ASSAY_PROGRAM"), words.npos) << words;
}

TEST_F(ProgramOfWorkers, IsThatOfTheVariableBeforeThatBesideTheLibrary) {
  const Copied copied;
  put_program(copied, "exit 2\n");
  ::setenv("ASSAY_PROGRAM", built("assay").c_str(), 1);
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_DONE) << words;
}

TEST_F(ProgramOfWorkers, OfAnotherBuildIsRefused) {
  const Copied copied;
  put_program(copied,
              "printf '0.1.0 older' | dd of=/proc/self/fd/3 bs=1 seek=$((268435456 - 4096)) conv=notrunc 2>/dev/null\n"
              "exit 2\n");
  std::string words;
  EXPECT_EQ(copied.code_of_foreign(words), ASSAY_SYSTEM) << words;
  EXPECT_NE(words.find("is assay 0.1.0 older, and the library is "), words.npos) << words;
}

/// It is named, with who has named it, whether a model or a compiler was to run in it, and nobody hears what it prints.
TEST_F(ProgramOfWorkers, ThatIsNoneOfAssaysIsRefused) {
  const ScratchFolder cache;
  ::setenv("ASSAY_CACHE_HOME", (cache / "").c_str(), 1);
  for (const std::string material : {"mfront_neo_hookean.yaml", "../../downstream/hooke_umat.f"}) {
    const Copied copied;
    put_program(copied, "echo said; echo wailed >&2; exit 1\n");
    const std::string program = copied.scratch / "assay";
    ::setenv("ASSAY_PROGRAM", program.c_str(), 1);
    std::string words;
    testing::internal::CaptureStdout(), testing::internal::CaptureStderr();
    EXPECT_EQ(copied.code_of_foreign(words, material), ASSAY_SYSTEM) << words;
    EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(words.find("'" + program + "', which ASSAY_PROGRAM names, ended before it could serve"), words.npos)
        << words;
    EXPECT_EQ(words.find("is no gfortran"), words.npos) << words;
  }
}

}  // namespace
}  // namespace assay::library_test::test_program_of_workers
