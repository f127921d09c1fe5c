#include "Surroundings.h"

#include "vtkMath.h"
#include "vtkVectorOperators.h"

#include <algorithm>
#include <cmath>

namespace penumbra::reference
{
namespace
{
// Rectangles of larger radius count as if they were everywhere; smaller ones bulge by less.
constexpr double LargestFlat = 0.3;
constexpr double WholeSphere = 2.0;
constexpr double Bulge = 1.05;

constexpr std::size_t MostPixelsKept = 500000;

/// Gauss's two nodes on [0, 1].
constexpr double Nodes[] = { 0.21132486540518711775, 0.78867513459481288225 };

/// Each pixel of an image as that many by that many.
EnvironmentImage Divide(const EnvironmentImage& image, int parts)
{
  EnvironmentImage divided;
  divided.Width = image.Width * parts;
  divided.Height = image.Height * parts;
  for (int row = 0; row < divided.Height; ++row)
  {
    for (int column = 0; column < divided.Width; ++column)
    {
      const float* pixel = image.Pixels.data() +
        3 * (static_cast<std::size_t>(row / parts) * image.Width + column / parts);
      divided.Pixels.insert(divided.Pixels.end(), pixel, pixel + 3);
    }
  }
  return divided;
}

/// As in OpenGL's table of cube maps, not of unit length; -1 <= a, b <= 1 to the right and down.
vtkVector3d GetFaceDirection(int face, double a, double b)
{
  const vtkVector3d directions[] = { { 1.0, -b, -a }, { -1.0, -b, a }, { a, 1.0, b },
    { a, -1.0, -b }, { a, -b, 1.0 }, { -a, -b, -1.0 } };
  return directions[face];
}
}

//------------------------------------------------------------------------------
void LightMoments::Add(const LightMoments& other, double factor)
{
  this->Flux += factor * other.Flux;
  this->First += other.First * factor;
  for (std::size_t i = 0; i < this->Second.size(); ++i)
  {
    this->Second[i] += factor * other.Second[i];
  }
}

//------------------------------------------------------------------------------
double LightMoments::GetSecond(const vtkVector3d& w) const
{
  const auto& s = this->Second;
  return w[0] * w[0] * s[0] + w[1] * w[1] * s[1] + w[2] * w[2] * s[2] +
    2.0 * (w[0] * w[1] * s[3] + w[0] * w[2] * s[4] + w[1] * w[2] * s[5]);
}

//------------------------------------------------------------------------------
std::array<SkyRectangle, 4> SkyRectangle::Halve() const
{
  const double x = 0.5 * (this->Left + this->Right);
  const double y = 0.5 * (this->Top + this->Bottom);
  return { SkyRectangle{ this->Image, this->Left, this->Top, x, y },
    SkyRectangle{ this->Image, x, this->Top, this->Right, y },
    SkyRectangle{ this->Image, this->Left, y, x, this->Bottom },
    SkyRectangle{ this->Image, x, y, this->Right, this->Bottom } };
}

//------------------------------------------------------------------------------
Surroundings::Surroundings(EnvironmentMap map, double largestPixel)
  : Map(std::move(map))
{
  for (EnvironmentImage& image : this->Map.Images)
  {
    const int parts = this->CountParts(image, largestPixel);
    if (parts > 1)
    {
      image = Divide(image, parts);
    }
  }
  this->Pyramids.resize(this->Map.Images.size());
  for (std::size_t image = 0; image < this->Pyramids.size(); ++image)
  {
    this->BuildPyramid(static_cast<int>(image));
  }
}

//------------------------------------------------------------------------------
int Surroundings::CountParts(const EnvironmentImage& image, double largestPixel) const
{
  const double count = static_cast<double>(this->Map.Images.size());
  const double pi = vtkMath::Pi();
  const double pixel =
    count > 1.0 ? 2.0 / image.Width : std::max(2.0 * pi / image.Width, pi / image.Height);
  const double pixels = count * image.Width * image.Height;
  const double most = std::max(std::floor(std::sqrt(MostPixelsKept / pixels)), 1.0);
  return static_cast<int>(std::min(std::ceil(pixel / largestPixel), most));
}

//------------------------------------------------------------------------------
vtkVector3d Surroundings::GetDirection(int image, double x, double y) const
{
  const EnvironmentImage& pixels = this->Map.Images[image];
  const double s = x / pixels.Width;
  const double t = y / pixels.Height;
  if (this->Map.Images.size() > 1)
  {
    return GetFaceDirection(image, 2.0 * s - 1.0, 2.0 * t - 1.0).Normalized();
  }
  const double azimuth = (2.0 * s - 1.0) * vtkMath::Pi();
  const double polar = t * vtkMath::Pi();
  return { std::sin(polar) * std::cos(azimuth), std::cos(polar),
    std::sin(polar) * std::sin(azimuth) };
}

//------------------------------------------------------------------------------
double Surroundings::GetSolidAngle(const SkyRectangle& rectangle, double x, double y) const
{
  const EnvironmentImage& pixels = this->Map.Images[rectangle.Image];
  const double width = (rectangle.Right - rectangle.Left) / pixels.Width;
  const double height = (rectangle.Bottom - rectangle.Top) / pixels.Height;
  if (this->Map.Images.size() > 1)
  {
    const double a = 2.0 * x / pixels.Width - 1.0;
    const double b = 2.0 * y / pixels.Height - 1.0;
    return 4.0 * width * height / std::pow(1.0 + a * a + b * b, 1.5);
  }
  const double pi = vtkMath::Pi();
  return 2.0 * pi * pi * width * height * std::sin(pi * y / pixels.Height);
}

//------------------------------------------------------------------------------
SkyRectangle Surroundings::GetRectangle(const Block& block) const
{
  const EnvironmentImage& pixels = this->Map.Images[block.Image];
  const double size = std::ldexp(1.0, block.Level);
  return { block.Image, block.Column * size, block.Row * size,
    std::min((block.Column + 1) * size, double(pixels.Width)),
    std::min((block.Row + 1) * size, double(pixels.Height)) };
}

//------------------------------------------------------------------------------
const SkyPatch& Surroundings::GetPatch(const Block& block) const
{
  const Level& level = this->Pyramids[block.Image][block.Level];
  return level.Patches[block.Row * static_cast<std::size_t>(level.Columns) + block.Column];
}

//------------------------------------------------------------------------------
SkyPatch Surroundings::MakeOutline(const SkyRectangle& r) const
{
  SkyPatch patch;
  patch.Center = this->GetDirection(r.Image, 0.5 * (r.Left + r.Right), 0.5 * (r.Top + r.Bottom));
  for (const double x : { r.Left, r.Right })
  {
    for (const double y : { r.Top, r.Bottom })
    {
      const vtkVector3d corner = this->GetDirection(r.Image, x, y);
      patch.Radius = std::max(patch.Radius, (corner - patch.Center).Norm());
    }
  }
  // The corners of a large rectangle need not be what is furthest from its centre.
  patch.Radius = patch.Radius > LargestFlat ? WholeSphere : patch.Radius * Bulge;
  return patch;
}

//------------------------------------------------------------------------------
SkyPatch Surroundings::MakePatch(const SkyRectangle& r) const
{
  SkyPatch patch = this->MakeOutline(r);
  LightMoments ofWhite;
  for (const double nodeX : Nodes)
  {
    for (const double nodeY : Nodes)
    {
      const double x = r.Left + nodeX * (r.Right - r.Left);
      const double y = r.Top + nodeY * (r.Bottom - r.Top);
      const vtkVector3d w = this->GetDirection(r.Image, x, y);
      const LightMoments node{ 1.0, w,
        { w[0] * w[0], w[1] * w[1], w[2] * w[2], w[0] * w[1], w[0] * w[2], w[1] * w[2] } };
      ofWhite.Add(node, 0.25 * this->GetSolidAngle(r, x, y));
    }
  }
  const EnvironmentImage& pixels = this->Map.Images[r.Image];
  const auto column = static_cast<std::size_t>(0.5 * (r.Left + r.Right));
  const auto row = static_cast<std::size_t>(0.5 * (r.Top + r.Bottom));
  for (int channel = 0; channel < 3; ++channel)
  {
    patch.Light[channel].Add(ofWhite, pixels.Pixels[3 * (row * pixels.Width + column) + channel]);
  }
  return patch;
}

//------------------------------------------------------------------------------
void Surroundings::BuildPyramid(int image)
{
  this->AddPixels(image);
  do
  {
    this->AddLevel(image);
  } while (this->Pyramids[image].back().Patches.size() > 1);
}

//------------------------------------------------------------------------------
void Surroundings::AddPixels(int image)
{
  const EnvironmentImage& pixels = this->Map.Images[image];
  Level& level = this->Pyramids[image].emplace_back();
  level.Columns = pixels.Width;
  level.Rows = pixels.Height;
  if (pixels.Pixels.size() * this->Map.Images.size() > 3 * MostPixelsKept)
  {
    return;
  }
  for (int row = 0; row < level.Rows; ++row)
  {
    for (int column = 0; column < level.Columns; ++column)
    {
      level.Patches.push_back(this->MakePatch(this->GetRectangle({ image, 0, column, row })));
    }
  }
}

//------------------------------------------------------------------------------
void Surroundings::AddLevel(int image)
{
  const Level& below = this->Pyramids[image].back();
  const int number = static_cast<int>(this->Pyramids[image].size());
  Level level{ (below.Columns + 1) / 2, (below.Rows + 1) / 2, {} };
  for (int row = 0; row < level.Rows; ++row)
  {
    for (int column = 0; column < level.Columns; ++column)
    {
      SkyPatch patch = this->MakeOutline(this->GetRectangle({ image, number, column, row }));
      for (int child = 0; child < 4; ++child)
      {
        const Block block{ image, number - 1, 2 * column + child % 2, 2 * row + child / 2 };
        if (block.Column < below.Columns && block.Row < below.Rows)
        {
          const SkyPatch part = below.Patches.empty() ? this->MakePatch(this->GetRectangle(block))
                                                      : this->GetPatch(block);
          for (int channel = 0; channel < 3; ++channel)
          {
            patch.Light[channel].Add(part.Light[channel], 1.0);
          }
        }
      }
      level.Patches.push_back(patch);
    }
  }
  this->Pyramids[image].push_back(std::move(level));
}

//------------------------------------------------------------------------------
Rgb Surroundings::GetMean() const
{
  Rgb mean{};
  for (const auto& pyramid : this->Pyramids)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      mean[channel] += pyramid.back().Patches[0].Light[channel].Flux / (4.0 * vtkMath::Pi());
    }
  }
  return mean;
}

}
