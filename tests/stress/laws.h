// The laws: each draws its questions on a scene and checks the answers.

#ifndef GEODESIC_TESTS_STRESS_LAWS_H_
#define GEODESIC_TESTS_STRESS_LAWS_H_

#include "tests/stress/report.h"
#include "tests/stress/scene.h"
#include "tests/support/random.h"

namespace geodesic::stress {

// REQUIRES, of all: the scene has a mesh.

// d(s) = 0, symmetry, triangle inequality, Euclid <= d, a point made a vertex,
// all algorithms agree, the same bits again, rigid motion and relabelling.
void CheckFieldLaws(const Scene& scene, test::Random& random, Report& report);

// Brute force, with several sources with offsets and curves. Small scenes only.
void CheckBruteForce(const Scene& scene, test::Random& random, Report& report);

// Limits by radius and targets, going on, cancelling, adding sources, settled
// vertices.
void CheckReachLaws(const Scene& scene, test::Random& random, Report& report);

// A curve is no farther than its points, and no nearer than the nearest of many
// points on it, less the way between two of them.
void CheckCurveLaws(const Scene& scene, test::Random& random, Report& report);

// Paths, nearest sources, gradients, log maps and isolines.
void CheckQuestionLaws(const Scene& scene, test::Random& random,
                       Report& report);

// Fields with a tolerance: no distance is farther off than is certified there,
// and no more is certified than asked for; at a radius and in the end.
void CheckToleranceLaws(const Scene& scene, test::Random& random,
                        Report& report);

// Searches for targets, with landmarks and without, one after the other on the
// same memory, say what fields say, both ways, and their paths are shortest. On
// the scene and on a variation of it.
void CheckPairLaws(const Scene& scene, test::Random& random, Report& report);

}  // namespace geodesic::stress

#endif  // GEODESIC_TESTS_STRESS_LAWS_H_
