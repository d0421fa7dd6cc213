// SPDX-License-Identifier: MIT
// Any bytes as a file of packed probes: it is read whole, and is then what a writer writes, or is
// rejected by one line that names it.
#include <sys/mman.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "bad_input.h"
#include "tests/fuzz/support.h"
#include "volume/probe_file.h"
#include "volume/probe_stream.h"

using namespace gaunt::fuzz;
using namespace gaunt::tool;

namespace {

// A file without a name, opened by the path that the system has for it.
class File {
 public:
  File() : file_(memfd_create("fuzz", 0)), path_("/proc/self/fd/" + std::to_string(file_)) {}
  const std::string& path() const { return path_; }
  void Write(const std::vector<uint8_t>& bytes) const {
    GAUNT_FUZZ_CHECK(ftruncate(file_, 0) == 0);
    GAUNT_FUZZ_CHECK(pwrite(file_, bytes.data(), bytes.size(), 0) ==
                     static_cast<ssize_t>(bytes.size()));
  }

 private:
  int file_;
  std::string path_;
};

// No mutation finds checksums: those that there is room for are made right.
void MakeChecksums(std::vector<uint8_t>& bytes, uint32_t record_bytes) {
  if (bytes.size() < kProbeFileHeaderBytes) return;
  ProbeFileHeader header;
  header.record_bytes = LoadLe32(&bytes[16]);
  header.count = LoadLe32(&bytes[32]) | uint64_t{LoadLe32(&bytes[36])} << 32;
  for (size_t axis = 0; axis < 3; ++axis) {
    header.grid.size[axis] = LoadLe32(&bytes[20 + 4 * axis]);
    std::memcpy(&header.grid.origin[axis], &bytes[40 + 4 * axis], sizeof(float));
    std::memcpy(&header.grid.spacing[axis], &bytes[52 + 4 * axis], sizeof(float));
  }
  header.format = LoadLe32(&bytes[12]);
  const ProbeFileHeaderBytes written = WriteProbeFileHeader(header);
  std::copy(written.begin(), written.end(), bytes.begin());
  size_t at = kProbeFileHeaderBytes;
  for (uint64_t first = 0; first < header.count && record_bytes > 0; first += kBlockProbes) {
    const size_t size = std::min<uint64_t>(kBlockProbes, header.count - first) * record_bytes;
    if (bytes.size() - at < size + kChecksumBytes) return;
    StoreLe32(BlockChecksum(first, &bytes[at], size), &bytes[at + size]);
    at += size + kChecksumBytes;
  }
}

void ReadAll(const std::string& path, const std::vector<uint8_t>& bytes) {
  ProbeReader reader(path);
  const ProbeEncoding encoding = reader.encoding();
  ProbeBlock block;
  size_t at = kProbeFileHeaderBytes;
  uint64_t count = 0;
  std::vector<float> floats;
  while (reader.Read(block)) {
    reader.Verify(block);
    GAUNT_FUZZ_CHECK(block.first == count);
    GAUNT_FUZZ_CHECK(block.bytes.size() <= bytes.size() - at);
    GAUNT_FUZZ_CHECK(std::equal(block.bytes.begin(), block.bytes.end(), &bytes[at]));
    at += block.bytes.size();
    count += block.count;
    floats.resize(block.count * encoding.planes());
    gaunt_view view;
    gaunt_view_interleaved(floats.data(), encoding.planes(), &view);
    GAUNT_FUZZ_CHECK(gaunt_probe_decode(encoding.format, block.count, block.bytes.data(),
                                        encoding.bytes, &view) == GAUNT_OK);
  }
  GAUNT_FUZZ_CHECK(at == bytes.size());
  GAUNT_FUZZ_CHECK(count == reader.count());
  const ProbeFileHeaderBytes header = WriteProbeFileHeader(
      {encoding.format, static_cast<uint32_t>(encoding.bytes), count, reader.grid()});
  GAUNT_FUZZ_CHECK(std::equal(header.begin(), header.end(), bytes.begin()));
}

void CheckRejection(const BadInput& error, const std::string& path) {
  const std::string message = error.what();
  GAUNT_FUZZ_CHECK(message.rfind(path + ": ", 0) == 0);
  GAUNT_FUZZ_CHECK(message.find('\n') == std::string::npos);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const File file;
  FuzzedDataProvider input(data, size);
  const bool make_checksums = input.ConsumeBool(), make_records = input.ConsumeBool();
  const Format format = ConsumeFormat(input);
  const auto count = input.ConsumeIntegralInRange<uint32_t>(0, 3 * kMaxCount);
  std::vector<uint8_t> bytes = input.ConsumeRemainingBytes<uint8_t>();
  if (make_records && bytes.size() >= kProbeFileHeaderBytes) {
    // A header that fits, but for the grid, and records of 0 behind those of the input.
    StoreLe32(format.id, &bytes[12]);
    StoreLe32(static_cast<uint32_t>(format.bytes), &bytes[16]);
    StoreLe32(count, &bytes[32]);
    StoreLe32(0, &bytes[36]);
    if (make_checksums) bytes.resize(kProbeFileHeaderBytes + count * format.bytes + kChecksumBytes);
  }
  if (make_checksums) {
    const uint32_t record_bytes = bytes.size() < 20 ? 0 : LoadLe32(&bytes[16]);
    MakeChecksums(bytes, std::min<uint32_t>(record_bytes, 4096));
  }
  file.Write(bytes);
  try {
    ReadAll(file.path(), bytes);
  } catch (const BadInput& error) {
    CheckRejection(error, file.path());
  }
  return 0;
}
