#include "hydro/loads/kernel/pieces.h"

namespace hydro::kernel {

void pad(Pieces& pieces, int lanes) {
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
