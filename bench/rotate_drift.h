// SPDX-License-Identifier: MIT
// How rotations drift that are applied one after the other, as a turning object's are.
#ifndef GAUNT_BENCH_ROTATE_DRIFT_H_
#define GAUNT_BENCH_ROTATE_DRIFT_H_

namespace gaunt::bench {

// rotate/drift/<what is kept>/<steps>
void RegisterRotateDrift();

}  // namespace gaunt::bench

#endif  // GAUNT_BENCH_ROTATE_DRIFT_H_
