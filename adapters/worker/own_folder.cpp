// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/own_folder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "adapters/worker/control.hpp"

namespace assay::adapters {

bool stand_in(const std::string& folder) { return stands_apart = ::chdir(folder.c_str()) == 0; }

std::string temporary_folder() {
  const char* said = std::getenv("TMPDIR");
  return said && *said == '/' ? said : "/tmp";
}

OwnFolder::OwnFolder() {
  if (stands_apart) return;
  path_ = temporary_folder() + "/" + worker_folder + "XXXXXX";
  if (!::mkdtemp(path_.data())) reason_ = errno, path_.clear();
}

OwnFolder::~OwnFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

bool OwnFolder::enter() const {
  if (stands_apart || stand_in(path_)) return true;
  if (reason_ != 0) errno = reason_;
  return false;
}

}  // namespace assay::adapters
