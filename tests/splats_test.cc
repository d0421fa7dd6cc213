// SPDX-License-Identifier: MIT
// Rotated files of Gaussian splats, against what a renderer of splats makes of them.
#include "splats/splats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bad_input.h"
#include "rotate/rotate_reference.h"
#include "splats/turn.h"
#include "tests/support/folder.h"
#include "tests/support/random.h"

namespace gaunt::test {
namespace {

namespace fs = std::filesystem;
using tool::BadInput;
using tool::Matrix;
using tool::Vector;

const double kPi = std::acos(-1.0);

// ---- what a renderer does, by its definitions

// The real SH of degree 0 to 3 with the Condon-Shortley phase, as polynomials of a unit vector.
std::array<double, 16> SplatBasis(const Vector& d) {
  const auto [x, y, z] = d;
  const auto c = [](double squared) { return std::sqrt(squared / kPi); };
  return {c(1.0 / 4),
          -c(3.0 / 4) * y,
          c(3.0 / 4) * z,
          -c(3.0 / 4) * x,
          c(15.0 / 4) * x * y,
          -c(15.0 / 4) * y * z,
          c(5.0 / 16) * (2 * z * z - x * x - y * y),
          -c(15.0 / 4) * x * z,
          c(15.0 / 16) * (x * x - y * y),
          -c(35.0 / 32) * y * (3 * x * x - y * y),
          c(105.0 / 4) * x * y * z,
          -c(21.0 / 32) * y * (4 * z * z - x * x - y * y),
          c(7.0 / 16) * z * (2 * z * z - 3 * x * x - 3 * y * y),
          -c(21.0 / 32) * x * (4 * z * z - x * x - y * y),
          c(105.0 / 16) * z * (x * x - y * y),
          -c(35.0 / 32) * x * (x * x - 3 * y * y)};
}

Vector Apply(const Matrix& m, const Vector& v) {
  Vector out = {};
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) out[i] += m[3 * i + j] * v[j];
  }
  return out;
}

// A file, and where it has what. Properties of the vertices are floats unless their name says a
// type: "uchar tag".
struct SplatFile {
  std::string header;
  std::string data;
  size_t begin = 0;  // of the vertices in data
  size_t stride = 0;
  size_t count = 0;
  size_t degree = 0;
  std::vector<std::pair<std::string, size_t>> offsets;

  std::string Bytes() const { return header + data; }
  size_t Offset(const std::string& name) const {
    for (const auto& [known, offset] : offsets) {
      if (known == name) return offset;
    }
    ADD_FAILURE() << "no " << name;
    return 0;
  }
  double Get(size_t splat, const std::string& name) const {
    float value;
    std::memcpy(&value, data.data() + begin + splat * stride + Offset(name), sizeof(value));
    return value;
  }
  Vector Get3(size_t splat, const std::string& a, const std::string& b,
              const std::string& c) const {
    return {Get(splat, a), Get(splat, b), Get(splat, c)};
  }
  Vector Position(size_t splat) const { return Get3(splat, "x", "y", "z"); }

  // 0.5 + the sum of f y(d), with d from the camera to the splat.
  Vector Colour(size_t splat, const Vector& camera) const {
    const Vector p = Position(splat);
    Vector d = {p[0] - camera[0], p[1] - camera[1], p[2] - camera[2]};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    for (double& x : d) x /= length;
    const std::array<double, 16> y = SplatBasis(d);
    const size_t rest = (degree + 1) * (degree + 1) - 1;
    Vector colour;
    for (size_t c = 0; c < 3; ++c) {
      colour[c] = 0.5 + Get(splat, "f_dc_" + std::to_string(c)) * y[0];
      for (size_t k = 0; k < rest; ++k) {
        colour[c] += Get(splat, "f_rest_" + std::to_string(c * rest + k)) * y[k + 1];
      }
    }
    return colour;
  }

