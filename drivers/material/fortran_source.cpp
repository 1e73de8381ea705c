// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_source.hpp"

#include <algorithm>
#include <filesystem>

#include "drivers/material/source_entry.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_source = std::size_t{32} << 20;

/// Its last part, in small letters.
std::string small_name(const std::string& file) { return small_letters(fs::path(file).filename().string()); }

/// In the source's folder, where the name may have letters of the other size; empty: not there.
std::string file_beside(const fs::path& folder, const std::string& name) {
  std::error_code code;
  if (fs::is_regular_file(folder / name, code)) return (folder / name).string();
  if (name.find('/') != name.npos) return {};
  std::vector<std::string> alike;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    std::error_code unknown_kind;
    const std::string other = at->path().filename().string();
    if (small_name(other) == small_name(name) && at->is_regular_file(unknown_kind)) alike.push_back(other);
  }
  std::sort(alike.begin(), alike.end());
  return alike.empty() ? "" : (folder / alike.front()).string();
}

std::string text_of_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Of each line. by_name: that of the source, where directives change it on the way.
std::vector<FortranForm> forms_in(const std::vector<std::string>& lines, const FoundForm& form, FortranForm by_name) {
  return form.mixed ? forms_of_lines(lines, by_name) : std::vector<FortranForm>(lines.size(), form.form);
}

/// Lines as gfortran reads them.
std::vector<std::string> lines_for_compiler(const std::vector<std::string>& lines, const FoundForm& form,
                                            FortranForm by_name) {
  const std::vector<FortranForm> forms = forms_in(lines, form, by_name);
  std::vector<std::string> adapted = adapted_lines(lines, forms);
  return form.mixed ? in_free_form(adapted, forms) : adapted;
}

/// Of the part in fixed form.
ColumnReadings columns_of(const std::vector<std::string>& lines, const FoundForm& form, FortranForm by_name) {
  const std::vector<FortranForm> forms = forms_in(lines, form, by_name);
  std::vector<std::string> fixed = adapted_lines(lines, forms);
  for (std::size_t k = 0; k < fixed.size(); ++k) {
    if (forms[k] == FortranForm::free) fixed[k].clear();
  }
  return readings_of(fixed, FortranForm::fixed);
}

/// Bytes of other systems that stop a compiler at another place, or without naming them.
void require_text(const std::string& bytes, const std::string& file, const Location& where, const std::string& key) {
  constexpr char end_of_dos = '\x1A';
  const auto refuse = [&](const std::string& words) { throw InputError(where, key, "'" + file + "' " + words); };
  if (bytes.find('\0') != bytes.npos) refuse("is no Fortran source: it holds bytes that are no text");
  if (const std::size_t at = bytes.find(end_of_dos); at != bytes.npos) {
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    refuse("holds U+001A, the end of a file of DOS, in line " + std::to_string(line) + ": delete it");
  }
  if (bytes.find('\n') == bytes.npos && bytes.find('\r') != bytes.npos)
    refuse(
        "has lines that end with a carriage return alone, which no compiler reads: tr '\\r' '\\n' makes them line "
        "breaks");
}

/// Adds what some lines include, and what that includes.
void add_includes(const std::vector<std::string>& lines, FortranSource& source) {
  for (const FortranInclude& include : includes_of(lines, source.form.form)) {
    if (std::ranges::count(source.includes, include.name, &IncludedFile::name) > 0) continue;
    const std::string path = file_beside(fs::path(source.file).parent_path(), include.name);
    const std::string bytes = path.empty() ? include_of_host(include.name) : read_bytes(path, largest_source);
    if (bytes.empty() && path.empty()) continue;  // the compiler says what is missing
    require_text(bytes, path, {source.file, include.line, 0}, "include");
    source.includes.push_back({include.name, path, bytes, {}});
    if (path.empty()) continue;
    const std::vector<std::string> said = lines_of_source(bytes);
    const FortranForm by_name = form_by_name(source.file);
    const std::vector<std::string> more = lines_for_compiler(said, source.form, by_name);
    if (more != said) source.includes.back().adapted = text_of_lines(more);
    append_all(source.statements, statements_of(more, source.form.form));
    append_all(source.warnings,
               column_sentences(columns_of(said, source.form, by_name), path, !is_of_other_vendor(source)));
    add_includes(more, source);
  }
}

/// Lengths of arrays, and the common blocks that a sample names: all of them are zero here. By its small name.
std::string lsdyna_include(const std::string& file) {
  if (file == "nlqparm") return "      integer nlq,lq1\n      parameter (nlq=128, lq1=101)\n";
  if (file == "bk06.inc") {
    return "      integer idmmy,iaddp,ifil,maxsiz,ncycle\n      common/bk06/idmmy,iaddp,ifil,maxsiz,ncycle\n";
  }
  if (file != "iounits.inc") return {};
  return "      integer iohsp,iotty,iomsg,ioall\n      common/iounits/iohsp,iotty,iomsg,ioall\n"
         "      integer msg_sol,ierdat(10)\n      real rerdat(10)\n      character*80 cerdat(10)\n"
         "      parameter (msg_sol=0)\n      common/lsmsgd/ierdat,rerdat\n      common/lsmsgc/cerdat\n";
}

