#include "PrepareTests.h"

#include "OffscreenWindow.h"

void penumbra::PrepareTests()
{
  penumbra::UseOffscreenWindows();
}
