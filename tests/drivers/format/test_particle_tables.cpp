// SPDX-License-Identifier: BSD-3-Clause
// Particles of other codes' files: each format gives the same numbers, and what is damaged is refused in one line.
#include <gtest/gtest.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "drivers/format/npy.hpp"
#include "drivers/format/npz.hpp"
#include "drivers/format/particle_tables.hpp"
#include "drivers/output/html.hpp"
#include "drivers/output/vtu.hpp"
#include "drivers/output/vtu_cells.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_particle_tables {
namespace {

using Values = std::vector<double>;

const Values positions{0.5, 1, 0, -2, 0.25, 0, 1e-3, 3, 0}, velocities{1, 2, 0, 3, 4, 0, 5, 6, 0};

std::string_view bytes_of_numbers(const auto& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]};
}

class ParticleTables : public testing::Test {
 protected:
  std::vector<ParticleTable> tables(const std::string& name, const std::string& text,
                                    const std::vector<std::string>& columns = {}) {
    std::vector<ParticleTable> all;
    read_particle_tables(
        scratch_.write(name, text), [&](ParticleTable&& table) { all.push_back(std::move(table)); }, columns);
    return all;
  }
  ParticleTable table(const std::string& name, const std::string& text, const std::vector<std::string>& columns = {}) {
    auto all = tables(name, text, columns);
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? ParticleTable() : std::move(all[0]);
  }
  static Values array(const ParticleTable& table, const std::string& name, std::size_t components = 1) {
    const ParticleArray* found = table.array(name);
    if (!found) {
      ADD_FAILURE() << "no array " << name;
      return {};
    }
    EXPECT_EQ(found->components, components) << name;
    return found->values;
  }
  std::string refusal(const std::string& name, const std::string& text) {
    try {
      tables(name, text);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  ScratchFolder scratch_;
};

TEST_F(ParticleTables, OfTextsWithAnySeparator) {
  for (const std::string text : {"id,x,y\n1,0.5,1\n2,-2,.25\n", "id;x;y\n1;0.5;1\n2;-2;.25\n",
                                 "id\tx\ty\n1\t0.5\t1\n2\t-2\t.25\n", "id  x y\n 1  0.5 1\n2 -2 .25\n",
                                 "# id x y\n1 5e-1 1\n2 -2 2.5d-1\n", "id,x,y,\r\n1,0.5,1,\r\n2,-2,.25,\r\n"}) {
    const ParticleTable found = table("a.csv", text);
    EXPECT_EQ(found.rows, 2u);
    EXPECT_EQ(array(found, "x"), (Values{0.5, -2})) << text;
    EXPECT_EQ(array(found, "y"), (Values{1, 0.25})) << text;
  }
  const ParticleTable words = table("b.csv", "x,kind,y\n1,steel,nan\n2,clay,-inf\n");
  EXPECT_FALSE(words.array("kind"));
  EXPECT_TRUE(std::isnan(array(words, "y")[0]));
  EXPECT_EQ(array(words, "y")[1], -HUGE_VAL);
  EXPECT_EQ(array(table("c", "1 2\n3 4\n", {"x", "y"}), "y"), (Values{2, 4}));
}

TEST_F(ParticleTables, OfTextsThatAreDamagedAreRefused) {
  EXPECT_TRUE(refusal("a.csv", "").find("holds no line") != std::string::npos);
  EXPECT_TRUE(refusal("a.csv", "1,2\n3,4\n").find(":1:1: no names of columns") != std::string::npos);
  EXPECT_TRUE(refusal("a.csv", "x,y\n1,2\n3\n").find(":3:1: 1 fields, where the header has 2") != std::string::npos);
  EXPECT_TRUE(refusal("a.csv", "x,y\n").find("holds no row") != std::string::npos);
  EXPECT_TRUE(refusal("a", std::string("\0\1\2", 3)).find("is binary") != std::string::npos);
  EXPECT_TRUE(refusal("a.vtk", "# vtk DataFile Version 2.0\n").find("legacy") != std::string::npos);
}

TEST_F(ParticleTables, OfDumps) {
  const std::string frame =
      "ITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id x y\n1 0.5 1\n2 -2 .25\n";
  const auto all = tables(
      "a.dump", "ITEM: TIMESTEP\n0\n" + frame + "ITEM: UNITS\nsi\nITEM: TIME\n0.5\nITEM: TIMESTEP\n10\n" + frame);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_FALSE(all[0].time);
  EXPECT_EQ(all[1].time, 0.5);
  EXPECT_EQ(all[1].step, 10);
  EXPECT_EQ(array(all[1], "x"), (Values{0.5, -2}));
  const std::string whole = "ITEM: TIMESTEP\n0\n" + frame;
  EXPECT_TRUE(refusal("b", whole.substr(0, whole.size() - 10)).find("atom 2 of 2") != std::string::npos);
  EXPECT_TRUE(refusal("b", "ITEM: TIMESTEP\n0\n").find("cut off") != std::string::npos);
  EXPECT_TRUE(refusal("b", "ITEM: TIMESTEP\n0\nITEM: ATOMS x\n").find("before NUMBER OF ATOMS") != std::string::npos);
}

TEST_F(ParticleTables, OfOurOwnSnapshots) {
  const std::vector<std::int64_t> id{4, 5, 6};
  const ParticleTable found = table("a.vtu", vtu_text(positions,
                                                      {{"id", 1, std::span<const std::int64_t>(id)},
                                                       {"velocity", 3, std::span<const double>(velocities)}},
                                                      0.25, 0.2));
  EXPECT_EQ(found.time, 0.25);
  EXPECT_EQ(found.velocity_time, 0.2);
  EXPECT_EQ(array(found, "id"), (Values{4, 5, 6}));
  EXPECT_EQ(array(found, "Points", 3), positions);
  EXPECT_EQ(array(found, "velocity", 3), velocities);
}

/// Cells with a position of their own, whose points are corners.
TEST_F(ParticleTables, OfOurOwnSnapshotsInSpace) {
  std::string text;
  const auto put = [&](std::uint64_t at, std::string_view bytes) {
    if (text.size() < at + bytes.size()) text.resize(at + bytes.size());
    text.replace(at, bytes.size(), bytes);
  };
  const auto made = [](const std::string& name, const Values& values) {
    return MadeArray<double>{name, 3, [&values](std::size_t first, std::size_t count, double* out) {
                               std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(3 * first), 3 * count, out);
                             }};
  };
  const MadeArray<double> corners{
      "", 24, [](std::size_t, std::size_t count, double* out) { std::fill_n(out, 24 * count, 0.5); }};
  for (const char* name : {"position", "middle"}) {
    text.clear();
    write_cells(put, 3, {made(name, positions), made("velocity", velocities)}, corners, 0.25, 0.2);
    const ParticleTable found = table("a.vtu", text);
    EXPECT_EQ(found.time, 0.25);
    EXPECT_EQ(found.velocity_time, 0.2);
    const bool is_of_particles = std::string_view(name) == "position";
    EXPECT_EQ(found.rows, is_of_particles ? 3U : 24U);  // else points of a mesh
    if (!is_of_particles) continue;
    EXPECT_EQ(array(found, "id"), (Values{0, 1, 2}));
    EXPECT_EQ(array(found, "position", 3), positions);
    EXPECT_EQ(array(found, "velocity", 3), velocities);
    EXPECT_EQ(found.array("Points"), nullptr);
  }
}

/// A file of VTK with arrays inline; encoded(values): what stands in an array.
std::string inline_vtu(const std::string& attributes, const std::string& format, const auto& encoded) {
  const std::vector<float> small(velocities.begin(), velocities.end());
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"" + attributes +
         ">\n<UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"0\">\n<PointData>"
         "<DataArray type=\"Float32\" Name=\"velocity\" NumberOfComponents=\"3\" format=\"" +
         format + "\">\n" + encoded(small) +
         "\n</DataArray></PointData>\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"" + format +
         "\">\n" + encoded(positions) + "\n</DataArray></Points></Piece></UnstructuredGrid></VTKFile>\n";
}

std::string number_of_four(std::uint32_t value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

TEST_F(ParticleTables, OfEveryEncodingOfVtk) {
  const auto as_text = [](const auto& values) {
    std::string text;
    for (const auto value : values) text += std::to_string(value) + " ";
    return text;
  };
  const auto as_base64 = [](const auto& values) {
    const std::string bytes(bytes_of_numbers(values));
    return html::base64(number_of_four(static_cast<std::uint32_t>(bytes.size())) + bytes);
  };
  const auto packed = [](const auto& values) {
    const std::string bytes(bytes_of_numbers(values));
    std::string out(compressBound(bytes.size()), '\0');
    uLongf size = out.size();
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    out.resize(size);
    const auto length = static_cast<std::uint32_t>(bytes.size());
    return html::base64(number_of_four(1) + number_of_four(length) + number_of_four(0) +
                        number_of_four(static_cast<std::uint32_t>(size))) +
           html::base64(out);
  };
  const std::string compressed = " header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"";
  for (const std::string& text : {inline_vtu("", "ascii", as_text), inline_vtu("", "binary", as_base64),
                                  inline_vtu(compressed, "binary", packed)}) {
    const ParticleTable found = table("a.vtu", text);
    EXPECT_EQ(found.rows, 3u);
    EXPECT_EQ(array(found, "Points", 3), positions);
    EXPECT_EQ(array(found, "velocity", 3), velocities);
  }
}

TEST_F(ParticleTables, OfCollectionsInTheirOrder) {
  for (const char* name : {"a_1.vtu", "a_2.vtu"}) scratch_.write(name, vtu_text(positions, {}, 7));
  const auto all = tables("a.pvd", pvd_text({{0.5, "a_2.vtu"}, {1, "a_1.vtu"}}));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].file.ends_with("a_2.vtu"));
  EXPECT_TRUE(refusal("b.pvd", pvd_text({{0, "missing.vtu"}})).find("missing.vtu") != std::string::npos);
}

