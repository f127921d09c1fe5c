/**
 * @file ShaderMathematics.h
 * @brief The functions of those GLSL files that are C++ too: the very text that the GPU runs.
 */
#ifndef ShaderMathematics_h
#define ShaderMathematics_h

namespace shader
{
// LightFalloff.glsl
float distanceAttenuation(float c1, float c2, float c3, float distance);
float coneFalloff(float cosine, float coneCosine, float exponent);

// ReflectionPhong.glsl
float diffuseReflection(float nDotL);
float specularReflection(float nDotL, float nDotV, float lDotV, float power);

// Transmittance.glsl
float opacityOfDepth(float tau);
float extinctionOfOpacity(float opacity);
}

#endif
