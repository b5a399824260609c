#pragma once

// All kinds of values that parameters have: the type of the value, how it is read and checked, described, put into the
// vertices' order and compared. A new kind is one file and its line here.

#include "methods/values/chains.h"
#include "methods/values/choice.h"
#include "methods/values/choice_or_rows.h"
#include "methods/values/flag.h"
#include "methods/values/handles.h"
#include "methods/values/integer.h"
#include "methods/values/number.h"
#include "methods/values/planes.h"
#include "methods/values/rotation.h"
#include "methods/values/rotations.h"
#include "methods/values/scalars.h"
#include "methods/values/sphere_field.h"
#include "methods/values/style.h"
#include "methods/values/texture_slopes.h"
#include "methods/values/vector.h"
