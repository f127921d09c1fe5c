/**
 * @file    StockLights.h
 * @brief   the lights that the stock ray caster can take
 */

#ifndef StockLights_h
#define StockLights_h

#include <vector>

class vtkLight;
class vtkLightCollection;

namespace penumbra
{

/// Switches lights off, for as long as it lives, beyond the six that VTK 9.1's arrays hold without
/// a check of their bound.
class StockLights
{
public:
  explicit StockLights(vtkLightCollection* lights);
  ~StockLights();
  StockLights(const StockLights&) = delete;
  StockLights& operator=(const StockLights&) = delete;

  bool AreSomeLeftOut() const { return !this->SwitchedOff.empty(); }

private:
  std::vector<vtkLight*> SwitchedOff;
};

}

#endif
