// SPDX-License-Identifier: BSD-3-Clause
// Results appear whole or not at all: files are staged in a hidden sub-folder and renamed into place by commit().
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/system/whole_file.hpp"

namespace assay::drivers {

/// Names that a result may hold, of whichever verb: '#' stands for one or more digits; a '+' in front marks a table
/// whose name users also give to files of their own, and which is therefore removed only where it begins as ours does.
std::vector<std::string> result_files();

/// One run's result folder, locked against a second writer as long as this lives. Every failure (unwritable folder,
/// full disk, a file in the way) throws SystemError with the path and the reason, another run that writes here
/// FolderBusy.
class OutputFolder {
 public:
  /// Creates `target` and its parents where they are missing, and the staging folder inside it. `names` are the
  /// patterns of the files that a result may hold. Refuses (InputError) the folder of another kind of results. Where
  /// the folder holds a complete result (its last file, as result.json of a run), commit() removes the files that match
  /// them and were not written again; it never removes any other file.
  explicit OutputFolder(std::filesystem::path target, std::vector<std::string> names = result_files());
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  /// Without a commit(): removes what was staged and the folders that the constructor made; an earlier result in the
  /// folder is as it was.
  ~OutputFolder();

  /// Refuses (InputError) a folder that holds the results of another kind: a run, a study and a judgement write files
  /// of the same names.
  static void refuse_another_kind(const std::filesystem::path& target, const std::vector<std::string>& names);

  /// Refuses (InputError) what was read and lies in the folder under a name of the result, which would replace it.
  void keep_inputs() const;

  /// Stages one file: all bytes on the disk, or SystemError. The name must match one of the patterns; with a slash in
  /// it the file lies in a sub-folder.
  void write(const std::string& name, std::string_view bytes);
  /// The same of a file that `write` puts together from pieces.
  void write_pieces(const std::string& name, const std::function<void(const PutBytes&)>& write);

  /// Publishes everything; the last file of its kind goes first and comes back last, so that a folder that holds one is
  /// complete. When it fails half-way everything is put back.
  void commit();

  const std::filesystem::path& target() const { return target_; }

 private:
  void stage(const std::string& name, const std::function<void(const std::filesystem::path&)>& write);
  bool make_folders();
  bool lock();
  void make_staging();
  bool is_ours(const std::string& name) const;
  bool is_stale(const std::string& name) const;
  std::vector<std::string> replaced() const;
  void give_back();

  std::filesystem::path target_, staging_;
  std::vector<std::string> names_, staged_;
  std::string last_file_;                    ///< which marks a complete result; empty: these files have none
  std::vector<std::filesystem::path> made_;  ///< folders that the constructor made, outermost first
  int lock_ = -1;                            ///< descriptor of the folder itself
};

}  // namespace assay::drivers
