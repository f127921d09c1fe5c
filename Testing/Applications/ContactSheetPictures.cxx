#include "Catch.h"
#include "ImageComparison.h"
#include "SheetOfColors.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

using namespace penumbra;

TEST_CASE("Larger pictures are scaled down into their cell, smaller ones stay in its middle")
{
  SheetOfColors folder;
  WritePNG(MakeUniform(400, 160, Green), folder.PathOf("green.png"));
  WritePNG(MakeUniform(40, 30, Blue), folder.PathOf("blue.png"));
  const auto sheet = folder.Make();
  const Box red = FindColor(sheet, Red);
  const Box green = FindColor(sheet, Green);
  const Box blue = FindColor(sheet, Blue);
  const Box violet = FindColor(sheet, Violet);
  CHECK(green.Width() == 100);
  CHECK(green.Height() == 40);
  CHECK(green.count == 100 * 40);
  CHECK(green.left == violet.left);
  CHECK(green.top == red.top + 20);
  CHECK(blue.Width() == 40);
  CHECK(blue.Height() == 30);
  CHECK(blue.left == red.left + 30);
  CHECK(blue.top == violet.top + 25);
}

TEST_CASE("A pixel of a picture that is scaled down is what its area was")
{
  const SheetOfColors folder;
  auto edged = MakeUniform(1000, 800, { 255, 255, 255 });
  for (int y = 0; y < 800; ++y)
  {
    auto* row = static_cast<unsigned char*>(edged->GetScalarPointer(0, y, 0));
    std::fill(row, row + 3 * 10, static_cast<unsigned char>(0));
  }
  WritePNG(edged, folder.PathOf("green.png"));
  const auto sheet = folder.Make();
  const int left = FindColor(sheet, Violet).left;
  const int middle = FindColor(sheet, Red).top + 40;
  CHECK(ColorAt(sheet, left, middle)[0] < 40);
  CHECK(ColorAt(sheet, left + 1, middle)[0] > 215);
  CHECK(ColorAt(sheet, left + 50, middle)[0] == 255);
}

TEST_CASE("A picture keeps its right, its left, its top and its bottom")
{
  const SheetOfColors folder;
  auto corners = MakeUniform(100, 80, Red);
  auto* upperLeft = static_cast<unsigned char*>(corners->GetScalarPointer(0, 79, 0));
  auto* lowerRight = static_cast<unsigned char*>(corners->GetScalarPointer(99, 0, 0));
  std::copy(Green.begin(), Green.end(), upperLeft);
  std::copy(Violet.begin(), Violet.end(), lowerRight);
  WritePNG(corners, folder.PathOf("blue.png"));
  WritePNG(MakeUniform(100, 80, Blue), folder.PathOf("green.png"));
  WritePNG(MakeUniform(100, 80, Blue), folder.PathOf("violet.png"));
  const auto sheet = folder.Make();
  const Box upper = FindColor(sheet, Green);
  const Box lower = FindColor(sheet, Violet);
  CHECK(upper.count == 1);
  CHECK(lower.count == 1);
  CHECK(lower.left - upper.left == 99);
  CHECK(lower.top - upper.top == 79);
}

TEST_CASE("Where a picture is transparent the cell is seen")
{
  const SheetOfColors folder;
  WritePNG(MakeUniform(100, 80, Green, 4), folder.PathOf("green.png"));
  const auto sheet = folder.Make();
  CHECK(FindColor(sheet, Green).count == 0);
  const Box red = FindColor(sheet, Red);
  const Box violet = FindColor(sheet, Violet);
  const Color seen = ColorAt(sheet, violet.left + 50, red.top + 40);
  CHECK(*std::min_element(seen.begin(), seen.end()) > 200);
}

TEST_CASE("Pictures of one channel, and of 16 bits, are shown as they are")
{
  const SheetOfColors folder;
  auto deep = vtkSmartPointer<vtkImageData>::New();
  deep->SetDimensions(100, 80, 1);
  deep->AllocateScalars(VTK_UNSIGNED_SHORT, 3);
  for (int channel = 0; channel < 3; ++channel)
  {
    deep->GetPointData()->GetScalars()->FillComponent(channel, Green[channel] * 257);
  }
  WritePNG(deep, folder.PathOf("green.png"));
  WritePNG(MakeUniform(100, 80, { 99, 0, 0 }, 1), folder.PathOf("blue.png"));
  const auto sheet = folder.Make();
  CHECK(FindColor(sheet, Green).count == 100 * 80);
  CHECK(FindColor(sheet, { 99, 99, 99 }).count >= 100 * 80);
}
