#include "app/scene_reader.h"
