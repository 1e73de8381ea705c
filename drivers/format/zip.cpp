// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/zip.hpp"

#include <zlib.h>

#include <algorithm>
#include <memory>
#include <new>

#include "drivers/system/input_error.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

constexpr std::uint64_t in_64_bits = 0xffffffff;  ///< stands where a number of 32 bits does not hold the value
constexpr std::uint64_t zip64_version = 45, date_1980 = 0x21, deflation = 8;
constexpr std::uint64_t local_mark = 0x04034b50, central_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::uint64_t end64_mark = 0x06064b50, locator_mark = 0x07064b50;
constexpr std::size_t local_bytes = 30, central_bytes = 46, end_bytes = 22, end64_bytes = 56, locator_bytes = 20;
constexpr std::size_t piece_bytes = std::size_t{1} << 18;

void put_little(std::string& text, std::uint64_t value, int bytes) {
  for (int k = 0; k < bytes; ++k) text += static_cast<char>(value >> (8 * k) & 0xff);
}

/// Of so many bytes at a place of a text that has them.
std::uint64_t little(std::string_view text, std::size_t at, int bytes) {
  std::uint64_t value = 0;
  for (int k = bytes; k-- > 0;) value = value << 8 | static_cast<unsigned char>(text[at + static_cast<std::size_t>(k)]);
  return value;
}

