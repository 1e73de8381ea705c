// SPDX-License-Identifier: BSD-3-Clause
// The files of `eval`: CSV, NumPy's arrays and VTK's vertices hold the same numbers, and arrays may hold the points.
#include <gtest/gtest.h>

#include <cstring>

#include "drivers/format/csv.hpp"
#include "drivers/format/npy.hpp"
#include "drivers/format/zip.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/python.hpp"
#include "tests/support/tree_folder.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_eval_formats {
namespace {

const std::string& python_with_numpy() {
  static const std::string found = python_with("numpy");
  return found;
}

std::vector<double> doubles(std::string_view bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

class EvalFormats : public testing::Test {
 protected:
  EvalFormats() {
    std::string points = "X,Y,t\n";
    for (int k = 0; k < rows; ++k) {
      points += std::to_string(0.8 + 0.01 * (k % 40)) + "," + std::to_string(0.001 * k) + "," +
                (k % 3 == 0   ? "0.5"
                 : k % 3 == 1 ? "0.25"
                              : "0.75") +
                "\n";
    }
    options_.scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
    options_.points = scratch_.write("points.csv", points);
    options_.verbosity = Verbosity::quiet;
    options_.out = scratch_ / "exact.csv";
    EXPECT_EQ(eval(options_), 0);
    std::vector<std::string> names;
    const std::string text = bytes_of(options_.out);
    CsvLines lines(text, options_.out);
    const auto header = lines.next();
    for (const CsvField& field : header.value()) names.push_back(field.text);
    table_ = read_csv(text, options_.out, names);
  }

  std::string written(const std::string& name, const std::string& columns = {}) {
    options_.out = scratch_ / name;
    options_.columns = columns;
    EXPECT_EQ(eval(options_), 0);
    return bytes_of(options_.out);
  }
  double at(const std::string& name, std::size_t row) const { return (*table_.column(name))[row]; }

  /// The numbers of an array of an archive.
  std::vector<double> array(const std::string& file, const std::string& name, std::vector<std::uint64_t> shape) {
    const InputBytes input(file);
    const ZipReader archive(input);
    for (std::size_t k = 0; k < archive.members().size(); ++k) {
      if (archive.members()[k].name != name + ".npy") continue;
      std::string bytes(archive.members()[k].size, '\0');
      EXPECT_EQ(archive.read(k, 0, bytes.data(), bytes.size()), bytes.size());
      const NpyHeader header = read_npy_header(bytes, {file});
      EXPECT_EQ(header.shape, shape) << name;
      return doubles(std::string_view(bytes).substr(header.size));
    }
    ADD_FAILURE() << "no array " << name;
    return std::vector<double>(rows * 9);
  }

  static constexpr int rows = 5000;  // more than a block
  ScratchFolder scratch_;
  EvalOptions options_;
  CsvTable table_;
};
using LongEvalFormats = EvalFormats;

TEST_F(EvalFormats, NpyHasTheColumnsAsFields) {
  const std::string text = written("exact.npy");
  const NpyHeader header = read_npy_header(text, {});
  EXPECT_EQ(header.shape, std::vector<std::uint64_t>{rows});
  ASSERT_EQ(header.fields.size(), table_.names.size());
  const std::vector<double> values = doubles(std::string_view(text).substr(header.size));
  ASSERT_EQ(values.size(), rows * table_.names.size());
  for (std::size_t c = 0; c < table_.names.size(); ++c) {
    EXPECT_EQ(header.fields[c].name, table_.names[c]);
    for (std::size_t i = 0; i < rows; ++i) ASSERT_EQ(values[i * table_.names.size() + c], table_.columns[c][i]);
  }
}

TEST_F(EvalFormats, NpzHasOneArrayAField) {
  written("exact.npz");
  const auto x = array(options_.out, "x", {rows, 2}), F = array(options_.out, "F", {rows, 3, 3});
  const auto sigma = array(options_.out, "sigma", {rows, 6}), t = array(options_.out, "t", {rows});
  const auto b = array(options_.out, "b", {rows, 2}), X = array(options_.out, "X", {rows, 2});
  for (std::size_t i = 0; i < rows; ++i) {
    ASSERT_EQ(X[2 * i], at("X", i));
    ASSERT_EQ(x[2 * i + 1], at("y", i));
    ASSERT_EQ(t[i], at("t", i));
    ASSERT_EQ(F[9 * i + 3], at("F21", i));
    ASSERT_EQ(F[9 * i + 8], at("F33", i));
    ASSERT_EQ(F[9 * i + 2], 0);
    ASSERT_EQ(sigma[6 * i + 2], at("s33", i));
    ASSERT_EQ(sigma[6 * i + 3], at("s12", i));
    ASSERT_EQ(b[2 * i], at("bx", i));
  }
  written("some.npz", "bx,v");
  EXPECT_EQ(array(options_.out, "bx", {rows})[7], at("bx", 7));
  EXPECT_EQ(array(options_.out, "v", {rows, 2})[15], at("vy", 7));
}

TEST_F(EvalFormats, VtuHasAFileATime) {
  written("exact.vtu");
  EXPECT_FALSE(std::filesystem::exists(options_.out));
  const std::string list = bytes_of(scratch_ / "exact.pvd");
  std::size_t found = 0;
  for (const auto& [t, file] : {std::pair{0.25, "exact_0000.vtu"}, {0.5, "exact_0001.vtu"}, {0.75, "exact_0002.vtu"}}) {
    EXPECT_NE(list.find(std::string("file=\"") + file + "\""), std::string::npos) << list;
    const VtuFile vtu(bytes_of(scratch_ / file));
    EXPECT_EQ(vtu.array<double>("TimeValue"), std::vector<double>{t});
    const auto x = vtu.array<double>("Points"), sigma = vtu.array<double>("sigma"), b = vtu.array<double>("b");
    const auto offsets = vtu.array<std::int64_t>("offsets"), first = vtu.array<std::int64_t>("connectivity");
    EXPECT_EQ(vtu.bytes("types"), std::string(x.size() / 3, '\1'));
    std::size_t p = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      if (at("t", i) != t) continue;
      ASSERT_EQ(x[3 * p], at("x", i));
      ASSERT_EQ(x[3 * p + 2], 0);
      ASSERT_EQ(sigma[9 * p + 1], at("s12", i));
      ASSERT_EQ(sigma[9 * p + 3], at("s12", i));
      ASSERT_EQ(sigma[9 * p + 8], at("s33", i));
      ASSERT_EQ(b[3 * p + 1], at("by", i));
      ASSERT_EQ(first[p], static_cast<std::int64_t>(p));
      ASSERT_EQ(offsets[p], static_cast<std::int64_t>(p + 1));
      ++p;
    }
    EXPECT_EQ(3 * p, x.size());
    found += p;
  }
  EXPECT_EQ(found, static_cast<std::size_t>(rows));
}

TEST_F(EvalFormats, VtuOfOneTimeIsOneFile) {
  options_.points = scratch_.write("one.csv", "X,Y,t\n0.9,0.1,0.5\n0.8,0.3,0.5\n");
  const VtuFile vtu(written("one.vtu", "s12,b"));
  EXPECT_EQ(vtu.names(),
            (std::vector<std::string>{"TimeValue", "s12", "b", "Points", "connectivity", "offsets", "types"}));
  EXPECT_EQ(vtu.array<double>("Points").size(), 6u);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "one.pvd"));
}

