#include "StockLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"

namespace penumbra
{

//------------------------------------------------------------------------------
StockLights::StockLights(vtkLightCollection* lights)
{
  constexpr int largestNumber = 6;
  int lightsOn = 0;
  vtkCollectionSimpleIterator cursor;
  lights->InitTraversal(cursor);
  while (vtkLight* light = lights->GetNextLight(cursor))
  {
    if (light->GetSwitch() && ++lightsOn > largestNumber)
    {
      light->SwitchOff();
      this->SwitchedOff.push_back(light);
    }
  }
}

//------------------------------------------------------------------------------
StockLights::~StockLights()
{
  for (vtkLight* light : this->SwitchedOff)
  {
    light->SwitchOn();
  }
}

}
