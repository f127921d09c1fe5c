/**
 * @class   vtkIlluminationPass
 * @brief   puts Penumbra's GLSL into VTK's volume ray caster
 *
 * A private render pass, attached to the drawn volume for the length of one draw. The ray caster
 * asks it for replacements when it builds a program, which it does when GetShaderStageMTime() is
 * newer, and for uniforms on every draw.
 */

#ifndef vtkIlluminationPass_h
#define vtkIlluminationPass_h

#include "LightingRequirements.h"

#include "vtkOpenGLRenderPass.h"

#include <functional>
#include <string>

class vtkIlluminationPass : public vtkOpenGLRenderPass
{
public:
  static vtkIlluminationPass* New();
  vtkTypeMacro(vtkIlluminationPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Selects the program; only a change makes the ray caster build another.
  void Select(const penumbra::LightingRequirements& requirements, bool continued);

  /// Called with the program bound before each draw.
  std::function<void(vtkShaderProgram*)> SetUniforms;

  const std::string& GetFragmentSource() const { return this->FragmentSource; }
  int GetNumberOfBuilds() const { return this->NumberOfBuilds; }
  /// True after a draw that had no program to draw with.
  bool GetProgramFailed() const { return this->ProgramFailed; }
  void ExpectDraw() { this->ProgramFailed = true; }

  void Render(const vtkRenderState* state) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vertices = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;

protected:
  vtkIlluminationPass();
  ~vtkIlluminationPass() override;

private:
  vtkIlluminationPass(const vtkIlluminationPass&) = delete;
  void operator=(const vtkIlluminationPass&) = delete;

  penumbra::LightingRequirements Requirements;
  bool Continued = false;
  std::string FragmentSource;
  int NumberOfBuilds = 0;
  bool ProgramFailed = false;
};

#endif
