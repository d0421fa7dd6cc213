// SPDX-License-Identifier: MIT
// Headers and checksums of files of packed probes, which docs/probe_file.md describes byte by byte.
#ifndef GAUNT_TOOLS_GAUNT_VOLUME_PROBE_FILE_H_
#define GAUNT_TOOLS_GAUNT_VOLUME_PROBE_FILE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace gaunt::tool {

// Where the probes of a file stand: probe x + size[0] (y + size[1] z) at origin + (x, y, z) spacing.
struct ProbeFileGrid {
  std::array<uint32_t, 3> size = {};  // 0: the probes are no grid
  std::array<float, 3> origin = {};
  std::array<float, 3> spacing = {};

  bool any() const { return size[0] != 0; }
};

struct ProbeFileHeader {
  uint32_t format = 0;  // GAUNT_FORMAT_*
  uint32_t record_bytes = 0;
  uint64_t count = 0;
  ProbeFileGrid grid;
};

inline constexpr size_t kProbeFileHeaderBytes = 68;
// Probes of all blocks but the last, which has what is left.
inline constexpr size_t kBlockProbes = 4096;
// After the header, and after the records of each block.
inline constexpr size_t kChecksumBytes = 4;

using ProbeFileHeaderBytes = std::array<uint8_t, kProbeFileHeaderBytes>;
ProbeFileHeaderBytes WriteProbeFileHeader(const ProbeFileHeader& header);

// Of the bytes that a file begins with, kProbeFileHeaderBytes of them if it has so many. Throws
// BadInput with the file's name. Bytes of all blocks fit into 63 bits.
ProbeFileHeader ReadProbeFileHeader(const std::string& file, const uint8_t* bytes, size_t size);

// Why a grid cannot be that of so many probes, or "".
std::string GridError(const ProbeFileGrid& grid, uint64_t count);

// Of the records of a block that begins with a probe.
uint32_t BlockChecksum(uint64_t first_probe, const uint8_t* records, size_t bytes);

uint32_t LoadLe32(const uint8_t* from);
void StoreLe32(uint32_t value, uint8_t* to);

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_VOLUME_PROBE_FILE_H_
