/**
 * @file    Surroundings.h
 * @brief   an environment map as light from patches of the sphere, coarse or fine
 *
 * Of each patch its light's moments are known: flux = integral of E dw, first = integral of E w dw,
 * second = integral of E w w^T dw. A smooth function's integral over the patch follows from them to
 * the third order of the patch's size.
 */

#ifndef Surroundings_h
#define Surroundings_h

#include "EnvironmentMap.h"
#include "LightSource.h" // For Rgb

#include "vtkVector.h"

#include <array>
#include <vector>

namespace penumbra::reference
{

struct LightMoments
{
  double Flux = 0.0;
  vtkVector3d First = vtkVector3d(0.0);
  /// xx, yy, zz, xy, xz, yz.
  std::array<double, 6> Second{};

  void Add(const LightMoments& other, double factor);
  /// w^T Second w.
  double GetSecond(const vtkVector3d& direction) const;
};

/// A part of an image of the map, in pixels from its upper left corner.
struct SkyRectangle
{
  int Image = 0;
  double Left = 0.0;
  double Top = 0.0;
  double Right = 0.0;
  double Bottom = 0.0;

  std::array<SkyRectangle, 4> Halve() const;
};

struct SkyPatch
{
  vtkVector3d Center;
  /// Of a ball about the centre that contains all of the patch's directions.
  double Radius = 0.0;
  /// Red, green and blue.
  std::array<LightMoments, 3> Light{};
};

class Surroundings
{
public:
  /// Pixels larger than this, in radians, are divided: no patch need be larger. Where that would be
  /// too many, the rest is divided when it is visited, which is slow.
  Surroundings(EnvironmentMap map, double largestPixel);

  /// 1/(4 pi) times the integral of E over all directions.
  Rgb GetMean() const;

  /// Calls visit(SkyPatch), which returns whether it is to be divided, for patches of which each
  /// direction is in exactly one that is not divided any further.
  template <typename Visitor>
  void VisitPatches(Visitor visit) const
  {
    for (std::size_t image = 0; image < this->Pyramids.size(); ++image)
    {
      const int top = static_cast<int>(this->Pyramids[image].size()) - 1;
      this->VisitBlock({ static_cast<int>(image), top, 0, 0 }, visit);
    }
  }

private:
  /// 2^Level by 2^Level pixels.
  struct Block
  {
    int Image;
    int Level;
    int Column;
    int Row;
  };
  struct Level
  {
    int Columns;
    int Rows;
    std::vector<SkyPatch> Patches;
  };

  template <typename Visitor>
  void VisitBlock(const Block& block, Visitor& visit) const
  {
    const Level& level = this->Pyramids[block.Image][block.Level];
    if (block.Column >= level.Columns || block.Row >= level.Rows)
    {
      return;
    }
    if (block.Level == 0)
    {
      this->VisitPixel(block, visit);
    }
    else if (visit(this->GetPatch(block)))
    {
      for (int child = 0; child < 4; ++child)
      {
        this->VisitBlock(
          { block.Image, block.Level - 1, 2 * block.Column + child % 2, 2 * block.Row + child / 2 },
          visit);
      }
    }
  }

  template <typename Visitor>
  void VisitPixel(const Block& block, Visitor& visit) const
  {
    const bool isKept = !this->Pyramids[block.Image][0].Patches.empty();
    if (isKept ? visit(this->GetPatch(block)) : visit(this->MakePatch(this->GetRectangle(block))))
    {
      this->VisitQuarters(this->GetRectangle(block), visit);
    }
  }

  /// Of a pixel or a part of one.
  template <typename Visitor>
  void VisitQuarters(const SkyRectangle& part, Visitor& visit) const
  {
    for (const SkyRectangle& quarter : part.Halve())
    {
      if (visit(this->MakePatch(quarter)))
      {
        this->VisitQuarters(quarter, visit);
      }
    }
  }

  int CountParts(const EnvironmentImage& image, double largestPixel) const;
  vtkVector3d GetDirection(int image, double x, double y) const;
  double GetSolidAngle(const SkyRectangle& rectangle, double x, double y) const;
  SkyRectangle GetRectangle(const Block& block) const;
  const SkyPatch& GetPatch(const Block& block) const;
  SkyPatch MakeOutline(const SkyRectangle& rectangle) const;
  SkyPatch MakePatch(const SkyRectangle& partOfPixel) const;
  void BuildPyramid(int image);
  void AddPixels(int image);
  void AddLevel(int image);

  EnvironmentMap Map;
  /// Of each image, level by level; pixels themselves are left out where they are too many.
  std::vector<std::vector<Level>> Pyramids;
};

}

#endif
