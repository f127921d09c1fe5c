#include "PrepareTests.h"

void penumbra::PrepareTests() {}