TEST_F(ParticleTables, OfVtkThatIsDamagedAreRefused) {
  const std::string whole = vtu_text(positions, {{"velocity", 3, std::span<const double>(velocities)}}, 0.25);
  for (std::size_t size = 40; size + 30 < whole.size(); size += 7) {
    const std::string said = refusal("a.vtu", whole.substr(0, size));
    EXPECT_NE(said, "") << size;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0);
  }
  EXPECT_NE(refusal("a.vtu", "<VTKFile type=\"ImageData\"></VTKFile>").find("ImageData"), std::string::npos);
  EXPECT_NE(
      refusal("a.vtu", "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZ4DataCompressor\"></VTKFile>").find("LZ4"),
      std::string::npos);
}

std::string npy(const Values& values, const std::vector<std::uint64_t>& shape) {
  return npy_header(shape) + std::string(bytes_of_numbers(values));
}

struct Member {
  std::string name;
  Values values;
  std::vector<std::uint64_t> shape;
};

std::string npz(const std::vector<Member>& members) {
  std::vector<NpzArray> arrays;
  for (const Member& each : members) arrays.push_back({each.name, each.shape, each.values});
  return npz_bytes(arrays);
}

TEST_F(ParticleTables, OfArraysOfNumPy) {
  const ParticleTable one =
      table("a.npz", npz({{"t", {0.5}, {}}, {"x", {1, 2, 3, 4}, {2, 2}}, {"F", Values(18, 1.5), {2, 3, 3}}}));
  EXPECT_EQ(one.time, 0.5);
  EXPECT_EQ(one.rows, 2u);
  EXPECT_EQ(array(one, "x", 2), (Values{1, 2, 3, 4}));
  EXPECT_EQ(array(one, "F", 9).size(), 18u);
  // two times of ten particles
  Values x(40);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<double>(k);
  const auto two = tables("b.npz", npz({{"t", {0, 1}, {2}}, {"id", Values(10, 3), {10}}, {"x", x, {2, 10, 2}}}));
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[1].time, 1);
  EXPECT_EQ(array(two[1], "x", 2)[0], 20);
  EXPECT_EQ(array(two[1], "id"), Values(10, 3));
  // three times of two particles, which are fewer than a tensor has components
  Values few(12);
  for (std::size_t k = 0; k < few.size(); ++k) few[k] = static_cast<double>(k);
  const auto three = tables("d.npz", npz({{"t", {0, 1, 2}, {3}}, {"id", {7, 8}, {2}}, {"x", few, {3, 2, 2}}}));
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(array(three[2], "x", 2), (Values{8, 9, 10, 11}));
  // the first index is the fastest
  std::string by_columns = npy({1, 2, 3, 4, 5, 6}, {3, 2});
  by_columns.replace(by_columns.find("False"), 5, "True ");
  EXPECT_EQ(array(table("e.npy", by_columns), "x", 2), (Values{1, 4, 2, 5, 3, 6}));
  EXPECT_NE(refusal("c.npz", npz({{"x", {1, 2}, {2}}, {"y", {1, 2, 3}, {3}}})).find("3 rows"), std::string::npos);
}

