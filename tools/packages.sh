# SPDX-License-Identifier: MIT
# Debian packages, by what needs them. Sourced by the other scripts.
packages_build="cmake ninja-build g++ libhwy-dev libopenimageio-dev openimageio-tools libcli11-dev libfmt-dev nlohmann-json3-dev zlib1g-dev"
packages_test="libgtest-dev libbenchmark-dev gnuplot-nox binutils libegl-dev libgles-dev libgl1-mesa-dri glslang-tools spirv-cross"
packages_clang="clang libclang-rt-14-dev"
packages_arm="g++-aarch64-linux-gnu qemu-user"
packages_panorama="blender-data"
