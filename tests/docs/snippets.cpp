// SPDX-License-Identifier: BSD-3-Clause
#include "tests/docs/snippets.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "tests/house/tree.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::docs {

namespace fs = std::filesystem;

namespace {

constexpr char mark = '\x01';  ///< between the outputs of console commands

struct Ran {
  int status = -1;
  std::string output;  ///< both streams
};

/// A Python that has numpy, which blocks ask for by needs=numpy.
const std::string numpy =
    ASSAY_NUMPY_PYTHON[0] == '\0' ? "" : "numpy() { :; }\npython3() { '" ASSAY_NUMPY_PYTHON "' \"$@\"; }\n";

/// The shell's environment: `assay`, its library and this build's cmake first, nothing of the user's.
const std::string environment =
    numpy + "unset ASSAY_MATERIAL_PATH ASSAY_LIBRARY ASSAY_PROGRAM CDPATH DESTDIR\nbuilt='" + built() +
    "'\n"
    "PATH=$built:$PATH ASSAY_DATA_HOME=$PWD/data ASSAY_CACHE_HOME=$PWD/cache HOME=$PWD\n"
    "PYTHONPATH=$built/python PKG_CONFIG_PATH=$built/pkgconfig PYTHONDONTWRITEBYTECODE=1\n"
    "CMAKE_GENERATOR='" ASSAY_CMAKE_GENERATOR
    "' LC_ALL=C\n"
    "export PATH ASSAY_DATA_HOME ASSAY_CACHE_HOME HOME CMAKE_GENERATOR LC_ALL\n"
    "export PYTHONPATH PKG_CONFIG_PATH PYTHONDONTWRITEBYTECODE\n";

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
}

Ran run_script(const std::string& script, const fs::path& folder) {
  const fs::path file = folder / ".script.sh", output = folder / ".output";
  write(file, environment + script);
  const std::string command =
      "cd '" + folder.string() + "' && sh ./.script.sh >'" + output.string() + "' 2>&1 </dev/null";
  const int status = std::system(command.c_str());
  Ran ran;
  if (WIFEXITED(status)) ran.status = WEXITSTATUS(status);
  std::ifstream in(output, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  ran.output = text.str();
  return ran;
}

/// Whether the line is the pattern with any text in place of each `...`.
bool line_agrees(const std::string& pattern, const std::string& line) {
  const std::string any = "...";
  std::size_t at = 0;
  for (std::size_t begin = 0;;) {
    const std::size_t end = pattern.find(any, begin);
    const std::string piece = pattern.substr(begin, end - begin);
    if (begin == 0 && end == pattern.npos) return line == pattern;
    if (begin == 0) {
      if (!line.starts_with(piece)) return false;
      at = piece.size();
    } else if (end == pattern.npos) {
      return line.size() >= at + piece.size() && line.ends_with(piece);
    } else {
      const std::size_t found = line.find(piece, at);
      if (found == line.npos) return false;
      at = found + piece.size();
    }
    begin = end + any.size();
  }
}

using Lines = std::vector<std::string>;

bool lines_agree(const Lines& expected, std::size_t i, const Lines& output, std::size_t j) {
  if (i == expected.size()) return j == output.size();
  if (expected[i] == "...") {
    for (std::size_t k = j; k <= output.size(); ++k) {
      if (lines_agree(expected, i + 1, output, k)) return true;
    }
    return false;
  }
  return j < output.size() && line_agrees(expected[i], output[j]) && lines_agree(expected, i + 1, output, j + 1);
}

struct Command {
  std::string text, expected;
};

std::vector<Command> commands_of(const Block& block) {
  std::vector<Command> commands;
  bool continued = false;
  for (const std::string& line : house::lines_of(block.text)) {
    if (line.starts_with("$ ")) {
      commands.push_back({line.substr(2), {}});
    } else if (commands.empty()) {
      throw std::runtime_error("a console block must begin with '$ '");
    } else if (continued) {
      commands.back().text += "\n" + line;
    } else {
      commands.back().expected += line + "\n";
    }
    continued = (line.starts_with("$ ") || continued) && line.ends_with("\\");
  }
  return commands;
}

std::string run_console(const Block& block, const fs::path& folder) {
  const auto commands = commands_of(block);
  std::string script;
  for (const Command& command : commands) {  // $? of a command stays for the next one
    script += command.text + "\nstatus_=$?; printf '\\001'; (exit $status_)\n";
  }
  const Ran ran = run_script(script, folder);
  std::size_t at = 0;
  for (const Command& command : commands) {
    const std::size_t end = ran.output.find(mark, at);
    if (end == ran.output.npos) return "'" + command.text + "' did not come to its end:\n" + ran.output.substr(at);
    const std::string output = ran.output.substr(at, end - at);
    if (!agrees(command.expected, output)) {
      return "'" + command.text + "' prints\n" + output + "where the page says\n" + command.expected;
    }
    at = end + 1;
  }
  return {};
}

}  // namespace

fs::path scratch_folder(const std::string& name) {
  const fs::path root = tree_folder(), folder = fs::path(built()) / "docs" / name;
  fs::remove_all(folder);
  fs::create_directories(folder / "build");
  for (const char* link : {"configs", "harness"}) fs::create_directory_symlink(root / link, folder / link);
  fs::create_directory_symlink(built(), folder / "build" / "release");
  return folder;
}

bool agrees(const std::string& expected, const std::string& output) {
  return lines_agree(house::lines_of(expected), 0, house::lines_of(output), 0);
}

std::string run_block(const Block& block, const fs::path& folder) {
  if (block.skip) return {};
  if (!block.needs.empty() && run_script("command -v '" + block.needs + "'", folder).status != 0) return {};
  if (!block.title.empty()) {
    const fs::path file = folder / block.title;
    fs::create_directories(file.parent_path());
    write(file, block.text);
    return {};
  }
  if (block.language == "console") return run_console(block, folder);
  if (block.language != "sh") return {};
  const Ran ran = run_script("set -e\n" + block.text, folder);
  if (ran.status == 0) return {};
  return "exit " + std::to_string(ran.status) + "\n" + ran.output;
}

std::string run_page(const Page& page, const fs::path& folder) {
  for (const Block& block : page.blocks) {
    const std::string complaint = run_block(block, folder);
    if (!complaint.empty()) return page.path + ":" + std::to_string(block.line) + ": " + complaint;
  }
  return {};
}

}  // namespace assay::docs