  // Q S S^T Q^T, as the 3D Gaussian has it.
  Matrix Covariance(size_t splat) const {
    double q[4], length = 0.0;
    for (size_t k = 0; k < 4; ++k) {
      q[k] = Get(splat, "rot_" + std::to_string(k));
      length += q[k] * q[k];
    }
    for (double& part : q) part /= std::sqrt(length);
    const auto [w, x, y, z] = q;
    const double m[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                         2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                         2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    Matrix covariance = {};
    for (size_t k = 0; k < 3; ++k) {
      const double scale = std::exp(Get(splat, "scale_" + std::to_string(k)));
      for (size_t i = 0; i < 3; ++i) {
        for (size_t j = 0; j < 3; ++j) {
          covariance[3 * i + j] += m[3 * i + k] * m[3 * j + k] * scale * scale;
        }
      }
    }
    return covariance;
  }
};

std::vector<std::string> SplatProperties(size_t degree) {
  std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"};
  for (size_t k = 0; k < 3 * ((degree + 1) * (degree + 1) - 1); ++k) {
    names.push_back("f_rest_" + std::to_string(k));
  }
  for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2"}) names.push_back(name);
  for (const char* name : {"rot_0", "rot_1", "rot_2", "rot_3"}) names.push_back(name);
  return names;
}

// Random splats in (-2, 2). What stands before and after the vertices is given as it stands in the
// file.
struct Around {
  std::string elements_before, data_before, elements_after, data_after;
  std::string end_of_line = "\n";
  std::string float_name = "float";
};

SplatFile MakeSplats(size_t degree, size_t count, const std::vector<std::string>& properties,
                     const Around& around = {}) {
  const std::string& eol = around.end_of_line;
  SplatFile file;
  file.degree = degree;
  file.count = count;
  file.header = "ply" + eol + "format binary_little_endian 1.0" + eol + "comment of  mine" + eol +
                around.elements_before + "element vertex " + std::to_string(count) + eol;
  struct Float {
    size_t offset;
    bool is_scale;
  };
  std::vector<Float> floats;
  for (const std::string& property : properties) {
    const size_t space = property.find(' ');
    const bool is_float = space == std::string::npos;
    const std::string type = is_float ? around.float_name : property.substr(0, space);
    const std::string name = is_float ? property : property.substr(space + 1);
    for (const std::string& part : {std::string("property "), type, std::string(" "), name, eol}) {
      file.header += part;
    }
    if (is_float) floats.push_back({file.stride, name.rfind("scale", 0) == 0});
    file.offsets.emplace_back(name, file.stride);
    file.stride += type == "uchar" ? 1 : type == "ushort" ? 2 : type == "double" ? 8 : 4;
  }
  file.header += around.elements_after + "end_header" + eol;
  file.begin = around.data_before.size();
  Random random(17 + count);
  std::string vertices(count * file.stride, '\0');
  for (char& byte : vertices) byte = static_cast<char>(random.Bits());
  for (size_t i = 0; i < count; ++i) {
    for (const Float& one : floats) {
      const float value = random.Between(-2, one.is_scale ? 0 : 2);
      std::memcpy(vertices.data() + i * file.stride + one.offset, &value, sizeof(value));
    }
  }
  file.data = around.data_before + vertices + around.data_after;
  return file;
}

SplatFile MakeSplats(size_t degree, size_t count, const Around& around = {}) {
  return MakeSplats(degree, count, SplatProperties(degree), around);
}

Matrix RandomRotation(Random& random) {
  double q[4];
  for (double& x : q) x = random.Between(-1, 1);
  Matrix m;
  rotate::MatrixReference(q, m.data());
  return m;
}

Matrix Negative(Matrix m) {
  for (double& x : m) x = -x;
  return m;
}

std::vector<Matrix> Turns() {
  Random random(5);
  std::vector<Matrix> turns = {{1, 0, 0, 0, 1, 0, 0, 0, 1},   {-1, 0, 0, 0, 1, 0, 0, 0, 1},
                               {1, 0, 0, 0, -1, 0, 0, 0, 1},  {1, 0, 0, 0, 1, 0, 0, 0, -1},
                               {0, -1, 0, 1, 0, 0, 0, 0, 1},  {0, 0, 1, 1, 0, 0, 0, 1, 0},
                               {-1, 0, 0, 0, -1, 0, 0, 0, -1}};
  for (int k = 0; k < 6; ++k) {
    turns.push_back(RandomRotation(random));
    turns.push_back(Negative(RandomRotation(random)));
  }
  return turns;
}

class Splats : public FolderTest {
 protected:
  void Run(const std::string& bytes, const Matrix& turn) {
    Write(Path("in.ply"), bytes);
    summary_ = tool::RotateSplats(Path("in.ply"), Path("out.ply"), turn, [](double) {});
  }

  // The same file with the data of the output.
  SplatFile Rotated(const SplatFile& before, const Matrix& turn) {
    Run(before.Bytes(), turn);
    const std::string bytes = Read(Path("out.ply"));
    EXPECT_EQ(bytes.size(), before.Bytes().size());
    EXPECT_EQ(bytes.substr(0, before.header.size()), before.header);
    EXPECT_EQ(FilesInFolder(), 2u);
    SplatFile after = before;
    after.data = bytes.substr(before.header.size());
    return after;
  }

