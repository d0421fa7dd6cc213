// SPDX-License-Identifier: MIT
// The frame job equals the functions that it is made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "frame/frame_reference.h"
#include "gaunt/gaunt.h"
#include "probe/format.h"
#include "probe/probe_reference.h"
#include "tests/support/buffer.h"
#include "tests/support/random.h"
#include "tests/support/targets.h"

namespace gaunt::test {
namespace {

constexpr uint32_t kFormats = probe::kNumFormats;
constexpr size_t kPlanes = 27, kConstants = 28;

gaunt_format_properties PropertiesOf(uint32_t format) {
  gaunt_format_properties properties = {sizeof(properties), 0, 0, 0};
  EXPECT_EQ(gaunt_format_info(format, &properties), GAUNT_OK);
  return properties;
}

// A volume of a format, and objects with their taps.
struct Scene {
  uint32_t format, taps;
  size_t count, probes, stride;
  std::vector<uint8_t> packed;
  std::vector<uint32_t> indices;
  std::vector<float> weights;

  Scene(uint32_t id, size_t objects, uint32_t tap_count, size_t probe_count = 50)
      : format(id),
        taps(tap_count),
        count(objects),
        probes(probe_count),
        stride(PropertiesOf(id).bytes + (id % 2 == 0 ? 5 : 0)),
        packed(probes * stride),
        indices(objects * tap_count),
        weights(objects * tap_count) {
    Random random(id + objects);
    const size_t planes = PropertiesOf(id).planes, size = planes / 3;
    std::vector<float> f(probes * planes);
    for (size_t k = 0; k < f.size(); ++k) {
      f[k] = k % size == 0 ? random.Between(0.5, 1.0) : random.Between(-0.4, 0.4);
    }
    gaunt_view view;
    gaunt_view_interleaved(f.data(), planes, &view);
    EXPECT_EQ(gaunt_probe_encode(id, probes, &view, packed.data(), stride, nullptr), GAUNT_OK);
    for (uint32_t& index : indices) index = static_cast<uint32_t>(random.Bits() % probes);
    for (float& weight : weights) weight = random.Between(0.0, 2.0 / taps);
    for (size_t k = 5; k < indices.size(); k += 11) indices[k] = GAUNT_NO_PROBE;
  }
  uint32_t order() const { return std::min(PropertiesOf(format).order, 3u); }
};

// Every view of the job, in the same layout but for alpha.
struct Views {
  Buffer history, alpha, quaternions, radiance, directions, colours, ambient, constants;

