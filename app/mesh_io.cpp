#include "app/mesh_io.h"