/// What was written as arrays may be asked again, and so may arrays of coordinates.
TEST_F(EvalFormats, PointsMayBeArrays) {
  const std::string expected = written("again.csv");
  for (const auto& [name, columns] : {std::pair{"p.npy", "t,X,Y"}, {"p.npz", "X,Y,t"}, {"q.npz", "reference,t"}}) {
    EvalOptions options = options_;
    options.out = scratch_ / name;
    options.columns = columns;
    ASSERT_EQ(eval(options), 0);
    options.points = options.out;
    options.columns = "";
    options.out = scratch_ / "from_arrays.csv";
    ASSERT_EQ(eval(options), 0);
    EXPECT_TRUE(bytes_of(options.out) == expected) << name;
  }
}

TEST_F(LongEvalFormats, NumPyReadsAndWritesThem) {
  if (python_with_numpy().empty()) GTEST_SKIP() << "NumPy is not installed (python3-numpy)";
  written("exact.npy");
  written("exact.npz");
  const std::string program = scratch_.write("check.py", R"py(
import numpy, os, sys
os.chdir(sys.argv[1])
rows = numpy.genfromtxt('exact.csv', delimiter=',', names=True)
array, fields = numpy.load('exact.npy'), numpy.load('exact.npz')
for name in rows.dtype.names:
    assert (array[name] == rows[name]).all(), name
assert (fields['b'][:, 1] == rows['by']).all() and (fields['F'][:, 1, 0] == rows['F21']).all()
assert (fields['sigma'] == numpy.stack([rows[c] if c in rows.dtype.names else 0 * rows['t']
        for c in ('s11', 's22', 's33', 's12', 's13', 's23')], axis=1)).all()
X, t = fields['X'], fields['t']
numpy.savez('stored.npz', X=X, t=t)
numpy.savez_compressed('deflated.npz', X=numpy.asfortranarray(X), t=t)
numpy.save('coordinates.npy', X[:3])
)py");
  ASSERT_EQ(std::system((python_with_numpy() + " '" + program + "' '" + scratch_ / "" + "'").c_str()), 0);
  const std::string expected = bytes_of(scratch_ / "exact.csv");
  for (const char* name : {"stored.npz", "deflated.npz"}) {
    options_.points = scratch_ / name;
    EXPECT_TRUE(written("read.csv") == expected) << name;
  }
  options_.points = scratch_ / "coordinates.npy";
  options_.times = "0.5,1";
  const std::string text = written("times.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
}

TEST_F(EvalFormats, AnUnknownFormatIsRefused) {
  options_.format = "vtk";
  EXPECT_THROW(eval(options_), InputError);
  options_.format = "npz";
  options_.out = scratch_ / "a.csv";
  EXPECT_EQ(eval(options_), 0);
  EXPECT_TRUE(is_zip(bytes_of(options_.out)));
}

}  // namespace
}  // namespace assay::drivers::test_eval_formats
