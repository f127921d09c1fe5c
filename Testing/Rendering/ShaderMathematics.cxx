#include "ShaderMathematics.h"

#include <algorithm>
#include <cmath>

namespace shader
{
using std::acos;
using std::exp;
using std::log;
using std::max;
using std::min;
using std::pow;
using std::sqrt;
#include "Fresnel.glsl"
#include "LightFalloff.glsl"
#include "Transmittance.glsl"
namespace phong
{
#include "ReflectionPhong.glsl"
}
namespace blinnPhong
{
#include "ReflectionBlinnPhong.glsl"
}
namespace orenNayar
{
#include "ReflectionOrenNayar.glsl"
}
namespace ward
{
#include "ReflectionWard.glsl"
}
namespace wardAnisotropic
{
#include "ReflectionWardAnisotropic.glsl"
}
namespace cookTorrance
{
#include "ReflectionCookTorrance.glsl"
}
}
