#include "Catch.h"
#include "MakeArray.h"
#include "ScalarEncoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace penumbra;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// Every scalar as a program gets it back from a texture.
std::vector<double> GetDecoded(vtkDataArray* scalars)
{
  const ScalarRange range = ComputeScalarRange(scalars);
  const ScalarEncoding encoding = ChooseEncoding(scalars->GetDataType(), range);
  std::vector<double> decoded;
  if (encoding.Normalized)
  {
    for (const unsigned short value : EncodeNormalized(scalars, encoding))
    {
      decoded.push_back(encoding.Scale * (value / 65535.0) + encoding.Offset);
    }
    return decoded;
  }
  for (const float value : EncodeFloat(scalars, encoding, range))
  {
    decoded.push_back(encoding.Scale * value + encoding.Offset);
  }
  return decoded;
}
}

TEST_CASE("Every value of 8 and 16 bits comes back as it was")
{
  for (const int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT })
  {
    std::vector<double> values;
    for (double value = vtkDataArray::GetDataTypeMin(type);
         value <= vtkDataArray::GetDataTypeMax(type); value += 1.0)
    {
      values.push_back(value);
    }
    INFO("type " << type << ", " << values.size() << " values");
    const std::vector<double> decoded = GetDecoded(MakeArray(type, values));
    double largestError = 0.0;
    for (size_t i = 0; i < values.size(); ++i)
    {
      largestError = std::max(largestError, std::abs(decoded[i] - values[i]));
    }
    // Rounding of doubles below 65536.
    CHECK(largestError <= 1e-10);
  }
}

TEST_CASE("Wider types come back as they were where 24 bits hold their range")
{
  for (const int type : { VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const double first : { 0.0, 1.0, 70000.0, 8388608.0 })
    {
      const std::vector<double> values = { first, first + 1.0, first + 1001.0, first + 65537.0 };
      INFO("type " << type << " from " << first);
      CHECK(GetDecoded(MakeArray(type, values)) == values);
    }
  }
  for (const int type : { VTK_INT, VTK_LONG, VTK_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    const std::vector<double> values = { -70000.0, -1.0, 0.0, 12345.0 };
    CHECK(GetDecoded(MakeArray(type, values)) == values);
  }
}

TEST_CASE("Values that are large against their range keep their digits")
{
  for (const double offset : { -1e9, 1e6, 1e15 })
  {
    std::vector<double> values;
    for (int i = 0; i <= 64; ++i)
    {
      values.push_back(offset + 0.25 * i);
    }
    const std::vector<double> decoded = GetDecoded(MakeArray(VTK_DOUBLE, values));
    for (size_t i = 0; i < values.size(); ++i)
    {
      // Single precision of the range of 16; without an offset it would be that of the values.
      CHECK(std::abs(decoded[i] - values[i]) <= 16.0 * std::numeric_limits<float>::epsilon());
    }
  }
}

TEST_CASE("Values beyond single precision keep its digits")
{
  for (const double unit : { 1e-300, 1e-40, 1e50, 1e300 })
  {
    std::vector<double> values;
    for (int i = -8; i <= 64; ++i)
    {
      values.push_back(unit * i);
    }
    const std::vector<double> decoded = GetDecoded(MakeArray(VTK_DOUBLE, values));
    for (size_t i = 0; i < values.size(); ++i)
    {
      CHECK(
        std::abs(decoded[i] - values[i]) <= 64.0 * unit * std::numeric_limits<float>::epsilon());
    }
  }
}

TEST_CASE("An offset is used only where it gains digits")
{
  CHECK(ChooseEncoding(VTK_FLOAT, { -1.0, 3.0, true }).Offset == 0.0);
  CHECK(ChooseEncoding(VTK_FLOAT, { 0.001, 255.0, true }).Offset == 0.0);
  CHECK(ChooseEncoding(VTK_FLOAT, { 20.0, 22.0, true }).Offset == 21.0);
  CHECK(ChooseEncoding(VTK_DOUBLE, { -22.0, -20.0, true }).Offset == -21.0);
  const ScalarEncoding widest = ChooseEncoding(VTK_DOUBLE, { -1.7e308, 1.7e308, true });
  CHECK(widest.Offset == 0.0);
}

TEST_CASE("NaN and -Inf count as the smallest finite value, +Inf as the largest")
{
  const std::vector<double> decoded =
    GetDecoded(MakeArray(VTK_DOUBLE, { std::nan(""), 3.0, -Infinity, -2.0, Infinity, 7.0 }));
  CHECK(decoded == std::vector<double>{ -2.0, 3.0, -2.0, -2.0, 7.0, 7.0 });
  CHECK(GetDecoded(MakeArray(VTK_FLOAT, { std::nan(""), Infinity })) ==
    std::vector<double>{ 0.0, 0.0 });
}