  Views(Layout layout, size_t count)
      : history(layout, count, kPlanes),
        alpha(layout, count, 1),
        quaternions(layout, count, 4),
        radiance(layout, count, kPlanes),
        directions(layout, count, 3),
        colours(layout, count, 3),
        ambient(layout, count, 3),
        constants(layout, count, kConstants) {
    Random random(count);
    for (size_t i = 0; i < count; ++i) {
      for (size_t p = 0; p < kPlanes; ++p) {
        history.Set(i, p, p % 9 == 0 ? random.Between(0.5, 1.0) : random.Between(-0.4, 0.4));
      }
      alpha.Set(i, 0, i % 5 == 0 ? 1.0f : random.Between(0.0, 1.0));
      for (size_t p = 0; p < 4; ++p) {
        quaternions.Set(i, p, i % 3 == 1 ? 0.0f : random.Between(-1.0, 1.0));
      }
    }
  }
  std::vector<Buffer*> Outputs() {
    return {&history, &radiance, &directions, &colours, &ambient, &constants};
  }
};

gaunt_frame_job JobOf(const Scene& scene) {
  gaunt_frame_job job = {};
  job.struct_size = sizeof(job);
  job.taps = scene.taps;
  job.indices = scene.indices.data();
  job.weights = scene.weights.data();
  job.packed = scene.packed.data();
  job.packed_count = scene.probes;
  job.stride = scene.stride;
  return job;
}

gaunt_frame_job JobOf(const Scene& scene, const Views& views) {
  gaunt_frame_job job = JobOf(scene);
  job.history = views.history.view();
  job.alpha = views.alpha.view();
  job.quaternions = views.quaternions.view();
  job.radiance = views.radiance.view();
  job.directions = views.directions.view();
  job.colours = views.colours.view();
  job.ambient = views.ambient.view();
  job.constants = views.constants.view();
  return job;
}

// The same by the functions of the steps, with or without a history and quaternions.
void RunSteps(const Scene& scene, bool lerps, bool rotates, Views* views) {
  const size_t count = scene.count, size = scene.order() * scene.order();
  Buffer gathered(Layout::kTiled, count, 3 * size), now(Layout::kTiled, count, kPlanes);
  ASSERT_EQ(gaunt_probe_gather(scene.format, scene.order(), count, scene.taps, scene.indices.data(),
                               scene.weights.data(), scene.packed.data(), scene.probes,
                               scene.stride, gathered.view()),
            GAUNT_OK);
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      for (size_t k = 0; k < 9; ++k) {
        now.Set(i, 9 * c + k, k < size ? gathered.Get(i, c * size + k) : 0.0f);
      }
    }
  }
  const gaunt_view* f = now.view();
  if (lerps) {
    f = views->history.view();
    ASSERT_EQ(gaunt_sh_blend(3, 3, count, f, now.view(), views->alpha.view(), f), GAUNT_OK);
  }
  if (rotates) {
    ASSERT_EQ(gaunt_rotate(3, 3, count, views->quaternions.view(), f, views->radiance.view()),
              GAUNT_OK);
  } else {
    for (size_t i = 0; i < count; ++i) {
      for (size_t p = 0; p < kPlanes; ++p) {
        views->radiance.Set(i, p, lerps ? views->history.Get(i, p) : now.Get(i, p));
      }
    }
  }
  const gaunt_view* r = views->radiance.view();
  ASSERT_EQ(gaunt_light_direction(3, 3, count, r, nullptr, views->directions.view()), GAUNT_OK);
  ASSERT_EQ(gaunt_light_extract(3, 3, 1, GAUNT_SENSE_IRRADIANCE, count, r, views->directions.view(),
                                views->colours.view(), views->ambient.view()),
            GAUNT_OK);
  ASSERT_EQ(gaunt_irradiance_constants(3, count, r, views->constants.view()), GAUNT_OK);
}

bool SameBytes(const Buffer& a, const Buffer& b) {
  return a.memory().size() == b.memory().size() &&
         std::memcmp(a.memory().data(), b.memory().data(), a.memory().size() * sizeof(float)) == 0;
}

class Frame : public TargetTest {};

TEST_P(Frame, EqualsItsStepsInEveryFormat) {
  for (uint32_t format = 1; format <= kFormats; ++format) {
    for (const uint32_t taps : {1u, 4u, 8u, 11u}) {
      for (const size_t count : {0, 1, 3, 15, 16, 17, 63, 64, 65, 200}) {
        SCOPED_TRACE("format " + std::to_string(format) + " taps " + std::to_string(taps) +
                     " count " + std::to_string(count));
        const Scene scene(format, count, taps);
        Views views(Layout::kTiled, count), wanted(Layout::kTiled, count);
        const gaunt_frame_job job = JobOf(scene, views);
        ASSERT_EQ(gaunt_frame_light(format, count, &job), GAUNT_OK);
        if (count == 0) continue;
        RunSteps(scene, true, true, &wanted);
        for (size_t k = 0; k < views.Outputs().size(); ++k) {
          EXPECT_TRUE(SameBytes(*views.Outputs()[k], *wanted.Outputs()[k])) << "output " << k;
        }
      }
    }
  }
}

