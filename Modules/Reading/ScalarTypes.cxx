#include "ScalarTypes.h"

#include "vtkType.h"

#include <array>
#include <limits>
#include <utility>

namespace penumbra
{

namespace
{

constexpr std::array<std::pair<const char*, int>, 8> NamedTypes = { {
  { "int8", VTK_SIGNED_CHAR },
  { "uint8", VTK_UNSIGNED_CHAR },
  { "int16", VTK_SHORT },
  { "uint16", VTK_UNSIGNED_SHORT },
  { "int32", VTK_INT },
  { "uint32", VTK_UNSIGNED_INT },
  { "float32", VTK_FLOAT },
  { "float64", VTK_DOUBLE },
} };

}

std::optional<int> ScalarTypeFromName(const std::string& name)
{
  for (const auto& [typeName, type] : NamedTypes)
  {
    if (name == typeName)
    {
      return type;
    }
  }
  return std::nullopt;
}

const char* ScalarTypeName(int vtkType)
{
  switch (vtkType)
  {
    case VTK_CHAR:
      return std::numeric_limits<char>::is_signed ? "int8" : "uint8";
    case VTK_LONG:
      return sizeof(long) == 4 ? "int32" : "int64";
    case VTK_UNSIGNED_LONG:
      return sizeof(long) == 4 ? "uint32" : "uint64";
    case VTK_LONG_LONG:
      return "int64";
    case VTK_UNSIGNED_LONG_LONG:
      return "uint64";
    default:
      break;
  }
  for (const auto& [typeName, type] : NamedTypes)
  {
    if (type == vtkType)
    {
      return typeName;
    }
  }
  return "unknown";
}

const char* ScalarTypeNames()
{
  return "int8 uint8 int16 uint16 int32 uint32 float32 float64";
}

}
