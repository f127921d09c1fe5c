#include "ShaderMathematics.h"

#include <algorithm>
#include <cmath>

namespace shader
{
using std::exp;
using std::log;
using std::max;
using std::min;
using std::pow;
#include "LightFalloff.glsl"
#include "ReflectionPhong.glsl"
#include "Transmittance.glsl"
}