bool is_path(const std::string& word) { return word.find('/') != word.npos; }

/// As the linker's -l takes it: no option, no list.
bool is_plain_library_name(const std::string& name) {
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter_or_digit(c) || c == '_' || c == '-' || c == '.' || c == '+';
  });
}

}  // namespace

bool FortranSource::includes_parameters(const FortranRoutine& routine) const {
  for (const FortranInclude& include : includes_of(lines, form.form)) {
    const std::string name = small_name(include.name);
    const bool within = include.line >= routine.line && include.line <= routine.last_line;
    if (within && (name == "aba_param.inc" || name == "vaba_param.inc")) return true;
  }
  return false;
}

FortranSource read_fortran_source(const std::string& file, const Location& where, const std::string& key) {
  std::error_code code;
  if (!fs::exists(file, code)) throw InputError(where, key, "no such file: '" + file + "'");
  FortranSource source;
  source.file = file;
  source.bytes = read_bytes(file, largest_source);
  require_text(source.bytes, file, where, key);
  const std::vector<std::string> said = lines_of_source(source.bytes);
  source.form = form_of_source(file, said);
  source.lines = lines_for_compiler(said, source.form, form_by_name(file));
  if (source.lines != said) source.adapted = text_of_lines(source.lines);
  const std::string ending = fs::path(file).extension().string();
  const bool capital = ending.size() > 1 && is_letter(ending[1]) && small_letter(ending[1]) != ending[1];
  const auto is_directive = [](const std::string& line) { return line.starts_with('#'); };
  source.preprocessed = capital || std::ranges::any_of(source.lines, is_directive);
  source.statements = statements_of(source.lines, source.form.form);
  const ColumnReadings readings = columns_of(said, source.form, form_by_name(file));
  source.warnings = column_sentences(readings, file, !is_of_other_vendor(source));
  if (source.preprocessed) append_all(source.warnings, joined_line_sentences(said, source.form.form, file));
  source.has_cards = !readings.cards.empty();
  if (!readings.cut.empty()) source.cut_line = readings.cut.front().line;
  add_includes(source.lines, source);
  return source;
}

std::string source_beside(const std::string& deck, const Location& where, const std::string& key) {
  const fs::path path(deck);
  std::error_code code;
  if (!fs::exists(path, code)) throw InputError(where, key, "no such file: '" + deck + "'");
  std::vector<std::string> found;
  for (fs::directory_iterator at(path.parent_path(), code), end; !code && at != end; at.increment(code)) {
    const bool named = at->path().stem() == path.stem() && is_fortran_source(at->path().string());
    if (std::error_code unknown_kind; named && at->is_regular_file(unknown_kind)) found.push_back(at->path().string());
  }
  std::sort(found.begin(), found.end());
  if (found.size() == 1) return found.front();
  const std::string stem = path.stem().string();
  throw InputError(where, key,
                   "'" + deck +
                       (found.empty() ? "' has no Fortran source beside it: " + stem + ".f, " + stem + ".for, ..."
                                      : "' has several Fortran sources beside it") +
                       "; assay check takes SOURCE --deck " + path.filename().string(),
                   joined(found));
}

std::string include_of_host(const std::string& name) {
  const std::string file = small_name(name);
  std::string reals = "      implicit real*8 (a-h,o-z)\n";  // serves both forms of the source
  if (file == "aba_param.inc") return reals + "      parameter (nprecd=2)\n";
  if (file == "vaba_param.inc") {
    return reals + "      parameter (j_sys_dimension=2, n_vec_length=136)\n      parameter (maxblk=n_vec_length)\n";
  }
  if (file == "impcom.inc") return reals;  // of Ansys
  if (std::string text = lsdyna_include(file); !text.empty()) return text;
  if (file.starts_with("smaaspuser") && file.ends_with(".hdr")) return "! what it declares needs no declaration here\n";
  return {};
}

std::string linked_word(const std::string& said, const std::string& folder, const Location& where,
                        const std::string& key) {
  const std::string extension = fs::path(said).extension().string();
  const bool object = extension == ".a" || extension == ".o" || extension == ".so";
  std::error_code code;
  std::string file = absolute_path(fs::path(folder) / said);
  if (!is_path(said) && !object && !fs::exists(file, code)) {
    if (is_plain_library_name(said)) return said;
    throw InputError(
        where, key,
        "must be the name of a library (lapack) or a file (.a, .o, .so), found '" + one_line(said, 80) + "'");
  }
  if (object && fs::is_regular_file(file, code)) return file;
  throw InputError(where, key,
                   "'" + one_line(file, 200) +
                       (fs::exists(file, code) ? "' is no library and no object (.a, .o, .so)" : "': no such file"));
}

std::vector<std::string> link_arguments(const std::string& word) {
  if (!is_path(word)) return {"-l" + word};
  if (!word.ends_with(".so")) return {word};
  return {word, "-Wl,-rpath," + fs::path(word).parent_path().string()};
}

std::string link_content(const std::string& word) { return is_path(word) ? word + "\n" + read_bytes(word) : word; }

}  // namespace assay::drivers
