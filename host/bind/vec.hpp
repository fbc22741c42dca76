// The algebra of Vec3 under the name that bind uses.
#pragma once
#include "host/vec.hpp"
