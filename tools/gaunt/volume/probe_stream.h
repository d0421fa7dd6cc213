// SPDX-License-Identifier: MIT
// Probes of files of any size, block by block: files of packed probes, and raw ones, which hold
// records or coefficients alone.
#ifndef GAUNT_TOOLS_GAUNT_VOLUME_PROBE_STREAM_H_
#define GAUNT_TOOLS_GAUNT_VOLUME_PROBE_STREAM_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "byte_file.h"
#include "gaunt/gaunt.h"
#include "volume/probe_file.h"

namespace gaunt::tool {

inline constexpr size_t kMaxStride = 4096;
inline constexpr uint32_t kMaxFloatOrder = 16;

// How a probe is written.
struct ProbeEncoding {
  uint32_t format = 0;  // GAUNT_FORMAT_*; 0: floats, channel by channel
  uint32_t order = 0;
  size_t bytes = 0;  // of a probe

  size_t planes() const { return 3 * size_t{order} * order; }
  std::string Name() const;  // for messages
};
ProbeEncoding EncodingOfFormat(uint32_t format);
ProbeEncoding EncodingOfFloats(uint32_t order);

// Probes that lie `stride` bytes apart.
struct ProbeBlock {
  uint64_t first = 0;
  size_t count = 0;
  std::vector<uint8_t> bytes;  // of a file of packed probes also the checksum
};

class ProbeReader {
 public:
  // A file of packed probes. Throws BadInput, as do the others.
  explicit ProbeReader(const std::string& path);
  // A raw file; a stride of 0 is that of probes without gaps.
  ProbeReader(const std::string& path, const ProbeEncoding& encoding, size_t stride);

  const ProbeEncoding& encoding() const { return encoding_; }
  size_t stride() const { return stride_; }
  uint64_t count() const { return count_; }
  const ProbeFileGrid& grid() const { return grid_; }
  uint64_t bytes_read() const { return file_.bytes(); }
  [[noreturn]] void Reject(const std::string& why) const;

  // Whether there was a block. After the last, nothing may follow.
  bool Read(ProbeBlock& block);
  // Checks a block that was read; on any thread.
  void Verify(const ProbeBlock& block) const;

 private:
  ByteReader file_;
  bool packed_file_;
  ProbeEncoding encoding_;
  size_t stride_ = 0;
  uint64_t count_ = 0;
  uint64_t read_ = 0;  // probes
  ProbeFileGrid grid_;
};

class ProbeWriter {
 public:
  // Messages say `name`, the file that `path` will become. Throws std::runtime_error, as do the
  // others. A file of packed probes begins with the header.
  ProbeWriter(const std::string& path, const std::string& name, const ProbeFileHeader& header);
  // A raw file has only the probes, with gaps of 0 if the stride is larger. Throws BadInput if it is
  // smaller.
  ProbeWriter(const std::string& path, const std::string& name, const ProbeEncoding& encoding,
              size_t stride);

  const ProbeEncoding& encoding() const { return encoding_; }
  size_t stride() const { return stride_; }
  uint64_t bytes_written() const { return bytes_written_; }

  // Makes room for the probes of a block, all bytes 0; on any thread.
  void Prepare(uint64_t first, size_t count, ProbeBlock& block) const;
  // Completes a block whose probes are there; on any thread.
  void Seal(ProbeBlock& block) const;
  void Write(const ProbeBlock& block);
  void Close();

 private:
  ByteWriter file_;
  bool packed_file_;
  ProbeEncoding encoding_;
  size_t stride_;
  uint64_t bytes_written_ = 0;
};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_VOLUME_PROBE_STREAM_H_
