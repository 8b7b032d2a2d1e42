// Who wants to hear of windows as they are made.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_OBSERVER_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_OBSERVER_H_

#include <cstdint>

#include "geodesic/mesh.h"
#include "solver/windows/mixed_origin.h"

namespace geodesic {

class WindowObserver {
 public:
  virtual ~WindowObserver() = default;

  // A window that enters the face of h: paths that exist, the shortest among
  // them unless other windows are nearer. Every point of every edge within the
  // settled radius has been in a window that is shortest there, or is reached
  // straight from an end of the edge or from a source in a face around it.
  virtual void OnWindow(HalfEdge h, const MixedWindow& window,
                        uint32_t pseudo_source) = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_OBSERVER_H_
