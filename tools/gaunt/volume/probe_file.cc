// SPDX-License-Identifier: MIT
#include "volume/probe_file.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bad_input.h"
#include "format_name.h"

namespace gaunt::tool {
namespace {

// A byte that is no ASCII, and line ends and an end of text, which transfers as text change.
constexpr uint8_t kMagic[8] = {0x89, 'G', 'P', 'R', 'B', '\r', '\n', 0x1a};
constexpr uint32_t kVersion = 1;

// Offsets.
constexpr size_t kVersionAt = 8, kFormatAt = 12, kRecordBytesAt = 16, kGridAt = 20, kCountAt = 32,
                 kOriginAt = 40, kSpacingAt = 52, kChecksumAt = 64;
static_assert(kChecksumAt + kChecksumBytes == kProbeFileHeaderBytes);

void StoreLe64(uint64_t value, uint8_t* to) {
  StoreLe32(static_cast<uint32_t>(value), to);
  StoreLe32(static_cast<uint32_t>(value >> 32), to + 4);
}

uint64_t LoadLe64(const uint8_t* from) {
  return LoadLe32(from) | static_cast<uint64_t>(LoadLe32(from + 4)) << 32;
}

float LoadFloat(const uint8_t* from) {
  const uint32_t bits = LoadLe32(from);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

void StoreFloat(float value, uint8_t* to) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  StoreLe32(bits, to);
}

uint32_t Checksum(const uint8_t* bytes, size_t size, uint32_t before = 0) {
  return static_cast<uint32_t>(crc32_z(before, bytes, size));
}

}  // namespace

uint32_t LoadLe32(const uint8_t* from) {
  uint32_t value = 0;
  for (size_t k = 0; k < 4; ++k) value |= static_cast<uint32_t>(from[k]) << (8 * k);
  return value;
}

void StoreLe32(uint32_t value, uint8_t* to) {
  for (size_t k = 0; k < 4; ++k) to[k] = static_cast<uint8_t>(value >> (8 * k));
}

ProbeFileHeaderBytes WriteProbeFileHeader(const ProbeFileHeader& header) {
  ProbeFileHeaderBytes bytes;
  std::copy(std::begin(kMagic), std::end(kMagic), bytes.begin());
  StoreLe32(kVersion, bytes.data() + kVersionAt);
  StoreLe32(header.format, bytes.data() + kFormatAt);
  StoreLe32(header.record_bytes, bytes.data() + kRecordBytesAt);
  StoreLe64(header.count, bytes.data() + kCountAt);
  for (size_t axis = 0; axis < 3; ++axis) {
    StoreLe32(header.grid.size[axis], bytes.data() + kGridAt + 4 * axis);
    StoreFloat(header.grid.origin[axis], bytes.data() + kOriginAt + 4 * axis);
    StoreFloat(header.grid.spacing[axis], bytes.data() + kSpacingAt + 4 * axis);
  }
  StoreLe32(Checksum(bytes.data(), kChecksumAt), bytes.data() + kChecksumAt);
  return bytes;
}

ProbeFileHeader ReadProbeFileHeader(const std::string& file, const uint8_t* bytes, size_t size) {
  const auto reject = [&](const std::string& why) { throw BadInput(file + ": " + why); };
  if (size == 0) reject("is empty");
  if (std::memcmp(bytes, kMagic, std::min(size, sizeof(kMagic))) != 0) {
    reject("is no file of packed probes");
  }
  if (size >= kVersionAt + 4 && LoadLe32(bytes + kVersionAt) != kVersion) {
    reject(fmt::format("has version {} of its format, but this program reads version {}",
                       LoadLe32(bytes + kVersionAt), kVersion));
  }
  if (size < kProbeFileHeaderBytes) reject("ends in its header");
  if (Checksum(bytes, kChecksumAt) != LoadLe32(bytes + kChecksumAt)) {
    reject("is damaged: the checksum of its header is wrong");
  }
  ProbeFileHeader header;
  header.format = LoadLe32(bytes + kFormatAt);
  header.record_bytes = LoadLe32(bytes + kRecordBytesAt);
  header.count = LoadLe64(bytes + kCountAt);
  for (size_t axis = 0; axis < 3; ++axis) {
    header.grid.size[axis] = LoadLe32(bytes + kGridAt + 4 * axis);
    header.grid.origin[axis] = LoadFloat(bytes + kOriginAt + 4 * axis);
    header.grid.spacing[axis] = LoadFloat(bytes + kSpacingAt + 4 * axis);
  }
  const uint32_t record_bytes = PropertiesOfFormat(header.format).bytes;
  if (record_bytes == 0) {
    reject(fmt::format("has probes of format {}, which this program does not know", header.format));
  }
  if (header.record_bytes != record_bytes) {
    reject(fmt::format("has records of {} bytes, but those of {} have {}", header.record_bytes,
                       NameOfFormat(header.format), record_bytes));
  }
  if (header.count == 0) reject("has no probes");
  if (header.count >= (uint64_t{1} << 62) / record_bytes) {
    reject(fmt::format("cannot have {} probes", header.count));
  }
  const std::string grid_error = GridError(header.grid, header.count);
  if (!grid_error.empty()) reject(grid_error);
  return header;
}

std::string GridError(const ProbeFileGrid& grid, uint64_t count) {
  const auto [x, y, z] = grid.size;
  if (x == 0 && y == 0 && z == 0) return "";
  // Exact where it is equal, for the product of the first two has 64 bits.
  if (x == 0 || y == 0 || z == 0 || count % z != 0 || count / z != uint64_t{x} * y) {
    return fmt::format("has a grid of {} x {} x {}, but {} probes", x, y, z, count);
  }
  for (size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(grid.origin[axis])) return "has a grid whose origin is not finite";
    if (!std::isfinite(grid.spacing[axis]) || !(grid.spacing[axis] > 0.0f)) {
      return "has a grid whose spacing is not finite and above 0";
    }
  }
  return "";
}

uint32_t BlockChecksum(uint64_t first_probe, const uint8_t* records, size_t bytes) {
  uint8_t place[8];
  StoreLe64(first_probe, place);
  return Checksum(records, bytes, Checksum(place, sizeof(place)));
}

}  // namespace gaunt::tool