  // What the error says, without the file's name; the file leaves nothing behind.
  std::string Rejection(const std::string& bytes) {
    fs::remove(Path("out.ply"));
    try {
      Run(bytes, tool::kIdentity);
    } catch (const BadInput& error) {
      EXPECT_EQ(FilesInFolder(), 1u);
      const std::string message = error.what(), start = Path("in.ply") + ": ";
      EXPECT_EQ(message.rfind(start, 0), 0u) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message.substr(start.size());
    }
    return "accepted";
  }

  tool::SplatSummary summary_ = {};
};

void ExpectSeenAlike(const SplatFile& before, const SplatFile& after, const Matrix& turn,
                     size_t splat, const Vector& camera) {
  const Vector a = before.Colour(splat, camera), b = after.Colour(splat, Apply(turn, camera));
  for (size_t c = 0; c < 3; ++c) {
    ASSERT_NEAR(a[c], b[c], 4e-6) << "degree " << before.degree << ", splat " << splat;
  }
}

void ExpectNear(const Vector& a, const Vector& b, double tolerance) {
  for (size_t k = 0; k < 3; ++k) ASSERT_NEAR(a[k], b[k], tolerance);
}

Vector RandomCamera(Random& random) {
  float d[3];
  random.Direction(d);
  const double distance = 5.0 + 10.0 * random.Uniform();  // outside of all splats
  return {distance * d[0], distance * d[1], distance * d[2]};
}

TEST_F(Splats, ColoursAreThoseSeenFromTheTurnedCamera) {
  Random random(1);
  for (size_t degree = 0; degree <= 3; ++degree) {
    const SplatFile before = MakeSplats(degree, 37);
    for (const Matrix& turn : Turns()) {
      const SplatFile after = Rotated(before, turn);
      ASSERT_EQ(summary_.splats, 37u);
      ASSERT_EQ(summary_.degree, degree);
      ASSERT_EQ(summary_.bytes, before.Bytes().size());
      for (size_t i = 0; i < before.count; ++i) {
        for (int view = 0; view < 4; ++view) {
          ExpectSeenAlike(before, after, turn, i, RandomCamera(random));
        }
      }
    }
  }
}

TEST_F(Splats, ShapesTurn) {
  const SplatFile before = MakeSplats(1, 50);
  for (const Matrix& turn : Turns()) {
    const SplatFile after = Rotated(before, turn);
    for (size_t i = 0; i < before.count; ++i) {
      ExpectNear(after.Position(i), Apply(turn, before.Position(i)), 3e-7);
      ExpectNear(after.Get3(i, "nx", "ny", "nz"), Apply(turn, before.Get3(i, "nx", "ny", "nz")),
                 3e-7);
      const Matrix a = before.Covariance(i), b = after.Covariance(i);
      for (size_t row = 0; row < 3; ++row) {  // M C M^T, a row at a time
        const Vector m = {turn[3 * row], turn[3 * row + 1], turn[3 * row + 2]};
        ExpectNear({b[3 * row], b[3 * row + 1], b[3 * row + 2]}, Apply(turn, Apply(a, m)), 1e-6);
      }
      double length_a = 0.0, length_b = 0.0;
      for (const char* name : {"rot_0", "rot_1", "rot_2", "rot_3"}) {
        length_a += before.Get(i, name) * before.Get(i, name);
        length_b += after.Get(i, name) * after.Get(i, name);
      }
      ASSERT_NEAR(length_b, length_a, 2e-6);
    }
  }
}

TEST_F(Splats, QuarterTurnsAndMirrorsKeepPositionsExactly) {
  const SplatFile before = MakeSplats(0, 100);
  const std::vector<Matrix> exact = {tool::Mirror(0),
                                     tool::Mirror(1),
                                     tool::Mirror(2),
                                     tool::TurnAboutAxis({0, 0, 2}, 90),
                                     tool::TurnAboutAxis({0, -1, 0}, -270),
                                     tool::TurnAboutAxis({3, 0, 0}, 180),
                                     tool::TurnAboutAxis({0, 0, 1}, 36000000090.0),
                                     tool::TurnByQuaternion({0.7, 0, 0.7, 0}),
                                     tool::TurnByQuaternion({3, 3, 3, -3}),
                                     tool::TurnByMatrix({0, 1, 0, 1, 0, 0, 0, 0, -1})};
  for (const Matrix& turn : exact) {
    const SplatFile after = Rotated(before, turn);
    for (size_t i = 0; i < before.count; ++i) {
      Vector a = before.Position(i), b = after.Position(i);
      ASSERT_EQ(Apply(turn, a), b);
      for (size_t k = 0; k < 3; ++k) a[k] = std::abs(a[k]), b[k] = std::abs(b[k]);
      std::sort(a.begin(), a.end());
      std::sort(b.begin(), b.end());
      ASSERT_EQ(a, b);
    }
  }
}

// Zeros with signs, infinities, and what is no number, quiet or signalling.
TEST_F(Splats, MirrorsKeepPositionsToTheBit) {
  constexpr uint32_t kSign = uint32_t{1} << 31;
  const uint32_t special[] = {0,          kSign,      1,          0x80012345,
                              0x7f800000, 0xff800000, 0x7f800001, 0xffc00077};
  SplatFile before = MakeSplats(0, 512);
  for (size_t i = 0; i < before.count; ++i) {
    const uint32_t vector[] = {special[i % 8], special[i / 8 % 8], special[i / 64]};
    for (const char* first : {"x", "nx", "rot_1"}) {
      char* splat = before.data.data() + i * before.stride;
      std::memcpy(splat + before.Offset(first), vector, sizeof(vector));
    }
  }
  const auto bits = [](const SplatFile& file, size_t splat, const char* first, size_t component) {
    uint32_t value;
    const char* begin = file.data.data() + splat * file.stride + file.Offset(first);
    std::memcpy(&value, begin + sizeof(value) * component, sizeof(value));
    return value;
  };
  EXPECT_TRUE(Rotated(before, tool::kIdentity).data == before.data);
  const SplatFile turned = Rotated(before, tool::TurnAboutAxis({0, 0, 1}, 90));
  for (const char* first : {"x", "nx"}) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const SplatFile mirrored = Rotated(before, tool::Mirror(axis));
      for (size_t i = 0; i < before.count; ++i) {
        for (size_t k = 0; k < 3; ++k) {
          ASSERT_EQ(bits(mirrored, i, first, k),
                    bits(before, i, first, k) ^ (k == axis ? kSign : 0));
        }
      }
    }
    for (size_t i = 0; i < before.count; ++i) {
      ASSERT_EQ(bits(turned, i, first, 0), bits(before, i, first, 1) ^ kSign);
      ASSERT_EQ(bits(turned, i, first, 1), bits(before, i, first, 0));
      ASSERT_EQ(bits(turned, i, first, 2), bits(before, i, first, 2));
    }
  }
}

