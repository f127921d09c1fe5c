/**
 * @file    ScalarTypes.h
 * @brief   the scalar types that volumes have, by name and as VTK's constants
 *
 * int8, uint8, int16, uint16, int32, uint32, float32 and float64 stand for VTK_SIGNED_CHAR,
 * VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT and
 * VTK_DOUBLE.
 */

#ifndef ScalarTypes_h
#define ScalarTypes_h

#include "PenumbraReadingModule.h" // For export macro

#include <optional>
#include <string>

namespace penumbra
{

/**
 * VTK's constant for one of the eight names above; nothing for any other name.
 */
PENUMBRAREADING_EXPORT std::optional<int> ScalarTypeFromName(const std::string& name);

/**
 * The name of a VTK scalar type: one of the eight above, or int64 or uint64. A type without such a
 * name, VTK_STRING for example, gives "unknown".
 */
PENUMBRAREADING_EXPORT const char* ScalarTypeName(int vtkType);

/**
 * The eight names above, separated by spaces, for messages.
 */
PENUMBRAREADING_EXPORT const char* ScalarTypeNames();

}

#endif
