// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/output_bytes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_output_bytes {
namespace {

using Order = OutputBytes::Order;

std::size_t files_in(const ScratchFolder& scratch) {
  const auto all = std::filesystem::directory_iterator(scratch / "");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

TEST(OutputBytes, AppearWholeOrNotAtAll) {
  const ScratchFolder scratch;
  const std::string name = scratch.write("a", "before");
  {
    OutputBytes out(name);
    out.append("one ");
    EXPECT_EQ(files_in(scratch), 2u);
  }
  EXPECT_EQ(bytes_of(name), "before");
  EXPECT_EQ(files_in(scratch), 1u);
  OutputBytes out(name);
  out.append("one ");
  out.append("two");
  EXPECT_EQ(bytes_of(name), "before");
  out.commit();
  EXPECT_EQ(bytes_of(name), "one two");
  EXPECT_EQ(files_in(scratch), 1u);
}

TEST(OutputBytes, TakePiecesAtAnyPlace) {
  const ScratchFolder scratch;
  OutputBytes out(scratch / "a", Order::any);
  out.write_at(3, "def");
  out.write_at(0, "abc");
  out.commit();
  EXPECT_EQ(bytes_of(scratch / "a"), "abcdef");
}

TEST(OutputBytes, MayBeEmpty) {
  const ScratchFolder scratch;
  OutputBytes(scratch / "a").commit();
  EXPECT_EQ(bytes_of(scratch / "a"), "");
  EXPECT_EQ(files_in(scratch), 1u);
}

TEST(OutputBytes, GoIntoAPipeThatStaysOpen) {
  for (const Order order : {Order::given, Order::any}) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    std::string found;
    std::thread reader([&] {
      char bytes[16];
      for (ssize_t n; (n = ::read(ends[0], bytes, sizeof bytes)) > 0;) found.append(bytes, static_cast<std::size_t>(n));
    });
    {
      OutputBytes out("/dev/fd/" + std::to_string(ends[1]), order);
      if (order == Order::any) {
        out.write_at(3, "def");
        out.write_at(0, "abc");
      } else {
        out.append("abc");
        out.append("def");
      }
      out.commit();
    }
    ::close(ends[1]);
    reader.join();
    ::close(ends[0]);
    EXPECT_EQ(found, "abcdef");
  }
}

TEST(OutputBytes, SayWhatFails) {
  const ScratchFolder scratch;
  OutputBytes out(scratch / "missing/a");
  EXPECT_THROW(out.append("x"), SystemError);
  if (::access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full";
  OutputBytes full("/dev/full");
  EXPECT_THROW(full.append("x"), SystemError);
}

}  // namespace
}  // namespace assay::drivers::test_output_bytes