// Whether a rotation may change a property.
bool Turns(const std::string& name) {
  for (const char* start : {"f_rest_", "rot_"}) {
    if (name.rfind(start, 0) == 0) return true;
  }
  for (const char* vector : {"x", "y", "z", "nx", "ny", "nz"}) {
    if (name == vector) return true;
  }
  return false;
}

TEST_F(Splats, AllElseStaysBitForBit) {
  std::vector<std::string> properties = SplatProperties(2);
  std::reverse(properties.begin(), properties.end());
  properties.insert(properties.begin(), "uchar tag");
  properties.insert(properties.begin() + 7, "double time");
  properties.insert(properties.begin() + 20, "ushort label");
  properties.push_back("uchar last");
  const Around around = {"obj_info \t\x80 \r\nelement none 7\nelement chunk 3\nproperty int8 a\n",
                         "abc",
                         "element face 2\nproperty list uchar int vertex_indices\n",
                         std::string("\0\2\xff\r\n \0\1\2\3", 10),
                         "\n",
                         "float32"};
  const SplatFile before = MakeSplats(2, 333, properties, around);
  ASSERT_EQ(before.stride % 4, 0u);
  properties.push_back("uchar odd");
  for (const SplatFile& file : {before, MakeSplats(2, 333, properties, around)}) {
    const Matrix turn = Turns().back();
    const SplatFile after = Rotated(file, turn);
    Random random(2);
    std::string restored = after.data;
    for (size_t i = 0; i < file.count; ++i) {
      ExpectSeenAlike(file, after, turn, i, RandomCamera(random));
      for (const auto& [name, offset] : file.offsets) {
        if (!Turns(name)) continue;
        const size_t at = file.begin + i * file.stride + offset;
        restored.replace(at, 4, file.data, at, 4);
      }
    }
    EXPECT_TRUE(restored == file.data);
  }
}

TEST_F(Splats, NormalsMayBeMissingAndLinesMayEndInReturns) {
  std::vector<std::string> properties = SplatProperties(1);
  properties.erase(properties.begin() + 3, properties.begin() + 6);
  Around around;
  around.end_of_line = "\r\n";
  const SplatFile before = MakeSplats(1, 5, properties, around);
  const Matrix turn = Turns().back();
  const SplatFile after = Rotated(before, turn);
  for (size_t i = 0; i < before.count; ++i) {
    ExpectSeenAlike(before, after, turn, i, {9, 8, 7});
  }
}

