// SPDX-License-Identifier: MIT
#include "splats/ply.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>

#include "bad_input.h"

namespace gaunt::tool {
namespace {

// No real header comes near it; it bounds what is kept of a file that is something else.
constexpr size_t kMaxHeaderBytes = size_t{1} << 20;

// 0: no type has this name.
size_t SizeOfType(std::string_view type) {
  constexpr struct {
    std::string_view old_name, new_name;
    size_t size;
  } kTypes[] = {{"char", "int8", 1},     {"uchar", "uint8", 1},   {"short", "int16", 2},
                {"ushort", "uint16", 2}, {"int", "int32", 4},     {"uint", "uint32", 4},
                {"float", "float32", 4}, {"double", "float64", 8}};
  for (const auto& known : kTypes) {
    if (type == known.old_name || type == known.new_name) return known.size;
  }
  return 0;
}

std::vector<std::string_view> Words(std::string_view line) {
  std::vector<std::string_view> words;
  for (size_t end = 0;;) {
    const size_t begin = line.find_first_not_of(" \t", end);
    if (begin == std::string_view::npos) return words;
    end = std::min(line.find_first_of(" \t", begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
}

class Parser {
 public:
  explicit Parser(ByteReader& in) : in_(in) { header_.file = in.path(); }

  PlyHeader Parse() {
    ReadMagic();
    for (;;) {
      const std::string line = ReadLine();
      const std::vector<std::string_view> words = Words(line);
      const std::string_view keyword = words.empty() ? std::string_view() : words[0];
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "end_header" && words.size() == 1) break;
      if (keyword == "format") {
        ParseFormat(words);
      } else if (keyword == "element") {
        ParseElement(words);
      } else if (keyword == "property") {
        ParseProperty(words);
      } else {
        RejectLine(Shown(line) + " belongs in no PLY header");
      }
    }
    if (!has_format_) header_.Reject("has no line that says the format");
    CheckSizes();
    return std::move(header_);
  }

 private:
  // By itself: what is no PLY file need not have lines.
  void ReadMagic() {
    constexpr std::string_view kMagic = "ply";
    header_.text.resize(kMagic.size());
    if (in_.Read(header_.text.data(), kMagic.size()) < kMagic.size() || header_.text != kMagic ||
        !ReadLine().empty()) {
      header_.Reject("is not a PLY file");
    }
  }

  // What is left of a line, without its end, a line feed that a carriage return may precede.
  std::string ReadLine() {
    ++line_;
    const size_t begin = header_.text.size();
    for (char c = 0; c != '\n'; header_.text += c) {
      if (header_.text.size() == kMaxHeaderBytes) {
        header_.Reject(fmt::format("has a header of more than {} bytes", kMaxHeaderBytes));
      }
      if (in_.Read(&c, 1) == 0) header_.Reject("ends in its header");
    }
    std::string line = header_.text.substr(begin, header_.text.size() - 1 - begin);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }

  [[noreturn]] void RejectLine(const std::string& why) const {
    header_.Reject(fmt::format("line {}: {}", line_, why));
  }

  void ParseFormat(const std::vector<std::string_view>& words) {
    if (has_format_) RejectLine("a second format");
    if (words.size() != 3 || words[1] != "binary_little_endian" || words[2] != "1.0") {
      const std::string_view format = words.size() > 1 ? words[1] : "";
      const std::string shown =
          words.size() > 2 ? fmt::format("{} {}", format, words[2]) : std::string(format);
      RejectLine("the format is " + Shown(shown) + ", but must be binary_little_endian 1.0");
    }
    has_format_ = true;
  }

  void ParseElement(const std::vector<std::string_view>& words) {
    if (words.size() != 3) RejectLine("an element has a name and a count");
    uint64_t count = 0;
    const char* end = words[2].data() + words[2].size();
    const auto [stop, error] = std::from_chars(words[2].data(), end, count);
    if (error == std::errc::result_out_of_range) RejectLine(Shown(words[2]) + " is too many");
    if (error != std::errc() || stop != end) RejectLine(Shown(words[2]) + " is no count");
    if (!elements_.emplace(words[1]).second) RejectLine("a second element " + Shown(words[1]));
    properties_.clear();
    header_.elements.push_back({std::string(words[1]), count, {}});
  }

  void ParseProperty(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) RejectLine("a property of no element");
    PlyElement& element = header_.elements.back();
    const bool list = words.size() > 1 && words[1] == "list";
    if (words.size() != (list ? 5 : 3)) RejectLine("a property has a type and a name");
    for (size_t k = list ? 2 : 1; k + 1 < words.size(); ++k) {
      if (SizeOfType(words[k]) == 0) RejectLine(Shown(words[k]) + " is no type");
    }
    if (!properties_.emplace(words.back()).second) {
      RejectLine("a second property " + Shown(words.back()));
    }
    PlyProperty property = {std::string(words.back()), list ? "" : std::string(words[1]),
                            element.stride, SizeOfType(words[list ? 3 : 1])};
    if (list) {
      if (IsPlyFloat(words[2]) || SizeOfType(words[2]) > 4) {
        RejectLine("a list cannot have its length as " + std::string(words[2]));
      }
      property.count_bytes = SizeOfType(words[2]);
      property.count_has_sign = words[2][0] != 'u';
      element.has_list = true;
    } else {
      element.stride += property.size;
    }
    element.properties.push_back(std::move(property));
  }

  void CheckSizes() const {
    constexpr auto kMaxBytes = static_cast<uint64_t>(std::numeric_limits<int64_t>::max());
    for (const PlyElement& element : header_.elements) {
      if (!element.has_list && element.stride > 0 && element.count > kMaxBytes / element.stride) {
        header_.Reject(
            fmt::format("cannot have {} items of element {}", element.count, Shown(element.name)));
      }
    }
  }

  ByteReader& in_;
  PlyHeader header_;
  std::set<std::string> elements_, properties_;  // names; those of the last element's properties
  int line_ = 0;
  bool has_format_ = false;
};

}  // namespace

void PlyHeader::Reject(const std::string& why) const { throw BadInput(file + ": " + why); }

PlyHeader ReadPlyHeader(ByteReader& in) { return Parser(in).Parse(); }

bool IsPlyFloat(std::string_view type) { return type == "float" || type == "float32"; }

std::string Shown(std::string_view word) {
  constexpr size_t kShown = 40;
  std::string text(word.substr(0, kShown));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + text + (word.size() > kShown ? "...'" : "'");
}

}  // namespace gaunt::tool
