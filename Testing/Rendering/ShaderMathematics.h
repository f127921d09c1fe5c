/**
 * @file ShaderMathematics.h
 * @brief The functions of those GLSL files that are C++ too: the very text that the GPU runs.
 *
 * The files of reflection models define the same two functions; each has a namespace here.
 */
#ifndef ShaderMathematics_h
#define ShaderMathematics_h

namespace shader
{
struct vec4
{
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
  float w = 0.0f;
};

// The struct of CosinesPreferred.glsl, which has all that Cosines.glsl's has.
struct ReflectionCosines
{
  float nDotL = 0.0f;
  float nDotV = 0.0f;
  float lDotV = 0.0f;
  float pDotN = 0.0f;
  float pDotL = 0.0f;
  float pDotV = 0.0f;
};

// Fresnel.glsl
float fresnelReflectance(float cosine, float n);

// LightFalloff.glsl
float distanceAttenuation(float c1, float c2, float c3, float distance);
float coneFalloff(float cosine, float coneCosine, float exponent);

// Transmittance.glsl
float opacityOfDepth(float tau);
float extinctionOfOpacity(float opacity);

// ReflectionPhong.glsl
namespace phong
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float specularReflection(ReflectionCosines c, vec4 parameters);
}

// ReflectionBlinnPhong.glsl
namespace blinnPhong
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float specularReflection(ReflectionCosines c, vec4 parameters);
}

// ReflectionOrenNayar.glsl
namespace orenNayar
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float specularReflection(ReflectionCosines c, vec4 parameters);
}

// ReflectionWard.glsl
namespace ward
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float specularReflection(ReflectionCosines c, vec4 parameters);
}

// ReflectionWardAnisotropic.glsl
namespace wardAnisotropic
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float specularReflection(ReflectionCosines c, vec4 parameters);
}

// ReflectionCookTorrance.glsl
namespace cookTorrance
{
float diffuseReflection(ReflectionCosines c, vec4 parameters);
float beckmannDistribution(float square, float m);
float gaussianDistribution(float square, float m, float constant);
float specularReflection(ReflectionCosines c, vec4 parameters);
}
}

#endif