TEST_F(Splats, AnyNumberOfSplats) {
  const Matrix turn = Turns().back();
  const auto test = [&](const SplatFile& before) {
    const SplatFile after = Rotated(before, turn);
    for (size_t i = 0; i < before.count; ++i) {
      ExpectSeenAlike(before, after, turn, i, {4, -6, 5});
      if (HasFatalFailure()) return;
    }
  };
  constexpr size_t kChunk = tool::kChunkSplats;
  for (const size_t count : {size_t{0}, size_t{1}, size_t{15}, size_t{16}, size_t{17}, kChunk - 1,
                             kChunk, kChunk + 1, 2 * kChunk, 2 * kChunk + 17}) {
    test(MakeSplats(1, count));
  }
  // Records so large that a chunk has few.
  std::vector<std::string> properties = SplatProperties(1);
  for (int k = 0; k < 5000; ++k) properties.push_back("double more_" + std::to_string(k));
  test(MakeSplats(1, 250, properties));
}

// So many that the library prepares the rotation, in a chunk and in what is left.
TEST_F(Splats, ColoursOfManySplats) {
  Random random(6);
  const SplatFile before = MakeSplats(3, tool::kChunkSplats + 300);
  const std::vector<Matrix> turns = Turns();
  for (size_t k = 0; k < turns.size(); k += 2) {
    const SplatFile after = Rotated(before, turns[k]);
    for (size_t i = 0; i < before.count; ++i) {
      ExpectSeenAlike(before, after, turns[k], i, RandomCamera(random));
      if (HasFatalFailure()) return;
    }
  }
}

TEST_F(Splats, OutputMayBeTheInput) {
  const SplatFile before = MakeSplats(1, 9);
  const Matrix turn = Turns().back();
  const SplatFile after = Rotated(before, turn);
  tool::RotateSplats(Path("in.ply"), Path("in.ply"), turn, [](double) {});
  EXPECT_EQ(Read(Path("in.ply")), after.Bytes());
}

TEST_F(Splats, ProgressRisesToAllInEveryElement) {
  const auto count_calls = [&](const SplatFile& file) {
    double last = 0.0;
    int calls = 0;
    Write(Path("in.ply"), file.Bytes());
    tool::RotateSplats(Path("in.ply"), Path("out.ply"), tool::kIdentity, [&](double share) {
      EXPECT_GT(share, last);
      last = share;
      ++calls;
    });
    EXPECT_EQ(last, 1.0);
    return calls;
  };
  EXPECT_EQ(count_calls(MakeSplats(0, 0)), 1);
  EXPECT_EQ(count_calls(MakeSplats(0, 3 * tool::kChunkSplats)), 3);
  Around around;
  around.elements_after = "element point 20000000\nproperty uchar a\n";
  around.data_after.resize(20000000);
  EXPECT_GT(count_calls(MakeSplats(0, 1, around)), 3);
  around.elements_after = "element face 100000\nproperty list uchar int a\n";
  around.data_after.resize(100000);
  EXPECT_GT(count_calls(MakeSplats(0, 1, around)), 500);
}

// Lists of all types of lengths and entries, before and after the splats.
TEST_F(Splats, ListsAreCopied) {
  Around around;
  around.elements_before =
      "element none 0\nproperty list uint double a\n"
      "element face 2\nproperty short a\nproperty list int8 float64 b\n"
      "property list ushort uchar c\n";
  around.data_before = std::string("sh\1doubled!\3\0abc", 16) + std::string("SH\0\0\0", 5);
  around.elements_after =
      "element strip 1\nproperty list int ushort a\nproperty list uint int8 b\n";
  around.data_after =
      std::string("\0\0\2\0", 4) + std::string(1 << 18, 'x') + std::string("\1\0\0\0y", 5);
  const SplatFile before = MakeSplats(1, 20, around);
  const Matrix turn = Turns().back();
  const SplatFile after = Rotated(before, turn);
  const size_t end = before.begin + before.count * before.stride;
  EXPECT_EQ(after.data.substr(0, before.begin), around.data_before);
  EXPECT_TRUE(after.data.substr(end) == around.data_after);
  for (size_t i = 0; i < before.count; ++i) ExpectSeenAlike(before, after, turn, i, {9, 8, 7});
}

