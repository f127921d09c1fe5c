/**
 * @class   vtkVolumeMaterial
 * @brief   a volume's property with the reflection models of the literature
 *
 * A vtkVolumeProperty that says how matter reflects light, for volumes drawn by
 * vtkIlluminatedVolumeMapper: give it to vtkVolume::SetProperty(). A plain vtkVolumeProperty
 * reflects by Phong's model. Per sample
 *
 *   c = C ka sum(Ia) + sum over lights of att spot V (C kd Id F_d + ks Is F_s)
 *
 * with ka, kd and ks the inherited Ambient, Diffuse and Specular factors. The models set F_d and
 * F_s alone; both are 0 where N.L <= 0, and, but for Phong's, F_s is 0 where N.V <= 0. N is the
 * normal, L points to the light, V to the eye, H = (L+V)/|L+V|, g is the angle from N to H. F_d =
 * N.L unless said otherwise.
 *
 * - Phong (1975): F_s = (R.V)^n, R = 2(N.L)N - L, n the inherited SpecularPower.
 * - BlinnPhong (Blinn 1977): F_s = (N.H)^n.
 * - OrenNayar (Oren and Nayar 1994), rough matt surfaces: F_d = N.L (A + B max(0, cos C) sin a
 *   tan b), A = 1 - 0.5 s^2/(s^2+0.33), B = 0.45 s^2/(s^2+0.09), s the Roughness, a and b the
 *   larger and the smaller of the angles from N to L and to V, C the difference of their azimuths;
 *   F_s = 0.
 * - Ward (1992), isotropic: F_s = sqrt(N.L/N.V) exp(-tan^2 g / s^2) / (4 pi s^2).
 * - WardAnisotropic (Ward 1992), brushed surfaces: F_s = sqrt(N.L/N.V) exp(-tan^2 g (cos^2 p / sx^2
 *   + sin^2 p / sy^2)) / (4 pi sx sy), p the angle from the PreferredDirection's projection on the
 *   tangent plane to H's. Within 1 degree of the normal a preferred direction has no projection
 *   worth the name: there the exponent goes over to that of the isotropic model of s^2 = sx sy.
 * - CookTorrance (Cook and Torrance 1982): F_s = F D G / (pi N.V), with Fresnel's reflectance F
 *   per colour channel, the distribution D of the facets' slopes and the geometric attenuation G.
 * - ReflectionMap (Blinn and Newell 1976; Miller and Hoffman 1984): instead of the lights' diffuse
 *   and specular terms C kd Ed(N) + ks Es(R), Ed and Es an environment's radiance filtered by the
 *   cosine and by its SpecularPower'th power, R the direction to the eye mirrored at N. It casts no
 *   shadows.
 *
 * Numbers that are not finite count as their defaults.
 *
 * @sa vtkIlluminatedVolumeMapper vtkVolumeLight
 */

#ifndef vtkVolumeMaterial_h
#define vtkVolumeMaterial_h

#include "PenumbraLightingModule.h" // For export macro
#include "vtkSmartPointer.h"        // For vtkSmartPointer
#include "vtkVolumeProperty.h"

#include <vector> // For std::vector

class vtkImageData;

class PENUMBRALIGHTING_EXPORT vtkVolumeMaterial : public vtkVolumeProperty
{
public:
  static vtkVolumeMaterial* New();
  vtkTypeMacro(vtkVolumeMaterial, vtkVolumeProperty);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The values are those of penumbra::ReflectionModel.
  enum ReflectionModelType
  {
    Phong = 0,
    BlinnPhong = 1,
    OrenNayar = 2,
    Ward = 3,
    WardAnisotropic = 4,
    CookTorrance = 5,
    ReflectionMap = 6
  };

  enum DistributionType
  {
    Beckmann = 0,
    Gaussian = 1
  };

  ///@{
  /**
   * How matter reflects light. Default: Phong.
   */
  vtkSetClampMacro(ReflectionModel, int, Phong, ReflectionMap);
  vtkGetMacro(ReflectionModel, int);
  void SetReflectionModelToPhong() { this->SetReflectionModel(Phong); }
  void SetReflectionModelToBlinnPhong() { this->SetReflectionModel(BlinnPhong); }
  void SetReflectionModelToOrenNayar() { this->SetReflectionModel(OrenNayar); }
  void SetReflectionModelToWard() { this->SetReflectionModel(Ward); }
  void SetReflectionModelToWardAnisotropic() { this->SetReflectionModel(WardAnisotropic); }
  void SetReflectionModelToCookTorrance() { this->SetReflectionModel(CookTorrance); }
  void SetReflectionModelToReflectionMap() { this->SetReflectionModel(ReflectionMap); }
  const char* GetReflectionModelAsString();
  ///@}