TEST_P(Frame, GivesTheSameBitsInEveryLayout) {
  for (const uint32_t format : {GAUNT_FORMAT_SH3_28, GAUNT_FORMAT_SH2_13}) {
    for (const size_t count : {1, 7, 16, 33, 64, 75, 130}) {
      const Scene scene(format, count, 8);
      Views wanted(Layout::kTiled, count);
      RunSteps(scene, true, true, &wanted);
      for (const Layout layout : Layouts()) {
        SCOPED_TRACE(Name(layout) + " count " + std::to_string(count));
        Views views(layout, count);
        const Views before = views;
        const gaunt_frame_job job = JobOf(scene, views);
        ASSERT_EQ(gaunt_frame_light(format, count, &job), GAUNT_OK);
        EXPECT_TRUE(SameBytes(views.alpha, before.alpha));
        EXPECT_TRUE(SameBytes(views.quaternions, before.quaternions));
        const size_t planes[] = {kPlanes, kPlanes, 3, 3, 3, kConstants};
        for (size_t k = 0; k < views.Outputs().size(); ++k) {
          EXPECT_TRUE(views.Outputs()[k]->CanariesIntact());
          for (size_t i = 0; i < count; ++i) {
            for (size_t p = 0; p < planes[k]; ++p) {
              ASSERT_EQ(views.Outputs()[k]->Get(i, p), wanted.Outputs()[k]->Get(i, p))
                  << "output " << k << " object " << i << " plane " << p;
            }
          }
        }
      }
    }
  }
}

// Whatever is left out, what is there stays what it is, and what is not is not touched.
TEST_P(Frame, EveryViewMayBeLeftOut) {
  constexpr size_t kCount = 75;
  const Scene scene(GAUNT_FORMAT_SH3_32, kCount, 8);
  for (const bool lerps : {false, true}) {
    for (const bool rotates : {false, true}) {
      Views wanted(Layout::kInterleaved, kCount);
      RunSteps(scene, lerps, rotates, &wanted);
      for (unsigned present = 0; present < 32; ++present) {
        SCOPED_TRACE(testing::Message() << lerps << rotates << " outputs " << present);
        Views views(Layout::kInterleaved, kCount), before = views;
        gaunt_frame_job job = JobOf(scene, views);
        const gaunt_view** const outputs[] = {&job.radiance, &job.directions, &job.colours,
                                              &job.ambient, &job.constants};
        for (unsigned k = 0; k < 5; ++k) {
          if ((present >> k & 1) == 0) *outputs[k] = nullptr;
        }
        if (!lerps) job.history = job.alpha = nullptr;
        if (!rotates) job.quaternions = nullptr;
        ASSERT_EQ(gaunt_frame_light(scene.format, kCount, &job), GAUNT_OK);
        EXPECT_TRUE(SameBytes(views.history, wanted.history));
        for (unsigned k = 0; k < 5; ++k) {
          const Buffer* const is =
              (present >> k & 1) ? wanted.Outputs()[k + 1] : before.Outputs()[k + 1];
          EXPECT_TRUE(SameBytes(*views.Outputs()[k + 1], *is)) << "output " << k;
        }
      }
    }
  }
}

// Direction, colour and ambient light as the fields of one record, of several and in other orders.
TEST_P(Frame, LightsMayBeFieldsOfARecord) {
  constexpr size_t kCount = 50;
  const Scene scene(GAUNT_FORMAT_SH3_28, kCount, 8);
  Views wanted(Layout::kTiled, kCount);
  RunSteps(scene, true, true, &wanted);
  const size_t places[][3] = {{0, 3, 6}, {1, 4, 7}, {3, 0, 6}, {0, 3, 7}, {0, 4, 8}};
  for (const auto& at : places) {
    for (const bool tiled : {false, true}) {
      std::vector<float> memory(64 * 12, -7.0f);
      gaunt_view fields[3];
      for (size_t f = 0; f < 3; ++f) {
        const auto make = tiled ? &gaunt_view_tiled : &gaunt_view_interleaved;
        ASSERT_EQ(make(memory.data() + at[f] * (tiled ? 16 : 1), 12, &fields[f]), GAUNT_OK);
      }
      Views views(Layout::kTiled, kCount);
      gaunt_frame_job job = JobOf(scene, views);
      job.directions = &fields[0];
      job.colours = &fields[1];
      job.ambient = &fields[2];
      ASSERT_EQ(gaunt_frame_light(scene.format, kCount, &job), GAUNT_OK);
      const Buffer* const is[3] = {&wanted.directions, &wanted.colours, &wanted.ambient};
      for (size_t i = 0; i < kCount; ++i) {
        for (size_t p = 0; p < 12; ++p) {
          float expected = -7.0f;
          for (size_t f = 0; f < 3; ++f) {
            if (p >= at[f] && p < at[f] + 3) expected = is[f]->Get(i, p - at[f]);
          }
          const size_t index = tiled ? i / 16 * 192 + p * 16 + i % 16 : 12 * i + p;
          ASSERT_EQ(memory[index], expected) << "object " << i << " plane " << p;
        }
      }
    }
  }
}