std::uint32_t crc_of(std::uint32_t before, std::string_view bytes) {
  return static_cast<std::uint32_t>(::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// What the header of a member and its entry in the directory share, up to the lengths of name and more.
void put_facts(std::string& text, std::uint32_t crc) {
  put_little(text, zip64_version, 2);
  put_little(text, 0, 2);  // flags
  put_little(text, 0, 2);  // stored
  put_little(text, 0, 2);  // time
  put_little(text, date_1980, 2);
  put_little(text, crc, 4);
  put_little(text, in_64_bits, 4);
  put_little(text, in_64_bits, 4);
}

class Inflation {
 public:
  Inflation() {
    if (::inflateInit2(&stream_, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { ::inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Calls take(bytes) for what the packed bytes hold. False: they are damaged.
  bool add(std::string& packed, const auto& take) {
    std::string out(piece_bytes, '\0');
    stream_.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream_.avail_in = static_cast<uInt>(packed.size());
    while (!ended_) {
      stream_.next_out = reinterpret_cast<Bytef*>(out.data());
      stream_.avail_out = static_cast<uInt>(out.size());
      const int said = ::inflate(&stream_, Z_NO_FLUSH);
      if (said != Z_OK && said != Z_STREAM_END && said != Z_BUF_ERROR) return false;
      ended_ = said == Z_STREAM_END;
      const std::size_t got = out.size() - stream_.avail_out;
      if (got > 0 && !take(std::string_view(out).substr(0, got))) return false;
      if (got == 0 && stream_.avail_in == 0) break;
      if (got == 0 && said == Z_BUF_ERROR) break;
    }
    return true;
  }
  bool ended() const { return ended_; }

 private:
  z_stream stream_ = {};
  bool ended_ = false;
};

}  // namespace

std::size_t ZipLayout::add(const std::string& name, std::uint64_t size) {
  constexpr std::uint64_t in_more = 20;  // the sizes
  const std::uint64_t begin = end_ + local_bytes + name.size() + in_more;
  members_.push_back({name, size, end_, begin, static_cast<std::uint32_t>(::crc32_z(0, nullptr, 0))});
  end_ = begin + size;
  return members_.size() - 1;
}

void ZipLayout::count(std::size_t member, std::string_view bytes) {
  members_[member].crc = crc_of(members_[member].crc, bytes);
}

std::vector<ZipLayout::Piece> ZipLayout::pieces() const {
  std::vector<Piece> all;
  std::string directory;
  for (const Member& member : members_) {
    std::string header;
    put_little(header, local_mark, 4);
    put_facts(header, member.crc);
    put_little(header, member.name.size(), 2);
    put_little(header, 20, 2);
    header += member.name;
    put_little(header, 1, 2), put_little(header, 16, 2);
    put_little(header, member.size, 8), put_little(header, member.size, 8);
    all.push_back({member.at, header});
    put_little(directory, central_mark, 4);
    put_little(directory, zip64_version, 2);
    put_facts(directory, member.crc);
    put_little(directory, member.name.size(), 2);
    put_little(directory, 28, 2);
    put_little(directory, 0, 2), put_little(directory, 0, 2), put_little(directory, 0, 2);  // remark, disk, kind
    put_little(directory, 0, 4);                                                            // rights
    put_little(directory, in_64_bits, 4);
    directory += member.name;
    put_little(directory, 1, 2), put_little(directory, 24, 2);
    for (const std::uint64_t value : {member.size, member.size, member.at}) put_little(directory, value, 8);
  }
  const std::uint64_t bytes = directory.size(), count = members_.size();
  put_little(directory, end64_mark, 4);
  put_little(directory, end64_bytes - 12, 8);
  put_little(directory, zip64_version, 2), put_little(directory, zip64_version, 2);
  put_little(directory, 0, 4), put_little(directory, 0, 4);
  for (const std::uint64_t value : {count, count, bytes, end_}) put_little(directory, value, 8);
  put_little(directory, locator_mark, 4);
  put_little(directory, 0, 4), put_little(directory, end_ + bytes, 8), put_little(directory, 1, 4);
  put_little(directory, end_mark, 4);
  for (const std::uint64_t value : {0, 0, 0xffff, 0xffff}) put_little(directory, value, 2);
  put_little(directory, in_64_bits, 4), put_little(directory, in_64_bits, 4), put_little(directory, 0, 2);
  all.push_back({end_, directory});
  return all;
}

ZipReader::ZipReader(const InputBytes& input) : input_(input) {
  constexpr std::uint64_t longest_remark = 0xffff;
  const std::uint64_t from = input.size() - std::min<std::uint64_t>(input.size(), longest_remark + end_bytes);
  const std::string tail = input.text(from, longest_remark + end_bytes);
  std::size_t at = tail.size() < end_bytes ? tail.npos : tail.rfind("PK\5\6", tail.size() - end_bytes);
  if (at == tail.npos) refuse("is cut off: it has no directory");
  std::uint64_t count = little(tail, at + 10, 2), size = little(tail, at + 12, 4), begin = little(tail, at + 16, 4);
  if (at >= locator_bytes && little(tail, at - locator_bytes, 4) == locator_mark) {
    const std::string end = bytes(little(tail, at - locator_bytes + 8, 8), end64_bytes);
    if (little(end, 0, 4) != end64_mark) refuse("is damaged");
    count = little(end, 32, 8), size = little(end, 40, 8), begin = little(end, 48, 8);
  }
  directory(begin, size, count);
}

void ZipReader::refuse(const std::string& what) const {
  throw InputError({input_.file(), 0, 0}, "", "the archive " + what);
}

std::string ZipReader::bytes(std::uint64_t at, std::size_t size) const {
  if (at > input_.size() || size > input_.size() - at) refuse("is cut off or damaged");
  std::string found = input_.text(at, size);
  if (found.size() != size) refuse("is cut off");
  return found;
}

void ZipReader::directory(std::uint64_t at, std::uint64_t size, std::uint64_t count) {
  constexpr std::uint64_t largest = 1 << 24;  // [bytes]
  if (size > largest) refuse("has a directory that is too large");
  const std::string text = bytes(at, size);
  std::size_t k = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (k + central_bytes > text.size() || little(text, k, 4) != central_mark) refuse("is damaged");
    const std::uint64_t flags = little(text, k + 8, 2), method = little(text, k + 10, 2);
    const auto crc = static_cast<std::uint32_t>(little(text, k + 16, 4));
    std::uint64_t packed = little(text, k + 20, 4), plain = little(text, k + 24, 4), local = little(text, k + 42, 4);
    const std::size_t name = little(text, k + 28, 2), more = little(text, k + 30, 2), remark = little(text, k + 32, 2);
    if (text.size() - k < central_bytes + name + more + remark) refuse("is damaged");
    members_.push_back({text.substr(k + central_bytes, name), 0});
    const std::string_view extra = std::string_view(text).substr(k + central_bytes + name, more);
    for (std::size_t e = 0; e + 4 <= extra.size(); e += 4 + little(extra, e + 2, 2)) {
      if (little(extra, e, 2) != 1) continue;
      std::size_t from = e + 4;
      for (std::uint64_t* value : {&plain, &packed, &local}) {
        if (*value != in_64_bits) continue;
        if (from + 8 > extra.size()) refuse("is damaged");
        *value = little(extra, from, 8), from += 8;
      }
    }
    k += central_bytes + name + more + remark;
    if (flags & 1) refuse("is encrypted");
    const std::string header = bytes(local, local_bytes);
    if (little(header, 0, 4) != local_mark) refuse("is damaged");
    const std::uint64_t begin = local + local_bytes + little(header, 26, 2) + little(header, 28, 2);
    if (begin > input_.size() || packed > input_.size() - begin) refuse("is cut off or damaged");
    if (method != 0 && method != deflation)
      refuse("has a member '" + shown(members_.back().name, 40) + "' that is neither stored nor deflated");
    if (method == 0 && packed != plain) refuse("is damaged");
    members_.back().size = plain;
    places_.push_back(method == 0 ? stored(begin, plain, crc) : deflated(begin, packed, plain, crc));
  }
}

ZipReader::Place ZipReader::stored(std::uint64_t at, std::uint64_t size, std::uint32_t crc) const {
  std::uint32_t found = 0;
  for (std::uint64_t done = 0; done < size;) {
    const std::string piece = bytes(at + done, std::min<std::uint64_t>(piece_bytes, size - done));
    found = crc_of(found, piece), done += piece.size();
  }
  if (found != crc) refuse("is damaged: '" + shown(members_.back().name, 40) + "' is not what it was");
  return {at};
}

ZipReader::Place ZipReader::deflated(std::uint64_t at, std::uint64_t packed, std::uint64_t size,
                                     std::uint32_t crc) const {
  Place place{0, std::make_unique<UnnamedFile>()};
  Inflation inflation;
  std::uint32_t found = 0;
  const auto keep = [&](std::string_view bytes) {
    if (place.inflated->size() + bytes.size() > size) return false;
    place.inflated->append(bytes);
    found = crc_of(found, bytes);
    return true;
  };
  bool good = true;
  for (std::uint64_t done = 0; good && done < packed && !inflation.ended();) {
    std::string piece = bytes(at + done, std::min<std::uint64_t>(piece_bytes, packed - done));
    done += piece.size();
    good = inflation.add(piece, keep);
  }
  if (!good || !inflation.ended() || place.inflated->size() != size || found != crc)
    refuse("is damaged: '" + shown(members_.back().name, 40) + "' is not what it was");
  return place;
}

std::size_t ZipReader::read(std::size_t member, std::uint64_t at, char* into, std::size_t most) const {
  const std::uint64_t size = members_[member].size;
  most = std::min<std::uint64_t>(most, size - std::min(at, size));
  const Place& place = places_[member];
  if (!place.inflated) return input_.read(place.begin + at, into, most);
  const std::int64_t n = read_at(place.inflated->number(), at, into, most);
  if (n < 0) refuse("cannot be read: its inflated copy is gone");
  return static_cast<std::size_t>(n);
}

}  // namespace assay::drivers
