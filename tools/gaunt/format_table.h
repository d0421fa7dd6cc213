// SPDX-License-Identifier: MIT
// The packed formats and their names, for commands and benchmarks.
#ifndef GAUNT_TOOLS_GAUNT_FORMAT_TABLE_H_
#define GAUNT_TOOLS_GAUNT_FORMAT_TABLE_H_

#include <cstdint>

#include "gaunt/gaunt.h"

namespace gaunt::tool {

struct FormatName {
  uint32_t format;
  const char* name;
};
inline constexpr FormatName kFormatNames[] = {{GAUNT_FORMAT_SH3_28, "sh3_28"},
                                              {GAUNT_FORMAT_SH2_13, "sh2_13"},
                                              {GAUNT_FORMAT_SH3_32, "sh3_32"},
                                              {GAUNT_FORMAT_SH5_55, "sh5_55"},
                                              {GAUNT_FORMAT_SH3_F16, "sh3_f16"},
                                              {GAUNT_FORMAT_SH3_F32, "sh3_f32"},
                                              {GAUNT_FORMAT_UNREAL_28, "unreal_28"},
                                              {GAUNT_FORMAT_UNITY_L1_16, "unity_l1_16"},
                                              {GAUNT_FORMAT_UNITY_L2_32, "unity_l2_32"},
                                              {GAUNT_FORMAT_RGB9E5, "rgb9e5"},
                                              {GAUNT_FORMAT_R11G11B10F, "r11g11b10f"},
                                              {GAUNT_FORMAT_SH3_LUMA_12, "sh3_luma_12"},
                                              {GAUNT_FORMAT_SH3_CHROMA_16, "sh3_chroma_16"},
                                              {GAUNT_FORMAT_SH3_CHROMA_21, "sh3_chroma_21"},
                                              {GAUNT_FORMAT_ZH3_16, "zh3_16"},
                                              {GAUNT_FORMAT_ZH3_LUMA_8, "zh3_luma_8"},
                                              {GAUNT_FORMAT_GODOT_L1_32, "godot_l1_32"}};

}  // namespace gaunt::tool

#endif  // GAUNT_TOOLS_GAUNT_FORMAT_TABLE_H_
