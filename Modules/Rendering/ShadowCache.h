/**
 * @file    ShadowCache.h
 * @brief   shadows that are computed on the GPU before the picture, and kept
 *
 * What has not changed since the last picture stays: a light that moves costs its own part only.
 */

#ifndef ShadowCache_h
#define ShadowCache_h

#include "LightUniforms.h"
#include "ShadowingMatter.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace penumbra
{

struct DrawnScene;
class VolumeTextures;

class ShadowCache
{
public:
  virtual ~ShadowCache() = default;

  /// Computes what has changed since the last call, or goes on with it, for about so many seconds;
  /// 0: all of it. The volume's textures are active. False where the program could not be built.
  bool Update(vtkOpenGLRenderWindow* window, const DrawnScene& scene,
    const VolumeTextures& textures, double seconds);
  /// Whether the last call computed all that there was.
  bool IsComplete() const { return !this->Begun; }

  void Activate();
  void Deactivate();
  virtual void SetUniforms(vtkShaderProgram* program, const DrawnScene& scene) = 0;

  /// How many lights were computed since this object was made.
  int GetNumberOfUpdates() const { return this->NumberOfUpdates; }
  /// What the last computation took by the clock, until OpenGL was done, in all calls together.
  double GetUpdateSeconds() const { return this->UpdateSeconds; }
  std::size_t GetBytes() const { return this->Texture->GetHandle() ? this->Bytes : 0; }

  virtual void Release(vtkOpenGLRenderWindow* window);

protected:
  struct TextureLayout
  {
    std::array<int, 3> Texels{};
    /// What one light, or those of its components, take: texels along both axes, and slices.
    std::array<int, 2> Block{};
    int Components = 0;
    int ScalarType = 0; ///< VTK's
    int Filter = 0;     ///< vtkTextureObject's

    bool HasTextureOf(const TextureLayout& other) const;
  };

  /// What one light's draws go to.
  struct Filling
  {
    vtkOpenGLRenderWindow* Window;
    vtkOpenGLQuadHelper* Quad;
    const DrawnScene* Scene;
  };

  virtual std::string GetSource(const LightingRequirements& requirements) const = 0;
  /// Of the framebuffer.
  virtual std::array<int, 2> GetSize() const = 0;
  /// Parts that a light's shadow is computed in, one after another.
  virtual int CountParts() const = 0;
  virtual void FillPart(const Filling& filling, int slot, int part) = 0;

  /// Keeps room for as many lights in a texture of that layout. Where the layout is as before,
  /// lights that stay are as they were; where only blocks differ, the texture stays. No lights give
  /// the texture up. False where the graphics card has no room.
  bool Reserve(vtkOpenGLRenderWindow* window, const TextureLayout& layout, int lights);
  /// Lets the next draw go to slices of the texture, the first one and those behind it, and then to
  /// a texture beside them.
  void Attach(int firstSlice, int slices, vtkTextureObject* beside = nullptr);
  /// Makes a light's rays march in steps of so many of the smallest spacings, or in the scene's
  /// where those are longer.
  static void SetLeastStep(const Filling& filling, double spacings);
  /// Tells the draws of a light's map its space, what depth is told apart, and steps: no finer than
  /// so many of the smallest spacings, where a soft shadow is no sharper than its texels.
  static void SetMapRays(const Filling& filling, int slot, double spacings);
  /// Covers the framebuffer by draws that are short; rays: times that a fragment marches a ray.
  void Draw(const Filling& filling, double rays);

  vtkNew<vtkTextureObject> Texture;

private:
  /// A light whose shadow is not complete yet.
  struct Beginning
  {
    int Slot = 0;
    ShadowCaster Caster;
    int NextPart = 0;
  };

  bool Create(vtkOpenGLRenderWindow* window);
  bool Fill(vtkOpenGLRenderWindow* window, const DrawnScene& scene, const VolumeTextures& textures,
    const std::vector<int>& slots, double seconds);
  void FillLights(const Filling& filling, const std::vector<int>& slots, double seconds);

  TextureLayout Layout;
  ShadowingMatter Matter;
  std::vector<std::optional<ShadowCaster>> Held;
  std::optional<Beginning> Begun;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::size_t Bytes = 0;
  int Attached = 0;
  int NumberOfUpdates = 0;
  double UpdateSeconds = 0.0;
};

/// The optical depth that is told apart from what is more, of ShadowSoft.glsl and
/// ShadowHardEdge.glsl.
float GetLargestDepth(const ShadowCaster& caster);

}

#endif
