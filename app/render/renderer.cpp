#include "app/render/renderer.h"
