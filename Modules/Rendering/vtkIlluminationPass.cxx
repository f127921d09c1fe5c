#include "vtkIlluminationPass.h"

#include "ShaderSource.h"

#include "vtkObjectFactory.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkIlluminationPass);

//------------------------------------------------------------------------------
vtkIlluminationPass::vtkIlluminationPass()
{
  // The ray caster fails on the default of 0 where it draws to a buffer of its own.
  this->SetActiveDrawBuffers(1);
}

//------------------------------------------------------------------------------
vtkIlluminationPass::~vtkIlluminationPass() = default;

//------------------------------------------------------------------------------
void vtkIlluminationPass::Select(const penumbra::LightingRequirements& requirements, bool continued)
{
  if (requirements != this->Requirements || continued != this->Continued)
  {
    this->Requirements = requirements;
    this->Continued = continued;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIlluminationPass::Render(const vtkRenderState*) {}

//------------------------------------------------------------------------------
bool vtkIlluminationPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  this->FragmentSource = penumbra::GetFragmentShaderSource(this->Requirements, this->Continued);
  vertexShader = penumbra::GetVertexShaderSource();
  geometryShader = penumbra::GetGeometryShaderSource(this->Requirements);
  fragmentShader = this->FragmentSource;
  ++this->NumberOfBuilds;
  return true;
}

//------------------------------------------------------------------------------
bool vtkIlluminationPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  this->ProgramFailed = !program || !program->GetCompiled();
  if (!this->ProgramFailed && this->SetUniforms)
  {
    this->SetUniforms(program);
  }
  return !this->ProgramFailed;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkIlluminationPass::GetShaderStageMTime()
{
  return this->GetMTime();
}

//------------------------------------------------------------------------------
void vtkIlluminationPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Continued: " << this->Continued << "\n";
  os << indent << "NumberOfBuilds: " << this->NumberOfBuilds << "\n";
  for (const auto& entry : this->Requirements.GetEntries())
  {
    os << indent << entry.Name << ": " << entry.Value << "\n";
  }
}
