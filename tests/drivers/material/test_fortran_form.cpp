// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/material_path.hpp"
#include "tests/drivers/material/fortran_texts.hpp"

namespace assay::drivers::test_fortran_form {
namespace {

struct Case {
  std::string file, text;
  FortranForm form;
  std::string why;
};

TEST(FortranForm, IsThatOfTheNameUnlessTheTextCannotBe) {
  constexpr auto fixed = FortranForm::fixed, free = FortranForm::free;
  const std::string bare = "      X = 1\n      END\n";  // either
  const Case cases[] = {
      {"m.f", hooke_umat, fixed, ""},
      {"m.for", hooke_umat, fixed, ""},
      {"m.FOR", hooke_umat, fixed, ""},
      {"m.F", bare, fixed, ""},
      {"m.f90", free_hooke_umat, free, ""},
      {"m.F90", bare, free, ""},
      {"m.f95", free_hooke_umat, free, ""},
      {"m.f08", bare, free, ""},
      {"m.f18", bare, free, ""},
      {"m.F77", bare, fixed, ""},
      {"m.f", free_hooke_umat, free, "by its text, as in line 1"},
      {"m.for", free_hooke_umat, free, "by its text, as in line 1"},
      {"m.f90", hooke_umat, fixed, "by its text, as in line 2"},
      {"m.f90", "      x = a +\n     1 b\n", fixed, "by its text, as in line 2"},
      {"m.f90", "      x = a + &\n     1\n", free, ""},
      {"m.f90", "!DIR$ NOFREEFORM\n" + bare, fixed, "by its directive in line 1"},
      {"m.for", "!DEC$ FREEFORM\n" + bare, free, "by its directive in line 1"},
      {"m.for", "!\ncDEC$ FREEFORM\n" + bare, free, "by its directive in line 2"},
      {"m.for", "C\n!DEC$ FREEFORM\n" + bare, free, "that changes by directives, as in line 2"},
      {"m.for", bare + "!DEC$ FREEFORM\n" + bare, free, "that changes by directives, as in line 3"},
      {"m.for", "!DIR$ FIXEDFORMLINESIZE:132\n" + bare, fixed, ""},
      {"m.for", "!DIR$ ATTRIBUTES ALIGN : 64 :: X\n" + bare, fixed, ""},
      {"m.f", "C     a comment\n" + bare, fixed, ""},
      {"m.f", "      a = 1 &\n     & + 2\n", fixed, ""},
      {"m.f", "      a = 1 &\n        + 2\n", free, "by its text, as in line 2"},
      {"m.f90", "C     a comment\n" + bare, fixed, "by its text, as in line 1"},
      {"m.f90", "c = 1\ncall a\n*1\n", fixed, "by its text, as in line 3"},
      {"m.f90", "c = 1 &\n*2\nend\n", free, ""},
      {"m.f90", "     x = 1\n     & + 2\n", fixed, "by its text, as in line 2"},
      {"m.f90", "     x = 1 &\n     & + 2\n", free, ""},
      {"m.f90", "     10 continue\n     a = 1\n", free, ""},
  };
  for (const Case& each : cases) {
    const FoundForm found = form_of_source(each.file, lines_of_source(each.text));
    EXPECT_EQ(found.form, each.form) << each.file << "\n" << each.text;
    EXPECT_EQ(found.why, each.why) << each.file << "\n" << each.text;
  }
}

TEST(FortranForm, NamesOfSources) {
  for (const char* name : {"a.f", "a.F", "a.for", "a.FOR", "b/c.f90", "a.F90", "a.f95", "a.ftn", "ü b.f", "a.b.For",
                           "a.f77", "a.F77", "a.f18"}) {
    EXPECT_TRUE(is_fortran_source(name)) << name;
  }
  for (const char* name : {"a.so", "f", ".f", "a.f/b", "a.inp", "a.fo", "a.f90x", "a.c", ""}) {
    EXPECT_FALSE(is_fortran_source(name)) << name;
  }
}

}  // namespace
}  // namespace assay::drivers::test_fortran_form
