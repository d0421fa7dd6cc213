// SPDX-License-Identifier: MIT
#include "volume/probe_stream.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "bad_input.h"
#include "format_name.h"

namespace gaunt::tool {
namespace {

// From probe to probe of a raw file.
size_t StrideOf(const std::string& file, const ProbeEncoding& encoding, size_t stride) {
  if (stride == 0) return encoding.bytes;
  if (stride < encoding.bytes) {
    throw BadInput(fmt::format("{}: a stride of {} bytes is less than the {} of {}", file, stride,
                               encoding.bytes, encoding.Name()));
  }
  if (encoding.format == 0 && stride % sizeof(float) != 0) {
    throw BadInput(
        fmt::format("{}: a stride of {} bytes is no multiple of the 4 of a float", file, stride));
  }
  return stride;
}

}  // namespace

// Coefficients are used as files have them.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the host must be little-endian");

std::string ProbeEncoding::Name() const {
  return format != 0 ? NameOfFormat(format) : fmt::format("floats of order {}", order);
}

ProbeEncoding EncodingOfFormat(uint32_t format) {
  const gaunt_format_properties properties = PropertiesOfFormat(format);
  return {format, properties.order, properties.bytes};
}

ProbeEncoding EncodingOfFloats(uint32_t order) {
  return {0, order, 3 * size_t{order} * order * sizeof(float)};
}

ProbeReader::ProbeReader(const std::string& path) : file_(path), packed_file_(true) {
  ProbeFileHeaderBytes bytes;
  const size_t size = file_.Read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  const ProbeFileHeader header = ReadProbeFileHeader(path, bytes.data(), size);
  encoding_ = EncodingOfFormat(header.format);
  stride_ = encoding_.bytes;
  count_ = header.count;
  grid_ = header.grid;
}

ProbeReader::ProbeReader(const std::string& path, const ProbeEncoding& encoding, size_t stride)
    : file_(path),
      packed_file_(false),
      encoding_(encoding),
      stride_(StrideOf(path, encoding, stride)) {
  const std::optional<uint64_t> size = file_.Size();
  if (!size) Reject("is no regular file, so that nothing says how many probes it has");
  if (*size == 0) Reject("is empty");
  if (*size % stride_ != 0) {
    Reject(fmt::format("has {} bytes, which is no multiple of {}, those from probe to probe of {}",
                       *size, stride_, encoding_.Name()));
  }
  count_ = *size / stride_;
}

void ProbeReader::Reject(const std::string& why) const {
  throw BadInput(file_.path() + ": " + why);
}

bool ProbeReader::Read(ProbeBlock& block) {
  if (read_ == count_) {
    char extra;
    if (file_.Read(&extra, 1) > 0) Reject("has bytes after its last probe");
    return false;
  }
  block.first = read_;
  block.count = std::min<uint64_t>(kBlockProbes, count_ - read_);
  block.bytes.resize(block.count * stride_ + (packed_file_ ? kChecksumBytes : 0));
  const size_t size = file_.Read(reinterpret_cast<char*>(block.bytes.data()), block.bytes.size());
  if (size < block.bytes.size()) {
    const size_t whole = std::min(block.count, size / stride_);
    Reject(whole < block.count
               ? fmt::format("is cut short: it has {} of {} probes", read_ + whole, count_)
               : fmt::format("is cut short: the checksum after its probe {} is missing",
                             read_ + whole - 1));
  }
  read_ += block.count;
  return true;
}

void ProbeReader::Verify(const ProbeBlock& block) const {
  if (!packed_file_) return;
  const size_t size = block.count * stride_;
  if (BlockChecksum(block.first, block.bytes.data(), size) != LoadLe32(&block.bytes[size])) {
    Reject(fmt::format("is damaged: the checksum of its probes {} to {} is wrong", block.first,
                       block.first + block.count - 1));
  }
}

ProbeWriter::ProbeWriter(const std::string& path, const std::string& name,
                         const ProbeFileHeader& header)
    : file_(path, name),
      packed_file_(true),
      encoding_(EncodingOfFormat(header.format)),
      stride_(encoding_.bytes),
      bytes_written_(kProbeFileHeaderBytes) {
  const ProbeFileHeaderBytes bytes = WriteProbeFileHeader(header);
  file_.Write(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

ProbeWriter::ProbeWriter(const std::string& path, const std::string& name,
                         const ProbeEncoding& encoding, size_t stride)
    : file_(path, name),
      packed_file_(false),
      encoding_(encoding),
      stride_(StrideOf(name, encoding, stride)) {}

void ProbeWriter::Prepare(uint64_t first, size_t count, ProbeBlock& block) const {
  block.first = first;
  block.count = count;
  block.bytes.assign(count * stride_ + (packed_file_ ? kChecksumBytes : 0), 0);
}

void ProbeWriter::Seal(ProbeBlock& block) const {
  if (!packed_file_) return;
  const size_t size = block.count * stride_;
  StoreLe32(BlockChecksum(block.first, block.bytes.data(), size), &block.bytes[size]);
}

void ProbeWriter::Write(const ProbeBlock& block) {
  file_.Write(reinterpret_cast<const char*>(block.bytes.data()), block.bytes.size());
  bytes_written_ += block.bytes.size();
}

void ProbeWriter::Close() { file_.Close(); }

}  // namespace gaunt::tool
