/**
 * @file LitShells.h
 * @brief A volume and a light to execute the filter with, and an ear for what it tells meanwhile.
 */
#ifndef LitShells_h
#define LitShells_h

#include "ShadowedVolume.h"

#include <vtkCallbackCommand.h>

#include <functional>
#include <utility>

namespace penumbra
{
struct LitShells : ShadowedVolume
{
  vtkSmartPointer<vtkVolumeLight> Light;

  LitShells()
    : ShadowedVolume(MakeShells(VolumeGrid{ { 16, 17, 18 } }, 7.0))
  {
    this->Opacity->AddPoint(255.0, 0.3);
    this->Light = this->AddDirectional({ 1.0, 2.0, 3.0 });
  }
};

/// Calls a function on an event of the filter as long as this object lives.
class Observation
{
public:
  Observation(vtkObject* object, unsigned long event, std::function<void()> function)
    : Object(object)
    , Function(std::move(function))
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { static_cast<Observation*>(self)->Function(); });
    this->Tag = object->AddObserver(event, this->Command);
  }
  ~Observation() { this->Object->RemoveObserver(this->Tag); }
  Observation(const Observation&) = delete;
  void operator=(const Observation&) = delete;

private:
  vtkObject* Object;
  std::function<void()> Function;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
};
}

#endif
