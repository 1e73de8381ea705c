// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/vtu.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "tests/drivers/sample_vortex.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_vtu {
namespace {

struct Sample {
  std::vector<double> positions, velocity, stress, shear;
  std::vector<std::int64_t> id;
  std::string file() const {
    return vtu_text(positions, {{"id", 1, id}, {"velocity", 3, velocity}, {"stress", 9, stress}, {"shear", 1, shear}},
                    0.25);
  }
};

/// For particles `spacing` apart: at 0.02 an array takes several blocks.
Sample sample(double spacing = 0.1) {
  Sample out;
  const ParticleFrame frame = sample_vortex(spacing, 0.25);
  for (std::size_t p = 0; p < frame.x.size(); ++p) {
    out.positions.insert(out.positions.end(), {frame.x[p], frame.y[p], 0});
    out.velocity.insert(out.velocity.end(), {-frame.y[p], frame.x[p], 0});
    for (int c = 0; c < 9; ++c) out.stress.push_back(static_cast<double>(p) + 0.1 * c);
    out.shear.push_back(frame.value[p]);
    out.id.push_back((std::int64_t{1} << 53) + 1 + static_cast<std::int64_t>(p));  // no double
  }
  return out;
}

void expect_every_value(const Sample& in) {
  const VtuFile file(in.file());
  EXPECT_EQ(file.array<double>("Points"), in.positions);
  EXPECT_EQ(file.array<double>("velocity"), in.velocity);
  EXPECT_EQ(file.array<double>("stress"), in.stress);
  EXPECT_EQ(file.array<double>("shear"), in.shear);
  EXPECT_EQ(file.array<std::int64_t>("id"), in.id);
  EXPECT_EQ(file.array<double>("TimeValue"), std::vector<double>{0.25});
  std::vector<std::int64_t> counted(in.id.size());
  std::iota(counted.begin(), counted.end(), 0);
  EXPECT_EQ(file.array<std::int64_t>("connectivity"), counted);
  std::iota(counted.begin(), counted.end(), 1);
  EXPECT_EQ(file.array<std::int64_t>("offsets"), counted);
  EXPECT_EQ(file.array<std::uint8_t>("types"), std::vector<std::uint8_t>(in.id.size(), 1));
}

TEST(Vtu, holds_every_value) {
  const Sample few = sample(), many = sample(0.02);
  ASSERT_GT(few.id.size(), 200u);
  ASSERT_GT(many.stress.size() * sizeof(double), 10 * vtu_block_bytes);
  expect_every_value(few);
  expect_every_value(many);
  EXPECT_EQ(many.file(), many.file());
}

TEST(Vtu, says_what_its_arrays_are) {
  const Sample in = sample();
  const std::string text = in.file(), n = std::to_string(in.id.size());
  for (const std::string& words :
       {"NumberOfPoints=\"" + n + "\" NumberOfCells=\"" + n + "\"",
        std::string("byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"")}) {
    EXPECT_NE(text.find(words), std::string::npos) << words;
  }
  const VtuFile file(text);
  EXPECT_EQ(file.attribute("id", "type"), "Int64");
  EXPECT_EQ(file.attribute("stress", "type"), "Float64");
  EXPECT_EQ(file.attribute("stress", "NumberOfComponents"), "9");
}

TEST(Vtu, no_particles_is_a_file_too) {
  const std::string text = vtu_text({}, {{"id", 1, std::span<const std::int64_t>{}}}, 0);
  EXPECT_NE(text.find("NumberOfPoints=\"0\""), std::string::npos);
  const VtuFile file(text);
  for (const char* name : {"id", "Points", "connectivity", "offsets", "types"}) EXPECT_EQ(file.bytes(name), "") << name;
}

/// The bytes of an array without its header, of `bytes` bytes that do not compress.
std::vector<std::uint64_t> header_of(std::size_t bytes) {
  std::string noise(bytes, '\0'), out;
  std::uint32_t state = 1;
  for (char& c : noise) c = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  append_compressed(out, noise);
  std::vector<std::uint64_t> header(3);
  std::memcpy(header.data(), out.data(), 24);
  header.resize(3 + header[0]);
  std::memcpy(header.data(), out.data(), 8 * header.size());
  const std::size_t blocks = std::accumulate(header.begin() + 3, header.end(), std::size_t{0});
  EXPECT_EQ(out.size(), 8 * header.size() + blocks) << bytes;
  return header;
}

TEST(Vtu, last_block_is_full_or_shorter) {
  using Numbers = std::vector<std::uint64_t>;
  const auto first_three = [](std::size_t bytes) {
    Numbers header = header_of(bytes);
    header.resize(3);
    return header;
  };
  constexpr std::uint64_t block = vtu_block_bytes;
  EXPECT_EQ(header_of(0), (Numbers{0, block, 0}));
  EXPECT_EQ(first_three(1), (Numbers{1, block, 1}));
  EXPECT_EQ(first_three(block - 1), (Numbers{1, block, block - 1}));
  EXPECT_EQ(first_three(block), (Numbers{1, block, 0}));
  EXPECT_EQ(first_three(block + 1), (Numbers{2, block, 1}));
  EXPECT_EQ(first_three(3 * block), (Numbers{3, block, 0}));
}

/// Of each byte of the data, one at a time: what is damaged is found, or no value is another one. (The bits that fill a
/// block's last byte mean nothing, nor does the size of a full block where there is none.)
TEST(Vtu, no_damage_stays_unseen) {
  const std::vector<double> positions{0.5, 1, 0, 1.5, 2, 0}, shear{0.25, -1};
  const std::string whole = vtu_text(positions, {{"shear", 1, shear}}, 0.5);
  const std::size_t begin = whole.find('_', whole.find("<AppendedData")) + 1, end = whole.rfind("\n</AppendedData>");
  std::size_t found = 0;
  for (std::size_t at = begin; at < end; ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    try {
      const VtuFile file(damaged);
      for (const std::string& name : file.names()) {
        EXPECT_EQ(file.bytes(name), VtuFile(whole).bytes(name)) << name << ", byte " << at - begin;
      }
    } catch (const std::runtime_error&) {
      ++found;
    }
  }
  EXPECT_GT(found, (end - begin) * 2 / 3);
  EXPECT_LT(found, end - begin);
}

TEST(Vtu, refuses_lengths_that_do_not_fit) {
  const std::vector<double> positions(6), four(4);
  EXPECT_THROW(vtu_text(four, {}, 0), std::invalid_argument);
  EXPECT_THROW(vtu_text(positions, {{"v", 3, four}}, 0), std::invalid_argument);
  EXPECT_NO_THROW(vtu_text(positions, {{"v", 2, four}}, 0));
}

TEST(Vtu, collection_lists_files_with_exact_times) {
  EXPECT_EQ(particles_name(7), "particles_0007.vtu");
  EXPECT_EQ(particles_name(12345), "particles_12345.vtu");
  const std::string file = pvd_text({{0, particles_name(0)}, {0.1, particles_name(1)}});
  EXPECT_NE(file.find("<DataSet timestep=\"0.1\" group=\"\" part=\"0\" file=\"particles_0001.vtu\"/>"),
            std::string::npos);
  EXPECT_NE(file.find("type=\"Collection\""), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_vtu
