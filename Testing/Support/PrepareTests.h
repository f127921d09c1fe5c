/**
 * @file PrepareTests.h
 * @brief What a test program does before its first test; penumbra_add_unit_test chooses which.
 */
#ifndef PrepareTests_h
#define PrepareTests_h

namespace penumbra
{
void PrepareTests();
}

#endif