// One alpha and one quaternion for all are the bits of as many equal ones.
TEST_P(Frame, TakesOneAlphaAndOneQuaternionForAll) {
  for (const size_t count : {1, 40, 600}) {
    const Scene scene(GAUNT_FORMAT_SH3_28, count, 8);
    Views one(Layout::kTiled, count), each(Layout::kTiled, count);
    float alpha = 0.3f, quaternion[4] = {0.1f, -0.7f, 0.4f, 0.2f};
    for (size_t i = 0; i < count; ++i) {
      each.alpha.Set(i, 0, alpha);
      for (size_t p = 0; p < 4; ++p) each.quaternions.Set(i, p, quaternion[p]);
    }
    gaunt_view va, vq;
    gaunt_view_broadcast(&alpha, &va);
    gaunt_view_broadcast(quaternion, &vq);
    gaunt_frame_job job = JobOf(scene, one);
    job.alpha = &va;
    job.quaternions = &vq;
    ASSERT_EQ(gaunt_frame_light(scene.format, count, &job), GAUNT_OK);
    const gaunt_frame_job all = JobOf(scene, each);
    ASSERT_EQ(gaunt_frame_light(scene.format, count, &all), GAUNT_OK);
    for (size_t k = 0; k < one.Outputs().size(); ++k) {
      EXPECT_TRUE(SameBytes(*one.Outputs()[k], *each.Outputs()[k])) << "output " << k;
    }
  }
}

// Against the definition in double precision, over frames.
TEST_P(Frame, IsAccurate) {
  constexpr size_t kCount = 70;
  constexpr uint32_t kTaps = 8;
  for (uint32_t format = 1; format <= kFormats; ++format) {
    SCOPED_TRACE("format " + std::to_string(format));
    Scene scene(format, kCount, kTaps);
    for (size_t i = 0; i < kCount; ++i) {
      double sum = 0.0;
      for (uint32_t t = 0; t < kTaps; ++t) sum += scene.weights[kTaps * i + t];
      for (uint32_t t = 0; t < kTaps; ++t) scene.weights[kTaps * i + t] /= static_cast<float>(sum);
    }
    const size_t size = PropertiesOf(format).planes / 3;
    std::vector<double> volume(scene.probes * kPlanes);
    for (size_t k = 0; k < scene.probes; ++k) {
      const auto record = probe::ReadReference(format, scene.packed.data() + k * scene.stride);
      for (size_t c = 0; c < 3; ++c) {
        for (size_t i = 0; i < std::min<size_t>(size, 9); ++i) {
          volume[kPlanes * k + 9 * c + i] = record[c * size + i].value;
        }
      }
    }
    Views views(Layout::kInterleaved, kCount);
    std::vector<double> history(kCount * kPlanes);
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t p = 0; p < kPlanes; ++p) views.history.Set(i, p, 0.0f);
    }
    const gaunt_frame_job job = JobOf(scene, views);
    for (int frame = 0; frame < 5; ++frame) {
      ASSERT_EQ(gaunt_frame_light(format, kCount, &job), GAUNT_OK);
      for (size_t i = 0; i < kCount; ++i) {
        frame::BlendReference(volume.data(), scene.probes, kTaps, &scene.indices[i * kTaps],
                              &scene.weights[i * kTaps], double{views.alpha.Get(i, 0)},
                              &history[i * kPlanes]);
      }
    }
    for (size_t i = 0; i < kCount; ++i) {
      double q[4], constants[kConstants], light[9], largest = 0.0;
      for (uint32_t t = 0; t < kTaps; ++t) {
        const uint32_t index = scene.indices[kTaps * i + t];
        for (size_t p = 0; index < scene.probes && p < kPlanes; ++p) {
          largest = std::max(largest, std::abs(volume[kPlanes * index + p]));
        }
      }
      for (size_t p = 0; p < 4; ++p) q[p] = views.quaternions.Get(i, p);
      frame::LightReference(&history[i * kPlanes], q, i % 3 != 1, constants, light, light + 3,
                            light + 6);
      for (size_t p = 0; p < kPlanes; ++p) {
        ASSERT_NEAR(views.history.Get(i, p), history[i * kPlanes + p], 4e-6 * largest);
      }
      for (size_t p = 0; p < kConstants; ++p) {
        ASSERT_NEAR(views.constants.Get(i, p), constants[p], 4e-6 * largest);
      }
    }
  }
}