/// Foreign files are not trusted: whatever they hold, they are read or refused in one line.
TEST_F(ParticleTables, OfDamagedBytesAreReadOrRefused) {
  const std::string dump =
      "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ss ss ss\n-2 2\n-2 2\n-2 2\n"
      "ITEM: ATOMS id x y z\n1 0.5 0.25 0\n2 1.5 1.25 0\n";
  const std::vector<std::pair<std::string, std::string>> wholes{
      {"a.csv", "t,id,x,y\n0,1,0.5,0.25\n0,2,1.5,1.25\n1,1,0.5,0.25\n1,2,nan,1.25\n"},
      {"dump.10", dump},
      {"a.vtu", vtu_text(positions, {{"velocity", 3, std::span<const double>(velocities)}}, 0.25)},
      {"a.npz", npz({{"t", {0.5}, {}}, {"x", {1, 2, 3, 4}, {2, 2}}})},
      {"x.npy", npy({1, 2, 3, 4}, {2, 2})}};
  constexpr int tries = 400;
  std::mt19937 random(7);
  for (const auto& [name, whole] : wholes) {
    int refused = 0;
    for (int k = 0; k < tries; ++k) {
      std::string damaged = whole;
      for (unsigned n = 1 + random() % 4; n > 0; --n) damaged[random() % damaged.size()] = static_cast<char>(random());
      if (k % 5 == 0) damaged.resize(random() % damaged.size());
      const std::string said = refusal(name, damaged);
      refused += !said.empty();
      EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
    }
    EXPECT_GT(refused, tries / 20) << name;
  }
}

TEST_F(ParticleTables, OfCollectionsThatNameThemselvesAreRefused) {
  EXPECT_NE(refusal("a.pvd", pvd_text({{0, "a.pvd"}})).find("name one another"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_particle_tables