TEST_F(Splats, RejectsBrokenLists) {
  const auto rejection = [&](const std::string& type, const std::string& data) {
    Around around;
    around.elements_after =
        "element face 2\nproperty list " + type + " ushort a\nproperty uchar b\n";
    around.data_after = data;
    return Rejection(MakeSplats(0, 1, around).Bytes());
  };
  const std::string good =
      "\2"
      "abcd!\1ab!";
  EXPECT_EQ(rejection("uchar", good), "accepted");
  EXPECT_EQ(rejection("char", good), "accepted");
  EXPECT_EQ(rejection("uchar", good + "x"), "has bytes after its last element");
  for (size_t size = 0; size < good.size(); ++size) {
    EXPECT_EQ(rejection("uchar", good.substr(0, size)), size < 6
                                                            ? "has 0 of 2 items of element 'face'"
                                                            : "has 1 of 2 items of element 'face'");
  }
  EXPECT_EQ(rejection("uint", "\xff\xff\xff\xff" + good), "has 0 of 2 items of element 'face'");
  for (const char* type : {"int8", "short", "int32"}) {
    EXPECT_EQ(rejection(type, "\xff\xff\xff\xff" + good),
              "element 'face' has a list of a negative length, in item 0");
  }
  EXPECT_EQ(rejection("int8", good.substr(0, 6) + "\x80"),
            "element 'face' has a list of a negative length, in item 1");
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(Splats, RejectsWrongHeaders) {
  const std::string good = MakeSplats(1, 2).Bytes();
  EXPECT_EQ(Rejection(good), "accepted");
  struct {
    const char *from, *to, *message;
  } const cases[] = {
      {"ply", "plx", "is not a PLY file"},
      {"ply\n", "ply2\n", "is not a PLY file"},
      {"binary_little", "binary_big",
       "line 2: the format is 'binary_big_endian 1.0', but must be binary_little_endian 1.0"},
      {"binary_little_endian", "ascii",
       "line 2: the format is 'ascii 1.0', but must be binary_little_endian 1.0"},
      {"1.0", "2.0",
       "line 2: the format is 'binary_little_endian 2.0', but must be binary_little_endian 1.0"},
      {" binary_little_endian 1.0", "",
       "line 2: the format is '', but must be binary_little_endian 1.0"},
      {"format", "comment", "has no line that says the format"},
      {"comment of  mine", "format binary_little_endian 1.0", "line 3: a second format"},
      {"comment", "remark", "line 3: 'remark of  mine' belongs in no PLY header"},
      {"comment of  mine", "", "line 3: '' belongs in no PLY header"},
      {"comment", "\x1b\xff", "line 3: '?? of  mine' belongs in no PLY header"},
      {"comment of  mine", "property float x", "line 3: a property of no element"},
      {"element vertex 2", "element vertex", "line 4: an element has a name and a count"},
      {"element vertex 2", "element vertex -2", "line 4: '-2' is no count"},
      {"element vertex 2", "element vertex 2.5", "line 4: '2.5' is no count"},
      {"element vertex 2", "element vertex 0x2", "line 4: '0x2' is no count"},
      {"vertex 2", "vertex 99999999999999999999", "line 4: '99999999999999999999' is too many"},
      {"vertex 2", "vertex 9999999999999999999",
       "cannot have 9999999999999999999 items of element 'vertex'"},
      {"vertex 2", "vertex 3", "has 2 of 3 splats"},
      {"vertex 2", "vertex 1", "has bytes after its last element"},
      {"vertex 2", "points 2", "has no element 'vertex'"},
      {"end_header", "element vertex 2\nend_header", "line 31: a second element 'vertex'"},
      {"property float x", "property x", "line 5: a property has a type and a name"},
      {"property float x", "property list uchar x", "line 5: a property has a type and a name"},
      {"property float x", "property half x", "line 5: 'half' is no type"},
      {"property float x", "property list uchar half x", "line 5: 'half' is no type"},
      {"property float x", "property float y", "line 6: a second property 'y'"},
      {"property float x", "property list uchar float x", "splats with lists cannot be rotated"},
      {"property float x", "property list float float x",
       "line 5: a list cannot have its length as float"},
      {"property float x", "property list float64 float x",
       "line 5: a list cannot have its length as float64"},
      {"end_header", "element a 2\nproperty list uchar int b\nend_header",
       "has 0 of 2 items of element 'a'"},
      {"element vertex", "element a 999999999\nproperty int b\nelement vertex",
       "has 52 of 999999999 items of element 'a'"},
      {"end_header", "element a 5\nproperty int b\nend_header", "has 0 of 5 items of element 'a'"},
      {"float x", "float w", "splats have no property x"},
      {"float f_dc_1", "float f_dc_3", "splats have no property f_dc_1"},
      {"float rot_3", "float rot_4", "splats have no property rot_3"},
      {"float nz", "float nw", "splats have no property nz"},
      {"float z", "double z", "property z is double, but must be float"},
      {"float rot_0", "int rot_0", "property rot_0 is int, but must be float"},
      {"float f_rest_4", "uint f_rest_4", "property f_rest_4 is uint, but must be float"},
      {"float nx", "int nx", "property nx is int, but must be float"},
      {"f_rest_4", "f_most_4", "has 8 properties f_rest_*, but splats have 0, 9, 24 or 45"},
      {"f_rest_4", "f_rest_9", "splats have no property f_rest_4"},
      {"f_rest_4", "f_rest_04", "splats have no property f_rest_4"},
  };
  for (const auto& one : cases) {
    EXPECT_EQ(Rejection(Replaced(good, one.from, one.to)), one.message) << one.from << one.to;
  }
  EXPECT_EQ(Rejection(""), "is not a PLY file");
  EXPECT_EQ(Rejection(MakeSplats(4, 1).Bytes()),
            "has 72 properties f_rest_*, but splats have 0, 9, 24 or 45");
  EXPECT_EQ(Rejection(Replaced(good, "mine", std::string(1 << 20, 'x'))),
            "has a header of more than 1048576 bytes");
  EXPECT_EQ(Rejection(Replaced(good, "comment", std::string(50, 'x'))),
            "line 3: '" + std::string(40, 'x') + "...' belongs in no PLY header");
}

TEST_F(Splats, RejectsEveryTruncation) {
  Around around;
  around.elements_after = "element camera 1\nproperty double x\n";
  around.data_after = "12345678";
  const SplatFile file = MakeSplats(1, 3, around);
  const std::string good = file.Bytes();
  EXPECT_EQ(Rejection(good), "accepted");
  EXPECT_EQ(Rejection(good + "x"), "has bytes after its last element");
  for (size_t size = 0; size < good.size(); ++size) {
    const std::string message = Rejection(good.substr(0, size));
    if (size < 4) {
      ASSERT_TRUE(message == "is not a PLY file" || message == "ends in its header") << size;
    } else if (size < file.header.size()) {
      ASSERT_EQ(message, "ends in its header");
    } else if (size < good.size() - 8) {
      ASSERT_EQ(message, "has " + std::to_string((size - file.header.size()) / file.stride) +
                             " of 3 splats");
    } else {
      ASSERT_EQ(message, "has 0 of 1 items of element 'camera'");
    }
  }
}

// Whatever is done to a file, it is rotated whole or rejected in one line.
TEST_F(Splats, SurvivesMutations) {
  Around around;
  around.elements_before = "element chunk 2\nproperty ushort a\n";
  around.data_before = "1234";
  around.elements_after = "element face 1\nproperty list uchar int vertex_indices\n";
  around.data_after = "\1abcd";
  const std::string good = MakeSplats(1, 3, around).Bytes();
  const size_t header = good.find("end_header\n") + 11;
  const std::string words[] = {"element", "property", "list",       "float",
                               "vertex",  "f_rest_9", "comment",    "end_header",
                               "format",  "double",   "x",          "\n",
                               " ",       "\r",       "4294967296", "18446744073709551615",
                               "-1",      "0",        "\t",         std::string(1, '\0')};
  Random random(7);
  const auto below = [&](size_t n) { return static_cast<size_t>(random.Bits() % n); };
  int accepted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string bytes = good;
    for (size_t edits = 1 + below(3); edits > 0; --edits) {
      const size_t at = below(std::min(header, bytes.size()));
      const size_t length = below(std::min<size_t>(40, bytes.size() - at));
      switch (below(6)) {
        case 0: bytes[at] = static_cast<char>(random.Bits()); break;
        case 1: bytes[at] ^= static_cast<char>(1 << below(8)); break;
        case 2: bytes.erase(at, length); break;
        case 3: bytes.insert(below(header), bytes.substr(at, length)); break;
        case 4: bytes.insert(at, words[below(std::size(words))]); break;
        default: bytes.replace(at, length, words[below(std::size(words))]);
      }
      if (bytes.empty()) bytes = "p";
    }
    const std::string message = Rejection(bytes);
    if (message != "accepted") continue;
    ++accepted;
    ASSERT_EQ(fs::file_size(Path("out.ply")), bytes.size());
  }
  // Changes of comments and names at least are harmless.
  EXPECT_GT(accepted, 200);
  EXPECT_LT(accepted, 16000);
}