// A volume that is fetched ahead, of which neither the taps of the last objects nor those that have no
// probe are followed beyond their ends.
TEST_P(Frame, FetchesLargeVolumesAhead) {
  constexpr size_t kProbes = (size_t{5} << 20) / 28;
  for (const size_t count : {1, 31, 32, 100, 333}) {
    for (const uint32_t taps : {1u, 8u, 300u}) {
      Scene scene(GAUNT_FORMAT_SH3_28, count, taps, kProbes);
      const std::unique_ptr<uint32_t[]> indices(new uint32_t[scene.indices.size()]);
      std::copy(scene.indices.begin(), scene.indices.end(), indices.get());
      Views views(Layout::kTiled, count), wanted(Layout::kTiled, count);
      gaunt_frame_job job = JobOf(scene, views);
      job.indices = indices.get();
      ASSERT_EQ(gaunt_frame_light(scene.format, count, &job), GAUNT_OK);
      // One object at a time, none is ahead of another.
      for (size_t i = 0; i < count; ++i) {
        Views single(Layout::kTiled, 1);
        for (size_t p = 0; p < kPlanes; ++p) single.history.Set(0, p, wanted.history.Get(i, p));
        for (size_t p = 0; p < 4; ++p) single.quaternions.Set(0, p, wanted.quaternions.Get(i, p));
        single.alpha.Set(0, 0, wanted.alpha.Get(i, 0));
        gaunt_frame_job one = JobOf(scene, single);
        one.indices += i * taps;
        one.weights += i * taps;
        ASSERT_EQ(gaunt_frame_light(scene.format, 1, &one), GAUNT_OK);
        for (size_t p = 0; p < kConstants; ++p) {
          ASSERT_EQ(views.constants.Get(i, p), single.constants.Get(0, p));
        }
      }
    }
  }
}

// A quaternion of zeros does not rotate at all, a NaN stays with its object, and at alpha 1 nothing of
// a finite history is left.
TEST_P(Frame, TakesWhatComes) {
  constexpr size_t kCount = 40;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Scene scene(GAUNT_FORMAT_SH3_F32, kCount, 8);
  Views views(Layout::kPlanar, kCount), wanted = views;
  for (size_t p = 0; p < kPlanes; ++p) views.history.Set(7, p, nan);
  for (size_t p = 0; p < kPlanes; ++p) views.history.Set(10, p, 1e30f);  // alpha is 1
  views.quaternions.Set(20, 2, nan);
  gaunt_frame_job job = JobOf(scene, views);
  ASSERT_EQ(gaunt_frame_light(scene.format, kCount, &job), GAUNT_OK);
  RunSteps(scene, true, true, &wanted);
  for (size_t i = 0; i < kCount; ++i) {
    if (i == 7 || i == 20) continue;
    for (size_t p = 0; p < kConstants; ++p) {
      ASSERT_EQ(views.constants.Get(i, p), wanted.constants.Get(i, p)) << "object " << i;
    }
    if (i % 3 != 1) continue;  // those with a quaternion of zeros
    for (size_t p = 0; p < kPlanes; ++p) {
      ASSERT_NEAR(views.radiance.Get(i, p), views.history.Get(i, p), 3e-7);
    }
  }
}

