// Ward's lobe of a brushed surface (Ward 1992; thesis eq. 11), a Gaussian of the slopes of the half
// vector H along the preferred direction P, projected on the tangent plane, and across it. Where P
// is within a degree of the normal it has no projection worth the name, and the exponent goes over
// to the isotropic one of the same peak. parameters: x the roughness along P, y across, both at
// least 0.001.

float diffuseReflection(ReflectionCosines c, vec4 parameters)
{
  return max(c.nDotL, 0.0f);
}

float specularReflection(ReflectionCosines c, vec4 parameters)
{
  if (c.nDotL <= 0.0f || c.nDotV <= 0.0f)
  {
    return 0.0f;
  }
  float length2 = max(2.0f + 2.0f * c.lDotV, 1e-12f);
  float sum = c.nDotL + c.nDotV;
  float normal2 = max(sum * sum / length2, 1e-8f);         // (N.H)^2
  float tangent2 = max(1.0f - normal2, 0.0f);              // of H's projection on the tangent plane
  float projection2 = max(1.0f - c.pDotN * c.pDotN, 0.0f); // of P's
  float along = c.pDotL + c.pDotV - c.pDotN * sum;
  float along2 = min(along * along / max(length2 * projection2, 1e-12f), tangent2);
  float exponent = along2 / (parameters.x * parameters.x) + (tangent2 - along2) / (parameters.y * parameters.y);
  float isotropic = tangent2 / (parameters.x * parameters.y);
  float certain = min(projection2 / 3.045865e-4f, 1.0f); // over the square of the sine of 1 degree
  exponent = isotropic + certain * (exponent - isotropic);
  return sqrt(c.nDotL / max(c.nDotV, 1e-6f)) * exp(-exponent / normal2) /
    (12.566371f * parameters.x * parameters.y);
}
