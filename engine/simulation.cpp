#include "engine/simulation.h"