TEST_P(Frame, RejectsWrongArguments) {
  constexpr size_t kCount = 20;
  const Scene scene(GAUNT_FORMAT_SH3_28, kCount, 8);
  Views views(Layout::kInterleaved, kCount);
  const Views before = views;
  const auto result = [&](const auto& change) {
    gaunt_frame_job job = JobOf(scene, views);
    change(job);
    const gaunt_status status = gaunt_frame_light(scene.format, kCount, &job);
    EXPECT_EQ(std::memcmp(before.history.memory().data(), views.history.memory().data(),
                          before.history.memory().size() * sizeof(float)),
              0);
    Views untouched = before;
    for (size_t k = 0; k < 6; ++k) {
      EXPECT_TRUE(SameBytes(*views.Outputs()[k], *untouched.Outputs()[k]));
    }
    return status;
  };
  EXPECT_EQ(gaunt_frame_light(scene.format, kCount, nullptr), GAUNT_ERROR_NULL);
  gaunt_frame_job good = JobOf(scene, views);
  EXPECT_EQ(gaunt_frame_light(0, kCount, &good), GAUNT_ERROR_FORMAT);
  EXPECT_EQ(gaunt_frame_light(kFormats + 1, kCount, &good), GAUNT_ERROR_FORMAT);
  using Job = gaunt_frame_job;
  EXPECT_EQ(result([](Job& j) { j.struct_size = 0; }), GAUNT_ERROR_STRUCT);
  EXPECT_EQ(result([](Job& j) { j.struct_size += 8; }), GAUNT_ERROR_STRUCT);
  EXPECT_EQ(result([](Job& j) { j.taps = 0; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(result([](Job& j) { j.taps = 65537; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(result([](Job& j) { j.stride = 27; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(result([](Job& j) { j.packed_count = SIZE_MAX / 2; }), GAUNT_ERROR_RANGE);
  EXPECT_EQ(result([](Job& j) { j.indices = nullptr; }), GAUNT_ERROR_NULL);
  EXPECT_EQ(result([](Job& j) { j.weights = nullptr; }), GAUNT_ERROR_NULL);
  EXPECT_EQ(result([](Job& j) { j.packed = nullptr; }), GAUNT_ERROR_NULL);
  EXPECT_EQ(result([](Job& j) { j.alpha = nullptr; }), GAUNT_ERROR_NULL);
  gaunt_view broken = *views.constants.view();
  broken.data = nullptr;
  EXPECT_EQ(result([&](Job& j) { j.constants = &broken; }), GAUNT_ERROR_NULL);
  EXPECT_EQ(result([&](Job& j) { j.history = &broken; }), GAUNT_ERROR_NULL);
  broken = *views.constants.view();
  broken.plane_stride = 2;
  EXPECT_EQ(result([&](Job& j) { j.constants = &broken; }), GAUNT_ERROR_LAYOUT);
  broken = {views.history.view()->data, 0, 4, 0, 0};
  EXPECT_EQ(result([&](Job& j) { j.history = &broken; }), GAUNT_ERROR_LAYOUT);
  EXPECT_EQ(result([](Job& j) { j.radiance = j.history; }), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(result([](Job& j) { j.colours = j.directions; }), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(result([](Job& j) { j.ambient = j.colours; }), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(result([](Job& j) { j.directions = j.quaternions; }), GAUNT_ERROR_OVERLAP);
  EXPECT_EQ(result([](Job& j) { j.radiance = j.constants; }), GAUNT_ERROR_OVERLAP);
  broken = *views.directions.view();
  broken.data = const_cast<float*>(scene.weights.data());
  EXPECT_EQ(result([&](Job& j) { j.directions = &broken; }), GAUNT_ERROR_OVERLAP);
  // With nothing to do there is nothing to look at.
  Job none = {};
  none.struct_size = sizeof(none);
  none.taps = 8;
  none.stride = 28;
  EXPECT_EQ(gaunt_frame_light(scene.format, 0, &none), GAUNT_OK);
  EXPECT_EQ(gaunt_frame_light(scene.format, SIZE_MAX / 4, &good), GAUNT_ERROR_RANGE);
}

GAUNT_INSTANTIATE_TARGETS(Frame);

}  // namespace
}  // namespace gaunt::test