  ///@{
  /**
   * Roughness of Oren and Nayar's model, the standard deviation of the facets' angles in radians,
   * and of Ward's isotropic one, the root mean square of their slopes; 0 or more. Ward's lobe takes
   * less than 0.001 as 0.001. Default: 0.3.
   */
  vtkSetClampMacro(Roughness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /**
   * Roughness along and across the preferred direction, of Ward's anisotropic model: the standard
   * deviation of the facets' slopes times the root of 2; 0 or more, less than 0.001 counts as
   * 0.001. Default: 0.1 and 0.5.
   */
  vtkSetClampMacro(RoughnessX, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RoughnessX, double);
  vtkSetClampMacro(RoughnessY, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(RoughnessY, double);
  ///@}

  ///@{
  /**
   * The direction in which an anisotropic surface is brushed, in the volume's own frame (before the
   * actor's matrix, which turns it), of any length but 0. One of length 0 shows as (1, 0, 0).
   * Default: (1, 0, 0).
   */
  vtkSetVector3Macro(PreferredDirection, double);
  vtkGetVector3Macro(PreferredDirection, double);
  ///@}

  ///@{
  /**
   * Root-mean-square slope m of the facets of Cook and Torrance's model; 0 or more, less than 0.001
   * counts as 0.001. Default: 0.3.
   */
  vtkSetClampMacro(Slope, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Slope, double);
  ///@}

  ///@{
  /**
   * How their slopes are distributed: by Beckmann, D = exp(-tan^2 g / m^2) / (m^2 cos^4 g), or
   * Gaussian, D = k exp(-(g/m)^2). Default: Beckmann.
   */
  vtkSetClampMacro(Distribution, int, Beckmann, Gaussian);
  vtkGetMacro(Distribution, int);
  void SetDistributionToBeckmann() { this->SetDistribution(Beckmann); }
  void SetDistributionToGaussian() { this->SetDistribution(Gaussian); }
  ///@}

  ///@{
  /**
   * The constant k of the Gaussian distribution, 0 or more. Default: 1.
   */
  vtkSetClampMacro(GaussianConstant, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GaussianConstant, double);
  ///@}

  ///@{
  /**
   * Index of refraction of Cook and Torrance's model for red, green and blue, more than 0;
   * less than 0.001 counts as 0.001. At normal incidence the reflectance is ((n-1)/(n+1))^2.
   * Default: 1.5 each.
   */
  vtkSetVector3Macro(IndexOfRefraction, double);
  vtkGetVector3Macro(IndexOfRefraction, double);
  ///@}

  ///@{
  /**
   * The surroundings that ReflectionMap shows, in the world with y up: one equirectangular image,
   * or six square ones of the directions +x, -x, +y, -y, +z and -z. See EnvironmentMap.h for which
   * pixel is seen where. Default: none, which reflects nothing.
   */
  void SetEnvironmentMap(vtkImageData* equirectangular);
  void SetEnvironmentMap(const std::vector<vtkSmartPointer<vtkImageData>>& images);
  const std::vector<vtkSmartPointer<vtkImageData>>& GetEnvironmentMap() const
  {
    return this->EnvironmentMap;
  }
  ///@}

  ///@{
  /**
   * Where the gradient is no more than noise, so is the normal. With a value k above 0 the share w
   * = 1 - exp(-(|grad f| / (k s))^2) of the reflected light has the normal's direction; s is the
   * root mean square of the gradient that the data's noise has by itself. The rest is reflected as
   * by normals of all directions: F_d is 1/4, or 1/2 with two-sided lighting, and F_s is 0. 1 to 3
   * calm noisy data. Default: 0, all of it is directional.
   */
  vtkSetClampMacro(NoiseFading, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(NoiseFading, double);
  ///@}

  /**
   * Takes over all of another property's state; of a plain vtkVolumeProperty's, what it has.
   */
  void DeepCopy(vtkVolumeProperty* property);

  /**
   * Also when a pixel of the environment map changes.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkVolumeMaterial();
  ~vtkVolumeMaterial() override;

  int ReflectionModel = Phong;
  double Roughness = 0.3;
  double RoughnessX = 0.1;
  double RoughnessY = 0.5;
  double PreferredDirection[3] = { 1.0, 0.0, 0.0 };
  double Slope = 0.3;
  int Distribution = Beckmann;
  double GaussianConstant = 1.0;
  double IndexOfRefraction[3] = { 1.5, 1.5, 1.5 };
  std::vector<vtkSmartPointer<vtkImageData>> EnvironmentMap;
  double NoiseFading = 0.0;

private:
  vtkVolumeMaterial(const vtkVolumeMaterial&) = delete;
  void operator=(const vtkVolumeMaterial&) = delete;
};

#endif
