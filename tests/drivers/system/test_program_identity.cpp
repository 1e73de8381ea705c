// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/program_identity.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cctype>
#include <cstdio>
#include <string>

namespace assay::drivers::test_program_identity {
namespace {

/// As binutils read it.
std::string build_id_of(const std::string& file) {
  std::FILE* pipe = ::popen(("readelf -n " + file + " 2>/dev/null | grep 'Build ID:'").c_str(), "r");
  if (!pipe) return {};
  char line_of_readelf[200] = "";
  const bool found = std::fgets(line_of_readelf, sizeof line_of_readelf, pipe) != nullptr;
  ::pclose(pipe);
  const std::string line = found ? line_of_readelf : "";
  const std::size_t at = line.find(": ");
  std::string id = at == line.npos ? "" : line.substr(at + 2);
  while (!id.empty() && std::isspace(static_cast<unsigned char>(id.back()))) id.pop_back();
  return id;
}

TEST(ProgramIdentity, IsWhatTheLinkerWrote) {
  const std::string expected = build_id_of("/proc/" + std::to_string(::getpid()) + "/exe");
  if (expected.empty()) GTEST_SKIP() << "readelf is not there";
  EXPECT_EQ(program_identity(), expected);
  EXPECT_EQ(expected.size(), 40u);
}

TEST(ProgramIdentity, OfWhatIsLoadedIsAnother) {
  EXPECT_EQ(loaded_identity().size(), 64u);
  EXPECT_NE(loaded_identity(), program_identity());
  EXPECT_EQ(loaded_identity(), loaded_identity());
}

}  // namespace
}  // namespace assay::drivers::test_program_identity
