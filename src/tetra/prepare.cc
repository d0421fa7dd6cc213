// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "tetra/tetra.h"

namespace gaunt::tetra {
namespace {

constexpr uint32_t kMagic = 0x54654167u, kVersion = 1;
// Flatter than that, barycentrics in floats mean nothing.
constexpr double kMaxAspect = 1e5;
// Beyond this a barycentric may overflow.
constexpr double kMaxSlope = 1e15;

Header HeaderOf(uint32_t vertices, uint32_t tetrahedra) {
  const double across = std::cbrt(static_cast<double>(tetrahedra));
  return {kMagic, kVersion, vertices, tetrahedra, 64 + 8 * static_cast<uint32_t>(across), {}};
}

Vertex LoadVertex(const simd::InView& positions, size_t i) {
  Vertex vertex;
  for (size_t a = 0; a < 3; ++a) {
    std::memcpy(&vertex.at[a],
                positions.Item(i) + static_cast<ptrdiff_t>(a) * positions.plane_stride,
                sizeof(float));
  }
  return vertex;
}

// A face of a tetrahedron, in the memory of the records before they are written: 16 bytes each.
struct Face {
  unsigned char bytes[16];

  struct Fields {
    uint32_t corners[3];  // rising
    uint32_t side;        // 4 tetrahedron + the corner that lies opposite
  };
  Fields Load() const {
    Fields fields;
    std::memcpy(&fields, bytes, sizeof(fields));
    return fields;
  }
};
static_assert(kCorners * sizeof(Face) == sizeof(Record), "faces fill the records");

bool SameCorners(const Face::Fields& a, const Face::Fields& b) {
  return std::equal(a.corners, a.corners + 3, b.corners);
}

bool operator<(const Face& a, const Face& b) {
  const Face::Fields x = a.Load(), y = b.Load();
  for (int k = 0; k < 3; ++k) {
    if (x.corners[k] != y.corners[k]) return x.corners[k] < y.corners[k];
  }
  return x.side < y.side;
}

// Fills neighbours[side] of every face. `faces` is memory for all of them.
void FindNeighbours(uint32_t tetrahedra, const uint32_t* corners, Face* faces,
                    unsigned char* neighbours) {
  const size_t count = size_t{tetrahedra} * kCorners;
  for (size_t side = 0; side < count; ++side) {
    const uint32_t* const own = corners + side / kCorners * kCorners;
    const size_t opposite = side % kCorners;
    Face::Fields fields;
    for (size_t k = 0; k < 3; ++k) fields.corners[k] = own[k + (k >= opposite ? 1 : 0)];
    std::sort(fields.corners, fields.corners + 3);
    fields.side = static_cast<uint32_t>(side);
    std::memcpy(faces[side].bytes, &fields, sizeof(fields));
  }
  std::sort(faces, faces + count);
  const auto set = [&](uint32_t side, uint32_t neighbour) {
    std::memcpy(neighbours + size_t{side} * sizeof(neighbour), &neighbour, sizeof(neighbour));
  };
  for (size_t i = 0; i < count;) {
    const Face::Fields one = faces[i].Load();
    if (i + 1 < count && SameCorners(one, faces[i + 1].Load())) {
      const uint32_t other = faces[i + 1].Load().side;
      set(one.side, other / kCorners);
      set(other, one.side / kCorners);
      i += 2;
    } else {
      set(one.side, kNone);
      ++i;
    }
  }
}

struct Vector {
  double x, y, z;
};
Vector Between(const Vertex& from, const Vertex& to) {
  return {double{to.at[0]} - double{from.at[0]}, double{to.at[1]} - double{from.at[1]},
          double{to.at[2]} - double{from.at[2]}};
}
Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double Dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double Length(const Vector& a) { return std::sqrt(Dot(a, a)); }

// The record but for its neighbours.
Record RecordOf(const Vertex (&v)[kCorners]) {
  const Vector edges[3] = {Between(v[3], v[0]), Between(v[3], v[1]), Between(v[3], v[2])};
  const Vector normals[3] = {Cross(edges[1], edges[2]), Cross(edges[2], edges[0]),
                             Cross(edges[0], edges[1])};
  const Vector last = {-normals[0].x - normals[1].x - normals[2].x,
                       -normals[0].y - normals[1].y - normals[2].y,
                       -normals[0].z - normals[1].z - normals[2].z};
  const double volume = Dot(edges[0], normals[0]);
  double longest = 0.0;
  for (int i = 0; i < kCorners; ++i) {
    for (int j = 0; j < i; ++j) longest = std::max(longest, Length(Between(v[i], v[j])));
  }
  // One over the least height.
  const double steepest =
      std::max({Length(normals[0]), Length(normals[1]), Length(normals[2]), Length(last)}) /
      std::abs(volume);
  const bool is_flat = !(steepest * longest <= kMaxAspect) || !(steepest <= kMaxSlope);
  Record record;
  for (int i = 0; i < 3; ++i) {
    const double row[3] = {normals[i].x / volume, normals[i].y / volume, normals[i].z / volume};
    for (int a = 0; a < 3; ++a) {
      record.rows[i][a] =
          is_flat ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(row[a]);
    }
    record.corner[i] = v[3].at[i];
  }
  return record;
}

}  // namespace

size_t SizeOf(uint32_t vertices, uint32_t tetrahedra) {
  const uint64_t size = sizeof(Header) + uint64_t{tetrahedra} * (sizeof(Record) + sizeof(Corners)) +
                        uint64_t{vertices} * sizeof(Vertex);
  return size > SIZE_MAX / 8 ? 0 : static_cast<size_t>(size);
}

bool FindMesh(const void* bytes, size_t size, Mesh* mesh) {
  Header header;
  if (size < sizeof(header)) return false;
  std::memcpy(&header, bytes, sizeof(header));
  const Header wanted = HeaderOf(header.vertices, header.tetrahedra);
  if (std::memcmp(&header, &wanted, sizeof(header)) != 0 || header.tetrahedra == 0 ||
      header.vertices == 0 || size != SizeOf(header.vertices, header.tetrahedra)) {
    return false;
  }
  mesh->records = static_cast<const uint8_t*>(bytes) + sizeof(Header);
  mesh->corners = mesh->records + size_t{header.tetrahedra} * sizeof(Record);
  mesh->vertices = mesh->corners + size_t{header.tetrahedra} * sizeof(Corners);
  mesh->tetrahedra = header.tetrahedra;
  mesh->last_vertex = header.vertices - 1;
  mesh->step_limit = header.step_limit;
  return true;
}

bool IsSound(uint32_t vertices, const simd::InView& positions, uint32_t tetrahedra,
             const uint32_t* corners, const uint32_t* neighbours) {
  const size_t sides = size_t{tetrahedra} * kCorners;
  for (size_t i = 0; i < sides; ++i) {
    if (corners[i] >= vertices) return false;
    if (neighbours == nullptr || neighbours[i] == kNone) continue;
    // Walks would end at its own face, as if they were inside.
    const bool is_own = neighbours[i] == i / kCorners;
    if (neighbours[i] >= tetrahedra || is_own) return false;
  }
  for (size_t i = 0; i < vertices; ++i) {
    const Vertex vertex = LoadVertex(positions, i);
    for (const float x : vertex.at) {
      if (!(std::abs(double{x}) <= kFarthest)) return false;
    }
  }
  return true;
}

void Prepare(uint32_t vertices, const simd::InView& positions, uint32_t tetrahedra,
             const uint32_t* corners, const uint32_t* neighbours, void* bytes) {
  const Header header = HeaderOf(vertices, tetrahedra);
  unsigned char* const records = static_cast<unsigned char*>(bytes) + sizeof(Header);
  unsigned char* const corner_bytes = records + size_t{tetrahedra} * sizeof(Record);
  unsigned char* const vertex_bytes = corner_bytes + size_t{tetrahedra} * sizeof(Corners);
  std::memcpy(bytes, &header, sizeof(header));
  // Neighbours wait where corners go.
  if (neighbours == nullptr) {
    FindNeighbours(tetrahedra, corners, reinterpret_cast<Face*>(records), corner_bytes);
  } else {
    std::memcpy(corner_bytes, neighbours, size_t{tetrahedra} * sizeof(Corners));
  }
  for (size_t t = 0; t < tetrahedra; ++t) {
    Corners own;
    std::memcpy(&own, corners + t * kCorners, sizeof(own));
    Vertex v[kCorners];
    for (int i = 0; i < kCorners; ++i) v[i] = LoadVertex(positions, own.vertices[i]);
    Record record = RecordOf(v);
    std::memcpy(record.neighbours, corner_bytes + t * sizeof(Corners), sizeof(record.neighbours));
    std::memcpy(records + t * sizeof(Record), &record, sizeof(record));
    std::memcpy(corner_bytes + t * sizeof(Corners), &own, sizeof(own));
  }
  for (size_t i = 0; i < vertices; ++i) {
    const Vertex vertex = LoadVertex(positions, i);
    std::memcpy(vertex_bytes + i * sizeof(Vertex), &vertex, sizeof(vertex));
  }
}

}  // namespace gaunt::tetra