TEST_F(Splats, RejectsFilesThatCannotBeReadOrWritten) {
  const auto run = [&](const std::string& in, const std::string& out) {
    tool::RotateSplats(in, out, tool::kIdentity, [](double) {});
  };
  Write(Path("in.ply"), MakeSplats(0, 1).Bytes());
  EXPECT_THROW(run(Path("missing.ply"), Path("out.ply")), BadInput);
  EXPECT_THROW(run(folder_.string(), Path("out.ply")), BadInput);
  EXPECT_THROW(run(Path("in.ply"), folder_.string()), BadInput);
  EXPECT_THROW(run(Path("in.ply"), Path("nowhere/out.ply")), BadInput);
  EXPECT_THROW(run(Path("in.ply"), ""), BadInput);
  EXPECT_EQ(FilesInFolder(), 1u);
  const std::string longest = Path(std::string(251, 'n') + ".ply");
  run(Path("in.ply"), longest);
  EXPECT_TRUE(Read(longest) == Read(Path("in.ply")));
  if (fs::exists("/dev/full")) {
    try {
      run(Path("in.ply"), "/dev/full");
      ADD_FAILURE() << "wrote to a full device";
    } catch (const BadInput& error) {
      ADD_FAILURE() << error.what();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
  }
}

void ExpectNear(const Matrix& a, const Matrix& b, double tolerance) {
  for (size_t k = 0; k < 9; ++k) ASSERT_NEAR(a[k], b[k], tolerance) << "entry " << k;
}

TEST(Turn, QuaternionsAndAxesMatchTheDefinition) {
  Random random(3);
  for (int trial = 0; trial < 1000; ++trial) {
    double q[4];  // x y z w
    for (double& x : q) x = random.Between(-1, 1);
    Matrix expected;
    rotate::MatrixReference(q, expected.data());
    const double scale = trial % 3 == 0 ? 1e-200 : trial % 3 == 1 ? 1.0 : 1e200;
    ExpectNear(tool::TurnByQuaternion({scale * q[3], scale * q[0], scale * q[1], scale * q[2]}),
               expected, 4e-16 * 4);
    const double half = std::atan2(std::hypot(q[0], q[1], q[2]), q[3]);
    const double turns = static_cast<double>(trial % 7) - 3.0;
    ExpectNear(tool::TurnAboutAxis({q[0], q[1], q[2]}, 360.0 * (half / kPi + turns)), expected,
               1e-13);
    for (const bool mirror : {false, true}) {
      const Matrix turn = mirror ? Negative(expected) : expected;
      EXPECT_EQ(tool::Mirrors(turn), mirror);
      const tool::Quaternion o = tool::Orientation(turn);  // w x y z
      const double back[4] = {o[1], o[2], o[3], o[0]};
      Matrix again;
      rotate::MatrixReference(back, again.data());
      ExpectNear(again, expected, 1e-14);
      EXPECT_NEAR(o[0] * o[0] + o[1] * o[1] + o[2] * o[2] + o[3] * o[3], 1.0, 1e-14);
    }
  }
}

TEST(Turn, MatricesBecomeOrthogonal) {
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const Matrix exact = trial % 2 == 0 ? RandomRotation(random) : Negative(RandomRotation(random));
    Matrix rough = exact;
    for (double& x : rough) x += random.Between(-1e-5, 1e-5);
    const Matrix turn = tool::TurnByMatrix(rough);
    ExpectNear(turn, exact, 3e-5);
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 3; ++j) {
        double dot = 0.0;
        for (size_t k = 0; k < 3; ++k) dot += turn[3 * i + k] * turn[3 * j + k];
        ASSERT_NEAR(dot, i == j ? 1.0 : 0.0, 1e-15);
      }
    }
  }
}

