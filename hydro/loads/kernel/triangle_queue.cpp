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

void put_piece(const TriangleQueue& from, int piece, TriangleQueue& pieces) {
  assert(pieces.count < TriangleQueue::kRoom);
  const int to = pieces.count++;
  pieces.face[to] = from.face[piece];
  for (int i = 0; i < 3; ++i) {
    pieces.x[i][to] = from.x[i][piece];
    pieces.y[i][to] = from.y[i][piece];
    pieces.depth[i][to] = from.depth[i][piece];
  }
}

}  // namespace hydro::kernel
