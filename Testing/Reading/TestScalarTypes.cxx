#include "Catch.h"
#include "ScalarTypes.h"
#include "vtkDataArray.h"
#include "vtkType.h"

#include <string>

TEST_CASE("The eight scalar types have their names and sizes")
{
  const struct
  {
    const char* name;
    int type;
    int size;
  } types[] = { { "int8", VTK_SIGNED_CHAR, 1 }, { "uint8", VTK_UNSIGNED_CHAR, 1 },
    { "int16", VTK_SHORT, 2 }, { "uint16", VTK_UNSIGNED_SHORT, 2 }, { "int32", VTK_INT, 4 },
    { "uint32", VTK_UNSIGNED_INT, 4 }, { "float32", VTK_FLOAT, 4 }, { "float64", VTK_DOUBLE, 8 } };
  for (const auto& expected : types)
  {
    INFO(expected.name);
    REQUIRE(penumbra::ScalarTypeFromName(expected.name) == expected.type);
    CHECK(penumbra::ScalarTypeName(expected.type) == std::string(expected.name));
    CHECK(vtkDataArray::GetDataTypeSize(expected.type) == expected.size);
    CHECK(std::string(penumbra::ScalarTypeNames()).find(expected.name) != std::string::npos);
  }
}

TEST_CASE("Other names and types have no scalar type")
{
  for (const char* name : { "", "int64", "float", "UINT8", "uint8 ", "double" })
  {
    INFO(name);
    CHECK_FALSE(penumbra::ScalarTypeFromName(name));
  }
  CHECK(penumbra::ScalarTypeName(VTK_STRING) == std::string("unknown"));
  CHECK(penumbra::ScalarTypeName(VTK_CHAR) != std::string("unknown"));
}
