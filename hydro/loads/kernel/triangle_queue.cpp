#include "hydro/loads/kernel/triangle_queue.h"

#include <cassert>

namespace hydro::kernel {

void pad(TriangleQueue& pieces, int lanes) {
  assert(pieces.count > 0 && lanes <= TriangleQueue::kRoom);
  const int last = pieces.count - 1;
  for (int i = pieces.count; i < lanes; ++i) {
    pieces.face[i] = pieces.face[last];
    for (int vertex = 0; vertex < 3; ++vertex) {
      pieces.x[vertex][i] = pieces.x[vertex][last];
      pieces.y[vertex][i] = pieces.y[vertex][last];
      pieces.depth[vertex][i] = pieces.depth[vertex][last];
    }
  }
}

}  // namespace hydro::kernel
