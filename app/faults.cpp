#include "app/faults.h"
