// SPDX-License-Identifier: BSD-3-Clause
// Files, folders and memory of ours beside foreign code, which closes what it can think of and writes where it stands.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace assay::adapters {

/// A file that is open, and closed with this; a negative number is none.
class OpenFile {
 public:
  explicit OpenFile(int number) : number_(number) {}
  ~OpenFile() { close(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const { return number_; }
  void take(int number) { close(), number_ = number; }
  /// What the system says of it, which errno explains.
  int close() { return number_ < 0 ? 0 : ::close(std::exchange(number_, -1)); }

 private:
  int number_;
};

/// A copy of a file. Its number is high where the system lets it be, and in any case beyond those of the standard
/// streams and of WorkerFile. -1: none can be had.
int high_copy(int file);

/// A pipe of such files, which no other program inherits. False: none can be had, and errno says why.
bool high_pipe(int ends[2]);

/// The same, closed with this.
class Pipe {
 public:
  /// Throws std::system_error.
  Pipe();
  ~Pipe() { close_in(), close_out(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int in() const { return ends_[0]; }
  int out() const { return ends_[1]; }
  void close_in() { close(0); }
  void close_out() { close(1); }

 private:
  void close(int k);
  int ends_[2] = {-1, -1};
};

/// A file in memory to which a program prints. Throws std::system_error.
class PrintedFile {
 public:
  explicit PrintedFile(const char* name);
  int number() const { return file_.number(); }
  /// So many bytes, at most, from the beginning, or from the end.
  std::string first(std::size_t most) const { return text(most, false); }
  std::string last(std::size_t most) const { return text(most, true); }

 private:
  std::string text(std::size_t most, bool last) const;
  OpenFile file_;
};

/// The words of a program as exec() takes them, and null; they point into `words`.
std::vector<char*> pointers_to(std::vector<std::string>& words);

/// Reads nothing from here on, and prints to such files.
void send_streams_to(int output, int errors);

/// False where not all of it could be written.
bool write_all(int file, std::string_view text);

/// This process, and those that it forks, stand in such a folder.
inline bool stands_apart = false;

/// That for temporary files.
std::string temporary_folder();

/// A new folder below that, which goes with this. Nothing in a process that stands apart already: its folder may hold
/// files of the model.
class OwnFolder {
 public:
  static constexpr const char* worker_names = "assay-worker-";  ///< how the names of such folders begin

  explicit OwnFolder(const char* names = worker_names);
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  /// In a process that was forked for foreign code, before it runs. False: there is no folder, and errno says why.
  bool enter() const;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int reason_ = 0;  ///< of errno, why there is none
};

/// Memory without a name that processes share: nothing is left of it when the last of them has ended.
class SharedMemory {
 public:
  /// New, zero, of so many bytes; pages are taken when they are touched. Throws std::system_error.
  explicit SharedMemory(std::size_t bytes);
  /// Likewise, for processes that this one forks: without a file, whatever the limit of a file's size.
  static SharedMemory of_forks(std::size_t bytes);
  /// That of another process, by an inherited file. Throws std::system_error.
  static SharedMemory of_file(int file);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  void* data() const { return data_; }
  std::size_t size() const { return size_; }
  int file() const { return file_; }

 private:
  SharedMemory(int file, std::size_t bytes);
  int file_;
  void* data_;
  std::size_t size_;
};

}  // namespace assay::adapters
