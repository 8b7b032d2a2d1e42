// Trimming of all neighbours in a list at once: loops without branches over
// columns, as in list_kernels.h. What they decide is what trimming.h says.

#ifndef GEODESIC_SOLVER_TRIMMING_TRIMMING_KERNELS_H_
#define GEODESIC_SOLVER_TRIMMING_TRIMMING_KERNELS_H_

#include "solver/windows/window_columns.h"

namespace geodesic {

// Of a list: where its windows begin, if they give up what they share with the
// one before by rounding alone: that is no wider than a window may be lost with
// (IsLost). overlap: by how much window i then still reaches into window
// i + 1; NaN if window i + 1 begins before window i.
void OverlapsOfNeighbours(double length, const WindowColumns& windows,
                          double* begin, double* overlap);

// Where pairs of overlapping neighbours change over, if the newer one ends last
// and each is nearer on its own side: the case of WonByNewer that wavefronts
// meeting in a face make. at: NaN in any other case. The distances there become
// those at the older one's end and the newer one's begin.
void FindCrossovers(WindowColumns& older, WindowColumns& newer, double* at);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TRIMMING_TRIMMING_KERNELS_H_
