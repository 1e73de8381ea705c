// SPDX-License-Identifier: BSD-3-Clause
// Where processes that run foreign code stand: it writes files where it stands, and that is not the user's folder.
#pragma once

#include <string>

namespace assay::adapters {

/// This process, and those that it forks, stand in such a folder.
inline bool stands_apart = false;

/// True, and so it does from now on; false: it cannot be reached.
bool stand_in(const std::string& folder);

/// That for temporary files.
std::string temporary_folder();

/// A new folder below that, which goes with this. Nothing in a process that stands apart already:
/// its folder may hold files of the model.
class OwnFolder {
 public:
  OwnFolder();
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  /// In a process that was forked for foreign code, before it runs. False: there is no folder.
  bool enter() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int reason_ = 0;  ///< of errno, why there is none
};

}  // namespace assay::adapters