TEST(Turn, RejectsWhatIsNoRotation) {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  EXPECT_THROW(tool::TurnByQuaternion({0, 0, 0, 0}), BadInput);
  EXPECT_THROW(tool::TurnByQuaternion({0, nan, 0, 0}), BadInput);
  EXPECT_THROW(tool::TurnByQuaternion({infinity, 1, 0, 0}), BadInput);
  EXPECT_THROW(tool::TurnAboutAxis({0, 0, 0}, 90), BadInput);
  EXPECT_THROW(tool::TurnAboutAxis({0, -infinity, 0}, 90), BadInput);
  EXPECT_THROW(tool::TurnAboutAxis({0, 0, 1}, nan), BadInput);
  EXPECT_THROW(tool::TurnAboutAxis({0, 0, 1}, infinity), BadInput);
  EXPECT_THROW(tool::TurnByMatrix({1, 0, 0, 0, 1, 0, 0, 0, 1.0001}), BadInput);
  EXPECT_THROW(tool::TurnByMatrix({1, 0, 0, 0, 1, 0, 0, 0, 0}), BadInput);
  EXPECT_THROW(tool::TurnByMatrix({1, 0, 0, 0, nan, 0, 0, 0, 1}), BadInput);
  EXPECT_THROW(tool::TurnByMatrix({1, 0, 0, 0, infinity, 0, 0, 0, 1}), BadInput);
  EXPECT_NO_THROW(tool::TurnByMatrix({1, 0, 0, 0, 1, 0, 0, 0, 1.00004}));
}

}  // namespace
}  // namespace gaunt::test
